//! Edges that faces share, and the vertices in which they end.
//!
//! The arcs around faces need not match one to one: each is cut where others end on it, and parts between the same
//! vertices that run along one another are one edge. An edge is gone along twice, once in each sense, as seams are
//! by one face.

use std::{collections::BTreeMap, sync::Arc};

use glam::DVec3;

use super::{Solid, SolidError, box_around};
use crate::{
    Bounds, FaceEdge, GeomError, Interval, NurbsCurve, ParameterArc, Tolerance,
    disjoint_sets::DisjointSets, mesh::welded, sorting::sort_by, tolerance::PARAMETER_RELATIVE,
};

/// Edges and vertices of a solid, and how its faces go along them.
///
/// ```
/// use virote_kernel::{Frame, NurbsCurve, Region, Solid, Tolerance, glam::DVec3};
///
/// let [o, x, y] = [DVec3::ZERO, DVec3::X, DVec3::Y];
/// let triangle = Region::new(&NurbsCurve::polyline(&[o, x, y, o])?, &[], Tolerance::DEFAULT)?;
/// let prism = Solid::extruded(&triangle, DVec3::Z, Tolerance::DEFAULT)?;
/// let found = prism.topology(Tolerance::DEFAULT)?;
/// assert_eq!((found.vertices.len(), found.edges.len(), found.genus()), (6, 9, 0));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct SolidTopology {
    /// Where edges end.
    pub vertices: Vec<DVec3>,
    /// Each once.
    pub edges: Vec<SolidEdge>,
    /// For each face the loops of each of its parts. Edges that are points are left out.
    pub loops: Vec<Vec<Vec<Vec<SolidStep>>>>,
    n_shells: usize,
    /// How far ends of edges that are one vertex are apart at most.
    pub(super) welded: f64,
}

/// An edge that two faces have in common, or a seam of one.
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{Face, Frame, NurbsSurface, Solid, Tolerance};
///
/// let sphere = Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, 1.0)?), Tolerance::DEFAULT)?;
/// let ball = Solid::new(&[sphere], Tolerance::DEFAULT)?.topology(Tolerance::DEFAULT)?;
/// assert!(ball.edges.len() == 1 && ball.edges[0].is_seam());
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct SolidEdge {
    /// From its first vertex to its second.
    pub curve: NurbsCurve,
    /// The vertices where it starts and ends.
    pub vertices: [usize; 2],
    /// The face that goes along it, and the one that goes back.
    pub faces: [usize; 2],
}

/// An edge that a face goes along.
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{Face, Frame, NurbsSurface, Solid, Tolerance};
///
/// let sphere = Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, 1.0)?), Tolerance::DEFAULT)?;
/// let ball = Solid::new(&[sphere], Tolerance::DEFAULT)?.topology(Tolerance::DEFAULT)?;
/// let steps = &ball.loops[0][0][0];
/// // Along the seam and back.
/// assert!(steps.len() == 2 && steps[0].edge == steps[1].edge);
/// assert!(steps[0].is_along != steps[1].is_along && steps[0].parameters.is_straight());
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct SolidStep {
    /// The number of the edge.
    pub edge: usize,
    /// Whether it goes along the edge, or back.
    pub is_along: bool,
    /// The way of the face, by the parameters of its surface.
    pub parameters: ParameterArc,
}

impl SolidEdge {
    /// Whether it has one face on both sides.
    #[must_use]
    pub fn is_seam(&self) -> bool {
        self.faces[0] == self.faces[1]
    }
}

impl SolidTopology {
    /// How many handles it has, all shells together: V − E + F = 2 (shells − genus), where parts of faces count, less
    /// their holes.
    #[must_use]
    pub fn genus(&self) -> i64 {
        let euler_of = |loops: &Vec<Vec<SolidStep>>| 2 - loops.len() as i64;
        let faces: i64 = self.loops.iter().flatten().map(euler_of).sum();
        let euler = self.vertices.len() as i64 - self.edges.len() as i64 + faces;
        self.n_shells as i64 - euler / 2
    }

