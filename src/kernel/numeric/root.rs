//! Roots of functions of one number.

use super::{
    asked_function::AskedFunction,
    least::least_between,
    narrow_bracket::{is_steep, polished},
    root_error::RootError,
    sample::{Sample, is_change, is_zero},
};
use crate::{
    ceiling::{ALL_ROOT_LOOKS, ROOT_LOOKS, ROOT_STEPS},
    tolerance::{JUMP_KEEPS, JUMP_LOOK, ROOT_JUMP_RELATIVE, ROOT_RELATIVE, ROOT_TOUCH_RELATIVE},
};

/// Of so many parts one may hold a root: more roots may come in pairs that samples do not tell.
const CROWDED: usize = 4;

/// One root of a function in an interval, `start` below `end`, as exactly as numbers tell it.
///
/// Where the signs at both ends are the same, the interval is divided until they are not somewhere, and
/// else the function is looked at where it is nearest to zero, since it may only touch it. The root that is
/// found is between two neighbouring numbers with a change of sign, over which the function does not jump. Where
/// the function is exactly zero it is asked a little beside, where it must not be.
/// Chandrupatla, *A new hybrid quadratic/bisection algorithm for finding the zero of a nonlinear function
/// without using derivatives*, Adv. Eng. Software 28 (1997).
///
/// ```
/// use virote_kernel::{find_root, RootError};
///
/// let root = find_root(|x| Ok::<_, ()>(x * x - 2.0), [0.0, 2.0])?;
/// assert!((root.at - 2.0_f64.sqrt()).abs() < 1e-15);
/// let pole = find_root(|x| Ok::<_, ()>(1.0 / (x - 0.3)), [0.0, 2.0]);
/// assert!(matches!(pole, Err(RootError::Jump { .. })));
/// # Ok::<(), RootError<()>>(())
/// ```
///
/// # Errors
/// Those of the function; no root; a jump over zero; a stretch along which it is zero.
pub fn find_root<E>(
    function: impl FnMut(f64) -> Result<f64, E>,
    interval: [f64; 2],
) -> Result<Sample, RootError<E>> {
    sought(function, interval, TouchingRoot::IsRoot)
}

/// The same, of a function of which others tell where it only touches zero: that is no root here, however near it
/// comes.
///
/// ```
/// use virote_kernel::{find_crossing, RootError};
///
/// let touch = find_crossing(|x| Ok::<_, ()>((x - 0.7) * (x - 0.7)), [0.0, 2.0]);
/// assert!(matches!(touch, Err(RootError::NoRoot { nearest, .. }) if (nearest.at - 0.7).abs() < 1e-6));
/// ```
///
/// # Errors
/// Those of [`find_root`].
pub fn find_crossing<E>(
    function: impl FnMut(f64) -> Result<f64, E>,
    interval: [f64; 2],
) -> Result<Sample, RootError<E>> {
    sought(function, interval, TouchingRoot::IsNone)
}

/// Whether a place where a function comes as near to zero as rounding tells, and does not cross it, is a root.
#[derive(Clone, Copy, PartialEq, Eq)]
enum TouchingRoot {
    IsRoot,
    IsNone,
}

fn sought<E>(
    function: impl FnMut(f64) -> Result<f64, E>,
    [start, end]: [f64; 2],
    touches: TouchingRoot,
) -> Result<Sample, RootError<E>> {
    let mut asked = AskedFunction::new(function, [start, end]);
    let ends = [asked.at(start)?, asked.at(end)?];
    let mut samples = ends.to_vec();
    loop {
        if let Some(root) = samples.iter().find(|sample| is_zero(sample.value)) {
            return asked.single(*root);
        }
        if let Some(pair) = samples.windows(2).find(|pair| is_change(pair[0], pair[1])) {
            return between(&mut asked, [pair[0], pair[1]], end - start);
        }
        if ROOT_LOOKS < samples.len() {
            break;
        }
        samples = halved(&mut asked, &samples)?;
    }
    touch(&mut asked, &samples, touches)?.map_err(|nearest| RootError::NoRoot { nearest, ends })
}

