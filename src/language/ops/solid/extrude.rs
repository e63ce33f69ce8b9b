//! `extrude`: a region moved along a vector.

use std::sync::Arc;

use super::{n_variables, slopes_of, varied_region};
use crate::{
    diag::{Result, Spanned},
    kernel::{RegionWay, Solid, VariedSolid},
    value::{At, Ctx, RealRegion, RealSolid, Vector, op},
};

op! {
    /// Solid that a region passes when it is moved along a vector, with both ends closed.
    ///
    /// Exact: the sides are the surfaces of the region's curves, the ends have its own borders. Its faces are the region where it was, where
    /// it comes to, and a side for each smooth part of its borders. Each hole goes through.
    extrude in Solid -> RealSolid {
        /// The region.
        r: RealRegion,
        /// Where each point of it goes.
        vector: Spanned<Vector>,
    }
    example "extrude(region(circle((0, 0), 1), holes = [circle((0, 0), 0.5)]), (0, 0, 2))" => "solid of 4 faces";
    example "volume(extrude(region(circle((0, 0), 1)), (1, 0, 2))) ~= 2*pi" => "true";
    example "gradient(h => volume(extrude(region(circle((0, 0), 1)), (1, 0, h))), 2) ~= pi" => "true";
    refuses "extrude(region(circle((0, 0), 1)), (1, 0, 0))" => "E0607: the vector leaves the plane of the region by 0, within the tolerance 1e-6, so that nothing is enclosed";
    scene r#"
        region plate = region(polyline([(0, 0), (4, 0), (4, 2), (0, 2)], closed = true), holes = [circle((1, 1), 0.5)])
        solid bracket = extrude(plate, (0, 0, 0.6))
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<RealSolid> {
    let (vector, span) = (args.vector.value.value(), args.vector.span);
    let solid = Arc::new(Solid::extruded(args.r.plain(), vector, ctx.tolerance).at(span)?);
    let Some(n_variables) = n_variables(&args.r, &args.vector.value.coordinates(), span)? else {
        return Ok(RealSolid::Plain(solid));
    };
    let slopes = slopes_of(&args.vector.value, n_variables);
    let region = varied_region(&args.r, n_variables).at(span)?;
    let way = RegionWay::Along(vector, slopes);
    Ok(RealSolid::Varied(Arc::new(VariedSolid::new(solid, region, way))))
}
