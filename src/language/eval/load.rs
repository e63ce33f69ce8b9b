//! A script with what it imports, names resolved, before anything of it is evaluated.

use std::sync::Arc;

use super::{
    env::Env,
    ir::Program,
    library::{Library, LoadedText},
    lower,
    name_uses::NotedNames,
    settings::Settings,
};
use crate::{
    diag::{Diagnostic, Sources, Span},
    syntax::{
        self,
        ast::{StatementKind, Tree, Unit},
    },
};

/// A script, ready to run.
pub(super) struct LoadedScript<'a> {
    pub(super) document: LoadingScript<'a>,
    pub(super) unit: Unit,
    /// What it imports.
    pub(super) library: Library<'a>,
    pub(super) program: Program,
    /// The texts of all of that.
    sources: Sources,
    /// What its own names mean.
    pub(super) noted: NotedNames,
    /// What is wrong so far.
    pub(super) diagnostics: Vec<Diagnostic>,
}

/// Loads the script `text`, which messages call `name`; it and the files that it imports are added
/// to `sources`.
pub(super) fn load<'a>(
    name: &str,
    text: &'a str,
    sources: &mut Sources,
    settings: Settings<'a>,
) -> LoadedScript<'a> {
    let base = sources.add(name, Arc::from(text));
    let (tree, found) = syntax::parse(text, settings.limits);
    let mut diagnostics: Vec<Diagnostic> =
        found.into_iter().map(|found| found.shifted(base)).collect();
    let unit = stated_unit(&tree);
    let mut library = Library::new(settings, unit);
    let file = name.rsplit('/').next().unwrap_or(name);
    let importer = LoadedText { path: file, base, tree: &tree };
    let chain = &mut vec![file.to_owned()];
    let imports = library.load_imports(&importer, chain, sources);
    let faults = lower::faults(&diagnostics);
    let origin =
        lower::Origin { text, base, faults: &faults, imports: &imports, known: settings.known };
    let mut lowered = lower::lower(&tree, origin, settings.registry, unit);
    library.load_scripts(file, &mut lowered, chain, sources);
    diagnostics.extend(lowered.diagnostics);
    let document = LoadingScript::new(text, base);
    let (program, sources) = (lowered.program, sources.clone());
    LoadedScript { document, unit, library, program, sources, noted: lowered.noted, diagnostics }
}

/// The unit that a script states; millimetres where it states none.
fn stated_unit(tree: &Tree<'_>) -> Unit {
    let stated = tree.statements.iter().find_map(|statement| match &statement.kind {
        StatementKind::Unit(name) => Unit::from_name(name.text),
        _ => None,
    });
    stated.filter(|unit| unit.millimetres().is_some()).unwrap_or(Unit::Mm)
}

impl LoadedScript<'_> {
    /// What evaluation looks things up in.
    pub(super) fn env<'e>(&'e self, settings: Settings<'e>) -> Env<'e> {
        Env {
            limits: settings.limits,
            n_threads: settings.n_threads,
            files: settings.files,
            tolerance: self.program.tolerance,
            unit: self.program.unit,
            registry: Some(settings.registry),
            library: Some(&self.library),
            sources: Some(&self.sources),
            gauge: settings.gauge,
            stop: settings.stop,
        }
    }
}

/// A script on its way into evaluation.
#[derive(Clone, Debug)]
pub(super) struct LoadingScript<'a> {
    /// Its text.
    text: &'a str,
    /// The first byte of its text in all sources.
    base: u32,
    /// The bytes at which its lines end.
    line_ends: Vec<u32>,
}

impl<'a> LoadingScript<'a> {
    fn new(text: &'a str, base: u32) -> Self {
        let ends = text.bytes().zip(0..).filter(|&(byte, _)| byte == b'\n');
        Self { text, base, line_ends: ends.map(|(_, at)| at).collect() }
    }

    /// The text at a place, white space folded to single spaces.
    pub(super) fn excerpt(&self, span: Span) -> String {
        let start = (span.start.saturating_sub(self.base)) as usize;
        let end = (span.end.saturating_sub(self.base)) as usize;
        let text = self.text.get(start..end).unwrap_or_default();
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// Whether a place is in its text, and not in that of what it imports.
    pub(super) fn holds(&self, span: Span) -> bool {
        (self.base..=self.base + self.text.len() as u32).contains(&span.start)
    }

    /// The line of a place, from 1.
    pub(super) fn line(&self, span: Span) -> usize {
        let start = span.start.saturating_sub(self.base);
        1 + self.line_ends.partition_point(|&end| end < start)
    }
}
