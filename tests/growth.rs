//! No shape of a script takes quadratic time: each is doubled twice, and what is counted may grow
//! with it and its logarithm, not with its square.
//!
//! Counted are the bytes that are allocated, which sees what is copied again and again, and the steps
//! of the evaluator and of searches (`limits::work`), which sees what is looked through again and
//! again. Neither depends on the machine.

use std::{
    alloc::System,
    fmt::Write as _,
    sync::{Mutex, PoisonError},
};

use stats_alloc::StatsAlloc;
use virote::{
    export::FORMATS,
    limits::{Limits, work},
    session::{Event, Session},
    value::Files,
};

#[global_allocator]
static MEMORY: StatsAlloc<System> = StatsAlloc::system();

/// Tests of this file take turns, because the memory is counted for all of them.
static TURN: Mutex<()> = Mutex::new(());

/// Bytes that count as one step.
const BYTES_A_STEP: u64 = 64;

/// From one doubling to the next the growth may grow by this factor: 2 for n, 2.2 for n log n, 4 for
/// n².
const MOST: f64 = 2.7;

/// The parts of a script: what stands once before, what is repeated with `#` for the number and what
/// stands between two, and what stands behind. There `@` is the number of repetitions.
type Shape = (&'static str, &'static str, &'static str, &'static str, &'static str);

const SHAPES: &[Shape] = &[
    // Text and tokens.
    ("stray characters in a row", "let a = 1\n", "$$$$", "", ""),
    ("stray characters apart", "let a = 1\n", "$", " ", ""),
    ("a long name misspelt", "let a", "bcdefghi", "", " = 1\nprint b"),
    ("comments", "", "// #", "\n", ""),
    ("comments inside one another", "", "/*", "", ""),
    (
        "a report",
        "export report to \"o.md\" with (picture = false)\n",
        "param p# = 3mm /// # Chapter #\ncheck p# < 5mm\nprint p#, \"text #\"\nexport table({a: [1]}) to \"t#.csv\"",
        "\n",
        "",
    ),
    ("documentation", "", "/// #", "\n", "\nlet a = 1"),
    ("comments inside a list", "let a = [\n", "#, // #", "\n", "\n]"),
    ("strings that are never closed", "", "let a# = \"abc", "\n", ""),
    ("a string of wide letters", "let a = \"", "漢", "", "\"; let b = q"),
    ("wide letters before mistakes", "", "let a# = \"漢\" + q", "; ", ""),
    ("a string of escapes", "let a = \"", "\\n", "", "\""),
    ("a string of inserted values", "let x = 1\nprint \"", "{x}", "", "\""),
    ("digits", "let a = 1", "0_0", "", ""),
    ("empty lines", "let a = 1", "\n", "", ""),
    ("semicolons", "", ";", "", ""),
    // Brackets.
    ("round brackets that open", "let a = ", "(", "", ""),
    ("square brackets that open", "let a = ", "[", "", ""),
    ("braces that open", "let a = ", "{", "", ""),
    ("round brackets that close", "let a = ", ")", "", ""),
    ("square brackets that close", "let a = ", "]", "", ""),
    ("braces that close", "let a = ", "}", "", ""),
    ("brackets of all kinds that open", "let a = ", "([{", "", ""),
    ("brackets that do not match", "let a = ", "(]", "", ""),
    ("brackets that match crosswise", "let a = ", "([)]", "", ""),
    ("pairs of brackets", "let a = [", "(#)", ", ", "]"),
    ("strings that open inside strings", "let a = ", "\"{", "", ""),
    // Definitions.
    ("definitions", "", "let a# = #", "\n", ""),
    ("definitions of what is not there", "", "let a# = b#", "\n", ""),
    ("definitions of one name", "", "let a = #", "\n", ""),
    ("definitions without a name", "", "let = #", "\n", ""),
    ("definitions without a value", "", "let a# =", "\n", ""),
    ("definitions without a keyword", "", "a# = #", "\n", ""),
    ("definitions on one line", "", "let a# = #", "; ", ""),
    ("mistakes on one line", "", "let a# = q", "; ", ""),
    ("functions", "", "fn f#(x) = x + #", "\n", ""),
    ("parameters of the script", "", "param p# = # in 0..1000000", "\n", ""),
    ("points", "", "point p# = (#, 1)", "\n", ""),
    (
        "lines with colours and layers",
        "",
        "curve c# = line((0, 0), (#, 1)) with (color = \"#0000ff\", layer = \"l#\")",
        "\n",
        "",
    ),
    ("definitions of a block", "let y = {\n", "let a# = #", "\n", "\n1 }"),
    (
        "definitions of a block in a block",
        "let y = { let z = {\n",
        "let a# = # + a0",
        "\n",
        "\n1 } z }",
    ),
    ("functions of a block", "let y = {\n", "fn f#(x) = x", "\n", "\n1 }"),
    (
        "functions of a block that use one another",
        "let y = {\nfn g(x) = x\n",
        "fn f#(x) = f(g(x))",
        "\n",
        "\nfn f(x) = f0(x)\n1 }",
    ),
    ("names around a function", "let y = {\n", "let a# = #", "\n", "\nlet f = x => a0 + x\nf(1) }"),
    ("one name twice in a block", "let y = {\n", "let a = #", "\n", "\n1 }"),
    ("parameters of a function", "let f = (", "a#", ", ", ") => 1"),
    ("parameters of one name", "let f = (", "a", ", ", ") => 1"),
    ("parameters with defaults", "fn f(", "a# = #", ", ", ") = 1\nprint f()"),
    // Lists and records.
    ("a list", "let a = [", "#", ", ", "]"),
    ("a list of texts", "let a = [", "\"#\"", ", ", "]\nprint a"),
    ("a list of points", "let a = [", "(#, 1)", ", ", "]"),
    ("mistakes in a list", "let a = [", "q", ", ", "]"),
    ("a list spread again and again", "let b = [1]\nlet a = [", "...b", ", ", "]"),
    ("a record", "let r = {", "f#: #", ", ", "}"),
    (
        "fields of a large record that are not there",
        "let r = {",
        "f#: #",
        ", ",
        "}\nprint r.g, r.h",
    ),
    ("a record with one label", "let r = {", "f: #", ", ", "}"),
    ("records that are equal", "let r = {", "f#: #", ", ", "}\ncheck r == r\ncheck r ~= {...r}"),
    ("a pattern of names", "let [", "a#", ", ", "] = [1, 2]"),
    ("a comprehension", "let a = [for i in 1..@: i]\n", "", "", "print len(a)"),
    (
        "steps through a list",
        "let a = [for i in 0..@: i]\nlet b = [for i in 0..@: a[i]]\n",
        "",
        "",
        "",
    ),
    // Operators and calls.
    ("calls", "let f = x => x\n", "print f(#)", "\n", ""),
    ("a call with labels that are not there", "let f = (x) => x\nlet y = f(", "l# = 1", ", ", ")"),
    ("an operation with labels that are not there", "let y = line(", "l# = 1", ", ", ")"),
    ("a call with too many arguments", "let f = (x) => x\nlet y = f(", "#", ", ", ")"),
    ("a call with too few arguments", "let f = (", "a#", ", ", ") => 1\nlet y = f()"),
    ("fields that are not there", "let r = {a: 1, b: 2}\n", "let g# = r.g#", "\n", ""),
    ("fields of a number", "", "let g# = 1.0.x", "\n", ""),
    ("kinds that do not fit", "", "let g# = 1 + \"a\"", "\n", ""),
    // Statements.
    ("checks", "", "check # == #", "\n", ""),
    ("checks that fail", "", "check # == 0.5", "\n", ""),
    ("prints", "", "print #", "\n", ""),
    ("tests", "", "test \"t#\" { check # == # }", "\n", ""),
    ("tests of one name", "", "test \"t\" { check # == # }", "\n", ""),
    ("imports that are not there", "", "import \"p#.geo\" as p#", "\n", ""),
    ("imports of one name", "", "import \"p.geo\" as p", "\n", ""),
    ("files", "curve c = line((0, 0), (1, 1))\n", "export c to \"o#.obj\"", "\n", ""),
    ("files of one name", "curve c = line((0, 0), (1, 1))\n", "export c to \"o.obj\"", "\n", ""),
    (
        "one thing many times in a file",
        "curve c = line((0, 0), (1, 1))\nexport ",
        "c",
        ", ",
        " to \"o.obj\"",
    ),
    ("things without a name in a file", "export ", "line((0, 0), (#, 1))", ", ", " to \"o.obj\""),
    (
        "all of many things",
        "",
        "curve c# = line((0, 0), (#, 1))",
        "\n",
        "\nexport all to \"o.step\"",
    ),
    (
        "all of many things without a name",
        "",
        "curve line((0, 0), (#, 1))",
        "\n",
        "\nexport all to \"o.step\"",
    ),
    (
        "options that are not there",
        "curve c = line((0, 0), (1, 1))\nexport c to \"o.obj\" with (",
        "o# = 1",
        ", ",
        ")",
    ),
    // Operations on lists.
    ("a list that grows by `fold`", "let a = fold(1..@, [], (b, i) => [...b, i])\n", "", "", ""),
    (
        "a list with a name in a block that grows by `fold`",
        "fn more(b) = [...b, 0]\nlet a = fold(1..@, [], (b, i) => { let c = [...b, i]\nmore(c) })\n",
        "",
        "",
        "",
    ),
    (
        "a list of points that grows by `fold`",
        "let a = fold(1..@, [], (b, i) => if i % 3 == 0 then b else { let p = (i, i)\n[...b, p, p] })\n",
        "",
        "",
        "",
    ),
    ("`unique` of numbers", "let a = unique([for i in 1..@: i])\n", "", "", ""),
    ("`unique` of lengths", "let a = unique([for i in 1..@: i * 1mm])\n", "", "", ""),
    ("`unique` of lists", "let a = unique([for i in 1..@: [i, 2]])\n", "", "", ""),
    ("`unique` of records", "let a = unique([for i in 1..@: {b: i}])\n", "", "", ""),
    ("`unique` of texts", "let a = unique([for i in 1..@: \"{i}\"])\n", "", "", ""),
    ("`unique` of curves", "let a = unique([for i in 1..@: line((0, 0), (i, 1))])\n", "", "", ""),
    ("`sort`", "let a = sort([for i in 1..@: sin(i)])\n", "", "", ""),
    ("`flatten`", "let a = flatten([for i in 1..@: [i]])\n", "", "", ""),
    ("`transpose`", "let a = transpose([for i in 1..@: [i, 2]])\n", "", "", ""),
    ("`zip`", "let a = zip([for i in 1..@: i], [for i in 1..@: i])\n", "", "", ""),
    ("`map` and `filter`", "let a = filter(map(1..@, x => x + 1), x => x > 2)\n", "", "", ""),
    ("`scan`", "let a = scan(1..@, 0, (a, x) => a + x)\n", "", "", ""),
    // Geometry.
    ("a polyline", "let a = polyline([for i in 0..@: (i, i % 2)])\n", "", "", ""),
    (
        "the length of a polyline",
        "print length(polyline([for i in 0..@: (i, i % 2)]))\n",
        "",
        "",
        "",
    ),
    (
        "`join`",
        "let a = join([for i in 0..@: line((i, i % 2), (i + 1, (i + 1) % 2))])\n",
        "",
        "",
        "",
    ),
    ("`bounds` of a list", "let a = bounds([for i in 0..@: line((i, 0), (i, 1))])\n", "", "", ""),
    ("`interpolate`", "let a = interpolate([for i in 0..@: (i, sin(i))])\n", "", "", ""),
    (
        "`intersect` of a polyline with a line that it never meets",
        "let a = intersect(polyline([for i in 0..@: (i, i % 2)]), line((0, 2), (@, 2)))\n",
        "",
        "",
        "",
    ),
    (
        "`intersect` of two polylines beside one another",
        "let a = intersect(polyline([for i in 0..@: (i, i % 2)]), \
         polyline([for i in 0..@: (i, i % 2 + 3)]))\n",
        "",
        "",
        "",
    ),
    (
        "`intersect` of two polylines that cross in each step",
        "let a = intersect(polyline([for i in 0..@: (i, i % 2)]), \
         polyline([for i in 0..@: (i, 0.7 - i % 2)]))\n",
        "",
        "",
        "",
    ),
    (
        "`intersect` of a polyline with a line that it touches in each second corner",
        "let a = intersect(polyline([for i in 0..@: (i, i % 2)]), line((-1, 1), (@ + 1, 1)))\n",
        "",
        "",
        "",
    ),
    (
        "`intersect` of a wave with a line",
        "let a = intersect(interpolate([for i in 0..@: (i, i % 2)]), line((-1, 0.5), (@ + 1, 0.5)))\n",
        "",
        "",
        "",
    ),
    (
        "`intersect` of arcs that each touch a line",
        "let a = intersect(bspline([(0, 1), ...flatten([for i in 1..@: [(2 * i - 1, -1), (2 * i, 1)]])], degree = 2, \
         knots = [0, ...flatten([for i in 0..@: [i, i]]), @]), line((-1, 0), (2 * @ + 1, 0)))\n",
        "",
        "",
        "",
    ),
    (
        "the length of a wave",
        "print length(interpolate([for i in 0..@: (i, i % 2)]))\n",
        "",
        "",
        "",
    ),
    (
        "`divide` of a polyline",
        "let a = divide(polyline([for i in 0..@: (i, i % 2)]), 10)\n",
        "",
        "",
        "",
    ),
    (
        "`parameter_at_length` of a spline",
        "let c = interpolate([for i in 0..@: (i/10, sin(i), cos(i/3))])\nlet a = parameter_at_length(c, 3)\n",
        "",
        "",
        "",
    ),
    ("`divide` into many parts", "let a = divide(circle((0, 0), 1), @)\n", "", "", ""),
    // Files that are read.
    ("imports of many files", "", "import \"leaf#.geo\" as p#", "\n", ""),
    ("definitions of an imported file", "import \"wide@.geo\" as p\nprint p.a0\n", "", "", ""),
    ("imports with many parameters", "", "import \"door.geo\" as p# with (w = #)", "\n", ""),
    ("numbers of JSON", "print len(load(\"numbers@.json\"))\n", "", "", ""),
    ("members of JSON", "let a = load(\"members@.json\")\n", "", "", ""),
    ("objects of JSON", "let a = load(\"objects@.json\")\n", "", "", ""),
    ("rows of CSV", "let a = load(\"rows@.csv\")\n", "", "", ""),
    ("columns of CSV", "let a = load(\"columns@.csv\")\n", "", "", ""),
    ("faces of OBJ", "let a = load(\"faces@.obj\")\n", "", "", ""),
    ("one face of OBJ", "let a = load(\"face@.obj\")\n", "", "", ""),
    ("files that are loaded", "", "let a# = load(\"one#.json\")", "\n", ""),
    // What grows by copying.
    ("a sum by `fold`", "let all = fold(1..@, 0, (a, x) => a + x)\n", "", "", ""),
    (
        "a face with corners on a parabola",
        "let a = mesh([...[for i in 1..@: (i / @, (i / @)^2)], (0.5, 0.9), (0, 0.5)], \
         [[for i in 0..@ + 1: i]])\n",
        "",
        "",
        "",
    ),
    (
        "a face that is a star",
        "let a = mesh([for i in 1..2 * @: (cos(i * 180deg / @), (1.3 - 0.3 * (i % 2)) * sin(i * 180deg / @))], \
         [[for i in 0..2 * @ - 1: i]])\n",
        "",
        "",
        "",
    ),
    (
        "a face whose sides lie above one another",
        "let a = mesh([(0, 0), ...[for i in 1..@: (1 + (i % 2) / 1000, i / @)]], [[for i in 0..@: i]])\n",
        "",
        "",
        "",
    ),
    (
        "a comb as a face",
        "let a = mesh([...flatten([for i in 1..@: [(2 * i, 0), (2 * i, 9), (2 * i + 1, 9), (2 * i + 1, 0)]]), \
         (2 * @ + 1, -1), (2, -1)], [[for i in 0..4 * @ + 1: i]])\n",
        "",
        "",
        "",
    ),
    (
        "a region with many holes",
        "let a = planar_mesh([polyline([(0, 0), (@ + 1, 0), (@ + 1, 2), (0, 2)], closed = true), \
         ...[for i in 1..@: polyline([(i, 1), (i + 0.5, 1), (i, 1.5)], closed = true)]])\n",
        "",
        "",
        "",
    ),
    (
        "a region of many corners",
        "let a = region(polyline([for i in 0..<@: polar(10, i * 360deg / @)], closed = true))\n",
        "",
        "",
        "",
    ),
    (
        "`union` of many discs",
        "let a = union([for i in 0..<@: region(circle((i % 10, floor(i / 10)), 0.6))])\n",
        "",
        "",
        "",
    ),
    (
        "holes cut into a plate",
        "let a = difference([region(polyline([(-1, -1), (10, -1), (10, @), (-1, @)], closed = true)), \
         ...[for i in 0..<@: region(circle((i % 10, floor(i / 10)), 0.3))]])\n",
        "",
        "",
        "",
    ),
    ("`helix`", "let a = helix((0, 0), 1, 1, @)\n", "", "", ""),
];

/// Things that are written in each format: once many of them, then one of many parts.
const EXPORTED: &[(&str, &str)] = &[
    ("many points", "[for i in 1..@: (i, i % 7)]"),
    ("many lines", "[for i in 1..@: line((i, 0), (i, 1))]"),
    ("a long polyline", "polyline([for i in 0..@: (i, i % 2)])"),
    ("a long spline", "interpolate([for i in 0..@: (i, i % 2)])"),
    ("many patches", "[for i in 1..@: plane_patch((i, 0), (0.5, 0), (0, 1))]"),
    ("a mesh", "grid_mesh(plane_patch((0, 0), (9, 0), (0, 1)), @, 1)"),
    ("many meshes", "[for i in 1..@: mesh([(i, 0), (i + 0.5, 0), (i, 1)], [[0, 1, 2]])]"),
    ("a table", "table({a: [for i in 1..@: i]})"),
];

/// Files whose names tell what they hold, and how much of it.
#[derive(Debug)]
struct MadeFiles;

impl Files for MadeFiles {
    fn read(&self, path: &str, _: usize) -> Result<Vec<u8>, String> {
        let missing = || format!("there is no `{path}`");
        let (name, ending) = path.rsplit_once('.').ok_or_else(missing)?;
        let kind = name.trim_end_matches(|c: char| c.is_ascii_digit());
        let n: usize = name[kind.len()..].parse().unwrap_or(0);
        let each = |part: &str, between: &str| {
            (0..n).map(|i| part.replace('#', &i.to_string())).collect::<Vec<_>>().join(between)
        };
        let text = match (kind, ending) {
            ("leaf", _) => "let a = 1".to_owned(),
            ("wide", _) => each("let a# = #", "\n"),
            ("door", _) => "param w = 1\nlet a = w + 1".to_owned(),
            ("one", _) => "[1]".to_owned(),
            ("numbers", _) => format!("[{}]", each("#", ",")),
            ("members", _) => format!("{{{}}}", each("\"k#\": #", ",")),
            ("objects", _) => format!("[{}]", each("{\"k\": #}", ",")),
            ("rows", _) => format!("a,b\n{}\n", each("#,1", "\n")),
            ("columns", _) => format!("{}\n{}\n", each("c#", ","), each("#", ",")),
            ("faces", _) => format!("{}\n{}", each("v # 0 0\nv # 1 0", "\n"), strip(n)),
            ("face", _) => format!("{}\nf {}\n", ring(n), each("#", " ").replacen("0 ", "", 1)),
            _ => return Err(missing()),
        };
        Ok(text.into_bytes())
    }
}

/// Faces between two rows of vertices.
fn strip(n: usize) -> String {
    (1..n).map(|i| 2 * i).map(|i| format!("f {} {} {} {}\n", i - 1, i + 1, i + 2, i)).collect()
}

/// Vertices on a circle.
fn ring(n: usize) -> String {
    let angle = |i: usize| std::f64::consts::TAU * i as f64 / n as f64;
    let vertex = |i: usize| format!("v {} {} 0\n", libm::cos(angle(i)), libm::sin(angle(i)));
    (0..n).map(vertex).collect()
}

/// The script of a shape.
fn script((_, before, repeated, between, behind): Shape, n: usize) -> String {
    let mut text = before.replace('@', &n.to_string());
    if !repeated.is_empty() {
        let parts = (0..n).map(|i| repeated.replace('#', &i.to_string()));
        text.push_str(&parts.collect::<Vec<_>>().join(between));
    }
    text + &behind.replace('@', &n.to_string())
}

/// Runs a script in each way in which it can be run, and counts.
fn counted(text: &str) -> u64 {
    let (bytes, steps) = (MEMORY.stats().bytes_allocated, work::counted());
    let session = Session::new(Limits::DEFAULT);
    let report = session.run("a.geo", text.as_bytes(), &MadeFiles, &[]);
    let mut said = String::new();
    for diagnostic in report.diagnostics.iter().take(Limits::DEFAULT.diagnostics) {
        said += &virote::render::picture(diagnostic, &report.sources, false);
    }
    for event in &report.events {
        if let Event::File(file) = event {
            let mut written = Vec::new();
            let outcome = file.write(&mut written);
            let _ = write!(said, "{}", outcome.is_ok());
        }
    }
    let _ = session.format("a.geo", text.as_bytes());
    let _ = session.graph("a.geo", text.as_bytes(), &MadeFiles);
    let _ = session.parameters("a.geo", text.as_bytes(), &MadeFiles);
    (MEMORY.stats().bytes_allocated - bytes) as u64 / BYTES_A_STEP + work::counted() - steps
}

/// How often a shape is repeated at first.
const FIRST: usize = 400;

/// What grows by fewer steps than these for each repetition is growth of buffers: a square is a
/// hundred times more.
const FEW: usize = 16;

/// What was counted, where it grows faster than the script.
fn complaint(shape: Shape) -> Option<String> {
    grown(shape.0, |n| counted(&script(shape, n)))
}

/// What was counted for so many repetitions and twice and four times as many, where it grows faster
/// than these.
fn grown(name: &str, counted: impl Fn(usize) -> u64) -> Option<String> {
    let [a, b, c] = [1, 2, 4].map(|times| counted(FIRST * times));
    let (before, after) = (b.saturating_sub(a), c.saturating_sub(b));
    let is_fast = (FEW * FIRST) as u64 <= after && MOST * before as f64 <= after as f64;
    is_fast.then(|| format!("{name}: {a}, {b}, {c}"))
}

#[test]
fn what_is_doubled_takes_twice_the_work() {
    let _turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    // Whatever is made once is made before.
    counted("print 1");
    let square = ("a square", "let a = [for i in 1..@: len([for j in 1..@: j + i])]", "", "", "");
    assert!(complaint(square).is_some(), "what grows with the square is seen");
    let complaints: Vec<String> = SHAPES.iter().copied().filter_map(complaint).collect();
    assert!(
        complaints.is_empty(),
        "these grow faster than they are long:\n{}",
        complaints.join("\n")
    );
}

#[test]
fn twice_as_much_takes_twice_the_work_to_write() {
    let _turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    counted("print 1");
    let mut complaints = Vec::new();
    for format in FORMATS {
        for (name, expression) in EXPORTED {
            let name = format!("{name} to `.{}`", format.ending);
            let before = format!("let a = {expression}\nexport a to \"o.{}\"\n", format.ending);
            let of = |n: usize| counted(&before.replace('@', &n.to_string()));
            complaints.extend(grown(&name, of));
        }
    }
    assert!(
        complaints.is_empty(),
        "these grow faster than what they hold:\n{}",
        complaints.join("\n")
    );
}

#[test]
fn one_more_entry_of_a_prompt_takes_work_in_proportion_to_the_document() {
    let _turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    let session = Session::new(Limits::DEFAULT).incremental();
    let complaint = grown("a document that an incremental session knows", |n| {
        let text: String = (0..n).map(|i| format!("let a{i} = {i}\n")).collect();
        let _ = session.run("a.geo", text.as_bytes(), &MadeFiles, &[]);
        let (bytes, steps) = (MEMORY.stats().bytes_allocated, work::counted());
        let _ = session.run("a.geo", format!("{text}let b = 1").as_bytes(), &MadeFiles, &[]);
        (MEMORY.stats().bytes_allocated - bytes) as u64 / BYTES_A_STEP + work::counted() - steps
    });
    assert_eq!(complaint, None);
}
