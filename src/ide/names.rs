//! Names across files: where they are defined and used, and how they are given another name.

use std::{collections::BTreeMap, ops::Range};

use super::{ActKind, DefinedName, Document, NameRole, SourceRange, TextEdit, applied};
use crate::{
    diag::{Code, Sources, Span},
    session::Session,
    syntax::{self, Highlight},
    value::{Files, Registry},
};

/// A place where a name stands, in a file: none is the document itself.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Occurrence {
    /// The path of the file, relative to the folder of the document.
    pub file: Option<String>,
    /// The first byte.
    pub start: usize,
    /// One past the last.
    pub end: usize,
}

impl Occurrence {
    /// Its bytes.
    #[must_use]
    pub fn range(&self) -> Range<usize> {
        self.start..self.end
    }
}

/// The edits of a rename, by file.
pub type Rename = BTreeMap<Option<String>, Vec<TextEdit>>;

/// What stands at a place.
#[derive(Debug)]
pub(super) enum Meaning<'d> {
    /// A name of a script, by its definition.
    Name(&'d DefinedName),
    /// An operation or a constant.
    BuiltIn(&'d str),
    /// The label of an argument of a built-in.
    Label {
        /// What is called.
        call: &'d str,
        /// The label.
        label: &'d str,
    },
    /// What stands behind a dot, and the name before it.
    Field {
        /// The name before the dot; none where something else stands there.
        of: Option<&'d str>,
        /// The field.
        field: &'d str,
    },
    /// The label of a field of a record that is written out, with the place of its value.
    Key(&'d str, Range<usize>),
    /// The code of an error.
    Code(Code),
    /// A word of the language.
    Keyword(&'d str),
    /// A number as it is written.
    Number(&'d str),
}

impl Document {
    /// What stands at byte `at`, and where.
    pub(super) fn meaning(
        &self,
        registry: &Registry,
        at: usize,
    ) -> Option<(Meaning<'_>, Range<usize>)> {
        let idx = self.piece_at(at)?;
        let (paint, place) = self.pieces[idx].clone();
        let text = self.piece(idx);
        let meaning = match paint {
            Highlight::Number => Meaning::Number(text),
            Highlight::Keyword | Highlight::Name => {
                if let Some(name) = self.definition_of(&place) {
                    return Some((Meaning::Name(name), place));
                }
                let before = idx.checked_sub(1).map_or("", |before| self.piece(before));
                let call = || syntax::open_call(&self.text, place.start).map(|call| call.name);
                if before == "." {
                    let of = idx
                        .checked_sub(2)
                        .map(|of| self.piece(of))
                        .filter(|of| syntax::is_name(of));
                    Meaning::Field { of, field: text }
                } else if self.piece(idx + 1) == ":" && matches!(before, "{" | ",") {
                    Meaning::Key(text, self.item_from(idx + 2)?)
                } else if let (true, Some(call)) = (self.piece(idx + 1) == "=", call()) {
                    Meaning::Label { call, label: text }
                } else if paint == Highlight::Keyword && self.piece(idx + 1) != "(" {
                    Meaning::Keyword(text)
                } else if registry.get(text).is_some() || registry.constant(text).is_some() {
                    Meaning::BuiltIn(text)
                } else if paint == Highlight::Keyword {
                    Meaning::Keyword(text)
                } else {
                    return None;
                }
            }
            Highlight::Text
                if idx.checked_sub(2).is_some_and(|two| {
                    self.piece(two) == "expect" && self.piece(two + 1) == "error"
                }) =>
            {
                Meaning::Code(Code::from_id(text.trim_matches('"'))?)
            }
            // The name of an import may be a part of its path.
            Highlight::Text => {
                let name = self.outline.names.iter().find(|name| {
                    name.role == NameRole::Import && name.place.start <= at && at <= name.place.end
                })?;
                return Some((Meaning::Name(name), name.place.clone()));
            }
            _ => return None,
        };
        Some((meaning, place))
    }

    /// The definition that a name at exactly this place means, or is.
    pub(super) fn definition_of(&self, place: &Range<usize>) -> Option<&DefinedName> {
        let span = Span::new(place.start as u32, place.end as u32);
        let target = self.uses.target(span).unwrap_or(span);
        self.definition_at(target).or_else(|| self.definition_at(span))
    }

    /// What a name at exactly this place is in the other file, where it came through an import that lists it.
    pub(super) fn imported_role(&self, place: &Range<usize>) -> Option<NameRole> {
        let span = Span::new(place.start as u32, place.end as u32);
        let origin = self.definition_at(self.uses.origin(span))?;
        (origin.role != NameRole::Import).then_some(origin.role)
    }

    /// The definition whose name stands at this place.
    fn definition_at(&self, span: Span) -> Option<&DefinedName> {
        let place = SourceRange::of(&self.sources, span);
        let outline = match place.source.checked_sub(1) {
            None => &self.outline,
            Some(imported) => self.imported.get(imported)?,
        };
        outline.defined_at(&place.range)
    }

    /// The place of the name at a byte.
    fn name_span(&self, at: usize) -> Option<Span> {
        let span = |range: &Range<usize>| Span::new(range.start as u32, range.end as u32);
        let idx = self.piece_at(at)?;
        let place = &self.pieces[idx].1;
        let is_known =
            self.uses.target(span(place)).is_some() || self.outline.defined_at(place).is_some();
        if is_known {
            return Some(span(place));
        }
        let mut names = self.outline.names.iter();
        names
            .find(|name| name.place.start <= at && at <= name.place.end)
            .map(|name| span(&name.place))
    }

    fn occurrence(&self, span: Span) -> Occurrence {
        let SourceRange { source, range } = SourceRange::of(&self.sources, span);
        let file = (0 < source).then(|| self.sources.iter().nth(source)).flatten();
        Occurrence {
            file: file.map(|source| source.name.clone()),
            start: range.start,
            end: range.end,
        }
    }

    /// Where the name at a byte is defined. A name that an import lists leads into its file.
    #[must_use]
    pub fn definition(&self, at: usize) -> Option<Occurrence> {
        let span = self.name_span(at)?;
        Some(self.occurrence(self.uses.origin(span)))
    }

    /// Every place where the name at a byte stands, in this text and in those that it imports, its
    /// definition included.
    #[must_use]
    pub fn references(&self, at: usize) -> Vec<Occurrence> {
        let Some(span) = self.name_span(at) else { return Vec::new() };
        self.same_as(self.uses.origin(span))
    }

    /// Every place of a name that is defined at `range` of the file `file`.
    #[must_use]
    pub fn references_of(&self, file: &str, range: &Range<usize>) -> Vec<Occurrence> {
        let Some(source) = self.sources.iter().skip(1).find(|source| source.name == file) else {
            return Vec::new();
        };
        self.same_as(Span::new(range.start as u32, range.end as u32).shifted(source.base))
    }

    /// Where `.name` is asked of something whose definition is not known, in a text that calls a file of these
    /// by `script`: what such a call gives may have come there by lists, functions and other names.
    #[must_use]
    pub fn unseen(&self, name: &str, is_of_file: impl Fn(&str) -> bool) -> Vec<Range<usize>> {
        let is_import = |range: &Range<usize>| {
            self.outline.acts.iter().any(|act| act.kind == ActKind::Import && act.subject == *range)
        };
        let imports = self.imports();
        if !imports.iter().any(|(range, file)| is_of_file(file) && !is_import(range)) {
            return Vec::new();
        }
        let is_field = |idx: &usize| {
            self.piece(*idx) == name && idx.checked_sub(1).is_some_and(|dot| self.piece(dot) == ".")
        };
        let fields = (0..self.pieces.len()).filter(is_field).map(|idx| self.pieces[idx].1.clone());
        fields.filter(|place| self.definition_of(place).is_none()).collect()
    }

    fn same_as(&self, origin: Span) -> Vec<Occurrence> {
        let mut found = vec![self.occurrence(origin)];
        let uses = self.uses.uses.iter().map(|&(place, _)| place);
        let same = uses.filter(|&place| self.uses.origin(place) == origin);
        found.extend(same.map(|place| self.occurrence(place)));
        found.sort();
        found.dedup();
        found
    }

    /// The places of the name at a byte in this text.
    #[must_use]
    pub fn highlights(&self, at: usize) -> Vec<Range<usize>> {
        let own = self.references(at).into_iter().filter(|found| found.file.is_none());
        own.map(|found| found.range()).collect()
    }

    /// The place of the name at a byte that can be given another one.
    ///
    /// # Errors
    /// A sentence on why it cannot.
    pub fn renamable(&self, at: usize) -> Result<Range<usize>, String> {
        let place = self.name_span(at).map(Span::range);
        let known = place.and_then(|place| Some((self.definition_of(&place)?, place)));
        let Some((name, place)) = known else {
            return Err("nothing that can be renamed stands here: only names that scripts define"
                .to_owned());
        };
        if name.is_part {
            return Err(format!(
                "`{0}` is called as the field that it stands for; a name of its own comes from `let name = record.{0}`",
                name.name
            ));
        }
        Ok(place)
    }

    /// The edits that give the name at a byte another one, in this text and in those that it imports.
    /// That no name means something else afterwards is tried out.
    ///
    /// # Errors
    /// A sentence on why that cannot be.
    pub fn rename(
        &self,
        session: &Session,
        files: &dyn Files,
        at: usize,
        new: &str,
    ) -> Result<Rename, String> {
        if !syntax::is_name(new) {
            return Err(match syntax::KEYWORDS.contains(&new) {
                true => format!("`{new}` is a word of the language"),
                false => format!("`{new}` is no name: letters, digits and `_`, no digit first"),
            });
        }
        self.renamable(at)?;
        let found = self.references(at);
        let home = self.definition(at).map(|definition| definition.file);
        if new.starts_with('_') && found.iter().any(|one| Some(&one.file) != home.as_ref()) {
            return Err("names that begin with `_` are not shown to other files, and another \
                        file uses this one"
                .to_owned());
        }
        let mut edits = Rename::new();
        for found in found {
            let edit = self.renamed(&found, new);
            edits.entry(found.file).or_default().push(edit);
        }
        self.tried(session, files, &edits)?;
        Ok(edits)
    }

    /// The edit at one occurrence.
    fn renamed(&self, found: &Occurrence, new: &str) -> TextEdit {
        let range = found.range();
        let (outline, text) = match self
            .sources
            .iter()
            .skip(1)
            .position(|source| Some(&source.name) == found.file.as_ref())
        {
            Some(idx) => (
                self.imported.get(idx),
                self.sources.iter().nth(idx + 1).map(|source| &source.text),
            ),
            None => (Some(&self.outline), Some(&self.text)),
        };
        let (Some(outline), Some(text)) = (outline, text) else {
            return TextEdit { range, text: new.to_owned() };
        };
        let old = text.get(range.clone()).unwrap_or_default();
        // A name that is a part of an import's path.
        let import = outline.acts.iter().find(|act| {
            act.kind == ActKind::Import
                && act.subject.start < range.start
                && range.end < act.subject.end
        });
        if let Some(import) = import {
            let end = import.subject.end;
            return TextEdit { range: end..end, text: format!(" as {new}") };
        }
        let is_short = outline.short_fields.contains(&range);
        TextEdit { range, text: if is_short { format!("{old}: {new}") } else { new.to_owned() } }
    }

    /// Whether all names mean the same after these edits.
    fn tried(&self, session: &Session, files: &dyn Files, edits: &Rename) -> Result<(), String> {
        let own = edits.get(&None).map(Vec::as_slice).unwrap_or_default();
        let text = applied(&self.text, own);
        let files = EditedFiles { files, edits, sources: &self.sources };
        let name = self.sources.iter().next().map_or("", |source| source.name.as_str());
        let (after, sources) = session.name_uses(name, text.as_bytes(), &files);
        let errors = |uses: &crate::eval::NameUses| uses.diagnostics.len();
        let moved = |span: Span| -> (usize, usize) {
            let place = SourceRange::of(&self.sources, span);
            let file = (0 < place.source)
                .then(|| self.sources.iter().nth(place.source).map(|source| source.name.clone()))
                .flatten();
            let before = edits
                .get(&file)
                .into_iter()
                .flatten()
                .filter(|edit| edit.range.start < place.range.start);
            let shift: isize =
                before.map(|edit| edit.text.len() as isize - edit.range.len() as isize).sum();
            (place.source, place.range.start.saturating_add_signed(shift))
        };
        let is_moved_alike = |(old, new): (&(Span, Span), &(Span, Span))| {
            let found = [new.0, new.1]
                .map(|span| SourceRange::of(&sources, span))
                .map(|place| (place.source, place.range.start));
            let expected = [moved(old.0), moved(old.1)];
            expected.iter().zip(&found).all(|(expected, found)| {
                expected.0 == found.0 && expected.1.abs_diff(found.1) <= self.longest_shift(edits)
            })
        };
        let is_same = after.uses.len() == self.uses.uses.len()
            && errors(&after) <= errors(&self.uses)
            && self.uses.uses.iter().zip(&after.uses).all(is_moved_alike);
        if is_same {
            Ok(())
        } else {
            Err("the new name means something else already where it would stand".to_owned())
        }
    }

    /// How far inside of its edit a name may stand: behind `label: ` of a short field, behind ` as `.
    fn longest_shift(&self, edits: &Rename) -> usize {
        let added = edits.values().flatten().filter(|edit| edit.text.contains(' '));
        added.map(|edit| edit.text.len() + edit.range.len() + 8).max().unwrap_or(0)
    }
}

/// Files after the edits of a rename.
#[derive(Debug)]
struct EditedFiles<'a> {
    files: &'a dyn Files,
    edits: &'a Rename,
    sources: &'a Sources,
}

impl Files for EditedFiles<'_> {
    fn read(&self, path: &str, most: usize) -> Result<Vec<u8>, String> {
        let edits = self.edits.get(&Some(path.to_owned()));
        let source = self.sources.iter().skip(1).find(|source| source.name == path);
        match (edits, source) {
            (Some(edits), Some(source)) => Ok(applied(&source.text, edits).into_bytes()),
            _ => self.files.read(path, most),
        }
    }

    fn beside(&self, path: &str) -> Vec<String> {
        self.files.beside(path)
    }
}
