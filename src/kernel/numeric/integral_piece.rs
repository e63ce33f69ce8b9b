//! A piece of an interval over which a function is integrated, by two rules of Gauss.

use std::cmp::Ordering;

use super::{
    gauss_legendre::{EIGHT_NODES, GaussRule, SIXTEEN_NODES},
    kink::SampledPiece,
};

/// How many times smaller than that of the worse half the error of the other one is, where it keeps to one side.
const LONELY: f64 = 64.0;

/// How many times smaller the error of a half may be than that of the whole beside a kink, even in the fourth
/// derivative; of a smooth function it falls a thousand times as fast.
const SLOW: f64 = 128.0;

/// Places of the sixteen nodes on −1..1, in the order in which the function is asked.
const PLACES: [f64; 16] = places(&SIXTEEN_NODES);

/// The polynomial through the function at the sixteen nodes, at each of the eight nodes.
const AT_EIGHT: [[f64; 16]; 8] = {
    let (eight, mut rows, mut k) = (places::<4, 8>(&EIGHT_NODES), [[0.0; 16]; 8], 0);
    while k < 8 {
        rows[k] = shares(eight[k]);
        k += 1;
    }
    rows
};

/// The same at both ends.
const AT_ENDS: [[f64; 16]; 2] = [shares(-1.0), shares(1.0)];

/// A piece of the interval with what the rules say of it; the one with the largest error comes first.
pub(super) struct IntegrationInterval {
    pub(super) interval: [f64; 2],
    pub(super) value: Vec<f64>,
    pub(super) size: f64,
    pub(super) error: f64,
    /// The function at the nodes of the finer rule.
    pub(super) samples: SampledPiece,
    /// What their polynomial is at both ends.
    pub(super) at_ends: [Vec<f64>; 2],
    /// After how many halvings one behind the other the error kept to this side.
    pub(super) n_lonely: u32,
    /// Whether the function was asked beside an end already.
    pub(super) is_seen: [bool; 2],
    /// Whether it was asked how the function grows inside.
    pub(super) is_looked_at: bool,
}

impl PartialEq for IntegrationInterval {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for IntegrationInterval {}

impl PartialOrd for IntegrationInterval {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for IntegrationInterval {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_place = || other.interval[0].total_cmp(&self.interval[0]);
        self.error.total_cmp(&other.error).then_with(by_place)
    }
}

impl IntegrationInterval {
    pub(super) fn middle(&self) -> f64 {
        0.5 * (self.interval[0] + self.interval[1])
    }

    /// The first node and the last one.
    pub(super) fn outer_nodes(&self) -> [f64; 2] {
        let half = 0.5 * (self.interval[1] - self.interval[0]);
        let reach = half * SIXTEEN_NODES[7][0];
        [self.middle() - reach, self.middle() + reach]
    }

