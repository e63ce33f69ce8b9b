//! `format`: a value as text with so many digits, or in a unit.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    value::{Ctx, NumberFormat, Value, op, varies},
};

op! {
    /// Text of a value with its numbers in one format: so many digits behind the point, and a unit.
    ///
    /// In a string `{x:.3}`, `{x:mm}` and `{x:.3mm}` say the same. A number without a unit counts as
    /// document units; an angle is told in degrees unless another unit is given. Numbers of points,
    /// lists and records are written alike, and texts stay as they are.
    format in Text -> String {
        /// A number, or a point, list or record of numbers.
        value: Spanned<Value>,
        /// Digits behind the point; as many as matter unless given.
        digits: Option<Spanned<usize>>,
        /// The unit, such as "mm", "m^2", "1/m" or "deg", which stands behind the number.
        unit: Option<Spanned<Arc<str>>>,
    }
    example "format(pi, digits = 3)" => "\"3.142\"";
    example "format(1.5m, unit = \"cm\")" => "\"150cm\"";
    example "format((1, 2, 3), digits = 1)" => "\"(1.0, 2.0, 3.0)\"";
    example "\"{2/3:.2} of {12.5mm * 40mm:.1cm^2}\"" => "\"0.67 of 5.0cm^2\"";
    refuses "format(30deg, unit = \"mm\")" => "E0303: an angle is not told in `mm`, which is for a length";
    refuses "format(3, unit = \"kg\")" => "E0006: `kg` is no unit that a number could be told in";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<String> {
    if varies(&args.value.value) {
        ctx.caller.made_varying_text();
    }
    let (digits, unit) = (args.digits, args.unit);
    let blamed = unit.as_ref().map(|unit| unit.span).or(digits.map(|digits| digits.span));
    let format = NumberFormat::new(
        digits.map(|digits| digits.value),
        unit.as_ref().map(|unit| &*unit.value),
        ctx.unit,
    );
    let format = format.map_err(|refusal| refusal.at(blamed.unwrap_or(ctx.span)))?;
    format.text(&args.value.value).map_err(|refusal| refusal.at(args.value.span))
}
