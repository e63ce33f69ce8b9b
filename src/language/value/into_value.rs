//! Conversions from the Rust types that operations return to language values.

use glam::DVec3;

use super::{Angle, Choice, Geometry, Length, Number, Range, RealGeometry, Record, Type, Value};
use crate::{
    diag::Spanned,
    kernel::{
        ConstructionReport, Curve, Face, Frame, Interval, Mesh, NurbsCurve, NurbsSurface, Region,
        ReportEntry, Solid, Surface, Table,
    },
};
use std::sync::Arc;

/// A Rust type that an operation can return.
pub trait IntoValue {
    /// How the type is called in help texts.
    const RETURNS: Type;
    /// The value.
    fn into_value(self) -> Value;
}

impl<T: Choice> IntoValue for T {
    const RETURNS: Type = Type::Choice(T::WORDS);

    fn into_value(self) -> Value {
        let idx = T::MEANINGS.iter().position(|meaning| *meaning == self);
        idx.map_or(Value::None, |idx| Value::text(T::WORDS[idx]))
    }
}

/// Wraps a payload into its variant.
macro_rules! into_variant {
    ($( $ty:ty = $tag:expr, |$inner:ident| $make:expr; )+) => { $(
        impl IntoValue for $ty {
            const RETURNS: Type = $tag;

            fn into_value(self) -> Value {
                let $inner = self;
                $make
            }
        }
    )+ };
}

into_variant! {
    Value = Type::Any, |value| value;
    bool = Type::Bool, |truth| Value::Bool(truth);
    f64 = Type::Number, |value| Value::number(value);
    usize = Type::Count, |count| Value::number(count as f64);
    i64 = Type::Integer, |count| Value::number(count as f64);
    Number = Type::Number, |number| Value::Number(number);
    &str = Type::Text, |text| Value::text(text);
    String = Type::Text, |text| Value::text(&text);
    DVec3 = Type::Point, |point| Value::Point(point);
    Interval = Type::Range, |interval| Value::Range(Range::from(interval));
    Record = Type::Record, |record| Value::Record(Arc::new(record));
    &ConstructionReport = Type::Record, |report| {
        let facts = report.facts().map(|(name, fact)| (Arc::from(name), fact.into_value()));
        Value::Record(Arc::new(Record::new(facts)))
    };
    &ReportEntry = Type::Any, |fact| match fact {
        ReportEntry::None => Value::None,
        ReportEntry::Truth(truth) => Value::Bool(*truth),
        ReportEntry::Number(number) => Value::number(*number),
        ReportEntry::Length(length) => Length(*length).into_value(),
        ReportEntry::Angle(angle) => Angle(*angle).into_value(),
        ReportEntry::Point(point) => Value::Point(*point),
        ReportEntry::Curve(curve) => (**curve).clone().into_value(),
        ReportEntry::Text(text) => Value::Text(text.clone()),
        ReportEntry::List(facts) => Value::list(facts.iter().map(IntoValue::into_value).collect()),
        ReportEntry::Numbers(numbers) => {
            Value::list(numbers.iter().map(|&number| Value::number(number)).collect())
        }
        ReportEntry::Record(report) => report.into_value(),
    };
    Curve = Type::Curve, |curve| Value::Curve(curve);
    Surface = Type::Surface, |surface| Value::Surface(surface);
    NurbsCurve = Type::Curve, |curve| Value::Curve(curve.into());
    NurbsSurface = Type::Surface, |surface| Value::Surface(surface.into());
    Region = Type::Region, |region| Value::Region(Arc::new(region));
    Face = Type::Face, |face| Value::Face(Arc::new(face));
    Solid = Type::Solid, |solid| Value::Solid(Arc::new(solid));
    Mesh = Type::Mesh, |mesh| Value::Mesh(Arc::new(mesh));
    Table = Type::Table, |table| Value::Table(Arc::new(table));
    Frame = Type::Plane, |frame| Value::Frame(Arc::new(frame));
    Geometry = Type::Geometry, |geometry| geometry.0;
    RealGeometry = Type::Geometry, |geometry| geometry.0;
}

impl<T: IntoValue> IntoValue for Vec<T> {
    const RETURNS: Type = Type::List(&T::RETURNS, 0);

    fn into_value(self) -> Value {
        Value::list(self.into_iter().map(IntoValue::into_value).collect())
    }
}

impl<T: IntoValue> IntoValue for Spanned<T> {
    const RETURNS: Type = T::RETURNS;

    fn into_value(self) -> Value {
        self.value.into_value()
    }
}
