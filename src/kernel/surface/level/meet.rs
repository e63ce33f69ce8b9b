//! Where two surfaces cross, and where a curve passes through a surface.
//!
//! Pairs of parts whose boxes or slabs are apart are dropped, the others halved, until their cones
//! of normals tell that they cross in at most one arc; so no loop is lost between samples. From a
//! place on such an arc `trace` follows the curve as far as it goes; arcs that lie on a curve that is
//! known are told by it. Pairs that are flat before they cross clearly touch.
//!
//! Sederberg & Meyers, *Loop detection in surface patch intersections*, CAGD 5 (1988); Barnhill &
//! Kersey, *A marching method for parametric surface/surface intersection*, CAGD 7 (1990).

use super::{
    FITTING, LevelSet, PictureError,
    chain::{self, Spot},
    cubic::{self, Cubic},
    pair::Part,
    plane::SPLINE_SHARE,
    sample::{Run, length_between},
    trace::{Crossing, Place},
};
use crate::kernel::{Bounds, GeomError, NurbsCurve, Surface, Tolerance};

/// Pairs of parts that are looked at before the surfaces count as running together.
const MAX_PAIRS: usize = 80_000;

/// Contacts that make up touches in points; more make up areas or lines.
const MOST_CONTACTS: usize = 1000;

/// Part of the tolerance within which parts are flat, and near enough to touch.
const FLAT: f64 = 0.02;

/// A touch this many times longer than its parts is no point.
const LONGEST_TOUCH: f64 = 24.0;

impl Surface {
    /// The curves in which the surface crosses another, within the tolerance's distance and complete;
    /// they run along N × N of the two. Functions are crossed as splines that near.
    ///
    /// Where the surfaces only touch in a point, that is told among the touches.
    ///
    /// # Errors
    /// [`PictureError::SurfacesRunTogether`] where they share more than curves in which they cross; for
    /// functions as [`super::super::ParametricSurface::to_nurbs`].
    pub fn intersections(&self, other: &Self, tolerance: Tolerance) -> Result<LevelSet, GeomError> {
        let [a, b] = [self, other].map(|s| s.splined(SPLINE_SHARE * tolerance.distance));
        let (a, b) = (a?, b?);
        let size = a.bounds().diagonal().min(b.bounds().diagonal());
        let crossing = Crossing::new([&a, &b], tolerance.distance_for(size), size);
        let (pairs, spots) = pairs(&crossing)?;
        let runs = runs(&crossing, pairs, &spots)?;
        let chained = chain::chained(runs, &spots, crossing.tolerance);
        let spline =
            |line: Vec<super::sample::Sample>| cubic::spline(&line, FITTING * crossing.tolerance);
        let curves: Result<Vec<NurbsCurve>, GeomError> =
            chained.lines.into_iter().filter(|line| 1 < line.len()).map(spline).collect();
        Ok(LevelSet { curves: curves?, touches: chained.isolated })
    }
}

/// Pairs of parts that cross in one arc if they do, and places where the surfaces touch.
fn pairs(crossing: &Crossing<'_>) -> Result<(Vec<[Part; 2]>, Vec<Spot>), GeomError> {
    let near = FLAT * crossing.tolerance;
    let [firsts, seconds] = crossing.surfaces.map(Part::all);
    let mut todo: Vec<[Part; 2]> = Vec::new();
    for a in &firsts {
        let beside = seconds.iter().filter(|b| !a.is_apart(b, near));
        todo.extend(beside.map(|b| [a.clone(), b.clone()]));
    }
    let mut clear = Vec::new();
    let mut contacts: Vec<(Bounds, [f64; 4])> = Vec::new();
    let mut n_pairs = 0;
    while let Some([a, b]) = todo.pop() {
        n_pairs += 1;
        if MAX_PAIRS < n_pairs {
            return Err(PictureError::SurfacesRunTogether { point: a.bounds.center() }.into());
        }
        if a.crosses_clearly(&b) {
            clear.push([a, b]);
        } else if a.thickness().max(b.thickness()) <= near
            && a.bounds.diagonal().max(b.bounds.diagonal()) <= crossing.touch_size()
        {
            let ([u, v], [s, t]) = (a.middle(), b.middle());
            contacts.push((a.bounds.union(b.bounds), [u, v, s, t]));
        } else {
            todo.extend(halved([a, b], near));
        }
    }
    Ok((clear, spots(crossing, contacts)?))
}

/// A pair with its larger part in halves, those that are near.
fn halved([a, b]: [Part; 2], near: f64) -> Vec<[Part; 2]> {
    let pairs: Vec<[Part; 2]> = if b.bounds.diagonal() <= a.bounds.diagonal() {
        a.halves().into_iter().map(|half| [half, b.clone()]).collect()
    } else {
        b.halves().into_iter().map(|half| [a.clone(), half]).collect()
    };
    pairs.into_iter().filter(|[a, b]| !a.is_apart(b, near)).collect()
}

