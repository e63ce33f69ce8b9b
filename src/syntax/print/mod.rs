//! Tree to text: the canonical form of a script.
//!
//! The tree becomes a `Layout`, a text that knows where its lines may be broken. What the parser
//! read is read again to an equal tree: parentheses are in the tree, and no line begins with a
//! `(`, `[` or `-` that should continue the one before.

mod expression;
mod format;
mod layout;
mod literal;

pub use format::format;

use self::expression::{arguments, expression, expressions, is_hugged, name_list};
use self::layout::Layout;
use super::ast::{
    Definition, Export, Expr, Function, Import, Kind, Param, Pattern, Statement, StatementKind,
    Tree,
};

/// Columns of a line.
const WIDTH: usize = 96;

/// The canonical text of `tree`, documentation included.
///
/// Statements that were not understood are left out. Numbers and strings stand in their shortest
/// form; comments are not in the tree: [`format()`] keeps both as they were written.
#[must_use]
pub fn print(tree: &Tree<'_>) -> String {
    let mut layout = Layout::new(None);
    for statement in &tree.statements {
        documented(&mut layout, statement);
        layout.hard_break();
    }
    layout.render(WIDTH)
}

/// A statement with its documentation.
fn documented<'a>(layout: &mut Layout<'a>, statement: &'a Statement<'_>) {
    for line in statement.docs.iter().flat_map(|docs| docs.split('\n')) {
        layout.text(if line.is_empty() { "///" } else { "/// " });
        layout.text(line);
        layout.hard_break();
    }
    self::statement(layout, statement);
}

/// A statement without its documentation.
fn statement<'a>(layout: &mut Layout<'a>, statement: &'a Statement<'_>) {
    layout.open();
    match &statement.kind {
        StatementKind::Error => {}
        StatementKind::Edition(edition) => keyed(layout, "geo ", edition),
        StatementKind::Unit(unit) => {
            layout.text("unit ");
            layout.text(unit.text);
        }
        StatementKind::Tolerance(tolerance) => keyed(layout, "tolerance ", tolerance),
        StatementKind::Param(param) => self::param(layout, param),
        StatementKind::Definition(definition) => self::definition(layout, definition),
        StatementKind::Function(function) => self::function(layout, function),
        StatementKind::Check { claim, message } => {
            keyed(layout, "check ", claim);
            optional(layout, " ", message.as_ref());
        }
        StatementKind::Print(items) => {
            layout.text("print ");
            expressions(layout, items);
        }
        StatementKind::Export(export) => self::export(layout, export),
        StatementKind::Import(import) => self::import(layout, import),
        StatementKind::Test { name, body } => test(layout, name, body),
        StatementKind::ExpectError { code, subject } => {
            keyed(layout, "expect error ", code);
            optional(layout, " ", Some(subject));
        }
    }
    layout.close();
}

fn keyed<'a>(layout: &mut Layout<'a>, keyword: &'static str, value: &'a Expr<'_>) {
    layout.text(keyword);
    expression(layout, value);
}

fn optional<'a>(layout: &mut Layout<'a>, before: &'static str, value: Option<&'a Expr<'_>>) {
    if let Some(value) = value {
        keyed(layout, before, value);
    }
}

fn param<'a>(layout: &mut Layout<'a>, param: &'a Param<'_>) {
    layout.text("param ");
    layout.text(param.name.text);
    if let Some(kind) = param.kind {
        layout.text(": ");
        layout.text(kind.text);
    }
    keyed(layout, " = ", &param.default);
    optional(layout, " in ", param.allowed.as_ref());
    optional(layout, " step ", param.step.as_ref());
    optional(layout, " ", param.label.as_ref());
}

fn definition<'a>(layout: &mut Layout<'a>, definition: &'a Definition<'_>) {
    layout.text(keyword(definition.kind));
    layout.text(" ");
    pattern(layout, &definition.pattern);
    if definition.pattern != Pattern::Anonymous {
        layout.text(" =");
        value(layout, &definition.value);
    } else {
        expression(layout, &definition.value);
    }
    options(layout, &definition.with);
}

fn function<'a>(layout: &mut Layout<'a>, function: &'a Function<'_>) {
    layout.text("fn ");
    layout.text(function.name.text);
    layout.text("(");
    layout.items(&function.parameters, |layout, parameter| {
        layout.text(parameter.name.text);
        optional(layout, " = ", parameter.default.as_ref());
    });
    layout.text(") =");
    value(layout, &function.body);
}

/// The value after a `=`: on the next line if it fits there and not here.
fn value<'a>(layout: &mut Layout<'a>, value: &'a Expr<'_>) {
    if is_hugged(value) {
        return keyed(layout, " ", value);
    }
    layout.open();
    layout.indent();
    layout.soft_break(" ");
    layout.open();
    expression(layout, value);
    layout.close();
    layout.dedent();
    layout.close();
}

/// `a`, `[a, b]` or `{a, b}`
fn pattern<'a>(layout: &mut Layout<'a>, pattern: &Pattern<'a>) {
    match pattern {
        Pattern::Anonymous => {}
        Pattern::Name(name) => layout.text(name.text),
        Pattern::List(names, _) => name_list(layout, ["[", "]"], names),
        Pattern::Record(names, _) => name_list(layout, ["{", "}"], names),
    }
}

fn options<'a>(layout: &mut Layout<'a>, options: &'a [super::ast::Arg<'_>]) {
    if !options.is_empty() {
        layout.text(" with ");
        arguments(layout, options);
    }
}

fn export<'a>(layout: &mut Layout<'a>, export: &'a Export<'_>) {
    layout.text("export ");
    match &export.subjects {
        Some(subjects) => expressions(layout, subjects),
        None => layout.text("all"),
    }
    keyed(layout, " to ", &export.path);
    options(layout, &export.options);
}

fn import<'a>(layout: &mut Layout<'a>, import: &'a Import<'_>) {
    keyed(layout, "import ", &import.path);
    if let Some(alias) = import.alias {
        layout.text(" as ");
        layout.text(alias.text);
    }
    if let Some(names) = &import.names {
        layout.text(" ");
        name_list(layout, ["(", ")"], names);
    }
    options(layout, &import.with);
}

fn test<'a>(layout: &mut Layout<'a>, name: &'a Expr<'_>, body: &'a [Statement<'_>]) {
    keyed(layout, "test ", name);
    layout.text(" {");
    layout.indent();
    for statement in body {
        layout.hard_break();
        documented(layout, statement);
    }
    layout.dedent();
    layout.hard_break();
    layout.text("}");
}

/// The first line of a test, with its name as it is written in `source`.
fn test_head(source: &str, name: &Expr<'_>) -> String {
    let mut layout = Layout::new(Some(source));
    keyed(&mut layout, "test ", name);
    layout.text(" {");
    layout.render_flat()
}

fn keyword(kind: Kind) -> &'static str {
    match kind {
        Kind::Let => "let",
        Kind::Point => "point",
        Kind::Curve => "curve",
        Kind::Surface => "surface",
        Kind::Mesh => "mesh",
        Kind::Table => "table",
        Kind::Points => "points",
        Kind::Curves => "curves",
        Kind::Surfaces => "surfaces",
        Kind::Meshes => "meshes",
        Kind::Tables => "tables",
    }
}
