//! Documents from files and into files.

use std::{
    fs,
    path::{Path, PathBuf},
};

use super::{
    super::reporter::{counted, pretty},
    document::PromptDocument,
    prompt::Prompt,
    show,
};
use crate::{
    disk::{Script, replace},
    export::io_reason,
    {session::Event, syntax::StatementRole, value::script_text},
};

/// What there is to say of a document that stands in the place of the one before.
pub(super) struct OpenedDocument {
    /// What was loaded.
    pub(super) told: String,
    /// The settings that no parameter of it takes, a sentence each.
    pub(super) unknown_settings: Vec<String>,
}

impl Prompt {
    /// Puts the document of a file into the place of this one, if all of it holds. Checks are
    /// judged; nothing is printed and no file written.
    pub(super) fn load(&mut self, path: &Path) {
        match Script::read(path, self.limits().source_bytes) {
            Ok(script) => {
                let Some(opened) = self.open(script) else { return };
                self.voice.remark(&opened.told);
                // They were meant for the script that the prompt began with.
                for message in opened.unknown_settings {
                    self.voice.remark(&format!("warning: {message}"));
                }
            }
            Err(message) => self.refuse(&message),
        }
    }

    /// [`Self::load`] of a script that was read; none where what is wrong with it was told.
    pub(super) fn open(&mut self, script: Script) -> Option<OpenedDocument> {
        let text = match script_text(&script.bytes) {
            Ok(text) => text.to_owned(),
            Err(what) => {
                self.refuse(&format!("{}: {what}", script.name));
                return None;
            }
        };
        let document = match PromptDocument::of(&text, self.limits()) {
            Ok(document) => document,
            Err(found) => {
                self.tell_wrong(&script.name, &text, &found);
                return None;
            }
        };
        let before = std::mem::take(&mut self.told);
        let files = self.engine.move_to(&script.folder);
        let Some(ran) = self.evaluate("", '\n', &text, ["document", &script.name]) else {
            self.told = before;
            self.engine.move_back(files);
            return None;
        };
        let mut report = ran.report;
        let unknown_settings = std::mem::take(&mut report.unknown_settings);
        let before = std::mem::replace(&mut self.document, document);
        self.undo.push(before, self.last.clone());
        self.folder = script.folder;
        self.file = script.path;
        report.events.retain(|event| matches!(event, Event::Checked(_)));
        self.act(&mut report);
        self.know(report);
        let time = pretty(ran.time);
        let n = counted(self.defined().count(), "definition");
        let n_exports = self.document.count(StatementRole::Export);
        let exports = match n_exports {
            0 => String::new(),
            _ => format!(", {} for `:export`", counted(n_exports, "file")),
        };
        let told = format!("loaded {}: {n}{exports} ({time})", show::cut(&script.name, 200));
        Some(OpenedDocument { told, unknown_settings })
    }

    /// Writes the document as a script. A file that is not its own is kept.
    pub(super) fn save(&mut self, name: &str, may_replace: bool) {
        let path = match (name, &self.file) {
            ("", Some(path)) => path.clone(),
            ("", None) => return self.refuse("where to? `:save FILE`"),
            (name, _) => PathBuf::from(name),
        };
        let is_own = self.file.as_ref().is_some_and(|own| *own == path);
        if path.exists() && !is_own && !may_replace {
            let message = format!(
                "`{}` is there already; `:save! {}` replaces it",
                path.display(),
                path.display()
            );
            return self.refuse(&message);
        }
        let text = self.document.text();
        let permissions = fs::metadata(&path).ok().map(|data| data.permissions());
        let written = replace(&path, permissions, |out| out.write_all(text.as_bytes()));
        match written {
            Ok(()) => {
                self.voice.remark(&format!("saved {}", path.display()));
                self.file = Some(path);
            }
            Err(err) => {
                self.refuse(&format!("cannot write `{}`: {}", path.display(), io_reason(&err)));
            }
        }
    }
}
