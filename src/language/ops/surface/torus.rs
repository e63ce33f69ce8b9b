//! `torus`: the exact torus.

use glam::DVec3;

use super::around;
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::NurbsSurface,
    ops::radius,
    value::{At, Ctx, Length, op},
};

op! {
    /// Exact torus as a rational surface on 0..1 in both directions.
    ///
    /// u goes around the axis counter-clockwise, from the place of (1, 0, 0) made normal to the axis,
    /// or of (0, 1, 0) where those are parallel; v goes around the tube, from the outer equator
    /// upward. Su × Sv points outward. With the minor radius above the major one the tube passes
    /// through itself, which a warning tells. Piegl & Tiller, *The NURBS Book*, §8.5.
    torus in Surface -> NurbsSurface {
        /// Its centre.
        center: DVec3,
        /// The distance of the middle of the tube from the centre, positive.
        major: Spanned<Length>,
        /// The radius of the tube, positive.
        minor: Spanned<Length>,
        /// The direction of its axis.
        axis: Spanned<DVec3> = Spanned::unplaced(DVec3::Z),
    }
    example "torus((0, 0), 3, 1)(0, 0)" => "(4, 0, 0)";
    example "torus((0, 0), 3, 1)(0.25, 0.25)" => "(0, 3, 1)";
    refuses "torus((0, 0), 3, 0)" => "E0607: the minor radius must be positive, found 0";
    derivative affine;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let major = radius("the major radius", args.major)?;
    let minor = radius("the minor radius", args.minor)?;
    let frame = around(args.center, args.axis)?;
    let torus = NurbsSurface::torus(frame, major, minor).at(ctx.span)?;
    if major < minor {
        let message =
            "the minor radius is above the major one, so that the tube passes through itself";
        ctx.warn(
            Diagnostic::warning(Code::SelfIntersecting, args.minor.span, message)
                .hint("the order is `torus(center, major, minor)`"),
        );
    }
    Ok(torus)
}
