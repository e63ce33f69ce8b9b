//! Boxes in a tree, for whoever looks for those beside a place.

use glam::DVec3;
use smallvec::{SmallVec, smallvec};

use crate::Bounds;

/// As many boxes, or fewer, are asked one by one.
const LEAF: usize = 4;

/// The numbers of boxes, sorted so that those of a node follow one another.
#[derive(Clone, Debug)]
pub(crate) struct BoxTree {
    boxes: Vec<Bounds>,
    numbers: Vec<usize>,
    /// The root first; each node before those below it.
    nodes: Vec<BoxNode>,
}

#[derive(Clone, Copy, Debug)]
struct BoxNode {
    around: Bounds,
    /// Its part of the numbers.
    range: [usize; 2],
    /// The two nodes below it.
    below: Option<[usize; 2]>,
}

impl BoxTree {
    /// O(n log² n).
    pub(crate) fn new(boxes: Vec<Bounds>) -> Self {
        let numbers: Vec<usize> = (0..boxes.len()).collect();
        let mut tree = Self { boxes, numbers, nodes: Vec::new() };
        tree.nodes.extend(tree.node([0, tree.numbers.len()]));
        let mut next = 0;
        while let Some(&BoxNode { around, range: [start, end], .. }) = tree.nodes.get(next) {
            if LEAF < end - start {
                // Cut it in halves across its longest side.
                let size = around.size();
                let axis = (1..3).fold(0, |axis, i| if size[axis] < size[i] { i } else { axis });
                let boxes = &tree.boxes;
                tree.numbers[start..end].sort_by(|&a, &b| {
                    let [a_at, b_at] = [a, b].map(|number| boxes[number].center()[axis]);
                    a_at.total_cmp(&b_at).then(a.cmp(&b))
                });
                let (middle, first) = (start + (end - start) / 2, tree.nodes.len());
                tree.nodes.extend(tree.node([start, middle]));
                tree.nodes.extend(tree.node([middle, end]));
                tree.nodes[next].below = Some([first, first + 1]);
            }
            next += 1;
        }
        tree
    }

    fn node(&self, range: [usize; 2]) -> Option<BoxNode> {
        let own = self.numbers[range[0]..range[1]].iter().map(|&number| self.boxes[number]);
        let around = own.reduce(Bounds::union)?;
        Some(BoxNode { around, range, below: None })
    }

    /// The box of a number.
    pub(crate) fn bounds(&self, number: usize) -> Bounds {
        self.boxes[number]
    }

    /// The numbers of the boxes no further than a distance from a point, along the axes; in their order.
    pub(crate) fn beside(&self, point: DVec3, distance: f64) -> Vec<usize> {
        self.near(Bounds { min: point, max: point }, distance)
    }

    /// The numbers of the boxes no further than a distance from another one, along the axes; in their order.
    pub(crate) fn near(&self, other: Bounds, distance: f64) -> Vec<usize> {
        let mut found = Vec::new();
        self.visit_near(other, distance, |number| found.push(number));
        found.sort_unstable();
        found
    }

    /// Tells the numbers of [`Self::near`], in an order of its own.
    pub(crate) fn visit_near(&self, other: Bounds, distance: f64, mut visit: impl FnMut(usize)) {
        let mut todo: SmallVec<[usize; 32]> = smallvec![0];
        while let Some(node) = todo.pop().and_then(|node| self.nodes.get(node)) {
            if !node.around.is_near(other, distance) {
                continue;
            }
            match node.below {
                Some(below) => todo.extend(below),
                None => {
                    let own = self.numbers[node.range[0]..node.range[1]].iter().copied();
                    own.filter(|&i| self.boxes[i].is_near(other, distance)).for_each(&mut visit);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::BoxTree;
    use crate::Bounds;

    #[test]
    fn all_boxes_beside_a_place_are_found_and_no_others() {
        // Cubes of side 1 about the places of a lattice that leaves gaps of 1.
        let places = (0..343)
            .map(|i| DVec3::new(f64::from(i % 7), f64::from(i / 7 % 7), f64::from(i / 49)) * 2.0);
        let boxes: Vec<Bounds> = places.map(|low| Bounds { min: low, max: low + 1.0 }).collect();
        let tree = BoxTree::new(boxes.clone());
        for (point, distance) in [
            (DVec3::splat(1.5), 0.6),
            (DVec3::splat(4.5), 0.1),
            (DVec3::ZERO, 0.0),
            (DVec3::X * -9.0, 2.0),
        ] {
            let all = boxes.iter().enumerate().filter(|(_, own)| own.contains(point, distance));
            let expected: Vec<usize> = all.map(|(i, _)| i).collect();
            assert_eq!(tree.beside(point, distance), expected);
        }
        assert_eq!(tree.beside(DVec3::splat(1.5), 0.6).len(), 8);
    }

    #[test]
    fn no_boxes_are_beside_no_place() {
        assert!(BoxTree::new(Vec::new()).beside(DVec3::ZERO, 1.0).is_empty());
    }
}
