//! Monotone changes of parameter, twice continuously differentiable, and curves run through them.

use glam::DVec4;

use crate::{
    Ends, FitError, GeomError, Interpolator, Interval, KnotVector, NurbsCurve,
    bernstein::{derivative, product, value},
    bezier,
    ceiling::BISECTIONS,
    numeric::bisection::bisected,
    tolerance::KNOT_RELATIVE,
};

/// A change of parameter: polynomials by their Bernstein coefficients between breaks.
#[derive(Clone, Debug)]
pub(crate) struct NetworkParameterMap {
    breaks: Vec<f64>,
    pieces: Vec<Vec<f64>>,
}

/// The derivative of a spline map may not fall below this part of its least mean slope.
const LEAST_SLOPE: f64 = 0.25;

impl NetworkParameterMap {
    /// A map that takes each of `from` to the one of `to`; both increase.
    ///
    /// The cubic spline where its derivative stays clear of zero. Else a quintic whose derivative
    /// has the least of both neighbours' slopes at each place, and a bump between them that makes
    /// up for the rest: positive by construction. With `is_ring` the derivative at the end is that
    /// at the start.
    pub(crate) fn new(from: &[f64], to: &[f64], is_ring: bool) -> Result<Self, GeomError> {
        let widths: Vec<f64> = from.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let slopes: Vec<f64> =
            to.windows(2).zip(&widths).map(|(pair, width)| (pair[1] - pair[0]) / width).collect();
        let least = slopes.iter().copied().fold(f64::INFINITY, f64::min);
        if let Ok(cubic) = Self::cubic(from, to, is_ring)
            && cubic.least_slope() > LEAST_SLOPE * least
        {
            return Ok(cubic);
        }
        let n = slopes.len();
        let at = |k: usize| match k {
            0 if is_ring => slopes[0].min(slopes[n - 1]),
            0 => slopes[0],
            k if k == n && is_ring => slopes[0].min(slopes[n - 1]),
            k if k == n => slopes[n - 1],
            k => slopes[k - 1].min(slopes[k]),
        };
        let piece = |k: usize| {
            let (a, b) = (at(k), at(k + 1));
            let bump = slopes[k] - 0.5 * (a + b);
            // Bernstein coefficients of a + (b − a)(3x² − 2x³) + 30·bump·x²(1 − x)², degree 4.
            let speed = [a, a, 0.5 * (a + b) + 5.0 * bump, b, b];
            let mut sum = to[k];
            let mut points = vec![sum];
            for value in speed {
                sum += value * widths[k] / 5.0;
                points.push(sum);
            }
            points[5] = to[k + 1];
            points
        };
        Ok(Self { breaks: from.to_vec(), pieces: (0..n).map(piece).collect() })
    }

    fn cubic(from: &[f64], to: &[f64], is_ring: bool) -> Result<Self, GeomError> {
        let n = from.len();
        let turn = to[n - 1] - to[0];
        let period = from[n - 1] - from[0];
        if is_ring && 3 < n {
            // What is periodic is the difference from the straight map.
            let straight = |t: f64| to[0] + (t - from[0]) / period * turn;
            let fit = Interpolator::periodic(from, 3)?;
            let values: Vec<DVec4> =
                (0..n - 1).map(|k| DVec4::new(to[k] - straight(from[k]), 0.0, 0.0, 1.0)).collect();
            let points = fit.through(&values)?;
            let greville = fit.knots().greville();
            let points = points
                .iter()
                .zip(greville)
                .map(|(p, t)| DVec4::new(p.x + straight(t), 0.0, 0.0, 1.0));
            return Ok(Self::of_spline(fit.knots(), &points.collect::<Vec<_>>()));
        }
        if is_ring {
            return Err(FitError::NoFit.into());
        }
        let ends = if n < 3 { Ends::Averaged } else { Ends::Bessel };
        let fit = Interpolator::new(from, 3, ends)?;
        let values: Vec<DVec4> = to.iter().map(|&t| DVec4::new(t, 0.0, 0.0, 1.0)).collect();
        let points = fit.through(&values)?;
        Ok(Self::of_spline(fit.knots(), &points))
    }

    fn of_spline(knots: &KnotVector, points: &[DVec4]) -> Self {
        let piece =
            |span: usize| bezier::piece(knots, points, span).iter().map(|point| point.x).collect();
        Self { breaks: knots.breaks(), pieces: knots.spans().map(piece).collect() }
    }

