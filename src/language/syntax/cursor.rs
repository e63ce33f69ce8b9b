//! What stands around a place in a text, also of one that does not parse: the call that is open there.

use super::{
    completion_place::{open_code, operand_start},
    lexed::Lexed,
    lexer::lex,
    outline::opening,
    token::Token,
};

/// A call whose brackets are open at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OpenCall<'s> {
    /// What is called: a name, or the keyword before the brackets.
    pub name: &'s str,
    /// The same with what stands before its dot: `rec.f` of `rec.f(`.
    pub callee: &'s str,
    /// The first byte of the name.
    pub start: usize,
    /// The argument that the place belongs to, among those without a label; what is piped into the call
    /// counts.
    pub position: usize,
    /// The label of that argument.
    pub label: Option<&'s str>,
    /// The labels given before.
    pub labels: Vec<&'s str>,
    /// The keyword of the statement around it.
    pub statement: Option<&'s str>,
}

/// The innermost call that is open at byte `at` of a text.
///
/// ```
/// use virote_language::syntax::open_call;
///
/// let text = "let s = pull(ring((0, 0), 2), by = (0, 0, ";
/// assert!(open_call(text, text.len()).is_none(), "the innermost bracket is that of a point");
/// let call = open_call(text, text.len() - 7).expect("it is that of `pull`");
/// assert_eq!((call.name, call.position, call.label), ("pull", 1, Some("by")));
/// ```
#[must_use]
pub fn open_call(source: &str, at: usize) -> Option<OpenCall<'_>> {
    let source = source.get(..at)?;
    let code = open_code(source);
    let lexed = lex(&source[code..], 0);
    let end = lexed.tokens.len() - 1;
    let open = opening(&lexed, end)?;
    let callee = open.checked_sub(1)?;
    let is_bracket = matches!(lexed.token(open), Token::OpenParen | Token::LineParen);
    if !is_bracket || !lexed.token(callee).is_word() {
        return None;
    }
    let piped = callee.checked_sub(1).is_some_and(|before| lexed.token(before) == Token::Pipe);
    let mut found = OpenCall {
        name: lexed.text(callee),
        callee: {
            let from = lexed.span(operand_start(&lexed, callee)).range().start;
            &source[code + from..code + lexed.span(callee).range().end]
        },
        start: code + lexed.span(callee).range().start,
        position: usize::from(piped),
        label: None,
        labels: Vec::new(),
        statement: statement(&lexed, callee),
    };
    for token in lexed.outside_brackets(open + 1..end) {
        match lexed.token(token) {
            Token::Comma => match found.label.take() {
                Some(label) => found.labels.push(label),
                None => found.position += 1,
            },
            Token::Equals if lexed.token(token - 1).is_word() => {
                found.label = Some(lexed.text(token - 1));
            }
            _ => {}
        }
    }
    Some(found)
}

/// The first byte of the list whose bracket is the innermost one that is open at byte `at` of a text.
///
/// ```
/// use virote_language::syntax::open_list;
///
/// let text = "let s = skin([a, f(b), ";
/// assert_eq!(open_list(text, text.len()), Some(13));
/// assert_eq!(open_list(text, text.len() - 4), None, "that is a call");
/// ```
#[must_use]
pub fn open_list(source: &str, at: usize) -> Option<usize> {
    let source = source.get(..at)?;
    let code = open_code(source);
    let lexed = lex(&source[code..], 0);
    let open = opening(&lexed, lexed.tokens.len() - 1)?;
    let is_element =
        open.checked_sub(1).is_some_and(|before| lexed.token(before).ends_expression());
    (matches!(lexed.token(open), Token::OpenBracket | Token::LineBracket) && !is_element)
        .then(|| code + lexed.span(open).range().start)
}

/// The end of the brackets that a text begins with.
///
/// ```
/// use virote_language::syntax::end_of_brackets;
///
/// assert_eq!(end_of_brackets("(a, f(b)).c"), Some(9));
/// assert_eq!(end_of_brackets("(a"), None);
/// ```
#[must_use]
pub fn end_of_brackets(source: &str) -> Option<usize> {
    let lexed = lex(source, 0);
    let mut depth = 0_usize;
    for at in 0..lexed.tokens.len() {
        match lexed.token(at) {
            token if token.opens() => depth += 1,
            token if token.closes() => depth = depth.checked_sub(1)?,
            _ => {}
        }
        if depth == 0 {
            return (0 < at).then(|| lexed.span(at).range().end);
        }
    }
    None
}

/// The keyword of the statement in which token `at` stands.
fn statement<'s>(lexed: &Lexed<'s>, at: usize) -> Option<&'s str> {
    (0..=at).rev().find(|&at| lexed.begins_statement(at)).map(|at| lexed.text(at))
}

/// Whether a text is one name that a script can define.
///
/// ```
/// use virote_language::syntax::is_name;
///
/// assert!(is_name("größe_2") && !is_name("let") && !is_name("a b") && !is_name("_"));
/// ```
#[must_use]
pub fn is_name(text: &str) -> bool {
    let lexed = lex(text, 0);
    let is_whole = lexed.span(0).range() == (0..text.len());
    lexed.tokens.len() == 2 && lexed.token(0) == Token::Name && is_whole
}

#[cfg(test)]
mod tests {
    use super::open_call;

    #[test]
    fn a_place_counts_the_arguments_before_it() {
        let told = |text: &str| {
            let call = open_call(text, text.len()).unwrap();
            format!("{} {} {:?} {:?}", call.name, call.position, call.label, call.labels)
        };
        assert_eq!(told("f("), "f 0 None []");
        assert_eq!(told("f(a, (1, 2), "), "f 2 None []");
        assert_eq!(told("f(a, b = 2, c = "), "f 1 Some(\"c\") [\"b\"]");
        assert_eq!(told("x |> f("), "f 1 None []");
        assert_eq!(told("f(g(1, 2), h(1, "), "h 1 None []");
        assert_eq!(told("print \"a {f(b, "), "f 1 None []");
        let text = "export a to \"a.obj\" with (tol";
        assert_eq!(open_call(text, text.len()).unwrap().statement, Some("export"));
        assert!(open_call("f(a)", 4).is_none() && open_call("[1, ", 4).is_none());
    }
}
