//! Where on a curve the points that it passes are to lie.

use glam::DVec3;

use crate::{
    CountError, FitError, GeomError, InputError, frame::norm, tolerance::PARAMETER_RELATIVE,
};

/// A rule for the distance of neighbouring parameters.
///
/// *The NURBS Book*, Ex9.1: chords of 5, 4, 5 and 3 are 17 together.
///
/// ```
/// use virote_kernel::{Parametrization, glam::DVec3};
///
/// let points = [(0.0, 0.0), (3.0, 4.0), (-1.0, 4.0), (-4.0, 0.0), (-4.0, -3.0)];
/// let found = Parametrization::Chord.parameters(&points.map(|(x, y)| DVec3::new(x, y, 0.0)))?;
/// for (parameter, sum) in found.iter().zip([0.0, 5.0, 9.0, 14.0, 17.0]) {
///     assert!((parameter - sum / 17.0).abs() < 1e-15);
/// }
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parametrization {
    /// All the same.
    Uniform,
    /// The distance of the points.
    Chord,
    /// Its square root: Lee, *Choosing nodes in parametric curve interpolation* (1989).
    Centripetal,
    /// The distance of the points, longer beside sharp bends: Foley's rule, in Farin, *Curves and
    /// Surfaces for CAGD*, §9.6.
    Foley,
}

impl Parametrization {
    /// One parameter a point, from 0 to 1.
    ///
    /// # Errors
    /// [`CountError::TooFewPoints`] below two; [`InputError::CoincidentPoints`] for neighbours at
    /// one place, unless the spacing does not ask for their distance; [`InputError::NotFinite`].
    pub fn parameters(self, points: &[DVec3]) -> Result<Vec<f64>, GeomError> {
        let parameters = self.loose_parameters(points)?;
        let same = |pair: &[f64]| pair[1] - pair[0] <= PARAMETER_RELATIVE;
        match parameters.windows(2).position(same) {
            Some(first) => {
                Err(GeomError::Input(InputError::CoincidentPoints { first, second: first + 1 }))
            }
            None => Ok(parameters),
        }
    }

    /// One parameter a point, from 0 to 1, where neighbours at one place may share theirs.
    ///
    /// # Errors
    /// [`CountError::TooFewPoints`] below two; [`InputError::CoincidentPoints`] where all points
    /// are at one place; [`InputError::NotFinite`].
    pub fn loose_parameters(self, points: &[DVec3]) -> Result<Vec<f64>, GeomError> {
        let got = points.len();
        if got < 2 {
            return Err(CountError::TooFewPoints { got, needed: 2 }.into());
        }
        if let Some(index) = points.iter().position(|point| !point.is_finite()) {
            return Err(InputError::NotFinite { what: "point", index }.into());
        }
        let mut parameters = self.steps(points);
        let mut sum = 0.0;
        for place in &mut parameters {
            sum += *place;
            *place = sum;
        }
        if sum <= 0.0 {
            return Err(InputError::CoincidentPoints { first: 0, second: 1 }.into());
        }
        if !sum.is_finite() {
            return Err(InputError::NotFinite { what: "distance to point", index: got - 1 }.into());
        }
        parameters.iter_mut().for_each(|place| *place /= sum);
        Ok(parameters)
    }

    /// Distances of the parameters from those before, up to a common factor; the first is zero.
    fn steps(self, points: &[DVec3]) -> Vec<f64> {
        let mut steps = Vec::with_capacity(points.len());
        steps.push(0.0);
        steps.extend(points.windows(2).map(|pair| norm(pair[1] - pair[0])));
        let own = &mut steps[1..];
        match self {
            Self::Uniform => own.fill(1.0),
            Self::Chord => {}
            Self::Centripetal => own.iter_mut().for_each(|step| *step = step.sqrt()),
            Self::Foley => {
                let chords = own.to_vec();
                let bends: Vec<f64> = points.windows(3).map(bend).collect();
                let longer = |(i, step): (usize, &mut f64)| *step = foley_step(&chords, &bends, i);
                own.iter_mut().enumerate().for_each(longer);
            }
        }
        steps
    }
}

/// How far three points turn at the middle one, at most a quarter turn; radians.
fn bend(points: &[DVec3]) -> f64 {
    let [before, after] = [points[1] - points[0], points[2] - points[1]];
    let turn = libm::atan2(before.cross(after).length(), before.dot(after));
    turn.min(std::f64::consts::FRAC_PI_2)
}

