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
    Bounds, CountError, GeomError, Mesh, NurbsCurve, Surface, TessellationOptions,
    distance_to_polyline,
    mesh::{BorderVertex, PartLoops, PartsTessellation, PlacesAlong, tessellate_through, welded},
    sorting::sort_by,
    tessellate_all, tessellation_parameters,
    tolerance::PARAMETER_RELATIVE,
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
    // Curves of parameters miss what they were made of by up to the tolerance on either side.
    let apart = 2.0 * options.weld;
    let loops = faces.iter().map(|face| face.part_loops(options.weld));
    let loops: Vec<Vec<PartLoops>> = loops.collect::<Result<_, _>>()?;
    let mut tessellations = Vec::with_capacity(loops.len());
    let (mut arcs, mut points) = (Vec::new(), Vec::new());
    for (face, loops) in faces.iter().zip(&loops) {
        let tessellation = face.tessellation(loops, options, most)?;
        arcs.extend(MeshedArc::all(face, &tessellation, loops, options, most, &mut points)?);
        tessellations.push(tessellation);
        if most < points.len() {
            return Err(CountError::TooManyVertices { got: points.len(), most }.into());
        }
    }

    // Let the surfaces have vertices there, and the arcs those of the surfaces and of one another.
    let limits = TessellationOptions { weld: apart, ..*options };
    let (surfaces, on_edges) = tessellate_through(surfaces, &points, &limits, most)?;
    let n_before = on_edges.len() as u32;
    let points = [on_edges, points].concat();
    let first = welded(&points, apart);
    for arc in &mut arcs {
        arc.weld(&first, n_before);
    }
    let known = PlacesAlong::new(&points, |place| first[place as usize] == place);
    for arc in &mut arcs {
        arc.take_others(&points, &known, [options.tolerance + apart, apart])?;
    }

    let mut arcs = arcs.iter();
    let mut faces = Vec::with_capacity(loops.len());
    for (tessellation, loops) in tessellations.iter().zip(&loops) {
        let n_arcs = loops.iter().flatten().map(Vec::len).sum();
        let own = arcs.by_ref().take(n_arcs);
        faces.push(tessellation.mesh_within(own.map(|arc| arc.vertices(&points)))?);
    }
    Ok(JoinedMeshes { surfaces, faces })
}

/// An arc of a face, and the vertices along it.
struct MeshedArc<'a> {
    /// Of parameters.
    arc: &'a NurbsCurve,
    /// In space, its parameters at the same fractions of its domain.
    curve: NurbsCurve,
    bounds: Bounds,
    /// Parameters of the arc in their order, each with the number of its vertex.
    stops: Vec<(f64, u32)>,
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
    /// The arcs of a face with the vertices that it needs, whose points come behind the others.
    fn all(
        face: &Face,
        tessellation: &PartsTessellation<'_>,
        loops: &'a [PartLoops],
        options: &TessellationOptions,
        most: usize,
        points: &mut Vec<DVec3>,
    ) -> Result<Vec<Self>, GeomError> {
        let mut arcs = Vec::new();
        let stops = tessellation.all_stops()?;
        for (arc, stops) in loops.iter().flatten().flatten().zip(stops) {
            let curve = face.lifted_spline(arc, options.weld)?;
            let stops = with_chords(arc, &curve, stops, options.tolerance, most)?;
            let at = |&t: &f64| tessellation.vertex_at(arc.point_at(t).truncate()).point;
            let first = points.len() as u32;
            points.extend(stops.iter().map(at));
            let bounds = Bounds::of(points[first as usize..].iter().copied());
            let Some(bounds) = bounds else { unreachable!("an arc has ends") };
            arcs.push(Self { arc, curve, bounds, stops: stops.into_iter().zip(first..).collect() });
        }
        Ok(arcs)
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

    /// Its vertices but the last.
    fn vertices(&self, points: &[DVec3]) -> Vec<BorderVertex> {
        let stops = &self.stops[..self.stops.len() - 1];
        let vertex = |&(t, vertex): &(f64, u32)| BorderVertex {
            parameters: self.arc.point_at(t).truncate(),
            point: points[vertex as usize],
        };
        stops.iter().map(vertex).collect()
    }
}
