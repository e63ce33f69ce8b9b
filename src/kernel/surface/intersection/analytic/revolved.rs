//! Cylinders, cones, spheres and tori: a meridian that is a line or an arc, turned about an axis.
//!
//! The axis is that of the circle in the middle; the surface of revolution of the meridian at the
//! start must be this one, point by point.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::{DAffine3, DVec3, DVec4};

use super::{AnalyticForm, AnalyticSurface};
use crate::{
    AnalyticCurve, Frame, Grid, NurbsCurve, NurbsSurface, Tolerance, bezier,
    curve::{rounded, rounded_place},
    frame::norm,
    surface::intersection::square::product,
};

impl NurbsSurface {
    /// The surface about an axis that it is, with u around.
    pub(super) fn revolved_form(
        &self,
        allowed: f64,
        distance: f64,
        closed: [bool; 2],
    ) -> Option<AnalyticSurface> {
        let middle = self.domain_v().at(0.5);
        let circle = self.isocurve_v(middle).analytic_within(allowed)?;
        let AnalyticCurve::Circle { mut frame, radius, turn } = circle else { return None };
        let line = self.isocurve_u(self.domain_u().start());
        if let Some(AnalyticCurve::Line { direction, .. }) = line.analytic_within(allowed) {
            frame = along_line(frame, direction)?;
        }
        let local = self.transformed(&frame.from_space());
        let around = local.isocurve_v(middle);
        let flat = DAffine3::from_scale(DVec3::new(1.0, 0.0, 1.0));
        let meridian = line.transformed(&frame.from_space()).transformed(&flat);
        let found = Meridian::of(&meridian, allowed)?;
        let is_thin = matches!(found.form, AnalyticForm::Torus { minor, .. } if minor <= distance);
        if is_thin || radius <= distance {
            return None;
        }
        let is_full = [TAU <= turn, found.is_full];
        if is_full != closed || !local.is_product(&around, radius, &meridian, allowed) {
            return None;
        }
        let origin = rounded_place(frame.point(DVec3::Z * found.height), allowed);
        let frame = match found.is_downward {
            false => frame.at(origin),
            // Counter-clockwise about an axis downward it begins where it ended.
            true => {
                let end = if is_full[0] { 0.0 } else { turn };
                let x = frame.x() * libm::cos(end) + frame.y() * libm::sin(end);
                Frame::from_normal(origin, -frame.z(), Some(x)).ok()?
            }
        };
        Some(AnalyticSurface { form: found.form, frame, is_outward: found.is_outward })
    }

    /// Whether it is the meridian turned about z as the circle `around` turns, at every (u, v).
    ///
    /// The difference of both is a polynomial over the product of their denominators: it is no
    /// longer than the largest quotient of coefficients.
    fn is_product(
        &self,
        around: &NurbsCurve,
        radius: f64,
        meridian: &NurbsCurve,
        allowed: f64,
    ) -> bool {
        let knots = [&self.knots_u, &self.knots_v];
        self.knots_u.spans().all(|span_u| {
            let circle = bezier::piece(around.knots(), around.control_points(), span_u);
            self.knots_v.spans().all(|span_v| {
                let line = bezier::piece(meridian.knots(), meridian.control_points(), span_v);
                let net = bezier::patch(knots, &self.control_points, span_u, span_v);
                let model = Grid::from_fn(net.n_rows(), net.n_columns(), |i, j| {
                    let (c, m) = (circle[i], line[j]);
                    let out = m.x / radius;
                    DVec4::new(out * c.x, out * c.y, m.z * c.w, m.w * c.w)
                });
                let gaps = product(&net, &model, |p, m| p.truncate() * m.w - m.truncate() * p.w);
                let weights = product(&net, &model, |p, m| p.w * m.w);
                gaps.iter()
                    .zip(&weights)
                    .all(|(gap, w)| gap.is_finite() && norm(*gap) <= allowed * w)
            })
        })
    }
}

/// What a meridian in the half plane of x and z makes.
struct Meridian {
    form: AnalyticForm,
    /// Where the origin stands on the axis.
    height: f64,
    /// Whether the axis must point downward.
    is_downward: bool,
    /// Whether its normal, to the right along it, points outward.
    is_outward: bool,
    is_full: bool,
}

