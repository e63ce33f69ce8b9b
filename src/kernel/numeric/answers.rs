//! What several functions of several unknowns answer, with derivatives or without.

use crate::tolerance::{
    DIFFERENCE_RELATIVE, KINK_ROUNDINGS, KINK_SIDE_RELATIVE, KINK_UNLIKE_RELATIVE, LAST_BIT,
};

/// What functions are asked for at a place.
///
/// ```
/// use virote_kernel::{Answers, Wanted, find_least_squares};
///
/// let functions = |x: &[f64], wanted| {
///     let gradients = (wanted == Wanted::Gradients).then(|| vec![vec![2.0 * x[0]]]);
///     Ok::<_, ()>(Answers { values: vec![x[0] * x[0] - 2.0], gradients })
/// };
/// let found = find_least_squares(functions, &[1.0], &[])?;
/// assert!((found.unknowns[0] - 2_f64.sqrt()).abs() < 1e-15);
/// # Ok::<(), ()>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// Values alone.
    Values,
    /// Values and, where the functions have them, derivatives.
    Gradients,
}

/// What several functions answer at one place.
///
/// ```
/// use virote_kernel::Answers;
///
/// let answers = Answers::from(vec![1.0, 2.0]);
/// assert!(answers.gradients.is_none());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Answers {
    /// The values.
    pub values: Vec<f64>,
    /// The derivatives of each function by all unknowns; none where they were not wanted, or where the
    /// functions have none.
    pub gradients: Option<Vec<Vec<f64>>>,
}

impl From<Vec<f64>> for Answers {
    fn from(values: Vec<f64>) -> Self {
        Self { values, gradients: None }
    }
}

/// Functions that are asked, and how often they were.
pub(super) struct CountedFunctions<F> {
    functions: F,
    /// Questions for values and for gradients together.
    pub(super) n_evaluations: usize,
    /// Whether derivatives were taken by differences.
    pub(super) has_differences: bool,
    /// The part of each unknown's size over which they are.
    pub(super) reach: f64,
    /// By how much the slopes differ on both sides of where the last differences were taken, of each function by each
    /// unknown: nothing where that is rounding.
    pub(super) jumps: Vec<Vec<f64>>,
    /// The sizes of the unknowns, if told: beside them zero but for rounding is zero.
    pub(super) sizes: Vec<f64>,
    /// Whether the functions had none where they were asked for some beside a place without.
    is_without: bool,
}

impl<F> CountedFunctions<F> {
    pub(super) fn new(functions: F) -> Self {
        let reach = DIFFERENCE_RELATIVE;
        Self {
            functions,
            n_evaluations: 0,
            has_differences: false,
            reach,
            jumps: Vec::new(),
            sizes: Vec::new(),
            is_without: false,
        }
    }

    /// The values at a place.
    pub(super) fn values<E>(&mut self, place: &[f64]) -> Result<Vec<f64>, E>
    where
        F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
    {
        self.n_evaluations += 1;
        (self.functions)(place, Wanted::Values).map(|answers| answers.values)
    }

    /// The gradient of each function at a place: the functions' own; at a kink, where they have none, those of one of its
    /// sides; or by differences over a part of each unknown's size on both sides, or on one where the other is outside of
    /// its bounds or has no value.
    pub(super) fn gradients<E>(
        &mut self,
        place: &[f64],
        bounds: &[[f64; 2]],
    ) -> Result<Vec<Vec<f64>>, E>
    where
        F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
    {
        self.n_evaluations += 1;
        let own = (self.functions)(place, Wanted::Gradients)?;
        if let Some(gradients) = own.gradients {
            return Ok(gradients);
        }
        if !self.is_without {
            self.n_evaluations += 1;
            let side = beside(place, bounds, KINK_SIDE_RELATIVE, self.n_evaluations);
            match (self.functions)(&side, Wanted::Gradients) {
                Ok(Answers { gradients: Some(gradients), .. }) => return Ok(gradients),
                _ => self.is_without = true,
            }
        }
        self.has_differences = true;
        self.jumps = vec![vec![0.0; place.len()]; own.values.len()];
        let size = place.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let size = if 0.0 < size { size } else { 1.0 };
        let sizes = std::mem::take(&mut self.sizes);
        let mut beside = place.to_vec();
        let mut gradients = vec![vec![0.0; place.len()]; own.values.len()];
        for (k, &x) in place.iter().enumerate() {
            let least = sizes.get(k).map_or(0.0, |size| LAST_BIT.sqrt() * size);
            let size = least.max(libm::cbrt(DIFFERENCE_RELATIVE) * size);
            let reach = self.reach * x.abs().max(size);
            let [least, most] = bounds.get(k).copied().unwrap_or([-f64::INFINITY, f64::INFINITY]);
            let [low, high] = [(x - reach).max(least), (x + reach).min(most)];
            beside[k] = low;
            let before = self.values(&beside)?;
            beside[k] = high;
            let behind = self.values(&beside)?;
            beside[k] = x;
            let sides = behind.iter().zip(&before).zip(&own.values);
            let told = gradients.iter_mut().zip(&mut self.jumps);
            for ((gradient, jumps), ((&behind, &before), &here)) in told.zip(sides) {
                // On one side alone where the other has no value.
                let [low, before] = if before.is_finite() { [low, before] } else { [x, here] };
                let [high, behind] = if behind.is_finite() { [high, behind] } else { [x, here] };
                gradient[k] = if low < high { (behind - before) / (high - low) } else { 0.0 };
                if low < x && x < high {
                    jumps[k] = 2.0 * jump([here - before, behind - here], here) / (high - low);
                }
            }
        }
        self.sizes = sizes;
        Ok(gradients)
    }
}

/// By how much a function changes otherwise behind a place than before; nothing where that is rounding, or little beside
/// either.
fn jump([before, behind]: [f64; 2], here: f64) -> f64 {
    let (rounding, jump) = (KINK_ROUNDINGS * LAST_BIT * here.abs(), (behind - before).abs());
    let little = KINK_UNLIKE_RELATIVE * before.abs().max(behind.abs());
    if little + rounding < jump { jump } else { 0.0 }
}

/// A place beside another one within bounds, by a part of each unknown's size, and of each by another one: so what unknowns
/// are beside together, as kinks along diagonals, is left as well. To other sides at each turn.
pub(super) fn beside(place: &[f64], bounds: &[[f64; 2]], part: f64, turn: usize) -> Vec<f64> {
    let most = place.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let most = if 0.0 < most { most } else { 1.0 };
    let shifted = place.iter().enumerate().map(|(k, &x)| {
        let size = x.abs().max(libm::cbrt(DIFFERENCE_RELATIVE) * most);
        let side = libm::sin(3.0 * k as f64 + 0.7 * turn as f64);
        let [low, high] = bounds.get(k).copied().unwrap_or([-f64::INFINITY, f64::INFINITY]);
        (x + part * size * (0.7 + 0.3 * side.abs()).copysign(side)).max(low).min(high)
    });
    shifted.collect()
}
