//! What an editor asks of a script while it is written: what is wrong, what a name is and is worth, what
//! could stand at a place, where a name is used.
//!
//! Knows no protocol and touches no file: places are bytes of a text, files come in through
//! [`Files`], and the doors translate. A [`Document`] is a text with the meaning of its names;
//! [`Values`] are what a run of it came to, which may take longer.

mod colors;
mod completion;
mod completion_fit;
mod completion_members;
mod completion_spot;
mod completion_words;
mod diagnostics;
mod edits;
mod format;
mod hints;
mod hover;
mod local_value;
mod measured;
mod names;
mod offered;
mod outline;
mod outline_walk;
mod owner;
mod position;
mod signature;
mod structure;
mod tokens;
mod values;
mod wanted_types;

use std::{ops::Range, sync::Arc};

pub use colors::{Color, colors, spellings};
pub use completion::{Completion, CompletionKind, FolderEntry};
pub use diagnostics::{Finding, SourceRange, fixes};
pub use edits::{TextEdit, applied};
pub use format::{formatted, formatted_lines};
pub use hints::{CodeLens, Hint, HintKind, HintOptions, LensKind};
pub use measured::CloserLook;
pub use names::{Occurrence, Rename};
pub use offered::offered;
pub use outline::{Act, ActKind, CallSite, DefinedName, NameRole, Outline};
pub use position::{ColumnUnit, LineColumn, LineIndex};
pub use signature::{CalledSignature, SignatureParameter};
pub use structure::{FoldingRange, Symbol};
pub use tokens::{SemanticToken, TokenKind};
pub use values::Values;
#[cfg(feature = "cli")]
pub(crate) use values::sized;

use crate::{
    diag::{Sources, Span},
    eval::NameUses,
    session::Session,
    syntax::{self, Highlight},
    value::Files,
};

/// A text with its names.
#[derive(Debug)]
pub struct Document {
    text: Arc<str>,
    lines: LineIndex,
    pieces: Vec<(Highlight, Range<usize>)>,
    outline: Outline,
    uses: NameUses,
    /// The text, and those that it imports.
    sources: Sources,
    /// Outlines of the imported texts.
    imported: Vec<Outline>,
    /// Outlines of the files whose imports do not parse yet, by the places of their paths.
    under_way: Vec<(Range<usize>, Outline)>,
}

impl Document {
    /// Looks at a text, which messages call `name`, and at what it imports.
    ///
    /// ```
    /// use virote::{ide::Document, session::Session, value::NoFiles};
    ///
    /// let session = Session::default();
    /// let document = Document::new(&session, "demo.geo", "let a = 1\nprint a + a", &NoFiles);
    /// assert_eq!(document.highlights(4), [4..5, 16..17, 20..21]);
    /// ```
    #[must_use]
    pub fn new(session: &Session, name: &str, text: &str, files: &dyn Files) -> Self {
        let (uses, sources) = session.name_uses(name, text.as_bytes(), files);
        let imported =
            sources.iter().skip(1).map(|source| Outline::of(session, &source.text)).collect();
        let pieces = syntax::pieces(text);
        let under_way = imports_under_way(session, text, &pieces, &uses, files);
        Self {
            text: Arc::from(text),
            lines: LineIndex::new(text),
            pieces,
            outline: Outline::of(session, text),
            uses,
            sources,
            imported,
            under_way,
        }
    }

    /// The outline of the file that an import within these bytes names.
    fn outline_of_import(&self, within: &Range<usize>) -> Option<&Outline> {
        let is_inside = |path: &Range<usize>| within.start <= path.start && path.end <= within.end;
        if let Some((_, outline)) = self.under_way.iter().find(|(path, _)| is_inside(path)) {
            return Some(outline);
        }
        let imports = self.imports();
        let (_, file) = imports.iter().find(|(path, _)| is_inside(path))?;
        let idx = self.sources.iter().skip(1).position(|source| source.name == *file)?;
        self.imported.get(idx)
    }

    /// The text.
    #[must_use]
    pub fn text(&self) -> &Arc<str> {
        &self.text
    }

    /// Its lines.
    #[must_use]
    pub fn lines(&self) -> &LineIndex {
        &self.lines
    }

    /// What it defines, calls and claims.
    #[must_use]
    pub fn outline(&self) -> &Outline {
        &self.outline
    }

    /// Each import's path with the file that it names, relative to the folder of the text.
    #[must_use]
    pub fn imports(&self) -> Vec<(Range<usize>, &str)> {
        let own = |span: &Span| (span.end as usize) <= self.text.len();
        let own = self.uses.imports.iter().filter(|(span, _)| own(span));
        own.map(|(span, path)| (span.range(), path.as_str())).collect()
    }

    /// The number of the piece at a byte, or right before it; of two a word.
    fn piece_at(&self, at: usize) -> Option<usize> {
        let behind = self.pieces.partition_point(|(_, range)| range.start <= at);
        let is_word =
            |idx: &usize| matches!(self.pieces[*idx].0, Highlight::Name | Highlight::Keyword);
        let touches = |idx: &usize| at <= self.pieces[*idx].1.end;
        let last = behind.checked_sub(1).filter(touches)?;
        let before =
            last.checked_sub(1).filter(|idx| touches(idx) && !is_word(&last) && is_word(idx));
        Some(before.unwrap_or(last))
    }

    /// The place of what begins with a piece and ends before a comma or the bracket around it.
    fn item_from(&self, first: usize) -> Option<Range<usize>> {
        let start = self.pieces.get(first)?.1.start;
        let (mut depth, mut end) = (0_usize, start);
        for idx in first..self.pieces.len() {
            match self.piece(idx) {
                "(" | "[" | "{" => depth += 1,
                ")" | "]" | "}" if depth == 0 => break,
                ")" | "]" | "}" => depth -= 1,
                "," if depth == 0 => break,
                _ => {}
            }
            end = self.pieces[idx].1.end;
        }
        (start < end).then_some(start..end)
    }

    /// The text of the piece of this number.
    fn piece(&self, idx: usize) -> &str {
        self.pieces.get(idx).and_then(|(_, range)| self.text.get(range.clone())).unwrap_or_default()
    }
}

/// The files that are named by imports, and by calls of scripts, which do not parse yet.
fn imports_under_way(
    session: &Session,
    text: &str,
    pieces: &[(Highlight, Range<usize>)],
    uses: &NameUses,
    files: &dyn Files,
) -> Vec<(Range<usize>, Outline)> {
    let is_read = |path: &Range<usize>| uses.imports.iter().any(|(span, _)| span.range() == *path);
    let outline = |path: &Range<usize>| {
        let name = text.get(path.clone())?.strip_prefix('"')?.strip_suffix('"')?;
        let bytes = files.read(name, session.limits().source_bytes).ok()?;
        Some((path.clone(), Outline::of(session, &String::from_utf8(bytes).ok()?)))
    };
    let piece = |idx: Option<usize>| text.get(pieces[idx?].1.clone());
    let calls_script = |name: &str| {
        let ops = session.registry().get(name);
        ops.is_some_and(|(_, ops)| ops.iter().any(|op| op.names_script))
    };
    let is_path = |&idx: &usize| {
        let is_called = || piece(idx.checked_sub(2)).is_some_and(calls_script);
        pieces[idx].0 == Highlight::Text
            && match piece(idx.checked_sub(1)) {
                Some("import") => true,
                Some("(") => is_called(),
                _ => false,
            }
    };
    let paths = (0..pieces.len()).filter(is_path).map(|idx| &pieces[idx].1);
    paths.filter(|path| !is_read(path)).filter_map(outline).collect()
}
