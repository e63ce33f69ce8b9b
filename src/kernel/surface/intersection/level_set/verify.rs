//! What was found is looked at before it is told: whether each curve lies on the surfaces, stands once,
//! and ends only where a curve of these surfaces can end.
//!
//! A curve in which surfaces cross ends at a border of one of them or where it meets others; so every end
//! elsewhere tells that a part is missing. Half-branches of an analytic set come in pairs at each of its
//! points (Sullivan, *Combinatorial invariants of analytic spaces*, 1971), so that an odd number of ends
//! tells the same wherever surfaces are round. Only at a tip a line may end by itself, along which what
//! touches the tip's cone does so.

use glam::DVec3;

use super::{LevelSet, PictureError};
use crate::{
    Bounds, Direction, Frame, GeomError, Interval, NurbsCurve, NurbsSurface,
    tolerance::NORMAL_AGREEMENT,
};

/// Where within each span a curve is looked at: not in its middle, where a cubic may be on by symmetry.
const SHARES: [f64; 3] = [0.15, 0.4, 0.75];

/// Places along a curve that are looked at, and how many of them elsewhere too make a stretch.
const N_PLACES: usize = 9;
const LEAST_SHARED: usize = 3;

/// Ends this many tolerances apart are one: where many meet each has its own error.
const ONE_END: f64 = 4.0;

/// Curves of fewer tolerances have no stretches.
const SHORTEST: f64 = 200.0;

/// Tolerances below which a curve that is not closed may be a piece of a longer one.
const CRUMB: f64 = 64.0;

/// What curves are told of.
pub(super) enum CurveOrigin<'m> {
    /// Two surfaces.
    Surfaces([&'m NurbsSurface; 2]),
    /// A surface and a plane, with places where curves may end too: flat parts are told by their borders,
    /// where others end.
    Section { surface: &'m NurbsSurface, plane: Frame, touches: &'m [DVec3] },
}

impl CurveOrigin<'_> {
    fn surfaces(&self) -> &[&NurbsSurface] {
        match self {
            Self::Surfaces(surfaces) => surfaces,
            Self::Section { surface, .. } => std::slice::from_ref(surface),
        }
    }

    /// How far a point is from the plane of a section.
    fn height_over_plane(&self, point: DVec3) -> f64 {
        match self {
            Self::Surfaces(_) => 0.0,
            Self::Section { plane, .. } => (point - plane.origin()).dot(plane.z()).abs(),
        }
    }

    /// Whether that many ends in a place tell of no part that is missing.
    fn allows(&self, n_ends: usize, end: DVec3, near: f64) -> bool {
        match self {
            Self::Surfaces(_) => n_ends.is_multiple_of(2),
            Self::Section { touches, .. } => {
                1 < n_ends || touches.iter().any(|touch| touch.distance(end) <= near)
            }
        }
    }

    /// Whether both only touch along the curve.
    fn touches_along(&self, curve: &NurbsCurve) -> bool {
        let point = curve.point_at(curve.domain().at(0.5));
        let normal = |surface: &NurbsSurface| {
            let [u, v] = surface.closest(point).parameters;
            surface.normal_at(u, v).ok()
        };
        let normals = match self {
            Self::Surfaces([a, b]) => normal(a).zip(normal(b)),
            Self::Section { surface, plane, .. } => normal(surface).map(|a| (a, plane.z())),
        };
        normals.is_some_and(|(a, b)| a.cross(b).length() <= NORMAL_AGREEMENT)
    }
}

/// Whether curves may be told: what cannot be may hang on where seams are, and so do crumbs of a curve
/// beside one.
pub(super) fn is_certain(found: &Result<LevelSet, GeomError>, tolerance: f64) -> bool {
    match found {
        Ok(set) => !set.curves.iter().any(|curve| is_crumb(curve, tolerance)),
        Err(GeomError::Picture(refused)) => !matches!(
            refused,
            PictureError::OffSurface { .. }
                | PictureError::ToldTwice { .. }
                | PictureError::EndsInside { .. }
                | PictureError::SmallLoop { .. }
        ),
        Err(_) => true,
    }
}

