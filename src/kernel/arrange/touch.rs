//! Arcs that cross twice within the tolerance touch once, where they are farthest into one another.
//!
//! Of such crossings the search for meetings tells one. Arcs cut there alone would not be cut at the
//! other, and what is between the two would be on the wrong side.

use crate::{
    NurbsCurve,
    ceiling::NEWTON_STEPS,
    frame::norm,
    numeric::{
        linear::TwoEquations,
        newton::{NewtonStep, within_limits},
    },
    tolerance::LAST_BIT,
};

/// Parts of the way from a crossing to a touch at whose ends the arcs are compared.
const WAY_PARTS: usize = 8;

/// Where two arcs run side by side, if all the way there from a crossing they are within the tolerance
/// of one another; else the crossing. Both by the parameters of the two arcs.
pub(super) fn touch_of(
    first: &NurbsCurve,
    second: &NurbsCurve,
    crossing: [f64; 2],
    tolerance: f64,
) -> [f64; 2] {
    // Straight legs run side by side all along or nowhere; arcs of degree 1 may have corners that go on straight.
    if [first, second].iter().all(|arc| arc.degree() == 1 && arc.control_points().len() == 2) {
        return crossing;
    }
    let Some(touch) = side_by_side_near(first, second, crossing) else { return crossing };
    let is_on = |i: usize| {
        let way = i as f64 / WAY_PARTS as f64;
        let point = first.point_at(crossing[0] + (touch[0] - crossing[0]) * way);
        second.foot_within(point, tolerance).is_some()
    };
    let apart = norm(second.point_at(touch[1]) - first.point_at(touch[0]));
    if apart <= tolerance && (1..=WAY_PARTS).all(is_on) { touch } else { crossing }
}

/// The parameters at which two arcs have one direction, straight across from one another: Newton's
/// method from a place; none where it does not come to rest.
fn side_by_side_near(first: &NurbsCurve, second: &NurbsCurve, start: [f64; 2]) -> Option<[f64; 2]> {
    let domains = [first.domain(), second.domain()];
    let limits = domains.map(|domain| [domain.start(), domain.end()]);
    let is_still = |at: [f64; 2], next: [f64; 2]| {
        (0..2).all(|i| (next[i] - at[i]).abs() <= LAST_BIT.sqrt() * domains[i].length())
    };
    let found = within_limits(limits, start, NEWTON_STEPS, is_still, |[s, t]| {
        let (own, its) = (first.derivatives_at(s, 2), second.derivatives_at(t, 2));
        let apart = own[0] - its[0];
        let matrix = [
            [own[2].cross(its[1]).z, own[1].cross(its[2]).z],
            [own[1].dot(its[1]), apart.dot(its[2]) - its[1].length_squared()],
        ];
        let off = [-own[1].cross(its[1]).z, -apart.dot(its[1])];
        let steps = TwoEquations { matrix }.solved(off);
        NewtonStep::perhaps(steps.iter().all(|step| step.is_finite()).then_some(steps))
    });
    found.settled()
}
