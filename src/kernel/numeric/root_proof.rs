//! Which intervals hold a root, beyond doubt.

use super::{
    enclosure::Enclosure,
    open_root::{OpenRoot, roots_in_open, told_apart},
    root::find_root,
    root_error::RootError,
    sample::Sample,
};
use crate::{ceiling::PROOF_PIECES, sorting::sort_by, tolerance::PROOF_WIDTH_RELATIVE, work};

/// What bounds of a function's values and slopes tell of its roots.
///
/// ```
/// use virote_kernel::{Enclosure, RootProof};
///
/// // x² − 2 between −3 and 3.
/// let square = |x| {
///     let x = Enclosure::variable(x);
///     Some(x.times(&x).plus(&Enclosure::constant(-2.0)))
/// };
/// let proof = RootProof::of(square, [-3.0, 3.0]);
/// assert!(proof.is_whole() && proof.brackets.len() == 2);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct RootProof {
    /// Intervals with exactly one root each, in order.
    pub brackets: Vec<[f64; 2]>,
    /// Intervals of which bounds do not tell whether they hold roots, in order; none where the work was not carried
    /// to its end.
    pub open: Option<Vec<[f64; 2]>>,
}

/// A stretch in which the function grows, or falls, all the way.
struct Monotone {
    interval: [f64; 2],
    is_growing: bool,
}

impl RootProof {
    /// Whether there are no other roots than one in each bracket.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.open.as_ref().is_some_and(Vec::is_empty)
    }

    /// Divides an interval until each part has no root, since the bounds of its values keep off zero, or one
    /// at most, since those of its slopes do. Moore, Kearfott & Cloud, *Introduction to Interval Analysis*,
    /// §8.1.
    pub fn of(
        mut function: impl FnMut([f64; 2]) -> Option<Enclosure>,
        [start, end]: [f64; 2],
    ) -> Self {
        let mut waiting = vec![[start, end]];
        let mut stretches: Vec<Monotone> = Vec::new();
        let mut open: Vec<[f64; 2]> = Vec::new();
        let (mut n_pieces, mut is_done) = (0, true);
        while let Some([low, high]) = waiting.pop() {
            n_pieces += 1;
            if PROOF_PIECES < n_pieces || !work::goes_on(1) {
                is_done = false;
                break;
            }
            let enclosed = function([low, high]);
            if enclosed.is_some_and(|bounds| !bounds.may_vanish()) {
                continue;
            }
            if let Some(bounds) = enclosed.filter(|bounds| !bounds.may_rest()) {
                let is_growing = bounds.is_growing();
                match stretches.last_mut() {
                    #[expect(clippy::float_cmp, reason = "neighbours share one number")]
                    Some(last) if last.interval[1] == low && last.is_growing == is_growing => {
                        last.interval[1] = high;
                    }
                    _ => stretches.push(Monotone { interval: [low, high], is_growing }),
                }
                continue;
            }
            let middle = low + SHARE * (high - low);
            if high - low <= PROOF_WIDTH_RELATIVE * (end - start) || middle <= low || high <= middle
            {
                match open.last_mut() {
                    Some(last) if last[1].to_bits() == low.to_bits() => last[1] = high,
                    _ => open.push([low, high]),
                }
                continue;
            }
            waiting.extend([[middle, high], [low, middle]]);
        }
        let mut brackets = Vec::new();
        for Monotone { interval: [low, high], is_growing } in stretches {
            let [before, behind] = [low, high].map(|at| function([at, at]).and_then(sign));
            match (before, behind) {
                (Some(before), Some(behind)) if before != behind => brackets.push([low, high]),
                (Some(before), _) if before == is_growing => {}
                (_, Some(behind)) if behind != is_growing => {}
                // It is zero at an end, as far as rounding tells.
                _ => open.push([low, high]),
            }
        }
        sort_by(&mut open, |a, b| a[0].total_cmp(&b[0]));
        Self { brackets, open: is_done.then_some(open) }
    }

    /// Every root, in order, of the function whose bounds made the proof: that of each bracket, and those that are
    /// found in what it left open, where the function may only touch zero.
    ///
    /// ```
    /// use virote_kernel::{Enclosure, RootError, RootProof};
    ///
    /// // (x² − 2)² between 0 and 3, which is zero at no number of the computer.
    /// let two = Enclosure::constant(-2.0);
    /// let bounds = |x| Enclosure::variable(x).power(2.0)?.plus(&two).power(2.0);
    /// let value = |x: f64| Ok::<_, RootError<()>>((x * x - 2.0) * (x * x - 2.0));
    /// let roots = RootProof::of(bounds, [0.0, 3.0]).roots(bounds, value, [0.0, 3.0]).expect("a root");
    /// assert!(roots.len() == 1 && (roots[0].at - 2.0_f64.sqrt()).abs() < 1e-15);
    /// ```
    ///
    /// # Errors
    /// Those of the function; a jump over zero; a stretch along which it is zero.
    pub fn roots<E>(
        &self,
        mut bounds: impl FnMut([f64; 2]) -> Option<Enclosure>,
        mut function: impl FnMut(f64) -> Result<f64, E>,
        [start, end]: [f64; 2],
    ) -> Result<Vec<Sample>, RootError<E>> {
        let mut roots = Vec::with_capacity(self.brackets.len());
        for &bracket in &self.brackets {
            let sample = find_root(&mut function, bracket)?;
            roots.push(OpenRoot { sample, is_at_rest: false });
        }
        for &interval in self.open.iter().flatten() {
            roots.extend(roots_in_open(&mut bounds, &mut function, interval, end - start)?);
        }
        sort_by(&mut roots, |a, b| a.sample.at.total_cmp(&b.sample.at));
        Ok(told_apart(&mut bounds, &roots, end - start))
    }
}