    fn least_slope(&self) -> f64 {
        let slope = |(piece, ends): (&Vec<f64>, &[f64])| {
            let least = derivative(piece).into_iter().fold(f64::INFINITY, f64::min);
            least / (ends[1] - ends[0])
        };
        self.pieces.iter().zip(self.breaks.windows(2)).map(slope).fold(f64::INFINITY, f64::min)
    }

    fn at(&self, t: f64) -> f64 {
        let k = self.breaks.partition_point(|&b| b <= t).clamp(1, self.pieces.len()) - 1;
        let width = self.breaks[k + 1] - self.breaks[k];
        value(&self.pieces[k], (t - self.breaks[k]) / width)
    }

    /// The parameter that goes to `target`, by bisection.
    fn inverse(&self, target: f64) -> f64 {
        let ends = [self.breaks[0], self.breaks[self.breaks.len() - 1]];
        let [low, high] = bisected(ends, BISECTIONS, |t| self.at(t) < target);
        0.5 * (low + high)
    }

    /// Whether a curve run through by the map stays within a distance of one place between two parameters.
    fn is_still(&self, curve: &NurbsCurve, ends: [f64; 2], near: f64) -> bool {
        let [start, end] = ends.map(|t| self.at(t));
        // What is too narrow for a part holds no knot.
        let part = Interval::new(start, end).and_then(|part| curve.trimmed(part));
        part.map_or(true, |part| part.bounds().diagonal() <= near)
    }

    /// The curve run through by the map: exact, of the product of both degrees, in pieces that
    /// meet; and the parameters at which its knots allow no second derivative, each with the order
    /// of the derivatives that there are.
    ///
    /// Breaks beside one another are one where the curve goes no further than `near` between them.
    ///
    /// de Casteljau's algorithm on polynomials: Farin, *Curves and Surfaces for CAGD*, §5.5.
    ///
    /// # Errors
    /// Those of [`KnotVector::new`] where the curve goes further between breaks that are one parameter.
    pub(crate) fn applied(
        &self,
        curve: &NurbsCurve,
        near: f64,
    ) -> Result<(NurbsCurve, Vec<(f64, usize)>), GeomError> {
        let domain = Interval::new(self.breaks[0], self.breaks[self.breaks.len() - 1])?;
        let same = KNOT_RELATIVE.sqrt() * domain.length();
        let inside = |t: &f64| domain.start() < *t && *t < domain.end();
        let own = curve.knots().breaks();
        let images: Vec<f64> = own.iter().map(|&t| self.inverse(t)).filter(inside).collect();
        let mut breaks = [&self.breaks[..], &images].concat();
        breaks.sort_by(f64::total_cmp);
        breaks.dedup_by(|later, earlier| {
            *later - *earlier <= same && self.is_still(curve, [*earlier, *later], near)
        });
        let last = breaks.len() - 1;
        breaks[last] = domain.end();

        let mut pieces: Vec<Vec<DVec4>> = Vec::new();
        for ends in breaks.windows(2) {
            let middle = 0.5 * (ends[0] + ends[1]);
            let k = self.breaks.partition_point(|&b| b <= middle).clamp(1, self.pieces.len()) - 1;
            let (start, width) = (self.breaks[k], self.breaks[k + 1] - self.breaks[k]);
            let part =
                part_of(&self.pieces[k], (ends[0] - start) / width, (ends[1] - start) / width);
            let span = curve.knots().span_at(self.at(middle));
            let interval = curve.knots().span_interval(span);
            let points = bezier::piece(curve.knots(), curve.control_points(), span);
            let local: Vec<f64> =
                part.iter().map(|t| (t - interval.start()) / interval.length()).collect();
            pieces.push(composed(&points, &local));
        }
        let degree = pieces.iter().map(Vec::len).max().unwrap_or(1) - 1;
        let mut knots = vec![domain.start()];
        let mut points: Vec<DVec4> = Vec::new();
        for (piece, ends) in pieces.iter().zip(breaks.windows(2)) {
            knots.extend(vec![ends[0]; degree]);
            if points.pop().is_some() {
                points.push(piece[0]);
                points.extend(&piece[1..]);
            } else {
                points.extend(piece);
            }
        }
        knots.extend(vec![domain.end(); degree + 1]);
        let p = curve.degree();
        let is_kept = |image: f64| breaks[1..last].iter().any(|b| (b - image).abs() <= same);
        let rough = |(t, times): (f64, usize)| {
            let order = p.saturating_sub(times);
            let image = self.inverse(t);
            let is_inner = curve.domain().start() < t && t < curve.domain().end();
            (is_inner && order < 2 && is_kept(image)).then_some((image, order))
        };
        let corners = curve.knots().distinct().into_iter().filter_map(rough).collect();
        Ok((NurbsCurve::new(KnotVector::new(degree, knots)?, points)?, corners))
    }
}

