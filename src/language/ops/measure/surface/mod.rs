//! Questions about surfaces.

pub(super) mod area;
pub(super) mod at;
pub(super) mod centroid;
pub(super) mod classify;
pub(super) mod closest;
pub(super) mod continuity;
pub(super) mod curvature_comb;
pub(super) mod curvature_table;
pub(super) mod derivative;
pub(super) mod deviation;
pub(super) mod first_form;
pub(super) mod gaussian;
pub(super) mod inertia;
pub(super) mod is_developable;
pub(super) mod is_minimal;
pub(super) mod is_planar;
pub(super) mod mean;
pub(super) mod normal;
pub(super) mod normal_curvature;
pub(super) mod normal_line;
pub(super) mod principal;
pub(super) mod second_form;
pub(super) mod tangent_plane;
pub(super) mod tangent_u;
pub(super) mod tangent_v;
pub(super) mod twist;
mod varying;
pub(super) mod volume;

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        Face, FaceError, GeomError, Jet, MassProperties, ShellError, Surface, SurfaceIntegral,
        VariedSurface, area_mass, signed_volume,
        tolerance::{ACCURACY_WORTH_HAVING, ACCURACY_WORTH_TELLING},
        volume_mass,
    },
    ops::{
        face::{RealSurfaceOrFace, SurfaceOrFace},
        list::check_length,
        measure::Measured,
    },
    value::{At, Choice, Ctx, FromValue, Mismatch, Real, Type, Value},
};

/// A surface, or a list of them; faces as well as surfaces.
struct Surfaces(Vec<SurfaceOrFace>);

impl FromValue for Surfaces {
    const TYPE: Type = Type::OneOf(&[
        Type::Surface,
        Type::Face,
        Type::List(&Type::OneOf(&[Type::Surface, Type::Face]), 1),
    ]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Surface(_) | Value::Face(_) => {
                Ok(Self(vec![SurfaceOrFace::from_value(value, span)?]))
            }
            Value::List(items) if !items.is_empty() => Vec::from_value(value, span).map(Self),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

/// A surface, or a list of surfaces and faces; a single face answers by its skin.
struct Together<S>(S);

impl<S: FromValue> FromValue for Together<S> {
    const TYPE: Type =
        Type::OneOf(&[Type::Surface, Type::List(&Type::OneOf(&[Type::Surface, Type::Face]), 1)]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Face(_) => Err(Mismatch::kind(Self::TYPE, value)),
            _ => S::from_value(value, span).map(Self),
        }
    }
}

impl Surfaces {
    /// All of them as surfaces; none where one is a part of a surface.
    fn whole(&self) -> Option<Vec<Surface>> {
        let whole = |part: &SurfaceOrFace| (!part.is_face()).then(|| (**part).clone());
        self.0.iter().map(whole).collect()
    }

    /// How the area of all is spread.
    fn area_mass(&self, span: Span, ctx: &Ctx<'_>) -> Result<MassProperties> {
        match self.whole() {
            Some(surfaces) => area_mass(&surfaces).at(span),
            None => Face::mass_of(&self.faces(span, ctx)?).at(span),
        }
    }

    /// What they enclose.
    fn volume_mass(
        &self,
        span: Span,
        ctx: &Ctx<'_>,
    ) -> Result<std::result::Result<MassProperties, GeomError>> {
        Ok(match self.whole() {
            Some(surfaces) => volume_mass(&surfaces, ctx.tolerance),
            None => Face::enclosed_mass(&self.faces(span, ctx)?, ctx.tolerance),
        })
    }

    /// How much they enclose, and by which fraction that may be wrong.
    fn volume(&self, span: Span, ctx: &Ctx<'_>) -> Result<(f64, f64)> {
        match self.whole() {
            Some(surfaces) => {
                let found = signed_volume(&surfaces, ctx.tolerance).at(span)?;
                Ok((found.amount, found.relative_error))
            }
            None => Face::enclosed_volume(&self.faces(span, ctx)?, ctx.tolerance).at(span),
        }
    }

    fn faces(&self, span: Span, ctx: &Ctx<'_>) -> Result<Vec<Face>> {
        let mut faces = Vec::with_capacity(self.0.len());
        for (idx, part) in self.0.iter().enumerate() {
            if !part.is_face() && part.nurbs().is_err() {
                let message = format!(
                    "element [{idx}] is a parametric surface, a function; beside faces surfaces must be NURBS"
                );
                return Diagnostic::error(Code::WrongKind, span, message)
                    .hint("`to_nurbs(s, 1e-6)` makes one of it within a tolerance")
                    .fail();
            }
            faces.push((*part.face(span, ctx.tolerance)?).clone());
        }
        Ok(faces)
    }
}

/// Surfaces and faces as [`Surfaces`]; surfaces may carry derivatives.
struct RealSurfaces {
    plain: Surfaces,
    real: Vec<RealSurfaceOrFace>,
}

impl FromValue for RealSurfaces {
    const TYPE: Type = Surfaces::TYPE;

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        let real = match value {
            Value::List(items) if !items.is_empty() => Vec::from_value(value, span)?,
            Value::List(_) => return Err(Mismatch::kind(Self::TYPE, value)),
            _ if Self::TYPE.accepts(value) => vec![RealSurfaceOrFace::from_value(value, span)?],
            _ => return Err(Mismatch::kind(Self::TYPE, value)),
        };
        let plain = |one: &RealSurfaceOrFace| SurfaceOrFace::clone(one);
        Ok(Self { plain: Surfaces(real.iter().map(plain).collect()), real })
    }
}

