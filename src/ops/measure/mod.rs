//! Questions about geometry.

mod arrows;
mod bounds;
mod curve;
mod describe;
mod report;
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
    &curve::binormal::OP,
    &curve::frame::OP,
    &curve::curvature::OP,
    &curve::signed_curvature::OP,
    &curve::torsion::OP,
    &curve::radius_of_curvature::OP,
    &curve::center_of_curvature::OP,
    &curve::osculating_circle::OP,
    &curve::normal_plane::OP,
    &curve::osculating_plane::OP,
    &curve::rectifying_plane::OP,
    &curve::tangent_line::OP,
    &curve::normal_line::OP,
    &curve::binormal_line::OP,
    &curve::classify::OP,
    &curve::continuity::OP,
    &curve::curvature_comb::OP,
    &curve::curvature_table::OP,
    &curve::basis_table::OP,
    &arrows::OP,
    &curve::is_planar::OP,
    &curve::is_closed::OP,
    &curve::is_straight::OP,
    &curve::length::OP,
    &curve::parameter_at_length::OP,
    &curve::divide::OP,
    &curve::closest::OP,
    &surface::closest::OP,
    &curve::inflections::OP,
    &curve::vertices::OP,
    &curve::extrema::OP,
    &curve::corners::OP,
    &curve::cusps::OP,
    &curve::intersect::OP,
    &curve::self_intersections::OP,
    &curve::section::OP,
    &curve::sample::OP,
    &bounds::OP,
    &describe::OP,
    &report::OP,
];
