//! Least squares: more equations than unknowns, whose coefficients stand near one another.

use glam::DVec4;

use crate::tolerance::RANK_RELATIVE;

/// The triangular factor of a band of equations, more than there are unknowns.
///
/// Givens rotations, an equation after the other. Golub & Van Loan, *Matrix Computations*, §5.2.
#[derive(Clone, Debug)]
pub(crate) struct TriangularFactor {
    width: usize,
    /// Rows from the diagonal on.
    rows: Vec<f64>,
}

impl TriangularFactor {
    /// `None` where the equations leave an unknown open.
    pub(crate) fn new<'a>(
        equations: impl Iterator<Item = (usize, &'a [f64])>,
        n: usize,
        width: usize,
    ) -> Option<Self> {
        let mut rows = vec![0.0; n * width];
        // A rotation moves the row on by one place; behind it stand zeros.
        let mut line = vec![0.0; width];
        for (first, shares) in equations {
            line.clear();
            line.extend_from_slice(shares);
            for i in first..n {
                let start = i - first;
                line.resize(start + width, 0.0);
                let row = &mut line[start..];
                if row.iter().all(|value| value.abs() <= 0.0) {
                    break;
                }
                rotate(&mut rows[i * width..][..width], row);
            }
        }
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

/// The part of an equation that is about the unknowns between the first and the last, which are given:
/// `n_inner` of them, counted from the second.
pub(crate) fn without_ends((first, shares): (usize, &[f64]), n_inner: usize) -> (usize, &[f64]) {
    let n_before = 1_usize.saturating_sub(first);
    let end = (n_inner + 1).saturating_sub(first).min(shares.len());
    ((first + n_before) - 1, shares.get(n_before..end).unwrap_or_default())
}

/// Turns two rows so that the second begins with zero.
fn rotate(upper: &mut [f64], lower: &mut [f64]) {
    // Shares of control points are at most one, and what is too small to be squared is rounding.
    let length = (upper[0] * upper[0] + lower[0] * lower[0]).sqrt();
    if length <= 0.0 {
        return;
    }
    let (cosine, sine) = (upper[0] / length, lower[0] / length);
    for (a, b) in upper.iter_mut().zip(lower.iter_mut()) {
        (*a, *b) = (cosine * *a + sine * *b, cosine * *b - sine * *a);
    }
    // What rounding leaves there would be rotated on.
    lower[0] = 0.0;
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
