//! What scripts compute with, and how an operation is declared.
//!
//! [`Value`] is the one representation of everything that an expression can yield. [`Op`] is the
//! one declaration of a built-in: the `op!` macro makes it, the [`Registry`] lists it, and the
//! evaluator, the reference, the help and the tests read nothing else.

mod affine;
mod affine_packs;
mod appearance;
mod bind;
mod bind_names;
mod common_dimension;
mod compare;
mod control_points;
mod decode;
mod display;
mod element;
mod error_map;
mod example;
mod field;
mod files;
mod format;
mod from_value;
mod from_variant;
mod function;
mod given_points;
mod held_numbers;
mod into_value;
mod json;
mod key;
mod list;
mod locally_constant;
mod mapped;
mod measured;
mod misplaced;
mod number;
mod numbers;
mod on_numbers;
mod on_vectors;
mod op;
mod op_macro;
mod packed;
mod parameter_range;
mod range;
mod reach;
mod read_json;
mod real;
mod real_body;
mod record;
mod registry;
mod remedy;
mod rounding;
mod same_shape;
mod selected;
mod settling;
mod shape;
mod switch;
mod table_text;
mod ty;
mod unit;
mod variation;
mod varied;
mod vector;
mod witness;

use std::sync::Arc;

use glam::DVec3;

use crate::kernel::{
    Curve, Face, Frame, Jet, Mesh, Region, Solid, Surface, Table, VariedCurve, VariedRegion,
    VariedSolid, VariedSurface,
};

pub use affine::{NoDerivative, through_affine, through_shape, through_told, varies};
pub use appearance::{Appearance, COLOR_NAMES, color_of};
pub use bind::{Binder, Call, FormalParameter, Mistakes, assign};
pub use common_dimension::CommonDimension;
pub use compare::{Discrepancy, deviation, equal};
pub use control_points::{slopes_by_variable, with_slopes_of_points};
pub use decode::{decode, script_text, stranger};
pub use element::pointed;
pub use error_map::{At, blamed_on, code_of, hint_of, raised};
pub use example::{Example, ExamplePicture, RefusalExample};
pub use field::{field, field_names, field_names_of, table_row};
pub use files::{Files, MemoryFiles, NoFiles, missing_file};
pub use format::{FormatRefusal, NumberFormat};
pub use from_value::{
    Angle, AtLeast, Callback, Choice, FromValue, Length, Maybe, Mismatch, Numbers, Rows,
};
pub use function::{Closure, Function, Partial};
pub use into_value::IntoValue;
pub use json::{from_json, to_json};
pub(crate) use key::exact_key;
pub use list::{List, ValueExtent};
pub use locally_constant::{CARRIES_DERIVATIVES, LocallyConstant, RealInterval};
pub use measured::{Area, Curvature, LengthPower, Open, Volume};
pub use misplaced::turned_around;
pub use number::{BARE_AND_ANGLE, Dimension, Number, radians_of, rounded, shortest};
pub use on_numbers::OnNumbers;
pub use on_vectors::OnVectors;
pub use op::{
    Bounded, Caller, Comparison, Ctx, EnclosedFunction, Family, Making, Op, OpParameter, Relation,
};
pub(crate) use op_macro::op;
pub use parameter_range::ParameterRange;
pub use range::{JetRange, Range};
pub use read_json::{ENDED, read_json};
pub use real::Real;
pub use real_body::{RealRegion, RealSolid, with_slopes};
pub use record::Record;
pub use registry::{Constant, Registry, choose};
pub(crate) use rounding::rounded_to;
pub use settling::{MovingSurface, Settling};
pub use shape::{Geometry, RealGeometry};
pub use switch::{Switch, is_like};
pub use table_text::{MOST_ROWS, table_cells, table_text};
pub use ty::Type;
pub use unit::shortest_in;
pub use unit::{in_document_unit, in_unit_of};
pub use variation::{looked_at, with_form_of};
pub use varied::{RealCurve, RealSurface};
pub use vector::Vector;
pub use witness::{Witness, WitnessOf};

/// What an expression evaluates to. Cheap to clone.
#[derive(Clone, Debug)]
pub enum Value {
    /// Nothing; what an option that was left out holds.
    None,
    /// A truth.
    Bool(bool),
    /// A number with its dimension.
    Number(Number),
    /// A text.
    Text(Arc<str>),
    /// A point or vector, in document units.
    Point(DVec3),
    /// A number in a function that is differentiated; a [`Real::Jet`].
    Jet(Arc<Number<Real>>),
    /// A point in a function that is differentiated.
    JetPoint(Arc<[Jet; 3]>),
    /// A list.
    List(List),
    /// A range.
    Range(Range),
    /// A range in a function that is differentiated.
    JetRange(Arc<JetRange>),
    /// A record.
    Record(Arc<Record>),
    /// Something that can be called.
    Function(Function),
    /// A curve.
    Curve(Curve),
    /// A curve in a function that is differentiated.
    JetCurve(Arc<VariedCurve>),
    /// A surface.
    Surface(Surface),
    /// A surface in a function that is differentiated.
    JetSurface(Arc<VariedSurface>),
    /// A plane region.
    Region(Arc<Region>),
    /// A plane region in a function that is differentiated.
    JetRegion(Arc<VariedRegion>),
    /// A part of a surface.
    Face(Arc<Face>),
    /// What faces enclose.
    Solid(Arc<Solid>),
    /// A solid in a function that is differentiated.
    JetSolid(Arc<VariedSolid>),
    /// A mesh.
    Mesh(Arc<Mesh>),
    /// A table.
    Table(Arc<Table>),
    /// A plane or frame.
    Frame(Arc<Frame>),
}

