//! `inertia` of a solid, or of its skin.

use glam::DVec3;

use super::{check_inside_varies, mass};
use crate::{
    diag::Result,
    ops::measure::{MassOf, inertia_told, varying_inertia},
    value::{At, Ctx, Real, RealSolid, Record, op, with_slopes},
};

op! {
    /// Inertia of a solid about its centroid, or of its faces: `{tensor, moments, axes}` as for surfaces.
    inertia in Solid -> Record {
        /// The solid.
        s: RealSolid,
        /// What is heavy: the inside or the skin.
        of: MassOf = MassOf::Volume,
    }
    example "inertia(solid(box((0, 0, 0), (1, 2, 3)))).moments ~= [2.5, 5, 6.5]" => "true";
    example "gradient(h => inertia(extrude(region(circle((0, 0), 1)), (0, 0, h))).tensor[2][2], 3) ~= pi/2" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let tensor = mass(args.s.plain(), args.of, "inertia", ctx)?.inertia;
    let Some(varied) = args.s.varied() else { return Ok(inertia_told(tensor, args.of)) };
    check_inside_varies("inertia", args.of, ctx)?;
    let second = |d: DVec3, e: DVec3| -> Result<Real> {
        with_slopes(0.0, Some(varied.second_moment_slopes([d, e]))).at(ctx.span)
    };
    varying_inertia(tensor, second, args.of, ctx.span)
}
