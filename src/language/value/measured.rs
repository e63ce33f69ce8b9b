//! Numbers with the dimension that an operation answers with.

use super::{
    Angle, Dimension, FromValue, IntoValue, Length, Mismatch, Number, Real, Type, Value,
    number::WHOLE,
};
use crate::diag::{Code, Span};

/// A number of document units to a power, as an operation answers: an area, a volume, a curvature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LengthPower<const POWER: i8, T = f64>(pub T);

/// In square document units.
pub type Area<T = f64> = LengthPower<2, T>;
/// In cubic document units.
pub type Volume<T = f64> = LengthPower<3, T>;
/// In one over document units.
pub type Curvature<T = f64> = LengthPower<-1, T>;

/// A number as an operation answers it that is a length, an area or a plain number, whatever the points
/// are that it comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Open<T = f64>(pub T);

impl<T: Into<Real>> IntoValue for Angle<T> {
    const RETURNS: Type = Type::Angle;

    fn into_value(self) -> Value {
        Number { value: self.0.into(), dim: Dimension::ANGLE }.into_value()
    }
}

impl<T: Into<Real>> IntoValue for Length<T> {
    const RETURNS: Type = Type::Length;

    fn into_value(self) -> Value {
        Number { value: self.0.into(), dim: Dimension::LENGTH }.into_value()
    }
}

impl<T: Into<Real>> IntoValue for Open<T> {
    const RETURNS: Type = Type::Number;

    fn into_value(self) -> Value {
        Number { value: self.0.into(), dim: Dimension::OPEN }.into_value()
    }
}

/// Also a plain number, in document units.
impl<const POWER: i8> FromValue for LengthPower<POWER> {
    const TYPE: Type = <Self as IntoValue>::RETURNS;

    fn from_value(value: &Value, _: Span) -> Result<Self, Mismatch> {
        let dim = Dimension::of_powers([POWER * WHOLE, 0]);
        match value {
            Value::Number(number) if number.dim == dim || number.dim.is_bare() => {
                Ok(Self(number.value))
            }
            Value::Number(_) => {
                Err(Mismatch::kind(<Self as FromValue>::TYPE, value).code(Code::UnitMismatch))
            }
            _ => Err(Mismatch::kind(<Self as FromValue>::TYPE, value)),
        }
    }
}

impl<const POWER: i8, T: Into<Real>> IntoValue for LengthPower<POWER, T> {
    const RETURNS: Type = match POWER {
        2 => Type::Quantity("area"),
        3 => Type::Quantity("volume"),
        -1 => Type::Quantity("curvature"),
        _ => Type::Number,
    };

    fn into_value(self) -> Value {
        let dim = Dimension::of_powers([POWER * WHOLE, 0]);
        Number { value: self.0.into(), dim }.into_value()
    }
}
