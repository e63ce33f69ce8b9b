//! Whether the faces of a shell go through one another, or lie on one another.
//!
//! A mesh no further than its chord from the faces tells where to look: of a shell that goes through itself by more
//! than two chords it goes through itself too. Whether the faces do so is then asked of them: Newton's method goes from
//! two places of the mesh that meet to those of the faces, and two places of the skin that are one in space are no two
//! where the skin between them stays there.

use glam::{DMat3, DVec2, DVec3};

use super::{Solid, SolidError, box_around};
use crate::{
    Face, GeomError, Interval, Mesh, TessellationOptions, Tolerance,
    ceiling::{CROSSING_STEPS, CROSSING_VERTICES},
    mesh::{CommonWeights, TriangleMeeting, welded},
    numeric::newton::{NewtonStep, within_limits},
    tolerance::{CROSSING_CHORD_RELATIVE, LAST_BIT, MEETING_SHARE},
    trim::joined_meshes,
};

/// How many times nearer the second mesh is that is asked where the first one leaves it open.
const NEARER: f64 = 16.0;

/// Where on the way between two places of a face it is looked at whether it stays there.
const ON_THE_WAY: [f64; 3] = [0.5, 0.21, 0.83];

/// Distances apart within which a way stays where it is.
const STAYS: f64 = 4.0;

/// What a mesh tells of a shell.
enum ShellCrossing {
    /// The faces go through one another there.
    Certain(DVec3),
    /// They lie on one another there.
    Overlaid(DVec3),
    /// The mesh goes through itself there, by more than it may be away.
    Likely(DVec3),
}

/// The mesh of a shell, and which part of it is which face's.
struct ShellMesh<'s> {
    faces: &'s [&'s Face],
    mesh: Mesh,
    /// Behind the last triangle, and the last vertex, of each face.
    ends: Vec<[usize; 2]>,
    chord: f64,
    /// Within which distance places are one.
    distance: f64,
    tolerance: Tolerance,
}

/// A place of a face.
#[derive(Clone, Copy)]
struct FacePlace {
    face: usize,
    at: [f64; 2],
}

impl Solid {
    /// The same, unless a shell goes through itself or lies on itself.
    ///
    /// What does so by less than two chords of the mesh, which are a thousandth of the size, is not seen; neither is
    /// anything of a shell with too large a mesh, which [`Self::may_cross`] tells.
    ///
    /// # Errors
    /// [`SolidError::CrossesItself`], [`SolidError::Overlaid`]; `GeomError::Ended`.
    pub(super) fn uncrossed(mut self, tolerance: Tolerance) -> Result<Self, GeomError> {
        let size = box_around(&self.faces).diagonal();
        let (chord, distance) = (CROSSING_CHORD_RELATIVE * size, tolerance.distance_for(size));
        let mut may_cross = false;
        for faces in self.shells() {
            let look = |chord: f64| {
                ShellMesh::of(&faces, [chord, distance], tolerance)
                    .and_then(|mesh| mesh.map_or(Ok(None), |mesh| mesh.crossing()))
            };
            let likely = match look(chord) {
                Err(GeomError::Ended) => return Err(GeomError::Ended),
                Err(_) => {
                    may_cross = true;
                    continue;
                }
                Ok(None) => continue,
                Ok(Some(ShellCrossing::Likely(point))) => point,
                Ok(Some(found)) => return Err(found.error()),
            };
            match look(chord / NEARER) {
                Err(GeomError::Ended) => return Err(GeomError::Ended),
                Ok(None) => {}
                Ok(Some(found)) => return Err(found.error()),
                Err(_) => return Err(ShellCrossing::Likely(likely).error()),
            }
        }
        self.may_cross = may_cross;
        Ok(self)
    }
}

impl ShellCrossing {
    fn error(&self) -> GeomError {
        match *self {
            Self::Certain(point) | Self::Likely(point) => {
                SolidError::CrossesItself { point }.into()
            }
            Self::Overlaid(point) => SolidError::Overlaid { point }.into(),
        }
    }
}

