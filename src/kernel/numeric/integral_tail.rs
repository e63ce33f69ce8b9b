//! How what an integral gains falls towards a place, over each tenth of the way.

use super::integral_piece::IntegrationInterval;
use crate::{
    sorting::sort_by,
    tolerance::{INTEGRAL_NEAR_SHARE, INTEGRAL_TAIL_LEAST, INTEGRAL_WIDTH_RELATIVE},
};

/// Spacings of numbers to a place that are left out.
pub(super) const SPACINGS: f64 = 64.0;

/// Parts of the way to a place, by equal factors.
const PARTS: usize = 4;

/// How often the way is halved, by its powers, where the function fails at its near end.
const SHORTENINGS: usize = 3;

/// The power of the distance by which the size of a function times the distance falls near a place, if that is enough:
/// rules are then not off by more than they tell.
const CLEAR_POWER: f64 = 0.5;

/// How many times more nodes the finer of two rules has.
const FINER: f64 = 2.0;

/// How many times larger errors of rules are that have few nodes than those of many tell, at most.
const TAIL_MARGIN: f64 = 1.25;

/// How the function's size times the distance falls towards a place.
pub(super) struct Tail {
    /// The logarithm of its fall over each part of the way.
    falls: Vec<f64>,
    /// That of the length of one part.
    part: f64,
    /// The distances, with the size times each.
    pub(super) gains: Vec<[f64; 2]>,
}

impl Tail {
    /// From so far beside a place, as near as numbers go if it takes that to see it fall; none where the function fails
    /// near it.
    pub(super) fn towards(
        size_at: &mut dyn FnMut(f64) -> Option<f64>,
        at: f64,
        reach: f64,
    ) -> Option<Self> {
        let last = (SPACINGS * spacing(at)).max(INTEGRAL_WIDTH_RELATIVE * reach.abs());
        let (mut share, mut gains) = (INTEGRAL_NEAR_SHARE, Vec::new());
        // Nearer by an integral of integrals takes long to ask.
        loop {
            let nearest = last.max(share * reach.abs());
            let mut tail = Self::down_to(nearest, size_at, at, reach)?;
            gains.append(&mut tail.gains);
            if nearest <= last || CLEAR_POWER * tail.part < tail.last() {
                return Some(Self { gains, ..tail });
            }
            share *= share;
        }
    }

    /// Down to a distance, or a larger one where the function fails there.
    fn down_to(
        mut nearest: f64,
        size_at: &mut dyn FnMut(f64) -> Option<f64>,
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
        let mut gains = Vec::with_capacity(PARTS + 1);
        for k in 0..=PARTS {
            gains.push([distance(k), gains_at(distance(k))?]);
        }
        (0.0 < part).then(|| Self::of(gains, part))
    }

    /// From what pieces on one side of a place gained, in any order; none where they are too few.
    pub(super) fn known<'p>(
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
        let distance = |k: usize| libm::exp(farthest - part * k as f64);
        let gains = (0..=PARTS).map(|k| [distance(k), gain_at(k)]).collect();
        (PARTS as f64 <= part).then(|| Self::of(gains, part))
    }

    fn of(gains: Vec<[f64; 2]>, part: f64) -> Self {
        let fall = |pair: &[[f64; 2]]| match pair {
            [[_, before], [_, behind]] if 0.0 < *behind => libm::log(before / behind),
            _ => f64::INFINITY,
        };
        Self { falls: gains.windows(2).map(fall).collect(), part, gains }
    }

    /// Whether the sum of all gains has no end, or has not as far as numbers go: it falls by no power of the distance, or by
    /// hardly more than one of the logarithm.
    pub(super) fn is_endless(&self) -> bool {
        PARTS as f64 * self.last() < INTEGRAL_TAIL_LEAST
    }

    /// The fall over the nearest part.
    fn last(&self) -> f64 {
        self.falls.last().copied().unwrap_or(f64::INFINITY)
    }

    /// How many times larger the error of a rule is than its difference to one with fewer nodes: both fall short by a
    /// power of the number of nodes that is twice that of the distance.
    pub(super) fn error_factor(&self) -> f64 {
        let finer = libm::pow(FINER, 2.0 * self.last() / self.part);
        (TAIL_MARGIN / (finer - 1.0)).max(1.0)
    }
}

