//! Printing and parsing undo each other; formatting changes nothing but the look.

use proptest::prelude::{ProptestConfig, proptest};

use virote::limits::Limits;
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

#[test]
fn real_scripts_survive_printing_and_formatting() {
    for (name, source) in scripts() {
        let tree = parse_clean(&source);
        let printed = print(&tree);
        assert_eq!(shape(&parse_clean(&printed)), shape(&tree), "{name}\n{printed}");
        let text = formatted(&source);
        assert_eq!(shape(&parse_clean(&text)), shape(&tree), "{name}\n{text}");
        assert_eq!(formatted(&text), text, "{name}");
        assert_eq!(text.matches("//").count(), source.matches("//").count(), "{name}: comments");
    }
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
    check("let  a=[1,2 ,3,]  ;let b = a+1*2^3", "let a = [1, 2, 3]\nlet b = a + 1 * 2^3\n");
    check("let r = 0 ..n-1\nlet s = xs[1 ..-1]", "let r = 0 .. n - 1\nlet s = xs[1..-1]\n");
    check("let f = ( x ) => {u: x,v}", "let f = x => {u: x, v}\n");
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
        &format!("curve c = bezier(\n{})\n", format!("  {point},\n").repeat(6)),
    );
    let numbers = |n: usize| vec!["0.125"; n].join(", ");
    check(
        &format!("let knots = [{}]", numbers(20)),
        &format!("let knots = [\n  {},\n  {},\n]\n", numbers(13), numbers(7)),
    );
}

#[test]
fn blocks_and_tests_take_a_line_a_statement() {
    check("let a = {let b = 1  (b, 2)}", "let a = {\n  let b = 1\n  (b, 2)\n}\n");
    check(
        "test \"t\" {let a = 1;\n\n\ncheck a == 1 }",
        "test \"t\" {\n  let a = 1\n\n  check a == 1\n}\n",
    );
}

#[test]
fn comments_and_single_blank_lines_stay() {
    check(
        "// head\n\n\n/// docs\nlet a = 1   // tail\n/* own\n line */\nlet b = 2 /* c */ // d\n\n\n// end",
        "// head\n\n/// docs\nlet a = 1  // tail\n/* own\n line */\nlet b = 2  /* c */  // d\n\n// end\n",
    );
    check("test \"t\" { // one\n  // two\n}\n", "test \"t\" {\n  // one\n  // two\n}\n");
    check("let a = [\n  1,   // one\n  2]", "let a = [\n  1,   // one\n  2]\n");
    check("", "");
}

#[test]
fn a_text_with_mistakes_is_not_formatted() {
    assert_eq!(format("let a = ", &Limits::DEFAULT).unwrap_err().len(), 1);
}
