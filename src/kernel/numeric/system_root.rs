//! Unknowns for which several functions are zero together, whatever units these have.

use super::{
    answers::{Answers, CountedFunctions, Wanted},
    least_squares::{LeastSquares, find_least_squares, largest},
};
use crate::tolerance::{SYSTEM_ROOT_RELATIVE, SYSTEM_STEP_RELATIVE};

impl LeastSquares {
    /// Whether next to nothing is left of what the functions were at the start, and one more step would lead nowhere.
    pub fn is_root(&self) -> bool {
        self.is_small() && self.rest <= SYSTEM_STEP_RELATIVE
    }

    /// Whether next to nothing is left of what the functions were at the start.
    pub fn is_small(&self) -> bool {
        largest(&self.residuals) <= SYSTEM_ROOT_RELATIVE * largest(&self.first_residuals)
    }
}

/// Functions as a search asks for them.
type Asked<'a, E> = &'a mut dyn FnMut(&[f64], Wanted) -> Result<Answers, E>;

/// Unknowns near a start for which several functions are zero, or, where there are more functions than unknowns, least
/// in their squares: those of [`find_least_squares`]. Beside functions that are many powers of ten larger, others hardly
/// count in a sum of squares; so, where no root comes out of that, it begins once more with each function in a unit of
/// its own, which is how much it changes with the unknowns' sizes at the start.
///
/// ```
/// use virote_kernel::find_system_root;
///
/// // x + x³ = 2 and eʸ = e·x, the one in billions, the other in billionths.
/// let mixed = |x: &[f64], _| {
///     let [a, b] = [x[0] + x[0] * x[0] * x[0] - 2.0, x[1].exp() - x[0] * 1_f64.exp()];
///     Ok::<_, ()>(vec![1e9 * a, 1e-9 * b].into())
/// };
/// let found = find_system_root(mixed, &[1.5, 0.5], &[])?;
/// assert!(found.is_root() && found.unknowns.iter().all(|x| (x - 1.0).abs() < 1e-9));
/// # Ok::<(), ()>(())
/// ```
///
/// # Errors
/// Those of the functions.
pub fn find_system_root<E>(
    mut functions: impl FnMut(&[f64], Wanted) -> Result<Answers, E>,
    start: &[f64],
    bounds: &[[f64; 2]],
) -> Result<LeastSquares, E> {
    root(&mut functions, start, bounds)
}

/// [`find_system_root`], compiled once for all functions with the same errors.
fn root<E>(functions: Asked<'_, E>, start: &[f64], bounds: &[[f64; 2]]) -> Result<LeastSquares, E> {
    let found = find_least_squares(&mut *functions, start, bounds)?;
    if found.is_root() || start.len() < found.residuals.len() {
        return Ok(found);
    }
    let units = units(functions, &found.first_residuals, start, bounds)?;
    let mut in_units = |place: &[f64], wanted: Wanted| {
        functions(place, wanted).map(|answers| divided(answers, &units))
    };
    let asked: Asked<'_, E> = &mut in_units;
    let again = find_least_squares(asked, start, bounds)?;
    if !again.is_root() {
        return Ok(found);
    }
    let residuals = again.residuals.iter().zip(&units).map(|(value, unit)| value * unit).collect();
    Ok(LeastSquares {
        residuals,
        first_residuals: found.first_residuals,
        n_evaluations: found.n_evaluations + again.n_evaluations,
        ..again
    })
}

