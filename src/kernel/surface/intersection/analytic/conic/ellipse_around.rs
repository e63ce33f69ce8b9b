//! The ellipse in which a plane cuts a cylinder or cone all around.
//!
//! Over its circle of height z, of radius r + z tan α, a plane is n·p = d: with the normal's part a along the axis and b
//! across it z·a + (r + z tan α)·b cos φ = d, where φ is the angle from the normal's way across. Where b tan α < |a| each
//! meridian has one such place, and their heights lie between those of cos φ = ±1: where these are between both rims
//! nothing else of the surface is in the plane.

use std::f64::consts::TAU;

use glam::DVec3;

use super::{
    super::{AnalyticForm, coaxial::LEAST_DEPTH},
    arc_of,
    carrier::ExactCarrier,
};
use crate::{
    Frame, Interval, NurbsCurve, NurbsSurface,
    frame::norm,
    tolerance::{ANALYTIC_RELATIVE, CONTACT_SHARE},
};

impl NurbsSurface {
    /// The ellipse in which a plane cuts a cylinder or cone that goes all around its axis, parametrized by its length; none
    /// of another surface or conic, and where that comes within some tolerances of a rim or an apex.
    ///
    /// It begins where the surface does, and runs along the product of the plane's normal and the surface's.
    pub(in crate::surface) fn ellipse_around(
        &self,
        plane: Frame,
        distance: f64,
    ) -> Option<NurbsCurve> {
        let found = self.analytic(distance)?;
        let (radius, slope) = match found.form {
            AnalyticForm::Cylinder { radius } => (radius, 0.0),
            AnalyticForm::Cone { radius, half_angle } => (radius, libm::tan(half_angle)),
            _ => return None,
        };
        let (frame, normal) = (found.frame, plane.z());
        let along = normal.dot(frame.z());
        let across = norm(normal - frame.z() * along);
        if along.abs() <= slope * across {
            return None;
        }
        let offset = (plane.origin() - frame.origin()).dot(normal);
        let height = |part: f64| (offset - radius * part) / (along + slope * part);
        let [u, v] = [self.domain_u(), self.domain_v()];
        let rims = [(u.start(), v.start()), (u.end(), v.end())]
            .map(|(u, v)| (self.point_at(u, v) - frame.origin()).dot(frame.z()));
        let (low, high) = (rims[0].min(rims[1]), rims[0].max(rims[1]));
        let near = LEAST_DEPTH * distance;
        let is_between = |height: f64| low + near < height && height < high - near;
        let is_clear = is_between(height(across)) && is_between(height(-across));
        if !is_clear || self.direction_around(frame, distance).is_none() {
            return None;
        }
        let carrier = ExactCarrier::of(self, distance)?;
        let on_axis = frame.origin() + frame.z() * (offset / along);
        let conic = carrier.conics(plane.at(on_axis)).pop()?;
        let at_start = height(normal.dot(frame.x()));
        let start = DVec3::new(radius + slope * at_start, 0.0, at_start);
        let start = conic.onto(conic.local(frame.point(start)))?;
        let sweep = if found.is_outward { TAU } else { -TAU };
        let domain = Interval::new(0.0, 1.0).ok()?;
        let ellipse = arc_of(&conic.ellipse(start)?, &conic, [start; 2], sweep, domain)?;
        let is_proven = carrier.holds(&ellipse, ANALYTIC_RELATIVE * self.bounds().magnitude())
            && self.has_all_of(&ellipse, [CONTACT_SHARE * distance, distance]) == Some(true);
        let length = Interval::new(0.0, ellipse.length(domain)).ok()?;
        is_proven.then(|| ellipse.reparametrized(length))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Direction;

    const DISTANCE: f64 = 1e-6;

    fn cylinder() -> NurbsSurface {
        NurbsSurface::cone(Frame::XY, [3.0; 2], 10.0).expect("a cylinder")
    }

    /// The plane of height z at the origin that climbs along x.
    fn climbing(z: f64, slope: f64) -> Frame {
        let normal = DVec3::new(-slope, 0.0, 1.0);
        Frame::from_normal(DVec3::Z * z, normal, None).expect("a plane")
    }

    #[test]
    fn a_cylinder_is_cut_in_an_ellipse_that_begins_on_its_seam() {
        let found = cylinder().ellipse_around(climbing(5.0, 4.0 / 3.0), DISTANCE);
        let ellipse = found.expect("an ellipse");
        // Of half axes 5 and 3: 20·E(0.8), Abramowitz & Stegun, *Handbook of Mathematical Functions*, 17.3.3.
        let length = 25.526_998_863_398_1;
        assert!((ellipse.domain().end() - length).abs() < 1e-11, "{:?}", ellipse.domain());
        assert!(ellipse.start().distance(DVec3::new(3.0, 0.0, 9.0)) < 1e-14);
        assert_eq!(ellipse.start(), ellipse.end());
        let quarter = ellipse.point_at(0.25 * length);
        assert!(quarter.distance(DVec3::new(0.0, 3.0, 5.0)) < 1e-11, "{quarter}");
    }

    #[test]
    fn a_cone_is_cut_in_an_ellipse_between_its_lowest_and_its_highest_place() {
        let cone = NurbsSurface::cone(Frame::XY, [0.0, 4.0], 4.0).expect("a cone");
        let ellipse = cone.ellipse_around(climbing(1.0, 0.5), DISTANCE).expect("an ellipse");
        let bounds = ellipse.bounds();
        // x² + y² = z² and z = 1 + x/2.
        let half_width = 2.0 / 3.0_f64.sqrt();
        assert!(bounds.min.distance(DVec3::new(-2.0 / 3.0, -half_width, 2.0 / 3.0)) < 1e-12);
        assert!(bounds.max.distance(DVec3::new(2.0, half_width, 2.0)) < 1e-12);
    }

    #[test]
    fn it_runs_along_the_product_of_the_normals_whichever_way_the_parameters_run() {
        let plane = climbing(5.0, 0.7);
        let turned = Frame::from_normal(plane.origin(), -plane.z(), None).expect("a plane");
        let given = cylinder();
        let surfaces =
            [given.reversed(Direction::U), given.reversed(Direction::V), given.swapped()];
        for surface in surfaces.iter().chain([&given]) {
            for plane in [plane, turned] {
                let ellipse = surface.ellipse_around(plane, DISTANCE).expect("an ellipse");
                let at = ellipse.derivatives_at(ellipse.domain().at(0.3), 1);
                let [u, v] = surface.closest(at[0]).parameters;
                let normal = surface.normal_at(u, v).expect("a normal");
                assert!(0.0 < plane.z().cross(normal).dot(at[1]));
                let seam = at[0].with_z(0.0).length() - 3.0;
                assert!(seam.abs() < 1e-14 && ellipse.start().y.abs() < 1e-14);
            }
        }
    }

    #[test]
    fn what_leaves_through_a_rim_or_is_no_ellipse_is_left_to_a_search() {
        let is_told =
            |surface: &NurbsSurface, plane| surface.ellipse_around(plane, DISTANCE).is_some();
        // It reaches up to 3 above its middle.
        assert!(is_told(&cylinder(), climbing(7.0 - 5e-6, 1.0)));
        assert!(!is_told(&cylinder(), climbing(7.0 - 3e-6, 1.0)));
        assert!(!is_told(&cylinder(), climbing(8.0, 1.0)));
        assert!(!is_told(&cylinder(), climbing(11.0, 0.1)));
        let cone = NurbsSurface::cone(Frame::XY, [1.0, 3.0], 2.0).expect("a cone");
        assert!(is_told(&cone, climbing(1.0, 0.3)));
        // A parabola, a hyperbola, and an ellipse of which only a part is on a half.
        assert!(!is_told(&cone, climbing(1.0, 1.0)));
        assert!(!is_told(&cone, climbing(1.0, 3.0)));
        let domain = cylinder().domain_u();
        let [half, _] = cylinder().split(Direction::U, domain.at(0.5)).expect("halves");
        assert!(!is_told(&half, climbing(5.0, 0.5)));
        let sphere = NurbsSurface::sphere(Frame::XY, 1.0).expect("a sphere");
        assert!(!is_told(&sphere, climbing(0.0, 0.5)));
    }
}
