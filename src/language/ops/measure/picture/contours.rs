//! `contours`: sections at several levels.

use glam::DVec3;

use super::section_curves;
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Frame, NurbsCurve, Surface},
    value::{At, Ctx, Length, op},
};

op! {
    /// Curves on a surface along which the height in a direction is one of the levels, in the order of
    /// the levels.
    ///
    /// Heights are lengths along the direction from (0, 0, 0): the planes stand at `level` times the unit
    /// vector. Complete, and of the kind that `section` gives; a level that the surface does not reach
    /// has no curves.
    contours in Measure -> Vec<NurbsCurve> {
        /// The surface.
        s: Surface,
        /// The direction in which the surface is high or low.
        direction: Spanned<DVec3>,
        /// The heights.
        levels: Vec<Length>,
    }
    example "len(contours(sphere((0, 0), 5), (0, 0, 1), [-3, 0, 3, 7]))" => "3";
    example "contours(bilinear((0, 0), (0, 1), (1, 0, 1), (1, 1, 1)), (0, 0, 2), [0.25])[0](0) ~= (0.25, 1, 0.25)" => "true";
    example "contours(sphere((0, 0), 5), (0, 0, 1), [])" => "[]";
    refuses "contours(plane_patch((0, 0), (1, 0), (0, 1)), (0, 0), [1])" => "E0607: the direction (0, 0, 0) is none, so that nothing is high or low";
    scene r#"
        surface s = bspline([for i in 0..5: [for j in 0..5: (i, j, sin(i)*cos(j))]]) with (color = "lightgray")
        curves lines = contours(s, (0, 0, 1), linspace(-0.5, 0.5, 11)) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    let span = args.direction.span;
    if args.direction.value == DVec3::ZERO {
        let message = "the direction (0, 0, 0) is none, so that nothing is high or low";
        return Diagnostic::error(Code::Degenerate, span, message).fail();
    }
    let base = Frame::from_normal(DVec3::ZERO, args.direction.value, None).at(span)?;
    let mut curves = Vec::new();
    for level in args.levels {
        curves.extend(section_curves(ctx, &args.s, base.at(base.z() * level.0))?);
    }
    Ok(curves)
}