/// Where an interval is divided: beside the middle, where roots like to be.
const SHARE: f64 = 0.487_390_625;

/// Whether it is positive; none where that is not sure.
fn sign(bounds: Enclosure) -> Option<bool> {
    (!bounds.may_vanish()).then(|| 0.0 < bounds.value()[0])
}

#[cfg(test)]
mod tests {
    use super::{Enclosure, RootError, RootProof};

    fn constant(value: f64) -> Enclosure {
        Enclosure::constant(value)
    }

    #[test]
    fn every_root_has_a_bracket_of_its_own() {
        let waves = RootProof::of(|x| Enclosure::variable(x).sin(), [1.0, 100.0]);
        assert!(waves.is_whole() && waves.brackets.len() == 31, "{waves:?}");
        for (k, [low, high]) in waves.brackets.iter().enumerate() {
            let root = std::f64::consts::PI * (k as f64 + 1.0);
            assert!(*low <= root && root <= *high);
        }
        // Two roots a millionth apart.
        let pair = |x| {
            let x = Enclosure::variable(x);
            Some(x.plus(&constant(-0.3)).times(&x.plus(&constant(-0.300_001))))
        };
        let pair = RootProof::of(pair, [0.0, 1.0]);
        assert!(pair.is_whole() && pair.brackets.len() == 2, "{pair:?}");
        let none = RootProof::of(
            |x| Some(Enclosure::variable(x).exp()?.plus(&constant(0.1))),
            [-5.0, 5.0],
        );
        assert!(none.is_whole() && none.brackets.is_empty());
    }

    /// The roots of a function between -1 and 10 that bounds and samples find.
    fn roots(
        bounds: impl Fn(Enclosure) -> Option<Enclosure>,
        value: impl Fn(f64) -> f64,
    ) -> Vec<f64> {
        let interval = [-1.0, 10.0];
        let bounds = |interval| bounds(Enclosure::variable(interval));
        let proof = RootProof::of(bounds, interval);
        let found = proof.roots(bounds, |x| Ok::<_, RootError<()>>(value(x)), interval);
        found.expect("roots").iter().map(|root| root.at).collect()
    }

