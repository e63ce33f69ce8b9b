//! Whole spheres with their poles elsewhere: where surfaces touch along a line through a pole, whose
//! parameters are all one point, the line is not followed over it. The sphere is the same about any axis.

use std::sync::Arc;

use glam::DVec3;

use super::tangential_contact::poles;
use crate::{AnalyticForm, AnalyticSurface, Frame, NurbsCurve, NurbsSurface, frame::unit};

/// Steps of −1, 0 and 1 that lead to the directions in which poles are looked for: the faces, edges and
/// corners of a cube, one of each two that are opposite.
const DIRECTIONS: [[i8; 3]; 13] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [1, 1, 0],
    [1, -1, 0],
    [1, 0, 1],
    [1, 0, -1],
    [0, 1, 1],
    [0, 1, -1],
    [1, 1, 1],
    [1, 1, -1],
    [1, -1, 1],
    [1, -1, -1],
];

/// The angle, radians, by which a sphere about another axis has its seam away from where a frame has its x axis by
/// itself: there, through the axes of space, much touches.
const SEAM_TURN: f64 = 0.7;

/// The surfaces, of which a whole sphere that touches the other in a pole, within the tolerance, has its poles as far
/// from it as any of some axes allows.
pub(super) fn with_poles_aside(
    surfaces: [Arc<NurbsSurface>; 2],
    contact: f64,
    tolerance: f64,
) -> [Arc<NurbsSurface>; 2] {
    let [a, b] = &surfaces;
    if poles([a, b], tolerance).is_empty() {
        return surfaces;
    }
    [(a, b), (b, a)].map(|(surface, other)| {
        turned(surface, other, contact).map_or_else(|| Arc::clone(surface), Arc::new)
    })
}

fn turned(surface: &NurbsSurface, other: &NurbsSurface, contact: f64) -> Option<NurbsSurface> {
    let (frame, radius, is_outward) = whole_sphere(surface, contact)?;
    let away = |axis: DVec3| {
        let pole = |sign: f64| other.closest(frame.origin() + axis * (sign * radius)).distance;
        pole(1.0).min(pole(-1.0))
    };
    let axes = DIRECTIONS.into_iter().filter_map(|[x, y, z]| {
        unit(frame.x() * f64::from(x) + frame.y() * f64::from(y) + frame.z() * f64::from(z))
    });
    let (_, axis) = axes.map(|axis| (away(axis), axis)).max_by(|a, b| a.0.total_cmp(&b.0))?;
    about(Frame::from_normal(frame.origin(), axis, None).ok()?, radius, is_outward)
}

/// A whole sphere with a pole in a direction of its own frame; none of other surfaces.
pub(super) fn sphere_about(
    surface: &NurbsSurface,
    contact: f64,
    pole: DVec3,
) -> Option<NurbsSurface> {
    let (frame, radius, is_outward) = whole_sphere(surface, contact)?;
    let axis = frame.x() * pole.x + frame.y() * pole.y + frame.z() * pole.z;
    let straight = Frame::from_normal(frame.origin(), axis, None).ok()?;
    let (sine, cosine) = libm::sincos(SEAM_TURN);
    let x = straight.x() * cosine + straight.y() * sine;
    about(Frame::from_normal(frame.origin(), axis, Some(x)).ok()?, radius, is_outward)
}

fn about(frame: Frame, radius: f64, is_outward: bool) -> Option<NurbsSurface> {
    let sphere = NurbsSurface::sphere(frame, radius).ok()?;
    Some(if is_outward { sphere } else { sphere.swapped() })
}

/// The frame and the radius of a sphere that is whole, and whether its normals point outward.
fn whole_sphere(surface: &NurbsSurface, contact: f64) -> Option<(Frame, f64, bool)> {
    let AnalyticSurface { form: AnalyticForm::Sphere { radius }, frame, is_outward } =
        surface.analytic(contact)?
    else {
        return None;
    };
    let [u0, u1, v0, v1] = surface.edges();
    let are_poles = |low: &NurbsCurve, high: &NurbsCurve| {
        let is_point = |edge: &NurbsCurve| edge.bounds().diagonal() <= contact;
        is_point(low) && is_point(high) && radius < low.start().distance(high.start())
    };
    let is_whole = surface.is_closed_u(contact) && are_poles(&v0, &v1)
        || surface.is_closed_v(contact) && are_poles(&u0, &u1);
    is_whole.then_some((frame, radius, is_outward))
}
