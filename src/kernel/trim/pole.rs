//! Curves on a surface where they go through a pole.

use glam::DVec3;

use super::pull::PulledCurve;
use crate::{
    GeomError, Interval,
    frame::norm,
    tolerance::{PARAMETER_RELATIVE, POLE_STEP},
};

/// Fractions of an edge of the domain at which it is asked whether it is a point.
const EDGE_LOOKS: [f64; 4] = [0.0, 0.3, 0.7, 1.0];

impl PulledCurve<'_> {
    /// Where between two parameters the curve goes through the pole that a place is at, with its places on both
    /// sides there; none of a place that is at no pole.
    pub(super) fn through_pole(
        &self,
        place: DVec3,
        [from, to]: [f64; 2],
    ) -> Result<Option<[(f64, DVec3); 2]>, GeomError> {
        let (pole, bounds) = (self.at_border(place), self.plane.bounds());
        let point = self.plane.point(pole);
        let is_point = |i: usize| {
            let along = 1 - i;
            let is_end =
                [bounds.min[i], bounds.max[i]].iter().any(|end| (pole[i] - end).abs() <= 0.0);
            is_end
                && EDGE_LOOKS.iter().all(|look| {
                    let mut other = pole;
                    other[along] =
                        bounds.min[along] + look * (bounds.max[along] - bounds.min[along]);
                    norm(self.plane.point(other) - point) <= self.accuracy
                })
        };
        let Some(across) = (0..2).find(|&i| is_point(i)) else { return Ok(None) };
        let part = self.curve.trimmed(Interval::new(from, to)?)?;
        let t = part.closest(point, self.accuracy).parameter;
        // Parameters along the pole are those that they tend to.
        let beside = |end: f64| -> Result<(f64, DVec3), GeomError> {
            let mut places = [pole; 3];
            let mut near = self.place(t + 3.0 * POLE_STEP * (end - t), pole)?;
            for (i, place) in places.iter_mut().enumerate().rev() {
                near = self.place(t + (i + 1) as f64 * POLE_STEP * (end - t), near)?;
                *place = near;
            }
            let [a, b, c] = places;
            let mut place = if self.is_jump(c, a) { a } else { (a - b) * 3.0 + c };
            place[across] = pole[across];
            Ok((t, place.clamp(bounds.min, bounds.max)))
        };
        let domain = self.curve.domain();
        let width = to - from;
        let [before, behind] = [(t - width).max(domain.start()), (t + width).min(domain.end())];
        let here = (t, pole);
        let is_inside = |end: f64| PARAMETER_RELATIVE * domain.length() < (end - t).abs();
        let end = if is_inside(before) { beside(before)? } else { here };
        let next = if is_inside(behind) { beside(behind)? } else { here };
        Ok(Some([end, next]))
    }
}
