//! `offset` of a face: the face beside it.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::Face,
    ops::positive,
    value::{At, Ctx, Length, op},
};

op! {
    /// Face at a distance beside another one, on the side of its normal for a positive distance: the part of the offset
    /// of its surface within the same curves of parameters.
    ///
    /// Exact on planes, spheres, cylinders, cones and tori; other surfaces as `offset` of a surface tells. Where the
    /// whole surface has no offset, because of a crease beside the face for one, that of the part around the face is
    /// taken. A distance that passes a centre of curvature is refused.
    offset in Face -> Face {
        /// The face.
        f: Arc<Face>,
        /// The distance; a negative one goes against the normal.
        distance: Spanned<Length>,
        /// How far the result may be from the true offset; otherwise the document's tolerance.
        tolerance: Option<Spanned<Length>>,
    }
    example "area(offset(trim(sphere((0, 0), 1), by = XY, keep = \"above\"), 0.5)) ~= 2*pi*1.5^2" => "true";
    example "centroid(offset(face(region(circle((0, 0), 1))), 2)) ~= (0, 0, 2)" => "true";
    refuses "offset(face(cylinder((0, 0), 1, 3)), -1.5)" => "E0617: an offset by -1.5 passes the centres of curvature, the nearest 1 away, at (0.9304, 0.3667, 0.3757)";
    refuses "offset(face(plane_patch((0, 0), (1, 0), (0, 1))), 1, tolerance = 0)" => "E0607: the tolerance must be positive, found 0";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Face> {
    let tolerance = match args.tolerance {
        Some(length) => ctx.tolerance.with_distance(positive("the tolerance", length)?),
        None => ctx.tolerance,
    };
    args.f.offset(args.distance.value.0, tolerance).at(args.distance.span)
}
