//! Taking a knot out of a spline, with the least change to its control points.

use std::ops::Range;

use glam::DVec4;

use super::homogeneous;

/// What taking out one copy of a knot does: the points of a range are replaced by one less.
pub(crate) struct Removal {
    pub(crate) range: Range<usize>,
    pub(crate) points: Vec<DVec4>,
    /// A distance that no point of a polynomial curve moves further than; of a rational one an
    /// estimate.
    pub(crate) displacement: f64,
}

/// The removal of the knot at `index`, the last of its copies, which lies inside the domain.
///
/// The old points are those that insertion would make of the new ones: one equation more than
/// there are unknowns. What cannot be met is spread evenly over the equations, which makes the
/// largest residual as small as it can be; the curve, a mean of the residuals, moves no further.
/// Eck & Hadenfeld, *Knot removal for B-spline curves*, CAGD 12 (1995); the equations are
/// Piegl & Tiller, *The NURBS Book*, (5.28).
pub(crate) fn removal(degree: usize, knots: &[f64], points: &[DVec4], index: usize) -> Removal {
    let t = knots[index];
    let times = index - knots.partition_point(|&knot| knot < t);
    // As for an insertion at `t` into the knots without it.
    let (first, last) = (index - 1 - degree, index - 1 - times);
    if first == last {
        let (left, right) = (points[first], points[first + 1]);
        let middle = (left + right) * 0.5;
        let extent = homogeneous::place(left).distance(homogeneous::place(right));
        let displacement = residual_length((left - right) * 0.5, middle, extent);
        return Removal { range: first..first + 2, points: vec![middle], displacement };
    }
    // Of the knots without it, the i-th for i up to its place, and the one p behind.
    let fraction = |i: usize| (t - knots[i]) / (knots[i + degree + 1] - knots[i]);

    // The combination of the equations in which every unknown cancels.
    let mut factors = vec![1.0_f64];
    for i in first + 1..last {
        let previous = factors[factors.len() - 1];
        let next = -previous * fraction(i) / (1.0 - fraction(i + 1));
        factors.push(next);
        if 1.0 < next.abs() {
            factors.iter_mut().for_each(|factor| *factor /= next.abs());
        }
    }
    let known = |i: usize| {
        let from_left =
            if i == first + 1 { points[first] * (1.0 - fraction(i)) } else { DVec4::ZERO };
        let from_right = if i == last { points[last + 1] * fraction(i) } else { DVec4::ZERO };
        points[i] - from_left - from_right
    };
    let sum: DVec4 = (first + 1..=last).zip(&factors).map(|(i, &factor)| known(i) * factor).sum();
    let spread = sum / factors.iter().map(|factor| factor.abs()).sum::<f64>();
    let target = |i: usize| points[i] - spread * factors[i - first - 1].signum();

    // Solve from both ends up to the equation that counts most.
    let largest = |a: &usize, b: &usize| factors[*a].abs().total_cmp(&factors[*b].abs());
    let middle = first + 1 + (0..factors.len()).max_by(largest).unwrap_or(0);
    let mut unknowns = vec![DVec4::ZERO; last - first - 1];
    let mut left = points[first];
    for i in first + 1..middle {
        left = (target(i) - left * (1.0 - fraction(i))) / fraction(i);
        unknowns[i - first - 1] = left;
    }
    let mut right = points[last + 1];
    for i in (middle + 1..=last).rev() {
        right = (target(i) - right * fraction(i)) / (1.0 - fraction(i));
        unknowns[i - first - 2] = right;
    }
    let around = &points[first..=last + 1];
    let from_first = |&p: &DVec4| homogeneous::place(p).distance(homogeneous::place(around[0]));
    let extent = 2.0 * around.iter().map(from_first).fold(0.0, f64::max);
    let lengths = (first + 1..=last).map(|i| residual_length(spread, points[i], extent));
    let displacement = lengths.fold(0.0, f64::max);
    Removal { range: first + 1..last + 1, points: unknowns, displacement }
}

/// How far a homogeneous difference of a control point moves the curve: the point itself, and by
/// its weight the places between it and others that are `extent` apart.
fn residual_length(difference: DVec4, at: DVec4, extent: f64) -> f64 {
    let moved = difference.truncate() - homogeneous::place(at) * difference.w;
    (moved.length() + difference.w.abs() * extent) / at.w.abs().max(f64::MIN_POSITIVE)
}
