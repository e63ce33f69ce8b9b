//! Operations that make new curves and surfaces of given ones.

mod curve;
mod surface;

use crate::value::Op;

pub(super) static OPS: &[&Op] = &[
    &curve::reversed::OP,
    &curve::reparametrize::OP,
    &curve::standard_form::OP,
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
    &surface::border::OP,
    &surface::compatible::OP,
    &surface::continue_bezier::OP,
    &surface::control_net::OP,
    &surface::corners::OP,
    &surface::de_casteljau::OP,
    &surface::decompose::OP,
    &surface::edge::OP,
    &surface::edges::OP,
    &surface::elevate::OP,
    &surface::flip::OP,
    &surface::orient::OP,
    &surface::power_coefficients::OP,
    &surface::insert_knot::OP,
    &surface::join::OP,
    &surface::offset::OP,
    &surface::refine::OP,
    &surface::reparametrize::OP,
    &surface::reverse_u::OP,
    &surface::reverse_v::OP,
    &surface::split::OP,
    &surface::swap_uv::OP,
    &surface::trim::OP,
    &surface::wireframe::OP,
];
