//! `volume` that surfaces enclose.

use super::{RealSurfaces, tell_accuracy};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{SignedVolume, Surface, VariedSurface, signed_volume, stay_closed},
    value::{At, Ctx, LengthPower, Real, Volume, op},
};

op! {
    /// Volume that closed surfaces enclose, or faces whose edges run together.
    ///
    /// The surfaces must close: every edge meets another one within the document's tolerance, or is
    /// collapsed to a point. Which way each of them faces does not matter, and a shell that is turned
    /// inward as a whole is a hole in another.
    ///
    /// The flux of the position through the surfaces by the theorem of Gauss, to some 12 digits.
    /// Mirtich, *Fast and accurate computation of polyhedral mass properties*, JGT 1 (1996).
    volume in Measure -> Volume<Real> {
        /// The surface, or a list of surfaces and faces.
        s: Spanned<RealSurfaces>,
    }
    example "volume(box((0, 0, 0), (1, 2, 3)))" => "6";
    example "volume(parametric((u, v) => (cos(u)*cos(v), sin(u)*cos(v), sin(v)), 0..tau, -pi/2..pi/2))/(4/3*pi) ~= 1 within 1e-12" => "true";
    example "{ let f = trim(sphere((0, 0), 1), by = XY, keep = \"above\")  volume([f, face(region(circle((0, 0), 1)))]) ~= 2*pi/3 within 1e-9 }" => "true";
    refuses "volume(plane_patch((0, 0), (1, 0), (0, 1)))" => "E0612: the surfaces do not close: edge \"u0\" is 0.4896 from the nearest other edge, at (0, 0.5104, 0)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Volume<Real>> {
    let Spanned { value: surfaces, span } = args.s;
    if surfaces.vary() {
        return varying(&surfaces, span, ctx).map(LengthPower);
    }
    let (amount, relative_error) = surfaces.plain.volume(span, ctx)?;
    tell_accuracy("volume", relative_error, ctx)?;
    Ok(LengthPower(Real::Plain(amount)))
}

/// The volume with the slopes that the fluxes through its surfaces have, as long as they stay closed.
fn varying(surfaces: &RealSurfaces, span: Span, ctx: &mut Ctx<'_>) -> Result<Real> {
    let SignedVolume { amount, about, signs, .. } = varying_volume(surfaces, span, "volume", ctx)?;
    let slopes = |idx: usize, varied: &VariedSurface| {
        let mut found = varied.volume_slopes(about)?;
        found.slopes.iter_mut().for_each(|slope| *slope *= signs[idx]);
        Ok(found)
    };
    surfaces.with_slopes(amount, "volume", ctx, slopes)
}

/// The volume that surfaces enclose which vary, as long as they stay closed.
pub(super) fn varying_volume(
    surfaces: &RealSurfaces,
    span: Span,
    what: &str,
    ctx: &mut Ctx<'_>,
) -> Result<SignedVolume> {
    let Some(whole) = surfaces.plain.whole() else {
        let message =
            format!("no derivative passes through a {what} of what faces enclose with surfaces");
        return Diagnostic::error(Code::NoDerivative, span, message)
            .hint("surfaces that close by themselves have one")
            .fail();
    };
    let found = signed_volume(&whole, ctx.tolerance).at(span)?;
    tell_accuracy(what, found.relative_error, ctx)?;
    let varied = surfaces.real.iter().map(|surface| surface.real().varied());
    let varied: Vec<(Surface, Option<&VariedSurface>)> = whole.into_iter().zip(varied).collect();
    if !stay_closed(&varied, ctx.tolerance).at(span)? {
        let message = format!(
            "the surfaces come apart where they vary, so that the {what} has no derivative"
        );
        return Diagnostic::error(Code::NoDerivative, span, message)
            .hint("whatever moves an edge must move the edge that it meets: make both of the same numbers")
            .fail();
    }
    Ok(found)
}
