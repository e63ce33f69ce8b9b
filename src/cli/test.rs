//! `virote test`: the tests and checks of scripts, files or whole folders of them.

use std::{
    fs,
    path::{Path, PathBuf},
};

use serde_json::json;

use super::{
    Ending,
    args::Common,
    files::{Beside, Script, reason},
    message::Voice,
    settings,
};
use crate::{
    diag::Severity,
    eval::Setting,
    session::{Event, Report, Session, Verdict},
};

/// `virote test [PATH...]`: the worst ending of all.
pub(super) fn run(paths: &[PathBuf], filter: Option<&str>, common: &Common) -> Ending {
    let session = common.session();
    let voice = Voice::new(&common.talk, session.limits().diagnostics);
    let settings = match settings::given(common, session.limits().input_bytes, &voice) {
        Ok(settings) => settings,
        Err(ending) => return ending,
    };
    let mut tests = Tests { session, voice, settings, filter, count: Count::default() };
    let here = [PathBuf::from(".")];
    let paths = if paths.is_empty() { &here } else { paths };
    let mut ending = Ending::Well;
    for path in paths {
        match scripts(path) {
            Ok(scripts) => {
                ending = scripts.iter().map(|script| tests.script(script)).fold(ending, Ord::max);
            }
            Err(message) => {
                tests.voice.trouble(&message);
                ending = Ending::Usage;
            }
        }
    }
    let is_missed = tests.count.tests == [0; 4] && ending == Ending::Well;
    if let Some(filter) = filter.filter(|_| is_missed) {
        tests.voice.trouble(&format!("no test has a name that contains `{filter}`"));
        ending = Ending::Usage;
    }
    tests.voice.total(&tests.count.text(), tests.count.figures());
    ending
}

/// The scripts that a path stands for: itself, or what lies in a folder at any depth, in order.
fn scripts(path: &Path) -> Result<Vec<PathBuf>, String> {
    if !path.is_dir() {
        return Ok(vec![path.to_path_buf()]);
    }
    let mut folders = vec![path.to_path_buf()];
    let mut found = Vec::new();
    while let Some(folder) = folders.pop() {
        let told =
            |err| format!("cannot look into the folder `{}`: {}", folder.display(), reason(&err));
        for entry in fs::read_dir(&folder).map_err(told)? {
            let entry = entry.map_err(told)?;
            let is_visible = !entry.file_name().to_string_lossy().starts_with('.');
            let path = entry.path();
            // Links to folders are not followed, since they could lead round in a circle.
            if entry.file_type().map_err(told)?.is_dir() {
                folders.extend(Some(path).filter(|_| is_visible));
            } else if is_visible && path.extension().is_some_and(|ending| ending == "geo") {
                found.push(path.strip_prefix(".").map(Path::to_path_buf).unwrap_or(path));
            }
        }
    }
    if found.is_empty() {
        return Err(format!("there is no script in the folder `{}`", path.display()));
    }
    found.sort();
    Ok(found)
}

/// What is done with each script.
struct Tests<'a> {
    session: Session,
    voice: Voice,
    settings: Vec<Setting>,
    filter: Option<&'a str>,
    count: Count,
}

impl Tests<'_> {
    fn script(&mut self, path: &Path) -> Ending {
        let voice = &self.voice;
        let script = match Script::read(path, self.session.limits().source_bytes) {
            Ok(script) => script,
            Err(message) => {
                voice.trouble(&message);
                return Ending::Usage;
            }
        };
        let files = Beside::new(&script.folder);
        let report =
            self.session.test(&script.name, &script.bytes, &files, &self.settings, self.filter);
        if !report.unknown_settings.is_empty() {
            report.unknown_settings.iter().for_each(|message| voice.trouble(message));
            voice.findings(&report.diagnostics, &report.sources);
            return Ending::Usage;
        }
        tell(&report, &script.name, voice, &mut self.count);
        Ending::of(&report)
    }
}

/// Tells what became of a script, and counts it.
fn tell(report: &Report, name: &str, voice: &Voice, count: &mut Count) {
    let mut checks = [0, 0];
    for event in &report.events {
        if let Event::Checked(checked) = event {
            voice.checked(checked, &report.sources, None);
            checks[usize::from(!checked.verdict.holds)] += 1;
        }
    }
    match checks {
        [0, 0] => {}
        [n, 0] => voice.result(Verdict::Passed, &format!("{name}  {}", some(n, "check"))),
        [passed, failed] => {
            let text = format!("{name}  {failed} of {}", some(passed + failed, "check"));
            voice.result(Verdict::Failed, &text);
        }
    }
    for test in &report.tests {
        voice.tested(test, &report.sources);
        for event in &test.events {
            match event {
                Event::Printed(printed) => voice.printed(printed, Some(&test.name)),
                Event::Checked(checked) => {
                    voice.checked(checked, &report.sources, Some(&test.name));
                }
                Event::Expected(expected) => {
                    voice.expected(expected, &report.sources, &test.name);
                }
                // Files of tests are nowhere written.
                Event::File(_) => {}
            }
        }
        count.tests[test.verdict as usize] += 1;
    }
    let n_errors = report.count(Severity::Error);
    if n_errors > 0 {
        voice.result(Verdict::Wrong, &format!("{name}  {}", some(n_errors, "error")));
    }
    voice.findings(&report.diagnostics, &report.sources);
    count.files += 1;
    count.wrong_files += usize::from(n_errors > 0);
    checks.iter().zip(&mut count.checks).for_each(|(n, total)| *total += n);
}

/// What was tested, and how it came out.
#[derive(Debug, Default)]
struct Count {
    files: usize,
    wrong_files: usize,
    /// By their verdicts.
    tests: [usize; 4],
    /// Outside of tests: those that hold, those that do not.
    checks: [usize; 2],
}

/// The verdicts in the order of their numbers.
const VERDICTS: [Verdict; 4] = [Verdict::Passed, Verdict::Failed, Verdict::Wrong, Verdict::Skipped];

impl Count {
    /// As `2 files, 3 tests (2 passed, 1 failed), 4 checks (4 passed)`.
    fn text(&self) -> String {
        let wrong = [(self.wrong_files, "with errors")];
        let mut parts = vec![some(self.files, "file") + &listed(&wrong)];
        let tests = self.tests.iter().copied().zip(VERDICTS.map(Verdict::word));
        parts.push(some(self.tests.iter().sum(), "test") + &listed(&tests.collect::<Vec<_>>()));
        let checks = self.checks.iter().copied().zip(VERDICTS.map(Verdict::word));
        parts.push(some(self.checks.iter().sum(), "check") + &listed(&checks.collect::<Vec<_>>()));
        parts.join(", ")
    }

    fn figures(&self) -> serde_json::Value {
        let [passed, failed, wrong, skipped] = self.tests;
        json!({
            "files": self.files,
            "wrong_files": self.wrong_files,
            "tests": { "passed": passed, "failed": failed, "wrong": wrong, "skipped": skipped },
            "checks": { "passed": self.checks[0], "failed": self.checks[1] },
        })
    }
}

/// A count with its noun.
fn some(n: usize, noun: &str) -> String {
    if n == 1 { format!("1 {noun}") } else { format!("{n} {noun}s") }
}

/// Counts in parentheses, without those of nothing.
fn listed(counts: &[(usize, &str)]) -> String {
    let parts: Vec<String> =
        counts.iter().filter(|(n, _)| *n > 0).map(|(n, word)| format!("{n} {word}")).collect();
    if parts.is_empty() { String::new() } else { format!(" ({})", parts.join(", ")) }
}
