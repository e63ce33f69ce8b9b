//! Boxes around triangles, in which the nearest of them are found.

use glam::DVec3;

use super::{Mesh, distance::to_triangle};
use crate::{Bounds, work};

/// Triangles of a box that is not divided.
const FEW: usize = 4;

/// A mesh of at least one triangle, prepared to be asked for its distance from places.
///
/// A balanced tree of boxes, halved along their longest side at the median of the middles of the
/// triangles: a node's children are numbers 2i + 1 and 2i + 2.
///
/// ```
/// use virote_kernel::{Mesh, MeshDistance, glam::DVec3};
///
/// let flat = Mesh::new(vec![DVec3::ZERO, DVec3::X, DVec3::Y], vec![], vec![], vec![[0, 1, 2]])?;
/// let Some(tree) = MeshDistance::new(&flat) else { unreachable!("it has a triangle") };
/// assert_eq!(tree.distance(DVec3::new(0.25, 0.25, 2.0)), 2.0);
/// assert_eq!(tree.distance(DVec3::new(4.0, -4.0, 0.0)), 5.0);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Debug)]
pub struct MeshDistance<'a> {
    mesh: &'a Mesh,
    order: Vec<u32>,
    boxes: Vec<Bounds>,
}

impl<'a> MeshDistance<'a> {
    /// The tree over the triangles, in O(n log² n) time; none of a mesh without triangles.
    #[must_use]
    pub fn new(mesh: &'a Mesh) -> Option<Self> {
        let whole = mesh.bounds().filter(|_| 0 < mesh.n_triangles())?;
        let mut order: Vec<u32> = (0..mesh.n_triangles() as u32).collect();
        let mut boxes = Vec::new();
        let mut todo = vec![(0, 0, order.len())];
        while let Some((node, first, behind)) = todo.pop() {
            let part = &mut order[first..behind];
            let corners = part.iter().flat_map(|&triangle| mesh.corners_of(triangle));
            let bounds = Bounds::of(corners).unwrap_or(whole);
            if boxes.len() <= node {
                boxes.resize(node + 1, whole);
            }
            boxes[node] = bounds;
            if part.len() <= FEW {
                continue;
            }
            let size = bounds.size();
            let axis = usize::from(size[0] < size[1]);
            let axis = if size[axis] < size[2] { 2 } else { axis };
            let middle = |triangle: u32| {
                mesh.corners_of(triangle).iter().map(|corner| corner[axis]).sum::<f64>()
            };
            let half = part.len() / 2;
            part.select_nth_unstable_by(half, |&a, &b| {
                middle(a).total_cmp(&middle(b)).then(a.cmp(&b))
            });
            todo.push((2 * node + 1, first, first + half));
            todo.push((2 * node + 2, first + half, behind));
        }
        Some(Self { mesh, order, boxes })
    }

    /// The distance of a place from the nearest triangle.
    #[must_use]
    pub fn distance(&self, place: DVec3) -> f64 {
        let least = |node: usize| {
            let Bounds { min, max } = self.boxes[node];
            place.distance(place.clamp(min, max))
        };
        let mut found = f64::INFINITY;
        let mut todo = vec![(least(0), 0, 0, self.order.len())];
        while work::goes_on(1)
            && let Some((distance, node, first, behind)) = todo.pop()
        {
            if found <= distance {
                continue;
            }
            if behind - first <= FEW {
                for &triangle in &self.order[first..behind] {
                    found = found.min(to_triangle(place, self.mesh.corners_of(triangle)));
                }
                continue;
            }
            let half = first + (behind - first) / 2;
            let left = (least(2 * node + 1), 2 * node + 1, first, half);
            let right = (least(2 * node + 2), 2 * node + 2, half, behind);
            // The nearer one is looked at first.
            todo.extend(if left.0 < right.0 { [right, left] } else { [left, right] });
        }
        found
    }

    /// Goes through the triangles that may meet a box.
    pub(super) fn each_near(&self, around: Bounds, mut visit: impl FnMut(u32)) {
        let mut todo = vec![(0, 0, self.order.len())];
        while let Some((node, first, behind)) = todo.pop() {
            if !self.boxes[node].is_near(around, 0.0) {
                continue;
            }
            if behind - first <= FEW {
                self.order[first..behind].iter().for_each(|&triangle| visit(triangle));
                continue;
            }
            let half = first + (behind - first) / 2;
            todo.extend([(2 * node + 2, half, behind), (2 * node + 1, first, half)]);
        }
    }

    /// How many triangles there are.
    pub(crate) fn n_triangles(&self) -> usize {
        self.order.len()
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::{Mesh, MeshDistance};

    #[test]
    fn the_tree_finds_what_looking_at_all_triangles_finds() {
        let place = |i: u32| {
            let t = f64::from(i);
            DVec3::new(libm::sin(7.1 * t), libm::cos(3.3 * t), libm::sin(5.7 * t))
        };
        let vertices: Vec<DVec3> = (0..120).map(place).collect();
        let triangles = (0..118).map(|i| [i, i + 1, i + 2]).collect();
        let mesh = Mesh::new(vertices, Vec::new(), Vec::new(), triangles).unwrap();
        let nearest = MeshDistance::new(&mesh).unwrap();
        for i in 200..300 {
            let place = 1.5 * place(i);
            assert_eq!(Some(nearest.distance(place)), mesh.distance_to(place));
        }
    }
}
