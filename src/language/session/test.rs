//! The tests of a script: what each of them came to.

use super::{Event, Report, Session, plan::PlanContext};
use crate::{
    diag::{Diagnostic, Severity, Span},
    eval::{self, Purpose, Setting, TestFilter},
    value::Files,
};

/// A test that was run.
#[derive(Debug)]
pub struct TestReport {
    /// Its name.
    pub name: String,
    /// Where its name stands.
    pub span: Span,
    /// How it came out.
    pub verdict: TestVerdict,
    /// What it says and claims. Files of a test are planned, so that mistakes in them show, but
    /// nobody writes them.
    pub events: Vec<Event>,
    /// The messages of its errors, which are among the findings of the report.
    pub errors: Vec<String>,
}

/// How a test came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TestVerdict {
    /// All of it holds.
    Passed,
    /// A claim does not hold, or an expected error did not come.
    Failed,
    /// There is a mistake in it.
    Wrong,
    /// Something outside of it has no value, for a reason that is told there.
    Skipped,
}

impl TestVerdict {
    /// Its word in reports.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Failed => "failed",
            Self::Wrong => "wrong",
            Self::Skipped => "skipped",
        }
    }
}

impl Session {
    /// Interprets the script `bytes` and runs its tests; with a `filter` only those that it takes, and no
    /// effects of the script itself.
    ///
    /// ```
    /// use virote_language::{eval::TestFilter, session::{Session, TestVerdict}, value::NoFiles};
    ///
    /// let script = b"let a = 2
    ///     test \"sums\" { check a + a == 4 }
    ///     test \"quotients\" { expect error \"E0501\" a / 0 }";
    /// let quotients = Some(TestFilter::Named("quotients"));
    /// let report = Session::default().test("demo", script, &NoFiles, &[], quotients);
    /// assert!(report.diagnostics.is_empty());
    /// assert!(matches!(&report.tests[..], [test] if test.verdict == TestVerdict::Passed));
    /// ```
    #[must_use]
    pub fn test(
        &self,
        name: &str,
        bytes: &[u8],
        files: &dyn Files,
        settings: &[Setting],
        filter: Option<TestFilter<'_>>,
    ) -> Report {
        let purpose = filter.map_or(Purpose::Test, Purpose::SomeTests);
        self.interpret(name, bytes, files, settings, purpose)
    }

    /// A test with its files planned; what went wrong in it goes to `diagnostics`.
    pub(super) fn tested(
        &self,
        tested: eval::TestOutcome,
        context: PlanContext<'_>,
        diagnostics: &mut Vec<Diagnostic>,
    ) -> TestReport {
        let eval::TestOutcome {
            name,
            span,
            outputs,
            diagnostics: mut found,
            is_poisoned,
            is_whole,
        } = tested;
        let events = self.events(outputs, context, &mut found);
        let has = |severity: Severity| found.iter().any(|found| found.severity == severity);
        let verdict = if is_poisoned || has(Severity::Error) {
            TestVerdict::Wrong
        } else if has(Severity::Failure) {
            TestVerdict::Failed
        } else if is_whole {
            TestVerdict::Passed
        } else {
            TestVerdict::Skipped
        };
        let errors = found.iter().filter(|found| found.severity == Severity::Error);
        let errors = errors.map(|found| found.message.clone()).collect();
        diagnostics.append(&mut found);
        TestReport { name, span, verdict, events, errors }
    }
}

impl Report {
    /// How many errors there are outside of tests.
    #[must_use]
    pub fn count_untested_errors(&self) -> usize {
        self.n_untested_errors
    }
}
