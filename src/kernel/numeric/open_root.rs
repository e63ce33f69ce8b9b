//! Roots of a function where bounds of its values and slopes tell of none.

use super::{
    bisection::bisected, enclosure::Enclosure, root::find_root, root_error::RootError,
    sample::Sample,
};
use crate::{
    ceiling::BISECTIONS,
    tolerance::{LAST_BIT, OPEN_WIDTH_RELATIVE, PROOF_WIDTH_RELATIVE, ROOT_RELATIVE},
};

/// A root that no bracket proves.
#[derive(Clone, Copy)]
pub(super) struct OpenRoot {
    pub(super) sample: Sample,
    /// Whether the slope of the function changes its sign there.
    pub(super) is_at_rest: bool,
}

/// The roots in an interval of which bounds over intervals do not tell whether it holds any; `whole` is the length of
/// all that is searched.
///
/// No sample tells where a function only touches zero at a place between two numbers of the computer. There its slope
/// changes its sign, and its bounds about that place, as far as rounding moves it in the whole, hold zero. What is zero as far as rounding tells all along a part
/// that is narrow beside the whole is one root, in its middle. A pole or a step in the narrowest parts is none.
///
/// # Errors
/// Those of the function, but for poles at which it has no value; a jump over zero; a stretch along which it is zero.
pub(super) fn roots_in_open<E>(
    bounds: &mut impl FnMut([f64; 2]) -> Option<Enclosure>,
    function: &mut impl FnMut(f64) -> Result<f64, E>,
    interval: [f64; 2],
    whole: f64,
) -> Result<Vec<OpenRoot>, RootError<E>> {
    let [low, high] = interval;
    let is_narrow = high - low <= OPEN_WIDTH_RELATIVE * whole;
    let is_narrowest = high - low <= PARTS_OF_STEP * PROOF_WIDTH_RELATIVE * whole;
    let rest = resting_place(bounds, interval);
    let around =
        |at: f64| [at - LAST_BIT * whole, at + LAST_BIT * whole].map(|at| at.clamp(low, high));
    let parts = match rest {
        Some(at) if is_zero(bounds, around(at)) => {
            // Of a place that is zero to rounding, too, zero itself is told.
            let [from, to] = around(at);
            let at = if from <= 0.0 && 0.0 <= to { 0.0 } else { at };
            return Ok(vec![OpenRoot {
                sample: Sample { at, value: function(at)? },
                is_at_rest: true,
            }]);
        }
        Some(at) if low < at && at < high => vec![[low, at], [at, high]],
        _ => vec![interval],
    };
    let mut is_zero = |at: f64| is_zero(bounds, around(at));
    let mut roots = Vec::new();
    for part in parts {
        let mut last = part[0];
        let looked_at = |at: f64| {
            last = at;
            function(at)
        };
        let found = find_root(looked_at, part);
        if matches!(found, Err(RootError::Function(_)))
            && is_narrowest
            && is_pole(function, interval, last)
        {
            continue;
        }
        let zeros = match &found {
            Err(RootError::NoRoot { nearest, .. }) => Some([nearest.at; 2]),
            Err(RootError::Jump { sides: [a, b] }) if is_narrow => Some([a.at, b.at]),
            Err(RootError::Flat { stretch }) if is_narrow => Some(*stretch),
            _ => None,
        };
        let zeros = zeros.filter(|ends| ends.iter().all(|&at| is_zero(at)));
        match (found, zeros) {
            (Ok(sample), _) => roots.push(OpenRoot { sample, is_at_rest: false }),
            (_, Some([from, to])) => {
                let at = from + 0.5 * (to - from);
                let sample = Sample { at, value: function(at)? };
                roots.push(OpenRoot { sample, is_at_rest: false });
            }
            (Err(RootError::NoRoot { .. }), None) => {}
            (Err(RootError::Jump { sides }), None)
                if is_narrowest && is_step(function, part, sides)? => {}
            (Err(other), None) => return Err(other),
        }
    }
    Ok(roots)
}

