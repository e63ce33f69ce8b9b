//! Documents as one page of HTML: no script, no address outside of the page, and a policy that says so.
//! WHATWG, *HTML Living Standard*; W3C, *Content Security Policy Level 3*.

use std::io::{self, Write};

use super::{
    super::xml::escaped,
    markup::{DocumentCell, DocumentTable, Markup, rest_of, word, write_address},
};

/// How the page looks, on a screen and on paper.
const STYLE: &str = include_str!("page.css");

pub(super) struct Html<'w> {
    out: &'w mut dyn Write,
}

impl<'w> Html<'w> {
    pub(super) fn new(out: &'w mut dyn Write) -> Self {
        Self { out }
    }
}

impl Markup for Html<'_> {
    fn begin(&mut self, title: &str) -> io::Result<()> {
        let title = escaped(title.trim());
        write!(
            self.out,
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta http-equiv=\"Content-Security-Policy\" \
             content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'\">\n\
             <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n\
             <h1>{title}</h1>\n"
        )
    }

    fn heading(&mut self, text: &str) -> io::Result<()> {
        writeln!(self.out, "<h2>{}</h2>", escaped(text.trim()))
    }

    fn paragraph(&mut self, text: &str) -> io::Result<()> {
        let lines: Vec<String> = text.lines().map(|line| escaped(line.trim())).collect();
        writeln!(self.out, "<p>{}</p>", lines.join("<br>\n"))
    }

    fn verdict(&mut self, holds: bool, text: &str) -> io::Result<()> {
        let (class, mark) = if holds { ("holds", '✓') } else { ("fails", '✗') };
        writeln!(self.out, "<p class=\"verdict {class}\">{mark} {}</p>", escaped(text))
    }

    fn table(&mut self, table: &DocumentTable) -> io::Result<()> {
        writeln!(self.out, "<div class=\"wide\"><table>")?;
        if let Some(caption) = &table.caption {
            writeln!(self.out, "<caption>{}</caption>", escaped(caption))?;
        }
        write!(self.out, "<thead><tr>")?;
        for (title, is_number) in &table.head {
            write!(self.out, "<th{}>{}</th>", class(*is_number), escaped(title))?;
        }
        write!(self.out, "</tr></thead>\n<tbody>\n")?;
        for row in &table.rows {
            let fails = row.contains(&DocumentCell::Verdict(false));
            write!(self.out, "<tr{}>", if fails { " class=\"fails\"" } else { "" })?;
            for (cell, (_, is_number)) in row.iter().zip(&table.head) {
                write!(self.out, "<td{}>{}</td>", class(*is_number), content(cell))?;
            }
            writeln!(self.out, "</tr>")?;
        }
        writeln!(self.out, "</tbody>\n</table></div>")?;
        match rest_of(table) {
            Some(rest) => writeln!(self.out, "<p>{rest}</p>"),
            None => Ok(()),
        }
    }

    fn picture(&mut self, png: &[u8], shows: &str) -> io::Result<()> {
        write!(self.out, "<figure><img alt=\"{}\" src=\"", escaped(shows))?;
        write_address(png, self.out)?;
        writeln!(self.out, "\"></figure>")
    }

    fn end(&mut self) -> io::Result<()> {
        writeln!(self.out, "</main>\n</body>\n</html>")
    }
}

fn class(is_number: bool) -> &'static str {
    if is_number { " class=\"number\"" } else { "" }
}

fn content(cell: &DocumentCell) -> String {
    match cell {
        DocumentCell::Text(text) => escaped(text),
        DocumentCell::Code(text) if text.is_empty() => String::new(),
        DocumentCell::Code(text) => format!("<code>{}</code>", escaped(text)),
        DocumentCell::Verdict(true) => format!("✓ {}", word(true)),
        DocumentCell::Verdict(false) => format!("<strong>✗ {}</strong>", word(false)),
    }
}
