//! Files that import one another: loaded before anything runs.
//!
//! Loading follows the imports of a file depth first, so that circles and missing files are told
//! with the chain that leads to them, and so that a file is lowered after those that it imports.

use std::{
    collections::BTreeMap,
    sync::{Arc, Mutex, OnceLock, PoisonError},
};

use super::{
    globals::Globals,
    imported::InstanceSlot,
    ir::Program,
    lower::{self, Imported, Lowered, Origin, ScriptCall},
    name_uses::NotedNames,
    settings::Settings,
};
use crate::{
    diag::{Code, Diagnostic, Result, Severity, Sources, Span},
    kernel::sorting::sort_by_key,
    limits::Ceiling,
    syntax::{
        self,
        ast::{Expr, ExprKind, StatementKind, Tree, Unit},
    },
    value::{missing_file, script_text},
};

/// A file that some import names.
#[derive(Debug)]
pub(super) struct LibraryFile {
    /// Its path as messages give it.
    pub(super) path: String,
    pub(super) program: Program,
    /// Its first mistake that was found without running it.
    pub(super) fault: Option<Box<Diagnostic>>,
    /// Whether its text has mistakes of form, so that names may mean something else than they would.
    pub(super) is_garbled: bool,
    /// The identity of its program, once somebody asked for it.
    pub(super) identity: OnceLock<u64>,
}

/// Every file that a script imports, directly or not.
#[derive(Debug)]
pub(crate) struct Library<'a> {
    pub(super) settings: Settings<'a>,
    /// The unit of the script; files that state none follow it.
    unit: Unit,
    pub(super) files: Vec<LibraryFile>,
    /// Each file, or why it cannot be had.
    by_path: BTreeMap<String, Result<usize>>,
    /// By the file and the exact key of its parameters.
    pub(super) instances: Mutex<BTreeMap<(usize, Vec<u8>), InstanceSlot>>,
    findings: Mutex<Vec<Diagnostic>>,
    /// What the names of the files mean.
    noted: NotedNames,
}

/// A text on its way in.
pub(crate) struct LoadedText<'t> {
    /// Its path, relative to the script's folder.
    pub(crate) path: &'t str,
    /// Its first byte in all sources.
    pub(crate) base: u32,
    /// Its tree.
    pub(crate) tree: &'t Tree<'t>,
}

impl<'a> Library<'a> {
    /// An empty library for a script in this unit.
    pub(crate) fn new(settings: Settings<'a>, unit: Unit) -> Self {
        Self {
            settings,
            unit,
            files: Vec::new(),
            by_path: BTreeMap::new(),
            instances: Mutex::default(),
            findings: Mutex::default(),
            noted: NotedNames::default(),
        }
    }

    /// Loads the files that a text imports; what each import's path stands for, by its first byte.
    pub(crate) fn load_imports(
        &mut self,
        importer: &LoadedText<'_>,
        chain: &mut Vec<String>,
        sources: &mut Sources,
    ) -> Vec<(u32, Option<Imported>)> {
        let mut found = Vec::new();
        let mut statements: Vec<_> = importer.tree.statements.iter().collect();
        // Imports in the bodies of tests count too.
        while let Some(statement) = statements.pop() {
            match &statement.kind {
                StatementKind::Test { body, .. } => statements.extend(body),
                StatementKind::Import(import) => {
                    let place = import.path.span.shifted(importer.base);
                    let imported = literal(&import.path).and_then(|path| {
                        let path = join(folder(importer.path), path);
                        let file = self.load(&path, place, chain, sources);
                        file.map_err(|finding| self.report(*finding)).ok()
                    });
                    let imported = imported.map(|file| self.imported(file));
                    found.push((import.path.span.start, imported));
                }
                _ => {}
            }
        }
        sort_by_key(&mut found, |(start, _)| *start);
        found
    }

