//! Eigenvalues and eigenvectors of small symmetric matrices.

use crate::sorting::sort_by;
use glam::{DMat2, DMat3, DVec2, DVec3};

/// Sweeps over all entries off the diagonal; five are enough for all bits.
const SWEEPS: usize = 12;

/// The eigenvalues of a symmetric matrix in ascending order, with unit eigenvectors that are
/// right-handed: Jacobi's rotations.
///
/// Golub & Van Loan, *Matrix Computations*, §8.5.
#[must_use]
pub fn principal_axes(matrix: DMat3) -> [(f64, DVec3); 3] {
    let (mut a, mut axes) = (matrix, DMat3::IDENTITY);
    for _ in 0..SWEEPS {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let off = a.col(q)[p];
            if off.abs() <= 0.0 {
                continue;
            }
            let [cosine, sine] = rotation([a.col(p)[p], off, a.col(q)[q]]);
            let mut turn = DMat3::IDENTITY;
            turn.col_mut(p)[p] = cosine;
            turn.col_mut(q)[q] = cosine;
            turn.col_mut(q)[p] = sine;
            turn.col_mut(p)[q] = -sine;
            a = turn.transpose() * a * turn;
            axes *= turn;
        }
    }
    let mut pairs = [0, 1, 2].map(|i| (a.col(i)[i], axes.col(i)));
    sort_by(&mut pairs, |a, b| a.0.total_cmp(&b.0));
    pairs[2].1 = pairs[0].1.cross(pairs[1].1);
    pairs
}

/// The eigenvalues of a symmetric matrix of any size in ascending order, with unit eigenvectors: Jacobi's rotations.
///
/// O(n³) in each of some eight sweeps. Golub & Van Loan, *Matrix Computations*, §8.5.
pub(super) fn symmetric_axes(mut matrix: Vec<Vec<f64>>) -> Vec<(f64, Vec<f64>)> {
    let n = matrix.len();
    let mut axes: Vec<Vec<f64>> =
        (0..n).map(|i| (0..n).map(|j| if i == j { 1.0 } else { 0.0 }).collect()).collect();
    for _ in 0..SWEEPS {
        for (p, q) in (0..n).flat_map(|p| (p + 1..n).map(move |q| (p, q))) {
            let off = matrix[p][q];
            if off.abs() <= 0.0 {
                continue;
            }
            let turn = rotation([matrix[p][p], off, matrix[q][q]]);
            rotate(&mut matrix, [p, q], turn);
            for row in &mut matrix {
                (row[p], row[q]) = turned([row[p], row[q]], turn);
            }
            rotate(&mut axes, [p, q], turn);
        }
    }
    let mut pairs: Vec<(f64, Vec<f64>)> =
        axes.into_iter().enumerate().map(|(i, axis)| (matrix[i][i], axis)).collect();
    sort_by(&mut pairs, |a, b| a.0.total_cmp(&b.0));
    pairs
}

/// Two rows in the place of which what a rotation makes of them comes.
fn rotate(rows: &mut [Vec<f64>], [p, q]: [usize; 2], turn: [f64; 2]) {
    let (before, behind) = rows.split_at_mut(q);
    for (first, second) in before[p].iter_mut().zip(&mut behind[0]) {
        (*first, *second) = turned([*first, *second], turn);
    }
}

fn turned([first, second]: [f64; 2], [cosine, sine]: [f64; 2]) -> (f64, f64) {
    (cosine * first - sine * second, sine * first + cosine * second)
}

/// The mean of the eigenvalues of a symmetric matrix with the first row `a`, `b` and the second `b`, `c`, and half of
/// their difference.
pub(crate) fn mean_and_spread([a, b, c]: [f64; 3]) -> [f64; 2] {
    [0.5 * (a + c), libm::hypot(0.5 * (a - c), b)]
}

/// The eigenvalues of a symmetric matrix with unit eigenvectors, the smaller one by size first: the
/// rotation that makes it diagonal, by its angle.
///
/// Golub & Van Loan, *Matrix Computations*, §8.5.2.
pub(crate) fn eigen_of_two(matrix: DMat2) -> [(f64, DVec2); 2] {
    let (a, b, c) = (matrix.x_axis.x, matrix.y_axis.x, matrix.y_axis.y);
    let angle = 0.5 * libm::atan2(2.0 * b, a - c);
    let (sine, cosine) = libm::sincos(angle);
    let axes = [DVec2::new(cosine, sine), DVec2::new(-sine, cosine)];
    let [first, second] = axes.map(|axis| (axis.dot(matrix * axis), axis));
    if first.0.abs() <= second.0.abs() { [first, second] } else { [second, first] }
}

