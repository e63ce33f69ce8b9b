//! Solids.

mod area;
mod bodies;
mod centroid;
mod closest;
mod contains;
mod cut;
mod edges;
mod extrude;
mod faces;
mod genus;
mod inertia;
mod intersect;
mod of_faces;
mod revolve;
mod section;
mod shells;
mod skin;
mod sweep;
mod varied_walls;
mod vertices;
mod volume;
mod walls;

use std::sync::Arc;

use glam::DVec3;

use super::measure::{MassOf, tell_accuracy};
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    kernel::{GeomError, MassProperties, Solid, VariedCurve, VariedRegion},
    value::{At, CARRIES_DERIVATIVES, Ctx, NoDerivative, Op, Real, RealRegion, Vector},
};

pub(super) static OPS: &[&Op] = &[
    &of_faces::OP,
    &extrude::OP,
    &revolve::OP,
    &sweep::OP,
    &skin::OP,
    &cut::OP,
    &section::OP,
    &volume::OP,
    &area::OP,
    &centroid::OP,
    &inertia::OP,
    &contains::OP,
    &closest::OP,
    &faces::OP,
    &edges::OP,
    &vertices::OP,
    &shells::OP,
    &bodies::OP,
    &genus::OP,
    &intersect::OP,
];

/// The solid that is asked about.
type GivenSolid = Arc<Solid>;

/// How many variables a region and numbers depend on together; none where they do on none.
///
/// # Errors
/// Series of a higher order.
fn n_variables(region: &RealRegion, numbers: &[Real], span: Span) -> Result<Option<usize>> {
    let jet = numbers.iter().find_map(|number| match number {
        Real::Jet(jet) => Some(jet),
        Real::Plain(_) => None,
    });
    let Some(jet) = jet else { return Ok(region.varied().map(VariedRegion::n_variables)) };
    let higher = || {
        let reason = NoDerivative::HigherOrder;
        let error = Diagnostic::error(Code::NoDerivative, span, reason.message());
        Box::new(error.hint(reason.hint()))
    };
    jet.n_variables().map(Some).ok_or_else(higher)
}

/// The slopes of a vector by each of so many variables.
fn slopes_of(vector: &Vector, n_variables: usize) -> Vec<DVec3> {
    let slope = |variable: usize| match vector {
        Vector::Plain(_) => DVec3::ZERO,
        Vector::Jets(jets) => DVec3::from(jets.each_ref().map(|jet| jet.slopes()[variable])),
    };
    (0..n_variables).map(slope).collect()
}

/// A region as one that varies, with zeros where it does not.
fn varied_region(
    region: &RealRegion,
    n_variables: usize,
) -> std::result::Result<Arc<VariedRegion>, GeomError> {
    if let RealRegion::Varied(varied) = region {
        return Ok(Arc::clone(varied));
    }
    let fixed = |border| Ok(vec![VariedCurve::fixed(Arc::new(border), n_variables)?]);
    let borders: std::result::Result<_, GeomError> =
        region.plain().borders()?.into_iter().map(fixed).collect();
    VariedRegion::new(Arc::clone(region.plain()), borders?).map(Arc::new)
}

/// How much of it there is, and how that is spread.
fn mass(solid: &Solid, of: MassOf, what: &str, ctx: &mut Ctx<'_>) -> Result<MassProperties> {
    let mass = match of {
        MassOf::Volume => solid.volume_mass(),
        MassOf::Area => solid.area_mass(),
    };
    let mass = mass.at(ctx.span)?;
    tell_accuracy(what, mass.relative_error, ctx)?;
    Ok(mass)
}

/// # Errors
/// The faces of a solid, to whose `what` no derivative passes.
fn check_inside_varies(what: &str, of: MassOf, ctx: &Ctx<'_>) -> Result<()> {
    if of == MassOf::Volume {
        return Ok(());
    }
    let message = format!("`{what}`: no derivative passes to that of the faces of a solid");
    Diagnostic::error(Code::NoDerivative, ctx.span, message).hint(CARRIES_DERIVATIVES).fail()
}
