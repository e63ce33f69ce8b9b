//! `split` of a text: its parts between separators.

use std::sync::Arc;

use super::super::list::check_length;
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    value::{Ctx, Maybe, op},
};

op! {
    /// Parts of a text between separators, `["a", "b"]` of "a,b".
    ///
    /// Without a separator the words: what stands between white space.
    split in Text -> Vec<String> {
        /// The text.
        text: Arc<str>,
        /// What stands between the parts; white space unless given.
        separator: Maybe<Spanned<Arc<str>>>,
    }
    example "split(\"a, b, c\", \", \")" => "[\"a\", \"b\", \"c\"]";
    example "split(\"  two words \")" => "[\"two\", \"words\"]";
    refuses "split(\"abc\", \"\")" => "E0502: a text is not split at nothing";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<String>> {
    let parts: Vec<String> = match &args.separator.0 {
        None => args.text.split_whitespace().map(str::to_owned).collect(),
        Some(separator) if separator.value.is_empty() => {
            let message = "a text is not split at nothing";
            return Diagnostic::error(Code::Domain, separator.span, message)
                .hint(
                    "give what stands between the parts; `substring(text, k, k + 1)` is one letter",
                )
                .fail();
        }
        Some(separator) => args.text.split(&*separator.value).map(str::to_owned).collect(),
    };
    check_length(parts.len() as f64, ctx)?;
    Ok(parts)
}
