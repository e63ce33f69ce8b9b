//! The edges of a mesh that a drawing needs.

use glam::DVec3;

use super::Mesh;
use crate::Tolerance;

impl Mesh {
    /// The edges at which a drawing shows a line, seen along the direction `toward` the eye: those
    /// without a neighbour, those between triangles that lean from each other by more than `angle`
    /// (radians), and those between a triangle that faces the eye and one that does not.
    #[must_use]
    pub fn outlines(&self, toward: DVec3, angle: f64, tolerance: Tolerance) -> Vec<[DVec3; 2]> {
        let topology = self.topology(tolerance);
        let place = |vertex: u32| self.vertices[vertex as usize];
        let normal = |triangle: &[u32; 3]| {
            let [a, b, c] = triangle.map(place);
            (b - a).cross(c - a).normalize_or_zero()
        };
        let is_smooth = |one: DVec3, other: DVec3| {
            let faces_alike = (one.dot(toward) < 0.0) == (other.dot(toward) < 0.0);
            faces_alike && libm::cos(angle) <= one.dot(other)
        };
        let edges = topology.edges_with_triangles().filter(|(_, triangles)| match triangles[..] {
            [one, other] => !is_smooth(normal(one), normal(other)),
            _ => true,
        });
        edges.map(|(ends, _)| ends.map(place)).collect()
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use crate::{Mesh, Tolerance};

    /// A square roof of four triangles over z = 0, `height` high in the middle.
    fn roof(height: f64) -> Mesh {
        let vertices = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]
            .map(|(x, y)| DVec3::new(x, y, 0.0))
            .into_iter()
            .chain([DVec3::new(1.0, 1.0, height)]);
        let triangles = vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
        Mesh::new(vertices.collect(), Vec::new(), Vec::new(), triangles).unwrap()
    }

    #[test]
    fn a_flat_roof_shows_its_border_and_a_steep_one_its_ridges() {
        let count = |height, toward| roof(height).outlines(toward, 0.5, Tolerance::default()).len();
        assert_eq!(count(0.01, DVec3::Z), 4);
        assert_eq!(count(2.0, DVec3::Z), 8);
        // From beside, two of the four sides are turned away, and two ridges part them.
        assert_eq!(count(0.1, DVec3::new(1.0, 0.5, 0.0)), 6);
    }
}
