//! What `load` and `import` make of the bytes of files: all encodings and forms, and no more memory
//! than a run may hold.

use std::{
    alloc::System,
    fmt::{self, Debug, Formatter},
    sync::{
        Mutex,
        atomic::{AtomicUsize, Ordering},
    },
};

use cap::Cap;
use virote::{
    limits::Limits,
    render,
    session::{Event, Session},
    value::Files,
};

#[global_allocator]
static MEMORY: Cap<System> = Cap::new(System, usize::MAX);

/// The most that a run was seen to hold.
static MOST_HELD: AtomicUsize = AtomicUsize::new(0);

/// What is held now, for a run that counts it.
fn held() -> usize {
    let held = MEMORY.allocated();
    MOST_HELD.fetch_max(held, Ordering::Relaxed);
    held
}

/// Tests of this file take turns, because the memory is counted for all of them.
static TURN: Mutex<()> = Mutex::new(());

/// One file, whatever its name.
struct One(Vec<u8>);

impl Debug for One {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{} bytes", self.0.len())
    }
}

impl Files for One {
    fn read(&self, _: &str, most: usize) -> Result<Vec<u8>, String> {
        Ok(self.0[..self.0.len().min(most.saturating_add(1))].to_vec())
    }
}

/// What the script prints, or its first message with its hints.
fn told(script: &str, bytes: Vec<u8>, limits: Limits) -> Result<Vec<String>, String> {
    let session = Session::new(limits).measured(held);
    let report = session.run("a.geo", script.as_bytes(), &One(bytes), &[]);
    if let Some(found) = report.diagnostics.first() {
        let hints = render::hints(found).join("; ");
        return Err(format!("{}: {} ({hints})", found.code.id(), found.message));
    }
    let printed = report.events.iter().filter_map(|event| match event {
        Event::Printed(printed) => Some(printed.value.to_string()),
        _ => None,
    });
    Ok(printed.collect())
}

/// A file of an ending, loaded; `value` says what of it is printed, `it` being all.
#[track_caller]
fn check(ending: &str, bytes: &[u8], value: &str, expected: Result<&str, &str>) {
    let _turn = TURN.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    let script = format!("let it = load(\"a.{ending}\")\nprint {value}");
    match (told(&script, bytes.to_vec(), Limits::DEFAULT), expected) {
        (Ok(printed), Ok(expected)) => assert_eq!(printed, [expected]),
        (Err(message), Err(part)) => assert!(message.contains(part), "{message}"),
        (found, expected) => assert_eq!(format!("{found:?}"), format!("{expected:?}")),
    }
}

/// The most memory that is ever held stays near a ceiling that the file's content is far above.
#[track_caller]
fn check_memory(ending: &str, text: impl FnOnce() -> String) {
    /// Lists of what is held double, and texts of few bytes take more than their length.
    const MOST: f64 = 1.25;
    let _turn = TURN.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    let bytes = text().into_bytes();
    let ceiling = MEMORY.allocated() + (24 << 20);
    let limits = Limits { memory_bytes: ceiling, ..Limits::DEFAULT };
    MOST_HELD.store(0, Ordering::Relaxed);
    let found = told(&format!("let it = load(\"a.{ending}\")"), bytes, limits);
    let message = found.expect_err("there is too much of it");
    for part in ["E0901", &format!("`a.{ending}`"), &format!("{ceiling} bytes of memory")] {
        assert!(message.contains(part), "{message}");
    }
    assert!(
        message.contains("ceiling on `memory`") && message.contains("load a part"),
        "{message}"
    );
    let most = MOST_HELD.load(Ordering::Relaxed) as f64 / ceiling as f64;
    assert!(most <= MOST, "{ending}: {most} of the ceiling");
}

