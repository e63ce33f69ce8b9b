//! Calls of built-ins with numbers and vectors: plain ones that are computed at once, and what is decided by those that carry
//! derivatives.

use crate::{
    diag::Span,
    value::{Call, Dimension, Number, OnNumbers, Op, Real, Switch, Value},
};

/// Arguments up to which a call of numbers alone is computed at once.
const FEW: usize = 4;

/// What an operation on numbers or vectors makes of plain ones that stand by position; none where more care is needed.
pub(super) fn on_few(ops: &[&'static Op], call: &Call) -> Option<Value> {
    let ([op], n) = (ops, call.positional.len()) else { return None };
    if !call.named.is_empty() || !(1..=FEW).contains(&n) {
        return None;
    }
    if let Some(on_vectors) = op.on_vectors {
        let mut args = [&call.positional[0].value; FEW];
        args.iter_mut().zip(&call.positional).for_each(|(to, arg)| *to = &arg.value);
        return on_vectors.of(&args[..n]);
    }
    let of = op.on_numbers?;
    let (mut values, mut dims) = ([0.0; FEW], [Dimension::NONE; FEW]);
    for (arg, (value, dim)) in call.positional.iter().zip(values.iter_mut().zip(&mut dims)) {
        let Value::Number(number) = arg.value else { return None };
        // An angle without a unit may be meant in degrees: it is looked at where it is written.
        if matches!(of, OnNumbers::OfAngle(_))
            && number.dim.is_bare()
            && number.value.fract() == 0.0
        {
            return None;
        }
        (*value, *dim) = (number.value, number.dim);
    }
    let dim = of.dimension(&dims[..n])?;
    let value = of.of(&values[..n]);
    value.is_finite().then_some(Value::Number(Number { value, dim }))
}

/// The arguments that are numbers, where one of them carries derivatives.
pub(super) fn numbers_with_derivatives(call: &Call) -> Vec<Real> {
    let values = call.positional.iter().chain(call.named.iter().map(|(_, value)| value));
    let real = |value: &Value| match value {
        Value::Jet(number) => Some(number.value.clone()),
        Value::Number(number) => Some(Real::Plain(number.value)),
        _ => None,
    };
    let numbers: Vec<Real> = values.filter_map(|arg| real(&arg.value)).collect();
    let varies = numbers.iter().any(|number| matches!(number, Real::Jet(_)));
    if varies { numbers } else { Vec::new() }
}

/// What a built-in decided that answers a number without derivatives to one that carries them, as `floor` does, or
/// one of its arguments, as `max` does, or its opposite.
pub(super) fn switch(asked: &[Real], value: &Value, span: Span) -> Option<Switch> {
    match value {
        Value::Number(number) => {
            let is_own = |real: &Real| *real == Real::Plain(number.value);
            if let Some(chosen) = asked.iter().position(is_own) {
                return Some(Switch { span, state: (chosen + 1) as f64, margin: None });
            }
            // A zero without its sign.
            let margin = asked.iter().find(|real| matches!(real, Real::Jet(_))).cloned()?;
            Some(Switch { span, state: number.value + 0.0, margin: Some(margin) })
        }
        Value::Jet(number) => {
            let own = |real: &Real| *real == number.value || real.scaled(-1.0) == number.value;
            let chosen = asked.iter().position(own)?;
            let sign = if asked[chosen] == number.value { 1.0 } else { -1.0 };
            Some(Switch { span, state: sign * (chosen + 1) as f64, margin: None })
        }
        _ => None,
    }
}
