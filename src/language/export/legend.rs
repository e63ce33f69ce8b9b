//! What the colours of a mesh mean: a scale, with labels at round values.

use glam::DVec3;

/// What the colours of a mesh mean.
#[derive(Clone, Debug, PartialEq)]
pub struct Legend {
    /// What is shown.
    pub title: String,
    /// Values with their red, green and blue from 0 to 1, in ascending order.
    pub stops: Vec<(f64, DVec3)>,
    /// Whether there are values below the first stop and above the last one, which have their
    /// colours.
    pub beyond: [bool; 2],
}

/// Most round values on a scale.
const MOST_TICKS: usize = 6;
/// Round values nearer than this part of the scale to an end that has a label make room for it.
const ROOM: f64 = 0.08;

impl Legend {
    /// The colour at a share of the way from the first stop to the last.
    pub(super) fn color_at(&self, share: f64) -> DVec3 {
        let last = self.stops.len().saturating_sub(1);
        let place = (share * last as f64).clamp(0.0, last as f64);
        let idx = (place as usize).min(last.saturating_sub(1));
        match &self.stops[idx..] {
            [(_, from), (_, to), ..] => from.lerp(*to, place - idx as f64),
            [(_, only)] => *only,
            [] => DVec3::ZERO,
        }
    }

    /// Labels with their shares of the way from the first stop to the last: round values, and the
    /// ends beyond which there are values.
    ///
    /// A scale of one value has that one as its label; so have the ends of a scale that is too short
    /// for round values.
    pub(super) fn labels(&self) -> Vec<(f64, String)> {
        let (Some(&(least, _)), Some(&(largest, _))) = (self.stops.first(), self.stops.last())
        else {
            return Vec::new();
        };
        if largest <= least {
            let sign = sign(self.beyond);
            return vec![(0.5, format!("{sign}{}", four_digits(least)))];
        }
        let round = round_values(least, largest);
        let mut labels: Vec<(f64, String)> = match &round[..] {
            [] | [_] => [least, largest].map(|end| (self.share_of(end), four_digits(end))).into(),
            round => round.iter().map(|&tick| (self.share_of(tick), digits(tick))).collect(),
        };
        if self.beyond[0] {
            labels.retain(|(share, _)| ROOM < *share);
            labels.insert(0, (0.0, format!("≤ {}", four_digits(least))));
        }
        if self.beyond[1] {
            labels.retain(|(share, _)| *share < 1.0 - ROOM);
            labels.push((1.0, format!("≥ {}", four_digits(largest))));
        }
        labels
    }

    /// The share of the way at which a value stands.
    fn share_of(&self, value: f64) -> f64 {
        let n_legs = self.stops.len().saturating_sub(1).max(1) as f64;
        for (i, leg) in self.stops.windows(2).enumerate() {
            let [(from, _), (to, _)] = [leg[0], leg[1]];
            if value <= to && from < to {
                return (i as f64 + ((value - from) / (to - from)).clamp(0.0, 1.0)) / n_legs;
            }
        }
        1.0
    }
}

/// What stands before the only value of a scale.
const fn sign(beyond: [bool; 2]) -> &'static str {
    match beyond {
        [false, false] => "",
        [true, false] => "≤ ",
        [false, true] => "≥ ",
        [true, true] => "≠ ",
    }
}

/// Multiples of 1, 2, 2.5 or 5 times a power of ten in an interval, as many as there is room for.
///
/// Heckbert, *Nice numbers for graph labels*, Graphics Gems (1990), with 2.5 beside his steps.
fn round_values(least: f64, largest: f64) -> Vec<f64> {
    let width = largest - least;
    if !(width.is_finite() && 0.0 < width) {
        return Vec::new();
    }
    let exponent = libm::floor(libm::log10(width / MOST_TICKS as f64)) as i32;
    for exponent in exponent - 1..=exponent + 2 {
        for leading in [1.0, 2.0, 2.5, 5.0] {
            let ticks = multiples(leading, exponent, [least, largest]);
            if !ticks.is_empty() && ticks.len() <= MOST_TICKS {
                return ticks;
            }
        }
    }
    Vec::new()
}

