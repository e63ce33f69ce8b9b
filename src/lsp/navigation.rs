//! Requests about names: in the document, in what it imports, and in scripts of the workspace that import it or
//! ask it by `script`.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
    str::FromStr,
    sync::Arc,
};

use lsp_types::{
    CallHierarchyIncomingCall, CallHierarchyIncomingCallsParams, CallHierarchyItem,
    CallHierarchyOutgoingCall, CallHierarchyOutgoingCallsParams, CallHierarchyPrepareParams,
    DocumentHighlight, DocumentHighlightKind, DocumentHighlightParams, DocumentSymbol,
    DocumentSymbolParams, GotoDefinitionParams, Location, ReferenceParams, SymbolInformation, Uri,
    WorkspaceSymbolParams,
};

use super::{
    convert::{self, TextPlaces},
    documents::OpenDocument,
    paths::{self, OverlaidFiles},
    server::Server,
};
use crate::ide::{self, Document, LineIndex, NameRole, Occurrence, Outline, Symbol};

/// The largest script of a workspace that is looked through, in bytes.
const MOST_BYTES: usize = 1 << 20;

/// The built-in that names a script.
pub(super) const SCRIPT: &str = "script";

/// A place in a file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct FoundName {
    pub(super) path: PathBuf,
    pub(super) start: usize,
    pub(super) end: usize,
}

