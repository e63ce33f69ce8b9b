//! Boxes around the patches of a spline, and around neighbours of these.

use glam::DVec3;

use crate::Bounds;

/// A binary tree over the grid of patches.
#[derive(Debug)]
pub(super) struct Tree {
    nodes: Vec<Node>,
}

#[derive(Debug)]
struct Node {
    bounds: Bounds,
    below: Below,
}

#[derive(Debug)]
enum Below {
    Children([usize; 2]),
    Patch([usize; 2]),
}

/// A rectangle of patches: the first one along each direction, and behind the last.
type Block = [[usize; 2]; 2];

impl Tree {
    /// The tree over so many patches along each direction, each in its box.
    pub(super) fn new(n: [usize; 2], mut bounds: impl FnMut([usize; 2]) -> Bounds) -> Self {
        let mut tree = Self { nodes: Vec::with_capacity(2 * n[0] * n[1]) };
        tree.add([[0, n[0]], [0, n[1]]], &mut bounds);
        tree
    }

    /// Adds a block, as deep as its size has bits.
    fn add(&mut self, block: Block, bounds: &mut impl FnMut([usize; 2]) -> Bounds) -> usize {
        let counts = block.map(|[first, behind]| behind - first);
        let index = self.nodes.len();
        if counts == [1, 1] {
            let patch = block.map(|[first, _]| first);
            self.nodes.push(Node { bounds: bounds(patch), below: Below::Patch(patch) });
            return index;
        }
        let direction = usize::from(counts[0] < counts[1]);
        let middle = block[direction][0] + counts[direction] / 2;
        let (mut left, mut right) = (block, block);
        (left[direction][1], right[direction][0]) = (middle, middle);
        let nowhere = Bounds { min: DVec3::ZERO, max: DVec3::ZERO };
        self.nodes.push(Node { bounds: nowhere, below: Below::Patch([0, 0]) });
        let children = [self.add(left, bounds), self.add(right, bounds)];
        let [a, b] = children.map(|child| self.nodes[child].bounds);
        self.nodes[index] = Node { bounds: a.union(b), below: Below::Children(children) };
        index
    }

    pub(super) fn root(&self) -> usize {
        0
    }

    pub(super) fn children(&self, node: usize) -> Option<[usize; 2]> {
        match self.nodes[node].below {
            Below::Children(children) => Some(children),
            Below::Patch(_) => None,
        }
    }

    /// The spans of the patch that a node without children stands for.
    pub(super) fn spans(&self, node: usize) -> [usize; 2] {
        match self.nodes[node].below {
            Below::Patch(spans) => spans,
            Below::Children(_) => unreachable!("it has no children"),
        }
    }

    /// How far its box is from `p`, lengths multiplied by `unit`.
    pub(super) fn least(&self, node: usize, p: DVec3, unit: f64) -> f64 {
        let Bounds { min, max } = self.nodes[node].bounds;
        ((p - p.clamp(min, max)) * unit).length()
    }

    /// The largest coordinate of all boxes that are known.
    pub(super) fn magnitude(&self) -> f64 {
        let leaves = self.nodes.iter().filter(|node| matches!(node.below, Below::Patch(_)));
        let magnitudes = leaves.map(|node| node.bounds.magnitude());
        magnitudes.filter(|magnitude| magnitude.is_finite()).fold(0.0, f64::max)
    }
}
