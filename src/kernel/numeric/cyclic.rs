//! Linear equations whose coefficients stand near the diagonal of a ring.

use glam::DVec4;
use smallvec::smallvec;

use super::banded::{BandedSystem, Equation};

/// As many equations as unknowns, where the unknown after the last is the first.
///
/// The last few unknowns are taken out, so that the rest is a band; they follow from what is left
/// of their own equations (block elimination). Golub & Van Loan, *Matrix Computations*, §3.2.
#[derive(Clone, Debug)]
pub(crate) struct CyclicSystem {
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
    /// count modulo their number. None where they contradict or repeat one another.
    pub(crate) fn new(equations: &[Equation], reach: usize) -> Option<Self> {
        let n = equations.len();
        let n_first = n - reach;
        let mut inside: Vec<Equation> = Vec::with_capacity(n_first);
        let mut coupling = vec![vec![0.0; reach]; n_first];
        for (i, equation) in equations[..n_first].iter().enumerate() {
            let mut own =
                Equation { first: i.saturating_sub(reach), values: smallvec![0.0; 2 * reach + 1] };
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
        let mut rest = vec![Equation { first: 0, values: smallvec![0.0; reach] }; reach];
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
        Some(Self { band, answers, last, rest: BandedSystem::new(&rest)? })
    }

    /// Replaces the right-hand sides by the unknowns.
    pub(crate) fn solve(&self, values: &mut [DVec4]) {
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

#[cfg(test)]
mod tests {
    use glam::DVec4;
    use smallvec::smallvec;

    use super::{BandedSystem, CyclicSystem, Equation};

    /// The equations a·x[i − 1] + b·x[i] + c·x[i + 1], around.
    fn ring(n: usize) -> Vec<Equation> {
        let row =
            |i: usize| Equation { first: n + i - 1, values: smallvec![1.0, 4.0 + i as f64, 2.0] };
        (0..n).map(row).collect()
    }

    #[test]
    fn unknowns_fulfil_their_equations_over_the_seam() {
        for n in 3..12 {
            let wanted: Vec<f64> = (0..n).map(|i| (i * i) as f64 - 7.0).collect();
            let equations = ring(n);
            let right = |equation: &Equation| -> f64 {
                equation.columns().zip(&equation.values).map(|(i, a)| a * wanted[i % n]).sum()
            };
            let mut values: Vec<DVec4> =
                equations.iter().map(|equation| DVec4::splat(right(equation))).collect();
            let system = CyclicSystem::new(&equations, 1).expect("independent equations");
            system.solve(&mut values);
            for (found, wanted) in values.iter().zip(&wanted) {
                assert!((found.x - wanted).abs() < 1e-12, "{found} for {wanted} of {n}");
            }
        }
    }

    #[test]
    fn a_ring_without_coupling_over_the_seam_is_a_band() {
        let rows = |first: usize| -> Vec<Equation> {
            (0..5).map(|i| Equation { first: first + i, values: smallvec![3.0] }).collect()
        };
        let (mut around, mut along) = (vec![DVec4::splat(6.0); 5], vec![DVec4::splat(6.0); 5]);
        CyclicSystem::new(&rows(5), 1).expect("a diagonal").solve(&mut around);
        BandedSystem::new(&rows(0)).expect("a diagonal").solve(&mut along);
        assert_eq!(around, along);
    }
}