    /// Loads the scripts that the calls of a lowered text name, and notes what is known of them.
    pub(crate) fn load_scripts(
        &mut self,
        path: &str,
        lowered: &mut Lowered,
        chain: &mut Vec<String>,
        sources: &mut Sources,
    ) {
        for ScriptCall { file, labels, name, is_expected } in std::mem::take(&mut lowered.scripts) {
            let path = join(folder(path), &file.path);
            let found = self.load(&path, file.place, chain, sources);
            match &found {
                Ok(found) => {
                    let imported = self.imported(*found);
                    let noted = &mut lowered.noted;
                    for whole in name.iter().chain([&file.place]) {
                        noted.parts.extend(imported.parts_of(*whole));
                    }
                    let given = labels.into_iter().map(|(label, at)| (file.place, label, at));
                    noted.part_uses.extend(given);
                    noted.imports.push((file.place, imported.path));
                }
                Err(finding) if !is_expected => self.report(finding.as_ref().clone()),
                Err(_) => {}
            }
            let _ = file.found.set(found);
        }
    }

    /// Loads one file, unless it is there already.
    ///
    /// # Errors
    /// Why it cannot be had.
    fn load(
        &mut self,
        path: &str,
        place: Span,
        chain: &mut Vec<String>,
        sources: &mut Sources,
    ) -> Result<usize> {
        if let Some(at) = chain.iter().position(|file| file == path) {
            let circle: Vec<String> =
                chain[at..].iter().chain([&chain[at]]).map(|file| format!("`{file}`")).collect();
            let message = format!("files import one another in a circle: {}", circle.join(" → "));
            return Diagnostic::error(Code::ImportCycle, place, message)
                .hint("move what both need into a third file")
                .fail();
        }
        if let Some(known) = self.by_path.get(path) {
            return known.clone();
        }
        let file = self.read(path, place, chain.len()).and_then(|text| {
            chain.push(path.to_owned());
            let file = self.add(path, &Arc::from(text), place, chain, sources);
            chain.pop();
            file
        });
        self.by_path.insert(path.to_owned(), file.clone());
        file
    }

    /// The text of a file.
    fn read(&self, path: &str, place: Span, n_nested: usize) -> Result<String> {
        let most = self.settings.limits.import_nesting;
        if most < n_nested {
            let message = format!("imports lie more than {most} deep inside one another");
            let found = Diagnostic::error(Code::TooLarge, place, message);
            return found.crossing(Ceiling::IMPORT_NESTING).fail();
        }
        let most = self.settings.limits.source_bytes;
        let bytes = self.settings.files.read(path, most).map_err(|message| {
            let remedy = "paths are relative to the file that names them";
            missing_file(self.settings.files, path, (place, message), remedy)
        })?;
        if most < bytes.len() {
            let message = format!("`{path}` is larger than the ceiling of {most} bytes");
            let hint = "numbers that a script needs are read by `load`";
            let found = Diagnostic::error(Code::SourceTooLarge, place, message).hint(hint);
            return found.crossing(Ceiling::SOURCE_BYTES).fail();
        }
        match script_text(&bytes) {
            Ok(text) => Ok(text.to_owned()),
            Err(what) => {
                Diagnostic::error(Code::NotUtf8, place, format!("`{path}`: {what}")).fail()
            }
        }
    }