/// Every root of a function in an interval that samples at equal distances tell apart, in order: roots
/// that are nearer to one another may be missed in pairs. A jump over zero, such as a pole, is no root and is passed over,
/// where the function is clearly no steep one.
///
/// ```
/// use virote_kernel::{RootError, find_roots};
///
/// let step = |x: f64| Ok::<_, ()>(if x < 1.0 { -1.0 - x } else { 3.0 - x });
/// let roots: Vec<f64> = find_roots(step, [0.0, 5.0])?.iter().map(|root| root.at).collect();
/// assert_eq!(roots, [3.0]);
/// # Ok::<(), RootError<()>>(())
/// ```
///
/// # Errors
/// Those of the function; what may be a jump over zero or a steep root; a stretch along which it is zero; roots in every
/// fourth part or more.
pub fn find_roots<E>(
    function: impl FnMut(f64) -> Result<f64, E>,
    [start, end]: [f64; 2],
) -> Result<Vec<Sample>, RootError<E>> {
    let mut asked = AskedFunction::new(function, [start, end]);
    let mut samples = vec![asked.at(start)?, asked.at(end)?];
    while samples.len() <= ALL_ROOT_LOOKS {
        samples = halved(&mut asked, &samples)?;
    }
    let n_parts = samples.len() - 1;
    let is_root = |pair: &&[Sample]| is_zero(pair[0].value) || is_change(pair[0], pair[1]);
    let n_roots = samples.windows(2).filter(is_root).count();
    let is_flat = samples.windows(2).any(|pair| pair.iter().all(|sample| is_zero(sample.value)));
    if n_parts < CROWDED * n_roots && !is_flat {
        return Err(RootError::Crowded { n_roots: [n_roots, n_parts] });
    }
    let mut roots = Vec::new();
    for (i, pair) in samples.windows(2).enumerate() {
        if is_zero(pair[0].value) {
            roots.push(asked.single(pair[0])?);
        } else if is_change(pair[0], pair[1]) {
            let found = between(&mut asked, [pair[0], pair[1]], end - start);
            roots.extend(unless_jump(&mut asked, [pair[0].at, pair[1].at], found)?);
        } else if let [before, middle, after] = samples[i..(i + 3).min(samples.len())]
            && is_valley(before, middle, after)
            && let Ok(root) =
                touch_between(&mut asked, [before, middle, after], TouchingRoot::IsRoot)?
        {
            roots.push(root);
        }
    }
    if let Some(last) = samples.last().filter(|sample| is_zero(sample.value)) {
        roots.push(asked.single(*last)?);
    }
    Ok(roots)
}

/// What was found between two places; none where the function jumps over zero, to which it then comes no nearer.
fn unless_jump<E, F: FnMut(f64) -> Result<f64, E>>(
    asked: &mut AskedFunction<F>,
    [low, high]: [f64; 2],
    found: Result<Sample, RootError<E>>,
) -> Result<Option<Sample>, RootError<E>> {
    let Err(RootError::Jump { sides }) = found else { return found.map(Some) };
    for (side, away) in sides.into_iter().zip([-JUMP_LOOK, JUMP_LOOK]) {
        let beside = asked.at((side.at + away * (high - low)).clamp(low, high))?;
        if side.value.abs() < JUMP_KEEPS * beside.value.abs() {
            return Err(RootError::Jump { sides });
        }
    }
    Ok(None)
}

/// Whether a function comes nearest to zero at the middle one of three places, without a root at them.
fn is_valley(before: Sample, middle: Sample, after: Sample) -> bool {
    let [a, b, c] = [before, middle, after].map(|sample| sample.value.abs());
    !is_change(before, middle) && !is_change(middle, after) && 0.0 < b && b <= a && b <= c
}

/// The samples with one in the middle between any two neighbours.
fn halved<E, F: FnMut(f64) -> Result<f64, E>>(
    asked: &mut AskedFunction<F>,
    samples: &[Sample],
) -> Result<Vec<Sample>, E> {
    let mut all = Vec::with_capacity(2 * samples.len());
    for pair in samples.windows(2) {
        all.extend([pair[0], asked.at(0.5 * (pair[0].at + pair[1].at))?]);
    }
    all.extend(samples.last());
    Ok(all)
}

