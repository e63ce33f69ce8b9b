//! What is in pieces that do not meet, where it should be connected.

use super::digits::{few_digits, plain};

/// A jump, and how far both sides are apart.
///
/// A knot as often as degree + 1 times may take a curve apart:
///
/// ```
/// use virote_kernel::{GeomError, JumpError, KnotVector, NurbsCurve, glam::DVec3};
///
/// let knots = KnotVector::new(1, vec![0.0, 0.0, 1.0, 1.0, 2.0, 2.0])?;
/// let broken = NurbsCurve::polynomial(knots, &[0.0, 1.0, 4.0, 5.0].map(|x| DVec3::X * x))?;
/// let found = broken.check_connected();
/// assert_eq!(found, Err(GeomError::Jump(JumpError::Curve { parameter: 1.0, gap: 3.0 })));
/// # Ok::<(), GeomError>(())
/// ```
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
    #[error("the function jumps by {} at ({}, {})", few_digits(*gap), few_digits(*u), few_digits(*v))]
    FunctionAt { u: f64, v: f64, gap: f64 },
}
