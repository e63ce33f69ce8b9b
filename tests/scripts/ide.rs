//! What an editor is told, at marks in scripts. `‸` is the cursor.

use std::sync::Arc;

use virote::{
    ide::{
        self, CalledSignature, Completion, Document, FolderEntry, HintOptions, LensKind, TextEdit,
        Values,
    },
    session::Session,
    value::MemoryFiles,
};

/// A script with a cursor, looked at and run.
pub(crate) struct Scene {
    pub(crate) session: Session,
    files: MemoryFiles,
    pub(crate) document: Document,
    pub(crate) values: Values,
    pub(crate) at: usize,
}

pub(crate) fn scene_with(marked: &str, files: MemoryFiles) -> Scene {
    let at = marked.find('‸').unwrap_or(0);
    let text = marked.replace('‸', "");
    let session = Session::default();
    let document = Document::new(&session, "main.geo", &text, &files);
    let values = Values::new(Arc::new(session.run("main.geo", text.as_bytes(), &files, &[])));
    Scene { session, files, document, values, at }
}

pub(crate) fn scene(marked: &str) -> Scene {
    scene_with(marked, MemoryFiles::default())
}

impl Scene {
    pub(crate) fn hover(&self) -> String {
        let found = self.document.hover(&self.session, Some(&self.values), self.at);
        found.map(|(text, _)| text).unwrap_or_default()
    }

    pub(crate) fn completions(&self) -> Vec<Completion> {
        let list = |folder: &str| match folder {
            "" => vec![
                FolderEntry { name: "part.geo".to_owned(), is_folder: false },
                FolderEntry { name: "TABLE.CSV".to_owned(), is_folder: false },
                FolderEntry { name: "data".to_owned(), is_folder: true },
            ],
            _ => Vec::new(),
        };
        self.document.completions(&self.session, Some(&self.values), &list, self.at)
    }

    pub(crate) fn signatures(&self) -> Vec<CalledSignature> {
        self.document.signatures(&self.session, Some(&self.values), self.at)
    }

    pub(crate) fn completion(&self, label: &str) -> Completion {
        let found = self.completions();
        let labels: Vec<&str> = found.iter().map(|one| one.label.as_str()).collect();
        let one = found.iter().find(|one| one.label == label);
        assert!(one.is_some(), "no {label} among {labels:?}");
        one.expect("it is there").clone()
    }

    fn edited(&self, edits: &[TextEdit]) -> String {
        ide::applied(self.document.text(), edits)
    }
}

#[test]
fn a_hover_tells_kind_unit_value_and_documentation() {
    let told = scene("/// How wide.\nparam width = 27.2mm\nlet s = wi‸dth + 1mm").hover();
    assert_eq!(told, "```geo\nparam width: length\n```\n\n27.2 mm\n\nHow wide.");
    let told = scene("curve keel = line((0, 0), (30, 40))\nprint kee‸l").hover();
    assert!(told.contains("curve keel") && told.ends_with("length 50 mm"), "{told}");
    let told = scene("print bez‸ier((0, 0), (1, 2), (2, 0))").hover();
    assert!(told.contains("```geo\nbezier(") && told.contains("- `"), "{told}");
    let told = scene("print circle((0, 0), 1, nor‸mal = (0, 0, 1))").hover();
    assert!(told.starts_with("```geo\nnormal"), "{told}");
    assert!(scene("print 2‸5.4mm").hover().contains("= 1 in"));
    assert!(scene("print 9‸0deg").hover().contains("0.25 turn"));
    assert!(scene("che‸ck 1 < 2").hover().contains("check"));
    assert!(scene("let p = (1, 2)\nprint p.x‸").hover().contains(".x = 1"));
    assert_eq!(scene("// not‸hing").hover(), "");
}

#[test]
fn a_hover_reaches_into_imported_files() {
    let files = MemoryFiles::from([("part.geo", "/// Its size.\nlet size = 3mm\n")]);
    let told = scene_with("import \"part.geo\" as part\nprint part.si‸ze", files).hover();
    assert_eq!(told, "```geo\nlet size\n```\n\n3 mm\n\nIts size.");
}

