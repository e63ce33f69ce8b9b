//! Symmetric linear equations whose coefficients stand near the diagonal.

use glam::DMat3;

/// Symmetric equations whose coefficients stand near the diagonal.
#[derive(Clone, Debug)]
pub(crate) struct SymmetricBand {
    width: usize,
    /// Rows from the diagonal on.
    rows: Vec<f64>,
}

impl SymmetricBand {
    /// So many equations without coefficients, each with room for `width` from the diagonal on.
    pub(crate) fn new(n: usize, width: usize) -> Self {
        Self { width, rows: vec![0.0; n * width] }
    }

    /// Sets a coefficient, its column not before its row.
    pub(crate) fn set(&mut self, row: usize, column: usize, value: f64) {
        self.rows[row * self.width + column - row] = value;
    }

    /// Adds a symmetric block at a row and a column, no column before the row.
    pub(crate) fn add(&mut self, row: usize, column: usize, block: DMat3) {
        for i in 0..3 {
            for j in if row == column { i } else { 0 }..3 {
                self.rows[(row + i) * self.width + column + j - row - i] += block.col(j)[i];
            }
        }
    }

    /// Replaces the right-hand side by the unknowns: elimination without exchanges, Golub & Van
    /// Loan, *Matrix Computations*, §4.3. `None` unless the equations are positive definite.
    pub(crate) fn solve(mut self, values: &mut [f64]) -> Option<()> {
        let (n, width) = (values.len(), self.width);
        for k in 0..n {
            let reach = width.min(n - k);
            let (done, rest) = self.rows.split_at_mut((k + 1) * width);
            let row = &done[k * width..][..reach];
            if row[0].is_nan() || row[0] <= 0.0 {
                return None;
            }
            for i in 1..reach {
                let factor = row[i] / row[0];
                values[k + i] -= factor * values[k];
                let later = &mut rest[(i - 1) * width..][..reach - i];
                for (to, from) in later.iter_mut().zip(&row[i..]) {
                    *to -= factor * from;
                }
            }
        }
        for k in (0..n).rev() {
            let row = &self.rows[k * width..][..width.min(n - k)];
            let known: f64 = row[1..].iter().zip(&values[k + 1..]).map(|(a, b)| a * b).sum();
            values[k] = (values[k] - known) / row[0];
        }
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, DVec3};

    use super::SymmetricBand;

    #[test]
    fn blocks_are_added_and_the_equations_solved() {
        let diagonal = DMat3::from_diagonal(DVec3::new(5.0, 6.0, 7.0));
        let beside = DMat3::from_cols(DVec3::X, DVec3::new(2.0, 1.0, 0.0), DVec3::Z);
        let mut band = SymmetricBand::new(6, 6);
        band.add(0, 0, diagonal);
        band.add(3, 3, diagonal);
        band.add(0, 3, beside);
        let wanted = [DVec3::new(1.0, -2.0, 3.0), DVec3::new(4.0, 0.5, -1.0)];
        let right = [
            diagonal * wanted[0] + beside * wanted[1],
            beside.transpose() * wanted[0] + diagonal * wanted[1],
        ];
        let mut values: Vec<f64> = right.iter().flat_map(DVec3::to_array).collect();
        band.solve(&mut values).expect("positive definite");
        for (part, wanted) in values.chunks_exact(3).zip(wanted) {
            assert!((DVec3::from_slice(part) - wanted).length() < 1e-14, "{values:?}");
        }
    }

    /// Blocks that differ and reach into one another, in a band and in a matrix that is full.
    #[test]
    fn solutions_fulfil_the_equations() {
        let number = |i: usize, k: usize| libm::sin((7 * i + 3 * k) as f64);
        let block =
            |i: usize| DMat3::from_cols_array(&[0, 1, 2, 3, 4, 5, 6, 7, 8].map(|k| number(i, k)));
        for (n, width) in [(5, 6), (4, 12)] {
            let mut band = SymmetricBand::new(3 * n, width);
            let wanted: Vec<DVec3> = (0..n).map(|i| block(i).x_axis).collect();
            let mut right = vec![DVec3::ZERO; n];
            for i in 0..n {
                let own =
                    DMat3::from_diagonal(DVec3::splat(20.0)) + block(i) + block(i).transpose();
                band.add(3 * i, 3 * i, own);
                right[i] += own * wanted[i];
                for k in i + 1..n.min(i + width / 3) {
                    let beside = block(n * i + k);
                    band.add(3 * i, 3 * k, beside);
                    right[i] += beside * wanted[k];
                    right[k] += beside.transpose() * wanted[i];
                }
            }
            let mut values: Vec<f64> = right.iter().flat_map(DVec3::to_array).collect();
            band.solve(&mut values).expect("positive definite");
            for (part, wanted) in values.chunks_exact(3).zip(wanted) {
                assert!((DVec3::from_slice(part) - wanted).length() < 1e-12, "{width}: {values:?}");
            }
        }
    }

    #[test]
    fn what_is_not_positive_definite_is_refused() {
        let mut band = SymmetricBand::new(3, 3);
        band.add(0, 0, DMat3::from_diagonal(DVec3::new(1.0, -1.0, 1.0)));
        assert_eq!(band.solve(&mut [1.0; 3]), None);
    }
}
