//! `second_form` of a surface.

use std::sync::Arc;

use super::varying;
use crate::{
    diag::{Result, Spanned},
    ops::face::RealSurfaceOrFace,
    value::{At, Ctx, IntoValue, Length, Real, Record, op},
};

op! {
    /// Coefficients of the second fundamental form of a surface: `L` = n·Suu, `M` = n·Suv, `N` = n·Svv,
    /// with the unit normal n along Su × Sv.
    ///
    /// They are positive where the surface bends to the side of n. At a pole or a collapsed edge n is the
    /// limit, where that exists. do Carmo, *Differential Geometry of Curves and Surfaces*, §3-3.
    second_form in Measure -> Record {
        /// The surface, or a part of one.
        s: RealSurfaceOrFace,
        /// The first parameter, inside its domain.
        u: Spanned<Real>,
        /// The second parameter.
        v: Spanned<Real>,
    }
    example "second_form(bezier([[(-1, -1, 0), (-1, 0, -1), (-1, 1, 0)], [(0, -1, 1), (0, 0, 0), (0, 1, 1)], [(1, -1, 0), (1, 0, -1), (1, 1, 0)]]), 0.5, 0.5)" => "{L: -4, M: 0, N: 4}";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let ([u, v], varying) = varying::place(&args.s, [&args.u, &args.v], 2, None, ctx.span)?;
    let plain = args.s.second_form_at(u, v).at(ctx.span)?;
    let form = match varying {
        None => plain.map(Real::Plain),
        Some(varying) => varying.second_form().at(ctx.span)?,
    };
    let entry = |((label, number), plain)| {
        (Arc::from(label), Length(Real::with_value(number, plain)).into_value())
    };
    Ok(Record::new(["L", "M", "N"].into_iter().zip(form).zip(plain).map(entry)))
}
