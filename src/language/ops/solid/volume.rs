//! `volume` of a solid.

use super::mass;
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Solid, VariedSolid},
    ops::measure::MassOf,
    value::{At, Ctx, LengthPower, Real, RealSolid, Volume, op, rounded, shortest, with_slopes},
};

op! {
    /// Volume of a solid: the flux of the position through its faces by the theorem of Gauss, to some 12 digits where
    /// they are smooth.
    ///
    /// Edges that are cuts lie on both of their faces within the document's tolerance, and the volume is as near as that
    /// allows: `volume_error` of its `report` is a bound. With `accuracy` edges are compared within ever smaller distances
    /// until the bound is met; a volume that is not known as well is refused.
    volume in Solid -> Volume<Real> {
        /// The solid.
        s: RealSolid,
        /// What the bound of the volume's error may be at most.
        accuracy: Option<Spanned<Volume>>,
    }
    example "volume(solid(box((0, 0, 0), (1, 2, 3))))" => "6";
    example "volume(solid(box((0, 0, 0), (1, 2, 3))), accuracy = 1e-9)" => "6";
    refuses "volume(solid(box((0, 0, 0), (1, 2, 3))), accuracy = 0)" => "E0607: the accuracy must be positive, found 0";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Volume<Real>> {
    if let Some(accuracy) = args.accuracy {
        check_accuracy(args.s.plain(), accuracy, ctx)?;
    }
    let volume = mass(args.s.plain(), MassOf::Volume, "volume", ctx)?.amount;
    let slopes = args.s.varied().map(VariedSolid::volume_slopes);
    with_slopes(volume, slopes).map(LengthPower).at(ctx.span)
}

/// # Errors
/// An accuracy that is not positive, or below what the volume is known within.
fn check_accuracy(solid: &Solid, accuracy: Spanned<Volume>, ctx: &Ctx<'_>) -> Result<()> {
    let wanted = accuracy.value.0;
    if wanted <= 0.0 {
        let message = format!("the accuracy must be positive, found {}", shortest(wanted));
        return Diagnostic::error(Code::Degenerate, accuracy.span, message).fail();
    }
    let known = solid.volume_error_within(wanted, ctx.tolerance).at(ctx.span)?;
    if known <= wanted {
        return Ok(());
    }
    let message = format!(
        "the volume is known within {}, not within {}: by what faces miss one another along their edges, and by rounding",
        rounded(known),
        shortest(wanted)
    );
    Diagnostic::error(Code::BeyondTolerance, accuracy.span, message)
        .hint("a smaller `tolerance` at the top of the script makes cuts whose edges are nearer to their faces")
        .fail()
}
