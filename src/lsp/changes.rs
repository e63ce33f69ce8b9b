//! What the client tells of: documents that open, change and close, files that change, requests that are
//! called off.

use std::path::PathBuf;

use lsp_server::{ErrorCode, RequestId};
use serde::de::DeserializeOwned;
use serde_json::{Value as Json, json};

use super::{
    documents::OpenDocument,
    paths,
    server::{RequestError, Server, WaitingRequest},
};
use crate::diag::Code;

impl Server<'_> {
    pub(super) fn opened(&mut self, params: Json) {
        let Some(params) = read::<lsp_types::DidOpenTextDocumentParams>(params) else { return };
        let document = params.text_document;
        let uri = document.uri.as_str().to_owned();
        let mut open = OpenDocument::new(uri.clone(), document.text, document.version);
        if let Some(before) = self.documents.remove(&uri) {
            // Opened twice: what it said before is in vain.
            (open.serial, open.told) = (before.serial + 1, before.told);
        }
        self.documents.insert(uri.clone(), open);
        self.renewed(&uri);
    }

    pub(super) fn changed(&mut self, params: Json) {
        let Some(params) = read::<lsp_types::DidChangeTextDocumentParams>(params) else { return };
        let uri = params.text_document.uri.as_str().to_owned();
        let unit = self.client.unit;
        let Some(open) = self.documents.get_mut(&uri) else { return };
        if params.text_document.version < open.version {
            // A text that is not there any more, or an edit of it, would spoil this one.
            let message = format!(
                "{uri}: version {} came after version {}",
                params.text_document.version, open.version
            );
            return self.notify("window/logMessage", json!({ "type": 2, "message": message }));
        }
        open.version = params.text_document.version;
        open.change(&params.content_changes, unit);
        self.renewed(&uri);
    }

    pub(super) fn closed(&mut self, params: &Json) {
        let Some(uri) = params.pointer("/textDocument/uri").and_then(Json::as_str) else { return };
        let Some(open) = self.documents.remove(uri) else { return };
        self.dirty.retain(|dirty| dirty != uri);
        self.queue.close(uri);
        self.refuse_waiting(uri);
        for told in open.told {
            self.notify(
                "textDocument/publishDiagnostics",
                json!({ "uri": told, "diagnostics": [] }),
            );
        }
        // Others read the file again.
        self.renew_others(uri, open.path.as_ref());
    }

    /// A document has another text.
    fn renewed(&mut self, uri: &str) {
        self.dirty(uri);
        let path = self.documents.get(uri).and_then(|open| open.path.clone());
        self.renew_others(uri, path.as_ref());
    }

    /// What uses a file means something else now, and what missed one may have found it.
    fn renew_others(&mut self, uri: &str, path: Option<&PathBuf>) {
        let uses = |open: &OpenDocument| match open.last_values() {
            Some(values) => {
                let report = values.report();
                let mut sources = report.sources.iter().skip(1);
                let folder = open.folder();
                sources.any(|source| Some(&paths::normal(&folder.join(&source.name))) == path)
                    || report.diagnostics.iter().any(|found| found.code == Code::FileMissing)
            }
            None => true,
        };
        let others = self.documents.values_mut().filter(|open| open.uri != uri && uses(open));
        let others: Vec<String> = others
            .map(|open| {
                open.renew();
                open.uri.clone()
            })
            .collect();
        others.iter().for_each(|other| self.dirty(other));
    }

    /// Files are others now.
    pub(super) fn files_changed(&mut self, params: &Json) {
        let uri = |json: &Json| json.get("uri").and_then(Json::as_str).map(str::to_owned);
        let saved = params.get("textDocument").and_then(uri);
        let changed = params.get("changes").and_then(Json::as_array);
        let all: Vec<String> = changed.into_iter().flatten().filter_map(uri).chain(saved).collect();
        // What stands in the editor counts, not what was saved of it.
        if all.iter().all(|uri| self.documents.contains_key(uri)) {
            return;
        }
        let uris: Vec<String> = self.documents.keys().cloned().collect();
        for uri in uris {
            if let Some(open) = self.documents.get_mut(&uri) {
                open.renew();
            }
            self.dirty(&uri);
        }
    }

    pub(super) fn folders_changed(&mut self, params: &Json) {
        let paths = |name: &str| -> Vec<PathBuf> {
            let folders = params.pointer(&format!("/event/{name}")).and_then(Json::as_array);
            let uris =
                folders.into_iter().flatten().filter_map(|folder| folder.get("uri")?.as_str());
            uris.filter_map(paths::path_of).collect()
        };
        let removed = paths("removed");
        self.client.roots.retain(|root| !removed.contains(root));
        self.client.roots.extend(paths("added"));
    }

    pub(super) fn cancelled(&mut self, params: &Json) {
        let Some(id) =
            params.get("id").and_then(|id| serde_json::from_value::<RequestId>(id.clone()).ok())
        else {
            return;
        };
        if let Some(idx) = self.waiting.iter().position(|waiting| waiting.request.id == id) {
            let WaitingRequest { request, .. } = self.waiting.remove(idx);
            let refusal = RequestError(ErrorCode::RequestCanceled, "cancelled".to_owned());
            self.reply(request.id, Err(refusal));
        }
    }

    fn dirty(&mut self, uri: &str) {
        self.queue.edited(uri);
        self.refuse_waiting(uri);
        if !self.dirty.iter().any(|dirty| dirty == uri) {
            self.dirty.push(uri.to_owned());
        }
    }

    /// What waits for values of a text that is another one now.
    fn refuse_waiting(&mut self, uri: &str) {
        let (gone, left): (Vec<_>, Vec<_>) =
            std::mem::take(&mut self.waiting).into_iter().partition(|waiting| waiting.uri == uri);
        self.waiting = left;
        for WaitingRequest { request, .. } in gone {
            let refusal = RequestError(ErrorCode::ContentModified, "the text changed".to_owned());
            self.reply(request.id, Err(refusal));
        }
    }
}

/// Parameters as their type; none where they are something else.
fn read<T: DeserializeOwned>(params: Json) -> Option<T> {
    serde_json::from_value(params).ok()
}
