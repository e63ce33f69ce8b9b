//! The document of a prompt: statements in order, replaced by name, undone as a whole.

use std::{collections::HashMap, sync::Arc};

use super::{
    concerned::ConcernedPart,
    statement::{DocumentStatement, words},
};
use crate::{
    diag::Diagnostic,
    limits::Limits,
    syntax::{OutlinedStatement, StatementRole, parts, pieces},
};

/// Documents that `:undo` can go back to.
const MOST_UNDONE: usize = 200;

/// The statements so far. The documents of a history share what they have in common.
#[derive(Clone, Debug, Default)]
pub(super) struct PromptDocument {
    pieces: Vec<Arc<DocumentStatement>>,
}

/// A document on its way to the next one.
#[derive(Debug)]
pub(super) struct Draft {
    /// What is replaced.
    replaced: Vec<Arc<DocumentStatement>>,
    /// The part that has to be evaluated, where it is not all.
    pub(super) concerned: Option<ConcernedPart>,
    /// Names that go with what is replaced and are not defined again.
    pub(super) lost: Vec<String>,
    /// The document once the new statements hold.
    pub(super) next: PromptDocument,
}

impl Draft {
    /// Whether something of the document is replaced.
    pub(super) fn replaces(&self) -> bool {
        !self.replaced.is_empty()
    }

    /// What stays of the document as it is, for the evaluation.
    pub(super) fn base(&self, document: &PromptDocument) -> String {
        let mut replaced = self.replaced.iter().peekable();
        document.text_of(|piece| {
            let is_replaced =
                replaced.next_if(|next| std::ptr::eq(Arc::as_ptr(next), piece)).is_some();
            let is_evaluated = matches!(
                piece.role,
                StatementRole::Setting(_) | StatementRole::Definition | StatementRole::Check
            );
            is_evaluated && !is_replaced
        })
    }
}

impl PromptDocument {
    /// The statements of a text.
    ///
    /// # Errors
    /// What is wrong with the text.
    pub(super) fn of(text: &str, limits: &Limits) -> Result<Self, Vec<Diagnostic>> {
        let text = text.trim_start_matches('\u{feff}');
        let piece = |part: OutlinedStatement| {
            let text = text[part.range].trim_matches('\n').to_owned();
            let words = words(&text);
            Arc::new(DocumentStatement { text, role: part.role, names: part.names, words })
        };
        Ok(Self { pieces: parts(text, limits)?.into_iter().map(piece).collect() })
    }

    /// Whether it holds nothing.
    pub(super) fn is_empty(&self) -> bool {
        self.pieces.is_empty()
    }

    /// How many statements play a role.
    pub(super) fn count(&self, role: StatementRole) -> usize {
        self.pieces.iter().filter(|piece| piece.role == role).count()
    }

