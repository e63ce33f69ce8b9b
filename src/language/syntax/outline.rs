//! What a prompt and an editor ask of a text without running it: its colours, whether it is
//! complete, its statements with the names that they define.

use std::ops::Range;

use super::{
    ast::{Pattern, Statement, StatementKind},
    lexed::Lexed,
    lexer::lex,
    parser::parse,
    token::Token,
};
use crate::{
    diag::{Code, Diagnostic},
    limits::Limits,
};

/// How a piece of text is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Highlight {
    /// A word of the language.
    Keyword,
    /// A name.
    Name,
    /// A number, its unit included.
    Number,
    /// A piece of a string.
    Text,
    /// A comment.
    Comment,
    /// An operator, a bracket, or the placeholder.
    Mark,
    /// Text that means nothing.
    Bad,
}

/// The pieces of a text in order, with their places in bytes; white space is left out.
///
/// ```
/// use virote_language::syntax::{Highlight, pieces};
///
/// let found: Vec<Highlight> = pieces("let a = 2mm // two").into_iter().map(|(paint, _)| paint).collect();
/// assert_eq!(found, [Highlight::Keyword, Highlight::Name, Highlight::Mark, Highlight::Number, Highlight::Comment]);
/// ```
#[must_use]
pub fn pieces(source: &str) -> Vec<(Highlight, Range<usize>)> {
    let lexed = lex(source, 0);
    let mut found: Vec<(Highlight, Range<usize>)> = lexed
        .tokens
        .iter()
        .zip(&lexed.spans)
        .filter(|(token, _)| **token != Token::End)
        .map(|(&token, span)| (paint(token), span.range()))
        .collect();
    found.extend(lexed.comments.iter().map(|comment| (Highlight::Comment, comment.span.range())));
    found.sort_by_key(|(_, range)| range.start);
    found
}

fn paint(token: Token) -> Highlight {
    match token {
        _ if token.is_keyword() => Highlight::Keyword,
        Token::Name => Highlight::Name,
        Token::Number => Highlight::Number,
        Token::Text | Token::TextHead | Token::TextMiddle | Token::TextTail => Highlight::Text,
        Token::Bad | Token::Foreign | Token::ForeignText | Token::Hash => Highlight::Bad,
        _ => Highlight::Mark,
    }
}

/// What somebody types at a prompt.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PromptEntry {
    /// Nothing but white space and comments.
    Empty,
    /// An expression, or several with commas between them.
    Expression,
    /// Statements.
    Statements,
}

/// What kind of entry a text is.
#[must_use]
pub fn entry(source: &str) -> PromptEntry {
    let lexed = lex(source, 0);
    // `a = 3` lacks its keyword: the parser of statements says so best.
    let lacks_keyword = lexed.token(0) == Token::Name && lexed.token(1) == Token::Equals;
    if lexed.token(0) == Token::End {
        if lexed.comments.iter().any(|comment| comment.is_doc) {
            PromptEntry::Statements
        } else {
            PromptEntry::Empty
        }
    } else if lexed.begins_statement(0) || lacks_keyword {
        PromptEntry::Statements
    } else {
        PromptEntry::Expression
    }
}

/// Whether an entry is complete: no bracket or comment is open, and nothing is missing at its end.
#[must_use]
pub fn is_complete(source: &str, limits: &Limits) -> bool {
    let is_open = |found: &Diagnostic| {
        matches!(found.code, Code::UnclosedBracket | Code::UnclosedComment) || found.is_at_end
    };
    let found = match entry(source) {
        PromptEntry::Empty => parse(source, limits).1,
        PromptEntry::Statements => {
            let lexed = lex(source, 0);
            // Documentation waits for its definition.
            let is_doc_last = lexed
                .comments
                .last()
                .is_some_and(|comment| comment.is_doc && comment.before + 1 == lexed.tokens.len());
            if is_doc_last {
                return false;
            }
            parse(source, limits).1
        }
        PromptEntry::Expression => parse(&format!("print {source}"), limits).1,
    };
    !found.iter().any(is_open)
}

/// What a statement is to a document that grows statement by statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StatementRole {
    /// `geo`, `unit`, `tolerance`: at most one of each.
    Setting(&'static str),
    /// A definition, a parameter, a function, an import.
    Definition,
    /// `check`
    Check,
    /// `print`
    Print,
    /// `export`
    Export,
    /// `test`
    Test,
}

/// A statement of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutlinedStatement {
    /// Its place, with the comments before it.
    pub range: Range<usize>,
    /// What it is.
    pub role: StatementRole,
    /// The names that it defines.
    pub names: Vec<String>,
}

/// The statements of a text that can be parsed; whatever stands behind the last one is its own.
///
/// # Errors
/// What is wrong with the text.
pub fn parts(source: &str, limits: &Limits) -> Result<Vec<OutlinedStatement>, Vec<Diagnostic>> {
    let (tree, found) = parse(source, limits);
    if !found.is_empty() {
        return Err(found);
    }
    let mut start = 0;
    let mut parts = Vec::with_capacity(tree.statements.len());
    for statement in &tree.statements {
        let end = behind(source, statement.span.end as usize);
        let (role, names) = role(statement);
        parts.push(OutlinedStatement { range: start..end, role, names });
        start = end;
    }
    if let Some(last) = parts.last_mut() {
        last.range.end = source.len();
    }
    Ok(parts)
}