impl RealSurfaces {
    /// Whether one of them carries derivatives.
    fn vary(&self) -> bool {
        self.real.iter().any(|surface| surface.real().varied().is_some())
    }

    /// Something that the surfaces have together, with its slopes: the sum of what each that varies adds, of
    /// which is also known how far it may be off.
    fn with_slopes(
        &self,
        value: f64,
        what: &str,
        ctx: &mut Ctx<'_>,
        slopes: impl Fn(usize, &VariedSurface) -> Measured<SurfaceIntegral>,
    ) -> Result<Real> {
        let mut sum: Option<Vec<f64>> = None;
        let mut relative_error = 0.0_f64;
        for (idx, surface) in self.real.iter().enumerate() {
            let Some(varied) = surface.real().varied() else { continue };
            let part = slopes(idx, varied).at(ctx.span)?;
            relative_error = relative_error.max(part.relative_error);
            match &mut sum {
                None => sum = Some(part.slopes),
                Some(sum) => sum.iter_mut().zip(part.slopes).for_each(|(sum, slope)| *sum += slope),
            }
        }
        let Some(sum) = sum else { return Ok(Real::Plain(value)) };
        tell_accuracy(&format!("derivative of the {what}"), relative_error, ctx)?;
        Ok(Real::Jet(Jet::with_slopes(value, &sum).at(ctx.span)?))
    }
}

/// What of surfaces is heavy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum MassOf {
    Volume,
    Area,
}

impl Choice for MassOf {
    const WORDS: &'static [&'static str] = &["volume", "area"];
    const MEANINGS: &'static [Self] = &[Self::Volume, Self::Area];
}

/// What the surfaces hold, or they themselves.
fn mass(
    surfaces: &Surfaces,
    span: Span,
    (of, what): (MassOf, &str),
    ctx: &mut Ctx<'_>,
) -> Result<MassProperties> {
    if of == MassOf::Area {
        let mass = surfaces.area_mass(span, ctx)?;
        tell_accuracy(what, mass.relative_error, ctx)?;
        return Ok(mass);
    }
    let mass = surfaces.volume_mass(span, ctx)?;
    let open = matches!(
        mass,
        Err(GeomError::Shell(ShellError::Open { .. } | ShellError::Alone { .. })
            | GeomError::Face(FaceError::OpenShell { .. }))
    );
    match mass.at(span) {
        Err(open_shell) if open => {
            let hint = format!("`{what}(…, of = \"area\")` is that of the surfaces themselves");
            (*open_shell).hint(hint).fail()
        }
        mass => {
            let mass = mass?;
            tell_accuracy(what, mass.relative_error, ctx)?;
            Ok(mass)
        }
    }
}

/// Warns of an integral that is not known as well as usual, and refuses one that is hardly known.
pub(in crate::ops) fn tell_accuracy(
    what: &str,
    relative_error: f64,
    ctx: &mut Ctx<'_>,
) -> Result<()> {
    if ACCURACY_WORTH_HAVING < relative_error {
        let message = format!("the {what} cannot be told: the surface changes too fast somewhere");
        let hint =
            "where derivatives grow beyond bounds, `trim` it or write it with another parameter";
        return Diagnostic::error(Code::Degenerate, ctx.span, message).hint(hint).fail();
    }
    if ACCURACY_WORTH_TELLING < relative_error {
        // One digit, and never less than it is.
        let most = 1.5 * relative_error;
        let message = format!("the {what} is known to a fraction of {most:.0e} of itself only");
        let hint = "folds, derivatives without bound, and jumps of a function inside of a piece cost digits";
        ctx.warn(Diagnostic::warning(Code::Unclean, ctx.span, message).hint(hint));
    }
    Ok(())
}

/// Parameters of a surface, inside its domains.
fn inside(surface: &SurfaceOrFace, u: Spanned<f64>, v: Spanned<f64>) -> Result<(f64, f64)> {
    let inside_u = surface.domain_u().clamp_inside(u.value).at(u.span)?;
    let inside_v = surface.domain_v().clamp_inside(v.value).at(v.span)?;
    surface.check_inside([inside_u, inside_v], u.span)?;
    Ok((inside_u, inside_v))
}

/// Evenly spaced parameters of a surface, so many along u and along v, the edges among them.
fn grid_parameters(
    surface: &Surface,
    samples: [Spanned<usize>; 2],
    ctx: &Ctx<'_>,
) -> Result<(Vec<f64>, Vec<f64>)> {
    for count in samples {
        if count.value < 2 {
            let message = format!(
                "a surface is sampled at 2 places or more in each direction, found {}",
                count.value
            );
            return Diagnostic::error(Code::TooFewPoints, count.span_or(ctx.span), message).fail();
        }
    }
    let [n_u, n_v] = samples.map(|count| count.value);
    check_length(n_u as f64 * n_v as f64, ctx)?;
    Ok((surface.domain_u().steps(n_u - 1), surface.domain_v().steps(n_v - 1)))
}
