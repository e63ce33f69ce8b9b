//! The nearest point of a spline, of the whole of it.
//!
//! Patches come in the order of their boxes. On a patch |A|² − λw² is a polynomial, A the
//! homogeneous point seen from the place that is asked for, and it is negative where the spline is
//! nearer than √λ: where its Bernstein coefficients are not, the patch is left out. Elsewhere a
//! minimum is found by Newton's method within the patch. It is the only one if the polynomial is
//! convex with λ the square of its distance; otherwise the patch is halved. So the answer does not
//! hang on a guess, minima on the boundary are found like all others, and nothing is sampled.
//!
//! `tree` has the boxes, `search` walks over them, `spans` has what makes patches, `patch` a patch and the minimum on a
//! part of it, `basis` its derivatives, `gap` the polynomial.

mod basis;
mod gap;
mod patch;
mod search;
mod spans;
mod tree;

use std::sync::Arc;

use glam::{DVec3, DVec4};

use crate::{Grid, KnotVector, homogeneous};
use gap::ProductFactors;
use patch::BezierPatch;
pub(crate) use patch::{FootVector, PatchPart, descend};
use spans::DirectionSpans;
pub(crate) use tree::BoxedPiece;
use tree::PatchTree;

/// A tensor-product spline prepared to be searched; a curve has a single row.
#[derive(Debug)]
pub(crate) struct ClosestPointTree {
    along: [DirectionSpans; 2],
    tree: PatchTree,
    magnitude: f64,
    /// The largest coordinate of the places of control points.
    control_magnitude: f64,
    factors: ProductFactors,
}

/// Parameters of a spline.
#[derive(Debug)]
pub(crate) struct SplineParameters {
    /// Places that are nearest, at least one unless it is too far, and some that were on the way to them.
    pub(crate) single: Vec<[f64; 2]>,
    /// The ends of stretches that are equally near all along; they are among the places too.
    pub(crate) stretches: Vec<[[f64; 2]; 2]>,
}

/// Which places are looked for.
#[derive(Clone, Copy, Debug)]
pub(crate) enum SearchTarget {
    /// One of the nearest.
    One,
    /// One of the nearest, if that is no further away.
    OneWithin(f64),
    /// Each local minimum that is at most so much further away than the nearest.
    AllWithin(f64),
}

impl ClosestPointTree {
    /// Prepares a curve.
    pub(crate) fn of_curve(knots: &KnotVector, points: &[DVec4]) -> Self {
        Self::new([DirectionSpans::single(), DirectionSpans::new(knots)], points.len(), points)
    }

    /// Prepares a surface.
    pub(crate) fn of_surface(knots: [&KnotVector; 2], points: &Grid<DVec4>) -> Self {
        Self::new(knots.map(DirectionSpans::new), points.n_columns(), points.as_slice())
    }

    fn new(along: [DirectionSpans; 2], n_columns: usize, points: &[DVec4]) -> Self {
        let mut patch = BezierPatch::new([along[0].degree, along[1].degree]);
        let tree = PatchTree::new([along[0].spans.len(), along[1].spans.len()], |spans| {
            patch.take(&along, spans, (points, n_columns), (DVec3::ZERO, 1.0));
            patch.bounds()
        });
        let largest = |&point| homogeneous::place(point).abs().max_element();
        Self {
            factors: ProductFactors::new([along[0].degree, along[1].degree]),
            magnitude: tree.magnitude(),
            control_magnitude: points.iter().map(largest).fold(0.0, f64::max),
            along,
            tree,
        }
    }

    /// The largest coordinate of the places of its control points.
    pub(crate) fn control_magnitude(&self) -> f64 {
        self.control_magnitude
    }

    /// The pairs of a patch of this spline and one of another whose boxes are within a distance of one
    /// another, each by the numbers of its spans along both directions; in order.
    pub(crate) fn near_pairs(&self, other: &Self, distance: f64) -> Vec<[[usize; 2]; 2]> {
        self.tree.near_pairs(&other.tree, distance)
    }

    /// The patches of this spline and what of the pieces their boxes are within a distance of, by the
    /// numbers of their spans; pieces are halved until they are no larger than the patch.
    pub(crate) fn near_pieces<P: BoxedPiece>(
        &self,
        pieces: Vec<Arc<P>>,
        distance: f64,
    ) -> Vec<(Arc<P>, [usize; 2])> {
        self.tree.near_pieces(pieces, distance)
    }

    fn n_rows(&self) -> usize {
        let last = self.along[0].spans.len() - 1;
        self.along[0].spans[last].first + self.along[0].degree + 1
    }
}
