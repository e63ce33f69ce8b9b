//! The parameters of the files that a script imports, with what it gives them.

use std::collections::BTreeMap;

use serde_json::{Value as Json, json};

use super::parameters::{allowed_text, written};
use crate::{
    eval::{RelativeFiles, Schema},
    session::Session,
    syntax::ast::{ExprKind, Import, StatementKind, Tree},
    value::Files,
};

/// An import as it stands in the script.
struct StatedImport {
    path: String,
    line: usize,
    /// Names of parameters with the texts and lines of what they are given.
    given: Vec<(String, String, usize)>,
}

/// Every import of a file with parameters: `path`, `line`, and its `parameters`.
pub(super) fn json(session: &Session, bytes: &[u8], files: &dyn Files) -> Json {
    let Ok(text) = std::str::from_utf8(bytes) else { return json!([]) };
    let mut known: BTreeMap<String, Option<Schema>> = BTreeMap::new();
    let imports = session.tree(text, |tree, _| stated(tree, text));
    let imports = imports.iter().filter_map(|import| {
        let schema = known
            .entry(import.path.clone())
            .or_insert_with_key(|path| schema_of(path, session, files))
            .as_ref()
            .filter(|schema| !schema.parameters.is_empty())?;
        Some(one(import, schema))
    });
    imports.collect()
}

fn schema_of(path: &str, session: &Session, files: &dyn Files) -> Option<Schema> {
    let bytes = files.read(path, session.limits().source_bytes).ok()?;
    session.known_parameters(path, &bytes, &RelativeFiles::beside(files, path))
}

fn stated(tree: &Tree<'_>, text: &str) -> Vec<StatedImport> {
    let breaks: Vec<usize> = text.match_indices('\n').map(|(at, _)| at).collect();
    let line = |start: u32| 1 + breaks.partition_point(|&at| at < start as usize);
    let import = |import: &Import<'_>| {
        let ExprKind::Text(path) = &import.path.kind else { return None };
        let given = import.with.iter().filter_map(|arg| {
            let name = arg.name?;
            let value = text.get(arg.value.span.range())?;
            Some((name.text.to_owned(), value.to_owned(), line(name.span.start)))
        });
        let (given, line) = (given.collect(), line(import.path.span.start));
        Some(StatedImport { path: path.clone(), line, given })
    };
    let statements = tree.statements.iter().map(|statement| &statement.kind);
    let imports = statements.filter_map(|kind| match kind {
        StatementKind::Import(its) => import(its),
        _ => None,
    });
    imports.collect()
}

fn one(import: &StatedImport, schema: &Schema) -> Json {
    let unit = schema.unit.name();
    let parameters = schema.parameters.iter().map(|parameter| {
        let given = import.given.iter().find(|(name, ..)| *name == parameter.name);
        json!({
            "name": parameter.name,
            "label": parameter.label,
            "docs": parameter.docs,
            "default": written(&parameter.default, unit),
            "allowed": allowed_text(parameter, unit),
            "given": given.map(|(_, text, _)| text),
            "line": given.map(|(.., line)| line),
        })
    });
    json!({
        "path": import.path,
        "line": import.line,
        "parameters": parameters.collect::<Vec<_>>(),
    })
}
