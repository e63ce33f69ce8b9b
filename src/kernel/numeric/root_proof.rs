//! Which intervals hold a root, beyond doubt.

use super::enclosure::Enclosure;
use crate::{ceiling::PROOF_PIECES, tolerance::PROOF_WIDTH_RELATIVE, work};

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
        open.sort_by(|a, b| a[0].total_cmp(&b[0]));
        Self { brackets, open: is_done.then_some(open) }
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
    use super::{Enclosure, RootProof};

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