/// The end of a statement with the comment that follows on its line.
fn behind(source: &str, end: usize) -> usize {
    let line = source[end..].split('\n').next().unwrap_or_default();
    let rest = line.trim_start().trim_start_matches(';').trim_start();
    if rest.is_empty() || rest.starts_with("//") { end + line.len() } else { end }
}

fn role(statement: &Statement<'_>) -> (StatementRole, Vec<String>) {
    let one = |name: &str| vec![name.to_owned()];
    let none = Vec::new();
    match &statement.kind {
        StatementKind::Edition(_) => (StatementRole::Setting("geo"), none),
        StatementKind::Unit(_) => (StatementRole::Setting("unit"), none),
        StatementKind::Tolerance(_) => (StatementRole::Setting("tolerance"), none),
        StatementKind::Param(param) => (StatementRole::Definition, one(param.name.text)),
        StatementKind::Function(function) => (StatementRole::Definition, one(function.name.text)),
        StatementKind::Definition(definition) => {
            let names = match &definition.pattern {
                Pattern::Anonymous => none,
                Pattern::Name(name) => one(name.text),
                Pattern::List(names, _) | Pattern::Record(names, _) => {
                    names.iter().map(|name| name.text.to_owned()).collect()
                }
            };
            (StatementRole::Definition, names)
        }
        StatementKind::Import(import) => {
            let names = match (&import.alias, &import.names) {
                (Some(alias), _) => one(alias.text),
                (None, Some(names)) => names.iter().map(|name| name.text.to_owned()).collect(),
                (None, None) => none,
            };
            (StatementRole::Definition, names)
        }
        StatementKind::Check { .. } => (StatementRole::Check, none),
        StatementKind::Print(_) => (StatementRole::Print, none),
        StatementKind::Export(_) => (StatementRole::Export, none),
        StatementKind::Test { .. } | StatementKind::ExpectError { .. } | StatementKind::Error => {
            (StatementRole::Test, none)
        }
    }
}

/// The placeholders of an expression that stand for a value of their own: all but those among the
/// arguments of a call of several, which make a function of it.
///
/// ```
/// use virote_language::syntax::free_placeholders;
///
/// assert_eq!(free_placeholders("_ * 2 + length(_)"), [0..1, 15..16]);
/// assert!(free_placeholders("s(0.5, _)").is_empty());
/// ```
#[must_use]
pub fn free_placeholders(source: &str) -> Vec<Range<usize>> {
    let lexed = lex(source, 0);
    let is_free = |at: usize| {
        let (before, after) = (at.checked_sub(1).map(|at| lexed.token(at)), lexed.token(at + 1));
        let begins = matches!(before, Some(Token::OpenParen | Token::Comma | Token::Equals));
        let ends = matches!(after, Token::CloseParen | Token::Comma);
        let is_argument = begins && ends && is_in_call(&lexed, at);
        let is_alone = before == Some(Token::OpenParen) && after == Token::CloseParen;
        !is_argument || is_alone
    };
    let places = (0..lexed.tokens.len()).filter(|&at| lexed.token(at) == Token::Placeholder);
    places.filter(|&at| is_free(at)).map(|at| lexed.span(at).range()).collect()
}

/// Whether the innermost bracket around token `at` is that of a call.
fn is_in_call(lexed: &Lexed<'_>, at: usize) -> bool {
    opening(lexed, at).is_some_and(|open| {
        lexed.token(open) == Token::OpenParen
            && open.checked_sub(1).is_some_and(|before| lexed.token(before).ends_expression())
    })
}

/// The innermost bracket that is open before token `at`.
pub(super) fn opening(lexed: &Lexed<'_>, at: usize) -> Option<usize> {
    let mut depth = 0_usize;
    for before in (0..at).rev() {
        let token = lexed.token(before);
        if token.closes() {
            depth += 1;
        } else if token.opens() {
            match depth.checked_sub(1) {
                Some(less) => depth = less,
                None => return Some(before),
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::{PromptEntry, entry, is_complete, parts};
    use crate::limits::Limits;

    #[test]
    fn an_entry_goes_on_until_it_is_complete() {
        for whole in
            ["1 + 1", "let a = 2", "// x", "", "[1, 2]", "let a = )", "fn f(x) = x", "a = 3"]
        {
            assert!(is_complete(whole, &Limits::DEFAULT), "{whole}");
        }
        for half in ["1 +", "let a", "[1, 2", "f(1,", "/* x", "if a then 1", "/// doc", "let a = {"]
        {
            assert!(!is_complete(half, &Limits::DEFAULT), "{half}");
        }
    }

    #[test]
    fn an_entry_is_an_expression_unless_it_begins_like_a_statement() {
        assert_eq!(entry("table({x: [1]})"), PromptEntry::Expression);
        assert_eq!(entry("mesh([], [])"), PromptEntry::Expression);
        assert_eq!(entry("mesh m = mesh([], [])"), PromptEntry::Statements);
        assert_eq!(entry("point p = (0, 0)"), PromptEntry::Statements);
        assert_eq!(entry("  // nothing"), PromptEntry::Empty);
    }

    #[test]
    fn statements_keep_their_comments() {
        let text = "// one\nlet a = 1 // first\nlet [b, c] = [2, 3]\ncheck a == 1\n// end";
        let parts = parts(text, &Limits::DEFAULT).unwrap();
        let texts: Vec<&str> = parts.iter().map(|part| &text[part.range.clone()]).collect();
        assert_eq!(
            texts,
            ["// one\nlet a = 1 // first", "\nlet [b, c] = [2, 3]", "\ncheck a == 1\n// end"]
        );
        assert_eq!(parts[1].names, ["b", "c"]);
    }
}
