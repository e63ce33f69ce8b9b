//! Contacts made exact: Newton's method on the parameters of both ends.

use glam::DVec3;

use crate::{
    NurbsCurve,
    ceiling::NEWTON_STEPS,
    numeric::{
        linear::TwoEquations,
        newton::{NewtonStep, within_limits},
    },
    tolerance::LAST_BIT,
};

/// An end beside which a contact is: a point, or a smooth part of a curve.
#[derive(Clone, Copy)]
pub(super) enum ContactEnd<'p> {
    Point(DVec3),
    Part(&'p NurbsCurve),
}

impl ContactEnd<'_> {
    /// Place, velocity and acceleration at a parameter; those of a point are zero.
    pub(super) fn at(self, t: f64) -> [DVec3; 3] {
        match self {
            Self::Point(point) => [point, DVec3::ZERO, DVec3::ZERO],
            Self::Part(curve) => {
                let found = curve.derivatives_at(t, 2);
                [found[0], found[1], found[2]]
            }
        }
    }

    pub(super) fn limits(self) -> [f64; 2] {
        match self {
            Self::Point(_) => [0.0, 0.0],
            Self::Part(curve) => [curve.domain().start(), curve.domain().end()],
        }
    }

    pub(super) fn is_curve(self) -> bool {
        matches!(self, Self::Part(_))
    }
}

/// Where two equations about the parameters of both ends come to zero, from a start; `equations` tells both values,
/// and their slopes by both parameters. Of a point, which has no parameter, its equation counts for nothing.
pub(super) fn contact(
    ends: [ContactEnd<'_>; 2],
    start: [f64; 2],
    equations: impl Fn([f64; 2]) -> ([f64; 2], [[f64; 2]; 2]),
) -> [f64; 2] {
    let limits = ends.map(ContactEnd::limits);
    let is_still = |last: [f64; 2], next: [f64; 2]| {
        (0..2).all(|i| (next[i] - last[i]).abs() <= LAST_BIT * next[i].abs())
    };
    let found = within_limits(limits, start, NEWTON_STEPS, is_still, |at| {
        let (mut values, mut slopes) = equations(at);
        for i in 0..2 {
            if !ends[i].is_curve() {
                values[i] = 0.0;
                slopes[i] = [0.0; 2];
                slopes[i][i] = 1.0;
                slopes[1 - i][i] = 0.0;
            }
        }
        let step = TwoEquations { matrix: slopes }.solved(values.map(|value| -value));
        NewtonStep::perhaps(step.iter().all(|step| step.is_finite()).then_some(step))
    });
    found.place()
}
