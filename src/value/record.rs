//! Records: values under labels, in the order in which they were written.

use std::sync::Arc;

use super::{Value, list::Extent};

/// Labelled values. Labels are unique; the order is the script's.
#[derive(Clone, Debug, Default)]
pub struct Record {
    fields: Vec<(Arc<str>, Value)>,
    extent: Extent,
}

impl Record {
    /// A record; of a label given twice, which no script can write, the last value counts.
    pub fn new(fields: impl IntoIterator<Item = (Arc<str>, Value)>) -> Self {
        let mut record = Self::default();
        for (label, value) in fields {
            match record.fields.iter_mut().find(|(known, _)| *known == label) {
                Some(slot) => slot.1 = value,
                None => record.fields.push((label, value)),
            }
        }
        record.extent = Extent::around(record.fields.iter().map(|(_, value)| value));
        record
    }

    /// How deep and how large it is.
    #[must_use]
    pub fn extent(&self) -> Extent {
        self.extent
    }

    /// The value under `label`.
    #[must_use]
    pub fn get(&self, label: &str) -> Option<&Value> {
        self.fields.iter().find(|(known, _)| &**known == label).map(|(_, value)| value)
    }

    /// Labels and values in order.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Value)> {
        self.fields.iter().map(|(label, value)| (&**label, value))
    }

    /// How many fields there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.fields.len()
    }

    /// Whether there are no fields.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.fields.is_empty()
    }
}
