//! `split` of a face by cutters.

use super::{Cutters, SurfaceOrFace};
use crate::{
    diag::{Result, Spanned},
    kernel::Face,
    value::{At, Ctx, op},
};

op! {
    /// All parts into which curves on it, planes, surfaces and solids divide a surface or face.
    ///
    /// Where cutters run is found completely: of planes and surfaces by their exact crossings, so that areas
    /// are those of the true curves. A part goes over the seam of a closed surface as over any other place.
    /// The order of the parts depends on the surface and the cutters alone; `trim` takes the part beside a point. A
    /// cutter that misses the face, ends inside of it, or only touches it, in points or along a line that ends inside,
    /// is an error; a line along which it touches the face from border to border, or around, divides it. A cutter that
    /// lies on the face, on its plane, cylinder, cone, sphere or torus or as a part of its own surface, divides it by
    /// the border of what both have in common; one that lies on all of it, and another surface that runs together with
    /// it, is an error.
    split in Face -> Vec<Face> {
        /// The surface or face.
        s: Spanned<SurfaceOrFace>,
        /// A curve on it, a plane, a surface or face, a solid, or a list of them.
        by: Spanned<Cutters>,
    }
    example "[for f in split(sphere((0, 0), 1), by = plane((0, 0, 0.5), (0, 0, 1))): area(f)] ~= [3*pi, pi]" => "true";
    example "len(split(plane_patch((0, 0), (4, 0), (0, 4)), by = [line((0, 1), (4, 1)), line((1, 0), (1, 4))]))" => "4";
    refuses "split(sphere((0, 0), 1), by = plane((0, 0, 5), (0, 0, 1)))" => "E0607: cutter [0] does not meet the face";
    refuses "split(sphere((0, 0), 1), by = plane((0, 0, 1), (0, 0, 1)))" => "E0607: cutter [0] only touches the face, at (0, 0, 1), so that it divides nothing";
    refuses "split(plane_patch((0, 0), (4, 0), (0, 4)), by = line((1, 1), (3, 3)))" => "E0607: a curve ends inside of the face at (1, 1, 0), so that it divides nothing";
    scene r#"
        faces parts = split(sphere((0, 0), 2), by = [plane((0, 0, 1), (0, 0, 1)), cylinder((1.2, 0, -3), 0.5, 6)])
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Face>> {
    let face = args.s.value.face(args.s.span, ctx.tolerance)?;
    face.split(&args.by.value.cutters, ctx.tolerance).at(args.by.span)
}
