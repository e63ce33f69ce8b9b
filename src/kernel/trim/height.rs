//! Where a second surface cuts the one on which a curve is followed: Newton's method across the curve.

use glam::DVec3;

use super::pull::{Height, MOST_BESIDE, PulledCurve};
use crate::{frame::norm, tolerance::PULL_SHARE};

/// Steps of Newton's method onto a second surface.
const STEPS: usize = 12;

/// Last bits of that which rounding may take of a place where a height vanishes steeply.
const HEIGHT_BITS: f64 = 8.0;

/// Where a height vanishes on a surface, beside a place of a curve.
struct HeightRoot {
    place: DVec3,
    /// How far rounding may move it; no number at a pole.
    rounding: f64,
    /// How far it is from the curve.
    gap: f64,
    /// Whether steps have become rounding.
    is_settled: bool,
}

impl PulledCurve<'_> {
    /// The place where the height vanishes beside the curve, and how far rounding may move it, where Newton's method
    /// leads there from a place of its neighbourhood: without the foot of the curve before.
    pub(super) fn crossing_near(&self, t: f64, near: DVec3) -> Option<(DVec3, f64)> {
        let root = self.height_root(self.height?, t, near, f64::INFINITY)?;
        let is_found = root.is_settled
            && root.rounding <= PULL_SHARE * self.tolerance
            && root.gap <= self.tolerance;
        is_found.then_some((root.place, root.rounding))
    }

    /// Newton's method from a place to where the height vanishes, across the curve; and how far rounding may
    /// move that place: the farther, the more flatly the height crosses the surface. Where that is farther
    /// than pieces may be away, as where the height touches, the place stays.
    pub(super) fn improved(&self, t: f64, start: DVec3) -> (DVec3, f64) {
        let Some(height) = self.height else { return (start, 0.0) };
        let most = PULL_SHARE * self.tolerance;
        match self.height_root(height, t, start, MOST_BESIDE * self.tolerance) {
            Some(root) if most < root.rounding => (start, most),
            // A pole has no normal.
            Some(root) if root.rounding.is_nan() => (root.place, 0.0),
            Some(root) => (root.place, root.rounding),
            None => (start, 0.0),
        }
    }

    /// Where Newton's method leads from a place to which the height vanishes across the curve; none where it goes
    /// further than `reach` from the first point. It ends where rounding would move the place too far.
    fn height_root(
        &self,
        height: &Height<'_>,
        t: f64,
        start: DVec3,
        reach: f64,
    ) -> Option<HeightRoot> {
        let derivatives = self.curve.derivatives_at(t, 1);
        let (center, along) = (derivatives[0], derivatives[1]);
        let bounds = self.plane.bounds();
        let mut root =
            HeightRoot { place: start, rounding: 0.0, gap: f64::INFINITY, is_settled: false };
        let mut begun = None;
        for _ in 0..STEPS {
            let [u, v] = self.plane.parameters(root.place);
            let [point, along_u, along_v] = self.plane.surface.tangents_at(u, v);
            let begun = *begun.get_or_insert(point);
            let (value, away) = height(point);
            let normal = along_u.cross(along_v);
            let sine = norm(away.cross(normal)) / (norm(away) * norm(normal));
            root.rounding = HEIGHT_BITS * self.last_bit / sine;
            if PULL_SHARE * self.tolerance < root.rounding {
                break;
            }
            let ahead = (point - center).dot(along);
            let rows =
                [[away.dot(along_u), away.dot(along_v)], [along.dot(along_u), along.dot(along_v)]];
            let determinant = rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
            let du = (value * rows[1][1] - ahead * rows[0][1]) / determinant;
            let dv = (ahead * rows[0][0] - value * rows[1][0]) / determinant;
            let step = self.plane.place([-du, -dv]);
            // Near a pole small ways are long ones of the parameters.
            if !step.is_finite() || reach < norm(point - begun) {
                return None;
            }
            root.place += step;
            // Over a seam it goes on at the other side.
            for i in (0..2).filter(|&i| self.plane.is_closed[i]) {
                let (low, high) = (bounds.min[i], bounds.max[i]);
                if root.place[i] < low {
                    root.place[i] += high - low;
                } else if high < root.place[i] {
                    root.place[i] -= high - low;
                }
            }
            root.place = root.place.clamp(bounds.min, bounds.max);
            root.gap = norm(point - center);
            // Beside a pole rounding is a long way in the plane.
            let way = norm(along_u * du) + norm(along_v * dv);
            root.is_settled = norm(step).min(way) <= 4.0 * self.last_bit;
            if root.is_settled {
                break;
            }
        }
        Some(root)
    }
}
