//! Findings with the files that their places lie in, and the edits that would mend them.

use std::ops::Range;

use super::TextEdit;
use crate::diag::{Diagnostic, Fix, Sources, Span};

/// A place in a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceRange {
    /// The number of the text among the sources: 0 is the script itself.
    pub source: usize,
    /// Its bytes.
    pub range: Range<usize>,
}

impl SourceRange {
    /// The place of a span, widened to a character where it is empty.
    #[must_use]
    pub fn of(sources: &Sources, span: Span) -> Self {
        let source = sources.iter().take_while(|source| source.base <= span.start).count();
        let number = source.saturating_sub(1);
        let range = sources.at(span).map(|source| source.local(span)).unwrap_or_default();
        Self { source: number, range }
    }
}

/// A finding at its place.
#[derive(Clone, Debug)]
pub struct Finding<'d> {
    /// What was found.
    pub diagnostic: &'d Diagnostic,
    /// Where.
    pub place: SourceRange,
    /// Remarks elsewhere.
    pub others: Vec<(SourceRange, &'d str)>,
}

impl<'d> Finding<'d> {
    /// A finding of a run.
    #[must_use]
    pub fn of(sources: &Sources, diagnostic: &'d Diagnostic) -> Self {
        let others = diagnostic.others.iter();
        Self {
            diagnostic,
            place: SourceRange::of(sources, diagnostic.primary.span),
            others: others
                .map(|label| (SourceRange::of(sources, label.span), label.text.as_str()))
                .collect(),
        }
    }

    /// The message with the remark at its place and the hints.
    #[must_use]
    pub fn sentences(&self) -> String {
        let Diagnostic { message, primary, hints, .. } = self.diagnostic;
        let remark = (!primary.text.is_empty()).then(|| format!("\n{}", primary.text));
        let hints: String = hints.iter().map(|hint| format!("\nhint: {hint}")).collect();
        format!("{message}{}{hints}", remark.unwrap_or_default())
    }
}

/// The fixes of a finding whose edits all lie in the script itself: what each is called, and its edits.
#[must_use]
pub fn fixes<'d>(sources: &Sources, found: &'d Diagnostic) -> Vec<(&'d str, Vec<TextEdit>)> {
    let edits = |fix: &'d Fix| -> Option<Vec<TextEdit>> {
        let edit = |(span, text): &(Span, String)| {
            let place = SourceRange::of(sources, *span);
            let script = &sources.iter().next()?.text;
            let before = script.get(place.range.clone())?;
            let is_spaced = script.get(place.range.end..)?.starts_with(' ');
            // A string takes the place of a string only: what computes one is not a slip.
            let is_odd = text.starts_with('"')
                && before.chars().any(|c| "({[+".contains(c))
                && !before.starts_with('"');
            // A space that stands there already is not written once more.
            let text = if is_spaced { text.trim_end_matches(' ') } else { text };
            (place.source == 0 && !is_odd)
                .then(|| TextEdit { range: place.range, text: text.to_owned() })
        };
        fix.edits.iter().map(edit).collect()
    };
    found.fixes.iter().filter_map(|fix| Some((fix.title.as_str(), edits(fix)?))).collect()
}