    /// Parses and lowers a file, after those that it imports.
    fn add(
        &mut self,
        path: &str,
        text: &Arc<str>,
        place: Span,
        chain: &mut Vec<String>,
        sources: &mut Sources,
    ) -> Result<usize> {
        let base = sources.add(path, Arc::clone(text));
        let (tree, found) = syntax::parse(text, self.settings.limits);
        let found: Vec<Diagnostic> = found.into_iter().map(|found| found.shifted(base)).collect();
        let imports = self.load_imports(&LoadedText { path, base, tree: &tree }, chain, sources);
        let faults = lower::faults(&found);
        let origin = Origin { text, base, faults: &faults, imports: &imports, known: &[] };
        let mut lowered = lower::lower(&tree, origin, self.settings.registry, self.unit);
        if lowered.program.unit != self.unit {
            let (theirs, ours) = (lowered.program.unit.name(), self.unit.name());
            let message = format!("`{path}` is in {theirs}, the script in {ours}");
            return Diagnostic::error(Code::UnitMismatch, place, message)
                .hint("bare numbers would change their meaning: state the same `unit` in both")
                .fail();
        }
        self.load_scripts(path, &mut lowered, chain, sources);
        self.noted.append(lowered.noted);
        let mut findings = found;
        findings.extend(lowered.diagnostics);
        let is_error = |found: &&Diagnostic| found.severity == Severity::Error;
        let fault = findings.iter().find(is_error).cloned().map(Box::new);
        let is_garbled = !faults.is_empty();
        findings.into_iter().for_each(|finding| self.report(finding));
        let (path, program, identity) = (path.to_owned(), lowered.program, OnceLock::new());
        self.files.push(LibraryFile { path, program, fault, is_garbled, identity });
        Ok(self.files.len() - 1)
    }

    /// What an importer knows of a file.
    fn imported(&self, file: usize) -> Imported {
        let definitions = &self.files[file].program.definitions;
        let names = definitions
            .iter()
            .filter(|definition| definition.is_named())
            .map(|definition| (Arc::clone(&definition.name), definition.name_span))
            .collect();
        Imported { file, path: self.files[file].path.clone(), names }
    }

    pub(super) fn report(&self, finding: Diagnostic) {
        self.findings.lock().unwrap_or_else(PoisonError::into_inner).push(finding);
    }

    /// The homes of all files that were evaluated.
    pub(super) fn homes(&self) -> Vec<Arc<Globals>> {
        let instances = self.instances.lock().unwrap_or_else(PoisonError::into_inner);
        let evaluated = instances.values().filter_map(|slot| slot.1.get());
        evaluated.map(|instance| Arc::clone(&instance.home)).collect()
    }

    /// What the names of all files mean.
    pub(super) fn take_noted(&mut self) -> NotedNames {
        std::mem::take(&mut self.noted)
    }

    /// Everything that was found in imported files so far.
    pub(crate) fn take_findings(&self) -> Vec<Diagnostic> {
        std::mem::take(&mut *self.findings.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

/// The text of a plain string.
fn literal<'t>(expr: &'t Expr<'_>) -> Option<&'t str> {
    match &expr.kind {
        ExprKind::Text(text) => Some(text),
        _ => None,
    }
}

/// The folder of a path; empty for that of the script.
pub(super) fn folder(path: &str) -> &str {
    path.rsplit_once('/').map_or("", |(folder, _)| folder)
}

/// A path relative to a folder, in normal form as far as it goes.
pub(super) fn join(folder: &str, path: &str) -> String {
    if folder.is_empty() && !path.contains("./") {
        return path.to_owned();
    }
    let mut parts: Vec<&str> = Vec::new();
    let is_absolute = path.starts_with('/');
    let from = if is_absolute { "" } else { folder };
    for part in from.split('/').chain(path.split('/')) {
        match (part, parts.last()) {
            ("" | ".", _) => {}
            ("..", Some(&last)) if last != ".." => {
                parts.pop();
            }
            (part, _) => parts.push(part),
        }
    }
    let joined = parts.join("/");
    if is_absolute || from.starts_with('/') { format!("/{joined}") } else { joined }
}

#[cfg(test)]
mod tests {
    use super::{folder, join};

    #[test]
    fn paths_are_relative_to_the_file_that_names_them() {
        assert_eq!(join("", "a.geo"), "a.geo");
        assert_eq!(join("lib", "a.geo"), "lib/a.geo");
        assert_eq!(join("lib/deep", "../a.geo"), "lib/a.geo");
        assert_eq!(join("lib", "../../a.geo"), "../a.geo");
        assert_eq!(join("", "./a.geo"), "a.geo");
        assert_eq!(join("lib", "/a.geo"), "/a.geo");
        assert_eq!((folder("lib/a.geo"), folder("a.geo")), ("lib", ""));
    }
}
