//! `num`: text as a number.

use std::sync::Arc;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    value::{Ctx, Number, op},
};

op! {
    /// Number that a text spells. Nobody has said what it measures, as of a coordinate. No derivative passes through a text: where one was made of what is differentiated, it is refused.
    num in Text -> Number {
        /// The text, such as "12.5" or "1e-3".
        text: Spanned<Arc<str>>,
    }
    example "num(\"12.5\")" => "12.5";
    refuses "gradient(x => num(\"{x}\")^2, 3)" => "E0503: `num`: no derivative passes through a text, and derivatives are wanted";
    refuses "num(\"12mm\")" => "E0301: \"12mm\" is not a number";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Number> {
    if ctx.caller.has_varying_texts() {
        let message = "`num`: no derivative passes through a text, and derivatives are wanted";
        return Diagnostic::error(Code::NoDerivative, ctx.span, message)
            .label("the text may be made of what is differentiated")
            .hint("`gradient(f, at, differences = true)` does without; `round` makes numbers of so many digits")
            .fail();
    }
    let number = args.text.value.trim().parse::<f64>().ok().filter(|number| number.is_finite());
    number.map(Number::open).ok_or_else(|| {
        let message = format!("\"{}\" is not a number", args.text.value);
        let diagnostic = Diagnostic::error(Code::WrongKind, args.text.span, message);
        let text = args.text.value.trim();
        let with_point = text.replacen(',', ".", 1);
        Box::new(match with_point.parse::<f64>() {
            Ok(number) if number.is_nan() => diagnostic.hint("`none` stands for what is missing"),
            Ok(number) if number.is_infinite() => {
                diagnostic.hint("numbers are finite, at most 1.8e308")
            }
            Ok(_) if text.contains(',') => {
                diagnostic.hint(format!("the decimal sign is a point: \"{with_point}\""))
            }
            _ => diagnostic,
        })
    })
}
