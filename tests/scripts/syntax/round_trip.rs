//! Printing and parsing undo each other; formatting changes nothing but the look.

use std::cell::Cell;
use std::path::Path;

use proptest::collection;
use proptest::prelude::{Just, ProptestConfig, Strategy, any, proptest};
use proptest::test_runner::TestRunner;

use virote::limits::Limits;
use virote::syntax::ast::Tree;
use virote::syntax::{format, print};

use super::trees::tree;
use super::{parse_clean, scripts, shape};

/// The formatted text of a script without mistakes.
#[track_caller]
fn formatted(source: &str) -> String {
    format(source, &Limits::DEFAULT).unwrap_or_else(|found| panic!("{source}\n{found:#?}"))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, max_shrink_iters: 4_000, ..ProptestConfig::default() })]

    #[test]
    fn what_is_printed_is_read_back(tree in tree()) {
        let text = print(&tree);
        let read = parse_clean(&text);
        assert_eq!(shape(&read), shape(&tree), "\n{text}");
        assert_eq!(print(&read), text);
    }

    #[test]
    fn formatting_keeps_the_meaning_and_is_done_once(tree in tree()) {
        let text = formatted(&print(&tree));
        assert_eq!(shape(&parse_clean(&text)), shape(&tree), "\n{text}");
        assert_eq!(formatted(&text), text);
    }
}

/// What formatting must do to any text: keep the tree and the comments, and be done.
#[track_caller]
fn check_law(source: &str) {
    let text = formatted(source);
    assert_eq!(shape(&parse_clean(&text)), shape(&parse_clean(source)), "\n{source}\n{text}");
    assert_eq!(marks(&text), marks(source), "\n{source}\n{text}");
    let again = formatted(&text);
    assert_eq!(again, text, "formatted twice\n{source}\n{text}\n{again}");
    assert!(!text.lines().any(|line| line.ends_with(' ')) || source.contains("/*"), "{text}");
    assert!(!text.contains("\n\n\n") || source.contains("/*"), "{text}");
}

/// The numbers of the comments that `dressed` made, in order.
fn marks(text: &str) -> Vec<&str> {
    let behind = text.split("<|").skip(1);
    behind.map(|rest| rest.split_once("|>").map_or("", |(mark, _)| mark)).collect()
}

/// Where a text has white space, or a bracket or a comma ends, outside of strings and comments.
fn gaps(text: &str) -> Vec<usize> {
    let mut gaps = Vec::new();
    let mut at = 0;
    while let Some(byte) = text.as_bytes().get(at) {
        match byte {
            b'"' => at = end_of_string(text, at),
            b'/' if text[at..].starts_with("//") => {
                at = text[at..].find('\n').map_or(text.len(), |line| at + line);
            }
            b' ' | b'\n' | b'(' | b'[' | b',' | b'{' => {
                at += 1;
                gaps.push(at);
            }
            _ => at += 1,
        }
    }
    gaps
}

/// Behind the string that begins at `start`.
fn end_of_string(text: &str, start: usize) -> usize {
    let bytes = text.as_bytes();
    let (mut at, mut braces) = (start + 1, 0);
    while at < bytes.len() {
        match bytes[at] {
            b'\\' if braces == 0 => at += 1,
            b'"' if braces == 0 => return at + 1,
            b'"' => at = end_of_string(text, at) - 1,
            b'{' => braces += 1,
            b'}' if braces > 0 => braces -= 1,
            _ => {}
        }
        at += 1;
    }
    at
}

