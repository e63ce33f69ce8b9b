//! Where a distance along a stretch is least, and whether that is one place.
//!
//! Two curves that touch in order k are (x − x₀)ᵏ apart: nearly nothing on a wide floor, of which
//! no place is nearer than another up to rounding. What tells the touch from a shared stretch is
//! that the distance rises behind the floor, and over a way as long as the floor.

use super::{
    Interval,
    ceiling::{BISECTIONS, FLOOR_DOUBLINGS},
    numeric::{bisection::bisected, golden_section::golden_section},
    tolerance::{FEW_DIGITS_SHARE, LAST_BIT},
};

/// Cells of a stretch at whose ends the distance is asked for.
const N_CELLS: usize = 64;

/// Roundings of a distance by which the floor may be above the least.
pub(crate) const FLOOR_ROUNDINGS: f64 = 16.0;

/// Digits that a number written in full has at most.
const MOST_DIGITS: usize = 16;

/// How a distance runs along a stretch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Valley {
    /// The middle of the floor, or where the distance is least if that is less.
    pub(crate) bottom: f64,
    /// The places around the bottom where the distance is the least one up to rounding.
    pub(crate) floor: Interval,
    /// Whether the distance rises from the floor to both ends.
    pub(crate) is_single: bool,
    /// Whether the floor reaches the end, and the distance there.
    sides: [(bool, f64); 2],
}

impl Valley {
    /// Follows the distance along a stretch; `rounding` is what a distance may be wrong by.
    pub(crate) fn of(distance: impl Fn(f64) -> f64, stretch: Interval, rounding: f64) -> Self {
        let places = stretch.steps(N_CELLS);
        let heights: Vec<f64> = places.iter().map(|&t| distance(t)).collect();
        let lowest =
            (0..heights.len()).fold(0, |low, i| if heights[i] < heights[low] { i } else { low });
        let around = [places[lowest.saturating_sub(1)], places[(lowest + 1).min(N_CELLS)]];
        let mut least = (places[lowest], heights[lowest]);
        let section = golden_section(&distance, around);
        if section.1 < least.1 {
            least = section;
        }

        let level = least.1 + FLOOR_ROUNDINGS * rounding;
        let is_floor = |t: f64| distance(t) <= level;
        let [low, high] = [stretch.start(), stretch.end()].map(|end| edge(&is_floor, least.0, end));
        let rises = |pair: [usize; 2]| heights[pair[0]] <= heights[pair[1]] + 2.0 * rounding;
        let is_single = (0..N_CELLS).all(|i| match () {
            () if places[i + 1] <= low => rises([i + 1, i]),
            () if high <= places[i] => rises([i, i + 1]),
            () => true,
        });

        let middle = round(0.5 * (low + high), FEW_DIGITS_SHARE * (high - low)).clamp(low, high);
        let bottom = if distance(middle) <= least.1 + rounding { middle } else { least.0 };
        let sides =
            [(low <= stretch.start(), heights[0]), (stretch.end() <= high, heights[N_CELLS])];
        let floor = Interval::new(low, high).unwrap_or(stretch);
        Self { bottom, floor, is_single, sides }
    }

    /// Whether at each end, but those that are none of it, the distance is at least this, or the floor goes that far.
    pub(crate) fn rises_to(&self, height: f64, is_beyond: [bool; 2]) -> bool {
        let mut sides = self.sides.iter().zip(is_beyond);
        sides.all(|(&(is_floor, end), is_beyond)| is_beyond || is_floor || height <= end)
    }
}

/// The last place from `inside` towards `end` up to which something holds.
pub(crate) fn edge(holds: &impl Fn(f64) -> bool, inside: f64, end: f64) -> f64 {
    let (mut on, mut step) = (inside, (end - inside) * LAST_BIT);
    let mut off = end;
    for _ in 0..FLOOR_DOUBLINGS {
        let next = if (end - inside).abs() <= step.abs() { end } else { inside + step };
        if !holds(next) {
            off = next;
            break;
        }
        on = next;
        if next.total_cmp(&end).is_eq() {
            return end;
        }
        step *= 2.0;
    }
    bisected([on, off], BISECTIONS, holds)[0]
}

/// The number with the fewest digits within `slack` of another.
pub(crate) fn round(t: f64, slack: f64) -> f64 {
    if t.abs() <= slack {
        return 0.0;
    }
    let written = (0..MOST_DIGITS).filter_map(|digits| format!("{t:.digits$e}").parse().ok());
    written.into_iter().find(|short: &f64| (short - t).abs() <= slack).unwrap_or(t)
}

#[cfg(test)]
mod tests {
    use super::Valley;
    use crate::Interval;

    #[test]
    fn a_touch_of_ninth_order_is_one_place() {
        let stretch = Interval::new(-0.2, 0.25).unwrap();
        let valley = Valley::of(|t: f64| libm::pow(t.abs(), 9.0), stretch, 1e-16);
        assert_eq!(valley.bottom.to_bits(), 0);
        assert!(
            valley.is_single
                && valley.rises_to(1e-7, [false; 2])
                && !valley.rises_to(1e-6, [false; 2])
        );
    }

    #[test]
    fn two_crossings_are_no_single_valley() {
        let around = Interval::new(-1.0, 1.0).unwrap();
        assert!(!Valley::of(|t: f64| (t * t - 0.3).abs(), around, 1e-16).is_single);
    }
}
