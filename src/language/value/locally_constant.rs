//! What operations take and return that can be differentiated.
//!
//! An operation that takes a [`Real`], a `Number<Real>`, a `Length<Real>`, an `Angle<Real>` or a
//! [`Vector`] works on plain numbers and on jets by one formula. Those that take `f64` and the like
//! refuse jets: [`Mismatch::kind`] tells that no derivative passes through.

use std::sync::Arc;

use glam::DVec3;

use super::{
    Angle, Dimension, FromValue, IntoValue, Length, Mismatch, Number, Range, Real, Type, Value,
    Vector, parameter_range::check_plain,
};
use crate::{diag::Span, kernel::Interval};

/// What carries derivatives on, as a hint.
pub const CARRIES_DERIVATIVES: &str = "derivatives pass through arithmetic, the functions of numbers and points, geometry that is made of given points with all else fixed, and its lengths, areas, volumes and places";

/// A number that is only looked at: what an operation answers does not change nearby.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocallyConstant(pub Number);

impl FromValue for LocallyConstant {
    const TYPE: Type = Type::Number;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        Number::<Real>::from_value(value, span).map(|number| Self(number.looked_at()))
    }
}

impl FromValue for Number<Real> {
    const TYPE: Type = Type::Number;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        match value {
            Value::Jet(jet) => Ok((**jet).clone()),
            _ => <Number>::from_value(value, span)
                .map(|Number { value, dim }| Self { value: value.into(), dim }),
        }
    }
}

/// Reads what a wrapped number reads, also from a jet.
macro_rules! from_jet {
    ($( $ty:ty, $plain:ty, $wrap:expr, $unwrap:expr; )+) => { $(
        impl FromValue for $ty {
            const TYPE: Type = <$plain as FromValue>::TYPE;

            fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
                // Units are checked on the value.
                let plain = <$plain>::from_value(&value.looked_at(), span)?;
                Ok(($wrap)(match value {
                    Value::Jet(jet) => jet.value.clone(),
                    _ => Real::Plain(($unwrap)(plain)),
                }))
            }
        }
    )+ };
}

from_jet! {
    Real, f64, |real| real, |plain| plain;
    Length<Real>, Length, Length, |plain: Length| plain.0;
    Angle<Real>, Angle, Angle, |plain: Angle| plain.0;
}

/// A range of a parameter whose ends may carry derivatives; its start is not above its end.
#[derive(Clone, Debug, PartialEq)]
pub struct RealInterval(pub [Real; 2]);

impl FromValue for RealInterval {
    const TYPE: Type = Type::Range;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        let plain = value.looked_at();
        let range = Range::from_value(&plain, span)?;
        check_plain(&range, &plain)?;
        let Range { start, end, .. } = range;
        if start.value.total_cmp(&end.value).is_ne() {
            Interval::from_value(&plain, span)?;
        }
        Ok(Self(match value {
            Value::JetRange(range) => [range.start.value.clone(), range.end.value.clone()],
            _ => [start, end].map(|end| Real::Plain(end.value)),
        }))
    }
}

impl FromValue for Vector {
    const TYPE: Type = Type::Point;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        match value {
            Value::JetPoint(jets) => Ok(Self::Jets(Box::new((**jets).clone()))),
            _ => DVec3::from_value(value, span).map(Self::Plain),
        }
    }
}

impl IntoValue for Number<Real> {
    const RETURNS: Type = Type::Number;

    fn into_value(self) -> Value {
        match self.value {
            Real::Plain(value) => Value::Number(Number { value, dim: self.dim }),
            Real::Jet(_) => Value::Jet(Arc::new(self)),
        }
    }
}

impl IntoValue for Real {
    const RETURNS: Type = Type::Number;

    fn into_value(self) -> Value {
        Number { value: self, dim: Dimension::NONE }.into_value()
    }
}

impl IntoValue for Vector {
    const RETURNS: Type = Type::Point;

    fn into_value(self) -> Value {
        match self {
            Self::Plain(vector) => Value::Point(vector),
            Self::Jets(jets) => Value::JetPoint(jets.into()),
        }
    }
}
