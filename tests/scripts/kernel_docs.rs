//! The kernel's documentation: what it shows to others has an example in its docs, which is a test.

use std::{fs, path::Path};

/// Types that need no example of their own, each with the reason.
const WITHOUT: &[(&str, &str)] =
    &[("PathLeg", "a name for a pair"), ("PlacedAxes", "a name for a pair")];

/// The types that `lib.rs` hands on: names in its `pub use` that begin with a capital.
fn handed_on() -> Vec<String> {
    let text = fs::read_to_string("src/kernel/lib.rs").expect("the kernel's root");
    let lists = text.split("\npub use ").skip(1).filter_map(|rest| rest.split(';').next());
    let names = lists.flat_map(|list| list.split(|c: char| !c.is_alphanumeric() && c != '_'));
    let is_type = |name: &&str| name.starts_with(|c: char| c.is_uppercase());
    names.filter(is_type).map(str::to_owned).collect()
}

/// What a line declares for everybody, if it is a type.
fn declared(line: &str) -> Option<&str> {
    let rest = ["pub struct ", "pub enum ", "pub trait ", "pub type "]
        .iter()
        .find_map(|start| line.strip_prefix(start))?;
    rest.split(|c: char| !c.is_alphanumeric() && c != '_').next()
}

/// Public types of a file, each with whether its docs have an example.
fn types_of(text: &str) -> Vec<(String, bool)> {
    let mut found = Vec::new();
    let mut has_example = false;
    for line in text.lines() {
        if line.starts_with("/// ```") {
            has_example = true;
        } else if let Some(name) = declared(line) {
            found.push((name.to_owned(), has_example));
            has_example = false;
        } else if line.is_empty() || line.starts_with('}') {
            has_example = false;
        }
    }
    found
}

/// All public types of a folder, with the file of each.
fn types_in(folder: &Path, found: &mut Vec<(String, String, bool)>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            types_in(&path, found);
        } else if path.extension().is_some_and(|ext| ext == "rs") {
            let text = fs::read_to_string(&path).expect("UTF-8");
            let file = path.to_string_lossy().into_owned();
            found.extend(types_of(&text).into_iter().map(|(name, has)| (name, file.clone(), has)));
        }
    }
}

#[test]
fn every_type_of_the_kernel_has_an_example() {
    let mut all = Vec::new();
    types_in(Path::new("src/kernel"), &mut all);
    let names = handed_on();
    assert!(names.len() > 100, "the list was read");
    let of_work = all.iter().filter(|(_, file, _)| file.ends_with("kernel/work.rs"));
    let shown = all.iter().filter(|(name, ..)| names.contains(name)).chain(of_work);
    let excused = |name: &str| WITHOUT.iter().any(|&(own, _)| own == name);
    let mut missing: Vec<String> = shown
        .filter(|(name, _, has_example)| !has_example && !excused(name))
        .map(|(name, file, _)| format!("{file}: `{name}` has no example in its docs"))
        .collect();
    let known = |name: &&String| all.iter().any(|(own, ..)| own == *name);
    missing
        .extend(names.iter().filter(|name| !known(name)).map(|name| format!("{name} is where?")));
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

#[test]
fn examples_are_seen() {
    let text = "/// A box.\n///\n/// ```\n/// ```\n#[derive(Debug)]\npub struct Box;\n\npub enum Bare {}\n";
    assert_eq!(types_of(text), [("Box".to_owned(), true), ("Bare".to_owned(), false)]);
}