/// The root between two places with values of different signs.
fn between<E, F: FnMut(f64) -> Result<f64, E>>(
    asked: &mut AskedFunction<F>,
    [mut b, mut a]: [Sample; 2],
    interval: f64,
) -> Result<Sample, RootError<E>> {
    let mut share = 0.5;
    for _ in 0..ROOT_STEPS {
        let new = asked.at(a.at + share * (b.at - a.at))?;
        let c = if is_change(new, a) { std::mem::replace(&mut b, a) } else { a };
        a = new;
        let best = if a.value.abs() < b.value.abs() { a } else { b };
        let spacing = best.at.abs().next_up() - best.at.abs();
        let rest = (2.0 * spacing).max(ROOT_RELATIVE * interval) / (b.at - a.at).abs();
        if is_zero(best.value) {
            return asked.single(best);
        }
        if 0.5 <= rest {
            break;
        }
        share = next_share([a, b, c]).clamp(rest, 1.0 - rest);
    }
    let sides = if a.at < b.at { [a, b] } else { [b, a] };
    let is_far = ROOT_JUMP_RELATIVE * asked.size < (a.value - b.value).abs();
    if is_far && !is_steep(asked, sides)? {
        return Err(RootError::Jump { sides });
    }
    polished(asked, [a, b])
}

/// Where between a and b the root is looked for next: by inverse quadratic interpolation where that is
/// sure to converge, else in the middle.
fn next_share([a, b, c]: [Sample; 3]) -> f64 {
    let xi = (a.at - b.at) / (c.at - b.at);
    let phi = (a.value - b.value) / (c.value - b.value);
    if !(phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi) {
        return 0.5;
    }
    let first = a.value / (b.value - a.value) * c.value / (b.value - c.value);
    let second = (c.at - a.at) / (b.at - a.at) * a.value / (c.value - a.value) * b.value
        / (c.value - b.value);
    first + second
}

/// Where a function without a change of sign touches zero, else where it is nearest to that.
fn touch<E, F: FnMut(f64) -> Result<f64, E>>(
    asked: &mut AskedFunction<F>,
    samples: &[Sample],
    touches: TouchingRoot,
) -> Result<Result<Sample, Sample>, RootError<E>> {
    let nearer = |a: &&Sample, b: &&Sample| a.value.abs().total_cmp(&b.value.abs());
    let Some(&nearest) = samples.iter().min_by(nearer) else { unreachable!("there are ends") };
    let valley = samples.windows(3).find(|trio| trio[1] == nearest);
    match valley {
        Some(&[before, middle, after]) => touch_between(asked, [before, middle, after], touches),
        _ => Ok(Err(nearest)),
    }
}

fn touch_between<E, F: FnMut(f64) -> Result<f64, E>>(
    asked: &mut AskedFunction<F>,
    [before, middle, after]: [Sample; 3],
    touches: TouchingRoot,
) -> Result<Result<Sample, Sample>, RootError<E>> {
    let sign = middle.value.signum();
    let size = asked.size;
    let mut crossed = None;
    let least = least_between(
        |at| {
            let sample = asked.at(at)?;
            if sample.value * sign < 0.0 {
                crossed = Some(sample);
            }
            Ok::<f64, E>(sample.value * sign)
        },
        [before.at, middle.at, after.at],
        middle.value * sign,
    )?;
    if let Some(beyond) = crossed {
        return between(asked, [before, beyond], after.at - before.at).map(Ok);
    }
    let least = Sample { at: least.at, value: least.value * sign };
    let is_root =
        touches == TouchingRoot::IsRoot && least.value.abs() <= ROOT_TOUCH_RELATIVE * size;
    Ok(if is_root { Ok(least) } else { Err(least) })
}

#[cfg(test)]
mod tests {
    use super::{RootError, Sample, find_root, find_roots};

    fn root(
        function: impl Fn(f64) -> f64,
        interval: [f64; 2],
    ) -> (Result<Sample, RootError<()>>, usize) {
        let mut n = 0;
        let found = find_root(
            |x| {
                n += 1;
                Ok(function(x))
            },
            interval,
        );
        (found, n)
    }

