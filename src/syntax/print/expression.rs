//! Expressions to layout. Chains are walked, not recursed over: they are as deep as long.

use super::documented;
use super::layout::Layout;
use super::literal::{escaped, number, piece, string};
use crate::syntax::ast::{
    Arg, BinaryOp, Block, Comprehension, Element, Expr, ExprKind, Field, Name, UnaryOp,
};

/// An expression.
pub(super) fn expression<'a>(layout: &mut Layout<'a>, whole: &'a Expr<'_>) {
    let mut links = Vec::new();
    let mut head = whole;
    while let Some(left) = left_of(head) {
        links.push(head);
        head = left;
    }
    let has_breaks = links.iter().any(|link| is_spaced(&link.kind));
    if has_breaks {
        layout.open();
        layout.indent();
    }
    primary(layout, head);
    for link in links.into_iter().rev() {
        self::link(layout, &link.kind);
    }
    if has_breaks {
        layout.dedent();
        layout.close();
    }
}

/// What an expression continues to the right.
fn left_of<'a, 's>(expr: &'a Expr<'s>) -> Option<&'a Expr<'s>> {
    match &expr.kind {
        ExprKind::Binary(_, operands) | ExprKind::Pipe(operands) | ExprKind::Index(operands) => {
            Some(&operands[0])
        }
        ExprKind::Within(operands) => Some(&operands[0]),
        ExprKind::Call(callee, _) => Some(callee),
        ExprKind::Field(owner, _) => Some(owner),
        _ => None,
    }
}

/// Whether a line may be broken beside its operator.
fn is_spaced(kind: &ExprKind<'_>) -> bool {
    match kind {
        ExprKind::Binary(op, operands) => !is_tight(*op, operands),
        ExprKind::Pipe(_) | ExprKind::Within(_) => true,
        _ => false,
    }
}

/// Powers stand without spaces, and so do ranges between simple ends.
fn is_tight(op: BinaryOp, operands: &[Expr<'_>; 2]) -> bool {
    match op {
        BinaryOp::Power => true,
        BinaryOp::Range | BinaryOp::RangeBelow => operands.iter().all(is_simple),
        _ => false,
    }
}

fn is_simple(expr: &Expr<'_>) -> bool {
    match &expr.kind {
        ExprKind::Unary(UnaryOp::Negate, operand) => is_simple(operand),
        ExprKind::Number(..)
        | ExprKind::Name(_)
        | ExprKind::Group(_)
        | ExprKind::Call(..)
        | ExprKind::Field(..)
        | ExprKind::Index(_) => true,
        _ => false,
    }
}

/// The part of an expression to the right of what it continues.
fn link<'a>(layout: &mut Layout<'a>, kind: &'a ExprKind<'_>) {
    match kind {
        ExprKind::Binary(op, operands) => {
            binary(layout, *op, is_tight(*op, operands));
            expression(layout, &operands[1]);
        }
        ExprKind::Pipe(operands) => {
            layout.soft_break(" ");
            layout.text("|> ");
            expression(layout, &operands[1]);
        }
        ExprKind::Within(operands) => {
            binary(layout, BinaryOp::Near, false);
            expression(layout, &operands[1]);
            layout.text(" within ");
            expression(layout, &operands[2]);
        }
        ExprKind::Call(_, args) => arguments(layout, args),
        ExprKind::Index(operands) => {
            layout.text("[");
            expression(layout, &operands[1]);
            layout.text("]");
        }
        ExprKind::Field(_, name) => {
            layout.text(".");
            layout.text(name.text);
        }
        _ => {}
    }
}

/// The operator: a line is broken before a word, else behind the operator.
fn binary(layout: &mut Layout<'_>, op: BinaryOp, is_tight: bool) {
    let text = operator(op);
    if is_tight {
        layout.text(text);
    } else if matches!(op, BinaryOp::And | BinaryOp::Or) {
        layout.soft_break(" ");
        layout.text(text);
        layout.text(" ");
    } else {
        layout.text(" ");
        layout.text(text);
        layout.soft_break(" ");
    }
}

