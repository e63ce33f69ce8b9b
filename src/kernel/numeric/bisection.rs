//! Bisection: the border between where something holds and where it does not.
//!
//! Burden & Faires, *Numerical Analysis*, §2.1.

use std::convert::Infallible;

/// The bracket of a border after so many halvings, from a place where something holds (of which
/// nobody is asked) and one where it does not, in either order: the last places known to be one
/// and the other.
pub(crate) fn bisected(
    bracket: [f64; 2],
    n_halvings: usize,
    mut holds: impl FnMut(f64) -> bool,
) -> [f64; 2] {
    let Ok(found) = try_bisected(bracket, n_halvings, |t| Ok::<_, Infallible>(holds(t)));
    found
}

/// [`bisected`] by a question that may fail.
///
/// # Errors
/// Those of the question.
pub(crate) fn try_bisected<E>(
    [mut on, mut off]: [f64; 2],
    n_halvings: usize,
    mut holds: impl FnMut(f64) -> Result<bool, E>,
) -> Result<[f64; 2], E> {
    for _ in 0..n_halvings {
        let middle = 0.5 * (on + off);
        if holds(middle)? {
            on = middle;
        } else {
            off = middle;
        }
    }
    Ok([on, off])
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "exactness is the claim")]
mod tests {
    use super::{bisected, try_bisected};

    #[test]
    fn a_border_is_found_to_the_last_bit_from_either_side() {
        let (on, off) = (std::f64::consts::FRAC_PI_3.next_down(), std::f64::consts::FRAC_PI_3);
        assert_eq!(bisected([0.0, 4.0], 60, |t| t < off), [on, off]);
        assert_eq!(bisected([4.0, 0.0], 60, |t| off <= t), [off, on]);
    }

    #[test]
    fn each_halving_halves_the_bracket() {
        for n in 0..20 {
            let [on, off] = bisected([0.0, 1.0], n, |t| t * t < 0.5);
            assert!(on * on < 0.5 && 0.5 <= off * off, "{on} {off}");
            assert_eq!((off - on) * libm::exp2(n as f64), 1.0);
        }
    }

    #[test]
    fn a_question_that_fails_ends_it() {
        let mut n_asked = 0;
        let asked = try_bisected([0.0, 1.0], 60, |_| {
            n_asked += 1;
            if n_asked < 5 { Ok(true) } else { Err("no answer") }
        });
        assert_eq!((asked, n_asked), (Err("no answer"), 5));
    }
}
