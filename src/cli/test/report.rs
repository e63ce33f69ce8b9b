//! What is told of tested scripts: line by line as they come, and in total.

use serde_json::json;

use super::{
    golden::GoldenOutcome,
    junit::{self, JunitSuite},
    tested::{TestAttempt, TestedScript},
};
use crate::{
    cli::{
        exit_status::ExitStatus,
        reporter::{Reporter, counted},
    },
    session::{Event, TestVerdict},
};

/// Tells, and counts what it tells.
pub(super) struct TestReporter<'a> {
    voice: &'a Reporter,
    count: TestCounts,
    ending: ExitStatus,
    /// For the file of results, if one is asked for.
    suites: Option<Vec<JunitSuite>>,
}

impl<'a> TestReporter<'a> {
    pub(super) fn new(voice: &'a Reporter, keeps_suites: bool) -> Self {
        let suites = keeps_suites.then(Vec::new);
        Self { voice, count: TestCounts::default(), ending: ExitStatus::Well, suites }
    }

    /// The worst ending so far.
    pub(super) fn ending(&self) -> ExitStatus {
        self.ending
    }

    /// How many tests were run.
    pub(super) fn n_tests(&self) -> usize {
        self.count.tests.iter().sum()
    }

    /// What was kept for the file of results.
    pub(super) fn suites(&self) -> &[JunitSuite] {
        self.suites.as_deref().unwrap_or_default()
    }

    /// Tells what became of a script.
    pub(super) fn add(&mut self, tried: &TestAttempt) {
        if let Some(suites) = &mut self.suites {
            suites.push(junit::suite(tried));
        }
        let tested = match tried {
            Ok(tested) => tested,
            Err(unread) => {
                self.voice.trouble(&unread.message);
                self.ending = ExitStatus::Usage;
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
        let n_errors = report.count_untested_errors();
        if n_errors > 0 {
            let text = format!("{}  {}", tested.name, counted(n_errors, "error"));
            self.voice.result(TestVerdict::Wrong, &text);
        }
        self.golden(tested);
        self.voice.findings(&report.diagnostics, &report.sources);
        self.count.files += 1;
        self.count.wrong_files += usize::from(n_errors > 0);
    }

    /// The checks outside of tests.
    fn checks(&mut self, TestedScript { name, report, .. }: &TestedScript) {
        let mut checks = [0, 0];
        for event in &report.events {
            if let Event::Checked(checked) = event {
                self.voice.checked(checked, &report.sources, None);
                checks[usize::from(!checked.verdict.holds)] += 1;
            }
        }
        match checks {
            [0, 0] => {}
            [n, 0] => {
                self.voice.result(TestVerdict::Passed, &format!("{name}  {}", counted(n, "check")));
            }
            [passed, failed] => {
                let text = format!("{name}  {failed} of {}", counted(passed + failed, "check"));
                self.voice.result(TestVerdict::Failed, &text);
            }
        }
        checks.iter().zip(&mut self.count.checks).for_each(|(n, total)| *total += n);
    }

    fn tests(&mut self, TestedScript { report, .. }: &TestedScript) {
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
    fn golden(&mut self, TestedScript { name, golden, .. }: &TestedScript) {
        let Some(golden) = golden else { return };
        let count = &mut self.count.golden;
        match golden {
            GoldenOutcome::Same(n) => {
                count[0] += 1;
                let text = counted(*n, "golden file");
                self.voice.golden(TestVerdict::Passed.word(), name, &text, &[], false);
            }
            GoldenOutcome::Apart(apart) => {
                count[1] += 1;
                let text = format!("golden folder: {}", counted(apart.len(), "difference"));
                self.voice.golden(TestVerdict::Failed.word(), name, &text, &both(apart), true);
            }
            GoldenOutcome::Blessed(n, changes) => {
                count[2] += 1;
                let text = match changes.len() {
                    0 => format!("{}, nothing changed", counted(*n, "golden file")),
                    n_changes => {
                        let changes = counted(n_changes, "change");
                        format!("{}, {changes}", counted(*n, "golden file"))
                    }
                };
                self.voice.golden("blessed", name, &text, &both(changes), !changes.is_empty());
            }
            GoldenOutcome::Skipped => {
                count[3] += 1;
                let text = "golden folder: the script has errors";
                self.voice.golden(TestVerdict::Skipped.word(), name, text, &[], true);
            }
            GoldenOutcome::Unusable(message) => {
                count[1] += 1;
                self.voice.golden(TestVerdict::Failed.word(), name, "golden folder", &[], true);
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
struct TestCounts {
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
const VERDICTS: [TestVerdict; 4] =
    [TestVerdict::Passed, TestVerdict::Failed, TestVerdict::Wrong, TestVerdict::Skipped];

/// What may become of a golden folder.
const OF_GOLDEN: [&str; 4] = ["passed", "failed", "blessed", "skipped"];

impl TestCounts {
    /// As `2 files, 3 tests (2 passed, 1 failed), 4 checks (4 passed)`.
    fn text(&self) -> String {
        let wrong = [(self.wrong_files, "with errors")];
        let mut parts = vec![counted(self.files, "file") + &listed(&wrong)];
        let tests = self.tests.iter().copied().zip(VERDICTS.map(TestVerdict::word));
        parts.push(counted(self.tests.iter().sum(), "test") + &listed(&tests.collect::<Vec<_>>()));
        let checks = self.checks.iter().copied().zip(VERDICTS.map(TestVerdict::word));
        parts.push(
            counted(self.checks.iter().sum(), "check") + &listed(&checks.collect::<Vec<_>>()),
        );
        let n_golden = self.golden.iter().sum();
        if 0 < n_golden {
            let golden = self.golden.iter().copied().zip(OF_GOLDEN);
            parts.push(counted(n_golden, "golden folder") + &listed(&golden.collect::<Vec<_>>()));
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

/// Counts in parentheses, without those of nothing.
fn listed(counts: &[(usize, &str)]) -> String {
    let parts: Vec<String> =
        counts.iter().filter(|(n, _)| *n > 0).map(|(n, word)| format!("{n} {word}")).collect();
    if parts.is_empty() { String::new() } else { format!(" ({})", parts.join(", ")) }
}