/// `text` with comments, blank lines, breaks and spaces in odd places.
fn dressed(text: &str, choices: &[u8]) -> String {
    let mut out = String::new();
    let mut start = 0;
    let mut choices = choices.iter().cycle();
    for (index, gap) in gaps(text).into_iter().enumerate() {
        out.push_str(&text[start..gap]);
        start = gap;
        // These would begin an expression of their own on a new line.
        let may_break = !text[gap..].starts_with(['(', '[', '-']);
        let mark = format!("<|{index}|>");
        match choices.next().copied().unwrap_or(0) {
            0 if may_break => out.push_str(&format!("// {mark}   \n")),
            1 if may_break => out.push_str(&format!("\n\n\n// {mark}\n\n  // <|x{index}|>\n")),
            2 if may_break => out.push_str(&format!("/* {mark}\n /* nested */ */")),
            3 if may_break => out.push_str(&format!("\n  /* {mark} */ ")),
            4 => out.push_str(&format!("/* {mark} */")),
            5 if may_break => out.push('\n'),
            6 if may_break => out.push_str("\r\n\t\n  "),
            7 => out.push_str("     "),
            _ => {}
        }
    }
    out + &text[start..]
}

/// The statements of a tree, each printed for itself, with semicolons between them.
fn with_semicolons(tree: &Tree<'static>) -> String {
    let statements = tree.statements.iter().cloned();
    let texts = statements.map(|one| print(&Tree { statements: vec![one] }));
    texts.map(|text| text.trim_end().to_owned() + " ; ").collect()
}

#[test]
fn formatting_keeps_tree_and_comments_and_is_done_once() {
    let n_read = Cell::new(0);
    let cases = 600;
    let config = ProptestConfig { cases, max_shrink_iters: 4_000, ..ProptestConfig::default() };
    let density = proptest::prop_oneof![Just(8_u8), Just(30), Just(100)];
    let strategy = (tree(), density, any::<bool>()).prop_flat_map(|(tree, most, is_joined)| {
        (Just(tree), collection::vec(0..most, 1..60), Just(is_joined))
    });
    let run = TestRunner::new(config).run(&strategy, |(tree, choices, is_joined)| {
        let text = if is_joined { with_semicolons(&tree) } else { print(&tree) };
        let source = dressed(&text, &choices);
        // Some breaks end a statement too early.
        if format(&source, &Limits::DEFAULT).is_ok() {
            n_read.set(n_read.get() + 1);
            check_law(&source);
        }
        Ok(())
    });
    assert!(run.is_ok(), "{}", run.unwrap_err());
    assert!(n_read.get() > cases / 2, "only {} could be read", n_read.get());
}

/// The scripts of a folder of the repository.
fn scripts_in(folder: &str) -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut scripts: Vec<(String, String)> = paths
        .filter(|path| path.extension().is_some_and(|ending| ending == "geo"))
        .map(|path| (path.display().to_string(), std::fs::read_to_string(path).unwrap()))
        .collect();
    scripts.sort();
    scripts
}

#[test]
fn real_scripts_survive_printing_and_formatting() {
    let mut all = scripts();
    for folder in ["examples", "tests/golden", "tests/golden/lib"] {
        all.extend(scripts_in(folder));
    }
    assert!(all.len() > 50, "{}", all.len());
    for (name, source) in all {
        let tree = parse_clean(&source);
        let printed = print(&tree);
        assert_eq!(shape(&parse_clean(&printed)), shape(&tree), "{name}\n{printed}");
        let text = formatted(&source);
        assert_eq!(text.matches("//").count(), source.matches("//").count(), "{name}: comments");
        check_law(&source);
        for step in 2..6_u8 {
            let choices: Vec<u8> = (0..97).map(|i: u8| i.wrapping_mul(step) % 29).collect();
            let source = dressed(&source, &choices);
            if format(&source, &Limits::DEFAULT).is_ok() {
                check_law(&source);
            }
        }
    }
}

#[test]
fn the_examples_are_formatted() {
    for (name, source) in scripts_in("examples") {
        assert!(formatted(&source) == source, "{name}: `virote fmt` changes it");
    }
}

/// The script that opens the description of the language.
const OPENING: &str = r#"
geo 1                                                   // the edition of the language
unit mm

param neck = 13mm in 8mm..20mm step 0.5mm "Neck radius" // virote run bottle.geo --set neck=15mm
param body = 34mm

/// Radius of the section at height h, 0 at the foot and 1 at the mouth.
fn radius(h) = body + (neck - body) * (3*h^2 - 2*h^3)

curves  rings    = [for h in linspace(0, 1, 5): circle((0, 0, 90*h), radius(h))]
surface shoulder = skin(rings)
curve   profile  = shoulder(0, _)                       // the isocurve u = 0

