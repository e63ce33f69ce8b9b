//! What is told at a mark of a script that is being written, often one that does not parse yet. `‸` is the cursor.

use std::sync::Arc;

use virote::{
    eval::TestFilter,
    ide::{HintKind, HintOptions, LensKind, TokenKind},
    session::TestVerdict,
    value::MemoryFiles,
};

use crate::ide::{scene, scene_with};

fn labels(marked: &str) -> Vec<String> {
    scene(marked).completions().into_iter().map(|one| one.label).collect()
}

fn part() -> MemoryFiles {
    let text = "/// How wide.\nparam wide = 3m in 1m..9m\nparam form = \"round\" in [\"round\", \"flat\"]\nfn make(size) = size\nlet _own = 1\n";
    MemoryFiles::from([("part.geo", text)])
}

fn labels_with_part(marked: &str) -> Vec<String> {
    scene_with(marked, part()).completions().into_iter().map(|one| one.label).collect()
}

#[test]
fn an_import_lists_the_names_of_its_file() {
    assert_eq!(labels_with_part("import \"part.geo\" (‸)"), ["form", "make", "wide"]);
    assert_eq!(labels_with_part("import \"part.geo\" (wide, ‸)"), ["form", "make"]);
    assert_eq!(labels_with_part("import \"part.geo\" (ma‸\nlet b = 2"), ["form", "make", "wide"]);
    assert_eq!(labels_with_part("import \"part.geo\" as l with (‸)"), ["form", "wide"]);
    assert_eq!(labels_with_part("import \"part.geo\" with (wide = 2m, ‸"), ["form"]);
    assert_eq!(
        scene_with("import \"part.geo\" with (‸)", part()).completion("wide").insert,
        "wide = "
    );
}

#[test]
fn choices_of_parameters_are_offered() {
    let own = "param s = \"a\" in [\"a\", \"b\"]\n";
    assert_eq!(labels(&format!("{own}let t = s == \"‸\"")), ["a", "b"]);
    assert_eq!(labels(&format!("{own}let t = if \"‸\" != s then 1 else 2")), ["a", "b"]);
    assert_eq!(labels("param s = \"‸\" in [\"a\", \"b\"]"), ["a", "b"]);
    assert_eq!(
        labels("let all = [\"a\", \"b\"]\nparam s = \"a\" in all\nprint s == \"‸\""),
        ["a", "b"]
    );
    for marked in [
        "import \"part.geo\" with (form = \"‸\")",
        "import \"part.geo\" as part\nprint part.form == \"‸\"",
        "import \"part.geo\" (form)\nprint form == \"‸\"",
        "let s = script(\"part.geo\", form = \"‸\")",
    ] {
        assert_eq!(labels_with_part(marked), ["flat", "round"], "{marked}");
    }
}

#[test]
fn labels_are_no_names() {
    let radius = labels("let a = circle(center = (0, 0), radius = ‸)");
    assert!(!radius.contains(&"center".to_owned()) && !radius.contains(&"radius".to_owned()));
    let record = labels("let p = {zeta: 3}\nlet u = zet‸");
    assert!(!record.contains(&"zeta".to_owned()), "a label of a record is no name");
}

#[test]
fn members_of_expressions_that_have_no_value_yet() {
    let curve = "curve ring = circle((0, 0), 1)\nlet rs = [ring]\n";
    let has = |marked: &str, label: &str| {
        let found = labels(&format!("{curve}{marked}"));
        assert!(found.iter().any(|one| one == label) && found.len() < 20, "{marked}: {found:?}");
    };
    has("print continuity(ring).‸", "curvature_gap");
    has("print closest(ring, (1, 2)).‸", "distance");
    has("print ring |> closest((1, 2)).‸", "distance");
    has("print (ring).‸", "degree");
    has("print {p: 1}.‸", "p");
    has("print [for r in rs: r.‸]", "degree");
    has("print [for r in rs: \"{r.‸}\"]", "degree");
    has("print (1, 2, 3).‸", "x");
    has("print ((1, 2) + (3, 4)).‸", "x");
    has("print (if true then ring else ring).‸", "degree");
    has("let b = { let inner = {zeta: 3} inner.‸ }", "zeta");
    has("fn f(x) = {zeta: x}\nprint f(2).‸", "zeta");
    assert_eq!(labels("fn f(x) = x.‸"), [""; 0], "nobody knows what it is given");
}

#[test]
fn files_to_write_and_formats_of_numbers_are_offered() {
    let curve = "curve ring = circle((0, 0), 1)\nlet neck = 3mm\n";
    let of = |marked: &str| labels(&format!("{curve}{marked}"));
    assert!(of("export ring to \"out.s‸\"").contains(&"out.step".to_owned()));
    assert!(of("export ring to \"‸\"").contains(&"ring.svg".to_owned()));
    let formats = of("print \"{neck:‸}\"");
    assert!(formats.contains(&"cm".to_owned()) && formats.contains(&".2".to_owned()));
    assert!(!formats.contains(&"deg".to_owned()) && !formats.contains(&"neck".to_owned()));
    assert!(of("print \"{sin({neck:‸").len() > 20, "a record is no format");
}

