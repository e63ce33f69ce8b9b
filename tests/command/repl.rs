//! `virote repl`: entries from a pipe, and keystroke by keystroke at a terminal of its own.

use std::{
    io::{Read, Write},
    process::{Command, Stdio},
    thread,
};

use crate::support::{Scratch, folder, programs, told, virote};

/// What the prompt says to entries from a pipe: standard output, standard error, exit code.
pub(crate) fn piped(
    scratch: &Scratch,
    args: &[&str],
    input: impl Into<Vec<u8>>,
) -> (String, String, i32) {
    let mut child = virote(&scratch.0)
        .arg("repl")
        .args(args)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    let mut stdin = child.stdin.take().expect("a pipe");
    let input = input.into();
    // It may end before it has read all.
    let writer = thread::spawn(move || drop(stdin.write_all(&input)));
    let output = child.wait_with_output().expect("the command ends");
    writer.join().expect("the input is written");
    told(&output)
}

/// What did not fail in an imported file can be used, as by `run`; the mistake is told once, and again where
/// something wants what it took away.
#[test]
fn the_rest_of_an_imported_file_can_be_used() {
    let scratch = Scratch::new("repl-import");
    scratch.file("part.geo", "let good = 2\nlet bad = nobody\n");
    scratch.file("garbled.geo", "let a = 1\nlet b = )\n");
    let input = "import \"part.geo\"\nlet a = part.good + 1\na * 10\n";
    let (out, err, code) = piped(&scratch, &[], input);
    assert_eq!(out, "a = 3\n30\n", "{err}");
    assert_eq!((err.matches("E0201").count(), code), (1, 2), "{err}");
    for refused in ["part.bad", "let b = part.bad", "print 1, part.bad", "let b = part"] {
        let input = format!("import \"part.geo\"\n{refused}\npart.good\n");
        let (out, err, _) = piped(&scratch, &[], input);
        assert_eq!((out.as_str(), err.matches("E0201").count()), ("2\n", 2), "{refused}: {err}");
    }
    let (out, err, _) = piped(&scratch, &[], "import \"garbled.geo\"\n:list\n");
    assert!(out.is_empty() && err.contains("garbled.geo:2"), "{out}{err}");
}

#[test]
fn entries_from_a_pipe_are_answered_without_a_prompt() {
    let scratch = Scratch::new("repl-pipe");
    let input = "\
1 + 1
_ * 10
let a = 3
curve c = bezier((0, 0), (1, 2),
  (2, 0))
c(0.5)
dist(_)
_.y
max(_, 7)
let b = a + 1
let a = 10
b
print a, b
check b == 11 \"eleven\"
:type c
:undo
:undo
b
:time 2
:list
:save a.geo
";
    let expected = "\
2
20
a = 3
c: curve of degree 2 with 3 control points on 0..1
(1, 1, 0)
1
max(numbers: list of numbers) -> number with places left open
b = 4
a = 10
11
a = 10
b = 11
1 check passed
a curve of degree 2 with 3 control points on 0..1
4
2
";
    let (out, err, code) = piped(&scratch, &[], input);
    let (before, after) = out.split_at(expected.len().min(out.len()));
    assert_eq!(before, expected, "{err}");
    let list = "a = 3\nc: curve of degree 2 with 3 control points on 0..1\nb = 4\n";
    assert!(after.ends_with(list) && after.starts_with('('), "{after}");
    assert!(err.contains("nothing is called `dist`") || err.contains("`dist`"), "{err}");
    assert!(err.contains("(evaluated 1 again: b, kept "), "{err}");
    assert!(err.contains("saved a.geo") && err.contains("(back to 3 definitions)"), "{err}");
    assert_eq!(code, 2, "an entry was wrong");
    let saved = std::fs::read_to_string(scratch.0.join("a.geo")).expect("a script");
    assert_eq!(saved, "let a = 3\ncurve c = bezier((0, 0), (1, 2),\n  (2, 0))\nlet b = a + 1\n");
}

