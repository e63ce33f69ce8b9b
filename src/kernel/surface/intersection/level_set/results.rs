//! What is found: lines on surfaces, and places of curves on them.

use glam::DVec3;

use crate::NurbsCurve;

/// The zero set of a field on a surface.
///
/// The plane z = 3/5 cuts the unit sphere in a circle of radius 4/5:
///
/// ```
/// use virote_kernel::{Frame, NurbsSurface, Surface, Tolerance, glam::DVec3};
///
/// let sphere = Surface::from(NurbsSurface::sphere(Frame::XY, 1.0)?);
/// let found = sphere.section(Frame::XY.at(DVec3::Z * 0.6), Tolerance::DEFAULT)?;
/// let around: f64 = found.curves.iter().map(|curve| curve.length(curve.domain())).sum();
/// assert!((around - 1.6 * std::f64::consts::PI).abs() < 1e-5);
/// assert!(found.touches.is_empty() && found.contacts.is_empty() && found.uncertain.is_empty());
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct LevelSet {
    /// Its lines. Where the field changes its sign the higher side is to the left of the line,
    /// seen from the side of the normal. A line ends at the surface's boundary, or where more than
    /// two branches meet.
    pub curves: Vec<NurbsCurve>,
    /// Points that the field touches zero in, or that branches shrink to.
    pub touches: Vec<DVec3>,
    /// Points of the lines along which two surfaces only touch, one of each.
    pub contacts: Vec<DVec3>,
    /// Points where rounding decides whether lines cross and how they go on: where surfaces touch more
    /// closely than second derivatives tell.
    pub uncertain: Vec<DVec3>,
}

/// A place that a curve and a surface have in common.
///
/// A line through the centre of a unit sphere pierces it at −1 and 1:
///
/// ```
/// use virote_kernel::{Curve, Frame, NurbsCurve, NurbsSurface, Surface, Tolerance, glam::DVec3};
///
/// let sphere = Surface::from(NurbsSurface::sphere(Frame::XY, 1.0)?);
/// let line = Curve::from(NurbsCurve::line(DVec3::X * -2.0, DVec3::X * 2.0)?);
/// let [first, second] = &sphere.piercings(&line, Tolerance::DEFAULT)?[..] else {
///     unreachable!("in two points");
/// };
/// assert!(first.point.distance(DVec3::NEG_X) < 1e-9 && (first.t - 0.25).abs() < 1e-9);
/// assert!(second.point.distance(DVec3::X) < 1e-9 && (second.t - 0.75).abs() < 1e-9);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveSurfaceIntersection {
    /// The parameter on the curve.
    pub t: f64,
    /// The parameters on the surface; at a seam and at a pole the start of the domain.
    pub uv: [f64; 2],
    /// The point, in the middle between both.
    pub point: DVec3,
}
