//! A section that was made to run beside another one.

use crate::NurbsCurve;

/// Places at which two sections are compared: enough to tell which way they run, and of closed
/// ones where their seams are.
pub(super) const N_PLACES: usize = 64;

/// A section made to run beside another one.
///
/// ```
/// use virote_kernel::{NurbsCurve, aligned, glam::DVec3};
///
/// let first = NurbsCurve::line(DVec3::ZERO, DVec3::X)?;
/// let against = NurbsCurve::line(DVec3::X + DVec3::Y, DVec3::Y)?;
/// let found = aligned(&against, &first, false, 1e-6)?;
/// assert!(found.is_reversed);
/// assert_eq!(found.curve.start(), DVec3::Y);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct AlignedSection {
    /// The section as it runs now.
    pub curve: NurbsCurve,
    /// Whether it ran the other way.
    pub is_reversed: bool,
    /// Where its seam is now, by the parameter that it had there, if it was moved.
    pub seam: Option<f64>,
    /// Whether its corners were brought to the parameters of the other one's.
    pub has_moved_corners: bool,
    /// How many corners it and the other one have, where these cannot be paired.
    pub unpaired: Option<[usize; 2]>,
}

impl AlignedSection {
    pub(super) fn of(curve: NurbsCurve, is_reversed: bool, seam: Option<f64>) -> Self {
        Self { curve, is_reversed, seam, has_moved_corners: false, unpaired: None }
    }
}
