//! Other forms of a curve, and what its present form is made of.

mod basis;
mod compatible;
mod control_polygon;
mod de_casteljau;
mod edit_points;
mod greville;
mod hodograph;
mod knot_points;
mod power_coefficients;
mod reweight;
mod to_clamped;
mod to_coons;
mod to_hermite;

use crate::value::Op;

pub(super) static OPS: &[&Op] = &[
    &to_hermite::OP,
    &to_coons::OP,
    &to_clamped::OP,
    &power_coefficients::OP,
    &compatible::OP,
    &reweight::OP,
    &hodograph::OP,
    &basis::OP,
    &control_polygon::OP,
    &de_casteljau::OP,
    &greville::OP,
    &edit_points::OP,
    &knot_points::OP,
];
