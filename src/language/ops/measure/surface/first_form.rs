//! `first_form` of a surface.

use std::sync::Arc;

use super::varying;
use crate::{
    diag::{Result, Spanned},
    ops::face::RealSurfaceOrFace,
    value::{At, Ctx, IntoValue, LengthPower, Real, Record, op},
};

op! {
    /// Coefficients of the first fundamental form of a surface: `E` = Su·Su, `F` = Su·Sv, `G` = Sv·Sv.
    ///
    /// They measure lengths, angles and areas on the surface. do Carmo, *Differential Geometry of Curves
    /// and Surfaces*, §2-5.
    first_form in Measure -> Record {
        /// The surface, or a part of one.
        s: RealSurfaceOrFace,
        /// The first parameter, inside its domain.
        u: Spanned<Real>,
        /// The second parameter.
        v: Spanned<Real>,
    }
    example "first_form(bilinear((0, 0), (0, 2), (3, 0), (3, 2)), 0.5, 0.5)" => "{E: 9, F: 0, G: 4}";
    refuses "first_form(plane_patch((0, 0), (1, 0), (0, 1)), 2, 0)" => "E0606: parameter 2 is outside the domain 0..1";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let ([u, v], varying) = varying::place(&args.s, [&args.u, &args.v], 2, None, ctx.span)?;
    let plain = args.s.first_form_at(u, v).at(ctx.span)?;
    let form = match varying {
        None => plain.map(Real::Plain),
        Some(varying) => varying.first_form().at(ctx.span)?,
    };
    let entry = |((label, number), plain)| {
        let coefficient = LengthPower::<2, _>(Real::with_value(number, plain));
        (Arc::from(label), coefficient.into_value())
    };
    Ok(Record::new(["E", "F", "G"].into_iter().zip(form).zip(plain).map(entry)))
}