/// Multiples of a decimal step in an interval, each the nearest number to its decimals; none for more
/// than a few too many.
fn multiples(leading: f64, exponent: i32, [least, largest]: [f64; 2]) -> Vec<f64> {
    let decimal = |n: f64| format!("{n}e{exponent}").parse().unwrap_or(f64::NAN);
    let step: f64 = decimal(leading);
    let first = (least / step).ceil();
    let n_steps = (largest / step).floor() - first;
    if !(0.0..10.0 * MOST_TICKS as f64).contains(&n_steps) {
        return Vec::new();
    }
    // One more on each side, in case the divisions were rounded.
    let ticks = (0..n_steps as usize + 3).map(|i| decimal((first + i as f64 - 1.0) * leading));
    // No zero below zero.
    let mut ticks: Vec<f64> = ticks.map(|tick| tick + 0.0).collect();
    ticks.retain(|tick| least <= *tick && *tick <= largest);
    ticks.dedup();
    ticks
}

/// Characters of a label in full.
const LABEL: usize = 7;

/// A value with all of its digits, of which a round one has few.
pub(super) fn digits(value: f64) -> String {
    let (plain, scientific) = (format!("{value}"), format!("{value:e}"));
    if plain.len() <= LABEL || plain.len() <= scientific.len() { plain } else { scientific }
}

/// A value to four digits.
pub(super) fn four_digits(value: f64) -> String {
    digits(format!("{value:.3e}").parse().unwrap_or(value))
}

#[cfg(test)]
mod tests {
    use super::{Legend, round_values};
    use glam::DVec3;

    #[track_caller]
    fn check(ends: [f64; 2], expected: &[f64]) {
        assert_eq!(round_values(ends[0], ends[1]), expected);
    }

    #[test]
    fn ticks_are_one_two_two_and_a_half_or_five_times_a_power_of_ten() {
        check([0.0, 1.0], &[0.0, 0.2, 0.4, 0.6, 0.8, 1.0]);
        check([-0.5, 0.25], &[-0.4, -0.2, 0.0, 0.2]);
        check([0.0, 12.0], &[0.0, 2.5, 5.0, 7.5, 10.0]);
        check([3e-7, 9.1e-7], &[4e-7, 6e-7, 8e-7]);
        check([12_340.0, 12_346.0], &[12_340.0, 12_342.0, 12_344.0, 12_346.0]);
        check([-3e20, -1e20], &[-3e20, -2.5e20, -2e20, -1.5e20, -1e20]);
    }

    #[test]
    fn ticks_are_round_and_lie_inside_of_any_range() {
        for i in 0..2000 {
            let i = f64::from(i);
            let least = libm::sin(i) * libm::exp(libm::cos(1.7 * i) * 20.0);
            let largest = least + libm::exp(libm::sin(2.3 * i) * 20.0).max(least.abs() / 1e6);
            let ticks = round_values(least, largest);
            assert!((3..=6).contains(&ticks.len()), "{least} {largest} {ticks:?}");
            for pair in ticks.windows(2) {
                let step = format!("{:.3e}", pair[1] - pair[0]);
                let leading = step.split('e').next();
                assert!(
                    ["1.000", "2.000", "2.500", "5.000"].map(Some).contains(&leading),
                    "{step}"
                );
            }
            assert!(ticks.iter().all(|tick| (least..=largest).contains(tick)), "{least} {largest}");
        }
    }

    #[test]
    fn what_lies_beyond_a_scale_is_told_at_its_end() {
        let stops = vec![(0.0, DVec3::ZERO), (2.037, DVec3::ONE)];
        let legend = |beyond| Legend { title: String::new(), stops: stops.clone(), beyond };
        let words = |beyond| -> Vec<String> {
            legend(beyond).labels().into_iter().map(|(_, label)| label).collect()
        };
        assert_eq!(words([false, false]), ["0", "0.5", "1", "1.5", "2"]);
        assert_eq!(words([true, true]), ["≤ 0", "0.5", "1", "1.5", "≥ 2.037"]);
        let places = legend([false, false]).labels();
        assert!((places[2].0 - 1.0 / 2.037).abs() < 1e-12);
    }

    #[test]
    fn a_scale_of_one_value_has_one_label() {
        let stops = vec![(0.25, DVec3::ONE); 9];
        let legend = Legend { title: String::new(), stops, beyond: [false, true] };
        assert_eq!(legend.labels(), [(0.5, "≥ 0.25".to_owned())]);
    }
}
