//! Sweeps around corners: what comes from both sides meets in the plane that halves the angle.

use glam::{DVec3, DVec4};

use super::frames::{Axes, FrameRule, Frames, over_corner};
use crate::{
    GeomError, Grid, InputError, Interval, LocalError, NurbsCurve, NurbsSurface, Side,
    frame::{across, unit},
    tolerance::VANISHING_RELATIVE,
};

/// Beside a corner a bent leg is sheared over so many times the section's reach.
const SHEARED: f64 = 3.0;

/// A part of a path with its frames.
pub type PathLeg = (NurbsCurve, Frames);

/// The path cut at its corners, each part with its frames, which are carried over the corners by
/// the smallest turn and slide the section into the planes that halve them. With `is_closed` there
/// is a corner at the seam too. `reach` is how far the section reaches from the path.
///
/// # Errors
/// [`LocalError::VanishingTangent`] where the path turns straight back; those of [`Frames::new`].
pub fn legs(
    path: &NurbsCurve,
    corners: &[f64],
    rule: FrameRule,
    up: DVec3,
    is_closed: bool,
    reach: f64,
) -> Result<Vec<PathLeg>, GeomError> {
    let domain = path.domain();
    let cuts = [&[domain.start()], corners, &[domain.end()]].concat();
    let last = cuts.len() - 2;
    let normal = |before: f64, behind: f64| {
        let both = [path.tangent_at(before, Side::Left)?, path.tangent_at(behind, Side::Right)?];
        let sum = both[0] + both[1];
        if sum.length() <= VANISHING_RELATIVE.sqrt() {
            return Err(GeomError::from(LocalError::VanishingTangent { parameter: before }));
        }
        Ok(sum)
    };
    let mut up = up;
    let mut legs = Vec::with_capacity(last + 1);
    for (k, ends) in cuts.windows(2).enumerate() {
        let part = path.trimmed(Interval::new(ends[0], ends[1])?)?;
        let mut frames = Frames::new(&part, rule, up, false)?;
        let axes = frames.last();
        if k < last || is_closed {
            let behind = if k < last { ends[1] } else { domain.start() };
            frames = frames.with_corner(1, normal(ends[1], behind)?, SHEARED * reach);
        }
        if 0 < k || is_closed {
            let before = if 0 < k { ends[0] } else { domain.end() };
            frames = frames.with_corner(0, normal(before, ends[0])?, SHEARED * reach);
        }
        if k < last && rule == FrameRule::RotationMinimizing {
            up = over_corner(axes, path.tangent_at(ends[1], Side::Right)?).z;
        }
        legs.push((part, frames));
    }
    Ok(legs)
}

/// Points of a mitred section that are looked at.
const N_POINTS: usize = 257;

/// By how much each leg of a [`mitred`] polygon is shortened by its mitres where that is most, over
/// the length that there is for it: above 1 the surface crosses itself there. With the leg's
/// parameters.
#[must_use]
pub fn overreaches(surface: &NurbsSurface, path: &NurbsCurve) -> Vec<(f64, [f64; 2])> {
    let lines = surface.domain_u().steps(N_POINTS - 1);
    let corners = path.knots().breaks();
    let rows = surface.points_on_grid(&lines, &corners);
    let each = corners.windows(2).enumerate().map(|(k, ends)| {
        let leg = path.point_at(ends[1]) - path.point_at(ends[0]);
        let advance = |i: usize| (rows.get(i, k + 1) - rows.get(i, k)).dot(leg);
        let least = (0..lines.len()).map(advance).fold(f64::INFINITY, f64::min);
        (1.0 - least / leg.length_squared(), [ends[0], ends[1]])
    });
    each.collect()
}

/// The section along a polygon of degree 1; at each corner it lies in the plane
/// that halves the angle, so that both prisms meet there. A closed polygon has a corner at its
/// seam too.
///
/// # Errors
/// [`LocalError::VanishingTangent`] for a leg of no length or one that turns straight back;
/// [`InputError::ParallelAxes`] for an `up` along the first leg.
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
        unit(corners[k + 1] - corners[k])
            .ok_or(GeomError::Local(LocalError::VanishingTangent { parameter: k as f64 }))
    };
    let legs: Vec<DVec3> = (0..n_legs).map(leg).collect::<Result<_, _>>()?;
    let x = legs[0];
    let z = across(up, x).ok_or(GeomError::Input(InputError::ParallelAxes {
        first: "the path",
        second: "the direction up",
    }))?;
    let mut axes = Axes { x, y: z.cross(x), z };
    let mut columns: Vec<Vec<DVec4>> = Vec::with_capacity(n_legs + 1);
    for (k, &corner) in corners.iter().enumerate() {
        let before = if k == 0 { n_legs - 1 } else { k - 1 };
        let behind = if k == n_legs { 0 } else { k };
        let is_end = !is_closed && (k == 0 || k == n_legs);
        let normal = if is_end { axes.x } else { legs[before] + legs[behind] };
        if normal.length() <= VANISHING_RELATIVE.sqrt() {
            return Err(LocalError::VanishingTangent { parameter: k as f64 }.into());
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
