//! `contours`: sections at several levels.

use glam::DVec3;

use super::section_curves;
use crate::{
    diag::{Result, Spanned},
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
    picture "contours(bspline([for i in 0..5: [for j in 0..5: (i, j, sin(i)*cos(j))]]), (0, 0, 1), linspace(-0.5, 0.5, 11))";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    let span = args.direction.span;
    let base = Frame::from_normal(DVec3::ZERO, args.direction.value, None).at(span)?;
    let mut curves = Vec::new();
    for level in args.levels {
        curves.extend(section_curves(ctx, &args.s, base.at(base.z() * level.0))?);
    }
    Ok(curves)
}
