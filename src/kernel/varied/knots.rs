//! Splines whose inner knots move.
//!
//! The derivative of a spline by one of its knots is a spline itself, with that knot once more. So what a
//! spline does when its knots move is a slope of control points over knots that stand twice, and whoever
//! measures curves with slopes need not know of it.

use glam::DVec4;

use crate::{GeomError, KnotVector, bezier::blend, refine::ControlLines};

/// The derivatives of a spline by its inner knots, over the knots that have each of these twice.
#[derive(Clone, Debug)]
pub(crate) struct KnotSlopes {
    knots: KnotVector,
    /// For each inner knot, the control points of the derivative that are not zero, and where they begin.
    by_knot: Vec<(usize, Vec<DVec4>)>,
}

impl KnotSlopes {
    /// Of a clamped spline of degree 2 or more whose inner knots stand once; none of any other.
    ///
    /// Of knot r, which stands twice among knots û, control point i of the derivative is
    /// (Pᵢ₋₁ − Pᵢ)/(ûᵢ₊ₚ₊₁ − ûᵢ) for i from r − p to r: the derivative of a divided difference by one of
    /// its places is the one with that place twice. De Boor, *A Practical Guide to Splines*, ch. I.
    ///
    /// # Errors
    /// None but those of knots that cannot be.
    pub(crate) fn new(knots: &KnotVector, points: &[DVec4]) -> Result<Option<Self>, GeomError> {
        let Some(inner) = simple_inner(knots) else { return Ok(None) };
        let (first, twice) = (knots.degree() + 1, knots.with(inner));
        let mut corners = vec![DVec4::ZERO; knots.degree() + 1];
        let of = |idx| derivative(knots, points, (twice.as_slice(), first + idx), &mut corners);
        let by_knot = (0..inner.len()).map(of).collect();
        Ok(Some(Self { knots: twice, by_knot }))
    }

    /// How a sum of control points over [`Self::knots`], with a factor for each, changes with each inner knot.
    pub(crate) fn growths(&self, factors: &[f64]) -> impl Iterator<Item = DVec4> {
        self.by_knot.iter().map(|(first, points)| {
            points.iter().zip(&factors[*first..]).map(|(&point, &factor)| point * factor).sum()
        })
    }

    /// The knots, each inner one twice.
    pub(crate) fn knots(&self) -> &KnotVector {
        &self.knots
    }

    /// How the spline changes where its inner knots move at these speeds: control points over
    /// [`Self::knots`].
    pub(crate) fn at_speeds(&self, speeds: &[f64]) -> Vec<DVec4> {
        let mut sums = vec![DVec4::ZERO; self.knots.n_points()];
        for ((first, points), speed) in self.by_knot.iter().zip(speeds) {
            for (sum, &point) in sums[*first..].iter_mut().zip(points) {
                *sum += point * *speed;
            }
        }
        sums
    }
}

/// The inner knots of a clamped vector where each stands once and none is a corner.
pub(crate) fn simple_inner(knots: &KnotVector) -> Option<&[f64]> {
    let (all, degree) = (knots.as_slice(), knots.degree());
    let inner = &all[degree + 1..all.len() - degree - 1];
    let domain = knots.domain();
    let is_clamped = domain.start() <= all[0] && all[all.len() - 1] <= domain.end();
    let is_simple = all[degree..all.len() - degree].windows(2).all(|pair| pair[0] < pair[1]);
    ((1 < degree || inner.is_empty()) && is_clamped && is_simple).then_some(inner)
}

/// The same splines with each inner knot twice.
pub(crate) fn with_knots_twice(
    knots: &KnotVector,
    lines: Vec<Vec<DVec4>>,
) -> Result<Vec<Vec<DVec4>>, GeomError> {
    let inner = simple_inner(knots).unwrap_or(&[]).to_vec();
    Ok(ControlLines { knots: knots.clone(), lines }.with_knots(&inner)?.lines)
}

