//! Edges of faces, and what is on the other side of them.

use std::collections::{BTreeMap, btree_map::Entry};

use glam::DVec3;

use super::{Face, FaceError};
use crate::{Bounds, Frame, GeomError, NurbsCurve, Tolerance, box_tree::BoxTree, frame::norm};

/// Places of each edge where its neighbour is looked for.
pub(super) const N_PLACES: usize = 24;

/// At which fractions of a part of an edge its neighbour is looked for: at the first unless several are there.
const WITHIN_PART: [f64; 4] = [0.5, 0.1, 0.9, 0.3];

/// Places that are told of an edge that lies in a plane.
const ALONG_PLANE: [f64; 5] = [0.0, 0.21, 0.5, 0.83, 1.0];

/// The least cosine of the angle between edges that run along one another, and do not just end at one corner.
const RUN_BESIDE: f64 = 0.9;

/// An edge of one of several faces.
pub(crate) struct FaceBorderEdge {
    pub(super) face: usize,
    pub(super) curve: NurbsCurve,
    bounds: Bounds,
    /// Which of the edges of its face it is; none of a part of one.
    number: Option<usize>,
}

/// The faces on both sides of a place of an edge.
pub(super) struct FacePair {
    pub(super) faces: [usize; 2],
    /// Whether one of both must turn to look as the other does.
    pub(super) must_turn: bool,
}

/// Another edge beside a place of one.
#[derive(Clone, Copy)]
struct PlaceBeside {
    other: usize,
    /// How far it is.
    gap: f64,
    /// Its way there.
    way: DVec3,
    /// The place, and the way of the edge that has it.
    point: DVec3,
    along: DVec3,
}

/// What is beside a part of an edge.
enum PartBeside {
    One(PlaceBeside),
    /// At this place of it.
    Nothing(DVec3),
    /// At the first place that was looked at, and at the one where most room is.
    Crowd {
        first: Vec<PlaceBeside>,
        widest: Vec<PlaceBeside>,
    },
}

/// The edges of several faces, among which those beside a place are looked for.
pub(super) struct NeighbourSearch<'e> {
    edges: &'e [FaceBorderEdge],
    boxes: BoxTree,
    /// Within which distance edges are one.
    distance: f64,
}

impl FaceBorderEdge {
    /// Those of faces, which are numbered from `first` on.
    ///
    /// # Errors
    /// Those of [`Face::edges`].
    pub(crate) fn all(
        faces: &[Face],
        first: usize,
        tolerance: Tolerance,
    ) -> Result<Vec<Self>, GeomError> {
        let mut edges = Vec::new();
        for (face, own) in (first..).zip(faces) {
            let own = own.edges(tolerance)?.into_iter().enumerate();
            edges.extend(own.map(|(number, curve)| {
                let number = Some(number);
                Self { number, ..Self::new(face, curve) }
            }));
        }
        Ok(edges)
    }

    /// The same as near as areas within them ask for, in parts that end where others do.
    ///
    /// # Errors
    /// Those of [`Face::edges`] and of [`Self::divided`].
    pub(crate) fn parts_around_areas(
        faces: &[Face],
        distance: f64,
        tolerance: Tolerance,
    ) -> Result<Vec<Self>, GeomError> {
        let mut edges = Vec::new();
        for (face, own) in faces.iter().enumerate() {
            let own = own.edges_around_areas(tolerance)?.into_iter();
            edges.extend(own.map(|curve| Self::new(face, curve)));
        }
        Self::divided(&edges, distance)
    }

    /// The curves of some edges of faces as near as areas within them ask for.
    ///
    /// # Errors
    /// Those of [`Face::edges`].
    pub(crate) fn curves_around_areas(
        edges: &[Self],
        wanted: &[usize],
        faces: &[Face],
        tolerance: Tolerance,
    ) -> Result<Vec<NurbsCurve>, GeomError> {
        let mut of_faces: BTreeMap<usize, Vec<NurbsCurve>> = BTreeMap::new();
        let mut curves = Vec::with_capacity(wanted.len());
        for edge in wanted.iter().map(|&i| &edges[i]) {
            let own = match of_faces.entry(edge.face) {
                Entry::Occupied(known) => known.into_mut(),
                Entry::Vacant(new) => new.insert(faces[edge.face].edges_around_areas(tolerance)?),
            };
            let curve = edge.number.and_then(|number| own.get(number));
            curves.push(curve.unwrap_or(&edge.curve).clone());
        }
        Ok(curves)
    }

