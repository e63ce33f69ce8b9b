//! Where two surfaces cross, and where a curve passes through a surface.
//!
//! Pairs of parts whose boxes or slabs are apart are dropped, the others halved, until their cones
//! of normals tell that they cross in at most one arc; so no loop is lost between samples. From a
//! place on such an arc `trace` follows the curve as far as it goes; arcs that lie on a curve that is
//! known are told by it. Where normals are parallel, `touch` tells what the surfaces share about
//! that place, and pairs within are dropped. Pairs that are flat before any of this touch.
//!
//! Sederberg & Meyers, *Loop detection in surface patch intersections*, CAGD 5 (1988); Barnhill &
//! Kersey, *A marching method for parametric surface/surface intersection*, CAGD 7 (1990).

use glam::DVec3;

use super::{
    FITTING, LevelSet, PictureError,
    chain::{self, Spot},
    cubic::{self, Cubic},
    pair::Part,
    sample::{Run, Sample, length_between},
    seam::Seam,
    touch::{Contact, Reach},
    trace::{Crossing, Ends, Place},
};
use crate::kernel::{
    Bounds, GeomError, NurbsCurve, Surface, Tolerance,
    tolerance::{CONTACT_SHARE, ONE_PLACE_SHARE},
};

/// Pairs of parts that are looked at before the surfaces count as running together.
const MAX_PAIRS: usize = 200_000;

/// Pairs in which a contact is looked for before it seems that second derivatives do not tell any.
const MAX_LOOKS: usize = 4000;

/// Contacts that make up touches in points; more make up areas or lines.
const MOST_CONTACTS: usize = 1000;

/// Part of the tolerance within which parts are flat, and near enough to touch.
const FLAT: f64 = 0.02;

/// Part of the tolerance within which splines stand in for functions: less than what counts as a
/// contact.
const SPLINE_SHARE: f64 = 0.4 * CONTACT_SHARE;

/// How far, in tolerances, a curve of two surfaces that are nearly parallel may be told beside it.
const FAR_ASIDE: f64 = 64.0;

/// A touch this many times longer than its parts is no point.
const LONGEST_TOUCH: f64 = 24.0;

impl Surface {
    /// The curves in which the surface crosses another or touches it, within the tolerance's distance
    /// and complete; they run along N × N of the two. Functions are crossed as splines that near.
    ///
    /// An edge that both have in common is that edge. Where the surfaces only touch in a point, that is
    /// told among the touches.
    ///
    /// # Errors
    /// [`PictureError::SurfacesRunTogether`] where they share more than curves; for functions as
    /// [`super::super::ParametricSurface::to_nurbs`].
    pub fn intersections(&self, other: &Self, tolerance: Tolerance) -> Result<LevelSet, GeomError> {
        let [a, b] = [self, other].map(|s| s.splined(SPLINE_SHARE * tolerance.distance));
        let (a, b) = (a?, b?);
        let size = a.bounds().diagonal().min(b.bounds().diagonal());
        let crossing = Crossing::new([&a, &b], tolerance.distance_for(size), size);
        let seams = Seam::all([&a, &b], crossing.tolerance)?;
        if let Some(point) =
            seams.iter().find_map(|seam| seam.overlap([&a, &b], crossing.tolerance))
        {
            return Err(PictureError::SurfacesRunTogether { point }.into());
        }
        let Found { clear, mut ends, touches, lines, .. } = pairs(&crossing, &seams)?;
        let mut runs = lines;
        let mut uncertain: Vec<DVec3> =
            runs.iter().map(|run| run.samples[run.samples.len() / 2].point).collect();
        branches(&crossing, &ends, &mut runs);
        arcs(&crossing, clear, &ends, &mut runs)?;
        let met = |spot: &Spot| is_met(spot, &runs, crossing.tolerance);
        uncertain.extend(ends.spots.iter().filter(|spot| met(spot)).map(|spot| spot.point));
        // A spot in the middle of a curve is no touch in a point.
        ends.spots.retain(|spot| n_ends(spot, &runs) != 0 || !met(spot));
        ends.spots.extend(touches);
        let poles = crossing.poles.iter().map(|&point| Spot { point, radius: crossing.tolerance });
        let is_passed =
            |spot: &Spot| runs.iter().any(|run| passes(run, spot.point, crossing.tolerance));
        ends.spots.extend(poles.filter(|spot| n_ends(spot, &runs) != 0 || !is_passed(spot)));
        let chained = chain::chained(runs, &ends.spots, crossing.tolerance);
        let spline = |line: Vec<Sample>| cubic::spline(&line, FITTING * crossing.tolerance);
        let seams_once = Seam::different(&seams, crossing.tolerance).into_iter();
        let lines = chained.lines.into_iter().filter(|line| 1 < line.len()).map(spline);
        let curves: Result<Vec<NurbsCurve>, GeomError> =
            seams_once.map(|seam| Ok(seam.directed([&a, &b]))).chain(lines).collect();
        let is_on_seam =
            |point: &DVec3| seams.iter().any(|seam| seam.holds(*point, crossing.tolerance));
        let touches = chained.isolated.into_iter().filter(|point| !is_on_seam(point)).collect();
        uncertain.retain(|point| !is_on_seam(point));
        Ok(LevelSet { curves: curves?, touches, uncertain })
    }
}

