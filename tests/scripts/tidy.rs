//! Rules of the house that a compiler does not check: floors, guests, small numbers, words.

use std::{fs, path::Path};

use virote::ops;

/// A row of the table of floors in `ARCHITECTURE.md`: a module, and those that it may use; none where
/// it may use all.
struct Floor {
    module: String,
    may_use: Option<Vec<String>>,
}

/// The table of floors, as the map of the house has it.
fn floors() -> Vec<Floor> {
    let map = fs::read_to_string("ARCHITECTURE.md").expect("the map");
    let named = |cell: &str| -> Vec<String> {
        cell.split('`').skip(1).step_by(2).map(str::to_owned).collect()
    };
    let rows = map.lines().filter(|line| line.starts_with("| F"));
    let floors = rows.flat_map(|row| {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
        let may_use = (cells[3] != "all below").then(|| named(cells[3]));
        named(cells[1]).into_iter().map(move |module| Floor { module, may_use: may_use.clone() })
    });
    floors.collect()
}

/// The doors, which talk to the world.
const DOORS: &[&str] = &["cli", "disk", "lsp", "main", "study", "view", "lib"];

/// The kernel is a package of its own: what it may use, its manifest says.
const PACKAGE: &str = "kernel";

/// Libraries that are guests of a few files only.
const GUESTS: &[(&str, &[&str])] = &[
    (
        "logos",
        &[
            "src/language/syntax/lexer.rs",
            "src/language/syntax/block_comment.rs",
            "src/language/syntax/token.rs",
        ],
    ),
    ("chumsky", &["src/language/syntax/parser/"]),
    ("ariadne", &["src/render.rs"]),
    ("clap", &["src/cli/"]),
    ("clap_complete", &["src/cli/args.rs", "src/cli/shell.rs"]),
    ("clap_mangen", &["src/cli/shell.rs"]),
    ("ctrlc", &["src/cli/interrupt.rs"]),
    ("rustyline", &["src/cli/repl/editor.rs"]),
    ("cap", &["src/main.rs"]),
    ("indicatif", &["src/cli/progress.rs"]),
    ("lsp_server", &["src/lsp/"]),
    ("lsp_types", &["src/lsp/"]),
    ("crossbeam_channel", &["src/lsp/"]),
    ("parquet", &["src/study/plan_file.rs", "src/study/typed_columns.rs"]),
    // Two folders have a module of that name.
    (
        "csv",
        &["src/study/plan_file.rs", "src/language/export/mod.rs", "src/language/ops/mesh/load.rs"],
    ),
    ("csv_core", &["src/language/ops/mesh/csv_rows.rs"]),
    ("png", &["src/language/export/raster/mod.rs", "src/language/export/raster/contact.rs"]),
    ("tobj", &["src/language/ops/mesh/obj.rs"]),
    (
        "ryu",
        &[
            "src/language/export/text.rs",
            "src/language/syntax/print/flat.rs",
            "src/language/value/number.rs",
        ],
    ),
    ("serde", &["src/language/export/json.rs", "src/lsp/", "src/language/value/read_json.rs"]),
    ("manifold_rust", &["src/kernel/mesh/manifold_body.rs"]),
    ("spade", &["src/kernel/mesh/triangulation.rs"]),
];

/// What nothing but the doors may do.
const DOORS_ONLY: &[&str] =
    &["println!", "print!(", "eprintln!", "eprint!(", "dbg!", "std::fs", "std::env", "std::time"];

/// What no script may reach.
const PANICS: &[&str] = &[".unwrap()", ".expect(", "panic!(", "todo!(", "unimplemented!("];

/// Built-ins whose names are words of the language as well (a keyword, a kind of parameter, a field
/// of what another built-in answers) or a habit of other languages that the parser knows.
const WORDS_TOO: &[&str] =
    &["table", "length", "assert", "scale", "region", "regions", "report", "solid", "faces"];

/// Where a small number may be written, and why.
const SMALL_NUMBERS: &[(&str, &str)] = &[
    ("src/kernel/tolerance/", "their home"),
    ("src/kernel/numeric/gauss_legendre.rs", "nodes and weights of mathematics"),
    ("src/kernel/numeric/dormand_prince.rs", "coefficients of a method"),
    ("src/kernel/digits.rs", "from where on numbers are written with a power of ten"),
    ("src/language/syntax/ast.rs", "what a unit is worth in another"),
    ("src/language/export/gltf/mod.rs", "the curve of sRGB"),
    ("src/language/export/legend.rs", "the layout of a picture"),
    ("src/language/export/raster/scene.rs", "the layout of a picture"),
    ("src/language/export/mod.rs", "the width of a stroke"),
    ("src/language/session/extra.rs", "the shape of an arrow"),
];

/// Lines of one file, without the examples in its docs.
const MOST_LINES: usize = 400;

