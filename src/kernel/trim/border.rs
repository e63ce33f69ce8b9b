//! The border of a face in space.

use std::sync::{Arc, OnceLock};

use glam::DVec3;

use super::{
    Face,
    lift::{is_point, joined_spline, spline, spline_near},
};
use crate::{
    Curve, FitError, GeomError, IntegralError, NurbsCurve, Region, Side, Tolerance,
    curve::join_chain,
    find_integral,
    frame::{angle_between, norm},
    tolerance::{EDGE_SHARE, QUADRATURE_RELATIVE, RIM_RELATIVE},
};

/// Last bits of where a surface lies that splines around areas are given at least.
const RIM_BITS: f64 = 64.0;

/// The border of a face at a tolerance, once it was asked for. It is known by what it is of: all of them are equal,
/// and what is copied to become another face has none.
#[derive(Debug, Default)]
pub(super) struct KnownBorder(OnceLock<(u64, Arc<[BorderArc]>)>);

impl Clone for KnownBorder {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl PartialEq for KnownBorder {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

/// An arc of the border: in the plane of parameters, in space, and where it stands.
#[derive(Clone, Debug)]
pub(super) struct BorderArc {
    pub(super) in_plane: NurbsCurve,
    pub(super) curve: Curve,
    /// Which loop of which part it belongs to.
    at: [usize; 2],
}

/// An arc of a loop of a face, by the parameters of its surface and in space.
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{Face, Frame, NurbsSurface, Tolerance};
///
/// // A sphere has a seam, which is gone along twice, and two poles, which are points.
/// let sphere = Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, 1.0)?), Tolerance::DEFAULT)?;
/// let parts = sphere.part_edges(Tolerance::DEFAULT)?;
/// let is_point: Vec<bool> = parts[0][0].iter().map(|edge| edge.curve.is_none()).collect();
/// assert_eq!(is_point.iter().filter(|&&is_point| is_point).count(), 2);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct FaceEdge {
    /// In the plane z = 0 of u and v.
    pub parameters: NurbsCurve,
    /// In space; none where it is a point.
    pub curve: Option<NurbsCurve>,
}

impl Face {
    /// The arcs of each loop of each part of the parameters, seams and edges that are points among them, in space
    /// as [`Self::edges`] are.
    ///
    /// # Errors
    /// Those of [`Self::edges`].
    pub fn part_edges(&self, tolerance: Tolerance) -> Result<Vec<Vec<Vec<FaceEdge>>>, GeomError> {
        let distance = self.distance(tolerance);
        let edge = |arc: &NurbsCurve| -> Result<FaceEdge, GeomError> {
            let parameters = self.plane.to_parameters(arc);
            let parts = self.lifted_parts(&parameters, distance)?;
            let mut is_short = true;
            for (part, curve) in &parts {
                is_short = is_short && is_point(curve, part, distance)?;
            }
            let curve = if is_short { None } else { Some(joined_spline(&parts, distance)?) };
            Ok(FaceEdge { parameters, curve })
        };
        let of_loop = |arcs: &[NurbsCurve]| arcs.iter().map(edge).collect();
        let of_part = |part: &Region| part.arcs().map(of_loop).collect();
        self.parts.iter().map(of_part).collect()
    }

    /// The border in space, from corner to corner; a closed curve where a loop has none.
    ///
    /// The face is to the left, seen from the tip of Su × Sv. Seams over which the face goes, and edges that
    /// are a point, are no border. Along lines of constant parameters the curves are exact, as they are on a plane
    /// patch; others are splines within an eighth of the tolerance.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use virote_kernel::{Cutter, Face, Frame, NurbsSurface, Tolerance, glam::DVec3};
    ///
    /// let sphere = Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, 1.0)?), Tolerance::DEFAULT)?;
    /// assert!(sphere.edges(Tolerance::DEFAULT)?.is_empty());
    /// let cut = Cutter::Plane(Frame::XY.at(DVec3::Z * 0.5));
    /// let cap = sphere.part_at(&[cut], DVec3::Z, Tolerance::DEFAULT)?;
    /// let rims = cap.edges(Tolerance::DEFAULT)?;
    /// assert_eq!(rims.len(), 1);
    /// assert!(rims[0].is_closed(1e-9));
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// `FitError::NoSplineNear`, `GeomError::Ended`; those of [`crate::join`].
    pub fn edges(&self, tolerance: Tolerance) -> Result<Vec<NurbsCurve>, GeomError> {
        self.edges_near(EDGE_SHARE * self.distance(tolerance), tolerance)
    }

