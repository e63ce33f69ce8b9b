//! Whether a function that grows without bound somewhere has an integral up to there.
//!
//! Over each tenth of the way to such a place the integral gains the function's size times the distance. Where that
//! does not fall to zero the integral has no value, however little two rules differ, and where it falls slowly they tell
//! little of what both miss.

use super::{
    integral_piece::{IntegrationInterval, piece},
    integral_tail::{SPACINGS, Tail, spacing},
};
use crate::tolerance::{INTEGRAL_END_SHARE, INTEGRAL_SUSPECT_RELATIVE};

/// Times that a step is halved until it is seen whether a function grows without bound, and by how many times it has
/// grown then at least where its integral has no value: near a simple pole by five, where a node is beside it already,
/// and by seven hundred.
const GROWTHS: [(i32, f64); 2] = [(7, 3.0), (14, 100.0)];

/// Times that it is halved at most: to the spacing of numbers near a place that is not zero.
const HALVINGS: i32 = 60;

/// The distance of nodes in the middle of a piece, as a part of it.
const NODES_APART: f64 = 8.0;

/// A place that the integral has no value up to.
pub(super) struct Divergence {
    pub(super) at: f64,
}

/// A place at an end of pieces, and how the function grows towards it; none where that was not asked.
struct SingularEnd {
    at: f64,
    /// At which end of a piece it is.
    side: usize,
    seen: Option<SeenTail>,
}

/// What rules do not tell of pieces that end at a place.
struct SeenTail {
    /// By how many times their errors are larger.
    factor: f64,
    /// The function's size times the distance, at some distances, that are to be nearer than a node to count.
    gains: Vec<[f64; 2]>,
}

/// How the function grows towards the ends of an integral, and towards places inside.
pub(super) struct IntegralGrowth(Vec<SingularEnd>);

impl IntegralGrowth {
    pub(super) fn new(interval: [f64; 2]) -> Self {
        let end = |side: usize| SingularEnd { at: interval[side], side, seen: None };
        Self(vec![end(0), end(1)])
    }

    /// Looks once at each piece in which the rules differ clearly, and cuts it where the function grows without bound;
    /// whether the errors of some became larger.
    ///
    /// # Errors
    /// A place up to which there is no integral.
    pub(super) fn look<E>(
        &mut self,
        function: &mut dyn FnMut(f64) -> Result<(Vec<f64>, f64), E>,
        pieces: &mut Vec<IntegrationInterval>,
    ) -> Result<bool, Divergence> {
        let mut is_larger = false;
        let mut cut = Vec::new();
        for one in pieces.iter_mut().filter(|piece| !piece.is_looked_at) {
            one.is_looked_at = true;
            if one.error <= INTEGRAL_SUSPECT_RELATIVE * one.size {
                continue;
            }
            let mut size_at = |at: f64| function(at).ok().map(|(value, _)| magnitude(&value));
            if let Some(at) = self.singularity(&mut size_at, one)? {
                cut.push(at);
                continue;
            }
            for end in &mut self.0 {
                if end.seen.is_none() && end.is_of(one) {
                    let reach = one.outer_nodes()[end.side] - end.at;
                    end.seen = Some(seen_tail(&mut size_at, end.at, reach)?);
                    let before = one.error;
                    one.error = end.error(one);
                    is_larger |= before < one.error;
                }
            }
        }
        for at in cut {
            is_larger |= self.cut(function, pieces, at);
        }
        Ok(is_larger)
    }

    /// Lets pieces end at a place, with errors as large as they may be beside it; whether that is so.
    fn cut<E>(
        &self,
        function: &mut dyn FnMut(f64) -> Result<(Vec<f64>, f64), E>,
        pieces: &mut Vec<IntegrationInterval>,
        at: f64,
    ) -> bool {
        let is_around =
            |piece: &IntegrationInterval| piece.interval[0] < at && at < piece.interval[1];
        let Some(idx) = pieces.iter().position(is_around) else {
            let beside = |piece: &&mut IntegrationInterval| piece.interval.contains(&at);
            pieces.iter_mut().filter(beside).for_each(|piece| self.weigh(piece));
            return true;
        };
        let [from, to] = pieces[idx].interval;
        let parts = [piece(function, [from, at]), piece(function, [at, to])];
        let [Ok(mut left), Ok(mut right)] = parts else { return false };
        self.weigh(&mut left);
        self.weigh(&mut right);
        pieces.splice(idx..=idx, [left, right]);
        true
    }