    /// Whether its error is much smaller than another.
    pub(super) fn is_smooth_beside(&self, other: &Self) -> bool {
        LONELY * self.error < other.error
    }
}

const fn places<const HALF: usize, const ALL: usize>(rule: &GaussRule<HALF>) -> [f64; ALL] {
    let (mut all, mut k) = ([0.0; ALL], 0);
    while k < HALF {
        all[2 * k] = -rule[k][0];
        all[2 * k + 1] = rule[k][0];
        k += 1;
    }
    all
}

/// What the values at the sixteen nodes add to their polynomial at another place. Berrut & Trefethen, *Barycentric
/// Lagrange interpolation*, SIAM Review 46 (2004).
const fn shares(place: f64) -> [f64; 16] {
    let (mut shares, mut total, mut j) = ([0.0; 16], 0.0, 0);
    while j < 16 {
        let (mut product, mut k) = (place - PLACES[j], 0);
        while k < 16 {
            if k != j {
                product *= 2.0 * (PLACES[j] - PLACES[k]);
            }
            k += 1;
        }
        shares[j] = 1.0 / product;
        total += shares[j];
        j += 1;
    }
    j = 0;
    while j < 16 {
        shares[j] /= total;
        j += 1;
    }
    shares
}

/// A function's components at a node, its size, and the weight of the node.
type NodeSample = (Vec<f64>, f64, f64);

/// The integral over a piece by sixteen nodes. Its error is that of eight nodes beside the polynomial through the
/// sixteen, without signs: with them the errors about a jump in the middle cancel.
pub(super) fn piece<E>(
    function: &mut dyn FnMut(f64) -> Result<(Vec<f64>, f64), E>,
    interval: [f64; 2],
) -> Result<IntegrationInterval, E> {
    let mut samples = SampledPiece::default();
    let eight = by_rule(function, &EIGHT_NODES, interval, |_, _| {})?;
    let sixteen = by_rule(function, &SIXTEEN_NODES, interval, |at, value| samples.push(at, value))?;
    let n = sixteen.first().map_or(0, |(value, ..)| value.len());
    let polynomial = |shares: &[f64; 16]| {
        let mut sum = vec![0.0; n];
        sixteen.iter().zip(shares).for_each(|((value, ..), share)| add(&mut sum, *share, value));
        sum
    };
    let (mut value, mut size) = (vec![0.0; n], 0.0);
    for (own, own_size, weight) in &sixteen {
        add(&mut value, *weight, own);
        size += weight * own_size;
    }
    let mut errors = vec![0.0; n];
    for ((own, _, weight), shares) in eight.iter().zip(&AT_EIGHT) {
        let other = polynomial(shares);
        for (error, (a, b)) in errors.iter_mut().zip(own.iter().zip(&other)) {
            *error += weight * (a - b).abs();
        }
    }
    // `max` passes over what is no number.
    let is_known = errors.iter().chain(&value).all(|part| part.is_finite());
    let error = if is_known { errors.into_iter().fold(0.0, f64::max) } else { f64::INFINITY };
    let at_ends = AT_ENDS.each_ref().map(polynomial);
    Ok(IntegrationInterval {
        interval,
        value,
        size,
        error,
        samples,
        at_ends,
        n_lonely: 0,
        is_seen: [false; 2],
        is_looked_at: false,
    })
}

/// The function at the nodes of a rule.
fn by_rule<const HALF: usize, E>(
    function: &mut dyn FnMut(f64) -> Result<(Vec<f64>, f64), E>,
    rule: &GaussRule<HALF>,
    [start, end]: [f64; 2],
    mut keep: impl FnMut(f64, &[f64]),
) -> Result<Vec<NodeSample>, E> {
    let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
    let mut all = Vec::with_capacity(2 * HALF);
    for &[node, weight] in rule {
        for at in [middle - half * node, middle + half * node] {
            let (value, size) = function(at)?;
            keep(at, &value);
            all.push((value, size, weight * half));
        }
    }
    Ok(all)
}

/// Both halves of a piece.
pub(super) fn halves<E>(
    function: &mut dyn FnMut(f64) -> Result<(Vec<f64>, f64), E>,
    whole: &IntegrationInterval,
) -> Result<Vec<IntegrationInterval>, E> {
    let ([from, to], middle) = (whole.interval, whole.middle());
    let (mut a, mut b) = (piece(function, [from, middle])?, piece(function, [middle, to])?);
    (a.is_seen[0], b.is_seen[1]) = (whole.is_seen[0], whole.is_seen[1]);
    let (worse, better) = if a.error < b.error { (&mut b, &a) } else { (&mut a, &b) };
    if better.is_smooth_beside(worse) && whole.error < SLOW * worse.error {
        worse.n_lonely = whole.n_lonely + 1;
    }
    Ok(vec![a, b])
}

/// Adds components with a factor.
pub(super) fn add(sum: &mut Vec<f64>, factor: f64, value: &[f64]) {
    sum.resize(value.len(), 0.0);
    sum.iter_mut().zip(value).for_each(|(sum, part)| *sum += factor * part);
}

#[cfg(test)]
mod tests {
    use super::{AT_EIGHT, AT_ENDS, PLACES, piece, places};
    use crate::numeric::gauss_legendre::EIGHT_NODES;

    #[test]
    fn the_polynomial_through_sixteen_nodes_is_that_of_a_power() {
        let eight: [f64; 8] = places::<4, 8>(&EIGHT_NODES);
        let rows = AT_EIGHT.iter().zip(eight).chain(AT_ENDS.iter().zip([-1.0, 1.0]));
        for (shares, place) in rows {
            for power in [0.0, 1.0, 7.0, 15.0] {
                let value = |at: f64| libm::pow(at, power);
                let found: f64 =
                    shares.iter().zip(PLACES).map(|(share, at)| share * value(at)).sum();
                assert!((found - value(place)).abs() < 1e-13, "{found} at {place}");
            }
        }
    }

    #[test]
    fn a_piece_is_smooth_beside_one_with_a_kink_and_beside_no_other() {
        let of = |kink: f64| {
            let mut size = |x: f64| Ok::<_, ()>((vec![(x - kink).abs()], (x - kink).abs()));
            piece(&mut size, [0.0, 1.0]).expect("a function")
        };
        let (smooth, kinked, other) = (of(2.0), of(0.4), of(0.6));
        assert!((smooth.value[0] - 1.5).abs() < 1e-14 && smooth.error < 1e-14);
        assert!(smooth.is_smooth_beside(&kinked) && !kinked.is_smooth_beside(&smooth));
        assert!(!kinked.is_smooth_beside(&other) && !other.is_smooth_beside(&kinked));
        // Of a kink at c the integral is (c² + (1 − c)²)/2.
        assert!((kinked.value[0] - 0.26).abs() < kinked.error);
    }
}