#[test]
fn completion_offers_each_name_once_and_not_the_one_that_is_defined() {
    let count = |marked: &str, label: &str| {
        scene(marked).completions().iter().filter(|one| one.label == label).count()
    };
    for marked in [
        "let width = 3\nlet b = width + w‸",
        "let width = 3\nlet b = width + (w‸",
        "let width = 3\nparam b = width in width..w‸",
        "let width = 3\nlet b =\n    [width, w‸",
        "let width = 3\ncurve b = line((0, 0), (width, 0)) with (color = w‸)",
        "let width = 3\nlet b = { let width = 4\n width + w‸ }",
        "fn width(x) = 3\nlet c = { let b = width(2) + w‸ }",
    ] {
        assert_eq!(count(marked, "width"), 1, "{marked}");
        assert_eq!(count(marked, "b"), 0, "{marked}");
    }
    let width = scene("let width = 3\nlet b = width + w‸").completion("width");
    assert_eq!(width.detail, "3");
    // What is before, a function inside of itself, and names of functions and comprehensions are known.
    assert_eq!(count("fn twice(n) = twi‸", "twice"), 1);
    assert_eq!(count("let f = n => n + n‸", "n"), 1);
    assert_eq!(count("let f = [for row in [1, 2]: (row + r‸", "row"), 1);
    assert_eq!(count("let c = {\n let own = 3\n own + o‸", "own"), 1);
    assert_eq!(count("let c = {\n let own = 3\n own + o‸", "c"), 0);
    assert_eq!(count("let circle = 3\nprint cir‸", "circle"), 1);
}

#[test]
fn completion_knows_the_place() {
    let names = scene("/// Its width.\nlet width = 2mm\nlet b = wi‸");
    let width = names.completion("width");
    assert_eq!((width.detail.as_str(), width.docs.as_str()), ("2 mm", "Its width."));
    let circle = scene("let b = cir‸").completion("circle");
    assert_eq!(circle.snippet.as_deref(), Some("circle(${1:center}, ${2:radius}$0)"));
    assert!(circle.all_docs(names.session.registry()).contains("- `radius`"));
    let labels = scene("let b = circle((0, 0), 1, normal = (0, 0, 1), ‸)").completions();
    assert!(
        labels.iter().any(|one| one.insert == "from = ")
            == labels.iter().any(|one| one.label == "from")
    );
    assert!(!labels.iter().any(|one| one.insert == "normal = "), "it is given already");
    assert!(
        scene("let c = interpolate([(0, 0), (1, 1)], ends = \"‸\")").completion("natural").insert
            == "natural"
    );
    assert!(!scene("print XY.‸").completions().is_empty());
    let row = scene("let t = table({wide: [1], high: [2]})\nprint t[0].‸").completion("high");
    assert_eq!(row.label, "high");
    assert_eq!(scene("let p = {width: 2mm}\nprint p.‸").completion("width").detail, "2 mm");
    assert_eq!(scene("print 10‸").completion("mm").insert, "mm");
    assert_eq!(scene("unit ‸").completion("cm").detail, "10 mm");
    assert_eq!(scene("import \"‸\"").completion("part.geo").detail, "file");
    assert_eq!(scene("import \"da‸\"").completion("data/").detail, "folder");
    assert_eq!(scene("fn f(inner) = inn‸").completion("inner").label, "inner");
    assert_eq!(
        scene("let xs = [for station in 0..3: stat‸").completion("station").label,
        "station"
    );
    assert_eq!(scene("param a: ‸").completion("length").label, "length");
    let colors = scene("curve c = line((0, 0), (1, 0)) with (color = \"st‸\")");
    assert_eq!(colors.completion("steelblue").detail, "#4682b4");
    assert_eq!(
        scene("curve c = line((0, 0), (1, 0)) with (‸)").completion("layer").insert,
        "layer = "
    );
    assert!(
        scene("export all to \"a.stl\" with (‸)").completion("tolerance").insert == "tolerance = "
    );
    assert!(scene("// wi‸").completions().is_empty());
}

/// The labels of what is offered first: those of a kind that is taken.
fn fitting(marked: &str) -> Vec<String> {
    let found = scene(marked).completions();
    found.into_iter().filter(|one| one.is_fitting).map(|one| one.label).collect()
}

