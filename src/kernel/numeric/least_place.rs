//! The last digits of the place at which a function of one number is least.

use super::{bisection::try_bisected, root::find_root, root_error::RootError};
use crate::{
    ceiling::LEAST_BRACKETS,
    tolerance::{LAST_BIT, LEAST_PLACE_RELATIVE},
};

/// By how many times a bracket of the place grows where its ends do not tell that it is one.
const WIDER: f64 = 8.0;

/// Halvings of what a search for a kink leaves open: a few numbers.
const KINK_HALVINGS: usize = 5;

/// The place near another one, inside an interval, at which a function is least, as exactly as numbers tell it: its
/// slope goes from below zero to above it there. Values alone tell half of its digits. Where the function has no slope,
/// as at a kink, that is the place; the other one is told where none is known beside it either, where it is an end of the
/// interval, and where slopes do not tell that the function falls before and rises behind.
///
/// ```
/// use virote_kernel::{find_least, find_least_place};
///
/// let found = find_least(|x: f64| Ok::<_, ()>((x - 0.3).cosh()), [0.0, 2.0])?;
/// let place = find_least_place(|x| Ok::<_, ()>(Some((x - 0.3).sinh())), [0.0, 2.0], found.at)?;
/// assert!((place - 0.3).abs() < 1e-15 && 1e-15 < (found.at - 0.3).abs());
/// # Ok::<(), ()>(())
/// ```
///
/// # Errors
/// Those of the slope.
pub fn find_least_place<E>(
    mut slope: impl FnMut(f64) -> Result<Option<f64>, E>,
    [start, end]: [f64; 2],
    near: f64,
) -> Result<f64, E> {
    let mut reach = LEAST_PLACE_RELATIVE * (end - start);
    reach = reach.max(4.0 * LAST_BIT * near.abs());
    for _ in 0..LEAST_BRACKETS {
        let [low, high] = [(near - reach).max(start), (near + reach).min(end)];
        let Some(before) = slope(low)? else { break };
        if low <= start && 0.0 <= before {
            break;
        }
        let Some(behind) = slope(high)? else { break };
        if end <= high && behind <= 0.0 {
            break;
        }
        if before < 0.0 && 0.0 < behind {
            let found = find_root(|at| Ok::<_, E>(slope(at)?.unwrap_or(0.0)), [low, high]);
            return match found {
                Ok(place) => Ok(place.at),
                // A kink: the last place before which the function falls.
                Err(RootError::Jump { sides }) => {
                    let falls_before = |at| Ok(slope(at)?.is_none_or(|slope| slope < 0.0));
                    let sides = sides.map(|side| side.at);
                    try_bisected(sides, KINK_HALVINGS, falls_before).map(|[place, _]| place)
                }
                Err(RootError::Function(err)) => Err(err),
                Err(_) => Ok(near),
            };
        }
        reach *= WIDER;
    }
    Ok(near)
}

#[cfg(test)]
mod tests {
    use super::find_least_place;

    fn place(slope: fn(f64) -> Option<f64>, near: f64) -> f64 {
        find_least_place(|x| Ok::<_, ()>(slope(x)), [-1.0, 4.0], near).expect("no failure")
    }

    #[test]
    fn slopes_tell_all_digits() {
        let third = 1.0 / 3.0;
        let found = place(|x| Some(libm::sinh(x - 1.0 / 3.0)), third + 3e-7);
        assert!((found - third).abs() < 1e-15, "{found}");
        // A kink, with a slope on it and without.
        let sign = |x: f64| if x < 1.0 / 3.0 { -1.0 } else { 2.0 };
        let found = place(|x| Some(if x < 1.0 / 3.0 { -1.0 } else { 2.0 }), third - 1e-8);
        assert!((found - third).abs() < 1e-15 && sign(found + 1e-15) > 0.0, "{found}");
        let found = place(|x| (0.0 < (x - 0.5).abs()).then(|| (x - 0.5).signum()), 0.5 + 1e-8);
        assert!((found - 0.5).abs() <= 0.0, "{found}");
    }

    #[test]
    fn where_slopes_tell_nothing_the_place_stays() {
        let stays = |slope: fn(f64) -> Option<f64>, near: f64| {
            let found = place(slope, near);
            assert!((found - near).abs() <= 0.0, "{found} for {near}");
        };
        stays(|_| None, 0.7);
        stays(|_| Some(1.0), -1.0);
        stays(|_| Some(-1.0), 4.0);
        stays(|_| Some(0.0), 0.7);
        stays(|x| Some(0.7 - x), 0.7 + 1e-9);
    }
}
