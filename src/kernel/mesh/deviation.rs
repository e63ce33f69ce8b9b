//! How far a mesh is from a surface, or from another mesh.

use glam::DVec3;

use super::Mesh;
use crate::{
    Deviation, DeviationReference, GeomError, ceiling::TRIANGLE_CLIMB_STEPS,
    numeric::pattern_search::climbed, sorting::sort_by,
};

/// Triangles in which the farthest place is searched: those with the farthest middles.
const SEARCHED: usize = 16;

impl Mesh {
    /// How far it is from a surface or from another mesh: its vertices, the middles of its edges and of its triangles,
    /// and from the farthest of these uphill. `None` of a mesh without triangles.
    ///
    /// The mean is that over the area, by the middles of the edges, which is exact for deviations
    /// that are quadratic over each triangle.
    ///
    /// # Errors
    /// As [`DeviationReference::distance`].
    pub fn deviation_from(
        &self,
        datum: &DeviationReference<'_>,
    ) -> Result<Option<Deviation>, GeomError> {
        let distance = |place: DVec3| datum.distance(place);
        let distances = |places: &mut dyn Iterator<Item = DVec3>| {
            places.map(distance).collect::<Result<Vec<f64>, GeomError>>()
        };
        let of_vertices = distances(&mut self.vertices.iter().copied())?;
        let edges = self.edges();
        let middle =
            |&[a, b]: &[u32; 2]| 0.5 * self.vertices[a as usize] + 0.5 * self.vertices[b as usize];
        let of_edges = distances(&mut edges.iter().map(middle))?;
        let of_middles = distances(&mut self.corners().map(|[a, b, c]| (a + b + c) / 3.0))?;

        let (mut moment, mut area) = (0.0, 0.0);
        let mut farthest: Vec<(f64, usize)> = Vec::with_capacity(self.n_triangles());
        for (i, (triangle, [a, b, c])) in self.triangles.iter().zip(self.corners()).enumerate() {
            let sides = sides_of(triangle).map(|side| edges.binary_search(&side).unwrap_or(0));
            let along = sides.map(|side| of_edges[side]);
            let at_corners = triangle.map(|corner| of_vertices[corner as usize]);
            let places = along.into_iter().chain(at_corners).chain([of_middles[i]]);
            farthest.push((places.fold(0.0, f64::max), i));
            let here = 0.5 * (b - a).cross(c - a).length();
            area += here;
            moment += here * along.into_iter().sum::<f64>() / 3.0;
        }
        sort_by(&mut farthest, |a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let mut most: Option<(f64, DVec3)> = None;
        for &(_, triangle) in farthest.iter().take(SEARCHED) {
            let corners = self.triangles[triangle].map(|i| self.vertices[i as usize]);
            let found = farthest_of(corners, distance)?;
            if most.is_none_or(|most| most.0 < found.0) {
                most = Some(found);
            }
        }
        let mean = if 0.0 < area { moment / area } else { 0.0 };
        Ok(most.map(|(max, at)| Deviation { max, mean, at }))
    }

    /// Each pair of vertices between which a triangle has a side, once, in order.
    fn edges(&self) -> Vec<[u32; 2]> {
        let mut edges: Vec<[u32; 2]> = self.triangles.iter().flat_map(sides_of).collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }
}

fn sides_of(&[a, b, c]: &[u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)])
}

/// The farthest place of a triangle, by steps uphill from the best of seven.
fn farthest_of(
    [a, b, c]: [DVec3; 3],
    distance: impl Fn(DVec3) -> Result<f64, GeomError>,
) -> Result<(f64, DVec3), GeomError> {
    let at = |[x, y]: [f64; 2]| a * (1.0 - x - y) + b * x + c * y;
    let (mut most, mut place) = (f64::NEG_INFINITY, [0.0, 0.0]);
    let third = 1.0 / 3.0;
    let seeds =
        [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.0], [0.0, 0.5], [0.5, 0.5], [third, third]];
    for seed in seeds {
        let here = distance(at(seed))?;
        if most < here {
            (most, place) = (here, seed);
        }
    }
    let ways = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [1.0, -1.0], [-1.0, 1.0]];
    (place, most) = climbed((place, most), [0.25; 2], &ways, TRIANGLE_CLIMB_STEPS, |beside| {
        let is_outside = beside[0] < 0.0 || beside[1] < 0.0 || 1.0 < beside[0] + beside[1];
        Ok::<_, GeomError>(match is_outside {
            true => None,
            false => Some((beside, distance(at(beside))?)),
        })
    })?;
    Ok((most, at(place)))
}
