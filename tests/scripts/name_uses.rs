//! Which name means which definition: by marks in scripts, and by a law over all examples.

use std::fs;

use virote::{
    diag::{Sources, Span},
    session::Session,
    value::{MemoryFiles, NoFiles},
};

fn text_at(sources: &Sources, place: Span) -> (String, String) {
    let source = sources.at(place).expect("a place in a source");
    (source.name.clone(), source.text[source.local(place)].to_owned())
}

/// Each use as `name line:column -> file line:column`, in order.
fn told(text: &str, files: &MemoryFiles) -> Vec<String> {
    let (names, sources) = Session::default().name_uses("main.geo", text.as_bytes(), files);
    let at = |place: Span| {
        let source = sources.at(place).expect("a place in a source");
        let (line, column) = source.line_column(place.start);
        format!("{}:{line}:{column}", source.name)
    };
    names
        .uses
        .iter()
        .map(|&(place, target)| {
            let name = text_at(&sources, place).1;
            format!("{name} {} -> {}", at(place), at(target))
        })
        .collect()
}

#[test]
fn inner_names_hide_outer_ones() {
    let text =
        "let a = 1\nlet f = a => a + 1\nlet b = [for a in 1..a: a]\nlet c = { let a = 2  a }";
    assert_eq!(
        told(text, &MemoryFiles::default()),
        [
            "a main.geo:2:14 -> main.geo:2:9",
            "a main.geo:3:22 -> main.geo:1:5",
            "a main.geo:3:25 -> main.geo:3:14",
            "a main.geo:4:22 -> main.geo:4:15",
        ]
    );
}

#[test]
fn labels_mean_parameters_and_imports_mean_their_files() {
    let mut files = MemoryFiles::default();
    files.insert("part.geo", "param width = 2mm\nfn twice(x, by = 2) = by * x\n");
    let text = "import \"part.geo\" as part with (width = 3mm)\nimport \"part.geo\" (twice)\n\
                print part.twice(part.width, by = 3)\nprint twice(1, by = 4)\n";
    assert_eq!(
        told(text, &files),
        [
            "width main.geo:1:33 -> part.geo:1:7",
            "twice main.geo:2:20 -> part.geo:2:4",
            "part main.geo:3:7 -> main.geo:1:22",
            "twice main.geo:3:12 -> part.geo:2:4",
            "part main.geo:3:18 -> main.geo:1:22",
            "width main.geo:3:23 -> part.geo:1:7",
            "by main.geo:3:30 -> part.geo:2:13",
            "twice main.geo:4:7 -> main.geo:2:20",
            "by main.geo:4:16 -> part.geo:2:13",
            "by part.geo:2:23 -> part.geo:2:13",
            "x part.geo:2:28 -> part.geo:2:10",
        ]
    );
}

#[test]
fn a_use_is_written_as_its_definition() {
    let mut n_uses = 0;
    for entry in fs::read_dir("examples").expect("the examples") {
        let path = entry.expect("an entry").path();
        if path.extension().is_none_or(|ending| ending != "geo") {
            continue;
        }
        let bytes = fs::read(&path).expect("a script");
        let (names, sources) = Session::default().name_uses("example.geo", &bytes, &NoFiles);
        for &(place, target) in &names.uses {
            let (used, defined) = (text_at(&sources, place), text_at(&sources, target));
            assert_eq!(used.1, defined.1, "{} at {place:?}", path.display());
            n_uses += 1;
        }
    }
    assert!(1000 < n_uses, "only {n_uses} uses were found");
}