/// As `run` refuses them; of another script they may be meant for the one before.
#[test]
fn settings_that_no_parameter_takes_are_told() {
    let scratch = Scratch::new("repl-settings");
    scratch.file("a.geo", "param width = 1\n");
    scratch.file("b.geo", "param depth = 1\n");
    let (out, err, code) = piped(&scratch, &["a.geo", "-D", "widht=2"], "width\n");
    assert_eq!((out.as_str(), code), ("", 3), "{err}");
    assert!(err.contains("the script has no parameter `widht`; did you mean `width`?"), "{err}");
    assert!(!err.contains("loaded"), "{err}");
    let input = "width\n:load b.geo\ndepth\n";
    let (out, err, code) = piped(&scratch, &["a.geo", "-D", "width=2"], input);
    assert_eq!((out.as_str(), code), ("2\n1\n", 0), "{err}");
    assert!(err.contains("warning: the script has no parameter `width`"), "{err}");
    // They wait for parameters that are still to come.
    let (out, err, code) = piped(&scratch, &["-D", "width=2"], "param width = 1\nwidth\n");
    assert_eq!((out.as_str(), code), ("width = 2\n2\n", 0), "{err}");
}

#[test]
fn options_are_told_and_changed() {
    let scratch = Scratch::new("repl-set");
    let input = "\
:set
:set width 40
:plot x => x in -1..1
:set width 100
:plot x => x in -1..1
:set width 5
:set widht 50
:set list-length 10
len(0..<20)
[for i in 0..<20: i]
:set list-length = 1_000
len([for i in 0..<20: i])
:set list-length none
:set color on
1 / 0
:set color off
";
    let (out, err, code) = piped(&scratch, &[], input);
    assert!(out.starts_with("  color off ") && out.contains("\n  width auto "), "{out}");
    assert!(out.contains("\n  list-length ") && out.contains("\nwidth 40\n"), "{out}");
    let widest = |from: &str, to: &str| {
        let (_, rest) = out.split_once(from).expect("it is told");
        let plot = rest.split_once(to).map_or(rest, |(plot, _)| plot);
        plot.lines().map(|line| line.chars().count()).max()
    };
    assert_eq!(widest("\nwidth 40\n", "width 100"), Some(40), "{out}");
    assert_eq!(widest("\nwidth 100\n", "list-length 10"), Some(100), "{out}");
    assert!(
        out.contains("\nlist-length 10\n") && out.ends_with("20\ncolor on\ncolor off\n"),
        "{out}"
    );
    assert!(
        err.contains("takes 20 to 240 columns") && err.contains("did you mean `width`?"),
        "{err}"
    );
    assert!(err.contains("E0901") && err.contains("`list-length` is a whole number"), "{err}");
    assert!(err.contains("`:set list-length N` moves this ceiling"), "{err}");
    assert!(err.contains("\x1b["), "the error after `:set color on` is coloured: {err}");
    assert_eq!(code, 2);
}

#[test]
fn values_are_shown_from_the_side_that_is_named() {
    let scratch = Scratch::new("repl-view");
    let input = "\
curve c = polyline((0, 0, 0), (4, 0, 2), (8, 3, 0))
let front = 2
:show c
:show c front
:show [c, c] isometric
:show front
:show 1 + front
";
    let (out, err, code) = piped(&scratch, &[], input);
    assert_eq!((err.as_str(), code), ("", 0));
    let axes: Vec<&str> = out.lines().filter(|line| line.starts_with("(x")).collect();
    let isometric = "(x down to the right, y up to the right, z up)";
    assert_eq!(axes, ["(x to the right, y up)", "(x to the right, z up)", isometric], "{out}");
    assert!(out.ends_with("\n2\n3\n"), "{out}");
}

#[test]
fn the_last_value_comes_back_with_the_document() {
    let scratch = Scratch::new("repl-last");
    let (out, err, code) = piped(&scratch, &[], "let a = 3\na\nlet b = a + 1\nb\n:undo\n_\n");
    assert_eq!(code, 0, "{err}");
    assert_eq!(out, "a = 3\n3\nb = 4\n4\n3\n");
}

