//! What a run says: lines for people, or JSON for programs.
//!
//! Lines: what the script prints and writes goes to standard output, findings to standard error.
//! JSON: everything is an object on a line of standard output, findings included.

use std::{collections::BTreeMap, time::Duration};

use serde_json::json;

use super::{
    run_args::{MessageFormat, OutputArgs},
    standard_streams::{say, say_error, say_exactly, say_painted},
};
use crate::{
    diag::{Diagnostic, Severity, Sources},
    eval::{Checked, ExpectedMistake, Printed},
    export::Summary,
    render,
    session::{TestReport, TestVerdict},
    value::to_json,
};

/// Says things in one of the two ways.
#[derive(Debug)]
pub(super) struct Reporter {
    is_json: bool,
    is_quiet: bool,
    with_color: bool,
    most_findings: usize,
    at_prompt: bool,
}

impl Reporter {
    /// Colours what is told from now on, or not.
    pub(super) fn paint(&mut self, with_color: bool) {
        self.with_color = with_color;
    }

    pub(super) fn new(talk: &OutputArgs, most_findings: usize) -> Self {
        Self {
            is_json: talk.message_format == MessageFormat::Json,
            is_quiet: talk.quiet,
            with_color: talk.with_color(),
            most_findings,
            at_prompt: false,
        }
    }

    /// Tells how to move a ceiling in the words of the prompt.
    pub(super) fn at_prompt(self) -> Self {
        Self { at_prompt: true, ..self }
    }

    /// Whether people want to see that something happens.
    pub(super) fn is_lively(&self) -> bool {
        !self.is_json && !self.is_quiet
    }

    /// A finding with what moves the ceiling that was crossed.
    fn with_remedy(&self, found: &Diagnostic) -> Diagnostic {
        let mut found = found.clone();
        if let Some(ceiling) = found.ceiling.take() {
            found.hints.push(match self.at_prompt {
                true => format!("`:set {ceiling} N` moves this ceiling"),
                false => format!("`--limit {ceiling}=N` moves this ceiling"),
            });
        }
        found
    }

    /// Findings: the first of them as pictures, the rest counted; in JSON all of them.
    pub(super) fn findings(&self, diagnostics: &[Diagnostic], sources: &Sources) {
        if self.is_json {
            let lines: String = diagnostics
                .iter()
                .map(|found| format!("{}\n", render::json(&self.with_remedy(found), sources)))
                .collect();
            say_exactly(&lines);
            return;
        }
        let is_heard = |found: &&Diagnostic| !self.is_quiet || found.severity != Severity::Warning;
        let heard: Vec<&Diagnostic> = diagnostics.iter().filter(is_heard).collect();
        for found in heard.iter().take(self.most_findings) {
            let found = self.with_remedy(found);
            say_painted(render::picture(&found, sources, self.with_color).trim_end());
        }
        if heard.len() > self.most_findings {
            say_error(&format!("... and {} more", heard.len() - self.most_findings));
        }
    }

    /// A mistake that has no place in a script.
    pub(super) fn trouble(&self, text: &str) {
        if self.is_json {
            say_exactly(&format!("{}\n", json!({ "type": "trouble", "message": text })));
        } else {
            say_error(&format!("virote: {text}"));
        }
    }

    /// Something worth knowing about the run itself.
    pub(super) fn remark(&self, text: &str) {
        if self.is_json {
            say_exactly(&format!("{}\n", json!({ "type": "remark", "message": text })));
        } else if !self.is_quiet {
            say_error(text);
        }
    }

    /// A printed line; `test` is the test that prints it.
    pub(super) fn printed(&self, printed: &Printed, test: Option<&str>) {
        if self.is_json {
            let mut line = json!({
                "type": "print",
                "source": printed.source,
                "text": printed.value_text(),
                "value": to_json(&printed.value),
            });
            name_test(&mut line, test);
            say_exactly(&format!("{line}\n"));
        } else {
            say(&format!("{printed}\n"));
        }
    }

