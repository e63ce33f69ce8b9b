//! Conics in a plane, by their equation.

use glam::{DMat2, DMat3, DVec2, DVec3, DVec4};

use crate::{
    Frame,
    numeric::{linear::TwoEquations, symmetric_eigen::eigen_of_two},
    tolerance::{LAST_BIT, ROUND_RELATIVE, ROUNDNESS_RELATIVE},
};

/// Steps of Newton's method onto a conic.
const STEPS: usize = 8;

/// The points (x, y) of a plane with p·Mp = 0, where p = (x, y, 1).
#[derive(Clone, Copy, Debug)]
pub(super) struct PlaneConic {
    /// With its origin near what is looked at.
    pub(super) frame: Frame,
    /// The symmetric M.
    pub(super) matrix: DMat3,
}

/// An ellipse: centre + x·cos + y·sin.
pub(super) struct Ellipse {
    center: DVec2,
    axes: [DVec2; 2],
    radii: [f64; 2],
}

impl Ellipse {
    /// The angle at which a place is seen from the centre of the circle that it is the image of.
    pub(super) fn angle(&self, place: DVec2) -> f64 {
        let out = place - self.center;
        let [x, y] = [0, 1].map(|i| out.dot(self.axes[i]) / self.radii[i]);
        libm::atan2(y, x)
    }

    /// The place at an angle, so many times as far from the centre.
    pub(super) fn place(&self, angle: f64, times: f64) -> DVec2 {
        let (sine, cosine) = libm::sincos(angle);
        let [x, y] = [0, 1].map(|i| self.axes[i] * self.radii[i]);
        self.center + (x * cosine + y * sine) * times
    }
}

impl PlaneConic {
    /// The circle about the origin of a frame.
    pub(super) fn circle(frame: Frame, radius: f64) -> Self {
        Self { frame, matrix: DMat3::from_diagonal(DVec3::new(1.0, 1.0, -radius * radius)) }
    }

    /// The coordinates of a point in the plane.
    pub(super) fn local(&self, point: DVec3) -> DVec2 {
        let out = point - self.frame.origin();
        DVec2::new(out.dot(self.frame.x()), out.dot(self.frame.y()))
    }

    /// The homogeneous point in space with a weight.
    pub(super) fn point(&self, place: DVec2, weight: f64) -> DVec4 {
        (self.frame.point(place.extend(0.0)) * weight).extend(weight)
    }

    /// The value of the equation in a place, and its gradient.
    fn value(&self, place: DVec2) -> (f64, DVec2) {
        let image = self.matrix * place.extend(1.0);
        (place.extend(1.0).dot(image), 2.0 * image.truncate())
    }

    /// Where Newton's method across it leads from a place.
    pub(super) fn onto(&self, start: DVec2) -> Option<DVec2> {
        let mut place = start;
        for _ in 0..STEPS {
            let (value, gradient) = self.value(place);
            let step = gradient * (value / gradient.length_squared());
            place -= step;
            if !place.is_finite() {
                return None;
            }
            if step.length() <= LAST_BIT * place.length() {
                break;
            }
        }
        Some(place)
    }

    /// The ellipse that it is; a circle begins at a place.
    pub(super) fn ellipse(&self, start: DVec2) -> Option<Ellipse> {
        let squares = DMat2::from_mat3(self.matrix);
        let linear = self.matrix.z_axis.truncate();
        let [(small, axis), (large, _)] = eigen_of_two(squares);
        if small * large <= 0.0 || small.abs() < ROUNDNESS_RELATIVE * large.abs() {
            return None;
        }
        let [x, y] = TwoEquations::symmetric(squares.x_axis.x, squares.x_axis.y, squares.y_axis.y)
            .solved([-linear.x, -linear.y]);
        let center = DVec2::new(x, y);
        let level = self.matrix.z_axis.z + linear.dot(center);
        let is_circle = (large - small).abs() <= ROUND_RELATIVE * large.abs();
        let (axis, eigenvalues) = match is_circle {
            true => ((start - center).normalize(), [0.5 * (small + large); 2]),
            false => (axis, [small, large]),
        };
        let radii = eigenvalues.map(|eigenvalue| libm::sqrt(-level / eigenvalue));
        let is_real = center.is_finite() && axis.is_finite() && radii.iter().all(|r| 0.0 < *r);
        is_real.then_some(Ellipse { center, axes: [axis, axis.perp()], radii })
    }

    /// The middle of the control polygon of the arc between two places, which is no half of an ellipse, and its weight.
    pub(super) fn between(&self, from: DVec2, to: DVec2) -> Option<(DVec2, f64)> {
        let [a, c] = [from, to].map(|place| place.extend(1.0));
        let pole = (self.matrix * a).cross(self.matrix * c);
        let b = pole / pole.z;
        let squared = -a.dot(self.matrix * c) / (2.0 * b.dot(self.matrix * b));
        let is_real = b.is_finite() && squared.is_finite() && 0.0 < squared;
        is_real.then(|| (b.truncate(), libm::sqrt(squared)))
    }
}
