//! `assert`: a condition that must hold.

use std::sync::Arc;

use crate::{
    diag::{Code, Diagnostic, Result},
    value::{Ctx, op},
};

op! {
    /// The condition, if it holds; else an error with the message. For conditions on the arguments of functions; claims about results are for `check`.
    assert in Text -> bool {
        /// What must hold.
        condition: bool,
        /// What to say if it does not.
        message: Arc<str>,
    }
    example "assert(1 < 2, \"numbers are in order\")" => "true";
    refuses "assert(1 > 2, \"numbers are in order\")" => "E0404: the assertion fails: numbers are in order";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<bool> {
    if args.condition {
        return Ok(true);
    }
    Diagnostic::error(
        Code::FailedAssert,
        ctx.span,
        format!("the assertion fails: {}", args.message),
    )
    .fail()
}
