//! `ellipse`: the exact full ellipse.

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::{CircleForm, Frame, NurbsCurve},
    ops::radius,
    value::{At, Ctx, Length, op},
};

op! {
    /// Exact full ellipse as a rational curve on 0..1: the affine image of a circle.
    ///
    /// It starts at center + rx·x and runs counter-clockwise about the normal, where x is
    /// (1, 0, 0) made normal to the normal unless given, or (0, 1, 0) where those are parallel.
    /// Piegl & Tiller, *The NURBS Book*, §7.5.
    ellipse in Curve -> NurbsCurve {
        /// Its centre.
        center: DVec3,
        /// Its radius along x, positive.
        rx: Spanned<Length>,
        /// Its radius across x, positive.
        ry: Spanned<Length>,
        /// The direction that it runs around.
        normal: Spanned<DVec3> = Spanned::unplaced(DVec3::Z),
        /// The direction of the first radius; its part normal to the normal counts.
        x: Option<Spanned<DVec3>>,
    }
    example "ellipse((0, 0), 4, 3)(0.25)" => "(0, 3, 0)";
    example "ellipse((0, 0), 4, 3, x = (0, 1)).start" => "(0, 4, 0)";
    example "curvature(ellipse((0, 0), 4, 3), 0) ~= 4/9 within 1e-12" => "true";
    refuses "ellipse((0, 0), 4, 0)" => "E0607: the radius `ry` must be positive, found 0";
    refuses "ellipse((0, 0), 4, 3, x = (0, 0, 1))" => "E0607: the x axis is parallel to the normal";
    derivative affine;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let blamed = args.rx.span;
    let radii = [radius("the radius `rx`", args.rx)?, radius("the radius `ry`", args.ry)?];
    let x = args.x.map(|x| x.value);
    let at_axis = args.x.map_or(args.normal.span, |x| x.span);
    let frame = Frame::from_normal(args.center, args.normal.value, x).at(at_axis)?;
    NurbsCurve::ellipse(frame, radii, CircleForm::NinePoint).at(blamed)
}
