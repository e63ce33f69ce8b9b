//! The unit that a file was written in.

use crate::{
    diag::{Code, Diagnostic},
    value::Ctx,
};

/// Warns where a file was written in another unit than the script's.
pub(super) fn compare_units(unit: &str, ctx: &mut Ctx<'_>) {
    if unit == ctx.unit {
        return;
    }
    let message = format!(
        "the file was written in {unit}, and the script's unit is {}: its lengths are taken as they stand",
        ctx.unit
    );
    let hint = "state the file's `unit` in the script, or `scale` what it holds";
    ctx.warn(Diagnostic::warning(Code::Unclean, ctx.span, message).hint(hint));
}
