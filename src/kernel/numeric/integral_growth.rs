//! Whether a function that grows without bound somewhere has an integral up to there.
//!
//! Over each tenth of the way to such a place the integral gains the function's size times the distance. Where that
//! does not fall to zero the integral has no value, however little two rules differ, and where it falls slowly they tell
//! little of what both miss.

use super::integral_piece::{IntegrationInterval, piece};
use crate::{
    sorting::sort_by,
    tolerance::{
        INTEGRAL_END_SHARE, INTEGRAL_NEAR_SHARE, INTEGRAL_SUSPECT_RELATIVE, INTEGRAL_TAIL_LEAST,
        INTEGRAL_WIDTH_RELATIVE,
    },
};

/// Parts of the way to a place, by equal factors.
const PARTS: usize = 4;

/// How often the way is halved, by its powers, where the function fails at its near end.
const SHORTENINGS: usize = 3;

/// The power of the distance by which the size of a function times the distance falls near a place, if that is enough:
/// rules are then not off by more than they tell.
const CLEAR_POWER: f64 = 0.5;

/// Spacings of numbers to a place that are left out.
const SPACINGS: f64 = 64.0;

/// Times that a step is halved until it is seen whether a function grows without bound, and by how many times it has
/// grown then at least where its integral has no value: near a simple pole by five, where a node is beside it already,
/// and by seven hundred.
const GROWTHS: [(i32, f64); 2] = [(7, 3.0), (14, 100.0)];

/// Times that it is halved at most: to the spacing of numbers near a place that is not zero.
const HALVINGS: i32 = 60;

/// How many times more nodes the finer of two rules has.
const FINER: f64 = 2.0;

/// How many times larger errors of rules are that have few nodes than those of many tell, at most.
const TAIL_MARGIN: f64 = 1.25;

/// The distance of nodes in the middle of a piece, as a part of it.
const NODES_APART: f64 = 8.0;

/// A place that the integral has no value up to.
pub(super) struct Divergence {
    pub(super) at: f64,
}

/// A place at an end of pieces, and by which factor their errors are larger there than the differences of two rules tell;
/// none where that was not asked.
struct SingularEnd {
    at: f64,
    /// At which end of a piece it is.
    side: usize,
    factor: Option<f64>,
}

/// How the function grows towards the ends of an integral, and towards places inside.
pub(super) struct IntegralGrowth(Vec<SingularEnd>);

impl IntegralGrowth {
    pub(super) fn new(interval: [f64; 2]) -> Self {
        let end = |side: usize| SingularEnd { at: interval[side], side, factor: None };
        Self(vec![end(0), end(1)])
    }

