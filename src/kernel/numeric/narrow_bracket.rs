//! A bracket of a root that is as narrow as numbers tell: whether there is a root, and where.

use super::{
    asked_function::AskedFunction,
    root_error::RootError,
    sample::{Sample, is_change, is_zero},
};
use crate::tolerance::{JUMP_KEEPS, JUMP_LOOK, STEEP_POWER_KEEPS};

/// Steps by which a root is polished whose bracket is narrow beside the interval but not beside itself.
const POLISHING: usize = 4;

/// How many widths of the bracket beside it a function is asked first: nearer by its places are rounded.
const NEAREST: f64 = 64.0;

/// How many times as far it is asked at least, for as much as a power to be told.
const REACH: [f64; 2] = [1e2, 1e4];

/// Whether a function comes to zero between neighbours with values of different signs though both are far from it: towards
/// a root with a vertical tangent its size shrinks as a power of the distance; towards a jump that power fades, and
/// towards a pole it grows.
pub(super) fn is_steep<E, F: FnMut(f64) -> Result<f64, E>>(
    asked: &mut AskedFunction<F>,
    [before, behind]: [Sample; 2],
) -> Result<bool, E> {
    let [start, end] = asked.ends;
    let near = NEAREST * (behind.at - before.at);
    for (side, room) in [(before, start - before.at), (behind, end - behind.at)] {
        let far = (JUMP_LOOK * (end - start)).max(REACH[1] * near).min(0.5 * room.abs());
        if far < REACH[0] * near {
            return Ok(false);
        }
        let middle = (near * far).sqrt();
        let mut sizes = [0.0; 3];
        for (size, distance) in sizes.iter_mut().zip([near, middle, far]) {
            let sample = asked.at(side.at + distance.copysign(room))?;
            *size = sample.value * side.value.signum();
        }
        // Both distances grow by the same factor.
        let powers = [sizes[1] / sizes[0], sizes[2] / sizes[1]].map(libm::log);
        let shrinks = 0.0 < sizes[0] && sizes[0] < JUMP_KEEPS * sizes[2];
        if !(shrinks && STEEP_POWER_KEEPS * powers[1] <= powers[0]) {
            return Ok(false);
        }
    }
    Ok(true)
}

/// The root in a narrow bracket, from one end of it to the other along the chord, as far as that leads nearer to zero.
pub(super) fn polished<E, F: FnMut(f64) -> Result<f64, E>>(
    asked: &mut AskedFunction<F>,
    [mut a, mut b]: [Sample; 2],
) -> Result<Sample, RootError<E>> {
    let nearer = |a: Sample, b: Sample| if a.value.abs() < b.value.abs() { a } else { b };
    let mut best = nearer(a, b);
    for _ in 0..POLISHING {
        let at = best.at - best.value * ((b.at - a.at) / (b.value - a.value));
        if !(a.at.min(b.at) < at && at < a.at.max(b.at)) {
            break;
        }
        let new = asked.at(at)?;
        if best.value.abs() <= new.value.abs() {
            break;
        }
        best = new;
        if is_zero(new.value) {
            break;
        }
        *(if is_change(new, a) { &mut b } else { &mut a }) = new;
    }
    Ok(best)
}

#[cfg(test)]
mod tests {
    use crate::{RootError, find_root};

    /// Where the root is that is found between 0 and 3; none where the function jumps.
    fn root(function: impl Fn(f64) -> f64) -> Option<f64> {
        match find_root(|x| Ok::<_, ()>(function(x)), [0.0, 3.0]) {
            Ok(root) => Some(root.at),
            Err(RootError::Jump { .. }) => None,
            Err(other) => unreachable!("{other:?}"),
        }
    }

    #[test]
    fn roots_with_vertical_tangents_are_roots() {
        for power in [0.05, 0.1, 0.2, 1.0 / 3.0, 0.5] {
            let steep = |x: f64| {
                let square = x * x - 2.0;
                libm::copysign(libm::pow(square.abs(), power), square)
            };
            let at = root(steep).unwrap_or(f64::NAN);
            assert!((at - 2.0_f64.sqrt()).abs() < 1e-15, "{at} for the power {power}");
        }
    }

    #[test]
    fn jumps_beside_which_a_function_is_steep_are_none() {
        for (rise, power) in
            [(0.0, 1.0), (1.0, 0.1), (10.0, 0.1), (10.0, 0.5), (1e3, 0.5), (1e3, 1.0)]
        {
            let step = |x: f64| {
                let off = x - 1.3;
                libm::copysign(1.0 + rise * libm::pow(off.abs(), power), off)
            };
            assert_eq!(root(step), None, "{rise} {power}");
        }
        // Poles that no number is exactly on.
        let square = |x: f64| x * x - 2.0;
        assert_eq!(root(|x| 1.0 / square(x)), None);
        let logarithm = |x: f64| 1.0 - libm::log(square(x).abs());
        assert_eq!(root(|x| libm::copysign(logarithm(x), square(x))), None);
    }
}
