//! Where arcs meet: single places, and the ends of the stretches that they share.

use super::touch::touch_of;
use crate::{
    GeomError, IntersectionError, Interval, NurbsCurve, ceiling::SHARED_STRETCHES, frame::norm,
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
    let mut found = Vec::new();
    let mut rests = vec![first.domain()];
    let mut n_stretches = 0;
    while let Some(rest) = rests.pop() {
        GeomError::go_on(1)?;
        let part = if rest == first.domain() { first.clone() } else { first.trimmed(rest)? };
        match part.intersections(second, tolerance) {
            Ok(meetings) => found.extend(meetings.iter().map(|place| [place.first, place.second])),
            Err(GeomError::Intersection(IntersectionError::RunTogether { start, end })) => {
                n_stretches += 1;
                if SHARED_STRETCHES < n_stretches {
                    return Err(IntersectionError::Tangled.into());
                }
                let on_second = |t: f64| second.closest(first.point_at(t), tolerance).parameter;
                found.extend([start, end].map(|t| [t, on_second(t)]));
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
    if curve.degree() == 1 && curve.n_segments() == 1 {
        return Ok(Vec::new());
    }
    let meetings = curve.self_intersections(tolerance)?;
    Ok(meetings.iter().map(|place| [place.first, place.second]).collect())
}
