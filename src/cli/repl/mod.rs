//! `virote repl`: a document that grows entry by entry, and answers.
//!
//! An entry is a statement, which joins the document once all of it holds; an expression, whose
//! value is told; or a command, which begins with a colon. Whatever goes wrong leaves the document
//! as it was. Without a terminal the same entries come line by line from standard input, and only
//! answers are written.

mod command;
mod complete;
mod concerned;
mod document;
mod editor;
mod engine;
mod graph;
mod join;
mod load;
mod options;
mod part_run;
mod pipe;
mod plot;
mod prompt;
mod show;
mod statement;

use std::{
    collections::BTreeSet,
    io::{self, IsTerminal},
    path::{Path, PathBuf},
    sync::{Arc, Weak},
};

use self::{
    complete::Scope,
    document::{PromptDocument, UndoHistory},
    editor::{Editor, EditorEvent},
    engine::Engine,
    prompt::Prompt,
};
use super::{
    exit_status::ExitStatus, interrupt, reporter::Reporter, run_args::RunArgs, settings,
    standard_streams::say,
};
use crate::{
    disk::Script,
    ide::Values,
    syntax::{PromptEntry, ast::Unit, entry, parts},
    value::NoFiles,
};

/// `virote repl [FILE]`
pub(super) fn run(file: Option<&Path>, out: Option<&Path>, common: &RunArgs) -> ExitStatus {
    let voice = Reporter::new(&common.talk, common.ceilings().diagnostics).at_prompt();
    let settings = match settings::given(common, common.ceilings().input_bytes, &voice) {
        Ok(settings) => settings,
        Err(ending) => return ending,
    };
    let engine = Engine::new(common, Path::new("."), settings);
    let nothing = engine.session().run("document", b"", &NoFiles, &[]);
    let mut prompt = Prompt {
        engine,
        voice,
        document: PromptDocument::default(),
        undo: UndoHistory::default(),
        last: None,
        told: BTreeSet::new(),
        values: Arc::new(Values::new(Arc::new(nothing))),
        values_of: Weak::new(),
        n_joined: 0,
        folder: PathBuf::from("."),
        out: out.map(Path::to_path_buf),
        file: None,
        columns: 80,
        width: None,
        is_terminal: io::stdin().is_terminal() && io::stdout().is_terminal(),
        with_color: common.talk.with_color(),
        worst: ExitStatus::Well,
        is_over: false,
        unit: Unit::Mm,
    };
    if let Some(file) = file {
        // As of every other command.
        match Script::read(file, prompt.limits().source_bytes) {
            Ok(script) => {
                if let Some(opened) = prompt.open(script) {
                    let unknown = opened.unknown_settings;
                    if !unknown.is_empty() {
                        unknown.iter().for_each(|message| prompt.voice.trouble(message));
                        return ExitStatus::Usage;
                    }
                    prompt.voice.remark(&opened.told);
                }
            }
            Err(message) => {
                prompt.voice.trouble(&message);
                return ExitStatus::Usage;
            }
        }
    }
    if prompt.is_terminal { prompt.converse(common.talk.quiet) } else { prompt.listen() }
}

impl Prompt {
    /// Entries from a terminal.
    fn converse(&mut self, is_quiet: bool) -> ExitStatus {
        interrupt::listen();
        let (mut editor, warning) = match Editor::new(*self.limits(), self.with_color) {
            Ok(editor) => editor,
            Err(err) => {
                self.voice.trouble(&format!("the terminal cannot be used: {err}"));
                return ExitStatus::Usage;
            }
        };
        if !is_quiet {
            say("virote: statements join the document, expressions are answered, `:help` helps\n");
        }
        if let Some(warning) = warning {
            self.voice.remark(&format!("warning: {warning}"));
        }
        while !self.is_over {
            self.columns = self.width.unwrap_or_else(|| editor.columns());
            editor.paint(self.with_color, *self.limits());
            editor.know(self.scope());
            match editor.read() {
                EditorEvent::Entry(text) => {
                    editor.forget();
                    self.take(&text);
                }
                EditorEvent::GivenUp => self.voice.remark("(Ctrl-D or `:quit` ends)"),
                EditorEvent::End => break,
            }
        }
        ExitStatus::Well
    }

    /// What can be completed.
    fn scope(&self) -> Scope {
        Scope {
            session: Arc::clone(self.engine.session()),
            document: self.document.clone(),
            values: Arc::clone(&self.values),
            folder: self.folder.clone(),
        }
    }

    /// Does what an entry wants.
    fn take(&mut self, text: &str) {
        let text = text.trim_end();
        if let Some(command) = text.trim_start().strip_prefix(':') {
            return command::run(self, command);
        }
        if let Some(name) = text.trim_start().strip_prefix('?') {
            return command::run(self, &format!("help {name}"));
        }
        match entry(text) {
            PromptEntry::Empty => {}
            PromptEntry::Statements => self.state(text),
            PromptEntry::Expression => {
                // Statements may follow where several lines were pasted.
                let asked = format!("print {text}");
                let end = match parts(&asked, self.limits()) {
                    Ok(parts) if parts.len() > 1 => parts[0].range.end - "print ".len(),
                    _ => text.len(),
                };
                let (question, rest) = text.split_at(end);
                if let Some((printed, _)) = self.ask(question) {
                    printed.iter().for_each(|printed| self.answer(&printed.value));
                    self.take(rest);
                }
            }
        }
    }
}
