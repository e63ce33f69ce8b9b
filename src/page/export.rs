//! Files that the page asks for: those of the script, or one of chosen definitions.

use std::{ops::Deref, sync::Arc};

use serde_json::Value as Json;

use crate::{
    diag::Diagnostic,
    session::{Event, File, Report, Session},
};

/// A file of the script, or one that was made for the page.
#[derive(Debug)]
pub(crate) enum WantedFile<'r> {
    OfScript(&'r File),
    Chosen(Box<File>),
}

impl Deref for WantedFile<'_> {
    type Target = File;

    fn deref(&self) -> &File {
        match self {
            Self::OfScript(file) => file,
            Self::Chosen(file) => file,
        }
    }
}

/// The files that a request is for.
///
/// # Errors
/// A sentence where there is none, or where the request says something else.
pub(crate) fn wanted<'r>(
    body: &Json,
    report: &'r Arc<Report>,
    session: &Session,
) -> Result<Vec<WantedFile<'r>>, String> {
    match (body["what"].as_str(), body["items"].as_array(), body["file"].as_str()) {
        (Some("script"), None, None) => {
            let files = report.events.iter().filter_map(|event| match event {
                Event::File(file) => Some(WantedFile::OfScript(file)),
                _ => None,
            });
            let files: Vec<WantedFile<'_>> = files.collect();
            let none = || "the script exports nothing".to_owned();
            (!files.is_empty()).then_some(files).ok_or_else(none)
        }
        (None, Some(names), Some(path)) => {
            Ok(vec![WantedFile::Chosen(chosen(names, path, report, session)?)])
        }
        _ => Err("say `what`: \"script\", or `items` and `file`".to_owned()),
    }
}

/// A file of the definitions with these names.
fn chosen(
    names: &[Json],
    path: &str,
    report: &Report,
    session: &Session,
) -> Result<Box<File>, String> {
    let name = |name: &Json| name.as_str().map(str::to_owned);
    let names: Option<Vec<String>> = names.iter().map(name).collect();
    let names = names.filter(|names| !names.is_empty());
    let names = names.ok_or("`items` must be a list of names of definitions")?;
    let first = |found: Vec<Diagnostic>| {
        let found = found.into_iter().next();
        found.map_or_else(|| "nothing to export".to_owned(), |found| found.message)
    };
    session.file_of(report, &names, path).map_err(first)
}
