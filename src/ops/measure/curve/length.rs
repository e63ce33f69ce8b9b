//! `length` of a curve.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::{Interval, NurbsCurve},
    value::{At, Ctx, op},
};

op! {
    /// Arc length of a curve, or of its part over a range of the parameter.
    ///
    /// Gaussian quadrature of |C'| over each polynomial piece, halved until its error is
    /// negligible.
    length in Measure -> f64 {
        /// The curve.
        c: Arc<NurbsCurve>,
        /// The range, inside the curve's domain; all of it when left out.
        range: Option<Spanned<Interval>>,
    }
    example "length(polyline((0, 0), (3, 4), (3, 5)))" => "6";
    example "length(polyline((0, 0), (3, 4), (3, 5)), range = 1..2)" => "1";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    let domain = args.c.domain();
    let interval = match args.range {
        None => domain,
        Some(range) => {
            let start = domain.clamp_inside(range.value.start()).at(range.span)?;
            let end = domain.clamp_inside(range.value.end()).at(range.span)?;
            Interval::new(start, end).at(range.span)?
        }
    };
    Ok(args.c.length(interval))
}
