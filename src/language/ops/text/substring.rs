//! `substring`: a part of a text.

use std::sync::Arc;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    value::{Ctx, Maybe, op},
};

op! {
    /// Part of a text from one letter up to another, which is not in it.
    ///
    /// Letters count from 0, and from the end where they are negative, as the elements of a list do.
    substring in Text -> String {
        /// The text.
        text: Arc<str>,
        /// The first letter.
        start: Spanned<i64>,
        /// The letter behind the last; the end of the text unless given.
        end: Maybe<Spanned<i64>>,
    }
    example "substring(\"NACA 2412\", 5)" => "\"2412\"";
    example "substring(\"NACA 2412\", 5, 6)" => "\"2\"";
    example "substring(\"hull.geo\", -4)" => "\".geo\"";
    refuses "substring(\"abc\", 5)" => "E0502: the text has 3 letters, and none at 5";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<String> {
    let n_letters = args.text.chars().count();
    let place = |at: Spanned<i64>| {
        let from_start = if at.value < 0 { at.value + n_letters as i64 } else { at.value };
        usize::try_from(from_start).ok().filter(|&place| place <= n_letters).ok_or_else(|| {
            let letters = if n_letters == 1 { "letter" } else { "letters" };
            let message = format!("the text has {n_letters} {letters}, and none at {}", at.value);
            Box::new(Diagnostic::error(Code::Domain, at.span, message))
        })
    };
    let start = place(args.start)?;
    let end = args.end.0.map_or(Ok(n_letters), place)?;
    Ok(args.text.chars().skip(start).take(end.saturating_sub(start)).collect())
}