impl<'s> ShellMesh<'s> {
    /// None where faces have no triangles.
    ///
    /// # Errors
    /// Those of [`Face::mesh`].
    fn of(
        faces: &'s [&'s Face],
        [chord, distance]: [f64; 2],
        tolerance: Tolerance,
    ) -> Result<Option<Self>, GeomError> {
        let options = TessellationOptions { weld: distance, ..TessellationOptions::within(chord) };
        let made = joined_meshes(&[], faces, &options, CROSSING_VERTICES)?.faces;
        let mesh = Mesh::merged(&made, CROSSING_VERTICES)?;
        let mut end = [0; 2];
        let ends = made.iter().map(|own| {
            end = [end[0] + own.n_triangles(), end[1] + own.n_vertices()];
            end
        });
        let ends = ends.collect();
        let has_parameters = mesh.uvs().len() == mesh.n_vertices() && 0 < mesh.n_triangles();
        Ok(has_parameters.then_some(Self { faces, mesh, ends, chord, distance, tolerance }))
    }

    /// # Errors
    /// `GeomError::Ended`.
    fn crossing(&self) -> Result<Option<ShellCrossing>, GeomError> {
        let mut likely = self.mesh.crowded_edge();
        let look = |triangles: [u32; 2], meeting: TriangleMeeting| match meeting {
            TriangleMeeting::Crossing { place, depth } => {
                let places = self.places(triangles, place);
                let found = self.common(places).map(ShellCrossing::Certain);
                if found.is_none() && 2.0 * self.chord < depth && likely.is_none() {
                    likely = Some(self.point(places[0]));
                }
                found
            }
            TriangleMeeting::Overlay { places } => {
                let mut common = places.iter().map(|&place| {
                    let [one, other] = self.places(triangles, place);
                    let point = self.point(one);
                    let foot = self.faces[other.face].surface().foot_from(other.at, point);
                    let other = FacePlace { at: foot.parameters, ..other };
                    (foot.distance <= self.distance).then_some(([one, other], point))
                });
                let (middle, point) = common.next()??;
                (common.all(|place| place.is_some()) && self.are_two(middle, point))
                    .then_some(ShellCrossing::Overlaid(point))
            }
        };
        if let Some(point) = self.doubled_vertex() {
            return Ok(Some(ShellCrossing::Certain(point)));
        }
        let found = self.mesh.among_meetings([2.0 * self.chord, self.distance], look)?;
        Ok(found.or_else(|| likely.map(ShellCrossing::Likely)))
    }

    /// A vertex inside of a face at the place of another one.
    fn doubled_vertex(&self) -> Option<DVec3> {
        let first = welded(self.mesh.vertices(), self.distance);
        let is_border = self.mesh.border_vertices();
        let place = |vertex: usize| {
            let face = self.ends.partition_point(|end| end[1] <= vertex);
            FacePlace { face, at: self.mesh.uvs()[vertex].to_array() }
        };
        let mut pairs = first.iter().enumerate().filter(|&(vertex, &first)| {
            first as usize != vertex && !(is_border[vertex] && is_border[first as usize])
        });
        pairs.find_map(|(vertex, &first)| self.common([place(first as usize), place(vertex)]))
    }

    fn places(&self, triangles: [u32; 2], weights: CommonWeights) -> [FacePlace; 2] {
        [0, 1].map(|i| {
            let face = self.ends.partition_point(|end| end[0] <= triangles[i] as usize);
            let corners = self.mesh.uvs_of(triangles[i]);
            let at = corners.iter().zip(weights[i]).map(|(&uv, weight)| uv * weight);
            FacePlace { face, at: at.sum::<DVec2>().to_array() }
        })
    }

    fn point(&self, FacePlace { face, at: [u, v] }: FacePlace) -> DVec3 {
        self.faces[face].surface().point_at(u, v)
    }

    /// The place in space that two faces have in common beside two places of them, if these are two of the skin.
    fn common(&self, places: [FacePlace; 2]) -> Option<DVec3> {
        let surfaces = places.map(|place| self.faces[place.face].surface());
        let domains = surfaces.map(|surface| [surface.domain_u(), surface.domain_v()]);
        let limits = domains.map(|pair| pair.map(|domain| [domain.start(), domain.end()]));
        let [[u, v], [s, t]] = limits;
        let widths = domains.map(|pair| pair.map(Interval::length));
        let [a, b] = places.map(|place| place.at);
        let still = |before: [f64; 4], now: [f64; 4]| {
            let widths = widths.as_flattened();
            (0..4).all(|k| (now[k] - before[k]).abs() <= LAST_BIT * widths[k])
        };
        let step = |at: [f64; 4]| {
            let [p, pu, pv] = surfaces[0].tangents_at(at[0], at[1]);
            let [q, qu, qv] = surfaces[1].tangents_at(at[2], at[3]);
            match p.distance(q) <= MEETING_SHARE * self.distance {
                true => NewtonStep::Stay,
                false => NewtonStep::perhaps(shortest_step([pu, pv, -qu, -qv], q - p)),
            }
        };
        let found =
            within_limits([u, v, s, t], [a[0], a[1], b[0], b[1]], CROSSING_STEPS, still, step);
        let [u, v, s, t] = found.unless_stuck()?;
        let places = [FacePlace { at: [u, v], ..places[0] }, FacePlace { at: [s, t], ..places[1] }];
        let points = places.map(|place| self.point(place));
        let point = points[0].midpoint(points[1]);
        let is_common = points[0].distance(points[1]) <= self.distance;
        (is_common && self.are_two(places, point)).then_some(point)
    }

    /// Whether two places at one point are two of the skin, and not one by which faces hang together.
    fn are_two(&self, places: [FacePlace; 2], point: DVec3) -> bool {
        let is_inside = |place: FacePlace| self.faces[place.face].has(place.at, self.tolerance);
        if !places.into_iter().all(is_inside) {
            return false;
        }
        match places[0].face == places[1].face {
            true => !self.stays(places, point),
            false => places.into_iter().any(|place| self.is_off_border(place.face, point)),
        }
    }

    /// Whether the way between two places of a face stays at a point: over a seam where that is shorter.
    fn stays(&self, [one, other]: [FacePlace; 2], point: DVec3) -> bool {
        let surface = self.faces[one.face].surface();
        let closed = [surface.is_closed_u(self.distance), surface.is_closed_v(self.distance)];
        let domains = [surface.domain_u(), surface.domain_v()];
        let way: [f64; 2] = std::array::from_fn(|i| {
            let (way, whole) = (other.at[i] - one.at[i], domains[i].length());
            if closed[i] && 0.5 * whole < way.abs() { way - whole * way.signum() } else { way }
        });
        ON_THE_WAY.into_iter().all(|share| {
            let at: [f64; 2] = std::array::from_fn(|i| {
                let (at, domain) = (one.at[i] + way[i] * share, domains[i]);
                match at {
                    _ if at < domain.start() => at + domain.length(),
                    _ if domain.end() < at => at - domain.length(),
                    _ => at,
                }
            });
            self.point(FacePlace { at, ..one }).distance(point) <= STAYS * self.distance
        })
    }

    /// Whether a point of a face is further from its edges than the mesh may be from it.
    fn is_off_border(&self, face: usize, point: DVec3) -> bool {
        // Where there are no edges to be had nothing can be told.
        let Ok(edges) = self.faces[face].edges(self.tolerance) else { return false };
        edges.iter().all(|edge| {
            self.chord < edge.bounds().distance(point)
                || edge.foot_within(point, self.chord).is_none()
        })
    }
}

/// The shortest change of parameters, as their derivatives go, that adds up to a way.
fn shortest_step(columns: [DVec3; 4], way: DVec3) -> Option<[f64; 4]> {
    let mut matrix = DMat3::ZERO;
    for column in columns {
        let square = column.length_squared();
        if 0.0 < square {
            let row = column / square;
            matrix += DMat3::from_cols(column * row.x, column * row.y, column * row.z);
        }
    }
    let pull = matrix.inverse() * way;
    let step = columns.map(|column| {
        let square = column.length_squared();
        if 0.0 < square { column.dot(pull) / square } else { 0.0 }
    });
    step.iter().all(|by| by.is_finite()).then_some(step)
}
