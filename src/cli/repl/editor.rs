//! The line editor: colours, completion, entries of several lines, a history that stays.

use std::{borrow::Cow, env, fmt::Write as _, fs, path::PathBuf};

use rustyline::{
    CompletionType, Config, Context, Editor as Lines, Helper,
    completion::{Completer, Pair},
    error::ReadlineError,
    highlight::{CmdKind, Highlighter},
    hint::Hinter,
    history::FileHistory,
    validate::{ValidationContext, ValidationResult, Validator},
};

use super::{complete::Scope, show::cut};
use crate::{
    export::io_reason,
    limits::Limits,
    syntax::{Highlight, is_complete, pieces},
};

/// What stands before an entry.
const PROMPT: &str = "geo> ";

/// Entries of more bytes are not coloured, and go into no history.
const MOST_BYTES: usize = 16 << 10;

/// Characters of a hint.
const MOST_HINT: usize = 60;

/// Entries that are remembered.
const MOST_ENTRIES: usize = 5_000;

/// What somebody did at the prompt.
pub(super) enum EditorEvent {
    /// An entry.
    Entry(String),
    /// Ctrl-C: the entry is given up.
    GivenUp,
    /// Ctrl-D, or the terminal is gone.
    End,
}

/// Reads entries from a terminal.
pub(super) struct Editor {
    lines: Lines<LineHelper, FileHistory>,
    history: Option<PathBuf>,
}

impl Editor {
    /// An editor, and what keeps its history from staying.
    pub(super) fn new(
        limits: Limits,
        with_color: bool,
    ) -> Result<(Self, Option<String>), ReadlineError> {
        let config = Config::builder()
            .completion_type(CompletionType::List)
            .max_history_size(MOST_ENTRIES)?
            .history_ignore_dups(true)?
            .history_ignore_space(true)
            .auto_add_history(false)
            .build();
        let mut lines = Lines::with_config(config)?;
        let assistant = LineHelper { limits, with_color, scope: None };
        lines.set_helper(Some(assistant));
        let (history, warning) = match history_file() {
            Some(path) => match open(&mut lines, &path) {
                Ok(()) => (Some(path), None),
                Err(why) => {
                    let text = format!("the history in `{}` is not kept: {why}", path.display());
                    (None, Some(text))
                }
            },
            None => (None, Some("the history is not kept: no home folder is known".to_owned())),
        };
        Ok((Self { lines, history }, warning))
    }

    /// Tells what there is to complete from now on.
    pub(super) fn know(&mut self, scope: Scope) {
        if let Some(assistant) = self.lines.helper_mut() {
            assistant.scope = Some(scope);
        }
    }

    /// Completes nothing until it knows again what there is.
    pub(super) fn forget(&mut self) {
        if let Some(assistant) = self.lines.helper_mut() {
            assistant.scope = None;
        }
    }

    /// Colours entries or not, and reads them under these ceilings.
    pub(super) fn paint(&mut self, with_color: bool, limits: Limits) {
        if let Some(assistant) = self.lines.helper_mut() {
            (assistant.with_color, assistant.limits) = (with_color, limits);
        }
    }

    /// The columns of the terminal.
    pub(super) fn columns(&mut self) -> usize {
        self.lines.dimensions().map_or(80, |(columns, _)| usize::from(columns))
    }

    /// The next entry.
    pub(super) fn read(&mut self) -> EditorEvent {
        match self.lines.readline(PROMPT) {
            Ok(entry) => {
                self.remember(&entry);
                EditorEvent::Entry(entry)
            }
            Err(ReadlineError::Interrupted) => EditorEvent::GivenUp,
            Err(_) => EditorEvent::End,
        }
    }

    /// Adds an entry to the history, at once also to its file: the program may end in any way.
    fn remember(&mut self, entry: &str) {
        let is_worth = !entry.trim().is_empty() && entry.len() <= MOST_BYTES;
        if is_worth
            && self.lines.add_history_entry(entry).unwrap_or(false)
            && let Some(path) = &self.history
        {
            // It could be written when the prompt began; a full disk since then is no matter.
            let _ = self.lines.append_history(path);
        }
    }
}

/// Reads the history, and makes sure that it can be written.
fn open(lines: &mut Lines<LineHelper, FileHistory>, path: &PathBuf) -> Result<(), String> {
    let told = |err: std::io::Error| io_reason(&err);
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(told)?;
    }
    fs::OpenOptions::new().append(true).create(true).open(path).map_err(told)?;
    if fs::metadata(path).map_err(told)?.len() > 0 {
        lines.load_history(path).map_err(|err| err.to_string())?;
    } else {
        // An empty file is no history of the editor's; it makes a new one.
        fs::remove_file(path).map_err(told)?;
        lines.save_history(path).map_err(|err| err.to_string())?;
    }
    Ok(())
}

