//! Where two surfaces cross, and where a curve passes through a surface.
//!
//! `share` halves pairs of parts until their cones of normals tell that they cross in at most one
//! arc; so no loop is lost between samples. From a place on such an arc `trace` follows the curve as
//! far as it goes; arcs that lie on a curve that is known are told by it. Where normals are parallel,
//! `tangential_contact` tells what the surfaces share about that place.
//!
//! Sederberg & Meyers, *Loop detection in surface patch intersections*, CAGD 5 (1988); Barnhill &
//! Kersey, *A marching method for parametric surface/surface intersection*, CAGD 7 (1990).

use std::sync::Arc;

use glam::DVec3;

use super::{
    CommonScale, FITTING, LevelSet, PictureError,
    beside::{edge_that_reaches, with_edges_beside},
    branch_sample::BranchSample,
    chain, cubic,
    elsewhere::with_seams_elsewhere,
    pair::SurfacePart,
    sample::{BranchSamples, VanishingPlace},
    seam::EdgeOverlap,
    share::{SharedParts, found, halved},
    sphere,
    surface_pair::SurfacePair,
    trace::CurveEnds,
    verify::{self, CurveOrigin},
};
use crate::{
    Bounds, Direction, GeomError, NurbsCurve, NurbsSurface, Surface, Tolerance,
    ceiling::SURFACE_PAIRS,
    mesh::check_rounding,
    tolerance::{CONTACT_SHARE, ONE_PLACE_SHARE},
    work,
};

/// Part of the tolerance within which splines stand in for functions: less than what counts as a
/// contact.
const SPLINE_SHARE: f64 = 0.4 * CONTACT_SHARE;

/// Roundings up to which surfaces are one along a line on which they touch.
const CONTACT_ROUNDINGS: f64 = 8.0;

impl Surface {
    /// The curves in which the surface crosses another or touches it, within the tolerance's distance
    /// and complete; they run along N × N of the two. Functions are crossed as splines that near.
    ///
    /// An edge that both have in common is that edge. Where the surfaces only touch in a point, that is
    /// told among the touches, and so is a corner that lies on the other surface; an edge that lies on it without
    /// reaching it, both within the tolerance, is no curve and told among the contacts.
    ///
    /// # Errors
    /// [`PictureError::SurfacesRunTogether`] where they share more than curves; for functions as
    /// [`crate::ParametricSurface::to_nurbs`], and [`PictureError::EdgeLost`] of an edge that lies on the other surface
    /// and was not found.
    pub fn intersections(&self, other: &Self, tolerance: Tolerance) -> Result<LevelSet, GeomError> {
        let [a, b] = [self, other].map(|s| s.splined(SPLINE_SHARE * tolerance.distance));
        let (a, b) = (a?, b?);
        let found = splines_cross(Arc::clone(&a), Arc::clone(&b), tolerance)?;
        // An edge on the other surface may be just beside it where a spline stands in for that.
        if [self, other].iter().any(|surface| matches!(surface, Self::Parametric(_))) {
            let size = a.bounds().diagonal().min(b.bounds().diagonal());
            let distances = [tolerance.distance_for(size), CONTACT_SHARE * tolerance.distance];
            if let Some(point) = edge_that_reaches(&found, [&a, &b], distances) {
                return Err(PictureError::EdgeLost { point }.into());
            }
        }
        Ok(found)
    }
}

/// What two surfaces share that are no functions.
fn splines_cross(
    a: Arc<NurbsSurface>,
    b: Arc<NurbsSurface>,
    tolerance: Tolerance,
) -> Result<LevelSet, GeomError> {
    let magnitude = a.bounds().magnitude().max(b.bounds().magnitude());
    if let Some(scale) = CommonScale::needed(magnitude) {
        let [a, b] = [scale.surface(&Surface::Nurbs(a))?, scale.surface(&Surface::Nurbs(b))?];
        return scale.lines(a.intersections(&b, scale.tolerance(tolerance)));
    }
    let near = [a.near_zero(), b.near_zero()];
    if near.iter().any(Option::is_some) {
        let [near_a, near_b] = near.map(|near| near.map(Arc::new));
        let [a, b] = [near_a.unwrap_or(a), near_b.unwrap_or(b)];
        return splines_cross(a, b, tolerance);
    }
    let size = a.bounds().diagonal().min(b.bounds().diagonal());
    let tolerance = tolerance.distance_for(size);
    check_rounding(tolerance, magnitude)?;
    if a.keeps_from(&b, tolerance) || b.keeps_from(&a, tolerance) {
        return Ok(LevelSet::default());
    }
    let crossings =
        a.crossing_of_balls(&b, tolerance).or_else(|| a.coaxial_crossings(&b, tolerance));
    if let Some(curves) = crossings.or_else(|| a.inscribed_crossings(&b, tolerance)) {
        return Ok(LevelSet { curves, ..LevelSet::default() });
    }
    if let Some(found) = a.coaxial_touches(&b, tolerance) {
        return Ok(with_edges_beside(found, [&a, &b], tolerance));
    }
    let surfaces = [a, b];
    match searched(&surfaces, tolerance, size) {
        Err(GeomError::Picture(refused)) => {
            let [a, b] = &surfaces;
            match (refused, a.coaxial_circles(b, tolerance)) {
                (_, Some(curves)) => Ok(LevelSet { curves, ..LevelSet::default() }),
                (PictureError::TooTangled { point }, None) if a.is_coaxially_on(b, tolerance) => {
                    Err(PictureError::SurfacesRunTogether { point }.into())
                }
                (refused, None) => Err(refused.into()),
            }
        }
        found => {
            let [a, b] = &surfaces;
            let found = a.with_exact_contacts(b, found?, tolerance);
            Ok(with_edges_beside(found, [a, b], tolerance))
        }
    }
}