/// Chord `i`, and more for the bends at its ends.
fn foley_step(chords: &[f64], bends: &[f64], i: usize) -> f64 {
    let own = chords[i];
    let share = |bend: usize, other: usize| {
        let other = chords[other];
        if own + other > 0.0 { 1.5 * bends[bend] * other / (own + other) } else { 0.0 }
    };
    let before = if i > 0 { share(i - 1, i - 1) } else { 0.0 };
    let after = if i + 1 < chords.len() { share(i, i + 1) } else { 0.0 };
    own * (1.0 + before + after)
}

/// # Errors
/// [`CountError::WrongCount`] unless there are `needed`; [`InputError::NotFinite`];
/// [`FitError::ParametersNotIncreasing`].
pub fn check_parameters(parameters: &[f64], needed: usize) -> Result<(), GeomError> {
    let got = parameters.len();
    if got != needed {
        return Err(CountError::WrongCount { what: "parameters", needed, got }.into());
    }
    if let Some(index) = parameters.iter().position(|parameter| !parameter.is_finite()) {
        return Err(InputError::NotFinite { what: "parameter", index }.into());
    }
    let length = parameters.last().zip(parameters.first()).map_or(0.0, |(end, start)| end - start);
    let same = PARAMETER_RELATIVE * length.abs();
    match parameters.windows(2).position(|pair| pair[1] - pair[0] <= same) {
        Some(i) => {
            let (previous, parameter) = (parameters[i], parameters[i + 1]);
            Err(GeomError::Fit(FitError::ParametersNotIncreasing {
                index: i + 1,
                previous,
                parameter,
            }))
        }
        None => Ok(()),
    }
}

/// A fit begins at the first parameter and ends at the last.
///
/// # Errors
/// [`CountError::TooFewPoints`] below two.
pub(super) fn check_ends(parameters: &[f64]) -> Result<(), GeomError> {
    match parameters.len() {
        got @ 0..2 => Err(CountError::TooFewPoints { got, needed: 2 }.into()),
        _ => Ok(()),
    }
}

/// One parameter for each of `needed` points, none before the one in front of it; neighbours may share theirs.
///
/// # Errors
/// [`CountError::WrongCount`], [`CountError::TooFewPoints`] below two, [`InputError::NotFinite`],
/// [`FitError::ParametersNotIncreasing`].
pub(super) fn check_loose_parameters(parameters: &[f64], needed: usize) -> Result<(), GeomError> {
    let got = parameters.len();
    if got != needed {
        return Err(CountError::WrongCount { what: "parameters", needed, got }.into());
    }
    check_ends(parameters)?;
    if let Some(index) = parameters.iter().position(|parameter| !parameter.is_finite()) {
        return Err(InputError::NotFinite { what: "parameter", index }.into());
    }
    match parameters.windows(2).position(|pair| pair[1] < pair[0]) {
        Some(i) => {
            let (previous, parameter) = (parameters[i], parameters[i + 1]);
            let index = i + 1;
            Err(FitError::ParametersNotIncreasing { index, previous, parameter }.into())
        }
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::Parametrization;

    #[track_caller]
    fn check(spacing: Parametrization, points: &[[f64; 3]], expected: &[f64]) {
        let points: Vec<DVec3> = points.iter().copied().map(DVec3::from_array).collect();
        let found = spacing.parameters(&points).expect("points apart");
        let differs = |(a, b): (&f64, &f64)| (a - b).abs() > 1e-15;
        assert!(!found.iter().zip(expected).any(differs), "{found:?} for {expected:?}");
    }

    #[test]
    fn chords_of_one_and_three_divide_at_a_quarter() {
        let points = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 3.0, 0.0]];
        check(Parametrization::Chord, &points, &[0.0, 0.25, 1.0]);
        check(Parametrization::Uniform, &points, &[0.0, 0.5, 1.0]);
        check(Parametrization::Centripetal, &points, &[0.0, 1.0 / (1.0 + f64::sqrt(3.0)), 1.0]);
    }

    #[test]
    fn foley_adds_for_a_quarter_turn() {
        // Chords 1 and 3 with a quarter turn between: 1 + 3/2 · π/2 · 3/4, 3 (1 + 3/2 · π/2 · 1/4).
        let points = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 3.0, 0.0]];
        let pi = std::f64::consts::PI;
        let (first, second) = (1.0 + pi * 9.0 / 16.0, 3.0 * (1.0 + pi * 3.0 / 16.0));
        check(Parametrization::Foley, &points, &[0.0, first / (first + second), 1.0]);
        // On a straight line it is the chord length.
        let line = [[0.0; 3], [1.0, 0.0, 0.0], [4.0, 0.0, 0.0]];
        check(Parametrization::Foley, &line, &[0.0, 0.25, 1.0]);
    }
}
