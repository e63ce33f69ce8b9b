//! Cards of 80 columns: sections, directory entries of two cards, parameters.
//!
//! IGES 5.3, §2.2.4.

use std::io::Write;

use super::super::{ExportError, text::TextBuffer};

/// Columns that parameters may use in the global section, and in the parameter section.
const GLOBAL_COLUMNS: usize = 72;
const PARAMETER_COLUMNS: usize = 64;

/// Letters of a name; a card has place for no more beside what else it holds.
const MOST_LETTERS: usize = 50;

/// An entity: its parameters, and what its directory entry says.
pub(super) struct Entity {
    kind: usize,
    pub(super) form: usize,
    pub(super) level: usize,
    /// The directory entry of its colour, or 0.
    pub(super) color: usize,
    pub(super) status: &'static str,
    pub(super) label: String,
    tokens: Vec<String>,
}

impl Entity {
    pub(super) fn new(kind: usize) -> Self {
        Self {
            kind,
            form: 0,
            level: 0,
            color: 0,
            status: "00000000",
            label: String::new(),
            tokens: Vec::new(),
        }
    }

    pub(super) fn int(&mut self, n: usize) {
        self.tokens.push(n.to_string());
    }

    /// A number, which must have a decimal point; `D` marks double precision.
    pub(super) fn real(&mut self, value: f64) {
        let mut text = TextBuffer::default();
        text.pointed(value, "D");
        self.tokens.push(text.into_string());
    }

    /// A string with its length before it; characters beyond ASCII become question marks.
    pub(super) fn string(&mut self, text: &str) {
        let text = ascii(text);
        self.tokens.push(if text.is_empty() { text } else { format!("{}H{text}", text.len()) });
    }

    /// The parameters on cards of so many columns: a parameter is not divided.
    fn lines(&self, columns: usize) -> Vec<String> {
        let mut lines = vec![String::with_capacity(columns)];
        let kind = (self.kind != 0).then(|| self.kind.to_string());
        let n = self.tokens.len() + usize::from(kind.is_some());
        for (i, token) in kind.iter().chain(&self.tokens).enumerate() {
            let end = if i + 1 == n { ";" } else { "," };
            match lines.last_mut() {
                Some(line) if line.len() + token.len() < columns => line.push_str(token),
                _ => lines.push(token.clone()),
            }
            if let Some(line) = lines.last_mut() {
                line.push_str(end);
            }
        }
        lines
    }
}

fn ascii(text: &str) -> String {
    let letters = text.chars().take(MOST_LETTERS);
    letters.map(|c| if c.is_ascii_graphic() || c == ' ' { c } else { '?' }).collect()
}

/// The directory and the parameters of a file under construction.
#[derive(Default)]
pub(super) struct Cards {
    directory: TextBuffer,
    parameters: TextBuffer,
    n_directory: usize,
    n_parameters: usize,
}

impl Cards {
    /// Adds an entity; the number of its directory entry.
    pub(super) fn add(&mut self, entity: Entity) -> usize {
        let own = self.n_directory + 1;
        let lines = entity.lines(PARAMETER_COLUMNS);
        let first = self.n_parameters + 1;
        for line in &lines {
            self.n_parameters += 1;
            let card = format!("{line:<64} {own:>7}P{:>7}\n", self.n_parameters);
            self.parameters.push(&card);
        }
        let label: String = ascii(&entity.label).chars().take(8).collect();
        let color = if entity.color == 0 { "0".to_owned() } else { format!("-{}", entity.color) };
        let Entity { kind, level, form, status, .. } = entity;
        let card = format!(
            "{kind:>8}{first:>8}{0:>8}{0:>8}{level:>8}{0:>8}{0:>8}{0:>8}{status}D{own:>7}\n",
            0
        );
        self.directory.push(&card);
        let n_lines = lines.len();
        let card = format!(
            "{kind:>8}{0:>8}{color:>8}{n_lines:>8}{form:>8}{1:>8}{1:>8}{label:>8}{0:>8}D{2:>7}\n",
            0,
            "",
            own + 1
        );
        self.directory.push(&card);
        self.n_directory += 2;
        own
    }

    /// Writes all sections.
    pub(super) fn write(mut self, global: &Entity, out: &mut dyn Write) -> Result<(), ExportError> {
        let mut head = TextBuffer::default();
        head.push(&format!("{:<72}S{:>7}\n", "virote", 1));
        let lines = global.lines(GLOBAL_COLUMNS);
        for (i, line) in lines.iter().enumerate() {
            head.push(&format!("{line:<72}G{:>7}\n", i + 1));
        }
        head.flush(out)?;
        self.directory.flush(out)?;
        self.parameters.flush(out)?;
        let counts = format!(
            "S{:>7}G{:>7}D{:>7}P{:>7}",
            1,
            lines.len(),
            self.n_directory,
            self.n_parameters
        );
        out.write_all(format!("{counts:<72}T{:>7}\n", 1).as_bytes())?;
        Ok(())
    }
}
