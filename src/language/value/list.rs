//! Lists: values in order, shared and never changed, that know how deep and how large they are.
//!
//! Numbers of one dimension lie side by side, a quarter of the size of values. Whoever wants them
//! as values gets those too; they are spelled out once, on first demand.

use std::{
    fmt,
    ops::Deref,
    sync::{Arc, OnceLock},
};

use super::{Dimension, FromValue, Mismatch, Number, Type, Value, table_row};
use crate::diag::Span;

/// How deep and how large a value is, told without walking through it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ValueExtent {
    /// Lists, records and functions inside one another.
    pub depth: u32,
    /// Values in it; what stands in it twice counts twice, also where it is shared.
    pub size: u64,
    /// Whether functions of the script stand in it: they point into its text.
    pub holds_functions: bool,
}

impl ValueExtent {
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
    items: ListItems,
    extent: ValueExtent,
}

#[derive(Clone, Debug)]
enum ListItems {
    Values(Arc<[Value]>),
    /// With room for more, which takes memory beside each list.
    GrowingValues(Arc<Vec<Value>>),
    NumberList(Arc<NumberList>),
    Made(Arc<MadeList>),
}

/// As many values of no depth, each made when somebody asks for it.
struct MadeList {
    len: usize,
    make: Box<dyn Fn(usize) -> Value + Send + Sync>,
    /// All of them, once somebody wanted these.
    spelled: OnceLock<Box<[Value]>>,
}

/// Whether somebody wanted the values does not show.
impl fmt::Debug for MadeList {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries((0..self.len).map(&self.make)).finish()
    }
}

/// Numbers of one dimension.
struct NumberList {
    values: Vec<f64>,
    dim: Dimension,
    /// The same as values, once somebody wanted them.
    spelled: OnceLock<Box<[Value]>>,
}

impl NumberList {
    fn value(&self, value: f64) -> Value {
        Value::Number(Number { value, dim: self.dim })
    }

    /// Whether a value is a number of the dimension.
    fn holds(&self, value: &Value) -> bool {
        matches!(value, Value::Number(number) if number.dim == self.dim)
    }
}

/// Whether somebody wanted the values does not show.
impl fmt::Debug for NumberList {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { values, dim, spelled: _ } = self;
        f.debug_struct("Numbers").field("values", values).field("dim", dim).finish()
    }
}

impl List {
    /// The list of finite numbers of one dimension.
    #[must_use]
    pub fn of_numbers(values: Vec<f64>, dim: Dimension) -> Self {
        let extent = ValueExtent { depth: 1, size: 1 + values.len() as u64, ..ValueExtent::ATOM };
        let numbers = NumberList { values, dim, spelled: OnceLock::new() };
        Self { items: ListItems::NumberList(Arc::new(numbers)), extent }
    }

    /// The list of so many values of no depth that are made when they are asked for, always alike.
    #[must_use]
    pub(super) fn made(len: usize, make: Box<dyn Fn(usize) -> Value + Send + Sync>) -> Self {
        let extent = ValueExtent { depth: 1, size: 1 + len as u64, ..ValueExtent::ATOM };
        let made = MadeList { len, make, spelled: OnceLock::new() };
        Self { items: ListItems::Made(Arc::new(made)), extent }
    }

    /// Whether its elements are made when they are asked for.
    #[must_use]
    pub(crate) fn is_made(&self) -> bool {
        matches!(self.items, ListItems::Made(_))
    }

    /// The list of these values, to which more may be appended soon; a short one is copied then.
    pub(crate) fn growing(items: Vec<Value>) -> Self {
        if items.len() < WORTH {
            return Self::from(items);
        }
        if let Some((values, dim)) = all_numbers(&items) {
            return Self::of_numbers(values, dim);
        }
        let extent = ValueExtent::around(&items);
        Self { items: ListItems::GrowingValues(Arc::new(items)), extent }
    }

    /// How deep and how large it is.
    #[must_use]
    pub fn extent(&self) -> ValueExtent {
        self.extent
    }

    /// How many elements it has.
    #[must_use]
    pub fn len(&self) -> usize {
        match &self.items {
            ListItems::Values(values) => values.len(),
            ListItems::GrowingValues(values) => values.len(),
            ListItems::NumberList(numbers) => numbers.values.len(),
            ListItems::Made(made) => made.len,
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
            ListItems::Values(values) => values.get(idx).cloned(),
            ListItems::GrowingValues(values) => values.get(idx).cloned(),
            ListItems::NumberList(numbers) => {
                numbers.values.get(idx).map(|&value| numbers.value(value))
            }
            ListItems::Made(made) => match made.spelled.get() {
                Some(values) => values.get(idx).cloned(),
                None => (idx < made.len).then(|| (made.make)(idx)),
            },
        }
    }

