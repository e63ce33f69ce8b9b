//! `sphere`: the exact sphere.

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::{Frame, NurbsSurface},
    ops::radius,
    value::{At, Ctx, Length, op},
};

op! {
    /// Exact sphere as a rational surface on 0..1 in both directions.
    ///
    /// u goes around the z direction counter-clockwise from x, in quarters; v goes from the lower
    /// pole to the upper one. Su × Sv points outward. Piegl & Tiller, *The NURBS Book*, §8.5.
    sphere in Surface -> NurbsSurface {
        /// Its centre.
        center: DVec3,
        /// Its radius, positive.
        radius: Spanned<Length>,
    }
    example "sphere((0, 0, 1), 2)(0.25, 0.5)" => "(0, 2, 1)";
    example "sphere((0, 0), 2)(0.7, 1)" => "(0, 0, 2)";
    example "norm(sphere((0, 0), 2)(0.3, 0.2)) ~= 2 within 1e-14" => "true";
    refuses "sphere((0, 0), 0)" => "E0607: the radius must be positive, found 0";
    derivative affine;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let radius = radius("the radius", args.radius)?;
    NurbsSurface::sphere(Frame::XY.at(args.center), radius).at(args.radius.span)
}
