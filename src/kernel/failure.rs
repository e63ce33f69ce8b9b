//! Why a function that geometry is made of has no value.

use std::{error::Error as StdError, fmt, sync::Arc};

use super::GeomError;

/// Why a function has no value, in the words of whoever made the function; the kernel looks not
/// inside.
///
/// ```
/// use virote_kernel::FunctionFailure;
///
/// let failure = FunctionFailure::new(std::fmt::Error);
/// assert_eq!(failure.reason::<std::fmt::Error>(), Some(&std::fmt::Error));
/// ```
#[derive(Clone, Debug)]
pub struct FunctionFailure(Arc<dyn StdError + Send + Sync>);

impl FunctionFailure {
    /// The failure for this reason.
    pub fn new(reason: impl StdError + Send + Sync + 'static) -> Self {
        Self(Arc::new(reason))
    }

    /// The reason, if it is of this type; also through functions that are made of functions.
    #[must_use]
    pub fn reason<T: StdError + 'static>(&self) -> Option<&T> {
        if let Some(reason) = self.0.downcast_ref() {
            return Some(reason);
        }
        match self.0.downcast_ref()? {
            GeomError::Function(inner) => inner.reason(),
            _ => None,
        }
    }
}

impl fmt::Display for FunctionFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl StdError for FunctionFailure {}

/// Failures are equal when they are one in memory.
impl PartialEq for FunctionFailure {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}
