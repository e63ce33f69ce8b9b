//! Nothing breaks the parser: no bytes, no torn scripts, no depth. It never takes long.

use std::time::{Duration, Instant};

use proptest::prelude::{Just, ProptestConfig, Strategy, any, prop_oneof, proptest};
use proptest::{collection, sample};

use virote::diag::Diagnostic;
use virote::syntax::{KEYWORDS, print};

use super::{parse, parse_clean};

const TOUR: &str = include_str!("scripts/tour.geo");

/// Far more than any of the scripts here needs.
const PATIENCE: Duration = Duration::from_secs(20);

/// Texts of at most so many bytes are looked into.
const SHORT: usize = 2_000;

/// `source` is read to the end: with places inside of the text, in order, and without `Error`
/// nodes that nobody tells of.
#[track_caller]
fn check(source: &str) -> Vec<Diagnostic> {
    let start = Instant::now();
    let (tree, diagnostics) = parse(source);
    let places = || diagnostics.iter().map(|diagnostic| diagnostic.primary.span);
    assert!(places().is_sorted(), "{source}");
    for label in diagnostics.iter().flat_map(|d| d.others.iter().chain([&d.primary])) {
        assert!(source.get(label.span.range()).is_some(), "{source}\n{label:?}");
    }
    let printed = print(&tree);
    if diagnostics.is_empty() {
        parse_clean(&printed);
    }
    // Debugging text recurses without mercy.
    if diagnostics.is_empty() && source.len() < SHORT {
        assert!(!format!("{tree:?}").contains("kind: Error"), "{source}");
    }
    assert!(start.elapsed() < PATIENCE, "{:?}", start.elapsed());
    diagnostics
}