    /// Looks once at each piece in which the rules differ clearly, and cuts it where the function grows without bound;
    /// whether the errors of some became larger.
    ///
    /// # Errors
    /// A place up to which there is no integral.
    pub(super) fn look<E>(
        &mut self,
        function: &mut impl FnMut(f64) -> Result<(Vec<f64>, f64), E>,
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
                if end.factor.is_none() && end.is_of(one) {
                    let reach = one.outer_nodes()[end.side] - end.at;
                    let factor = error_factor(&mut size_at, end.at, reach)?;
                    end.factor = Some(factor);
                    one.error *= factor;
                    is_larger |= 1.0 < factor;
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
        function: &mut impl FnMut(f64) -> Result<(Vec<f64>, f64), E>,
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
        size_at: &mut impl FnMut(f64) -> Option<f64>,
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
        let left = error_factor(size_at, at, -near)?;
        let right = error_factor(size_at, at, near)?;
        self.0.push(SingularEnd { at, side: 1, factor: Some(left) });
        self.0.push(SingularEnd { at, side: 0, factor: Some(right) });
        Ok(Some(at))
    }

    /// Makes the error of a new piece beside such a place as large as it may be.
    pub(super) fn weigh(&self, piece: &mut IntegrationInterval) {
        let factors = self.0.iter().filter(|end| end.is_of(piece)).filter_map(|end| end.factor);
        piece.error *= factors.product::<f64>();
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
}

/// How many times larger the error of a rule is than two of them tell, up to a place.
fn error_factor(
    size_at: &mut impl FnMut(f64) -> Option<f64>,
    at: f64,
    reach: f64,
) -> Result<f64, Divergence> {
    match Tail::towards(size_at, at, reach) {
        Some(tail) if tail.is_endless() => Err(Divergence { at }),
        tail => Ok(tail.map_or(1.0, |tail| tail.error_factor())),
    }
}

/// The place in a piece towards which a function grows without bound, as far as a thousandth of the way shows; where it
/// fails on the way, that is the place.
fn peak(size_at: &mut impl FnMut(f64) -> Option<f64>, piece: &IntegrationInterval) -> Option<f64> {
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

/// How the function's size times the distance falls towards a place.
struct Tail {
    /// The logarithm of its fall over each part of the way.
    falls: Vec<f64>,
    /// That of the length of one part.
    part: f64,
}

impl Tail {
    /// From so far beside a place, as near as numbers go if it takes that to see it fall; none where the function fails
    /// near it.
    fn towards(size_at: &mut impl FnMut(f64) -> Option<f64>, at: f64, reach: f64) -> Option<Self> {
        let last = (SPACINGS * spacing(at)).max(INTEGRAL_WIDTH_RELATIVE * reach.abs());
        let first = last.max(INTEGRAL_NEAR_SHARE * reach.abs());
        // Nearer by an integral of integrals takes long to ask.
        let seen = Self::down_to(first, size_at, at, reach)
            .filter(|tail| CLEAR_POWER * tail.part < tail.last());
        seen.or_else(|| Self::down_to(last, size_at, at, reach))
    }

    /// Down to a distance, or a larger one where the function fails there.
    fn down_to(
        mut nearest: f64,
        size_at: &mut impl FnMut(f64) -> Option<f64>,
        at: f64,
        reach: f64,
    ) -> Option<Self> {
        let mut gains_at = |distance: f64| {
            let size = size_at(at + distance.copysign(reach))?;
            Some(size * distance).filter(|gain| gain.is_finite())
        };
        for _ in 0..SHORTENINGS {
            if gains_at(nearest).is_some() {
                break;
            }
            nearest = (nearest * reach.abs()).sqrt();
        }
        let part = libm::log(reach.abs() / nearest) / PARTS as f64;
        let distance = |k: usize| reach.abs() * libm::exp(-part * k as f64);
        let gains: Option<Vec<f64>> = (0..=PARTS).map(|k| gains_at(distance(k))).collect();
        Some(Self::of(&gains?, part)).filter(|_| 0.0 < part)
    }

    /// From what pieces on one side of a place gained, in any order; none where they are too few.
    fn known<'p>(
        at: f64,
        side: f64,
        pieces: impl Iterator<Item = &'p IntegrationInterval>,
    ) -> Option<Self> {
        let mut gains: Vec<[f64; 2]> = Vec::new();
        for piece in pieces {
            let [from, to] = piece.interval.map(|end| side * (end - at));
            let (near, far) = (from.min(to), from.max(to));
            if 0.0 < near {
                let width = libm::log(far / near);
                gains.push([libm::log(near) + 0.5 * width, piece.size / width]);
            }
        }
        sort_by(&mut gains, |a, b| b[0].total_cmp(&a[0]));
        let (farthest, nearest) = (gains.first()?[0], gains.last()?[0]);
        let part = (farthest - nearest) / PARTS as f64;
        let gain_at = |k: usize| {
            let place = farthest - part * k as f64;
            let behind = gains.iter().find(|gain| gain[0] <= place).or(gains.last());
            behind.map_or(0.0, |gain| gain[1])
        };
        let gains: Vec<f64> = (0..=PARTS).map(gain_at).collect();
        (PARTS as f64 <= part).then(|| Self::of(&gains, part))
    }

    fn of(gains: &[f64], part: f64) -> Self {
        let fall = |pair: &[f64]| match pair {
            [before, behind] if 0.0 < *behind => libm::log(before / behind),
            _ => f64::INFINITY,
        };
        Self { falls: gains.windows(2).map(fall).collect(), part }
    }

    /// Whether the sum of all gains has no end, or has not as far as numbers go: it falls by no power of the distance, or by
    /// hardly more than one of the logarithm.
    fn is_endless(&self) -> bool {
        PARTS as f64 * self.last() < INTEGRAL_TAIL_LEAST
    }

    /// The fall over the nearest part.
    fn last(&self) -> f64 {
        self.falls.last().copied().unwrap_or(f64::INFINITY)
    }

    /// How many times larger the error of a rule is than its difference to one with fewer nodes: both fall short by a
    /// power of the number of nodes that is twice that of the distance.
    fn error_factor(&self) -> f64 {
        let finer = libm::pow(FINER, 2.0 * self.last() / self.part);
        (TAIL_MARGIN / (finer - 1.0)).max(1.0)
    }
}

fn magnitude(value: &[f64]) -> f64 {
    value.iter().fold(0.0, |most: f64, part| most.max(part.abs()))
}

fn spacing(at: f64) -> f64 {
    at.abs().next_up() - at.abs()
}

#[cfg(test)]
mod tests {
    use crate::numeric::integral::{Integral, IntegralError, IntegralReason, find_integral};

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
