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
        GeomError, MassProperties, ShellError, Surface, area_mass,
        tolerance::{ACCURACY_WORTH_HAVING, ACCURACY_WORTH_TELLING},
        volume_mass,
    },
    ops::list::check_length,
    value::{At, Choice, Ctx, FromValue, Mismatch, Type, Value},
};

/// A surface, or a list of them.
struct Surfaces(Vec<Surface>);

impl FromValue for Surfaces {
    const TYPE: Type = Type::OneOf(&[Type::Surface, Type::List(&Type::Surface, 1)]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Surface(surface) => Ok(Self(vec![surface.clone()])),
            Value::List(items) if !items.is_empty() => Vec::from_value(value, span).map(Self),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
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
    surfaces: &Spanned<Surfaces>,
    of: MassOf,
    what: &str,
    ctx: &mut Ctx<'_>,
) -> Result<MassProperties> {
    let mass = match of {
        MassOf::Volume => volume_mass(&surfaces.value.0, ctx.tolerance),
        MassOf::Area => area_mass(&surfaces.value.0),
    };
    let open =
        matches!(mass, Err(GeomError::Shell(ShellError::Open { .. } | ShellError::Alone { .. })));
    match mass.at(surfaces.span) {
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
fn tell_accuracy(what: &str, relative_error: f64, ctx: &mut Ctx<'_>) -> Result<()> {
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
fn inside(surface: &Surface, u: Spanned<f64>, v: Spanned<f64>) -> Result<(f64, f64)> {
    let inside_u = surface.domain_u().clamp_inside(u.value).at(u.span)?;
    let inside_v = surface.domain_v().clamp_inside(v.value).at(v.span)?;
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
