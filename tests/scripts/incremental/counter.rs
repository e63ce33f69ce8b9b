//! What is evaluated after an edit: counted inside the definitions.

use std::collections::BTreeSet;

use virote::{
    eval::{Setting, Work},
    value::Value,
};

use super::harness::{Desk, Run};

/// Documents of a hundred definitions are tried on one thread and on several.
const THREADS: [usize; 2] = [1, 4];

fn lines(n: usize, line: impl Fn(usize) -> String) -> Vec<String> {
    (0..n).map(line).collect()
}

fn names(numbers: impl IntoIterator<Item = usize>) -> BTreeSet<String> {
    numbers.into_iter().map(|i| format!("d{i}")).collect()
}

/// Runs a document, replaces one line, and runs it again: exactly `evaluated` are evaluated.
#[track_caller]
fn check_edit(
    lines: &[String],
    edited: usize,
    line: &str,
    evaluated: impl IntoIterator<Item = usize>,
) {
    let evaluated = names(evaluated);
    for n_threads in THREADS {
        let desk = Desk::new(n_threads);
        let first = desk.run(&lines.join("\n"));
        assert_eq!((first.n_calls, first.with(Work::Evaluated).len()), (lines.len(), lines.len()));

        let again = desk.run(&lines.join("\n"));
        assert_eq!((again.n_calls, again.with(Work::Reused).len()), (0, lines.len()));

        let mut after = lines.to_vec();
        line.clone_into(&mut after[edited]);
        let run = desk.run(&after.join("\n"));
        assert_eq!(run.with(Work::Evaluated), evaluated);
        assert_eq!(run.n_calls, evaluated.len());
        assert_eq!(run.with(Work::Reused).len(), lines.len() - evaluated.len());
        check_values(&run, &Desk::new(1).run(&after.join("\n")));
        assert_eq!(desk.n_remembered(), 1 + lines.len(), "the file's and one for each");
    }
}

#[track_caller]
fn check_values(run: &Run, fresh: &Run) {
    for defined in &fresh.outcome.definitions {
        assert_eq!(run.value(&defined.name), fresh.value(&defined.name), "{}", defined.name);
    }
}

#[test]
fn in_a_chain_everything_after_the_edit() {
    let chain = lines(100, |i| match i {
        0 => "let d0 = @(1)".to_owned(),
        i => format!("let d{i} = @(d{} + 1)", i - 1),
    });
    check_edit(&chain, 60, "let d60 = @(d59 + 2)", 60..100);
    check_edit(&chain, 99, "let d99 = @(d98 + 2)", [99]);
    check_edit(&chain, 0, "let d0 = @(2)", 0..100);
}

#[test]
fn of_a_fan_the_edited_blade() {
    let fan = lines(100, |i| match i {
        0 => "let d0 = @(1)".to_owned(),
        i => format!("let d{i} = @(d0 + {i})"),
    });
    check_edit(&fan, 31, "let d31 = @(d0 - 31)", [31]);
    check_edit(&fan, 0, "let d0 = @(7)", 0..100);
}

#[test]
fn of_diamonds_the_side_and_the_tips_below() {
    let diamonds = lines(100, |i| match (i, i % 3) {
        (0, _) => "let d0 = @(1)".to_owned(),
        (i, 0) => format!("let d{i} = @(d{} + d{})", i - 1, i - 2),
        (i, side) => format!("let d{i} = @(d{} * {side})", i - side),
    });
    check_edit(&diamonds, 50, "let d50 = @(d48 * 5)", [50].into_iter().chain(51..100));
    check_edit(&diamonds, 49, "let d49 = @(d48 * 5)", [49].into_iter().chain(51..100));
}

#[test]
fn of_independent_definitions_the_edited_one() {
    let independent = lines(100, |i| format!("let d{i} = @([{i}, {i}])"));
    check_edit(&independent, 42, "let d42 = @([0])", [42]);
}

#[test]
fn an_edit_of_form_evaluates_nothing() {
    let desk = Desk::new(1);
    let before = "param n = 3 in 0..9\nlet a = @([n, 2mm])\nfn f(x) = x + n\nlet b = @(f(a[0]))\n\
        let c = @([for x in a if x == n: {k: x}])";
    assert_eq!(desk.run(before).n_calls, 3);
    let after = "/// how many\nparam n = 3.0 in 0..9\n\n// moved\nlet c = @([for y in (a) if y == n: \
        { k: y }])\nlet b = /* here */ @( f( a[0] ) )\nfn f(x) =\n  x + n\nlet a =\n @([n, 2mm])";
    let run = desk.run(after);
    assert_eq!(run.n_calls, 0);
    assert_eq!(run.with(Work::Evaluated), BTreeSet::new());
    assert_eq!(run.with(Work::Renewed), BTreeSet::from(["f".to_owned()]));
}