    #[test]
    fn roots_are_found_to_the_last_digit_in_few_steps() {
        let cases: [(fn(f64) -> f64, [f64; 2], f64); 7] = [
            (|x| x * x - 2.0, [0.0, 2.0], std::f64::consts::SQRT_2),
            (|x| libm::cos(x) - x, [0.0, 1.0], 0.739_085_133_215_160_6),
            (|x| libm::exp(x) - 1e6, [0.0, 20.0], 13.815_510_557_964_274),
            (|x| x * x * x - 1e-9, [-1.0, 1.0], 1e-3),
            (|x| 1.0 - 5.0 * x, [-3.0, 8.0], 0.2),
            (|x| x - 1e-200, [-1.0, 1.0], 1e-200),
            (|x| x - 1e-9, [-1e9, 1e9], 1e-9),
        ];
        for (function, interval, expected) in cases {
            let (found, n) = root(function, interval);
            let at = found.expect("a root").at;
            assert!((at - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(), "{at}");
            assert!(n <= 30, "{n} for {expected}");
        }
    }

    #[test]
    fn roots_between_ends_of_one_sign_are_found() {
        let (found, _) = root(|x| (x - 1.0) * (x - 1.3), [0.0, 2.0]);
        let at = found.expect("a root").at;
        assert!((at - 1.0).abs() < 1e-14 || (at - 1.3).abs() < 1e-14, "{at}");
        let (touch, _) = root(|x| (x - 0.7) * (x - 0.7), [0.0, 2.0]);
        assert!((touch.expect("a touch").at - 0.7).abs() < 1e-7);
    }

    #[test]
    fn what_is_no_root_is_none() {
        let (above, _) = root(|x| x * x + 0.1, [-1.0, 2.0]);
        let Err(RootError::NoRoot { nearest, ends }) = above else { unreachable!("{above:?}") };
        assert!(nearest.at.abs() < 1e-6 && (ends[1].value - 4.1).abs() < 1e-15);
        let (step, _) = root(|x| if x < 0.3 { -1.0 } else { 1.0 }, [0.0, 1.0]);
        let Err(RootError::Jump { sides }) = step else { unreachable!("{step:?}") };
        assert!(sides[0].at < 0.3 && 0.3 <= sides[1].at && sides[1].at - sides[0].at < 1e-15);
        let (pole, _) = root(|x| 1.0 / (x - 0.3), [0.0, 1.0]);
        assert!(matches!(pole, Err(RootError::Jump { .. })));
        let (steep, _) = root(|x| libm::cbrt(x - 0.3), [0.0, 1.0]);
        assert!((steep.expect("a root").at - 0.3).abs() < 1e-15);
    }

    #[test]
    fn a_stretch_of_zeros_is_no_root() {
        let stretch = |function: fn(f64) -> f64| match root(function, [0.0, 2.0]).0 {
            Err(RootError::Flat { stretch }) => stretch,
            other => unreachable!("{other:?}"),
        };
        let [from, to] = stretch(|_| 0.0);
        assert!(from <= 0.0 && 2.0 <= to, "{from} {to}");
        let [from, to] = stretch(|x| (x - 1.3).max(0.0) + (x - 0.4).min(0.0));
        assert!(0.4 <= from && from < to && to <= 1.3, "{from} {to}");
        let all = find_roots(|x: f64| Ok::<_, ()>((x - 1.3).max(0.0)), [0.0, 2.0]);
        assert!(matches!(all, Err(RootError::Flat { .. })));
        // Zero at one place only, however flat, and beside a place where it fails.
        assert!(
            (root(|x| libm::pow(x - 1.0, 21.0), [0.0, 2.0]).0.expect("a root").at - 1.0).abs()
                < 1e-15
        );
        let edge = find_root(|x| if x < 1e-9 { Ok(x) } else { Err(()) }, [0.0, 0.0_f64.next_up()]);
        assert!(edge.expect("a root").at < 1e-300);
    }

    #[test]
    fn all_roots_come_in_order() {
        let found = find_roots(|x| Ok::<_, ()>(libm::sin(x)), [-1.0, 10.0]).expect("roots");
        let expected = [0.0, 1.0, 2.0, 3.0].map(|k| k * std::f64::consts::PI);
        assert_eq!(found.len(), 4);
        for (found, expected) in found.iter().zip(expected) {
            assert!((found.at - expected).abs() < 1e-14, "{}", found.at);
        }
        let crowded = find_roots(|x| Ok::<_, ()>(libm::sin(700.0 * x)), [0.0, 1.0]);
        assert!(matches!(crowded, Err(RootError::Crowded { n_roots: [223, 256] })), "{crowded:?}");
        // Ends, and touches.
        let found =
            find_roots(|x| Ok::<_, ()>(x * (x - 0.31) * (x - 0.31) * (x - 1.0)), [0.0, 1.0]);
        let places: Vec<f64> = found.expect("roots").iter().map(|root| root.at).collect();
        assert!(places.len() == 3 && (places[1] - 0.31).abs() < 1e-6, "{places:?}");
    }
}