impl Server<'_> {
    /// The address and the text of a file: that of the editor where it is open.
    pub(super) fn text_of(&self, path: &Path) -> Option<(Uri, Arc<str>)> {
        // What is no file is known by its address, as `found` has it.
        let is_it = |open: &&OpenDocument| match &open.path {
            Some(own) => own == path,
            None => Path::new(&open.uri) == path,
        };
        let open = self.documents.values().find(is_it);
        match open {
            Some(open) => Some((Uri::from_str(&open.uri).ok()?, Arc::from(open.text.as_str()))),
            None => {
                let text = String::from_utf8(fs::read(path).ok()?).ok()?;
                Some((Uri::from_str(&paths::uri_of(path)).ok()?, Arc::from(text)))
            }
        }
    }

    /// The place of a name as the client counts.
    fn location(&self, found: &FoundName) -> Option<Location> {
        let (uri, text) = self.text_of(&found.path)?;
        let lines = LineIndex::new(&text);
        let places = TextPlaces { text: &text, lines: &lines, unit: self.client.unit };
        Some(Location::new(uri, places.range(&(found.start..found.end))))
    }

    /// A place of a document's names as a place of a file.
    fn found(&self, open: &OpenDocument, one: &Occurrence) -> FoundName {
        let own = open.path.clone().unwrap_or_else(|| PathBuf::from(&open.uri));
        let path = match &one.file {
            None => own,
            Some(file) => paths::normal(&open.folder().join(file)),
        };
        FoundName { path, start: one.start, end: one.end }
    }

    /// Scripts of the workspace and open documents, with their texts, that may use what the file at
    /// `path` calls `name`; apart from them those that are too large to be looked through.
    pub(super) fn importers(
        &self,
        path: &Path,
        name: &str,
    ) -> (Vec<(PathBuf, Arc<str>)>, Vec<PathBuf>) {
        let stem = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        let mut found: BTreeMap<PathBuf, Arc<str>> = BTreeMap::new();
        let open = self
            .documents
            .values()
            .filter_map(|open| Some((open.path.clone()?, Arc::from(open.text.as_str()))));
        found.extend(open);
        for script in paths::scripts(&self.client.roots) {
            if !found.contains_key(&script)
                && let Some((_, text)) = self.text_of(&script)
            {
                found.insert(script, text);
            }
        }
        found.retain(|script, text| {
            let names_files = text.contains("import") || text.contains(SCRIPT);
            script != path && names_files && text.contains(stem) && text.contains(name)
        });
        let (small, large): (Vec<_>, Vec<_>) =
            found.into_iter().partition(|(_, text)| text.len() <= MOST_BYTES);
        (small, large.into_iter().map(|(script, _)| script).collect())
    }

    /// A script of the workspace, looked at.
    pub(super) fn looked_at(&self, path: &Path, text: &str) -> (Document, PathBuf) {
        let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
        let texts = self
            .documents
            .values()
            .filter_map(|open| Some((open.path.clone()?, Arc::from(open.text.as_str()))));
        let files = OverlaidFiles::new(&folder, &Arc::new(texts.collect()));
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        (Document::new(&self.session, name, text, &files), folder)
    }

    /// Every place of the name at a byte of an open document, in all files that can be seen, the
    /// definition first.
    pub(super) fn everywhere(
        &self,
        open: &OpenDocument,
        document: &Document,
        at: usize,
    ) -> Vec<FoundName> {
        let Some(definition) = document.definition(at) else { return Vec::new() };
        let definition = self.found(open, &definition);
        let own = document.references(at);
        let mut found: Vec<FoundName> = own.iter().map(|one| self.found(open, one)).collect();
        let Some((_, text)) = self.text_of(&definition.path) else { return found };
        let name = text.get(definition.start..definition.end).unwrap_or_default();
        let is_shown = !name.starts_with('_');
        let (importers, _) = self.importers(&definition.path, name);
        for (path, text) in importers.into_iter().filter(|_| is_shown) {
            let (script, folder) = self.looked_at(&path, &text);
            let imports = script.imports();
            let files = imports.iter().map(|(_, file)| *file);
            let mut files =
                files.filter(|file| paths::normal(&folder.join(file)) == definition.path);
            let Some(file) = files.next() else { continue };
            for one in script.references_of(file, &(definition.start..definition.end)) {
                let at = match &one.file {
                    None => path.clone(),
                    Some(file) => paths::normal(&folder.join(file)),
                };
                found.push(FoundName { path: at, start: one.start, end: one.end });
            }
        }
        found.sort();
        found.dedup();
        found.retain(|one| *one != definition);
        found.insert(0, definition);
        found
    }

    pub(super) fn definition(&self, params: &GotoDefinitionParams) -> Option<Location> {
        let at = &params.text_document_position_params;
        let (open, document, places) = self.open(&at.text_document.uri)?;
        let byte = places.offset(at.position);
        if let Some(found) = document.definition(byte) {
            return self.location(&self.found(open, &found));
        }
        // The path of an import leads to its file.
        let imports = document.imports();
        let (_, file) =
            imports.iter().find(|(range, _)| range.start <= byte && byte <= range.end)?;
        self.location(&FoundName {
            path: paths::normal(&open.folder().join(file)),
            start: 0,
            end: 0,
        })
    }

    pub(super) fn references(&self, params: &ReferenceParams) -> Option<Vec<Location>> {
        let at = &params.text_document_position;
        let (open, document, places) = self.open(&at.text_document.uri)?;
        let found = self.everywhere(open, document, places.offset(at.position));
        let skipped = usize::from(!params.context.include_declaration);
        Some(found.iter().skip(skipped).filter_map(|one| self.location(one)).collect())
    }

    pub(super) fn highlights(
        &self,
        params: &DocumentHighlightParams,
    ) -> Option<Vec<DocumentHighlight>> {
        let at = &params.text_document_position_params;
        let (_, document, places) = self.open(&at.text_document.uri)?;
        let highlight = |range: &std::ops::Range<usize>| {
            let is_written = document.outline().defined_at(range).is_some();
            let kind =
                if is_written { DocumentHighlightKind::WRITE } else { DocumentHighlightKind::READ };
            DocumentHighlight { range: places.range(range), kind: Some(kind) }
        };
        Some(document.highlights(places.offset(at.position)).iter().map(highlight).collect())
    }

    pub(super) fn symbols(&self, params: &DocumentSymbolParams) -> Option<Vec<DocumentSymbol>> {
        let (_, document, places) = self.open(&params.text_document.uri)?;
        Some(document.symbols().iter().map(|one| symbol(one, &places)).collect())
    }

    pub(super) fn workspace_symbols(
        &self,
        params: &WorkspaceSymbolParams,
    ) -> Option<Vec<SymbolInformation>> {
        /// Symbols that are told at once.
        const MOST: usize = 500;
        let query = params.query.to_lowercase();
        let open = self.documents.values().filter_map(|open| open.path.clone());
        let mut scripts = paths::scripts(&self.client.roots);
        scripts.extend(open);
        scripts.sort();
        scripts.dedup();
        let mut found = Vec::new();
        for path in scripts {
            let Some((uri, text)) =
                self.text_of(&path).filter(|(_, text)| text.to_lowercase().contains(&query))
            else {
                continue;
            };
            let lines = LineIndex::new(&text);
            let places = TextPlaces { text: &text, lines: &lines, unit: self.client.unit };
            let outline = Outline::of(&self.session, &text);
            let names = outline.of_file().filter(|name| {
                name.role != NameRole::Import && name.name.to_lowercase().contains(&query)
            });
            for name in names {
                #[expect(deprecated, reason = "a field that must be given")]
                found.push(SymbolInformation {
                    name: name.name.clone(),
                    kind: convert::symbol_kind(Some(name.role)),
                    tags: None,
                    deprecated: None,
                    location: Location::new(uri.clone(), places.range(&name.place)),
                    container_name: None,
                });
            }
            if MOST <= found.len() {
                break;
            }
        }
        Some(found)
    }

    pub(super) fn prepare_calls(
        &self,
        params: &CallHierarchyPrepareParams,
    ) -> Option<Vec<CallHierarchyItem>> {
        let at = &params.text_document_position_params;
        let (_, document, places) = self.open(&at.text_document.uri)?;
        let definition =
            document.definition(places.offset(at.position)).filter(|found| found.file.is_none())?;
        let name = document.outline().defined_at(&definition.range())?;
        Some(vec![call_item(name, &at.text_document.uri, &places)])
    }

    pub(super) fn incoming_calls(
        &self,
        params: &CallHierarchyIncomingCallsParams,
    ) -> Option<Vec<CallHierarchyIncomingCall>> {
        let (_, document, places) = self.open(&params.item.uri)?;
        let uses = document.highlights(places.offset(params.item.selection_range.start));
        let around = |name: &&ide::DefinedName| uses.iter().any(|place| is_used_in(place, name));
        let calls =
            document.outline().of_file().filter(around).map(|name| CallHierarchyIncomingCall {
                from: call_item(name, &params.item.uri, &places),
                from_ranges: uses
                    .iter()
                    .filter(|place| is_used_in(place, name))
                    .map(|place| places.range(place))
                    .collect(),
            });
        Some(calls.collect())
    }

    pub(super) fn outgoing_calls(
        &self,
        params: &CallHierarchyOutgoingCallsParams,
    ) -> Option<Vec<CallHierarchyOutgoingCall>> {
        let (_, document, places) = self.open(&params.item.uri)?;
        let at = places.offset(params.item.selection_range.start);
        let whole = document.outline().names.iter().find(|name| name.place.start == at)?;
        let mut found: Vec<CallHierarchyOutgoingCall> = Vec::new();
        for name in document.outline().of_file() {
            let uses = document.highlights(name.place.start);
            let ranges: Vec<_> = uses
                .iter()
                .filter(|place| is_used_in(place, whole))
                .map(|place| places.range(place))
                .collect();
            if !ranges.is_empty() {
                found.push(CallHierarchyOutgoingCall {
                    to: call_item(name, &params.item.uri, &places),
                    from_ranges: ranges,
                });
            }
        }
        Some(found)
    }
}

