//! Operations that make new curves and surfaces of given ones.

mod curve;

use crate::value::Op;

pub(super) static OPS: &[&Op] = &[
    &curve::reversed::OP,
    &curve::reparametrize::OP,
    &curve::trim::OP,
    &curve::to_nurbs::OP,
    &curve::split::OP,
    &curve::elevate::OP,
    &curve::insert_knot::OP,
    &curve::refine::OP,
    &curve::decompose::OP,
    &curve::remove_knot::OP,
    &curve::reduce::OP,
    &curve::join::OP,
    &curve::extend::OP,
    &curve::continue_bezier::OP,
    &curve::offset::OP,
];
