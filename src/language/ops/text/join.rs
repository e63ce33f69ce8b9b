//! `join` of texts: one text of several.

use std::sync::Arc;

use crate::{
    diag::{Code, Diagnostic, Result},
    limits::Ceiling,
    value::{Ctx, op},
};

op! {
    /// One text of several, with a separator between them.
    join in Text -> String {
        /// The texts.
        texts: Vec<Arc<str>>,
        /// What stands between them.
        separator: Arc<str>,
    }
    example "join([\"a\", \"b\", \"c\"], \", \")" => "\"a, b, c\"";
    example "join([for x in [1/3, 2/3]: \"{x:.2}\"], \" and \")" => "\"0.33 and 0.67\"";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<String> {
    let n_bytes = args.texts.iter().map(|text| text.len() + args.separator.len()).sum::<usize>();
    let most = ctx.limits.text_bytes;
    if most < n_bytes {
        let message = format!("a text of more than {most} bytes");
        return Diagnostic::error(Code::TooLarge, ctx.span, message)
            .crossing(Ceiling::TEXT_BYTES)
            .fail();
    }
    Ok(args.texts.join(&args.separator))
}
