//! Places in a text: bytes, and lines with columns in the units of a client.

use std::ops::Range;

/// What a client counts columns in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ColumnUnit {
    /// Bytes.
    Utf8,
    /// Halves of surrogate pairs count, as in most editors.
    #[default]
    Utf16,
    /// Characters.
    Utf32,
}

impl ColumnUnit {
    /// How many columns a character takes.
    fn width(self, character: char) -> usize {
        match self {
            Self::Utf8 => character.len_utf8(),
            Self::Utf16 => character.len_utf16(),
            Self::Utf32 => 1,
        }
    }
}

/// A line and a column, both from 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct LineColumn {
    /// The line.
    pub line: usize,
    /// The column, in the client's units.
    pub column: usize,
}

/// Where the lines of a text begin.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LineIndex {
    starts: Vec<usize>,
}

impl LineIndex {
    /// The lines of a text; they end with `\n`, `\r\n` or a lone `\r`.
    #[must_use]
    pub fn new(text: &str) -> Self {
        let bytes = text.as_bytes();
        let is_end = |at: &usize| {
            bytes[*at] == b'\n' || bytes[*at] == b'\r' && bytes.get(at + 1) != Some(&b'\n')
        };
        let ends = (0..bytes.len()).filter(is_end).map(|at| at + 1);
        Self { starts: std::iter::once(0).chain(ends).collect() }
    }

    /// How many lines there are.
    #[must_use]
    pub fn n_lines(&self) -> usize {
        self.starts.len()
    }

    /// The bytes of a line, its end included; empty beyond the last.
    #[must_use]
    pub fn line(&self, line: usize, text: &str) -> Range<usize> {
        let start = self.starts.get(line).copied().unwrap_or(text.len());
        start..self.starts.get(line + 1).copied().unwrap_or(text.len())
    }

    /// The line and column of a byte, which is clamped to the text and to whole characters.
    ///
    /// ```
    /// use virote::ide::{ColumnUnit, LineColumn, LineIndex};
    ///
    /// let text = "let a = 1\n// 🫖 pot";
    /// let lines = LineIndex::new(text);
    /// let after = text.find(" pot").expect("it is there");
    /// for (unit, column) in [(ColumnUnit::Utf8, 7), (ColumnUnit::Utf16, 5), (ColumnUnit::Utf32, 4)] {
    ///     assert_eq!(lines.position(text, after, unit), LineColumn { line: 1, column });
    ///     assert_eq!(lines.offset(text, LineColumn { line: 1, column }, unit), after);
    /// }
    /// ```
    #[must_use]
    pub fn position(&self, text: &str, at: usize, unit: ColumnUnit) -> LineColumn {
        let at = text.floor_char_boundary(at.min(text.len()));
        let line = self.starts.partition_point(|&start| start <= at).saturating_sub(1);
        let before = &text[self.starts[line]..at];
        let column = match unit {
            ColumnUnit::Utf8 => before.len(),
            _ => before.chars().map(|character| unit.width(character)).sum(),
        };
        LineColumn { line, column }
    }

    /// The byte at a line and column: beyond the end of a line its end, beyond the text its end, inside
    /// of a character its start.
    #[must_use]
    pub fn offset(&self, text: &str, at: LineColumn, unit: ColumnUnit) -> usize {
        let range = self.line(at.line, text);
        let line = text[range.clone()].trim_end_matches(['\n', '\r']);
        let mut column = 0;
        for (idx, character) in line.char_indices() {
            column += unit.width(character);
            if at.column < column {
                return range.start + idx;
            }
        }
        range.start + line.len()
    }
}

#[cfg(test)]
mod tests {
    use super::{ColumnUnit, LineColumn, LineIndex};

    #[test]
    fn places_go_there_and_back() {
        let text = "a\tb\r\n\n🫖ü\rx\n";
        let lines = LineIndex::new(text);
        assert_eq!(lines.n_lines(), 5);
        for unit in [ColumnUnit::Utf8, ColumnUnit::Utf16, ColumnUnit::Utf32] {
            for (at, character) in text.char_indices().filter(|(_, c)| !"\r\n".contains(*c)) {
                let place = lines.position(text, at, unit);
                assert_eq!(lines.offset(text, place, unit), at, "{character:?} {unit:?}");
            }
        }
    }

    #[test]
    fn places_outside_of_the_text_are_clamped() {
        let text = "ab\n🫖";
        let lines = LineIndex::new(text);
        let at = |line, column| lines.offset(text, LineColumn { line, column }, ColumnUnit::Utf16);
        assert_eq!([at(0, 99), at(1, 1), at(1, 2), at(7, 0)], [2, 3, 7, 7]);
    }
}
