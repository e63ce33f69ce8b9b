//! Linear equations whose coefficients stand near the diagonal of a ring.

use glam::DVec4;

use super::{banded::BandedSystem, equation::Equation};
use crate::GeomError;

/// As many equations as unknowns, where the unknown after the last is the first.
///
/// The last few unknowns are taken out, so that the rest is a band; they follow from what is left
/// of their own equations (block elimination). Golub & Van Loan, *Matrix Computations*, §3.2.
#[derive(Clone, Debug)]
pub(super) struct CyclicSystem {
    /// The equations of the first unknowns among themselves.
    band: BandedSystem,
    /// How the first unknowns answer to each of the last ones: `[unknown][last / 4]`, four a vector.
    answers: Vec<Vec<DVec4>>,
    /// The first unknowns' part of the last equations.
    last: Vec<Vec<(usize, f64)>>,
    /// What is left of the last equations for the last unknowns.
    rest: BandedSystem,
}

impl CyclicSystem {
    /// The equations, the i-th of which is about unknowns up to `reach` from the i-th; columns
    /// count modulo their number.
    ///
    /// # Errors
    /// `FitError::NoFit` where the equations contradict or repeat one another.
    pub(super) fn new(equations: &[Equation], reach: usize) -> Result<Self, GeomError> {
        let n = equations.len();
        let n_first = n - reach;
        let mut inside: Vec<Equation> = Vec::with_capacity(n_first);
        let mut coupling = vec![vec![0.0; reach]; n_first];
        for (i, equation) in equations[..n_first].iter().enumerate() {
            let mut own =
                Equation { first: i.saturating_sub(reach), values: vec![0.0; 2 * reach + 1] };
            for (column, &value) in equation.columns().zip(&equation.values) {
                match column % n {
                    column if column < n_first => own.values[column - own.first] += value,
                    column => coupling[i][column - n_first] += value,
                }
            }
            own.values.truncate((n_first - own.first).min(2 * reach + 1));
            inside.push(own);
        }
        let band = BandedSystem::new(&inside)?;

        // Let each of the last unknowns be one in turn.
        let mut answers: Vec<Vec<DVec4>> = Vec::new();
        for four in 0..reach.div_ceil(4) {
            let part = |row: &Vec<f64>| {
                DVec4::from_array(std::array::from_fn(|k| {
                    row.get(4 * four + k).copied().unwrap_or(0.0)
                }))
            };
            let mut column: Vec<DVec4> = coupling.iter().map(part).collect();
            band.solve(&mut column);
            answers.push(column);
        }

        let mut last = vec![Vec::new(); reach];
        let mut rest = vec![Equation { first: 0, values: vec![0.0; reach] }; reach];
        for (k, equation) in equations[n_first..].iter().enumerate() {
            for (column, &value) in equation.columns().zip(&equation.values) {
                match column % n {
                    column if column < n_first => {
                        last[k].push((column, value));
                        for (j, coefficient) in rest[k].values.iter_mut().enumerate() {
                            *coefficient -= value * answers[j / 4][column][j % 4];
                        }
                    }
                    column => rest[k].values[column - n_first] += value,
                }
            }
        }
        Ok(Self { band, answers, last, rest: BandedSystem::new(&rest)? })
    }

    /// Replaces the right-hand sides by the unknowns.
    pub(super) fn solve(&self, values: &mut [DVec4]) {
        let (first, last) = values.split_at_mut(self.band.len());
        self.band.solve(first);
        for (value, own) in last.iter_mut().zip(&self.last) {
            for &(column, coefficient) in own {
                *value -= coefficient * first[column];
            }
        }
        self.rest.solve(last);
        for (i, value) in first.iter_mut().enumerate() {
            for (j, &unknown) in last.iter().enumerate() {
                *value -= self.answers[j / 4][i][j % 4] * unknown;
            }
        }
    }
}
