//! How far a curve is from a chord.

use glam::{DVec3, DVec4};

use crate::{bezier, homogeneous::project};

/// A bound of the distance of a Bézier curve from a chord, by the hulls of its quarters.
pub(super) fn chord_deviation(piece: &[DVec4], chord: [DVec4; 2]) -> f64 {
    let [a, b] = chord.map(project);
    let (left, right) = bezier::cut_at(piece, 0.5);
    let mut most = 0.0_f64;
    for half in [left, right] {
        let (first, second) = bezier::cut_at(&half, 0.5);
        for point in first.into_iter().chain(second) {
            let is_behind = point.w <= 0.0;
            let distance =
                if is_behind { f64::INFINITY } else { distance_to_segment(project(point), a, b) };
            most = most.max(distance);
        }
    }
    most
}

fn distance_to_segment(point: DVec3, a: DVec3, b: DVec3) -> f64 {
    let leg = b - a;
    let length_squared = leg.length_squared();
    if length_squared <= 0.0 {
        return point.distance(a);
    }
    let fraction = ((point - a).dot(leg) / length_squared).clamp(0.0, 1.0);
    point.distance(a + leg * fraction)
}
