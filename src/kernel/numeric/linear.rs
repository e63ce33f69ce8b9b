//! Linear systems with a few unknowns.

/// The solution of a small linear system, by elimination with partial pivoting; none of a system
/// that is singular, or so nearly that a number overflows.
///
/// O(N³). Golub & Van Loan, *Matrix Computations*, Algorithm 3.4.1.
pub(crate) fn solved<const N: usize>(
    mut matrix: [[f64; N]; N],
    mut right: [f64; N],
) -> Option<[f64; N]> {
    eliminated(&mut matrix, &mut right).then_some(right)
}

/// The solution of a linear system of any size; as many rows of as many numbers as there are right-hand sides.
///
/// None of a system that is singular, or so nearly that a number overflows. O(n³), by elimination with partial
/// pivoting. Golub & Van Loan, *Matrix Computations*, Algorithm 3.4.1.
///
/// ```
/// use virote_kernel::solve_linear;
///
/// let found = solve_linear(vec![vec![2.0, 1.0], vec![1.0, -1.0]], vec![5.0, 1.0]);
/// assert_eq!(found, Some(vec![2.0, 1.0]));
/// ```
#[must_use]
pub fn solve_linear(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let n = right.len();
    let is_square = matrix.len() == n && matrix.iter().all(|row| row.len() == n);
    (is_square && eliminated(&mut matrix, &mut right)).then_some(right)
}

/// Puts the unknowns in the place of the right-hand sides, if that can be.
#[inline]
fn eliminated<R: AsRef<[f64]> + AsMut<[f64]>>(matrix: &mut [R], right: &mut [f64]) -> bool {
    let n = right.len();
    for column in 0..n {
        let size = |row: usize| matrix[row].as_ref()[column].abs();
        let pivot = (column..n).max_by(|&i, &k| size(i).total_cmp(&size(k))).unwrap_or(column);
        if size(pivot) < f64::MIN_POSITIVE {
            return false;
        }
        matrix.swap(column, pivot);
        right.swap(column, pivot);
        let (above, below) = matrix.split_at_mut(column + 1);
        let above = above[column].as_ref();
        for (row, own) in below.iter_mut().enumerate() {
            let own = own.as_mut();
            let factor = own[column] / above[column];
            for (value, above) in own.iter_mut().zip(above).skip(column) {
                *value -= factor * above;
            }
            right[column + 1 + row] -= factor * right[column];
        }
    }
    for row in (0..n).rev() {
        let own = matrix[row].as_ref();
        let known: f64 = (row + 1..n).map(|k| own[k] * right[k]).sum();
        right[row] = (right[row] - known) / own[row];
    }
    right.iter().all(|x| x.is_finite())
}

/// Two equations with two unknowns, to be solved for several right-hand sides by Cramer's rule.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TwoEquations {
    /// By rows.
    pub(crate) matrix: [[f64; 2]; 2],
}

impl TwoEquations {
    /// Those whose matrix is its own transpose: the first of its rows, and the rest of the second.
    pub(crate) fn symmetric(a: f64, b: f64, c: f64) -> Self {
        Self { matrix: [[a, b], [b, c]] }
    }

    /// How much larger the area between the images of two vectors is than between them.
    pub(crate) fn determinant(&self) -> f64 {
        let [[a, b], [c, d]] = self.matrix;
        a * d - b * c
    }

    /// The unknowns; not finite where the equations are parallel.
    pub(crate) fn solved(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [[a, b], [c, d]] = self.matrix;
        let determinant = self.determinant();
        [(x * d - y * b) / determinant, (y * a - x * c) / determinant]
    }
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "exactness is the claim")]
mod tests {
    use super::{TwoEquations, solved};

    /// Equations whose right-hand sides are made for the unknowns 1, −2, 3, ....
    #[track_caller]
    fn check<const N: usize>(matrix: [[f64; N]; N]) {
        let wanted: [f64; N] =
            std::array::from_fn(|i| (i as f64 + 1.0) * if i % 2 == 0 { 1.0 } else { -1.0 });
        let right = matrix.map(|row| row.iter().zip(&wanted).map(|(a, x)| a * x).sum());
        let found = solved(matrix, right).expect("independent equations");
        let error = found.iter().zip(&wanted).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        assert!(error < 1e-13, "{found:?}");
    }

    #[test]
    fn unknowns_fulfil_their_equations() {
        check([[4.0]]);
        check([[2.0, 1.0, -1.0], [-3.0, -1.0, 2.0], [-2.0, 1.0, 2.0]]);
        check([
            [1.0, 2.0, 0.0, 1.0],
            [0.5, 1.0, 3.0, 2.0],
            [1.0, 0.0, 1.0, 0.0],
            [2.0, 2.0, 2.0, -7.0],
        ]);
    }

    #[test]
    fn a_zero_on_the_diagonal_is_exchanged_and_a_tiny_one_too() {
        check([[0.0, 1.0], [1.0, 0.0]]);
        // Without the exchange all digits of the first unknown are lost.
        check([[1e-20, 1.0], [1.0, 1.0]]);
    }

    #[test]
    fn equations_that_repeat_one_another_have_no_single_solution() {
        assert_eq!(solved([[1.0, 2.0], [2.0, 4.0]], [1.0, 2.0]), None);
        assert_eq!(solved([[0.0; 3]; 3], [0.0; 3]), None);
    }

    #[test]
    fn cramer_and_elimination_agree() {
        let pair = TwoEquations { matrix: [[3.0, -1.0], [2.0, 5.0]] };
        assert_eq!(pair.determinant(), 17.0);
        assert_eq!(pair.solved([1.0, 12.0]), [1.0, 2.0]);
        let eliminated = solved(pair.matrix, [1.0, 12.0]).expect("independent equations");
        assert!((eliminated[0] - 1.0).abs() < 1e-15 && (eliminated[1] - 2.0).abs() < 1e-15);
        let parallel = TwoEquations::symmetric(1.0, 2.0, 4.0).solved([1.0, 1.0]);
        assert!(parallel.iter().all(|x| !x.is_finite()));
    }
}
