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
    value::Op,
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

/// The length of a vector, without overflow on the way.
fn length(vector: DVec3) -> f64 {
    libm::hypot(libm::hypot(vector.x, vector.y), vector.z)
}

/// The unit vector of a direction.
fn direction(vector: Spanned<DVec3>) -> Result<DVec3> {
    let length = length(vector.value);
    if 0.0 < length {
        return Ok(vector.value / length);
    }
    let message = "a vector of length zero has no direction";
    Diagnostic::error(Code::Degenerate, vector.span, message).fail()
}