/// By how much each function changes with the sizes of the unknowns at the start; where it does not, what it is there.
fn units<E>(
    functions: Asked<'_, E>,
    values: &[f64],
    start: &[f64],
    bounds: &[[f64; 2]],
) -> Result<Vec<f64>, E> {
    let gradients = CountedFunctions::new(functions).gradients(start, bounds)?;
    let most = largest(start);
    let size = |x: &f64| match () {
        () if 0.0 < x.abs() => x.abs(),
        () if 0.0 < most => most,
        () => 1.0,
    };
    let is_unit = |unit: &f64| 0.0 < *unit && unit.is_finite();
    let unit = |(gradient, value): (&Vec<f64>, &f64)| {
        let changes = gradient.iter().zip(start).map(|(slope, x)| (slope * size(x)).abs());
        let change = changes.fold(0.0, f64::max);
        [change, value.abs()].into_iter().find(is_unit).unwrap_or(1.0)
    };
    Ok(gradients.iter().zip(values).map(unit).collect())
}

/// Values and slopes in units of their functions.
fn divided(mut answers: Answers, units: &[f64]) -> Answers {
    answers.values.iter_mut().zip(units).for_each(|(value, unit)| *value /= unit);
    for (gradient, unit) in answers.gradients.iter_mut().flatten().zip(units) {
        gradient.iter_mut().for_each(|slope| *slope /= unit);
    }
    answers
}

#[cfg(test)]
mod tests {
    use super::{Answers, LeastSquares, find_system_root};

    /// The root near (1.1, -0.4, 2.1) of three functions at (1, -1/2, 2), in units.
    fn found(units: [f64; 3]) -> LeastSquares {
        let functions = |x: &[f64], _| {
            let [x, y, z] = [x[0], x[1], x[2]];
            let values = [
                x + x * x * x - 2.0 + 0.2 * (y + 0.5),
                libm::exp(y) - libm::exp(-0.5) + 0.1 * (x - 1.0),
                z + libm::sin(z) - 2.0 - libm::sin(2.0) + 0.3 * (x - 1.0) * y,
            ];
            let gradients = [
                [1.0 + 3.0 * x * x, 0.2, 0.0],
                [0.1, libm::exp(y), 0.0],
                [0.3 * y, 0.3 * (x - 1.0), 1.0 + libm::cos(z)],
            ];
            let values = values.iter().zip(units).map(|(value, unit)| value * unit).collect();
            let gradients = gradients.iter().zip(units);
            let gradients = gradients.map(|(row, unit)| row.map(|slope| slope * unit).to_vec());
            Ok::<_, ()>(Answers { values, gradients: Some(gradients.collect()) })
        };
        find_system_root(functions, &[1.3, -0.2, 2.3], &[]).expect("no failure")
    }

    #[test]
    fn units_of_functions_move_no_root() {
        let cases =
            [[1.0, 1.0, 1.0], [1e9, 1.0, 1e-9], [1e-9, 1e9, 1.0], [1.0, 1e-12, 1e12], [1e-30; 3]];
        for units in cases {
            let found = found(units);
            let off = |(x, root): (&f64, f64)| (x - root).abs();
            let off = found.unknowns.iter().zip([1.0, -0.5, 2.0]).map(off).fold(0.0, f64::max);
            assert!(found.is_root() && off < 1e-12, "{found:?} with {units:?}");
            let small = |(value, unit): (&f64, f64)| value.abs() <= 1e-12 * unit;
            assert!(found.residuals.iter().zip(units).all(small), "{found:?} with {units:?}");
        }
    }

    #[test]
    fn what_has_no_root_in_any_units_has_none() {
        let none = |x: &[f64], _| {
            Ok::<_, ()>(vec![1e6 * (x[0] * x[0] + 1.0), 1e-6 * (x[1] - x[0])].into())
        };
        assert!(!find_system_root(none, &[3.0, 1.0], &[]).expect("no failure").is_root());
        // More functions than unknowns keep their weights: the mean of 0 and 1 with weights 1 and 4.
        let mean = |x: &[f64], _| Ok::<_, ()>(vec![x[0], 2.0 * (x[0] - 1.0)].into());
        let found = find_system_root(mean, &[3.0], &[]).expect("no failure");
        assert!((found.unknowns[0] - 0.8).abs() < 1e-9, "{found:?}");
    }
}
