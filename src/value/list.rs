//! Lists: values in order, shared and never changed, that know how deep and how large they are.
//!
//! Numbers of one dimension lie side by side, a quarter of the size of values. Whoever wants them
//! as values gets those too; they are spelled out once, on first demand.

use std::{
    fmt,
    ops::Deref,
    sync::{Arc, OnceLock},
};

use super::{Dim, FromValue, Mismatch, Number, Type, Value};
use crate::diag::Span;

/// How deep and how large a value is, told without walking through it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Extent {
    /// Lists, records and functions inside one another.
    pub depth: u32,
    /// Values in it; what stands in it twice counts twice, also where it is shared.
    pub size: u64,
    /// Whether functions of the script stand in it: they point into its text.
    pub holds_functions: bool,
}

impl Extent {
    /// The extent of something that holds no values.
    pub(super) const ATOM: Self = Self { depth: 0, size: 1, holds_functions: false };

    /// The extent of something that holds `values`.
    pub(super) fn around<'v>(values: impl IntoIterator<Item = &'v Value>) -> Self {
        let whole = Self { depth: 1, ..Self::ATOM };
        values.into_iter().map(Value::extent).fold(whole, |whole, part| Self {
            depth: whole.depth.max(part.depth.saturating_add(1)),
            size: whole.size.saturating_add(part.size),
            holds_functions: whole.holds_functions || part.holds_functions,
        })
    }
}

/// A list. Cheap to clone.
#[derive(Clone, Debug)]
pub struct List {
    items: Items,
    extent: Extent,
}

#[derive(Clone, Debug)]
enum Items {
    Values(Arc<[Value]>),
    Numbers(Arc<Numbers>),
}

/// Numbers of one dimension.
struct Numbers {
    values: Vec<f64>,
    dim: Dim,
    /// The same as values, once somebody wanted them.
    spelled: OnceLock<Box<[Value]>>,
}

impl Numbers {
    fn value(&self, value: f64) -> Value {
        Value::Number(Number { value, dim: self.dim })
    }
}

/// Whether somebody wanted the values does not show.
impl fmt::Debug for Numbers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { values, dim, spelled: _ } = self;
        f.debug_struct("Numbers").field("values", values).field("dim", dim).finish()
    }
}

impl List {
    /// The list of finite numbers of one dimension.
    #[must_use]
    pub fn of_numbers(values: Vec<f64>, dim: Dim) -> Self {
        let extent = Extent { depth: 1, size: 1 + values.len() as u64, ..Extent::ATOM };
        let numbers = Numbers { values, dim, spelled: OnceLock::new() };
        Self { items: Items::Numbers(Arc::new(numbers)), extent }
    }

    /// How deep and how large it is.
    #[must_use]
    pub fn extent(&self) -> Extent {
        self.extent
    }

    /// How many elements it has.
    #[must_use]
    pub fn len(&self) -> usize {
        match &self.items {
            Items::Values(values) => values.len(),
            Items::Numbers(numbers) => numbers.values.len(),
        }
    }

    /// Whether it has none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// An element.
    #[must_use]
    pub fn get(&self, idx: usize) -> Option<Value> {
        match &self.items {
            Items::Values(values) => values.get(idx).cloned(),
            Items::Numbers(numbers) => numbers.values.get(idx).map(|&value| numbers.value(value)),
        }
    }

    /// Its elements in order.
    pub fn values(&self) -> impl Iterator<Item = Value> + '_ {
        (0..self.len()).filter_map(|idx| self.get(idx))
    }

    /// Its elements, where it holds them as numbers of one dimension.
    #[must_use]
    pub fn numbers(&self) -> Option<(&[f64], Dim)> {
        match &self.items {
            Items::Values(_) => None,
            Items::Numbers(numbers) => Some((&numbers.values, numbers.dim)),
        }
    }

    /// The elements of `range`, which lies inside.
    #[must_use]
    pub fn slice(&self, range: std::ops::Range<usize>) -> Self {
        match &self.items {
            Items::Values(values) => values[range].iter().cloned().collect(),
            Items::Numbers(numbers) => {
                Self::of_numbers(numbers.values[range].to_vec(), numbers.dim)
            }
        }
    }

    /// Whether both are one list in memory, and so equal.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        match (&self.items, &other.items) {
            (Items::Values(own), Items::Values(other)) => Arc::ptr_eq(own, other),
            (Items::Numbers(own), Items::Numbers(other)) => Arc::ptr_eq(own, other),
            _ => false,
        }
    }
}

impl Deref for List {
    type Target = [Value];

    fn deref(&self) -> &[Value] {
        match &self.items {
            Items::Values(values) => values,
            Items::Numbers(numbers) => numbers
                .spelled
                .get_or_init(|| numbers.values.iter().map(|&value| numbers.value(value)).collect()),
        }
    }
}

/// The numbers, if all are such and of one dimension, and enough that it pays.
fn all_numbers(items: &[Value]) -> Option<(Vec<f64>, Dim)> {
    /// Elements from which on numbers are held as such.
    const WORTH: usize = 64;
    let Some(Value::Number(Number { dim, .. })) = items.first() else { return None };
    let number = |item: &Value| match item {
        Value::Number(number) if number.dim == *dim => Some(number.value),
        _ => None,
    };
    if items.len() < WORTH {
        return None;
    }
    Some((items.iter().map(number).collect::<Option<_>>()?, *dim))
}

impl From<Vec<Value>> for List {
    fn from(items: Vec<Value>) -> Self {
        if let Some((values, dim)) = all_numbers(&items) {
            return Self::of_numbers(values, dim);
        }
        Self { extent: Extent::around(&items), items: Items::Values(Arc::from(items)) }
    }
}

impl FromIterator<Value> for List {
    fn from_iter<I: IntoIterator<Item = Value>>(items: I) -> Self {
        let items: Arc<[Value]> = items.into_iter().collect();
        Self { extent: Extent::around(items.iter()), items: Items::Values(items) }
    }
}

/// A list as an argument; a range of whole numbers is as good as its list.
impl FromValue for List {
    const TYPE: Type = Type::List(&Type::Any, 0);

    fn from_value(value: &Value, _: Span) -> Result<Self, Mismatch> {
        Self::of(value, Self::TYPE)
    }
}

impl List {
    /// The elements of a list, or of a range of whole numbers.
    pub(super) fn of(value: &Value, wanted: Type) -> Result<Self, Mismatch> {
        match value {
            Value::List(items) => Ok(items.clone()),
            Value::Range(range) => match range.integers() {
                Some((start, count)) => {
                    let values = (0..count).map(|i| (start + i as i64) as f64).collect();
                    Ok(Self::of_numbers(values, Dim::NONE))
                }
                None => Err(Mismatch::kind(wanted, value)),
            },
            _ => Err(Mismatch::kind(wanted, value)),
        }
    }
}