fn token() -> impl Strategy<Value = String> {
    let marks = "( ) [ ] { } , : ; . .. ..< ... = => |> == != < <= > >= ~= + - * / % ^ _ \" // /* */ ° ! && # ' “ ?";
    let marks: Vec<&str> = marks.split(' ').collect();
    prop_oneof![
        4 => sample::select(marks).prop_map(str::to_owned),
        4 => sample::select(KEYWORDS).prop_map(str::to_owned),
        2 => sample::select(vec!["a", "xs", "f", "all", "step", "expect", "error", "Point", "ß"])
            .prop_map(str::to_owned),
        2 => sample::select(vec!["1", "2.5mm", "1e9", "10mn", "\"text\"", "\"a {x} b\"", "\"{", "}\""])
            .prop_map(str::to_owned),
        2 => Just("\n".to_owned()),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1_000, ..ProptestConfig::default() })]

    #[test]
    fn any_text_is_read(text in ".*") {
        check(&text);
    }

    #[test]
    fn any_bytes_that_are_text_are_read(bytes in collection::vec(any::<u8>(), 0..200)) {
        check(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn any_tokens_are_read(tokens in collection::vec((token(), any::<bool>()), 0..60)) {
        let text: String =
            tokens.into_iter().map(|(token, space)| token + if space { " " } else { "" }).collect();
        check(&text);
    }
}

#[test]
fn every_prefix_of_a_script_is_read() {
    for (end, _) in TOUR.char_indices() {
        check(&TOUR[..end]);
    }
}

/// The places of the words, marks and white space of a script.
fn pieces(source: &str) -> Vec<&str> {
    let mut pieces = Vec::new();
    let mut rest = source;
    while let Some(first) = rest.chars().next() {
        let is_word = |c: char| c.is_alphanumeric() || c == '_';
        let len = match rest.find(|c: char| is_word(c) != is_word(first)) {
            Some(len) if is_word(first) => len,
            None if is_word(first) => rest.len(),
            _ => first.len_utf8(),
        };
        let (piece, behind) = rest.split_at(len);
        pieces.push(piece);
        rest = behind;
    }
    pieces
}

#[test]
fn a_script_with_a_piece_lost_doubled_or_swapped_is_read() {
    let whole = pieces(TOUR);
    for at in 0..whole.len() {
        let mut lost = whole.clone();
        lost.remove(at);
        check(&lost.concat());
        let mut doubled = whole.clone();
        doubled.insert(at, whole[at]);
        check(&doubled.concat());
        let mut swapped = whole.clone();
        swapped.swap(at, (at + 1).min(whole.len() - 1));
        check(&swapped.concat());
    }
}

/// `source` is refused with exactly one complaint, of this code.
#[track_caller]
fn check_refused(source: &str, code: &str) {
    let codes: Vec<&str> = check(source).iter().map(|diagnostic| diagnostic.code.id()).collect();
    assert_eq!(codes, [code]);
}

/// The script `let x = left left ... 1 right right ...`
fn wrapped(left: &str, right: &str, times: usize) -> String {
    format!("let x = {}1{}\n", left.repeat(times), right.repeat(times))
}

const MANY: usize = 100_000;

#[test]
fn depth_beyond_reason_is_refused() {
    for (left, right) in [
        ("(", ")"),
        ("[", "]"),
        ("{a: ", "}"),
        ("{ let a = ", " 1}"),
        ("f(", ")"),
        ("\"{", "}\""),
        ("-", ""),
        ("- ", ""),
        ("not ", ""),
        ("if a then b else ", ""),
        ("if ", ""),
        ("x => ", ""),
        ("(x, y) => ", ""),
        ("let => ", ""),
        ("1^", ""),
        ("1^-", ""),
        ("[for i in xs: ", "]"),
    ] {
        check_refused(&wrapped(left, right, MANY), "E0104");
    }
}

#[test]
fn length_beyond_reason_is_refused() {
    check_refused(&wrapped("1+", "", 1_000_000), "E0104");
    for link in ["*1", " |> f(x)", ".x", " or a", "..1", "(1)", "[1]"] {
        check_refused(&format!("let x = f{}", link.repeat(MANY)), "E0104");
    }
}

#[test]
fn a_deep_statement_hides_no_other() {
    let source = wrapped("(", ")", MANY) + "crve c = 2";
    let codes: Vec<&str> = check(&source).iter().map(|diagnostic| diagnostic.code.id()).collect();
    assert_eq!(codes, ["E0104", "E0101"]);
}

#[test]
fn brackets_without_end_are_one_mistake() {
    for bracket in ["(", "[", "{", "f("] {
        check_refused(&format!("let x = {}", bracket.repeat(MANY)), "E0102");
    }
    check_refused(&"test \"a\" {".repeat(MANY), "E0102");
    check_refused(&"/*".repeat(MANY), "E0003");
    assert!(check(&format!("{}{}", "/*".repeat(MANY), "*/".repeat(MANY))).is_empty());
}

#[test]
fn many_blocks_without_end_take_no_longer_than_a_few() {
    check(&("let a = {\n".repeat(200) + &"let b = 1\n".repeat(MANY)));
    check(&"let a = {\n".repeat(MANY));
}

#[test]
fn brackets_in_any_disorder_take_no_longer_than_in_order() {
    for (left, right) in [
        ("(", "]"),
        ("{", ")"),
        ("([{", ")"),
        ("{(", "]}"),
        ("{ a(", "\nlet a = }"),
        ("\"{(", "}\""),
    ] {
        check(&format!("{}{}", left.repeat(MANY), right.repeat(MANY)));
    }
}

/// Bytes that the main thread of a program has.
const MAIN_STACK: usize = 8 << 20;

#[test]
fn depth_within_reason_is_read() {
    let reader = std::thread::Builder::new().stack_size(MAIN_STACK).spawn(read_all_depths);
    reader.expect("a thread").join().expect("what is nested is read");
}

fn read_all_depths() {
    for (left, right, times) in [
        ("(", ")", 250),
        ("{ let a = ", " 1}", 120),
        ("\"{", "}\"", 250),
        ("if a then b else ", "", 250),
        ("x => ", "", 250),
        ("1 or 1 and 1 == 1 .. 1 + 1 * f(", ")", 250),
    ] {
        let source = wrapped(left, right, times);
        assert!(check(&source).is_empty(), "{left}");
    }
    let sum: String = (0..600).map(|i| format!(" + {i} * x^{i} * -x")).collect();
    assert!(check(&format!("let x = 1{sum}")).is_empty());
    assert!(check(&format!("let x = 1{}", "+1".repeat(3_990))).is_empty());
    assert!(check(&format!("let x = [{}]", "-1^2, not a, ".repeat(MANY))).is_empty());
}