#[test]
fn functions_are_plotted_together_over_an_axis() {
    let scratch = Scratch::new("repl-together");
    let (out, err, code) = piped(&scratch, &[], ":plot x => x, x => -x in -1..1\n?sin\n");
    assert_eq!((err.as_str(), code), ("", 0));
    let (plot, help) = out.split_once("sin(").expect("help");
    assert!(help.contains("Sine of an angle"), "{help}");
    let lines: Vec<&str> = plot.lines().filter(|line| line.contains('┤')).collect();
    let dots = |line: &str| line.chars().filter(|c| ('\u{2801}'..='\u{28ff}').contains(c)).count();
    // Both lines reach the upper edge, one on each side; the axis runs between them all the way.
    assert!(lines[0].contains(" 1 ┤") && 2 <= dots(lines[0]), "{plot}");
    assert!(lines.iter().any(|line| 30 < dots(line)), "{plot}");
}

#[test]
fn plots_of_functions_that_fail_somewhere_say_where() {
    let scratch = Scratch::new("repl-plot-fails");
    let (out, err, code) = piped(&scratch, &[], ":plot x => 1/x in -1..1\n");
    assert_eq!(code, 0);
    assert!(out.contains('┤') && !err.contains("Error"), "{out}{err}");
    let told = format!("{out}{err}");
    assert!(told.contains("no value at 1 of 201 places, the first at 0"), "{told}");
    // Numbers of a comprehension are drawn, and what is no number is told by its kind.
    let (out, err, _) = piped(&scratch, &[], ":plot [for x in 0..3: x^2]\n");
    assert!(out.contains("9 ┤") && err.is_empty(), "{out}{err}");
    let (_, err, _) = piped(&scratch, &[], ":plot [for x in 0..3: \"{x}\"]\n");
    assert_eq!(err.trim(), "virote: a list of 4 strings cannot be plotted");
}

#[test]
fn whatever_is_wrong_leaves_the_document_as_it_was() {
    let scratch = Scratch::new("repl-wrong");
    scratch.file("wrong.geo", "let keep = 1\nlet other = keep +");
    scratch.file("binary.geo", [0xff, 0xfe, 0x00, 0x80]);
    let wrong = [
        "let keep = )",
        "let keep = 1 / 0",
        "let keep = nobody",
        "let keep = keep",
        "let twice = 1 let twice = 2",
        "curve keep = (1, 2)",
        "let keep = 10mm + 30deg",
        "keep(1)",
        "keep = 3",
        "\"open",
        "let keep = [1, 2][7]",
        "let keep = bezeir((0, 0))",
        "fn keep(a, a) = a",
        "fn keep(a) = keep(a + 1) let x = keep(1)",
        "import \"nowhere.geo\"",
        "unit parsec",
        "tolerance -1",
        "export keep to \"../out.json\"",
        "export keep to \"a.xyz\"",
        "check \"text\"",
        ":load wrong.geo",
        ":load binary.geo",
        ":load nowhere.geo",
        ":lst",
        ":",
        ":save /nowhere/at/all.geo",
        ":help bezeir",
        ":plot \"text\"",
        "\u{1}\u{2}\u{3}",
        "Point(1) = {0, 0, 0};",
        "_",
    ];
    let mut input = "let keep = 41\nlet user = keep + 1\n".to_owned();
    for line in wrong {
        input.push_str(&format!("{line}\nprint user\n"));
    }
    let (out, err, code) = piped(&scratch, &[], input);
    assert!(!err.contains("virote failed"), "{err}");
    assert_eq!(out.matches("user = 42\n").count(), wrong.len() + 1, "{out}\n{err}");
    assert_eq!(code, 2);
    for text in
        ["did you mean `:list`?", "did you mean `bezier`?", "save it as UTF-8", "wrong.geo:2"]
    {
        assert!(err.contains(text), "`{text}` is missing in {err}");
    }
}

