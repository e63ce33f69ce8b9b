//! Where arcs meet: single places, and the ends of the stretches that they share.

use std::borrow::Cow;

use glam::DVec3;

use super::touch::touch_of;
use crate::{
    CurveIntersection, GeomError, IntersectionError, Interval, NurbsCurve,
    ceiling::{BISECTIONS, SHARED_STRETCHES},
    frame::norm,
    numeric::bisection::bisected,
    tolerance::{LAST_BIT, PARTING_ROUNDINGS, PARTING_SHARE, QUARTER_SLACK, VERTEX_REACH},
};

/// The parameters of both at each place where two arcs meet, or begin or end to run together.
///
/// # Errors
/// [`IntersectionError::Tangled`].
pub(super) fn meetings(
    first: &NurbsCurve,
    second: &NurbsCurve,
    tolerance: f64,
) -> Result<Vec<[f64; 2]>, GeomError> {
    // Circles that cross clearly touch nowhere.
    if let Some(crossings) = first.circle_crossings(second, tolerance) {
        return Ok(crossings.iter().map(|place| [place.first, place.second]).collect());
    }
    let mut found = Vec::new();
    let mut rests = vec![first.domain()];
    let mut n_stretches = 0;
    // Behind the places where arcs part they are still within the tolerance of one another.
    let mut behind: Vec<DVec3> = Vec::new();
    while let Some(rest) = rests.pop() {
        GeomError::go_on(1)?;
        let part = match rest == first.domain() {
            true => Cow::Borrowed(first),
            false => Cow::Owned(first.trimmed(rest)?),
        };
        match part.intersections(second, tolerance) {
            Ok(meetings) => {
                let is_new = |place: &&CurveIntersection| {
                    let apart = |end: &DVec3| norm(first.point_at(place.first) - *end);
                    behind.iter().all(|end| VERTEX_REACH * tolerance < apart(end))
                };
                let new = meetings.iter().filter(is_new);
                found.extend(new.map(|place| [place.first, place.second]));
            }
            Err(GeomError::Intersection(IntersectionError::RunTogether { start, end })) => {
                n_stretches += 1;
                if SHARED_STRETCHES < n_stretches {
                    return Err(IntersectionError::Tangled.into());
                }
                let ends = parting_places(first, second, [start, end], tolerance);
                let on_second = |t: f64| second.closest(first.point_at(t), tolerance).parameter;
                found.extend(ends.map(|t| [t, on_second(t)]));
                let moved =
                    ends.into_iter().zip([start, end]).filter(|(end, t)| 0.0 < (t - end).abs());
                behind.extend(moved.map(|(_, t)| first.point_at(t)));
                rests.extend(beside(first, rest, [start, end], tolerance));
            }
            Err(other) => return Err(other),
        }
    }
    if n_stretches == 0 {
        found.iter_mut().for_each(|place| *place = touch_of(first, second, *place, tolerance));
    } else {
        // Ends that lie within a stretch are places like others.
        found.extend(ends_on(first, second, tolerance));
        found.extend(ends_on(second, first, tolerance).map(|[own, other]| [other, own]));
    }
    Ok(found)
}

/// Where arcs that run together part, as far as that is told from rounding.
///
/// Arcs that part in one direction are within the tolerance a long way behind: whoever changes over from one to the other
/// there has left the first by all of it, and is neither on it nor beside it when they are compared once more. They part
/// where they are one if halving the way from there on divides by four, at least, what they are apart; arcs that are near one
/// another by chance do not.
fn parting_places(
    first: &NurbsCurve,
    second: &NurbsCurve,
    [start, end]: [f64; 2],
    tolerance: f64,
) -> [f64; 2] {
    let domain = first.domain();
    // A stretch may go over the seam of a closed arc.
    let length = if end < start { end - start + domain.length() } else { end - start };
    let at = |part: f64| {
        let t = start + part * length;
        if domain.end() < t { t - domain.length() } else { t }
    };
    let apart = |part: f64| second.closest(first.point_at(at(part)), tolerance).distance;
    let size = norm(first.point_at(start)).max(norm(first.point_at(end)));
    let rounding = (PARTING_SHARE * tolerance).max(PARTING_ROUNDINGS * LAST_BIT * size);
    [(start, 0.0), (end, 1.0)].map(|(place, far)| {
        let is_one = |from: f64| {
            let mut before = apart(far);
            let mut way = far - from;
            while rounding < before {
                way *= 0.5;
                let here = apart(from + way);
                if QUARTER_SLACK * before < here {
                    return false;
                }
                before = here;
            }
            true
        };
        let from =
            [0.5, 1.0 - far].into_iter().find(|&from| apart(from) <= rounding && is_one(from));
        match from {
            Some(from) if rounding < apart(far) => {
                at(bisected([from, far], BISECTIONS, |part| apart(part) <= rounding)[0])
            }
            _ => place,
        }
    })
}

/// What is left of a part beside a stretch, which may go over the seam of a closed arc.
fn beside(
    curve: &NurbsCurve,
    whole: Interval,
    [start, end]: [f64; 2],
    tolerance: f64,
) -> impl Iterator<Item = Interval> {
    let ends = if end < start {
        vec![[end, start]]
    } else {
        vec![[whole.start(), start], [end, whole.end()]]
    };
    let is_long = move |rest: &Interval| {
        let from = curve.point_at(rest.start());
        rest.steps(4).into_iter().any(|t| tolerance < norm(curve.point_at(t) - from))
    };
    let is_part = move |rest: &Interval| *rest != whole;
    ends.into_iter().filter_map(|[a, b]| Interval::new(a, b).ok()).filter(is_long).filter(is_part)
}

/// The ends of an arc that lie on another, by the parameters of both.
fn ends_on(
    curve: &NurbsCurve,
    other: &NurbsCurve,
    tolerance: f64,
) -> impl Iterator<Item = [f64; 2]> {
    let domain = curve.domain();
    [domain.start(), domain.end()].into_iter().filter_map(move |t| {
        let nearest = other.closest(curve.point_at(t), tolerance);
        (nearest.distance <= tolerance).then_some([t, nearest.parameter])
    })
}

/// The parameters of each place where an arc meets itself, other than in its seam.
///
/// # Errors
/// `IntersectionError::RunsAlongItself`, `IntersectionError::Tangled`.
pub(super) fn own_meetings(curve: &NurbsCurve, tolerance: f64) -> Result<Vec<[f64; 2]>, GeomError> {
    let is_straight = curve.degree() == 1 && curve.n_segments() == 1;
    if is_straight || curve.is_circular_arc(tolerance) {
        return Ok(Vec::new());
    }
    let meetings = curve.self_intersections(tolerance)?;
    Ok(meetings.iter().map(|place| [place.first, place.second]).collect())
}
