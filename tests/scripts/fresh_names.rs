//! Every name of every example takes a fresh one, and the program still means the same.

use std::{fs, path::Path};

use virote::{
    disk::ScriptFiles,
    ide::{self, Document},
    session::{Event, Session},
};

/// Begins every fresh name.
const FRESH: &str = "zq_";

/// A text in which each definition that can be renamed is, and how many there are.
fn renamed(session: &Session, text: &str, files: &ScriptFiles) -> (String, usize) {
    let (mut text, mut n_renamed) = (text.to_owned(), 0);
    loop {
        let document = Document::new(session, "main.geo", &text, files);
        let names = document.outline().names.iter();
        let next = names
            .filter(|name| !name.name.contains(FRESH) && name.name != "_")
            .find(|name| document.renamable(name.place.start).is_ok());
        let Some(name) = next else { return (text, n_renamed) };
        let fresh = format!("{FRESH}{}{n_renamed}", name.name.trim_start_matches('_'));
        let found = document.rename(session, files, name.place.start, &fresh);
        let edits = found.unwrap_or_else(|why| unreachable!("{}: {why}\n{text}", name.name));
        n_renamed += 1;
        text = ide::applied(&text, edits.get(&None).map(Vec::as_slice).unwrap_or_default());
    }
}

/// The values that a script prints, and whether its checks hold.
fn said(session: &Session, text: &str, files: &ScriptFiles) -> Vec<String> {
    let report = session.run("main.geo", text.as_bytes(), files, &[]);
    let said = |event: &Event| match event {
        Event::Printed(line) => Some(line.value.to_string()),
        Event::Checked(checked) => Some(checked.verdict.holds.to_string()),
        _ => None,
    };
    report.events.iter().filter_map(said).collect()
}

#[test]
fn every_definition_of_every_example_takes_a_fresh_name() {
    let session = Session::default();
    let folder = Path::new("examples");
    let files = ScriptFiles::new(folder);
    let mut n_all = 0;
    for entry in fs::read_dir(folder).expect("the examples") {
        let path = entry.expect("an entry").path();
        if path.extension().is_none_or(|ending| ending != "geo") {
            continue;
        }
        let text = fs::read_to_string(&path).expect("an example");
        let document = Document::new(&session, "main.geo", &text, &files);
        for name in &document.outline().names {
            if document.renamable(name.place.start).is_ok() {
                n_all += 1;
                let found = document.rename(&session, &files, name.place.start, FRESH);
                assert!(found.is_ok(), "{}, {}: {found:?}", path.display(), name.name);
            }
        }
    }
    assert!(300 < n_all, "{n_all}");
}

#[test]
fn with_fresh_names_for_all_a_program_says_the_same() {
    let session = Session::default();
    let files = ScriptFiles::new(Path::new("examples"));
    for name in ["first-steps", "circles", "lens"] {
        let text = fs::read_to_string(format!("examples/{name}.geo")).expect("an example");
        let (fresh, n_renamed) = renamed(&session, &text, &files);
        assert!(0 < n_renamed, "{name}");
        assert_eq!(said(&session, &fresh, &files), said(&session, &text, &files), "{fresh}");
    }
}

#[test]
fn names_in_what_is_printed_and_exported_are_renamed() {
    let session = Session::default();
    let text = "let c = 1\nprint [c], sin(c), \"{c}\"\ncheck c == 1 or c > 2\n";
    let files = ScriptFiles::new(Path::new("."));
    let (fresh, n_renamed) = renamed(&session, text, &files);
    let expected =
        "let zq_c0 = 1\nprint [zq_c0], sin(zq_c0), \"{zq_c0}\"\ncheck zq_c0 == 1 or zq_c0 > 2\n";
    assert_eq!((fresh.as_str(), n_renamed), (expected, 1));
}