    /// Where the solid touches itself: a vertex about which faces do not follow one another in one ring, or both ends
    /// of an edge beside which another one is, no further than a reach, if these are such vertices.
    pub(super) fn pinch(&self, reach: f64) -> Option<Vec<DVec3>> {
        let pinched = self.pinched_vertices();
        let first = pinched.iter().position(|&is_pinched| is_pinched)?;
        let is_beside = |edge: &SolidEdge, other: &SolidEdge| {
            sense_along(&edge.curve, edge.vertices, (&other.curve, other.vertices), reach).is_some()
                && other.vertices.iter().all(|end| edge.vertices.contains(end))
        };
        let is_pinched = |edge: &&SolidEdge| edge.vertices.iter().all(|&end| pinched[end]);
        let edges: Vec<&SolidEdge> = self.edges.iter().filter(is_pinched).collect();
        let doubled = edges
            .iter()
            .enumerate()
            .find(|&(i, edge)| edges[i + 1..].iter().any(|other| is_beside(edge, other)));
        Some(match doubled {
            Some((_, edge)) => edge.vertices.map(|end| self.vertices[end]).to_vec(),
            None => vec![self.vertices[first]],
        })
    }

    /// Whether about each vertex faces do not follow one another in one ring.
    fn pinched_vertices(&self) -> Vec<bool> {
        // The ends of each edge, 2·e and 2·e + 1, that corners of faces have in common.
        let mut rings = DisjointSets::new(2 * self.edges.len());
        for steps in self.loops.iter().flatten().flatten() {
            for (k, step) in steps.iter().enumerate() {
                let next = &steps[(k + 1) % steps.len()];
                let (ends, starts) = (step.is_along, !next.is_along);
                rings.unite(2 * step.edge + usize::from(ends), 2 * next.edge + usize::from(starts));
            }
        }
        let mut ring_of: Vec<Option<usize>> = vec![None; self.vertices.len()];
        let mut is_pinched = vec![false; self.vertices.len()];
        for (number, edge) in self.edges.iter().enumerate() {
            for (end, &vertex) in edge.vertices.iter().enumerate() {
                let ring = rings.least(2 * number + end);
                is_pinched[vertex] |= *ring_of[vertex].get_or_insert(ring) != ring;
            }
        }
        is_pinched
    }
}

/// An arc of a face in space, between the vertices where it is cut.
struct CutArc {
    curve: NurbsCurve,
    /// The same by the parameters of the surface.
    parameters: ParameterArc,
    /// Parameters and vertices, its ends among them.
    stops: Vec<(f64, usize)>,
}

impl CutArc {
    /// Its part between two parameters in the plane of those of the surface, which runs as the curve does.
    fn part_of_parameters(&self, ends: [f64; 2]) -> ParameterArc {
        let (own, domain) = (self.parameters.curve.domain(), self.curve.domain());
        let range = ends.map(|t| own.at((t - domain.start()) / domain.length()));
        ParameterArc { curve: Arc::clone(&self.parameters.curve), range }
    }

    /// How far its stops are from their vertices at most.
    fn farthest_from(&self, vertices: &[DVec3]) -> f64 {
        let gaps =
            self.stops.iter().map(|&(t, vertex)| self.curve.point_at(t).distance(vertices[vertex]));
        gaps.fold(0.0, f64::max)
    }
}

/// Edges while their second sides are looked for.
struct EdgeTable {
    edges: Vec<(NurbsCurve, [usize; 2], [Option<usize>; 2])>,
    by_ends: BTreeMap<[usize; 2], Vec<usize>>,
    /// Within which distance edges are one.
    reach: f64,
}

