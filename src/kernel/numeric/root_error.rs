//! Why a function has no root that is told.

use super::sample::Sample;

/// Why there is no root.
///
/// ```
/// use virote_kernel::{RootError, find_root};
///
/// let found = find_root(|x| Ok::<_, ()>(x * x + 1.0), [-1.0, 2.0]);
/// assert!(matches!(found, Err(RootError::NoRoot { nearest, .. }) if nearest.at.abs() < 1e-6));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum RootError<E> {
    /// The function failed.
    Function(E),
    /// No change of sign was found and no touch: the sample nearest to zero, and those at both ends.
    NoRoot {
        /// Where it is nearest to zero.
        nearest: Sample,
        /// At the ends of the interval.
        ends: [Sample; 2],
    },
    /// The sign changes from one number to the next without a zero.
    Jump {
        /// Both numbers.
        sides: [Sample; 2],
    },
    /// So many changes of sign between samples at equal distances that others may lie between the same two.
    Crowded {
        /// Parts between samples that hold a root, and parts in all.
        n_roots: [usize; 2],
    },
    /// The function is zero all along a stretch, so that it has no single root.
    Flat {
        /// The ends of the stretch, as far as it was looked at: of all of the interval where it is zero at every
        /// place that was.
        stretch: [f64; 2],
    },
}

impl<E> From<E> for RootError<E> {
    fn from(err: E) -> Self {
        Self::Function(err)
    }
}