#[test]
fn what_fits_an_argument_comes_first() {
    let has = |marked: &str, label: &str| fitting(marked).iter().any(|one| one == label);
    let script = "curve rail = line((0, 0), (9, 0))\nlet size = 3mm\nlet turn = 30deg\nsurface s = sphere((0, 0), 2)\n";
    let with = |text: &str| format!("{script}{text}");
    let along = with("let t = sweep(circle((0, 0), 1), path = ‸)");
    assert!(has(&along, "rail") && has(&along, "helix"), "{:?}", fitting(&along));
    assert!(!has(&along, "size") && !has(&along, "s") && !has(&along, "sin"));
    let radius = with("let t = circle((0, 0), ‸)");
    assert!(
        has(&radius, "size")
            && has(&radius, "length")
            && !has(&radius, "turn")
            && !has(&radius, "rail")
    );
    let angle = with("let t = rotate(rail, angle = ‸)");
    assert!(has(&angle, "turn") && !has(&angle, "size"), "{:?}", fitting(&angle));
    // Elements of a list, and what a keyword promises.
    let list = with("let t = skin([rail, ‸])");
    assert!(has(&list, "rail") && !has(&list, "size"));
    let promise = with("surface t = ‸");
    assert!(has(&promise, "s") && has(&promise, "torus") && !has(&promise, "rail"));
    // What does not fit is still offered, behind.
    let found = scene(&along).completions();
    let place = |label: &str| found.iter().position(|one| one.label == label).unwrap();
    assert!(place("rail") < place("size"));
    assert!(has(&with("let t = size + ‸"), "turn"), "anything may stand here");
    let units = scene("print sin(30‸)").completions();
    assert_eq!((units[0].label.as_str(), units[0].is_fitting), ("deg", true));
}

#[test]
fn words_are_offered_with_their_quotes() {
    let one = scene("let c = interpolate([(0, 0), (1, 1)], ends = ‸)").completion("\"natural\"");
    assert_eq!((one.insert.as_str(), one.is_fitting), ("\"natural\"", true));
    let color = "curve c = line((0, 0), (1, 0)) with (color = ‸)";
    assert_eq!(scene(color).completion("\"steelblue\"").insert, "\"steelblue\"");
    let hidden = fitting("curve c = line((0, 0), (1, 0)) with (hidden = ‸)");
    assert!(hidden.iter().any(|one| one == "true") && !hidden.iter().any(|one| one == "sphere"));
    // Names are offered again inside of the braces of a string, and nothing in its text.
    assert_eq!(scene("let width = 2mm\nprint \"{wid‸}\"").completion("width").detail, "2 mm");
    assert!(scene("print \"wid‸\"").completions().is_empty());
}

#[test]
fn members_are_those_of_the_expression_before_the_dot() {
    let of = |marked: &str| -> Vec<String> {
        scene(marked).completions().into_iter().map(|one| one.label).collect()
    };
    let record = "let p = {a: {b: 2mm}, cs: [line((0, 0), (1, 0))]}\nlet b = {wrong: 1}\n";
    assert_eq!(of(&format!("{record}print p.a.‸")), ["b"]);
    assert!(of(&format!("{record}print p.cs[0].‸")).contains(&"degree".to_owned()));
    assert!(of("print circle((0, 0), 2).‸").contains(&"knots".to_owned()));
    assert!(of("solid s = solid(sphere((0, 0), 2))\nprint s.‸").contains(&"vertices".to_owned()));
    assert_eq!(of("curve c = line((0, 0), (1, 0))\nprint c(0.5).‸"), ["x", "y", "z"]);
    // A function of the script hides the built-in of its name.
    assert_eq!(of("fn circle(r) = r\nprint circle(2).‸"), [""; 0]);
    // By what it promises, where it has no value.
    assert!(of("curve c = nothing()\nprint c.‸").contains(&"degree".to_owned()));
    let degree = scene("curve c = line((0, 0), (1, 0))\nprint c.‸").completion("degree");
    assert_eq!(degree.detail, "1");
}

#[test]
fn files_and_labels_are_those_that_are_left() {
    let files = scene("let a = load(\"‸\")").completions();
    let names: Vec<(&str, bool)> =
        files.iter().map(|one| (one.label.as_str(), one.is_fitting)).collect();
    assert_eq!(names, [("TABLE.CSV", true), ("data/", true), ("part.geo", false)]);
    let labels = scene("let c = circle((0, 0), ‸)").completions();
    let labels: Vec<&str> = labels
        .iter()
        .filter(|one| one.insert.ends_with(" = "))
        .map(|one| one.label.as_str())
        .collect();
    assert!(labels.contains(&"radius") && !labels.contains(&"center"), "{labels:?}");
    let part =
        || MemoryFiles::from([("part.geo", "param beam = 3m\nfn f(size, by) = size * by\n")]);
    let one = scene_with("let s = script(\"part.geo\", ‸)", part());
    assert_eq!(one.completion("beam").insert, "beam = ");
    let one = scene_with("import \"part.geo\"\nlet s = part.f(‸)", part());
    assert_eq!(one.completion("by").insert, "by = ");
}

