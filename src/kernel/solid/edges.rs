//! Edges between faces as one sees them: without seams, and without the vertices in which these alone end.

use std::collections::BTreeMap;

use glam::DVec3;

use super::{Solid, SolidEdge, SolidTopology};
use crate::{GeomError, NurbsCurve, Side, Tolerance, frame::angle_between, join};

/// An end of an edge: its number, and whether it is that where it ends.
type EdgeEnd = (usize, bool);

impl Solid {
    /// The edges that faces have in common, without seams, each once.
    ///
    /// Where of two edges between the same faces one goes on smoothly as the other, and no third ends, they are one,
    /// and a closed one ends where it starts.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use virote_kernel::{Face, Frame, NurbsSurface, Solid, Tolerance, glam::DVec3};
    ///
    /// let sphere = Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, 1.0)?), Tolerance::DEFAULT)?;
    /// let ball = Solid::new(&[sphere], Tolerance::DEFAULT)?;
    /// assert!(ball.edges(Tolerance::DEFAULT)?.is_empty());
    /// // The circle goes over the seam of the sphere twice.
    /// let upright = Frame::from_axes(DVec3::X * 0.4, DVec3::Y, DVec3::Z)?;
    /// let part = ball.cut(upright, true, Tolerance::DEFAULT)?.expect("a cap");
    /// let edges = part.edges(Tolerance::DEFAULT)?;
    /// assert!(edges.len() == 1 && edges[0].vertices[0] == edges[0].vertices[1]);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Self::topology`] and of [`join`].
    pub fn edges(&self, tolerance: Tolerance) -> Result<Vec<SolidEdge>, GeomError> {
        self.topology(tolerance)?.edges_between_faces(tolerance)
    }

    /// The places where these edges end; a closed one ends where it starts.
    ///
    /// # Errors
    /// Those of [`Self::edges`].
    pub fn vertices(&self, tolerance: Tolerance) -> Result<Vec<DVec3>, GeomError> {
        let topology = self.topology(tolerance)?;
        let mut is_end = vec![false; topology.vertices.len()];
        let edges = topology.edges_between_faces(tolerance)?;
        edges.iter().flat_map(|edge| edge.vertices).for_each(|end| is_end[end] = true);
        let points = topology.vertices.into_iter().zip(is_end);
        Ok(points.filter(|end| end.1).map(|end| end.0).collect())
    }
}

impl SolidTopology {
    /// The edges of [`Solid::edges`].
    ///
    /// # Errors
    /// Those of [`join`].
    pub(super) fn edges_between_faces(
        &self,
        tolerance: Tolerance,
    ) -> Result<Vec<SolidEdge>, GeomError> {
        let next = self.smooth_vertices(tolerance);
        let mut is_taken = vec![false; self.edges.len()];
        let mut found = Vec::new();
        // Open chains begin at an end where they do not go on; what is left then is closed.
        let is_open = |&(edge, is_end): &EdgeEnd| !next.contains_key(&(edge, is_end));
        let numbers = || (0..self.edges.len()).filter(|&edge| !self.edges[edge].is_seam());
        let starts = numbers().flat_map(|edge| [(edge, false), (edge, true)]).filter(is_open);
        for (first, is_end) in starts.chain(numbers().map(|edge| (edge, false))) {
            if is_taken[first] {
                continue;
            }
            let (mut chain, mut at) = (Vec::new(), (first, is_end));
            loop {
                is_taken[at.0] = true;
                chain.push(at);
                match next.get(&(at.0, !at.1)) {
                    Some(&further) if !is_taken[further.0] => at = further,
                    _ => break,
                }
            }
            found.push(self.joined(
                &chain,
                self.edges[first].curve.bounds().magnitude(),
                tolerance,
            )?);
        }
        Ok(found)
    }

    /// For ends of edges that go on smoothly as another between the same faces the start of that.
    fn smooth_vertices(&self, tolerance: Tolerance) -> BTreeMap<EdgeEnd, EdgeEnd> {
        let mut ends: Vec<Vec<EdgeEnd>> = vec![Vec::new(); self.vertices.len()];
        for (number, edge) in self.edges.iter().enumerate().filter(|(_, edge)| !edge.is_seam()) {
            ends[edge.vertices[0]].push((number, false));
            ends[edge.vertices[1]].push((number, true));
        }
        let mut next = BTreeMap::new();
        for pair in ends {
            let [one, other] = pair[..] else { continue };
            // A closed edge has both its ends there.
            let goes_on = one.0 != other.0
                && self.faces_into(one) == self.faces_into((other.0, !other.1))
                && self
                    .direction_into(one)
                    .zip(self.direction_into(other))
                    .is_some_and(|(a, b)| angle_between(a, -b) <= tolerance.angle);
            if goes_on {
                next.insert(one, other);
                next.insert(other, one);
            }
        }
        next
    }

    /// The faces along and back of an edge that is gone along to an end.
    fn faces_into(&self, (edge, is_end): EdgeEnd) -> [usize; 2] {
        let [along, back] = self.edges[edge].faces;
        if is_end { [along, back] } else { [back, along] }
    }

    /// The direction in which an edge comes to an end; none where it has none.
    fn direction_into(&self, (edge, is_end): EdgeEnd) -> Option<DVec3> {
        let curve = &self.edges[edge].curve;
        match is_end {
            true => curve.tangent_at(curve.domain().end(), Side::Left).ok(),
            false => curve.tangent_at(curve.domain().start(), Side::Right).ok().map(|it| -it),
        }
    }

    /// Edges that follow one another, each begun at an end of it, as one.
    fn joined(
        &self,
        chain: &[EdgeEnd],
        size: f64,
        tolerance: Tolerance,
    ) -> Result<SolidEdge, GeomError> {
        let along = |&(number, is_end): &EdgeEnd| {
            let SolidEdge { curve, vertices: [a, b], faces: [one, other] } = &self.edges[number];
            match is_end {
                true => {
                    SolidEdge { curve: curve.reversed(), vertices: [*b, *a], faces: [*other, *one] }
                }
                false => self.edges[number].clone(),
            }
        };
        let edges: Vec<SolidEdge> = chain.iter().map(along).collect();
        let (first, last) = (&edges[0], &edges[edges.len() - 1]);
        if edges.len() == 1 {
            // As it was found: its sense tells on which side which face is.
            return Ok(self.edges[chain[0].0].clone());
        }
        let curves: Vec<NurbsCurve> = edges.iter().map(|edge| edge.curve.clone()).collect();
        let curve = join(&curves, 4.0 * tolerance.distance_for(size))?;
        if first.faces[1] < first.faces[0] {
            let ([one, other], [start, end]) = (first.faces, [first.vertices[0], last.vertices[1]]);
            let (vertices, faces) = ([end, start], [other, one]);
            return Ok(SolidEdge { curve: curve.reversed(), vertices, faces });
        }
        Ok(SolidEdge { curve, vertices: [first.vertices[0], last.vertices[1]], faces: first.faces })
    }
}