    /// A judged claim; `test` is the test that makes it.
    pub(super) fn checked(&self, checked: &Checked, sources: &Sources, test: Option<&str>) {
        if !self.is_json {
            return;
        }
        let source = sources.at(checked.span);
        let line = source.map(|source| source.line_column(checked.span.start).0);
        let sides: Vec<serde_json::Value> = checked
            .verdict
            .sides
            .iter()
            .map(|side| json!({ "path": side.path, "value": side.value }))
            .collect();
        let mut line = json!({
            "type": "check",
            "holds": checked.verdict.holds,
            "claim": checked.source,
            "message": checked.message,
            "file": source.map(|source| source.name.as_str()),
            "line": line,
            "sides": sides,
            "apart": checked.verdict.apart,
            "limit": checked.verdict.limit,
        });
        name_test(&mut line, test);
        say_exactly(&format!("{line}\n"));
    }

    pub(super) fn written(&self, path: &str, summary: Option<Summary>) {
        if self.is_json {
            let line = match summary {
                Some(summary) => json!({
                    "type": "export",
                    "path": path,
                    "vertices": summary.vertices,
                    "triangles": summary.triangles,
                    "surfaces": summary.surfaces,
                    "curves": summary.curves,
                    "points": summary.points,
                    "rows": summary.rows,
                    "values": summary.values,
                }),
                None => json!({ "type": "export", "path": path, "dry_run": true }),
            };
            say_exactly(&format!("{line}\n"));
        } else if !self.is_quiet {
            match summary {
                Some(summary) => say(&format!("wrote {path}: {summary}\n")),
                None => say(&format!("would write {path}\n")),
            }
        }
    }

    /// A page that was written.
    pub(super) fn page(&self, path: &str, n_bytes: usize) {
        if self.is_json {
            say_exactly(&format!(
                "{}\n",
                json!({ "type": "page", "path": path, "bytes": n_bytes })
            ));
        } else if !self.is_quiet {
            say(&format!("wrote {path}: {n_bytes} bytes\n"));
        }
    }

    /// An error that a test expects, and what happened.
    pub(super) fn expected(&self, expected: &ExpectedMistake, sources: &Sources, test: &str) {
        if !self.is_json {
            return;
        }
        let source = sources.at(expected.span);
        let (value, code, message) = match &expected.found {
            Ok(value) => (Some(value), None, None),
            Err(found) => (None, Some(found.code.id()), Some(&found.message)),
        };
        let line = json!({
            "type": "expect",
            "holds": expected.holds(),
            "subject": expected.source,
            "expected": expected.code.id(),
            "found": { "code": code, "message": message, "value": value },
            "file": source.map(|source| source.name.as_str()),
            "line": source.map(|source| source.line_column(expected.span.start).0),
            "test": test,
        });
        say_exactly(&format!("{line}\n"));
    }

    /// How a test came out.
    pub(super) fn tested(&self, tested: &TestReport, sources: &Sources) {
        let Some(source) = sources.at(tested.span) else { return };
        let line = source.line_column(tested.span.start).0;
        if self.is_json {
            let line = json!({
                "type": "test",
                "name": tested.name,
                "result": tested.verdict.word(),
                "file": source.name,
                "line": line,
            });
            say_exactly(&format!("{line}\n"));
        } else {
            self.result(tested.verdict, &format!("{}:{line}  {}", source.name, tested.name));
        }
    }

    /// A line for people that begins with how something came out.
    pub(super) fn result(&self, verdict: TestVerdict, text: &str) {
        let is_heard = !self.is_quiet || verdict != TestVerdict::Passed;
        if is_heard && !self.is_json {
            say(&format!("{:<7}  {text}\n", verdict.word()));
        }
    }

    /// How the golden folder of a script came out, with differences for people and for programs;
    /// `is_heard` is whether it is told even by the quiet.
    pub(super) fn golden(
        &self,
        word: &str,
        script: &str,
        text: &str,
        differences: &[(String, serde_json::Value)],
        is_heard: bool,
    ) {
        if self.is_json {
            let differences: Vec<_> = differences.iter().map(|(_, json)| json).collect();
            let line = json!({
                "type": "golden",
                "file": script,
                "result": word,
                "differences": differences,
            });
            say_exactly(&format!("{line}\n"));
        } else if is_heard || !self.is_quiet {
            say(&format!("{word:<7}  {script}  {text}\n"));
            differences.iter().for_each(|(text, _)| say(&format!("  {text}\n")));
        }
    }