/// Whether a place is a use of something inside of a definition.
fn is_used_in(place: &std::ops::Range<usize>, name: &ide::DefinedName) -> bool {
    name.whole.start <= place.start && place.end <= name.whole.end && *place != name.place
}

fn call_item(name: &ide::DefinedName, uri: &Uri, places: &TextPlaces<'_>) -> CallHierarchyItem {
    CallHierarchyItem {
        name: name.name.clone(),
        kind: convert::symbol_kind(Some(name.role)),
        tags: None,
        detail: None,
        uri: uri.clone(),
        range: places.range(&name.whole),
        selection_range: places.range(&name.place),
        data: None,
    }
}

fn symbol(one: &Symbol, places: &TextPlaces<'_>) -> DocumentSymbol {
    let children: Vec<_> = one.children.iter().map(|child| symbol(child, places)).collect();
    #[expect(deprecated, reason = "a field that must be given")]
    DocumentSymbol {
        name: if one.name.is_empty() { "test".to_owned() } else { one.name.clone() },
        detail: Some(one.detail.clone()),
        kind: convert::symbol_kind(one.role),
        tags: None,
        deprecated: None,
        range: places.range(&one.whole),
        selection_range: places.range(&one.place),
        children: (!children.is_empty()).then_some(children),
    }
}
