//! The elements that a comprehension or a spread runs through.

use std::ops::Range;

use crate::{
    kernel::Table,
    value::{Dimension, List, Number, Value, table_row},
};

/// What a comprehension or a spread runs through.
pub(super) enum Items<'v> {
    /// Elements of a list.
    List(std::slice::Iter<'v, Value>),
    /// Elements of a list that holds them as numbers.
    Numbers(std::slice::Iter<'v, f64>, Dimension),
    /// Rows of a table.
    Rows(&'v Table, Range<usize>),
    /// The next whole number and how many are left.
    Integers(i64, usize),
}

impl<'v> Items<'v> {
    /// The elements of a list from and to these places, which lie inside.
    pub(super) fn of(list: &'v List, range: Range<usize>) -> Self {
        match list.numbers() {
            Some((values, dim)) => Self::Numbers(values[range].iter(), dim),
            None => Self::List(list[range].iter()),
        }
    }
}

impl Iterator for Items<'_> {
    type Item = Value;

    fn next(&mut self) -> Option<Value> {
        match self {
            Self::List(items) => items.next().cloned(),
            Self::Numbers(items, dim) => {
                items.next().map(|&value| Value::Number(Number { value, dim: *dim }))
            }
            Self::Rows(table, rows) => rows.next().map(|row| table_row(table, row)),
            Self::Integers(_, 0) => None,
            Self::Integers(next, left) => {
                let value = Value::number(*next as f64);
                (*next, *left) = (*next + 1, *left - 1);
                Some(value)
            }
        }
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let n = match self {
            Self::List(items) => items.len(),
            Self::Numbers(items, _) => items.len(),
            Self::Rows(_, rows) => rows.len(),
            Self::Integers(_, left) => *left,
        };
        (n, Some(n))
    }
}

impl ExactSizeIterator for Items<'_> {}