/// How far numbers are apart at one.
pub(super) fn spacing(at: f64) -> f64 {
    at.abs().next_up() - at.abs()
}

#[cfg(test)]
mod tests {
    use super::{super::integral_piece::piece, *};

    /// Pieces from a distance on, each twice as long as the one before, on a side of a place.
    fn pieces(
        at: f64,
        side: f64,
        size_at: impl Fn(f64) -> f64,
        nearest: f64,
    ) -> Vec<IntegrationInterval> {
        let mut size = |x: f64| {
            let size = size_at((x - at).abs());
            Ok::<_, ()>((vec![size], size))
        };
        let mut of = |k: i32| {
            let ends = [k, k + 1].map(|k| at + side * libm::ldexp(nearest, k));
            piece(&mut size, [ends[0].min(ends[1]), ends[0].max(ends[1])]).expect("a function")
        };
        (0..40).map(&mut of).collect()
    }

    /// Over a part of the way to x⁻ᵠ, its size times the distance falls as the power 1 − q of the distance.
    #[test]
    fn a_power_falls_by_one_more_than_itself() {
        for (at, side, power) in [(0.0, 1.0, 0.5), (2.0, -1.0, 0.75), (-3.0, 1.0, 0.2)] {
            let size = |distance: f64| libm::pow(distance, -power);
            let nearest = 1e-9;
            let known = Tail::known(at, side, pieces(at, side, size, nearest).iter());
            let known = known.expect("forty pieces");
            let fall = known.last() / known.part;
            // A piece stands for its middle, a twentieth of a part away at most.
            assert!((fall - (1.0 - power)).abs() < 0.12, "{fall} of {power}");
            assert!(!known.is_endless());
            let distances = known.gains.iter().map(|gain| gain[0]);
            assert!(distances.clone().zip(distances.skip(1)).all(|(a, b)| b < a));
            assert!((known.gains[PARTS][0] / (nearest * 2.0_f64.sqrt()) - 1.0).abs() < 1e-3);

            let mut asked = |x: f64| Some(size((x - at).abs()));
            let told = Tail::towards(&mut asked, at, side * 0.5).expect("a tail");
            assert!((told.last() / told.part - (1.0 - power)).abs() < 1e-3);
            assert!((told.gains[0][0] - 0.5).abs() < 1e-12);
            let gain = libm::pow(0.5, 1.0 - power);
            assert!((told.gains[0][1] - gain).abs() < 1e-9);
            let factor = (TAIL_MARGIN / (libm::pow(4.0, 1.0 - power) - 1.0)).max(1.0);
            assert!((told.error_factor() - factor).abs() < 1e-2, "{}", told.error_factor());
        }
    }

    #[test]
    fn what_falls_by_no_more_than_its_logarithm_is_endless() {
        let falls = |power: f64| {
            move |distance: f64| {
                1.0 / (distance * libm::pow(libm::log(distance).abs().max(1e-3), power))
            }
        };
        for (power, is_endless) in [(0.0, true), (1.0, true), (2.0, false)] {
            let size = falls(power);
            let mut asked = |x: f64| Some(size(x));
            let told = Tail::towards(&mut asked, 0.0, 0.1).expect("a tail");
            assert_eq!(told.is_endless(), is_endless, "1/(x·lnᵖ x) for p = {power}");
        }
        let known = Tail::known(0.0, 1.0, pieces(0.0, 1.0, falls(0.0), 1e-11).iter());
        assert!(known.expect("forty pieces").is_endless());
    }

    #[test]
    fn too_few_pieces_and_a_function_that_fails_tell_nothing() {
        let few = pieces(0.0, 1.0, |_| 1.0, 1.0);
        assert!(Tail::known(0.0, 1.0, few[..3].iter()).is_none());
        assert!(Tail::known(0.0, -1.0, few.iter()).is_none());
        assert!(Tail::towards(&mut |_| None, 0.0, 1.0).is_none());
        assert!(Tail::towards(&mut |_| Some(f64::INFINITY), 0.0, 1.0).is_none());
    }
}