fn operator(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::Or => "or",
        BinaryOp::And => "and",
        BinaryOp::Equal => "==",
        BinaryOp::NotEqual => "!=",
        BinaryOp::Less => "<",
        BinaryOp::LessEqual => "<=",
        BinaryOp::Greater => ">",
        BinaryOp::GreaterEqual => ">=",
        BinaryOp::Near => "~=",
        BinaryOp::Range => "..",
        BinaryOp::RangeBelow => "..<",
        BinaryOp::Add => "+",
        BinaryOp::Subtract => "-",
        BinaryOp::Multiply => "*",
        BinaryOp::Divide => "/",
        BinaryOp::Remainder => "%",
        BinaryOp::Power => "^",
    }
}

/// An expression that continues none.
fn primary<'a>(layout: &mut Layout<'a>, expr: &'a Expr<'_>) {
    match &expr.kind {
        ExprKind::Number(value, unit) => number(layout, *value, *unit, expr.span),
        ExprKind::Text(text) => {
            let pieces = [escaped(text)];
            string(layout, expr.span, &pieces);
        }
        ExprKind::Interpolation(pieces) => {
            let pieces: Vec<String> = pieces.iter().map(piece).collect();
            string(layout, expr.span, &pieces);
        }
        ExprKind::Bool(value) => layout.text(if *value { "true" } else { "false" }),
        ExprKind::None => layout.text("none"),
        ExprKind::Name(text) => layout.text(*text),
        ExprKind::Placeholder => layout.text("_"),
        ExprKind::Group(inner) => {
            layout.text("(");
            layout.items(std::slice::from_ref(&**inner), expression);
            layout.text(")");
        }
        ExprKind::Point(coordinates) => {
            layout.text("(");
            layout.items(coordinates, expression);
            layout.text(")");
        }
        ExprKind::List(elements) => list(layout, elements),
        ExprKind::Record(fields) => {
            layout.text("{");
            layout.items(fields, field);
            layout.text("}");
        }
        ExprKind::Comprehension(comprehension) => self::comprehension(layout, comprehension),
        ExprKind::Block(block) => self::block(layout, block),
        ExprKind::Unary(op, operand) => {
            layout.text(match op {
                UnaryOp::Negate => "-",
                UnaryOp::Not => "not ",
            });
            expression(layout, operand);
        }
        ExprKind::Lambda(parameters, body) => {
            match parameters.as_slice() {
                [only] => layout.text(only.text),
                _ => name_list(layout, ["(", ")"], parameters),
            }
            layout.text(" => ");
            expression(layout, body);
        }
        ExprKind::If(parts) => choice(layout, parts),
        // Not understood, or printed as links.
        _ => {}
    }
}

/// A list: one element a line, or as many as fit where they are numbers.
fn list<'a>(layout: &mut Layout<'a>, elements: &'a [Element<'_>]) {
    layout.text("[");
    let is_row = elements.len() > 1
        && elements.iter().all(|e| matches!(e, Element::Item(item) if is_scalar(item)));
    if !is_row {
        layout.items(elements, element);
        return layout.text("]");
    }
    layout.open();
    layout.indent();
    layout.soft_break("");
    for (index, one) in elements.iter().enumerate() {
        if index > 0 {
            layout.text(",");
            layout.fill_break();
        }
        element(layout, one);
    }
    layout.if_broken(",");
    layout.dedent();
    layout.soft_break("");
    layout.close();
    layout.text("]");
}

fn is_scalar(expr: &Expr<'_>) -> bool {
    match &expr.kind {
        ExprKind::Unary(UnaryOp::Negate, operand) => is_scalar(operand),
        ExprKind::Number(..) | ExprKind::Name(_) => true,
        _ => false,
    }
}

