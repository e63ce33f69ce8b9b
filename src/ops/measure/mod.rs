//! Questions about geometry.

mod bounds;
mod curve;
mod surface;

use crate::value::Op;

pub(super) static OPS: &[&Op] = &[
    &curve::at::OP,
    &surface::at::OP,
    &curve::derivative::OP,
    &surface::derivative::OP,
    &curve::tangent::OP,
    &curve::normal::OP,
    &surface::normal::OP,
    &curve::curvature::OP,
    &curve::length::OP,
    &curve::sample::OP,
    &bounds::OP,
];
