//! Stretches of curves on a surface: where they go over its knots, and which of them are straight.

use glam::DVec3;

use super::pull::{COMPARED, JOINT_SHARE, PulledCurve, Section};
use crate::{
    GeomError, NurbsCurve,
    ceiling::KNOT_STEPS,
    frame::norm,
    sorting::sort_by,
    tolerance::{PARAMETER_RELATIVE, PULL_SHARE},
};

impl PulledCurve<'_> {
    /// Stops with those between them at which the arc goes over a knot of the surface: there it is less smooth.
    pub(super) fn with_knots(
        &self,
        stops: Vec<(f64, DVec3)>,
    ) -> Result<Vec<(f64, DVec3)>, GeomError> {
        let surface = &self.plane.surface;
        let knots = [surface.knots_u().breaks(), surface.knots_v().breaks()];
        let mut all = stops.clone();
        for pair in stops.windows(2) {
            for (i, knots) in knots.iter().enumerate() {
                let inner = &knots[1..knots.len() - 1];
                for line in inner.iter().map(|knot| knot * self.plane.scales[i]) {
                    let beyond = [pair[0].1[i] - line, pair[1].1[i] - line];
                    let is_clear = beyond.iter().all(|way| self.accuracy < way.abs());
                    if is_clear && beyond[0] * beyond[1] < 0.0 {
                        all.extend(self.on_knot([pair[0], pair[1]], i, line)?);
                    }
                }
            }
        }
        sort_by(&mut all, |a, b| a.0.total_cmp(&b.0));
        let least = PARAMETER_RELATIVE * self.curve.domain().length();
        all.dedup_by(|behind, before| behind.0 - before.0 <= least);
        Ok(all)
    }

    /// Where the arc is on a line of one parameter that its ends are on both sides of; none where that is not found.
    fn on_knot(
        &self,
        [mut low, mut high]: Section,
        i: usize,
        line: f64,
    ) -> Result<Option<(f64, DVec3)>, GeomError> {
        let (mut of_low, mut of_high) = (low.1[i] - line, high.1[i] - line);
        let mut last = 0.0;
        for _ in 0..KNOT_STEPS {
            let share = of_low / (of_low - of_high);
            let t = low.0 + (high.0 - low.0) * share;
            let mut place = self.place_between(t, low.1.lerp(high.1, share))?.0;
            let of_place = place[i] - line;
            if of_place.abs() <= JOINT_SHARE * self.accuracy {
                place[i] = line;
                return Ok(Some((t, place)));
            }
            // An end that stays a second time counts half: the Illinois method.
            let factor = if 0.0 < of_place * last { 0.5 } else { 1.0 };
            last = of_place;
            if of_place * of_low < 0.0 {
                (high, of_high, of_low) = ((t, place), of_place, factor * of_low);
            } else {
                (low, of_low, of_high) = ((t, place), of_place, factor * of_high);
            }
        }
        Ok(None)
    }

    /// The line between the ends of a stretch where all of it is that; of one parameter alone where it is.
    pub(super) fn straight(&self, [start, end]: Section) -> Result<Option<NurbsCurve>, GeomError> {
        let ((from, first), (to, last)) = (start, end);
        let way = last - first;
        let length = norm(way);
        if length <= PULL_SHARE * self.tolerance {
            return Ok(None);
        }
        let inner = self.curve.knots().breaks().into_iter().filter(|&t| from < t && t < to);
        let ends: Vec<f64> = [from].into_iter().chain(inner).chain([to]).collect();
        for pair in ends.windows(2) {
            for fraction in COMPARED {
                let t = pair[0] + (pair[1] - pair[0]) * fraction;
                let near = first.lerp(last, (t - from) / (to - from));
                let (place, rounding) = self.place_between(t, near)?;
                if self.accuracy.max(rounding) < norm((place - first).cross(way)) / length {
                    return Ok(None);
                }
            }
        }
        self.line_between([first, last]).map(Some)
    }

    /// The line between two places; of one parameter alone where it is, at the end of its domain where that is.
    pub(super) fn line_between(
        &self,
        [mut first, mut last]: [DVec3; 2],
    ) -> Result<NurbsCurve, GeomError> {
        let (bounds, way) = (self.plane.bounds(), last - first);
        for i in 0..2 {
            if way[i].abs() <= self.accuracy {
                let is_end = last[i] <= bounds.min[i] || bounds.max[i] <= last[i];
                (first[i], last[i]) =
                    if is_end { (last[i], last[i]) } else { (first[i], first[i]) };
            }
        }
        NurbsCurve::line(first, last)
    }
}