impl Value {
    /// A bare number.
    #[must_use]
    pub fn number(value: f64) -> Self {
        Self::Number(Number::bare(value))
    }

    /// A text.
    #[must_use]
    pub fn text(text: &str) -> Self {
        Self::Text(Arc::from(text))
    }

    /// A list.
    #[must_use]
    pub fn list(items: Vec<Self>) -> Self {
        Self::List(List::from(items))
    }

    /// The value without derivatives: a plain number for a jet, a point for one of jets, a curve or surface for one that
    /// varies.
    #[must_use]
    pub fn looked_at(&self) -> Self {
        match self {
            Self::Jet(number) => Self::Number(number.looked_at()),
            Self::JetPoint(jets) => Self::Point(DVec3::from(jets.each_ref().map(Jet::value))),
            Self::JetRange(range) => Self::Range(range.looked_at()),
            Self::JetCurve(curve) => Self::Curve(Curve::Nurbs(Arc::clone(curve.given()))),
            Self::JetSurface(surface) => Self::Surface(Surface::Nurbs(Arc::clone(surface.given()))),
            Self::JetRegion(region) => Self::Region(Arc::clone(region.region())),
            Self::JetSolid(solid) => Self::Solid(Arc::clone(solid.solid())),
            other => other.clone(),
        }
    }

    /// Whether it carries derivatives.
    #[must_use]
    pub fn is_jet(&self) -> bool {
        matches!(
            self,
            Self::Jet(_)
                | Self::JetPoint(_)
                | Self::JetRange(_)
                | Self::JetCurve(_)
                | Self::JetSurface(_)
                | Self::JetRegion(_)
                | Self::JetSolid(_)
        )
    }

    /// How deep and how large it is.
    #[must_use]
    pub fn extent(&self) -> ValueExtent {
        /// Bytes of text that count as one value.
        const BYTES_A_VALUE: usize = 32;
        match self {
            Self::List(items) => items.extent(),
            Self::Record(record) => record.extent(),
            Self::Function(function) => function.extent(),
            Self::Text(text) => {
                ValueExtent { size: 1 + (text.len() / BYTES_A_VALUE) as u64, ..ValueExtent::ATOM }
            }
            Self::Curve(Curve::Parametric(_)) | Self::Surface(Surface::Parametric(_)) => {
                ValueExtent { holds_functions: true, ..ValueExtent::ATOM }
            }
            _ => ValueExtent::ATOM,
        }
    }

    /// The kind's name alone: `curve`.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Bool(_) => "bool",
            Self::Number(_) | Self::Jet(_) => "number",
            Self::Text(_) => "string",
            Self::Point(_) | Self::JetPoint(_) => "point",
            Self::List(_) => "list",
            Self::Range(_) | Self::JetRange(_) => "range",
            Self::Record(_) => "record",
            Self::Function(_) => "function",
            Self::Curve(_) | Self::JetCurve(_) => "curve",
            Self::Surface(_) | Self::JetSurface(_) => "surface",
            Self::Region(_) | Self::JetRegion(_) => "region",
            Self::Face(_) => "face",
            Self::Solid(_) | Self::JetSolid(_) => "solid",
            Self::Mesh(_) => "mesh",
            Self::Table(_) => "table",
            Self::Frame(_) => "plane",
        }
    }

    /// The value as a noun phrase of a message: `a list of 3 points`, `an angle`.
    #[must_use]
    pub fn phrase(&self) -> String {
        match self {
            Self::None => "none".to_owned(),
            Self::Bool(truth) => format!("the truth value {truth}"),
            Self::Number(number) if number.dim.is_bare() => format!("the number {number}"),
            Self::Number(number) => format!("{} ({number})", number.dim),
            Self::Text(text) if text.chars().count() <= 24 => format!("the string \"{text}\""),
            Self::Text(_) => "a string".to_owned(),
            Self::List(items) => list_phrase(items),
            Self::Jet(number) => Self::Number(number.looked_at()).phrase(),
            Self::Point(_) | Self::JetPoint(_) => "a point".to_owned(),
            Self::Range(range) => format!("the range {range}"),
            Self::JetRange(range) => format!("the range {}", range.looked_at()),
            Self::Curve(Curve::Parametric(_)) | Self::Surface(Surface::Parametric(_)) => {
                format!("a parametric {}", self.kind())
            }
            _ => format!("a {}", self.kind()),
        }
    }
}

/// `an empty list`, `a list of 3 points`, `a list of 4 values`.
fn list_phrase(items: &[Value]) -> String {
    let Some(first) = items.first() else { return "an empty list".to_owned() };
    let kind =
        if items.iter().all(|item| item.kind() == first.kind()) { first.kind() } else { "value" };
    let plural = match kind {
        "mesh" => "meshes".to_owned(),
        _ => format!("{kind}s"),
    };
    format!("a list of {} {}", items.len(), if items.len() == 1 { kind } else { &plural })
}