    #[test]
    fn roots_at_which_a_function_only_touches_zero_are_found() {
        let is = |found: Vec<f64>, expected: &[f64], room: f64| {
            assert_eq!(found.len(), expected.len(), "{found:?}");
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() <= room, "{found} for {expected}");
            }
        };
        let pi = std::f64::consts::PI;
        let square = |x: Enclosure| x.power(2.0)?.plus(&constant(-2.0)).power(2.0);
        is(roots(square, |x| (x * x - 2.0) * (x * x - 2.0)), &[2.0_f64.sqrt()], 4e-16);
        is(
            roots(|x| x.sin()?.power(2.0), |x| libm::sin(x) * libm::sin(x)),
            &[0.0, pi, 2.0 * pi, 3.0 * pi],
            4e-15,
        );
        is(
            roots(|x| x.sin()?.abs(), |x| libm::sin(x).abs()),
            &[0.0, pi, 2.0 * pi, 3.0 * pi],
            4e-15,
        );
        let cosine = |x: Enclosure| Some(x.cos()?.negated().plus(&constant(1.0)));
        is(roots(cosine, |x| 1.0 - libm::cos(x)), &[0.0, 2.0 * pi], 4e-15);
        // Of third order, which has digits for a third of the place only.
        is(roots(|x| Some(x.plus(&x.sin()?.negated())), |x| x - libm::sin(x)), &[0.0], 1e-8);
        let exponential = |x: Enclosure| Some(x.exp()?.plus(&constant(-1.0)).plus(&x.negated()));
        is(roots(exponential, |x| libm::exp(x) - 1.0 - x), &[0.0], 1e-15);
        // What only comes near.
        let near = |x: Enclosure| Some(x.plus(&constant(-0.7)).power(2.0)?.plus(&constant(1e-20)));
        is(roots(near, |x| (x - 0.7) * (x - 0.7) + 1e-20), &[], 0.0);
        let pair =
            |x: Enclosure| Some(x.plus(&constant(-0.3)).times(&x.plus(&constant(-0.3 - 1e-13))));
        is(roots(pair, |x| (x - 0.3) * (x - 0.3 - 1e-13)), &[0.3, 0.3 + 1e-13], 1e-15);
        let pole = |x: Enclosure| constant(1.0).over(&x.plus(&constant(-0.3)).power(2.0)?);
        is(roots(pole, |x| 1.0 / ((x - 0.3) * (x - 0.3))), &[], 0.0);
        // A pole over which the sign changes, beside a root.
        let odd = |x: Enclosure| {
            Some(constant(1.0).over(&x.plus(&constant(-0.3)))?.plus(&constant(-2.0)))
        };
        is(roots(odd, |x| 1.0 / (x - 0.3) - 2.0), &[0.8], 1e-15);
    }

    #[test]
    fn poles_at_which_a_function_has_no_value_are_passed_over() {
        let interval = [5.1132, 7.2489];
        let (root, pole) = (6.1229, 6.6196);
        for order in [1, 2] {
            let bounds = |interval| {
                let x = Enclosure::variable(interval);
                let under = x.plus(&constant(-pole)).power(f64::from(order))?;
                x.plus(&constant(-root)).over(&under)
            };
            let value = |x: f64| {
                let under = if order == 1 { x - pole } else { (x - pole) * (x - pole) };
                if under == 0.0 { Err("division by zero") } else { Ok((x - root) / under) }
            };
            let found = RootProof::of(bounds, interval).roots(bounds, value, interval);
            let found: Vec<f64> = found.expect("a root").iter().map(|root| root.at).collect();
            assert!(found.len() == 1 && (found[0] - root).abs() < 1e-14, "{found:?}");
        }
        // What comes to zero at such a place is no pole, and nothing is said of it.
        let bounds = |interval| {
            let x = Enclosure::variable(interval).plus(&constant(-pole));
            x.power(2.0)?.over(&x)
        };
        let value = |x: f64| {
            let x = x - pole;
            if x == 0.0 { Err("division by zero") } else { Ok(x * x / x) }
        };
        let found = RootProof::of(bounds, interval).roots(bounds, value, interval);
        assert!(matches!(found, Err(RootError::Function(_))), "{found:?}");
    }

    #[test]
    fn what_is_not_sure_is_not_claimed() {
        let touch =
            RootProof::of(|x| Enclosure::variable(x).plus(&constant(-0.7)).power(2.0), [0.0, 2.0]);
        assert!(!touch.is_whole() && touch.brackets.is_empty());
        let pole = RootProof::of(
            |x| constant(1.0).over(&Enclosure::variable(x).plus(&constant(-0.3))),
            [0.0, 1.0],
        );
        assert!(!pole.is_whole() && pole.brackets.is_empty());
        let border = RootProof::of(|x| Some(Enclosure::variable(x)), [0.0, 1.0]);
        assert!(!border.is_whole() && border.brackets.is_empty());
        assert!(border.open.is_some_and(|open| open.len() == 1 && open[0][0] <= 0.0));
        assert!(!RootProof::of(|_| None, [0.0, 1.0]).is_whole());
    }
}
