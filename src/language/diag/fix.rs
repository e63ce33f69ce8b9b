//! Hints as edits: what an editor can carry out at one press.

use super::{Diagnostic, Span};

/// An edit that would mend a finding, or a good part of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// What it does, in the imperative: "write `bezier`".
    pub title: String,
    /// The places and what stands there afterwards, none inside of another.
    pub edits: Vec<(Span, String)>,
}

impl Fix {
    /// `text` in the place of `span`.
    pub fn replace(span: Span, text: impl Into<String>) -> Self {
        let text = text.into();
        Self { title: format!("write `{}`", text.trim()), edits: vec![(span, text)] }
    }

    /// Another ending in a string with a file's name; none where the string is not written as it reads.
    ///
    /// ```
    /// use virote_language::diag::{Fix, Span};
    ///
    /// let fix = Fix::ending(Span::new(7, 16), "x.stepp", "stepp", "step").expect("it is written so");
    /// assert_eq!(fix.edits, [(Span::new(10, 15), "step".to_owned())]);
    /// // What no script says.
    /// assert!(Fix::ending(Span::default(), "x.stepp", "stepp", "step").is_none());
    /// ```
    pub fn ending(string: Span, name: &str, ending: &str, near: &str) -> Option<Self> {
        /// Quotation marks around it.
        const QUOTED: usize = 2;
        if (string.end - string.start) as usize != name.len() + QUOTED {
            return None;
        }
        let end = string.end - 1;
        let span = Span { start: end - u32::try_from(ending.len()).ok()?, end };
        Some(Self { title: format!("write `.{near}`"), edits: vec![(span, near.to_owned())] })
    }

    /// Another name at the end of a string with a file's path; none where the string cannot end so.
    #[must_use]
    pub fn file_name(string: Span, name: &str, near: &str) -> Option<Self> {
        let end = string.end.checked_sub(1)?;
        let start = end.checked_sub(u32::try_from(name.len()).ok()?)?;
        let span = Span { start, end };
        let title = format!("write `{near}`");
        (string.start < start).then(|| Self { title, edits: vec![(span, near.to_owned())] })
    }

    /// `text` at `span`, which is empty.
    pub fn insert(span: Span, text: impl Into<String>) -> Self {
        let text = text.into();
        Self { title: format!("insert `{}`", text.trim()), edits: vec![(span, text)] }
    }

    /// Nothing in the place of `span`.
    #[must_use]
    pub fn remove(span: Span, what: &str) -> Self {
        Self { title: format!("remove `{what}`"), edits: vec![(span, String::new())] }
    }
}

impl Diagnostic {
    /// The culprit is a slip for `word`.
    #[must_use]
    pub fn meant(self, word: &str) -> Self {
        let fix = Fix::replace(self.primary.span, word);
        self.label(format!("did you mean `{word}`?")).fix(fix)
    }

    /// An edit that mends it.
    #[must_use]
    pub fn fix(mut self, fix: Fix) -> Self {
        self.fixes.push(fix);
        self
    }
}
