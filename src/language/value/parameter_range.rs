//! Ranges of parameters.

use super::{FromValue, Mismatch, Range, Type, Value};
use crate::{
    diag::{Code, Span},
    kernel::Interval,
};

impl FromValue for Interval {
    const TYPE: Type = Type::Range;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        let range = Range::from_value(value, span)?;
        check_parameters(&range, value)?;
        Self::new(range.start.value, range.end.value)
            .map_err(|err| Mismatch::because(err.to_string(), Code::OutsideDomain))
    }
}

/// That a range is one of parameters, which are no angles: a function would be given plain numbers.
fn check_parameters(range: &Range, value: &Value) -> Result<(), Mismatch> {
    if range.start.dim.angle_power() == 0 && range.end.dim.angle_power() == 0 {
        return Ok(());
    }
    let hint = "parameters are no angles: `0..tau` goes once around, where the function takes `t * 1rad` for one";
    Err(Mismatch::new("a range of plain numbers", value.phrase())
        .code(Code::UnitMismatch)
        .hint(hint))
}

/// A range of a parameter of a curve or surface that there is already: plain numbers, as a parameter is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterRange(pub Interval);

impl FromValue for ParameterRange {
    const TYPE: Type = Type::Range;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        check_plain(&Range::from_value(value, span)?, value)?;
        Interval::from_value(value, span).map(Self)
    }
}

/// That a range is one of parameters of what there is already.
pub(super) fn check_plain(range: &Range, value: &Value) -> Result<(), Mismatch> {
    check_parameters(range, value)?;
    if range.start.dim.is_bare() && range.end.dim.is_bare() {
        return Ok(());
    }
    let hint = "parameters have no unit: that of a curve at a length is `parameter_at_length(c, 5mm)`; where the parameter is meant to be a length, divide by `1mm`";
    Err(Mismatch::new("a range of plain numbers", value.phrase())
        .code(Code::UnitMismatch)
        .hint(hint))
}