/// What parts of two surfaces tell that they share.
fn searched(
    surfaces: &[Arc<NurbsSurface>; 2],
    tolerance: f64,
    size: f64,
) -> Result<LevelSet, GeomError> {
    let elsewhere = with_seams_elsewhere(surfaces, CONTACT_SHARE * tolerance);
    // What both have along a seam of both is no edge of either, and perhaps none of both along a seam of one.
    let common = EdgeOverlap::all([&surfaces[0], &surfaces[1]], tolerance)?;
    let as_given = (!have_seam_in_common([&surfaces[0], &surfaces[1]], &common, tolerance))
        .then(|| Ok(surfaces.clone()));
    let has_inner =
        common.iter().any(|edge| edge.n_inside([&surfaces[0], &surfaces[1]], tolerance) == 1);
    let mut best: Option<Result<LevelSet, GeomError>> = None;
    let [a, b] = [&surfaces[0], &surfaces[1]];
    for surfaces in as_given.into_iter().chain(elsewhere) {
        let found = shared(surfaces?, tolerance, size);
        let is_seam_in_doubt = has_inner && matches!(found, Err(GeomError::Picture(_)));
        if !is_seam_in_doubt && verify::is_certain(&found, tolerance) {
            return found.map(|found| a.with_exact_curves(b, found, tolerance));
        }
        best = Some(match best {
            Some(best) => best.or_else(|refused| found.map_err(|_| refused)),
            None => found,
        });
    }
    let found = best.unwrap_or_else(|| shared(surfaces.clone(), tolerance, size));
    found.map(|found| a.with_exact_curves(b, found, tolerance))
}

impl NurbsSurface {
    /// What it shares with another surface, the curves as exact ones where both tell the plane in which they lie.
    fn with_exact_curves(&self, other: &Self, mut found: LevelSet, tolerance: f64) -> LevelSet {
        if found.curves.is_empty() {
            return found;
        }
        let (carrier, plane) = if let Some(plane) = self.flat_frame() {
            (other, plane)
        } else if let Some(plane) = other.flat_frame() {
            (self, plane)
        } else if let Some(plane) = self.radical_plane(other, tolerance) {
            (self, plane)
        } else {
            return found;
        };
        found.curves = carrier.exact_in_plane(found.curves, plane, tolerance);
        found
    }
}

impl NurbsSurface {
    /// What it shares with another surface, the lines along which they touch as exact circles where both turn about
    /// one axis.
    fn with_exact_contacts(&self, other: &Self, mut found: LevelSet, tolerance: f64) -> LevelSet {
        if found.contacts.is_empty() {
            return found;
        }
        let circles = self.coaxial_circles(other, tolerance);
        if let Some(circles) = circles.filter(|circles| circles.len() == found.curves.len()) {
            found.curves = circles;
        }
        found
    }
}

/// Whether surfaces that share no area about edges that they have in common have a seam among these.
fn have_seam_in_common(
    surfaces: [&NurbsSurface; 2],
    common: &[EdgeOverlap],
    tolerance: f64,
) -> bool {
    common.iter().all(|edge| edge.overlap(surfaces, tolerance).is_none())
        && common.iter().any(|edge| edge.n_inside(surfaces, tolerance) == 2)
}

