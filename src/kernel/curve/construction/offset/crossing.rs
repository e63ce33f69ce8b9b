//! Where an offset crosses itself.

use crate::{
    Bounds, GeomError, IntersectionError, Interval,
    curve::{CurveIntersection, NurbsCurve, intersection::intersect::work},
    sorting::sort_by,
    tolerance::TURN_MARGIN,
};

/// Where a curve crosses itself, given the parameters at which it turns back. The seam of a closed
/// curve is no crossing.
///
/// # Errors
/// [`IntersectionError::RunsAlongItself`], [`IntersectionError::Tangled`].
pub(super) fn crossings(
    curve: &NurbsCurve,
    turns: &[f64],
    tolerance: f64,
) -> Result<Vec<CurveIntersection>, GeomError> {
    let domain = curve.domain();
    let mut ends = turns.to_vec();
    ends.retain(|&t| domain.start() < t && t < domain.end());
    ends.sort_by(f64::total_cmp);
    let turns_at = |t: f64| turns.iter().any(|&turn| turn.total_cmp(&t).is_eq());
    let ends = [&[domain.start()], &ends[..], &[domain.end()]].concat();
    let mut stretches: Vec<(Bounds, NurbsCurve)> = Vec::new();
    for pair in ends.windows(2) {
        let margin = TURN_MARGIN * (pair[1] - pair[0]);
        let [before, behind] = [0, 1].map(|i| if turns_at(pair[i]) { margin } else { 0.0 });
        let Ok(part) = Interval::new(pair[0] + before, pair[1] - behind) else { continue };
        // The trimmed curve keeps its parameters.
        let Ok(stretch) = curve.trimmed(part) else { continue };
        let bounds = Bounds::of(stretch.points()).filter(|bounds| tolerance < bounds.diagonal());
        stretches.extend(bounds.map(|bounds| (bounds, stretch)));
    }

    let is_seam = |meeting: &CurveIntersection| {
        let near = TURN_MARGIN * domain.length();
        meeting.first - domain.start() <= near
            && domain.end() - meeting.second <= near
            && curve.start().distance(meeting.point) <= tolerance
    };
    let mut found = Vec::new();
    let mut left = work([curve, curve]);
    for (i, (bounds, stretch)) in stretches.iter().enumerate() {
        found.extend(stretch.own_meetings(tolerance, &mut left)?);
        let later = &stretches[i + 1..];
        left = left
            .checked_sub(later.len())
            .ok_or(GeomError::Intersection(IntersectionError::Tangled))?;
        for (others, other) in later {
            if bounds.is_near(*others, tolerance) {
                found.extend(stretch.meetings_with(other, tolerance, &mut left)?);
            }
        }
    }
    found.retain(|meeting| !is_seam(meeting));
    sort_by(&mut found, |a, b| a.first.total_cmp(&b.first).then(a.second.total_cmp(&b.second)));
    Ok(found)
}
