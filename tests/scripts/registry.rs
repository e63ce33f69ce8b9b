//! Questions to the registry: what must hold for every built-in operation and constant.

use virote::{
    diag::{Diagnostic, Severity, Span},
    docs,
    eval::Setting,
    limits::Limits,
    ops,
    session::{Event, Report, Session},
    syntax,
    value::{Call, Files, Op, OpParameter, Type, choose},
};

/// The files that examples may read.
#[derive(Debug)]
struct Points;

impl Files for Points {
    fn read(&self, path: &str, _: usize) -> Result<Vec<u8>, String> {
        match path {
            "points.csv" => Ok(b"x,y\n0,0\n1,2\n4,3\n".to_vec()),
            "ring.geo" => Ok(b"param radius = 10mm\ncurve rim = circle((0, 0), radius)\n".to_vec()),
            _ => Err(format!("cannot read `{path}`: there is no such file")),
        }
    }
}

fn run(script: &str) -> Report {
    let settings: &[Setting] = &[];
    Session::default().run("example.geo", script.as_bytes(), &Points, settings)
}

/// Fails with everything that is wrong.
#[track_caller]
fn report(complaints: &[String]) {
    assert!(complaints.is_empty(), "{}\n({} in all)", complaints.join("\n"), complaints.len());
}

/// Asks a question about every operation; the answer is what is wrong.
#[track_caller]
fn ask(question: impl Fn(&Op) -> Option<String>) {
    let registry = ops::registry();
    let answer = |op| question(op).map(|text| format!("{}: {text}", op.name));
    report(&registry.iter().filter_map(answer).collect::<Vec<_>>());
}

/// Asks a question about every parameter of every operation.
#[track_caller]
fn ask_params(question: impl Fn(&OpParameter) -> Option<String>) {
    ask(|op| {
        op.params
            .iter()
            .find_map(|param| question(param).map(|text| format!("`{}` {text}", param.name)))
    });
}

/// Whether a script can call something of this name; a keyword such as `table` can be called too.
fn is_identifier(name: &str) -> bool {
    let source = format!("let a = {name}(1)");
    let (tree, diagnostics) = syntax::parse(&source, &Limits::DEFAULT);
    let is_word = name.chars().all(|c| c.is_alphanumeric() || c == '_');
    is_word && diagnostics.is_empty() && tree.statements.len() == 1
}

#[test]
fn names_are_identifiers() {
    ask(|op| {
        let names = std::iter::once(&op.name).chain(op.aliases);
        names
            .copied()
            .find(|name| !is_identifier(name))
            .map(|name| format!("`{name}` cannot be written in a script"))
    });
    for constant in ops::registry().constants() {
        assert!(is_identifier(constant.name), "{}", constant.name);
    }
}

#[test]
fn names_mean_one_thing() {
    let registry = ops::registry();
    for constant in registry.constants() {
        assert!(registry.get(constant.name).is_none(), "{} is an operation too", constant.name);
    }
    // An alias must not lead to other operations than the name.
    let behind = |name: &str| -> Vec<*const Op> {
        let found = registry.get(name).map(|(_, ops)| ops.iter());
        found.into_iter().flatten().map(|op| std::ptr::from_ref(*op)).collect()
    };
    ask(|op| {
        let is_wrong = |alias: &&&str| **alias == op.name || behind(alias) != behind(op.name);
        op.aliases.iter().find(is_wrong).map(|alias| format!("has the alias `{alias}`"))
    });
    ask(|op| (!behind(op.name).contains(&std::ptr::from_ref(op))).then(|| "is lost".to_owned()));
}

#[test]
fn documentation_begins_with_a_sentence() {
    ask(|op| {
        let first = op.docs.trim().split("\n \n").next().unwrap_or_default();
        let first = first.split("\n\n").next().unwrap_or_default().trim();
        let starts = first.starts_with(|c: char| c.is_uppercase() || c.is_numeric() || c == '`');
        (!starts || !first.ends_with('.'))
            .then(|| format!("the first paragraph is no sentence: {first:?}"))
    });
    ask(|op| (op.summary().is_empty()).then(|| "has no summary".to_owned()));
}

#[test]
fn parameters_are_documented() {
    ask_params(|param| param.docs.trim().is_empty().then(|| "has no documentation".to_owned()));
    ask_params(|param| (!param.docs.trim().ends_with('.')).then(|| "has no full stop".to_owned()));
}

#[test]
fn required_parameters_stand_first() {
    ask(|op| {
        let optional = op.params.iter().map(OpParameter::may_be_left_out);
        (!optional.is_sorted())
            .then(|| format!("a required parameter follows an optional one: {}", op.signature()))
    });
}

