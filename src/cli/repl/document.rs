//! The document of a prompt: statements in order, replaced by name, undone as a whole.

use crate::{
    diag::Diagnostic,
    limits::Limits,
    syntax::{StatementRole, parts},
};

/// Documents that `:undo` can go back to.
const MOST_UNDONE: usize = 200;

/// A statement with the comments before it.
#[derive(Clone, Debug)]
struct DocumentStatement {
    text: String,
    role: StatementRole,
    names: Vec<String>,
}

/// The statements so far.
#[derive(Clone, Debug, Default)]
pub(super) struct PromptDocument {
    pieces: Vec<DocumentStatement>,
}

/// A document on its way to the next one.
#[derive(Debug)]
pub(super) struct Draft {
    /// What stays as it is, for the evaluation.
    pub(super) base: String,
    /// Whether something of the document is replaced.
    pub(super) replaces: bool,
    /// Names that go with what is replaced and are not defined again.
    pub(super) lost: Vec<String>,
    /// The document once the new statements hold.
    pub(super) next: PromptDocument,
}

impl PromptDocument {
    /// The statements of a text.
    ///
    /// # Errors
    /// What is wrong with the text.
    pub(super) fn of(text: &str, limits: &Limits) -> Result<Self, Vec<Diagnostic>> {
        let text = text.trim_start_matches('\u{feff}');
        let pieces = parts(text, limits)?.into_iter().map(|part| DocumentStatement {
            text: text[part.range].trim_matches('\n').to_owned(),
            role: part.role,
            names: part.names,
        });
        Ok(Self { pieces: pieces.collect() })
    }

    /// Whether it holds nothing.
    pub(super) fn is_empty(&self) -> bool {
        self.pieces.is_empty()
    }

    /// How many statements play a role.
    pub(super) fn count(&self, role: StatementRole) -> usize {
        self.pieces.iter().filter(|piece| piece.role == role).count()
    }

    /// The whole as a script.
    pub(super) fn text(&self) -> String {
        self.pieces.iter().map(|piece| format!("{}\n", piece.text)).collect()
    }

    /// What a question is asked of: settings and definitions.
    pub(super) fn definitions(&self) -> String {
        self.text_of(|piece| {
            matches!(piece.role, StatementRole::Setting(_) | StatementRole::Definition)
        })
    }

    /// What `:export` carries out: the exports with all that they need.
    pub(super) fn with_exports(&self) -> String {
        self.text_of(|piece| {
            matches!(
                piece.role,
                StatementRole::Setting(_) | StatementRole::Definition | StatementRole::Export
            )
        })
    }

    fn text_of(&self, is_wanted: impl Fn(&DocumentStatement) -> bool) -> String {
        let wanted = self.pieces.iter().filter(|piece| is_wanted(piece));
        wanted.map(|piece| format!("{}\n", piece.text)).collect()
    }

    /// The document with the statements of `input`: what they define takes the place of what had
    /// those names; what is only said, a `print`, is not kept.
    ///
    /// # Errors
    /// What is wrong with the input.
    pub(super) fn draft(&self, input: &str, limits: &Limits) -> Result<Draft, Vec<Diagnostic>> {
        let mut added = Self::of(input, limits)?.pieces;
        let base = Self { pieces: self.outside(&added) };
        let lost = self.lost(&added);
        let replaces = base.pieces.len() < self.pieces.len();
        added.retain(|piece| piece.role != StatementRole::Print);
        let mut next = self.clone();
        for piece in added {
            next.put(piece);
        }
        let base = base.text_of(|piece| {
            matches!(
                piece.role,
                StatementRole::Setting(_) | StatementRole::Definition | StatementRole::Check
            )
        });
        Ok(Draft { base, replaces, lost, next })
    }

    /// The pieces that none of `added` takes the place of.
    fn outside(&self, added: &[DocumentStatement]) -> Vec<DocumentStatement> {
        let stays = |old: &&DocumentStatement| !added.iter().any(|new| new.replaces(old));
        self.pieces.iter().filter(stays).cloned().collect()
    }

    /// Names of replaced pieces that nothing defines any more.
    fn lost(&self, added: &[DocumentStatement]) -> Vec<String> {
        let gone = self.pieces.iter().filter(|old| added.iter().any(|new| new.replaces(old)));
        let is_lost = |name: &&String| !added.iter().any(|new| new.names.contains(name));
        gone.flat_map(|old| old.names.iter().filter(is_lost).cloned()).collect()
    }

    /// Puts a piece into the place of what it replaces, or at the end; a setting to the front.
    fn put(&mut self, piece: DocumentStatement) {
        let place = self.pieces.iter().position(|old| piece.replaces(old));
        self.pieces.retain(|old| !piece.replaces(old));
        let end = self.pieces.len();
        let front = match piece.role {
            StatementRole::Setting("geo") => 0,
            StatementRole::Setting(_) => usize::from(
                self.pieces.first().is_some_and(|p| p.role == StatementRole::Setting("geo")),
            ),
            _ => end,
        };
        self.pieces.insert(place.unwrap_or(front).min(end), piece);
    }
}

impl DocumentStatement {
    /// Whether it takes the place of another one.
    fn replaces(&self, old: &Self) -> bool {
        match (self.role, old.role) {
            (StatementRole::Setting(a), StatementRole::Setting(b)) => a == b,
            _ => self.names.iter().any(|name| old.names.contains(name)),
        }
    }
}

/// The documents before, newest last, each with what `_` stood for.
#[derive(Debug, Default)]
pub(super) struct UndoHistory(Vec<(PromptDocument, Option<String>)>);

impl UndoHistory {
    /// Remembers a document.
    pub(super) fn push(&mut self, document: PromptDocument, last: Option<String>) {
        if self.0.len() == MOST_UNDONE {
            self.0.remove(0);
        }
        self.0.push((document, last));
    }

    /// The document before.
    pub(super) fn pop(&mut self) -> Option<(PromptDocument, Option<String>)> {
        self.0.pop()
    }
}

#[cfg(test)]
mod tests {
    use super::PromptDocument;
    use crate::limits::Limits;

    #[test]
    fn a_definition_takes_the_place_of_its_namesake() {
        let limits = Limits::DEFAULT;
        let document =
            PromptDocument::of("let a = 1\nlet [b, c] = [a, 2]\ncheck a > 0", &limits).unwrap();
        let draft = document.draft("let b = 7", &limits).unwrap();
        assert_eq!(draft.base, "let a = 1\ncheck a > 0\n");
        assert_eq!(draft.lost, ["c"]);
        assert_eq!(draft.next.text(), "let a = 1\nlet b = 7\ncheck a > 0\n");
        let draft = draft.next.draft("unit cm print a", &limits).unwrap();
        assert_eq!(draft.next.text(), "unit cm\nlet a = 1\nlet b = 7\ncheck a > 0\n");
        assert!(!draft.replaces);
    }
}