/// Whether a function jumps over zero between two neighbours: its size stays towards these from the ends of an interval
/// around them, or grows, where towards a steep root it becomes less.
fn is_step<E>(
    function: &mut impl FnMut(f64) -> Result<f64, E>,
    [low, high]: [f64; 2],
    [before, behind]: [Sample; 2],
) -> Result<bool, E> {
    if before.at <= low || high <= behind.at {
        return Ok(false);
    }
    let stays = |end: f64, side: f64| SHARE_OF_STEP * end.abs() <= side.abs();
    Ok(stays(function(low)?, before.value) && stays(function(high)?, behind.value))
}

/// Whether a function that has no value at a place does not come near zero around it: from the ends of an interval to
/// both neighbours it keeps its sign, and its size or more.
fn is_pole<E>(
    function: &mut impl FnMut(f64) -> Result<f64, E>,
    [low, high]: [f64; 2],
    at: f64,
) -> bool {
    let mut stays = |end: f64, side: f64| match (function(end), function(side)) {
        (Ok(end), Ok(side)) => 0.0 < end * side && SHARE_OF_STEP * end.abs() <= side.abs(),
        _ => false,
    };
    low < at && at < high && stays(low, at.next_down()) && stays(high, at.next_up())
}

/// Parts that are not divided further, and left open together around a step.
const PARTS_OF_STEP: f64 = 8.0;

/// The share of a function's size beside a step that it has at it.
const SHARE_OF_STEP: f64 = 0.9;

/// Roots in order, of which those are one between which the function is zero as far as rounding tells: where it is at
/// rest if it is anywhere, else the one in their middle.
pub(super) fn told_apart(
    bounds: &mut impl FnMut([f64; 2]) -> Option<Enclosure>,
    roots: &[OpenRoot],
    whole: f64,
) -> Vec<Sample> {
    let is_same = |a: &OpenRoot, b: &OpenRoot| {
        let [from, to] = [a.sample.at, b.sample.at];
        let mut between = PLACES_BETWEEN.into_iter().map(|share| from + share * (to - from));
        to - from <= ROOT_RELATIVE * whole
            || (to - from <= OPEN_WIDTH_RELATIVE * whole
                && between.all(|at| is_zero(bounds, [at, at])))
    };
    let one = |same: &[OpenRoot]| {
        let at_rest = same.iter().find(|root| root.is_at_rest);
        at_rest.unwrap_or(&same[same.len() / 2]).sample
    };
    roots.chunk_by(is_same).map(one).collect()
}

/// Whether a function may be zero in an interval.
fn is_zero(bounds: &mut impl FnMut([f64; 2]) -> Option<Enclosure>, interval: [f64; 2]) -> bool {
    bounds(interval).is_some_and(|bounds| bounds.may_vanish())
}

/// Where a function is looked at between two roots that may be one, as shares of the way.
const PLACES_BETWEEN: [f64; 3] = [0.25, 0.5, 0.75];

/// Where the slope of a function changes its sign, to the last bits; none where it is not seen to do so.
fn resting_place(
    bounds: &mut impl FnMut([f64; 2]) -> Option<Enclosure>,
    [low, high]: [f64; 2],
) -> Option<f64> {
    let mut slope = |at: f64| bounds([at, at]).map(|bounds| bounds.slope()).unwrap_or_default();
    let is_growing = |[least, most]: [f64; 2]| match () {
        () if 0.0 < least => Some(true),
        () if most < 0.0 => Some(false),
        () => None,
    };
    let [before, behind] = [slope(low), slope(high)].map(is_growing);
    if before? == behind? {
        return None;
    }
    let rise = |[least, most]: [f64; 2]| least + most;
    let ends = bisected([low, high], BISECTIONS, |at| before == Some(0.0 < rise(slope(at))));
    let [on, off] = ends.map(|at| (rise(slope(at)).abs(), at));
    Some(if on.0 <= off.0 { on.1 } else { off.1 })
}
