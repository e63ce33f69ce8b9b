//! Which operands an operator takes, where they stand, and why it takes none of others.

use crate::diag::Span;

/// Kinds that an arithmetic operator takes beside two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::eval) enum Sides {
    /// Two points, coordinate by coordinate.
    Points,
    /// A point, each coordinate with the number.
    PointByNumber,
    /// The same the other way round, for an operator whose sides may change places.
    NumberByPoint,
}

/// Why two numbers have no result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::eval) enum OperatorRefusal {
    /// Their units do not go together.
    Mismatch,
    /// The power of a unit leaves the range.
    PowerOfUnitTooHigh,
    /// An exponent has a unit.
    ExponentWithUnit,
    /// The unit has no such power, or none that is known before the exponent is.
    NoSuchPowerOfUnit,
    /// The divisor is zero.
    ZeroDivisor,
    /// Zero to a negative power.
    NegativePowerOfZero,
    /// A negative number to a power that is not whole.
    FractionalPowerOfNegative,
}

/// Where an operation and its two sides stand.
#[derive(Clone, Copy, Debug)]
pub(in crate::eval) struct OperandPlaces {
    pub(in crate::eval) whole: Span,
    pub(in crate::eval) left: Span,
    pub(in crate::eval) right: Span,
}