#[test]
fn a_new_name_keeps_the_value() {
    let desk = Desk::new(1);
    desk.run("let a = @(1)  let b = @(a + 1)  let [p, q] = @([a, b])");
    let run = desk.run("let start = @(1)  let b = @(start + 1)  let [r, s] = @([start, b])");
    assert_eq!((run.n_calls, run.value("s").as_str()), (0, "2"));
}

#[test]
fn an_edited_function_evaluates_its_callers() {
    let desk = Desk::new(1);
    let functions = "fn f(x) = g(x) + 1  fn g(x) = if x <= 0 then 0 else f(x - 1)  fn h(x) = -x";
    let rest = "let a = @(f(2))  let b = @(h(2))  let c = @(a + b)  let d = @(3)";
    assert_eq!(desk.run(&format!("{functions} {rest}")).n_calls, 4);
    let run = desk.run(&format!("{} {rest}", functions.replace("+ 1", "+ 2")));
    let expected = ["f", "g", "a", "c"].map(str::to_owned);
    assert_eq!(run.with(Work::Evaluated), BTreeSet::from(expected), "both functions of the circle");
    assert_eq!((run.n_calls, run.value("a").as_str()), (2, "6"));
    // Their order in the text does not count.
    let swapped = "fn h(x) = -x  fn g(x) = if x <= 0 then 0 else f(x - 1)  fn f(x) = g(x) + 2";
    assert_eq!(desk.run(&format!("{swapped} {rest}")).n_calls, 0);
}

#[test]
fn a_value_with_functions_is_renewed_and_its_users_stay() {
    let desk = Desk::new(1);
    let text = "let a = {f: x => x + 1, v: @(1)}  let b = @(a.f(1))";
    assert_eq!(desk.run(text).n_calls, 2);
    let run = desk.run(&format!("// later\n{text}"));
    assert_eq!((run.n_calls, run.with(Work::Reused)), (1, BTreeSet::from(["b".to_owned()])));
    assert_eq!(run.with(Work::Renewed), BTreeSet::from(["a".to_owned()]));
}

#[test]
fn a_warning_is_told_again_at_its_new_place() {
    let desk = Desk::new(1);
    let text = "let a = doubtful(\"\", 1)  let b = @(a + 1)";
    assert_eq!(desk.run(text).outcome.diagnostics[0].primary.span.start, 8);
    let run = desk.run(&format!("// 67\n{text}"));
    assert_eq!(run.outcome.diagnostics.len(), 1);
    assert_eq!(run.outcome.diagnostics[0].primary.span.start, 14);
    assert_eq!((run.n_calls, run.with(Work::Renewed)), (0, BTreeSet::from(["a".to_owned()])));
}

#[test]
fn a_setting_evaluates_the_users_of_its_parameter() {
    for n_threads in THREADS {
        let mut desk = Desk::new(n_threads);
        let mut text = "param p = 1  param q = 1\n".to_owned();
        for i in 0..100 {
            text += &format!("let d{i} = @({} + {i})\n", if i % 2 == 0 { "p" } else { "q" });
        }
        desk.run(&text);
        let setting = |text: &str| {
            vec![Setting { name: "p".to_owned(), text: text.to_owned(), called: String::new() }]
        };
        desk.settings = setting("5");
        let run = desk.run(&text);
        let mut expected = names((0..100).step_by(2));
        expected.insert("p".to_owned());
        assert_eq!((run.with(Work::Evaluated), run.n_calls), (expected, 50));
        assert_eq!(run.value("d2"), "7");
        assert_eq!(desk.run(&text).n_calls, 0);
        desk.settings = setting("6");
        assert_eq!(desk.run(&text).n_calls, 50);
    }
}

