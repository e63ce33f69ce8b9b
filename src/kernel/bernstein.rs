//! Polynomials by their Bernstein coefficients: products, and the bounds that these give.

use std::{
    cmp::Ordering,
    collections::BinaryHeap,
    ops::{Add, Mul, Sub},
};

use glam::DVec4;

use super::bezier;
use crate::{ceiling::MAXIMUM_HALVINGS, work};

/// Bernstein coefficients of the product of two polynomials on one interval, of any kind of
/// values; `times` multiplies these. O(p·q).
///
/// Farouki & Rajan, *Algorithms for polynomials in Bernstein form*, CAGD 5 (1988), (44).
pub(crate) fn product<A: Copy, B: Copy, C>(a: &[A], b: &[B], times: impl Fn(A, B) -> C) -> Vec<C>
where
    C: Copy + Default + Add<Output = C> + Mul<f64, Output = C>,
{
    let (p, q) = (a.len() - 1, b.len() - 1);
    let (of_a, of_b, of_both) = (binomials(p), binomials(q), binomials(p + q));
    let mut sums = vec![C::default(); p + q + 1];
    for (i, &x) in a.iter().enumerate() {
        for (j, &y) in b.iter().enumerate() {
            let share = of_a[i] * of_b[j] / of_both[i + j];
            sums[i + j] = sums[i + j] + times(x, y) * share;
        }
    }
    sums
}

/// Coefficients of the derivative by the local parameter 0..1.
pub(crate) fn derivative<T>(coefficients: &[T]) -> Vec<T>
where
    T: Copy + Default + Sub<Output = T> + Mul<f64, Output = T>,
{
    match coefficients.len() {
        1 => vec![T::default()],
        n => coefficients.windows(2).map(|pair| (pair[1] - pair[0]) * (n - 1) as f64).collect(),
    }
}

/// The value at a local parameter of 0..1: Horner's scheme, O(p).
///
/// Farin, *Curves and Surfaces for CAGD*, §5.6.
pub(crate) fn value(coefficients: &[f64], t: f64) -> f64 {
    let degree = coefficients.len() - 1;
    if degree == 0 {
        return coefficients[0];
    }
    let s = 1.0 - t;
    let (mut power, mut choose) = (1.0, 1.0);
    let mut sum = coefficients[0] * s;
    for (i, coefficient) in coefficients.iter().enumerate().take(degree).skip(1) {
        power *= t;
        choose *= (degree + 1 - i) as f64 / i as f64;
        sum = (sum + power * choose * coefficient) * s;
    }
    sum + power * t * coefficients[degree]
}

/// The Bernstein polynomials of a degree at a local parameter of 0..1.
pub(crate) fn basis(degree: usize, t: f64) -> Vec<f64> {
    let mut values = binomials(degree);
    let (mut rising, mut falling) = (1.0, 1.0);
    for i in 0..=degree {
        values[i] *= rising;
        values[degree - i] *= falling;
        rising *= t;
        falling *= 1.0 - t;
    }
    values
}

/// The coefficients over both halves of the interval.
pub(crate) fn halves(coefficients: &[f64]) -> [Vec<f64>; 2] {
    let mut right = coefficients.to_vec();
    let mut left = Vec::with_capacity(right.len());
    for n_left in (0..right.len()).rev() {
        left.push(right[0]);
        for i in 0..n_left {
            right[i] = 0.5 * right[i] + 0.5 * right[i + 1];
        }
    }
    [left, right]
}

/// The coefficients over a part of the interval or beyond it: blossoms of the part's ends.
///
/// Ramshaw, *Blossoms are polar forms*, CAGD 6 (1989).
pub(crate) fn part(coefficients: &[DVec4], [from, to]: [f64; 2]) -> Vec<DVec4> {
    let degree = coefficients.len() - 1;
    let blossom = |n_at_end: usize| {
        let mut corners = coefficients.to_vec();
        for level in 0..degree {
            let t = if level < n_at_end { to } else { from };
            for i in 0..degree - level {
                corners[i] = bezier::blend(corners[i], corners[i + 1], t);
            }
        }
        corners[0]
    };
    (0..=degree).map(blossom).collect()
}

