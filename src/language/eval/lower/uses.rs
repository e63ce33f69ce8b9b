//! What a definition or an effect under way uses of the definitions around it.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use super::super::ir::Dependency;

/// How often a definition is used as a whole, and which of its fields are read.
#[derive(Default)]
struct Use {
    n_whole: usize,
    fields: BTreeSet<Arc<str>>,
}

/// The definitions that are used.
#[derive(Default)]
pub(super) struct Uses(BTreeMap<usize, Use>);

impl Uses {
    /// Notes a definition.
    pub(super) fn add(&mut self, definition: usize) {
        self.0.entry(definition).or_default().n_whole += 1;
    }

    /// Notes that of a definition, as it was noted last, no more than a field is read.
    pub(super) fn narrow(&mut self, definition: usize, field: &Arc<str>) {
        if let Some(used) = self.0.get_mut(&definition) {
            used.n_whole = used.n_whole.saturating_sub(1);
            used.fields.insert(Arc::clone(field));
        }
    }

    /// Notes what others are.
    pub(super) fn append(&mut self, others: Self) {
        for (definition, mut other) in others.0 {
            let used = self.0.entry(definition).or_default();
            used.n_whole += other.n_whole;
            used.fields.append(&mut other.fields);
        }
    }

    /// Forgets all.
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }

    /// The definitions, in ascending order.
    pub(super) fn definitions(&self) -> Vec<usize> {
        self.0.keys().copied().collect()
    }

    /// The same, with how they are used.
    pub(super) fn dependencies(&self) -> Vec<Dependency> {
        let dependency = |(&definition, used): (&usize, &Use)| {
            let fields = || used.fields.iter().cloned().collect();
            Dependency { definition, fields: (used.n_whole == 0).then(fields) }
        };
        self.0.iter().map(dependency).collect()
    }
}
