//! Entries that are evaluated in part: what they concern of the document, behind the values of the rest.

use std::{
    collections::HashSet,
    sync::{Arc, Weak},
};

use super::{document::Draft, part_run::PartRun, prompt::Prompt};
use crate::{eval::Defined, session::Report};

/// Definitions of a document for each entry that is evaluated in part before all is evaluated again, which
/// forgets what was replaced: with fewer more is kept in vain, with more more is evaluated.
const DEFINITIONS_FOR_AN_ENTRY: usize = 8;

impl Prompt {
    /// Whether the values of the document are those that its session would find: no file was read that may have
    /// changed, and the session remembers them.
    pub(super) fn values_hold(&self) -> bool {
        let session = Arc::downgrade(self.engine.session());
        Weak::ptr_eq(&self.values_of, &session) && self.engine.inputs().is_empty()
    }

    /// The definitions of the document that have one of these names.
    pub(super) fn known(&self, names: &[String]) -> Vec<Defined> {
        names.iter().filter_map(|name| self.values.defined(name)).cloned().collect()
    }

    /// Evaluates what an entry concerns.
    pub(super) fn joined(&mut self, draft: &Draft, text: &str) -> PartRun {
        let Some(part) = &draft.concerned else { return PartRun::WantsAll };
        let n_bytes = self.document.n_bytes() + text.len();
        let n_entries = (1 + self.n_joined) * DEFINITIONS_FOR_AN_ENTRY;
        if part.has_others && !self.told.is_empty()
            || !self.values_hold()
            || self.values.report().definitions.len() < n_entries
            || self.limits().source_bytes < n_bytes
        {
            return PartRun::WantsAll;
        }
        let known = self.known(&part.used);
        let Some(ran) = self.engine.run_joining(known, &part.base, text, ["document", "input"])
        else {
            return PartRun::Stopped;
        };
        let report = &ran.report;
        let holds = report.diagnostics.is_empty() && report.is_whole && self.values_hold();
        if holds { PartRun::Holds(Box::new(ran)) } else { PartRun::WantsAll }
    }

    /// How many definitions keep their values beside a part that was evaluated and what is lost: those that would be found again if
    /// all were, which functions are not.
    pub(super) fn n_beside(&self, report: &Report, lost: &[String]) -> usize {
        let names = report.definitions.iter().map(|defined| &defined.name).chain(lost);
        let names: HashSet<&str> = names.map(String::as_str).collect();
        let beside = self.defined().filter(|(name, _)| !names.contains(name));
        beside.filter(|(_, value)| !value.extent().holds_functions).count()
    }

    /// Keeps the values of a part of the document, the rest of which is as it was.
    pub(super) fn know_part(&mut self, report: &Report, lost: &[String]) {
        self.n_joined += 1;
        let is_taken =
            Arc::get_mut(&mut self.values).is_some_and(|values| values.take_in(report, lost));
        // Somebody else looks at them: the next entry evaluates all of the document.
        if !is_taken {
            self.values_of = Weak::new();
        }
    }
}
