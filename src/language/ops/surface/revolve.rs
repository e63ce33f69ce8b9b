//! `revolve`: a curve turned about an axis.

use std::f64::consts::TAU;

use glam::DVec3;

use super::check_axis;
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Axis, AxisContact, Curve, NurbsSurface},
    value::{Angle, At, Ctx, op, rounded},
};

op! {
    /// Surface that a curve leaves behind when it is turned about an axis.
    ///
    /// Exact, of a rational curve too: u goes around the axis on 0..1 from the curve's own place, in
    /// equal arcs of at most a quarter turn, v along the curve on its own domain. A positive angle
    /// turns counter-clockwise seen from where the axis points to, a negative one the other way.
    /// An end of the curve on the axis makes a pole. A parametric curve is followed within the document's tolerance.
    /// Piegl & Tiller, *The NURBS Book*, A8.1.
    revolve in Surface -> NurbsSurface {
        /// The curve.
        c: Curve,
        /// The direction of the axis.
        axis: Spanned<DVec3> = Spanned::unplaced(DVec3::Z),
        /// A point of the axis.
        about: DVec3 = DVec3::ZERO,
        /// How far it turns: up to a full turn, either way.
        angle: Spanned<Angle> = Spanned::unplaced(Angle(TAU)),
    }
    example "revolve(line((2, 0), (2, 0, 5)))(0.25, 0.5) ~= (0, 2, 2.5)" => "true";
    example "revolve(line((2, 0), (1, 0, 5)), angle = 90deg).patches" => "[1, 1]";
    example "revolve(line((1, 3), (2, 3)), about = (0, 3), angle = -90deg)(1, 0)" => "(0, 2, 0)";
    refuses "revolve(line((2, 0), (2, 0, 5)), angle = 400deg)" => "E0607: a turn by 400deg goes around more than once";
    refuses "revolve(line((0, 0, 0), (0, 0, 5)))" => "E0607: the curve lies on the axis, so that turning it makes no surface";
    derivative shape;
    picture "revolve(bezier((1, 0, 0), (4, 0, 2), (0, 0, 3), (1, 0, 5)))";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    check_axis(args.axis)?;
    let axis = Axis::new(args.about, args.axis.value).at(args.axis.span_or(ctx.span))?;
    let c = args.c.nurbs_within(ctx.tolerance.distance).at(ctx.span)?;
    let contacts = axis.contacts(&c, ctx.tolerance.distance).at(ctx.span)?;
    let angle = args.angle.value.0;
    let surface = NurbsSurface::revolved(&c, axis, angle);
    let surface = surface.at(args.angle.span_or(ctx.span)).map_err(|mut found| {
        if TAU < angle.abs() {
            let most = if angle < 0.0 { "-1turn" } else { "1turn" };
            found.hints.push(format!("the angle is one full turn at most: `angle = {most}`"));
        }
        found
    })?;
    for contact in contacts {
        if let Some(warning) = axis_warning(contact, ctx) {
            ctx.warn(warning);
        }
    }
    Ok(surface)
}

/// What it means for the surface that the curve comes to the axis between its ends.
fn axis_warning(contact: AxisContact, ctx: &Ctx<'_>) -> Option<Diagnostic> {
    match contact {
        AxisContact::Place { parameter, is_crossing: true } => {
            let message = format!(
                "the curve crosses the axis at t = {}, where the surface passes through itself",
                rounded(parameter)
            );
            let hint = "`trim` the curve there, and turn one side of it";
            Some(Diagnostic::warning(Code::SelfIntersecting, ctx.span, message).hint(hint))
        }
        AxisContact::Place { .. } => None,
        AxisContact::Stretch { start, end } => {
            let message = format!(
                "the curve runs along the axis from t = {} to {}, where the surface has no area",
                rounded(start),
                rounded(end)
            );
            Some(Diagnostic::warning(Code::Unclean, ctx.span, message))
        }
    }
}
