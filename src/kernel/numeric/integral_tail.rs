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
