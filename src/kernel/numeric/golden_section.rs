//! The least value in a bracket, without derivatives.

use crate::ceiling::GOLDEN_SECTIONS;

/// The place in a bracket where a function with one minimum has it, and its value there.
///
/// Kiefer, *Sequential minimax search for a maximum*, Proc. AMS 4 (1953).
pub(crate) fn golden_section(
    value: impl Fn(f64) -> f64,
    [mut low, mut high]: [f64; 2],
) -> (f64, f64) {
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let mut inner = [high - golden * (high - low), low + golden * (high - low)];
    let mut values = inner.map(&value);
    for _ in 0..GOLDEN_SECTIONS {
        if values[0] <= values[1] {
            high = inner[1];
            inner = [high - golden * (high - low), inner[0]];
            values = [value(inner[0]), values[0]];
        } else {
            low = inner[0];
            inner = [inner[1], low + golden * (high - low)];
            values = [values[1], value(inner[1])];
        }
    }
    if values[0] <= values[1] { (inner[0], values[0]) } else { (inner[1], values[1]) }
}

#[cfg(test)]
mod tests {
    use super::golden_section;

    #[test]
    fn a_parabola_is_least_at_its_vertex() {
        let (place, value) = golden_section(|t| (t - 0.3) * (t - 0.3), [0.0, 1.0]);
        assert!((place - 0.3).abs() < 1e-8 && value < 1e-16);
    }
}
