//! A statement of the document of a prompt.

use crate::syntax::{Highlight, StatementRole, pieces};

/// A statement with the comments before it.
#[derive(Debug)]
pub(super) struct DocumentStatement {
    pub(super) text: String,
    pub(super) role: StatementRole,
    pub(super) names: Vec<String>,
    /// The words that stand in it, its own names too, each once.
    pub(super) words: Vec<Box<str>>,
}

/// The words of a text that can be names, each once.
pub(super) fn words(text: &str) -> Vec<Box<str>> {
    let is_word = |paint: &Highlight| matches!(paint, Highlight::Name | Highlight::Keyword);
    let found = pieces(text).into_iter().filter(|(paint, _)| is_word(paint));
    let mut words: Vec<Box<str>> =
        found.filter_map(|(_, range)| text.get(range)).map(Box::from).collect();
    words.sort_unstable();
    words.dedup();
    words
}
