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
