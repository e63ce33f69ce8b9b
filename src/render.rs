//! Diagnostics as pictures of the source, drawn by ariadne, and as lines of JSON.

use std::borrow::Cow;

use ariadne::{CharSet, Color, Config, IndexType, Label, Report, ReportKind};
use serde_json::{Value as Json, json};

use crate::diag::{Diagnostic, Severity, Source, Sources, Span, is_hidden, shown};

/// A place as ariadne names it: the source's name, and bytes of its text.
type AriadneSpan = (String, std::ops::Range<usize>);

/// Draws one diagnostic.
#[must_use]
pub fn picture(diagnostic: &Diagnostic, sources: &Sources, with_color: bool) -> String {
    let diagnostic = &spelled(diagnostic);
    let (kind, color) = match diagnostic.severity {
        Severity::Error => (ReportKind::Error, Color::Red),
        Severity::Failure => (ReportKind::Custom("Failed", Color::Red), Color::Red),
        Severity::Warning => (ReportKind::Warning, Color::Yellow),
    };
    let Some(primary) = place(diagnostic.primary.span, sources) else {
        return format!("[{}] {}\n", diagnostic.code.id(), diagnostic.message);
    };
    if has_long_line(diagnostic, sources) {
        return without_picture(diagnostic, sources);
    }
    // The renderer counts bytes, as the lexer does.
    let config = Config::new()
        .with_index_type(IndexType::Byte)
        .with_color(with_color)
        .with_char_set(CharSet::Unicode);
    let mut report = Report::build(kind, primary.clone())
        .with_config(config)
        .with_code(diagnostic.code.id())
        .with_message(&diagnostic.message);
    // The renderer keeps lines together only when labels come in the order of the text.
    let mut labels = vec![(primary, primary_text(diagnostic), color)];
    let others = diagnostic.others.iter();
    labels.extend(
        others.filter_map(|label| {
            Some((place(label.span, sources)?, label.text.as_str(), Color::Blue))
        }),
    );
    labels.sort_by(|(a, ..), (b, ..)| (&a.0, a.1.start).cmp(&(&b.0, b.1.start)));
    for (place, text, color) in labels {
        report = report.with_label(Label::new(place).with_message(text).with_color(color));
    }
    for hint in hints(diagnostic) {
        report = report.with_help(hint);
    }
    let texts =
        sources.iter().map(|source| (shown(&source.name).into(), shown(&source.text).into()));
    let texts = texts.collect::<Vec<(String, String)>>();
    let mut out = Vec::new();
    // Writing into memory cannot fail.
    let _ = report.finish().write(ariadne::sources(texts), &mut out);
    let text = String::from_utf8_lossy(&out);
    let text = if with_color { text } else { without_escapes(&text).into() };
    text.lines().map(str::trim_end).collect::<Vec<_>>().join("\n") + "\n"
}

/// What to do: what the finding says itself, and which ceiling was crossed. A door that can move it says
/// how, in a hint, and takes [`Diagnostic::ceiling`] away.
#[must_use]
pub fn hints(diagnostic: &Diagnostic) -> Vec<String> {
    let ceiling = |name| format!("the ceiling on `{name}` can be moved");
    diagnostic.hints.iter().cloned().chain(diagnostic.ceiling.map(ceiling)).collect()
}

/// The same with all texts as they may stand on a terminal.
fn spelled(diagnostic: &Diagnostic) -> Diagnostic {
    let mut spelled = diagnostic.clone();
    let labels = std::iter::once(&mut spelled.primary).chain(&mut spelled.others);
    let texts = labels.map(|label| &mut label.text).chain(&mut spelled.hints);
    for text in texts.chain([&mut spelled.message]) {
        if let Cow::Owned(new) = shown(text) {
            *text = new;
        }
    }
    spelled
}

/// Bytes of a line that a picture shows; longer ones are no picture any more.
const MOST_BYTES_A_LINE: usize = 1000;

/// Whether a place is on a line that is too long to be shown.
fn has_long_line(diagnostic: &Diagnostic, sources: &Sources) -> bool {
    std::iter::once(&diagnostic.primary).chain(&diagnostic.others).any(|label| {
        let Some(source) = sources.at(label.span) else { return false };
        let range = source.local(label.span);
        let before =
            source.text[..range.start].bytes().rev().take_while(|&byte| byte != b'\n').count();
        let after = source.text[range.start..].bytes().take_while(|&byte| byte != b'\n').count();
        before + after > MOST_BYTES_A_LINE
    })
}

