//! What keeps an integral from being found.

/// Why there is no integral.
///
/// ```
/// use virote_kernel::{IntegralError, find_integral};
///
/// let found = find_integral(|x| Ok::<_, ()>(vec![1.0 / x]), [0.0, 1.0], 1e-13, 0.0);
/// assert!(matches!(found, Err(IntegralError::Unsettled { at, .. }) if at < 1e-9));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum IntegralError<E> {
    /// The function failed.
    Function(E),
    /// The error does not go below what was asked for.
    Unsettled {
        /// Where it is largest.
        at: f64,
        /// What it is.
        error: f64,
        /// Why.
        reason: IntegralReason,
    },
}

/// Why the error of an integral does not go below what was asked for.
///
/// ```
/// use virote_kernel::{IntegralError, IntegralReason, find_integral};
///
/// let found = find_integral(|x| Ok::<_, ()>(vec![1.0 / x]), [0.0, 1.0], 1e-13, 100.0);
/// let reason = IntegralReason::Endless;
/// assert!(matches!(found, Err(IntegralError::Unsettled { at: 0.0, reason: found, .. }) if found == reason));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum IntegralReason {
    /// The function has no more digits there: halves of pieces are off as far as the whole.
    Noise,
    /// The function grows so fast towards the place that the integral has no value, or none that numbers come to.
    Endless,
    /// Any other.
    Slow,
}
