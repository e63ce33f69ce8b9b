//! `round`: the nearest whole number, or the nearest of so many digits.

use super::{check_whole, rounded_dim};
use crate::{
    diag::{Result, Spanned},
    value::{Ctx, Dimension, LocallyConstant, Maybe, Number, OnNumbers, op, rounded_to},
};

op! {
    /// The nearest whole number, or the nearest number of so many digits behind the point; halves go
    /// away from zero.
    ///
    /// A quantity is rounded in document units; `round(x / 1in) * 1in` rounds in others.
    round in Math -> Number {
        /// A number that is no angle.
        x: LocallyConstant,
        /// Digits behind the point; where negative, tens, hundreds and so on.
        digits: Maybe<Spanned<i64>>,
    }
    example "round(2.5)" => "3";
    example "round(-2.5)" => "-3";
    example "round(pi, 3)" => "3.142";
    example "round(1234, -2)" => "1200";
    refuses "round(30.26deg, 1)" => "E0303: an angle has no digits of its own: degrees are no radians";
    on_numbers OnNumbers::OneOrTwo {
        one: (rounded_dim, f64::round),
        two: (with_digits, rounded_to_digits),
    };
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Number> {
    let LocallyConstant(x) = args.x;
    check_whole(x, OP.name, ctx.span)?;
    let value = match args.digits.0 {
        None => x.value.round(),
        Some(digits) => rounded_to(x.value, digits.value),
    };
    Ok(Number { value, ..x })
}

/// An angle has no digits of its own.
fn with_digits(x: Dimension, digits: Dimension) -> Option<Dimension> {
    (digits.is_bare() && !x.is_angle()).then_some(x)
}

/// No number where the digits are no whole number.
fn rounded_to_digits(x: f64, digits: f64) -> f64 {
    let digits = Number { value: digits, dim: Dimension::NONE }.as_integer();
    digits.map_or(f64::NAN, |digits| rounded_to(x, digits))
}
