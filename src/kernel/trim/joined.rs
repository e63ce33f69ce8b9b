//! The triangles of surfaces and parts of surfaces together, without cracks where their edges run together.
//!
//! Each face says where the vertices along its arcs must stand at least. Surfaces get vertices there too, on their
//! edges; then all vertices of edges and arcs that lie on an arc become vertices of that one, at the same point;
//! what is within the tolerance is one vertex. So all sides of an edge have the same vertices, whatever the arcs
//! are that it consists of.

use std::sync::Arc;

use glam::DVec3;

use super::Face;
use crate::{
    Bounds, CountError, GeomError, Mesh, NurbsCurve, RegionError, Surface, TessellationOptions,
    ceiling::CROSSING_ROUNDS,
    distance_to_polyline,
    mesh::{
        BorderVertex, PartLoops, PartsTessellation, PlacesAlong, drop_opposite_triangles,
        tessellate_through, welded,
    },
    sorting::sort_by,
    tessellate_all, tessellation_parameters,
    tolerance::{LEG_MARGIN, PARAMETER_RELATIVE},
};

/// A surface, or a part of one, that becomes triangles.
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{
///     Face, Frame, Mesh, NurbsCurve, NurbsSurface, Region, Surface, SurfacePiece, TessellationOptions,
///     Tolerance, glam::DVec3, tessellate_together,
/// };
///
/// // A wall over a half disc, whose floor is a region: the straight part of its rim is one edge of the wall.
/// let arc = NurbsCurve::arc(Frame::XY, 1.0, 0.0, std::f64::consts::PI)?;
/// let chord = NurbsCurve::line(arc.end(), arc.start())?;
/// let wall = |rim: &NurbsCurve| NurbsSurface::extruded(rim, DVec3::Z).map(Surface::from);
/// let (round, straight) = (wall(&arc)?, wall(&chord)?);
/// let floor = Region::of_arcs(Frame::XY, vec![vec![arc, chord]])?;
/// let floor = Face::of_region(&floor, Tolerance::DEFAULT)?;
/// let pieces = [SurfacePiece::Whole(&round), SurfacePiece::Whole(&straight), SurfacePiece::Part(&floor)];
/// let meshes = tessellate_together(&pieces, &TessellationOptions::within(1e-3), 10_000)?;
/// // It is open at the top alone.
/// assert_eq!(Mesh::merged(&meshes, 10_000)?.check(Tolerance::DEFAULT).boundaries, 1);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub enum SurfacePiece<'a> {
    /// All of a surface.
    Whole(&'a Surface),
    /// A part of one.
    Part(&'a Face),
}

/// Meshes of surfaces and of faces.
pub(crate) struct JoinedMeshes {
    surfaces: Vec<Mesh>,
    pub(crate) faces: Vec<Mesh>,
}

/// Meshes of surfaces and parts of surfaces, which share the vertices on edges that they share.
///
/// # Errors
/// Those of [`tessellate_all`] and of [`Face::mesh`].
pub fn tessellate_together(
    pieces: &[SurfacePiece<'_>],
    options: &TessellationOptions,
    most: usize,
) -> Result<Vec<Mesh>, GeomError> {
    let is_part =
        |piece: &SurfacePiece<'_>| matches!(piece, SurfacePiece::Part(face) if !face.is_whole());
    let (mut surfaces, mut faces) = (Vec::new(), Vec::new());
    for piece in pieces {
        match piece {
            SurfacePiece::Whole(surface) => surfaces.push((*surface).clone()),
            SurfacePiece::Part(face) if is_part(piece) => faces.push(*face),
            SurfacePiece::Part(face) => surfaces.push(Surface::Nurbs(Arc::clone(face.surface()))),
        }
    }
    let joined = joined_meshes(&surfaces, &faces, options, most)?;
    let (mut surfaces, mut faces) = (joined.surfaces.into_iter(), joined.faces.into_iter());
    let next = |piece| if is_part(piece) { faces.next() } else { surfaces.next() };
    Ok(pieces.iter().filter_map(next).collect())
}

/// Meshes of surfaces and parts of surfaces, which share the vertices on edges that they share.
///
/// # Errors
/// Those of [`tessellate_all`] and of [`Face::mesh`].
pub(crate) fn joined_meshes(
    surfaces: &[Surface],
    faces: &[&Face],
    options: &TessellationOptions,
    most: usize,
) -> Result<JoinedMeshes, GeomError> {
    if faces.is_empty() {
        let surfaces = tessellate_all(surfaces, options, most)?;
        return Ok(JoinedMeshes { surfaces, faces: Vec::new() });
    }
    let loops = faces.iter().map(|face| face.part_loops(options.weld));
    let loops: Vec<Vec<PartLoops>> = loops.collect::<Result<_, _>>()?;
    let mut tessellations = Vec::with_capacity(loops.len());
    let mut arcs = Vec::with_capacity(loops.len());
    for (face, loops) in faces.iter().zip(&loops) {
        let tessellation = face.tessellation(loops, options, most)?;
        arcs.push(MeshedArc::all(face, &tessellation, loops, options, most)?);
        tessellations.push(tessellation);
    }
    for _ in 0..CROSSING_ROUNDS {
        match with_common_vertices(surfaces, &tessellations, &mut arcs, options, most) {
            Err(GeomError::Region(RegionError::Unclear { point })) => {
                if !divide_crossing_legs(&tessellations, &mut arcs, options.weld) {
                    return Err(RegionError::Unclear { point }.into());
                }
            }
            found => {
                let found = found?;
                let mut is_done = true;
                for (i, mesh) in found.faces.iter().enumerate() {
                    if !tessellations[i].is_settled() && tessellations[i].sharpen(mesh, options)? {
                        is_done = false;
                        let finer = tessellations[i].all_stops()?;
                        for (arc, finer) in arcs[i].iter_mut().zip(finer) {
                            arc.want(finer);
                        }
                    }
                }
                if is_done {
                    return Ok(found);
                }
            }
        }
    }
    with_common_vertices(surfaces, &tessellations, &mut arcs, options, most)
}

/// Meshes whose borders have the vertices that arcs want, and those of one another where they run together.
fn with_common_vertices(
    surfaces: &[Surface],
    tessellations: &[PartsTessellation<'_>],
    arcs: &mut [Vec<MeshedArc<'_>>],
    options: &TessellationOptions,
    most: usize,
) -> Result<JoinedMeshes, GeomError> {
    let mut points = Vec::new();
    for (tessellation, arcs) in tessellations.iter().zip(&mut *arcs) {
        arcs.iter_mut().for_each(|arc| arc.place(tessellation, &mut points));
        if most < points.len() {
            return Err(CountError::TooManyVertices { got: points.len(), most }.into());
        }
    }
    // Curves of parameters miss what they were made of by up to the tolerance on either side.
    let apart = 2.0 * options.weld;
    // Let the surfaces have vertices there, and the arcs those of the surfaces and of one another.
    let limits = TessellationOptions { weld: apart, ..*options };
    let (surfaces, on_edges) = tessellate_through(surfaces, &points, &limits, most)?;
    let n_before = on_edges.len() as u32;
    let points = [on_edges, points].concat();
    let first = welded(&points, apart);
    for arc in arcs.iter_mut().flatten() {
        arc.weld(&first, n_before);
    }
    let known = PlacesAlong::new(&points, |place| first[place as usize] == place);
    for arc in arcs.iter_mut().flatten() {
        arc.take_others(&points, &known, [options.tolerance + apart, apart])?;
        arc.find_vertices(&points);
    }
    let mesh = |(tessellation, arcs): (&PartsTessellation<'_>, &mut Vec<MeshedArc<'_>>)| {
        tessellation.mesh_within(arcs.iter().map(|arc| arc.vertices.clone()))
    };
    let mut faces =
        tessellations.iter().zip(arcs).map(mesh).collect::<Result<Vec<_>, GeomError>>()?;
    drop_opposite_triangles(&mut faces, apart);
    Ok(JoinedMeshes { surfaces, faces })
}

/// Lets arcs have more vertices where their legs cross: at the places of one that are nearest to those of the other,
/// else in the middle. False where none cross.
fn divide_crossing_legs(
    tessellations: &[PartsTessellation<'_>],
    arcs: &mut [Vec<MeshedArc<'_>>],
    distance: f64,
) -> bool {
    let mut is_any = false;
    for (tessellation, arcs) in tessellations.iter().zip(arcs) {
        let pairs = tessellation.crossing_legs(arcs.iter().map(|arc| arc.vertices.clone()));
        for pair in pairs {
            let ends = pair.map(|(arc, leg)| arcs[arc].leg(leg));
            let mut more = [0, 1].map(|i| {
                let (arc, points) = (&arcs[pair[i].0], ends[1 - i].map(|end| end.1));
                arc.feet(ends[i].map(|end| end.0), points, distance)
            });
            if more.iter().all(Vec::is_empty) {
                more = ends.map(|[(from, _), (to, _)]| vec![from.midpoint(to)]);
            }
            for (more, (arc, _)) in more.into_iter().zip(pair) {
                is_any |= arcs[arc].want(more);
            }
        }
    }
    is_any
}

/// An arc of a face, and the vertices along it.
struct MeshedArc<'a> {
    /// Of parameters.
    arc: &'a NurbsCurve,
    /// In space, its parameters at the same fractions of its domain.
    curve: NurbsCurve,
    bounds: Bounds,
    /// Parameters of the arc at which it has vertices whatever others have, in their order.
    wanted: Vec<f64>,
    /// Parameters of the arc in their order, each with the number of its vertex.
    stops: Vec<(f64, u32)>,
    /// Its vertices but the last.
    vertices: Vec<BorderVertex>,
    /// Where it ends.
    end: DVec3,
}

/// Places along an arc of parameters with more between them, so that the arc in space is nowhere further than the
/// tolerance from its chords.
fn with_chords(
    arc: &NurbsCurve,
    curve: &NurbsCurve,
    mut stops: Vec<f64>,
    tolerance: f64,
    most: usize,
) -> Result<Vec<f64>, GeomError> {
    let domain = arc.domain();
    let finer = tessellation_parameters(curve, tolerance, most)?.into_iter();
    stops.extend(finer.map(|t| domain.at(curve.domain().fraction_of(t))));
    let least = PARAMETER_RELATIVE * domain.length();
    stops.retain(|&t| domain.start() + least < t && t < domain.end() - least);
    stops.sort_by(f64::total_cmp);
    stops.dedup_by(|behind, before| *behind - *before <= least);
    stops.insert(0, domain.start());
    stops.push(domain.end());
    Ok(stops)
}

impl<'a> MeshedArc<'a> {
    /// The arcs of a face with the places at which it needs vertices.
    fn all(
        face: &Face,
        tessellation: &PartsTessellation<'_>,
        loops: &'a [PartLoops],
        options: &TessellationOptions,
        most: usize,
    ) -> Result<Vec<Self>, GeomError> {
        let mut arcs = Vec::new();
        let stops = tessellation.all_stops()?;
        for (arc, stops) in loops.iter().flatten().flatten().zip(stops) {
            let curve = face.lifted_spline(arc, options.weld)?;
            let wanted = with_chords(arc, &curve, stops, options.tolerance, most)?;
            let bounds = curve.bounds();
            let (stops, vertices, end) = (Vec::new(), Vec::new(), curve.end());
            arcs.push(Self { arc, curve, bounds, wanted, stops, vertices, end });
        }
        Ok(arcs)
    }

    /// Gives it the vertices that it wants and no others; their points come behind the others.
    fn place(&mut self, tessellation: &PartsTessellation<'_>, points: &mut Vec<DVec3>) {
        let at = |&t: &f64| tessellation.vertex_at(self.arc.point_at(t).truncate()).point;
        let first = points.len() as u32;
        points.extend(self.wanted.iter().map(at));
        let own = points[first as usize..].iter().copied();
        let Some(bounds) = Bounds::of(own) else { unreachable!("an arc has ends") };
        self.bounds = bounds;
        self.stops = self.wanted.iter().copied().zip(first..).collect();
    }

    /// Lets it have vertices at more parameters; false where it has them.
    fn want(&mut self, more: Vec<f64>) -> bool {
        let n_before = self.wanted.len();
        let domain = self.arc.domain();
        let least = PARAMETER_RELATIVE * domain.length();
        let is_apart =
            |t: f64, wanted: &[f64]| wanted.iter().all(|&other| least < (t - other).abs());
        for t in more {
            if is_apart(t, &self.wanted) {
                self.wanted.push(t);
            }
        }
        self.wanted.sort_by(f64::total_cmp);
        n_before < self.wanted.len()
    }

    /// The parameters and points of the ends of a leg.
    fn leg(&self, leg: usize) -> [(f64, DVec3); 2] {
        let point = |i: usize| self.vertices.get(i).map_or(self.end, |vertex| vertex.point);
        [leg, leg + 1].map(|i| (self.stops[i].0, point(i)))
    }

    /// The parameters between those of a leg, not next to them, at which it is nearest to points.
    fn feet(&self, [from, to]: [f64; 2], points: [DVec3; 2], distance: f64) -> Vec<f64> {
        let domain = self.arc.domain();
        let foot = |point: DVec3| {
            let foot = self.curve.closest(point, distance);
            domain.at(self.curve.domain().fraction_of(foot.parameter))
        };
        let margin = LEG_MARGIN * (to - from);
        let is_between = |t: &f64| from + margin < *t && *t < to - margin;
        points.into_iter().map(foot).filter(is_between).collect()
    }

    /// Makes vertices at one place one, of numbers that `n_before` others come before; an arc that is a point
    /// keeps all of its places.
    fn weld(&mut self, first: &[u32], n_before: u32) {
        for stop in &mut self.stops {
            stop.1 = first[(stop.1 + n_before) as usize];
        }
        if self.is_point() {
            return;
        }
        let end = self.stops[self.stops.len() - 1];
        self.stops.dedup_by_key(|stop| stop.1);
        // Its end stays where it is.
        if let Some(last) = self.stops.last_mut() {
            *last = if last.1 == end.1 { end } else { *last };
        }
    }

    fn is_point(&self) -> bool {
        self.stops.iter().all(|&(_, vertex)| vertex == self.stops[0].1)
    }

    /// Takes vertices of other arcs that lie on it.
    fn take_others(
        &mut self,
        points: &[DVec3],
        known: &PlacesAlong<'_>,
        [reach, distance]: [f64; 2],
    ) -> Result<(), GeomError> {
        if self.is_point() {
            return Ok(());
        }
        let mut own: Vec<u32> = self.stops.iter().map(|&(_, vertex)| vertex).collect();
        own.sort_unstable();
        let legs: Vec<DVec3> =
            self.stops.iter().map(|&(_, vertex)| points[vertex as usize]).collect();
        let (low, high) = (self.bounds.min - reach, self.bounds.max + reach);
        let mut others = Vec::new();
        GeomError::go_on(1)?;
        for &vertex in known.between(low, high) {
            let point = points[vertex as usize];
            let is_there = low.cmple(point).all()
                && point.cmple(high).all()
                && own.binary_search(&vertex).is_err()
                && distance_to_polyline(point, &legs).is_some_and(|distance| distance <= reach);
            if !is_there {
                continue;
            }
            GeomError::go_on(1)?;
            let foot = self.curve.closest(point, distance);
            if foot.distance <= distance {
                let fraction = self.curve.domain().fraction_of(foot.parameter);
                let t = self.arc.domain().at(fraction);
                others.push((t, vertex));
            }
        }
        let [start, end] = [self.stops[0], self.stops[self.stops.len() - 1]];
        self.stops.extend(others);
        self.stops.retain(|&(t, _)| start.0 < t && t < end.0);
        sort_by(&mut self.stops, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        self.stops.insert(0, start);
        self.stops.push(end);
        Ok(())
    }

    /// Finds its vertices at its stops.
    fn find_vertices(&mut self, points: &[DVec3]) {
        let (last, stops) = (self.stops[self.stops.len() - 1], &self.stops[..self.stops.len() - 1]);
        let vertex = |&(t, vertex): &(f64, u32)| BorderVertex {
            parameters: self.arc.point_at(t).truncate(),
            point: points[vertex as usize],
        };
        self.vertices = stops.iter().map(vertex).collect();
        self.end = points[last.1 as usize];
    }
}
