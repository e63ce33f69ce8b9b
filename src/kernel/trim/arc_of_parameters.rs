//! Arcs of the parameters of a face.

use std::sync::Arc;

use crate::{Interval, NurbsCurve, tolerance::PARAMETER_RELATIVE};

/// A part of a curve in the plane z = 0 of the parameters of a surface, or that part backward.
///
/// ```
/// use virote_kernel::{NurbsCurve, ParameterArc, glam::DVec3};
///
/// let line = NurbsCurve::line(DVec3::ZERO, DVec3::X)?;
/// let back = ParameterArc::whole(line).reversed();
/// assert!(back.is_straight() && back.range == [1.0, 0.0]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct ParameterArc {
    /// The curve.
    pub curve: Arc<NurbsCurve>,
    /// Its parameters where the part starts and ends; backward the first is the larger one.
    pub range: [f64; 2],
}

impl ParameterArc {
    /// All of a curve.
    #[must_use]
    pub fn whole(curve: NurbsCurve) -> Self {
        let domain = curve.domain();
        Self { curve: Arc::new(curve), range: [domain.start(), domain.end()] }
    }

    /// The same from its end to its start.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let [from, to] = self.range;
        Self { curve: Arc::clone(&self.curve), range: [to, from] }
    }

    /// Whether it runs along a line of a constant parameter.
    #[must_use]
    pub fn is_straight(&self) -> bool {
        let [start, end] = [self.curve.start(), self.curve.end()];
        let (wide, high) = ((end.x - start.x).abs(), (end.y - start.y).abs());
        let is_line = self.curve.degree() == 1 && self.curve.control_points().len() == 2;
        is_line && wide.min(high) <= PARAMETER_RELATIVE * wide.max(high)
    }

    /// The parameters inside at which the curve has knots, in its order.
    pub(super) fn breaks(&self) -> Vec<f64> {
        let [from, to] = self.range;
        let (low, high) = (from.min(to), from.max(to));
        let mut breaks = self.curve.knots().breaks();
        breaks.retain(|&t| low < t && t < high);
        if to < from {
            breaks.reverse();
        }
        breaks
    }

    /// The part as a curve of its own; none where that would have spans of no width.
    pub(super) fn as_curve(&self) -> Option<NurbsCurve> {
        let [from, to] = self.range;
        let domain = self.curve.domain();
        let (low, high) = (from.min(to), from.max(to));
        let is_whole = low <= domain.start() && domain.end() <= high;
        let part = if is_whole {
            (*self.curve).clone()
        } else {
            let least = PARAMETER_RELATIVE * domain.length();
            let breaks = self.curve.knots().breaks();
            let is_beside = |end: f64| {
                breaks.iter().any(|&t| 0.0 < (t - end).abs() && (t - end).abs() <= least)
            };
            if is_beside(low) || is_beside(high) {
                return None;
            }
            self.curve.trimmed(Interval::new(low, high).ok()?).ok()?
        };
        Some(if to < from { part.reversed() } else { part })
    }
}
