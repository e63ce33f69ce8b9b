//! What could stand at a place: names with their kinds, labels, words, fields, files, commands.

use std::{fs, path::PathBuf};

use crate::{
    syntax::{CompletionPlace, KEYWORDS, ast::Unit, place},
    value::{Op, OpParameter, Registry, Value, field_names},
};

use super::{command::COMMANDS, show};

/// What the prompt knows of its document.
#[derive(Clone, Debug, Default)]
pub(super) struct Scope {
    /// Its definitions.
    pub(super) names: Vec<KnownDefinition>,
    /// The folder that its files lie in.
    pub(super) folder: PathBuf,
}

/// A definition.
#[derive(Clone, Debug)]
pub(super) struct KnownDefinition {
    pub(super) name: String,
    /// Kind and size, or the value.
    pub(super) what: String,
    /// What may stand after a dot.
    pub(super) fields: Vec<String>,
}

impl KnownDefinition {
    pub(super) fn of(name: &str, value: &Value, unit: Unit) -> Self {
        let fields = field_names(value).into_iter().map(str::to_owned).collect();
        let what = show::cut(&show::line(name, value, unit)[name.len()..], 60);
        let what = what.trim_start_matches([' ', '=', ':']).to_owned();
        Self { name: name.to_owned(), what, fields }
    }
}

/// Something that could stand at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Candidate {
    /// What is inserted.
    pub(super) text: String,
    /// What it is.
    pub(super) what: String,
}

impl Candidate {
    fn new(text: impl Into<String>, what: impl Into<String>) -> Self {
        Self { text: text.into(), what: what.into() }
    }
}

/// Where the completed part of `line` begins, and what could stand there.
pub(super) fn candidates(
    line: &str,
    scope: &Scope,
    registry: &Registry,
) -> (usize, Vec<Candidate>) {
    let indent = line.len() - line.trim_start().len();
    if line[indent..].starts_with(':') {
        return command(line, indent, scope, registry);
    }
    let (start, mut found) = in_expression(line, scope, registry);
    let begun = line[start..].to_owned();
    found.retain(|candidate| candidate.text.starts_with(&begun));
    found.sort_by(|a, b| a.text.cmp(&b.text));
    found.dedup_by(|b, a| a.text == b.text);
    (start, found)
}

/// A command, or what may stand behind it.
fn command(
    line: &str,
    indent: usize,
    scope: &Scope,
    registry: &Registry,
) -> (usize, Vec<Candidate>) {
    let Some(blank) = line.find(char::is_whitespace).filter(|&at| at > indent) else {
        let begun = &line[indent + 1..];
        let fitting = COMMANDS.iter().filter(|command| command.name.starts_with(begun));
        let found = fitting.map(|command| Candidate::new(command.name, command.docs)).collect();
        return (indent + 1, found);
    };
    let takes_file =
        COMMANDS.iter().any(|known| known.takes_file && line[indent + 1..blank] == *known.name);
    let rest = blank + (line.len() - blank) - line[blank..].trim_start().len();
    if takes_file {
        let found = files(&line[rest..], scope);
        let folder = line[rest..].rfind('/').map_or(rest, |slash| rest + slash + 1);
        return (folder, found);
    }
    let (start, found) = candidates(&line[rest..], scope, registry);
    (rest + start, found)
}

