//! The least value of a function of one number.

use super::sample::Sample;
use crate::{
    ceiling::{LEAST_LOOKS, LEAST_STEPS, MOST_LEAST_LOOKS},
    tolerance::{LAST_BIT, LEAST_PLACE_RELATIVE},
};

/// Samples that a valley needs around it to be seen: as many for each turn of the function, or there are more.
const SAMPLES_OF_A_TURN: usize = 8;

/// Last bits of a value that its function may be wrong by.
const ROUNDINGS: f64 = 16.0;

/// How far samples stand from equal distances, as a share of these: waves of the same length would hide.
const UNEVENNESS: f64 = 0.3;

/// The place in an interval at which a function is least, and its value there.
///
/// Places at nearly equal distances tell near which the least value is: some seventeen, and the more the oftener the
/// function turns between them, up to 257. From there on Brent's method goes on, and in other valleys whose bottom
/// may be lower. A valley between two of these places in which no other is lower than theirs is missed. The least
/// value may stand at an end.
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
    let mut sample_at = |at: f64| Ok::<_, E>(Sample { at, value: function(at)? });
    let mut samples = Vec::with_capacity(LEAST_LOOKS + 1);
    for k in 0..=LEAST_LOOKS {
        let unevenness = UNEVENNESS * libm::sin((k * k) as f64);
        let share = (k as f64 + unevenness) / LEAST_LOOKS as f64;
        samples.push(sample_at(match k {
            0 => start,
            LEAST_LOOKS => end,
            _ => start + (end - start) * share,
        })?);
    }
    while samples.len() <= MOST_LEAST_LOOKS
        && samples.len() <= SAMPLES_OF_A_TURN * n_turns(&samples)
    {
        let mut finer = Vec::with_capacity(2 * samples.len());
        for pair in samples.windows(2) {
            finer.extend([pair[0], sample_at(0.5 * (pair[0].at + pair[1].at))?]);
        }
        finer.extend(samples.last());
        samples = finer;
    }
    let lower = |&a: &usize, &b: &usize| samples[a].value.total_cmp(&samples[b].value);
    let last = samples.len() - 1;
    let lowest = (0..=last).min_by(lower).unwrap_or(0);
    let mut best = samples[lowest];
    let others = (1..last).filter(|&k| k != lowest && is_valley(&samples[k - 1..=k + 1]));
    for k in [lowest].into_iter().chain(others) {
        let [before, at, behind] = [k.saturating_sub(1), k, (k + 1).min(last)].map(|k| samples[k]);
        if k != lowest && best.value - rounding(best.value) <= depth(before, at, behind) {
            continue;
        }
        let found =
            least_between(|at| Ok(sample_at(at)?.value), [before.at, at.at, behind.at], at.value)?;
        if found.value < best.value {
            best = found;
        }
    }
    Ok(best)
}

/// How often samples go from growing to falling, or back, by more than rounding.
fn n_turns(samples: &[Sample]) -> usize {
    let step = |pair: &[Sample]| {
        let step = pair[1].value - pair[0].value;
        Some(step).filter(|step| rounding(pair[0].value) < step.abs())
    };
    let steps: Vec<f64> = samples.windows(2).filter_map(step).collect();
    steps.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count()
}

/// What a value may be wrong by, at most.
fn rounding(value: f64) -> f64 {
    ROUNDINGS * LAST_BIT * value.abs()
}

/// Whether the middle one of three samples is lowest.
fn is_valley(samples: &[Sample]) -> bool {
    samples[1].value < samples[0].value && samples[1].value <= samples[2].value
}

/// A value that the bottom of a valley around the lowest of three samples is not much below, of what is curved as the
/// parabola through them.
fn depth(before: Sample, lowest: Sample, behind: Sample) -> f64 {
    let rise = before.value.max(behind.value) - lowest.value;
    lowest.value - 0.5 * rise
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
    fn the_lowest_of_many_valleys_is_found() {
        for n in 1..=60 {
            let n = f64::from(n);
            let waves = |x: f64| libm::sin(n * x) + 0.05 * x;
            let found = find_least(|x| Ok::<_, ()>(waves(x)), [0.0, 3.0]).expect("no failure");
            let places = (0..=60_000).map(|k| waves(3.0 * f64::from(k) / 60_000.0));
            let least = places.fold(f64::INFINITY, f64::min);
            assert!(found.value <= least + 1e-9, "{n}: {found:?}, {least}");
        }
        // As many waves as samples.
        let waves = |x: f64| Ok::<_, ()>(-libm::cos(std::f64::consts::TAU * x) - 0.01 * x);
        let found = find_least(waves, [0.0, 16.5]).expect("no failure");
        assert!((found.at - 16.0).abs() < 1e-3, "{found:?}");
        // A function of one valley is asked some thirty times.
        let mut n_asked = 0;
        let valley = |x: f64| {
            n_asked += 1;
            Ok::<_, ()>((x - 0.3) * (x - 0.3))
        };
        assert!(find_least(valley, [0.0, 2.0]).is_ok() && n_asked < 40, "{n_asked}");
    }

    #[test]
    fn a_parabola_is_left_for_its_bottom_in_one_step() {
        let on = |at: f64| Sample { at, value: 3.0 * (at - 1.25) * (at - 1.25) - 2.0 };
        let step = parabola_step(on(1.0), on(0.25), on(2.5)).expect("three places");
        assert!((step - 0.25).abs() < 1e-15, "{step}");
        assert_eq!(parabola_step(on(1.0), on(1.0), on(1.0)), None);
    }
}
