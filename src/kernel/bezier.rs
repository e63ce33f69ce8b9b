//! Bézier pieces of splines: their control points, and cutting them.
//!
//! Works on bare slices of homogeneous points, so that curves and the rows and columns of
//! surfaces share it. Every step is a convex combination.

use std::ops::RangeInclusive;

use glam::DVec4;

use super::{Direction, Grid, KnotVector};

/// Control points of the Bézier curve that a spline is over one span.
///
/// The j-th is the blossom with p − j arguments at the span's start and j at its end; O(p³).
/// Ramshaw, *Blossoms are polar forms*, §5.
pub(crate) fn piece(knots: &KnotVector, points: &[DVec4], span: usize) -> Vec<DVec4> {
    local_piece(knots, &points[knots.support(span)], span)
}

/// The symmetric multi-affine function of p arguments that is the spline's piece over `span`
/// where all of them are equal.
pub(crate) fn blossom(
    knots: &KnotVector,
    points: &[DVec4],
    span: usize,
    arguments: &[f64],
) -> DVec4 {
    let mut corners = points[knots.support(span)].to_vec();
    for (level, &t) in arguments.iter().enumerate() {
        cut(knots.as_slice(), span, level + 1, t, level + 1..=knots.degree(), &mut corners);
    }
    corners[knots.degree()]
}

/// By how much each of the control points that act over `span` counts in [`blossom`].
pub(crate) fn blossom_factors(knots: &KnotVector, span: usize, arguments: &[f64]) -> Vec<f64> {
    let (all, p) = (knots.as_slice(), knots.degree());
    let mut factors = vec![0.0; p + 1];
    factors[p] = 1.0;
    for (level, &t) in arguments.iter().enumerate().rev() {
        for r in level + 1..=p {
            if factors[r] == 0.0 {
                continue;
            }
            let (left, right) = (all[span + r - p], all[span + r - level]);
            let fraction = (t - left) / (right - left);
            factors[r - 1] += factors[r] * (1.0 - fraction);
            factors[r] *= fraction;
        }
    }
    factors
}

/// One level q of de Boor's corner cutting at `t`, in place: `corners[q..]` are the new ones, of which some are made.
fn cut(
    knots: &[f64],
    span: usize,
    q: usize,
    t: f64,
    made: RangeInclusive<usize>,
    corners: &mut [DVec4],
) {
    let p = corners.len() - 1;
    for r in made.rev() {
        let (left, right) = (knots[span + r - p], knots[span + 1 + r - q]);
        corners[r] = blend(corners[r - 1], corners[r], (t - left) / (right - left));
    }
}

/// The point a fraction of the way from `a` to `b`; exactly these at 0 and 1.
pub(crate) fn blend(a: DVec4, b: DVec4, fraction: f64) -> DVec4 {
    a * (1.0 - fraction) + b * fraction
}

/// Both parts of a Bézier curve cut at a fraction of its domain: de Casteljau.
///
/// Farin, *Curves and Surfaces for CAGD*, §4.6.
pub(crate) fn cut_at(points: &[DVec4], fraction: f64) -> (Vec<DVec4>, Vec<DVec4>) {
    let mut right = points.to_vec();
    let mut left = Vec::with_capacity(points.len());
    cut_off(&mut right, fraction, |point| left.push(point));
    (left, right)
}

/// Makes the second part of a curve of the whole, as [`cut_at`]; `keep` is told the points of the first.
pub(crate) fn cut_off(points: &mut [DVec4], fraction: f64, mut keep: impl FnMut(DVec4)) {
    for n_left in (0..points.len()).rev() {
        keep(points[0]);
        for i in 0..n_left {
            points[i] = blend(points[i], points[i + 1], fraction);
        }
    }
}

/// Makes the part from `low` to `high` of a curve of the whole, whose points stand `stride` apart: as [`cut_at`] at
/// `high` and of what is before it at `low`.
pub(crate) fn keep_between(points: &mut [DVec4], stride: usize, [low, high]: [f64; 2]) {
    let n_points = points.len().div_ceil(stride);
    for n_done in 1..n_points {
        for i in (n_done..n_points).rev() {
            points[i * stride] = blend(points[(i - 1) * stride], points[i * stride], high);
        }
    }
    for n_left in (1..n_points).rev() {
        for i in 0..n_left {
            points[i * stride] = blend(points[i * stride], points[(i + 1) * stride], low / high);
        }
    }
}

/// The net of the Bézier patch that a tensor-product spline is over a pair of spans.
pub(crate) fn patch(
    knots: [&KnotVector; 2],
    points: &Grid<DVec4>,
    span_u: usize,
    span_v: usize,
) -> Grid<DVec4> {
    let [knots_u, knots_v] = knots;
    let (p, q) = (knots_u.degree(), knots_v.degree());
    let strip: Vec<Vec<DVec4>> =
        knots_u.support(span_u).map(|i| piece(knots_v, points.row(i), span_v)).collect();
    let columns: Vec<Vec<DVec4>> = (0..=q)
        .map(|j| {
            let column: Vec<DVec4> = strip.iter().map(|row| row[j]).collect();
            local_piece(knots_u, &column, span_u)
        })
        .collect();
    Grid::from_fn(p + 1, q + 1, |i, j| columns[j][i])
}

/// [`piece`] of the p + 1 points that act on the span.
fn local_piece(knots: &KnotVector, local: &[DVec4], span: usize) -> Vec<DVec4> {
    let p = knots.degree();
    let (start, end) = (knots.as_slice()[span], knots.as_slice()[span + 1]);
    // What arguments at the end make of the points, as many as the blossom in turn has.
    let mut at_end = local.to_vec();
    // Between knots that stand as often as the degree the piece has these very points.
    if p == 0 || start <= knots.as_slice()[span + 1 - p] && knots.as_slice()[span + p] <= end {
        return at_end;
    }
    // Where a knot stands more than once cuts at it move points, or leave them where they are.
    let (before, behind) = knots.as_slice()[span + 1 - p..=span + p].split_at(p);
    let n_starts = before.iter().filter(|&&knot| start <= knot).count();
    let n_ends = behind.iter().filter(|&&knot| knot <= end).count();
    let mut corners = local.to_vec();
    let blossom = |n_at_end: usize| {
        if 0 < n_at_end {
            let moved = n_at_end + n_ends..=p;
            cut(knots.as_slice(), span, n_at_end, end, moved, &mut at_end);
        }
        let last = n_at_end.max(p - n_starts);
        corners.copy_from_slice(&at_end);
        for q in n_at_end + 1..=last {
            cut(knots.as_slice(), span, q, start, q..=last, &mut corners);
        }
        corners[last]
    };
    (0..=p).map(blossom).collect()
}

/// Both halves of a Bézier net along a direction.
pub(crate) fn halves(net: &Grid<DVec4>, along: Direction) -> [Grid<DVec4>; 2] {
    if along == Direction::U {
        return halves(&net.transposed(), Direction::V).map(|half| half.transposed());
    }
    let (n_rows, n_columns) = (net.n_rows(), net.n_columns());
    let rows: Vec<(Vec<DVec4>, Vec<DVec4>)> =
        (0..n_rows).map(|i| cut_at(net.row(i), 0.5)).collect();
    [
        Grid::from_fn(n_rows, n_columns, |i, j| rows[i].0[j]),
        Grid::from_fn(n_rows, n_columns, |i, j| rows[i].1[j]),
    ]
}
