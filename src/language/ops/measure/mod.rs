//! Questions about geometry.

mod arrows;
mod bounds;
mod continuity_limits;
mod curve;
mod describe;
mod picture;
mod piercing;
mod report;
mod surface;

use crate::{
    kernel::{GeomError, NamedColumn},
    value::{Dimension, Op},
};

pub(super) use continuity_limits::ContinuityOptions;
pub(super) use surface::{
    MassOf,
    inertia::{inertia_told, varying_inertia},
    tell_accuracy,
};

/// What the kernel answers to a question.
type Measured<T> = std::result::Result<T, GeomError>;

/// A column of a table of measurements, with its unit where the power of length is known that it holds.
fn measured_column(name: &str, power: Option<i8>, cells: Vec<f64>, length: &str) -> NamedColumn {
    let column = NamedColumn::numbers(name, cells);
    let dim = power.and_then(|power| Dimension::LENGTH.power(f64::from(power)));
    match dim.and_then(|dim| dim.unit(length)) {
        Some(unit) => column.with_unit(unit),
        None => column,
    }
}

pub(super) static OPS: &[&Op] = &[
    &curve::at::OP,
    &surface::at::OP,
    &curve::derivative::OP,
    &surface::derivative::OP,
    &curve::tangent::OP,
    &curve::normal::OP,
    &surface::normal::OP,
    &surface::tangent_u::OP,
    &surface::tangent_v::OP,
    &surface::twist::OP,
    &surface::tangent_plane::OP,
    &surface::first_form::OP,
    &surface::second_form::OP,
    &surface::gaussian::OP,
    &surface::mean::OP,
    &surface::principal::OP,
    &surface::normal_curvature::OP,
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
    &surface::normal_line::OP,
    &curve::binormal_line::OP,
    &curve::classify::OP,
    &surface::classify::OP,
    &curve::continuity::OP,
    &surface::continuity::OP,
    &curve::curvature_comb::OP,
    &surface::curvature_comb::OP,
    &curve::curvature_table::OP,
    &surface::curvature_table::OP,
    &curve::basis_table::OP,
    &arrows::OP,
    &curve::is_planar::OP,
    &curve::knot_class::OP,
    &surface::is_planar::OP,
    &surface::is_developable::OP,
    &surface::is_minimal::OP,
    &surface::deviation::OP,
    &surface::area::OP,
    &surface::volume::OP,
    &surface::centroid::OP,
    &surface::inertia::OP,
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
    &picture::intersect::OP,
    &curve::self_intersections::OP,
    &curve::section::OP,
    &picture::section::OP,
    &picture::section_all::OP,
    &picture::section_mesh::OP,
    &picture::contours::OP,
    &picture::isophotes::OP,
    &picture::zebra::OP,
    &picture::reflection_lines::OP,
    &picture::curvature_map::OP,
    &curve::sample::OP,
    &bounds::OP,
    &describe::OP,
    &report::OP,
];
