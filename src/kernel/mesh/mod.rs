//! Meshes: triangles, and faces made of them.
//!
//! This file has the type; `grid` makes a mesh of a surface by counts, `tessellate` by a tolerance, `any` of functions too, `polygons` of faces, `planar` of regions, both by a `triangulation`;
//! `faces` are the runs of triangles that stand for faces of more than three corners, and `quadrilaterals` pairs triangles to such. For the latter `bend` bounds derivatives, by the `reach` of
//! the hulls of `quotient`, or of the two curves of `homothetic`; `cell_bounds` makes of them `rules` for each piece, `compact_rules` where they are gone through many times, `form`s of what a
//! cell may be, `near` those along its normal, and `unfolding` those in a plane; `steps` lays the lines of a `surface_patch`, `seam` finds what the `edge`s of patches share, `division` divides that, `passing` for many
//! patches, and `stitch` makes the triangles, of a `ball` in `ball_rows` as `ball_mesh` does; `trimmed` those of parts of a surface, whose borders are the `legs` of arcs and come together where
//! they are `pinched`, and of which the `grid_core` is even cells. `weld` tells which vertices are one place, `places_along` which are in a box, `topology` how the triangles hang together,
//! `orient` which of them face inward, over `numbered_places`, `measure` area, volume and their centres, `deviation` how far one is from a surface, `distance` how far a place is from one,
//! `nearest` the same for many places, `fault` why a mesh encloses nothing, `crossing` where it goes through itself, `section` where a plane cuts it; `boolean` combines closed ones, whose parts
//! `nesting` looks through, and takes away what of them is `flattened`.

mod alike;
mod any;
mod arc_places;
mod ball;
mod ball_mesh;
mod ball_rows;
mod bend;
mod boolean;
mod cell_bounds;
mod chord;
mod coincident;
mod compact_rules;
mod crossing;
mod deviation;
mod distance;
mod division;
mod edge;
mod even_plane;
mod faces;
mod fault;
mod flattened;
mod form;
mod grid;
mod grid_core;
mod homothetic;
mod legs;
mod manifold_body;
mod measure;
mod near;
mod nearest;
mod nesting;
mod numbered_places;
mod orient;
mod outline;
mod passing;
mod pinched;
mod places_along;
mod planar;
mod polygons;
mod quadrilaterals;
mod quotient;
mod reach;
mod rules;
mod seam;
mod section;
mod steps;
mod stitch;
mod surface_patch;
mod tessellate;
mod topology;
mod triangulation;
mod trimmed;
mod turns;
mod unfolding;
mod weld;

use glam::{DAffine3, DMat3, DVec2, DVec3};

use super::{Bounds, CountError, GeomError, InputError, frame::unit, tolerance::UNIT_SLACK};

pub use any::{grid_mesh_any, tessellate_any, tessellate_curve_any};
pub(crate) use arc_places::BorderVertex;
pub use cell_bounds::TessellationOptions;
pub(crate) use crossing::{CommonWeights, TriangleMeeting};
pub use distance::distance_to_polyline;
pub use fault::{FaceFault, MeshError};
pub use grid::grid_mesh;
pub use nearest::MeshDistance;
pub use orient::facing_inward;
pub(crate) use pinched::drop_opposite_triangles;
pub(crate) use places_along::PlacesAlong;
pub use planar::planar_mesh;
pub use polygons::{polygon_mesh, split_polygon};
pub(super) use tessellate::check_rounding;
pub(crate) use tessellate::tessellate_through;
pub use tessellate::{
    tessellate, tessellate_all, tessellate_curve, tessellate_finely, tessellation_parameters,
};
pub use topology::{MeshCheck, Topology};
pub(crate) use trimmed::{PartLoops, PartsTessellation, tessellate_parts};
pub(crate) use weld::welded;