/// The curves without crumbs that lie on another one of them.
pub(super) fn without_crumbs(curves: Vec<NurbsCurve>, tolerance: f64) -> Vec<NurbsCurve> {
    let lies_on = |crumb: &NurbsCurve, other: &NurbsCurve| {
        let around = other.bounds();
        crumb.domain().steps(N_PLACES).into_iter().all(|t| {
            let point = crumb.point_at(t);
            let is_near = || other.foot_within(point, tolerance).is_some();
            around.contains(point, tolerance) && is_near()
        })
    };
    let is_kept: Vec<bool> = curves
        .iter()
        .map(|curve| {
            let longer = |other: &&NurbsCurve| !is_crumb(other, tolerance);
            !is_crumb(curve, tolerance)
                || !curves.iter().filter(longer).any(|other| lies_on(curve, other))
        })
        .collect();
    curves
        .into_iter()
        .zip(is_kept)
        .filter(|(_, is_kept)| *is_kept)
        .map(|(curve, _)| curve)
        .collect()
}

fn is_crumb(curve: &NurbsCurve, tolerance: f64) -> bool {
    curve.start() != curve.end() && curve.bounds().diagonal() <= CRUMB * tolerance
}

/// Whether curves are on both that meet, each once, and complete.
///
/// # Errors
/// [`PictureError::OffSurface`], [`PictureError::ToldTwice`], [`PictureError::EndsInside`] with the place.
pub(super) fn verify(
    curves: &[NurbsCurve],
    meeting: &CurveOrigin<'_>,
    tolerance: f64,
) -> Result<(), GeomError> {
    for curve in curves {
        is_on(curve, meeting, tolerance)?;
    }
    for (i, curve) in curves.iter().enumerate() {
        let others = curves.iter().enumerate().filter(|&(k, _)| k != i).map(|(_, other)| other);
        stands_once(curve, others, tolerance)?;
    }
    ends_are_ends(curves, meeting, tolerance)
}

/// A surface with the parameters under the last of some points, where the next is looked for first.
pub(in crate::surface) struct ClosestPointTracker<'s> {
    surface: &'s NurbsSurface,
    parameters: Option<[f64; 2]>,
}

impl<'s> ClosestPointTracker<'s> {
    pub(in crate::surface) fn new(surface: &'s NurbsSurface) -> Self {
        Self { surface, parameters: None }
    }

    /// How far a point is from the surface, at most; beyond the tolerance, how far it is.
    pub(in crate::surface) fn distance(&mut self, point: DVec3, tolerance: f64) -> f64 {
        let beside = self.parameters.map(|start| self.surface.place_near(start, point, tolerance));
        let foot = match beside {
            Some(foot) if foot.distance <= tolerance => foot,
            _ => self.surface.closest(point),
        };
        self.parameters = Some(foot.parameters);
        foot.distance
    }
}

/// Fails where the curve is further than the tolerance from what meets.
fn is_on(curve: &NurbsCurve, meeting: &CurveOrigin<'_>, tolerance: f64) -> Result<(), GeomError> {
    let trackers = meeting.surfaces().iter().map(|surface| ClosestPointTracker::new(surface));
    let mut surfaces: Vec<ClosestPointTracker<'_>> = trackers.collect();
    let knots = curve.knots().distinct();
    for pair in knots.windows(2) {
        for share in SHARES {
            let point = curve.point_at(pair[0].0 + (pair[1].0 - pair[0].0) * share);
            let from_surfaces = surfaces.iter_mut().map(|under| under.distance(point, tolerance));
            // What is no number is off too.
            let distance = from_surfaces.fold(meeting.height_over_plane(point), |far, near| {
                if far.is_nan() || near <= far { far } else { near }
            });
            let is_near = distance <= tolerance;
            if !is_near {
                return Err(PictureError::OffSurface { point, distance }.into());
            }
        }
    }
    Ok(())
}

