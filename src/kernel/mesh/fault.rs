//! Why a mesh encloses nothing, or cannot be as it is asked to.

use glam::DVec3;
use thiserror::Error;

use crate::error::few_digits;

/// What is wrong with a mesh.
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum MeshError {
    /// A colour that no screen shows.
    #[error(
        "colour {index} is ({}, {}, {}); red, green and blue are from 0 to 1",
        color.x, color.y, color.z
    )]
    BadColor { index: usize, color: DVec3 },
    /// A mesh or polygon that should be nearer to its geometry than places can be told apart.
    #[error(
        "the tolerance {} cannot be kept: places of this geometry are rounded by up to {}",
        few_digits(*tolerance), few_digits(*rounding)
    )]
    BelowRounding { tolerance: f64, rounding: f64 },
    /// A mesh with an edge of one triangle.
    #[error(
        "the mesh does not close: it has {} around {}, from {} on",
        counted(*edges, "edge with one triangle", "edges with one triangle"),
        counted(*loops, "hole", "holes"),
        place(*at)
    )]
    Open { edges: usize, loops: usize, at: DVec3 },
    /// A mesh whose triangles do not face alike.
    #[error(
        "the triangles of the mesh do not face alike at the edge from {}, so that it has no inside",
        place(*at)
    )]
    Unoriented { at: DVec3 },
}

/// `1 hole`, `2 holes`.
fn counted(n: usize, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}

/// A measured point for a message.
fn place(point: DVec3) -> String {
    format!("({}, {}, {})", few_digits(point.x), few_digits(point.y), few_digits(point.z))
}
