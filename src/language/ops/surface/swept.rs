//! What is to be said about a swept surface: warnings.

use crate::{
    diag::{Code, Diagnostic},
    kernel::{SweptLeg, SweptSurface},
    value::{Ctx, rounded, shortest},
};

/// Warns of what a sweep cannot promise.
pub(super) fn warn(ctx: &mut Ctx<'_>, made: &SweptSurface) {
    for leg in &made.legs {
        warn_of_leg(ctx, leg);
    }
    warn_of_short_legs(ctx, &made.short_legs);
}

/// Warns of what is on a part of the path.
fn warn_of_leg(ctx: &mut Ctx<'_>, leg: &SweptLeg) {
    if let Some([before, behind]) = leg.flips.first() {
        let message = format!(
            "the frame turns at once near parameter {} of the path",
            rounded(0.5 * (before + behind))
        );
        let hint = "`frame = \"rotation_minimizing\"` does not";
        ctx.warn(Diagnostic::warning(Code::FrameFlip, ctx.span, message).hint(hint));
    }
    if let Some([from, to]) = leg.folds.first() {
        let more = match leg.folds.len() - 1 {
            0 => String::new(),
            1 => ", and along another stretch,".to_owned(),
            n => format!(", and along {n} other stretches,"),
        };
        let message = format!(
            "between the parameters {} and {} of the path{more} the section reaches beyond the centre of curvature, so that the surface crosses itself",
            rounded(*from),
            rounded(*to)
        );
        let hint = "a smaller section, or a path that bends less, does not";
        ctx.warn(Diagnostic::warning(Code::SelfIntersecting, ctx.span, message).hint(hint));
    }
    if let Some(&t) = leg.collapses.first() {
        let message = format!(
            "at parameter {} of the path the section shrinks to a line or a point",
            rounded(t)
        );
        let hint = "a `scale` that stays above zero between the ends keeps the surface regular";
        ctx.warn(Diagnostic::warning(Code::SelfIntersecting, ctx.span, message).hint(hint));
    }
}

/// Tells of legs, by their parameters, that are more than once too short.
fn warn_of_short_legs(ctx: &mut Ctx<'_>, legs: &[(f64, [f64; 2])]) {
    for &(over, [from, to]) in legs {
        if over <= 1.0 {
            continue;
        }
        let message = format!(
            "between the parameters {} and {} the path is {} times too short for the mitres at its ends, so that the surface crosses itself",
            rounded(from),
            rounded(to),
            shortest((100.0 * over).round() / 100.0)
        );
        let hint = "a smaller section, or corners further apart";
        ctx.warn(Diagnostic::warning(Code::SelfIntersecting, ctx.span, message).hint(hint));
    }
}