/// How many curves end in a spot.
fn n_ends(spot: &Spot, runs: &[Run]) -> usize {
    let ends = runs.iter().flat_map(|run| [run.start(), run.end()]);
    ends.filter(|end| end.distance(spot.point) <= spot.radius).count()
}

/// Whether curves meet in a spot, and do not only go on in one another.
fn is_met(spot: &Spot, runs: &[Run], tolerance: f64) -> bool {
    match n_ends(spot, runs) {
        0 => runs.iter().any(|run| passes(run, spot.point, tolerance)),
        n => n != 2,
    }
}

/// What two surfaces share, before it is followed.
#[derive(Default)]
struct Found {
    /// Pairs of parts that cross in one arc if they do.
    clear: Vec<[Part; 2]>,
    ends: Ends,
    /// Places where the surfaces only touch, and lines.
    touches: Vec<Spot>,
    lines: Vec<Run>,
    /// Where all is known.
    reaches: Vec<Reach>,
    /// How often a contact was looked for.
    n_looks: usize,
}

/// Sorts pairs of parts until each is apart, clear, or within what is known about a contact.
fn pairs(crossing: &Crossing<'_>, seams: &[Seam]) -> Result<Found, GeomError> {
    let near = FLAT * crossing.tolerance;
    let [firsts, seconds] = crossing.surfaces.map(Part::all);
    let mut todo: Vec<[Part; 2]> = Vec::new();
    for a in &firsts {
        let beside = seconds.iter().filter(|b| !a.is_apart(b, near));
        todo.extend(beside.map(|b| [a.clone(), b.clone()]));
    }
    let mut found = Found::default();
    let mut contacts: Vec<(Bounds, [f64; 4])> = Vec::new();
    let mut n_pairs = 0;
    while let Some([a, b]) = todo.pop() {
        n_pairs += 1;
        if MAX_PAIRS < n_pairs {
            return Err(PictureError::TooTangled { point: a.bounds.center() }.into());
        }
        let beside = || seams.iter().filter(|seam| seam.is_beside(&a, &b));
        if found.holds(&a, &b) || beside().any(|seam| seam.is_all_of(&a, &b)) {
            continue;
        }
        if beside().next().is_some() && crossing.touch_size() < a.bounds.union(b.bounds).diagonal()
        {
            todo.extend(halved([a, b], near));
        } else if a.crosses_clearly(&b) {
            found.clear.push([a, b]);
        } else if a.may_touch(&b) && found.add_contact(crossing, &a, &b, seams)? {
            todo.push([a, b]);
        } else if a.thickness().max(b.thickness()) <= near
            && a.bounds.diagonal().max(b.bounds.diagonal()) <= crossing.touch_size()
        {
            contacts.push((a.bounds.union(b.bounds), middle(&a, &b)));
        } else {
            todo.extend(halved([a, b], near));
        }
    }
    found.ends.spots = spots(crossing, contacts)?;
    Ok(found)
}

impl Found {
    /// Whether all is known that two parts share.
    fn holds(&self, a: &Part, b: &Part) -> bool {
        let low = [a.low[0], a.low[1], b.low[0], b.low[1]];
        let high = [a.high[0], a.high[1], b.high[0], b.high[1]];
        self.reaches.iter().any(|reach| reach.holds(low, high))
    }

    /// Looks for a contact in a pair; whether one was found that was not known.
    fn add_contact(
        &mut self,
        crossing: &Crossing<'_>,
        a: &Part,
        b: &Part,
        seams: &[Seam],
    ) -> Result<bool, GeomError> {
        let at = middle(a, b);
        if self.n_looks == MAX_LOOKS || self.reaches.iter().any(|reach| reach.holds(at, at)) {
            return Ok(false);
        }
        self.n_looks += 1;
        let seen = crossing.touch_near(at).filter(|seen| {
            let [u, v, s, t] = seen.at;
            crossing.is_contact(seen)
                && crossing.is_inside(seen.at)
                && a.is_about([u, v])
                && b.is_about([s, t])
                && !seams.iter().any(|seam| seam.holds(seen.point, crossing.tolerance))
                && !self.reaches.iter().any(|reach| reach.holds(seen.at, seen.at))
        });
        let Some(seen) = seen else { return Ok(false) };
        match crossing.contact(&seen) {
            None => return Ok(false),
            Some(Contact::Area) => {
                return Err(PictureError::SurfacesRunTogether { point: seen.point }.into());
            }
            Some(Contact::Point(reach)) => {
                self.touches.push(Spot { point: reach.point, radius: 0.0 });
                self.reaches.push(reach);
            }
            Some(Contact::Branches(junction)) => {
                self.reaches.push(junction.reach);
                self.ends.junctions.push(*junction);
            }
            Some(Contact::Line) => {
                let Some((run, reaches)) = crossing.tangency(&seen) else { return Ok(false) };
                if !is_known(&self.lines, &run, crossing.tolerance) {
                    self.lines.push(run);
                }
                self.reaches.extend(reaches);
            }
        }
        Ok(true)
    }
}