/// Coefficients of a polynomial over a part of 0..1.
fn part_of(coefficients: &[f64], start: f64, end: f64) -> Vec<f64> {
    let n = coefficients.len() - 1;
    let blossom = |n_at_end: usize| {
        let mut row = coefficients.to_vec();
        for level in 0..n {
            let t = if level < n_at_end { end } else { start };
            for i in 0..n - level {
                row[i] = row[i] * (1.0 - t) + row[i + 1] * t;
            }
        }
        row[0]
    };
    (0..=n).map(blossom).collect()
}

/// Coefficients of a Bézier curve whose parameter is a polynomial.
fn composed(points: &[DVec4], inner: &[f64]) -> Vec<DVec4> {
    let rest: Vec<f64> = inner.iter().map(|t| 1.0 - t).collect();
    let mut row: Vec<Vec<DVec4>> = points.iter().map(|&point| vec![point]).collect();
    for n_left in (1..row.len()).rev() {
        for i in 0..n_left {
            let before = product(&row[i], &rest, |a, b| a * b);
            let behind = product(&row[i + 1], inner, |a, b| a * b);
            row[i] = before.iter().zip(&behind).map(|(a, b)| *a + *b).collect();
        }
    }
    row.swap_remove(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Places that go to others, at which the slope may only be known to lie between two bounds.
    #[track_caller]
    fn check(from: &[f64], to: &[f64], is_ring: bool) -> NetworkParameterMap {
        let map = NetworkParameterMap::new(from, to, is_ring).expect("a map");
        for (t, target) in from.iter().zip(to) {
            assert!((map.at(*t) - target).abs() < 1e-12, "{t} goes to {}", map.at(*t));
        }
        let (start, end) = (from[0], from[from.len() - 1]);
        let places: Vec<f64> =
            (0..=200).map(|k| start + (end - start) * k as f64 / 200.0).collect();
        assert!(places.windows(2).all(|pair| map.at(pair[0]) < map.at(pair[1])));
        for t in &places {
            assert!((map.inverse(map.at(*t)) - t).abs() < 1e-9, "{t}");
        }
        map
    }

    /// The slopes beside a place.
    fn slopes(map: &NetworkParameterMap, t: f64) -> [f64; 2] {
        let h = 1e-6;
        [-h, h].map(|h| (map.at(t + h) - map.at(t)) / h)
    }

    #[test]
    fn an_even_map_is_straight() {
        for is_ring in [false, true] {
            let map = check(&[0.0, 1.0, 2.5, 3.0, 5.0], &[1.0, 3.0, 6.0, 7.0, 11.0], is_ring);
            for k in 0..=50 {
                assert!((map.at(0.1 * k as f64) - 1.0 - 0.2 * k as f64).abs() < 1e-12);
            }
            assert!((map.least_slope() - 2.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_gentle_map_runs_smoothly_through_its_places() {
        let (from, to) = ([0.0, 1.0, 2.0, 3.0, 4.0], [0.0, 1.2, 2.1, 2.9, 4.0]);
        for is_ring in [false, true] {
            let map = check(&from, &to, is_ring);
            let joints = from[1..4].iter().map(|t| slopes(&map, *t));
            assert!(joints.clone().all(|[a, b]| (a - b).abs() < 1e-5));
            if is_ring {
                let around = [slopes(&map, 0.0)[1], slopes(&map, 4.0)[0]];
                assert!((around[0] - around[1]).abs() < 1e-5, "{around:?}");
            }
        }
    }

    #[test]
    fn a_steep_map_has_the_least_of_its_neighbours_slopes_at_its_places() {
        let (from, to) = ([0.0, 1.0, 2.0, 4.0, 5.0], [0.0, 0.01, 1.0, 1.02, 2.0]);
        let least = [0.01, 0.01, 0.01, 0.01, 0.98];
        for is_ring in [false, true] {
            let map = check(&from, &to, is_ring);
            for (k, expected) in least.into_iter().enumerate() {
                let [before, behind] = slopes(&map, from[k]);
                let expected = if is_ring && k == 4 { 0.01 } else { expected };
                assert!(k == 0 || (before - expected).abs() < 1e-4, "{k}: {before}");
                assert!(k == 4 || (behind - expected).abs() < 1e-4, "{k}: {behind}");
            }
        }
    }
}