    /// Whether both are one script.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        let is_same = |(own, other): (&Arc<DocumentStatement>, &Arc<DocumentStatement>)| {
            Arc::ptr_eq(own, other) || own.text == other.text
        };
        let mut both = self.pieces.iter().zip(&other.pieces);
        self.pieces.len() == other.pieces.len() && both.all(is_same)
    }

    /// The whole as a script.
    pub(super) fn text(&self) -> String {
        self.pieces.iter().map(|piece| format!("{}\n", piece.text)).collect()
    }

    /// What a question can reach: the settings, the definitions of the names in it, of those in these, and so on;
    /// and those without a name, which may be imports that are called as their file. A name counts wherever it
    /// stands, also as a field or a label.
    pub(super) fn reached_from(&self, question: &str) -> String {
        let mut places: HashMap<&str, usize> = HashMap::new();
        for (idx, piece) in self.pieces.iter().enumerate() {
            places.extend(piece.names.iter().map(|name| (name.as_str(), idx)));
        }
        let mut is_reached: Vec<bool> = self
            .pieces
            .iter()
            .map(|piece| match piece.role {
                StatementRole::Setting(_) => true,
                StatementRole::Definition => piece.names.is_empty(),
                _ => false,
            })
            .collect();
        let reached = self.pieces.iter().zip(&is_reached).filter(|(_, is_reached)| **is_reached);
        let mut texts: Vec<&str> = reached.map(|(piece, _)| piece.text.as_str()).collect();
        texts.push(question);
        while let Some(text) = texts.pop() {
            for (_, range) in pieces(text) {
                let Some(&idx) = places.get(&text[range]) else { continue };
                if !std::mem::replace(&mut is_reached[idx], true) {
                    texts.push(&self.pieces[idx].text);
                }
            }
        }
        let reached = self.pieces.iter().zip(is_reached).filter(|(_, is_reached)| *is_reached);
        reached.map(|(piece, _)| format!("{}\n", piece.text)).collect()
    }

    /// Bytes of its statements.
    pub(super) fn n_bytes(&self) -> usize {
        self.pieces.iter().map(|piece| piece.text.len() + 1).sum()
    }

    /// The settings.
    pub(super) fn settings(&self) -> String {
        self.text_of(|piece| matches!(piece.role, StatementRole::Setting(_)))
    }

    /// What a question is asked of where all names count: settings and definitions.
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

    fn text_of(&self, mut is_wanted: impl FnMut(&DocumentStatement) -> bool) -> String {
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
        let (mut replaced, mut stays) = (Vec::new(), Vec::with_capacity(self.pieces.len()));
        for old in &self.pieces {
            if added.iter().any(|new| new.replaces(old)) {
                replaced.push(Arc::clone(old));
            } else {
                stays.push(&**old);
            }
        }
        let is_lost = |name: &&String| !added.iter().any(|new| new.names.contains(*name));
        let lost = replaced.iter().flat_map(|old| old.names.iter().filter(is_lost));
        let lost = lost.cloned().collect();
        let concerned = ConcernedPart::of_entry(&added, &replaced, &stays);
        added.retain(|piece| piece.role != StatementRole::Print);
        let mut next = self.clone();
        for piece in added {
            next.put(piece);
        }
        Ok(Draft { replaced, concerned, lost, next })
    }

    /// Puts a piece into the place of what it replaces, or at the end; a setting to the front.
    fn put(&mut self, piece: Arc<DocumentStatement>) {
        let place = self.pieces.iter().position(|old| piece.replaces(old));
        if place.is_some() {
            self.pieces.retain(|old| !piece.replaces(old));
        }
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
        assert_eq!(draft.base(&document), "let a = 1\ncheck a > 0\n");
        assert_eq!(draft.lost, ["c"]);
        assert_eq!(draft.next.text(), "let a = 1\nlet b = 7\ncheck a > 0\n");
        let draft = draft.next.draft("unit cm print a", &limits).unwrap();
        assert_eq!(draft.next.text(), "unit cm\nlet a = 1\nlet b = 7\ncheck a > 0\n");
        assert!(!draft.replaces());
    }

    #[test]
    fn a_question_reaches_what_its_names_do() {
        let text = "unit cm\nimport \"a.geo\"\nlet a = 1\nlet [b, c] = [a, 2]\nfn f(x) = \"{c}\"\nlet d = 4\ncheck d > 0";
        let document = PromptDocument::of(text, &Limits::DEFAULT).unwrap();
        let always = "unit cm\nimport \"a.geo\"\n";
        let reached = |question: &str| document.reached_from(question);
        assert_eq!(reached("1"), always);
        assert_eq!(reached("d + a"), format!("{always}let a = 1\nlet d = 4\n"));
        let of_f = "let a = 1\nlet [b, c] = [a, 2]\nfn f(x) = \"{c}\"\n";
        assert_eq!(reached("[for i in 0..3: f(i)]"), format!("{always}{of_f}"));
    }

    #[test]
    fn documents_are_one_where_their_statements_are() {
        let document = |text: &str| PromptDocument::of(text, &Limits::DEFAULT).unwrap();
        let one = document("let a = 1\nlet b = 2");
        assert!(one.is_same(&one.clone()) && one.is_same(&document("let a = 1\nlet b = 2")));
        assert!(!one.is_same(&document("let a = 1\nlet b = 3")));
        assert!(!one.is_same(&document("let a = 1")));
    }
}