impl Solid {
    /// Its edges and vertices.
    ///
    /// # Errors
    /// [`SolidError::UnmatchedEdge`] of an edge that is not gone along twice; those of [`crate::Face::edges`].
    pub fn topology(&self, tolerance: Tolerance) -> Result<SolidTopology, GeomError> {
        let reach = 2.0 * tolerance.distance_for(box_around(&self.faces).diagonal());
        let mut curves = Vec::new();
        let mut loops = Vec::with_capacity(self.faces.len());
        for face in &self.faces {
            let mut parts = Vec::new();
            for borders in face.part_edges(tolerance)? {
                let mut arcs = Vec::new();
                for border in borders {
                    let first = curves.len();
                    let in_space = |edge: FaceEdge| Some((edge.curve?, edge.parameters));
                    curves.extend(border.into_iter().filter_map(in_space));
                    if first < curves.len() {
                        arcs.push(first..curves.len());
                    }
                }
                parts.push(arcs);
            }
            loops.push(parts);
        }
        let (vertices, arcs) = cut_arcs(curves, reach)?;
        let welded = arcs.iter().map(|arc| arc.farthest_from(&vertices)).fold(0.0, f64::max);
        let mut table = EdgeTable { edges: Vec::new(), by_ends: BTreeMap::new(), reach };
        let mut found = Vec::with_capacity(loops.len());
        for (face, parts) in loops.into_iter().enumerate() {
            let mut of_face = Vec::with_capacity(parts.len());
            for borders in parts {
                let mut of_part = Vec::with_capacity(borders.len());
                for border in borders {
                    let mut steps = Vec::new();
                    for arc in &arcs[border] {
                        table.take(arc, face, &mut steps)?;
                    }
                    of_part.push(steps);
                }
                of_face.push(of_part);
            }
            found.push(of_face);
        }
        let edges = table.finished()?;
        let n_shells = self.shells.len();
        Ok(SolidTopology { vertices, edges, loops: found, n_shells, welded })
    }
}

/// Curves, with the same by parameters, with the places where others end on them, and these places.
fn cut_arcs(
    curves: Vec<(NurbsCurve, NurbsCurve)>,
    reach: f64,
) -> Result<(Vec<DVec3>, Vec<CutArc>), GeomError> {
    let ends = curves.iter().flat_map(|(curve, _)| [curve.start(), curve.end()]);
    let ends: Vec<DVec3> = ends.collect();
    let first = welded(&ends, reach);
    let mut numbers: Vec<usize> = vec![0; ends.len()];
    let mut vertices = Vec::new();
    for (i, &end) in ends.iter().enumerate() {
        numbers[i] = if first[i] as usize == i {
            vertices.push(end);
            vertices.len() - 1
        } else {
            numbers[first[i] as usize]
        };
    }
    let mut arcs = Vec::with_capacity(curves.len());
    for (i, (curve, parameters)) in curves.into_iter().enumerate() {
        GeomError::go_on(1)?;
        let (domain, [from, to]) = (curve.domain(), [numbers[2 * i], numbers[2 * i + 1]]);
        let least = PARAMETER_RELATIVE * domain.length();
        let Bounds { min, max } = curve.bounds();
        // Beside a knot a piece would begin or end with a span of rounding width.
        let breaks = curve.knots().breaks();
        let on_knot = |t: f64| breaks.iter().copied().find(|knot| (knot - t).abs() <= least);
        let mut stops = vec![(domain.start(), from), (domain.end(), to)];
        for (vertex, &point) in vertices.iter().enumerate() {
            let is_near = (min - reach).cmple(point).all() && point.cmple(max + reach).all();
            if vertex == from || vertex == to || !is_near {
                continue;
            }
            let foot = curve.closest(point, reach);
            let is_inside =
                domain.start() + least < foot.parameter && foot.parameter < domain.end() - least;
            if foot.distance <= reach && is_inside {
                stops.push((on_knot(foot.parameter).unwrap_or(foot.parameter), vertex));
            }
        }
        sort_by(&mut stops, |a, b| a.0.total_cmp(&b.0));
        arcs.push(CutArc { curve, parameters: ParameterArc::whole(parameters), stops });
    }
    Ok((vertices, arcs))
}

