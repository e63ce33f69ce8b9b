//! `pad`: a text of at least so many letters.

use std::sync::Arc;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    limits::Ceiling,
    value::{Choice, Ctx, op},
};

op! {
    /// Text with spaces on one side, so that it has at least so many letters.
    ///
    /// Numbers stand under one another with their spaces on the left: `pad("{x:.2}", 8)`.
    pad in Text -> String {
        /// The text.
        text: Arc<str>,
        /// How many letters it is to have; a longer text stays as it is.
        width: Spanned<usize>,
        /// Where the spaces stand.
        side: PadSide = PadSide::Left,
        /// What stands there instead of a space: one letter.
        fill: Option<Spanned<Arc<str>>>,
    }
    example "pad(\"7.5\", 6)" => "\"   7.5\"";
    example "pad(\"bow\", 6, side = \"right\")" => "\"bow   \"";
    example "pad(\"7\", 3, fill = \"0\")" => "\"007\"";
    refuses "pad(\"7\", 3, fill = \"ab\")" => "E0502: the letter that fills is one, found \"ab\"";
}

/// Where the letters that fill stand.
#[derive(Clone, Copy, PartialEq)]
enum PadSide {
    Left,
    Right,
}

impl Choice for PadSide {
    const WORDS: &'static [&'static str] = &["left", "right"];
    const MEANINGS: &'static [Self] = &[Self::Left, Self::Right];
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<String> {
    let fill = match &args.fill {
        None => ' ',
        Some(fill) => {
            let mut letters = fill.value.chars();
            match (letters.next(), letters.next()) {
                (Some(letter), None) => letter,
                _ => {
                    let message = format!("the letter that fills is one, found \"{}\"", fill.value);
                    return Diagnostic::error(Code::Domain, fill.span, message).fail();
                }
            }
        }
    };
    let missing = args.width.value.saturating_sub(args.text.chars().count());
    let most = ctx.limits.text_bytes;
    if most < args.text.len().saturating_add(missing.saturating_mul(fill.len_utf8())) {
        let message = format!("a text of more than {most} bytes");
        return Diagnostic::error(Code::TooLarge, args.width.span, message)
            .crossing(Ceiling::TEXT_BYTES)
            .fail();
    }
    let spaces = || String::from_iter(std::iter::repeat_n(fill, missing));
    Ok(match args.side {
        PadSide::Left => spaces() + &args.text,
        PadSide::Right => args.text.to_string() + &spaces(),
    })
}
