//! `area` of surfaces.

use super::{RealSurfaces, tell_accuracy};
use crate::{
    diag::{Result, Spanned},
    kernel::VariedSurface,
    value::{Area, At, Ctx, LengthPower, Real, op},
};

op! {
    /// Area of a surface or face, or of several together.
    ///
    /// The integral of |Su × Sv|, to some 12 digits where the surface is smooth.
    area in Measure -> Area<Real> {
        /// The surface or face, or a list of them.
        s: Spanned<RealSurfaces>,
    }
    example "area(sphere((0, 0), 1)) ~= 4*pi within 1e-12" => "true";
    example "area(bilinear((0, 0), (0, 2), (3, 0), (3, 2))) ~= 6" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Area<Real>> {
    let Spanned { value: surfaces, span } = &args.s;
    let (mut sum, mut relative_error) = (0.0, 0.0_f64);
    for surface in &surfaces.plain.0 {
        let (area, error) = match surface.is_face() {
            true => {
                let mass = surface.face(*span, ctx.tolerance)?.mass().at(*span)?;
                (mass.amount, mass.relative_error)
            }
            false => surface.area().at(*span)?,
        };
        sum += area;
        relative_error = relative_error.max(error);
    }
    tell_accuracy("area", relative_error, ctx)?;
    let slopes = |_, varied: &VariedSurface| varied.area_slopes();
    surfaces.with_slopes(sum, "area", ctx, slopes).map(LengthPower)
}