    /// The same edges, splines as near as areas of what they bound in a plane ask for, where that can be.
    ///
    /// # Errors
    /// Those of [`Self::edges`].
    pub(crate) fn edges_around_areas(
        &self,
        tolerance: Tolerance,
    ) -> Result<Vec<NurbsCurve>, GeomError> {
        let size = self.plane.surface.bounds().diagonal();
        let deviation = (RIM_RELATIVE * size).max(RIM_BITS * self.plane.last_bit());
        let most = EDGE_SHARE * self.distance(tolerance);
        match self.edges_near(deviation.min(most), tolerance) {
            Err(GeomError::Fit(FitError::NoSplineNear { .. })) => self.edges(tolerance),
            found => found,
        }
    }

    fn edges_near(
        &self,
        deviation: f64,
        tolerance: Tolerance,
    ) -> Result<Vec<NurbsCurve>, GeomError> {
        let distance = self.distance(tolerance);
        let mut edges = Vec::new();
        for ring in self.rings(distance)? {
            edges.extend(between_corners(&ring, [distance, deviation], tolerance.angle)?);
        }
        Ok(edges)
    }

    /// Each loop of the border as one closed curve in space.
    ///
    /// # Errors
    /// Those of [`Self::edges`].
    pub fn loops(&self, tolerance: Tolerance) -> Result<Vec<NurbsCurve>, GeomError> {
        let distance = self.distance(tolerance);
        let joined = |ring: &Vec<Curve>| joined(ring, [distance, EDGE_SHARE * distance]);
        self.rings(distance)?.iter().map(joined).collect()
    }

    /// The length of its border.
    ///
    /// # Errors
    /// Those of [`Self::edges`].
    pub fn border_length(&self, tolerance: Tolerance) -> Result<f64, GeomError> {
        let arcs = self.border_arcs(self.distance(tolerance))?;
        let length = |arc: &BorderArc| match &arc.curve {
            Curve::Nurbs(curve) => Ok(curve.length(curve.domain())),
            Curve::Parametric(function) => {
                let speed = |t: f64| Ok(vec![norm(function.derivatives_at(t, 1)?[1])]);
                let ends = [function.domain().start(), function.domain().end()];
                match find_integral(speed, ends, QUADRATURE_RELATIVE, 0.0) {
                    Ok(found) => Ok(found.value[0]),
                    Err(IntegralError::Function(err)) => Err(err),
                    Err(IntegralError::Unsettled { .. }) => arc.curve.length(function.domain()),
                }
            }
        };
        arcs.iter().map(length).sum()
    }

    /// Whether a place of the surface is on the border, of which seams that the face goes over are none.
    ///
    /// # Errors
    /// Those of a search that was ended.
    pub(crate) fn is_on_border(
        &self,
        parameters: [f64; 2],
        tolerance: Tolerance,
    ) -> Result<bool, GeomError> {
        let distance = self.distance(tolerance);
        let place = self.plane.place(parameters);
        // What was found of a curve within the tolerance is away from it by that, and so is the border.
        let reach = 2.0 * distance;
        let point = self.plane.point(place);
        let is_near = |arc: &BorderArc| {
            let is_beside = arc.in_plane.bounds().distance(place) <= reach
                && arc.in_plane.foot_within(place, reach).is_some();
            // At a pole and at the other side of a seam arcs end, whose parameters are far away.
            let ends = [arc.curve.start(), arc.curve.end()];
            is_beside || ends.iter().any(|end| end.distance(point) <= reach)
        };
        Ok(self.border_arcs(distance)?.iter().any(is_near))
    }

