//! The point of a curve that is nearest to a given one.
//!
//! Pieces whose control points are further away than the best foot so far are left out; of the
//! others every foot is found, as a root of (C − P)·C' by its Bernstein coefficients. So the answer
//! is that of the whole curve, and not of the neighbourhood of a guess.

use glam::{DVec3, DVec4};

use super::NurbsCurve;
use crate::kernel::{
    Interval,
    bernstein::{derivative, product},
    bezier,
    roots::Signs,
    tolerance::{LAST_BIT, SIGN_RELATIVE},
};

/// The nearest point of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foot {
    /// Where it is; the least parameter among equals.
    pub parameter: f64,
    /// The point.
    pub point: DVec3,
    /// How far away it is.
    pub distance: f64,
    /// Places that are as near as that, within the tolerance.
    pub count: usize,
}

impl NurbsCurve {
    /// The nearest point to `p`. Places of the curve whose distances differ by less than
    /// `tolerance` count as equally near.
    #[must_use]
    pub fn closest(&self, p: DVec3, tolerance: f64) -> Foot {
        let mut feet: Vec<(f64, f64)> = Vec::new();
        let mut best = self.point_at(self.domain().start()).distance(p);
        let mut spans: Vec<(f64, usize)> =
            self.knots().spans().map(|span| (self.least_distance(span, p), span)).collect();
        spans.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (least, span) in spans {
            if best + tolerance < least {
                break;
            }
            for t in self.feet_of_span(span, p) {
                let distance = self.point_at(t).distance(p);
                best = best.min(distance);
                feet.push((t, distance));
            }
        }
        let rounding = LAST_BIT * (p.abs().max_element() + self.magnitude());
        feet.retain(|&(_, distance)| distance <= best + tolerance);
        feet.sort_by(|a, b| a.0.total_cmp(&b.0));
        let nearest = feet.iter().find(|&&(_, distance)| distance <= best + rounding);
        let parameter = nearest.map_or(self.domain().start(), |&(t, _)| t);
        let point = self.point_at(parameter);
        let count = self.different_places(&feet, tolerance);
        Foot { parameter, point, distance: point.distance(p), count }
    }

    /// How many of the feet are different places of the curve.
    fn different_places(&self, feet: &[(f64, f64)], tolerance: f64) -> usize {
        let mut places: Vec<DVec3> = Vec::new();
        for &(t, _) in feet {
            let point = self.point_at(t);
            if !places.iter().any(|place| place.distance(point) <= tolerance) {
                places.push(point);
            }
        }
        places.len()
    }

    /// No point of the span is nearer than this.
    fn least_distance(&self, span: usize, p: DVec3) -> f64 {
        let points = &self.control_points()[self.knots().support(span)];
        if points.iter().any(|point| point.w <= 0.0) {
            return 0.0;
        }
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for point in points {
            let place = point.truncate() / point.w;
            (low, high) = (low.min(place), high.max(place));
        }
        p.distance(p.clamp(low, high))
    }

    /// The ends of a span and every parameter where the distance has a minimum.
    fn feet_of_span(&self, span: usize, p: DVec3) -> Vec<f64> {
        let interval = self.knots().span_interval(span);
        let points = bezier::piece(self.knots(), self.control_points(), span);
        let mut signs = Signs::default();
        let (slope, rounding) = slope_of_distance(&points, p);
        signs.follow(interval, &slope, rounding);
        let minima = signs.changes().iter().filter(|&&(_, sign)| sign > 0).map(|&(t, _)| t);
        let inside = minima.map(|t| self.polished_foot(t, interval, p));
        [interval.start(), interval.end()].into_iter().chain(inside).collect()
    }

    /// A foot after one step of Newton's method, where that comes nearer.
    fn polished_foot(&self, t: f64, interval: Interval, p: DVec3) -> f64 {
        let derivatives = self.derivatives_on(self.knots().span_at(interval.at(0.5)), t, 2);
        let away = derivatives[0] - p;
        let slope = away.dot(derivatives[1]);
        let change = derivatives[1].length_squared() + away.dot(derivatives[2]);
        let better = t - slope / change;
        let is_better = interval.contains(better)
            && self.point_at(better).distance(p) < derivatives[0].distance(p);
        if is_better { better } else { t }
    }
}

/// (A − Pw)·(A'w − Aw'), which has the sign of the slope of the distance from P, and its rounding.
fn slope_of_distance(points: &[DVec4], p: DVec3) -> (Vec<f64>, f64) {
    let away: Vec<DVec3> = points.iter().map(|point| point.truncate() - p * point.w).collect();
    let weight: Vec<f64> = points.iter().map(|point| point.w).collect();
    let times = |vector: DVec3, factor: f64| vector * factor;
    let grown = product(&derivative(&away), &weight, times);
    let shrunk = product(&away, &derivative(&weight), times);
    let velocity: Vec<DVec3> = grown.iter().zip(&shrunk).map(|(&a, &b)| a - b).collect();
    let slope = product(&away, &velocity, DVec3::dot);
    let largest = |vectors: &[DVec3]| vectors.iter().fold(0.0, |most: f64, v| most.max(v.length()));
    (slope, SIGN_RELATIVE * largest(&away) * largest(&velocity))
}
