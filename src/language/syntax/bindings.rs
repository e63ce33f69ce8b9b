//! Names that a text defines and that are known at its end, also where it does not parse yet: the parameters of
//! functions, the variables of comprehensions, the definitions before.

use std::ops::Range;

use super::{
    completion_place::open_code, lexed::Lexed, lexer::lex, outline::opening, token::Token,
};

/// A name that is defined before a place and known there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Binding {
    /// Its place.
    pub name: Range<usize>,
    /// What it stands for, if a definition says so.
    pub value: Option<Range<usize>>,
    /// What a variable of a comprehension runs over.
    pub source: Option<Range<usize>>,
}

/// The names that a text defines and that are known at its end.
///
/// ```
/// use virote_language::syntax::bindings;
///
/// let text = "fn f(a, by = 2) = [for [b, c] in grid(a, size = 3) if b: x => max(x, ";
/// let names: Vec<&str> = bindings(text).into_iter().map(|one| &text[one.name]).collect();
/// assert_eq!(names, ["f", "a", "by", "b", "c", "x"]);
/// ```
#[must_use]
pub fn bindings(source: &str) -> Vec<Binding> {
    let lexed = lex(source, 0);
    let levels = vec![BracketLevel::default()];
    let mut walk = BindingWalk { lexed: &lexed, levels, statement: None };
    (0..lexed.tokens.len()).for_each(|at| walk.token(at));
    let mut found: Vec<Binding> =
        walk.levels.into_iter().flat_map(|level| [level.known, level.passing].concat()).collect();
    let start = open_code(source);
    if 0 < start {
        let shifted = |range: Range<usize>| range.start + start..range.end + start;
        found.extend(bindings(&source[start..]).into_iter().map(|one| Binding {
            name: shifted(one.name),
            value: one.value.map(shifted),
            source: one.source.map(shifted),
        }));
    }
    found
}

/// What is known between two brackets, as far as it was read.
#[derive(Default)]
struct BracketLevel {
    known: Vec<Binding>,
    /// Known up to the next comma or statement: parameters.
    passing: Vec<Binding>,
    /// Known from the next statement on: what is being defined.
    coming: Vec<Binding>,
    /// Whether it is a comprehension, in which a comma brings the next variable.
    is_comprehension: bool,
}

struct BindingWalk<'l, 's> {
    lexed: &'l Lexed<'s>,
    /// The open brackets, outermost first.
    levels: Vec<BracketLevel>,
    /// The first token of the statement under way.
    statement: Option<usize>,
}

impl BindingWalk<'_, '_> {
    fn level(&mut self) -> &mut BracketLevel {
        let last = self.levels.len() - 1;
        &mut self.levels[last]
    }

    fn binding(&self, at: usize) -> Binding {
        Binding { name: self.lexed.span(at).range(), value: None, source: None }
    }

    fn token(&mut self, at: usize) {
        let token = self.lexed.token(at);
        // `solid s = ...`: a kind that is no keyword.
        let is_word_kind = token == Token::Name
            && self.lexed.token(at + 1) == Token::Name
            && self.lexed.token(at + 2) == Token::Equals;
        let begins_statement = is_word_kind || self.lexed.begins_statement(at);
        // The value of a block follows its definitions without a word.
        let begins_value = token.begins_expression()
            && !matches!(
                token,
                Token::OpenParen | Token::OpenBracket | Token::OpenBrace | Token::Minus
            )
            && at.checked_sub(1).is_some_and(|before| {
                self.lexed.token(before).ends_expression() && self.statement != Some(before)
            });
        if begins_statement || begins_value || token == Token::Semicolon {
            self.end_statement(at);
        }
        if begins_statement {
            self.statement = Some(at);
            self.statement(at);
        }
        match token {
            _ if token.opens() => self.levels.push(BracketLevel::default()),
            _ if token.closes() && 1 < self.levels.len() => {
                self.levels.pop();
            }
            Token::Arrow => {
                let parameters = self.before_arrow(at);
                self.level().passing.extend(parameters);
            }
            Token::Comma => {
                self.level().passing.clear();
                if self.level().is_comprehension {
                    self.variables(at + 1);
                }
            }
            Token::For => {
                self.level().is_comprehension = true;
                self.variables(at + 1);
            }
            _ => {}
        }
    }

    /// What the statement before token `at` defines is known from here on.
    fn end_statement(&mut self, at: usize) {
        let end = self.lexed.gap(at).end as usize;
        let level = self.level();
        level.passing.clear();
        let defined = std::mem::take(&mut level.coming).into_iter();
        level.known.extend(defined.map(|one| Binding {
            value: one.value.filter(|value| value.start < end).map(|value| value.start..end),
            ..one
        }));
    }

    /// What the statement that begins with token `at` defines.
    fn statement(&mut self, at: usize) {
        let lexed = self.lexed;
        if lexed.token(at) == Token::Fn {
            if lexed.token(at + 1) == Token::Name {
                let name = self.binding(at + 1);
                self.level().known.push(name);
            }
            let parameters = self.parameters(at + 2);
            self.level().passing.extend(parameters);
        } else {
            let (names, behind) = self.pattern(at + 1);
            if matches!(lexed.token(behind), Token::Equals | Token::Colon) {
                let is_whole = lexed.token(at + 1) == Token::Name;
                let is_value = is_whole && lexed.token(behind) == Token::Equals;
                // Its end is known when the next statement begins.
                let start = lexed.span(behind + 1).range().start;
                let value = is_value.then_some(start..start);
                self.level()
                    .coming
                    .extend(names.into_iter().map(|name| Binding { value: value.clone(), ..name }));
            }
        }
    }

