//! Where a curve jumps: an inner knot that stands degree + 1 times parts it into pieces whose ends
//! need not meet.
//!
//! Questions are asked of each connected part; whatever needs one line from start to end refuses a
//! jump by its place and size.

use std::borrow::Cow;

use glam::DVec3;

use crate::{
    GeomError, JumpError, Side,
    curve::{CurveIntersection, NurbsCurve, intersection::intersect::work},
    homogeneous,
    sorting::sort_by,
    tolerance::LAST_BIT,
};

/// Last bits of a coordinate within which two ends meet.
const MOST_ROUNDINGS: f64 = 16.0;

impl NurbsCurve {
    /// The inner parameters at which the curve jumps, each with the distance of both sides.
    #[must_use]
    pub fn jumps(&self) -> Vec<(f64, f64)> {
        if !self.knots.has_inner_full_break() {
            return Vec::new();
        }
        let domain = self.domain();
        let rounding = MOST_ROUNDINGS * LAST_BIT * self.magnitude();
        let full = self.knots.full_breaks();
        let inner = full.into_iter().filter(|&t| domain.start() < t && t < domain.end());
        let gaps = inner.map(|t| {
            let [before, behind] = [Side::Left, Side::Right].map(|side| self.point_beside(t, side));
            (t, before.distance(behind))
        });
        gaps.filter(|&(_, gap)| rounding < gap).collect()
    }

    /// The point at `t` of the piece on one side of it.
    #[must_use]
    pub fn point_beside(&self, t: f64, side: Side) -> DVec3 {
        let span = self.knots.span_beside(t, side);
        homogeneous::project(self.homogeneous_derivatives(span, t, 0)[0])
    }

    /// # Errors
    /// [`JumpError::Curve`] at the first jump.
    pub fn check_connected(&self) -> Result<(), GeomError> {
        match self.jumps().first() {
            Some(&(parameter, gap)) => Err(JumpError::Curve { parameter, gap }.into()),
            None => Ok(()),
        }
    }

    /// The parts between jumps, on their own parts of the domain.
    #[must_use]
    pub fn connected_parts(&self) -> Vec<Cow<'_, Self>> {
        let jumps = self.jumps();
        if jumps.is_empty() {
            return vec![Cow::Borrowed(self)];
        }
        let mut parts = Vec::with_capacity(jumps.len() + 1);
        let mut rest = self.clamped();
        for (at, _) in jumps {
            if let Ok([part, behind]) = rest.split(at) {
                parts.push(Cow::Owned(part));
                rest = behind;
            }
        }
        parts.push(Cow::Owned(rest));
        parts
    }

    /// A parameter of a connected part as one of the whole, whose point at it is the same: at a jump
    /// the end of the part before it is the last parameter before it.
    pub(in crate::curve) fn on_whole(&self, part: &Self, t: f64) -> f64 {
        let end = part.domain().end();
        if end <= t && end < self.domain().end() { end.next_down() } else { t }
    }

    /// Meetings of all connected parts with those of another curve; with its own if there is none.
    pub(in crate::curve) fn meetings_of_parts(
        &self,
        other: Option<&Self>,
        tolerance: f64,
        left: &mut usize,
    ) -> Result<Vec<CurveIntersection>, GeomError> {
        let own = self.connected_parts();
        let others = other.map(Self::connected_parts);
        let mut meetings = Vec::new();
        for (i, a) in own.iter().enumerate() {
            if others.is_none() {
                for found in a.own_meetings(tolerance, left)? {
                    let [first, second] = [found.first, found.second].map(|t| self.on_whole(a, t));
                    meetings.push(CurveIntersection { first, second, ..found });
                }
            }
            let whole = other.unwrap_or(self);
            for b in others.as_deref().unwrap_or_else(|| &own[i + 1..]) {
                for found in a.meetings_with(b, tolerance, left)? {
                    let (first, second) =
                        (self.on_whole(a, found.first), whole.on_whole(b, found.second));
                    meetings.push(CurveIntersection { first, second, ..found });
                }
            }
        }
        sort_by(&mut meetings, |a, b| {
            a.first.total_cmp(&b.first).then(a.second.total_cmp(&b.second))
        });
        Ok(meetings)
    }

    /// [`Self::meetings_of_parts`] of curves that jump; none where both are connected.
    pub(in crate::curve) fn meetings_over_jumps(
        &self,
        other: Option<&Self>,
        tolerance: f64,
    ) -> Option<Result<Vec<CurveIntersection>, GeomError>> {
        let is_connected = |curve: &Self| curve.jumps().is_empty();
        if is_connected(self) && other.is_none_or(is_connected) {
            return None;
        }
        let mut left = work([self, other.unwrap_or(self)]);
        Some(self.meetings_of_parts(other, tolerance, &mut left))
    }
}
