//! Results as JUnit has them: a suite for each script, a case for each test, for the checks outside
//! of tests, and for the golden folder.
//!
//! The form is the one that CI services agree on (<https://github.com/testmoapp/junitxml>).

use std::{fmt::Write as _, io, path::Path};

use super::{
    super::reporter::counted,
    golden::GoldenOutcome,
    tested::{TestAttempt, TestedScript},
};
use crate::{
    disk::replace,
    render,
    session::{Event, Report, TestVerdict},
};

/// What became of a script.
pub(super) struct JunitSuite {
    name: String,
    seconds: f64,
    cases: Vec<JunitCase>,
    /// All findings.
    findings: String,
}

/// What became of a test, or of what stands for one.
struct JunitCase {
    name: String,
    line: Option<usize>,
    verdict: TestVerdict,
    /// What is wrong, if anything.
    message: String,
    details: String,
}

impl JunitCase {
    fn new(name: &str, verdict: TestVerdict, message: String) -> Self {
        Self { name: name.to_owned(), line: None, verdict, message, details: String::new() }
    }
}

/// The suite of a script.
pub(super) fn suite(tried: &TestAttempt) -> JunitSuite {
    let tested = match tried {
        Ok(tested) => tested,
        Err(unread) => {
            let case = JunitCase::new("script", TestVerdict::Wrong, unread.message.clone());
            let (name, findings) = (unread.name.clone(), String::new());
            return JunitSuite { name, seconds: 0.0, cases: vec![case], findings };
        }
    };
    let report = &tested.report;
    let pictures = report.diagnostics.iter();
    let findings = pictures.map(|found| render::picture(found, &report.sources, false)).collect();
    JunitSuite {
        name: tested.name.clone(),
        seconds: tested.time.as_secs_f64(),
        cases: cases(tested),
        findings,
    }
}

fn cases(tested: &TestedScript) -> Vec<JunitCase> {
    let report = &tested.report;
    let mut cases = Vec::new();
    let n_errors = report.count_untested_errors();
    if !report.unknown_settings.is_empty() {
        let message = report.unknown_settings.join("; ");
        cases.push(JunitCase::new("parameters", TestVerdict::Wrong, message));
    }
    if 0 < n_errors {
        cases.push(JunitCase::new("script", TestVerdict::Wrong, counted(n_errors, "error")));
    }
    cases.extend(of_claims("checks", &report.events, None));
    for test in &report.tests {
        let mut case = of_claims(&test.name, &test.events, Some(test.verdict))
            .unwrap_or_else(|| JunitCase::new(&test.name, test.verdict, String::new()));
        case.line = line(report, test.span.start);
        if let Some(error) = test.errors.first() {
            case.message.clone_from(error);
        }
        cases.push(case);
    }
    cases.extend(tested.golden.as_ref().map(of_golden));
    cases
}

/// The line of a place.
fn line(report: &Report, start: u32) -> Option<usize> {
    let span = crate::diag::Span::new(start, start);
    report.sources.at(span).map(|source| source.line_column(start).0)
}

/// What some claims came to, told of the first that do not hold; none without claims.
fn of_claims(name: &str, events: &[Event], verdict: Option<TestVerdict>) -> Option<JunitCase> {
    let (mut n_claims, mut broken) = (0, Vec::new());
    for event in events {
        match event {
            Event::Checked(checked) => {
                n_claims += 1;
                if !checked.verdict.holds {
                    let claim = checked.message.as_deref().unwrap_or(&checked.source);
                    broken.push(format!("check failed: {claim}"));
                }
            }
            Event::Expected(expected) => {
                n_claims += 1;
                if !expected.holds() {
                    let code = expected.code.id();
                    broken.push(format!("error {code} was expected: {}", expected.source));
                }
            }
            Event::Printed(_) | Event::File(_) => {}
        }
    }
    if n_claims == 0 {
        return None;
    }
    let of_them = if broken.is_empty() { TestVerdict::Passed } else { TestVerdict::Failed };
    let message = broken.first().cloned().unwrap_or_default();
    let case = JunitCase::new(name, verdict.unwrap_or(of_them), message);
    Some(JunitCase { details: broken.join("\n"), ..case })
}