    /// An edge of the face of a number, with that to its left.
    pub(super) fn new(face: usize, curve: NurbsCurve) -> Self {
        let bounds = curve.bounds();
        Self { face, curve, bounds, number: None }
    }

    /// The same edges in parts that end where others do.
    ///
    /// # Errors
    /// Those of [`NurbsCurve::split`]; `GeomError::Ended`.
    fn divided(edges: &[Self], distance: f64) -> Result<Vec<Self>, GeomError> {
        let reach = 2.0 * distance;
        let ends: Vec<DVec3> =
            edges.iter().flat_map(|edge| [edge.curve.start(), edge.curve.end()]).collect();
        let mut parts = Vec::with_capacity(edges.len());
        for edge in edges {
            GeomError::go_on(1 + ends.len())?;
            let own = [edge.curve.start(), edge.curve.end()];
            let near = ends.iter().filter(|&&end| edge.bounds.distance(end) <= reach);
            let apart = near.filter(|&&end| own.iter().all(|place| reach < place.distance(end)));
            let feet = apart.map(|&end| edge.curve.closest(end, distance));
            let mut cuts: Vec<f64> =
                feet.filter(|foot| foot.distance <= reach).map(|foot| foot.parameter).collect();
            cuts.sort_by(f64::total_cmp);
            let point = |t: f64| edge.curve.point_at(t);
            cuts.dedup_by(|next, known| point(*next).distance(point(*known)) <= reach);
            let mut rest = edge.curve.clone();
            for cut in cuts {
                let [part, behind] = rest.split(cut)?;
                parts.push(Self::new(edge.face, part));
                rest = behind;
            }
            parts.push(Self::new(edge.face, rest));
        }
        Ok(parts)
    }

    /// How far a point is from it, if no further than a distance, and its way at the place that is nearest.
    fn nearest(&self, point: DVec3, distance: f64) -> Option<(f64, DVec3)> {
        if self.curve.degree() == 1 && self.curve.control_points().len() == 2 {
            let (start, way) = (self.curve.start(), self.curve.end() - self.curve.start());
            let share = ((point - start).dot(way) / way.length_squared()).clamp(0.0, 1.0);
            let gap = norm(start + way * share - point);
            return (gap <= distance).then_some((gap, way));
        }
        let (parameter, gap) = self.curve.foot_within(point, distance)?;
        Some((gap, self.curve.derivatives_at(parameter, 1)[1]))
    }

    /// Whether a point of it is beside an end of it from which another edge leads the other way: of short edges such an
    /// end is near though nothing runs beside them.
    fn is_left_at_corner(&self, other: &Self, point: DVec3, reach: f64) -> bool {
        let mut corners = self.ways_from_ends().into_iter();
        let corner = corners.find(|(corner, _)| norm(point - *corner) <= 2.0 * reach);
        corner.is_some_and(|(corner, ahead)| {
            let ends = other.ways_from_ends().into_iter();
            let mut ways = ends.filter(|(end, _)| norm(*end - corner) <= reach).peekable();
            ways.peek().is_some() && ways.all(|(_, way)| way.dot(ahead) < 0.0)
        })
    }

    /// Its ends, each with a way from there into it.
    fn ways_from_ends(&self) -> [(DVec3, DVec3); 2] {
        let [start, end] = [0.0, 1.0].map(|at| self.place(at));
        [start, (end.0, -end.1)]
    }

