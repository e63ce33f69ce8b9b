//! The built-ins as data, for the modules that are generated of them.

use pyo3::prelude::*;
use serde_json::{Value as Json, json};
use virote::{
    ops,
    value::{Op, Type},
};

/// Every built-in as JSON: name, aliases, chapter, documentation, signature, parameters, result.
#[pyfunction]
pub(crate) fn operations() -> String {
    let registry = ops::registry();
    let all: Vec<Json> = registry.iter().filter(|op| !op.names_script).map(operation).collect();
    Json::Array(all).to_string()
}

fn operation(op: &'static Op) -> Json {
    let parameters: Vec<Json> = op
        .params
        .iter()
        .map(|parameter| {
            json!({
                "name": parameter.name,
                "docs": parameter.docs.trim(),
                "type": parameter.ty.to_string(),
                "hint": hint(parameter.ty),
                "optional": parameter.may_be_left_out(),
                "by_position": !parameter.may_be_left_out() || parameter.by_position,
                "default": parameter.default.map(|default| default().to_string()),
                "spreads": parameter.spreads,
            })
        })
        .collect();
    json!({
        "name": op.name,
        "aliases": op.aliases,
        "chapter": format!("{:?}", op.family),
        "docs": op.docs.trim(),
        "signature": op.signature(),
        "parameters": parameters,
        "returns": op.returns.to_string(),
        "examples": op.examples.iter().map(|one| json!([one.code, one.prints])).collect::<Vec<_>>(),
    })
}

/// The name of the Python type that stands for a type.
fn hint(ty: Type) -> &'static str {
    match ty {
        Type::None => "None",
        Type::Bool => "bool",
        Type::Number | Type::Length | Type::Angle | Type::Quantity(_) => "Quantity",
        Type::Ratio | Type::Count | Type::Integer => "float",
        Type::Text | Type::Choice(_) => "str",
        Type::Point => "PointLike",
        Type::List(Type::Point, _) => "PointsLike",
        Type::Range => "tuple[Quantity, Quantity]",
        Type::Record => "dict[str, Any]",
        Type::Function => "FunctionLike",
        Type::Curve => "Curve",
        Type::Surface => "Surface",
        Type::Mesh => "Mesh",
        Type::Table => "Table",
        Type::Plane => "Frame",
        Type::Region => "Region",
        Type::Face => "Face",
        Type::Solid => "Solid",
        Type::List(Type::Curve, _) => "Sequence[Curve]",
        Type::List(Type::Surface, _) => "Sequence[Surface]",
        Type::Any | Type::Geometry | Type::List(..) | Type::Grid(_) | Type::OneOf(_) => "Any",
    }
}
