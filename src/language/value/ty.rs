//! Types as the user reads them: in signatures, and in messages that say what was expected.

use std::fmt;

use super::Value;

/// A type of the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    /// Any value.
    Any,
    /// `none`.
    None,
    /// `true` or `false`.
    Bool,
    /// A number of whatever dimension.
    Number,
    /// A number without a unit.
    Ratio,
    /// A whole number without a unit, zero or more.
    Count,
    /// A whole number without a unit.
    Integer,
    /// A length; a bare number counts as document units.
    Length,
    /// An angle; never a bare number.
    Angle,
    /// A number of a known dimension, by its name; only as an answer.
    Quantity(&'static str),
    /// A string.
    Text,
    /// One of a few words.
    Choice(&'static [&'static str]),
    /// A point or vector.
    Point,
    /// Element type and least length.
    List(&'static Type, usize),
    /// A list of rows of one length.
    Grid(&'static Type),
    /// A range.
    Range,
    /// A record.
    Record,
    /// Anything that can be called.
    Function,
    /// A curve.
    Curve,
    /// A surface.
    Surface,
    /// A plane region.
    Region,
    /// A part of a surface.
    Face,
    /// What faces enclose.
    Solid,
    /// A mesh.
    Mesh,
    /// A table.
    Table,
    /// A plane or frame.
    Plane,
    /// A point, curve, surface, mesh or plane, or a list of such.
    Geometry,
    /// One of several types.
    OneOf(&'static [Type]),
}

impl Type {
    /// Whether a value looks like one of this type. Looks at the kind, and at the first element
    /// of lists: enough to choose between the built-ins of one name.
    #[must_use]
    pub fn accepts(self, value: &Value) -> bool {
        match (self, value) {
            (Self::Any, _)
            | (Self::None, Value::None)
            | (Self::Bool, Value::Bool(_))
            | (
                Self::Number
                | Self::Ratio
                | Self::Count
                | Self::Integer
                | Self::Length
                | Self::Angle
                | Self::Quantity(_),
                Value::Number(_) | Value::Jet(_),
            )
            | (Self::Text | Self::Choice(_), Value::Text(_))
            | (Self::Point, Value::Point(_) | Value::JetPoint(_))
            | (Self::Range, Value::Range(_) | Value::JetRange(_))
            | (Self::Record, Value::Record(_))
            | (
                Self::Function,
                Value::Function(_)
                | Value::Curve(_)
                | Value::JetCurve(_)
                | Value::Surface(_)
                | Value::JetSurface(_)
                | Value::Face(_),
            )
            | (Self::Curve, Value::Curve(_) | Value::JetCurve(_))
            | (Self::Surface, Value::Surface(_) | Value::JetSurface(_))
            | (Self::Region, Value::Region(_) | Value::JetRegion(_))
            | (Self::Face, Value::Face(_))
            | (Self::Solid, Value::Solid(_) | Value::JetSolid(_))
            | (Self::Mesh, Value::Mesh(_))
            | (Self::Table, Value::Table(_))
            | (Self::Plane, Value::Frame(_))
            | (
                Self::Geometry,
                Value::Point(_)
                | Value::Curve(_)
                | Value::Surface(_)
                | Value::Region(_)
                | Value::Face(_)
                | Value::Solid(_)
                | Value::Mesh(_)
                | Value::Frame(_),
            ) => true,
            (Self::List(of, _), Value::List(items)) => {
                items.get(0).is_none_or(|item| of.accepts(&item))
            }
            (Self::Grid(of), Value::List(rows)) => {
                rows.get(0).is_some_and(|row| Self::List(of, 0).accepts(&row))
            }
            (Self::Geometry, Value::List(items)) => {
                items.get(0).is_none_or(|item| self.accepts(&item))
            }
            // A table is run through by its rows.
            (Self::List(Self::Any, _), Value::Table(_)) => true,
            // A range of whole numbers is as good as their list.
            (Self::List(of, _), Value::Range(_)) => of.accepts(&Value::number(0.0)),
            (Self::OneOf(types), _) => types.iter().any(|of| of.accepts(value)),
            _ => false,
        }
    }

    /// Whether a value looks like an element of a list of this type.
    #[must_use]
    pub fn is_list_of(self, value: &Value) -> bool {
        match self {
            Self::List(Self::Any, _) => !matches!(
                value,
                Value::Function(_)
                    | Value::List(_)
                    | Value::Range(_)
                    | Value::Table(_)
                    | Value::Record(_)
                    | Value::Text(_)
            ),
            Self::List(of, _) => of.accepts(value),
            Self::Grid(of) => Self::List(of, 0).accepts(value),
            Self::OneOf(types) => types.iter().any(|of| of.is_list_of(value)),
            _ => false,
        }
    }

    /// The type as a noun phrase of a message: `a list of 2 or more points`.
    #[must_use]
    pub fn phrase(self) -> String {
        match self {
            Self::Any => "a value".to_owned(),
            Self::None => "none".to_owned(),
            Self::Bool => "true or false".to_owned(),
            Self::Angle => "an angle".to_owned(),
            Self::Ratio => "a number without a unit".to_owned(),
            Self::Count | Self::Integer => "a whole number".to_owned(),
            Self::Text => "a string".to_owned(),
            Self::Function => "a function".to_owned(),
            Self::Choice(words) => format!("one of {}", quoted(words)),
            Self::Geometry => {
                "geometry (a point, curve, surface, mesh, plane, or a list of them)".to_owned()
            }
            Self::List(of, 0) => format!("a list of {}", of.plural()),
            Self::List(of, least) => format!("a list of {least} or more {}", of.plural()),
            Self::Grid(of) => format!("a grid of {} (a list of rows)", of.plural()),
            Self::OneOf(_) => Self::phrase_of_any([self].into_iter()),
            _ => format!("a {self}"),
        }
    }

    /// What any of these types may be, each told once: `a curve, a surface or a face`.
    #[must_use]
    pub fn phrase_of_any(types: impl Iterator<Item = Self>) -> String {
        let mut wanted: Vec<String> = Vec::new();
        for ty in types {
            let alternatives = match ty {
                Self::OneOf(types) => named(types).copied().collect(),
                other => vec![other],
            };
            for phrase in alternatives.into_iter().map(Self::phrase) {
                if !wanted.contains(&phrase) {
                    wanted.push(phrase);
                }
            }
        }
        join(wanted.into_iter(), "or")
    }

    /// The words that it may be.
    #[must_use]
    pub fn words(self) -> Vec<&'static str> {
        match self {
            Self::Choice(words) => words.to_vec(),
            Self::OneOf(types) => types.iter().flat_map(|of| of.words()).collect(),
            _ => Vec::new(),
        }
    }

    fn plural(self) -> String {
        match self {
            Self::Any => "values".to_owned(),
            Self::None => "none".to_owned(),
            Self::Bool => "truth values".to_owned(),
            Self::Ratio => "numbers without units".to_owned(),
            Self::Count | Self::Integer => "whole numbers".to_owned(),
            Self::Text => "strings".to_owned(),
            Self::Mesh => "meshes".to_owned(),
            Self::Choice(words) => quoted(words),
            Self::List(of, _) => format!("lists of {}", of.plural()),
            Self::OneOf(types) => join(named(types).map(|of| of.plural()), "or"),
            Self::Geometry | Self::Grid(_) => self.to_string(),
            _ => format!("{self}s"),
        }
    }
}

/// Those that messages name: nobody has to be told of `none`.
fn named(types: &[Type]) -> impl Iterator<Item = &Type> {
    types.iter().filter(|of| **of != Type::None)
}

/// `"a", "b" or "c"`.
fn quoted(words: &[&str]) -> String {
    join(words.iter().map(|word| format!("\"{word}\"")), "or")
}

/// `a, b or c`.
fn join(words: impl Iterator<Item = String>, last: &str) -> String {
    let mut words: Vec<String> = words.collect();
    let Some(end) = words.pop() else { return String::new() };
    if words.is_empty() { end } else { format!("{} {last} {end}", words.join(", ")) }
}

/// As in a signature.
impl fmt::Display for Type {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Any => "any",
            Self::None => "none",
            Self::Bool => "bool",
            Self::Number | Self::Ratio => "number",
            Self::Count | Self::Integer => "integer",
            Self::Length => "length",
            Self::Quantity(name) => name,
            Self::Angle => "angle",
            Self::Text => "string",
            Self::Point => "point",
            Self::Range => "range",
            Self::Record => "record",
            Self::Function => "function",
            Self::Curve => "curve",
            Self::Surface => "surface",
            Self::Region => "region",
            Self::Face => "face",
            Self::Solid => "solid",
            Self::Mesh => "mesh",
            Self::Table => "table",
            Self::Plane => "plane",
            Self::Geometry => "geometry",
            Self::Choice(words) => {
                return write!(
                    f,
                    "{}",
                    words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(" | ")
                );
            }
            Self::List(of, _) => return write!(f, "list of {}", of.plural()),
            Self::Grid(of) => return write!(f, "grid of {}", of.plural()),
            Self::OneOf(types) => {
                return write!(
                    f,
                    "{}",
                    types.iter().map(ToString::to_string).collect::<Vec<_>>().join(" | ")
                );
            }
        })
    }
}
