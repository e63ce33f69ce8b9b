//! Commands that lenses offer: a test is run, a definition is shown.

use std::{sync::Arc, time::Duration};

use crossbeam_channel::RecvTimeoutError;
use lsp_server::ErrorCode;
use serde_json::{Value as Json, json};

use super::{
    capabilities::{TEST, VIEW},
    documents::OpenDocument,
    paths,
    server::{RequestError, RequestResult, Server},
    viewer::StartedViewer,
};
use crate::{
    eval::TestFilter,
    session::{Event, TestReport, TestVerdict},
};

/// A test that runs for so long is stopped.
const PATIENCE: Duration = Duration::from_secs(10);

impl Server<'_> {
    pub(super) fn execute(&mut self, params: &Json) -> RequestResult {
        let argument = |idx: usize| {
            params.pointer(&format!("/arguments/{idx}")).and_then(Json::as_str).unwrap_or_default()
        };
        match params.get("command").and_then(Json::as_str).unwrap_or_default() {
            TEST => self.test(argument(0), argument(1)),
            VIEW => self.view(argument(0), argument(1)),
            other => Err(RequestError(
                ErrorCode::InvalidParams,
                format!("there is no command `{other}`"),
            )),
        }
    }

    /// Runs the test of a document that is called so, and says what it came to.
    fn test(&mut self, uri: &str, name: &str) -> RequestResult {
        let Some(open) = self.documents.get(uri) else { return Ok(Json::Null) };
        let files = self.files(open);
        // Somebody waits, and nothing else is answered meanwhile.
        let (ended, is_ended) = crossbeam_channel::bounded::<()>(0);
        let stop = self.stop.clone();
        let watch = std::thread::spawn(move || {
            if is_ended.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                stop.stop();
            }
        });
        let wanted = Some(TestFilter::Named(name));
        let report = self.session.test(open.name(), open.text.as_bytes(), &files, &[], wanted);
        drop(ended);
        let _ = watch.join();
        self.stop.reset();
        let report = Arc::new(report);
        let told = |test: &TestReport| json!({ "name": test.name, "verdict": test.verdict.word(), "reasons": reasons(test) });
        let tests: Vec<Json> = report.tests.iter().map(told).collect();
        let has_passed = report.tests.iter().all(|test| test.verdict == TestVerdict::Passed);
        let words = report.tests.iter().map(|test| {
            let all = [vec![test.verdict.word().to_owned()], reasons(test)].concat();
            format!("{}: {}", test.name, all.join("; "))
        });
        let words: Vec<String> = words.collect();
        let text =
            if words.is_empty() { format!("there is no test `{name}`") } else { words.join(", ") };
        let kind = if has_passed && !words.is_empty() { 3 } else { 1 };
        self.notify("window/showMessage", json!({ "type": kind, "message": text }));
        // What the test found is told with what the last run did.
        let open = self.documents.get_mut(uri);
        if let Some(values) = open.and_then(OpenDocument::values_mut) {
            values.take_tests(&report);
            self.publish(uri);
            self.refresh();
        }
        Ok(json!({ "passed": has_passed, "tests": tests }))
    }

    /// Shows a definition of a document, or all of it, in a viewer, which is started unless it runs.
    fn view(&mut self, uri: &str, definition: &str) -> RequestResult {
        let path = self.documents.get(uri).and_then(|open| open.path.clone());
        let Some(path) = path else {
            return Err(RequestError(
                ErrorCode::InvalidParams,
                "only a file can be shown: save it first".to_owned(),
            ));
        };
        let known = self
            .viewers
            .iter()
            .find(|viewer| viewer.path == path)
            .map(|viewer| viewer.address.clone());
        let address = match known {
            Some(address) => address,
            None => {
                let viewer = StartedViewer::start(path)
                    .map_err(|why| RequestError(ErrorCode::RequestFailed, why))?;
                let address = viewer.address.clone();
                self.viewers.push(viewer);
                address
            }
        };
        let address = match definition {
            "" => address,
            name => format!("{address}#definition={}", paths::escaped(name)),
        };
        if self.client.shows_documents {
            self.ask("window/showDocument", json!({ "uri": address, "external": true }));
        } else {
            self.notify("window/showMessage", json!({ "type": 3, "message": address }));
        }
        Ok(json!({ "address": address }))
    }
}

/// Why a test did not pass: its errors, the claims that do not hold, the errors that did not come.
fn reasons(test: &TestReport) -> Vec<String> {
    let failed = test.events.iter().filter_map(|event| match event {
        Event::Checked(checked) if !checked.verdict.holds => {
            Some(format!("`{}`: {}", checked.source, checked.verdict.figures()))
        }
        Event::Expected(expected) if !expected.holds() => {
            Some(format!("error {} was expected of `{}`", expected.code.id(), expected.source))
        }
        _ => None,
    });
    test.errors.iter().cloned().chain(failed).collect()
}