/// What two surfaces share that are no functions. Where curves that end at creases are refused, as where they meet on
/// them, they go over these within the tolerance.
fn shared(
    surfaces: [Arc<NurbsSurface>; 2],
    tolerance: f64,
    size: f64,
) -> Result<LevelSet, GeomError> {
    let found = shared_by(surfaces.clone(), tolerance, size, true);
    let has_creases = || {
        let creases = |surface: &Arc<NurbsSurface>| {
            Direction::BOTH.iter().any(|&along| !surface.creases(along).is_empty())
        };
        surfaces.iter().any(creases)
    };
    match found {
        Err(GeomError::Picture(refused)) if has_creases() => {
            shared_by(surfaces, tolerance, size, false).map_err(|_| refused.into())
        }
        found => found,
    }
}

fn shared_by(
    surfaces: [Arc<NurbsSurface>; 2],
    tolerance: f64,
    size: f64,
    stops_at_creases: bool,
) -> Result<LevelSet, GeomError> {
    let [a, b] = sphere::with_poles_aside(surfaces, CONTACT_SHARE * tolerance, tolerance);
    let seams = EdgeOverlap::all([&a, &b], tolerance)?;
    if let Some(point) = seams.iter().find_map(|seam| seam.overlap([&a, &b], tolerance)) {
        return Err(PictureError::SurfacesRunTogether { point }.into());
    }
    let (mut crossing, found) = found([&a, &b], &seams, tolerance, size)?;
    if !stops_at_creases {
        crossing.creases = std::array::from_fn(|_| Vec::new());
    }
    let SharedParts { clear, mut ends, touches, lines, gaps, loops, .. } = found;
    let middle = |run: &BranchSamples| run.samples[run.samples.len() / 2].point;
    let is_on_seam =
        |point: &DVec3| seams.iter().any(|seam| seam.holds(*point, crossing.tolerance));
    // Where they reach through one another by more than rounding, they cross beside the line.
    let touches_only = |gap: f64| gap <= CONTACT_ROUNDINGS * crossing.rounding;
    let middles = lines.iter().map(middle).zip(gaps);
    let (contacts, uncertain): (Vec<_>, Vec<_>) = middles.partition(|&(_, gap)| touches_only(gap));
    let [mut contacts, mut uncertain] = [contacts, uncertain]
        .map(|told| told.into_iter().map(|(point, _)| point).collect::<Vec<DVec3>>());
    let mut runs = lines;
    runs.extend(loops);
    branches(&crossing, &ends, &mut runs);
    arcs(&crossing, clear, &ends, &mut runs)?;
    // Where the surfaces are that near all over, a loop is no more than a touch.
    let poles = |radius: f64| {
        let pole = move |&point| VanishingPlace { point, radius, is_exact: true };
        crossing.poles.iter().map(pole)
    };
    let around_poles = poles((crossing.contact * crossing.size).sqrt());
    let near: Vec<VanishingPlace> = ends.spots.iter().copied().chain(around_poles).collect();
    runs.retain(|run| !near.iter().any(|spot| run.is_within(spot)));
    runs.iter_mut().for_each(|run| {
        reach_seam(run, ends.spots.iter().filter(|spot| is_on_seam(&spot.point)));
    });
    // A border of both is told as the seam that it is.
    runs.retain(|run| !run.samples.iter().all(|sample| is_on_seam(&sample.point)));
    let met = |spot: &VanishingPlace| spot.is_met(&runs, crossing.tolerance);
    uncertain.extend(ends.spots.iter().filter(|spot| met(spot)).map(|spot| spot.point));
    // A spot in the middle of a curve is no touch in a point.
    ends.spots.retain(|spot| spot.n_ends(&runs) != 0 || !met(spot));
    ends.spots.extend(touches);
    let is_passed =
        |spot: &VanishingPlace| runs.iter().any(|run| run.passes(spot.point, crossing.tolerance));
    ends.spots.extend(
        poles(crossing.tolerance).filter(|spot| spot.n_ends(&runs) != 0 || !is_passed(spot)),
    );
    let chained = chain::chained(runs, &ends.spots, crossing.tolerance);
    let spline = |line: Vec<BranchSample>| cubic::spline(&line, FITTING * crossing.tolerance);
    let seams_once = EdgeOverlap::different(&seams, crossing.tolerance).into_iter();
    // A line about a tip may be as short as rounding: it is a place.
    let has_length = |line: &Vec<BranchSample>| line.iter().any(|s| s.point != line[0].point);
    let (lines, places): (Vec<_>, Vec<_>) = chained.lines.into_iter().partition(has_length);
    let lines = lines.into_iter().map(spline);
    let curves: Result<Vec<NurbsCurve>, GeomError> =
        seams_once.map(|seam| Ok(seam.directed([&a, &b]))).chain(lines).collect();
    let curves = verify::without_crumbs(curves?, tolerance);
    let places = places.into_iter().filter_map(|line| line.first().map(|sample| sample.point));
    let touches = chained.isolated.into_iter().chain(places);
    let touches = touches.filter(|point| !is_on_seam(point)).collect();
    contacts.retain(|point| !is_on_seam(point));
    uncertain.retain(|point| !is_on_seam(point));
    verify::verify(&curves, &CurveOrigin::Surfaces([&a, &b]), tolerance)?;
    Ok(LevelSet { curves, touches, contacts, uncertain })
}