    /// The names of a name, `[a, b]` or `{a, b}` at token `at`, and the token behind.
    fn pattern(&self, at: usize) -> (Vec<Binding>, usize) {
        let lexed = self.lexed;
        match lexed.token(at).anywhere() {
            Token::Name => (vec![self.binding(at)], at + 1),
            Token::OpenBracket | Token::OpenBrace => {
                let is_inside = |&at: &usize| matches!(lexed.token(at), Token::Name | Token::Comma);
                let inside = (at + 1..).take_while(is_inside);
                let (names, commas): (Vec<usize>, Vec<usize>) =
                    inside.partition(|&at| lexed.token(at) == Token::Name);
                let behind = at + names.len() + commas.len() + 2;
                (names.into_iter().map(|at| self.binding(at)).collect(), behind)
            }
            _ => (Vec::new(), at),
        }
    }

    /// The variables of a comprehension at token `at`, with what they run over.
    fn variables(&mut self, at: usize) {
        let (names, behind) = self.pattern(at);
        if self.lexed.token(behind) != Token::In {
            return;
        }
        let end = self.end_of_item(behind + 1);
        let source = self.lexed.place(behind + 1, end).range();
        // What a part of an element is, its source does not tell.
        let is_whole = self.lexed.token(at) == Token::Name && behind + 1 < end;
        let source = is_whole.then_some(source);
        let names = names.into_iter().map(|name| Binding { source: source.clone(), ..name });
        self.level().known.extend(names);
    }

    /// The end of what begins with token `at` and ends before a comma, a colon, `if` or the bracket around it.
    fn end_of_item(&self, at: usize) -> usize {
        let mut depth = 0_usize;
        for behind in at.. {
            match self.lexed.token(behind) {
                Token::End => return behind,
                token if token.opens() => depth += 1,
                token if token.closes() && depth == 0 => return behind,
                token if token.closes() => depth -= 1,
                Token::Comma | Token::Colon | Token::If if depth == 0 => return behind,
                _ => {}
            }
        }
        at
    }

    /// The names of the parameters in the brackets that open with token `at`.
    fn parameters(&self, at: usize) -> Vec<Binding> {
        let mut found = Vec::new();
        let mut depth = 0_usize;
        for inside in at.. {
            let token = self.lexed.token(inside);
            match token {
                Token::End => break,
                _ if token.opens() => depth += 1,
                _ if token.closes() => depth = depth.saturating_sub(1),
                Token::Name if depth == 1 => {
                    let before = self.lexed.token(inside - 1).anywhere();
                    if matches!(before, Token::OpenParen | Token::Comma) {
                        found.push(self.binding(inside));
                    }
                }
                _ => {}
            }
            if depth == 0 {
                break;
            }
        }
        found
    }

    /// The parameters before the arrow at token `at`.
    fn before_arrow(&self, at: usize) -> Vec<Binding> {
        let Some(last) = at.checked_sub(1) else { return Vec::new() };
        match self.lexed.token(last) {
            Token::Name => vec![self.binding(last)],
            Token::CloseParen => {
                opening(self.lexed, last).map(|open| self.parameters(open)).unwrap_or_default()
            }
            _ => Vec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::bindings;

    #[test]
    fn what_is_known_at_a_place_is_found_in_text_that_does_not_parse() {
        for (text, names) in [
            ("let a = circle(center = (0, 0), radius = ", ""),
            ("let a = {let b = 1 let c = f(d = 2, ", "b"),
            ("let a = 1\nlet b = ", "a"),
            ("let {p, q} = r print ", "p q"),
            ("let a = map(xs, x => x + 1, ", ""),
            ("let a = map(xs, x => x + ", "x"),
            ("let a = fold(xs, 0, (sum, x) => sum + ", "sum x"),
            ("fn f(x, y = g(z = 2)) = x", "f x y"),
            ("fn f(x) = x\nprint ", "f"),
            ("let a = [for i in 0..3, j in 0..i: ", "i j"),
            ("let a = [for i in 0..3: i] + [", ""),
            ("print \"{[for r in rs: r", "r"),
            ("param a: angle = 3 param b = ", "a"),
            ("curve circle(", ""),
            ("solid s = t region r = f(", "s"),
            ("let b = { let inner = {zeta: 3} inner.", "inner"),
            ("let b = { let inner = 3mm; in", "inner"),
        ] {
            let found: Vec<&str> = bindings(text).into_iter().map(|one| &text[one.name]).collect();
            assert_eq!(found.join(" "), names, "{text}");
        }
        let text = "{ let a = f(b, 2)\n  a.";
        assert_eq!(bindings(text)[0].value.clone().map(|value| &text[value]), Some("f(b, 2)"));
        let text = "[for r in f(a, b) if r: r.";
        assert_eq!(bindings(text)[0].source.clone().map(|source| &text[source]), Some("f(a, b)"));
    }
}
