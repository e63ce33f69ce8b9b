//! What operations on vectors do to many of them at a time.

use glam::DVec3;

use super::{Dimension, Number, Value};

/// An operation on plain vectors, or that makes one of plain numbers: what its `run` yields for them, to the bit. A
/// result with a number that is infinite or none tells that there is none: `run` says what is wrong.
#[derive(Clone, Copy, Debug)]
pub enum OnVectors {
    /// A number of this dimension, of one vector.
    NumberOfOne(Dimension, fn(DVec3) -> f64),
    /// A number of this dimension, of two.
    NumberOfTwo(Dimension, fn(DVec3, DVec3) -> f64),
    /// A vector, of one.
    VectorOfOne(fn(DVec3) -> DVec3),
    /// A vector, of two.
    VectorOfTwo(fn(DVec3, DVec3) -> DVec3),
    /// A vector, of a length and an angle.
    OfLengthAndAngle(fn(f64, f64) -> DVec3),
}

impl OnVectors {
    /// The result of plain arguments that stand by position; none where they do not fit, or `run` has to tell.
    #[must_use]
    pub fn of(&self, args: &[&Value]) -> Option<Value> {
        let number = |value: f64, dim: Dimension| {
            value.is_finite().then_some(Value::Number(Number { value, dim }))
        };
        let point = |point: DVec3| point.is_finite().then_some(Value::Point(point));
        match (self, args) {
            (Self::NumberOfOne(dim, of), &[Value::Point(a)]) => number(of(*a), *dim),
            (Self::NumberOfTwo(dim, of), &[Value::Point(a), Value::Point(b)]) => {
                number(of(*a, *b), *dim)
            }
            (Self::VectorOfOne(of), &[Value::Point(a)]) => point(of(*a)),
            (Self::VectorOfTwo(of), &[Value::Point(a), Value::Point(b)]) => point(of(*a, *b)),
            (Self::OfLengthAndAngle(of), &[Value::Number(length), Value::Number(angle)])
                if Self::are_length_and_angle(length.dim, angle.dim) =>
            {
                point(of(length.value, angle.value))
            }
            _ => None,
        }
    }

    /// Whether numbers of these dimensions are a length and an angle.
    #[must_use]
    pub fn are_length_and_angle(length: Dimension, angle: Dimension) -> bool {
        length.is_as_length() && angle.is_angle()
    }
}
