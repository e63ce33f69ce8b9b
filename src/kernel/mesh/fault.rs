//! Why a mesh encloses nothing, or cannot be as it is asked to.

use glam::DVec3;
use thiserror::Error;

use crate::error::few_digits;

/// What is wrong with a mesh.
///
/// ```
/// use virote_kernel::{GeomError, Mesh, MeshError, Tolerance, glam::DVec3};
///
/// // One triangle encloses nothing.
/// let flat = Mesh::new(vec![DVec3::ZERO, DVec3::X, DVec3::Y], vec![], vec![], vec![[0, 1, 2]])?;
/// let found = flat.check_solid(Tolerance::DEFAULT);
/// assert!(matches!(found, Err(GeomError::Mesh(MeshError::Open { edges: 3, loops: 1, .. }))));
/// # Ok::<(), GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum MeshError {
    /// A colour that no screen shows.
    #[error(
        "colour {index} is ({}, {}, {}); red, green and blue are from 0 to 1",
        color.x, color.y, color.z
    )]
    BadColor { index: usize, color: DVec3 },
    /// A face that is no polygon over the vertices: which, and which of its corners is wrong.
    #[error("face {face} {fault}")]
    BadFace { face: usize, corner: Option<usize>, fault: FaceFault },
    /// A mesh or polygon that should be nearer to its geometry than places can be told apart.
    #[error(
        "the tolerance {} cannot be kept: places of this geometry are rounded by up to {}",
        few_digits(*tolerance), few_digits(*rounding)
    )]
    BelowRounding { tolerance: f64, rounding: f64 },
    /// A mesh whose triangles cross one another, or lie on one another.
    #[error("the mesh crosses itself at {}", place(*at))]
    CrossesItself { at: DVec3 },
    /// A mesh with a part that lies inside of another one and faces as that does.
    #[error(
        "the part of the mesh at {} lies in another one that faces as it does, so that there the mesh encloses places twice",
        place(*at)
    )]
    Doubled { at: DVec3 },
    /// A mesh that faces inward.
    #[error("the triangles of the mesh face inward at {}", place(*at))]
    Inverted { at: DVec3 },
    /// One of several meshes.
    #[error("mesh [{index}]: {fault}")]
    OfSeveral { index: usize, fault: Box<MeshError> },
    /// A mesh with an edge of one triangle.
    #[error(
        "the mesh does not close: it has {} around {}, from {} on",
        counted(*edges, "edge with one triangle", "edges with one triangle"),
        counted(*loops, "hole", "holes"),
        place(*at)
    )]
    Open { edges: usize, loops: usize, at: DVec3 },
    /// A mesh that is more than one surface around a place.
    #[error(
        "the mesh touches itself at {}; a body has one inside around each point",
        place(*at)
    )]
    Pinched { at: DVec3 },
    /// A mesh to be made that is so.
    #[error(
        "the result would touch itself at {}: a body has one inside around each point",
        place(*at)
    )]
    TouchesItself { at: DVec3 },
    /// A combination of meshes that fails a check of its own.
    #[error(
        "what the meshes have together could not be proven: the volumes of the parts differ from the whole by {}, {} is allowed",
        few_digits(*excess), few_digits(*allowed)
    )]
    Unproven { excess: f64, allowed: f64 },
    /// A mesh whose triangles do not face alike.
    #[error(
        "the triangles of the mesh do not face alike at the edge from {}, so that it has no inside",
        place(*at)
    )]
    Unoriented { at: DVec3 },
}

/// What is wrong with a face.
///
/// ```
/// use virote_kernel::{FaceFault, GeomError, MeshError, glam::DVec3, polygon_mesh};
///
/// let found = polygon_mesh(vec![DVec3::ZERO, DVec3::X], &[vec![0, 1]], 2);
/// let fault = FaceFault::TooFew { got: 2 };
/// let expected = MeshError::BadFace { face: 0, corner: None, fault };
/// assert_eq!(found, Err(GeomError::Mesh(expected)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum FaceFault {
    /// Fewer corners than a triangle has.
    #[error("has {}; a face needs 3 or more", counted(*got, "corner", "corners"))]
    TooFew { got: usize },
    /// A corner at no vertex.
    #[error("names vertex {vertex}; {} {vertices}, counted from 0", if *vertices == 1 { "there is" } else { "there are" })]
    NoVertex { vertex: usize, vertices: usize },
    /// Two corners at one vertex.
    #[error("names vertex {vertex} twice")]
    Repeats { vertex: usize },
    /// Sides that meet between corners.
    #[error("crosses or touches itself, seen along its normal")]
    Crosses,
    /// Triangles that are not one polygon together.
    #[error("is of triangles that make no polygon")]
    NoPolygon,
}

/// `1 hole`, `2 holes`.
fn counted(n: usize, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}

/// A measured point for a message.
fn place(point: DVec3) -> String {
    format!("({}, {}, {})", few_digits(point.x), few_digits(point.y), few_digits(point.z))
}
