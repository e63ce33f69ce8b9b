//! The least value of a function of one number.

use super::sample::Sample;
use crate::{
    ceiling::{LEAST_LOOKS, LEAST_STEPS},
    tolerance::LEAST_PLACE_RELATIVE,
};

/// The place in an interval at which a function is least, and its value there.
///
/// Places at equal distances tell near which the least value is; from there on Brent's method goes on. A
/// valley between two of these places in which no other is lower than theirs is missed. The least value may
/// stand at an end.
///
/// ```
/// use virote_kernel::find_least;
///
/// let least = find_least(|x| Ok::<_, ()>((x - 0.3) * (x - 0.3) + 1.0), [0.0, 2.0])?;
/// assert!((least.at - 0.3).abs() < 1e-7 && (least.value - 1.0).abs() < 1e-15);
/// # Ok::<(), ()>(())
/// ```
///
/// # Errors
/// Those of the function.
pub fn find_least<E>(
    mut function: impl FnMut(f64) -> Result<f64, E>,
    [start, end]: [f64; 2],
) -> Result<Sample, E> {
    let at = |k: usize| match k {
        LEAST_LOOKS => end,
        _ => start + (end - start) * (k as f64 / LEAST_LOOKS as f64),
    };
    let values = (0..=LEAST_LOOKS).map(|k| function(at(k))).collect::<Result<Vec<f64>, E>>()?;
    let lower = |&a: &usize, &b: &usize| values[a].total_cmp(&values[b]);
    let k = (0..=LEAST_LOOKS).min_by(lower).unwrap_or(0);
    let known = Sample { at: at(k), value: values[k] };
    let around = [at(k.saturating_sub(1)), at(k), at((k + 1).min(LEAST_LOOKS))];
    let found = least_between(&mut function, around, known.value)?;
    Ok(if found.value < known.value { found } else { known })
}

/// The least value between two places, with one between them or at one of them whose value is known.
///
/// Brent, *Algorithms for Minimization without Derivatives*, ch. 5: parabolas through the three lowest
/// places, and golden sections where these do not converge.
pub(super) fn least_between<E>(
    mut function: impl FnMut(f64) -> Result<f64, E>,
    [mut low, middle, mut high]: [f64; 3],
    value: f64,
) -> Result<Sample, E> {
    let golden = 0.5 * (3.0 - 5.0_f64.sqrt());
    let mut best = Sample { at: middle, value };
    let [mut second, mut third] = [best; 2];
    let (mut step, mut before) = (0.0_f64, 0.0_f64);
    let least_step = LEAST_PLACE_RELATIVE * (high - low);
    for _ in 0..LEAST_STEPS {
        let center = 0.5 * (low + high);
        let near = (LEAST_PLACE_RELATIVE * best.at.abs()).min(least_step);
        let spacing = 2.0 * (best.at.abs().next_up() - best.at.abs());
        let near = near.max(spacing);
        if (best.at - center).abs() <= 2.0 * near - 0.5 * (high - low) {
            break;
        }
        let parabola = parabola_step(best, second, third).filter(|parabola| {
            let at = best.at + parabola;
            parabola.abs() < 0.5 * before.abs() && low < at && at < high
        });
        (before, step) = match parabola {
            Some(parabola) => {
                let at = best.at + parabola;
                let is_beside = at - low < 2.0 * near || high - at < 2.0 * near;
                (step, if is_beside { near.copysign(center - best.at) } else { parabola })
            }
            None => {
                let rest = if best.at < center { high - best.at } else { low - best.at };
                (rest, golden * rest)
            }
        };
        let at = best.at + if step.abs() < near { near.copysign(step) } else { step };
        let new = Sample { at, value: function(at)? };
        if new.value <= best.value {
            if at < best.at {
                high = best.at;
            } else {
                low = best.at;
            }
            (third, second, best) = (second, best, new);
        } else {
            if at < best.at {
                low = at;
            } else {
                high = at;
            }
            let is_one = |a: f64, b: f64| (a - b).abs() < spacing;
            if new.value <= second.value || is_one(second.at, best.at) {
                (third, second) = (second, new);
            } else if new.value <= third.value
                || is_one(third.at, best.at)
                || is_one(third.at, second.at)
            {
                third = new;
            }
        }
    }
    Ok(best)
}

/// The way from the best place to the bottom of the parabola through three places.
fn parabola_step(best: Sample, second: Sample, third: Sample) -> Option<f64> {
    let r = (best.at - second.at) * (best.value - third.value);
    let q = (best.at - third.at) * (best.value - second.value);
    let above = (best.at - third.at) * q - (best.at - second.at) * r;
    let step = -above / (2.0 * (q - r));
    step.is_finite().then_some(step)
}

#[cfg(test)]
mod tests {
    use super::{Sample, find_least, parabola_step};

    #[test]
    fn least_values_are_found_inside_and_at_ends() {
        let least = |function: fn(f64) -> f64, interval| {
            find_least(|x| Ok::<_, ()>(function(x)), interval).expect("no failure")
        };
        let found = least(libm::cos, [0.0, 6.0]);
        assert!(
            (found.at - std::f64::consts::PI).abs() < 1e-7 && (found.value + 1.0).abs() < 1e-15
        );
        let found = least(|x| (x - 0.7).abs(), [0.0, 1.0]);
        assert!((found.at - 0.7).abs() < 1e-7, "{}", found.at);
        let found = least(|x| x * x, [1.0, 2.0]);
        assert!((found.at - 1.0).abs() < 1e-15);
        let found = least(|x| -x, [0.0, 2.0]);
        assert!((found.at - 2.0).abs() < 1e-15);
        // The lower one of two valleys.
        let found = least(|x| libm::pow(x * x - 1.0, 2.0) + 0.1 * x, [-2.0, 2.0]);
        assert!(found.at < -1.0 && -1.1 < found.at, "{}", found.at);
        let flat = least(|_| 3.0, [0.0, 1.0]);
        assert!((flat.value - 3.0).abs() < 1e-15);
    }

    #[test]
    fn a_parabola_is_left_for_its_bottom_in_one_step() {
        let on = |at: f64| Sample { at, value: 3.0 * (at - 1.25) * (at - 1.25) - 2.0 };
        let step = parabola_step(on(1.0), on(0.25), on(2.5)).expect("three places");
        assert!((step - 0.25).abs() < 1e-15, "{step}");
        assert_eq!(parabola_step(on(1.0), on(1.0), on(1.0)), None);
    }
}
