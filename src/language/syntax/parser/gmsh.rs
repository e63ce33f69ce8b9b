//! Recognises a script that is written for Gmsh, whose language has the same file ending.

use crate::diag::{Code, Diagnostic};
use crate::syntax::lexed::Lexed;
use crate::syntax::token::Token;

/// Commands of Gmsh, and how the same looks here.
const COMMANDS: &[(&str, &str)] = &[
    ("Point", "`Point(1) = {0, 0, 0};` is `point p1 = (0, 0, 0)`"),
    ("Line", "`Line(1) = {1, 2};` is `curve c1 = line(p1, p2)`"),
    ("Circle", "`Circle(1) = {1, 2, 3};` is `curve c1 = arc(p2, r, from, to)`"),
    ("Ellipse", "`Ellipse(1) = {...};` is `curve c1 = ellipse(p1, rx, ry)`"),
    ("Spline", "`Spline(1) = {1, 2, 3};` is `curve c1 = interpolate([p1, p2, p3])`"),
    ("BSpline", "`BSpline(1) = {1, 2, 3, 4};` is `curve c1 = clamped([p1, p2, p3, p4])`"),
    ("Bezier", "`Bezier(1) = {1, 2, 3};` is `curve c1 = bezier([p1, p2, p3])`"),
    ("Curve", "`Curve Loop(1) = {1, 2, 3};` is `let loop = [c1, c2, c3]`"),
    ("Plane", "`Plane Surface(1) = {1};` is `surface s1 = edge_surface([c1, c2, c3])`"),
    ("Surface", "`Surface(1) = {1};` is `surface s1 = edge_surface([c1, c2, c3])`"),
    ("Extrude", "`Extrude {0, 0, 1} { Curve{1}; }` is `surface s1 = extrude(c1, (0, 0, 1))`"),
    ("Rotate", "`Rotate {...} { Curve{1}; }` is `curve c2 = rotate(c1, 90deg)`"),
    ("Translate", "`Translate {0, 0, 1} { Curve{1}; }` is `curve c2 = translate(c1, (0, 0, 1))`"),
    ("SetFactory", COMMON),
    ("Physical", COMMON),
    ("Transfinite", COMMON),
    ("Recombine", COMMON),
    ("Compound", COMMON),
    ("Volume", COMMON),
    ("Field", COMMON),
    ("Mesh", COMMON),
    ("Include", COMMON),
    ("Merge", COMMON),
    ("Box", COMMON),
    ("Sphere", COMMON),
    ("Cylinder", COMMON),
];

const COMMON: &str = "`Point(1) = {0, 0, 0};` is `point p1 = (0, 0, 0)`";

/// The one thing to say about a script for Gmsh; `None` when it is not one.
pub(super) fn recognise(lexed: &Lexed<'_>) -> Option<Diagnostic> {
    let mut commands = (0..lexed.tokens.len()).filter_map(|at| command(lexed, at));
    let (at, hint) = commands.next()?;
    let message = "this is a script for Gmsh, a language with the same file ending";
    Some(
        Diagnostic::error(Code::GmshScript, lexed.span(at), message)
            .label("a command of Gmsh")
            .hint(format!("in this language {hint}"))
            .hint("open such a file with Gmsh"),
    )
}

/// The hint for the command of Gmsh that begins with token `at`, if one does.
fn command(lexed: &Lexed<'_>, at: usize) -> Option<(usize, &'static str)> {
    if lexed.tokens[at] != Token::Name {
        return None;
    }
    let known = |at: usize| COMMANDS.iter().find(|(name, _)| *name == lexed.text(at));
    let (name, hint) = known(at)?;
    let before = at.checked_sub(1).map_or(Token::Semicolon, |before| lexed.tokens[before]);
    let begins = matches!(before, Token::Semicolon | Token::CloseBrace) || lexed.begins_line(at);
    let is_command = match lexed.token(at + 1) {
        Token::OpenParen => *name == "SetFactory" || is_assigned(lexed, at + 1),
        Token::OpenBrace => true,
        Token::Name => known(at + 1).is_some() || lexed.is_word(at + 1, "Loop"),
        Token::Text => matches!(*name, "Include" | "Merge"),
        Token::Dot => *name == "Mesh",
        _ => false,
    };
    (begins && is_command).then_some((at, hint))
}

/// The parenthesis behind a command of Gmsh has at most so many tokens.
const TAG: usize = 32;

/// Whether the parenthesis that opens at token `open` is followed by `=`.
fn is_assigned(lexed: &Lexed<'_>, open: usize) -> bool {
    let mut depth = 0_usize;
    for at in open..lexed.tokens.len().min(open + TAG) {
        match lexed.tokens[at] {
            Token::OpenParen | Token::LineParen => depth += 1,
            Token::CloseParen if depth <= 1 => return lexed.token(at + 1) == Token::Equals,
            Token::CloseParen => depth -= 1,
            Token::Semicolon => return false,
            _ => {}
        }
    }
    false
}
