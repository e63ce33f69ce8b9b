//! Two straight legs, which meet in a closed form.
//!
//! Legs that part clearly meet in one place at most: where their lines come nearest, or at an end. Only those that stay
//! within the tolerance of one another for long are left to the search, which tells a touch from a shared stretch.

use glam::DVec3;

use super::meeting::{CurveIntersection, IntersectionSearch};
use crate::{curve::NurbsCurve, homogeneous};

/// The share of the shorter leg, and of the longest touch, for which legs that part clearly may be within the tolerance.
const SHORT_SHARE: f64 = 0.25;

/// Roundings beyond the tolerance at which legs are apart for certain.
const APART_ROUNDINGS: f64 = 16.0;

/// What two straight legs come to.
pub(super) enum LegMeeting {
    /// They are apart.
    Apart,
    At(CurveIntersection),
}

impl IntersectionSearch<'_> {
    /// Where two straight legs meet; none where a curve is not one, or the search must tell.
    pub(super) fn leg_meeting(&self) -> Option<LegMeeting> {
        let legs = [leg(self.first)?, leg(self.second)?];
        let [own, other] = legs.map(|[start, end]| end - start);
        let fractions = nearest_fractions(legs);
        let [from, to] = [0, 1].map(|i| legs[i][0].lerp(legs[i][1], fractions[i]));
        if self.tolerance + APART_ROUNDINGS * self.rounding < from.distance(to) {
            return Some(LegMeeting::Apart);
        }
        let shorter = own.length().min(other.length());
        let sine = own.cross(other).length() / (own.length() * other.length());
        let is_joint = self.lead_away([own, other], fractions);
        let way = if is_joint { self.tolerance } else { self.tolerance / sine };
        // Not so where that is no number.
        let is_clear = way <= SHORT_SHARE * self.longest_touch.min(shorter);
        let at = [(self.first, fractions[0]), (self.second, fractions[1])];
        let [t, s] = at.map(|(curve, fraction)| {
            let domain = curve.domain();
            domain.without_dust(domain.at(fraction))
        });
        self.meeting(t, s).filter(|_| is_clear).map(LegMeeting::At)
    }

    /// Whether both legs end in the place where they meet, and lead away from it at no acute angle, so that they part
    /// as fast as they are long.
    fn lead_away(&self, legs: [DVec3; 2], fractions: [f64; 2]) -> bool {
        let onward = [0, 1].map(|i| {
            let length = legs[i].length();
            let [before, behind] = [fractions[i], 1.0 - fractions[i]].map(|part| part * length);
            match (before <= self.tolerance, behind <= self.tolerance) {
                (true, false) => Some(legs[i]),
                (false, true) => Some(-legs[i]),
                _ => None,
            }
        });
        matches!(onward, [Some(own), Some(other)] if own.dot(other) <= 0.0)
    }
}

/// The ends of a curve that runs straight and evenly from one to the other.
fn leg(curve: &NurbsCurve) -> Option<[DVec3; 2]> {
    let &[start, end] = curve.control_points() else { return None };
    let is_even = start.w.total_cmp(&end.w).is_eq();
    is_even.then(|| [start, end].map(homogeneous::project))
}

/// By fractions of two legs, where they are nearest: where their lines are, if that is within both, or at an end.
fn nearest_fractions(legs: [[DVec3; 2]; 2]) -> [f64; 2] {
    let [[p, p_end], [q, q_end]] = legs;
    let (own, other, apart) = (p_end - p, q_end - q, q - p);
    // Products of vectors lose fewer digits at small angles than equations for both.
    let normal = own.cross(other);
    let across = normal.length_squared();
    let crossing = [apart.cross(other).dot(normal) / across, apart.cross(own).dot(normal) / across];
    // Of lines that are one it is rounding, and some place.
    let is_within = crossing.iter().all(|fraction| (0.0..=1.0).contains(fraction));
    let foot = |point: DVec3, [start, end]: [DVec3; 2]| {
        let leg = end - start;
        let fraction = (point - start).dot(leg) / leg.length_squared();
        if fraction.is_finite() { fraction.clamp(0.0, 1.0) } else { 0.0 }
    };
    let ends = [
        [0.0, foot(p, legs[1])],
        [1.0, foot(p_end, legs[1])],
        [foot(q, legs[0]), 0.0],
        [foot(q_end, legs[0]), 1.0],
    ];
    let distance = |[s, t]: [f64; 2]| p.lerp(p_end, s).distance_squared(q.lerp(q_end, t));
    let candidates = is_within.then_some(crossing).into_iter().chain(ends);
    let nearest = candidates.min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
    nearest.unwrap_or([0.0; 2])
}
