//! Places and kinds in the protocol's words.

use std::ops::Range;

use lsp_types::{CompletionItemKind, DiagnosticSeverity, Position, SymbolKind};

use crate::{
    diag::Severity,
    ide::{ColumnUnit, CompletionKind, LineColumn, LineIndex, NameRole, TextEdit},
    syntax::ast::Kind,
};

/// A text with what turns its bytes into lines and columns.
#[derive(Clone, Copy, Debug)]
pub(super) struct TextPlaces<'a> {
    pub(super) text: &'a str,
    pub(super) lines: &'a LineIndex,
    pub(super) unit: ColumnUnit,
}

impl TextPlaces<'_> {
    pub(super) fn position(&self, at: usize) -> Position {
        let LineColumn { line, column } = self.lines.position(self.text, at, self.unit);
        Position::new(line as u32, column as u32)
    }

    pub(super) fn range(&self, range: &Range<usize>) -> lsp_types::Range {
        lsp_types::Range::new(self.position(range.start), self.position(range.end))
    }

    pub(super) fn offset(&self, at: Position) -> usize {
        let at = LineColumn { line: at.line as usize, column: at.character as usize };
        self.lines.offset(self.text, at, self.unit)
    }

    /// The bytes of a range, whose ends may stand the wrong way around.
    pub(super) fn bytes(&self, range: &lsp_types::Range) -> Range<usize> {
        let (start, end) = (self.offset(range.start), self.offset(range.end));
        start.min(end)..start.max(end)
    }

    pub(super) fn edits(&self, edits: &[TextEdit]) -> Vec<lsp_types::TextEdit> {
        let edit =
            |edit: &TextEdit| lsp_types::TextEdit::new(self.range(&edit.range), edit.text.clone());
        edits.iter().map(edit).collect()
    }
}

pub(super) fn severity(severity: Severity) -> DiagnosticSeverity {
    match severity {
        Severity::Error => DiagnosticSeverity::ERROR,
        Severity::Failure | Severity::Warning => DiagnosticSeverity::WARNING,
    }
}

pub(super) fn completion_kind(kind: CompletionKind) -> CompletionItemKind {
    match kind {
        CompletionKind::Label => CompletionItemKind::PROPERTY,
        CompletionKind::Field => CompletionItemKind::FIELD,
        CompletionKind::Choice => CompletionItemKind::ENUM_MEMBER,
        CompletionKind::File => CompletionItemKind::FILE,
        CompletionKind::Unit => CompletionItemKind::UNIT,
        CompletionKind::Local | CompletionKind::Definition => CompletionItemKind::VARIABLE,
        CompletionKind::Function | CompletionKind::BuiltIn => CompletionItemKind::FUNCTION,
        CompletionKind::Import => CompletionItemKind::MODULE,
        CompletionKind::Constant => CompletionItemKind::CONSTANT,
        CompletionKind::Keyword => CompletionItemKind::KEYWORD,
    }
}

/// What a definition is; a test where there is no role.
pub(super) fn symbol_kind(role: Option<NameRole>) -> SymbolKind {
    match role {
        None => SymbolKind::EVENT,
        Some(NameRole::Param) => SymbolKind::PROPERTY,
        Some(NameRole::Function) => SymbolKind::FUNCTION,
        Some(NameRole::Import) => SymbolKind::MODULE,
        Some(NameRole::Definition(Kind::Let)) => SymbolKind::CONSTANT,
        Some(NameRole::Definition(kind)) if kind.is_geometry() => SymbolKind::OBJECT,
        Some(NameRole::Definition(_)) => SymbolKind::ARRAY,
        Some(NameRole::Parameter | NameRole::Variable) => SymbolKind::VARIABLE,
    }
}