/// The parameters in the middle of both parts.
fn middle(a: &Part, b: &Part) -> [f64; 4] {
    let ([u, v], [s, t]) = (a.middle(), b.middle());
    [u, v, s, t]
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
    let places: Vec<(DVec3, f64)> =
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
        // Where no place is the best one, as at a pole, any is near enough.
        let seen = nearest.and_then(|i| crossing.touch_near(contacts[i].1));
        let is_here = |point: DVec3| whole.contains(point, 0.5 * whole.diagonal());
        let inside = seen.map(|seen| seen.point).filter(|&point| is_here(point));
        let pole = crossing.poles.iter().copied().find(|&pole| is_here(pole));
        let point = pole.or(inside).unwrap_or(center);
        spots.push(Spot { point, radius: point.distance(center) + 0.5 * whole.diagonal() });
    }
    Ok(spots)
}

/// The curves out of all junctions.
fn branches(crossing: &Crossing<'_>, ends: &Ends, runs: &mut Vec<Run>) {
    let near = ONE_PLACE_SHARE * crossing.tolerance;
    for way in ends.junctions.iter().flat_map(|junction| junction.ways) {
        let begins = |run: &Run| {
            let sample = if 0.0 < way.sign { run.samples.first() } else { run.samples.last() };
            sample.is_some_and(|sample| {
                sample.point.distance(way.place.point) <= near
                    && sample.before.distance(way.place.tangent) <= CONTACT_SHARE
            })
        };
        if runs.iter().any(begins) {
            continue;
        }
        let run = crossing.run_out(way, ends);
        if crossing.tolerance < run.length() && !is_known(runs, &run, crossing.tolerance) {
            runs.push(run);
        }
    }
}

/// Whether a run lies on others.
fn is_known(runs: &[Run], run: &Run, tolerance: f64) -> bool {
    let point = run.samples[run.samples.len() / 2].point;
    runs.iter().any(|other| passes(other, point, tolerance))
}

/// Adds the curves through all pairs that are not known.
fn arcs(
    crossing: &Crossing<'_>,
    pairs: Vec<[Part; 2]>,
    ends: &Ends,
    runs: &mut Vec<Run>,
) -> Result<(), GeomError> {
    // Where normals are nearly parallel parts of a tolerance are a long way.
    let near = crossing.rounding;
    let mut todo = pairs;
    let mut n_pairs = 0;
    while let Some(pair) = todo.pop() {
        let [a, b] = &pair;
        n_pairs += 1;
        if MAX_PAIRS < n_pairs {
            return Err(PictureError::TooTangled { point: a.bounds.center() }.into());
        }
        let size = a.bounds.diagonal().max(b.bounds.diagonal());
        let Some(place) = common(crossing, &pair) else {
            if crossing.tolerance < size {
                todo.extend(halved(pair, near));
            }
            continue;
        };
        let mut run = runs.iter().find(|run| passes(run, place.point, crossing.tolerance));
        if run.is_none() {
            let new = crossing.run(place, ends);
            match runs.iter().position(|known| repeats(&new, known, crossing.tolerance)) {
                Some(idx) => run = runs.get(idx),
                None => {
                    runs.push(new);
                    run = runs.last();
                }
            }
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
    Ok(())
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

/// Whether a run is another one again, between the same ends: where surfaces cross at a small angle,
/// places that are on both may be far from the curve. A neighbour of it would run the other way.
fn repeats(run: &Run, known: &Run, tolerance: f64) -> bool {
    let near = FAR_ASIDE * tolerance;
    let middle = run.samples[run.samples.len() / 2];
    let beside = known.samples.iter().min_by(|a, b| {
        let away = |sample: &Sample| sample.point.distance(middle.point);
        away(a).total_cmp(&away(b))
    });
    run.start().distance(known.start()) <= near
        && run.end().distance(known.end()) <= near
        && run.samples.iter().all(|sample| passes(known, sample.point, 0.25 * near))
        && beside.is_some_and(|sample| 0.0 < sample.behind.dot(middle.behind))
}

/// Whether a run passes through a point.
fn passes(run: &Run, point: DVec3, tolerance: f64) -> bool {
    run.samples.windows(2).any(|pair| {
        let chord = pair[1].point - pair[0].point;
        let along = (point - pair[0].point).dot(chord) / chord.length_squared();
        let reach = pair[0].point.distance(point).min(pair[1].point.distance(point));
        reach <= chord.length()
            && Cubic::between(pair[0], pair[1], length_between(pair[0], pair[1]))
                .misses_near(point, along.clamp(0.0, 1.0))
                <= 4.0 * tolerance
    })
}