#[test]
fn a_hover_measures() {
    let told = |marked: &str| scene(marked).hover();
    let rim = "curve rim = circle((0, 0), 2)\nprint ri‸m";
    assert!(told(rim).ends_with("length 12.5664 mm"), "{}", told(rim));
    let closer = |marked: &str, name: &str| {
        let one = scene(marked);
        one.values.measures(one.values.value(name).expect("a value"))
    };
    let ball = "surface ball = sphere((0, 0), 2)\nprint bal‸l";
    assert!(!told(ball).contains("area"), "that takes a closer look: {}", told(ball));
    assert_eq!(closer(ball, "ball"), "area 50.2655 mm^2");
    let block = "solid block = extrude(region(circle((0, 0), 1)), (0, 0, 2))\nprint bloc‸k";
    assert!(told(block).ends_with("solid of 3 faces"), "that takes a closer look: {}", told(block));
    assert_eq!(closer(block, "block"), "volume 6.28319 mm^3, area 18.8496 mm^2");
    let param = "param width = 5mm in 1mm..9mm step 1mm \"How wide\"\nprint widt‸h";
    assert_eq!(
        told(param),
        "```geo\nparam width: length in 1mm..9mm step 1mm\n```\n\n5 mm\n\n*How wide*"
    );
}

#[test]
fn a_signature_knows_its_argument() {
    let one = scene("let c = circle((0, 0), ‸");
    let found = one.signatures();
    assert_eq!(
        found[0].active.map(|idx| found[0].parameters[idx].label.clone()).unwrap(),
        "radius: length"
    );
    let one = scene("let c = circle((1, ‸");
    let found = one.signatures();
    assert!(found[0].label.starts_with("circle(") && found[0].active == Some(0), "{found:?}");
    let one = scene("/// Doubles.\nfn twice(x, by = 2) = by * x\nlet c = twice(1, by = ‸)");
    let found = one.signatures();
    assert_eq!((found[0].label.as_str(), found[0].active), ("fn twice(x, by = 2)", Some(1)));
    assert_eq!(found[0].docs, "Doubles.");
}

#[test]
fn names_are_followed_and_renamed_across_files() {
    let files = || MemoryFiles::from([("part.geo", "let size = 3mm\nlet twice = 2 * size\n")]);
    let one = scene_with("import \"part.geo\" (size)\nlet r = {size}\nprint si‸ze", files());
    let definition = one.document.definition(one.at).unwrap();
    assert_eq!((definition.file.as_deref(), definition.range()), (Some("part.geo"), 4..8));
    assert_eq!(one.document.references(one.at).len(), 5);
    let edits = one.document.rename(&one.session, &one.files, one.at, "width").unwrap();
    assert_eq!(
        one.edited(&edits[&None]),
        "import \"part.geo\" (width)\nlet r = {size: width}\nprint width"
    );
    let part = "let size = 3mm\nlet twice = 2 * size\n";
    assert_eq!(
        ide::applied(part, &edits[&Some("part.geo".to_owned())]),
        part.replace("size", "width")
    );

    let one = scene_with("import \"part.geo\"\nprint par‸t.size", files());
    let edits = one.document.rename(&one.session, &one.files, one.at, "piece").unwrap();
    assert_eq!(one.edited(&edits[&None]), "import \"part.geo\" as piece\nprint piece.size");

    for (text, new, why) in [
        ("let a = 1\nlet b‸ = a", "a", "means something else"),
        ("let a = 1\nlet b‸ = a", "let", "a word of the language"),
        ("let a = 1\nlet b‸ = a", "2b", "is no name"),
        ("let a‸ = 1\nlet f = b => a + b", "b", "means something else"),
        ("print sq‸rt(2)", "root", "only names that scripts define"),
    ] {
        let one = scene(text);
        let refused = one.document.rename(&one.session, &one.files, one.at, new).unwrap_err();
        assert!(refused.contains(why), "{text}: {refused}");
    }
}

#[test]
fn what_other_files_use_stays_visible_to_them() {
    let files = || MemoryFiles::from([("part.geo", "let wide = 3mm\nlet twice = 2 * wide\n")]);
    for text in
        ["import \"part.geo\" as part\nprint part.wi‸de", "import \"part.geo\" (wide)\nprint wi‸de"]
    {
        let one = scene_with(text, files());
        let refused = one.document.rename(&one.session, &one.files, one.at, "_w").unwrap_err();
        assert!(refused.contains("begin with `_` are not shown to other files"), "{refused}");
    }
    // What only its own file uses may hide, and show itself again.
    for (text, new, right) in [
        ("let wide‸ = 3\nprint wide", "_w", "let _w = 3\nprint _w"),
        ("let _w‸ = 3\nprint _w", "wide", "let wide = 3\nprint wide"),
        (
            "import \"part.geo\" as part‸\nprint part.wide",
            "_p",
            "import \"part.geo\" as _p\nprint _p.wide",
        ),
    ] {
        let one = scene_with(text, files());
        let edits = one.document.rename(&one.session, &one.files, one.at, new).unwrap();
        assert_eq!(one.edited(&edits[&None]), right);
    }
}

