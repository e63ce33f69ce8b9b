//! The rows of CSV, cell by cell, for tables that are loaded and tables that are compared.
//!
//! The parser of `csv` divides the text. What it lets pass, as spreadsheets do, is a mistake here: a
//! quotation mark that nothing closes, and text behind a closed one.

use std::borrow::Cow;

use csv_core::{ReadFieldResult, Reader, ReaderBuilder};

use crate::{limits::work, value::ENDED};

/// A row that is not empty.
#[derive(Debug)]
pub struct CsvRow<'t> {
    /// The byte of the text at which it begins.
    pub(super) start: usize,
    /// As many as in the header.
    pub cells: Vec<CsvCell<'t>>,
}

/// What stands between separators.
#[derive(Debug)]
pub struct CsvCell<'t> {
    /// All that stood in quotation marks, else without the spaces around.
    pub text: Cow<'t, str>,
    pub(super) is_quoted: bool,
}

/// The header, and the rows below it, `most` of them or fewer.
///
/// # Errors
/// What is wrong, with its line; that the work was ended.
pub fn csv_rows(
    text: &str,
    separator: u8,
    most: usize,
) -> Result<(CsvRow<'_>, Vec<CsvRow<'_>>), String> {
    let mut reader = CellReader::new(text, separator);
    let header = reader.next_row()?.ok_or("the file is empty")?;
    let wanted = header.cells.len();
    let mut rows = Vec::new();
    while let Some(row) = reader.next_row()? {
        let got = row.cells.len();
        if got != wanted {
            let (line, cells) = (line_at(text, row.start), if got == 1 { "cell" } else { "cells" });
            return Err(format!("line {line} has {got} {cells}, the header has {wanted}"));
        }
        if rows.len() == most {
            return Err(format!("the table has more than the {most} rows that are allowed"));
        }
        if !work::push(&mut rows, row) {
            return Err(ENDED.to_owned());
        }
    }
    Ok((header, rows))
}

/// The number of the line in which a byte of the text stands, from 1.
pub(super) fn line_at(text: &str, at: usize) -> usize {
    1 + text[..at].replace("\r\n", "\n").matches(['\r', '\n']).count()
}

struct CellReader<'t> {
    text: &'t str,
    separator: char,
    /// The byte of the text up to which it has read.
    at: usize,
    parser: Reader,
    /// Where the parser writes the text of a cell.
    output: Vec<u8>,
}

impl<'t> CellReader<'t> {
    fn new(text: &'t str, separator: u8) -> Self {
        let parser = ReaderBuilder::new().delimiter(separator).build();
        Self { text, separator: char::from(separator), at: 0, parser, output: vec![0; 64] }
    }

    /// The next row; none at the end of the text.
    fn next_row(&mut self) -> Result<Option<CsvRow<'t>>, String> {
        self.skip_while(char::is_whitespace);
        let start = self.at;
        let mut cells = Vec::new();
        while let Some((cell, ends_row)) = self.next_cell()? {
            if !work::push(&mut cells, cell) {
                return Err(ENDED.to_owned());
            }
            if ends_row {
                return Ok(Some(CsvRow { start, cells }));
            }
            self.skip_while(|character| character.is_whitespace() && !"\r\n".contains(character));
        }
        Ok(None)
    }

    /// Goes on to the first character that is a separator or is none of these.
    fn skip_while(&mut self, is_skipped: impl Fn(char) -> bool) {
        let separator = self.separator;
        let rest = &self.text[self.at..];
        let rest =
            rest.trim_start_matches(|character| character != separator && is_skipped(character));
        self.at = self.text.len() - rest.len();
    }

    /// The next cell, and whether it is the last of its row; none at the end of the text.
    fn next_cell(&mut self) -> Result<Option<(CsvCell<'t>, bool)>, String> {
        let start = self.at;
        let mut n_written = 0;
        let ends_row = loop {
            let input = &self.text.as_bytes()[self.at..];
            let (result, n_read, n) = self.parser.read_field(input, &mut self.output[n_written..]);
            self.at += n_read;
            n_written += n;
            match result {
                // The next round tells the parser that nothing follows.
                ReadFieldResult::InputEmpty => {}
                ReadFieldResult::OutputFull if work::has_room(self.output.len()) => {
                    self.output.resize(2 * self.output.len(), 0);
                }
                ReadFieldResult::OutputFull => return Err(ENDED.to_owned()),
                ReadFieldResult::Field { record_end } => break record_end,
                ReadFieldResult::End => return Ok(None),
            }
        };
        let source = &self.text[start..self.at];
        let ends: &[char] = if ends_row { &['\r', '\n'] } else { &[self.separator] };
        let source = source.strip_suffix(ends).unwrap_or(source);
        if !source.starts_with('"') {
            let cell = CsvCell { text: Cow::Borrowed(source.trim()), is_quoted: false };
            return Ok(Some((cell, ends_row)));
        }
        let outside = self.outside(start, source)?;
        let text = String::from_utf8_lossy(&self.output[..n_written - outside.len()]);
        let cell = CsvCell { text: Cow::Owned(text.into_owned()), is_quoted: true };
        Ok(Some((cell, ends_row)))
    }

    /// The spaces behind the quotation mark that closes a cell, which begins with one.
    fn outside(&self, start: usize, source: &'t str) -> Result<&'t str, String> {
        let Some(outside) = behind_quotation(source) else {
            let line = line_at(self.text, start);
            return Err(format!("line {line}: the quotation mark is not closed"));
        };
        let stranger = outside.trim_start();
        let Some(character) = stranger.chars().next() else { return Ok(outside) };
        let line = line_at(self.text, start + source.len() - stranger.len());
        Err(format!("line {line}: `{character}` follows a quotation mark"))
    }
}

/// What follows the quotation that a text begins with; none if it does not end. Two quotation marks
/// are one of its text.
fn behind_quotation(source: &str) -> Option<&str> {
    let mut rest = &source[1..];
    loop {
        let (_, behind) = rest.split_once('"')?;
        match behind.strip_prefix('"') {
            Some(behind) => rest = behind,
            None => return Some(behind),
        }
    }
}
