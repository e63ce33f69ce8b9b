//! Text that knows where its lines may be broken.
//!
//! Groups are broken as a whole, the outermost that does not fit first; a fill breaks only where
//! it must. Oppen, "Prettyprinting" (1980), with the widths computed beforehand.

use std::borrow::Cow;

/// Spaces of one indentation.
const INDENT: usize = 2;

/// A part of a layout.
#[derive(Debug)]
enum Part<'a> {
    Text(Cow<'a, str>),
    /// A line break if the group is broken, else this text.
    Soft(&'static str),
    /// A line break if what follows up to the next break does not fit, else this text.
    Fill(&'static str),
    /// This text if the group is broken.
    IfBroken(&'static str),
    /// Always a line break; `; ` where everything must stay on one line.
    Hard,
    Open,
    Close,
    Indent,
    Dedent,
}

/// A text under construction.
#[derive(Debug)]
pub(super) struct Layout<'a> {
    parts: Vec<Part<'a>>,
    /// Where numbers and strings are copied from; without it they are spelled anew.
    source: Option<&'a str>,
}

impl<'a> Layout<'a> {
    pub(super) fn new(source: Option<&'a str>) -> Self {
        Self { parts: Vec::new(), source }
    }

    pub(super) fn source(&self) -> Option<&'a str> {
        self.source
    }

    pub(super) fn text(&mut self, text: impl Into<Cow<'a, str>>) {
        self.parts.push(Part::Text(text.into()));
    }

    pub(super) fn soft_break(&mut self, flat: &'static str) {
        self.parts.push(Part::Soft(flat));
    }

    pub(super) fn fill_break(&mut self) {
        self.parts.push(Part::Fill(" "));
    }

    pub(super) fn if_broken(&mut self, text: &'static str) {
        self.parts.push(Part::IfBroken(text));
    }

    pub(super) fn hard_break(&mut self) {
        self.parts.push(Part::Hard);
    }

    pub(super) fn open(&mut self) {
        self.parts.push(Part::Open);
    }

    pub(super) fn close(&mut self) {
        self.parts.push(Part::Close);
    }

    pub(super) fn indent(&mut self) {
        self.parts.push(Part::Indent);
    }

    pub(super) fn dedent(&mut self) {
        self.parts.push(Part::Dedent);
    }

    /// Items between brackets that stand already: all on one line, or one a line.
    pub(super) fn items<T>(&mut self, items: &'a [T], mut item: impl FnMut(&mut Self, &'a T)) {
        if items.is_empty() {
            return;
        }
        self.open();
        self.indent();
        self.soft_break("");
        for (index, one) in items.iter().enumerate() {
            if index > 0 {
                self.text(",");
                self.soft_break(" ");
            }
            item(self, one);
        }
        self.if_broken(",");
        self.dedent();
        self.soft_break("");
        self.close();
    }

    /// The text with lines of at most `width` columns where its breaks allow that.
    pub(super) fn render(&self, width: usize) -> String {
        let widths = self.group_widths();
        let mut out = Output { text: String::new(), column: 0, indent: 0, most: width / 2 };
        let mut broken = vec![true];
        for (at, part) in self.parts.iter().enumerate() {
            let is_broken = *broken.last().unwrap_or(&true);
            match part {
                Part::Text(text) => out.write(text),
                Part::Open => broken.push(out.column.saturating_add(widths[at]) > width),
                Part::Close => {
                    broken.pop();
                }
                Part::Indent => out.indent += INDENT,
                Part::Dedent => out.indent -= INDENT,
                Part::Hard => out.new_line(),
                Part::Soft(flat) if !is_broken => out.write(flat),
                Part::Soft(_) => out.new_line(),
                Part::Fill(flat) => {
                    let next = flat.len() + self.width_to_break(at + 1);
                    if is_broken && out.column + next > width {
                        out.new_line();
                    } else {
                        out.write(flat);
                    }
                }
                Part::IfBroken(text) if is_broken => out.write(text),
                Part::IfBroken(_) => {}
            }
        }
        out.text
    }

    /// The text on one line.
    pub(super) fn render_flat(&self) -> String {
        let mut out = String::new();
        for part in &self.parts {
            match part {
                Part::Text(text) => out.push_str(text),
                Part::Soft(flat) | Part::Fill(flat) => out.push_str(flat),
                Part::Hard => out.push_str("; "),
                Part::IfBroken(_) | Part::Open | Part::Close | Part::Indent | Part::Dedent => {}
            }
        }
        out
    }

    /// For each `Open` the columns of its group on one line, with the text right behind it;
    /// no line is long enough for a group with a hard break.
    fn group_widths(&self) -> Vec<usize> {
        let mut widths = vec![0; self.parts.len()];
        // From the back: the columns and hard breaks behind, and the columns up to the next break.
        let (mut columns, mut n_hard, mut tail) = (0, 0_usize, 0);
        let mut open = Vec::new();
        for (at, part) in self.parts.iter().enumerate().rev() {
            match part {
                Part::Text(text) => {
                    let added = text.chars().count();
                    (columns, tail) = (columns + added, tail + added);
                }
                Part::Soft(flat) | Part::Fill(flat) => {
                    (columns, tail) = (columns + flat.len(), 0);
                }
                Part::Hard => (n_hard, tail) = (n_hard + 1, 0),
                Part::Close => open.push((columns, n_hard, tail)),
                Part::Open => {
                    let (columns_behind, n_hard_behind, tail_behind) =
                        open.pop().unwrap_or_default();
                    let width = columns - columns_behind + tail_behind;
                    widths[at] = if n_hard > n_hard_behind { usize::MAX } else { width };
                }
                Part::IfBroken(_) | Part::Indent | Part::Dedent => {}
            }
        }
        widths
    }

    /// Columns from part `at` to the next possible break.
    fn width_to_break(&self, at: usize) -> usize {
        let mut width = 0;
        for part in &self.parts[at..] {
            match part {
                Part::Text(text) => width += text.chars().count(),
                Part::IfBroken(text) => width += text.len(),
                Part::Soft(_) | Part::Fill(_) | Part::Hard => break,
                Part::Open | Part::Close | Part::Indent | Part::Dedent => {}
            }
        }
        width
    }
}

struct Output {
    text: String,
    column: usize,
    indent: usize,
    /// Deeper than this nothing is indented, lest a text grow with the square of its depth.
    most: usize,
}

impl Output {
    fn write(&mut self, text: &str) {
        if text.is_empty() {
            return;
        }
        if self.column == 0 {
            self.column = self.indent.min(self.most);
            self.text.extend(std::iter::repeat_n(' ', self.column));
        }
        self.text.push_str(text);
        self.column += text.chars().count();
    }

    fn new_line(&mut self) {
        let kept = self.text.trim_end_matches(' ').len();
        self.text.truncate(kept);
        self.text.push('\n');
        self.column = 0;
    }
}
