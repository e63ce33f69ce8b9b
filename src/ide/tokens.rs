//! The words of a text with what they are, for colours that know the script.

use std::ops::Range;

use super::{Document, NameRole};
use crate::{syntax::Highlight, value::Registry};

/// What a word is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// A word of the language.
    Keyword,
    /// A definition.
    Variable,
    /// A parameter of a function, a label.
    Parameter,
    /// A variable of a comprehension, or a `param` of the script.
    Setting,
    /// A function.
    Function,
    /// A field.
    Property,
    /// An imported file.
    Namespace,
    /// A number.
    Number,
    /// A string.
    Text,
    /// A comment.
    Comment,
    /// An operator.
    Operator,
}

impl TokenKind {
    /// Every kind, in the order of its number.
    pub const ALL: [Self; 11] = [
        Self::Keyword,
        Self::Variable,
        Self::Parameter,
        Self::Setting,
        Self::Function,
        Self::Property,
        Self::Namespace,
        Self::Number,
        Self::Text,
        Self::Comment,
        Self::Operator,
    ];
}

/// A word with what it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SemanticToken {
    /// Its bytes.
    pub range: Range<usize>,
    /// What it is.
    pub kind: TokenKind,
    /// Whether it is defined here.
    pub is_declaration: bool,
    /// Whether it is built in.
    pub is_built_in: bool,
}

impl Document {
    /// The words of the text in order.
    #[must_use]
    pub fn tokens(&self, registry: &Registry) -> Vec<SemanticToken> {
        (0..self.pieces.len()).filter_map(|idx| self.token(idx, registry)).collect()
    }

    fn token(&self, idx: usize, registry: &Registry) -> Option<SemanticToken> {
        let (paint, range) = self.pieces[idx].clone();
        let token = |kind| SemanticToken {
            range: range.clone(),
            kind,
            is_declaration: false,
            is_built_in: false,
        };
        let is_called = self.piece(idx + 1) == "(";
        let text = self.piece(idx);
        Some(match paint {
            Highlight::Bad => return None,
            Highlight::Number => token(TokenKind::Number),
            Highlight::Text => token(TokenKind::Text),
            Highlight::Comment => token(TokenKind::Comment),
            Highlight::Mark => match text.chars().all(|c| "()[]{},;.:".contains(c)) {
                true => return None,
                false => token(TokenKind::Operator),
            },
            Highlight::Keyword if !(is_called && registry.get(text).is_some()) => {
                token(TokenKind::Keyword)
            }
            Highlight::Keyword | Highlight::Name => {
                let before = idx.checked_sub(1).map_or("", |before| self.piece(before));
                if let Some(name) = self.definition_of(&range) {
                    let is_declaration = self.outline.defined_at(&range).is_some();
                    // A name that an import lists is what it is in the other file.
                    let role = self.imported_role(&range).unwrap_or(name.role);
                    return Some(SemanticToken { is_declaration, ..token(kind(role)) });
                }
                let is_label = self.piece(idx + 1) == "=" && matches!(before, "(" | ",");
                if before == "." || self.piece(idx + 1) == ":" {
                    token(TokenKind::Property)
                } else if is_label {
                    token(TokenKind::Parameter)
                } else if registry.get(text).is_some() {
                    SemanticToken { is_built_in: true, ..token(TokenKind::Function) }
                } else if registry.constant(text).is_some() {
                    SemanticToken { is_built_in: true, ..token(TokenKind::Variable) }
                } else {
                    return None;
                }
            }
        })
    }
}

fn kind(role: NameRole) -> TokenKind {
    match role {
        NameRole::Param | NameRole::Variable => TokenKind::Setting,
        NameRole::Function => TokenKind::Function,
        NameRole::Import => TokenKind::Namespace,
        NameRole::Definition(_) => TokenKind::Variable,
        NameRole::Parameter => TokenKind::Parameter,
    }
}
