//! Points and vectors.

mod angle_between;
mod centroid;
mod cross;
mod distance;
mod dot;
mod midpoint;
mod norm;
mod polar;
mod unit_vector;

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    value::{At, Op, Vector},
};

pub(super) static OPS: &[&Op] = &[
    &angle_between::OP,
    &centroid::OP,
    &cross::OP,
    &distance::OP,
    &dot::OP,
    &midpoint::OP,
    &norm::OP,
    &polar::OP,
    &unit_vector::OP,
];

/// The unit vector of a direction.
fn direction(vector: Spanned<Vector>) -> Result<Vector> {
    let Spanned { value: vector, span } = vector;
    if vector.value() == DVec3::ZERO {
        let message = "a vector of length zero has no direction";
        return Diagnostic::error(Code::Degenerate, span, message).fail();
    }
    vector.norm().and_then(|length| vector.over(&length)).at(span)
}

/// The same of a plain one; no numbers where it has no direction.
fn plain_direction(vector: DVec3) -> DVec3 {
    vector / Vector::plain_norm(vector)
}