/// Each mistake of `tests/errors` but those of exports and of the command line, which `:load` does
/// not see: these scripts are loaded.
#[test]
fn each_mistake_of_the_language_leaves_the_document_as_it_was() {
    let scratch = Scratch::new("repl-mistakes");
    let folder = folder("tests/errors");
    let is_wrong = |name: &String| !name.starts_with("check-") && !name.starts_with("usage-");
    let names: Vec<String> = programs(&folder).into_iter().filter(is_wrong).collect();
    let mut input = String::new();
    for name in &names {
        let path = folder.join(name).with_extension("geo");
        input += &format!("let keep = 41\n:load {}\nprint keep\n", path.display());
    }
    // What takes longer is a mistake of another kind then.
    let (out, err, code) = piped(&scratch, &["--limit", "steps=100000"], input);
    assert!(!err.contains("virote failed"), "{err}");
    let n_loaded = err.lines().filter(|line| line.starts_with("loaded ")).count();
    assert!(10 * n_loaded < names.len(), "{n_loaded} of {} are loaded", names.len());
    assert_eq!(out.matches("keep = 41\n").count() + n_loaded, 2 * names.len(), "{err}");
    assert_eq!(code, 2);
}

#[test]
fn redefinitions_that_break_others_are_refused() {
    let scratch = Scratch::new("repl-breaks");
    let input = "let a = 2\nlet b = 1 / a\nlet a = 0\na\nlet a = 4\nb\n";
    let (out, err, _) = piped(&scratch, &[], input);
    assert_eq!(out, "a = 2\nb = 0.5\n2\na = 4\n0.25\n", "{err}");
    assert!(err.contains("document:1:"), "the place in the document is shown: {err}");
}

#[test]
fn files_are_loaded_and_written() {
    let scratch = Scratch::new("repl-files");
    let script = "\
// A script with everything.
geo 1
unit cm
param size = 2cm
/// The circle.
curve c = circle((0, 0), size)
check length(c) > 12 \"long enough\"
print size
export c to \"c.obj\"
test \"never run here\" { check false }
";
    scratch.file("a.geo", script);
    let input = "length(c) > 12\nexport size to \"size.json\"\n:export\n:export c to \"d.obj\"\n:save b.geo\n:save a.geo\n:load b.geo\nsize\n";
    let (out, err, code) = piped(&scratch, &["a.geo"], input);
    assert!(code == 2 && err.contains("`a.geo` is there already"), "{out}{err}");
    for text in
        ["1 check passed\n", "true\n", "wrote size.json", "wrote c.obj", "wrote d.obj", "\n2cm\n"]
    {
        assert!(out.contains(text), "`{text}` is missing in {out}{err}");
    }
    assert!(!out.contains("size = 2"), "prints of a loaded script do not run: {out}");
    let saved = std::fs::read_to_string(scratch.0.join("b.geo")).expect("a script");
    assert_eq!(saved, format!("{script}export size to \"size.json\"\n"));
    assert!(err.contains("loaded a.geo: 2 definitions, 1 file for `:export`"), "{err}");
}

#[test]
fn a_line_of_ten_megabytes_is_read_and_told_shortly() {
    let scratch = Scratch::new("repl-long");
    let mut input = b"1 + 1\n".to_vec();
    input.extend(std::iter::repeat_n(b'x', 10 << 20));
    input.extend(b"\n\"");
    input.extend(std::iter::repeat_n(b'y', 10 << 20));
    input.extend(b"\"\n2 + 2\n\xff\xfe\x00\n3 + 3\n");
    let (out, err, _) = piped(&scratch, &[], input);
    assert!(out.starts_with("2\n") && out.ends_with("\n4\n6\n"), "{} bytes", out.len());
    assert!(err.len() < 2 * (10 << 20) + 10_000, "{} bytes", err.len());
}

