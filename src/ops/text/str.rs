//! `str`: a value as text.

use crate::{
    diag::Result,
    value::{Ctx, Value, op},
};

op! {
    /// Text of a value as `print` shows it; a string stays as it is.
    str in Text -> String {
        /// Any value.
        value: Value,
    }
    example "str(12.5)" => "\"12.5\"";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<String> {
    Ok(match &args.value {
        Value::Text(text) => text.to_string(),
        other => other.to_string(),
    })
}
