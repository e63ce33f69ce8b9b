//! Equality of values, exact (`==`) and within a tolerance (`~=`).

use std::sync::Arc;

use super::{Dimension, Function, Number, Value};

/// Exact equality; `None` when two numbers of different dimension meet.
///
/// Values of different kinds are unequal; lists of different length are unequal.
#[must_use]
#[expect(clippy::float_cmp, reason = "exact equality is what `==` means")]
pub fn equal(a: &Value, b: &Value) -> Option<bool> {
    if a.is_jet() || b.is_jet() {
        return equal(&a.looked_at(), &b.looked_at());
    }
    Some(match (a, b) {
        (Value::None, Value::None) => true,
        (Value::Bool(a), Value::Bool(b)) => a == b,
        (Value::Number(a), Value::Number(b)) => {
            common(*a, *b)?;
            a.value == b.value
        }
        (Value::Text(a), Value::Text(b)) => a == b,
        (Value::Point(a), Value::Point(b)) => a == b,
        (Value::Range(a), Value::Range(b)) => a == b,
        (Value::List(a), Value::List(b)) => {
            a.is_same(b) || (a.len() == b.len() && all_equal(a.iter().zip(b.iter()))?)
        }
        (Value::Record(a), Value::Record(b)) => {
            a.len() == b.len()
                && all_some(a.iter().map(|(label, value)| b.get(label).map(|other| (value, other))))
                    .map_or(Some(false), |pairs| all_equal(pairs.into_iter()))?
        }
        (Value::Curve(a), Value::Curve(b)) => a == b,
        (Value::Surface(a), Value::Surface(b)) => a == b,
        (Value::Region(a), Value::Region(b)) => a == b,
        (Value::Face(a), Value::Face(b)) => a == b,
        (Value::Solid(a), Value::Solid(b)) => a == b,
        (Value::Mesh(a), Value::Mesh(b)) => a == b,
        (Value::Table(a), Value::Table(b)) => a == b,
        (Value::Frame(a), Value::Frame(b)) => a == b,
        (Value::Function(a), Value::Function(b)) => same_function(a, b),
        _ => false,
    })
}

fn common(a: Number, b: Number) -> Option<Dimension> {
    a.dim.common(b.dim)
}

fn all_equal<'a>(pairs: impl Iterator<Item = (&'a Value, &'a Value)>) -> Option<bool> {
    for (a, b) in pairs {
        if !equal(a, b)? {
            return Some(false);
        }
    }
    Some(true)
}

fn all_some<T>(items: impl Iterator<Item = Option<T>>) -> Option<Vec<T>> {
    items.collect()
}

fn same_function(a: &Function, b: &Function) -> bool {
    match (a, b) {
        (Function::Builtin(a, _), Function::Builtin(b, _)) => a == b,
        (Function::Closure(a), Function::Closure(b)) => Arc::ptr_eq(a, b),
        (Function::Partial(a), Function::Partial(b)) => Arc::ptr_eq(a, b),
        _ => false,
    }
}

/// How far two values are apart under `~=`.
#[derive(Clone, Debug, PartialEq)]
pub enum Discrepancy {
    /// The largest distance of numbers or points in them, and the path that leads to it:
    /// `[3].x` inside a list of records.
    Apart(f64, String),
    /// They cannot be near: lengths, labels or values without a distance differ. The text tells
    /// what differs.
    Different(String),
    /// The two kinds of number cannot be compared, or the values have no distance at all.
    Incomparable(String),
}

/// The deviation of two values; numbers by difference, points by distance, lists, records and
/// tables by their worst element.
#[must_use]
pub fn deviation(a: &Value, b: &Value) -> Discrepancy {
    if a.is_jet() || b.is_jet() {
        return deviation(&a.looked_at(), &b.looked_at());
    }
    match (a, b) {
        (Value::Number(x), Value::Number(y)) => match common(*x, *y) {
            Some(_) => Discrepancy::Apart((x.value - y.value).abs(), String::new()),
            None => Discrepancy::Incomparable(format!("{} against {}", a.phrase(), b.phrase())),
        },
        (Value::Point(a), Value::Point(b)) => Discrepancy::Apart(a.distance(*b), String::new()),
        (Value::List(xs), Value::List(ys)) if xs.len() == ys.len() => worst(
            xs.iter()
                .zip(ys.iter())
                .enumerate()
                .map(|(i, (x, y))| (format!("[{i}]"), deviation(x, y))),
        ),
        (Value::List(xs), Value::List(ys)) => {
            Discrepancy::Different(format!("lists of {} and {} elements", xs.len(), ys.len()))
        }
        (Value::Record(xs), Value::Record(ys)) => match all_some(
            xs.iter()
                .map(|(label, x)| ys.get(label).map(|y| (format!(".{label}"), deviation(x, y)))),
        ) {
            Some(pairs) if xs.len() == ys.len() => worst(pairs.into_iter()),
            _ => Discrepancy::Different("records with different labels".to_owned()),
        },
        (Value::Table(xs), Value::Table(ys)) => table_deviation(xs, ys),
        (Value::Bool(_) | Value::Text(_) | Value::None, _) if a.kind() == b.kind() => {
            if equal(a, b) == Some(true) {
                Discrepancy::Apart(0.0, String::new())
            } else {
                Discrepancy::Different(format!("{a} and {b}"))
            }
        }
        _ => Discrepancy::Incomparable(format!("{} against {}", a.phrase(), b.phrase())),
    }
}

/// The worst of the parts: what cannot be compared first, then what differs, then the distance.
fn worst(parts: impl Iterator<Item = (String, Discrepancy)>) -> Discrepancy {
    let mut found = Discrepancy::Apart(0.0, String::new());
    for (step, part) in parts {
        match (part, &found) {
            (Discrepancy::Incomparable(what), _) => {
                return Discrepancy::Incomparable(format!("{what} at {step}"));
            }
            (_, Discrepancy::Different(_)) => {}
            (Discrepancy::Different(what), _) => {
                found = Discrepancy::Different(format!("{what} at {step}"));
            }
            (Discrepancy::Apart(distance, path), Discrepancy::Apart(most, so_far)) => {
                if *most < distance || (so_far.is_empty() && distance == 0.0) {
                    found = Discrepancy::Apart(distance, format!("{step}{path}"));
                }
            }
            (Discrepancy::Apart(..), Discrepancy::Incomparable(_)) => {}
        }
    }
    found
}

fn table_deviation(a: &crate::kernel::Table, b: &crate::kernel::Table) -> Discrepancy {
    let (names_a, names_b): (Vec<&str>, Vec<&str>) = (
        a.columns().iter().map(|column| column.name.as_str()).collect(),
        b.columns().iter().map(|column| column.name.as_str()).collect(),
    );
    if names_a != names_b {
        return Discrepancy::Different("tables with different columns".to_owned());
    }
    worst(names_a.into_iter().map(|name| {
        let column = |table| super::field::column(table, name).unwrap_or(Value::None);
        (format!(".{name}"), deviation(&column(a), &column(b)))
    }))
}