/// Leads the ends of a curve that are in a spot to the spot's own place: on a border that both surfaces have, where
/// nothing else leads them there.
fn reach_seam<'s>(run: &mut BranchSamples, spots: impl Iterator<Item = &'s VanishingPlace>) {
    for spot in spots.filter(|spot| spot.is_exact) {
        let ends = [run.samples.first(), run.samples.last()].map(Option::<&BranchSample>::copied);
        for (end, sample) in ends.into_iter().enumerate() {
            let Some(sample) = sample else { continue };
            let away = sample.point.distance(spot.point);
            if 0.0 < away && away <= spot.radius {
                let place = if end == 0 { 0 } else { run.samples.len() };
                run.samples.insert(place, BranchSample { point: spot.point, ..sample });
            }
        }
    }
}

/// The curves out of all junctions.
fn branches(crossing: &SurfacePair<'_>, ends: &CurveEnds, runs: &mut Vec<BranchSamples>) {
    let near = ONE_PLACE_SHARE * crossing.tolerance;
    for way in ends.junctions.iter().flat_map(|junction| junction.ways) {
        let begins = |run: &BranchSamples| {
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
        if crossing.tolerance < run.length() && !run.is_on(runs, crossing.tolerance) {
            runs.push(run);
        }
    }
}

/// Adds the curves through all pairs that are not known.
///
/// Of a pair there is at most one arc. A curve that runs along a side of its parts leaves them and comes back all along it;
/// one that is known and runs beside both is that arc, since their normals turn by so little up to there that both would
/// be one. So is one further beside both where the parts up to there cross in at most one arc, too.
fn arcs(
    crossing: &SurfacePair<'_>,
    pairs: Vec<[Arc<SurfacePart>; 2]>,
    ends: &CurveEnds,
    runs: &mut Vec<BranchSamples>,
) -> Result<(), GeomError> {
    // Where normals are nearly parallel parts of a tolerance are a long way.
    let near = crossing.rounding;
    let mut todo = pairs;
    let (mut n_pairs, mut n_kept) = (0, 0);
    while work::goes_on(1)
        && let Some(pair) = todo.pop()
    {
        let [a, b] = &pair;
        n_pairs += 1;
        if SURFACE_PAIRS < n_pairs {
            return Err(PictureError::TooTangled { point: a.bounds.center() }.into());
        }
        let boxes = [a.bounds, b.bounds];
        let size = boxes.map(Bounds::diagonal).into_iter().fold(0.0, f64::max);
        let place = crossing.common_near(&pair);
        let Some(place) = place.and_then(|place| crossing.inside(place, &pair)) else {
            let is_known = place.is_some_and(|place| {
                let boxes = match crossing.is_beside(&place, &pair) {
                    true => Some(boxes),
                    false => crossing.reach(&place, &pair),
                };
                let mut known = runs.iter();
                boxes.is_some_and(|boxes| {
                    known.any(|run| {
                        run.passes(place.point, crossing.tolerance) && !run.ends_within(boxes, near)
                    })
                })
            });
            if crossing.tolerance < size && !is_known {
                todo.extend(halved(pair, near, &mut n_kept));
            }
            continue;
        };
        if crossing.is_collapsed(place.point) {
            // From there no curve can be followed.
            if crossing.tolerance < size {
                todo.extend(halved(pair, near, &mut n_kept));
            }
            continue;
        }
        let mut run = runs.iter().find(|run| run.passes(place.point, crossing.tolerance));
        if run.is_none() {
            let new = crossing.run(place, ends);
            match runs.iter().position(|known| new.repeats(known, &ends.spots, crossing.tolerance))
            {
                Some(idx) => run = runs.get(idx),
                None => {
                    runs.push(new);
                    run = runs.last();
                }
            }
        }
        // Behind the end of a run another may begin.
        let ends_here = run.is_some_and(|run| run.ends_within(boxes, near));
        if ends_here && crossing.tolerance < size {
            todo.extend(halved(pair, near, &mut n_kept));
        }
    }
    Ok(())
}