#[test]
fn json_of_many_small_lists_stops_at_the_ceiling_on_memory() {
    check_memory("json", || format!("[{}[]]", "[],".repeat(1_000_000)));
    check_memory("json", || format!("[{}1]", "1,".repeat(1_000_000)));
    check_memory("json", || format!("[{}null]", "{\"a\": 1},".repeat(200_000)));
    let deep = format!("{}{}", "[".repeat(60), "]".repeat(60));
    check_memory("json", || format!("[{}[]]", format!("{deep},").repeat(10_000)));
}

#[test]
fn json_of_many_members_stops_at_the_ceiling_on_memory() {
    let members: Vec<String> = (0..300_000).map(|i| format!("\"k{i}\": 1")).collect();
    check_memory("json", || format!("{{{}}}", members.join(",")));
}

#[test]
fn a_table_of_many_cells_stops_at_the_ceiling_on_memory() {
    check_memory("csv", || format!("a,b\n{}", "1,2\n".repeat(400_000)));
    let names: Vec<String> = (0..100_000).map(|i| format!("c{i}")).collect();
    check_memory("csv", || {
        format!("{}\n{}", names.join(","), format!("1{}\n", ",1".repeat(99_999)).repeat(8))
    });
    check_memory("csv", || format!("a\n{}", "\"\"\n".repeat(600_000)));
}

#[test]
fn a_mesh_of_many_faces_stops_at_the_ceiling_on_memory() {
    let places = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    check_memory("obj", || format!("{places}{}", "f 1 2 3\n".repeat(400_000)));
    check_memory("obj", || format!("{places}f{}", " 1 2 3".repeat(400_000)));
    check_memory("obj", || "v 1 2 3\n".repeat(1_200_000));
}

#[test]
fn points_and_patches_without_end_stop_at_the_ceiling_on_memory() {
    check_memory("dat", || format!("name\n{}", "1 0\n".repeat(1_200_000)));
    check_memory("bpt", || format!("99999\n{}", "1 1 0 0 0 0 0 1 1 0 0 1 1 1\n".repeat(99_999)));
}

#[test]
fn a_file_larger_than_the_memory_that_is_left_is_not_read_to_its_end() {
    check_memory("json", || format!("\"{}\"", "x".repeat(40 << 20)));
}

#[test]
fn each_door_names_the_ceiling_that_moves_it() {
    let _turn = TURN.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    let limits = Limits { source_bytes: 100, input_bytes: 200, ..Limits::DEFAULT };
    let data = format!("[1{}]", " ".repeat(300));
    let loaded = told("let it = load(\"a.json\")", data.into_bytes(), limits);
    let message = loaded.expect_err("it is too large");
    assert!(
        message.contains("ceiling of 200 bytes") && message.contains("ceiling on `input-bytes`"),
        "{message}"
    );
    let imported = told("import \"lib.geo\" as it", vec![b' '; 101], limits);
    let message = imported.expect_err("it is too large");
    assert!(
        message.contains("ceiling of 100 bytes") && message.contains("ceiling on `source-bytes`"),
        "{message}"
    );
    let message = told(&" ".repeat(101), Vec::new(), limits).expect_err("it is too large");
    assert!(
        message.contains("ceiling of 100 bytes") && message.contains("ceiling on `source-bytes`"),
        "{message}"
    );
}

/// A text in UTF-16 with its byte-order mark.
fn utf16(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
    format!("\u{feff}{text}").encode_utf16().flat_map(bytes).collect()
}

/// A small file of each format, what of it is printed, and what that is.
const SMALL: &[(&str, &str, &str, &str)] = &[
    ("json", "[1,\n{\"a\": 2}]", "it[1].a", "2"),
    ("csv", "a;b [cm]\n1;2\n", "it.b[0]", "20"),
    ("dat", "wing\n1 0\n0 1\n-1 0\n", "it[1]", "(0, 1, 0)"),
    ("obj", "o é\nv 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n", "area(it)", "2"),
    ("bpt", "1\n1 1\n0 0 0 0 1 0\n1 0 0 1 1 0\n", "it[0](1, 1)", "(1, 1, 0)"),
];

