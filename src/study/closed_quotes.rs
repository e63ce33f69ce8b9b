//! A text of CSV whose quotes are closed: what a reader of CSV takes for a cell up to the end of the file
//! is a mistake, which costs the rows behind it. Which cells are in quotes is noted on the way, since the
//! reader does not tell.

use std::{
    collections::VecDeque,
    io::{self, Read},
    sync::{Arc, Mutex, PoisonError},
};

/// Reads on to the end, and fails there where a quote is open.
#[derive(Debug)]
pub(super) struct ClosedQuotes<R> {
    inner: R,
    separator: u8,
    place: CsvPlace,
    /// The line that is read, from 1.
    line: u64,
    /// The line of the last quote that was opened.
    opened: u64,
    /// The number of the cell in its row.
    cell: usize,
    /// Those of the row so far that are in quotes.
    in_quotes: Vec<usize>,
    quoted: QuotedCells,
}

/// For each row that was read and not asked for yet the numbers of its cells that are in quotes, from 0.
#[derive(Clone, Debug, Default)]
pub(super) struct QuotedCells(Arc<Mutex<VecDeque<Vec<usize>>>>);

impl QuotedCells {
    /// Those of the next row; lines without a character are no rows.
    pub(super) fn next_row(&self) -> Vec<usize> {
        let mut rows = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        rows.pop_front().unwrap_or_default()
    }

    fn add(&self, row: Vec<usize>) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).push_back(row);
    }
}

/// Where in a cell a byte stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum CsvPlace {
    /// Before the first of a row.
    Line,
    /// Before another one.
    Start,
    /// In one without quotes.
    Plain,
    /// Between quotes.
    Quoted,
    /// Behind a quote inside of quotes, which closes them unless another one follows.
    Closing,
}

impl<R> ClosedQuotes<R> {
    pub(super) fn new(inner: R, separator: u8) -> Self {
        Self {
            inner,
            separator,
            place: CsvPlace::Line,
            line: 1,
            opened: 0,
            cell: 0,
            in_quotes: Vec::new(),
            quoted: QuotedCells::default(),
        }
    }

    /// Which cells are in quotes, row by row as they are read.
    pub(super) fn quoted_cells(&self) -> QuotedCells {
        self.quoted.clone()
    }

    fn pass(&mut self, byte: u8) {
        self.line += u64::from(byte == b'\n');
        self.place = match (self.place, byte) {
            (CsvPlace::Line | CsvPlace::Start, b'"') => {
                self.opened = self.line;
                self.in_quotes.push(self.cell);
                CsvPlace::Quoted
            }
            (CsvPlace::Quoted, b'"') => CsvPlace::Closing,
            (CsvPlace::Quoted, _) | (CsvPlace::Closing, b'"') => CsvPlace::Quoted,
            (_, b'\r' | b'\n') => {
                self.end_row();
                CsvPlace::Line
            }
            // A byte order mark is no part of the first cell.
            (CsvPlace::Line, 0xef | 0xbb | 0xbf) if self.line == 1 => CsvPlace::Line,
            (_, byte) if byte == self.separator => {
                self.cell += 1;
                CsvPlace::Start
            }
            _ => CsvPlace::Plain,
        };
    }

    fn end_row(&mut self) {
        if self.place != CsvPlace::Line {
            self.cell = 0;
            self.quoted.add(std::mem::take(&mut self.in_quotes));
        }
    }
}

impl<R: Read> Read for ClosedQuotes<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let n_read = self.inner.read(buffer)?;
        buffer[..n_read].iter().for_each(|&byte| self.pass(byte));
        if n_read == 0 && !buffer.is_empty() && self.place == CsvPlace::Quoted {
            let told = format!("the quote that line {} opens is not closed", self.opened);
            return Err(io::Error::new(io::ErrorKind::InvalidData, told));
        }
        if n_read == 0 && !buffer.is_empty() {
            self.end_row();
            self.place = CsvPlace::Line;
        }
        Ok(n_read)
    }
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use super::ClosedQuotes;

    #[track_caller]
    fn check(text: &str, expected: Option<&str>) {
        let mut out = String::new();
        let read = ClosedQuotes::new(text.as_bytes(), b';').read_to_string(&mut out);
        assert_eq!(read.err().map(|err| err.to_string()).as_deref(), expected, "{text:?}");
        assert_eq!(out, text, "all is passed on");
    }

    #[test]
    fn quotes_that_are_closed_pass() {
        for text in [
            "",
            "a;b\n1;2",
            "\"a\";\"b;\n\"\n",
            "\"a\"\"b\"",
            "5\";6\n",
            "\"\"",
            "\"a\"x\"\n",
            "\u{feff}\"a;\"\n",
        ] {
            check(text, None);
        }
    }

    #[test]
    fn cells_in_quotes_are_noted_by_row() {
        let text = "\u{feff}\"a\";b\r\n\r\n1;\"\"\n;\n\"x;\n\";2;\"y\"\"\"";
        let mut reader = ClosedQuotes::new(text.as_bytes(), b';');
        let quoted = reader.quoted_cells();
        assert!(reader.read_to_string(&mut String::new()).is_ok());
        let rows: Vec<Vec<usize>> = (0..5).map(|_| quoted.next_row()).collect();
        assert_eq!(rows, [vec![0], vec![1], vec![], vec![0, 2], vec![]]);
    }

    #[test]
    fn an_open_quote_is_told_with_its_line() {
        let told = |line: u64| format!("the quote that line {line} opens is not closed");
        for (text, line) in
            [("\"", 1), ("a\n\"1\n", 2), ("\"x\ny\"\n1;\"2\"\"\n3\n", 3), ("a;\"b", 1)]
        {
            check(text, Some(&told(line)));
        }
    }
}
