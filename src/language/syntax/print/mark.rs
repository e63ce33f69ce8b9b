//! What the tree tells of the atoms: which brackets take a comma, where statements begin, which
//! operators stand without spaces, where lines may be broken.
//!
//! The tree is walked with a stack of its own, since chains are as deep as long.

use super::atom::{Atom, GroupContent, Point, Rank, Start, code_at, code_before};
use super::shape::{breaks_inside, is_tight_operand};
use crate::diag::Span;
use crate::syntax::ast::{
    Arg, BinaryOp, Block, Comprehension, Definition, Element, Export, Expr, ExprKind, Function,
    Import, Param, Pattern, Statement, StatementKind, Tree, UnaryOp,
};
use crate::syntax::token::Token;

/// Marks the atoms of the script that `tree` was read from.
pub(super) fn mark(atoms: &mut [Atom<'_>], tree: &Tree<'_>) {
    let mut marker =
        Marker { atoms, open: tree.statements.iter().map(MarkNode::Statement).collect() };
    while let Some(node) = marker.open.pop() {
        match node {
            MarkNode::Statement(statement) => marker.statement(statement),
            MarkNode::Expr(expr) => marker.expression(expr),
        }
    }
    close_what_is_opened(atoms);
}

/// Makes closing brackets begin a line where the text behind the opening one does.
fn close_what_is_opened(atoms: &mut [Atom<'_>]) {
    for at in 0..atoms.len() {
        let is_open = atoms[at].opens() && {
            let first = code_at(atoms, at + 1);
            atoms[at].holds == GroupContent::Statements
                || (at + 1..=first).any(|inner| atoms[inner].begins_line())
        };
        let partner = atoms[at].partner;
        if is_open && partner != code_at(atoms, at + 1) {
            atoms[partner].begin_line();
        }
    }
}

enum MarkNode<'a, 's> {
    Statement(&'a Statement<'s>),
    Expr(&'a Expr<'s>),
}

struct Marker<'a, 'b, 's, 't> {
    atoms: &'a mut [Atom<'b>],
    open: Vec<MarkNode<'t, 's>>,
}

impl<'s, 't> Marker<'_, '_, 's, 't> {
    /// The atom that begins at `start`.
    fn at(&self, start: u32) -> usize {
        self.atoms.partition_point(|atom| atom.span.start < start)
    }

    /// The first atom of an expression.
    fn first(&self, expr: &Expr<'_>) -> usize {
        self.at(expr.span.start)
    }

    /// The atom before the one that begins at `start`, comments left out.
    fn before(&self, start: u32) -> usize {
        code_before(self.atoms, self.at(start)).unwrap_or(0)
    }

    /// The first atom behind `span`.
    fn behind(&self, span: Span) -> usize {
        code_at(self.atoms, self.at(span.end))
    }

    fn rank(&mut self, at: usize, rank: Rank) {
        self.atoms[at].rank = Some(rank);
    }

    fn point(&mut self, at: usize, point: Point) {
        self.atoms[at].point = Some(point);
    }

    fn walk(&mut self, expr: &'t Expr<'s>) {
        self.open.push(MarkNode::Expr(expr));
    }

    fn walk_all(&mut self, exprs: impl IntoIterator<Item = &'t Expr<'s>>) {
        self.open.extend(exprs.into_iter().map(MarkNode::Expr));
    }

    /// Makes a statement, or the value of a block, begin a line.
    fn head(&mut self, start: u32) {
        let at = self.at(start);
        self.atoms[at].is_head = true;
        let before = code_before(self.atoms, at);
        let first = before.map_or(0, |before| before + 1);
        if !(first..=at).any(|at| self.atoms[at].begins_line()) {
            self.atoms[at].begin_line();
        }
        // A comma at the end of a list without brackets.
        if let Some(before) = before
            && self.atoms[before].token == Token::Comma
        {
            let comma = &mut self.atoms[before];
            (comma.text, comma.start, comma.is_glued) = ("", Start::Same, true);
        }
    }

    /// Statements in the braces that close with the text before `end`.
    fn body(&mut self, statements: &'t [Statement<'s>], end: u32) {
        if !statements.is_empty() {
            let close = self.before(end);
            let open = self.atoms[close].partner;
            self.atoms[open].holds = GroupContent::Statements;
        }
        self.open.extend(statements.iter().map(MarkNode::Statement));
    }

    fn statement(&mut self, statement: &'t Statement<'s>) {
        self.head(statement.span.start);
        match &statement.kind {
            StatementKind::Error | StatementKind::Unit(_) => {}
            StatementKind::Edition(value) | StatementKind::Tolerance(value) => self.walk(value),
            StatementKind::Param(param) => self.param(param),
            StatementKind::Definition(definition) => self.definition(definition),
            StatementKind::Function(function) => self.function(function),
            StatementKind::Check { claim, message } => {
                self.walk(claim);
                self.label(message.as_ref());
            }
            StatementKind::Print(items) => self.walk_all(items),
            StatementKind::Export(export) => self.export(export),
            StatementKind::Import(import) => self.import(import),
            StatementKind::Test { body, .. } => self.body(body, statement.span.end),
            StatementKind::ExpectError { subject, .. } => self.walk(subject),
        }
    }

    fn label(&mut self, label: Option<&'t Expr<'s>>) {
        if let Some(label) = label {
            self.point(self.first(label), Point::Label);
        }
    }

    fn param(&mut self, param: &'t Param<'s>) {
        self.point(self.at(param.name.span.start), Point::Name);
        self.point(self.before(param.default.span.start), Point::Equals);
        for (clause, point) in [(&param.allowed, Point::In), (&param.step, Point::Step)] {
            if let Some(clause) = clause {
                let at = self.before(clause.span.start);
                self.point(at, point);
                self.rank(at, Rank::Clause);
            }
        }
        self.label(param.label.as_ref());
        self.walk_all(
            [Some(&param.default), param.allowed.as_ref(), param.step.as_ref()]
                .into_iter()
                .flatten(),
        );
    }

    fn definition(&mut self, definition: &'t Definition<'s>) {
        let value = &definition.value;
        if let Pattern::Name(name) = &definition.pattern {
            self.point(self.at(name.span.start), Point::Name);
        }
        self.pattern(&definition.pattern);
        if definition.pattern != Pattern::Anonymous {
            self.point(self.before(value.span.start), Point::Equals);
            let rank = if breaks_inside(value) { Rank::LastBind } else { Rank::Bind };
            self.rank(self.first(value), rank);
        }
        self.options(&definition.with);
        self.walk(value);
    }

    fn function(&mut self, function: &'t Function<'s>) {
        self.point(self.at(function.name.span.start), Point::Name);
        let body = &function.body;
        let equals = self.before(body.span.start);
        self.point(equals, Point::Equals);
        let rank = match &body.kind {
            ExprKind::Block(_) | ExprKind::Record(_) => Rank::LastBind,
            _ => Rank::Bind,
        };
        self.rank(self.first(body), rank);
        let open = self.behind(function.name.span);
        self.atoms[open].is_glued = true;
        if !function.parameters.is_empty() {
            self.atoms[open].holds = GroupContent::Items;
        }
        self.walk_all(function.parameters.iter().filter_map(|one| one.default.as_ref()));
        self.walk(body);
    }

    fn pattern(&mut self, pattern: &Pattern<'_>) {
        if let Pattern::List(names, span) | Pattern::Record(names, span) = pattern
            && !names.is_empty()
        {
            let open = self.at(span.start);
            self.atoms[open].holds = GroupContent::Items;
        }
    }

    /// What stands between the parentheses after `with`.
    fn options(&mut self, options: &'t [Arg<'s>]) {
        if let Some(open) = self.arguments(options)
            && let Some(with) = code_before(self.atoms, open)
        {
            self.point(with, Point::With);
        }
    }

    /// Arguments; their opening bracket.
    fn arguments(&mut self, args: &'t [Arg<'s>]) -> Option<usize> {
        let first = args.first()?;
        let start = first.name.map_or(first.value.span.start, |name| name.span.start);
        let open = self.before(start);
        self.atoms[open].holds = GroupContent::Items;
        self.walk_all(args.iter().map(|arg| &arg.value));
        Some(open)
    }

    fn export(&mut self, export: &'t Export<'s>) {
        let to = self.before(export.path.span.start);
        self.point(to, Point::To);
        self.rank(to, Rank::Clause);
        self.walk_all(&export.subjects);
        self.options(&export.options);
    }

    fn import(&mut self, import: &'t Import<'s>) {
        if let Some(first) = import.names.as_ref().and_then(|names| names.first()) {
            let open = self.before(first.span.start);
            self.atoms[open].holds = GroupContent::Items;
        }
        self.options(&import.with);
    }

    fn expression(&mut self, expr: &'t Expr<'s>) {
        match &expr.kind {
            ExprKind::Group(inner) => self.walk(inner),
            ExprKind::Point(coordinates) => {
                self.holds_items(expr);
                self.walk_all(coordinates);
            }
            ExprKind::List(elements) => {
                if !elements.is_empty() {
                    self.holds_items(expr);
                }
                self.walk_all(elements.iter().map(|element| match element {
                    Element::Item(item) | Element::Spread(item) => item,
                }));
            }
            ExprKind::Record(fields) => {
                if !fields.is_empty() {
                    self.holds_items(expr);
                }
                self.walk_all(fields.iter().filter_map(|field| field.value.as_ref()));
            }
            ExprKind::Comprehension(comprehension) => self.comprehension(comprehension),
            ExprKind::Block(block) => self.block(expr, block),
            ExprKind::Unary(op, operand) => {
                if *op == UnaryOp::Negate {
                    let first = self.first(operand);
                    self.atoms[first].is_glued = true;
                }
                self.walk(operand);
            }
            ExprKind::Lambda(_, body) => {
                self.rank(self.first(body), Rank::Arrow);
                self.walk(body);
            }
            ExprKind::If(parts) => {
                self.rank(self.before(parts[1].span.start), Rank::Then);
                self.rank(self.before(parts[2].span.start), Rank::Else);
                self.walk_all(parts.iter());
            }
            _ => self.link(expr),
        }
    }

    fn holds_items(&mut self, expr: &Expr<'_>) {
        let open = self.first(expr);
        self.atoms[open].holds = GroupContent::Items;
    }

    /// An expression that continues another.
    fn link(&mut self, expr: &'t Expr<'s>) {
        match &expr.kind {
            ExprKind::Binary(op, operands) => self.binary(*op, operands),
            ExprKind::Within(operands) => {
                self.rank(self.before(operands[1].span.start), Rank::Compare);
                self.walk_all(operands.iter());
            }
            ExprKind::Pipe(operands) => {
                self.rank(self.before(operands[1].span.start), Rank::Pipe);
                self.walk_all(operands.iter());
            }
            ExprKind::Call(callee, args) => {
                let open = self.behind(callee.span);
                self.atoms[open].is_glued = true;
                self.arguments(args);
                self.walk(callee);
            }
            ExprKind::Index(operands) => {
                let open = self.behind(operands[0].span);
                self.atoms[open].is_glued = true;
                self.walk_all(operands.iter());
            }
            ExprKind::Field(owner, _) => self.walk(owner),
            // Strings stay as they are written.
            _ => {}
        }
    }

    fn binary(&mut self, op: BinaryOp, operands: &'t [Expr<'s>; 2]) {
        self.walk_all(operands.iter());
        let right = self.first(&operands[1]);
        let sign = self.before(operands[1].span.start);
        let is_tight = match op {
            BinaryOp::Power => true,
            BinaryOp::Range | BinaryOp::RangeBelow => {
                operands.iter().all(|one| self.is_compact(one))
            }
            BinaryOp::Multiply | BinaryOp::Divide | BinaryOp::Remainder => {
                self.is_written_tight(&operands[1]) && is_tight_operand(&operands[1])
            }
            _ => false,
        };
        if is_tight {
            self.atoms[sign].is_glued = true;
            self.atoms[right].is_glued = true;
            return;
        }
        match op {
            BinaryOp::Or => self.rank(sign, Rank::Or),
            BinaryOp::And => self.rank(sign, Rank::And),
            BinaryOp::Add | BinaryOp::Subtract => self.rank(right, Rank::Sum),
            BinaryOp::Multiply | BinaryOp::Divide | BinaryOp::Remainder => {
                self.rank(right, Rank::Product);
            }
            BinaryOp::Range | BinaryOp::RangeBelow => {}
            _ => self.rank(sign, Rank::Compare),
        }
    }

    /// Whether nothing stands between the operator, its left operand, and this one.
    fn is_written_tight(&self, right: &Expr<'_>) -> bool {
        let at = self.first(right);
        at >= 2
            && self.atoms[at].span.start == self.atoms[at - 1].span.end
            && self.atoms[at - 1].span.start == self.atoms[at - 2].span.end
    }

    /// Whether an expression has no spaces outside of brackets, chains of operators aside.
    fn is_compact(&self, expr: &Expr<'_>) -> bool {
        match &expr.kind {
            ExprKind::Unary(UnaryOp::Negate, operand) => self.is_compact(operand),
            ExprKind::Binary(BinaryOp::Power, operands) => is_tight_operand(&operands[1]),
            ExprKind::Binary(BinaryOp::Multiply | BinaryOp::Divide, operands) => {
                self.is_written_tight(&operands[1])
                    && is_tight_operand(&operands[0])
                    && is_tight_operand(&operands[1])
            }
            _ => is_tight_operand(expr),
        }
    }

    fn comprehension(&mut self, comprehension: &'t Comprehension<'s>) {
        for generator in &comprehension.generators {
            self.pattern(&generator.pattern);
            self.walk(&generator.source);
            self.walk_all(generator.condition.as_ref());
        }
        self.rank(self.first(&comprehension.body), Rank::Body);
        self.walk(&comprehension.body);
    }

    fn block(&mut self, expr: &Expr<'_>, block: &'t Block<'s>) {
        let open = self.first(expr);
        self.atoms[open].holds = GroupContent::Value;
        if !block.statements.is_empty() {
            self.body(&block.statements, expr.span.end);
            self.head(block.value.span.start);
        }
        self.walk(&block.value);
    }
}