#[test]
fn a_closed_pipe_ends_it() {
    let scratch = Scratch::new("repl-closed");
    let mut child = virote(&scratch.0)
        .arg("repl")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("the command starts");
    let mut stdin = child.stdin.take().expect("a pipe");
    let mut stdout = child.stdout.take().expect("a pipe");
    stdin.write_all(b"1 + 1\n").expect("an entry");
    let mut first = [0; 2];
    stdout.read_exact(&mut first).expect("an answer");
    drop(stdout);
    // It reads no more once it sees that nobody listens.
    let is_ended = (0..1_000_000).any(|_| stdin.write_all(b"2 + 2\n").is_err());
    let status = child.wait().expect("it ends");
    assert!(is_ended && status.code() == Some(0), "{is_ended} {status}");
}

/// At a terminal.
#[cfg(unix)]
mod terminal {
    use std::time::Duration;

    use expectrl::{Eof, Expect, Session, session::OsSession};

    use super::{Command, Scratch};

    /// A terminal with the prompt in it.
    struct Terminal(OsSession);

    impl Terminal {
        fn new(scratch: &Scratch, columns: u16, state: &str) -> Self {
            let mut command = Command::new(env!("CARGO_BIN_EXE_virote"));
            command
                .args(["repl", "--threads", "2"])
                .current_dir(&scratch.0)
                .env("XDG_STATE_HOME", state)
                .env("TERM", "xterm")
                .env_remove("NO_COLOR");
            let mut session = Session::spawn(command).expect("a terminal");
            session.set_expect_timeout(Some(Duration::from_secs(60)));
            session.get_process_mut().set_window_size(columns, 40).expect("a size");
            let mut terminal = Self(session);
            if scratch.0.join(state).is_file() {
                terminal.sees("warning: the history in `");
                terminal.sees("is not kept");
            }
            terminal.sees(READY);
            terminal
        }

        /// Waits for a text.
        #[track_caller]
        fn sees(&mut self, text: &str) {
            let found = self.0.expect(text);
            let seen = found.is_ok();
            let mut rest = vec![0; 4000];
            let n_left = if seen { 0 } else { self.0.try_read(&mut rest).unwrap_or(0) };
            assert!(seen, "no `{text}` in {}", String::from_utf8_lossy(&rest[..n_left]));
        }

        fn types(&mut self, keys: &str) {
            self.0.send(keys).expect("keys");
        }

        /// Types an entry and waits for an answer.
        #[track_caller]
        fn says(&mut self, entry: &str, answer: &str) {
            self.types(&format!("{entry}\r"));
            self.sees(answer);
            self.sees(READY);
        }

        /// Gives up the entry.
        #[track_caller]
        fn gives_up(&mut self) {
            self.types("\x03");
            self.sees("ends)");
            self.sees(READY);
        }

        #[track_caller]
        fn ends(&mut self) {
            self.0.expect(Eof).expect("it ends");
        }
    }

    const STATE: &str = "state";

    /// What a terminal is told when the prompt is there again: what is typed before may get lost.
    const READY: &str = "\x1b[?2004h";