/// Cosine and sine of Jacobi's rotation, by less than an eighth of a turn, that makes a matrix
/// diagonal of which the first row is `a`, `b` and the second `b`, `c`; `b` is not zero.
///
/// Golub & Van Loan, *Matrix Computations*, Algorithm 8.5.1.
pub(super) fn rotation([a, b, c]: [f64; 3]) -> [f64; 2] {
    let ratio = 0.5 * (c - a) / b;
    let tangent = 1.0_f64.copysign(ratio) / (ratio.abs() + libm::hypot(ratio, 1.0));
    let cosine = 1.0 / libm::hypot(tangent, 1.0);
    [cosine, tangent * cosine]
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "exactness is the claim")]
mod tests {
    use glam::{DMat2, DMat3, DVec2, DVec3};

    use super::{eigen_of_two, principal_axes, rotation, symmetric_axes};

    #[test]
    fn eigenvectors_keep_their_direction_and_are_right_handed() {
        let [x, y, z] =
            [DVec3::new(2.0, -1.0, 0.5), DVec3::new(-1.0, 3.0, 4.0), DVec3::new(0.5, 4.0, -6.0)];
        let matrix = DMat3::from_cols(x, y, z);
        let found = principal_axes(matrix);
        for (value, axis) in found {
            assert!((matrix * axis - axis * value).length() < 1e-14 * 8.0, "{value} {axis}");
        }
        assert!(found[0].0 <= found[1].0 && found[1].0 <= found[2].0);
        let axes = found.map(|(_, axis)| axis);
        let turned = DMat3::from_cols(axes[0], axes[1], axes[2]);
        assert!((turned.determinant() - 1.0).abs() < 1e-15);
        let trace: f64 = found.iter().map(|(value, _)| value).sum();
        assert!((trace + 1.0).abs() < 1e-14, "{trace}");
    }

    #[test]
    fn axes_of_any_number_are_those_of_second_differences() {
        // The eigenvalues of second differences are 2 − 2 cos(kπ/(n + 1)).
        let n = 9;
        let entry = |i: usize, j: usize| match i.abs_diff(j) {
            0 => 2.0,
            1 => -1.0,
            _ => 0.0,
        };
        let matrix: Vec<Vec<f64>> = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
        for (k, (value, axis)) in symmetric_axes(matrix.clone()).iter().enumerate() {
            let turn = std::f64::consts::PI * (k as f64 + 1.0) / (n as f64 + 1.0);
            assert!((value - (2.0 - 2.0 * libm::cos(turn))).abs() < 1e-14, "{value}");
            for (row, part) in matrix.iter().zip(axis) {
                let image: f64 = row.iter().zip(axis).map(|(a, b)| a * b).sum();
                assert!((image - value * part).abs() < 1e-14, "{image} {part}");
            }
        }
        assert_eq!(symmetric_axes(Vec::new()), Vec::new());
    }

    #[test]
    fn a_diagonal_matrix_has_its_own_axes() {
        let found = principal_axes(DMat3::from_diagonal(DVec3::new(3.0, 1.0, 2.0)));
        assert_eq!(found.map(|(value, _)| value), [1.0, 2.0, 3.0]);
        assert_eq!(found.map(|(_, axis)| axis.abs()), [DVec3::Y, DVec3::Z, DVec3::X]);
    }

    #[test]
    fn of_two_the_smaller_by_size_comes_first() {
        // Of 1, 2, 2, −2 they are 2 along (2, 1) and −3 along (1, −2).
        let matrix = DMat2::from_cols(DVec2::new(1.0, 2.0), DVec2::new(2.0, -2.0));
        let [(small, along), (large, across)] = eigen_of_two(matrix);
        assert!((small - 2.0).abs() < 1e-15 && (large + 3.0).abs() < 1e-15, "{small} {large}");
        assert!(along.perp_dot(DVec2::new(2.0, 1.0)).abs() < 1e-15, "{along}");
        assert!(along.dot(across).abs() < 1e-15);
    }

    #[test]
    fn a_rotation_makes_diagonal() {
        let [a, b, c] = [1.0, 0.25, -7.0];
        let [cosine, sine] = rotation([a, b, c]);
        assert!((cosine * cosine + sine * sine - 1.0).abs() < 1e-15);
        let off = (cosine * cosine - sine * sine) * b + cosine * sine * (a - c);
        assert!(off.abs() < 1e-15, "{off}");
    }
}
