//! The circle in which a plane, or another sphere, cuts a sphere.

use std::f64::consts::TAU;

use glam::DVec3;

use super::{
    AnalyticForm, AnalyticSurface,
    coaxial::{LEAST_DEPTH, has_poles},
};
use crate::{CircleForm, Frame, Interval, NurbsCurve, NurbsSurface, frame::norm};

impl NurbsSurface {
    /// The circle in which a plane cuts a whole sphere, parametrized by its length; none where it is no sphere, and of a
    /// plane within some tolerances of touching it or of a pole.
    ///
    /// It begins where it is lowest on the seam, or lowest of all where it does not come there, and runs along the
    /// product of the plane's normal and the surface's.
    pub(in crate::surface) fn circle_of_ball(
        &self,
        plane: Frame,
        distance: f64,
    ) -> Option<NurbsCurve> {
        let AnalyticSurface { form: AnalyticForm::Sphere { radius }, frame, is_outward } =
            self.analytic(distance)?
        else {
            return None;
        };
        let (center, axis, normal) = (frame.origin(), frame.z(), plane.z());
        let height = (center - plane.origin()).dot(normal);
        let near = LEAST_DEPTH * distance;
        let to_pole = radius * axis.dot(normal).abs();
        let inside = radius - height.abs();
        let is_clear = near < inside && near < (to_pole - height.abs()).abs();
        if !is_clear || !has_poles(self, distance) {
            return None;
        }
        let own = (inside * (radius + height.abs())).sqrt();
        let middle = center - normal * height;
        let start = middle + direction_to_start(frame, normal, height, radius)? * own;
        let z = if is_outward { normal } else { -normal };
        let frame = Frame::from_normal(middle, z, Some(start - middle)).ok()?;
        let circle = NurbsCurve::ellipse(frame, [own; 2], CircleForm::NinePoint).ok()?;
        Some(circle.reparametrized(Interval::new(0.0, TAU * own).ok()?))
    }

    /// The circle in which it crosses another sphere, both whole; none of others, and of spheres within some tolerances
    /// of touching one another or of being one. It runs along N × N of the two.
    pub(in crate::surface) fn crossing_of_balls(
        &self,
        other: &Self,
        distance: f64,
    ) -> Option<Vec<NurbsCurve>> {
        let plane = self.radical_plane(other, distance)?;
        let of = |surface: &Self| {
            surface.analytic(distance).map(|found| (found.frame.origin(), found.radius()))
        };
        let ((center, radius), (its_center, its_radius)) = (of(self)?, of(other)?);
        let apart = norm(its_center - center);
        let depth = (radius + its_radius - apart).min(apart - (radius - its_radius).abs());
        let is_clear = LEAST_DEPTH * distance < depth && has_poles(other, distance);
        let circle = is_clear.then(|| self.circle_of_ball(plane, distance))??;
        Some(vec![self.directed_across(other, circle)?])
    }
}

/// From the middle of the circle to where it begins.
fn direction_to_start(frame: Frame, normal: DVec3, height: f64, radius: f64) -> Option<DVec3> {
    // In the plane of the seam, in coordinates from the centre: along x and along the axis.
    let [a, b] = [normal.dot(frame.x()), normal.dot(frame.z())];
    let size = libm::hypot(a, b);
    let away = -height / size;
    let on_seam = if away.abs() < radius {
        let half = (radius * radius - away * away).sqrt();
        let place =
            |sign: f64| [(a * away - b * half * sign) / size, (b * away + a * half * sign) / size];
        let places = [place(1.0), place(-1.0)].into_iter().filter(|place| 0.0 < place[0]);
        places.min_by(|one, other| one[1].total_cmp(&other[1]))
    } else {
        None
    };
    let way = match on_seam {
        Some([x, z]) => frame.x() * x + frame.z() * z + normal * height,
        // Downward, of a plane across the axis anywhere.
        None => normal * normal.dot(frame.z()) - frame.z(),
    };
    let length = norm(way);
    (0.0 < length).then(|| way / length)
}