/// Letters of a word that are shown where the source is not; of longer ones the beginning and the end.
const MOST_LETTERS_A_WORD: usize = 200;

/// The text with the middle of endless words left out.
fn with_short_words(text: &str) -> String {
    let shortened = |word: &str| {
        let n_letters = word.chars().count();
        if n_letters <= MOST_LETTERS_A_WORD {
            return word.to_owned();
        }
        let half = MOST_LETTERS_A_WORD / 2;
        let first: String = word.chars().take(half).collect();
        let last: String = word.chars().skip(n_letters - half).collect();
        format!("{first}…{last}")
    };
    text.split_inclusive([' ', '\n']).map(shortened).collect()
}

/// A diagnostic in lines of text, where the source cannot be shown.
fn without_picture(diagnostic: &Diagnostic, sources: &Sources) -> String {
    let mut text = format!("[{}] {}\n", diagnostic.code.id(), diagnostic.message);
    let others = diagnostic.others.iter().map(|label| (label.span, label.text.as_str()));
    for (span, remark) in
        std::iter::once((diagnostic.primary.span, primary_text(diagnostic))).chain(others)
    {
        if let Some(source) = sources.at(span) {
            let (line, column) = source.line_column(span.start);
            let name = shown(&source.name);
            text.push_str(&format!("   {name}:{line}:{column}: {remark}\n"));
        }
    }
    hints(diagnostic).iter().for_each(|hint| text.push_str(&format!("   Help: {hint}\n")));
    with_short_words(&text)
}

/// The text without escape sequences: the renderer paints the name of a kind of our own even where
/// colour is off.
fn without_escapes(text: &str) -> String {
    let mut parts = text.split("\x1b[");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |plain, part| plain + part.split_once('m').map_or(part, |(_, rest)| rest))
}

/// What stands at the culprit; the renderer underlines nothing that has no remark.
fn primary_text(diagnostic: &Diagnostic) -> &str {
    match diagnostic.primary.text.as_str() {
        "" if diagnostic.message.starts_with(diagnostic.code.title()) => "here",
        "" => diagnostic.code.title(),
        text => text,
    }
}

/// The place of a span in its source, at least one character wide.
fn place(span: Span, sources: &Sources) -> Option<AriadneSpan> {
    let source: &Source = sources.at(span)?;
    let mut range = source.local(span);
    if range.is_empty() {
        match source.text[range.start..].chars().next().filter(|c| *c != '\n') {
            Some(next) => range.end += next.len_utf8(),
            None => range.start = source.text.floor_char_boundary(range.start.saturating_sub(1)),
        }
    }
    // The picture shows the text with what is hidden spelled out.
    let spelled = |end: usize| shown(&source.text[..end]).len();
    let range = if source.text.contains(is_hidden) {
        spelled(range.start)..spelled(range.end)
    } else {
        range
    };
    Some((shown(&source.name).into(), range))
}

/// One diagnostic as one JSON object.
#[must_use]
pub fn json(diagnostic: &Diagnostic, sources: &Sources) -> Json {
    let severity = match diagnostic.severity {
        Severity::Error => "error",
        Severity::Failure => "failure",
        Severity::Warning => "warning",
    };
    let mut labels = vec![location(diagnostic.primary.span, &diagnostic.primary.text, sources)];
    labels.extend(diagnostic.others.iter().map(|label| location(label.span, &label.text, sources)));
    json!({
        "type": "diagnostic",
        "severity": severity,
        "code": diagnostic.code.id(),
        "message": diagnostic.message,
        "labels": labels,
        "hints": hints(diagnostic),
    })
}

fn location(span: Span, text: &str, sources: &Sources) -> Json {
    let Some(source) = sources.at(span) else { return json!({ "text": text }) };
    let (line, column) = source.line_column(span.start);
    let (end_line, end_column) = source.line_column(span.end);
    let bytes = source.local(span);
    json!({
        "file": source.name,
        "line": line,
        "column": column,
        "end_line": end_line,
        "end_column": end_column,
        "start_byte": bytes.start,
        "end_byte": bytes.end,
        "text": text,
    })
}
