//! The triangles of solids: one closed mesh.
//!
//! Each face says where the vertices along its arcs must stand at least. Those of every arc that lie on another
//! one, of the same face or of its neighbour, become vertices of that one too, at the same point; what is within
//! the tolerance is one vertex. So both sides of an edge have the same vertices, whatever its arcs are.

use glam::DVec3;

use super::Solid;
use crate::{
    Bounds, CountError, GeomError, Mesh, NurbsCurve, TessellationOptions, distance_to_polyline,
    mesh::{BorderVertex, PartLoops, welded},
    tessellation_parameters,
    tolerance::PARAMETER_RELATIVE,
};

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

impl Solid {
    /// Its mesh, as fine as is asked for: closed, with its triangles to the outside.
    ///
    /// ```
    /// use std::f64::consts::PI;
    /// use virote_kernel::{CircleForm, Frame, NurbsCurve, Region, Solid, TessellationOptions, Tolerance, glam::DVec3};
    ///
    /// let disc = NurbsCurve::ellipse(Frame::XY, [1.0; 2], CircleForm::NinePoint)?;
    /// let rod = Solid::extruded(&Region::new(&disc, &[], Tolerance::DEFAULT)?, DVec3::Z * 3.0, Tolerance::DEFAULT)?;
    /// let mesh = rod.mesh(&TessellationOptions::within(1e-3), 100_000)?;
    /// assert!(mesh.check(Tolerance::DEFAULT).is_closed);
    /// assert!(mesh.volume() < 3.0 * PI && 3.0 * PI * (1.0 - 4e-3) < mesh.volume());
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`crate::Face::mesh`].
    pub fn mesh(&self, options: &TessellationOptions, most: usize) -> Result<Mesh, GeomError> {
        let weld = options.weld;
        let loops = self.faces.iter().map(|face| face.part_loops(weld));
        let loops: Vec<Vec<PartLoops>> = loops.collect::<Result<_, _>>()?;
        let mut tessellations = Vec::with_capacity(loops.len());
        let (mut arcs, mut points) = (Vec::new(), Vec::new());
        for (face, loops) in self.faces.iter().zip(&loops) {
            let tessellation = face.tessellation(loops, options, most)?;
            let stops = tessellation.all_stops()?;
            for (arc, stops) in loops.iter().flatten().flatten().zip(stops) {
                let curve = face.lifted_spline(arc, weld)?;
                let stops = with_chords(arc, &curve, stops, options.tolerance, most)?;
                let at = |&t: &f64| tessellation.vertex_at(arc.point_at(t).truncate()).point;
                let first = points.len() as u32;
                points.extend(stops.iter().map(at));
                let bounds = Bounds::of(points[first as usize..].iter().copied());
                let Some(bounds) = bounds else { unreachable!("an arc has ends") };
                arcs.push(MeshedArc {
                    arc,
                    curve,
                    bounds,
                    stops: stops.into_iter().zip(first..).collect(),
                });
            }
            tessellations.push(tessellation);
        }
        if most < points.len() {
            return Err(CountError::TooManyVertices { got: points.len(), most }.into());
        }
        let first = welded(&points, 2.0 * weld);
        for arc in &mut arcs {
            arc.weld(&first);
        }
        let reach = options.tolerance + 2.0 * weld;
        for arc in &mut arcs {
            arc.take_others(&points, &first, [reach, 2.0 * weld])?;
        }
        let mut arcs = arcs.iter();
        let mut meshes = Vec::with_capacity(loops.len());
        for (tessellation, loops) in tessellations.iter().zip(&loops) {
            let n_arcs = loops.iter().flatten().map(Vec::len).sum();
            let own = arcs.by_ref().take(n_arcs);
            meshes.push(tessellation.mesh_within(own.map(|arc| arc.vertices(&points)))?);
        }
        Mesh::merged(&meshes, most)
    }
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

impl MeshedArc<'_> {
    /// Makes vertices at one place one; an arc that is a point keeps all of its places.
    fn weld(&mut self, first: &[u32]) {
        for stop in &mut self.stops {
            stop.1 = first[stop.1 as usize];
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
        first: &[u32],
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
        for (vertex, &point) in points.iter().enumerate() {
            let is_there = first[vertex] as usize == vertex
                && low.cmple(point).all()
                && point.cmple(high).all()
                && own.binary_search(&(vertex as u32)).is_err()
                && distance_to_polyline(point, &legs).is_some_and(|distance| distance <= reach);
            if !is_there {
                continue;
            }
            GeomError::go_on(1)?;
            let foot = self.curve.closest(point, distance);
            if foot.distance <= distance {
                let fraction = self.curve.domain().fraction_of(foot.parameter);
                let t = self.arc.domain().at(fraction);
                others.push((t, vertex as u32));
            }
        }
        let [start, end] = [self.stops[0], self.stops[self.stops.len() - 1]];
        self.stops.extend(others);
        self.stops.retain(|&(t, _)| start.0 < t && t < end.0);
        self.stops.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
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
