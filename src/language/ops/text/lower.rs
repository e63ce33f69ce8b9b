//! `lower`: text in small letters.

use std::sync::Arc;

use crate::{
    diag::Result,
    value::{Ctx, op},
};

op! {
    /// Text in small letters.
    lower in Text -> String {
        /// The text.
        text: Arc<str>,
    }
    example "lower(\"Bow 3\")" => "\"bow 3\"";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<String> {
    Ok(args.text.to_lowercase())
}
