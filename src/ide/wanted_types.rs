//! Types of which something is wanted at a place, and whether a value, a name or a call is of them.

use super::{DefinedName, NameRole};
use crate::{
    syntax::ast::{Kind, Unit},
    value::{Type, Value},
};

/// The types of which something is wanted; without one anything may stand.
#[derive(Debug, Default)]
pub(super) struct WantedTypes(Vec<Type>);

impl WantedTypes {
    pub(super) fn new(types: Vec<Type>) -> Self {
        // Where anything is taken nothing is better than the rest.
        Self(if types.contains(&Type::Any) { Vec::new() } else { types })
    }

    fn is_any(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether it takes a value.
    pub(super) fn takes(&self, value: &Value) -> bool {
        self.is_any() || self.0.iter().any(|ty| takes_value(*ty, value))
    }

    /// Whether it takes what is of a type.
    pub(super) fn takes_type(&self, given: Type) -> bool {
        self.is_any() || self.0.iter().any(|ty| takes_type(*ty, given))
    }

    /// Whether it takes what a name stands for: by its value, or else by what it promises.
    pub(super) fn takes_defined(&self, name: &DefinedName, value: Option<&Value>) -> bool {
        match (value, name.role) {
            (Some(value), _) => self.takes(value),
            (None, NameRole::Function) => self.takes_type(Type::Function),
            (None, NameRole::Definition(kind)) => {
                type_of(kind).map_or(self.is_any(), |ty| self.takes_type(ty))
            }
            _ => self.is_any(),
        }
    }

    /// Whether it takes what a word of the language begins.
    pub(super) fn takes_word(&self, word: &str) -> bool {
        match word {
            "true" | "false" => self.takes_type(Type::Bool),
            _ => self.is_any(),
        }
    }

    /// Whether it takes a number with this unit.
    pub(super) fn takes_unit(&self, unit: Unit) -> bool {
        self.takes_type(if unit.millimetres().is_some() { Type::Length } else { Type::Angle })
    }

    /// The words that are chosen from.
    pub(super) fn words(&self) -> Vec<&'static str> {
        self.0.iter().flat_map(|ty| ty.words()).collect()
    }
}

/// The type that a keyword promises.
pub(super) fn type_of(kind: Kind) -> Option<Type> {
    Some(match kind {
        Kind::Let => return None,
        Kind::Point => Type::Point,
        Kind::Curve => Type::Curve,
        Kind::Surface => Type::Surface,
        Kind::Region => Type::Region,
        Kind::Face => Type::Face,
        Kind::Solid => Type::Solid,
        Kind::Mesh => Type::Mesh,
        Kind::Table => Type::Table,
        Kind::Points => Type::List(&Type::Point, 0),
        Kind::Curves => Type::List(&Type::Curve, 0),
        Kind::Surfaces => Type::List(&Type::Surface, 0),
        Kind::Regions => Type::List(&Type::Region, 0),
        Kind::Faces => Type::List(&Type::Face, 0),
        Kind::Solids => Type::List(&Type::Solid, 0),
        Kind::Meshes => Type::List(&Type::Mesh, 0),
        Kind::Tables => Type::List(&Type::Table, 0),
    })
}

/// The types of elements of a list of a type.
pub(super) fn elements(ty: Type) -> Vec<Type> {
    match ty {
        Type::List(of, _) => vec![*of],
        Type::Grid(Type::Point) => vec![Type::List(&Type::Point, 0)],
        Type::OneOf(types) => types.iter().flat_map(|of| elements(*of)).collect(),
        Type::Geometry => vec![ty],
        _ => Vec::new(),
    }
}

/// Whether a value may stand where a type is wanted; of numbers their dimension counts.
fn takes_value(wanted: Type, value: &Value) -> bool {
    if let Type::OneOf(types) = wanted {
        return types.iter().any(|of| takes_value(*of, value));
    }
    let Value::Number(number) = value else {
        return wanted != Type::None && wanted.accepts(value);
    };
    match wanted {
        Type::Length => number.dim.is_as_length(),
        Type::Angle => number.dim.is_angle(),
        Type::Ratio | Type::Count | Type::Integer => number.dim.is_bare(),
        _ => wanted.accepts(value),
    }
}

/// Whether what is of one type may stand where another is wanted.
fn takes_type(wanted: Type, given: Type) -> bool {
    match (wanted, given) {
        (Type::OneOf(types), _) => types.iter().any(|of| takes_type(*of, given)),
        (_, Type::OneOf(types)) => types.iter().any(|of| takes_type(wanted, *of)),
        (Type::None, _) | (_, Type::None | Type::Any) => false,
        (
            Type::Number,
            Type::Ratio
            | Type::Count
            | Type::Integer
            | Type::Length
            | Type::Angle
            | Type::Quantity(_),
        )
        | (Type::Ratio, Type::Number | Type::Count | Type::Integer)
        | (Type::Integer, Type::Count)
        | (Type::Length | Type::Angle, Type::Number)
        | (Type::Function, Type::Curve | Type::Surface | Type::Face)
        | (
            Type::Geometry,
            Type::Point
            | Type::Curve
            | Type::Surface
            | Type::Region
            | Type::Face
            | Type::Solid
            | Type::Mesh
            | Type::Plane,
        ) => true,
        (Type::Length, Type::Quantity(name)) => name == "length",
        (Type::List(of, _), Type::List(given, _)) => *of == Type::Any || takes_type(*of, *given),
        (Type::Geometry, Type::List(of, _)) => takes_type(wanted, *of),
        (Type::Text | Type::Choice(_), Type::Text) => true,
        _ => wanted == given,
    }
}