    #[test]
    fn every_command_answers() {
        let scratch = Scratch::new("repl-terminal");
        scratch.file("a.geo", "let loaded = 7\ncurve arc1 = circle((0, 0), 2)\n");
        let mut prompt = Terminal::new(&scratch, 100, STATE);
        prompt.says("1 + 1", "\n2\r");
        prompt.says("_ * 21", "\n42\r");
        prompt.says("let a = 3", "a = 3\r");
        // An entry of several lines.
        prompt.types("curve c = bezier([\r");
        prompt.types("  (0, 0), (1, 2),\r");
        prompt.says("  (2, 0)])", "curve of degree 2 with 3 control points on 0..1\r");
        prompt.says("let b = 2 * a", "b = 6\r");
        prompt.says("let a = 5", "(evaluated 1 again: b, kept 1; ");
        prompt.says("b", "\n10\r");
        prompt.says(":undo", "(back to 3 definitions)");
        prompt.says("let spare = 1", "spare = 1\r");
        prompt.says(":undo", "(back to 3 definitions, without spare)");
        prompt.says("b", "\n6\r");
        prompt.says(":list", "c: curve of degree 2");
        prompt.says(":type c", "a curve of degree 2");
        prompt.types(":show c\r");
        prompt.sees("knots: 0 0 0 1 1 1\r");
        prompt.sees("    1  (1, 2, 0)\r");
        prompt.sees("⠒");
        prompt.sees("(x to the right, y up)");
        prompt.sees(READY);
        prompt.says(":show curvature_table(c, samples = 3)", "torsion");
        prompt.says(":plot curvature(c)", "┤");
        prompt.says(":plot x => x^2 in 0..2", "┤");
        prompt.says(":plot basis_table(c)", "(n0, n1, n2 over t)");
        prompt.says("test \"t\" { check true }", "(`virote test` runs it once");
        prompt.says(":list", "(1 test)");
        prompt.says(":undo", "(back to 3 definitions)");
        prompt.says(":time length(c)", " ms)");
        prompt.says(":help bezier", "list of points");
        prompt.says(":help E0602", "E0602: ");
        prompt.says(":help :sho", ":show EXPR [VIEW]\r");
        prompt.says(":help :shw", "did you mean `:show`?");
        prompt.types("/// Half of it.\r");
        prompt.says("fn half(h) = h / 2", "half: function half(h)");
        prompt.says(":help half", "Half of it.\r");
        prompt.says(":undo", "without half)");
        prompt.says(":help", ":undo");
        prompt.says(":export c to \"c.obj\"", "wrote c.obj");
        prompt.says(":save mine.geo", "saved mine.geo");
        prompt.says(":load a.geo", "loaded a.geo: 2 definitions");
        prompt.says("loaded", "\n7\r");
        prompt.says(":lsit", "did you mean `:list`?");
        prompt.says(":list all", "`:list` stands alone; found `all`");
        prompt.says(":save mine.geo", "`mine.geo` is there already");
        prompt.says(":save! mine.geo", "saved mine.geo");
        prompt.says("lenth(arc1)", "did you mean `length`?");
        prompt.types(":quit\r");
        prompt.ends();
        assert!(scratch.0.join("c.obj").is_file() && scratch.0.join("mine.geo").is_file());
    }

    #[test]
    fn tab_completes_names_labels_words_fields_files_and_commands() {
        let scratch = Scratch::new("repl-tab");
        scratch.file("a_script_of_mine.geo", "let mine = 1");
        let mut prompt = Terminal::new(&scratch, 120, STATE);
        prompt.says("let unmistakable = (1, 2)", "unmistakable = (1, 2, 0)");
        prompt.says("unmist\t + (1, 0)", "\n(2, 2, 0)\r");
        // Several that fit are listed with what they are.
        prompt.types("unmistakable.\t\t");
        prompt.sees("y  2");
        prompt.says("y", "\n2\r");
        prompt.says("fn half(height, by = 2) = height / by", "half: function");
        prompt.says("half(3mm, by\t6)", "\n0.5mm\r");
        // The argument that is being written stands behind the cursor.
        prompt.types("half(3, ");
        prompt.sees("by = 2");
        prompt.gives_up();
        prompt.types("25m\t\t");
        prompt.sees("1000 mm");
        prompt.gives_up();
        prompt.types("len(circle((0, 0), 1, nor\t\t");
        prompt.sees("label: point");
        prompt.gives_up();
        prompt.says(":lo\t a_scr\t", "loaded a_script_of_mine.geo");
        prompt.types("mes\t\t");
        prompt.sees("keyword");
        prompt.gives_up();
        prompt.types("\x04");
        prompt.ends();
    }

    #[test]
    fn the_history_stays_and_words_are_coloured() {
        let scratch = Scratch::new("repl-history");
        let mut prompt = Terminal::new(&scratch, 80, STATE);
        prompt.says("let kept = 5", "kept = 5");
        prompt.types(":quit\r");
        prompt.ends();
        assert!(scratch.0.join(STATE).join("virote").join("history").is_file());
        let mut prompt = Terminal::new(&scratch, 80, STATE);
        // Up twice: over `:quit`.
        prompt.types("\x1b[A\x1b[A");
        prompt.sees("\x1b[1;34mlet\x1b[0m");
        prompt.says("", "kept = 5");
        prompt.types("\x04");
        prompt.ends();
    }

