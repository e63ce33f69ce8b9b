//! Where a field has no slope: there lines along which it vanishes cross.

use crate::{
    Grid,
    ceiling::NEWTON_STEPS,
    numeric::newton::{NewtonStep, within_limits},
    surface::intersection::square,
    tolerance::{LAST_BIT, PARAMETER_RELATIVE, TOUCH_RELATIVE},
};

/// Widths of a cell by which the place may lie beside its middle: where rounding leaves several cells about it, none
/// but one holds it.
const REACH: f64 = 4.0;

/// The slopes of a field on a patch, and theirs.
pub(super) struct FieldSlopes {
    first: [Grid<f64>; 2],
    second: [Grid<f64>; 3],
}

impl FieldSlopes {
    pub(super) fn of(field: &Grid<f64>) -> Self {
        let first = [square::slope_u(field), square::slope_v(field)];
        let second =
            [square::slope_u(&first[0]), square::slope_v(&first[0]), square::slope_v(&first[1])];
        Self { first, second }
    }

    /// Whether the field bends both ways at a place, by fractions of a patch of these extents in space: where it touches zero
    /// along a line it is straight along it, to rounding.
    pub(super) fn bends_both_ways(&self, at: [f64; 2], [along_u, along_v]: [f64; 2]) -> bool {
        let [uu, uv, vv] = self.second.each_ref().map(|slope| square::value(slope, at));
        let [uu, uv, vv] = [uu / along_u / along_u, uv / along_u / along_v, vv / along_v / along_v];
        let most = uu.abs().max(uv.abs()).max(vv.abs());
        uu * vv - uv * uv < -TOUCH_RELATIVE.sqrt() * most * most
    }

    /// The one place, by fractions of the patch, about which a cell of these widths lies and where both slopes vanish, by
    /// Newton's method; none where the field bends in one direction alone, as where it touches zero along a line.
    pub(super) fn resting_place(&self, middle: [f64; 2], widths: [f64; 2]) -> Option<[f64; 2]> {
        // Also beyond the patch: on its border the place is as far inside as rounding has it.
        let limits = [0, 1].map(|i| [middle[i] - REACH * widths[i], middle[i] + REACH * widths[i]]);
        let is_still =
            |a: [f64; 2], b: [f64; 2]| (0..2).all(|i| (a[i] - b[i]).abs() <= PARAMETER_RELATIVE);
        within_limits(limits, middle, NEWTON_STEPS, is_still, |at| {
            let [along_u, along_v] = self.first.each_ref().map(|slope| square::value(slope, at));
            let [uu, uv, vv] = self.second.each_ref().map(|slope| square::value(slope, at));
            let (bend, size) = (uu * vv - uv * uv, (uu * vv).abs() + uv * uv);
            let step = [uv * along_v - vv * along_u, uv * along_u - uu * along_v];
            let is_certain = LAST_BIT.sqrt() * size < bend.abs();
            NewtonStep::perhaps(is_certain.then(|| step.map(|step| step / bend)))
        })
        .settled()
        .filter(|at| (0..2).all(|i| limits[i][0] < at[i] && at[i] < limits[i][1]))
        .map(|at| [at, at.map(|at| at.clamp(0.0, 1.0))])
        .filter(|&[at, within]| is_still(at, within))
        .map(|[_, within]| within)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half of uu (x − 0.3)² + vv (y − 0.6)², and uv (x − 0.3)(y − 0.6).
    fn field([uu, uv, vv]: [f64; 3]) -> FieldSlopes {
        let (a, b) = (0.3, 0.6);
        let square = |c: f64| [c * c, c * (c - 1.0), (1.0 - c) * (1.0 - c)];
        let line = |c: f64| [-c, 0.5 - c, 1.0 - c];
        FieldSlopes::of(&Grid::from_fn(3, 3, |i, j| {
            0.5 * uu * square(a)[i] + uv * line(a)[i] * line(b)[j] + 0.5 * vv * square(b)[j]
        }))
    }

    #[test]
    fn saddles_bend_both_ways_whatever_the_extents_of_the_patch() {
        for extents in [[1.0, 1.0], [2.0, 2.0], [0.5, 3.0]] {
            let bends = |second: [f64; 3]| field(second).bends_both_ways([0.2, 0.9], extents);
            assert!(bends([1.0, 0.0, -1.0]) && bends([1.0, 1.1, 1.0]) && bends([0.0, -2.0, 0.0]));
            assert!(
                !bends([1.0, 0.0, 1.0]) && !bends([1.0, 0.9, 1.0]) && !bends([-1.0, 0.9, -1.0])
            );
            assert!(!bends([1.0, 0.0, 0.0]) && !bends([4.0, -2.0, 1.0]));
        }
    }

    #[test]
    fn the_place_without_slopes_is_found_beside_the_cell_that_is_near_it() {
        for second in [[1.0, 0.3, -2.0], [1.0, 0.5, 2.0], [0.0, 1.0, 0.0]] {
            let slopes = field(second);
            let found = slopes.resting_place([0.4, 0.5], [0.1, 0.05]).expect("a place");
            assert!((found[0] - 0.3).abs() < 1e-12 && (found[1] - 0.6).abs() < 1e-12, "{found:?}");
            assert!(slopes.resting_place([0.9, 0.6], [0.1, 0.1]).is_none());
            assert!(slopes.resting_place([0.3, 0.1], [0.1, 0.1]).is_none());
        }
    }

    #[test]
    fn a_valley_has_no_single_place() {
        assert!(field([1.0, 0.0, 0.0]).resting_place([0.3, 0.6], [0.1, 0.1]).is_none());
        assert!(field([4.0, -2.0, 1.0]).resting_place([0.3, 0.6], [0.1, 0.1]).is_none());
    }
}
