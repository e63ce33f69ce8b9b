//! The walk through a tree that gathers its outline.

use std::ops::Range;

use super::{Act, ActKind, CallSite, DefinedName, NameRole, Outline};
use crate::{
    diag::Span,
    syntax::ast::{self, ExprKind, Pattern, Statement, StatementKind, Tree},
};

/// A walk through a tree.
pub(super) struct OutlineWalk<'t> {
    text: &'t str,
    out: Outline,
    /// Where names of the place under way are known.
    scope: Range<usize>,
    is_of_file: bool,
}

impl<'t> OutlineWalk<'t> {
    /// The outline of a text with this tree.
    pub(super) fn of(text: &'t str, tree: &Tree<'_>) -> Outline {
        let out = Outline::default();
        let mut walk = Self { text, out, scope: 0..text.len(), is_of_file: true };
        walk.tree(tree);
        walk.out
    }

    fn tree(&mut self, tree: &Tree<'_>) {
        tree.statements.iter().for_each(|statement| self.statement(statement));
    }

    /// Walks with another scope, inside of which nothing is of the file.
    fn inside(&mut self, scope: Range<usize>, walk: impl FnOnce(&mut Self)) {
        let before = std::mem::replace(&mut self.scope, scope);
        let was_of_file = std::mem::replace(&mut self.is_of_file, false);
        walk(self);
        (self.scope, self.is_of_file) = (before, was_of_file);
    }

    fn name(&mut self, name: &ast::Name<'_>, role: NameRole, whole: Span) -> &mut DefinedName {
        self.out.names.push(DefinedName {
            name: name.text.to_owned(),
            place: name.span.range(),
            role,
            whole: whole.range(),
            scope: self.scope.clone(),
            value: None,
            is_literal: false,
            docs: None,
            parameters: Vec::new(),
            kind: None,
            allowed: None,
            label: None,
            is_of_file: self.is_of_file,
            is_part: false,
        });
        let last = self.out.names.len() - 1;
        &mut self.out.names[last]
    }

