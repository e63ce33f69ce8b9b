//! `second_form` of a surface.

use std::sync::Arc;

use super::inside;
use crate::{
    diag::{Result, Spanned},
    kernel::Surface,
    value::{At, Ctx, Record, Value, op},
};

op! {
    /// Coefficients of the second fundamental form of a surface: `L` = n·Suu, `M` = n·Suv, `N` = n·Svv,
    /// with the unit normal n along Su × Sv.
    ///
    /// They are positive where the surface bends to the side of n. At a pole or a collapsed edge n is the
    /// limit, where that exists. do Carmo, *Differential Geometry of Curves and Surfaces*, §3-3.
    second_form in Measure -> Record {
        /// The surface.
        s: Surface,
        /// The first parameter, inside the surface's domain.
        u: Spanned<f64>,
        /// The second parameter.
        v: Spanned<f64>,
    }
    example "second_form(bezier([[(-1, -1, 0), (-1, 0, -1), (-1, 1, 0)], [(0, -1, 1), (0, 0, 0), (0, 1, 1)], [(1, -1, 0), (1, 0, -1), (1, 1, 0)]]), 0.5, 0.5)" => "{L: -4, M: 0, N: 4}";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let (u, v) = inside(&args.s, args.u, args.v)?;
    let form = args.s.second_form_at(u, v).at(ctx.span)?;
    let entry = |(label, number)| (Arc::from(label), Value::number(number));
    Ok(Record::new(["L", "M", "N"].into_iter().zip(form).map(entry)))
}