#[test]
fn signatures_of_functions_that_are_values() {
    let active = |marked: &str| {
        let found = scene(marked).signatures();
        let first = found.first().map(|one| (one.label.clone(), one.active));
        first.unwrap_or_default()
    };
    let has = |marked: &str, label: &str, idx: usize| {
        assert_eq!(active(marked), (label.to_owned(), Some(idx)), "{marked}");
    };
    has("fn f(x, y) = x\nprint \"x {f(1, ‸)}\"", "fn f(x, y)", 1);
    has("let f = x => x\nprint f(‸)", "f(x)", 0);
    has("let rec = {f: (x, y) => x}\nprint rec.f(1, ‸)", "rec.f(x, y)", 1);
    has("curve c = line((0, 0), (1, 0))\nprint c(‸)", "c(t)", 0);
    has("surface s = sphere((0, 0), 1)\nprint s(0.5, ‸)", "s(u, v)", 1);
    has("print { let g = (a, b) => a  g(1, ‸) }", "g(a, b)", 1);
    assert!(active("let f = sin\nprint f(‸)").0.starts_with("sin("));
    // What the script defines hides what is built in.
    has("let circle = r => r\nprint circle(‸)", "circle(r)", 0);
}

#[test]
fn hovers_tell_what_is_defined_inside() {
    let told = |marked: &str| scene(marked).hover();
    let has = |marked: &str, text: &str| {
        assert!(told(marked).contains(text), "{marked}: {}", told(marked));
    };
    has("let neck = 3mm\nlet q = { let inn‸er = neck * 2  inner + 1mm }", "6 mm");
    has("test \"t\" { let lo‸c = 5mm  check loc > 3mm }", "5 mm");
    has("fn f(x) = { let half = 0.5  let y‸ = half + 1  y * x }", "1.5");
    has("fn f(x) = { curve c‸ = circle((0, 0), x)  c }", "curve");
    has("fn f(x) = { let c‸ = circle((0, 0), x)  c }", "curve");
    has("let lam‸ = x => x + 1", "function `(x) => ...`");
    has("param ne‸ck = 13mm in 8mm..20mm", "param neck: length in 8mm..20mm");
    has("param n‸: integer = 3", "param n: integer");
    has("let rec = {alp‸ha: 3mm + 1mm, b: 2}", "alpha: 4 mm");
    has("curve c = line((0, 0), (1, 0)) with (col‸or = \"red\")", "colour");
    has("curve c = line((0, 0), (1, 0)) with (hid‸den = true)", "`all`");
    has("curve c = line((0, 0), (1, 0))\nexport c to \"a.svg\" with (vi‸ew = \"top\")", "view =");
    has("test \"t\" { expect error \"E05‸01\" 1 / 0 }", "E0501");
    // What depends on an argument has no value of its own.
    assert!(!told("fn f(x) = { let y‸ = x + 1  y }").contains('='));
}

#[test]
fn names_of_another_file_have_its_colours() {
    let files = MemoryFiles::from([("part.geo", "fn make(x) = x\nlet pub = 3\n")]);
    let one = scene_with("import \"part.geo\" (make, pub)\nprint make(pub)", files);
    let tokens = one.document.tokens(one.session.registry());
    let kinds: Vec<TokenKind> = tokens.iter().rev().take(2).map(|token| token.kind).collect();
    assert_eq!(kinds, [TokenKind::Variable, TokenKind::Function]);
}

#[test]
fn fields_that_are_taken_apart_keep_their_names() {
    let one = scene("let {a1‸, b1} = {a1: 1, b1: 2}\nprint a1");
    let why = one.document.renamable(one.at).expect_err("it is a field");
    assert!(why.contains("the field that it stands for"), "{why}");
    assert!(scene("let [p‸, q] = [1, 2]").document.renamable(5).is_ok());
}

#[test]
fn claims_of_a_test_have_margins_once_it_ran() {
    let text = "let a = 2\ntest \"t\" {\n    check a < 1\n    check a < 5\n}\n";
    let mut one = scene(text);
    let margins = |one: &crate::ide::Scene| {
        let registry = one.session.registry();
        let hints = one.document.hints(
            registry,
            Some(&one.values),
            &(0..text.len()),
            HintOptions::default(),
        );
        hints.iter().filter(|hint| hint.kind == HintKind::Margin).count()
    };
    assert_eq!((margins(&one), one.values.findings().len()), (0, 0));
    let filter = Some(TestFilter::Named("t"));
    let report =
        one.session.test("main.geo", text.as_bytes(), &MemoryFiles::default(), &[], filter);
    one.values.take_tests(&Arc::new(report));
    assert_eq!((margins(&one), one.values.findings().len()), (2, 1));
    let lenses = one.document.lenses(Some(&one.values));
    let is_failed =
        |lens: &LensKind| matches!(lens, LensKind::Test { verdict: Some(TestVerdict::Failed), .. });
    assert!(lenses.iter().any(|lens| is_failed(&lens.kind)));
    assert_eq!(lenses.iter().filter(|lens| matches!(lens.kind, LensKind::Check { .. })).count(), 2);
}