fn element<'a>(layout: &mut Layout<'a>, element: &'a Element<'_>) {
    match element {
        Element::Item(item) => expression(layout, item),
        Element::Spread(list) => {
            layout.text("...");
            expression(layout, list);
        }
    }
}

fn field<'a>(layout: &mut Layout<'a>, field: &'a Field<'_>) {
    layout.text(field.name.text);
    if let Some(value) = &field.value {
        layout.text(": ");
        expression(layout, value);
    }
}

fn comprehension<'a>(layout: &mut Layout<'a>, comprehension: &'a Comprehension<'_>) {
    layout.text("[");
    layout.open();
    layout.indent();
    layout.soft_break("");
    layout.text("for ");
    for (index, generator) in comprehension.generators.iter().enumerate() {
        if index > 0 {
            layout.text(", ");
        }
        super::pattern(layout, &generator.pattern);
        layout.text(" in ");
        expression(layout, &generator.source);
        if let Some(condition) = &generator.condition {
            layout.text(" if ");
            expression(layout, condition);
        }
    }
    layout.text(":");
    layout.soft_break(" ");
    expression(layout, &comprehension.body);
    layout.dedent();
    layout.soft_break("");
    layout.close();
    layout.text("]");
}

fn block<'a>(layout: &mut Layout<'a>, block: &'a Block<'_>) {
    if block.statements.is_empty() {
        layout.text("{ ");
        expression(layout, &block.value);
        return layout.text(" }");
    }
    layout.text("{");
    layout.indent();
    for statement in &block.statements {
        layout.hard_break();
        documented(layout, statement);
    }
    layout.hard_break();
    expression(layout, &block.value);
    layout.dedent();
    layout.hard_break();
    layout.text("}");
}

fn choice<'a>(layout: &mut Layout<'a>, [condition, first, second]: &'a [Expr<'_>; 3]) {
    layout.open();
    layout.indent();
    layout.text("if ");
    expression(layout, condition);
    layout.soft_break(" ");
    layout.text("then ");
    expression(layout, first);
    layout.soft_break(" ");
    layout.text("else ");
    expression(layout, second);
    layout.dedent();
    layout.close();
}

/// `(a, label = b)`
pub(super) fn arguments<'a>(layout: &mut Layout<'a>, args: &'a [Arg<'_>]) {
    layout.text("(");
    match args {
        [only] if is_hugged(&only.value) => argument(layout, only),
        _ => layout.items(args, argument),
    }
    layout.text(")");
}

fn argument<'a>(layout: &mut Layout<'a>, arg: &'a Arg<'_>) {
    if let Some(name) = arg.name {
        layout.text(name.text);
        layout.text(" = ");
    }
    expression(layout, &arg.value);
}

/// Whether its brackets break on their own, so that what is around it need not.
pub(super) fn is_hugged(expr: &Expr<'_>) -> bool {
    match &expr.kind {
        ExprKind::Call(callee, _) => is_simple(callee),
        ExprKind::Lambda(_, body) => is_hugged(body),
        ExprKind::List(_)
        | ExprKind::Record(_)
        | ExprKind::Comprehension(_)
        | ExprKind::Block(_)
        | ExprKind::Point(_)
        | ExprKind::Group(_) => true,
        _ => false,
    }
}

/// Expressions with commas between them, without brackets around.
pub(super) fn expressions<'a>(layout: &mut Layout<'a>, items: &'a [Expr<'_>]) {
    layout.open();
    layout.indent();
    for (index, item) in items.iter().enumerate() {
        if index > 0 {
            layout.text(",");
            layout.soft_break(" ");
        }
        expression(layout, item);
    }
    layout.dedent();
    layout.close();
}

/// Names between brackets.
pub(super) fn name_list<'a>(
    layout: &mut Layout<'a>,
    [open, close]: [&'static str; 2],
    names: &[Name<'a>],
) {
    layout.text(open);
    for (index, name) in names.iter().enumerate() {
        if index > 0 {
            layout.text(", ");
        }
        layout.text(name.text);
    }
    layout.text(close);
}
