//! Integrals of functions of one number, to a stated error.

use std::{cmp::Ordering, collections::BinaryHeap};

use super::gauss_legendre::{EIGHT_NODES, GaussRule, SIXTEEN_NODES};
use crate::{ceiling::INTEGRAL_PIECES, tolerance::INTEGRAL_WIDTH_RELATIVE};

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

/// Why there is no integral.
///
/// ```
/// use virote_kernel::{IntegralError, find_integral};
///
/// let found = find_integral(|x| Ok::<_, ()>(vec![1.0 / x]), [0.0, 1.0], 1e-13, 0.0);
/// assert!(matches!(found, Err(IntegralError::Unsettled { at, .. }) if at < 1e-9));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum IntegralError<E> {
    /// The function failed.
    Function(E),
    /// The error does not go below what was asked for.
    Unsettled {
        /// Where it is largest.
        at: f64,
        /// What it is.
        error: f64,
    },
}

/// Numbers between the ends of a piece that is divided: nodes are no longer places of their own in less.
const LEAST_SPACINGS: u32 = 256;

/// A piece of the interval with what the rules say of it; the one with the largest error comes first.
struct IntegrationInterval {
    interval: [f64; 2],
    value: Vec<f64>,
    size: f64,
    error: f64,
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

/// The integral of a function of some components, as many everywhere, over an interval, `start` below `end`, with an
/// error of at most `relative` times the integral of the function's size, or of `absolute`.
///
/// The piece of which rules with eight and with sixteen nodes say most different things is halved, until
/// they agree. Ends of the interval are never asked for, so that a function may grow there without bound as
/// long as its integral does not. Piessens et al., *QUADPACK*, §2.2.1 (QAG).
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
    find_sized_integral(sized, interval, relative, absolute)
}

/// [`find_integral`] of a function that tells its size beside its components, as an integral does that is small
/// because what it adds up cancels.
///
/// ```
/// use virote_kernel::find_sized_integral;
///
/// // Rounding about zero, left of numbers of size 1.
/// let noise = |x: f64| Ok::<_, ()>((vec![if (1e9 * x) % 2.0 < 1.0 { 1e-17 } else { -1e-17 }], 1.0));
/// let found = find_sized_integral(noise, [0.0, 3.0], 1e-13, 0.0)?;
/// assert!(found.value[0].abs() < 1e-15 && (found.size - 3.0).abs() < 1e-14);
/// # Ok::<(), virote_kernel::IntegralError<()>>(())
/// ```
///
/// # Errors
/// As for [`find_integral`].
pub fn find_sized_integral<E>(
    mut function: impl FnMut(f64) -> Result<(Vec<f64>, f64), E>,
    [start, end]: [f64; 2],
    relative: f64,
    absolute: f64,
) -> Result<Integral, IntegralError<E>> {
    let mut ask = |interval| piece(&mut function, interval).map_err(IntegralError::Function);
    let mut pieces = BinaryHeap::from([ask([start, end])?]);
    loop {
        let sum = |what: fn(&IntegrationInterval) -> f64| pieces.iter().map(what).sum::<f64>();
        let (error, size) = (sum(|piece| piece.error), sum(|piece| piece.size));
        let is_known = error.is_finite() && size.is_finite();
        if is_known && error <= absolute.max(relative * size) {
            return Ok(total(pieces.into_sorted_vec(), error, size));
        }
        let Some(worst) = pieces.pop() else { unreachable!("there is a piece") };
        let [from, to] = worst.interval;
        let middle = 0.5 * (from + to);
        let beside = from.abs().max(to.abs());
        let spacing = beside.next_up() - beside;
        let is_wide = INTEGRAL_WIDTH_RELATIVE * (end - start) < to - from
            && f64::from(LEAST_SPACINGS) * spacing < to - from;
        if !is_wide || INTEGRAL_PIECES <= pieces.len() || !is_known {
            return Err(IntegralError::Unsettled { at: middle, error });
        }
        pieces.extend([ask([from, middle])?, ask([middle, to])?]);
    }
}

/// The sum over all pieces, from the left to the right.
fn total(mut pieces: Vec<IntegrationInterval>, error: f64, size: f64) -> Integral {
    pieces.sort_by(|a, b| a.interval[0].total_cmp(&b.interval[0]));
    let mut value = Vec::new();
    for piece in &pieces {
        add(&mut value, 1.0, &piece.value);
    }
    Integral { value, error, size }
}

fn piece<E>(
    function: &mut impl FnMut(f64) -> Result<(Vec<f64>, f64), E>,
    interval: [f64; 2],
) -> Result<IntegrationInterval, E> {
    let (rough, _) = by_rule(function, &EIGHT_NODES, interval)?;
    let (value, size) = by_rule(function, &SIXTEEN_NODES, interval)?;
    let apart = value.iter().zip(&rough).map(|(value, rough)| (value - rough).abs());
    // `max` passes over what is no number.
    let is_known = value.iter().chain(&rough).all(|part| part.is_finite());
    let error = if is_known { apart.fold(0.0, f64::max) } else { f64::INFINITY };
    Ok(IntegrationInterval { interval, value, size, error })
}

/// The integral by one rule, and that of the size.
fn by_rule<const HALF: usize, E>(
    function: &mut impl FnMut(f64) -> Result<(Vec<f64>, f64), E>,
    rule: &GaussRule<HALF>,
    [start, end]: [f64; 2],
) -> Result<(Vec<f64>, f64), E> {
    let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
    let (mut sum, mut size) = (Vec::new(), 0.0);
    for &[node, weight] in rule {
        for at in [middle - half * node, middle + half * node] {
            let (value, own_size) = function(at)?;
            add(&mut sum, weight * half, &value);
            size += weight * half * own_size;
        }
    }
    Ok((sum, size))
}

/// Adds components with a factor.
fn add(sum: &mut Vec<f64>, factor: f64, value: &[f64]) {
    sum.resize(value.len(), 0.0);
    sum.iter_mut().zip(value).for_each(|(sum, part)| *sum += factor * part);
}

#[cfg(test)]
mod tests {
    use super::{IntegralError, find_integral};

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
}
