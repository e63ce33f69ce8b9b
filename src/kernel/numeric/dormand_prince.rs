//! One step of Dormand & Prince's method of order five with an error of order four: *A family of embedded
//! Runge-Kutta formulae*, Journal of Computational and Applied Mathematics 6 (1980), RK5(4)7M.

/// A place of a trajectory.
#[derive(Clone, Debug)]
pub(super) struct Step {
    pub(super) place: f64,
    pub(super) state: Vec<f64>,
    pub(super) rate: Vec<f64>,
}

/// Where the rates are asked, as parts of the step.
const PLACES: [f64; 7] = [0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0];

/// What the rates before count in the state at which each one is asked; the last is that of order five.
const COUNTS: [&[f64]; 7] = [
    &[],
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
    &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];

/// What the rates count in the difference of order five from order four.
const DIFFERENCE: [f64; 7] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339_200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

/// A step that was tried.
pub(super) struct TrialStep {
    pub(super) step: Step,
    /// The difference of the two orders.
    difference: Vec<f64>,
    /// The width of the step as a multiple of the time in which the fastest change happens.
    pub(super) stiffness: f64,
}

impl TrialStep {
    /// # Errors
    /// Those of the rate.
    pub(super) fn new<E>(
        rate: &mut impl FnMut(f64, &[f64]) -> Result<Vec<f64>, E>,
        from: &Step,
        to: f64,
    ) -> Result<Self, E> {
        let width = to - from.place;
        let mut rates: Vec<Vec<f64>> = vec![from.rate.clone()];
        let (mut state, mut before) = (from.state.clone(), Vec::new());
        for (counts, part) in COUNTS.iter().zip(PLACES).skip(1) {
            before = std::mem::replace(&mut state, moved(&from.state, width, counts, &rates));
            let place = if part < 1.0 { from.place + part * width } else { to };
            rates.push(rate(place, &state)?);
        }
        let difference = moved(&vec![0.0; state.len()], width, &DIFFERENCE, &rates);
        let [.., sixth, last] = &rates[..] else { unreachable!("there are seven rates") };
        let stiffness = width.abs() * apart(sixth, last) / apart(&before, &state);
        let step = Step { place: to, state, rate: last.clone() };
        Ok(Self { step, difference, stiffness })
    }

    /// The error as a multiple of what it may be, which depends on the size of the state; infinite where
    /// something is no number.
    pub(super) fn error(&self, before: &[f64], allowed: impl Fn(f64) -> f64) -> f64 {
        /// Last bits by which the state is off anyway.
        const BITS: f64 = 8.0;
        let Step { state, rate, .. } = &self.step;
        let mut largest: f64 = 0.0;
        for (i, difference) in self.difference.iter().enumerate() {
            if !(difference.is_finite() && state[i].is_finite() && rate[i].is_finite()) {
                return f64::INFINITY;
            }
            let size = state[i].abs().max(before[i].abs());
            let rounding = BITS * (size.next_up() - size);
            largest = largest.max(difference.abs() / allowed(size).max(rounding));
        }
        largest
    }

    /// By how much the next step is longer than one of this error.
    pub(super) fn growth(error: f64, was_refused: bool) -> f64 {
        const SAFETY: f64 = 0.9;
        const LEAST: f64 = 0.2;
        let most = if was_refused { 1.0 } else { 5.0 };
        // The error goes with the fifth power of the width.
        (SAFETY * libm::pow(error, -0.2)).clamp(LEAST, most)
    }
}

impl Step {
    /// The state at a place between this step and another one: the cubic that has their states and rates.
    pub(super) fn cubic(&self, other: &Self, place: f64) -> Vec<f64> {
        let width = other.place - self.place;
        let s = (place - self.place) / width;
        let r = 1.0 - s;
        let state = |i: usize| {
            r * r * (1.0 + 2.0 * s) * self.state[i]
                + s * s * (1.0 + 2.0 * r) * other.state[i]
                + width * s * r * (r * self.rate[i] - s * other.rate[i])
        };
        (0..self.state.len()).map(state).collect()
    }
}

/// A state that went on with these rates, each as much as it counts.
fn moved(state: &[f64], width: f64, counts: &[f64], rates: &[Vec<f64>]) -> Vec<f64> {
    let rate =
        |i: usize| counts.iter().zip(rates).map(|(count, rate)| count * rate[i]).sum::<f64>();
    state.iter().enumerate().map(|(i, state)| state + width * rate(i)).collect()
}

/// The largest difference of two states.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::{Step, TrialStep};

    /// A place of t³ − 2t and of 1 + t².
    fn place(t: f64) -> Step {
        Step {
            place: t,
            state: vec![t * t * t - 2.0 * t, 1.0 + t * t],
            rate: vec![3.0 * t * t - 2.0, 2.0 * t],
        }
    }

    #[test]
    fn cubics_are_their_own_between_two_steps() {
        for (from, to) in [(-1.0, 2.0), (2.0, -1.0), (0.5, 0.75)] {
            for t in [from, 0.25 * from + 0.75 * to, 0.5 * (from + to), to] {
                for (found, exact) in place(from).cubic(&place(to), t).iter().zip(place(t).state) {
                    assert!((found - exact).abs() < 1e-14, "{from}, {to} at {t}: {found}");
                }
            }
        }
    }

    /// Of y′ = y the state is multiplied by 1 + z + z²/2 + … + z⁵/120 + z⁶/600: Hairer & Wanner, *Solving Ordinary
    /// Differential Equations II*, §IV.2.
    #[test]
    fn growth_is_multiplied_by_the_polynomial_of_the_method() {
        for z in [-1.5_f64, -0.25, 0.5, 2.0] {
            let from = Step { place: 3.0, state: vec![2.0], rate: vec![2.0] };
            let made: Result<TrialStep, ()> =
                TrialStep::new(&mut |_, y| Ok(y.to_vec()), &from, 3.0 + z);
            let found = made.unwrap().step.state[0];
            let factor = (1..=6).rev().fold(1.2, |sum, k| 1.0 + sum * z / f64::from(k));
            assert!((found - 2.0 * factor).abs() < 1e-13, "{z}: {found}");
        }
    }

    #[test]
    fn the_next_step_is_longer_by_the_fifth_root_within_bounds() {
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-14, "{a} is not {b}");
        close(TrialStep::growth(32.0, true), 0.45);
        close(TrialStep::growth(1.0 / 32.0, false), 1.8);
        close(TrialStep::growth(1.0 / 32.0, true), 1.0);
        close(TrialStep::growth(0.0, false), 5.0);
        close(TrialStep::growth(f64::INFINITY, true), 0.2);
    }
}
