//! What could stand at a place of an entry, as `ide` tells it of the document with the entry behind
//! it; and commands with what stands behind them.

use std::{path::PathBuf, sync::Arc};

use super::{command::COMMANDS, document::PromptDocument};
use crate::{
    disk::{ScriptFiles, entries},
    ide::{Completion, CompletionKind, Document, Values},
    session::Session,
    syntax::open_call,
};

/// Bytes of a document up to which help is shown at each key.
const MOST_BYTES: usize = 256 << 10;

/// What the prompt knows of its document.
#[derive(Debug)]
pub(super) struct Scope {
    pub(super) session: Arc<Session>,
    /// The document.
    pub(super) document: PromptDocument,
    /// What they came to.
    pub(super) values: Arc<Values>,
    /// The folder that its files lie in.
    pub(super) folder: PathBuf,
}

/// Something that could stand at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Candidate {
    /// What is inserted.
    pub(super) text: String,
    /// What it is.
    pub(super) what: String,
}

impl Candidate {
    fn of(completion: Completion) -> Self {
        let what = match completion.kind {
            CompletionKind::Keyword => "keyword".to_owned(),
            CompletionKind::Label => format!("label: {}", completion.detail),
            _ => completion.detail,
        };
        Self { text: completion.insert, what }
    }
}

impl Scope {
    /// The document with the beginning of an entry behind it.
    fn document(&self, line: &str) -> Document {
        let (files, text) = (ScriptFiles::new(&self.folder), self.document.definitions());
        Document::new(&self.session, "input", &(text + line), &files)
    }

    /// Where the completed part of `line` begins, and what could stand there.
    pub(super) fn candidates(&self, line: &str) -> (usize, Vec<Candidate>) {
        let line_start = line.len() - line.trim_start().len();
        match line[line_start..].strip_prefix(':') {
            Some(command) => {
                let (start, found) = self.in_command(command);
                (line_start + 1 + start, found)
            }
            None => self.in_entry(line),
        }
    }

    fn in_entry(&self, line: &str) -> (usize, Vec<Candidate>) {
        let document = self.document(line);
        let end = document.text().len();
        let list = |below: &str| entries(&self.folder.join(below));
        let mut found = document.completions(&self.session, Some(&self.values), &list, end);
        let start = found.first().map_or(end, |first| first.range.start);
        let begun = document.text().get(start..).unwrap_or_default();
        // All are of one place, behind what is in the document already.
        found.retain(|one| one.range.start == start && one.insert.starts_with(begun));
        let start = start.saturating_sub(end - line.len());
        (start, found.into_iter().map(Candidate::of).collect())
    }

    /// A command, or what may stand behind it.
    fn in_command(&self, line: &str) -> (usize, Vec<Candidate>) {
        let Some((name, rest)) = line.split_once(char::is_whitespace) else {
            let fitting = COMMANDS.iter().filter(|command| command.name.starts_with(line));
            let candidate =
                |name: &str, what: &str| Candidate { text: name.to_owned(), what: what.to_owned() };
            return (0, fitting.map(|command| candidate(command.name, command.docs)).collect());
        };
        let rest = rest.trim_start();
        let start = line.len() - rest.len();
        let is_file = COMMANDS.iter().any(|known| known.takes_file && known.name == name);
        let (at, found) = if is_file { self.files(rest) } else { self.in_entry(rest) };
        (start + at, found)
    }

    /// The files and folders whose path begins with this.
    fn files(&self, begun: &str) -> (usize, Vec<Candidate>) {
        let start = begun.rfind('/').map_or(0, |slash| slash + 1);
        let (folder, stem) = begun.split_at(start);
        let found = entries(&self.folder.join(folder)).into_iter();
        let candidate = |(name, is_folder): (String, bool)| match is_folder {
            true => Candidate { text: name + "/", what: "folder".to_owned() },
            false => Candidate { text: name, what: "file".to_owned() },
        };
        let found = found.map(|entry| (entry.name, entry.is_folder));
        (start, found.filter(|(name, _)| name.starts_with(stem)).map(candidate).collect())
    }

    /// The argument that is being written at the end of `line`, as the signature of its call has it.
    pub(super) fn argument(&self, line: &str) -> Option<String> {
        open_call(line, line.len())?;
        if MOST_BYTES < self.document.n_bytes() {
            return None;
        }
        let document = self.document(line);
        let signatures =
            document.signatures(&self.session, Some(&self.values), document.text().len());
        let first = signatures.into_iter().next()?;
        Some(first.parameters.into_iter().nth(first.active?)?.label)
    }
}

#[cfg(test)]
mod tests {
    use std::{path::PathBuf, sync::Arc};

    use super::{super::document::PromptDocument, Scope};
    use crate::{ide::Values, session::Session, value::NoFiles};

    fn scope(text: &str) -> Scope {
        let session = Session::default();
        let report = session.run("document", text.as_bytes(), &NoFiles, &[]);
        Scope {
            document: PromptDocument::of(text, session.limits()).unwrap(),
            session: Arc::new(session),
            values: Arc::new(Values::new(Arc::new(report))),
            folder: PathBuf::from("."),
        }
    }

    const TEXT: &str = "let benchmark = (1mm, 2mm)\nfn half(height, by = 2) = height / by\n";

    #[track_caller]
    fn check(line: &str, start: usize, expected: &[(&str, &str)]) {
        let (at, found) = scope(TEXT).candidates(line);
        let found: Vec<(&str, &str)> =
            found.iter().map(|one| (one.text.as_str(), one.what.as_str())).collect();
        assert_eq!((at, found.as_slice()), (start, expected), "{line}");
    }

    #[test]
    fn names_members_labels_words_units_and_commands_are_completed() {
        check("let a = benc", 8, &[("benchmark", "(1, 2, 0)")]);
        check("benchmark.", 10, &[("x", "1"), ("y", "2"), ("z", "0")]);
        check("half(3, by", 8, &[("by = ", "label: by = 2")]);
        check("interpolate(p, ends = \"be", 23, &[("bessel", "")]);
        check("2i", 1, &[("in", "25.4 mm")]);
        check("param a: nu", 9, &[("number", "keyword")]);
        check(":lo", 1, &[("load", "puts a script into the place of the document")]);
        check(":show benc", 6, &[("benchmark", "(1, 2, 0)")]);
        check("// benc", 7, &[]);
    }

    #[test]
    fn labels_that_are_given_are_not_offered_again() {
        let labels = |line: &str| -> Vec<String> {
            let (_, found) = scope(TEXT).candidates(line);
            found.into_iter().map(|one| one.text).filter(|text| text.ends_with(" = ")).collect()
        };
        assert!(labels("circle((0, 0), 1, ").contains(&"normal = ".to_owned()));
        assert!(
            !labels("circle((0, 0), 1, normal = (0, 0, 1), ").contains(&"normal = ".to_owned())
        );
    }

    #[test]
    fn the_argument_that_is_written_is_told() {
        let told = |line: &str| scope(TEXT).argument(line);
        assert_eq!(told("half("), Some("height".to_owned()));
        assert_eq!(told("1 + half(3, "), Some("by = 2".to_owned()));
        assert!(told("circle((0, 0), ").is_some_and(|label| label.starts_with("radius")));
        assert_eq!((told("half(3)"), told("benchmark"), told("unknown(")), (None, None, None));
    }
}
