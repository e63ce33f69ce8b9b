//! Lists: values in order, shared and never changed, that know how deep and how large they are.

use std::{ops::Deref, sync::Arc};

use super::{FromValue, Mismatch, Type, Value};
use crate::diag::Span;

/// How deep and how large a value is, told without walking through it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Extent {
    /// Lists, records and functions inside one another.
    pub depth: u32,
    /// Values in it; what stands in it twice counts twice, also where it is shared.
    pub size: u64,
}

impl Extent {
    /// The extent of something that holds `values`.
    pub(super) fn around<'v>(values: impl IntoIterator<Item = &'v Value>) -> Self {
        let whole = Self { depth: 1, size: 1 };
        values.into_iter().map(Value::extent).fold(whole, |whole, part| Self {
            depth: whole.depth.max(part.depth.saturating_add(1)),
            size: whole.size.saturating_add(part.size),
        })
    }
}

/// A list. Cheap to clone.
#[derive(Clone, Debug)]
pub struct List {
    items: Arc<[Value]>,
    extent: Extent,
}

impl List {
    /// How deep and how large it is.
    #[must_use]
    pub fn extent(&self) -> Extent {
        self.extent
    }

    /// Whether both are one list in memory, and so equal.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.items, &other.items)
    }
}

impl Deref for List {
    type Target = [Value];

    fn deref(&self) -> &[Value] {
        &self.items
    }
}

impl From<Vec<Value>> for List {
    fn from(items: Vec<Value>) -> Self {
        Self { extent: Extent::around(&items), items: Arc::from(items) }
    }
}

impl FromIterator<Value> for List {
    fn from_iter<I: IntoIterator<Item = Value>>(items: I) -> Self {
        let items: Arc<[Value]> = items.into_iter().collect();
        Self { extent: Extent::around(items.iter()), items }
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
                    Ok((0..count).map(|i| Value::number((start + i as i64) as f64)).collect())
                }
                None => Err(Mismatch::kind(wanted, value)),
            },
            _ => Err(Mismatch::kind(wanted, value)),
        }
    }
}
