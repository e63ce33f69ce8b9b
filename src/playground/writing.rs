//! What the editor of the page asks while a script is written. Places are lines and columns from 0, in
//! the units of JavaScript's texts.

use std::{ops::Range, sync::Arc};

use serde_json::{Value as Json, json};

use super::Playground;
use crate::{
    diag::Severity,
    docs,
    ide::{
        self, ColumnUnit, Completion, Document, Finding, FolderEntry, LineColumn, LineIndex,
        SemanticToken, TextEdit, Values,
    },
    page::Answer,
};

const UNIT: ColumnUnit = ColumnUnit::Utf16;

/// A text in which places are told.
struct Places<'a> {
    text: &'a str,
    lines: &'a LineIndex,
}

impl<'a> Places<'a> {
    fn of(document: &'a Document) -> Self {
        Self { text: document.text(), lines: document.lines() }
    }

    /// The byte that a request names.
    fn asked(&self, body: &Json) -> Result<usize, String> {
        let number = |name: &str| {
            let number = body[name].as_u64().and_then(|number| usize::try_from(number).ok());
            number.ok_or_else(|| format!("`{name}` must be a whole number"))
        };
        let place = LineColumn { line: number("line")?, column: number("column")? };
        Ok(self.lines.offset(self.text, place, UNIT))
    }

    fn place(&self, at: usize) -> Json {
        let LineColumn { line, column } = self.lines.position(self.text, at, UNIT);
        json!({ "line": line, "column": column })
    }

    fn range(&self, range: &Range<usize>) -> Json {
        json!({ "from": self.place(range.start), "to": self.place(range.end) })
    }

    fn edits(&self, edits: &[TextEdit]) -> Json {
        let edit = |edit: &TextEdit| json!({ "range": self.range(&edit.range), "text": edit.text });
        edits.iter().map(edit).collect()
    }
}

impl Playground {
    /// The answer to a call of the editor.
    pub(super) fn writing(&mut self, call: &str, body: &Json) -> Answer {
        // Put back below: while it is looked at nothing else may change.
        let document = self.document.take().unwrap_or_else(|| self.look());
        let answer = match call {
            "complete" => self.complete(&document, body),
            // What a completion's built-in does: all of these pages are most of a list.
            "page" => self.page(body),
            "hover" => self.hover(&document, body),
            "signature" => self.signature(&document, body),
            "definition" => definition(&document, body),
            "tokens" => Ok(self.tokens(&document)),
            "format" => Ok(self.format()),
            "findings" => Ok(self.findings()),
            _ => Err(format!("there is no call `{call}`")),
        };
        self.document = Some(document);
        answer
    }

    /// The text with its names.
    fn look(&self) -> Document {
        Document::new(&self.session, &self.name, &self.text, &self.files)
    }

    /// The files of a folder.
    fn entries(&self, folder: &str) -> Vec<FolderEntry> {
        let folder = folder.trim_start_matches("./").trim_end_matches('/');
        let below = |name: &String| {
            let rest = name.strip_prefix(folder)?;
            let rest = if folder.is_empty() { rest } else { rest.strip_prefix('/')? };
            (!rest.contains('/')).then(|| FolderEntry { name: rest.to_owned(), is_folder: false })
        };
        self.file_names.iter().filter_map(below).collect()
    }

    /// What the last run came to.
    fn values(&self) -> Option<Values> {
        self.model.last.as_ref().map(|last| Values::new(Arc::clone(last)))
    }

    fn complete(&self, document: &Document, body: &Json) -> Answer {
        let places = Places::of(document);
        let at = places.asked(body)?;
        // Files of the script's own folder; there are few folders in a page.
        let list = |folder: &str| self.entries(folder);
        let found = document.completions(&self.session, self.values().as_ref(), &list, at);
        let completion = |its: &Completion| {
            json!({
                "label": its.label,
                "detail": its.detail,
                "docs": its.docs,
                "kind": format!("{:?}", its.kind).to_lowercase(),
                "range": places.range(&its.range),
                "insert": its.insert,
                "snippet": its.snippet,
                "fits": its.is_fitting,
            })
        };
        Ok(found.iter().map(completion).collect())
    }