    /// The point of the border that is nearest to a point; none without one.
    pub(super) fn closest_on_border(
        &self,
        point: DVec3,
        distance: f64,
    ) -> Result<Option<DVec3>, GeomError> {
        let mut best: Option<(f64, DVec3)> = None;
        for arc in self.border_arcs(distance)?.iter() {
            let foot = match arc.curve.closest(point, distance) {
                Ok(foot) => foot,
                Err(_) => Curve::from(spline(&arc.curve, distance)?).closest(point, distance)?,
            };
            if best.is_none_or(|(least, _)| foot.distance < least) {
                best = Some((foot.distance, foot.point));
            }
        }
        Ok(best.map(|(_, point)| point))
    }

    /// The arcs of the border, chained to closed rings.
    fn rings(&self, distance: f64) -> Result<Vec<Vec<Curve>>, GeomError> {
        let mut left: Vec<Option<BorderArc>> =
            self.border_arcs(distance)?.iter().cloned().map(Some).collect();
        let mut rings = Vec::new();
        while let Some(first) = left.iter_mut().find_map(Option::take) {
            let (start, mut end, mut at) = (first.curve.start(), first.curve.end(), first.at);
            let mut ring = vec![first.curve];
            loop {
                // Of several that begin there the one of the same loop goes on.
                let gap = |arc: &BorderArc| (arc.at != at, arc.curve.start().distance(end));
                let next = left
                    .iter()
                    .enumerate()
                    .filter_map(|(i, arc)| Some((i, gap(arc.as_ref()?))))
                    .filter(|&(_, (_, gap))| gap <= 2.0 * distance)
                    .min_by(|(_, a), (_, b)| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
                let is_back = start.distance(end) <= 2.0 * distance;
                let Some((i, (is_other, _))) = next.filter(|_| !is_back || 1 < ring.len()) else {
                    break;
                };
                if is_back && is_other {
                    break;
                }
                let Some(arc) = left[i].take() else { break };
                (end, at) = (arc.curve.end(), arc.at);
                ring.push(arc.curve);
            }
            rings.push(ring);
        }
        Ok(rings)
    }

    /// The arcs of all loops but seams that the face goes over and edges that are points.
    pub(super) fn border_arcs(&self, distance: f64) -> Result<Arc<[BorderArc]>, GeomError> {
        match self.border.0.get() {
            Some((known, arcs)) if *known == distance.to_bits() => Ok(Arc::clone(arcs)),
            _ => {
                let arcs: Arc<[BorderArc]> = self.arcs_outside_seams(distance)?.into();
                // Of two that come at once either is as good; of another tolerance it is not kept.
                let _ = self.border.0.set((distance.to_bits(), Arc::clone(&arcs)));
                Ok(arcs)
            }
        }
    }

    fn arcs_outside_seams(&self, distance: f64) -> Result<Vec<BorderArc>, GeomError> {
        let mut found = Vec::new();
        for (i, part) in self.parts.iter().enumerate() {
            for (k, arcs) in part.arcs().enumerate() {
                for arc in arcs {
                    for piece in self.outside_seams(arc, distance)? {
                        let parts =
                            self.lifted_parts(&self.plane.to_parameters(&piece), distance)?;
                        for (part, curve) in parts {
                            if !is_point(&curve, &part, distance)? {
                                let in_plane = self.plane.to_plane(&part);
                                found.push(BorderArc { in_plane, curve, at: [i, k] });
                            }
                        }
                    }
                }
            }
        }
        Ok(found)
    }

    /// The parts of an arc in the plane of parameters that are no seam with the face on both sides.
    fn outside_seams(&self, arc: &NurbsCurve, distance: f64) -> Result<Vec<NurbsCurve>, GeomError> {
        let bounds = self.plane.bounds();
        let domain = arc.domain();
        let places = [0.0, 0.5, 1.0].map(|at| arc.point_at(domain.at(at)));
        let is_along =
            |i: usize, end: f64| places.iter().all(|place| (place[i] - end).abs() <= distance);
        let across = (0..2).find(|&i| {
            self.plane.is_closed[i] && (is_along(i, bounds.min[i]) || is_along(i, bounds.max[i]))
        });
        let Some(across) = across else { return Ok(vec![arc.clone()]) };
        let along = 1 - across;
        // What changes beside it changes where other arcs end at the seam.
        let ends = self.parts.iter().flat_map(|part| part.arcs().flatten());
        let mut cuts: Vec<f64> = ends.map(|other| other.start()[along]).collect();
        cuts.sort_by(f64::total_cmp);
        let [from, to] = [places[0][along], places[2][along]];
        let fraction = |cut: f64| (cut - from) / (to - from);
        let slack = distance / (to - from).abs();
        let mut fractions = vec![0.0];
        let inner = cuts.into_iter().map(fraction).filter(|&f| slack < f && f < 1.0 - slack);
        fractions.extend(inner);
        fractions.push(1.0);
        fractions.sort_by(f64::total_cmp);
        fractions.dedup_by(|a, b| *a - *b <= slack);
        let mut pieces = Vec::new();
        for pair in fractions.windows(2) {
            let middle =
                self.plane.parameters(places[0].lerp(places[2], 0.5 * (pair[0] + pair[1])));
            if self.is_on_inner_seam(middle, distance) {
                continue;
            }
            let ends = [pair[0], pair[1]].map(|at| places[0].lerp(places[2], at));
            pieces.push(match (pair[0] <= 0.0, 1.0 <= pair[1]) {
                (true, true) => arc.clone(),
                _ => NurbsCurve::line(ends[0], ends[1])?,
            });
        }
        Ok(pieces)
    }
}

/// The curves of a ring, joined between its corners.
fn between_corners(
    ring: &[Curve],
    distances: [f64; 2],
    angle: f64,
) -> Result<Vec<NurbsCurve>, GeomError> {
    let n = ring.len();
    let mut corners = Vec::new();
    for i in 0..n {
        let (before, behind) = (&ring[(i + n - 1) % n], &ring[i]);
        let tangent = |curve: &Curve, t: f64, side: Side| Ok(curve.local_at(t, side)?.tangent());
        let ends: Result<[DVec3; 2], GeomError> =
            tangent(before, before.domain().end(), Side::Left)
                .and_then(|one| Ok([one, tangent(behind, behind.domain().start(), Side::Right)?]));
        // Without a tangent there is a corner.
        let is_smooth = ends.is_ok_and(|[one, other]| angle_between(one, other) <= angle);
        if !is_smooth {
            corners.push(i);
        }
    }
    let Some(&first) = corners.first() else { return Ok(vec![joined(ring, distances)?]) };
    let mut edges = Vec::with_capacity(corners.len());
    for (k, &corner) in corners.iter().enumerate() {
        let next = corners.get(k + 1).map_or(first + n, |&next| next);
        let chain: Vec<Curve> = (corner..next).map(|i| ring[i % n].clone()).collect();
        edges.push(joined(&chain, distances)?);
    }
    Ok(edges)
}

/// Curves that follow one another within a distance as one spline that is no further away than another.
fn joined(chain: &[Curve], [distance, deviation]: [f64; 2]) -> Result<NurbsCurve, GeomError> {
    let splines = chain.iter().map(|curve| spline_near(curve, deviation));
    let splines: Vec<NurbsCurve> = splines.collect::<Result<_, _>>()?;
    join_chain(&splines, 4.0 * distance)
}
