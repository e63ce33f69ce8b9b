//! What a search knows of a function of one number.

/// A place at which a function was asked, and its value there.
///
/// ```
/// use virote_kernel::{Sample, find_least};
///
/// let least: Sample = find_least(|x| Ok::<_, ()>(x * x + 1.0), [-1.0, 2.0])?;
/// assert!(least.at.abs() < 1e-7 && (least.value - 1.0).abs() < 1e-15);
/// # Ok::<(), ()>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The place.
    pub at: f64,
    /// The value of the function.
    pub value: f64,
}

/// Whether a value is zero, not only near it.
pub(super) fn is_zero(value: f64) -> bool {
    value == 0.0
}

/// Whether the values at two places have different signs.
pub(super) fn is_change(a: Sample, b: Sample) -> bool {
    a.value.is_sign_negative() != b.value.is_sign_negative()
        && !is_zero(a.value)
        && !is_zero(b.value)
}
