//! Integrals of functions of one number, to a stated error.

use std::collections::BinaryHeap;

use super::{
    integral_error::{IntegralError, IntegralReason},
    integral_growth::{Divergence, IntegralGrowth, divergence},
    integral_kink::{beside_kink, kink, unseen_jump},
    integral_look::{is_cut_at, places_between},
    integral_piece::{IntegrationInterval, add, halves},
    integral_start::{MOST_LOOKS, first_pieces},
};
use crate::{
    ceiling::INTEGRAL_PIECES,
    sorting::sort_by,
    tolerance::{INTEGRAL_NOISE_RELATIVE, INTEGRAL_SEEN_RELATIVE, INTEGRAL_WIDTH_RELATIVE},
};

/// An integral, and how far it may be off.
///
/// ```
/// use virote_kernel::{Integral, IntegralError, find_integral};
///
/// let found: Integral = find_integral(|x| Ok::<_, ()>(vec![x, x * x]), [0.0, 3.0], 1e-13, 0.0)?;
/// assert!((found.value[1] - 9.0).abs() < 1e-12 && found.error < 1e-12);
/// # Ok::<(), IntegralError<()>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Integral {
    /// The integral of each component.
    pub value: Vec<f64>,
    /// The differences between two rules, added up.
    pub error: f64,
    /// The integral of the function's size: of the largest component without its sign, or of what it tells itself.
    pub size: f64,
}

/// Numbers between the ends of a piece that is divided: nodes are no longer places of their own in less.
const LEAST_SPACINGS: u32 = 256;

/// Halvings one behind the other that only find noise.
const NOISY_HALVINGS: usize = 3;

/// By which share of the error of the whole both halves are off at least, where it is noise.
const NOISY_SHARE: f64 = 0.2;

/// How many times smaller than the error asked for is what may be left to the place of a kink.
const FINER: f64 = 64.0;

/// The integral of a function of some components, as many everywhere, over an interval, `start` below `end`, with an
/// error of at most `relative` times the integral of the function's size, or of `absolute`.
///
/// The piece of which rules with eight and with sixteen nodes say most different things is halved, until
/// they agree. Where the error keeps to one side, as beside a kink or a jump, the function is cut there; neighbours
/// that do not meet have a jump between their last nodes. Ends of the interval are never asked for, so that a function
/// may grow there without bound as long as its integral does not. What no node shows stays unseen: a peak between
/// them, or two jumps beside one another. Piessens et al., *QUADPACK*, §2.2.1 (QAG).
///
/// ```
/// use virote_kernel::{IntegralError, find_integral};
///
/// let found = find_integral(|x: f64| Ok::<_, ()>(vec![x.sqrt()]), [0.0, 1.0], 1e-12, 0.0)?;
/// assert!((found.value[0] - 2.0 / 3.0).abs() < 1e-12);
/// # Ok::<(), IntegralError<()>>(())
/// ```
///
/// # Errors
/// Those of the function; an error that stays larger.
pub fn find_integral<E>(
    mut function: impl FnMut(f64) -> Result<Vec<f64>, E>,
    interval: [f64; 2],
    relative: f64,
    absolute: f64,
) -> Result<Integral, IntegralError<E>> {
    let sized = |at| {
        let value = function(at)?;
        let size = value.iter().fold(0.0, |most: f64, part| most.max(part.abs()));
        Ok((value, size))
    };
    find_sized_integral(sized, interval, [relative, absolute], 0)
}

/// [`find_integral`] of a function that tells its size beside its components, as an integral does that is small
/// because what it adds up cancels. Before it is believed it is asked at so many places more, evenly spread, so that
/// a stretch of it that is wider than what lies between them does not go unseen.
///
/// ```
/// use virote_kernel::find_sized_integral;
///
/// // Rounding about zero, left of numbers of size 1.
/// let noise = |x: f64| Ok::<_, ()>((vec![if (1e9 * x) % 2.0 < 1.0 { 1e-17 } else { -1e-17 }], 1.0));
/// let found = find_sized_integral(noise, [0.0, 3.0], [1e-13, 0.0], 100)?;
/// assert!(found.value[0].abs() < 1e-15 && (found.size - 3.0).abs() < 1e-14);
/// # Ok::<(), virote_kernel::IntegralError<()>>(())
/// ```
///
/// # Errors
/// As for [`find_integral`].
pub fn find_sized_integral<E>(
    mut function: impl FnMut(f64) -> Result<(Vec<f64>, f64), E>,
    interval: [f64; 2],
    allowed: [f64; 2],
    n_looks: usize,
) -> Result<Integral, IntegralError<E>> {
    asked_integral(&mut function, interval, allowed, n_looks)
}

