//! `replace`: a text with one part instead of another.

use std::sync::Arc;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    limits::Ceiling,
    value::{Ctx, op},
};

op! {
    /// Text with another part wherever one occurs.
    replace in Text -> String {
        /// The text.
        text: Arc<str>,
        /// What is replaced.
        old: Spanned<Arc<str>>,
        /// What stands there instead.
        new: Arc<str>,
    }
    example "replace(\"3,5\", \",\", \".\")" => "\"3.5\"";
    refuses "replace(\"abc\", \"\", \"x\")" => "E0502: nothing is no part of a text that could be replaced";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<String> {
    let old = &*args.old.value;
    if old.is_empty() {
        let message = "nothing is no part of a text that could be replaced";
        return Diagnostic::error(Code::Domain, args.old.span, message).fail();
    }
    let n_bytes = args.text.len() + args.text.matches(old).count() * args.new.len();
    let most = ctx.limits.text_bytes;
    if most < n_bytes {
        let message = format!("a text of more than {most} bytes");
        return Diagnostic::error(Code::TooLarge, ctx.span, message)
            .crossing(Ceiling::TEXT_BYTES)
            .fail();
    }
    Ok(args.text.replace(old, &args.new))
}