impl Meridian {
    fn of(meridian: &NurbsCurve, allowed: f64) -> Option<Self> {
        let (start, end) = (meridian.start(), meridian.end());
        if start.x.min(end.x) < -allowed {
            return None;
        }
        // Of a narrow band no more is known than that the centre is on the axis.
        let squares = end.length_squared() - start.length_squared();
        let on_axis = DVec3::Z * rounded(0.5 * squares / (end.z - start.z), allowed);
        let ball = meridian.arc_about(on_axis, DVec3::Y, allowed);
        let (frame, form, turn) = match ball.or_else(|| meridian.analytic_within(allowed))? {
            AnalyticCurve::Line { .. } => return Self::straight(start, end, allowed),
            AnalyticCurve::Circle { frame, radius, turn } if frame.origin() == on_axis => {
                let is_half = turn <= PI + Tolerance::DEFAULT.angle;
                (frame, is_half.then_some(AnalyticForm::Sphere { radius })?, turn)
            }
            AnalyticCurve::Circle { frame, radius: minor, turn } => {
                let major = frame.origin().x;
                let is_ring = allowed < major - minor;
                (frame, is_ring.then_some(AnalyticForm::Torus { major, minor })?, turn)
            }
        };
        Some(Self {
            form,
            height: frame.origin().z,
            is_downward: false,
            // Counter-clockwise seen with x to the right and z upward.
            is_outward: frame.z().y < 0.0,
            is_full: TAU <= turn,
        })
    }

    fn straight(start: DVec3, end: DVec3, allowed: f64) -> Option<Self> {
        let (low, high) = if start.x <= end.x { (start, end) } else { (end, start) };
        let (widening, rise) = (high.x - low.x, high.z - low.z);
        let half_angle = libm::atan2(widening, rise.abs());
        let least = Tolerance::DEFAULT.angle;
        let radius = if low.x <= allowed { 0.0 } else { rounded(low.x, allowed) };
        let (form, height, is_downward) = if widening <= allowed && allowed < rise.abs() {
            (AnalyticForm::Cylinder { radius }, start.z, false)
        } else if least < half_angle && half_angle < FRAC_PI_2 - least {
            (AnalyticForm::Cone { radius, half_angle }, low.z, rise < 0.0)
        } else {
            return None;
        };
        let is_outward = start.z < end.z;
        Some(Self { form, height, is_downward, is_outward, is_full: false })
    }
}

/// A frame with z along a line, where that differs by no more than what a narrow arc leaves open:
/// the axis of a cylinder.
fn along_line(frame: Frame, direction: DVec3) -> Option<Frame> {
    let axis = if frame.z().dot(direction) < 0.0 { -direction } else { direction };
    match norm(axis - frame.z()) <= Tolerance::DEFAULT.angle {
        true => Frame::from_normal(frame.origin(), axis, Some(frame.x())).ok(),
        false => Some(frame),
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_4;

    use super::*;

    /// What a straight meridian makes between two places in the half plane, with the flags that say where it points.
    fn straight(from: [f64; 2], to: [f64; 2]) -> Option<(AnalyticForm, f64, bool, bool)> {
        let place = |[x, z]: [f64; 2]| DVec3::new(x, 0.0, z);
        let found = Meridian::straight(place(from), place(to), 1e-12)?;
        assert!(!found.is_full);
        Some((found.form, found.height, found.is_downward, found.is_outward))
    }

    #[test]
    fn straight_meridians_make_cylinders_and_cones() {
        let cylinder = AnalyticForm::Cylinder { radius: 2.0 };
        assert_eq!(straight([2.0, 1.0], [2.0, 5.0]), Some((cylinder, 1.0, false, true)));
        assert_eq!(straight([2.0, 5.0], [2.0, 1.0]), Some((cylinder, 5.0, false, false)));
        let cone = |radius: f64| AnalyticForm::Cone { radius, half_angle: FRAC_PI_4 };
        assert_eq!(straight([0.0, 1.0], [3.0, 4.0]), Some((cone(0.0), 1.0, false, true)));
        assert_eq!(straight([4.0, 4.0], [1.0, 1.0]), Some((cone(1.0), 1.0, false, false)));
        assert_eq!(straight([1.0, 4.0], [4.0, 1.0]), Some((cone(1.0), 4.0, true, false)));
    }

    #[test]
    fn what_is_flat_or_hardly_a_cone_is_neither() {
        let least = Tolerance::DEFAULT.angle;
        assert_eq!(straight([1.0, 0.0], [3.0, 0.0]), None);
        assert_eq!(straight([1.0, 0.0], [3.0, least]), None);
        assert_eq!(straight([1.0, 0.0], [1.0 + 0.5 * least, 1.0]), None);
        assert!(straight([1.0, 0.0], [1.0 + 2.0 * least, 1.0]).is_some());
        assert!(straight([1.0, 0.0], [3.0, 4.0 * least]).is_some());
    }
}
