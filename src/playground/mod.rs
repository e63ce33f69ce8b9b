//! The door of a page without a server: one function of messages.
//!
//! A [`Playground`] holds a script with the files that it reads, and answers what `page`
//! answers over HTTP elsewhere, and what an editor asks of [`ide`](crate::ide).
//!
//! A message is a length in four bytes, little-endian, that much JSON, and then attachments: the member
//! `parts` has the length of each, and each begins at the next multiple of 8. An answer has the same form;
//! a refusal is `{"error": "a sentence"}`.

mod framing;
mod writing;

use std::{collections::BTreeSet, path::Path, sync::Arc};

use serde_json::{Value as Json, json};

use self::framing::Message;
use crate::{
    eval::Setting,
    ide::Document,
    page::{
        Answer, Known, Model, PageRun, RunPlace, Shown, ask::ask, defaults::rewritten,
        deviation::deviation, export::wanted, isocurves::isocurves, keys_of, measure::measure,
        settings, stripes::stripes,
    },
    session::Session,
    value::MemoryFiles,
};

/// A script that is written and shown in a page.
#[derive(Debug)]
pub struct Playground {
    model: Model,
    /// For questions; without a memory.
    session: Session,
    known: Known,
    settings: Vec<Setting>,
    name: String,
    text: String,
    files: MemoryFiles,
    file_names: BTreeSet<String>,
    document: Option<Document>,
    clock: fn() -> f64,
}

/// An answer with its attachments.
type FullAnswer = Result<(Json, Vec<Arc<Vec<u8>>>), String>;

impl Playground {
    /// A playground with nothing in it. `session` makes a session; `process` tells keys of its items from
    /// those of other playgrounds, which a page may still know; `clock` counts milliseconds.
    ///
    /// ```
    /// use virote::{playground::Playground, session::Session};
    ///
    /// let mut playground = Playground::new(&Session::default, 1, || 0.0);
    /// let request = br#"{"call": "text", "text": "print 1 + 1"}"#;
    /// let message = [&(request.len() as u32).to_le_bytes()[..], request].concat();
    /// let answer = playground.answer(&message);
    /// let length = u32::from_le_bytes([answer[0], answer[1], answer[2], answer[3]]) as usize;
    /// let state = String::from_utf8_lossy(&answer[4..4 + length]);
    /// assert!(state.contains(r#""prints":[{"text":"1 + 1","value":"2","line":1}]"#));
    /// ```
    #[must_use]
    pub fn new(session: &dyn Fn() -> Session, process: u64, clock: fn() -> f64) -> Self {
        let first = Arc::new(Model::empty(Path::new(NAME), Path::new("")));
        Self {
            model: Model::new(session(), process),
            session: session(),
            known: Known { before: Arc::clone(&first), shown: first },
            settings: Vec::new(),
            name: NAME.to_owned(),
            text: String::new(),
            files: MemoryFiles::default(),
            file_names: BTreeSet::new(),
            document: None,
            clock,
        }
    }

    /// The answer to a message.
    pub fn answer(&mut self, message: &[u8]) -> Vec<u8> {
        let answer = Message::read(message).and_then(|message| self.full_answer(&message));
        let (mut head, parts) = answer.unwrap_or_else(|why| (json!({ "error": why }), Vec::new()));
        framing::written(&mut head, &parts)
    }

    fn full_answer(&mut self, message: &Message<'_>) -> FullAnswer {
        let body = &message.head;
        let (known, session) = (&self.known, &self.session);
        match body["call"].as_str().unwrap_or_default() {
            "items" => {
                let parts = known.bytes(&keys_of(&body["items"])?, session);
                Ok((json!({}), parts))
            }
            "deviation" => Ok(numbers(deviation(body, known, session)?)),
            "isocurves" => {
                let item = isocurves(body, known, session)?;
                Ok((json!({}), vec![Arc::new(item)]))
            }
            "stripes" => Ok(numbers(stripes(body, known, session)?)),
            "export" => self.export(body),
            _ => self.plain_answer(message).map(|answer| (answer, Vec::new())),
        }
    }