check continuity(rings[0]).g >= 2      "the ring closes without a corner"
check max(curvature_table(profile).curvature) < 1/5mm   "no bend tighter than 5 mm"
print area(shoulder), length(profile)

export shoulder                  to "shoulder.glb" with (tolerance = 0.05)
export curvature_table(shoulder) to "shoulder.csv"
"#;

#[test]
fn columns_stay_columns() {
    check(&OPENING[1..], &OPENING[1..]);
    // A column moves when what stands before it grows.
    check("let a  =1\nlet bb =(1,2)  // x\n", "let a  = 1\nlet bb = (1, 2) // x\n");
    check(
        "check a==1    \"one\"\ncheck bb+1==1\"two\"\ncheck c==1    \"three\"\n",
        "check a == 1  \"one\"\ncheck bb + 1 == 1 \"two\"\ncheck c == 1  \"three\"\n",
    );
    // Spaces that make no column go.
    check("let   a   =  1\nlet bb = 2\n", "let a = 1\nlet bb = 2\n");
}

/// `source` in canonical form is `expected`.
#[track_caller]
fn check(source: &str, expected: &str) {
    let text = formatted(source);
    assert_eq!(text, expected, "\n{text}");
    assert_eq!(formatted(&text), expected);
}

#[test]
fn short_things_stay_on_one_line() {
    check("let  a=[1,2 ,3,]  ;let b = a+1*2 ^3", "let a = [1, 2, 3]\nlet b = a + 1*2^3\n");
    check("let b = 3/4*x-y* 2", "let b = 3/4*x - y * 2\n");
    check("let r = 0 ..n-1\nlet s = xs[1 ..-1]", "let r = 0 .. n - 1\nlet s = xs[1..-1]\n");
    check("let f = ( x,y ,) => {u: x,v}", "let f = (x, y) => {u: x, v}\n");
}

#[test]
fn numbers_and_strings_stay_as_they_are_written() {
    check("let a = 1_000.50mm + 1e-3", "let a = 1_000.50mm + 1e-3\n");
    check(r#"let a = "\u{3b1} {x  + 1}""#, "let a = \"\\u{3b1} {x  + 1}\"\n");
}

#[test]
fn long_lists_take_one_line_an_element_and_numbers_as_many_as_fit() {
    let point = "(1.25, 2.5, 3.75)";
    check(
        &format!("curve c = bezier({point}, {point}, {point}, {point}, {point}, {point})"),
        &format!("curve c = bezier(\n{})\n", format!("    {point},\n").repeat(6)),
    );
    let numbers = |n: usize| vec!["0.125"; n].join(", ");
    check(
        &format!("let knots = [{}]", numbers(20)),
        &format!("let knots = [\n    {},\n    {},\n]\n", numbers(13), numbers(7)),
    );
}

#[test]
fn blocks_and_tests_take_a_line_a_statement() {
    check("let a = {let b = 1  (b, 2)}", "let a = {\n    let b = 1\n    (b, 2)\n}\n");
    check(
        "test \"t\" {let a = 1;\n\n\ncheck a == 1 }",
        "test \"t\" {\n    let a = 1\n\n    check a == 1\n}\n",
    );
}

#[test]
fn comments_and_single_blank_lines_stay() {
    check(
        "// head\n\n\n/// docs\nlet a = 1   // tail\n/* own\n line */\nlet b = 2 /* c */ // d\n\n\n// end",
        "// head\n\n/// docs\nlet a = 1   // tail\n/* own\n line */\nlet b = 2 /* c */ // d\n\n// end\n",
    );
    check("test \"t\" { // one\n  // two\n}\n", "test \"t\" { // one\n    // two\n}\n");
    check("let a = [\n  1,   // one\n  2]\n", "let a = [\n    1,   // one\n    2,\n]\n");
    check("", "");
}

#[test]
fn a_text_with_mistakes_is_not_formatted() {
    assert_eq!(format("let a = ", &Limits::DEFAULT).unwrap_err().len(), 1);
}
