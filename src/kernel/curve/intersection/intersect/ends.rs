//! Ends at which one curve goes on from another, as the sides of an outline with round corners do.
//!
//! There the curves share a direction and no search by halving comes to an end before the tolerance. But two pieces that
//! together keep to one direction have nothing else in common.

use super::meeting::{CurveIntersection, IntersectionSearch};
use crate::{
    curve::{
        NurbsCurve,
        representation::part::{CurvePart, DirectionCone},
    },
    homogeneous,
};

/// Roundings within which ends are one place.
const SAME_ROUNDINGS: f64 = 16.0;

/// An end of a piece that is one of its curve: the parameter there, whether it is the start, and the directions in which
/// the piece leads away from it.
struct PieceEnd {
    parameter: f64,
    is_start: bool,
    onward: DirectionCone,
}

impl IntersectionSearch<'_> {
    /// The meeting of two pieces one of which goes on where the other one ends, in whatever sense they run, where that
    /// is all that they have in common.
    pub(super) fn end_joint(&self, a: &CurvePart, b: &CurvePart) -> Option<CurveIntersection> {
        if self.is_same {
            return None;
        }
        let others = ends_of(self.second, b);
        ends_of(self.first, a).into_iter().flatten().find_map(|own| {
            let p = place(a, own.is_start);
            let other = others.iter().flatten().find(|other| {
                let apart = p.distance(place(b, other.is_start));
                apart <= SAME_ROUNDINGS * self.rounding
                    && own.onward.reversed().with(other.onward).is_narrow()
            })?;
            let point = p.midpoint(place(b, other.is_start));
            Some(CurveIntersection { first: own.parameter, second: other.parameter, point })
        })
    }
}

/// The ends of a piece that are those of its curve.
fn ends_of(curve: &NurbsCurve, part: &CurvePart) -> [Option<PieceEnd>; 2] {
    let (own, whole) = (part.interval, curve.domain());
    let start = (own.start() <= whole.start()).then(|| PieceEnd {
        parameter: whole.start(),
        is_start: true,
        onward: part.cone(),
    });
    let end = (whole.end() <= own.end()).then(|| PieceEnd {
        parameter: whole.end(),
        is_start: false,
        onward: part.cone().reversed(),
    });
    [start, end]
}

fn place(part: &CurvePart, is_start: bool) -> glam::DVec3 {
    let at = if is_start { 0 } else { part.points.len() - 1 };
    homogeneous::project(part.points[at])
}
