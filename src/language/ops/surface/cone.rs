//! `cone`: the exact circular cone, with or without its tip.

use glam::DVec3;

use super::{around, upward};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::NurbsSurface,
    value::{At, Ctx, Length, op, shortest},
};

op! {
    /// Exact wall of a circular cone as a rational surface on 0..1 in both directions, without its
    /// ends.
    ///
    /// u goes around the axis counter-clockwise, from the place of (1, 0, 0) made normal to the axis,
    /// or of (0, 1, 0) where those are parallel; v goes up from the base. Su × Sv points outward.
    /// A radius of zero makes a tip. Piegl & Tiller, *The NURBS Book*, §8.5.
    cone in Surface -> NurbsSurface {
        /// The centre of its lower circle.
        base: DVec3,
        /// The radius below.
        r0: Spanned<Length>,
        /// The radius above; one of both may be zero.
        r1: Spanned<Length>,
        /// Its height along the axis, positive.
        height: Spanned<Length>,
        /// The direction of its axis.
        axis: Spanned<DVec3> = Spanned::unplaced(DVec3::Z),
    }
    example "cone((0, 0), 3, 0, 4)(0.25, 0.5)" => "(0, 1.5, 2)";
    example "cone((0, 0), 3, 0, 4)(0.5, 1)" => "(0, 0, 4)";
    refuses "cone((0, 0), 0, 0, 4)" => "E0607: both radii are zero, which leaves a line and no cone";
    refuses "cone((0, 0), 3, 1, -4)" => "E0607: the height must be positive, found -4";
    derivative affine;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let mut radii = [0.0; 2];
    for (i, (name, radius)) in [("r0", args.r0), ("r1", args.r1)].into_iter().enumerate() {
        radii[i] = radius.value.0;
        if radii[i] < 0.0 {
            let found = shortest(radii[i]);
            let message = format!("the radius `{name}` must not be negative, found {found}");
            return Diagnostic::error(Code::Degenerate, radius.span, message).fail();
        }
    }
    if radii[0].max(radii[1]) <= 0.0 {
        let message = "both radii are zero, which leaves a line and no cone";
        return Diagnostic::error(Code::Degenerate, args.r1.span, message)
            .also(args.r0.span, "the other one")
            .fail();
    }
    let height = upward(args.height)?;
    let frame = around(args.base, args.axis)?;
    NurbsSurface::cone(frame, radii, height).at(ctx.span)
}