/// The derivative by knot r over knots that all stand twice inside: its control points that are not zero, and where they
/// begin; with room for p + 1 of them.
///
/// Each is the blossom of the derivative, over the knots with r once more, at the knots between those at which it begins
/// and ends. Ramshaw, *Blossoms are polar forms* (1989).
fn derivative(
    knots: &KnotVector,
    points: &[DVec4],
    (twice, r): (&[f64], usize),
    corners: &mut [DVec4],
) -> (usize, Vec<DVec4>) {
    let (all, p) = (knots.as_slice(), knots.degree());
    let once_more = |i: usize| if i <= r { all[i] } else { all[i - 1] };
    let control_point =
        |i: usize| (points[i - 1] - points[i]) / (once_more(i + p + 1) - once_more(i));
    let own: Vec<DVec4> = (r - p..=r).map(control_point).collect();
    // Of the knots before r, all but those at the start stand twice, so that every second span is one.
    let twice_of = |i: usize| if i <= p { i } else { p + 1 + 2 * (i - p - 1) };
    let (from, to) = (twice_of(r - p), (twice_of(r) + p).min(twice.len() - p - 2));
    let last_span = twice.len() - p - 2;
    let mut line = Vec::with_capacity(to + 1 - from);
    for j in from..=to {
        let first = j.max(p) + j.max(p).abs_diff(p) % 2;
        let spans = (first..=(j + p).min(last_span)).step_by(2);
        let Some(m) = spans.min_by_key(|m| (2 * m).abs_diff(2 * j + p)) else {
            line.push(DVec4::ZERO);
            continue;
        };
        // The span of the same interval, behind r once more.
        let before = p + (m - p) / 2;
        let span = if all[r] <= twice[m] { before + 1 } else { before };
        if span < r - p || r < span - p {
            line.push(DVec4::ZERO);
            continue;
        }
        for (corner, i) in corners.iter_mut().zip(span - p..) {
            let idx = i.checked_sub(r - p);
            *corner = idx.and_then(|idx| own.get(idx)).copied().unwrap_or(DVec4::ZERO);
        }
        for (level, &t) in twice[j + 1..=j + p].iter().enumerate() {
            for k in (level + 1..=p).rev() {
                let i = span - p + k;
                let [low, high] = [once_more(i), once_more(i + p - level)];
                corners[k] = blend(corners[k - 1], corners[k], (t - low) / (high - low));
            }
        }
        line.push(corners[p]);
    }
    let n_zeros = line.iter().take_while(|point| **point == DVec4::ZERO).count();
    line.drain(..n_zeros);
    while line.last().is_some_and(|point| *point == DVec4::ZERO) {
        line.pop();
    }
    if line.is_empty() { (0, line) } else { (from + n_zeros, line) }
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, DVec4};

    use super::{KnotSlopes, with_knots_twice};
    use crate::{KnotVector, NurbsCurve};

    fn point(i: usize) -> DVec4 {
        let i = i as f64;
        DVec3::new(libm::sin(3.0 * i), libm::cos(2.0 * i), i).extend(1.0 + 0.2 * libm::sin(i))
    }

    fn homogeneous(knots: &KnotVector, points: &[DVec4], t: f64) -> DVec4 {
        let span = knots.span_at(t);
        let mut values = vec![0.0; knots.degree() + 1];
        knots.basis_at(span, t, &mut values);
        knots.support(span).zip(values).map(|(i, n)| points[i] * n).sum()
    }

    #[test]
    fn a_spline_grows_with_each_of_its_knots_by_its_derivative() {
        for degree in 2..=5 {
            for n_inner in 1..=7 {
                let inner: Vec<f64> =
                    (0..n_inner).map(|k| 0.7 + k as f64 + 0.3 * libm::sin(k as f64)).collect();
                let end = n_inner as f64 + 1.0;
                let knots_of = |inner: &[f64]| {
                    let ends = [0.0, end].map(|end| vec![end; degree + 1]);
                    KnotVector::new(degree, [&ends[0], inner, &ends[1]].concat()).unwrap()
                };
                let knots = knots_of(&inner);
                let points: Vec<DVec4> = (0..knots.n_points()).map(point).collect();
                let found = KnotSlopes::new(&knots, &points).unwrap().unwrap();
                let twice = with_knots_twice(&knots, vec![points.clone()]).unwrap().remove(0);
                assert_eq!(twice.len(), found.knots().n_points());
                for moving in 0..n_inner {
                    let mut speeds = vec![0.0; n_inner];
                    speeds[moving] = 1.0;
                    let slope = found.at_speeds(&speeds);
                    let moved = |h: f64| {
                        let mut inner = inner.clone();
                        inner[moving] += h;
                        knots_of(&inner)
                    };
                    let h = 1e-5;
                    for step in 0..=40 {
                        let t = end * f64::from(step) / 40.0;
                        if inner.iter().any(|knot| (knot - t).abs() < 3.0 * h) {
                            continue;
                        }
                        let same =
                            homogeneous(found.knots(), &twice, t) - homogeneous(&knots, &points, t);
                        assert!(same.abs().max_element() < 1e-13);
                        let ahead = homogeneous(&moved(h), &points, t);
                        let behind = homogeneous(&moved(-h), &points, t);
                        let expected = (ahead - behind) / (2.0 * h);
                        let error = homogeneous(found.knots(), &slope, t) - expected;
                        assert!(
                            error.abs().max_element() < 1e-7,
                            "{degree} {n_inner} {moving} {t}: {error}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn corners_and_polygons_have_no_such_derivatives() {
        let square = NurbsCurve::polyline(&[DVec3::ZERO, DVec3::X, DVec3::ONE]).unwrap();
        assert!(KnotSlopes::new(square.knots(), square.control_points()).unwrap().is_none());
    }
}
