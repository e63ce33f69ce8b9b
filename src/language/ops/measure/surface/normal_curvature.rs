//! `normal_curvature` of a surface.

use super::varying;
use crate::{
    diag::{Result, Spanned},
    ops::face::RealSurfaceOrFace,
    value::{At, Ctx, Curvature, LengthPower, Real, Vector, op},
};

op! {
    /// Normal curvature of a surface in a direction: the curvature of its section by the plane of the
    /// normal and that direction.
    ///
    /// Of a direction in space that is not tangent to the surface its part in the tangent plane counts.
    /// A curvature is positive where its centre lies on the side of Su × Sv. do Carmo, *Differential Geometry of
    /// Curves and Surfaces*, §3-2.
    normal_curvature in Measure -> Curvature<Real> {
        /// The surface, or a part of one.
        s: RealSurfaceOrFace,
        /// The first parameter, inside its domain.
        u: Spanned<Real>,
        /// The second parameter.
        v: Spanned<Real>,
        /// A direction of the tangent plane, of any length.
        direction: Spanned<Vector>,
    }
    example "normal_curvature(cylinder((0, 0), 2, 1), 0, 0.5, (0, 1, 0)) ~= -1/2 within 1e-12" => "true";
    example "normal_curvature(cylinder((0, 0), 2, 1), 0, 0.5, (0, 1, 1)) ~= -1/4 within 1e-12" => "true";
    refuses "normal_curvature(plane_patch((0, 0), (1, 0), (0, 1)), 0, 0, (0, 0, 1))" => "E0607: the direction runs along the normal of the surface, so that it has no part in the tangent plane";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Curvature<Real>> {
    let Spanned { value: direction, span } = &args.direction;
    let beside = match direction {
        Vector::Jets(jets) => Some(&jets[0]),
        Vector::Plain(_) => None,
    };
    let ([u, v], varying) = varying::place(&args.s, [&args.u, &args.v], 2, beside, ctx.span)?;
    let shape = args.s.shape_at(u, v).at(ctx.span)?;
    let value = shape.normal_curvature(direction.value(), ctx.tolerance).at(*span)?;
    let Some(at) = varying else { return Ok(LengthPower(Real::Plain(value))) };
    let found = at.forms().and_then(|forms| forms.normal_curvature(&at, direction));
    Ok(LengthPower(found.at(ctx.span)?.with_value(value)))
}