    /// What a parameter allows, as it is written on one line.
    fn allowed(&self, param: &ast::Param<'_>) -> Option<String> {
        let written = |expr: &ast::Expr<'_>| {
            let text = self.text.get(expr.span.range()).unwrap_or_default();
            text.split_whitespace().collect::<Vec<_>>().join(" ")
        };
        let allowed = format!("in {}", written(param.allowed.as_ref()?));
        Some(match &param.step {
            Some(step) => format!("{allowed} step {}", written(step)),
            None => allowed,
        })
    }

    fn pattern(&mut self, pattern: &Pattern<'_>, role: NameRole, whole: Span) {
        match pattern {
            Pattern::Anonymous => {}
            Pattern::Name(name) => {
                self.name(name, role, whole);
            }
            Pattern::List(names, _) => {
                names.iter().for_each(|name| {
                    self.name(name, role, whole);
                });
            }
            Pattern::Record(names, _) => {
                names.iter().for_each(|name| self.name(name, role, whole).is_part = true);
            }
        }
    }

    fn act(&mut self, kind: ActKind, whole: Span, subject: Span) {
        self.out.acts.push(Act { kind, whole: whole.range(), subject: subject.range() });
    }

    fn statement(&mut self, statement: &Statement<'_>) {
        let whole = statement.span;
        self.out.nodes.push(whole.range());
        let first = self.out.names.len();
        match &statement.kind {
            StatementKind::Error | StatementKind::Unit(_) => {}
            StatementKind::Edition(expr) | StatementKind::Tolerance(expr) => self.expr(expr),
            StatementKind::Param(param) => {
                let allowed = self.allowed(param);
                let name = self.name(&param.name, NameRole::Param, whole);
                name.allowed = allowed;
                name.kind = param.kind.map(|kind| kind.text.to_owned());
                if let Some(ExprKind::Text(label)) = param.label.as_ref().map(|label| &label.kind) {
                    name.label = Some(label.to_string());
                }
                name.value = Some(param.default.span.range());
                name.is_literal = is_literal(&param.default);
                let parts = [&param.allowed, &param.step, &param.label];
                self.expr(&param.default);
                parts.into_iter().flatten().for_each(|part| self.expr(part));
            }
            StatementKind::Definition(definition) => {
                self.pattern(&definition.pattern, NameRole::Definition(definition.kind), whole);
                if let Pattern::Name(_) = definition.pattern
                    && let Some(name) = self.out.names.last_mut()
                {
                    name.value = Some(definition.value.span.range());
                    name.is_literal = is_literal(&definition.value);
                }
                self.expr(&definition.value);
                self.args(&definition.with);
            }
            StatementKind::Function(function) => self.function(function, whole),
            _ => self.acting(statement),
        }
        if let (Some(docs), Some(name)) = (&statement.docs, self.out.names.get_mut(first)) {
            name.docs = Some(docs.clone());
        }
    }

    /// A statement without a name of its own kind.
    fn acting(&mut self, statement: &Statement<'_>) {
        let whole = statement.span;
        match &statement.kind {
            StatementKind::Check { claim, message } => {
                self.act(ActKind::Check, whole, claim.span);
                self.expr(claim);
                message.iter().for_each(|message| self.expr(message));
            }
            StatementKind::Print(exprs) => {
                if let [first, ..] = &exprs[..] {
                    self.act(ActKind::Print, whole, first.span);
                }
                exprs.iter().for_each(|expr| self.expr(expr));
            }
            StatementKind::Export(export) => {
                self.act(ActKind::Export, whole, export.path.span);
                export.subjects.iter().for_each(|expr| self.expr(expr));
                self.expr(&export.path);
                self.args(&export.options);
            }
            StatementKind::Import(import) => {
                self.act(ActKind::Import, whole, import.path.span);
                let names = import.names.iter().flatten().chain(&import.alias);
                names.for_each(|name| {
                    self.name(name, NameRole::Import, whole);
                });
                if let (None, None, Some(name)) =
                    (&import.names, &import.alias, self.stem(import.path.span))
                {
                    self.name(&name, NameRole::Import, whole);
                }
                self.args(&import.with);
            }
            StatementKind::Test { name, body } => {
                self.act(ActKind::Test, whole, name.span);
                self.inside(whole.range(), |walk| {
                    body.iter().for_each(|statement| walk.statement(statement));
                });
            }
            StatementKind::ExpectError { code, subject } => {
                self.expr(code);
                self.expr(subject);
            }
            _ => {}
        }
    }

    /// The name of an import by its file, which stands in the path.
    fn stem(&self, path: Span) -> Option<ast::Name<'t>> {
        let text = self.text.get(path.range())?;
        let file = text.rfind('/').map_or(1, |slash| slash + 1);
        let stem = text[file..].split(['.', '"']).next()?;
        let start = path.start + file as u32;
        (!stem.is_empty())
            .then(|| ast::Name { text: stem, span: Span::new(start, start + stem.len() as u32) })
    }

    fn function(&mut self, function: &ast::Function<'_>, whole: Span) {
        let default = |parameter: &ast::Parameter<'_>| {
            let text =
                parameter.default.as_ref().and_then(|default| self.text.get(default.span.range()));
            (parameter.name.text.to_owned(), text.map(str::to_owned))
        };
        let parameters = function.parameters.iter().map(default).collect();
        let name = self.name(&function.name, NameRole::Function, whole);
        name.parameters = parameters;
        name.value = Some(function.body.span.range());
        self.inside(whole.range(), |walk| {
            for parameter in &function.parameters {
                walk.name(&parameter.name, NameRole::Parameter, whole);
                parameter.default.iter().for_each(|default| walk.expr(default));
            }
            walk.expr(&function.body);
        });
    }

    fn args(&mut self, args: &[ast::Arg<'_>]) {
        for arg in args {
            if let ExprKind::Text(text) = &arg.value.kind {
                let label = arg.name.map(|name| name.text.to_owned());
                self.out.nodes.push(arg.value.span.range());
                self.out.texts.push((arg.value.span.range(), text.clone(), label));
            } else {
                self.expr(&arg.value);
            }
        }
    }

    fn each(&mut self, exprs: &[ast::Expr<'_>]) {
        exprs.iter().for_each(|expr| self.expr(expr));
    }

    fn expr(&mut self, expr: &ast::Expr<'_>) {
        self.out.nodes.push(expr.span.range());
        match &expr.kind {
            ExprKind::Error
            | ExprKind::Number(..)
            | ExprKind::Bool(_)
            | ExprKind::None
            | ExprKind::Name(_)
            | ExprKind::Placeholder => {}
            ExprKind::Text(text) => self.out.texts.push((expr.span.range(), text.clone(), None)),
            ExprKind::Interpolation(pieces) => {
                for piece in pieces {
                    if let ast::StringPart::Expr(inner, _) = piece {
                        self.expr(inner);
                    }
                }
            }
            ExprKind::Group(inner) | ExprKind::Unary(_, inner) | ExprKind::Field(inner, _) => {
                self.expr(inner);
            }
            ExprKind::Point(exprs) => self.each(exprs),
            ExprKind::List(elements) => {
                for ast::Element::Item(inner) | ast::Element::Spread(inner) in elements {
                    self.expr(inner);
                }
            }
            ExprKind::Record(fields) => {
                for field in fields {
                    match &field.value {
                        Some(value) => self.expr(value),
                        None => self.out.short_fields.push(field.name.span.range()),
                    }
                }
            }
            ExprKind::Comprehension(comprehension) => self.comprehension(comprehension, expr.span),
            ExprKind::Block(block) => self.inside(expr.span.range(), |walk| {
                block.statements.iter().for_each(|statement| walk.statement(statement));
                walk.expr(&block.value);
            }),
            ExprKind::Binary(_, parts) | ExprKind::Index(parts) => self.each(&parts[..]),
            ExprKind::Pipe(parts) => self.pipe(parts),
            ExprKind::Within(parts) | ExprKind::If(parts) => self.each(&parts[..]),
            ExprKind::Call(callee, args) => self.call(callee, args, false),
            ExprKind::Lambda(names, body) => self.inside(expr.span.range(), |walk| {
                names.iter().for_each(|name| {
                    walk.name(name, NameRole::Parameter, expr.span);
                });
                walk.expr(body);
            }),
        }
    }

    fn pipe(&mut self, [subject, target]: &[ast::Expr<'_>; 2]) {
        self.expr(subject);
        self.out.nodes.push(target.span.range());
        match &target.kind {
            ExprKind::Call(callee, args) => self.call(callee, args, true),
            _ => self.expr(target),
        }
    }

    fn call(&mut self, callee: &ast::Expr<'_>, args: &[ast::Arg<'_>], is_piped: bool) {
        if let ExprKind::Name(_) = callee.kind {
            let arguments = args
                .iter()
                .map(|arg| (arg.value.span.range(), arg.name.is_some(), is_literal(&arg.value)))
                .collect();
            self.out.calls.push(CallSite { name: callee.span.range(), arguments, is_piped });
        }
        self.expr(callee);
        self.args(args);
    }

    fn comprehension(&mut self, comprehension: &ast::Comprehension<'_>, whole: Span) {
        self.inside(whole.range(), |walk| {
            for generator in &comprehension.generators {
                walk.expr(&generator.source);
                walk.pattern(&generator.pattern, NameRole::Variable, whole);
                generator.condition.iter().for_each(|condition| walk.expr(condition));
            }
            walk.expr(&comprehension.body);
        });
    }
}

/// Whether an expression is a value as it is written.
fn is_literal(expr: &ast::Expr<'_>) -> bool {
    match &expr.kind {
        ExprKind::Number(..) | ExprKind::Text(_) | ExprKind::Bool(_) | ExprKind::None => true,
        ExprKind::Unary(_, inner) | ExprKind::Group(inner) => is_literal(inner),
        ExprKind::Point(exprs) => exprs.iter().all(is_literal),
        _ => false,
    }
}