impl EdgeTable {
    /// Goes along an arc of a face: each of its pieces is an edge that is known, or a new one.
    fn take(
        &mut self,
        arc: &CutArc,
        face: usize,
        steps: &mut Vec<SolidStep>,
    ) -> Result<(), GeomError> {
        for pair in arc.stops.windows(2) {
            GeomError::go_on(1)?;
            let ends = [pair[0].1, pair[1].1];
            // What the tolerance leaves of an edge whose ends are one vertex is that.
            if ends[0] == ends[1] && self.is_place(&arc.curve, [pair[0].0, pair[1].0]) {
                continue;
            }
            let piece = match arc.stops.len() {
                2 => arc.curve.clone(),
                _ => arc.curve.trimmed(Interval::new(pair[0].0, pair[1].0)?)?,
            };
            let parameters = arc.part_of_parameters([pair[0].0, pair[1].0]);
            let (edge, is_along) = self.step(piece, ends, face);
            steps.push(SolidStep { edge, is_along, parameters });
        }
        Ok(())
    }

    /// Whether a piece of a curve is no longer than the distance within which things are one.
    fn is_place(&self, curve: &NurbsCurve, [from, to]: [f64; 2]) -> bool {
        let [start, end] = [from, to].map(|t| curve.point_at(t));
        let within = |share: f64| {
            let point = curve.point_at(from + (to - from) * share);
            point.distance(start).max(point.distance(end)) <= self.reach
        };
        start.distance(end) <= self.reach && [0.5, 0.21, 0.83].into_iter().all(within)
    }

    fn step(&mut self, piece: NurbsCurve, ends: [usize; 2], face: usize) -> (usize, bool) {
        let key = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        let known = self.by_ends.entry(key).or_default();
        for &number in known.iter() {
            let (curve, own, faces) = &mut self.edges[number];
            let Some(is_along) = sense_along(&piece, ends, (&*curve, *own), self.reach) else {
                continue;
            };
            let side = &mut faces[usize::from(!is_along)];
            if side.is_some() {
                continue;
            }
            *side = Some(face);
            if is_simpler(&piece, curve) {
                *curve = if is_along { piece } else { piece.reversed() };
            }
            return (number, is_along);
        }
        known.push(self.edges.len());
        self.edges.push((piece, ends, [Some(face), None]));
        (self.edges.len() - 1, true)
    }

    /// # Errors
    /// [`SolidError::UnmatchedEdge`].
    fn finished(self) -> Result<Vec<SolidEdge>, GeomError> {
        let edge = |(curve, vertices, faces): (NurbsCurve, [usize; 2], [Option<usize>; 2])| {
            let [Some(along), Some(back)] = faces else {
                let point = curve.point_at(curve.domain().at(0.5));
                return Err(SolidError::UnmatchedEdge { point }.into());
            };
            Ok::<_, GeomError>(SolidEdge { curve, vertices, faces: [along, back] })
        };
        self.edges.into_iter().map(edge).collect()
    }
}

/// Whether a piece runs along an edge with the same ends, true, or back; none where it lies elsewhere.
fn sense_along(
    piece: &NurbsCurve,
    ends: [usize; 2],
    (edge, own): (&NurbsCurve, [usize; 2]),
    reach: f64,
) -> Option<bool> {
    let mut places = [0.0; 3];
    for (place, fraction) in places.iter_mut().zip([0.5, 0.25, 0.75]) {
        let foot = edge.closest(piece.point_at(piece.domain().at(fraction)), reach);
        if reach < foot.distance {
            return None;
        }
        *place = foot.parameter;
    }
    Some(if ends[0] == ends[1] { places[1] < places[2] } else { ends == own })
}

/// Whether a curve is a line or an arc where another is none, or needs fewer points.
fn is_simpler(curve: &NurbsCurve, other: &NurbsCurve) -> bool {
    let cost = |curve: &NurbsCurve| (curve.analytic().is_none(), curve.control_points().len());
    cost(curve) < cost(other)
}