/// Files that are longer and may only shrink: take a file out of here when it is split.
const LONG: &[(&str, usize)] = &[("src/language/syntax/ast.rs", 500)];

/// A source file without its tests: its path, and its lines without comments and strings.
struct Source {
    path: String,
    text: String,
    code: Vec<String>,
}

impl Source {
    /// The lines of code with their numbers.
    fn lines(&self) -> impl Iterator<Item = (usize, &str)> {
        self.code.iter().enumerate().map(|(i, line)| (i + 1, line.as_str()))
    }

    fn module(&self) -> &str {
        let below = self.path.trim_start_matches("src/").trim_start_matches("language/");
        below.split('/').next().unwrap_or_default().trim_end_matches(".rs")
    }
}

pub(crate) fn visit(folder: &Path, found: &mut Vec<String>) {
    let mut entries: Vec<_> = fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
        .collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            visit(&path, found);
        } else if path.extension().is_some_and(|ext| ext == "rs") {
            found.push(path.to_str().expect("UTF-8").to_owned());
        }
    }
}

fn sources() -> Vec<Source> {
    let mut paths = Vec::new();
    visit(Path::new("src"), &mut paths);
    let read = |path: String| {
        let text = fs::read_to_string(&path).expect("UTF-8");
        let is_test = path.ends_with("/tests.rs");
        let code = if is_test { Vec::new() } else { code(&text) };
        Source { code, path, text }
    };
    paths.into_iter().map(read).collect()
}

/// The lines up to the tests, without comments and without what stands in strings.
fn code(text: &str) -> Vec<String> {
    let before_tests = text.split("#[cfg(test)]").next().unwrap_or_default();
    let mut is_in_string = false;
    before_tests.lines().map(|line| strip(line, &mut is_in_string)).collect()
}

/// A line without comment and strings; `is_in_string` goes on to the next line.
pub(crate) fn strip(line: &str, is_in_string: &mut bool) -> String {
    let mut out = String::new();
    let mut chars = line.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '\\' if *is_in_string => {
                chars.next();
            }
            '"' => {
                *is_in_string = !*is_in_string;
                out.push('"');
            }
            _ if *is_in_string => {}
            // A quotation mark as a character is no string.
            '\'' if chars.clone().take(2).eq("\"'".chars()) => {
                chars.nth(1);
            }
            '/' if chars.peek() == Some(&'/') => break,
            c => out.push(c),
        }
    }
    out
}

/// Fails with everything that is wrong.
#[track_caller]
fn report(complaints: &[String]) {
    assert!(complaints.is_empty(), "{}\n({} in all)", complaints.join("\n"), complaints.len());
}

/// Collects complaints about lines of code.
#[track_caller]
fn each_line(complaint: impl Fn(&Source, &str) -> Option<String>) {
    let mut complaints = Vec::new();
    for source in sources() {
        for (n, line) in source.lines() {
            complaints.extend(
                complaint(&source, line).map(|text| format!("{}:{n}: {text}", source.path)),
            );
        }
    }
    report(&complaints);
}

/// Modules named right after `crate::`, single or in a brace list.
fn used_modules(code: &str) -> Vec<String> {
    let name = |text: &str| {
        text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>()
    };
    let mut used = Vec::new();
    for (at, _) in code.match_indices("crate::") {
        // Visibility is no use.
        if code[..at].trim_end_matches('$').ends_with("pub(in ") {
            continue;
        }
        let rest = &code[at + "crate::".len()..];
        let Some(list) = rest.strip_prefix('{') else {
            used.push(name(rest));
            continue;
        };
        let (mut depth, mut is_start) = (0, true);
        for (i, c) in list.char_indices() {
            match c {
                '{' => depth += 1,
                '}' if depth == 0 => break,
                '}' => depth -= 1,
                ',' if depth == 0 => is_start = true,
                c if is_start && c.is_alphabetic() => {
                    used.push(name(&list[i..]));
                    is_start = false;
                }
                _ => {}
            }
        }
    }
    used
}

