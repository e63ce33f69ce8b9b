//! How much was evaluated for an entry, and what came of it.

use super::engine::EngineRun;

/// What was evaluated for an entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum EvaluatedExtent {
    /// All of the document.
    Whole,
    /// What the entry concerns; the rest is as it was.
    Part,
}

/// What came of an entry that was to be evaluated in part.
pub(super) enum PartRun {
    /// All of it holds, and nothing is to be told.
    Holds(Box<EngineRun>),
    /// It was stopped.
    Stopped,
    /// All of the document has to be evaluated, which also tells whatever there is to tell.
    WantsAll,
}
