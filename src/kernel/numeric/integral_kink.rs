//! Cuts of an interval of integration at kinks and jumps.

use std::collections::BinaryHeap;

use super::{
    integral_piece::{IntegrationInterval, halves, piece},
    kink::SampledPiece,
};

/// Halvings after which the error keeps to one side, as beside a kink, that lead to a search for it.
const LONELY_HALVINGS: u32 = 2;

/// Between an end of the interval and the node beside it the function is asked, lest it jumps there, at this share of the
/// way from the end.
const BESIDE_END: f64 = 1.0 / 8.0;

/// So many times nearer by the same share it is asked at last: 1/8¹³ of a way is less than counts.
const END_LOOKS: i32 = 13;

/// The narrow interval in which the function kinks inside of a piece that looks like it, between its neighbours.
pub(super) fn kink<E>(
    function: &mut dyn FnMut(f64) -> Result<(Vec<f64>, f64), E>,
    pieces: &BinaryHeap<IntegrationInterval>,
    piece: &IntegrationInterval,
    budget: f64,
) -> Option<[f64; 2]> {
    if piece.n_lonely < LONELY_HALVINGS {
        return None;
    }
    let [from, to] = piece.interval.map(f64::to_bits);
    let neighbour = |is_it: &dyn Fn([u64; 2]) -> bool| {
        let found = pieces.iter().find(|other| is_it(other.interval.map(f64::to_bits)));
        found.filter(|other| other.is_smooth_beside(piece)).map(|other| &other.samples)
    };
    match [neighbour(&|[_, end]| end == from), neighbour(&|[start, _]| start == to)] {
        [Some(left), Some(right)] => {
            let ask = |at| function(at).map(|(value, _)| value);
            piece.samples.kink(piece.interval, [left, right], budget, ask)
        }
        _ => None,
    }
}

/// The interval of a piece, or of two beside one another, cut on both sides of a kink.
pub(super) fn beside_kink<E>(
    function: &mut dyn FnMut(f64) -> Result<(Vec<f64>, f64), E>,
    [first, last]: [&IntegrationInterval; 2],
    [low, high]: [f64; 2],
) -> Result<Vec<IntegrationInterval>, E> {
    let (from, to) = (first.interval[0], last.interval[1]);
    let mut parts = Vec::with_capacity(3);
    for (start, end, is_seen) in [
        (from, low, [first.is_seen[0], true]),
        (low, high, [true; 2]),
        (high, to, [true, last.is_seen[1]]),
    ] {
        if start < end {
            let mut part = piece(function, [start, end])?;
            part.is_seen = is_seen;
            // From nearer by the kink may be seen more clearly.
            part.n_lonely = if is_seen == [true; 2] { LONELY_HALVINGS } else { 0 };
            parts.push(part);
        }
    }
    Ok(parts)
}

/// Divides pieces, in order, between whose outermost nodes the function jumps, as their polynomials tell that do not
/// meet, or a question beside an end of the interval: by so much that it counts beside the error that is allowed. Whether
/// there were any.
pub(super) fn unseen_jump<E>(
    function: &mut dyn FnMut(f64) -> Result<(Vec<f64>, f64), E>,
    pieces: &mut Vec<IntegrationInterval>,
    allowed: f64,
    is_wide: impl Fn(&IntegrationInterval) -> bool,
) -> Result<bool, E> {
    Ok(jump_between(function, pieces, allowed, &is_wide)?
        || jump_beside_end(function, pieces, allowed, &is_wide)?)
}

