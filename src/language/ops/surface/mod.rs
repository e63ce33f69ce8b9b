//! Operations that make surfaces.

mod approximate;
mod bezier;
mod bilinear;
mod boundary;
mod bspline;
mod clamped;
mod cone;
mod coons;
mod coons_bicubic;
mod coons_bspline;
mod corner_surface;
mod cuboid;
mod cylinder;
mod disc;
mod disc_about;
mod edge_surface;
mod extrude;
mod fit;
mod gordon;
mod interpolate;
pub(super) mod motion;
pub(super) mod moving;
mod network;
mod nurbs;
mod parametric;
mod plane_patch;
mod revolve;
mod ribbon;
mod ruled;
pub(super) mod section;
mod skin;
pub(super) mod skin_options;
mod sphere;
mod sweep;
pub(super) mod sweep_options;
mod swept;
mod swung;
mod to_nurbs;
mod torus;
mod turned;

use glam::DVec3;

use super::{curve::knots_for, positive};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{CountError, Frame, GeomError, Grid, NurbsSurface},
    value::{At, Ctx, FromValue, IntoValue, Length, Mismatch, Op, Rows, Type, Value, code_of},
};

pub(super) static OPS: &[&Op] = &[
    &bilinear::OP,
    &ruled::OP,
    &edge_surface::OP,
    &corner_surface::OP,
    &coons::OP,
    &coons_bicubic::OP,
    &extrude::OP,
    &revolve::OP,
    &swung::OP,
    &plane_patch::OP,
    &disc::OP,
    &disc_about::OP,
    &cuboid::OP,
    &sphere::OP,
    &cylinder::OP,
    &cone::OP,
    &torus::OP,
    &gordon::OP,
    &skin::OP,
    &sweep::OP,
    &bezier::OP,
    &clamped::OP,
    &coons_bspline::OP,
    &bspline::OP,
    &nurbs::OP,
    &interpolate::OP,
    &approximate::OP,
    &parametric::OP,
    &to_nurbs::OP,
];

/// A value for both directions, or `{u: , v: }` where they differ.
#[derive(Clone, Debug)]
struct PerDirection<T> {
    u: T,
    v: T,
}

impl<T: FromValue + Clone> FromValue for PerDirection<T> {
    const TYPE: Type = Type::OneOf(&[T::TYPE, Type::Record]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        let Value::Record(record) = value else {
            let both = T::from_value(value, span)?;
            return Ok(Self { u: both.clone(), v: both });
        };
        let part = |label: &str| match record.get(label) {
            Some(value) => T::from_value(value, span),
            None => {
                Err(Mismatch::new("a record `{u: , v: }`", format!("a record without `{label}`")))
            }
        };
        if record.len() > 2 {
            return Err(Mismatch::new("a record `{u: , v: }`", "a record with more labels"));
        }
        Ok(Self { u: part("u")?, v: part("v")? })
    }
}

impl<T: IntoValue> IntoValue for PerDirection<T> {
    const RETURNS: Type = T::RETURNS;

    fn into_value(self) -> Value {
        self.u.into_value()
    }
}

/// Degree 3 in both directions.
fn cubic() -> Spanned<PerDirection<usize>> {
    Spanned::unplaced(PerDirection { u: 3, v: 3 })
}

/// The surface, after a warning where it is no more than a curve or a point.
fn with_area(ctx: &mut Ctx<'_>, surface: NurbsSurface) -> NurbsSurface {
    if !surface.has_area() {
        let message = "the surface has no area: all of it lies on one curve, or in one point";
        let hint = "it has no normal anywhere; look for points or curves that are given twice";
        ctx.warn(Diagnostic::warning(Code::DegenerateResult, ctx.span, message).hint(hint));
    }
    surface
}

