//! Least squares: more equations than unknowns, whose coefficients stand near one another.

use std::f64::consts::GOLDEN_RATIO;

use glam::DVec4;

use crate::{sorting::sort_by_key, tolerance::RANK_RELATIVE};

/// Equations that are turned at once.
const BLOCK_EQUATIONS: usize = 64;

/// The triangular factor of a band of equations, more than there are unknowns.
///
/// Householder reflections of the equations that begin with the same unknown, block after block.
/// Lawson & Hanson, *Solving Least Squares Problems*, §27.2.
#[derive(Clone, Debug)]
pub(crate) struct TriangularFactor {
    width: usize,
    /// Rows from the diagonal on.
    rows: Vec<f64>,
}

impl TriangularFactor {
    /// `None` where the equations leave an unknown open. Each is at most `width` long.
    pub(crate) fn new<'a>(
        equations: impl Iterator<Item = (usize, &'a [f64])> + Clone,
        n: usize,
        width: usize,
    ) -> Option<Self> {
        if equations.clone().is_sorted_by_key(|(first, _)| first) {
            return Self::of_sorted(equations, n, width);
        }
        let mut sorted: Vec<(usize, &[f64])> = equations.collect();
        sort_by_key(&mut sorted, |(first, _)| *first);
        Self::of_sorted(sorted.into_iter(), n, width)
    }

    fn of_sorted<'a>(
        equations: impl Iterator<Item = (usize, &'a [f64])>,
        n: usize,
        width: usize,
    ) -> Option<Self> {
        let mut rows = vec![0.0; n * width];
        let mut block =
            EquationBlock { first: 0, len: 0, columns: vec![0.0; width * BLOCK_EQUATIONS] };
        for (first, shares) in equations {
            if first != block.first || block.len == BLOCK_EQUATIONS {
                block.turn_into(&mut rows, width);
                block.first = first;
            }
            block.push(shares);
        }
        block.turn_into(&mut rows, width);
        let diagonal = || rows.iter().step_by(width);
        let largest = diagonal().fold(0.0_f64, |most, value| most.max(value.abs()));
        let is_open = |value: &f64| value.abs() <= RANK_RELATIVE * largest;
        if diagonal().any(is_open) { None } else { Some(Self { width, rows }) }
    }

    /// Solves RᵀR x = values in place.
    pub(crate) fn solve_normal(&self, values: &mut [DVec4]) {
        let n = values.len();
        for i in 0..n {
            let row = &self.rows[i * self.width..][..self.width];
            values[i] /= row[0];
            let value = values[i];
            for (later, &coefficient) in values[i + 1..].iter_mut().zip(&row[1..]) {
                *later -= coefficient * value;
            }
        }
        for i in (0..n).rev() {
            let row = &self.rows[i * self.width..][..self.width];
            let known = row[1..].iter().zip(&values[i + 1..]);
            let sum =
                known.fold(values[i], |sum, (&coefficient, &value)| sum - coefficient * value);
            values[i] = sum / row[0];
        }
    }
}

/// Steps of the power method, which finds the order of what is hardly held in two or three.
const POWER_STEPS: usize = 4;

impl TriangularFactor {
    /// How little the equations hold what they hold least, as a fraction of what they hold an unknown by at most:
    /// an estimate, by the power method on the inverse of RᵀR.
    pub(crate) fn least_hold(&self) -> f64 {
        let n = self.rows.len() / self.width;
        let largest =
            self.rows.iter().step_by(self.width).fold(0.0_f64, |most, x| most.max(x.abs()));
        // Neither even nor smooth, so that it has a part in every direction.
        let mut values: Vec<DVec4> =
            (0..n).map(|i| DVec4::splat((i as f64 * GOLDEN_RATIO).fract() - 0.5)).collect();
        let mut growth = 0.0_f64;
        for _ in 0..POWER_STEPS {
            let length = values.iter().map(|value| value.x * value.x).sum::<f64>().sqrt();
            let is_number = length.is_finite() && 0.0 < length;
            if !is_number {
                return if n == 0 { 1.0 } else { 0.0 };
            }
            values.iter_mut().for_each(|value| *value /= length);
            self.solve_normal(&mut values);
            growth = values.iter().map(|value| value.x * value.x).sum::<f64>().sqrt();
        }
        (growth.sqrt() * largest).recip()
    }
}

/// The part of an equation that is about the unknowns between the first and the last, which are given:
/// `n_inner` of them, counted from the second.
pub(crate) fn without_ends((first, shares): (usize, &[f64]), n_inner: usize) -> (usize, &[f64]) {
    let n_before = 1_usize.saturating_sub(first);
    let end = (n_inner + 1).saturating_sub(first).min(shares.len());
    ((first + n_before) - 1, shares.get(n_before..end).unwrap_or_default())
}

/// Equations that begin with the same unknown.
struct EquationBlock {
    first: usize,
    len: usize,
    /// The coefficients of each unknown, [`BLOCK_EQUATIONS`] places apart.
    columns: Vec<f64>,
}

