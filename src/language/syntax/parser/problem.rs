//! Why a rule failed: a place and a set of what could have stood there, as bits.
//!
//! Making one allocates nothing; words are found for it in `explain`, once per report.

use chumsky::DefaultExpected;
use chumsky::error::{Error, LabelError};
use chumsky::prelude::SimpleSpan;
use chumsky::util::MaybeRef;

use crate::diag::Diagnostic;
use crate::syntax::token::Token;

/// The input of the grammar.
pub(super) type Tokens<'t> = &'t [Token];

/// The failure of a rule.
#[derive(Debug)]
pub(super) enum Problem {
    /// Something else was expected.
    Expected {
        /// The index of the token that was found.
        at: usize,
        /// What could have stood there.
        expected: ExpectedTokens,
    },
    /// A failure with words of its own.
    Told(Box<Diagnostic>),
}

/// What could stand at a place: a bit for each kind of token, then those of the constants.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(super) struct ExpectedTokens(u128);

/// The kinds of tokens leave the bits of the constants free.
const _: () = assert!((Token::End as u32) < 123);

impl ExpectedTokens {
    /// Any expression.
    pub(super) const EXPRESSION: Self = Self(1 << 127);
    /// A name.
    pub(super) const NAME: Self = Self(1 << 126);
    /// A statement.
    pub(super) const STATEMENT: Self = Self(1 << 125);
    /// A string.
    pub(super) const TEXT: Self = Self(1 << 124);
    /// The value of a block.
    pub(super) const VALUE: Self = Self(1 << 123);
    /// Those that are no tokens, in words.
    const LABELS: [(Self, &'static str); 5] = [
        (Self::EXPRESSION, "an expression"),
        (Self::NAME, "a name"),
        (Self::STATEMENT, "a statement"),
        (Self::TEXT, "a string"),
        (Self::VALUE, "the value of the block"),
    ];

    /// A token of this kind.
    pub(super) const fn token(token: Token) -> Self {
        Self(1 << token as u8)
    }

    /// Or a token of this kind.
    pub(super) const fn or(self, token: Token) -> Self {
        Self(self.0 | 1 << token as u8)
    }

    /// Whether it contains all of `other`.
    pub(super) fn has(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }

    /// Whether a token of this kind could stand there.
    pub(super) fn has_token(self, token: Token) -> bool {
        self.has(Self::token(token))
    }

    /// Its members in words: "`,` or `]`".
    pub(super) fn alternatives(self) -> String {
        let labels = Self::LABELS.iter().filter(|(label, _)| self.has(*label));
        let mut words: Vec<String> = labels.map(|&(_, text)| text.to_owned()).collect();
        words.extend(Token::ALL.iter().filter(|t| self.has_token(**t)).map(|t| t.shown()));
        match words.split_last() {
            None => "something else".to_owned(),
            Some((only, [])) => only.clone(),
            Some((last, others)) => format!("{} or {last}", others.join(", ")),
        }
    }
}

impl<'t> Error<'t, Tokens<'t>> for Problem {
    /// The grammar never goes back, so there is one failure at a time; the later one counts.
    fn merge(self, other: Self) -> Self {
        other
    }
}

impl<'t> LabelError<'t, Tokens<'t>, DefaultExpected<'t, Token>> for Problem {
    fn expected_found<E: IntoIterator<Item = DefaultExpected<'t, Token>>>(
        expected: E,
        _found: Option<MaybeRef<'t, Token>>,
        span: SimpleSpan,
    ) -> Self {
        let tokens = expected.into_iter().filter_map(|expected| match expected {
            DefaultExpected::Token(token) => Some(*token),
            DefaultExpected::EndOfInput => Some(Token::End),
            _ => None,
        });
        let expected = tokens.fold(ExpectedTokens::default(), ExpectedTokens::or);
        Self::Expected { at: span.start, expected }
    }
}
