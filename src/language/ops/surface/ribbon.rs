//! Sections that lie along the path of their sweep.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic},
    kernel::{NurbsCurve, Side},
    value::Ctx,
};

/// Points of the section that are looked at.
const N_POINTS: usize = 257;

/// Warns where all of the section lies in one plane with the direction of the path, and not only
/// once beside it: what is swept is then a strip, covered twice or more, instead of a tube. A
/// section that is only moved lies along the path that is given; any other has its x there.
pub(super) fn warn_of_ribbon(ctx: &mut Ctx<'_>, section: &NurbsCurve, moved: Option<&NurbsCurve>) {
    let tolerance = ctx.tolerance.distance;
    let along = match moved {
        None => DVec3::X,
        Some(path) => match path.tangent_at(path.domain().start(), Side::Right) {
            Ok(tangent) => tangent,
            Err(_) => return,
        },
    };
    let Some(across) = shadow(section, along, tolerance) else { return };
    let leaves_plane = |path: &NurbsCurve| {
        let (start, normal) = (path.start(), across.cross(along));
        path.points().iter().any(|p| tolerance < (*p - start).dot(normal).abs())
    };
    if moved.is_some_and(leaves_plane) {
        return;
    }
    let message = "the section lies in one plane with the direction of the path, so that the surface is a strip that covers itself";
    let hint = match moved {
        None => {
            "the section's x lies along the path, its y and z across: draw it in y and z, a circle with `normal = (1, 0, 0)`"
        }
        Some(_) => "\"translate\" leaves the section as it lies: draw it across the path",
    };
    ctx.warn(Diagnostic::warning(Code::DegenerateResult, ctx.span, message).hint(hint));
}

/// The direction in which the section's shadow along a direction runs, if that is a line that
/// the shadow runs along to and fro, or a point.
fn shadow(section: &NurbsCurve, along: DVec3, tolerance: f64) -> Option<DVec3> {
    let flat = |p: DVec3| p - along * p.dot(along);
    let points: Vec<DVec3> = section.sample(N_POINTS).into_iter().map(flat).collect();
    let far = |p: &&DVec3| p.distance(points[0]);
    let farthest = points.iter().max_by(|a, b| far(a).total_cmp(&far(b)))?;
    let Some(across) = (*farthest - points[0]).try_normalize() else { return Some(DVec3::ZERO) };
    if far(&farthest) <= tolerance {
        return Some(across);
    }
    let places: Vec<f64> = points.iter().map(|p| (*p - points[0]).dot(across)).collect();
    let is_line =
        points.iter().zip(&places).all(|(p, &s)| p.distance(points[0] + across * s) <= tolerance);
    let goes_back = |pair: &[f64]| pair[1] < pair[0] - tolerance / N_POINTS as f64;
    (is_line && places.windows(2).any(goes_back)).then_some(across)
}
