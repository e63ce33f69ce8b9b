//! Boxes around the patches of a spline, and around neighbours of these.

use std::sync::Arc;

use glam::DVec3;

use crate::{Bounds, work};

/// A binary tree over the grid of patches.
#[derive(Debug)]
pub(super) struct PatchTree {
    nodes: Vec<TreeNode>,
}

#[derive(Debug)]
struct TreeNode {
    bounds: Bounds,
    below: Children,
}

#[derive(Debug)]
enum Children {
    Children([usize; 2]),
    Patch([usize; 2]),
}

/// Something in a box that can be halved.
pub(crate) trait BoxedPiece: Sized {
    /// The box around it.
    fn bounds(&self) -> Bounds;

    /// Its halves.
    fn halves(&self) -> [Self; 2];
}

/// A rectangle of patches: the first one along each direction, and behind the last.
type PatchBlock = [[usize; 2]; 2];

impl PatchTree {
    /// The tree over so many patches along each direction, each in its box.
    pub(super) fn new(n: [usize; 2], mut bounds: impl FnMut([usize; 2]) -> Bounds) -> Self {
        let mut tree = Self { nodes: Vec::with_capacity(2 * n[0] * n[1]) };
        tree.add([[0, n[0]], [0, n[1]]], &mut bounds);
        tree
    }

    /// Adds a block, as deep as its size has bits.
    fn add(&mut self, block: PatchBlock, bounds: &mut impl FnMut([usize; 2]) -> Bounds) -> usize {
        let counts = block.map(|[first, behind]| behind - first);
        let index = self.nodes.len();
        if counts == [1, 1] {
            let patch = block.map(|[first, _]| first);
            self.nodes.push(TreeNode { bounds: bounds(patch), below: Children::Patch(patch) });
            return index;
        }
        let direction = usize::from(counts[0] < counts[1]);
        let middle = block[direction][0] + counts[direction] / 2;
        let (mut left, mut right) = (block, block);
        (left[direction][1], right[direction][0]) = (middle, middle);
        let nowhere = Bounds { min: DVec3::ZERO, max: DVec3::ZERO };
        self.nodes.push(TreeNode { bounds: nowhere, below: Children::Patch([0, 0]) });
        let children = [self.add(left, bounds), self.add(right, bounds)];
        let [a, b] = children.map(|child| self.nodes[child].bounds);
        self.nodes[index] = TreeNode { bounds: a.union(b), below: Children::Children(children) };
        index
    }

    pub(super) fn root(&self) -> usize {
        0
    }

    pub(super) fn children(&self, node: usize) -> Option<[usize; 2]> {
        match self.nodes[node].below {
            Children::Children(children) => Some(children),
            Children::Patch(_) => None,
        }
    }

    /// The spans of the patch that a node without children stands for.
    pub(super) fn spans(&self, node: usize) -> [usize; 2] {
        match self.nodes[node].below {
            Children::Patch(spans) => spans,
            Children::Children(_) => unreachable!("it has no children"),
        }
    }

    /// How far its box is from `p`, lengths multiplied by `unit`.
    pub(super) fn least(&self, node: usize, p: DVec3, unit: f64) -> f64 {
        let Bounds { min, max } = self.nodes[node].bounds;
        ((p - p.clamp(min, max)) * unit).length()
    }

    /// The pairs of a patch of this and one of another tree whose boxes are within a distance of one
    /// another, in order.
    pub(super) fn near_pairs(&self, other: &Self, distance: f64) -> Vec<[[usize; 2]; 2]> {
        let mut pairs = Vec::new();
        let mut todo = vec![[self.root(), other.root()]];
        while let Some([own, its]) = todo.pop() {
            let [a, b] = [&self.nodes[own], &other.nodes[its]];
            if !work::goes_on(1) || !a.bounds.is_near(b.bounds, distance) {
                continue;
            }
            match (&a.below, &b.below) {
                (&Children::Patch(first), &Children::Patch(second)) => pairs.push([first, second]),
                (Children::Children(below), Children::Patch(_)) => {
                    todo.extend(below.map(|own| [own, its]));
                }
                (Children::Patch(_), Children::Children(below)) => {
                    todo.extend(below.map(|its| [own, its]));
                }
                (Children::Children(_), Children::Children(below))
                    if a.bounds.diagonal() < b.bounds.diagonal() =>
                {
                    todo.extend(below.map(|its| [own, its]));
                }
                (Children::Children(below), Children::Children(_)) => {
                    todo.extend(below.map(|own| [own, its]));
                }
            }
        }
        pairs.sort_unstable();
        pairs
    }

    /// The patches whose boxes are within a distance of something in pieces, each with what of the
    /// pieces is there; in the order of the pieces. A piece is halved until it is no larger than the
    /// patch, or so small that rounding is all of it.
    pub(super) fn near_pieces<P: BoxedPiece>(
        &self,
        pieces: Vec<Arc<P>>,
        distance: f64,
    ) -> Vec<(Arc<P>, [usize; 2])> {
        let mut found = Vec::new();
        let mut todo: Vec<(Arc<P>, usize)> =
            pieces.into_iter().rev().map(|piece| (piece, self.root())).collect();
        while work::goes_on(1)
            && let Some((piece, node)) = todo.pop()
        {
            let TreeNode { bounds, below } = &self.nodes[node];
            if !bounds.is_near(piece.bounds(), distance) {
                continue;
            }
            let [size, own] = [bounds.diagonal(), piece.bounds().diagonal()];
            match *below {
                Children::Children(children) if own <= size => {
                    todo.extend(children.map(|child| (Arc::clone(&piece), child)));
                }
                Children::Patch(spans) if own <= size.max(distance) => found.push((piece, spans)),
                _ => {
                    let [before, behind] = piece.halves().map(Arc::new);
                    todo.extend([(behind, node), (before, node)]);
                }
            }
        }
        found
    }

    /// The largest coordinate of all boxes that are known.
    pub(super) fn magnitude(&self) -> f64 {
        let leaves = self.nodes.iter().filter(|node| matches!(node.below, Children::Patch(_)));
        let magnitudes = leaves.map(|node| node.bounds.magnitude());
        magnitudes.filter(|magnitude| magnitude.is_finite()).fold(0.0, f64::max)
    }
}
