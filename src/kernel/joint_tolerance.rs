//! What counts as equal where two pieces of geometry meet.

use super::Tolerance;

/// What counts as equal at a joint: what somebody asked for, and by the document's tolerance
/// whatever was left open. What was asked for counts as it is, whatever the size of the pieces, but
/// nothing is told apart below its rounding.
///
/// Lines that meet at a right angle are one direction to whoever allows two radians:
///
/// ```
/// use virote_kernel::{Curve, JointTolerance, NurbsCurve, Tolerance, glam::DVec3};
///
/// let [first, second] = [(DVec3::ZERO, DVec3::X), (DVec3::X, DVec3::X + DVec3::Y)];
/// let [first, second] = [NurbsCurve::line(first.0, first.1)?, NurbsCurve::line(second.0, second.1)?];
/// let [first, second] = [Curve::from(first), Curve::from(second)];
/// let rough = JointTolerance { angle: Some(2.0), ..Tolerance::DEFAULT.into() };
/// assert_eq!(first.continuity_with(&second, Tolerance::DEFAULT)?.g, 0);
/// assert!(1 <= first.continuity_with(&second, rough)?.g);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointTolerance {
    /// The document's.
    pub document: Tolerance,
    /// Points closer than this coincide; model units.
    pub distance: Option<f64>,
    /// Tangents, or tangent planes, closer than this are one; radians.
    pub angle: Option<f64>,
    /// Curvature vectors, or normal curvatures of surfaces, closer than this are one; one over
    /// model units.
    pub curvature_gap: Option<f64>,
}

impl JointTolerance {
    /// The same for pieces that are divided by a scale.
    pub(crate) fn divided_by(self, scale: f64) -> Self {
        Self {
            document: self.document.with_distance(self.document.distance / scale),
            distance: self.distance.map(|distance| distance / scale),
            curvature_gap: self.curvature_gap.map(|gap| gap * scale),
            ..self
        }
    }

    /// The distance within which ends are one place, as where a closed curve is looked for.
    pub(crate) fn closed_within(&self) -> f64 {
        self.distance.unwrap_or(self.document.distance)
    }

    /// The distance for pieces of a size, whose points are known but for a rounding.
    pub(crate) fn distance_for(&self, size: f64, rounding: f64) -> f64 {
        self.distance.unwrap_or_else(|| self.document.distance_for(size)).max(rounding)
    }
}

impl From<Tolerance> for JointTolerance {
    fn from(document: Tolerance) -> Self {
        Self { document, distance: None, angle: None, curvature_gap: None }
    }
}

/// How far two joined pieces agree geometrically.
///
/// An order counts where it was measured to hold. Where nobody asked for its tolerance it also counts
/// where the pieces agree to it by the parameter, which says more.
pub(crate) struct Agreement<const N: usize> {
    /// Of each order from 1 on, whether it holds, and whether somebody asked for its tolerance.
    pub(crate) orders: [(bool, bool); N],
}

impl<const N: usize> Agreement<N> {
    /// The highest order up to which all hold, where points and derivatives by the parameter agree
    /// up to an order.
    pub(crate) fn order(&self, by_parameter: usize) -> usize {
        let holds = |&(k, &(is_met, is_asked)): &(usize, &(bool, bool))| {
            is_met || !is_asked && k < by_parameter
        };
        self.orders.iter().enumerate().take_while(holds).count()
    }
}
