//! Numbers as messages tell them.

use glam::DVec3;

use crate::tolerance::SHOWN_RELATIVE;

/// A bound of a deviation for a message; without one the weights left no curve to measure.
pub(super) fn how_far(error: f64) -> String {
    if error.is_finite() {
        format!("by up to {}", few_digits(error))
    } else {
        "to where its weights are not positive".to_owned()
    }
}

/// Turns as degrees.
pub(super) fn degrees(turns: f64) -> String {
    let degrees = 360.0 * turns;
    format!("{}deg", format!("{degrees:.11e}").parse().unwrap_or(degrees))
}

/// A measured number for a message.
pub(crate) fn few_digits(x: f64) -> String {
    let rounded: f64 = format!("{x:.3e}").parse().unwrap_or(x);
    if rounded == 0.0 || (0.001..1_000_000.0).contains(&rounded.abs()) {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

/// A measured point for a message; a coordinate that only rounding keeps from zero is told as zero.
pub(crate) fn place(point: DVec3) -> String {
    let least = SHOWN_RELATIVE * point.abs().max_element();
    let [x, y, z] = point.to_array().map(|x| few_digits(if x.abs() < least { 0.0 } else { x }));
    format!("({x}, {y}, {z})")
}

/// A line for a message, by its ends.
pub(super) fn line_between([start, end]: [DVec3; 2]) -> String {
    match [place(start), place(end)] {
        [start, end] if start == end => format!("a closed line through {start}"),
        [start, end] => format!("a line from {start} to {end}"),
    }
}

/// A number in full, with an exponent where scripts print one.
pub(super) fn plain(x: f64) -> String {
    let is_plain = x == 0.0 || (0.000_01..1e16).contains(&x.abs());
    if is_plain { x.to_string() } else { format!("{x:e}") }
}

/// That `what` is `got` and not above zero; one that is not finite was derived from geometry that is
/// too large.
pub(super) fn not_positive(what: &str, got: f64) -> String {
    if got.is_finite() {
        format!("{what} is {}; it must be above zero", plain(got))
    } else {
        "the geometry reaches farther than can be measured".to_owned()
    }
}