    #[test]
    fn a_history_that_cannot_be_written_is_a_warning() {
        let scratch = Scratch::new("repl-no-history");
        scratch.file("state", "a file, no folder");
        let mut prompt = Terminal::new(&scratch, 80, STATE);
        prompt.says("1 + 1", "\n2\r");
        prompt.types("\x04");
        prompt.ends();
    }

    #[test]
    fn a_long_evaluation_is_stopped_and_the_document_is_whole() {
        let scratch = Scratch::new("repl-stop");
        let mut prompt = Terminal::new(&scratch, 80, STATE);
        prompt.says("let a = 6", "a = 6");
        let long = "fold(0..9_000_000, 0, (x, y) => fold(0..1000, x, (p, q) => p + q))";
        prompt.types(&format!("let a = {long}\r"));
        std::thread::sleep(Duration::from_millis(1500));
        prompt.types("\x03");
        prompt.sees("stopped; the document is as it was");
        prompt.sees(READY);
        prompt.says("a * 7", "\n42\r");
        // At the prompt Ctrl-C gives up the entry.
        prompt.types("let a = 1");
        prompt.gives_up();
        prompt.says("a", "\n6\r");
        prompt.types("\x04");
        prompt.ends();
    }

    #[test]
    fn what_is_typed_ahead_is_not_lost() {
        let scratch = Scratch::new("repl-ahead");
        let mut prompt = Terminal::new(&scratch, 80, STATE);
        // All at once: the later entries come while the first is still evaluated.
        prompt.types("fold(0..300_000, 0, (x, y) => x + 1)\rlet a = 21\ra * 2\r");
        prompt.sees("\n300001\r");
        prompt.sees("a = 21\r");
        prompt.sees("\n42\r");
        prompt.says("a + 1", "\n22\r");
        // The second is typed while the first is under way, and finished when the prompt is back.
        prompt.types("fold(0..300_000, 0, (x, y) => x + 1)\r");
        std::thread::sleep(Duration::from_millis(100));
        prompt.types("a * ");
        prompt.sees("\n300001\r");
        prompt.sees(READY);
        prompt.says("3", "\n63\r");
        prompt.types("\x04");
        prompt.ends();
    }

    #[test]
    fn a_narrow_terminal_and_pasted_rubbish_do_no_harm() {
        let scratch = Scratch::new("repl-narrow");
        let mut prompt = Terminal::new(&scratch, 20, STATE);
        prompt.says("curve c = circle((0, 0), 1)", "control points on");
        prompt.says(":show c", "right");
        prompt.says(":plot curvature(c)", "┤");
        // Pasted at once, brackets, quotes and signs of control among it.
        let rubbish: String = (1..400_u32)
            .filter_map(|i| char::from_u32(i * 37 % 700))
            .filter(|c| !matches!(c, '\x1b' | '\0'))
            .collect();
        prompt.types(&format!("\x1b[200~{rubbish}\x1b[201~"));
        prompt.gives_up();
        prompt.says("1 + 1", "\n2\r");
        let long = "x".repeat(5_000);
        prompt.says(&format!("\x1b[200~{long}\x1b[201~"), "nothing is called");
        prompt.says("3 + 3", "\n6\r");
        prompt.types("\x04");
        prompt.ends();
    }

    #[test]
    fn ten_megabytes_pasted_in_one_line_are_an_entry_like_others() {
        let scratch = Scratch::new("repl-megabytes");
        let mut prompt = Terminal::new(&scratch, 80, STATE);
        let long = "x".repeat(10 << 20);
        prompt.types(&format!("\x1b[200~{long}\x1b[201~"));
        prompt.gives_up();
        prompt.says("3 + 3", "\n6\r");
        prompt.types("\x04");
        prompt.ends();
    }
}
