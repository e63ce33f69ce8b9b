//! What is told of tested scripts: line by line as they come, and in total.

use serde_json::json;

use super::{
    Tested, Tried,
    golden::Judged,
    junit::{self, Suite},
};
use crate::{
    cli::{Ending, message::Voice},
    diag::Severity,
    session::{Event, Verdict},
};

/// Tells, and counts what it tells.
pub(super) struct Teller<'a> {
    voice: &'a Voice,
    count: Count,
    ending: Ending,
    /// For the file of results, if one is asked for.
    suites: Option<Vec<Suite>>,
}

impl<'a> Teller<'a> {
    pub(super) fn new(voice: &'a Voice, keeps_suites: bool) -> Self {
        let suites = keeps_suites.then(Vec::new);
        Self { voice, count: Count::default(), ending: Ending::Well, suites }
    }

    /// The worst ending so far.
    pub(super) fn ending(&self) -> Ending {
        self.ending
    }

    /// How many tests were run.
    pub(super) fn n_tests(&self) -> usize {
        self.count.tests.iter().sum()
    }

    /// What was kept for the file of results.
    pub(super) fn suites(&self) -> &[Suite] {
        self.suites.as_deref().unwrap_or_default()
    }

    /// Tells what became of a script.
    pub(super) fn tell(&mut self, tried: &Tried) {
        if let Some(suites) = &mut self.suites {
            suites.push(junit::suite(tried));
        }
        let tested = match tried {
            Ok(tested) => tested,
            Err(unread) => {
                self.voice.trouble(&unread.message);
                self.ending = Ending::Usage;
                return;
            }
        };
        self.ending = self.ending.max(tested.ending);
        let report = &tested.report;
        if !report.unknown_settings.is_empty() {
            report.unknown_settings.iter().for_each(|message| self.voice.trouble(message));
            self.voice.findings(&report.diagnostics, &report.sources);
            return;
        }
        self.checks(tested);
        self.tests(tested);
        let n_errors = report.count(Severity::Error);
        if n_errors > 0 {
            let text = format!("{}  {}", tested.name, some(n_errors, "error"));
            self.voice.result(Verdict::Wrong, &text);
        }
        self.golden(tested);
        self.voice.findings(&report.diagnostics, &report.sources);
        self.count.files += 1;
        self.count.wrong_files += usize::from(n_errors > 0);
    }

    /// The checks outside of tests.
    fn checks(&mut self, Tested { name, report, .. }: &Tested) {
        let mut checks = [0, 0];
        for event in &report.events {
            if let Event::Checked(checked) = event {
                self.voice.checked(checked, &report.sources, None);
                checks[usize::from(!checked.verdict.holds)] += 1;
            }
        }
        match checks {
            [0, 0] => {}
            [n, 0] => self.voice.result(Verdict::Passed, &format!("{name}  {}", some(n, "check"))),
            [passed, failed] => {
                let text = format!("{name}  {failed} of {}", some(passed + failed, "check"));
                self.voice.result(Verdict::Failed, &text);
            }
        }
        checks.iter().zip(&mut self.count.checks).for_each(|(n, total)| *total += n);
    }

    fn tests(&mut self, Tested { report, .. }: &Tested) {
        for test in &report.tests {
            self.voice.tested(test, &report.sources);
            for event in &test.events {
                match event {
                    Event::Printed(printed) => self.voice.printed(printed, Some(&test.name)),
                    Event::Checked(checked) => {
                        self.voice.checked(checked, &report.sources, Some(&test.name));
                    }
                    Event::Expected(expected) => {
                        self.voice.expected(expected, &report.sources, &test.name);
                    }
                    // Files of tests are nowhere written.
                    Event::File(_) => {}
                }
            }
            self.count.tests[test.verdict as usize] += 1;
        }
    }

