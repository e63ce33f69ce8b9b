//! Sweeps along polygons: prisms that meet in the planes halfway between their legs.

use glam::{DVec3, DVec4};

use super::frames::{Axes, over_corner};
use crate::kernel::{
    GeomError, Grid, NurbsCurve, NurbsSurface,
    frame::{across, unit},
    tolerance::VANISHING_RELATIVE,
};

/// The section along a polygon of degree 1; at each corner it lies in the plane
/// that halves the angle, so that both prisms meet there. A closed polygon has a corner at its
/// seam too.
///
/// # Errors
/// [`GeomError::VanishingTangent`] for a leg of no length or one that turns straight back;
/// [`GeomError::ParallelAxes`] for an `up` along the first leg.
pub fn mitred(
    section: &NurbsCurve,
    path: &NurbsCurve,
    up: DVec3,
    is_closed: bool,
) -> Result<NurbsSurface, GeomError> {
    let path = path.clamped();
    let corners = path.points();
    let n_legs = corners.len() - 1;
    let leg = |k: usize| {
        unit(corners[k + 1] - corners[k]).ok_or(GeomError::VanishingTangent { parameter: k as f64 })
    };
    let legs: Vec<DVec3> = (0..n_legs).map(leg).collect::<Result<_, _>>()?;
    let x = legs[0];
    let z = across(up, x)
        .ok_or(GeomError::ParallelAxes { first: "the path", second: "the direction up" })?;
    let mut axes = Axes { x, y: z.cross(x), z };
    let mut columns: Vec<Vec<DVec4>> = Vec::with_capacity(n_legs + 1);
    for (k, &corner) in corners.iter().enumerate() {
        let before = if k == 0 { n_legs - 1 } else { k - 1 };
        let behind = if k == n_legs { 0 } else { k };
        let is_end = !is_closed && (k == 0 || k == n_legs);
        let normal = if is_end { axes.x } else { legs[before] + legs[behind] };
        if normal.length() <= VANISHING_RELATIVE.sqrt() {
            return Err(GeomError::VanishingTangent { parameter: k as f64 });
        }
        // Along the leg into the plane of the corner.
        let place = |p: &DVec4| {
            let offset = axes.x * p.x + axes.y * p.y + axes.z * p.z;
            let from_plane = offset - axes.x * p.x;
            let slid = offset - axes.x * (from_plane.dot(normal) / axes.x.dot(normal));
            (corner * p.w + slid).extend(p.w)
        };
        columns.push(section.control_points().iter().map(place).collect());
        if 0 < k && k < n_legs {
            axes = over_corner(axes, legs[k]);
        }
    }
    let net = Grid::from_fn(section.control_points().len(), n_legs + 1, |i, j| columns[j][i]);
    NurbsSurface::new(section.knots().clone(), path.knots().clone(), net)
}