    /// Where it comes to a plane; of one that lies in it some places.
    pub(crate) fn places_in(&self, plane: Frame, tolerance: Tolerance) -> Vec<DVec3> {
        let height = |point: DVec3| (point - plane.origin()).dot(plane.z());
        let (lowest, highest) = self
            .bounds
            .corners()
            .into_iter()
            .map(height)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), h| (a.min(h), b.max(h)));
        if highest < -tolerance.distance || tolerance.distance < lowest {
            return Vec::new();
        }
        let points = self.curve.points();
        if points.iter().all(|&point| height(point).abs() <= tolerance.distance) {
            let domain = self.curve.domain();
            return ALONG_PLANE.map(|at| self.curve.point_at(domain.at(at))).to_vec();
        }
        let parameters = self.curve.plane_parameters(plane, tolerance).into_iter();
        let ends = [self.curve.start(), self.curve.end()].into_iter();
        let ends = ends.filter(|&end| height(end).abs() <= tolerance.distance);
        ends.chain(parameters.map(|t| self.curve.point_at(t))).collect()
    }

    /// The point at a fraction of it, and its way there.
    fn place(&self, fraction: f64) -> (DVec3, DVec3) {
        let derivatives = self.curve.derivatives_at(self.curve.domain().at(fraction), 1);
        (derivatives[0], derivatives[1])
    }
}

impl<'e> NeighbourSearch<'e> {
    pub(super) fn new(edges: &'e [FaceBorderEdge], distance: f64) -> Self {
        let boxes = BoxTree::new(edges.iter().map(|edge| edge.bounds).collect());
        Self { edges, boxes, distance }
    }

    /// For each of [`N_PLACES`] parts of an edge its face and that on the other side; else a place where there is none.
    ///
    /// Where edges run into a common place along one tangent several are beside it, and of others of the same part
    /// one is asked. Where all of a part beside an end is that near, the neighbour of the next part goes on.
    ///
    /// # Errors
    /// [`FaceError::CrowdedShell`], [`FaceError::NearEdges`] where several are beside it.
    pub(super) fn neighbours(&self, own: usize) -> Result<Vec<Result<FacePair, DVec3>>, GeomError> {
        let mut parts = Vec::with_capacity(N_PLACES);
        for part in 0..N_PLACES {
            GeomError::go_on(1)?;
            parts.push(self.beside_part(own, part));
        }
        let crowd_from = |end: &mut dyn Iterator<Item = &PartBeside>| {
            end.take_while(|part| matches!(part, PartBeside::Crowd { .. })).count()
        };
        let first = crowd_from(&mut parts.iter());
        let last = N_PLACES - crowd_from(&mut parts.iter().rev());
        let mut found = Vec::with_capacity(N_PLACES);
        for (number, part) in parts.iter().enumerate() {
            let next = match number {
                _ if number < first => parts.get(first),
                _ if last <= number => last.checked_sub(1).and_then(|next| parts.get(next)),
                _ => None,
            };
            let (end, innermost) = if number < first { (0, first - 1) } else { (1, last) };
            found.push(match (part, next) {
                (PartBeside::One(place), _) => Ok(self.pair(own, place)),
                (PartBeside::Nothing(point), _) => Err(*point),
                (PartBeside::Crowd { first, widest }, Some(PartBeside::One(known))) => {
                    let other = Some(known.other);
                    let goes_on = self.comes_together(own, end, &parts[innermost], other);
                    let place = widest.iter().find(|place| place.other == known.other);
                    match place.filter(|_| goes_on) {
                        Some(place) => Ok(self.pair(own, place)),
                        None => return Err(self.crowd(own, first)),
                    }
                }
                (PartBeside::Crowd { widest, .. }, Some(PartBeside::Nothing(point)))
                    if self.comes_together(own, end, &parts[innermost], None) =>
                {
                    Err(widest.first().map_or(*point, |place| place.point))
                }
                (PartBeside::Crowd { first, .. }, _) => return Err(self.crowd(own, first)),
            });
        }
        Ok(found)
    }

    fn pair(&self, own: usize, place: &PlaceBeside) -> FacePair {
        let faces = [self.edges[own].face, self.edges[place.other].face];
        FacePair { faces, must_turn: 0.0 < place.along.dot(place.way) }
    }

