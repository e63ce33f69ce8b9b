//! The loop of the server's thread: takes messages and reports as they come, and answers.

use std::{
    sync::Arc,
    time::{Duration, Instant},
};

use crossbeam_channel::{Receiver, select};
use lsp_server::{ErrorCode, Message, Notification, ProtocolError, Request};
use serde_json::{Value as Json, json};

use super::{
    answers,
    documents::OpenDocument,
    server::{RequestError, Server, WaitingRequest},
    worker::{Evaluated, EvaluationRequest},
};
use crate::diag::{Span, fault};

/// A run that is not over so long after an edit leaves time to tell what is wrong with the text alone.
const EARLY: Duration = Duration::from_millis(200);
/// How long a request waits for values that nobody asks for again: a client that can be told to ask anew waits
/// for less.
const PATIENCE: Duration = Duration::from_secs(2);

impl Server<'_> {
    /// Serves until the client says goodbye or is gone.
    pub(super) fn run(&mut self, finished: &Receiver<Evaluated>) -> Result<(), ProtocolError> {
        self.watch_files();
        loop {
            if self.receiver.is_empty() {
                self.evaluate_dirty();
            }
            let early = self.next_early();
            select! {
                recv(self.receiver) -> message => match message {
                    Ok(Message::Request(request)) => self.request(request),
                    Ok(Message::Notification(told)) if told.method == "exit" => return Ok(()),
                    Ok(Message::Notification(told)) => self.notification(told),
                    Ok(Message::Response(_)) => {}
                    // It went without a word.
                    Err(_) => return Ok(()),
                },
                recv(finished) -> done => {
                    if let Ok(done) = done {
                        self.finished(done);
                    }
                }
                default(early) => self.tell_early(),
            }
        }
    }

    /// How long until something is to be told early.
    fn next_early(&self) -> Duration {
        let unknown =
            self.documents.values().filter(|open| open.values().is_none() && !open.is_told_early);
        let early = unknown.map(|open| open.since + EARLY);
        let due = early.chain(self.waiting.iter().map(|waiting| waiting.deadline)).min();
        due.map_or(Duration::from_secs(3600), |due| due.saturating_duration_since(Instant::now()))
    }

    /// Tells what is wrong with the texts whose runs take long, and what else is known of them to who waits.
    fn tell_early(&mut self) {
        let is_due = |open: &&OpenDocument| {
            open.values().is_none() && !open.is_told_early && EARLY <= open.since.elapsed()
        };
        let due: Vec<String> =
            self.documents.values().filter(is_due).map(|open| open.uri.clone()).collect();
        for uri in due {
            self.publish_early(&uri);
        }
        let now = Instant::now();
        self.answer_waiting(|waiting| waiting.deadline <= now);
    }

    /// Answers those of the requests that wait for values.
    fn answer_waiting(&mut self, is_due: impl Fn(&WaitingRequest) -> bool) {
        let waiting = std::mem::take(&mut self.waiting);
        let (due, left): (Vec<_>, Vec<_>) = waiting.into_iter().partition(is_due);
        self.waiting = left;
        for WaitingRequest { request, uri, .. } in due {
            if let Some(open) = self.documents.get_mut(&uri) {
                open.lacked_values |= open.values().is_none();
            }
            self.answer(request);
        }
    }

    /// Asks to be told of files that change.
    fn watch_files(&mut self) {
        if self.client.watches_files {
            let watchers = json!([{ "globPattern": "**/*" }]);
            self.ask(
                "client/registerCapability",
                json!({ "registrations": [{
                    "id": "files",
                    "method": "workspace/didChangeWatchedFiles",
                    "registerOptions": { "watchers": watchers },
                }] }),
            );
        }
    }

    fn request(&mut self, request: Request) {
        if request.method == "shutdown" {
            self.is_shut = true;
            return self.reply(request.id, Ok(Json::Null.to_string()));
        }
        if self.is_shut {
            let refusal =
                RequestError(ErrorCode::InvalidRequest, "the server is shut down".to_owned());
            return self.reply(request.id, Err(refusal));
        }
        let uri = request.params.pointer("/textDocument/uri").and_then(Json::as_str);
        let open = uri.and_then(|uri| self.documents.get(uri));
        let is_waiting = answers::needs_values(&request.method)
            && open.is_some_and(|open| open.values().is_none());
        if let (true, Some(uri)) = (is_waiting, uri) {
            let can_ask_anew = match &*request.method {
                "textDocument/inlayHint" => self.client.refreshes_hints,
                "textDocument/codeLens" => self.client.refreshes_lenses,
                _ => false,
            };
            let deadline = Instant::now() + if can_ask_anew { EARLY } else { PATIENCE };
            let uri = uri.to_owned();
            self.waiting.push(WaitingRequest { request, uri, deadline });
            return;
        }
        self.answer(request);
    }

    fn answer(&mut self, request: Request) {
        let Request { id, method, params } = request;
        let caught = fault::caught(Span::default(), || Ok(answers::answer(self, &method, params)));
        let answer = caught.unwrap_or_else(|told| {
            Err(RequestError(ErrorCode::InternalError, told.message.clone()))
        });
        self.reply(id, answer);
    }

    fn notification(&mut self, told: Notification) {
        let Notification { method, params } = told;
        let known = fault::caught(Span::default(), || {
            self.noted(&method, params);
            Ok(())
        });
        if let Err(fault) = known {
            self.notify("window/logMessage", json!({ "type": 1, "message": fault.message }));
        }
    }

    fn noted(&mut self, method: &str, params: Json) {
        match method {
            "textDocument/didOpen" => self.opened(params),
            "textDocument/didChange" => self.changed(params),
            "textDocument/didClose" => self.closed(&params),
            "textDocument/didSave" | "workspace/didChangeWatchedFiles" => {
                self.files_changed(&params);
            }
            "workspace/didChangeConfiguration" => {
                self.client.set(params.get("settings").unwrap_or(&Json::Null));
                self.refresh();
            }
            "workspace/didChangeWorkspaceFolders" => self.folders_changed(&params),
            "$/cancelRequest" => self.cancelled(&params),
            _ => {}
        }
    }

    fn evaluate_dirty(&mut self) {
        if self.dirty.is_empty() {
            return;
        }
        let texts = self.open_texts();
        for uri in std::mem::take(&mut self.dirty) {
            let Some(open) = self.documents.get(&uri) else { continue };
            self.queue.want(EvaluationRequest {
                serial: open.serial,
                name: open.name().to_owned(),
                folder: open.folder(),
                text: Arc::from(open.text.as_str()),
                open: Arc::clone(&texts),
                uri,
            });
        }
    }

    fn finished(&mut self, done: Evaluated) {
        let Some(open) =
            self.documents.get_mut(&done.uri).filter(|open| open.serial == done.serial)
        else {
            return;
        };
        open.take(done.serial, done.report);
        let is_late = std::mem::take(&mut open.lacked_values);
        self.publish(&done.uri);
        self.answer_waiting(|waiting| waiting.uri == done.uri);
        if is_late {
            self.refresh();
        }
    }
}
