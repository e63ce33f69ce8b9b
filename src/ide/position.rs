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

/// Where the lines of a text begin, and how many columns there are up to its blocks: a line may be as long as
/// the text, and is not counted from its start for each place in it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LineIndex {
    starts: Vec<usize>,
    /// Columns of the text before each block, its line ends counted as well.
    blocks: Vec<ColumnCount>,
}

/// How many columns a text takes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct ColumnCount {
    utf16: usize,
    utf32: usize,
}

impl ColumnCount {
    /// Counts a part of a text in UTF-8, without a branch for each character.
    fn add(&mut self, part: &str) {
        let bytes = part.as_bytes();
        let n_characters = bytes.iter().filter(|byte| !(0x80..0xc0).contains(*byte)).count();
        // Characters of four bytes are two halves of a surrogate pair.
        let n_pairs = bytes.iter().filter(|byte| 0xf0 <= **byte).count();
        self.utf16 += n_characters + n_pairs;
        self.utf32 += n_characters;
    }
}

/// Bytes of a block: at most these are counted for a place.
const BLOCK: usize = 128;

impl LineIndex {
    /// The lines of a text; they end with `\n`, `\r\n` or a lone `\r`.
    #[must_use]
    pub fn new(text: &str) -> Self {
        let bytes = text.as_bytes();
        let is_end = |at: &usize| {
            bytes[*at] == b'\n' || bytes[*at] == b'\r' && bytes.get(at + 1) != Some(&b'\n')
        };
        let ends = (0..bytes.len()).filter(is_end).map(|at| at + 1);
        let starts = std::iter::once(0).chain(ends).collect();
        let (mut columns, mut before) = (ColumnCount::default(), 0);
        let n_blocks = text.len().div_ceil(BLOCK);
        let block = |idx| {
            // A block begins with the character that its first byte belongs to.
            let start = block_start(text, idx);
            columns.add(&text[std::mem::replace(&mut before, start)..start]);
            columns
        };
        let blocks = (0..n_blocks).map(block).collect();
        Self { starts, blocks }
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
        let column = self.columns(text, at, unit) - self.columns(text, self.starts[line], unit);
        LineColumn { line, column }
    }

    /// How many columns the text takes before a byte, which is the start of a character, or its end.
    fn columns(&self, text: &str, at: usize, unit: ColumnUnit) -> usize {
        let block = (at / BLOCK).min(self.blocks.len().saturating_sub(1));
        let mut columns = self.blocks.get(block).copied().unwrap_or_default();
        columns.add(&text[block_start(text, block)..at]);
        match unit {
            ColumnUnit::Utf8 => at,
            ColumnUnit::Utf16 => columns.utf16,
            ColumnUnit::Utf32 => columns.utf32,
        }
    }

    /// The byte at a line and column: beyond the end of a line its end, beyond the text its end, inside
    /// of a character its start.
    #[must_use]
    pub fn offset(&self, text: &str, at: LineColumn, unit: ColumnUnit) -> usize {
        let range = self.line(at.line, text);
        let end = range.start + text[range.clone()].trim_end_matches(['\n', '\r']).len();
        let wanted = self.columns(text, range.start, unit).saturating_add(at.column);
        let behind = match unit {
            ColumnUnit::Utf8 => wanted / BLOCK + 1,
            ColumnUnit::Utf16 => self.blocks.partition_point(|before| before.utf16 <= wanted),
            ColumnUnit::Utf32 => self.blocks.partition_point(|before| before.utf32 <= wanted),
        };
        let start = block_start(text, behind.saturating_sub(1)).clamp(range.start, end);
        let mut column = self.columns(text, start, unit);
        for (idx, character) in text[start..end].char_indices() {
            column += unit.width(character);
            if wanted < column {
                return start + idx;
            }
        }
        end
    }
}

/// The first character of a block.
fn block_start(text: &str, block: usize) -> usize {
    text.floor_char_boundary(block.saturating_mul(BLOCK))
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
    fn places_in_long_lines_go_there_and_back() {
        // Characters of one to four bytes, so that blocks end inside of some, and after others.
        let long = "aü€🫖b".repeat(300);
        for pad in 0..4 {
            let text = format!("{}{long}\n\r\n{long}\r{long}", "x".repeat(pad));
            let lines = LineIndex::new(&text);
            for unit in [ColumnUnit::Utf8, ColumnUnit::Utf16, ColumnUnit::Utf32] {
                let mut place = LineColumn::default();
                for (at, character) in text.char_indices().filter(|(_, c)| !"\r\n".contains(*c)) {
                    let found = lines.position(&text, at, unit);
                    if place.line < found.line {
                        place = LineColumn { line: found.line, column: 0 };
                    }
                    assert_eq!(found, place, "{at} {unit:?}");
                    assert_eq!(lines.offset(&text, place, unit), at, "{at} {unit:?}");
                    place.column += unit.width(character);
                }
                let end = lines.position(&text, text.len(), unit);
                assert_eq!(end, place);
                assert_eq!(lines.offset(&text, end, unit), text.len());
                let beyond = LineColumn { line: 0, column: usize::MAX };
                assert_eq!(lines.offset(&text, beyond, unit), pad + long.len());
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
