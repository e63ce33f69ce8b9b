//! Linear equations whose coefficients stand near the diagonal.

use glam::DVec4;
use smallvec::SmallVec;

/// Coefficients of an equation; up to degree 7 those of a spline need no memory of their own.
pub(crate) type Coefficients = SmallVec<[f64; 8]>;

/// The coefficients of an equation: Σ `values[j]`·x[`first` + j] is given.
#[derive(Clone, Debug)]
pub(crate) struct Equation {
    pub(crate) first: usize,
    pub(crate) values: Coefficients,
}

impl Equation {
    /// Its largest coefficient, without a sign.
    pub(crate) fn largest(&self) -> f64 {
        self.values.iter().fold(0.0_f64, |most, value| most.max(value.abs()))
    }

    /// The equation divided by its largest coefficient: for right-hand sides of zero.
    pub(crate) fn scaled(mut self) -> Self {
        let largest = self.largest();
        if largest > 0.0 {
            self.values.iter_mut().for_each(|value| *value /= largest);
        }
        self
    }

    /// The unknowns that it is about.
    pub(crate) fn columns(&self) -> std::ops::Range<usize> {
        self.first..self.first + self.values.len()
    }

    /// The equation without zeros at either end, which would only widen the band.
    pub(crate) fn without_zeros(mut self) -> Self {
        let is_zero = |value: &f64| value.abs() <= 0.0;
        let n_leading = self.values.iter().take_while(|value| is_zero(value)).count();
        self.values.drain(..n_leading);
        self.first += n_leading;
        let n_trailing = self.values.iter().rev().take_while(|value| is_zero(value)).count();
        self.values.truncate(self.values.len() - n_trailing);
        self
    }
}

/// As many equations as unknowns, factored once for any number of right-hand sides.
///
/// Gaussian elimination inside the band: O(n·b²) once and O(n·b) for each right-hand side. Golub &
/// Van Loan, *Matrix Computations*, §4.3. With row exchanges; without them where the coefficients
/// are totally positive, as those of a spline's points: there they gain nothing. De Boor & Pinkus,
/// *Backward error analysis for totally positive linear systems*, Numer. Math. 27 (1977).
#[derive(Clone, Debug)]
pub(crate) struct BandedSystem {
    /// Coefficients below the diagonal, at most.
    lower: usize,
    /// Length of a row: from `lower` before the diagonal to where exchanges can reach.
    width: usize,
    /// Rows of U, and before the diagonal the factors of the elimination.
    rows: Vec<f64>,
    /// With which row each one was exchanged, where any may be.
    exchanged: Option<Vec<usize>>,
}

impl BandedSystem {
    /// None where the equations contradict or repeat one another.
    pub(crate) fn new(equations: &[Equation]) -> Option<Self> {
        let n = equations.len();
        let below = |(i, equation): (usize, &Equation)| i.saturating_sub(equation.first);
        let above =
            |(i, equation): (usize, &Equation)| equation.columns().end.saturating_sub(i + 1);
        let lower = equations.iter().enumerate().map(below).max().unwrap_or(0);
        let upper = equations.iter().enumerate().map(above).max().unwrap_or(0);
        let rows = equations.iter().map(|equation| (equation.first, &equation.values[..]));
        let width = 2 * lower + upper + 1;
        let exchanged = Some(Vec::with_capacity(n));
        let mut band = Self { lower, width, rows: vec![0.0; n * width], exchanged };
        rows.enumerate().for_each(|(i, (first, values))| band.add(i, first, values));
        band.factored()
    }

    /// So many equations without coefficients, which will be totally positive and reach so far
    /// before and behind the diagonal.
    pub(crate) fn totally_positive(n: usize, [lower, upper]: [usize; 2]) -> Self {
        let width = lower + upper + 1;
        Self { lower, width, rows: vec![0.0; n * width], exchanged: None }
    }

    /// Adds to the coefficients of an equation, from a column on.
    #[inline]
    pub(crate) fn add(&mut self, row: usize, first: usize, values: &[f64]) {
        let place = self.place(row, first);
        for (own, value) in self.rows[place..][..values.len()].iter_mut().zip(values) {
            *own += value;
        }
    }

    /// The equations, ready to be solved; `None` where they contradict or repeat one another.
    pub(crate) fn factored(mut self) -> Option<Self> {
        match self.narrow() {
            Some(Narrow::One) => factor_narrow::<1, 3>(&mut self.rows)?,
            Some(Narrow::Two) => factor_narrow::<2, 5>(&mut self.rows)?,
            None => {
                let n = self.len();
                for k in 0..n {
                    self.eliminate(k, n)?;
                }
            }
        }
        Some(self)
    }

    /// Whether it is one of the bands whose size the compiler knows.
    fn narrow(&self) -> Option<Narrow> {
        match (&self.exchanged, self.lower, self.width) {
            (None, 1, 3) => Some(Narrow::One),
            (None, 2, 5) => Some(Narrow::Two),
            _ => None,
        }
    }

