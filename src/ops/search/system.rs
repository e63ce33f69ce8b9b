//! `solve` from a start: unknowns for which several functions are zero together.

use super::{
    no_derivatives, six_digits,
    unknowns::{Unknowns, asked, numbers},
};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{LeastSquares, find_least_squares, tolerance::SYSTEM_ROOT_RELATIVE},
    value::{Callback, Ctx, Value},
};

/// The unknowns near the start, and how they were found.
pub(super) fn solved(
    ctx: &mut Ctx<'_>,
    function: &Spanned<Callback>,
    start: &Spanned<Value>,
) -> Result<(Value, LeastSquares)> {
    if ctx.caller.is_varying(&function.value.0) {
        return no_derivatives(function.span);
    }
    let unknowns = Unknowns::new(start)?;
    let mut n_residuals = None;
    let mut ask = |place: &Value| {
        let value = asked(ctx, &function.value, place)?;
        let mut all = Vec::new();
        numbers(&value, function.span, &mut all)?;
        let n_before = *n_residuals.get_or_insert(all.len());
        if all.len() != n_before || all.is_empty() {
            let message = format!(
                "the function yields {} numbers at {place}, and {n_before} before",
                all.len()
            );
            return Diagnostic::error(Code::WrongKind, function.span, message).fail();
        }
        Ok(all.into_iter().map(|number| number.value).collect())
    };
    let found = find_least_squares(
        |values, wanted| unknowns.answers(values, wanted, &mut ask),
        &unknowns.values,
    )?;
    let place = unknowns.with(&found.unknowns);
    let size = |values: &[f64]| values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let (left, first) = (size(&found.residuals), size(&found.first_residuals));
    let is_root = left <= SYSTEM_ROOT_RELATIVE * first;
    let is_overdetermined = unknowns.values.len() < found.residuals.len();
    if is_root || is_overdetermined && found.is_settled {
        return Ok((place, found));
    }
    let message = "no root was found from this start";
    Diagnostic::error(Code::NoAnswer, start.span, message)
        .label(format!("the search ended at {}", unknowns.rounded(&found.unknowns)))
        .hint(format!(
            "of what is to be 0 there is {} left there, of {} at the start; another start may lead to a root",
            six_digits(left, None),
            six_digits(first, None)
        ))
        .fail()
}
