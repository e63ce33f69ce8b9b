//! Singular values of tall matrices, small ones to their last digits: one-sided Jacobi.
//!
//! Golub & Van Loan, *Matrix Computations*, §8.6.3.

use crate::tolerance::LAST_BIT;

/// Sweeps; ten are enough for all bits.
const SWEEPS: usize = 30;

/// The singular values of a matrix of these columns, the largest first, each with its right vector.
pub(super) fn singular_values<const N: usize>(mut columns: [Vec<f64>; N]) -> [(f64, [f64; N]); N] {
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
                let ratio = 0.5 * (b - a) / c;
                let tangent = 1.0_f64.copysign(ratio) / (ratio.abs() + libm::hypot(ratio, 1.0));
                let cosine = 1.0 / libm::hypot(tangent, 1.0);
                let turn = [cosine, tangent * cosine];
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
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
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
