//! How far a curve is from a chord.

use glam::{DVec3, DVec4};
use smallvec::SmallVec;

use crate::{bezier, homogeneous::project};

/// The points of a Bézier curve: those of most need no memory of their own.
pub(super) type PiecePoints = SmallVec<[DVec4; 4]>;

/// A bound of the distance of a Bézier curve from a chord, by the hulls of its quarters.
pub(super) fn chord_deviation(piece: &[DVec4], chord: [DVec4; 2]) -> f64 {
    let chord = Chord::new(chord.map(project));
    let mut most = 0.0_f64;
    let mut add = |point: DVec4| {
        let is_behind = point.w <= 0.0;
        let distance = if is_behind { f64::INFINITY } else { chord.distance(project(point)) };
        most = most.max(distance);
    };
    let mut right = PiecePoints::from_slice(piece);
    let left = cut_before(&mut right, 0.5);
    for mut half in [left, right] {
        bezier::cut_off(&mut half, 0.5, &mut add);
        half.into_iter().for_each(&mut add);
    }
    most
}

/// The part of a curve before a fraction of its domain; what is left of it is the part behind.
pub(super) fn cut_before(points: &mut PiecePoints, fraction: f64) -> PiecePoints {
    let mut left = PiecePoints::with_capacity(points.len());
    bezier::cut_off(points, fraction, |point| left.push(point));
    left
}

/// A chord to which many distances are asked.
struct Chord {
    start: DVec3,
    leg: DVec3,
    length_squared: f64,
}

impl Chord {
    fn new([a, b]: [DVec3; 2]) -> Self {
        let leg = b - a;
        Self { start: a, leg, length_squared: leg.length_squared() }
    }

    fn distance(&self, point: DVec3) -> f64 {
        if self.length_squared <= 0.0 {
            return point.distance(self.start);
        }
        let fraction = ((point - self.start).dot(self.leg) / self.length_squared).clamp(0.0, 1.0);
        point.distance(self.start + self.leg * fraction)
    }
}