/// The places of contacts that hang together.
fn spots(
    crossing: &Crossing<'_>,
    contacts: Vec<(Bounds, [f64; 4])>,
) -> Result<Vec<Spot>, GeomError> {
    let places: Vec<(glam::DVec3, f64)> =
        contacts.iter().map(|(bounds, _)| (bounds.center(), 0.5 * bounds.diagonal())).collect();
    if MOST_CONTACTS < places.len() {
        return Err(PictureError::SurfacesRunTogether { point: places[0].0 }.into());
    }
    let mut group: Vec<usize> = (0..places.len()).collect();
    for (i, k) in chain::near_pairs(&places, crossing.tolerance) {
        let (old, new) = (group[i].max(group[k]), group[i].min(group[k]));
        group.iter_mut().filter(|number| **number == old).for_each(|number| *number = new);
    }
    let mut spots = Vec::new();
    for number in 0..places.len() {
        let members: Vec<usize> = (0..places.len()).filter(|&i| group[i] == number).collect();
        let Some(&first) = members.first() else { continue };
        let whole = members.iter().fold(contacts[first].0, |all, &i| all.union(contacts[i].0));
        let widest = members.iter().map(|&i| 2.0 * places[i].1).fold(0.0, f64::max);
        if LONGEST_TOUCH * widest < whole.diagonal() {
            return Err(PictureError::SurfacesRunTogether { point: whole.center() }.into());
        }
        let center = whole.center();
        let nearest = members.iter().copied().min_by(|&i, &k| {
            let away = |i: usize| places[i].0.distance(center);
            away(i).total_cmp(&away(k))
        });
        let found = nearest.and_then(|i| crossing.touch(contacts[i].1));
        if let Some(point) = found {
            spots.push(Spot { point, radius: point.distance(center) + 0.5 * whole.diagonal() });
        }
    }
    Ok(spots)
}

/// The curves through all pairs.
fn runs(
    crossing: &Crossing<'_>,
    pairs: Vec<[Part; 2]>,
    spots: &[Spot],
) -> Result<Vec<Run>, GeomError> {
    let near = FLAT * crossing.tolerance;
    let mut runs: Vec<Run> = Vec::new();
    let mut todo = pairs;
    let mut n_pairs = 0;
    while let Some(pair) = todo.pop() {
        let [a, b] = &pair;
        n_pairs += 1;
        if MAX_PAIRS < n_pairs {
            return Err(PictureError::SurfacesRunTogether { point: a.bounds.center() }.into());
        }
        let size = a.bounds.diagonal().max(b.bounds.diagonal());
        let Some(place) = common(crossing, &pair) else {
            if crossing.tolerance < size {
                todo.extend(halved(pair, near));
            }
            continue;
        };
        let mut run = runs.iter().find(|run| passes(run, place, crossing.tolerance));
        if run.is_none() {
            runs.push(crossing.run(place, spots));
            run = runs.last();
        }
        // Behind the end of a run another may begin.
        let ends_here = run.is_some_and(|run| {
            let is_here = |point| a.bounds.contains(point, near) && b.bounds.contains(point, near);
            run.start() != run.end() && (is_here(run.start()) || is_here(run.end()))
        });
        if ends_here && crossing.tolerance < size {
            todo.extend(halved(pair, near));
        }
    }
    Ok(runs)
}

/// A place that a pair has in common, inside both.
fn common(crossing: &Crossing<'_>, [a, b]: &[Part; 2]) -> Option<Place> {
    let ([u, v], [s, t]) = (a.middle(), b.middle());
    let widths =
        [a.high[0] - a.low[0], a.high[1] - a.low[1], b.high[0] - b.low[0], b.high[1] - b.low[1]];
    let place = crossing.common([u, v, s, t], widths)?;
    let [u, v, s, t] = place.at;
    (a.holds([u, v]) && b.holds([s, t])).then_some(place)
}

/// Whether a run passes through a place.
fn passes(run: &Run, place: Place, tolerance: f64) -> bool {
    run.samples.windows(2).any(|pair| {
        let chord = pair[1].point - pair[0].point;
        let along = (place.point - pair[0].point).dot(chord) / chord.length_squared();
        let reach = pair[0].point.distance(place.point).min(pair[1].point.distance(place.point));
        reach <= chord.length()
            && Cubic::between(pair[0], pair[1], length_between(pair[0], pair[1]))
                .misses_near(place.point, along.clamp(0.0, 1.0))
                <= 4.0 * tolerance
    })
}
