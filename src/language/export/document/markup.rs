//! What the formats of documents have in common: tables, and how a document is written down.

use std::io::{self, Write};

use crate::export::base64::Base64;

/// A table of a document. Every row has as many cells as the head.
#[derive(Clone, Debug, Default)]
pub struct DocumentTable {
    /// What it is called.
    pub caption: Option<String>,
    /// The titles of the columns, and whether what stands below is numbers, which stand to the right.
    pub head: Vec<(String, bool)>,
    /// The rows.
    pub rows: Vec<Vec<DocumentCell>>,
    /// How many rows more there are.
    pub n_more: usize,
}

/// A cell of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DocumentCell {
    /// Words.
    Text(String),
    /// A piece of a script, a number, a path.
    Code(String),
    /// Whether something holds.
    Verdict(bool),
}

/// How a kind of document is written down.
pub(super) trait Markup {
    fn begin(&mut self, title: &str) -> io::Result<()>;
    fn heading(&mut self, text: &str) -> io::Result<()>;
    fn paragraph(&mut self, text: &str) -> io::Result<()>;
    fn verdict(&mut self, holds: bool, text: &str) -> io::Result<()>;
    fn table(&mut self, table: &DocumentTable) -> io::Result<()>;
    /// A picture, in the form of PNG.
    fn picture(&mut self, png: &[u8], shows: &str) -> io::Result<()>;
    fn end(&mut self) -> io::Result<()>;
}

/// Writes a picture as the address of an image.
pub(super) fn write_address(png: &[u8], out: &mut dyn Write) -> io::Result<()> {
    out.write_all(b"data:image/png;base64,")?;
    let mut encoder = Base64::new(out);
    encoder.write_all(png)?;
    encoder.finish()
}

/// What stands below a table that is not whole.
pub(super) fn rest_of(table: &DocumentTable) -> Option<String> {
    match table.n_more {
        0 => None,
        1 => Some("… and 1 row more".to_owned()),
        n => Some(format!("… and {n} rows more")),
    }
}

/// The word of a verdict.
pub(super) fn word(holds: bool) -> &'static str {
    if holds { "holds" } else { "FAILS" }
}