fn in_expression(line: &str, scope: &Scope, registry: &Registry) -> (usize, Vec<Candidate>) {
    match place(line) {
        CompletionPlace::Comment => (line.len(), Vec::new()),
        CompletionPlace::Field { start, of } => {
            let known = scope.names.iter().find(|known| known.name == of);
            let fields = known.map(|known| known.fields.as_slice()).unwrap_or_default();
            (start, fields.iter().map(|field| Candidate::new(field, "field")).collect())
        }
        CompletionPlace::Text { start, call, label, .. } => {
            let words = call
                .zip(label)
                .and_then(|(call, label)| parameter(registry, call, label))
                .map(|param| param.ty.words())
                .unwrap_or_default();
            if words.is_empty() {
                let begun = &line[start..];
                let folder = begun.rfind('/').map_or(start, |slash| start + slash + 1);
                return (folder, files(begun, scope));
            }
            (start, words.into_iter().map(|word| Candidate::new(word, "word")).collect())
        }
        CompletionPlace::Name { start, call } => {
            let mut found: Vec<Candidate> =
                scope.names.iter().map(|known| Candidate::new(&known.name, &known.what)).collect();
            let labels = call.map(|call| ops(registry, call)).unwrap_or_default();
            found.extend(labels.iter().flat_map(|op| op.params).map(|param| {
                Candidate::new(format!("{} = ", param.name), format!("label: {}", param.ty))
            }));
            found.extend(registry.names().map(|name| built_in(registry, name)));
            found.extend(KEYWORDS.iter().map(|word| Candidate::new(*word, "keyword")));
            (start, found)
        }
    }
}

fn built_in(registry: &Registry, name: &str) -> Candidate {
    let what = match (registry.get(name), registry.constant(name)) {
        (Some((_, ops)), _) => ops.first().map(|op| op.signature()).unwrap_or_default(),
        (None, Some(constant)) => constant.docs.to_owned(),
        (None, None) => String::new(),
    };
    Candidate::new(name, what)
}

fn ops<'r>(registry: &'r Registry, name: &str) -> Vec<&'r Op> {
    registry.get(name).map(|(_, ops)| ops.iter().copied().collect()).unwrap_or_default()
}

fn parameter(registry: &Registry, call: &str, label: &str) -> Option<&'static OpParameter> {
    let (_, ops) = registry.get(call)?;
    ops.iter().flat_map(|op| op.params).find(|param| param.name == label)
}

/// The files and folders whose path begins with `begun`.
fn files(begun: &str, scope: &Scope) -> Vec<Candidate> {
    let (folder, stem) = begun.rsplit_once('/').unwrap_or(("", begun));
    let root = if begun.starts_with('/') { PathBuf::from("/") } else { scope.folder.clone() };
    let Ok(entries) = fs::read_dir(root.join(folder.trim_start_matches('/'))) else {
        return Vec::new();
    };
    let mut found: Vec<Candidate> = entries
        .flatten()
        .filter_map(|entry| {
            let name = entry.file_name().into_string().ok()?;
            let is_fitting = name.starts_with(stem) && !(name.starts_with('.') && stem.is_empty());
            if !is_fitting {
                return None;
            }
            let data = entry.metadata().ok()?;
            Some(if data.is_dir() {
                Candidate::new(name + "/", "folder")
            } else {
                let ending = name.rsplit_once('.').map_or("file", |(_, ending)| ending);
                let what = format!("{ending}, {} bytes", data.len());
                Candidate::new(&name, what)
            })
        })
        .collect();
    found.sort_by(|a, b| a.text.cmp(&b.text));
    found
}

#[cfg(test)]
mod tests {
    use super::{KnownDefinition, Scope, candidates};
    use crate::{ops, value::Value};

    #[track_caller]
    fn check(line: &str, start: usize, expected: &[&str]) {
        let names = vec![KnownDefinition::of(
            "benchmark",
            &Value::Point(glam::DVec3::ZERO),
            crate::syntax::ast::Unit::Mm,
        )];
        let scope = Scope { names, ..Scope::default() };
        let (at, found) = candidates(line, &scope, &ops::registry());
        let texts: Vec<&str> = found.iter().map(|candidate| candidate.text.as_str()).collect();
        assert_eq!((at, texts.as_slice()), (start, expected), "{line}");
    }

    #[test]
    fn names_labels_words_fields_and_commands_are_completed() {
        check("let a = benc", 8, &["benchmark"]);
        check("benchmark.", 10, &["x", "y", "z"]);
        check(
            "circle((0, 0), 1, norm",
            18,
            &["norm", "normal", "normal = ", "normal_curvature", "normal_line", "normal_plane"],
        );
        check("interpolate(p, ends = \"be", 23, &["bessel"]);
        check(":lo", 1, &["load"]);
        check(":show benc", 6, &["benchmark"]);
        check("// benc", 7, &[]);
    }
}
