//! What the documents for contributors name is there: every path and every identifier in backticks.

use std::{
    collections::HashSet,
    fs,
    path::{Path, PathBuf},
};

const DOCUMENTS: &[&str] = &["ARCHITECTURE.md", "CONTRIBUTING.md"];

/// Where a path may begin.
const ROOTS: &[&str] =
    &["", "src/", "src/kernel/", "src/kernel/curve/", "src/language/", "tests/", "python/", "web/"];

/// Folders with sources.
const SOURCES: &[&str] = &["src", "tests", "examples", "benches", "python", "web"];

/// What is not kept in the repository: what tools make.
const MADE: &[&str] = &["node_modules", "dist", "target", "pkg"];

/// Files that a walk makes, or that stand for any.
const EXAMPLES: &[&str] = &["chord.rs", "a-weight-of-zero.geo"];

/// Words behind which a name is declared.
const DECLARING: &[&str] = &[
    "struct",
    "enum",
    "trait",
    "type",
    "fn",
    "mod",
    "const",
    "static",
    "macro_rules!",
    "class",
    "def",
    "function",
];

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for path in entries.flatten().map(|entry| entry.path()) {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() {
            if !MADE.contains(&name.as_str()) && !name.starts_with('.') {
                collect(&path, files);
            }
        } else if [".rs", ".py", ".ts", ".mjs"].iter().any(|ending| name.ends_with(ending)) {
            files.push(path);
        }
    }
}

fn is_part_of_name(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

/// The names that a source declares: of items, and of the fields and variants that begin a line.
fn declared(text: &str, names: &mut HashSet<String>) {
    for line in text.lines() {
        let mut before = "";
        for word in line.split_whitespace() {
            if DECLARING.contains(&before) {
                names.insert(word.chars().take_while(|&c| is_part_of_name(c)).collect());
            }
            before = word;
        }
        let line = line.trim_start();
        let line = line.strip_prefix("pub(crate) ").or(line.strip_prefix("pub ")).unwrap_or(line);
        let name: String = line.chars().take_while(|&c| is_part_of_name(c)).collect();
        if line[name.len()..].trim_start().starts_with([':', '(', ',', '{', '=']) {
            names.insert(name);
        }
    }
}

/// Every text in backticks outside of blocks of code, with its line.
fn quoted(document: &str) -> Vec<(usize, String)> {
    let text = fs::read_to_string(document).expect("the document");
    let mut is_code = false;
    let mut found = Vec::new();
    for (number, line) in text.lines().enumerate() {
        if line.trim_start().starts_with("```") {
            is_code = !is_code;
        } else if !is_code {
            let parts = line.split('`').skip(1).step_by(2);
            found.extend(parts.map(|part| (number + 1, part.to_owned())));
        }
    }
    found
}

fn is_path(text: &str) -> bool {
    let is_plain = |c: char| is_part_of_name(c) || "./-".contains(c);
    let endings = [".rs", ".md", ".py", ".toml", ".json", ".geo", ".mjs", ".ts"];
    let is_file = endings.iter().any(|ending| text.ends_with(ending) && text != *ending);
    text.chars().all(is_plain)
        && !text.starts_with(['/', '-', '.'])
        && (text.contains('/') || is_file)
}

/// Capitals stand for any name.
fn is_placeholder(text: &str) -> bool {
    let is_capital = |part: &str| 1 < part.len() && part.chars().all(|c| c.is_ascii_uppercase());
    text.split(['/', '.']).any(|part| {
        is_capital(part)
            && !matches!(part, "ARCHITECTURE" | "CONTRIBUTING" | "CHANGELOG" | "README")
    })
}

fn is_there(path: &str, files: &[PathBuf]) -> bool {
    let path = path.trim_end_matches('/');
    let known = |root: &&str| {
        Path::new(&format!("{root}{path}")).exists()
            || Path::new(&format!("{root}{path}.rs")).exists()
    };
    ROOTS.iter().any(known) || files.iter().any(|file| file.ends_with(path))
}

/// The names of a path such as `Type::function()`; none of a text that is no such path, or one plain word, which may be
/// a word of the language.
fn segments(text: &str) -> Option<Vec<&str>> {
    let bare = text.strip_suffix("()");
    let names: Vec<&str> = bare.unwrap_or(text).split("::").collect();
    let is_name = |name: &&str| {
        name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
            && name.chars().all(is_part_of_name)
    };
    let is_mixed = |name: &str| {
        name.contains('_')
            || name.starts_with(|c: char| c.is_ascii_uppercase())
                && name.contains(|c: char| c.is_ascii_lowercase())
    };
    let is_code = 1 < names.len() || bare.is_some() || is_mixed(names[0]);
    (is_code && names.iter().all(is_name)).then_some(names)
}

#[test]
fn documents_name_what_is_there() {
    let mut files = Vec::new();
    SOURCES.iter().for_each(|folder| collect(Path::new(folder), &mut files));
    let mut names = HashSet::new();
    for file in &files {
        declared(&fs::read_to_string(file).expect("a source"), &mut names);
        let parts = file.iter().map(|part| part.to_string_lossy().into_owned());
        names.extend(parts.map(|part| part.split('.').next().unwrap_or_default().to_owned()));
    }
    let mut complaints = Vec::new();
    for document in DOCUMENTS {
        for (line, text) in quoted(document) {
            let is_example = EXAMPLES.iter().any(|example| text.ends_with(example));
            if is_example || is_placeholder(&text) {
                continue;
            }
            if is_path(&text) {
                if !is_there(&text, &files) {
                    complaints.push(format!("{document}:{line}: there is no `{text}`"));
                }
            } else if let Some(missing) =
                segments(&text).and_then(|all| all.into_iter().find(|name| !names.contains(*name)))
            {
                complaints
                    .push(format!("{document}:{line}: nothing is called `{missing}` in `{text}`"));
            }
        }
    }
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}

#[test]
fn names_and_paths_are_understood() {
    assert_eq!(segments("Value::extent"), Some(vec!["Value", "extent"]));
    assert_eq!(segments("main()"), Some(vec!["main"]));
    assert_eq!(segments("export"), None);
    assert!(is_path("src/lib.rs") && is_path("construction/") && !is_path("a or b"));
    let mut names = HashSet::new();
    declared("pub struct Held<T> {\n    pub value: T,\n    fn ask(&self) {}", &mut names);
    assert!(["Held", "value", "ask"].iter().all(|name| names.contains(*name)));
    assert!(!names.contains("Extent"));
}
