//! The script beside the tokens that the rules of the grammar read.

use std::ops::Deref;

use crate::diag::Diagnostic;
use crate::limits::Limits;
use crate::syntax::lexed::Lexed;

/// The script while it is parsed.
#[derive(Debug)]
pub(super) struct ParsedScript<'t, 's> {
    pub(super) lexed: &'t Lexed<'s>,
    pub(super) limits: Limits,
    /// Findings that did not stop the rule that made them.
    pub(super) diagnostics: Vec<Diagnostic>,
}

impl<'s> Deref for ParsedScript<'_, 's> {
    type Target = Lexed<'s>;

    fn deref(&self) -> &Self::Target {
        self.lexed
    }
}

impl ParsedScript<'_, '_> {
    /// Records a finding.
    pub(super) fn complain(&mut self, diagnostic: Diagnostic) {
        if self.diagnostics.len() < super::most_diagnostics(&self.limits) {
            self.diagnostics.push(diagnostic);
        }
    }
}
