//! Curves on a surface where they go through a pole, or pass it within the tolerance.

use glam::DVec3;

use super::pull::PulledCurve;
use crate::{
    Bounds, GeomError, Interval, NurbsCurve,
    ceiling::BISECTIONS,
    frame::norm,
    tolerance::{PARAMETER_RELATIVE, POLE_STEP},
};

/// Tolerances from a pole from which on a curve that passes it leads straight into it.
const POLE_REACH: f64 = 8.0;

/// Fractions of an edge of the domain at which it is asked whether it is a point.
const EDGE_LOOKS: [f64; 4] = [0.0, 0.3, 0.7, 1.0];

/// An edge of the domain that is one point of the surface.
struct Pole {
    point: DVec3,
    /// The parameter that is constant there, and its value in the plane.
    across: usize,
    end: f64,
}

impl PulledCurve<'_> {
    /// The arcs along a curve that passes a pole within the tolerance without going through it, in order; none of any
    /// other. In the plane of parameters it would run along the pole, nearer than the tolerance: it leads into the pole
    /// instead, along lines of a constant parameter, and out of it again.
    pub(super) fn arcs_into_pole(&self) -> Result<Option<Vec<NurbsCurve>>, GeomError> {
        let Some((pole, t)) = self.passed_pole()? else { return Ok(None) };
        let domain = self.curve.domain();
        let mut arcs = Vec::new();
        for (limit, sign) in [(domain.start(), -1.0), (domain.end(), 1.0)] {
            let Some(from) = self.leaves(&pole, t, sign * (limit - t), sign) else { continue };
            let part = self.curve.trimmed(Interval::new(from.min(limit), from.max(limit))?)?;
            let rest = PulledCurve { curve: &part, ..*self }.arcs()?;
            let into = |start: DVec3| {
                let mut end = start;
                end[pole.across] = pole.end;
                end
            };
            if sign < 0.0 {
                let start = rest.last().map(NurbsCurve::end);
                arcs.extend(rest);
                arcs.extend(start.map(|start| NurbsCurve::line(start, into(start))).transpose()?);
            } else {
                let end = rest.first().map(NurbsCurve::start);
                arcs.extend(end.map(|end| NurbsCurve::line(into(end), end)).transpose()?);
                arcs.extend(rest);
            }
        }
        Ok(Some(arcs))
    }

    /// The pole that the curve passes, and where it is nearest to that.
    fn passed_pole(&self) -> Result<Option<(Pole, f64)>, GeomError> {
        let Some(hull) = Bounds::of(self.curve.points()) else { return Ok(None) };
        let bounds = self.plane.bounds();
        for across in 0..2 {
            for end in [bounds.min[across], bounds.max[across]] {
                let Some(point) = self.pole_point(across, end) else { continue };
                if !hull.contains(point, self.tolerance) {
                    continue;
                }
                GeomError::go_on(1)?;
                let near = self.curve.closest(point, self.accuracy);
                if self.accuracy < near.distance && near.distance <= self.tolerance {
                    return Ok(Some((Pole { point, across, end }, near.parameter)));
                }
            }
        }
        Ok(None)
    }

    /// Where the curve, followed from a parameter by a length of these at most, is no longer beside a pole; none where
    /// it ends before.
    fn leaves(&self, pole: &Pole, t: f64, most: f64, sign: f64) -> Option<f64> {
        let reach = POLE_REACH * self.tolerance;
        let speed = norm(self.curve.derivatives_at(t, 1)[1]);
        let mut step = (reach / speed).min(0.5 * most);
        for _ in 0..BISECTIONS {
            if most <= step {
                return None;
            }
            let at = t + sign * step;
            if reach <= norm(self.curve.point_at(at) - pole.point) {
                return Some(at);
            }
            step *= 2.0;
        }
        None
    }

    /// The point that an edge of the domain is; none where it is a curve.
    fn pole_point(&self, across: usize, end: f64) -> Option<DVec3> {
        let bounds = self.plane.bounds();
        let along = 1 - across;
        let points = EDGE_LOOKS.map(|look| {
            let mut place = bounds.min;
            place[across] = end;
            place[along] = bounds.min[along] + look * (bounds.max[along] - bounds.min[along]);
            self.plane.point(place)
        });
        points.iter().all(|&point| norm(point - points[0]) <= self.accuracy).then_some(points[0])
    }

    /// Where between two parameters the curve goes through the pole that a place is at, with its places on both
    /// sides there; none of a place that is at no pole.
    pub(super) fn through_pole(
        &self,
        place: DVec3,
        [from, to]: [f64; 2],
    ) -> Result<Option<[(f64, DVec3); 2]>, GeomError> {
        let (pole, bounds) = (self.at_border(place), self.plane.bounds());
        let point = self.plane.point(pole);
        let is_pole = |&i: &usize| {
            let mut ends = [bounds.min[i], bounds.max[i]].into_iter();
            ends.any(|end| (pole[i] - end).abs() <= 0.0 && self.pole_point(i, end).is_some())
        };
        let Some(across) = (0..2).find(is_pole) else { return Ok(None) };
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
