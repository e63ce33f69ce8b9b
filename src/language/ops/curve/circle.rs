//! `circle`: the exact full circle.

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::{CircleForm, Frame, NurbsCurve},
    ops::radius,
    value::{At, Choice, Ctx, Length, op},
};

op! {
    /// Exact full circle as a rational curve on 0..1.
    ///
    /// It starts at center + radius·x and runs counter-clockwise about the normal, where x is
    /// (1, 0, 0) made normal to the normal, or (0, 1, 0) where those are parallel. The forms trace
    /// the same circle with other control points. Piegl & Tiller, *The NURBS Book*, §7.5.
    circle in Curve -> NurbsCurve {
        /// Its centre.
        center: DVec3,
        /// Its radius, positive.
        radius: Spanned<Length>,
        /// The direction that it runs around.
        normal: Spanned<DVec3> = Spanned::unplaced(DVec3::Z),
        /// Nine points in four quarters, seven on a square or a triangle, or degree 5 without
        /// inner knots.
        form: CircleForm = CircleForm::NinePoint,
    }
    example "circle((0, 0), 2)(0.25)" => "(0, 2, 0)";
    example "circle((0, 0), 2).degree" => "2";
    refuses "circle((0, 0), 0)" => "E0607: the radius must be positive, found 0";
    refuses "circle((0, 0), 1, normal = (0, 0, 0))" => "E0607: the normal has no direction";
    derivative affine;
}

impl Choice for CircleForm {
    const WORDS: &'static [&'static str] = &["9-point", "7-square", "7-triangle", "degree-5"];
    const MEANINGS: &'static [Self] =
        &[Self::NinePoint, Self::SevenSquare, Self::SevenTriangle, Self::DegreeFive];
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let radius = radius("the radius", args.radius)?;
    let frame = Frame::from_normal(args.center, args.normal.value, None).at(args.normal.span)?;
    NurbsCurve::circle(args.center, radius, frame.x(), frame.z(), args.form).at(ctx.span)
}