    fn plain_answer(&mut self, message: &Message<'_>) -> Answer {
        let body = &message.head;
        match body["call"].as_str().unwrap_or_default() {
            "reset" => self.reset(body),
            "file" => self.put_file(message),
            "edit" => self.edit(body).map(|()| json!({})),
            "text" => {
                self.edit(body)?;
                self.run()
            }
            "set" => {
                let change = settings::changed(body, &self.known.shown)?;
                change(&mut self.settings);
                self.run()
            }
            "state" => state(&self.known.shown),
            "ask" => ask(body, &self.known, &self.session),
            "measure" => measure(body, &self.known, &self.session),
            "write" => self.write(body),
            call => self.writing(call, body),
        }
    }

    /// Takes a text over without evaluating it: enough for what is asked while it is written.
    fn edit(&mut self, body: &Json) -> Result<(), String> {
        text_of(body, "text")?.clone_into(&mut self.text);
        self.document = None;
        Ok(())
    }

    /// Forgets files and settings; what is shown stays until the next run.
    fn reset(&mut self, body: &Json) -> Answer {
        text_of(body, "name")?.clone_into(&mut self.name);
        self.files = MemoryFiles::default();
        self.file_names.clear();
        self.settings.clear();
        self.document = None;
        Ok(json!({}))
    }

    /// Puts a file beside the script.
    fn put_file(&mut self, message: &Message<'_>) -> Answer {
        let path = text_of(&message.head, "path")?;
        let bytes = message.parts.first().ok_or("a file comes with its bytes")?;
        self.files.insert(path, *bytes);
        self.file_names.insert(path.to_owned());
        self.document = None;
        Ok(json!({}))
    }

    /// Evaluates the text with the settings; the answer is the state.
    fn run(&mut self) -> Answer {
        let place = RunPlace {
            version: self.known.shown.version + 1,
            script: Path::new(&self.name),
            out: Path::new(""),
            settings: &self.settings,
        };
        let run = PageRun {
            name: &self.name,
            bytes: self.text.as_bytes(),
            files: &self.files,
            // A text that changed may have other parameters.
            is_file_new: true,
            is_stale: &|| false,
            clock: &self.clock,
        };
        let shown = self.model.run(place, run).ok_or("it was stopped")?;
        self.settings.retain(|setting| !shown.lost.contains(&setting.name));
        let shown = Arc::new(shown);
        self.known.before = std::mem::replace(&mut self.known.shown, shown);
        state(&self.known.shown)
    }

    /// The text with these values as the defaults of its parameters.
    fn write(&mut self, body: &Json) -> Answer {
        let given = settings::to_be_written(body, &self.known.shown, &self.settings)?;
        let text = rewritten(&self.text, &given, &self.session, &self.files)?;
        let names: Vec<String> = given.into_iter().map(|(name, _)| name).collect();
        // What is the default now is set no more.
        self.settings.retain(|setting| !names.contains(&setting.name));
        Ok(json!({ "written": names, "text": text }))
    }

    /// The files that are asked for: all, or none.
    fn export(&self, body: &Json) -> FullAnswer {
        let report = self.known.shown.to_export()?;
        let (mut names, mut parts) = (Vec::new(), Vec::new());
        for file in wanted(body, report, &self.session)? {
            let mut bytes = Vec::new();
            let cannot = |why: &str| format!("cannot write `{}`: {why}", file.path);
            file.write(&mut bytes).map_err(|found| cannot(&found.message))?;
            names.push(file.path.clone());
            parts.push(Arc::new(bytes));
        }
        Ok((json!({ "files": names }), parts))
    }
}

/// What a script is called that has no name.
const NAME: &str = "script.geo";

/// An answer of numbers, four bytes each.
fn numbers(numbers: Vec<f64>) -> (Json, Vec<Arc<Vec<u8>>>) {
    let bytes = numbers.into_iter().flat_map(|number| (number as f32).to_le_bytes());
    (json!({}), vec![Arc::new(bytes.collect())])
}

fn state(shown: &Shown) -> Answer {
    serde_json::from_slice(&shown.state).map_err(|err| err.to_string())
}

fn text_of<'b>(body: &'b Json, name: &str) -> Result<&'b str, String> {
    body[name].as_str().ok_or_else(|| format!("`{name}` must be a text"))
}
