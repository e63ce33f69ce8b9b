//! Where two curves meet, as it is told and while it is searched for.

use glam::DVec3;

use crate::{Interval, curve::NurbsCurve};

/// A place where two curves meet.
///
/// ```
/// use virote_kernel::{NurbsCurve, glam::DVec3};
///
/// let rising = NurbsCurve::line(DVec3::ZERO, DVec3::new(2.0, 2.0, 0.0))?;
/// let falling = NurbsCurve::line(DVec3::new(0.0, 2.0, 0.0), DVec3::new(2.0, 0.0, 0.0))?;
/// let [meeting] = rising.intersections(&falling, 1e-6)?[..] else { unreachable!("they meet once") };
/// assert!(meeting.point.distance(DVec3::new(1.0, 1.0, 0.0)) < 1e-12);
/// assert!((meeting.first - 0.5).abs() < 1e-12 && (meeting.second - 0.5).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveIntersection {
    /// The parameter on the first curve.
    pub first: f64,
    /// The parameter on the second.
    pub second: f64,
    /// The point, in the middle between both curves' points.
    pub point: DVec3,
}

/// A meeting, and the stretch that came down to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct ReportedIntersection {
    pub(super) meeting: CurveIntersection,
    pub(super) stretch: Option<ContactInterval>,
}

impl ReportedIntersection {
    /// Of two pieces that cross clearly.
    pub(super) fn crossing(meeting: CurveIntersection) -> Self {
        Self { meeting, stretch: None }
    }
}

/// A stretch on which two curves are within the tolerance, by the parameters of both. Over the seam
/// of a closed curve parameters go on beyond the domain.
#[derive(Clone, Copy, Debug)]
pub(super) struct ContactInterval {
    pub(super) first: Interval,
    pub(super) second: Interval,
}

impl ContactInterval {
    /// The same with the curves exchanged.
    pub(super) fn swapped(self) -> Self {
        Self { first: self.second, second: self.first }
    }
}

/// The curves in search of each other.
pub(super) struct IntersectionSearch<'c> {
    pub(super) first: &'c NurbsCurve,
    pub(super) second: &'c NurbsCurve,
    pub(super) tolerance: f64,
    /// Whether both are one curve, so that a parameter does not meet itself.
    pub(super) is_same: bool,
    /// A simple touch is no longer than this.
    pub(super) longest_touch: f64,
    /// What a distance may be wrong by.
    pub(super) rounding: f64,
    /// Control points that may still be looked at.
    pub(super) left: usize,
    pub(super) meetings: Vec<ReportedIntersection>,
    pub(super) contacts: Vec<ContactInterval>,
}
