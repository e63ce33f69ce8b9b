//! Planes: surfaces whose control points lie in one, which cover their part of it once.

use glam::{DVec3, DVec4};

use super::{AnalyticForm, AnalyticSurface};
use crate::{
    Frame, Grid, NurbsCurve, NurbsSurface,
    curve::plane_of,
    surface::intersection::square::{product, slope_u, slope_v},
    tolerance::ANALYTIC_RELATIVE,
};

impl NurbsSurface {
    /// The plane that it is in, with its normal along Su × Sv.
    pub(super) fn plane_form(&self, distance: f64, closed: [bool; 2]) -> Option<AnalyticSurface> {
        let frame = self.flat_frame()?;
        let (first, normal) = (frame.origin(), frame.z());
        let normal = normal * self.transformed(&frame.from_space()).sign_of(across)?;
        let frame = Frame::from_normal(first, normal, None).ok()?;
        self.has_simple_border(distance, closed).then_some(AnalyticSurface {
            form: AnalyticForm::Plane,
            frame,
            is_outward: true,
        })
    }

    /// The plane in which all its control points lie up to rounding.
    pub(in crate::surface) fn flat_frame(&self) -> Option<Frame> {
        let allowed = ANALYTIC_RELATIVE * self.bounds().magnitude();
        let points = self.points();
        let (first, normal) = (points.get(0, 0), plane_of(points.as_slice())?);
        let is_in = |&point: &DVec3| normal.dot(point - first).abs() <= allowed;
        points.iter().all(is_in).then(|| Frame::from_normal(first, normal, None).ok())?
    }

    /// Of two spheres the plane in which they cross, through all points of the same power.
    pub(in crate::surface) fn radical_plane(&self, other: &Self, distance: f64) -> Option<Frame> {
        let sphere = |surface: &Self| {
            let found = surface.analytic(distance)?;
            let AnalyticForm::Sphere { radius } = found.form else { return None };
            Some((found.frame.origin(), radius))
        };
        let ((center, radius), (its_center, its_radius)) = (sphere(self)?, sphere(other)?);
        let way = its_center - center;
        let squares = way.length_squared() + (radius - its_radius) * (radius + its_radius);
        Frame::from_normal(center + way * (0.5 * squares / way.length_squared()), way, None).ok()
    }

    /// Whether its border does not meet itself; where edges are one, that around it and that of
    /// the hole.
    fn has_simple_border(&self, distance: f64, closed: [bool; 2]) -> bool {
        let is_simple = |line: &NurbsCurve| {
            line.self_intersections(distance).is_ok_and(|meetings| meetings.is_empty())
        };
        let [u0, u1, v0, v1] = self.edges();
        let lines = match closed {
            [false, false] => return self.border(distance).is_ok_and(|border| is_simple(&border)),
            [true, false] => [v0, v1],
            [false, true] => [u0, u1],
            [true, true] => return false,
        };
        let is_wide = |line: &&NurbsCurve| distance < line.bounds().diagonal();
        let lines: Vec<&NurbsCurve> = lines.iter().filter(is_wide).collect();
        let are_apart = match lines[..] {
            [a, b] => a.intersections(b, distance).is_ok_and(|meetings| meetings.is_empty()),
            _ => lines.len() == 1,
        };
        are_apart && lines.into_iter().all(is_simple)
    }
}

/// The determinant of (x, y, w) and its derivatives, which has the sign of the z of Su × Sv.
fn across(net: &Grid<DVec4>) -> Grid<f64> {
    let flat: Grid<DVec3> = net.map(|point| DVec3::new(point.x, point.y, point.w));
    let normal = product(&slope_u(&flat), &slope_v(&flat), DVec3::cross);
    product(&flat, &normal, DVec3::dot)
}
