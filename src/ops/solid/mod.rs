//! Solids.

mod area;
mod centroid;
mod closest;
mod contains;
mod cut;
mod edges;
mod extrude;
mod genus;
mod inertia;
mod intersect;
mod of_faces;
mod revolve;
mod section;
mod volume;

use std::sync::Arc;

use super::measure::{MassOf, tell_accuracy};
use crate::{
    diag::Result,
    kernel::{MassProperties, Solid},
    value::{At, Ctx, Op},
};

pub(super) static OPS: &[&Op] = &[
    &of_faces::OP,
    &extrude::OP,
    &revolve::OP,
    &cut::OP,
    &section::OP,
    &volume::OP,
    &area::OP,
    &centroid::OP,
    &inertia::OP,
    &contains::OP,
    &closest::OP,
    &edges::OP,
    &genus::OP,
    &intersect::OP,
];

/// The solid that is asked about.
type GivenSolid = Arc<Solid>;

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