fn of_golden(golden: &GoldenOutcome) -> JunitCase {
    let case =
        |verdict, message: &str| JunitCase::new("golden folder", verdict, message.to_owned());
    match golden {
        GoldenOutcome::Same(_) | GoldenOutcome::Blessed(..) => case(TestVerdict::Passed, ""),
        GoldenOutcome::Skipped => case(TestVerdict::Skipped, "the script has errors"),
        GoldenOutcome::Unusable(message) => case(TestVerdict::Wrong, message),
        GoldenOutcome::Apart(apart) => {
            let details: Vec<String> = apart.iter().map(super::golden::Difference::text).collect();
            let message = counted(apart.len(), "difference");
            JunitCase { details: details.join("\n"), ..case(TestVerdict::Failed, &message) }
        }
    }
}

/// Writes the suites into a file, whole or not at all.
pub(super) fn write(path: &Path, suites: &[JunitSuite]) -> io::Result<()> {
    let text = text(suites);
    replace(path, None, |out| out.write_all(text.as_bytes()))
}

fn text(suites: &[JunitSuite]) -> String {
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let all = || suites.iter().flat_map(|suite| &suite.cases);
    let seconds: f64 = suites.iter().map(|suite| suite.seconds).sum();
    let _ = writeln!(out, "<testsuites name=\"virote\"{} time=\"{seconds:.3}\">", counts(all()));
    for suite in suites {
        let name = escaped(&suite.name);
        let counts = counts(suite.cases.iter());
        let seconds = suite.seconds;
        let _ = writeln!(out, "  <testsuite name=\"{name}\"{counts} time=\"{seconds:.3}\">");
        suite.cases.iter().for_each(|case| push_case(&mut out, case, &name));
        if !suite.findings.is_empty() {
            let _ = writeln!(out, "    <system-err>{}</system-err>", escaped(&suite.findings));
        }
        out.push_str("  </testsuite>\n");
    }
    out + "</testsuites>\n"
}

/// How many cases there are, and how they came out, as attributes.
fn counts<'a>(cases: impl Iterator<Item = &'a JunitCase> + Clone) -> String {
    let count = |verdict| cases.clone().filter(|case| case.verdict == verdict).count();
    format!(
        " tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\"",
        cases.clone().count(),
        count(TestVerdict::Failed),
        count(TestVerdict::Wrong),
        count(TestVerdict::Skipped)
    )
}

/// Adds a case of the suite called `suite`.
fn push_case(out: &mut String, case: &JunitCase, suite: &str) {
    let name = escaped(&case.name);
    let _ = write!(out, "    <testcase name=\"{name}\" classname=\"{suite}\" file=\"{suite}\"");
    if let Some(line) = case.line {
        let _ = write!(out, " line=\"{line}\"");
    }
    let element = match case.verdict {
        TestVerdict::Passed => {
            out.push_str("/>\n");
            return;
        }
        TestVerdict::Failed => "failure",
        TestVerdict::Wrong => "error",
        TestVerdict::Skipped => "skipped",
    };
    let (message, details) = (escaped(&case.message), escaped(&case.details));
    let _ = writeln!(out, ">\n      <{element} message=\"{message}\">{details}</{element}>");
    out.push_str("    </testcase>\n");
}

/// Text as XML holds it, in attributes too; what XML has no place for is replaced.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\n' => out.push_str("&#10;"),
            '\t' => out.push('\t'),
            '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            other if other.is_control() => out.push('\u{fffd}'),
            other => out.push(other),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::escaped;

    #[test]
    fn text_is_escaped_for_attributes_and_elements() {
        assert_eq!(escaped("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; &gt; d");
        assert_eq!(escaped("one\ntwo\u{0}\u{1b}\u{ffff}é"), "one&#10;two\u{fffd}\u{fffd}\u{fffd}é");
    }
}