    /// Its elements in order.
    pub fn values(&self) -> impl Iterator<Item = Value> + '_ {
        (0..self.len()).filter_map(|idx| self.get(idx))
    }

    /// Its elements, where it holds them as numbers of one dimension.
    #[must_use]
    pub fn numbers(&self) -> Option<(&[f64], Dimension)> {
        match &self.items {
            ListItems::Values(_) | ListItems::GrowingValues(_) | ListItems::Made(_) => None,
            ListItems::NumberList(numbers) => Some((&numbers.values, numbers.dim)),
        }
    }

    /// The elements of `range`, which lies inside.
    #[must_use]
    pub fn slice(&self, range: std::ops::Range<usize>) -> Self {
        match &self.items {
            ListItems::Values(_) | ListItems::GrowingValues(_) | ListItems::Made(_) => {
                self[range].iter().cloned().collect()
            }
            ListItems::NumberList(numbers) => {
                Self::of_numbers(numbers.values[range].to_vec(), numbers.dim)
            }
        }
    }

    /// Appends values where nobody else has this list and it is held as it would be then; else gives them back.
    ///
    /// # Errors
    /// The values, where all would have to be copied.
    pub(crate) fn append(&mut self, more: Vec<Value>) -> Result<(), Vec<Value>> {
        let extent = ValueExtent::around(&more);
        match &mut self.items {
            ListItems::GrowingValues(values) => match Arc::get_mut(values) {
                Some(values) => values.extend(more),
                None => return Err(more),
            },
            ListItems::NumberList(numbers) => match Arc::get_mut(numbers) {
                Some(numbers) if more.iter().all(|value| numbers.holds(value)) => {
                    numbers.spelled = OnceLock::new();
                    let number = |value: &Value| match value {
                        Value::Number(number) => Some(number.value),
                        _ => None,
                    };
                    numbers.values.extend(more.iter().filter_map(number));
                }
                _ => return Err(more),
            },
            ListItems::Values(_) | ListItems::Made(_) => return Err(more),
        }
        self.extent = ValueExtent {
            depth: self.extent.depth.max(extent.depth),
            size: self.extent.size.saturating_add(extent.size - 1),
            holds_functions: self.extent.holds_functions || extent.holds_functions,
        };
        Ok(())
    }

    /// Whether both are one list in memory, and so equal.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        match (&self.items, &other.items) {
            (ListItems::Values(own), ListItems::Values(other)) => Arc::ptr_eq(own, other),
            (ListItems::GrowingValues(own), ListItems::GrowingValues(other)) => {
                Arc::ptr_eq(own, other)
            }
            (ListItems::NumberList(own), ListItems::NumberList(other)) => Arc::ptr_eq(own, other),
            (ListItems::Made(own), ListItems::Made(other)) => Arc::ptr_eq(own, other),
            _ => false,
        }
    }
}

impl Deref for List {
    type Target = [Value];

    fn deref(&self) -> &[Value] {
        match &self.items {
            ListItems::Values(values) => values,
            ListItems::GrowingValues(values) => values,
            ListItems::NumberList(numbers) => numbers
                .spelled
                .get_or_init(|| numbers.values.iter().map(|&value| numbers.value(value)).collect()),
            ListItems::Made(made) => {
                made.spelled.get_or_init(|| (0..made.len).map(&made.make).collect())
            }
        }
    }
}

/// Elements from which on numbers are held as such, and more are appended in place.
const WORTH: usize = 64;

/// The numbers, if all are such and of one dimension, and enough that it pays.
fn all_numbers(items: &[Value]) -> Option<(Vec<f64>, Dimension)> {
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
        Self { extent: ValueExtent::around(&items), items: ListItems::Values(Arc::from(items)) }
    }
}

impl FromIterator<Value> for List {
    fn from_iter<I: IntoIterator<Item = Value>>(items: I) -> Self {
        let items: Arc<[Value]> = items.into_iter().collect();
        Self { extent: ValueExtent::around(items.iter()), items: ListItems::Values(items) }
    }
}

/// A list as an argument; a range of whole numbers is as good as its list.
impl FromValue for List {
    const TYPE: Type = Type::List(&Type::Any, 0);

    fn from_value(value: &Value, _: Span) -> Result<Self, Mismatch> {
        match value {
            Value::Table(table) => {
                Ok((0..table.n_rows()).map(|row| table_row(table, row)).collect())
            }
            _ => Self::of(value, Self::TYPE),
        }
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
                    Ok(Self::of_numbers(values, Dimension::NONE))
                }
                None => Err(Mismatch::kind(wanted, value)),
            },
            _ => Err(Mismatch::kind(wanted, value)),
        }
    }
}
