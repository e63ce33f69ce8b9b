//! That what a parameter allows measures what the parameter does.

use crate::{
    diag::{Code, Diagnostic, Result, Span},
    value::{BARE_AND_ANGLE, Dimension, Number, Range, Value},
};

/// # Errors
/// Ends of another dimension than the parameter.
pub(super) fn check_range(number: Number, range: &Range, place: Span) -> Result<()> {
    let fits = |end: Number| number.beside(end).is_some();
    if fits(range.start) && fits(range.end) {
        return Ok(());
    }
    let message = format!("the range is of another dimension than the parameter, {}", number.dim);
    Diagnostic::error(Code::UnitMismatch, place, message).fail()
}

/// # Errors
/// A step of another dimension than the parameter; one that measures something of a parameter that measures nothing.
pub(super) fn check_step(number: Number, step: Number, place: Span) -> Result<()> {
    let fits = match number.dim.is_bare() {
        true => step.dim.is_bare(),
        false => number.beside(step).is_some(),
    };
    if fits {
        return Ok(());
    }
    mismatch("the step", [step.dim, number.dim], place)
}

/// Messages tell lengths in `unit`.
///
/// # Errors
/// A choice of another dimension than the parameter: it could never be made.
pub(super) fn check_choices(
    number: Number,
    choices: &[Value],
    place: Span,
    unit: &'static str,
) -> Result<()> {
    for choice in choices {
        let Value::Number(its) = choice else { continue };
        if number.beside(*its).is_none() {
            let what = format!("the choice {}", choice.in_unit(unit));
            return mismatch(&what, [its.dim, number.dim], place);
        }
    }
    Ok(())
}

fn mismatch(what: &str, [own, dim]: [Dimension; 2], place: Span) -> Result<()> {
    let message = format!("{what} is {own}, the parameter is {dim}");
    let found = Diagnostic::error(Code::UnitMismatch, place, message);
    let is_bare_angle = own.common(dim).is_some() && own.angle_power() != dim.angle_power();
    if is_bare_angle { found.hint(BARE_AND_ANGLE) } else { found }.fail()
}
