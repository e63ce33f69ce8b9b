//! Findings as the client shows them: of a run, or of a text alone while its run takes long.

use std::{collections::BTreeMap, path::Path, str::FromStr};

use lsp_types::{
    CodeAction, CodeActionKind, CodeActionOrCommand, CodeActionParams,
    DiagnosticRelatedInformation, Location, NumberOrString, TextEdit, Uri, WorkspaceEdit,
};
use serde_json::json;

use super::{
    convert::{self, TextPlaces},
    documents::OpenDocument,
    paths,
    server::Server,
};
use crate::{
    diag::{Diagnostic, Sources},
    ide::{self, ColumnUnit, Finding, LineIndex, SourceRange},
    limits::MOST_FINDINGS,
};

/// The texts of a run with their addresses.
struct Addressed<'a> {
    sources: &'a Sources,
    uris: Vec<String>,
    lines: Vec<LineIndex>,
    unit: ColumnUnit,
}

impl<'a> Addressed<'a> {
    fn of(open: &OpenDocument, sources: &'a Sources, unit: ColumnUnit) -> Self {
        let folder = open.folder();
        let uri = |(idx, name): (usize, &str)| match idx {
            0 => open.uri.clone(),
            _ => paths::uri_of(&paths::normal(&folder.join(Path::new(name)))),
        };
        let uris = sources.iter().map(|source| source.name.as_str()).enumerate().map(uri).collect();
        let lines = sources.iter().map(|source| LineIndex::new(&source.text)).collect();
        Self { sources, uris, lines, unit }
    }

    fn range(&self, place: &SourceRange) -> lsp_types::Range {
        let (Some(source), Some(lines)) =
            (self.sources.iter().nth(place.source), self.lines.get(place.source))
        else {
            return lsp_types::Range::default();
        };
        TextPlaces { text: &source.text, lines, unit: self.unit }.range(&place.range)
    }

    fn location(&self, place: &SourceRange) -> Option<Location> {
        let uri = Uri::from_str(self.uris.get(place.source)?).ok()?;
        Some(Location::new(uri, self.range(place)))
    }

    fn lsp_diagnostic(&self, found: &Finding<'_>) -> lsp_types::Diagnostic {
        let related = found.others.iter().filter_map(|(place, text)| {
            let message = if text.is_empty() { "here" } else { text };
            Some(DiagnosticRelatedInformation {
                location: self.location(place)?,
                message: message.to_owned(),
            })
        });
        lsp_types::Diagnostic {
            range: self.range(&found.place),
            severity: Some(convert::severity(found.diagnostic.severity)),
            code: Some(NumberOrString::String(found.diagnostic.code.id().to_owned())),
            source: Some("virote".to_owned()),
            message: found.sentences(),
            related_information: Some(related.collect()),
            ..lsp_types::Diagnostic::default()
        }
    }
}

impl Server<'_> {
    /// Tells what the last run of a document found.
    pub(super) fn publish(&mut self, uri: &str) {
        let Some(open) = self.documents.get(uri) else { return };
        let Some(values) = open.values() else { return };
        let report = std::sync::Arc::clone(values.report());
        let found: Vec<Diagnostic> = values.findings().into_iter().cloned().collect();
        self.publish_all(uri, &report.sources, &found);
    }

    /// Tells what is wrong with the text of a document, before its values are known.
    pub(super) fn publish_early(&mut self, uri: &str) {
        let Some(open) = self.documents.get(uri) else { return };
        let files = self.files(open);
        let (uses, sources) = self.session.name_uses(open.name(), open.text.as_bytes(), &files);
        if let Some(open) = self.documents.get_mut(uri) {
            open.is_told_early = true;
        }
        self.publish_all(uri, &sources, &uses.diagnostics);
    }

    fn publish_all(&mut self, uri: &str, sources: &Sources, found: &[Diagnostic]) {
        let unit = self.client.unit;
        let Some(open) = self.documents.get_mut(uri) else { return };
        let addressed = Addressed::of(open, sources, unit);
        let mut by_file: BTreeMap<String, Vec<lsp_types::Diagnostic>> = BTreeMap::new();
        by_file.entry(uri.to_owned()).or_default();
        for (n_before, diagnostic) in found.iter().enumerate() {
            let finding = Finding::of(sources, diagnostic);
            let Some(file) = addressed.uris.get(finding.place.source) else { continue };
            let mut told = addressed.lsp_diagnostic(&finding);
            let n_left = found.len() - n_before;
            if n_before == MOST_FINDINGS && 1 < n_left {
                told.message = format!("{n_left} more findings from here on");
            }
            by_file.entry(file.clone()).or_default().push(told);
            if n_before == MOST_FINDINGS {
                break;
            }
        }
        let before = std::mem::replace(&mut open.told, by_file.keys().cloned().collect());
        let version = open.version;
        for file in before {
            by_file.entry(file).or_default();
        }
        for (file, diagnostics) in by_file {
            // An imported file that is open tells of itself.
            if file == uri {
                self.notify(
                    "textDocument/publishDiagnostics",
                    json!({ "uri": file, "version": version, "diagnostics": diagnostics }),
                );
            } else if !self.documents.contains_key(&file) {
                self.notify(
                    "textDocument/publishDiagnostics",
                    json!({ "uri": file, "diagnostics": diagnostics }),
                );
            }
        }
    }

    /// The hints at a place that are edits.
    pub(super) fn code_actions(
        &self,
        params: &CodeActionParams,
    ) -> Option<Vec<CodeActionOrCommand>> {
        let open = self.documents.get(params.text_document.uri.as_str())?;
        let wanted = params.context.only.as_ref();
        if wanted.is_some_and(|only| !only.iter().any(|kind| "quickfix".starts_with(kind.as_str())))
        {
            return Some(Vec::new());
        }
        let early;
        let (sources, diagnostics) = match open.values() {
            Some(values) => (&values.report().sources, values.findings()),
            // While the run takes long, what is wrong with the text alone.
            None => {
                let text = open.text.as_bytes();
                early = self.session.name_uses(open.name(), text, &self.files(open));
                (&early.1, early.0.diagnostics.iter().collect())
            }
        };
        let places = open.places(self.client.unit);
        let at = places.bytes(&params.range);
        let addressed = Addressed::of(open, sources, self.client.unit);
        let mut actions = Vec::new();
        for diagnostic in diagnostics {
            let finding = Finding::of(sources, diagnostic);
            let SourceRange { source, range } = &finding.place;
            if *source != 0 || at.end < range.start || range.end < at.start {
                continue;
            }
            for (idx, (title, edits)) in ide::fixes(sources, diagnostic).into_iter().enumerate() {
                let edits: Vec<TextEdit> = places.edits(&edits);
                #[expect(clippy::mutable_key_type, reason = "the type of the protocol's crate")]
                let changes =
                    std::collections::HashMap::from([(params.text_document.uri.clone(), edits)]);
                actions.push(CodeActionOrCommand::CodeAction(CodeAction {
                    title: title.to_owned(),
                    kind: Some(CodeActionKind::QUICKFIX),
                    diagnostics: Some(vec![addressed.lsp_diagnostic(&finding)]),
                    edit: Some(WorkspaceEdit {
                        changes: Some(changes),
                        ..WorkspaceEdit::default()
                    }),
                    is_preferred: Some(idx == 0),
                    ..CodeAction::default()
                }));
            }
        }
        Some(actions)
    }
}