    /// How many unknowns there are.
    pub(crate) fn len(&self) -> usize {
        self.rows.len() / self.width
    }

    fn place(&self, row: usize, column: usize) -> usize {
        row * self.width + self.lower + column - row
    }

    /// Clears column `k` below the diagonal; `n` is how many unknowns there are, which takes a division to ask for.
    fn eliminate(&mut self, k: usize, n: usize) -> Option<()> {
        let last_row = (k + self.lower).min(n - 1);
        let last_column = (k + self.width - 1 - self.lower).min(n - 1);
        if self.exchanged.is_some() {
            self.exchange(k, last_row, last_column);
        }
        let size = self.rows[self.place(k, k)].abs();
        if size.is_nan() || size <= 0.0 {
            return None;
        }
        let n_columns = last_column - k + 1;
        let (above, below) = self.rows.split_at_mut((k + 1) * self.width);
        let pivot = &above[k * self.width + self.lower..][..n_columns];
        for row in k + 1..=last_row {
            let place = (row - k - 1) * self.width + self.lower + k - row;
            let own = &mut below[place..][..n_columns];
            let factor = own[0] / pivot[0];
            own[0] = factor;
            for (value, from) in own[1..].iter_mut().zip(&pivot[1..]) {
                *value -= factor * from;
            }
        }
        Some(())
    }

    /// Makes the largest coefficient of a column that of its own row.
    fn exchange(&mut self, k: usize, last_row: usize, last_column: usize) {
        let size = |row: usize| self.rows[self.place(row, k)].abs();
        let pivot =
            (k..=last_row).fold(k, |best, row| if size(best) < size(row) { row } else { best });
        for column in if pivot == k { 0..0 } else { k..last_column + 1 } {
            let (a, b) = (self.place(k, column), self.place(pivot, column));
            self.rows.swap(a, b);
        }
        self.exchanged.iter_mut().for_each(|exchanged| exchanged.push(pivot));
    }

    /// Replaces the right-hand sides by the unknowns.
    pub(crate) fn solve(&self, values: &mut [DVec4]) {
        match self.narrow() {
            Some(Narrow::One) => return solve_narrow::<1, 3>(&self.rows, values),
            Some(Narrow::Two) => return solve_narrow::<2, 5>(&self.rows, values),
            None => {}
        }
        let n = self.len();
        for k in 0..n {
            if let Some(exchanged) = &self.exchanged {
                values.swap(k, exchanged[k]);
            }
            let value = values[k];
            for (row, later) in (k + 1..).zip(values[k + 1..].iter_mut().take(self.lower)) {
                *later -= self.rows[self.place(row, k)] * value;
            }
        }
        for k in (0..n).rev() {
            let place = self.place(k, k);
            let row = &self.rows[place + 1..place + self.width - self.lower];
            let known = row.iter().zip(&values[k + 1..]);
            let sum =
                known.fold(values[k], |sum, (&coefficient, &value)| sum - coefficient * value);
            values[k] = sum / self.rows[place];
        }
    }
}

/// Bands without exchanges that are as wide before the diagonal as behind it, by that width: those of splines of
/// degree 2 and 3. A size that the compiler knows makes loops faster.
#[derive(Clone, Copy)]
enum Narrow {
    One,
    Two,
}

/// [`BandedSystem::factored`] with LOWER coefficients before the diagonal and behind it, WIDTH together with it.
fn factor_narrow<const LOWER: usize, const WIDTH: usize>(rows: &mut [f64]) -> Option<()> {
    let (rows, _) = rows.as_chunks_mut::<WIDTH>();
    for k in 0..rows.len() {
        let (above, below) = rows.split_at_mut(k + 1);
        let pivot = &above[k];
        let size = pivot[LOWER].abs();
        if size.is_nan() || size <= 0.0 {
            return None;
        }
        for (i, own) in below.iter_mut().take(LOWER).enumerate() {
            let own = &mut own[LOWER - 1 - i..][..=LOWER];
            let factor = own[0] / pivot[LOWER];
            own[0] = factor;
            for j in 1..=LOWER {
                own[j] -= factor * pivot[LOWER + j];
            }
        }
    }
    Some(())
}

/// [`BandedSystem::solve`] of what [`factor_narrow`] made.
fn solve_narrow<const LOWER: usize, const WIDTH: usize>(rows: &[f64], values: &mut [DVec4]) {
    let (rows, _) = rows.as_chunks::<WIDTH>();
    for (k, row) in rows.iter().enumerate() {
        let mut value = values[k];
        for i in LOWER.saturating_sub(k)..LOWER {
            value -= row[i] * values[k + i - LOWER];
        }
        values[k] = value;
    }
    for (k, row) in rows.iter().enumerate().rev() {
        let known = row[LOWER + 1..].iter().zip(&values[k + 1..]);
        let sum = known.fold(values[k], |sum, (&coefficient, &value)| sum - coefficient * value);
        values[k] = sum / row[LOWER];
    }
}

