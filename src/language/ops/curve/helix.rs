//! `helix`: the screw line, to the document's tolerance.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Frame, NurbsCurve},
    ops::radius,
    value::{At, Ctx, Length, op},
};

op! {
    /// Helix around the z direction, on 0..1, nowhere further off than the document's tolerance.
    ///
    /// It starts at center + (radius, 0, 0) and runs counter-clockwise, upward for a positive
    /// pitch, with the parameter proportional to the angle. No NURBS curve is a helix: this one
    /// has pieces of degree 5 that share its points and first two derivatives at their ends (C2).
    helix in Curve -> NurbsCurve {
        /// The point of its axis beside which it starts.
        center: DVec3,
        /// Its radius, positive.
        radius: Spanned<Length>,
        /// How far it rises in a turn; below zero it goes down.
        pitch: Length,
        /// How many turns, positive, not necessarily a whole number.
        turns: Spanned<f64>,
    }
    example "helix((0, 0), 2, 3, 1.5).end" => "(-2, 0, 4.5)";
    example "helix((0, 0), 2, 3, 1.5)(1/8) ~= (2*cos(67.5deg), 2*sin(67.5deg), 4.5/8)" => "true";
    refuses "helix((0, 0), 2, 3, 0)" => "E0607: the number of turns must be positive, found 0";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let at_turns = args.turns.span;
    let radius = radius("the radius", args.radius)?;
    let turns = args.turns.value;
    if turns <= 0.0 {
        let message = format!(
            "the number of turns must be positive, found {}",
            crate::value::shortest(turns)
        );
        return Diagnostic::error(Code::Degenerate, at_turns, message)
            .hint("a negative pitch makes the helix go down")
            .fail();
    }
    let frame = Frame::XY.at(args.center);
    let distance = ctx.tolerance.distance;
    NurbsCurve::helix(frame, radius, args.pitch.0, turns, distance).at(ctx.span)
}
