//! Records: values under labels, in the order in which they were written.

use std::{collections::HashMap, sync::Arc};

use super::{Value, list::ValueExtent};
use crate::limits::work;

/// Labelled values. Labels are unique; the order is the script's.
#[derive(Clone, Debug, Default)]
pub struct Record {
    fields: Vec<(Arc<str>, Value)>,
    extent: ValueExtent,
    /// Where each label stands, where there are more than a few.
    places: Option<Arc<HashMap<Arc<str>, usize>>>,
}

/// Fields up to which one looks through them for a label.
const FEW: usize = 16;

impl Record {
    /// A record; of a label given twice, which no script can write, the last value counts.
    pub fn new(fields: impl IntoIterator<Item = (Arc<str>, Value)>) -> Self {
        let mut record = Self::default();
        let mut places: HashMap<Arc<str>, usize> = HashMap::new();
        for (label, value) in fields {
            work::count(1);
            let known = match record.fields.len() {
                ..=FEW => record.place(&label),
                _ => places.get(&label).copied(),
            };
            if let Some(known) = known {
                record.fields[known].1 = value;
                continue;
            }
            record.fields.push((label, value));
            let (n, fields) = (record.fields.len(), &record.fields);
            let new = if n == FEW + 1 { 0 } else { n - 1 };
            if FEW < n {
                places.extend((new..n).map(|idx| (Arc::clone(&fields[idx].0), idx)));
            }
        }
        record.places = (!places.is_empty()).then(|| Arc::new(places));
        record.extent = ValueExtent::around(record.fields.iter().map(|(_, value)| value));
        record
    }

    /// The record of what becomes of each value; none where nothing becomes of one.
    pub(crate) fn mapped(&self, mut of: impl FnMut(&Value) -> Option<Value>) -> Option<Self> {
        let field = |(label, value): &(Arc<str>, Value)| Some((Arc::clone(label), of(value)?));
        Some(Self::new(self.fields.iter().map(field).collect::<Option<Vec<_>>>()?))
    }

    /// Where a label stands.
    fn place(&self, label: &str) -> Option<usize> {
        match &self.places {
            Some(places) => places.get(label).copied(),
            None => {
                work::count(self.fields.len() as u64);
                self.fields.iter().position(|(known, _)| &**known == label)
            }
        }
    }

    /// How deep and how large it is.
    #[must_use]
    pub fn extent(&self) -> ValueExtent {
        self.extent
    }

    /// The value under `label`.
    #[must_use]
    pub fn get(&self, label: &str) -> Option<&Value> {
        self.place(label).map(|idx| &self.fields[idx].1)
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