#[test]
fn imports_are_understood() {
    assert_eq!(used_modules("use crate::diag::Code; $crate::value::Op"), ["diag", "value"]);
    assert_eq!(
        used_modules("use crate::{\n diag::{self, Code},\n value, kernel::*,\n};"),
        ["diag", "value", "kernel"]
    );
    let mut open = false;
    assert_eq!(strip(r#"a("1e-9 // x", '"') // crate::cli"#, &mut open), r#"a("", ) "#);
}

#[test]
fn modules_use_only_lower_floors() {
    let (floors, mut complaints) = (floors(), Vec::new());
    for source in sources() {
        let module = source.module();
        if matches!(module, PACKAGE | "main" | "lib") {
            continue;
        }
        let Some(floor) = floors.iter().find(|floor| floor.module == module) else {
            complaints.push(format!("{}: `{module}` has no floor in ARCHITECTURE.md", source.path));
            continue;
        };
        let Some(may_use) = &floor.may_use else { continue };
        for used in used_modules(&source.code.join("\n")) {
            if used != module && !may_use.contains(&used) {
                complaints.push(format!("{}: `{module}` must not use `{used}`", source.path));
            }
        }
    }
    assert!(floors.len() > 10, "the table was read");
    report(&complaints);
}

#[test]
fn libraries_stay_in_their_own_files() {
    each_line(|source, line| {
        let mut guests = GUESTS.iter();
        let (guest, homes) = guests.find(|(guest, _)| line.contains(&format!("{guest}::")))?;
        let is_home = homes.iter().any(|home| source.path.starts_with(home));
        (!is_home).then(|| format!("`{guest}` belongs to {}", homes.join(", ")))
    });
}

#[test]
fn small_numbers_live_in_one_file() {
    each_line(|source, line| {
        let may = |(path, _): &(&str, &str)| source.path.starts_with(path);
        let small = small_number(line)?;
        (!SMALL_NUMBERS.iter().any(may))
            .then(|| format!("`{small}`, a small number, belongs to kernel/tolerance"))
    });
}

/// The first small number in a line of code, in whichever notation: a decimal, a quotient, a negative
/// power, or the last bit.
fn small_number(code: &str) -> Option<String> {
    const LARGEST: f64 = 0.1;
    const POWERS: &[&str] = &["powi(", "powf(", "pow(", "exp2(", "exp10(", "ldexp("];
    if code.contains("EPSILON") {
        return Some("EPSILON".to_owned());
    }
    let arguments = |at: usize| code[at..].split(')').next().unwrap_or_default();
    let is_negative = |argument: &str| {
        argument.trim().strip_prefix('-').is_some_and(|rest| rest.starts_with(char::is_numeric))
    };
    for power in POWERS {
        for (at, _) in code.match_indices(power) {
            let arguments = arguments(at + power.len());
            if arguments.split(',').next_back().is_some_and(is_negative) {
                return Some(format!("{power}{arguments})"));
            }
        }
    }
    let numbers = numbers(code);
    let is_small = |value: f64| 0.0 < value && value < LARGEST;
    let alone = numbers.iter().find(|number| number.is_float && is_small(number.value));
    let quotient = numbers.windows(2).find(|pair| {
        let is_divided = code[pair[0].place.end..pair[1].place.start].trim() == "/";
        is_divided && pair.iter().all(|n| n.is_float) && is_small(pair[0].value / pair[1].value)
    });
    let text = |start: usize, end: usize| code[start..end].to_owned();
    alone
        .map(|number| text(number.place.start, number.place.end))
        .or_else(|| quotient.map(|pair| text(pair[0].place.start, pair[1].place.end)))
}

/// A number as it is written.
struct Written {
    place: std::ops::Range<usize>,
    value: f64,
    is_float: bool,
}

/// All decimal numbers in a line of code.
fn numbers(code: &str) -> Vec<Written> {
    let bytes = code.as_bytes();
    let digits = |mut i: usize| {
        while bytes.get(i).is_some_and(|b| b.is_ascii_digit() || *b == b'_') {
            i += 1;
        }
        i
    };
    let (mut found, mut i) = (Vec::new(), 0);
    while i < bytes.len() {
        let is_inside =
            i > 0 && (bytes[i - 1].is_ascii_alphanumeric() || b"_.".contains(&bytes[i - 1]));
        // The end of a range is a number, a field of a tuple is none.
        let is_end_of_range = i > 1 && &bytes[i - 2..i] == b"..";
        if !bytes[i].is_ascii_digit() || is_inside && !is_end_of_range {
            i += 1;
            continue;
        }
        let (start, mut is_float) = (i, false);
        i = digits(i);
        let follows = |i: usize, wanted: fn(&u8) -> bool| bytes.get(i).is_some_and(wanted);
        if follows(i, |b| *b == b'.')
            && !follows(i + 1, |b| b.is_ascii_alphabetic() || b"._".contains(b))
        {
            (i, is_float) = (digits(i + 1), true);
        }
        if follows(i, |b| b"eE".contains(b)) {
            let sign = i + 1 + usize::from(follows(i + 1, |b| b"+-".contains(b)));
            if follows(sign, u8::is_ascii_digit) {
                (i, is_float) = (digits(sign), true);
            }
        }
        let text = code[start..i].replace('_', "");
        if code[i..].starts_with("f64") {
            (i, is_float) = (i + "f64".len(), true);
        }
        found.extend(text.parse().ok().map(|value| Written { place: start..i, value, is_float }));
    }
    found
}

#[test]
fn small_numbers_are_seen_in_every_notation() {
    let small = [
        "x <= 0.01",
        "1e-3",
        "1.0e-3",
        "1E-3_f64",
        "2.5_e-4",
        "0.000_1",
        "1_f64 / 1000.0",
        "1.0 / 16.0",
        "f64::powi(10, -3)",
        "10_f64.powi(-3)",
        "libm::pow(10.0, -3.0)",
        "libm::exp10(-3.0)",
        "(0.001..1.0)",
        "0.5..0.05",
        "f64::EPSILON",
        "-0.02",
        "libm::ldexp(1.0, -20)",
    ];
    for line in small {
        assert!(small_number(line).is_some(), "{line}");
    }
    let plain = [
        "0.5",
        "0.1",
        "0.0",
        "1.0 / 3.0",
        "pair.0.01",
        "x1e",
        "0x1e-3",
        "100.0",
        "1e3",
        "1.0e+3",
        "0..10",
        "a.0 - 1",
        "x.powi(3)",
        "libm::pow(x, 2.0)",
        "3 / 64",
        "1.0 - 25.0",
        "i - 0",
    ];
    for line in plain {
        assert_eq!(small_number(line), None, "{line}");
    }
}

#[test]
fn only_doors_touch_the_world() {
    each_line(|source, line| {
        let what = DOORS_ONLY.iter().find(|what| line.contains(**what))?;
        (!DOORS.contains(&source.module()))
            .then(|| format!("`{what}` belongs to the doors: {}", DOORS.join(", ")))
    });
}

#[test]
fn nothing_panics() {
    each_line(|_, line| {
        PANICS
            .iter()
            .find(|what| line.contains(**what))
            .map(|what| format!("`{what}` could be reached"))
    });
}

#[test]
fn files_open_with_what_they_are_for() {
    let silent = sources().into_iter().filter(|source| !source.text.starts_with("//! "));
    report(
        &silent
            .map(|source| format!("{}: begin with a module doc", source.path))
            .collect::<Vec<_>>(),
    );
}

#[test]
fn files_are_short() {
    let most = |path: &str| {
        LONG.iter().find(|(long, _)| *long == path).map_or(MOST_LINES, |&(_, most)| most)
    };
    let long = sources().into_iter().filter(|source| most(&source.path) < length(&source.text));
    report(
        &long
            .map(|source| format!("{}: {} lines", source.path, length(&source.text)))
            .collect::<Vec<_>>(),
    );
}

/// How many lines there are without those of examples in docs, which are tests.
fn length(text: &str) -> usize {
    let mut is_in_example = false;
    let is_counted = |line: &&str| {
        let doc = line.trim_start().strip_prefix("///").map(str::trim_start);
        let is_fence = doc.is_some_and(|doc| doc.starts_with("```"));
        is_in_example ^= is_fence;
        !(is_in_example || is_fence)
    };
    text.lines().filter(is_counted).count()
}

#[test]
fn built_ins_are_named_in_their_own_files_only() {
    let registry = ops::registry();
    let names: Vec<String> = registry
        .iter()
        .map(|op| op.name)
        .filter(|name| name.len() > 4 && !WORDS_TOO.contains(name))
        .map(|name| format!("\"{name}\""))
        .collect();
    let mut complaints = Vec::new();
    for source in sources() {
        if !matches!(source.module(), "eval" | "syntax" | "session" | "docs") {
            continue;
        }
        let before_tests = source.text.split("#[cfg(test)]").next().unwrap_or_default();
        for (i, line) in before_tests.lines().enumerate() {
            complaints.extend(
                names
                    .iter()
                    .filter(|name| line.contains(*name))
                    .map(|name| format!("{}:{}: {name}", source.path, i + 1)),
            );
        }
    }
    report(&complaints);
}

#[test]
fn no_word_is_out_of_place() {
    // Put together here, so that this file does not hold them.
    let words = [["/wo", "rk/"], ["/ro", "ot/"], ["TO", "DO"], ["FIX", "ME"], ["crates", ".io"]]
        .map(|parts| parts.concat());
    let Ok(listed) = std::process::Command::new("git").args(["ls-files", "-z"]).output() else {
        return;
    };
    let listed = String::from_utf8_lossy(&listed.stdout).into_owned();
    let mut complaints = Vec::new();
    for path in listed.split('\0').filter(|path| !path.is_empty() && !path.ends_with("Cargo.lock"))
    {
        let Ok(bytes) = fs::read(path) else { continue };
        let text = String::from_utf8_lossy(&bytes);
        for (i, line) in text.lines().enumerate() {
            let found = words.iter().find(|word| line.contains(word.as_str()));
            complaints.extend(found.map(|word| format!("{path}:{}: {word}", i + 1)));
        }
    }
    report(&complaints);
}
