//! The parts into which edges divide the plane.

use glam::DVec3;

use super::{Arrangement, OrientedEdge};
use crate::{GeomError, NurbsCurve, sorting::sort_by_key};

/// A closed chain of edges with one part of the plane to its left.
#[derive(Debug)]
pub(crate) struct CellLoop {
    /// Edges, and whether it runs along them.
    pub(crate) steps: Vec<OrientedEdge>,
    /// Its arcs; those that follow one another on one given arc are one.
    pub(crate) arcs: Vec<NurbsCurve>,
    /// A number that loops have in common whose edges hang together.
    pub(crate) component: usize,
}

impl Arrangement {
    /// Leaves out edges that end where no other goes on, until there are none. Such ends of the given arcs of
    /// which nothing is left, each with its arc, in their order.
    pub(crate) fn drop_loose_edges(&mut self) -> Vec<(usize, DVec3)> {
        let mut loose_ends = Vec::new();
        loop {
            let mut n_ends = vec![0_usize; self.vertices.len()];
            self.edges.iter().flat_map(|edge| edge.ends).for_each(|end| n_ends[end] += 1);
            let n_before = self.edges.len();
            let vertices = &self.vertices;
            self.edges.retain(|edge| {
                let loose = edge.ends.into_iter().find(|&end| n_ends[end] < 2);
                if let Some(end) = loose {
                    loose_ends.push((edge.arc, vertices[end]));
                }
                loose.is_none()
            });
            if self.edges.len() == n_before {
                break;
            }
        }
        let mut is_left = vec![false; self.arcs.len()];
        self.edges.iter().for_each(|edge| is_left[edge.arc] = true);
        loose_ends.retain(|&(arc, _)| !is_left[arc]);
        sort_by_key(&mut loose_ends, |&(arc, _)| arc);
        loose_ends
    }

    /// The loops around all parts, also around what is outside of everything, which run clockwise; no
    /// edge may be loose.
    ///
    /// # Errors
    /// [`crate::RegionError::Unclear`] where edges come too near one another to be told apart.
    pub(crate) fn cell_loops(&self) -> Result<Vec<CellLoop>, GeomError> {
        let mut exits: Vec<Vec<OrientedEdge>> = vec![Vec::new(); self.vertices.len()];
        for number in 0..self.edges.len() {
            for step in [(number, true), (number, false)] {
                exits[self.ends_of(step)[0]].push(step);
            }
        }
        let components = self.components();
        let mut loops = Vec::new();
        let mut left_by = vec![None; exits.len()];
        for vertex in 0..exits.len() {
            while let Some(step) = exits[vertex].pop() {
                for steps in self.walk(step, &mut exits, &mut left_by)? {
                    let component = components[self.ends_of(steps[0])[0]];
                    loops.push(CellLoop {
                        arcs: self.arcs_of(&steps, |_| false)?,
                        steps,
                        component,
                    });
                }
            }
        }
        Ok(loops)
    }

    /// For each vertex the least one that edges lead to from it.
    fn components(&self) -> Vec<usize> {
        let mut least: Vec<usize> = (0..self.vertices.len()).collect();
        fn root(least: &mut [usize], mut i: usize) -> usize {
            while least[i] != i {
                least[i] = least[least[i]];
                i = least[i];
            }
            i
        }
        for edge in &self.edges {
            let [a, b] = edge.ends.map(|end| root(&mut least, end));
            least[a.max(b)] = a.min(b);
        }
        (0..least.len()).map(|i| root(&mut least, i)).collect()
    }
}
