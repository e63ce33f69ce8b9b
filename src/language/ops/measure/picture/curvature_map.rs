//! `curvature_map`: a mesh that shows by its colours how a surface bends.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{
        self, GeomError, LocalError, Surface, SurfaceShape, TessellationOptions, Tolerance,
        tolerance::{DEFAULT_CHORD_RELATIVE, FLAT_SIZES, SHADE_RELATIVE},
    },
    value::{At, Choice, Ctx, IntoValue, Length, LengthPower, Record, Value, op},
};

op! {
    /// How a surface bends, by the colours of a mesh:
    /// `{mesh, kind, min, max, scale, below, above, values}`.
    ///
    /// Kinds are `"gaussian"`, `"mean"`, the principal curvatures `"k1"` and `"k2"`, `"absolute"`
    /// (the larger of them without its sign) and `"difference"` (k2 − k1, zero at umbilics); and the
    /// least and the greatest radius of curvature along the principal directions, without sign:
    /// `"min_radius"`, 1/max(|k1|, |k2|), and `"max_radius"`, 1/min(|k1|, |k2|). The
    /// values are those at the vertices, `none` where the surface has none, which are grey, and where
    /// a radius has no bound, which have the colour of the largest. `min` and
    /// `max` are the ends of the scale, those of the values unless a `range` is given; the scale of a
    /// radius ends at ten times the surface's size, from where on all looks flat. Values beyond
    /// have the colours of the ends; `below` and `above` count the vertices that have them, and the
    /// legend of a picture has ≤ or ≥ there. Values that are the same but for rounding are one value,
    /// and white. The scale goes through white at zero where it holds both signs, blue
    /// below and red above, and else from blue over white to red; `scale` lists
    /// `{value, color}` at nine places, colours as red, green and blue from 0 to 1.
    /// Beck, Farouki & Hinds, *Surface analysis methods*, IEEE CG&A 6 (1986).
    curvature_map in Measure -> Record {
        /// The surface.
        s: Spanned<Surface>,
        /// Which curvature, or which radius of curvature.
        kind: CurvatureKind,
        /// How far the mesh may be from the surface; when left out a thousandth of its size.
        tolerance: Option<Spanned<Length>>,
        /// The values at the ends of the scale.
        range: Option<crate::kernel::Interval>,
    }
    example "curvature_map(sphere((0, 0), 2), \"gaussian\").max ~= 0.25" => "true";
    example "curvature_map(cylinder((0, 0), 2, 1), \"k1\", range = -1..0).scale[4]" => "{value: -0.5, color: (1, 1, 1)}";
    example "len(curvature_map(sphere((0, 0), 2), \"mean\", tolerance = 0.1).values) > 20" => "true";
    example "curvature_map(sphere((0, 0), 2), \"max_radius\").max ~= 2" => "true";
    example "curvature_map(cylinder((0, 0), 2, 1), \"min_radius\").min ~= 2" => "true";
    refuses "curvature_map(plane_patch((0, 0), (1, 0), (0, 1)), \"average\")" => "E0402: `curvature_map`: `kind` must be one of \"gaussian\", \"mean\", \"k1\", \"k2\", \"absolute\", \"difference\", \"min_radius\" or \"max_radius\", found the string \"average\"";
    picture "curvature_map(bspline([for i in 0..5: [for j in 0..5: (i, j, sin(i)*cos(j))]]), \"gaussian\")";
}

/// The curvatures that can be shown.
#[derive(Clone, Copy, Debug, PartialEq)]
enum CurvatureKind {
    Gaussian,
    Mean,
    K1,
    K2,
    Absolute,
    Difference,
    MinRadius,
    MaxRadius,
}

impl Choice for CurvatureKind {
    const WORDS: &'static [&'static str] =
        &["gaussian", "mean", "k1", "k2", "absolute", "difference", "min_radius", "max_radius"];
    const MEANINGS: &'static [Self] = &[
        Self::Gaussian,
        Self::Mean,
        Self::K1,
        Self::K2,
        Self::Absolute,
        Self::Difference,
        Self::MinRadius,
        Self::MaxRadius,
    ];
}

impl CurvatureKind {
    /// The value where the surface has a shape; a radius without bound is infinite.
    fn of(self, shape: &SurfaceShape, tolerance: Tolerance) -> f64 {
        let [k1, k2] = shape.curvatures();
        match self {
            Self::Gaussian => shape.gaussian(),
            Self::Mean => shape.mean(),
            Self::K1 => k1,
            Self::K2 => k2,
            Self::Absolute => k1.abs().max(k2.abs()),
            Self::Difference => k2 - k1,
            Self::MinRadius => shape.radii(tolerance)[0],
            Self::MaxRadius => shape.radii(tolerance)[1],
        }
    }

    /// How far values of surfaces that bend by `strongest` at most, and of `largest` at most, may be
    /// apart by rounding.
    fn rounding(self, strongest: f64, largest: f64) -> f64 {
        SHADE_RELATIVE
            * match self {
                Self::Gaussian => strongest * strongest,
                // dR = R² dk.
                Self::MinRadius | Self::MaxRadius => largest * largest * strongest,
                _ => strongest,
            }
    }

    /// A value with its dimension.
    fn with_dimension(self, value: f64) -> Value {
        match self {
            Self::Gaussian => LengthPower::<-2>(value).into_value(),
            Self::MinRadius | Self::MaxRadius => Length(value).into_value(),
            _ => LengthPower::<-1>(value).into_value(),
        }
    }

