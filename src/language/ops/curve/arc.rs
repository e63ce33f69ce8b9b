//! `arc`: an arc of a circle by its angles.

use std::f64::consts::TAU;

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Frame, NurbsCurve, tolerance::KNOT_RELATIVE},
    ops::radius,
    value::{Angle, At, Ctx, Length, op},
};

op! {
    /// Exact arc of a circle as a rational curve on 0..1, in equal pieces of at most a quarter
    /// turn.
    ///
    /// It runs counter-clockwise about the normal from the angle `from` up to the angle `to`, or
    /// where that is less up to its next place, once around at most; angles count from x, which is (1, 0, 0) made normal to the normal unless
    /// given, or (0, 1, 0) where those are parallel. Piegl & Tiller, *The NURBS Book*, A7.1.
    arc in Curve -> NurbsCurve {
        /// The centre of its circle.
        center: DVec3,
        /// Its radius, positive.
        radius: Spanned<Length>,
        /// The angle at which it starts.
        from: Spanned<Angle>,
        /// The angle at which it ends; `from + 1turn` makes the full circle.
        to: Spanned<Angle>,
        /// The direction that it runs around.
        normal: Spanned<DVec3> = Spanned::unplaced(DVec3::Z),
        /// The direction of angle zero; its part normal to the normal counts.
        x: Option<Spanned<DVec3>>,
    }
    example "arc((0, 0), 2, 90deg, 180deg).end" => "(-2, 0, 0)";
    example "arc((0, 0), 2, 0deg, 270deg).segments" => "3";
    example "norm(arc((0, 0), 2, 10deg, 100deg)(0.3)) ~= 2 within 1e-15" => "true";
    refuses "arc((0, 0), -2, 0deg, 90deg)" => "E0607: the radius must be positive, found -2";
    refuses "arc((0, 0), 2, 90deg, 90deg)" => "E0607: the arc ends at the angle at which it starts";
    refuses "arc((0, 0), 2, 0deg, 90deg, normal = (0, 0, 0))" => "E0607: the normal has no direction";
    refuses "arc((0, 0), 2, 0, 90deg)" => "E0304: `arc`: `from` must be an angle, found the number 0";
    derivative affine;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let radius = radius("the radius", args.radius)?;
    let x = args.x.map(|x| x.value);
    let blamed = args.x.map_or(args.normal.span, |x| x.span);
    let frame = Frame::from_normal(args.center, args.normal.value, x).at(blamed)?;
    let (from, to) = (args.from.value.0, args.to.value.0);
    let difference = to - from;
    if (1.0 + KNOT_RELATIVE) * TAU < difference {
        return Diagnostic::error(
            Code::Degenerate,
            args.to.span,
            "the arc would go around more than once",
        )
        .hint("an arc ends a full turn after its start at most")
        .fail();
    }
    // Behind the start the next place of that angle is meant.
    let sweep = if difference < 0.0 { difference.rem_euclid(TAU) } else { difference };
    if sweep <= KNOT_RELATIVE * TAU {
        return Diagnostic::error(
            Code::Degenerate,
            args.to.span,
            "the arc ends at the angle at which it starts",
        )
        .hint("for the full circle write `from + 1turn`")
        .fail();
    }
    NurbsCurve::arc(frame, radius, from, sweep.min(TAU)).at(args.radius.span)
}