/// The file in the user's folder for what programs remember.
fn history_file() -> Option<PathBuf> {
    let of = |name: &str| env::var_os(name).filter(|value| !value.is_empty()).map(PathBuf::from);
    let state = of("XDG_STATE_HOME")
        .or_else(|| of("LOCALAPPDATA"))
        .or_else(|| of("HOME").map(|home| home.join(".local").join("state")));
    Some(state?.join("virote").join("history"))
}

/// What helps while an entry is typed.
struct LineHelper {
    limits: Limits,
    with_color: bool,
    scope: Option<Scope>,
}

impl Helper for LineHelper {}

impl Hinter for LineHelper {
    type Hint = String;

    /// The argument that is being written; without colour it would look like a part of the entry.
    fn hint(&self, line: &str, pos: usize, _: &Context<'_>) -> Option<String> {
        let is_shown = self.with_color
            && pos == line.len()
            && pos <= MOST_BYTES
            && !line.trim_start().starts_with(':');
        let argument = self.scope.as_ref().filter(|_| is_shown)?.argument(line)?;
        Some(format!("  {}", cut(&argument, MOST_HINT)))
    }
}

impl Completer for LineHelper {
    type Candidate = Pair;

    fn complete(
        &self,
        line: &str,
        pos: usize,
        _: &Context<'_>,
    ) -> rustyline::Result<(usize, Vec<Pair>)> {
        let before = line.get(..pos).unwrap_or_default();
        let Some(scope) = self.scope.as_ref().filter(|_| before.len() <= MOST_BYTES) else {
            return Ok((pos, Vec::new()));
        };
        let (start, found) = scope.candidates(before);
        let width = found.iter().map(|one| one.text.chars().count()).max().unwrap_or(0).min(24);
        let pairs = found.into_iter().map(|one| Pair {
            display: format!("{:width$}  {}", one.text, one.what),
            replacement: one.text,
        });
        Ok((start, pairs.collect()))
    }
}

impl Highlighter for LineHelper {
    fn highlight<'l>(&self, line: &'l str, _: usize) -> Cow<'l, str> {
        let is_plain = !self.with_color || line.len() > MOST_BYTES || line.starts_with(':');
        if is_plain { Cow::Borrowed(line) } else { Cow::Owned(painted(line)) }
    }

    fn highlight_prompt<'b, 's: 'b, 'p: 'b>(&'s self, prompt: &'p str, _: bool) -> Cow<'b, str> {
        if self.with_color {
            Cow::Owned(format!("\x1b[1;36m{prompt}\x1b[0m"))
        } else {
            Cow::Borrowed(prompt)
        }
    }

    fn highlight_hint<'h>(&self, hint: &'h str) -> Cow<'h, str> {
        Cow::Owned(format!("\x1b[2m{hint}\x1b[0m"))
    }

    fn highlight_char(&self, line: &str, _: usize, _: CmdKind) -> bool {
        self.with_color && line.len() <= MOST_BYTES
    }
}

impl Validator for LineHelper {
    fn validate(&self, ctx: &mut ValidationContext<'_>) -> rustyline::Result<ValidationResult> {
        let input = ctx.input();
        let is_whole = input.trim_start().starts_with(':')
            || input.ends_with("\n\n")
            || is_complete(input, &self.limits);
        Ok(if is_whole { ValidationResult::Valid(None) } else { ValidationResult::Incomplete })
    }
}

/// A text in colours.
pub(super) fn painted(text: &str) -> String {
    let mut out = String::with_capacity(2 * text.len());
    let mut at = 0;
    for (paint, range) in pieces(text) {
        let Some(piece) = text.get(range.clone()) else { continue };
        out.push_str(text.get(at..range.start).unwrap_or_default());
        at = range.end;
        let color = match paint {
            Highlight::Keyword => "1;34",
            Highlight::Number => "36",
            Highlight::Text => "32",
            Highlight::Comment => "2",
            Highlight::Bad => "31",
            Highlight::Name | Highlight::Mark => {
                out.push_str(piece);
                continue;
            }
        };
        let _ = write!(out, "\x1b[{color}m{piece}\x1b[0m");
    }
    out.push_str(text.get(at..).unwrap_or_default());
    out
}

#[cfg(test)]
mod tests {
    use super::painted;

    #[test]
    fn colours_leave_the_text_as_it_is() {
        let text = "let a = [1mm, \"x {b}\"] // ü";
        let colored = painted(text);
        let mut parts = colored.split("\x1b[");
        let first = parts.next().unwrap_or_default().to_owned();
        let plain = parts
            .fold(first, |plain, part| plain + part.split_once('m').map_or("", |(_, rest)| rest));
        assert_eq!(plain, text);
        assert!(colored.starts_with("\x1b[1;34mlet\x1b[0m a = "));
    }
}
