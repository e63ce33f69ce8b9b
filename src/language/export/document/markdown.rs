//! Documents as Markdown: CommonMark 0.31 with the tables of GitHub Flavored Markdown 0.29, §4.10.
//!
//! Text is escaped, so that it reads as it was written. Pictures are reference images whose data stand
//! at the end, so that the text before them can be read as it is.

use std::io::{self, Write};

use super::markup::{DocumentCell, DocumentTable, Markup, rest_of, word, write_address};

pub(super) struct Markdown<'w> {
    out: &'w mut dyn Write,
    /// The pictures so far, whose data are written at the end.
    pictures: Vec<Vec<u8>>,
}

impl<'w> Markdown<'w> {
    pub(super) fn new(out: &'w mut dyn Write) -> Self {
        Self { out, pictures: Vec::new() }
    }

    fn row(&mut self, cells: impl Iterator<Item = String>) -> io::Result<()> {
        for cell in cells {
            write!(self.out, "| {cell} ")?;
        }
        writeln!(self.out, "|")
    }
}

impl Markup for Markdown<'_> {
    fn begin(&mut self, title: &str) -> io::Result<()> {
        writeln!(self.out, "# {}", line(title))
    }

    fn heading(&mut self, text: &str) -> io::Result<()> {
        writeln!(self.out, "\n## {}", line(text))
    }

    fn paragraph(&mut self, text: &str) -> io::Result<()> {
        // A backslash before a line break keeps it.
        let lines: Vec<String> = text.lines().map(line).collect();
        writeln!(self.out, "\n{}", lines.join("\\\n"))
    }

    fn verdict(&mut self, holds: bool, text: &str) -> io::Result<()> {
        let mark = if holds { '✓' } else { '✗' };
        writeln!(self.out, "\n**{mark} {}**", line(text))
    }

    fn table(&mut self, table: &DocumentTable) -> io::Result<()> {
        if let Some(caption) = &table.caption {
            writeln!(self.out, "\n**{}**", line(caption))?;
        }
        writeln!(self.out)?;
        self.row(table.head.iter().map(|(title, _)| line(title)))?;
        let rule = |is_number| if is_number { "---:" } else { "---" };
        self.row(table.head.iter().map(|&(_, is_number)| rule(is_number).to_owned()))?;
        for row in &table.rows {
            self.row(row.iter().map(cell))?;
        }
        match rest_of(table) {
            Some(rest) => writeln!(self.out, "\n{rest}"),
            None => Ok(()),
        }
    }

    fn picture(&mut self, png: &[u8], shows: &str) -> io::Result<()> {
        self.pictures.push(png.to_vec());
        writeln!(self.out, "\n![{}][picture-{}]", line(shows), self.pictures.len())
    }

    fn end(&mut self) -> io::Result<()> {
        for (idx, png) in self.pictures.iter().enumerate() {
            write!(self.out, "\n[picture-{}]: ", idx + 1)?;
            write_address(png, self.out)?;
            writeln!(self.out)?;
        }
        Ok(())
    }
}

fn cell(cell: &DocumentCell) -> String {
    match cell {
        DocumentCell::Text(text) => line(text),
        // The bar ends a cell also inside of code.
        DocumentCell::Code(text) => code(text).replace('|', "\\|"),
        DocumentCell::Verdict(true) => format!("✓ {}", word(true)),
        DocumentCell::Verdict(false) => format!("**✗ {}**", word(false)),
    }
}

/// Text on one line, with a backslash before whatever would mean something.
fn line(text: &str) -> String {
    let text = text.trim();
    let mut out = String::with_capacity(text.len() + 8);
    for (at, c) in text.char_indices() {
        if "\\`*_[]<>|~&#$".contains(c) || begins_block(&text[..at], c, &text[at + c.len_utf8()..])
        {
            out.push('\\');
        }
        out.push(if c.is_whitespace() { ' ' } else { c });
    }
    out
}

/// Whether a character would begin a list, or make a heading of the line above.
fn begins_block(before: &str, c: char, behind: &str) -> bool {
    let ends_word = behind.chars().next().is_none_or(char::is_whitespace);
    match c {
        '=' => before.is_empty(),
        '+' | '-' => before.is_empty() && (ends_word || behind.starts_with(c)),
        '.' | ')' => {
            ends_word && !before.is_empty() && before.bytes().all(|byte| byte.is_ascii_digit())
        }
        _ => false,
    }
}

/// Code on one line, between more backticks than stand in it one after another.
fn code(text: &str) -> String {
    let text: String =
        text.trim().chars().map(|c| if c.is_whitespace() { ' ' } else { c }).collect();
    if text.is_empty() {
        return text;
    }
    let longest = text.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest + 1);
    match text.starts_with('`') || text.ends_with('`') {
        true => format!("{fence} {text} {fence}"),
        false => format!("{fence}{text}{fence}"),
    }
}

#[cfg(test)]
mod tests {
    use super::{DocumentCell, cell, code, line};

    #[test]
    fn text_reads_as_it_was_written() {
        assert_eq!(line("a*b_c <d> | [e]\nf"), "a\\*b\\_c \\<d\\> \\| \\[e\\] f");
        assert_eq!(line("- no list"), "\\- no list");
        assert_eq!(line("12. no list"), "12\\. no list");
        assert_eq!(line("# no heading of 3.5 mm - at all"), "\\# no heading of 3.5 mm - at all");
        assert_eq!(["0.25", "-3 mm", ".5"].map(line), ["0.25", "-3 mm", ".5"]);
    }

    #[test]
    fn code_holds_backticks_and_bars() {
        assert_eq!(code("a ~= b"), "`a ~= b`");
        assert_eq!(code("a `` b"), "```a `` b```");
        assert_eq!(code("`"), "`` ` ``");
        assert_eq!(cell(&DocumentCell::Code("xs |> sum()".to_owned())), "`xs \\|> sum()`");
    }
}
