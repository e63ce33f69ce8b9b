//! Arguments that are the payload of one variant of a value.

use std::sync::Arc;

use glam::DVec3;

use super::{FromValue, Mismatch, Number, Range, Record, Type, Value};
use crate::{
    diag::Span,
    kernel::{Curve, Face, Frame, Mesh, Region, Solid, Surface, Table},
};

/// Reads the payload of one variant.
macro_rules! from_variant {
    ($( $ty:ty = $tag:ident from $variant:ident($inner:ident) $get:expr; )+) => { $(
        impl FromValue for $ty {
            const TYPE: Type = Type::$tag;

            fn from_value(value: &Value, _: Span) -> Result<Self, Mismatch> {
                if let Value::$variant($inner) = value { Ok($get) } else { Err(Mismatch::kind(Self::TYPE, value)) }
            }
        }
    )+ };
}

from_variant! {
    bool = Bool from Bool(truth) *truth;
    Number = Number from Number(number) *number;
    Arc<str> = Text from Text(text) Arc::clone(text);
    DVec3 = Point from Point(point) *point;
    Range = Range from Range(range) *range;
    Arc<Record> = Record from Record(record) Arc::clone(record);
    Curve = Curve from Curve(curve) curve.clone();
    Surface = Surface from Surface(surface) surface.clone();
    Arc<Region> = Region from Region(region) Arc::clone(region);
    Arc<Face> = Face from Face(face) Arc::clone(face);
    Arc<Solid> = Solid from Solid(solid) Arc::clone(solid);
    Arc<Mesh> = Mesh from Mesh(mesh) Arc::clone(mesh);
    Arc<Table> = Table from Table(table) Arc::clone(table);
    Arc<Frame> = Plane from Frame(frame) Arc::clone(frame);
}