/// [`find_sized_integral`], compiled once for all functions with the same errors.
fn asked_integral<E>(
    function: &mut dyn FnMut(f64) -> Result<(Vec<f64>, f64), E>,
    [start, end]: [f64; 2],
    [relative, absolute]: [f64; 2],
    n_looks: usize,
) -> Result<Integral, IntegralError<E>> {
    let failed = IntegralError::Function;
    let mut pieces =
        BinaryHeap::from(first_pieces(function, [start, end], MOST_LOOKS).map_err(failed)?);
    let (mut n_noisy, mut is_looked_at) = (0, n_looks == 0);
    let mut growth = IntegralGrowth::new([start, end]);
    loop {
        let sum = |what: fn(&IntegrationInterval) -> f64| pieces.iter().map(what).sum::<f64>();
        let (error, size) = (sum(|piece| piece.error), sum(|piece| piece.size));
        let is_known = error.is_finite() && size.is_finite();
        let allowed = absolute.max(relative * size);
        if is_known && error <= allowed {
            let mut settled = pieces.into_vec();
            // To all digits nothing settles beside a place that the integral does not reach.
            if relative * size < absolute {
                let grown = growth.look(function, &mut settled);
                if grown.map_err(|Divergence { at }| endless(at, error))? {
                    pieces = settled.into();
                    continue;
                }
            }
            sort_by(&mut settled, |a, b| a.interval[0].total_cmp(&b.interval[0]));
            if !is_looked_at {
                is_looked_at = true;
                let counts = allowed.max(INTEGRAL_SEEN_RELATIVE * size);
                let looks = places_between([start, end], n_looks);
                if is_cut_at(function, &mut settled, looks, counts).map_err(failed)? {
                    pieces = settled.into();
                    continue;
                }
            }
            let is_wide = |piece: &IntegrationInterval| is_wide(piece, end - start);
            let n_left = INTEGRAL_PIECES.saturating_sub(settled.len());
            if n_left == 0
                || !unseen_jump(function, &mut settled, allowed, is_wide).map_err(failed)?
            {
                return Ok(total(&settled, error, size));
            }
            pieces = settled.into();
            continue;
        }
        let Some(worst) = pieces.pop() else { unreachable!("there is a piece") };
        if !is_wide(&worst, end - start) || INTEGRAL_PIECES <= pieces.len() || !is_known {
            return Err(unsettled(&worst, &pieces, error));
        }
        let mut parts = parts(function, &pieces, &worst, allowed / FINER).map_err(failed)?;
        parts.iter_mut().for_each(|part| growth.weigh(part));
        n_noisy = if is_noise(&worst, &parts) { n_noisy + 1 } else { 0 };
        if n_noisy == NOISY_HALVINGS {
            let (at, reason) = (worst.middle(), IntegralReason::Noise);
            return Err(IntegralError::Unsettled { at, error, reason });
        }
        pieces.extend(parts);
    }
}

/// A piece cut beside its kink, or in halves.
fn parts<E>(
    function: &mut dyn FnMut(f64) -> Result<(Vec<f64>, f64), E>,
    pieces: &BinaryHeap<IntegrationInterval>,
    worst: &IntegrationInterval,
    budget: f64,
) -> Result<Vec<IntegrationInterval>, E> {
    let found = kink(function, pieces, worst, budget);
    match found.map(|kink| beside_kink(function, [worst, worst], kink)) {
        Some(Ok(parts)) => Ok(parts),
        // Where it fails so near to a kink there is a pole.
        _ => halves(function, worst),
    }
}

/// Why the worst piece cannot be divided far enough, beside the others.
fn unsettled<E>(
    worst: &IntegrationInterval,
    pieces: &BinaryHeap<IntegrationInterval>,
    error: f64,
) -> IntegralError<E> {
    match divergence(worst, pieces.iter()) {
        Some(Divergence { at }) => endless(at, error),
        None => {
            let reason = IntegralReason::Slow;
            IntegralError::Unsettled { at: worst.middle(), error, reason }
        }
    }
}

fn endless<E>(at: f64, error: f64) -> IntegralError<E> {
    IntegralError::Unsettled { at, error, reason: IntegralReason::Endless }
}

/// Whether both halves of a piece are off by as much for their width as the whole, and the sum stays.
fn is_noise(whole: &IntegrationInterval, parts: &[IntegrationInterval]) -> bool {
    let [a, b] = parts else { return false };
    let stays = |(whole, (a, b)): (&f64, (&f64, &f64))| {
        (a + b - whole).abs() <= INTEGRAL_NOISE_RELATIVE * whole.abs()
    };
    let least = a.error.min(b.error);
    // Steps that are as large as the function are none, though halves may cancel.
    0.0 < least
        && whole.error <= INTEGRAL_NOISE_RELATIVE * whole.size
        && NOISY_SHARE * whole.error < least
        && a.error + b.error < 2.0 * whole.error
        && whole.value.iter().zip(a.value.iter().zip(&b.value)).all(stays)
}

