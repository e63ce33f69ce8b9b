//! Surfaces that lie on one plane, cylinder, cone, sphere or torus, or are the same.

use glam::{DVec2, DVec3};

use super::{AnalyticForm, AnalyticSurface};
use crate::{Direction, NurbsSurface};

impl NurbsSurface {
    /// Whether it and another one are parts of one surface within a distance: the same but for their directions, or
    /// one of them nowhere that is looked at further from the plane, cylinder, cone, sphere or torus of the other.
    pub(crate) fn shares_carrier(&self, other: &Self, distance: f64) -> bool {
        let [own, its] = [self.bounds(), other.bounds()];
        let apart = (own.min - its.max).max(its.min - own.max).max_element();
        apart <= distance
            && (self.is_same_as(other)
                || self.is_on_carrier_of(other, distance)
                || other.is_on_carrier_of(self, distance))
    }

    /// Whether it is another one, whichever way u and v of that run.
    fn is_same_as(&self, other: &Self) -> bool {
        if [self.degree_u(), self.degree_v()] != [other.degree_u(), other.degree_v()] {
            return false;
        }
        let back_u = || other.reversed(Direction::U);
        let back_v = || other.reversed(Direction::V);
        self == other
            || *self == back_v()
            || *self == back_u()
            || *self == back_u().reversed(Direction::V)
    }

    fn is_on_carrier_of(&self, other: &Self, distance: f64) -> bool {
        let Some(carrier) = other.carrier(distance) else { return false };
        self.samples().into_iter().all(|point| carrier.height_of(point).abs() <= distance)
    }

    /// The plane in which it lies, however it covers it, or what [`Self::analytic`] tells.
    fn carrier(&self, distance: f64) -> Option<AnalyticSurface> {
        let plane = self.flat_frame().map(|frame| AnalyticSurface {
            form: AnalyticForm::Plane,
            frame,
            is_outward: true,
        });
        plane.or_else(|| self.analytic(distance))
    }
}

impl AnalyticSurface {
    /// How far a point is from the whole of what it is a part of, negative below a plane and inside of what is round;
    /// from a cone as from its straight lines.
    fn height_of(&self, point: DVec3) -> f64 {
        let place = self.frame.from_space().transform_point3(point);
        let out = place.truncate().length();
        match self.form {
            AnalyticForm::Plane => place.z,
            AnalyticForm::Cylinder { radius } => out - radius,
            AnalyticForm::Cone { radius, half_angle } => {
                let (sine, cosine) = libm::sincos(half_angle);
                (out - radius) * cosine - place.z * sine
            }
            AnalyticForm::Sphere { radius } => place.length() - radius,
            AnalyticForm::Torus { major, minor } => {
                DVec2::new(out - major, place.z).length() - minor
            }
        }
    }
}