impl BandedSystem {
    /// Replaces the right-hand sides of the transposed equations by the unknowns: what a sum of the unknowns, with the
    /// given factors, grows by with each right-hand side.
    pub(crate) fn solve_transposed(&self, values: &mut [f64]) {
        let n = self.len();
        for k in 0..n {
            let place = self.place(k, k);
            values[k] /= self.rows[place];
            let value = values[k];
            let row = &self.rows[place + 1..place + self.width - self.lower];
            for (later, coefficient) in values[k + 1..].iter_mut().zip(row) {
                *later -= coefficient * value;
            }
        }
        for k in (0..n).rev() {
            let later = k + 1..n.min(k + 1 + self.lower);
            let sum: f64 = later.map(|row| self.rows[self.place(row, k)] * values[row]).sum();
            values[k] -= sum;
            if let Some(exchanged) = &self.exchanged {
                values.swap(k, exchanged[k]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec4;
    use smallvec::smallvec;

    use super::{BandedSystem, Equation};

    #[test]
    fn a_zero_on_the_diagonal_is_exchanged() {
        // y = 2, x + z = 4, x + y = 3.
        let equation = |first, values: &[f64]| Equation { first, values: values.into() };
        let equations =
            [equation(1, &[1.0]), equation(0, &[1.0, 0.0, 1.0]), equation(0, &[1.0, 1.0])];
        let system = BandedSystem::new(&equations).expect("independent equations");
        let mut values = [2.0, 4.0, 3.0].map(DVec4::splat);
        system.solve(&mut values);
        assert_eq!(values, [1.0, 2.0, 3.0].map(DVec4::splat));
    }

    #[test]
    fn transposed_equations_tell_how_sums_grow_with_right_hand_sides() {
        // With exchanges, and without.
        let row = |i: usize| {
            let values = [0.1, 2.0 + i as f64, if i.is_multiple_of(3) { 9.0 } else { 1.0 }, 0.3];
            let first = i.saturating_sub(2);
            Equation { first, values: values[..4.min(8 - first)].into() }
        };
        let equations: Vec<Equation> = (0..8).map(row).collect();
        let exchanging = BandedSystem::new(&equations).expect("independent equations");
        let mut plain = BandedSystem::totally_positive(8, [2, 3]);
        for (i, equation) in equations.iter().enumerate() {
            plain.add(i, equation.first, &equation.values);
        }
        let plain = plain.factored().expect("independent equations");
        for system in [exchanging, plain] {
            for asked in 0..8 {
                let mut growths = vec![0.0; 8];
                growths[asked] = 1.0;
                system.solve_transposed(&mut growths);
                for (given, growth) in growths.iter().enumerate() {
                    let mut values = vec![DVec4::ZERO; 8];
                    values[given] = DVec4::ONE;
                    system.solve(&mut values);
                    assert!((values[asked].x - growth).abs() < 1e-12);
                }
            }
        }
    }

    /// A decaying band on both sides of a diagonal, as wide as `reach`, in room for `wide`.
    fn decaying(n: usize, reach: usize, wide: usize) -> BandedSystem {
        let mut band = BandedSystem::totally_positive(n, [wide; 2]);
        for row in 0..n {
            for column in row.saturating_sub(reach)..n.min(row + reach + 1) {
                let share = libm::exp(-1.7 * row.abs_diff(column) as f64);
                band.add(row, column, &[share * (1.0 + 0.1 * libm::sin((3 * row) as f64))]);
            }
        }
        band.factored().expect("independent equations")
    }

    #[test]
    fn bands_of_a_known_width_are_solved_as_any_other_to_the_last_bit() {
        for (n, reach) in [(1, 1), (2, 1), (9, 1), (1, 2), (2, 2), (3, 2), (9, 2)] {
            let given = |i: usize| DVec4::new(1.0, i as f64, libm::cos(i as f64), -0.3);
            let solved = |wide: usize| {
                let mut values: Vec<DVec4> = (0..n).map(given).collect();
                decaying(n, reach, wide).solve(&mut values);
                values
            };
            assert_eq!(solved(reach), solved(3), "{n} equations, {reach} beside the diagonal");
        }
        let mut open = BandedSystem::totally_positive(3, [1; 2]);
        (0..3).for_each(|row| open.add(row, row, &[if row == 1 { 0.0 } else { 1.0 }]));
        assert!(open.factored().is_none());
    }

    #[test]
    fn equations_that_repeat_one_another_have_no_single_solution() {
        let twice = [
            Equation { first: 0, values: smallvec![1.0, 1.0] },
            Equation { first: 0, values: smallvec![2.0, 2.0] },
        ];
        assert!(BandedSystem::new(&twice).is_none());
    }
}