    fn page(&self, body: &Json) -> Answer {
        let name = body["name"].as_str().unwrap_or_default();
        Ok(json!(docs::markdown(self.session.registry(), name)))
    }

    fn hover(&self, document: &Document, body: &Json) -> Answer {
        let places = Places::of(document);
        let at = places.asked(body)?;
        let values = self.values();
        let Some((mut text, range)) = document.hover(&self.session, values.as_ref(), at) else {
            return Ok(Json::Null);
        };
        let value = values
            .as_ref()
            .and_then(|values| Some((values, document.shown_geometry(&self.session, values, at)?)));
        let measures = value.map(|(values, value)| values.measures(value)).unwrap_or_default();
        if !measures.is_empty() {
            text.push_str(&format!("\n\n{measures}"));
        }
        Ok(json!({ "text": text, "range": places.range(&range) }))
    }

    fn signature(&self, document: &Document, body: &Json) -> Answer {
        let places = Places::of(document);
        let at = places.asked(body)?;
        let signatures = document.signatures(&self.session, self.values().as_ref(), at);
        let signature = |its: &ide::CalledSignature| {
            let parameter =
                |its: &ide::SignatureParameter| json!({ "label": its.label, "docs": its.docs });
            json!({
                "label": its.label,
                "docs": its.docs,
                "parameters": its.parameters.iter().map(parameter).collect::<Vec<_>>(),
                "active": its.active,
            })
        };
        Ok(signatures.iter().map(signature).collect())
    }

    /// The words of the text: where each begins and ends, what it is, and whether it is defined there or
    /// built in.
    fn tokens(&self, document: &Document) -> Json {
        let places = Places::of(document);
        let token = |its: &SemanticToken| {
            json!({
                "range": places.range(&its.range),
                "kind": format!("{:?}", its.kind).to_lowercase(),
                "isDeclaration": its.is_declaration,
                "isBuiltIn": its.is_built_in,
            })
        };
        document.tokens(self.session.registry()).iter().map(token).collect()
    }

    /// The edits that bring the text into canonical form.
    fn format(&self) -> Json {
        let lines = LineIndex::new(&self.text);
        let places = Places { text: &self.text, lines: &lines };
        places.edits(&ide::formatted(&self.session, &self.text))
    }

    /// What the last run found in the script itself, with the edits that would mend it.
    fn findings(&self) -> Json {
        let Some(report) = &self.model.last else { return json!([]) };
        let Some(source) = report.sources.iter().next() else { return json!([]) };
        let lines = LineIndex::new(&source.text);
        let places = Places { text: &source.text, lines: &lines };
        let finding = |found| {
            let finding = Finding::of(&report.sources, found);
            let fixes = ide::fixes(&report.sources, found).into_iter();
            let fixes = fixes
                .map(|(title, edits)| json!({ "title": title, "edits": places.edits(&edits) }));
            (finding.place.source == 0).then(|| {
                json!({
                    "severity": match found.severity {
                        Severity::Error => "error",
                        Severity::Failure | Severity::Warning => "warning",
                    },
                    "code": found.code.id(),
                    "text": finding.sentences(),
                    "range": places.range(&finding.place.range),
                    "fixes": fixes.collect::<Vec<_>>(),
                })
            })
        };
        report.diagnostics.iter().filter_map(finding).collect()
    }
}

/// Where the name at a place is defined, if that is in the script itself.
fn definition(document: &Document, body: &Json) -> Answer {
    let places = Places::of(document);
    let found = document.definition(places.asked(body)?);
    // Imported files are not open in the editor.
    let own = found.filter(|found| found.file.is_none());
    Ok(own.map_or(Json::Null, |found| places.range(&found.range())))
}