#[test]
fn hints_tell_values_margins_and_parameters() {
    let text = "let a = 2mm\nlet b = a * 3\nlet c = line((0, 0), (3, 4))\ncheck length(c) < 6\nlet d = circle((0, 0), 2)";
    let one = scene(text);
    let all = 0..text.len();
    let hints =
        one.document.hints(one.session.registry(), Some(&one.values), &all, HintOptions::default());
    let mut shown = text.to_owned();
    for hint in hints.iter().rev() {
        shown.insert_str(hint.at, &format!("«{}»", hint.text));
    }
    assert_eq!(
        shown,
        "let a = 2mm\nlet b = a * 3« = 6 mm»\nlet c«: curve» = line((0, 0), (3, 4))\ncheck length(c) < 6« holds with margin 1mm»\nlet d«: curve» = circle(«center: »(0, 0), «radius: »2)"
    );
    let lenses =
        scene("curve c = line((0, 0), (1, 0))\ntest \"two\" { check 1 < 2 }").document.lenses(None);
    let kinds: Vec<&LensKind> = lenses.iter().map(|lens| &lens.kind).collect();
    let test = LensKind::Test { name: "two".to_owned(), verdict: None };
    assert_eq!(kinds, [&LensKind::View("c".to_owned()), &test]);
}

#[test]
fn the_shape_of_a_text_is_told() {
    let one = scene(
        "// one\n// two\nfn f(x) = {\n    let y = x\n    y\n}\ntest \"t\" {\n    let z = 1\n    check z == 1\n}\nlet a = [1, ‸2]",
    );
    let symbols = one.document.symbols();
    let told: Vec<(&str, usize)> =
        symbols.iter().map(|symbol| (symbol.name.as_str(), symbol.children.len())).collect();
    assert_eq!(told, [("f", 1), ("t", 1), ("a", 0)]);
    assert_eq!(one.document.folds().len(), 3);
    let texts: Vec<&str> = one
        .document
        .selections(one.at)
        .into_iter()
        .map(|range| &one.document.text()[range])
        .collect();
    assert_eq!(texts[..3], ["2", "[1, 2]", "let a = [1, 2]"]);
    let edits = ide::formatted(&one.session, "let   a = 1\nlet b = 2\n");
    assert_eq!((edits.len(), edits[0].range.clone()), (1, 0..12));
    assert!(ide::formatted(&one.session, "let a = (").is_empty());
}

#[test]
fn colours_are_found_and_spelt() {
    let one = scene("curve c = line((0, 0), (1, 0)) with (color = \"red\")");
    let text = one.document.text().clone();
    let found = ide::colors(&one.document);
    assert_eq!((&text[found[0].0.clone()], found[0].1), ("\"red\"", [255, 0, 0]));
    assert_eq!(ide::spellings([255, 0, 0]), ["\"red\"", "\"#ff0000\""]);
}

#[test]
fn words_have_kinds() {
    let one =
        scene("import \"x.geo\" as x\nparam w = 2\nfn f(a) = a + w\nprint f(1) + sqrt(pi), {k: w}");
    let tokens = one.document.tokens(one.session.registry());
    let told: Vec<String> = tokens
        .iter()
        .map(|token| {
            let mark = if token.is_declaration {
                "*"
            } else if token.is_built_in {
                "!"
            } else {
                ""
            };
            format!("{}:{:?}{mark}", &one.document.text()[token.range.clone()], token.kind)
        })
        .collect();
    for expected in [
        "x:Namespace*",
        "w:Setting*",
        "f:Function*",
        "a:Parameter*",
        "a:Parameter",
        "f:Function",
        "sqrt:Function!",
        "pi:Variable!",
        "k:Property",
        "print:Keyword",
    ] {
        assert!(told.iter().any(|one| one == expected), "{expected}: {told:?}");
    }
}

#[test]
fn every_place_of_every_example_can_be_asked() {
    let session = Session::default();
    for name in ["bottle", "teapot"] {
        let text = std::fs::read_to_string(format!("examples/{name}.geo")).expect("an example");
        let files = MemoryFiles::default();
        let document = Document::new(&session, "main.geo", &text, &files);
        for (at, _) in text.char_indices().step_by(7) {
            let _ = document.hover(&session, None, at);
            let _ = document.signatures(&session, None, at);
            let _ = document.selections(at);
            for found in document.references(at) {
                assert_eq!(document.definition(found.start), document.definition(at));
            }
        }
    }
}