/// Whether a piece of an interval of some length can be divided.
fn is_wide(piece: &IntegrationInterval, length: f64) -> bool {
    let [from, to] = piece.interval;
    let beside = from.abs().max(to.abs());
    let spacing = beside.next_up() - beside;
    let reaches_zero = from <= 0.0 && 0.0 <= to;
    f64::from(LEAST_SPACINGS) * spacing < to - from
        && (!reaches_zero || INTEGRAL_WIDTH_RELATIVE * length < to - from)
}

/// The sum over all pieces, from the left to the right.
fn total(pieces: &[IntegrationInterval], error: f64, size: f64) -> Integral {
    let mut value = Vec::new();
    for piece in pieces {
        add(&mut value, 1.0, &piece.value);
    }
    Integral { value, error, size }
}

#[cfg(test)]
mod tests {
    use super::{IntegralError, IntegralReason, find_integral, find_sized_integral};

    fn integral(function: fn(f64) -> f64, interval: [f64; 2]) -> Result<f64, IntegralError<()>> {
        find_integral(|x| Ok(vec![function(x)]), interval, 1e-13, 0.0).map(|found| found.value[0])
    }

    #[test]
    fn integrals_are_those_of_closed_forms() {
        let cases: [(fn(f64) -> f64, [f64; 2], f64); 6] = [
            (libm::exp, [0.0, 1.0], std::f64::consts::E - 1.0),
            (|x| libm::sin(50.0 * x), [0.0, 3.0], (1.0 - libm::cos(150.0)) / 50.0),
            (|x| 1.0 / (1e-4 + x * x), [-1.0, 1.0], 200.0 * libm::atan(100.0)),
            (f64::sqrt, [0.0, 1.0], 2.0 / 3.0),
            (|x| 1.0 / x.sqrt(), [0.0, 1.0], 2.0),
            (|x| (x - 0.3).abs(), [0.0, 1.0], 0.29),
        ];
        for (function, interval, expected) in cases {
            let found = integral(function, interval).expect("an integral");
            assert!((found / expected - 1.0).abs() < 1e-12, "{found}, not {expected}");
        }
        assert!(integral(|_| 0.0, [0.0, 1.0]).expect("zero").abs() < 1e-300);
    }

    #[test]
    fn what_is_large_at_an_end_alone_is_seen() {
        let cases: [(fn(f64) -> f64, [f64; 2], f64); 6] = [
            (|x| libm::exp(-x), [0.0, 1e6], 1.0),
            (|x| libm::exp(-x), [0.0, 1e300], 1.0),
            (|x| libm::pow(x, -2.0), [1.0, 1e300], 1.0),
            (|x| 1.0 / x, [1.0, 1e300], 690.775_527_898_213_7),
            (|x| libm::exp(x), [-1e9, 1.0], std::f64::consts::E),
            (|x| libm::exp(-x * x), [-1e3, 1e9], 1.772_453_850_905_516),
        ];
        for (function, interval, expected) in cases {
            let found = integral(function, interval).expect("an integral");
            assert!((found / expected - 1.0).abs() < 1e-12, "{found}, not {expected}");
        }
    }

    #[test]
    fn kinks_and_jumps_take_few_questions() {
        let cases: [(fn(f64) -> f64, f64); 5] = [
            (|x| (x - 0.3).abs(), 0.29),
            (|x| if x < 0.3 { libm::exp(x) } else { 0.0 }, 0.349_858_807_576_003_1),
            (|x| if x < 0.77 { 1.0 } else { libm::cos(x - 0.77) }, 0.77 + 0.227_977_523_535_188_4),
            (|x| (x - 0.6).max(0.0) - (0.2 - x).max(0.0), 0.06),
            (
                |x| (x - 0.613).abs() * (x - 0.613),
                (0.387_f64 * 0.387 * 0.387 - 0.613 * 0.613 * 0.613) / 3.0,
            ),
        ];
        for (function, expected) in cases {
            let mut n_asked = 0;
            let asked = |x| {
                n_asked += 1;
                Ok::<_, ()>(vec![function(x)])
            };
            let found = find_integral(asked, [0.0, 1.0], 1e-13, 0.0).expect("an integral");
            assert!(
                (found.value[0] / expected - 1.0).abs() < 2e-13,
                "{}, not {expected}",
                found.value[0]
            );
            assert!(n_asked < 500, "{n_asked} questions for {expected}");
        }
    }

