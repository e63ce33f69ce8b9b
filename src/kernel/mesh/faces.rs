//! Faces of more than three corners, as runs of triangles.
//!
//! A mesh is triangles, and a face is a run of them, one behind the other, whose sides that no other
//! triangle of the run has go once around all corners. So whatever measures, cuts or draws a mesh knows
//! triangles alone, and whoever writes faces finds their corners here.

use super::{Mesh, MeshError, fault::FaceFault};
use crate::{CountError, GeomError};

impl Mesh {
    /// The same with its triangles in faces, in their order: how many triangles each has.
    ///
    /// # Errors
    /// [`CountError::WrongCount`] unless the faces hold as many triangles as there are;
    /// [`MeshError::BadFace`] where the triangles of a face make no polygon.
    pub fn with_faces(self, sizes: Vec<u32>) -> Result<Self, GeomError> {
        let got = sizes.iter().fold(0_usize, |sum, &size| sum.saturating_add(size as usize));
        let needed = self.n_triangles();
        if got != needed {
            return Err(CountError::WrongCount { what: "triangles in faces", needed, got }.into());
        }
        let mesh = self.of_runs(sizes);
        let odd = mesh.runs().position(|run| outline(run).is_none());
        match odd {
            Some(face) => {
                let error = MeshError::BadFace { face, corner: None, fault: FaceFault::NoPolygon };
                Err(error.into())
            }
            None => Ok(mesh),
        }
    }

    /// The same with faces that are known to be polygons.
    pub(super) fn of_runs(self, sizes: Vec<u32>) -> Self {
        let is_of_triangles = sizes.iter().all(|&size| size == 1);
        Self { face_sizes: if is_of_triangles { Vec::new() } else { sizes }, ..self }
    }

    /// How many triangles each face has; none where each triangle is a face.
    #[must_use]
    pub fn face_sizes(&self) -> &[u32] {
        &self.face_sizes
    }

    /// How many faces.
    #[must_use]
    pub fn n_faces(&self) -> usize {
        if self.face_sizes.is_empty() { self.n_triangles() } else { self.face_sizes.len() }
    }

    /// The corners of each face, counter-clockwise seen from outside, beginning with the first of its
    /// first triangle.
    pub fn faces(&self) -> impl Iterator<Item = Vec<u32>> {
        self.runs().filter_map(outline)
    }

    /// The sides of the faces, each once.
    #[must_use]
    pub fn face_edges(&self) -> Vec<[u32; 2]> {
        let mut edges: Vec<[u32; 2]> = if self.face_sizes.is_empty() {
            self.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect()
        } else {
            let sides = |corners: Vec<u32>| {
                let n = corners.len();
                (0..n).map(move |k| [corners[k], corners[(k + 1) % n]])
            };
            self.faces().flat_map(sides).collect()
        };
        edges.iter_mut().for_each(|ends| ends.sort_unstable());
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    /// The triangles of each face.
    pub(super) fn runs(&self) -> impl Iterator<Item = &[[u32; 3]]> {
        let n_alone = if self.face_sizes.is_empty() { self.n_triangles() } else { 0 };
        let sizes = self.face_sizes.iter().copied().chain(std::iter::repeat_n(1, n_alone));
        let mut first = 0;
        sizes.map(move |size| {
            let run = &self.triangles[first..first + size as usize];
            first += run.len();
            run
        })
    }
}

/// The corners around triangles, unless these make no polygon: one way around through all corners.
pub(super) fn outline(run: &[[u32; 3]]) -> Option<Vec<u32>> {
    if let &[corners] = run {
        return Some(corners.to_vec());
    }
    let mut sides: Vec<[u32; 2]> =
        run.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
    sides.sort_unstable();
    let has = |side: &[u32; 2]| sides.binary_search(side).is_ok();
    let border: Vec<[u32; 2]> = sides.iter().copied().filter(|&[a, b]| !has(&[b, a])).collect();
    let start = run.first()?[0];
    let (mut corners, mut at) = (Vec::with_capacity(run.len() + 2), start);
    for _ in 0..border.len() {
        corners.push(at);
        let next = border.partition_point(|side| side[0] < at);
        let [from, to] = *border.get(next)?;
        let is_alone = border.get(next + 1).is_none_or(|side| side[0] != at);
        if from != at || !is_alone {
            return None;
        }
        at = to;
        if at == start {
            break;
        }
    }
    (at == start && corners.len() == border.len() && corners.len() == run.len() + 2)
        .then_some(corners)
}

#[cfg(test)]
mod tests {
    use super::outline;

    #[test]
    fn triangles_that_make_a_polygon_are_told_from_others() {
        assert_eq!(outline(&[[4, 5, 6]]), Some(vec![4, 5, 6]));
        assert_eq!(outline(&[[0, 1, 2], [0, 2, 3]]), Some(vec![0, 1, 2, 3]));
        assert_eq!(outline(&[[1, 2, 3], [3, 0, 1]]), Some(vec![1, 2, 3, 0]));
        assert_eq!(outline(&[[0, 1, 2], [0, 2, 3], [0, 3, 4]]), Some(vec![0, 1, 2, 3, 4]));
        // Apart, touching in a corner, turned against one another, one side thrice, closed.
        assert_eq!(outline(&[[0, 1, 2], [3, 4, 5]]), None);
        assert_eq!(outline(&[[0, 1, 2], [0, 3, 4]]), None);
        assert_eq!(outline(&[[0, 1, 2], [0, 3, 2]]), None);
        assert_eq!(outline(&[[0, 1, 2], [0, 2, 3], [0, 2, 4]]), None);
        assert_eq!(outline(&[[0, 1, 2], [2, 1, 0]]), None);
        assert_eq!(outline(&[]), None);
    }
}
