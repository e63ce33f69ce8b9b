//! Arcs in the plane z = 0, cut where they meet: what booleans, offsets and even-odd filling of plane
//! regions are made of.
//!
//! `near` finds which arcs may meet, `meet` where they do, completely, with `touch` of crossings that are one touch; `cut` makes places within the tolerance one vertex and what
//! lies along itself one edge; `around` counts how often rings go around what is on either side of an edge, by a `ray`;
//! `walk` puts edges together to loops that run with the region to their left, `cell` to the loops around all
//! that edges divide the plane into. An edge ends at vertices
//! alone, so that what is true at one place on it is true along all of it. What was missed shows: loops
//! would not close.

mod around;
mod cell;
mod cut;
mod meet;
mod near;
mod ray;
mod touch;
mod walk;

use glam::DVec3;

use crate::{Interval, NurbsCurve};

pub(crate) use around::{EdgeSide, RaySearch, Windings};
pub(crate) use cell::CellLoop;
pub(crate) use ray::winding_about;
pub(crate) use walk::{OrientedEdge, joined};

/// A closed chain of arcs. Its loops count for the group that it belongs to.
#[derive(Clone, Debug)]
pub(crate) struct Ring {
    /// A number that rings of one region have in common.
    pub(crate) group: usize,
    /// Each begins where the one before it ends, up to the tolerance; the first behind the last.
    pub(crate) arcs: Vec<NurbsCurve>,
}

/// Which arcs are known not to meet but at the ends that they share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Apart {
    /// Those of one group.
    Groups,
    /// None.
    Nothing,
}

/// Arcs between the vertices in which they meet.
#[derive(Debug)]
pub(crate) struct Arrangement {
    /// Where edges end.
    pub(crate) vertices: Vec<DVec3>,
    pub(crate) edges: Vec<PlaneEdge>,
    /// The start of the first edge along which rings of one group run more than once, in either sense, and the group.
    repeated: Option<(usize, usize)>,
    /// A place of the first ring that lies within reach of one vertex, so that none of it is left.
    pub(crate) swallowed: Option<DVec3>,
    /// The given arcs, by their number.
    arcs: Vec<NurbsCurve>,
    /// How near places are one.
    tolerance: f64,
}

/// A part of an arc that meets nothing between its ends; of parts that lie along one another the first.
#[derive(Debug)]
pub(crate) struct PlaneEdge {
    /// The given arc of which it is a part.
    pub(crate) arc: usize,
    pub(crate) interval: Interval,
    /// That part.
    pub(crate) curve: NurbsCurve,
    /// The vertices where it starts and ends.
    pub(crate) ends: [usize; 2],
    /// How often each group's rings run along it, less how often they run against it.
    pub(crate) passes: Vec<(usize, i32)>,
}

impl Arrangement {
    /// A vertex in which more than two ends of edges meet, or the start of an edge along which more than
    /// one ring runs; and the groups there, in order. None where all rings are apart and meet nothing
    /// but themselves in their joints, or run back along themselves.
    pub(crate) fn knot(&self) -> Option<(DVec3, Vec<usize>)> {
        let mut n_ends = vec![0; self.vertices.len()];
        self.edges.iter().flat_map(|edge| edge.ends).for_each(|end| n_ends[end] += 1);
        let is_shared = |edge: &&PlaneEdge| !matches!(edge.passes[..], [(_, 1 | -1)]);
        let shared = self.edges.iter().find(is_shared).map(|edge| edge.ends[0]);
        let vertex = shared.or_else(|| n_ends.iter().position(|&n| 2 < n))?;
        let edges = self.edges.iter().filter(|edge| edge.ends.contains(&vertex));
        let mut groups: Vec<usize> =
            edges.flat_map(|edge| edge.passes.iter().map(|&(group, _)| group)).collect();
        groups.sort_unstable();
        groups.dedup();
        Some((self.vertices[vertex], groups))
    }

    /// The start of an edge along which rings of one group run more than once, in either sense, with the group.
    pub(crate) fn repeated(&self) -> Option<(DVec3, Vec<usize>)> {
        self.repeated.map(|(vertex, group)| (self.vertices[vertex], vec![group]))
    }
}
