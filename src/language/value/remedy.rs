//! What to write where a value of another kind was given: the slips of people who come from other
//! languages.

use super::{Type, Value};

impl Type {
    /// What to write instead of `value`, where something of this type is wanted.
    #[must_use]
    pub fn remedy(self, value: &Value) -> Option<String> {
        let hint = match (self, value) {
            (Self::OneOf(types), _) => {
                return types.iter().find_map(|of| of.remedy(value));
            }
            (Self::List(of, _) | Self::Grid(of), Value::List(items)) => {
                // The first element that does not fit.
                let stranger = items.values().find(|item| !of.accepts(item))?;
                return of.remedy(&stranger);
            }
            (Self::List(of, _), single) if !matches!(of, Self::Any) && of.accepts(single) => {
                "a list of one element is written `[x]`"
            }
            (Self::List(Self::Any, _), Value::Table(_)) => {
                "`[...t]` is the list of its rows, as records"
            }
            (Self::List(Self::Any, _), Value::Record(_)) => {
                "a record has no order; a list is written `[a, b]`"
            }
            // Of things that may stand as the arguments themselves.
            (Self::List(Self::OneOf(types), _), single) => {
                return types.iter().find_map(|of| of.remedy(single));
            }
            (Self::Region | Self::Face | Self::Solid, _)
            | (
                Self::Mesh,
                Value::Surface(_) | Value::Region(_) | Value::Face(_) | Value::Solid(_),
            ) => return self.maker(value).map(str::to_owned),
            (Self::Point, Value::Number(_)) => {
                "a point or vector is written `(x, y)` or `(x, y, z)`"
            }
            (Self::Point, Value::List(items)) if is_coordinates(items.values()) => {
                "a point stands in round brackets: `(x, y)`; of lists, as in data, `[for p in ps: (p[0], p[1])]` makes points"
            }
            (Self::Range, Value::Number(_)) => "a range is written `0..1`",
            (Self::Range, Value::List(items)) if is_coordinates(items.values()) => {
                "a range is written `0..1`"
            }
            (Self::Plane, Value::Text(_) | Value::Point(_) | Value::List(_)) => {
                "a plane is `XY`, `YZ`, `ZX`, or made by `plane(origin, normal)`"
            }
            (Self::Curve, Value::List(items)) => match items.first() {
                Some(Value::Point(_)) => {
                    "`polyline(points)` and `interpolate(points)` make a curve of points"
                }
                Some(Value::Curve(_)) => "`join(curves)` makes one curve of several",
                _ => return None,
            },
            (Self::Surface | Self::Mesh, Value::Curve(_)) => {
                "`planar_mesh(c)` fills a closed curve, `extrude` and `revolve` make surfaces of one"
            }
            (
                Self::Number
                | Self::Ratio
                | Self::Count
                | Self::Integer
                | Self::Length
                | Self::Angle,
                Value::Text(_),
            ) => "a number stands without quotes",
            _ => return None,
        };
        Some(hint.to_owned())
    }

    /// What makes one of this kind, which has parts, of `value`.
    fn maker(self, value: &Value) -> Option<&'static str> {
        let is_surface = |value: &Value| matches!(value, Value::Surface(_));
        Some(match (self, value) {
            (Self::Region, Value::Curve(_)) => "`region(c)` is what lies within a closed curve",
            (Self::Mesh, Value::Surface(_)) => {
                "`tessellate(s)` makes a mesh of surfaces that close"
            }
            (Self::Mesh, _) => "`tessellate(s)` makes a mesh of it",
            (Self::Face, Value::Surface(_)) => "`face(s)` makes a face of a surface",
            (Self::Solid, Value::Surface(_)) => "`solid(s)` is what surfaces that close enclose",
            (Self::Solid, Value::List(items)) if items.first().is_some_and(is_surface) => {
                "`solid(s)` is what surfaces that close enclose"
            }
            _ => return None,
        })
    }
}

/// Whether so many numbers could be meant as a point.
fn is_coordinates(items: impl Iterator<Item = Value>) -> bool {
    let items: Vec<Value> = items.take(4).collect();
    (2..=3).contains(&items.len()) && items.iter().all(|item| matches!(item, Value::Number(_)))
}