/// A number of another dimension is another number.
#[test]
fn another_dimension_evaluates_the_users() {
    let desk = Desk::new(1);
    desk.run("let a = @(5mm)  let b = @(a * 1)");
    for number in ["5", "5rad", "5mm", "5mm * 1mm", "5 / 1mm"] {
        let text = format!("let a = @({number})  let b = @(a * 1)");
        let run = desk.run(&text);
        assert_eq!(
            (run.n_calls, run.value("b")),
            (2, desk.fresh().run(&text).value("b")),
            "{text}"
        );
        assert_eq!(desk.run(&text).n_calls, 0, "{text}");
    }
}

#[test]
fn another_unit_tolerance_or_ceiling_evaluates_all() {
    let mut desk = Desk::new(1);
    let text = "let a = @(1mm)  let b = @(2)";
    desk.run(text);
    assert_eq!(desk.run(&format!("unit cm {text}")).value("a"), "0.1");
    assert_eq!(desk.run(&format!("unit cm tolerance 1e-5 {text}")).n_calls, 2);
    desk.limits.list_length = 10;
    assert_eq!(desk.run(&format!("unit cm tolerance 1e-5 {text}")).n_calls, 2);
    assert_eq!(desk.run(&format!("unit cm tolerance 1e-5 {text}")).n_calls, 0);
}

#[test]
fn errors_keep_what_was_known_before_them() {
    let desk = Desk::new(1);
    let good = "let a = @(1)\nlet b = @(a + 1)\nlet c = @(b + 1)\nlet d = @(4)\n";
    assert_eq!(desk.run(good).n_calls, 4);
    for broken in ["let a = @((1", "let a = nothing", "let a = @(1) / 0", "let a = c", "let ="] {
        for _ in 0..3 {
            desk.run(&good.replace("let a = @(1)", broken));
        }
        assert_eq!(desk.run(good).n_calls, 0, "{broken}");
    }
    // What the broken states held in addition is forgotten with them.
    assert_eq!(desk.n_remembered(), 5);
}

#[test]
fn what_a_run_did_not_use_is_forgotten() {
    let desk = Desk::new(1);
    desk.run("let a = @(1)  let b = @(2)");
    desk.run("let a = @(1)");
    assert_eq!(desk.n_remembered(), 2);
    assert_eq!(desk.run("let a = @(1)  let b = @(2)").n_calls, 1);
}

#[test]
fn a_loaded_file_counts_by_its_content() {
    let mut desk = Desk::new(1);
    desk.files.0.insert("data.json".to_owned(), "[1, 2]".to_owned());
    desk.files.0.insert("other.json".to_owned(), "[7]".to_owned());
    let text = "fn read(name) = load(\"{name}.json\")\nlet a = @(read(\"data\"))\n\
        let b = @(a[0])\nlet c = @(load(\"other.json\"))";
    assert_eq!(desk.run(text).n_calls, 3);
    assert_eq!(desk.run(text).n_calls, 0);
    desk.files.0.insert("data.json".to_owned(), "[3, 2]".to_owned());
    let run = desk.run(text);
    assert_eq!((run.n_calls, run.value("b").as_str()), (2, "3"));
    desk.files.0.remove("data.json");
    assert_eq!(desk.run(text).value("b"), "nothing");
    desk.files.0.insert("data.json".to_owned(), "[3, 2]".to_owned());
    let run = desk.run(text);
    assert_eq!((run.n_calls, run.value("b").as_str()), (0, "3"));
}

#[test]
fn an_imported_file_counts_by_the_definitions_that_are_used() {
    let mut desk = Desk::new(1);
    let library = "param k = 1\nimport \"deep.geo\" (base)\nlet one = [base, k]\n\
        fn two(x) = x + base\nfn three(x) = x * k\nlet four = load(\"four.json\")";
    desk.files.0.insert("lib/part.geo".to_owned(), library.to_owned());
    desk.files.0.insert("lib/deep.geo".to_owned(), "let base = 10 let more = 1".to_owned());
    desk.files.0.insert("lib/four.json".to_owned(), "4".to_owned());
    let text = "param w = 3\nimport \"lib/part.geo\" as part with (k = w)\n\
        import \"lib/part.geo\" (one, four)\n\
        let a = @(part.one)  let b = @(part.two(1))  let c = @(part.three(2))\n\
        let d = @(one)  let e = @(four)";
    let evaluated = |desk: &Desk, text: &str| {
        let run = desk.run(text);
        check_values(&run, &desk.fresh().run(text));
        let mut names = run.with(Work::Evaluated);
        names.retain(|name| name.len() == 1);
        assert_eq!(run.n_calls, names.iter().filter(|name| *name != "w").count());
        names.into_iter().collect::<String>()
    };
    assert_eq!(evaluated(&desk, text), "abcdew");
    assert_eq!(evaluated(&desk, text), "");
    assert_eq!(evaluated(&desk, &text.replace("w = 3", "w = 4")), "acw");
    let library = library.replace("x * k", "k * x");
    desk.files.0.insert("lib/part.geo".to_owned(), format!("// three\n{library}"));
    assert_eq!(evaluated(&desk, &text.replace("w = 3", "w = 4")), "c");
    desk.files.0.insert("lib/four.json".to_owned(), "5".to_owned());
    assert_eq!(evaluated(&desk, &text.replace("w = 3", "w = 4")), "e");
    desk.files.0.insert("lib/deep.geo".to_owned(), "let base = 10 let more = 2".to_owned());
    assert_eq!(evaluated(&desk, &text.replace("w = 3", "w = 4")), "");
    desk.files.0.insert("lib/deep.geo".to_owned(), "let base = 11".to_owned());
    assert_eq!(evaluated(&desk, &text.replace("w = 3", "w = 4")), "abd");
}