#[test]
fn parameters_have_different_labels() {
    ask(|op| {
        let mut names: Vec<&str> = op.params.iter().map(|param| param.name).collect();
        names.sort_unstable();
        (!names.is_sorted_by(|a, b| a < b))
            .then(|| format!("a label stands twice: {}", op.signature()))
    });
}

#[test]
fn defaults_are_of_their_type() {
    ask_params(|param| {
        let default = param.default?();
        (!param.ty.accepts(&default))
            .then(|| format!("is {} by default, but {} is wanted", default, param.ty.phrase()))
    });
}

#[test]
fn defaults_can_be_written_in_a_script() {
    ask_params(|param| {
        let default = param.default?();
        let outcome = run(&format!("print {default}"));
        match &outcome.events[..] {
            [Event::Printed(printed)] if printed.value.to_string() == default.to_string() => None,
            _ => Some(format!("has the default {default}, which does not read back")),
        }
    });
}

/// Elements of a list stand loose only as the first arguments; any further list needs its brackets.
#[test]
fn loose_elements_stand_for_the_first_parameter_alone() {
    for (whole, loose) in [
        (
            "hermite([(0, 0), (2, 0)], [(1, 1), (1, -1)])",
            "hermite([(0, 0), (2, 0)], (1, 1), (1, -1))",
        ),
        (
            "cubic_spline([(0, 0), (1, 1), (2, 0)], [(1, 1), (1, -1)])",
            "cubic_spline([(0, 0), (1, 1), (2, 0)], (1, 1), (1, -1))",
        ),
        (
            "continue_bezier(line((0, 0), (1, 0)), 0, [(2, 1), (3, 0)])",
            "continue_bezier(line((0, 0), (1, 0)), 0, (2, 1), (3, 0))",
        ),
    ] {
        assert!(run(&format!("curve c = {whole}")).diagnostics.is_empty(), "{whole}");
        let codes: Vec<_> =
            run(&format!("curve c = {loose}")).diagnostics.iter().map(|d| d.code.id()).collect();
        assert_eq!(codes, ["E0401"], "{loose}");
    }
}

/// Whether a value could be of both types.
fn overlap(a: Type, b: Type) -> bool {
    match (a, b) {
        (Type::Any, _) | (_, Type::Any) => true,
        (Type::OneOf(types), other) | (other, Type::OneOf(types)) => {
            types.iter().any(|of| overlap(*of, other))
        }
        // `[]` is a list of anything, but elements tell lists apart.
        (Type::List(x, _), Type::List(y, _)) => overlap(*x, *y),
        (Type::Grid(x), Type::Grid(y)) => overlap(*x, *y),
        (Type::Grid(x), Type::List(y, _)) | (Type::List(y, _), Type::Grid(x)) => {
            overlap(Type::List(x, 0), *y)
        }
        (Type::Geometry, Type::Point | Type::Curve | Type::Surface | Type::Mesh | Type::Plane)
        | (Type::Point | Type::Curve | Type::Surface | Type::Mesh | Type::Plane, Type::Geometry) => {
            true
        }
        (Type::Function, Type::Curve | Type::Surface)
        | (Type::Curve | Type::Surface, Type::Function) => true,
        (x, y) if is_number(x) && is_number(y) => true,
        (x, y) => x == y,
    }
}

fn is_number(of: Type) -> bool {
    matches!(
        of,
        Type::Number | Type::Ratio | Type::Count | Type::Integer | Type::Length | Type::Angle
    )
}

#[test]
fn operations_of_one_name_differ_in_their_first_parameter_or_in_what_they_need() {
    let registry = ops::registry();
    let mut complaints = Vec::new();
    for name in registry.names() {
        let Some((_, ops)) = registry.get(name) else { continue };
        for (i, a) in ops.iter().enumerate() {
            for b in &ops[i + 1..] {
                let (Some(first_a), Some(first_b)) = (a.params.first(), b.params.first()) else {
                    complaints.push(format!("{name}: one of several takes no argument"));
                    continue;
                };
                // Elements may stand as the arguments: then the first one is compared.
                let variants = |param: &OpParameter| match param.ty {
                    Type::List(of, _) if param.spreads => vec![param.ty, *of],
                    ty => vec![ty],
                };
                let clash = variants(first_a)
                    .into_iter()
                    .any(|x| variants(first_b).into_iter().any(|y| overlap(x, y)));
                let are_all_required =
                    a.params.iter().chain(b.params).all(|param| !param.may_be_left_out());
                let differ_in_count = are_all_required && a.params.len() != b.params.len();
                // What one needs has no place in the other, by position or by name.
                let needs_more = |one: &Op, other: &Op| {
                    let needed = || one.params.iter().filter(|param| !param.may_be_left_out());
                    let by_position =
                        |param: &&OpParameter| !param.may_be_left_out() || param.by_position;
                    let places = other.params.iter().filter(by_position).count();
                    let has = |name: &str| other.params.iter().any(|param| param.name == name);
                    places < needed().count() && needed().any(|param| !has(param.name))
                };
                let differ_in_needs = needs_more(a, b) || needs_more(b, a);
                if clash && !differ_in_count && !differ_in_needs {
                    complaints.push(format!(
                        "{name}: {} and {} cannot be told apart",
                        a.signature(),
                        b.signature()
                    ));
                }
            }
        }
    }
    report(&complaints);
}