#[test]
fn every_format_is_read_in_utf_8_and_in_both_orders_of_utf_16() {
    for &(ending, text, value, expected) in SMALL {
        check(ending, text.as_bytes(), value, Ok(expected));
        check(ending, format!("\u{feff}{text}").as_bytes(), value, Ok(expected));
        check(ending, &utf16(text, u16::to_le_bytes), value, Ok(expected));
        check(ending, &utf16(text, u16::to_be_bytes), value, Ok(expected));
    }
}

#[test]
fn bytes_that_are_no_text_are_told_with_their_line_and_the_remedy() {
    for &(ending, text, ..) in SMALL {
        let bad = |bytes: &[u8], part| check(ending, bytes, "it", Err(part));
        let n_lines = text.matches('\n').count();
        let last = format!("line {}, column", n_lines + 1);
        bad(&[text.as_bytes(), b"caf\xe9"].concat(), &last);
        bad(
            &[text.as_bytes(), b"caf\xe9"].concat(),
            "`é` in Latin-1) is not UTF-8; save the file as UTF-8",
        );
        bad(&[&[0x1f, 0x8b][..], text.as_bytes()].concat(), "packed by gzip; unpack it first");
        bad(&[text.as_bytes(), b"\0"].concat(), &last);
        let cut = utf16(text, u16::to_le_bytes);
        bad(&cut[..cut.len() - 1], "the file ends within a character of UTF-16");
    }
}

#[test]
fn lines_end_in_any_way() {
    for &(ending, text, value, expected) in SMALL {
        for end in ["\r\n", "\r"] {
            check(ending, text.replace('\n', end).as_bytes(), value, Ok(expected));
        }
    }
}

