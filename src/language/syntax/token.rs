//! The kinds of tokens: one byte each; a token's text is looked up in the source by its span.

use logos::Logos;

use super::block_comment::block_comment;

/// Declares the tokens once: their kinds, their spellings, the list of keywords.
macro_rules! tokens {
    (
        statements { $($statement:ident $statement_text:tt)+ }
        keywords { $($keyword:ident $keyword_text:tt)+ }
        marks { $($mark:ident $mark_text:tt)+ }
        others { $($(#[$attribute:meta])* $other:ident $other_text:tt)+ }
    ) => {
        /// The kind of a token. Statement keywords come first, then the other keywords.
        #[derive(Logos, Clone, Copy, Debug, PartialEq, Eq)]
        #[logos(skip r"[\s\u{feff}]+")]
        #[repr(u8)]
        pub(super) enum Token {
            $( #[token($statement_text)] $statement, )+
            $( #[token($keyword_text)] $keyword, )+
            $( #[token($mark_text)] $mark, )+
            $( $(#[$attribute])* $other, )+
        }

        /// Every keyword of the language.
        pub const KEYWORDS: &[&str] = &[ $($statement_text,)+ $($keyword_text,)+ ];

        impl Token {
            /// Every kind, in order.
            pub(super) const ALL: &'static [Self] =
                &[ $(Self::$statement,)+ $(Self::$keyword,)+ $(Self::$mark,)+ $(Self::$other,)+ ];
            /// The keywords that begin statements.
            pub(super) const STATEMENTS: &'static [Self] = &[ $(Self::$statement,)+ ];
            const TEXTS: &'static [&'static str] =
                &[ $($statement_text,)+ $($keyword_text,)+ $($mark_text,)+ $($other_text,)+ ];
        }
    };
}

tokens! {
    statements {
        Geo "geo" Unit "unit" Tolerance "tolerance" Param "param" Let "let" Fn "fn"
        Point "point" Curve "curve" Surface "surface" Mesh "mesh" Table "table"
        Points "points" Curves "curves" Surfaces "surfaces" Meshes "meshes" Tables "tables"
        Check "check" Print "print" Export "export" Import "import" Test "test"
    }
    keywords {
        In "in" With "with" As "as" To "to" For "for" If "if" Then "then" Else "else"
        And "and" Or "or" Not "not" True "true" False "false" None "none" Within "within"
    }
    marks {
        OpenParen "(" CloseParen ")" OpenBracket "[" CloseBracket "]" OpenBrace "{" CloseBrace "}"
        Comma "," Colon ":" Semicolon ";" Dot "." Range ".." RangeBelow "..<" Spread "..."
        Equals "=" Arrow "=>" Pipe "|>"
        Equal "==" NotEqual "!=" Less "<" LessEqual "<=" Greater ">" GreaterEqual ">=" Near "~="
        Plus "+" Minus "-" Star "*" Slash "/" Percent "%" Caret "^"
    }
    others {
        #[token("_", priority = 9)]
        Placeholder "_"
        #[regex(r"[\p{XID_Start}_]\p{XID_Continue}*")]
        Name "a name"
        // A unit is taken whatever its letters are, so that the parser can name the nearest one.
        #[regex(r"[0-9][0-9_]*(\.[0-9][0-9_]*)?([eE][+-]?[0-9]+)?(\p{XID_Start}\p{XID_Continue}*)?")]
        Number "a number"
        #[token("\"")]
        Text "a string"
        // `"a {x} {y} b"` is head, x, middle, y, tail; the lexer makes them of quotes and braces.
        TextHead "a string"
        TextMiddle "the rest of the string"
        TextTail "the rest of the string"
        // `:.3mm` before the brace that ends an interpolated expression; the lexer makes it of a colon.
        TextFormat "a format"
        // Brackets and minus that begin a line never continue an expression.
        LineParen "("
        LineBracket "["
        LineMinus "-"
        // Never in the stream: comments go into a list of their own.
        #[regex(r"//[^\n]*", allow_greedy = true)]
        LineComment "a comment"
        #[token("/*", block_comment)]
        BlockComment "a comment"
        // Habits from other languages; the lexer reports them and goes on with what is meant.
        #[token("&&")] #[token("&")] #[token("||")] #[token("|")] #[token("!")] #[token(":=")]
        #[token("->")] #[token("**")] #[token("<>")] #[token("===")] #[token("+=")] #[token("-=")]
        #[token("°")] #[token("−")] #[token("×")] #[token("·")] #[token("÷")]
        #[token("≤")] #[token("≥")] #[token("≠")] #[token("≈")] #[token("…")]
        Foreign "text that means nothing"
        #[regex(r"'[^'\n]*'")] #[regex(r"[“”„‟][^“”„‟\x22\n]*[“”„‟\x22]")] #[regex(r"[‘’][^‘’\n]*[‘’]")]
        ForeignText "text that means nothing"
        #[token("#")]
        Hash "text that means nothing"
        // Already reported; stands in the stream to keep the parser in step.
        Bad "text that means nothing"
        End "the end of the script"
    }
}

impl Token {
    /// Its spelling, or what it is.
    pub(super) fn text(self) -> &'static str {
        Self::TEXTS[self as usize]
    }

    /// As it is called in messages: spellings in backquotes.
    pub(super) fn shown(self) -> String {
        match self {
            Self::Name
            | Self::Number
            | Self::Text
            | Self::TextHead
            | Self::TextMiddle
            | Self::TextTail
            | Self::TextFormat
            | Self::Bad
            | Self::End => self.text().to_owned(),
            _ => format!("`{}`", self.text()),
        }
    }

    /// Whether it is a keyword that begins a statement.
    pub(super) fn begins_statement(self) -> bool {
        self as u8 <= Self::Test as u8
    }

    /// Whether it is a keyword.
    pub(super) fn is_keyword(self) -> bool {
        self as u8 <= Self::Within as u8
    }

    /// Whether it is a name or a keyword, which may be a label.
    pub(super) fn is_word(self) -> bool {
        self == Self::Name || self.is_keyword()
    }

    /// Whether it is also the name of a built-in, before an opening bracket.
    pub(super) fn names_built_in(self) -> bool {
        matches!(self, Self::Mesh | Self::Table)
    }

    /// Whether it begins a definition: what a block may hold.
    pub(super) fn begins_definition(self) -> bool {
        (Self::Let as u8..=Self::Tables as u8).contains(&(self as u8))
    }

    /// Whether an expression may begin with it.
    pub(super) fn begins_expression(self) -> bool {
        matches!(
            self,
            Self::Name
                | Self::Number
                | Self::Text
                | Self::TextHead
                | Self::OpenParen
                | Self::LineParen
                | Self::OpenBracket
                | Self::LineBracket
                | Self::OpenBrace
                | Self::Minus
                | Self::LineMinus
                | Self::Not
                | Self::If
                | Self::True
                | Self::False
                | Self::None
                | Self::Placeholder
        )
    }

    /// Whether an expression may end with it.
    pub(super) fn ends_expression(self) -> bool {
        matches!(
            self,
            Self::Name
                | Self::Number
                | Self::Text
                | Self::TextTail
                | Self::CloseParen
                | Self::CloseBracket
                | Self::CloseBrace
                | Self::True
                | Self::False
                | Self::None
                | Self::Placeholder
                | Self::Bad
        )
    }

    /// Whether it stands between two operands, `^` and `-` included.
    pub(super) fn is_infix(self) -> bool {
        (Self::Equal as u8..=Self::Caret as u8).contains(&(self as u8))
            || matches!(
                self,
                Self::Range | Self::RangeBelow | Self::Pipe | Self::And | Self::Or | Self::Within
            )
    }

    /// Whether it opens a bracket or an interpolation.
    pub(super) fn opens(self) -> bool {
        matches!(
            self.anywhere(),
            Self::OpenParen | Self::OpenBracket | Self::OpenBrace | Self::TextHead
        )
    }

    /// Whether it closes a bracket or an interpolation.
    pub(super) fn closes(self) -> bool {
        matches!(self, Self::CloseParen | Self::CloseBracket | Self::CloseBrace | Self::TextTail)
    }

    /// The same token without regard to its line.
    pub(super) fn anywhere(self) -> Self {
        match self {
            Self::LineParen => Self::OpenParen,
            Self::LineBracket => Self::OpenBracket,
            Self::LineMinus => Self::Minus,
            other => other,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Token;

    #[test]
    fn kinds_are_numbered_in_the_order_of_their_texts() {
        for (index, token) in Token::ALL.iter().enumerate() {
            assert_eq!(*token as usize, index);
        }
        assert!(Token::Test.begins_statement() && !Token::In.begins_statement());
        assert!(Token::Within.is_keyword() && !Token::OpenParen.is_keyword());
    }
}
