//! What an entry concerns of a document: its own statements, and those that use a name which the entry defines,
//! replaces or takes away. What they use besides stays as it is.

use std::{
    collections::{BTreeSet, HashMap, HashSet},
    sync::Arc,
};

use super::statement::{DocumentStatement, words};
use crate::syntax::StatementRole;

/// The part of a document that has to be evaluated for an entry.
#[derive(Debug)]
pub(super) struct ConcernedPart {
    /// The settings, and the statements that use what changes, in the order of the document.
    pub(super) base: String,
    /// Names that stand in the part and are not defined there.
    pub(super) used: Vec<String>,
    /// Whether it concerns statements besides those of the entry.
    pub(super) has_others: bool,
}

impl ConcernedPart {
    /// The part that a question concerns, below the settings of its document.
    pub(super) fn of_question(settings: String, question: &str) -> Self {
        let used = words(question).into_iter().map(String::from).collect();
        Self { base: settings, used, has_others: false }
    }

    /// The part that an entry concerns, which adds statements, replaces some, and lets the others stay. None where
    /// that cannot be told by names.
    pub(super) fn of_entry(
        added: &[Arc<DocumentStatement>],
        replaced: &[Arc<DocumentStatement>],
        stays: &[&DocumentStatement],
    ) -> Option<Self> {
        let is_told = |piece: &DocumentStatement| match piece.role {
            StatementRole::Definition => !piece.names.is_empty(),
            role => role == StatementRole::Print,
        };
        if !added.iter().chain(replaced).all(|piece| is_told(piece)) {
            return None;
        }
        let changed = added.iter().chain(replaced).flat_map(|piece| &piece.names);
        let users = users(changed.map(String::as_str).collect(), stays);
        if !users.iter().all(|&idx| stays[idx].role == StatementRole::Check || is_told(stays[idx]))
        {
            return None;
        }
        let is_part = |(idx, piece): &(usize, &&DocumentStatement)| {
            matches!(piece.role, StatementRole::Setting(_)) || users.contains(idx)
        };
        let part = stays.iter().enumerate().filter(is_part).map(|(_, piece)| *piece);
        let part: Vec<&DocumentStatement> = part.collect();
        let all = || added.iter().map(|piece| &**piece).chain(part.iter().copied());
        // What is replaced is known no more, also where nothing of its name comes instead.
        let gone = replaced.iter().map(|piece| &**piece);
        let own = all().chain(gone).flat_map(|piece| &piece.names).map(String::as_str);
        let own: HashSet<&str> = own.collect();
        let used: BTreeSet<&str> = all()
            .flat_map(|piece| &piece.words)
            .map(|word| &**word)
            .filter(|word| !own.contains(word))
            .collect();
        Some(Self {
            base: part.iter().map(|piece| format!("{}\n", piece.text)).collect(),
            used: used.into_iter().map(str::to_owned).collect(),
            has_others: !replaced.is_empty() || !users.is_empty(),
        })
    }
}

/// How far the users of users are looked for one after the other, each time in all statements. What is used by more
/// is looked up.
const FEW_ROUNDS: usize = 4;

/// Names up to which a word is compared with each.
const FEW_NAMES: usize = 8;

/// The definitions and checks that use one of these names, or one that such a definition has.
fn users<'p>(mut changed: Vec<&'p str>, stays: &[&'p DocumentStatement]) -> BTreeSet<usize> {
    let is_evaluated = |piece: &DocumentStatement| {
        matches!(piece.role, StatementRole::Definition | StatementRole::Check)
    };
    let pieces = || stays.iter().enumerate().filter(|(_, piece)| is_evaluated(piece));
    let mut found = BTreeSet::new();
    for _ in 0..FEW_ROUNDS {
        let many: HashSet<&str> = changed.iter().skip(FEW_NAMES).copied().collect();
        let few = &changed[..changed.len().min(FEW_NAMES)];
        let is_changed =
            |word: &str| few.contains(&word) || !many.is_empty() && many.contains(word);
        let uses = |piece: &DocumentStatement| piece.words.iter().any(|word| is_changed(word));
        let users = pieces().filter(|(_, piece)| uses(piece)).map(|(idx, _)| idx);
        let new: Vec<usize> = users.filter(|&idx| found.insert(idx)).collect();
        changed = new.iter().flat_map(|&idx| &stays[idx].names).map(String::as_str).collect();
        if changed.is_empty() {
            return found;
        }
    }
    let mut by_word: HashMap<&str, Vec<usize>> = HashMap::new();
    for (idx, piece) in pieces() {
        piece.words.iter().for_each(|word| by_word.entry(word).or_default().push(idx));
    }
    while let Some(name) = changed.pop() {
        let users = by_word.get(name).into_iter().flatten();
        let new: Vec<usize> = users.copied().filter(|&idx| found.insert(idx)).collect();
        changed.extend(new.iter().flat_map(|&idx| &stays[idx].names).map(String::as_str));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::super::document::PromptDocument;
    use crate::limits::Limits;

    /// The part that an entry concerns: the text before it, and the words in both.
    #[track_caller]
    fn check(entry: &str, expected: Option<(&str, &str)>) {
        let text = "unit cm\nlet a = 1\nlet [b, c] = [a, 2]\nfn f(x) = \"{c}\"\nlet d = length(4)\ncheck f(1) == d\ncurve line(a, a)";
        let document = PromptDocument::of(text, &Limits::DEFAULT).unwrap();
        let draft = document.draft(entry, &Limits::DEFAULT).unwrap();
        let part = draft.concerned.as_ref();
        let found = part.map(|part| (part.base.clone(), part.used.join(" ")));
        let expected = expected.map(|(base, used)| (base.to_owned(), used.to_owned()));
        assert_eq!(found, expected, "{entry}");
    }

    #[test]
    fn what_an_entry_concerns_is_what_uses_its_names() {
        check("let e = a + d", Some(("unit cm\n", "a cm d let unit")));
        let f = "unit cm\ncheck f(1) == d\n";
        check("fn f(x) = x", Some((f, "check cm d fn unit x")));
        let all = "unit cm\nfn f(x) = \"{c}\"\ncheck f(1) == d\n";
        check("let c = 7", Some((all, "check cm d fn let unit x")));
        // A name of a built-in means something else from now on.
        let users = "unit cm\nlet d = length(4)\ncheck f(1) == d\n";
        check("fn length(x) = x", Some((users, "check cm f fn let unit x")));
        // What has no name cannot be told apart, and a setting concerns everything.
        check("let a = 2", None);
        check("unit mm", None);
        check("check a > 0", None);
    }
}
