//! A fault of the program itself is told like a mistake, and the rest of the script goes on.

use virote::{
    diag::Code,
    session::{Event, Session},
    value::Files,
};

/// Files that nobody can read without a panic.
#[derive(Debug)]
struct Broken;

impl Files for Broken {
    fn read(&self, path: &str, _: usize) -> Result<Vec<u8>, String> {
        assert!(path.is_empty(), "the disk is on fire");
        Ok(Vec::new())
    }
}

#[test]
fn a_panic_in_one_definition_leaves_the_others() {
    let script =
        "let a = load(\"a.csv\")\nlet b = a\nlet c = 1 / 0\nprint 2\nprint load(\"b.csv\")\n";
    for n_threads in [1, 4] {
        let session = Session::default().on_threads(n_threads).incremental();
        for _ in 0..2 {
            let report = session.run("demo", script.as_bytes(), &Broken, &[]);
            let codes: Vec<Code> = report.diagnostics.iter().map(|found| found.code).collect();
            assert_eq!(codes.iter().filter(|code| **code == Code::Fault).count(), 2, "{codes:?}");
            assert_eq!(codes.len(), 3, "{codes:?}");
            let told = &report.diagnostics[0];
            assert!(told.message.contains("the disk is on fire"), "{}", told.message);
            assert!(told.hints[0].contains("please report"), "{}", told.hints[0]);
            let is_printed = |event: &Event| matches!(event, Event::Printed(_));
            assert_eq!(report.events.iter().filter(|event| is_printed(event)).count(), 1);
        }
    }
}