    /// What a run of `watch` evaluated, how much it kept, and how long it took.
    pub(super) fn evaluated(&self, names: &[&str], n_kept: usize, time: Duration) {
        if self.is_json {
            let milliseconds = 1e3 * time.as_secs_f64();
            let line = json!({
                "type": "evaluated",
                "names": names,
                "kept": n_kept,
                "milliseconds": milliseconds,
            });
            say_exactly(&format!("{line}\n"));
            return;
        }
        let what = match names.len() {
            0 => "nothing".to_owned(),
            n => format!("{n}: {}", first_of(names)),
        };
        let kept = if n_kept == 0 { String::new() } else { format!(", kept {n_kept}") };
        self.remark(&format!("(evaluated {what}{kept}; {})", pretty(time)));
    }

    /// The last words of `test`; `figures` are the same for programs.
    pub(super) fn total(&self, text: &str, mut figures: serde_json::Value) {
        if self.is_json {
            figures["type"] = json!("total");
            say(&format!("{figures}\n"));
        } else if !self.is_quiet {
            say(&format!("{text}\n"));
        }
    }

    /// A script that `fmt` rewrote, or would.
    pub(super) fn formatted(&self, path: &str, is_written: bool) {
        if self.is_json {
            let line = json!({ "type": "format", "path": path, "dry_run": !is_written });
            say_exactly(&format!("{line}\n"));
        } else if !self.is_quiet {
            let verb = if is_written { "formatted" } else { "would format" };
            say(&format!("{verb} {path}\n"));
        }
    }

    /// What came of a study: how many rows, how many with failed checks, and how many with each error.
    pub(super) fn study(
        &self,
        path: &str,
        n_rows: u64,
        (n_failed, errors): (u64, &BTreeMap<String, u64>),
    ) {
        if self.is_json {
            let line = json!({
                "type": "study", "path": path, "rows": n_rows, "failed": n_failed, "errors": errors,
            });
            say_exactly(&format!("{line}\n"));
        } else if !self.is_quiet {
            let n_wrong: u64 = errors.values().sum();
            let codes: Vec<String> =
                errors.iter().map(|(code, n)| format!("{n} of {code}")).collect();
            let mut text = format!("wrote {path}: {n_rows} rows");
            if 0 < n_failed {
                text.push_str(&format!(", {n_failed} with failed checks"));
            }
            if 0 < n_wrong {
                text.push_str(&format!(", {n_wrong} with errors ({})", codes.join(", ")));
            }
            say(&format!("{text}\n"));
        }
    }

    /// The last line: how the checks came out.
    pub(super) fn verdict(&self, n_checks: usize, n_failed: usize) {
        if self.is_json || self.is_quiet || n_checks == 0 {
            return;
        }
        let checks = if n_checks == 1 { "check" } else { "checks" };
        match n_failed {
            0 => say(&format!("{n_checks} {checks} passed\n")),
            _ => say(&format!("{n_failed} of {n_checks} {checks} failed\n")),
        }
    }
}

/// The first of some names.
pub(super) fn first_of(names: &[&str]) -> String {
    /// Names that are listed.
    const MOST_NAMES: usize = 6;
    let more = if MOST_NAMES < names.len() { ", ..." } else { "" };
    names[..names.len().min(MOST_NAMES)].join(", ") + more
}

/// A time in a unit that suits it.
pub(super) fn pretty(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    if seconds < 1.0 { format!("{:.1} ms", 1e3 * seconds) } else { format!("{seconds:.2} s") }
}

/// Says in a line of JSON which test it comes from.
fn name_test(line: &mut serde_json::Value, test: Option<&str>) {
    if let Some(test) = test {
        line["test"] = json!(test);
    }
}

/// A count with its noun.
pub(super) fn counted(n: usize, noun: &str) -> String {
    if n == 1 { format!("1 {noun}") } else { format!("{n} {noun}s") }
}
