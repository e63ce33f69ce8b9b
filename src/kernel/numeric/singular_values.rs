//! Singular values of tall matrices, small ones to their last digits: one-sided Jacobi.
//!
//! Golub & Van Loan, *Matrix Computations*, §8.6.3.

use super::symmetric_eigen::rotation;
use crate::{sorting::sort_by, tolerance::LAST_BIT};

/// Sweeps; ten are enough for all bits.
const SWEEPS: usize = 30;

/// The singular values of a matrix of these columns, the largest first, each with its right vector.
pub(crate) fn singular_values<const N: usize>(mut columns: [Vec<f64>; N]) -> [(f64, [f64; N]); N] {
    let mut right: [[f64; N]; N] = [[0.0; N]; N];
    (0..N).for_each(|i| right[i][i] = 1.0);
    for _ in 0..SWEEPS {
        let mut is_done = true;
        for p in 0..N {
            for q in p + 1..N {
                let [a, b, c] =
                    [(p, p), (q, q), (p, q)].map(|(i, j)| dot(&columns[i], &columns[j]));
                if c.abs() <= LAST_BIT * (a * b).sqrt() {
                    continue;
                }
                is_done = false;
                let turn = rotation([a, c, b]);
                let (before, behind) = columns.split_at_mut(q);
                rotate(&mut before[p], &mut behind[0], turn);
                let (before, behind) = right.split_at_mut(q);
                rotate(&mut before[p], &mut behind[0], turn);
            }
        }
        if is_done {
            break;
        }
    }
    let mut found = std::array::from_fn(|i| (dot(&columns[i], &columns[i]).sqrt(), right[i]));
    sort_by(&mut found, |a, b| b.0.total_cmp(&a.0));
    found
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn rotate(a: &mut [f64], b: &mut [f64], [cosine, sine]: [f64; 2]) {
    for (x, y) in a.iter_mut().zip(b) {
        (*x, *y) = (cosine * *x - sine * *y, sine * *x + cosine * *y);
    }
}

#[cfg(test)]
mod tests {
    use super::singular_values;

    #[test]
    fn small_singular_values_keep_their_digits() {
        // Their product is the determinant, 1.
        let [(large, _), (small, _)] = singular_values::<2>([vec![1e8, 0.0], vec![5e-9, 1e-8]]);
        assert!((large * small - 1.0).abs() < 1e-15, "{large} {small}");
        assert!((small / 1e-8 - 1.0).abs() < 1e-15, "{small}");
    }

    #[test]
    fn a_matrix_without_full_rank_tells_what_it_takes_to_nothing() {
        let [(first, _), (second, right)] = singular_values::<2>([vec![3.0, 0.0], vec![4.0, 0.0]]);
        assert!((first - 5.0).abs() < 1e-15 && second < 1e-15, "{first} {second}");
        assert!((3.0 * right[0] + 4.0 * right[1]).abs() < 1e-14);
    }
}
