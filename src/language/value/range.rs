//! Ranges `a..b` and `a..<b`: over integers something to iterate, over numbers an interval.

use std::fmt;

use super::{Dimension, Number, Real};
use crate::kernel::Interval;

/// A range as it was written; `start` above `end` is empty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Its start.
    pub start: Number,
    /// Its end.
    pub end: Number,
    /// Whether the end belongs to it: `..` against `..<`.
    pub closed: bool,
}

/// A range in a function that is differentiated, one end of which carries derivatives at least.
#[derive(Clone, Debug, PartialEq)]
pub struct JetRange {
    /// Its start.
    pub start: Number<Real>,
    /// Its end.
    pub end: Number<Real>,
    /// Whether the end belongs to it.
    pub closed: bool,
}

impl JetRange {
    /// The range without derivatives.
    #[must_use]
    pub fn looked_at(&self) -> Range {
        let (start, end) = (self.start.looked_at(), self.end.looked_at());
        Range { start, end, closed: self.closed }
    }
}

impl Range {
    /// First whole number and how many there are; `None` unless both ends are whole.
    #[must_use]
    pub fn integers(&self) -> Option<(i64, usize)> {
        let (start, end) = (self.start.as_integer()?, self.end.as_integer()?);
        let count = end.checked_sub(start)?.checked_add(i64::from(self.closed))?;
        Some((start, usize::try_from(count).unwrap_or(0)))
    }
}

impl From<Interval> for Range {
    fn from(interval: Interval) -> Self {
        let [start, end] = [interval.start(), interval.end()].map(Number::bare);
        Self { start, end, closed: true }
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(None))
    }
}

impl Range {
    /// The text of the range, its ends with their units where the document's unit of length is given.
    pub(super) fn text(&self, unit: Option<&str>) -> String {
        let dots = if self.closed { ".." } else { "..<" };
        format!("{}{dots}{}", self.start.text(unit), self.end.text(unit))
    }
}

impl Number {
    /// The common dimension with the other end of a range; beside an angle a bare number is 0 or says nothing.
    #[must_use]
    pub fn beside(self, other: Self) -> Option<Dimension> {
        let is_said = |number: Self| number.dim.angle_power() != 0 || number.value.abs() <= 0.0;
        let common = self.dim.common(other.dim)?;
        (common.angle_power() == 0 || is_said(self) && is_said(other)).then_some(common)
    }
}