    /// Whether all that is beside a part of an edge ends where that does at this end, and all but its neighbour leave it.
    fn comes_together(
        &self,
        own: usize,
        end: usize,
        innermost: &PartBeside,
        neighbour: Option<usize>,
    ) -> bool {
        let PartBeside::Crowd { widest, .. } = innermost else { return false };
        let reach = 2.0 * self.distance;
        let ends = |edge: usize| [self.edges[edge].curve.start(), self.edges[edge].curve.end()];
        let corner = ends(own)[end];
        widest.iter().all(|place| {
            let ends_there = ends(place.other).iter().any(|it| it.distance(corner) <= reach);
            ends_there && (Some(place.other) == neighbour || self.distance < place.gap)
        })
    }

    /// What is beside a part of an edge: of its places the first counts that is not crowded, else the one where most
    /// room is.
    fn beside_part(&self, own: usize, part: usize) -> PartBeside {
        let mut crowds: Vec<Vec<PlaceBeside>> = Vec::new();
        for within in WITHIN_PART {
            let place = self.edges[own].place((part as f64 + within) / N_PLACES as f64);
            let mut there = self.beside_place(own, place);
            match there.len() {
                0 => return PartBeside::Nothing(place.0),
                1 => return PartBeside::One(there.remove(0)),
                _ => {}
            }
            crowds.push(there);
        }
        let room = |there: &[PlaceBeside]| there.iter().map(|it| it.gap).fold(0.0, f64::max);
        let widest = crowds.iter().max_by(|a, b| room(a).total_cmp(&room(b)));
        PartBeside::Crowd {
            widest: widest.cloned().unwrap_or_default(),
            first: crowds.into_iter().next().unwrap_or_default(),
        }
    }

    /// The other edges beside a place of an edge, given with its way there.
    fn beside_place(&self, own: usize, (point, along): (DVec3, DVec3)) -> Vec<PlaceBeside> {
        let (edges, reach) = (self.edges, 2.0 * self.distance);
        let mut there = Vec::new();
        for other in self.boxes.beside(point, reach).into_iter().filter(|&i| i != own) {
            if let Some((gap, way)) = edges[other].nearest(point, reach)
                && !edges[own].is_left_at_corner(&edges[other], point, reach)
            {
                there.push(PlaceBeside { other, gap, way, point, along });
            }
        }
        // Near a corner the edges that end there are as near as the neighbour.
        if 1 < there.len() {
            let runs_beside =
                |way: DVec3| RUN_BESIDE * norm(way) * norm(along) <= along.dot(way).abs();
            let n_beside = there.iter().filter(|place| runs_beside(place.way)).count();
            if n_beside == 1 {
                there.retain(|place| runs_beside(place.way));
            }
        }
        there
    }

    /// That several others are at a place of an edge: in one place, or further apart than the tolerance.
    fn crowd(&self, own: usize, crowd: &[PlaceBeside]) -> GeomError {
        let (edges, face) = (self.edges, self.edges[own].face);
        match crowd.iter().max_by(|a, b| a.gap.total_cmp(&b.gap)) {
            Some(&PlaceBeside { other, gap, point, .. }) if self.distance < gap => {
                let faces = [face, edges[other].face];
                FaceError::NearEdges { faces, gap, tolerance: self.distance, point }.into()
            }
            _ => {
                let others = crowd.iter().map(|place| edges[place.other].face).collect();
                let point = crowd.first().map_or(DVec3::ZERO, |place| place.point);
                FaceError::CrowdedShell { face, others, point }.into()
            }
        }
    }

    /// That there is none at a point of an edge.
    pub(super) fn no_neighbour(&self, own: usize, point: DVec3) -> GeomError {
        let mut gap = f64::INFINITY;
        for (_, other) in self.edges.iter().enumerate().filter(|&(i, _)| i != own) {
            let apart = (other.bounds.min - point).max(point - other.bounds.max).max_element();
            if apart <= gap {
                gap = gap.min(other.curve.closest(point, self.distance).distance);
            }
        }
        let n_faces = 1 + self.edges.iter().map(|edge| edge.face).max().unwrap_or(0);
        FaceError::OpenShell { face: self.edges[own].face, n_faces, gap, point }.into()
    }
}
