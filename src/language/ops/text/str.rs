//! `str`: a value as text.

use crate::{
    diag::Result,
    value::{Ctx, Value, op, varies},
};

op! {
    /// Text of a value as `print` shows it; a string stays as it is.
    str in Text -> String {
        /// Any value.
        value: Value,
    }
    example "str(12.5)" => "\"12.5\"";
    example "str(12.5mm)" => "\"12.5mm\"";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<String> {
    if varies(&args.value) {
        ctx.caller.made_varying_text();
    }
    Ok(match &args.value {
        Value::Text(text) => text.to_string(),
        other => other.in_unit(ctx.unit).to_string(),
    })
}
