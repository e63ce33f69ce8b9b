//! Questions about curves.

pub(super) mod at;
pub(super) mod curvature;
pub(super) mod derivative;
pub(super) mod length;
pub(super) mod normal;
pub(super) mod sample;
pub(super) mod tangent;

use crate::{
    diag::{Result, Spanned},
    kernel::Curve,
    value::At,
};

/// A parameter of a curve, inside its domain.
fn inside(curve: &Curve, t: Spanned<f64>) -> Result<f64> {
    curve.domain().clamp_inside(t.value).at(t.span)
}
