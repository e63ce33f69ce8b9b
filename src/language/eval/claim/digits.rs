//! Numbers of a report in few digits: as many as tell them apart.

use crate::value::shortest;

/// Digits of a measured number that a report shows.
const FEW_DIGITS: usize = 4;
/// Digits of a compared number that a report shows at least.
pub(super) const SIDE_DIGITS: usize = 6;
/// Digits behind the first in which two compared numbers differ.
pub(super) const MORE_DIGITS: usize = 2;

/// A number with so many digits.
fn with_digits(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value)
}

/// Two measured numbers in few digits, in as many as tell them apart.
pub(super) fn brief(values: [f64; 2]) -> [String; 2] {
    told_apart(values, FEW_DIGITS, 0)
}

/// Two numbers in the fewest digits from `least` on that tell them apart, and `more`; equal ones in full.
pub(super) fn told_apart([a, b]: [f64; 2], least: usize, more: usize) -> [String; 2] {
    /// Digits that tell any two numbers apart.
    const ALL: usize = 17;
    let differ = (1..ALL)
        .find(|&n| with_digits(a, n).to_bits() != with_digits(b, n).to_bits())
        .unwrap_or(ALL);
    let digits = least.max(differ + more);
    [a, b].map(
        |value| if ALL <= digits { shortest(value) } else { shortest(with_digits(value, digits)) },
    )
}

/// A text that is a number with its unit, as both.
pub(super) fn number(text: &str) -> Option<(f64, &str)> {
    let is_of_number = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | 'e');
    let (number, unit) = text.split_at(text.find(|c| !is_of_number(c)).unwrap_or(text.len()));
    let is_alone = !unit.contains([' ', ',']);
    number.parse().ok().filter(|_| is_alone).map(|number| (number, unit))
}