/// The tensor product on given knots, or on uniform clamped ones over 0..1.
fn tensor(
    ctx: &mut Ctx<'_>,
    points: Spanned<Rows>,
    weights: Option<Spanned<Vec<Vec<f64>>>>,
    degree: Spanned<PerDirection<usize>>,
    knots: Option<Spanned<PerDirection<Vec<f64>>>>,
) -> Result<NurbsSurface> {
    let Rows(grid) = points.value;
    let span = points.span;
    let (knots_u, knots_v) = match knots {
        None => (None, None),
        Some(Spanned { value, span }) => {
            (Some(Spanned::new(value.u, span)), Some(Spanned::new(value.v, span)))
        }
    };
    let degrees =
        (Spanned::new(degree.value.u, degree.span), Spanned::new(degree.value.v, degree.span));
    let knots_u = knots_for(knots_u, degrees.0, Spanned::new(grid.n_rows(), span))
        .map_err(|found| in_direction(found, "u", "rows"))?;
    let knots_v = knots_for(knots_v, degrees.1, Spanned::new(grid.n_columns(), span))
        .map_err(|found| in_direction(found, "v", "points in a row"))?;
    let surface = match weights {
        None => NurbsSurface::polynomial(knots_u, knots_v, &grid).at(span)?,
        Some(weights) => {
            let net = weight_grid(weights.value, &grid, weights.span)?;
            NurbsSurface::rational(knots_u, knots_v, &grid, &net).at(weights.span)?
        }
    };
    Ok(with_area(ctx, surface))
}

/// A height, which must be above zero.
fn upward(height: Spanned<Length>) -> Result<f64> {
    positive("the height", height).map_err(|mut found| {
        if height.value.0 < 0.0 {
            found.hints.push("to go down, turn the `axis` around".to_owned());
        }
        found
    })
}

/// The frame of a surface around an axis: z along it, x as near to (1, 0, 0) as that allows.
fn around(origin: DVec3, axis: Spanned<DVec3>) -> Result<Frame> {
    check_axis(axis)?;
    Frame::from_normal(origin, axis.value, None).at(axis.span)
}

/// Fails for an axis without a direction.
pub(super) fn check_axis(axis: Spanned<DVec3>) -> Result<()> {
    if axis.value != DVec3::ZERO {
        return Ok(());
    }
    let message = "the axis has length zero, and no direction";
    let hint = "an axis is a vector, such as (0, 0, 1)";
    Diagnostic::error(Code::Degenerate, axis.span, message).hint(hint).fail()
}

/// Tells in which direction a mistake lies.
fn in_direction(mut found: Box<Diagnostic>, direction: &str, counted: &str) -> Box<Diagnostic> {
    found.message = format!("along {direction}: {}", found.message);
    found.hints.push(format!("along {direction} the {counted} count"));
    found
}

/// Weights as a grid like that of the points.
fn weight_grid<P>(rows: Vec<Vec<f64>>, points: &Grid<P>, span: Span) -> Result<Grid<f64>> {
    let weights = Grid::from_rows(rows).map_err(|error| match error {
        GeomError::Count(CountError::RaggedGrid { row, got, expected }) => {
            let weights = if got == 1 { "weight" } else { "weights" };
            let message = format!(
                "row {row} has {got} {weights}, row 0 has {expected}; every row needs the same number"
            );
            Box::new(Diagnostic::error(Code::RaggedGrid, span, message))
        }
        other => Box::new(Diagnostic::error(code_of(&other), span, other.to_string())),
    })?;
    let sizes = [(points.n_rows(), points.n_columns()), (weights.n_rows(), weights.n_columns())];
    if sizes[0] != sizes[1] {
        let [(rows, columns), (found_rows, found_columns)] = sizes;
        let message = format!(
            "there are {rows} x {columns} points, but {found_rows} x {found_columns} weights; each point needs one"
        );
        return Diagnostic::error(Code::BadWeights, span, message).fail();
    }
    if let Some(idx) = weights.iter().position(|&weight| weight < 0.0) {
        let (i, j) = (idx / weights.n_columns(), idx % weights.n_columns());
        let message =
            format!("weight [{i}][{j}] is {}; weights are not negative", weights.get(i, j));
        let hint = "the larger a weight, the nearer the surface comes to its point; at zero the point is gone";
        return Diagnostic::error(Code::BadWeights, span, message).hint(hint).fail();
    }
    Ok(weights)
}
