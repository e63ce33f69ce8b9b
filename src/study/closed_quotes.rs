//! A text of CSV whose quotes are closed: what a reader of CSV takes for a cell up to the end of the file
//! is a mistake, which costs the rows behind it.

use std::io::{self, Read};

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
}

/// Where in a cell a byte stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum CsvPlace {
    /// Before it.
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
        Self { inner, separator, place: CsvPlace::Start, line: 1, opened: 0 }
    }

    fn pass(&mut self, byte: u8) {
        self.line += u64::from(byte == b'\n');
        self.place = match (self.place, byte) {
            (CsvPlace::Start, b'"') => {
                self.opened = self.line;
                CsvPlace::Quoted
            }
            (CsvPlace::Quoted, b'"') => CsvPlace::Closing,
            (CsvPlace::Quoted, _) | (CsvPlace::Closing, b'"') => CsvPlace::Quoted,
            (_, b'\r' | b'\n') => CsvPlace::Start,
            // A byte order mark is no part of the first cell.
            (CsvPlace::Start, 0xef | 0xbb | 0xbf) if self.line == 1 => CsvPlace::Start,
            (_, byte) if byte == self.separator => CsvPlace::Start,
            _ => CsvPlace::Plain,
        };
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
    fn an_open_quote_is_told_with_its_line() {
        let told = |line: u64| format!("the quote that line {line} opens is not closed");
        for (text, line) in
            [("\"", 1), ("a\n\"1\n", 2), ("\"x\ny\"\n1;\"2\"\"\n3\n", 3), ("a;\"b", 1)]
        {
            check(text, Some(&told(line)));
        }
    }
}
