//! Names get another one, in all scripts of the workspace that use them.

use std::{
    collections::{BTreeMap, BTreeSet, HashMap},
    path::{Path, PathBuf},
    sync::Arc,
};

use lsp_server::ErrorCode;
use lsp_types::{RenameParams, TextDocumentPositionParams, TextEdit, Uri, WorkspaceEdit};
use serde_json::{Value as Json, json};

use super::{
    convert::TextPlaces,
    navigation::{FoundName, SCRIPT},
    paths::{self, OverlaidFiles},
    server::{RequestError, RequestResult, Server},
};
use crate::ide::{self, LineIndex, Outline};

impl Server<'_> {
    pub(super) fn prepare_rename(&self, params: &TextDocumentPositionParams) -> RequestResult {
        let refused = |why: String| RequestError(ErrorCode::RequestFailed, why);
        let Some((_, document, places)) = self.open(&params.text_document.uri) else {
            return Ok(Json::Null);
        };
        let at = places.offset(params.position);
        match document.renamable(at) {
            Ok(place) => Ok(json!(places.range(&place))),
            Err(why) if document.definition(at).is_some() => Err(refused(why)),
            Err(_) => Ok(Json::Null),
        }
    }

    pub(super) fn rename(&self, params: &RenameParams) -> RequestResult {
        let refused = |why: String| RequestError(ErrorCode::RequestFailed, why);
        let at = &params.text_document_position;
        let (open, document, places) = self
            .open(&at.text_document.uri)
            .ok_or_else(|| refused("the document is not open".to_owned()))?;
        let byte = places.offset(at.position);
        let files = self.files(open);
        let mut by_path: BTreeMap<PathBuf, Vec<ide::TextEdit>> = BTreeMap::new();
        let mut add = |folder: &Path, own: &Path, rename: ide::Rename| {
            for (file, edits) in rename {
                let path = file.map_or(own.to_path_buf(), |file| paths::normal(&folder.join(file)));
                let all = by_path.entry(path).or_default();
                edits.into_iter().for_each(|edit| {
                    if !all.contains(&edit) {
                        all.push(edit);
                    }
                });
            }
        };
        let own = open.path.clone().unwrap_or_else(|| PathBuf::from(&open.uri));
        add(
            &open.folder(),
            &own,
            document.rename(&self.session, &files, byte, &params.new_name).map_err(refused)?,
        );
        // Each script that uses the file has to mean the same afterwards, too.
        let everywhere = self.everywhere(open, document, byte);
        if let Some(definition) = everywhere.first() {
            self.check_unseen(definition, &everywhere).map_err(refused)?;
        }
        let others: BTreeSet<&PathBuf> =
            everywhere.iter().map(|one| &one.path).filter(|path| **path != own).collect();
        for path in others {
            let Some((_, text)) = self.text_of(path) else { continue };
            let (script, folder) = self.looked_at(path, &text);
            let Some(one) = everywhere.iter().find(|one| one.path == *path) else { continue };
            let texts = self
                .documents
                .values()
                .filter_map(|open| Some((open.path.clone()?, Arc::from(open.text.as_str()))));
            let files = OverlaidFiles::new(&folder, &Arc::new(texts.collect()));
            let rename = script
                .rename(&self.session, &files, one.start, &params.new_name)
                .map_err(|why| refused(format!("{}: {why}", path.display())))?;
            add(&folder, path, rename);
        }
        serde_json::to_value(self.workspace_edit(
            by_path,
            &own,
            (&at.text_document.uri, &open.text),
        ))
        .map_err(|err| RequestError(ErrorCode::InternalError, err.to_string()))
    }

    /// Edits by path, of which one is that of the document with this address and text, as the client has
    /// them.
    fn workspace_edit(
        &self,
        by_path: BTreeMap<PathBuf, Vec<ide::TextEdit>>,
        own: &Path,
        (own_uri, own_text): (&Uri, &str),
    ) -> WorkspaceEdit {
        #[expect(clippy::mutable_key_type, reason = "the type of the protocol's crate")]
        let mut changes: HashMap<Uri, Vec<TextEdit>> = HashMap::new();
        for (path, edits) in by_path {
            let known = if path == own {
                Some((own_uri.clone(), Arc::from(own_text)))
            } else {
                self.text_of(&path)
            };
            let Some((uri, text)) = known else { continue };
            let lines = LineIndex::new(&text);
            let places = TextPlaces { text: &text, lines: &lines, unit: self.client.unit };
            changes.insert(uri, places.edits(&edits));
        }
        WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() }
    }

    /// Refuses where scripts may use a name beside the places that were found.
    fn check_unseen(&self, definition: &FoundName, found: &[FoundName]) -> Result<(), String> {
        let Some((_, text)) = self.text_of(&definition.path) else { return Ok(()) };
        let name = text.get(definition.start..definition.end).unwrap_or_default();
        let outline = Outline::of(&self.session, &text);
        let is_shown = outline
            .defined_at(&(definition.start..definition.end))
            .is_some_and(|known| known.is_of_file && !known.name.starts_with('_'));
        if !is_shown {
            return Ok(());
        }
        let (importers, large) = self.importers(&definition.path, name);
        if let Some(script) = large.first() {
            return Err(format!(
                "{} may use the name, and is too large to be looked through",
                script.display()
            ));
        }
        for (path, text) in importers.iter().filter(|(_, text)| text.contains(SCRIPT)) {
            let (script, folder) = self.looked_at(path, text);
            let is_of_file = |file: &str| paths::normal(&folder.join(file)) == definition.path;
            let unseen = script.unseen(name, is_of_file).into_iter().find(|place| {
                !found.iter().any(|one| one.path == *path && one.start == place.start)
            });
            if let Some(place) = unseen {
                let lines = LineIndex::new(text);
                let line = lines.position(text, place.start, ide::ColumnUnit::Utf8).line + 1;
                return Err(format!(
                    "{}:{line}: `{name}` may be this one: it is asked of what came from the file by other ways",
                    path.display()
                ));
            }
        }
        Ok(())
    }
}