    /// A place inside of a piece, or at its end and inside of the integral, towards which the function grows without bound;
    /// it is kept.
    fn singularity(
        &mut self,
        size_at: &mut dyn FnMut(f64) -> Option<f64>,
        piece: &IntegrationInterval,
    ) -> Result<Option<f64>, Divergence> {
        let [from, to] = piece.interval;
        // What is largest beside such an end is looked at from there.
        let beside = piece.outer_nodes();
        let greatest = piece.samples.greatest().map(|(place, _)| place.to_bits());
        let is_known =
            |end: &SingularEnd| end.is_of(piece) && greatest == Some(beside[end.side].to_bits());
        if self.0.iter().any(is_known) {
            return Ok(None);
        }
        let Some(peak) = peak(size_at, piece) else { return Ok(None) };
        let near = INTEGRAL_END_SHARE * (to - from);
        let nearest = if peak - from < to - peak { from } else { to };
        let is_at_end = (peak - nearest).abs() <= near;
        let at = if is_at_end { nearest } else { peak };
        if self.0.iter().any(|end| end.at.to_bits() == at.to_bits()) {
            return Ok(None);
        }
        for (side, reach) in [(1, -near), (0, near)] {
            let seen = Some(seen_tail(size_at, at, reach)?);
            self.0.push(SingularEnd { at, side, seen });
        }
        Ok(Some(at))
    }

    /// Makes the error of a new piece beside such a place as large as it may be.
    pub(super) fn weigh(&self, piece: &mut IntegrationInterval) {
        for end in &self.0 {
            if end.is_of(piece) {
                piece.error = end.error(piece);
            }
        }
    }
}

/// The place up to which there is no integral, if that is why a piece among others cannot be divided far enough: the
/// pieces beside it tell.
pub(super) fn divergence<'p>(
    worst: &IntegrationInterval,
    pieces: impl Iterator<Item = &'p IntegrationInterval> + Clone,
) -> Option<Divergence> {
    let [from, to] = worst.interval;
    // What is no number has no size.
    let is_endless = |(at, side): (f64, f64)| {
        Tail::known(at, side, pieces.clone()).is_some_and(|tail| tail.is_endless())
    };
    let is_found = 0.0 < worst.size && [(to, -1.0), (from, 1.0)].into_iter().any(is_endless);
    let reaches_zero = from <= 0.0 && 0.0 <= to;
    is_found.then_some(Divergence { at: if reaches_zero { 0.0 } else { worst.middle() } })
}

impl SingularEnd {
    fn is_of(&self, piece: &IntegrationInterval) -> bool {
        piece.interval[self.side].to_bits() == self.at.to_bits()
    }

    /// The error of a piece that ends there.
    fn error(&self, piece: &IntegrationInterval) -> f64 {
        let Some(SeenTail { factor, gains }) = &self.seen else { return piece.error };
        let node = (piece.outer_nodes()[self.side] - self.at).abs();
        let unseen = gains.iter().filter(|[distance, _]| *distance < node);
        unseen.fold(factor * piece.error, |error, [_, gain]| error.max(*gain))
    }
}

/// What rules do not tell up to a place, from so far beside it.
fn seen_tail(
    size_at: &mut dyn FnMut(f64) -> Option<f64>,
    at: f64,
    reach: f64,
) -> Result<SeenTail, Divergence> {
    let Some(tail) = Tail::towards(size_at, at, reach) else {
        return Ok(SeenTail { factor: 1.0, gains: Vec::new() });
    };
    if tail.is_endless() {
        return Err(Divergence { at });
    }
    Ok(SeenTail { factor: tail.error_factor(), gains: tail.gains })
}

/// The place in a piece towards which a function grows without bound, as far as a thousandth of the way shows; where it
/// fails on the way, that is the place.
fn peak(size_at: &mut dyn FnMut(f64) -> Option<f64>, piece: &IntegrationInterval) -> Option<f64> {
    let [from, to] = piece.interval;
    let (mut at, lowest) = piece.samples.greatest()?;
    let (mut most, mut reach) = (lowest, (to - from) / NODES_APART);
    for halving in 0..HALVINGS {
        if GROWTHS.iter().any(|(n, growth)| halving == *n && most < growth * lowest) {
            return None;
        }
        if reach <= SPACINGS * spacing(at) / NODES_APART {
            break;
        }
        for beside in [at - reach, at + reach] {
            if beside <= from || to <= beside {
                continue;
            }
            let Some(size) = size_at(beside) else { return Some(beside) };
            if most < size {
                (at, most) = (beside, size);
                break;
            }
        }
        reach *= 0.5;
    }
    Some(at)
}

