//! What was found is looked at before it is told: whether each curve lies on the surfaces, stands once,
//! and ends only where a curve of these surfaces can end.
//!
//! A curve in which surfaces cross ends at a border of one of them or where it meets others; so every end
//! elsewhere tells that a part is missing.

use glam::DVec3;

use super::PictureError;
use crate::kernel::{GeomError, NurbsCurve, NurbsSurface};

/// Where within each span a curve is looked at: not in its middle, where a cubic may be on by symmetry.
const SHARE: f64 = 0.4;

/// Places along a curve that are looked for on another, and how many of them make a stretch.
const N_PLACES: usize = 9;
const MOST_SHARED: usize = 3;

/// Ends this many tolerances apart are one: where many meet each has its own error.
const ONE_END: f64 = 4.0;

/// Curves of fewer tolerances have no stretches.
const SHORTEST: f64 = 200.0;

/// Whether curves are on all surfaces, each once, and complete; `touches` are places where curves may end
/// too.
///
/// # Errors
/// [`PictureError::OffSurface`], [`PictureError::ToldTwice`], [`PictureError::EndsInside`] with the place.
pub(super) fn verify(
    curves: &[NurbsCurve],
    surfaces: &[&NurbsSurface],
    touches: &[DVec3],
    tolerance: f64,
) -> Result<(), GeomError> {
    for curve in curves {
        is_on(curve, surfaces, tolerance)?;
    }
    for (i, curve) in curves.iter().enumerate() {
        let others = curves.iter().enumerate().filter(|&(k, _)| k != i).map(|(_, other)| other);
        stands_once(curve, others, tolerance)?;
    }
    ends_are_ends(curves, surfaces, touches, tolerance)
}

/// Fails where the curve is further than the tolerance from a surface.
pub(super) fn is_on(
    curve: &NurbsCurve,
    surfaces: &[&NurbsSurface],
    tolerance: f64,
) -> Result<(), GeomError> {
    let knots = curve.knots().distinct();
    for pair in knots.windows(2) {
        let t = pair[0].0 + (pair[1].0 - pair[0].0) * SHARE;
        let point = curve.point_at(t);
        for surface in surfaces {
            let distance = surface.closest(point).distance;
            if distance.is_nan() || tolerance < distance {
                return Err(PictureError::OffSurface { point, distance }.into());
            }
        }
    }
    Ok(())
}

/// Fails where a stretch of the curve is one of another.
fn stands_once<'c>(
    curve: &NurbsCurve,
    others: impl Iterator<Item = &'c NurbsCurve>,
    tolerance: f64,
) -> Result<(), GeomError> {
    let bounds = curve.bounds();
    if bounds.diagonal() <= SHORTEST * tolerance {
        return Ok(());
    }
    let domain = curve.domain();
    let places: Vec<DVec3> = (1..=N_PLACES)
        .map(|i| curve.point_at(domain.at(i as f64 / (N_PLACES + 1) as f64)))
        .collect();
    for other in others {
        let around = other.bounds();
        let is_shared = |point: &&DVec3| {
            around.contains(**point, tolerance)
                && other.closest(**point, tolerance).distance <= tolerance
        };
        let mut shared = places.iter().filter(is_shared);
        if let Some(&point) = shared.nth(MOST_SHARED - 1) {
            return Err(PictureError::ToldTwice { point }.into());
        }
    }
    Ok(())
}

/// Fails where a curve ends inside all surfaces, and nothing else ends there.
fn ends_are_ends(
    curves: &[NurbsCurve],
    surfaces: &[&NurbsSurface],
    touches: &[DVec3],
    tolerance: f64,
) -> Result<(), GeomError> {
    let near = ONE_END * tolerance;
    let ends: Vec<DVec3> = curves.iter().flat_map(|curve| [curve.start(), curve.end()]).collect();
    let mut borders: Option<Vec<NurbsCurve>> = None;
    for (i, &end) in ends.iter().enumerate() {
        let is_near = |other: DVec3| other.distance(end) <= near;
        let is_met = ends.iter().enumerate().any(|(k, &other)| k != i && is_near(other));
        if is_met || touches.iter().any(|&touch| is_near(touch)) {
            continue;
        }
        let borders = borders.get_or_insert_with(|| {
            surfaces.iter().flat_map(|surface| borders_of(surface, tolerance)).collect()
        });
        let is_at_border = borders.iter().any(|border| {
            border.bounds().contains(end, near) && border.closest(end, tolerance).distance <= near
        });
        if !is_at_border {
            return Err(PictureError::EndsInside { point: end }.into());
        }
    }
    Ok(())
}

/// The edges at which a surface ends: no seams, and none that is a point.
fn borders_of(surface: &NurbsSurface, tolerance: f64) -> Vec<NurbsCurve> {
    let [u0, u1, v0, v1] = surface.edges();
    let mut borders = Vec::new();
    if !surface.is_closed_u(tolerance) {
        borders.extend([u0, u1]);
    }
    if !surface.is_closed_v(tolerance) {
        borders.extend([v0, v1]);
    }
    borders.retain(|edge| tolerance < edge.bounds().diagonal());
    borders
}