    #[test]
    fn what_has_no_integral_is_refused_where_that_is() {
        let found = integral(|x| 1.0 / x, [0.0, 1.0]);
        let Err(IntegralError::Unsettled { at, .. }) = found else { unreachable!("{found:?}") };
        assert!(at < 1e-6, "{at}");
        let found = integral(|x| 1.0 / ((x - 0.3) * (x - 0.3)), [0.0, 1.0]);
        assert!(
            matches!(found, Err(IntegralError::Unsettled { at, .. }) if (at - 0.3).abs() < 1e-3)
        );
    }

    #[test]
    fn noise_is_refused_after_a_few_questions() {
        let mut n_asked = 0;
        let noisy = |x: f64| {
            n_asked += 1;
            let noise = libm::sin(1e9 * x) + libm::sin(1e8 * x + 1.0);
            Ok::<_, ()>(vec![4.0 - x * x + 1e-9 * noise])
        };
        let found = find_integral(noisy, [-2.0, 2.0], 1e-13, 0.0);
        let Err(IntegralError::Unsettled { error, reason: IntegralReason::Noise, .. }) = found
        else {
            unreachable!("{found:?}")
        };
        assert!((1e-10..1e-7).contains(&error) && n_asked < 300, "{error} after {n_asked}");
        assert!(find_integral(|x| Ok::<_, ()>(vec![4.0 - x * x]), [-2.0, 2.0], 1e-13, 0.0).is_ok());
        let steps = integral(|x| (3.0 * x).floor(), [0.0, 2.0]).expect("an integral");
        assert!((steps - 5.0).abs() < 1e-12, "{steps}");
    }

    #[test]
    fn what_lies_on_a_part_of_the_range_alone_is_seen() {
        for k in 1..200 {
            let at = 0.01 + 0.97 * (f64::from(k) * 0.618_033_988_749_894_9).fract();
            let pulse = |x: f64| {
                let height = if at < x && x < at + 0.012 { 1.0 } else { 0.0 };
                Ok::<_, ()>((vec![height], height))
            };
            let found = find_sized_integral(pulse, [0.0, 1.0], [1e-13, 0.0], 100);
            let found = found.expect("an integral").value[0];
            assert!((found - 0.012).abs() < 1e-13, "{found} from {at}");
        }
    }

    #[test]
    fn a_function_may_fail_where_it_grows_without_bound() {
        let at =
            |x: f64| if x - 0.3 == 0.0 { Err(x) } else { Ok(vec![libm::log((x - 0.3).abs())]) };
        let found = find_integral(at, [0.0, 1.0], 1e-13, 0.0).expect("an integral");
        let expected = 0.7 * (libm::log(0.7) - 1.0) + 0.3 * (libm::log(0.3) - 1.0);
        assert!((found.value[0] - expected).abs() < 1e-12, "{}", found.value[0]);
    }

    #[test]
    fn a_function_that_fails_ends_it() {
        let found =
            find_integral(|x| if x < 0.9 { Ok(vec![x; 3]) } else { Err(x) }, [0.0, 1.0], 1e-9, 0.0);
        assert!(matches!(found, Err(IntegralError::Function(x)) if 0.9 <= x));
    }

    #[test]
    fn what_is_no_number_is_refused_by_its_first_piece() {
        let mut n_asked = 0;
        let function = |_| {
            n_asked += 1;
            Ok::<_, ()>(vec![f64::NAN])
        };
        let found = find_integral(function, [0.0, 1.0], 1e-9, 0.0);
        assert!(matches!(found, Err(IntegralError::Unsettled { .. })));
        // Eight nodes and sixteen.
        assert_eq!(n_asked, 24);
    }

    #[test]
    fn jumps_are_seen_wherever_they_are() {
        for k in 1..400 {
            // Golden shares come everywhere.
            let at = (f64::from(k) * 0.618_033_988_749_894_9).fract();
            let found = find_integral(
                |x| Ok::<_, ()>(vec![if x < at { 1.0 } else { 0.0 }]),
                [0.0, 1.0],
                1e-13,
                0.0,
            );
            let found = found.expect("an integral");
            assert!((found.value[0] - at).abs() < 2e-13, "{} for {at}", found.value[0]);
            let found = find_integral(
                |x| Ok::<_, ()>(vec![1.0, libm::exp(x) + if x < at { 1.0 } else { 0.0 }]),
                [0.0, 1.0],
                1e-13,
                0.0,
            );
            let (found, expected) =
                (found.expect("an integral").value[1], std::f64::consts::E - 1.0 + at);
            assert!((found - expected).abs() < 1e-12, "{found} for {at}");
        }
    }
}