/// Fails where a stretch of the curve is one of another, or one of its own further on.
fn stands_once<'c>(
    curve: &NurbsCurve,
    others: impl Iterator<Item = &'c NurbsCurve>,
    tolerance: f64,
) -> Result<(), GeomError> {
    let bounds = curve.bounds();
    if bounds.diagonal() <= SHORTEST * tolerance {
        return Ok(());
    }
    let ends = curve.domain().steps(N_PLACES + 1);
    let places: Vec<DVec3> = ends[1..=N_PLACES].iter().map(|&t| curve.point_at(t)).collect();
    let is_of = |other: &NurbsCurve, around: Bounds, point: DVec3| {
        around.contains(point, tolerance) && other.foot_within(point, tolerance).is_some()
    };
    let told_twice = |mut shared: Vec<DVec3>| match shared.len() {
        LEAST_SHARED.. => Err(PictureError::ToldTwice { point: shared.swap_remove(0) }.into()),
        _ => Ok(()),
    };
    for other in others {
        let around = other.bounds();
        told_twice(places.iter().copied().filter(|&point| is_of(other, around, point)).collect())?;
    }
    let mut again = [false; N_PLACES];
    for (i, pair) in ends.windows(2).enumerate() {
        let piece = curve.trimmed(Interval::new(pair[0], pair[1])?)?;
        let around = piece.bounds();
        // The places with these numbers are its own ends.
        for k in (0..N_PLACES).filter(|&k| k + 1 != i && k != i) {
            again[k] = again[k] || is_of(&piece, around, places[k]);
        }
    }
    told_twice((0..N_PLACES).filter(|&k| again[k]).map(|k| places[k]).collect())
}

/// Fails where a curve ends inside all surfaces, and what ends there too leaves one over.
fn ends_are_ends(
    curves: &[NurbsCurve],
    meeting: &CurveOrigin<'_>,
    tolerance: f64,
) -> Result<(), GeomError> {
    let near = ONE_END * tolerance;
    let ends: Vec<(DVec3, &NurbsCurve)> =
        curves.iter().flat_map(|curve| [(curve.start(), curve), (curve.end(), curve)]).collect();
    let mut borders: Option<Vec<NurbsCurve>> = None;
    for &(end, curve) in &ends {
        let n_ends = ends.iter().filter(|(other, _)| other.distance(end) <= near).count();
        if meeting.allows(n_ends, end, near) {
            continue;
        }
        let borders = borders.get_or_insert_with(|| {
            meeting.surfaces().iter().flat_map(|surface| borders_of(surface, tolerance)).collect()
        });
        let is_at_border = borders.iter().any(|border| {
            border.bounds().contains(end, near) && border.foot_within(end, near).is_some()
        });
        let is_at_tip = || meeting.surfaces().iter().any(|surface| is_tip(surface, end, tolerance));
        if !(is_at_border || is_at_tip() && meeting.touches_along(curve)) {
            return Err(PictureError::EndsInside { point: end }.into());
        }
    }
    Ok(())
}

/// Whether a point is an edge of the surface that has no one tangent plane.
fn is_tip(surface: &NurbsSurface, point: DVec3, tolerance: f64) -> bool {
    let near = ONE_END * tolerance;
    let (u, v) = (surface.domain_u(), surface.domain_v());
    let sides = [
        (u.start(), Direction::U),
        (u.end(), Direction::U),
        (v.start(), Direction::V),
        (v.end(), Direction::V),
    ];
    surface.edges().iter().zip(sides).any(|(edge, (end, across))| {
        let is_here = edge.bounds().diagonal() <= tolerance && edge.start().distance(point) <= near;
        let normals = edge.domain().steps(N_PLACES).into_iter().map(|t| {
            let [u, v] = across.pair(end, t);
            surface.normal_at(u, v).unwrap_or(DVec3::ZERO)
        });
        let normals: Vec<DVec3> = if is_here { normals.collect() } else { Vec::new() };
        normals.iter().any(|normal| NORMAL_AGREEMENT < normal.distance(normals[0]))
    })
}

/// The edges at which a surface ends: no seams, and none that is a point.
fn borders_of(surface: &NurbsSurface, tolerance: f64) -> Vec<NurbsCurve> {
    let [u0, u1, v0, v1] = surface.edges();
    let mut borders = Vec::new();
    if !surface.is_closed_u(tolerance) {
        borders.extend([u0, u1]);
    }
    if !surface.is_closed_v(tolerance) {
        borders.extend([v0, v1]);
    }
    // Where it jumps it ends on both sides.
    for along in Direction::BOTH {
        let (knots, domain) = (surface.knots(along), surface.domain(along));
        let jumps = knots
            .distinct()
            .into_iter()
            .filter(|&(t, times)| domain.start() < t && t < domain.end() && knots.degree() < times);
        for [before, behind] in jumps.filter_map(|(t, _)| surface.split(along, t).ok()) {
            let ([u0, _, v0, _], [_, u1, _, v1]) = (behind.edges(), before.edges());
            borders.extend(match along {
                Direction::U => [u0, u1],
                Direction::V => [v0, v1],
            });
        }
    }
    borders.retain(|edge| tolerance < edge.bounds().diagonal());
    borders
}

