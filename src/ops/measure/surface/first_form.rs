//! `first_form` of a surface.

use std::sync::Arc;

use super::inside;
use crate::{
    diag::{Result, Spanned},
    kernel::Surface,
    value::{At, Ctx, Record, Value, op},
};

op! {
    /// Coefficients of the first fundamental form of a surface: `E` = Su·Su, `F` = Su·Sv, `G` = Sv·Sv.
    ///
    /// They measure lengths, angles and areas on the surface. do Carmo, *Differential Geometry of Curves
    /// and Surfaces*, §2-5.
    first_form in Measure -> Record {
        /// The surface.
        s: Surface,
        /// The first parameter, inside the surface's domain.
        u: Spanned<f64>,
        /// The second parameter.
        v: Spanned<f64>,
    }
    example "first_form(bilinear((0, 0), (0, 2), (3, 0), (3, 2)), 0.5, 0.5)" => "{E: 9, F: 0, G: 4}";
    refuses "first_form(plane_patch((0, 0), (1, 0), (0, 1)), 2, 0)" => "E0606: parameter 2 is outside the domain 0..1";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let (u, v) = inside(&args.s, args.u, args.v)?;
    let form = args.s.first_form_at(u, v).at(ctx.span)?;
    let entry = |(label, number)| (Arc::from(label), Value::number(number));
    Ok(Record::new(["E", "F", "G"].into_iter().zip(form).map(entry)))
}
