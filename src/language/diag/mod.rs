//! What went wrong and where, as data. Ground floor: depends on nothing in the crate.
//!
//! Nothing here is coloured, wrapped or printed; the doors do that.

mod code;
pub mod fault;
mod fix;
mod nearest;
mod shown;
mod source;

pub use code::{Code, RETIRED};
pub use fix::Fix;
pub use nearest::nearest;
pub use shown::{is_hidden, shown};
pub use source::{Source, Sources};

/// Half-open byte range.
///
/// Inside `syntax` it counts from the start of the text that is parsed; everywhere else from the
/// start of all sources laid end to end, so that eight bytes name a place in any file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default, PartialOrd, Ord)]
pub struct Span {
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl Span {
    /// The range `start..end`.
    #[must_use]
    pub const fn new(start: u32, end: u32) -> Self {
        Self { start, end }
    }

    /// From the start of `self` to the end of `other`.
    #[must_use]
    pub fn to(self, other: Self) -> Self {
        Self { start: self.start, end: other.end }
    }

    /// The empty range at the start.
    #[must_use]
    pub fn at_start(self) -> Self {
        Self { start: self.start, end: self.start }
    }

    /// The empty range at the end.
    #[must_use]
    pub fn at_end(self) -> Self {
        Self { start: self.end, end: self.end }
    }

    /// The range moved `by` bytes to the right.
    #[must_use]
    pub fn shifted(self, by: u32) -> Self {
        Self { start: self.start + by, end: self.end + by }
    }

    /// As indices into a text.
    #[must_use]
    pub fn range(self) -> std::ops::Range<usize> {
        self.start as usize..self.end as usize
    }
}

/// A value together with the place where it was written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spanned<T> {
    /// The value.
    pub value: T,
    /// Where it stands.
    pub span: Span,
}

impl<T> Spanned<T> {
    /// `value` at `span`.
    pub fn new(value: T, span: Span) -> Self {
        Self { value, span }
    }

    /// `value` without a place, as the default of a parameter.
    pub fn unplaced(value: T) -> Self {
        Self { value, span: Span::default() }
    }

    /// The place, or another where this value has none.
    #[must_use]
    pub fn span_or(&self, other: Span) -> Span {
        if self.span == Span::default() { other } else { self.span }
    }

    /// The same place with another value.
    pub fn map<U>(self, f: impl FnOnce(T) -> U) -> Spanned<U> {
        Spanned { value: f(self.value), span: self.span }
    }
}

/// How grave a finding is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The script is wrong; its result does not exist.
    Error,
    /// A claim of the script does not hold.
    Failure,
    /// The result exists, but not all of what was asked could be promised.
    Warning,
}

/// A remark at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// The remark; may be empty.
    pub text: String,
}

/// One finding for the person who wrote the script.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Stable identity; `virote explain` tells more.
    pub code: Code,
    /// How grave it is.
    pub severity: Severity,
    /// What is wrong: one sentence in the user's words, lower case, no full stop.
    pub message: String,
    /// The culprit.
    pub primary: Label,
    /// Causes and counterparts elsewhere.
    pub others: Vec<Label>,
    /// What to do; each a sentence.
    pub hints: Vec<String>,
    /// Hints that are edits, the likeliest first.
    pub fixes: Vec<Fix>,
    /// The name of the ceiling that was crossed ([`Ceiling::name`](crate::limits::Ceiling::name)), if it
    /// can be moved.
    pub ceiling: Option<&'static str>,
    /// Whether the text ends where something is missing: what is typed next may complete it.
    pub is_at_end: bool,
    /// Elements of the list at the culprit that it is about, each by its indices, outermost first;
    /// whoever has the text at hand points at them.
    pub elements: Vec<Vec<usize>>,
}

/// How many findings are errors.
pub(crate) fn n_errors(findings: &[Diagnostic]) -> usize {
    findings.iter().filter(|found| found.severity == Severity::Error).count()
}

/// The message alone, for whoever knows no places.
impl std::fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Diagnostic {}

/// Result of whatever can fail at a place in a script.
pub type Result<T> = std::result::Result<T, Box<Diagnostic>>;

impl Diagnostic {
    /// An error at `span`.
    pub fn error(code: Code, span: Span, message: impl Into<String>) -> Self {
        Self {
            code,
            severity: Severity::Error,
            message: message.into(),
            primary: Label { span, text: String::new() },
            others: Vec::new(),
            hints: Vec::new(),
            fixes: Vec::new(),
            ceiling: None,
            is_at_end: false,
            elements: Vec::new(),
        }
    }

    /// A warning at `span`, with the code of one.
    pub fn warning(code: Code, span: Span, message: impl Into<String>) -> Self {
        debug_assert!(!code.is_error(), "{} is the code of an error", code.id());
        Self { severity: Severity::Warning, ..Self::error(code, span, message) }
    }

    /// The remark at the culprit itself.
    #[must_use]
    pub fn label(mut self, text: impl Into<String>) -> Self {
        self.primary.text = text.into();
        self
    }

    /// A remark at another place.
    #[must_use]
    pub fn also(mut self, span: Span, text: impl Into<String>) -> Self {
        self.others.push(Label { span, text: text.into() });
        self
    }

    /// What to do about it.
    #[must_use]
    pub fn hint(mut self, text: impl Into<String>) -> Self {
        self.hints.push(text.into());
        self
    }

    /// The ceiling of this name was crossed.
    #[must_use]
    pub fn crossing(self, ceiling: &'static str) -> Self {
        Self { ceiling: Some(ceiling), ..self }
    }

    /// All places moved `by` bytes to the right.
    #[must_use]
    pub fn shifted(mut self, by: u32) -> Self {
        for label in std::iter::once(&mut self.primary).chain(&mut self.others) {
            label.span = label.span.shifted(by);
        }
        for (span, _) in self.fixes.iter_mut().flat_map(|fix| &mut fix.edits) {
            *span = span.shifted(by);
        }
        self
    }

    /// As the failure of a [`Result`].
    pub fn fail<T>(self) -> Result<T> {
        Err(Box::new(self))
    }
}
