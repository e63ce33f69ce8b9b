//! Surfaces with their seams and poles elsewhere: the same places by other parameters.
//!
//! Where a curve touches a seam, or passes a pole closely, rounding leads it out of the domain and back.
//! Nothing that surfaces share hangs on where their seams are, so that what cannot be told for certain
//! is looked for again with seams that lie elsewhere.

use std::sync::Arc;

use glam::DVec3;

use super::sphere::sphere_about;
use crate::{Direction, GeomError, Grid, NurbsSurface, frame::unit, surface::join_patches};

/// Where seams go to in turn, as parts of the domain: nowhere near simple fractions, where circles have
/// their knots.
const SEAMS: [f64; 3] = [0.381_966, 0.618_034, 0.145_898];

/// Where the poles of spheres go to in turn, in the sphere's own frame.
const POLES: [DVec3; 3] =
    [DVec3::new(0.56, 0.31, 0.77), DVec3::new(-0.67, 0.72, 0.18), DVec3::new(0.23, -0.84, 0.49)];

/// The surfaces with their seams and poles elsewhere, in turn; none of surfaces without seams.
pub(super) fn with_seams_elsewhere(
    surfaces: &[Arc<NurbsSurface>; 2],
    tolerance: f64,
) -> impl Iterator<Item = Result<[Arc<NurbsSurface>; 2], GeomError>> {
    let has_seam = surfaces
        .iter()
        .any(|surface| surface.is_closed_u(tolerance) || surface.is_closed_v(tolerance));
    let ways = SEAMS.into_iter().zip(POLES).filter(move |_| has_seam);
    ways.map(move |(seam, pole)| {
        let [a, b] = surfaces;
        Ok([moved(a, seam, pole, tolerance)?, moved(b, seam, pole, tolerance)?])
    })
}

fn moved(
    surface: &Arc<NurbsSurface>,
    seam: f64,
    pole: DVec3,
    tolerance: f64,
) -> Result<Arc<NurbsSurface>, GeomError> {
    let axis = unit(pole).unwrap_or(DVec3::Z);
    if let Some(sphere) = sphere_about(surface, tolerance, axis) {
        return Ok(Arc::new(sphere));
    }
    let mut surface = Arc::clone(surface);
    if surface.is_closed_u(tolerance) {
        surface = Arc::new(reseamed(&surface, Direction::U, seam, tolerance)?);
    }
    if surface.is_closed_v(tolerance) {
        surface = Arc::new(reseamed(&surface, Direction::V, seam, tolerance)?);
    }
    Ok(surface)
}

/// The closed surface that begins elsewhere.
fn reseamed(
    surface: &NurbsSurface,
    along: Direction,
    seam: f64,
    tolerance: f64,
) -> Result<NurbsSurface, GeomError> {
    let [before, behind] = surface.split(along, surface.domain(along).at(seam))?;
    let patches = vec![behind, before];
    let grid = match along {
        Direction::U => Grid::new(2, 1, patches),
        Direction::V => Grid::new(1, 2, patches),
    };
    join_patches(&grid?, tolerance)
}