fn magnitude(value: &[f64]) -> f64 {
    value.iter().fold(0.0, |most: f64, part| most.max(part.abs()))
}

#[cfg(test)]
mod tests {
    use crate::numeric::{
        integral::{Integral, find_integral},
        integral_error::{IntegralError, IntegralReason},
    };

    fn within(
        function: fn(f64) -> f64,
        interval: [f64; 2],
        tolerance: f64,
    ) -> Result<Integral, IntegralError<()>> {
        find_integral(|x| Ok(vec![function(x)]), interval, 1e-12, tolerance)
    }

    #[test]
    fn no_tolerance_gives_an_endless_integral_a_value() {
        let cases: [(fn(f64) -> f64, [f64; 2], f64); 7] = [
            (|x| 1.0 / x, [0.0, 1.0], 0.0),
            (|x| 1.0 / x, [-1.0, 1.0], 0.0),
            (|x| libm::pow(x, -1.001), [0.0, 1.0], 0.0),
            (|x| 1.0 / (x * libm::log(x)), [0.0, 0.5], 0.0),
            (|x| 1.0 + 0.01 / x, [0.0, 1.0], 0.0),
            (|x| 1.0 / (x - 0.3).abs(), [0.0, 1.0], 0.3),
            (libm::tan, [0.0, 3.0], std::f64::consts::FRAC_PI_2),
        ];
        for (function, interval, place) in cases {
            for tolerance in [0.01, 3.0, 1e9] {
                let found = within(function, interval, tolerance);
                let Err(IntegralError::Unsettled { at, reason, .. }) = found else {
                    unreachable!("{found:?} at {place} within {tolerance}")
                };
                assert_eq!(reason, IntegralReason::Endless, "at {place} within {tolerance}");
                assert!((at - place).abs() < 1e-9, "{at}, not {place}");
            }
        }
    }

    #[test]
    fn peaks_between_nodes_are_seen_that_grow_towards_their_top() {
        for width in [1e-3, 1e-6, 1e-9, 1e-12] {
            let peak = |x: f64| Ok::<_, ()>(vec![width / (x * x + width * width)]);
            for interval in [[-1.0, 1.0], [0.0, 1.0], [-0.3, 1.0]] {
                let found = find_integral(peak, interval, 1e-12, 0.01).expect("an integral");
                let [from, to] = interval.map(|end: f64| libm::atan(end / width));
                let off = (found.value[0] - (to - from)).abs();
                assert!(off < 0.01, "{} of {width} over {interval:?}", found.value[0]);
            }
        }
    }

    #[test]
    fn what_grows_without_bound_and_has_an_integral_is_known_within_its_tolerance() {
        let pi = std::f64::consts::PI;
        let cases: [(fn(f64) -> f64, [f64; 2], f64); 7] = [
            (|x| 1.0 / x.sqrt(), [0.0, 1.0], 2.0),
            (libm::log, [0.0, 1.0], -1.0),
            (|x| libm::pow(x, -0.9), [0.0, 1.0], 10.0),
            (|x| 1.0 / (1.0 - x * x).sqrt(), [-1.0, 1.0], pi),
            (|x| libm::pow(x, -0.95), [0.0, 1.0], 20.0),
            (
                |x| libm::pow((x - 0.3).abs(), -0.8),
                [0.0, 1.0],
                5.0 * (libm::pow(0.3, 0.2) + libm::pow(0.7, 0.2)),
            ),
            (|x| 1.0 / (1e-6 + x * x), [-1.0, 1.0], 2e3 * libm::atan(1e3)),
        ];
        for (function, interval, expected) in cases {
            for tolerance in [3.0, 0.1] {
                let found = within(function, interval, tolerance).expect("an integral");
                let off = (found.value[0] - expected).abs();
                assert!(off < tolerance, "{} for {expected} within {tolerance}", found.value[0]);
            }
        }
    }
}
