//! Cells in a plane that do not fold over one another.

use std::f64::consts::PI;

use glam::DVec3;

use super::{Mesh, bend::PieceBounds, form::ParameterBoxes};
use crate::{Grid, tolerance::VANISHING_RELATIVE};

/// Whether a triangle of a plane looks against the normals of its corners, further than by rounding.
pub(super) fn is_folded(mesh: &Mesh) -> bool {
    let far = mesh.vertices.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
    mesh.triangles.iter().any(|corners| {
        let [a, b, c] = corners.map(|corner| mesh.vertices[corner as usize]);
        let (first, second) = (b - a, c - a);
        let rounding = VANISHING_RELATIVE * far * (first.length() + second.length());
        first.cross(second).dot(mesh.normals[corners[0] as usize]) < -rounding
    })
}

/// Whether somewhere in a plane Su has a direction that Sv has somewhere.
pub(super) fn may_fold(pieces: &Grid<PieceBounds>, normal: DVec3) -> bool {
    let Some(first) = pieces.as_slice().first() else { return true };
    let x = first.middle[0];
    let y = normal.cross(x);
    let mut directions = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for bend in pieces {
        for (i, range) in directions.iter_mut().enumerate() {
            let along = bend.middle[i];
            let reach = bend.spread[i] / along.length();
            if 1.0 <= reach || reach.is_nan() {
                return true;
            }
            let (angle, spread) = (libm::atan2(along.dot(y), along.dot(x)), libm::asin(reach));
            *range = [range[0].min(angle - spread), range[1].max(angle + spread)];
        }
    }
    let [u, v] = directions;
    v[0] - u[1] <= 0.0 || PI <= v[1] - u[0]
}

/// Whether lines of constant v or of constant u bend in their plane.
pub(super) fn is_bent(bend: &PieceBounds) -> bool {
    let [along_u, along_v, uu, _, vv] = bend.middle;
    let bends = |along: DVec3, bend: DVec3| {
        VANISHING_RELATIVE * along.length_squared() < along.cross(bend).length()
    };
    bends(along_u, uu) || bends(along_v, vv)
}

/// Whether Su and Sv have different directions all over the piece, by bounds: there only cells fold, not the surface.
pub(super) fn is_regular(bend: &PieceBounds) -> bool {
    let [along_u, along_v, ..] = bend.middle;
    let angle = libm::atan2(along_u.cross(along_v).length(), along_u.dot(along_v));
    let [turn_u, turn_v] = [0, 1].map(|i| libm::asin(bend.spread[i] / bend.middle[i].length()));
    let turn = turn_u + turn_v;
    // No number where one of them may vanish.
    turn < angle && angle + turn < PI
}

/// The boxes over which neither Su nor Sv turns by half of the angle between them.
pub(super) fn unfolded(bend: &PieceBounds) -> ParameterBoxes {
    let [along_u, along_v, uu, uv, vv] = bend.middle;
    let angle = libm::atan2(along_u.cross(along_v).length(), along_u.dot(along_v));
    let room = 0.5 * angle.min(PI - angle);
    let turn = |along: DVec3, bend: DVec3| along.cross(bend).length() / along.length_squared();
    let per_u = turn(along_u, uu).max(turn(along_v, uv)) / room;
    let per_v = turn(along_u, uv).max(turn(along_v, vv)) / room;
    ParameterBoxes { uu: per_u * per_u, uv: per_u * per_v, vv: per_v * per_v }
}