#[test]
fn what_is_reused_is_the_very_value() {
    let desk = Desk::new(1);
    let list = |run: &Run| match &run.outcome.definitions[0].value {
        Some(Value::List(items)) => items.clone(),
        other => panic!("{other:?}"),
    };
    let first = list(&desk.run("let a = [1, 2]"));
    assert!(list(&desk.run("let a = [1, 2] let b = 3")).is_same(&first));
    assert!(!list(&Desk::new(1).run("let a = [1, 2]")).is_same(&first));
}

#[test]
fn equal_definitions_are_told_alike_on_every_number_of_threads() {
    let text: String = (0..100).map(|i| format!("let d{i} = @([1, 2])\n")).collect();
    for n_threads in THREADS {
        let desk = Desk::new(n_threads);
        let run = desk.run(&text);
        assert_eq!((run.n_calls, run.with(Work::Evaluated).len()), (100, 100));
        assert_eq!(desk.run(&text).with(Work::Reused).len(), 100);
    }
}

#[test]
fn functions_inside_functions_take_no_exponential_time() {
    let mut text = "0".to_owned();
    for i in 0..40 {
        text = format!(
            "{{ fn a{i}(x) = if x < 1 then {text} else b{i}(x - 1) fn b{i}(x) = a{i}(x) a{i}(0) }}"
        );
    }
    let desk = Desk::new(1);
    desk.run(&format!("let a = @({text})"));
    assert_eq!(desk.run(&format!("let a = @( {text} )")).n_calls, 0);
}

#[test]
fn a_script_that_is_called_is_evaluated_once_for_each_set_of_parameters() {
    for n_threads in THREADS {
        let mut desk = Desk::new(n_threads);
        let hull = |factor: i32| {
            format!("param b = 1\nlet wide = {factor} * b\nlet n = len(load(\"offsets.csv\").x)")
        };
        desk.files.0.insert("hull.geo".to_owned(), hull(2));
        desk.files.0.insert("offsets.csv".to_owned(), "x\n1\n2\n".to_owned());
        let text = "fn wide(b) = script(\"hull.geo\", b = b).wide\n\
            let all = @([for b in 1..3: wide(b)])\nlet rows = @(script(\"hull.geo\").n)\nlet other = @(1)";
        let first = desk.run(text);
        assert_eq!((first.n_calls, first.value("all").as_str()), (3, "[2, 4, 6]"));
        let again = desk.run(&format!("// moved\n{text}"));
        assert_eq!((again.n_calls, again.value("all").as_str()), (0, "[2, 4, 6]"));
        // The form of the file does not count, what it says does.
        desk.files.0.insert("hull.geo".to_owned(), format!("// a hull\n{}", hull(2)));
        assert_eq!(desk.run(text).n_calls, 0);
        desk.files.0.insert("hull.geo".to_owned(), hull(3));
        let edited = desk.run(text);
        assert_eq!((edited.n_calls, edited.value("all").as_str()), (2, "[3, 6, 9]"));
        // So does what the file reads.
        desk.files.0.insert("offsets.csv".to_owned(), "x\n1\n2\n3\n".to_owned());
        let read = desk.run(text);
        assert_eq!(read.value("rows"), "3");
        assert!((1..=2).contains(&read.n_calls));
    }
}
