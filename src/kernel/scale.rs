//! Measures of what is so large or small that squares of its coordinates are no numbers.
//!
//! What is measured is divided by a power of two near its size, which changes no digit, and what was found
//! multiplied by that power again.

use super::{GeomError, MeasureError};

/// The eighth power of a size up to this one is a number, and so is that of its inverse: nothing that is
/// measured takes more.
const PLAIN: f64 = 1e35;

/// The power of two by which something of a size is divided to be measured; none of sizes that need none.
pub(crate) fn needed_scale(size: f64) -> Option<f64> {
    let is_plain = (PLAIN.recip()..=PLAIN).contains(&size);
    if is_plain || size <= 0.0 || !size.is_finite() {
        return None;
    }
    Some(libm::exp2(libm::log2(size).floor().clamp(-1000.0, 1000.0)))
}

/// The same, which is one of sizes that need none.
pub(crate) fn scale_of(size: f64) -> f64 {
    needed_scale(size).unwrap_or(1.0)
}

/// A measure of a dimension, found of what was divided by a scale.
///
/// # Errors
/// [`MeasureError::TooSmallToMeasure`] of what is not zero, but less than the smallest number.
pub(crate) fn scaled_back(
    found: f64,
    scale: f64,
    dimension: usize,
    what: &'static str,
) -> Result<f64, GeomError> {
    let measure = (0..dimension).fold(found, |measure, _| measure * scale);
    if measure.abs() < f64::MIN_POSITIVE && 0.0 < found.abs() {
        return Err(MeasureError::TooSmallToMeasure { what }.into());
    }
    Ok(measure)
}