    /// How the golden folder came out.
    fn golden(&mut self, Tested { name, golden, .. }: &Tested) {
        let Some(golden) = golden else { return };
        let count = &mut self.count.golden;
        match golden {
            Judged::Same(n) => {
                count[0] += 1;
                let text = some(*n, "golden file");
                self.voice.golden(Verdict::Passed.word(), name, &text, &[], false);
            }
            Judged::Apart(apart) => {
                count[1] += 1;
                let text = format!("golden folder: {}", some(apart.len(), "difference"));
                self.voice.golden(Verdict::Failed.word(), name, &text, &both(apart), true);
            }
            Judged::Blessed(n, changes) => {
                count[2] += 1;
                let text = match changes.len() {
                    0 => format!("{}, nothing changed", some(*n, "golden file")),
                    n_changes => {
                        let changes = some(n_changes, "change");
                        format!("{}, {changes}", some(*n, "golden file"))
                    }
                };
                self.voice.golden("blessed", name, &text, &both(changes), !changes.is_empty());
            }
            Judged::Skipped => {
                count[3] += 1;
                let text = "golden folder: the script has errors";
                self.voice.golden(Verdict::Skipped.word(), name, text, &[], true);
            }
            Judged::Unusable(message) => {
                count[1] += 1;
                self.voice.golden(Verdict::Failed.word(), name, "golden folder", &[], true);
                self.voice.trouble(message);
            }
        }
    }

    /// The last words.
    pub(super) fn total(&self) {
        self.voice.total(&self.count.text(), self.count.figures());
    }
}

/// Differences for people and for programs.
fn both(apart: &[super::golden::Difference]) -> Vec<(String, serde_json::Value)> {
    apart.iter().map(|difference| (difference.text(), difference.json())).collect()
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
    /// Golden folders: the same, others, rewritten, not looked at.
    golden: [usize; 4],
}

/// The verdicts in the order of their numbers.
const VERDICTS: [Verdict; 4] = [Verdict::Passed, Verdict::Failed, Verdict::Wrong, Verdict::Skipped];

/// What may become of a golden folder.
const OF_GOLDEN: [&str; 4] = ["passed", "failed", "blessed", "skipped"];

impl Count {
    /// As `2 files, 3 tests (2 passed, 1 failed), 4 checks (4 passed)`.
    fn text(&self) -> String {
        let wrong = [(self.wrong_files, "with errors")];
        let mut parts = vec![some(self.files, "file") + &listed(&wrong)];
        let tests = self.tests.iter().copied().zip(VERDICTS.map(Verdict::word));
        parts.push(some(self.tests.iter().sum(), "test") + &listed(&tests.collect::<Vec<_>>()));
        let checks = self.checks.iter().copied().zip(VERDICTS.map(Verdict::word));
        parts.push(some(self.checks.iter().sum(), "check") + &listed(&checks.collect::<Vec<_>>()));
        let n_golden = self.golden.iter().sum();
        if 0 < n_golden {
            let golden = self.golden.iter().copied().zip(OF_GOLDEN);
            parts.push(some(n_golden, "golden folder") + &listed(&golden.collect::<Vec<_>>()));
        }
        parts.join(", ")
    }

    fn figures(&self) -> serde_json::Value {
        let [passed, failed, wrong, skipped] = self.tests;
        let golden = OF_GOLDEN.iter().zip(self.golden);
        json!({
            "files": self.files,
            "wrong_files": self.wrong_files,
            "tests": { "passed": passed, "failed": failed, "wrong": wrong, "skipped": skipped },
            "checks": { "passed": self.checks[0], "failed": self.checks[1] },
            "golden": golden
                .map(|(word, n)| ((*word).to_owned(), json!(n)))
                .collect::<serde_json::Map<_, _>>(),
        })
    }
}

/// A count with its noun.
pub(super) fn some(n: usize, noun: &str) -> String {
    if n == 1 { format!("1 {noun}") } else { format!("{n} {noun}s") }
}

/// Counts in parentheses, without those of nothing.
fn listed(counts: &[(usize, &str)]) -> String {
    let parts: Vec<String> =
        counts.iter().filter(|(n, _)| *n > 0).map(|(n, word)| format!("{n} {word}")).collect();
    if parts.is_empty() { String::new() } else { format!(" ({})", parts.join(", ")) }
}