/// The largest coefficient by absolute value.
pub(crate) fn largest(coefficients: &[f64]) -> f64 {
    coefficients.iter().fold(0.0, |most, value| most.max(value.abs()))
}

/// `n` over 0, 1, … n.
pub(crate) fn binomials(n: usize) -> Vec<f64> {
    let next = |value: &mut f64, k: usize| {
        let this = *value;
        *value *= (n - k) as f64 / (k + 1) as f64;
        Some(this)
    };
    (0..=n).scan(1.0, next).collect()
}

/// How far above the largest value found a bound may stay.
const SLACK: f64 = 1.02;

/// An upper bound of a quantity over several polynomials of 0..1, of which the one with the largest
/// bound is halved each time: within 2% of the largest value, unless that is as small as
/// `rounding`.
///
/// `bound` tells from coefficients how large the quantity can be between the ends, `value` how
/// large it is at an end.
pub(crate) fn maximum(
    pieces: Vec<Vec<DVec4>>,
    rounding: f64,
    bound: impl Fn(&[DVec4]) -> f64,
    value: impl Fn(DVec4) -> f64,
) -> f64 {
    let mut reached = rounding;
    let mut left = MAXIMUM_HALVINGS + pieces.len();
    let mut todo = BinaryHeap::with_capacity(pieces.len());
    let mut n_pieces = 0;
    let mut add = |todo: &mut BinaryHeap<BoundedPiece>, points: Vec<DVec4>, most: f64| {
        let ends = [points[0], points[points.len() - 1]];
        reached = ends.into_iter().map(&value).fold(reached, f64::max);
        n_pieces += 1;
        todo.push(BoundedPiece { most: bound(&points).min(most), number: n_pieces, points });
        reached
    };
    let mut highest = rounding;
    for points in pieces {
        highest = add(&mut todo, points, f64::INFINITY);
    }
    while work::goes_on(1)
        && let Some(piece) = todo.pop()
    {
        if left == 0 || piece.most <= SLACK * highest {
            return piece.most;
        }
        left -= 1;
        let (before, behind) = bezier::cut_at(&piece.points, 0.5);
        add(&mut todo, before, piece.most);
        highest = add(&mut todo, behind, piece.most);
    }
    0.0
}

/// A piece in the search for a maximum: the one with the largest bound comes first, of equal ones
/// that which was made first.
struct BoundedPiece {
    most: f64,
    number: usize,
    points: Vec<DVec4>,
}

impl Ord for BoundedPiece {
    fn cmp(&self, other: &Self) -> Ordering {
        self.most.total_cmp(&other.most).then(other.number.cmp(&self.number))
    }
}

impl PartialOrd for BoundedPiece {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for BoundedPiece {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for BoundedPiece {}

#[cfg(test)]
mod tests {
    use glam::DVec4;

    use super::{maximum, product};

    #[test]
    fn products_are_those_of_the_polynomials() {
        // (1 − t)·t on coefficients (1, 0) and (0, 1) is half of the middle Bernstein polynomial.
        assert_eq!(product(&[1.0, 0.0], &[0.0, 1.0], |a, b| a * b), [0.0, 0.5, 0.0]);
        // t²·t = t³.
        assert_eq!(product(&[0.0, 0.0, 1.0], &[0.0, 1.0], |a, b| a * b), [0.0, 0.0, 0.0, 1.0]);
    }
    #[test]
    fn a_maximum_is_found_in_whatever_piece_it_hides() {
        // 4t(1 − t) has the maximum 1 between ends of 0, here in the last of many lesser ones.
        let arch = |height: f64| [0.0, 2.0 * height, 0.0].map(|x| DVec4::new(x, 0.0, 0.0, 1.0));
        let mut pieces = vec![arch(0.99).to_vec(); 3000];
        pieces.push(arch(1.0).to_vec());
        let bound = |points: &[DVec4]| points.iter().map(|point| point.x).fold(0.0, f64::max);
        let found = maximum(pieces, 1e-16, bound, |point| point.x);
        assert!((1.0..=1.02).contains(&found), "{found}");
        // Nothing is asked of what is nothing.
        assert!(maximum(vec![arch(0.0).to_vec()], 1e-16, bound, |point| point.x) <= 1e-16);
    }
}
