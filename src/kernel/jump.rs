//! What is in pieces that do not meet, where it should be connected.

use super::digits::{few_digits, plain};

/// A jump, and how far both sides are apart.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum JumpError {
    /// Of a curve, at an inner knot that stands degree + 1 times.
    #[error("the curve jumps by {} at parameter {}", few_digits(*gap), plain(*parameter))]
    Curve { parameter: f64, gap: f64 },
    /// Of a surface, across such a knot of one direction.
    #[error("the surface jumps by {} across {along} = {}", few_digits(*gap), plain(*at))]
    Surface { along: &'static str, at: f64, gap: f64 },
    /// Of a function.
    #[error("the function jumps by {} at parameter {parameter}", few_digits(*gap))]
    Function { parameter: f64, gap: f64 },
    /// Of a function of two parameters.
    #[error("the function jumps by {} at ({u}, {v})", few_digits(*gap))]
    FunctionAt { u: f64, v: f64, gap: f64 },
}