#[cfg(test)]
mod tests {
    use super::{CRUMB, CurveOrigin, PictureError, verify, without_crumbs};
    use crate::{GeomError, Interval, NurbsCurve, NurbsSurface, glam::DVec3};

    const TOLERANCE: f64 = 1e-6;

    /// What is said of some curves in which two squares that cross along the x axis would cross.
    fn verdict(curves: &[NurbsCurve]) -> Result<(), GeomError> {
        let square = |up: DVec3| {
            let corner = |x: f64, side: f64| DVec3::X * x + up * side;
            NurbsSurface::bilinear(
                corner(0.0, -1.0),
                corner(0.0, 1.0),
                corner(1.0, -1.0),
                corner(1.0, 1.0),
            )
            .expect("a square")
        };
        let surfaces = [square(DVec3::Y), square(DVec3::Z)];
        verify(curves, &CurveOrigin::Surfaces(surfaces.each_ref()), TOLERANCE)
    }

    fn axis(from: f64, to: f64) -> NurbsCurve {
        NurbsCurve::line(DVec3::X * from, DVec3::X * to).expect("a segment")
    }

    #[test]
    fn the_line_in_which_squares_cross_may_be_told() {
        assert_eq!(verdict(&[axis(0.0, 1.0)]), Ok(()));
        assert_eq!(verdict(&[axis(0.0, 0.5), axis(0.5, 1.0)]), Ok(()));
        assert_eq!(verdict(&[]), Ok(()));
    }

    #[test]
    fn a_curve_that_leaves_a_surface_is_refused_with_its_place() {
        let off = DVec3::new(0.0, 0.0, 0.01);
        let bent =
            NurbsCurve::bezier(&[DVec3::ZERO, DVec3::X * 0.5 + off, DVec3::X]).expect("a curve");
        let found = verdict(&[axis(0.0, 1.0), bent]);
        let Err(GeomError::Picture(PictureError::OffSurface { point, distance })) = found else {
            unreachable!("{found:?}")
        };
        assert!((point.z - distance).abs() <= 1e-12 && 1e-3 < distance, "{point} {distance}");
    }

    #[test]
    fn a_curve_that_stands_twice_is_refused() {
        let is_told_twice = |curves: &[NurbsCurve]| {
            matches!(verdict(curves), Err(GeomError::Picture(PictureError::ToldTwice { .. })))
        };
        assert!(is_told_twice(&[axis(0.0, 1.0), axis(0.0, 1.0)]));
        assert!(is_told_twice(&[axis(0.0, 1.0), axis(0.3, 1.0)]));
        // Once there and back again.
        let back = NurbsCurve::polyline(&[DVec3::ZERO, DVec3::X, DVec3::X * 0.2]).expect("a line");
        assert!(is_told_twice(&[back]));
    }

    #[test]
    fn a_curve_of_which_a_part_is_missing_is_refused_where_it_ends() {
        let whole = axis(0.0, 1.0);
        let half = whole.trimmed(Interval::new(0.0, 0.5).expect("an interval")).expect("a part");
        let found = verdict(&[half]);
        let Err(GeomError::Picture(PictureError::EndsInside { point })) = found else {
            unreachable!("{found:?}")
        };
        assert!(point.distance(DVec3::X * 0.5) <= 1e-12, "{point}");
    }

    #[test]
    fn crumbs_on_longer_curves_are_left_out() {
        let line = |from: DVec3, to: DVec3| NurbsCurve::polyline(&[from, to]).expect("a line");
        let crumb = |at: DVec3| line(at, at + 0.5 * CRUMB * TOLERANCE * DVec3::X);
        let long = line(DVec3::ZERO, 10.0 * DVec3::X);
        let (on, beside) = (crumb(5.0 * DVec3::X), crumb(DVec3::new(5.0, 1.0, 0.0)));
        let starts = |curves: Vec<NurbsCurve>| -> Vec<DVec3> {
            without_crumbs(curves, TOLERANCE).iter().map(NurbsCurve::start).collect()
        };
        let kept = starts(vec![on.clone(), long.clone(), beside.clone()]);
        assert_eq!(kept, [long.start(), beside.start()]);
        // Two crumbs on one another may be one small curve.
        assert_eq!(starts(vec![on.clone(), on.clone()]), [on.start(), on.start()]);
        assert_eq!(starts(vec![long.clone(), long.clone()]), [long.start(), long.start()]);
    }
}