#[test]
fn without_arguments_some_operation_is_chosen() {
    let registry = ops::registry();
    for name in registry.names() {
        if let Some((_, ops)) = registry.get(name) {
            let call = Call { span: Span::default(), positional: Vec::new(), named: Vec::new() };
            assert!(choose(ops, None, &call).is_ok(), "{name}");
        }
    }
}

#[test]
fn examples_print_what_they_declare() {
    ask(|op| {
        if op.examples.is_empty() {
            return Some("has no example".to_owned());
        }
        op.examples.iter().find_map(|example| {
            let outcome = run(&format!("print {}\n", example.code));
            let found = match &outcome.events[..] {
                [Event::Printed(printed)] if outcome.diagnostics.is_empty() => {
                    printed.value.to_string()
                }
                _ => {
                    let messages: Vec<&str> =
                        outcome.diagnostics.iter().map(|found| found.message.as_str()).collect();
                    format!("an error: {}", messages.join("; "))
                }
            };
            (found != example.prints).then(|| {
                format!("`{}` prints\n    {found}\nnot\n    {}", example.code, example.prints)
            })
        })
    });
}

#[test]
fn misuse_is_refused_as_declared() {
    ask(|op| {
        op.refusals.iter().find_map(|refusal| {
            let outcome = run(&format!("print {}\n", refusal.code));
            let told = |found: &Diagnostic| format!("{}: {}", found.code.id(), found.message);
            // What warns beside an error is not what the operation says.
            let (errors, warnings): (Vec<&Diagnostic>, Vec<&Diagnostic>) =
                outcome.diagnostics.iter().partition(|found| found.severity == Severity::Error);
            let found = if errors.is_empty() { warnings } else { errors };
            let found: Vec<String> = found.into_iter().map(told).collect();
            (found != [refusal.says]).then(|| {
                format!("`{}` says\n    {found:?}\nnot\n    {}", refusal.code, refusal.says)
            })
        })
    });
}

#[test]
fn the_reference_has_every_operation() {
    let registry = ops::registry();
    let reference = docs::reference(&registry);
    let overview = docs::overview(&registry);
    ask(|op| {
        let is_there = reference.contains(&format!("### `{}`", op.name))
            && reference.contains(&op.signature());
        (!is_there).then(|| "is not in the reference".to_owned())
    });
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let all = words(&overview);
    ask(|op| {
        let line = format!("{} {}", op.name, words(op.summary()));
        (!all.contains(&line)).then(|| "is not in the overview".to_owned())
    });
    assert!(overview.lines().all(|line| line.chars().count() <= 90), "{overview}");
    for name in registry.names() {
        assert!(docs::entry(&registry, name).is_some(), "`virote doc {name}` knows nothing");
    }
}

#[test]
fn the_reference_on_the_disk_is_up_to_date() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/reference.md");
    let expected = docs::reference(&ops::registry());
    let found = std::fs::read_to_string(path).unwrap_or_default();
    if std::env::var_os("VIROTE_BLESS").is_some() {
        std::fs::write(path, expected).expect("the reference can be written");
    } else {
        assert!(
            found == expected,
            "docs/reference.md is out of date: VIROTE_BLESS=1 cargo test --test scripts registry rewrites it"
        );
    }
}

#[test]
fn every_keyword_is_told_by_the_language() {
    for word in virote::syntax::KEYWORDS {
        assert!(virote::docs::language::entry(word).is_some(), "`{word}`");
    }
}

#[test]
fn what_the_language_is_asked_for_is_told() {
    use virote::docs::language::entry;

    let words =
        ["units", "range", "operators", "golden", "kinds", "tolerance", "|>", "..<", "~=", "color"];
    for word in words {
        assert!(entry(word).is_some(), "`{word}`");
    }
    assert_eq!(entry("qqq"), None);
    assert!(entry("param").is_some_and(|text| text.contains("### Parameters")));
}
