//! What the server knows, and how it speaks to the client.

use std::{collections::BTreeMap, path::PathBuf, sync::Arc, time::Instant};

use crossbeam_channel::Receiver;
use lsp_server::{ErrorCode, Message, Notification, Request, RequestId, Response};
use serde::Serialize;
use serde_json::Value as Json;

use super::{
    SessionMaker, capabilities::Client, closer_look::CloserLooks, documents::OpenDocument,
    paths::OverlaidFiles, transport::Outgoing, viewer::StartedViewer, worker::EvaluationQueue,
};
use crate::{limits::work::StopToken, session::Session};

/// Why a request is not answered.
#[derive(Debug)]
pub(super) struct RequestError(pub(super) ErrorCode, pub(super) String);

/// The answer to a request.
pub(super) type RequestResult = Result<Json, RequestError>;

/// The same as it is written.
pub(super) type WrittenResult = Result<String, RequestError>;

/// A request that waits for the values of a document.
pub(super) struct WaitingRequest {
    pub(super) request: Request,
    /// The address of the document.
    pub(super) uri: String,
    /// When it is answered without them.
    pub(super) deadline: Instant,
}

/// What the server knows.
pub(super) struct Server<'a> {
    pub(super) receiver: &'a Receiver<Message>,
    tell: &'a dyn Fn(Outgoing),
    pub(super) queue: &'a EvaluationQueue,
    pub(super) client: Client,
    /// For questions.
    pub(super) session: Session,
    /// Its switch.
    pub(super) stop: StopToken,
    /// By address.
    pub(super) documents: BTreeMap<String, OpenDocument>,
    /// Documents that are to be evaluated as soon as no message waits.
    pub(super) dirty: Vec<String>,
    /// Requests that wait for the values of a document.
    pub(super) waiting: Vec<WaitingRequest>,
    /// Viewers that were started.
    pub(super) viewers: Vec<StartedViewer>,
    /// At geometry, for hovers.
    pub(super) looks: CloserLooks,
    next_id: i32,
    pub(super) is_shut: bool,
}

impl<'a> Server<'a> {
    pub(super) fn new(
        receiver: &'a Receiver<Message>,
        tell: &'a dyn Fn(Outgoing),
        queue: &'a EvaluationQueue,
        session: SessionMaker<'_>,
        client: Client,
    ) -> Self {
        let stop = StopToken::default();
        Self {
            receiver,
            tell,
            queue,
            client,
            session: session(stop.clone()),
            stop,
            documents: BTreeMap::new(),
            dirty: Vec::new(),
            waiting: Vec::new(),
            viewers: Vec::new(),
            looks: CloserLooks::default(),
            next_id: 0,
            is_shut: false,
        }
    }

    pub(super) fn notify(&self, method: &str, params: impl Serialize) {
        let told = Notification::new(method.to_owned(), params);
        (self.tell)(Outgoing::Message(told.into()));
    }

    pub(super) fn ask(&mut self, method: &str, params: impl Serialize) {
        self.next_id += 1;
        let request = Request::new(RequestId::from(self.next_id), method.to_owned(), params);
        (self.tell)(Outgoing::Message(request.into()));
    }

    pub(super) fn reply(&self, id: RequestId, answer: WrittenResult) {
        (self.tell)(match answer {
            Ok(result) => Outgoing::Answer(id, result),
            Err(RequestError(code, message)) => {
                Outgoing::Message(Response::new_err(id, code as i32, message).into())
            }
        });
    }

    /// The texts of all open documents.
    pub(super) fn open_texts(&self) -> Arc<BTreeMap<PathBuf, Arc<str>>> {
        let texts = self
            .documents
            .values()
            .filter_map(|open| Some((open.path.clone()?, Arc::from(open.text.as_str()))));
        Arc::new(texts.collect())
    }

    /// The files beside a document.
    pub(super) fn files(&self, open: &OpenDocument) -> OverlaidFiles {
        OverlaidFiles::new(&open.folder(), &self.open_texts())
    }

    /// What is shown between the lines may be wanted anew.
    pub(super) fn refresh(&mut self) {
        if self.client.refreshes_hints {
            self.ask("workspace/inlayHint/refresh", Json::Null);
        }
        if self.client.refreshes_lenses {
            self.ask("workspace/codeLens/refresh", Json::Null);
        }
    }
}