#[test]
fn forms_of_csv_that_other_programs_write_are_read() {
    let table = |text: &str, value: &str, expected: &str| {
        check("csv", text.as_bytes(), value, Ok(expected));
    };
    let texts = |rows: &str, expected: &str| {
        table(&format!("a,b\n{rows}"), "[for t in it.a: \"<{t}>\"]", expected);
    };
    texts("\"x, y\",1\n\"two\r\nlines\",2", r#"["<x, y>", "<two\u{d}\nlines>"]"#);
    texts("\"say \"\"é\"\"\",1\n\"\"\"\",2\n", r#"["<say \"é\">", "<\">"]"#);
    texts("  \" kept \"  ,1\n lost ,2", r#"["< kept >", "<lost>"]"#);
    texts("3\" pipe,1\n,2\n\"\",3\n", r#"["<3\" pipe>", "<>", "<>"]"#);
    let (long, shown) = ("é\"\"".repeat(100), "é\\\"".repeat(100));
    texts(&format!("\"{long}\",1"), &format!("[\"<{shown}>\"]"));
    // Texts that look like numbers, and numbers that are not there.
    table("a\n\"1\"\n", "it.a[0] == \"1\"", "true");
    table("a,b\n1,\n,2\n", "it.b[1]", "2");
    table("a;b\n1;\n", "len(it.b)", "1");
    // Tabulators separate, and so are no space around.
    table("a\tb\n\t 2 \n1\t\n", "it.b[0]", "2");
    // Lines without anything, and an end without a line's.
    table("\n\r\n a ; b \r\n  \r\n\r\n1;2\r\n \n3;4", "it.b", "[2, 4]");
    table("a\n1\n   ", "len(it)", "1");
}

#[test]
fn mistakes_in_csv_are_told_with_their_line() {
    let wrong = |text: &str, part: &str| check("csv", text.as_bytes(), "it", Err(part));
    wrong("", "the file is empty");
    wrong(" \r\n\n", "the file is empty");
    wrong("\na,b\r\n\"x\ny\",1\n1\n", "line 5 has 1 cell, the header has 2");
    wrong("a\r1,2,3", "line 2 has 3 cells, the header has 1");
    wrong("a,b\n1,\"x\ny\"\"\n", "line 2: the quotation mark is not closed");
    wrong("a,b\n1,\"", "line 2: the quotation mark is not closed");
    wrong("a,b\n\"x\ny\" z,1\n", "line 3: `z` follows a quotation mark");
    wrong("a,b\n\"x\"\"\" \"y\",1\n", "line 2: `\"` follows a quotation mark");
    wrong(
        "a,b\n1,2\n\n1,x\n",
        "line 4: `b` is a column of numbers, since its first cell is `2`, but here it holds `x`",
    );
    wrong(
        "a\n1\n\"2\"\n",
        "line 3: `a` is a column of numbers, since its first cell is `1`, but here it holds `2`",
    );
    wrong("a,\n1,2", "line 1: column 2 has no name");
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

#[test]
fn forms_of_obj_that_other_programs_write_are_read() {
    let area = |text: &str| check("obj", format!("{SQUARE}{text}").as_bytes(), "area(it)", Ok("1"));
    area("f 1 2 3 4");
    area("f -4 -3 -2 -1");
    area("f 1 \\\n 2 3\\\n 4\n");
    area("f 1 2 3 4 # a square\n");
    area("\tf  1 2 3 4\r\n");
    area("usemtl\nmtllib x.mtl\ns off\nl 1 2 3\np 1\nf 1 2 3 4");
    area("vt 0 0\nf 1/1 2/1 3/1 4/1\n");
    area("vn 0 0 1\nf 1//-1 2//-1 3//-1 4//-1\n");
    area("o a\nf 1 2 3\ng b\nf 1 3 4\n");
    // A corner that stands twice is one, and a face of two is none.
    area("f 1 1 2 3 3 4 4 1\n");
    let leaves_out_at = |line: usize, text: &str| {
        let told =
            format!("line {line}: the face names a vertex twice and has no area; it is left out");
        check("obj", format!("{SQUARE}{text}").as_bytes(), "area(it)", Err(&told));
    };
    leaves_out_at(5, "f 1 1 2\nf 1 2 1 3\nf 2 1 3 1\nf -4 1 2\nf 1 2 3 4\n");
    leaves_out_at(7, "vt 0 0\nvt 1 0\nf 1/1 1/2 2/1\nf 1/1 2/1 3/1 4/1\n");
    // Colours of some vertices and a weight.
    let colors = "v 0 0 0 1 0 0\nv 1 0 0\nv 2 2 0 2\nv 0 1 0 1 1 0 0\nf 1 2 3 4";
    check("obj", colors.as_bytes(), "area(it)", Ok("1"));
    // A vertex that comes after its face.
    check("obj", b"v 0 0 0\nv 2 0 0\nf 1 2 3\nv 0 2 0", "area(it)", Ok("2"));
}

#[test]
fn mistakes_in_obj_are_told_with_their_line() {
    let wrong = |text: &str, part: &str| {
        check("obj", format!("{SQUARE}{text}").as_bytes(), "it", Err(part));
    };
    wrong("f\n", "line 5: a face needs 3 corners or more, found 0");
    wrong("f 1 2 3 \\\n9 4\n", "line 5: vertex 9 does not exist; the file has 4");
    wrong("f 1 2\n", "line 5: a face needs 3 corners or more, found 2");
    wrong("f 1 2 0\n", "line 5: vertex 0 does not exist");
    wrong("f 1 2 -5\n", "line 5: vertex -5 does not exist; 4 came before");
    wrong("f 1 2 -9223372036854775808\n", "line 5: vertex -9223372036854775808 does not exist");
    wrong("f 1/-1 2/-1 3/-1\n", "line 5: texture coordinate -1 does not exist; 0 came before");
    wrong("vn 0 0 1\nf 1//9 2//1 3//1\n", "line 6: normal 9 does not exist; the file has 1");
    wrong("vt 0 0\nf 1/9223372036854775807 2/1 3/1\n", "line 6: texture coordinate");
    wrong("f 1 2 x\n", "line 5: a corner must be the number of a vertex, found `x`");
    wrong("f 1/1/1/1 2 3\n", "line 5: a corner names a vertex, a texture coordinate and a normal");
    wrong("v 1 2\n", "line 5: `v` has too few coordinates");
    wrong("v 1 2 3 4 5\nf 1 2 3", "line 5: `v` has 5 numbers");
    wrong("v 1 2 nan\nf 1 2 5", "line 5: a coordinate must be a number, found `nan`");
    wrong("l 1 2 3\n", "the file holds no triangles");
    wrong("f 1 1 2\n", "the file holds no triangles");
}

#[test]
fn names_that_stand_twice_in_one_object_of_json_are_told() {
    check("json", b"{\"a\": 1,\n\"a\": 2}", "it", Err("`a` stands twice in one object at line 2"));
}

#[test]
fn tables_written_in_one_unit_are_equal_in_another() {
    let written = "unit mm\nlet it = table({a: [1mm, 2.5m], b: [90deg, 1deg], c: [1mm^2, 3m^2], d: [\"x\", \"y\"], e: [7, 8]})\nexport it to \"it.FORMAT\"";
    let claims = "check len(it) == 2 and it.a[0] ~= 1mm and it.a[1] ~= 2.5m and it.b[0] ~= 90deg and it.c[1] ~= 3m^2 and it.d[1] == \"y\" and it.e[0] == 7";
    for (format, which) in [("csv", ""), ("json", ".it")] {
        let session = Session::new(Limits::DEFAULT);
        let script = written.replace("FORMAT", format);
        let report = session.run("a.geo", script.as_bytes(), &One(Vec::new()), &[]);
        let [Event::File(file)] = &report.events[..] else { panic!("{:?}", report.diagnostics) };
        let mut bytes = Vec::new();
        (file.format.write)(&file.job, &mut bytes).expect("it is written");
        for unit in ["mm", "m", "in", "um"] {
            let script = format!("unit {unit}\nlet it = load(\"it.{format}\"){which}\n{claims}");
            let report = session.run("b.geo", script.as_bytes(), &One(bytes.clone()), &[]);
            assert!(report.diagnostics.is_empty(), "{unit}: {:?}", report.diagnostics);
        }
    }
}

#[test]
fn numbers_of_json_that_may_be_lengths_of_another_unit_are_told() {
    let turn = TURN.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    for values in [
        "{\"a\": 40}",
        "{\"a\": [{\"b\": 1}]}",
        "{\"a\": {\"virote\": \"point\", \"xyz\": [1, 2, 3]}}",
    ] {
        let file = format!("{{\"virote\": \"document\", \"unit\": \"mm\", \"values\": {values}}}");
        let found = told("unit m\nprint load(\"a.json\")", file.into_bytes(), Limits::DEFAULT);
        let message = found.expect_err("it is told");
        assert!(message.contains("W0001: the file was written in mm"), "{message}");
    }
    drop(turn);
    let file = b"{\"virote\": \"document\", \"unit\": \"in\", \"values\": {\"a\": true, \"b\": {\"virote\": \"angle\", \"radians\": 1}}}";
    check("json", file, "it.a", Ok("true"));
}

#[test]
fn lengths_and_angles_of_a_table_come_in_the_units_of_its_header() {
    // Under the default unit, mm.
    let table = "a [m],b [deg]\n1,90\n";
    check("csv", table.as_bytes(), "it.a[0]", Ok("1000"));
    check("csv", table.as_bytes(), "[it.a[0] == 1m, it.b[0] == 90deg]", Ok("[true, true]"));
    check("csv", table.as_bytes(), "sin(it.b[0])", Ok("1"));
}

#[test]
fn an_angle_from_a_file_says_how_it_gets_its_unit() {
    check("json", b"{\"turn\": 30}", "rotate((1, 0), it.turn)", Err("`* 1deg`"));
    check(
        "json",
        b"{\"turn\": 30}",
        "rotate((1, 0), it.turn * 1deg) ~= (cos(30deg), sin(30deg), 0)",
        Ok("true"),
    );
}
