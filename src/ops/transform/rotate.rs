//! `rotate`: geometry turned about an axis.

use glam::{DAffine3, DMat3, DVec3};

use super::{about, apply};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::unit,
    value::{Angle, Ctx, Geometry, op},
};

op! {
    /// Geometry turned about an axis, counter-clockwise seen from the axis's tip.
    rotate in Transform -> Geometry {
        /// What is turned.
        g: Geometry,
        /// By how much.
        angle: Angle,
        /// The direction of the axis.
        axis: Spanned<DVec3> = Spanned::unplaced(DVec3::Z),
        /// A point of the axis.
        about: DVec3 = DVec3::ZERO,
    }
    example "rotate((1, 0), 180deg, about = (2, 0)) ~= (3, 0)" => "true";
    refuses "rotate((1, 0), 90)" => "E0304: `rotate`: `angle` must be an angle, found the number 90";
    refuses "rotate((1, 0), 90deg, axis = (0, 0, 0))" => "E0607: an axis of length zero has no direction";
    picture "[for i in 0..<8: rotate(bezier((1, 0), (2, 1), (3, 0)), i*45deg)]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Geometry> {
    let Some(axis) = unit(args.axis.value) else {
        return Diagnostic::error(
            Code::Degenerate,
            args.axis.span,
            "an axis of length zero has no direction",
        )
        .fail();
    };
    let map = DAffine3::from_mat3(DMat3::from_axis_angle(axis, args.angle.0));
    apply(&args.g, &about(map, args.about), ctx.span)
}
