//! What the operators that compute do to numbers, dimensions and derivatives: an item for each.

use super::operand::{OperatorRefusal, Sides};
use crate::{
    kernel::{Enclosure, GeomError, LocalError},
    value::{Dimension, Real},
};

/// What a row of the table is made of.
pub(super) trait ArithmeticMeaning {
    const VERB: &'static str;
    const SIDES: &'static [Sides];
    fn plain(a: f64, b: f64) -> f64;
    fn dimension(
        a: Dimension,
        b: Dimension,
        right: Option<f64>,
    ) -> Result<Dimension, OperatorRefusal>;
    fn refusal(_: f64, _: f64) -> Option<OperatorRefusal> {
        None
    }
    fn derivatives(a: &Real, b: &Real, plain: f64) -> Result<Real, GeomError>;
    fn enclosure(a: &Enclosure, b: &Enclosure) -> Option<Enclosure>;
}

/// The sum.
pub(super) struct Add;

impl ArithmeticMeaning for Add {
    const VERB: &'static str = "added";
    const SIDES: &'static [Sides] = &[Sides::Points];

    #[inline(always)]
    fn plain(a: f64, b: f64) -> f64 {
        a + b
    }

    fn dimension(a: Dimension, b: Dimension, _: Option<f64>) -> Result<Dimension, OperatorRefusal> {
        a.sum(b).ok_or(OperatorRefusal::Mismatch)
    }

    fn derivatives(a: &Real, b: &Real, _: f64) -> Result<Real, GeomError> {
        Ok(a.plus(b))
    }

    fn enclosure(a: &Enclosure, b: &Enclosure) -> Option<Enclosure> {
        Some(a.plus(b))
    }
}

/// The difference.
pub(super) struct Subtract;

impl ArithmeticMeaning for Subtract {
    const VERB: &'static str = "subtracted";
    const SIDES: &'static [Sides] = &[Sides::Points];

    #[inline(always)]
    fn plain(a: f64, b: f64) -> f64 {
        a - b
    }

    fn dimension(a: Dimension, b: Dimension, _: Option<f64>) -> Result<Dimension, OperatorRefusal> {
        a.sum(b).ok_or(OperatorRefusal::Mismatch)
    }

    fn derivatives(a: &Real, b: &Real, _: f64) -> Result<Real, GeomError> {
        Ok(a.minus(b))
    }

    fn enclosure(a: &Enclosure, b: &Enclosure) -> Option<Enclosure> {
        Some(a.plus(&b.negated()))
    }
}

/// The product.
pub(super) struct Multiply;

impl ArithmeticMeaning for Multiply {
    const VERB: &'static str = "multiplied";
    const SIDES: &'static [Sides] = &[Sides::PointByNumber, Sides::NumberByPoint];

    #[inline(always)]
    fn plain(a: f64, b: f64) -> f64 {
        a * b
    }

    fn dimension(a: Dimension, b: Dimension, _: Option<f64>) -> Result<Dimension, OperatorRefusal> {
        a.times(b).ok_or(OperatorRefusal::PowerOfUnitTooHigh)
    }

    fn derivatives(a: &Real, b: &Real, _: f64) -> Result<Real, GeomError> {
        Ok(a.times(b))
    }

    fn enclosure(a: &Enclosure, b: &Enclosure) -> Option<Enclosure> {
        Some(a.times(b))
    }
}

/// The quotient.
pub(super) struct Divide;

impl ArithmeticMeaning for Divide {
    const VERB: &'static str = "divided";
    const SIDES: &'static [Sides] = &[Sides::PointByNumber];

    #[inline(always)]
    fn plain(a: f64, b: f64) -> f64 {
        a / b
    }

    fn dimension(a: Dimension, b: Dimension, _: Option<f64>) -> Result<Dimension, OperatorRefusal> {
        a.over(b).ok_or(OperatorRefusal::PowerOfUnitTooHigh)
    }

    fn refusal(_: f64, b: f64) -> Option<OperatorRefusal> {
        (b == 0.0).then_some(OperatorRefusal::ZeroDivisor)
    }

    fn derivatives(a: &Real, b: &Real, _: f64) -> Result<Real, GeomError> {
        a.over(b)
    }

    fn enclosure(a: &Enclosure, b: &Enclosure) -> Option<Enclosure> {
        a.over(b)
    }
}

/// The remainder with the sign of the divisor.
pub(super) struct Remainder;

impl ArithmeticMeaning for Remainder {
    const VERB: &'static str = "divided with remainder";
    const SIDES: &'static [Sides] = &[];

    #[inline(always)]
    fn plain(a: f64, b: f64) -> f64 {
        let rest = a % b;
        if rest != 0.0 && (rest < 0.0) != (b < 0.0) { rest + b } else { rest }
    }

    fn dimension(a: Dimension, b: Dimension, _: Option<f64>) -> Result<Dimension, OperatorRefusal> {
        a.sum(b).ok_or(OperatorRefusal::Mismatch)
    }

    fn refusal(_: f64, b: f64) -> Option<OperatorRefusal> {
        (b == 0.0).then_some(OperatorRefusal::ZeroDivisor)
    }

    fn derivatives(a: &Real, b: &Real, plain: f64) -> Result<Real, GeomError> {
        if plain == 0.0 {
            let at = a.value();
            return Err(LocalError::NotDifferentiable { what: "the remainder", at }.into());
        }
        // Between its jumps the remainder is a difference.
        let n_times = ((a.value() - plain) / b.value()).round();
        Ok(a.minus(&b.scaled(n_times)))
    }

    fn enclosure(_: &Enclosure, _: &Enclosure) -> Option<Enclosure> {
        None
    }
}

/// The power.
pub(super) struct Power;

impl ArithmeticMeaning for Power {
    const VERB: &'static str = "raised";
    const SIDES: &'static [Sides] = &[];

    #[inline(always)]
    fn plain(a: f64, b: f64) -> f64 {
        libm::pow(a, b)
    }

    fn dimension(
        a: Dimension,
        b: Dimension,
        right: Option<f64>,
    ) -> Result<Dimension, OperatorRefusal> {
        match right {
            _ if !b.is_bare() => Err(OperatorRefusal::ExponentWithUnit),
            Some(exponent) => a.power(exponent).ok_or(OperatorRefusal::NoSuchPowerOfUnit),
            None if a.is_bare() => Ok(a),
            None => Err(OperatorRefusal::NoSuchPowerOfUnit),
        }
    }

    fn refusal(a: f64, b: f64) -> Option<OperatorRefusal> {
        if a == 0.0 && b < 0.0 {
            Some(OperatorRefusal::NegativePowerOfZero)
        } else {
            (a < 0.0 && b.fract() != 0.0).then_some(OperatorRefusal::FractionalPowerOfNegative)
        }
    }

    fn derivatives(a: &Real, b: &Real, plain: f64) -> Result<Real, GeomError> {
        match (a, b) {
            (Real::Jet(base), Real::Plain(exponent)) => base.power(*exponent).map(Real::Jet),
            (_, Real::Jet(exponent)) => a.like(exponent).power_of(exponent).map(Real::Jet),
            (Real::Plain(_), Real::Plain(_)) => Ok(Real::Plain(plain)),
        }
    }

    fn enclosure(a: &Enclosure, b: &Enclosure) -> Option<Enclosure> {
        a.power_of(b)
    }
}