/// Triangles over shared vertices, counter-clockwise seen from the side of the normals.
///
/// A vertex has one normal, one parameter pair and one colour: where a surface has a crease or a
/// seam, two vertices or more stand at one place.
///
/// A face is a run of triangles that make one polygon: of one triangle unless `face_sizes` tell.
///
/// Invariants: finite vertices; a unit normal, a parameter pair and a colour for each vertex, or
/// none at all; triangles name vertices that exist; faces and groups hold all triangles, or there are
/// none; the triangles of a face go once around its corners.
///
/// The tetrahedron of the unit vectors has the volume 1/6:
///
/// ```
/// use virote_kernel::{glam::DVec3, polygon_mesh};
///
/// let vertices = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
/// let faces = [vec![0, 2, 1], vec![0, 1, 3], vec![0, 3, 2], vec![1, 2, 3]];
/// let mesh = polygon_mesh(vertices, &faces, 4)?;
/// assert!((mesh.volume() - 1.0 / 6.0).abs() < 1e-15);
/// assert!((mesh.area() - (1.5 + 0.75_f64.sqrt())).abs() < 1e-15);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Mesh {
    vertices: Vec<DVec3>,
    normals: Vec<DVec3>,
    uvs: Vec<DVec2>,
    colors: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    face_sizes: Vec<u32>,
    groups: Vec<MeshGroup>,
}

/// Triangles that belong together, one behind the other.
///
/// ```
/// use virote_kernel::{MeshGroup, Mesh, glam::DVec3};
///
/// let flat = Mesh::new(vec![DVec3::ZERO, DVec3::X, DVec3::Y], vec![], vec![], vec![[0, 1, 2]])?;
/// let named = flat.in_group("floor");
/// assert_eq!(named.groups(), [MeshGroup { name: "floor".to_owned(), n_triangles: 1 }]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshGroup {
    /// What they are called.
    pub name: String,
    /// How many they are.
    pub n_triangles: usize,
}