    const fn is_radius(self) -> bool {
        matches!(self, Self::MinRadius | Self::MaxRadius)
    }
}

/// Places of the scale that are listed.
const STOPS: usize = 9;

/// Where nothing is known.
const GREY: DVec3 = DVec3::splat(0.5);

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let (surface, span) = (&args.s.value, args.s.span);
    let size = surface.bounds().at(span)?.diagonal();
    let limits = TessellationOptions::within(tolerance(size, args.tolerance)?);
    let mesh = kernel::tessellate_any(surface, &limits, ctx.limits.mesh_vertices).at(span)?;
    let mut values = Vec::with_capacity(mesh.n_vertices());
    let mut strongest = 0.0_f64;
    for uv in mesh.uvs() {
        values.push(match surface.shape_at(uv.x, uv.y) {
            Ok(shape) => {
                let [k1, k2] = shape.curvatures();
                strongest = strongest.max(k1.abs()).max(k2.abs());
                Some(args.kind.of(&shape, ctx.tolerance))
            }
            Err(GeomError::Local(LocalError::NoNormal { .. } | LocalError::NoCurvature { .. })) => {
                None
            }
            Err(error) => return Err(error).at(span),
        });
    }
    let most = if args.kind.is_radius() { FLAT_SIZES * size } else { f64::INFINITY };
    let ends =
        match (args.range, ends_of(&values, most, |most| args.kind.rounding(strongest, most))) {
            (Some(range), _) => [range.start(), range.end()],
            (None, Some(ends)) => ends,
            (None, None) => {
                let message = "the surface has no curvature anywhere that could be shown";
                return Diagnostic::error(Code::Degenerate, span, message).fail();
            }
        };
    let colors = values.iter().map(|value| value.map_or(GREY, |value| color(value, ends)));
    let mesh = mesh.with_colors(colors.collect()).at(span)?;
    let stop = |i: usize| {
        let value = stop_value(i, ends);
        Value::Record(Arc::new(Record::new([
            (Arc::from("value"), args.kind.with_dimension(value)),
            (Arc::from("color"), Value::Point(color(value, ends))),
        ])))
    };
    let word = CurvatureKind::MEANINGS.iter().position(|kind| *kind == args.kind);
    let slack = args.kind.rounding(strongest, ends[1]);
    let n_beyond = |is_beyond: &dyn Fn(f64) -> bool| {
        Value::number(values.iter().flatten().filter(|value| is_beyond(**value)).count() as f64)
    };
    let (below, above) =
        (n_beyond(&|value| value < ends[0] - slack), n_beyond(&|value| ends[1] + slack < value));
    let all = values.iter().map(|value| {
        value
            .filter(|value| value.is_finite())
            .map_or(Value::None, |value| args.kind.with_dimension(value))
    });
    Ok(Record::new([
        (Arc::from("mesh"), Value::Mesh(Arc::new(mesh))),
        (Arc::from("kind"), word.map_or(Value::None, |i| Value::text(CurvatureKind::WORDS[i]))),
        (Arc::from("min"), args.kind.with_dimension(ends[0])),
        (Arc::from("max"), args.kind.with_dimension(ends[1])),
        (Arc::from("scale"), Value::list((0..STOPS).map(stop).collect())),
        (Arc::from("below"), below),
        (Arc::from("above"), above),
        (Arc::from("values"), Value::list(all.collect())),
    ]))
}

/// The least and the largest value, none above `most`; one for both where they differ by rounding,
/// which depends on the largest.
fn ends_of(values: &[Option<f64>], most: f64, rounding: impl Fn(f64) -> f64) -> Option<[f64; 2]> {
    let known = || values.iter().copied().flatten().map(|value| value.min(most));
    let least = known().reduce(f64::min)?;
    let largest = known().reduce(f64::max)?;
    let (middle, rounding) = (0.5 * (least + largest), rounding(largest));
    Some(match largest - least <= rounding {
        false => [least, largest],
        true if middle.abs() <= rounding => [0.0; 2],
        true => [middle; 2],
    })
}

/// The value at a place of the scale, at its ends exactly these.
fn stop_value(i: usize, [least, most]: [f64; 2]) -> f64 {
    let share = i as f64 / (STOPS - 1) as f64;
    least * (1.0 - share) + most * share
}

/// How far the mesh may be from a surface of a size.
fn tolerance(size: f64, asked: Option<Spanned<Length>>) -> Result<f64> {
    match asked {
        Some(tolerance) if tolerance.value.0 <= 0.0 => {
            let message = "the tolerance must be positive";
            Diagnostic::error(Code::Degenerate, tolerance.span, message).fail()
        }
        Some(tolerance) => Ok(tolerance.value.0),
        None => Ok(DEFAULT_CHORD_RELATIVE * if 0.0 < size { size } else { 1.0 }),
    }
}

/// The colour of a value: white in the middle, or at zero where the ends have two signs.
fn color(value: f64, [least, most]: [f64; 2]) -> DVec3 {
    let has_both = least < 0.0 && 0.0 < most;
    let middle = if has_both { 0.0 } else { 0.5 * (least + most) };
    let reach = if value < middle { middle - least } else { most - middle };
    let share = if 0.0 < reach { ((value - middle) / reach).clamp(-1.0, 1.0) } else { 0.0 };
    let (low, high) = (DVec3::new(0.1, 0.2, 0.8), DVec3::new(0.8, 0.1, 0.1));
    DVec3::ONE.lerp(if share < 0.0 { low } else { high }, share.abs())
}