impl EquationBlock {
    fn push(&mut self, shares: &[f64]) {
        for (j, column) in self.columns.chunks_exact_mut(BLOCK_EQUATIONS).enumerate() {
            column[self.len] = shares.get(j).copied().unwrap_or(0.0);
        }
        self.len += 1;
    }

    /// Reflects the equations into the rows of the factor, one unknown after the other, until
    /// nothing is left of them. Golub & Van Loan, *Matrix Computations*, §5.1.
    ///
    /// The rows have nothing beyond the unknowns of the block, as no earlier equation had.
    fn turn_into(&mut self, rows: &mut [f64], width: usize) {
        let len = std::mem::take(&mut self.len);
        let mut rows = rows.chunks_exact_mut(width).skip(self.first);
        let mut rest = &mut self.columns[..];
        while let Some((column, behind)) = rest.split_at_mut_checked(BLOCK_EQUATIONS) {
            rest = behind;
            let (column, Some(row)) = (&column[..len], rows.next()) else { return };
            // Shares of control points are at most one, and what is too small to be squared is
            // rounding.
            let squares = dot(column, column);
            if squares <= 0.0 {
                continue;
            }
            let length = (row[0] * row[0] + squares).sqrt();
            let own = row[0] + length.copysign(row[0]);
            let per_square = 1.0 / (length * own.abs());
            row[0] = -length.copysign(row[0]);
            for (value, other) in row[1..].iter_mut().zip(rest.chunks_exact_mut(BLOCK_EQUATIONS)) {
                let other = &mut other[..len];
                let factor = (own * *value + dot(column, other)) * per_square;
                *value -= factor * own;
                for (value, from) in other.iter_mut().zip(column) {
                    *value -= factor * from;
                }
            }
        }
    }
}

/// The sum of products, four at a time.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let ((a, rest_a), (b, rest_b)) = (a.as_chunks::<4>(), b.as_chunks::<4>());
    let mut sums = [0.0; 4];
    for (a, b) in a.iter().zip(b) {
        for i in 0..4 {
            sums[i] += a[i] * b[i];
        }
    }
    let rest: f64 = rest_a.iter().zip(rest_b).map(|(a, b)| a * b).sum();
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

#[cfg(test)]
mod tests {
    use glam::DVec4;

    use super::{TriangularFactor, without_ends};

    #[test]
    fn the_normal_equations_are_solved() {
        // x + y, y + z, x, z, y: AᵀA is [2 1 0; 1 3 1; 0 1 2].
        let rows: [(usize, &[f64]); 5] =
            [(0, &[1.0, 1.0]), (0, &[1.0]), (1, &[1.0, 1.0]), (1, &[1.0]), (2, &[1.0])];
        let factor = TriangularFactor::new(rows.into_iter(), 3, 2).expect("full rank");
        // Of 1, −2, 3.
        let mut values = [0.0, -2.0, 4.0].map(DVec4::splat);
        factor.solve_normal(&mut values);
        for (found, wanted) in values.iter().zip([1.0, -2.0, 3.0]) {
            assert!((found.x - wanted).abs() < 1e-14, "{found} for {wanted}");
        }
    }

    #[test]
    fn the_order_of_the_equations_makes_no_difference() {
        let rows: [(usize, &[f64]); 5] =
            [(0, &[1.0, 1.0]), (0, &[1.0]), (1, &[1.0, 1.0]), (1, &[1.0]), (2, &[1.0])];
        let solved = |rows: Vec<(usize, &[f64])>| {
            let factor = TriangularFactor::new(rows.into_iter(), 3, 2).expect("full rank");
            let mut values = [0.0, -2.0, 4.0].map(DVec4::splat);
            factor.solve_normal(&mut values);
            values
        };
        let [forwards, backwards] = [rows.to_vec(), rows.into_iter().rev().collect()].map(solved);
        for (a, b) in forwards.iter().zip(backwards) {
            assert!((a.x - b.x).abs() < 1e-14, "{a} and {b}");
        }
    }

    #[test]
    fn many_equations_of_the_same_unknowns_are_as_few() {
        // A hundred times what two equations want: x + y = 3, x − y = 1.
        let rows = [[1.0, 1.0], [1.0, -1.0]];
        let many = (0..200).map(|i| (0, &rows[i % 2][..]));
        let factor = TriangularFactor::new(many, 2, 2).expect("full rank");
        let mut values = [400.0, 200.0].map(DVec4::splat);
        factor.solve_normal(&mut values);
        assert!((values[0].x - 2.0).abs() < 1e-14 && (values[1].x - 1.0).abs() < 1e-14);
    }

    #[test]
    fn given_ends_are_left_out_of_an_equation() {
        let shares = [1.0, 2.0, 3.0];
        assert_eq!(without_ends((0, &shares), 4), (0, &shares[1..]));
        assert_eq!(without_ends((1, &shares), 4), (0, &shares[..]));
        assert_eq!(without_ends((3, &shares), 4), (2, &shares[..2]));
    }

    #[test]
    fn an_unknown_that_no_equation_is_about_is_open() {
        let rows: [(usize, &[f64]); 2] = [(0, &[1.0]), (2, &[1.0])];
        assert!(TriangularFactor::new(rows.into_iter(), 3, 2).is_none());
    }
}