impl Mesh {
    /// The mesh of these parts; `normals` and `uvs` may be empty.
    ///
    /// # Errors
    /// [`InputError::NotFinite`], [`CountError::AttributeCount`], [`InputError::NotUnit`],
    /// [`CountError::NoSuchVertex`].
    pub fn new(
        vertices: Vec<DVec3>,
        normals: Vec<DVec3>,
        uvs: Vec<DVec2>,
        triangles: Vec<[u32; 3]>,
    ) -> Result<Self, GeomError> {
        check_attribute("normals", vertices.len(), normals.len())?;
        check_attribute("parameter pairs", vertices.len(), uvs.len())?;
        let finite = |what: &'static str, found: Option<usize>| match found {
            Some(index) => Err(GeomError::Input(InputError::NotFinite { what, index })),
            None => Ok(()),
        };
        finite("vertex", vertices.iter().position(|vertex| !vertex.is_finite()))?;
        finite("parameter pair", uvs.iter().position(|uv| !uv.is_finite()))?;
        for (index, normal) in normals.iter().enumerate() {
            let length = normal.length();
            if !length.is_finite() || UNIT_SLACK < (length - 1.0).abs() {
                return Err(InputError::NotUnit { index, length }.into());
            }
        }
        check_triangles(&triangles, vertices.len())?;
        Ok(Self { vertices, normals, uvs, triangles, ..Self::default() })
    }

    /// The same with a colour for each vertex, red, green and blue from 0 to 1 as screens show them
    /// (sRGB); without colours for none.
    ///
    /// # Errors
    /// [`CountError::AttributeCount`], [`MeshError::BadColor`].
    pub fn with_colors(self, colors: Vec<DVec3>) -> Result<Self, GeomError> {
        check_attribute("colours", self.n_vertices(), colors.len())?;
        let is_color = |color: &DVec3| (0..3).all(|i| 0.0 <= color[i] && color[i] <= 1.0);
        match colors.iter().position(|color| !is_color(color)) {
            Some(index) => Err(MeshError::BadColor { index, color: colors[index] }.into()),
            None => Ok(Self { colors, ..self }),
        }
    }

    /// The same with its triangles in groups, in their order; in none for none.
    ///
    /// # Errors
    /// [`CountError::WrongCount`] unless the groups hold as many triangles as there are.
    pub fn with_groups(self, groups: Vec<MeshGroup>) -> Result<Self, GeomError> {
        let got = groups.iter().fold(0_usize, |sum, group| sum.saturating_add(group.n_triangles));
        let needed = self.n_triangles();
        if !groups.is_empty() && got != needed {
            return Err(CountError::WrongCount { what: "triangles in groups", needed, got }.into());
        }
        Ok(Self { groups, ..self })
    }

    /// The same with all of its triangles in one group.
    #[must_use]
    pub fn in_group(self, name: impl Into<String>) -> Self {
        let groups = vec![MeshGroup { name: name.into(), n_triangles: self.n_triangles() }];
        Self { groups, ..self }
    }

    /// The corners of the triangles.
    #[must_use]
    pub fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// Unit normals, one a vertex, or none at all.
    #[must_use]
    pub fn normals(&self) -> &[DVec3] {
        &self.normals
    }

    /// Parameters on the surface, one pair a vertex, or none at all.
    #[must_use]
    pub fn uvs(&self) -> &[DVec2] {
        &self.uvs
    }

    /// Red, green and blue from 0 to 1 (sRGB), one triple a vertex, or none at all.
    #[must_use]
    pub fn colors(&self) -> &[DVec3] {
        &self.colors
    }

    /// The groups of the triangles, in the order of these; none where nothing is grouped.
    #[must_use]
    pub fn groups(&self) -> &[MeshGroup] {
        &self.groups
    }

    /// Triples of vertex indices.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// How many vertices.
    #[must_use]
    pub fn n_vertices(&self) -> usize {
        self.vertices.len()
    }

    /// How many triangles.
    #[must_use]
    pub fn n_triangles(&self) -> usize {
        self.triangles.len()
    }

    /// The corners of a triangle.
    fn corners_of(&self, triangle: u32) -> [DVec3; 3] {
        self.triangles[triangle as usize].map(|corner| self.vertices[corner as usize])
    }

    /// The parameters of the corners of a triangle of a mesh with parameters.
    pub(crate) fn uvs_of(&self, triangle: u32) -> [DVec2; 3] {
        self.triangles[triangle as usize].map(|corner| self.uvs[corner as usize])
    }

    /// The corners of each triangle.
    pub fn corners(&self) -> impl Iterator<Item = [DVec3; 3]> {
        self.triangles.iter().map(|triangle| triangle.map(|i| self.vertices[i as usize]))
    }

    /// The box around the vertices; none around no vertices.
    #[must_use]
    pub fn bounds(&self) -> Option<Bounds> {
        Bounds::of(self.vertices.iter().copied())
    }

    /// The image under an affine map. Normals stay normal; a mirror turns the triangles round, so
    /// that the outside stays outside; a map that flattens space loses the normals.
    #[must_use]
    pub fn transformed(&self, map: &DAffine3) -> Self {
        let vertices = self.vertices.iter().map(|&vertex| map.transform_point3(vertex)).collect();
        let mirrors = map.matrix3.determinant() < 0.0;
        let cofactors = cofactors(map.matrix3) * if mirrors { -1.0 } else { 1.0 };
        let normals: Option<Vec<DVec3>> =
            self.normals.iter().map(|&normal| unit(cofactors * normal)).collect();
        let turn = |&[a, b, c]: &[u32; 3]| if mirrors { [a, c, b] } else { [a, b, c] };
        let triangles = self.triangles.iter().map(turn).collect();
        Self {
            vertices,
            normals: normals.unwrap_or_default(),
            uvs: self.uvs.clone(),
            colors: self.colors.clone(),
            triangles,
            face_sizes: self.face_sizes.clone(),
            groups: self.groups.clone(),
        }
    }

    /// The same triangles without the vertices that belong to none, the others in their order.
    fn without_strays(self) -> Self {
        let mut is_used = vec![false; self.n_vertices()];
        self.triangles.iter().flatten().for_each(|&corner| is_used[corner as usize] = true);
        if is_used.iter().all(|&is_used| is_used) {
            return self;
        }
        let mut renamed = vec![0; self.n_vertices()];
        let mut n_kept = 0;
        for (name, &is_used) in renamed.iter_mut().zip(&is_used) {
            *name = n_kept;
            n_kept += u32::from(is_used);
        }
        fn kept<T: Copy>(values: &[T], is_used: &[bool]) -> Vec<T> {
            let pairs = values.iter().zip(is_used);
            pairs.filter(|(_, is_used)| **is_used).map(|(value, _)| *value).collect()
        }
        Self {
            vertices: kept(&self.vertices, &is_used),
            normals: kept(&self.normals, &is_used),
            uvs: kept(&self.uvs, &is_used),
            colors: kept(&self.colors, &is_used),
            triangles: self
                .triangles
                .into_iter()
                .map(|corners| corners.map(|corner| renamed[corner as usize]))
                .collect(),
            face_sizes: self.face_sizes,
            groups: self.groups,
        }
    }

    /// All meshes as one, with their groups one behind the other. Normals and parameters only where
    /// every one of them has them; if some have colours, the others are white.
    ///
    /// # Errors
    /// [`CountError::TooManyVertices`] above the ceiling, or beyond what a triangle can name.
    pub fn merged(meshes: &[Self], max_vertices: usize) -> Result<Self, GeomError> {
        let got = meshes.iter().map(Self::n_vertices).sum();
        let most = max_vertices.min(u32::MAX as usize);
        if most < got {
            return Err(CountError::TooManyVertices { got, most }.into());
        }
        let have_normals = meshes.iter().all(|mesh| mesh.normals.len() == mesh.n_vertices());
        let have_uvs = meshes.iter().all(|mesh| mesh.uvs.len() == mesh.n_vertices());
        let have_colors = meshes.iter().any(|mesh| !mesh.colors.is_empty());
        let have_groups = meshes.iter().any(|mesh| !mesh.groups.is_empty());
        let have_faces = meshes.iter().any(|mesh| !mesh.face_sizes.is_empty());
        let mut all = Self::default();
        for mesh in meshes {
            let first = all.n_vertices() as u32;
            all.vertices.extend_from_slice(&mesh.vertices);
            if have_normals {
                all.normals.extend_from_slice(&mesh.normals);
            }
            if have_uvs {
                all.uvs.extend_from_slice(&mesh.uvs);
            }
            all.triangles.extend(mesh.triangles.iter().map(|corners| corners.map(|i| i + first)));
            if have_colors {
                all.colors.extend_from_slice(&mesh.colors);
                all.colors.resize(all.vertices.len(), DVec3::ONE);
            }
            if have_faces {
                all.face_sizes.extend(mesh.runs().map(|run| run.len() as u32));
            }
            if have_groups {
                all.groups.extend_from_slice(&mesh.groups);
                if mesh.groups.is_empty() {
                    let n_triangles = mesh.n_triangles();
                    all.groups.push(MeshGroup { name: String::new(), n_triangles });
                }
            }
        }
        Ok(all)
    }
}

/// The inverse transpose times the determinant, which also exists for flat maps.
fn cofactors(m: DMat3) -> DMat3 {
    let [x, y, z] = [m.x_axis, m.y_axis, m.z_axis];
    DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y))
}

fn check_attribute(what: &'static str, vertices: usize, got: usize) -> Result<(), GeomError> {
    if got == 0 || got == vertices {
        Ok(())
    } else {
        Err(GeomError::Count(CountError::AttributeCount { what, vertices, got }))
    }
}

fn check_triangles(triangles: &[[u32; 3]], vertices: usize) -> Result<(), GeomError> {
    for (triangle, corners) in triangles.iter().enumerate() {
        if let Some(&vertex) = corners.iter().find(|&&vertex| vertices <= vertex as usize) {
            return Err(CountError::NoSuchVertex { triangle, vertex, vertices }.into());
        }
    }
    Ok(())
}