/// As [`unseen_jump`], between neighbours.
fn jump_between<E>(
    function: &mut dyn FnMut(f64) -> Result<(Vec<f64>, f64), E>,
    pieces: &mut Vec<IntegrationInterval>,
    allowed: f64,
    is_wide: &impl Fn(&IntegrationInterval) -> bool,
) -> Result<bool, E> {
    let mut ask = |at| function(at).map(|(value, _)| value);
    for idx in 1..pieces.len() {
        let [left, right] = [&pieces[idx - 1], &pieces[idx]];
        let [low, high] = [left.outer_nodes()[1], right.outer_nodes()[0]];
        let is_seen = left.is_seen[1] || right.is_seen[0];
        let apart = distance(&left.at_ends[1], &right.at_ends[0]);
        if is_seen || apart * (high - low) <= 0.5 * allowed || !is_wide(left) || !is_wide(right) {
            continue;
        }
        let sides = [&left.samples, &right.samples];
        let found = SampledPiece::default().kink([low, high], sides, 0.5 * allowed, &mut ask);
        let parts = found.and_then(|kink| beside_kink(function, [left, right], kink).ok());
        let parts = match parts {
            Some(parts) => parts,
            None => {
                let mut parts = halves(function, left)?;
                parts.extend(halves(function, right)?);
                parts
            }
        };
        pieces.splice(idx - 1..=idx, parts);
        return Ok(true);
    }
    Ok(false)
}

/// As [`unseen_jump`], between an end of the interval and the node beside it.
fn jump_beside_end<E>(
    function: &mut dyn FnMut(f64) -> Result<(Vec<f64>, f64), E>,
    pieces: &mut Vec<IntegrationInterval>,
    allowed: f64,
    is_wide: &impl Fn(&IntegrationInterval) -> bool,
) -> Result<bool, E> {
    let mut ask = |at| function(at).map(|(value, _)| value);
    for side in [0, 1] {
        let idx = if side == 0 { 0 } else { pieces.len() - 1 };
        let node = pieces[idx].outer_nodes()[side];
        if pieces[idx].is_seen[side] || !is_wide(&pieces[idx]) {
            continue;
        }
        pieces[idx].is_seen[side] = true;
        let Some((beside, value)) = unlike_beside_end(&pieces[idx], side, allowed, &mut ask) else {
            continue;
        };
        let mut outside = SampledPiece::default();
        outside.push(beside, &value);
        let (inside, mut sides) = (&pieces[idx].samples, [&outside, &pieces[idx].samples]);
        let mut stretch = [beside, node];
        if side == 1 {
            (sides, stretch) = ([inside, &outside], [node, beside]);
        }
        let found = SampledPiece::default().kink(stretch, sides, 0.5 * allowed, &mut ask);
        let whole = &pieces[idx];
        let parts = found.and_then(|kink| beside_kink(function, [whole, whole], kink).ok());
        let parts = match parts {
            Some(parts) => parts,
            None => {
                let mut parts = halves(function, whole)?;
                // It changes fast there: nearer to the end it is to be asked again.
                parts[side].is_seen[side] = false;
                parts
            }
        };
        pieces.splice(idx..=idx, parts);
        return Ok(true);
    }
    Ok(false)
}

/// The first place between the node beside an end and the end at which the function is so far from the polynomial of
/// its piece that it counts, with the value there. A step anywhere between them shows at the nearest place to
/// the end; only where something does is the function asked on the way.
fn unlike_beside_end<E>(
    piece: &IntegrationInterval,
    side: usize,
    allowed: f64,
    ask: &mut dyn FnMut(f64) -> Result<Vec<f64>, E>,
) -> Option<(f64, Vec<f64>)> {
    let (end, node) = (piece.interval[side], piece.outer_nodes()[side]);
    let place = |look: i32| end + libm::pow(BESIDE_END, f64::from(look)) * (node - end);
    let is_inside = |at: f64| (end < at) == (end < node) && (at - end).abs() > 0.0;
    // What is so far from the polynomial at a place is so at least up to the place before it.
    let mut unlike = |look: i32, reach: f64| {
        // Where it fails so near to an end it is not asked again.
        let value = Some(place(look)).filter(|at| is_inside(*at)).and_then(|at| ask(at).ok())?;
        let apart = piece.samples.distance_at(place(look), &value);
        (0.5 * allowed < apart * (reach - end).abs()).then_some((place(look), value))
    };
    if let Some(found) = unlike(1, node) {
        return Some(found);
    }
    unlike(END_LOOKS, node)?;
    (2..=END_LOOKS).find_map(|look| unlike(look, place(look - 1)))
}

/// The largest difference of components.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
