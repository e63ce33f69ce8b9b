//! The documents that are open in the editor: their texts, names, and last values.

use std::{
    cell::OnceCell,
    collections::BTreeSet,
    path::{Path, PathBuf},
    sync::Arc,
    time::Instant,
};

use lsp_types::TextDocumentContentChangeEvent;

use super::{convert::TextPlaces, paths};
use crate::{
    ide::{ColumnUnit, Document, LineIndex, Values},
    session::Session,
    value::Files,
};

/// An open document.
#[derive(Debug)]
pub(super) struct OpenDocument {
    /// As the client writes it.
    pub(super) uri: String,
    /// None where it is no file.
    pub(super) path: Option<PathBuf>,
    pub(super) text: String,
    lines: LineIndex,
    /// The client's number of the text.
    pub(super) version: i32,
    /// The server's: it grows also where another file changes what this one means.
    pub(super) serial: u64,
    /// When it changed last.
    pub(super) since: Instant,
    /// Its names, as soon as somebody asks.
    document: OnceCell<Document>,
    /// What it came to, with the serial of that text.
    pub(super) values: Option<(u64, Values)>,
    /// Whether what is wrong with this text was told, without its values.
    pub(super) is_told_early: bool,
    /// Whether requests were answered without its values, so that they are to be asked anew when these are there.
    pub(super) lacked_values: bool,
    /// Where findings of its last run were told.
    pub(super) told: BTreeSet<String>,
}

impl OpenDocument {
    pub(super) fn new(uri: String, text: String, version: i32) -> Self {
        Self {
            path: paths::path_of(&uri),
            uri,
            lines: LineIndex::new(&text),
            text,
            version,
            serial: 0,
            since: Instant::now(),
            document: OnceCell::new(),
            values: None,
            is_told_early: false,
            lacked_values: false,
            told: BTreeSet::new(),
        }
    }

    /// Changes the text as the client did.
    pub(super) fn change(&mut self, changes: &[TextDocumentContentChangeEvent], unit: ColumnUnit) {
        for change in changes {
            match &change.range {
                Some(range) => {
                    let bytes =
                        TextPlaces { text: &self.text, lines: &self.lines, unit }.bytes(range);
                    self.text.replace_range(bytes, &change.text);
                }
                None => self.text.clone_from(&change.text),
            }
            self.lines = LineIndex::new(&self.text);
        }
        self.renew();
    }

    /// Forgets what was known of the text before.
    pub(super) fn renew(&mut self) {
        self.serial += 1;
        self.since = Instant::now();
        self.document = OnceCell::new();
        self.is_told_early = false;
    }

    /// Its text with lines and columns.
    pub(super) fn places(&self, unit: ColumnUnit) -> TextPlaces<'_> {
        TextPlaces { text: &self.text, lines: &self.lines, unit }
    }

    /// What messages call it.
    pub(super) fn name(&self) -> &str {
        let name = self.path.as_deref().and_then(Path::file_name).and_then(|name| name.to_str());
        name.unwrap_or("untitled.geo")
    }

    /// The folder that its paths are relative to.
    pub(super) fn folder(&self) -> PathBuf {
        let folder = self.path.as_deref().and_then(Path::parent);
        folder.map_or_else(|| PathBuf::from("."), Path::to_path_buf)
    }

    /// Its names.
    pub(super) fn document(&self, session: &Session, files: &dyn Files) -> &Document {
        self.document.get_or_init(|| Document::new(session, self.name(), &self.text, files))
    }

    /// What it came to last, whatever it was then.
    pub(super) fn last_values(&self) -> Option<&Values> {
        self.values.as_ref().map(|(_, values)| values)
    }

    /// What it comes to as it stands.
    pub(super) fn values(&self) -> Option<&Values> {
        self.values.as_ref().filter(|(serial, _)| *serial == self.serial).map(|(_, values)| values)
    }

    /// The same, to be added to.
    pub(super) fn values_mut(&mut self) -> Option<&mut Values> {
        let (serial, values) = self.values.as_mut()?;
        (*serial == self.serial).then_some(values)
    }

    /// Takes in a report of the text with this serial.
    pub(super) fn take(&mut self, serial: u64, report: Arc<crate::session::Report>) {
        self.values = Some((serial, Values::new(report)));
    }
}
