//! Pictures as geometry: sections, contours, and what light shows on a surface.

pub(super) mod contours;
pub(super) mod curvature_map;
pub(super) mod intersect;
pub(super) mod isophotes;
pub(super) mod reflection_lines;
pub(super) mod section;
pub(super) mod section_all;
pub(super) mod section_mesh;
pub(super) mod zebra;

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result},
    kernel::{Frame, LevelSet, NurbsCurve, Surface, SurfaceCurve},
    value::{At, Ctx, shortest},
};

/// The lines of a surface in a plane; of touches in a point, which are no lines, a warning tells.
fn section_curves(ctx: &mut Ctx<'_>, surface: &Surface, plane: Frame) -> Result<Vec<NurbsCurve>> {
    let section = surface.section(plane, ctx.tolerance).at(ctx.span)?;
    Ok(lines(ctx, section, "the plane touches the surface"))
}

/// A curve with what is known of it as one of a surface in a plane.
fn reported(curve: NurbsCurve, surface: &Surface, plane: Frame, ctx: &Ctx<'_>) -> NurbsCurve {
    const OPERATION: &str = "section";
    match surface.nurbs() {
        Ok(nurbs) => {
            let (nurbs, tolerance) = (Arc::clone(nurbs), ctx.tolerance);
            SurfaceCurve::reported_in_plane(curve, nurbs, plane, tolerance, OPERATION)
        }
        Err(_) => SurfaceCurve::reported_without_proof(curve, OPERATION),
    }
}

/// The lines of a set; of its touches a warning tells.
fn lines(ctx: &mut Ctx<'_>, set: LevelSet, what: &str) -> Vec<NurbsCurve> {
    for touch in set.touches {
        let message = format!("{what} at {} only, which is no curve", place_of(ctx, touch));
        ctx.warn(Diagnostic::warning(Code::DegenerateResult, ctx.span, message));
    }
    for place in set.contacts {
        let message = format!(
            "{what} along a line through {}, where they do not cross",
            place_of(ctx, place)
        );
        ctx.warn(Diagnostic::warning(Code::DegenerateResult, ctx.span, message));
    }
    for place in set.uncertain {
        let place = place_of(ctx, place);
        let message =
            format!("{what} so closely near {place} that rounding decides where they cross");
        ctx.warn(Diagnostic::warning(Code::DegenerateResult, ctx.span, message));
    }
    set.curves
}

/// A point for a message, without the digits that the tolerance leaves open.
fn place_of(ctx: &Ctx<'_>, point: DVec3) -> String {
    let [x, y, z] = point.to_array().map(|x| shortest(to_digits(x, ctx.tolerance.distance)));
    format!("({x}, {y}, {z})")
}

/// A coordinate without the digits that the tolerance leaves open.
fn to_digits(x: f64, tolerance: f64) -> f64 {
    let digits = (-libm::log10(tolerance)).clamp(0.0, 12.0) as usize;
    let rounded: f64 = format!("{x:.digits$}").parse().unwrap_or(x);
    // No zero below zero.
    rounded + 0.0
}

/// Of a light at (0, 0, 0).
const NO_LIGHT: &str = "the light has no direction: it is (0, 0, 0)";
