//! `upper`: text in capital letters.

use std::sync::Arc;

use crate::{
    diag::Result,
    value::{Ctx, op},
};

op! {
    /// Text in capital letters.
    upper in Text -> String {
        /// The text.
        text: Arc<str>,
    }
    example "upper(\"Bow 3\")" => "\"BOW 3\"";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<String> {
    Ok(args.text.to_uppercase())
}
