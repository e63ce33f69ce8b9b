//! Which names of around it an expression uses.

use std::collections::{HashMap, hash_map::Entry};

use crate::syntax::ast::{self, Pattern, StatementKind};

/// A walk through an expression, which shows every name that comes from around it.
pub(super) struct NameWalk<'w, 's> {
    /// Names that parameters, variables and blocks hide at this place, innermost last.
    hidden: Vec<&'s str>,
    /// How often each stands among them.
    times: HashMap<&'s str, usize>,
    /// Is shown the others.
    see: &'w mut dyn FnMut(&str),
}

impl<'w, 's> NameWalk<'w, 's> {
    pub(super) fn new(see: &'w mut dyn FnMut(&str)) -> Self {
        Self { hidden: Vec::new(), times: HashMap::new(), see }
    }

    fn name(&mut self, name: &str) {
        if !self.times.contains_key(name) {
            (self.see)(name);
        }
    }

    fn hide(&mut self, name: &ast::Name<'s>) {
        self.hidden.push(name.text);
        *self.times.entry(name.text).or_default() += 1;
    }

    fn hide_all(&mut self, pattern: &Pattern<'s>) {
        match pattern {
            Pattern::Anonymous => {}
            Pattern::Name(name) => self.hide(name),
            Pattern::List(names, _) | Pattern::Record(names, _) => {
                names.iter().for_each(|name| self.hide(name));
            }
        }
    }

    /// Ends what was hidden since `mark`.
    fn release(&mut self, mark: usize) {
        for name in self.hidden.drain(mark..) {
            if let Entry::Occupied(mut times) = self.times.entry(name) {
                *times.get_mut() -= 1;
                if *times.get() == 0 {
                    times.remove();
                }
            }
        }
    }

    /// A function: its defaults, each of which sees the parameters before it, and its body.
    pub(super) fn function(&mut self, function: &ast::Function<'s>) {
        let mark = self.hidden.len();
        for parameter in &function.parameters {
            parameter.default.iter().for_each(|default| self.expr(default));
            self.hide(&parameter.name);
        }
        self.expr(&function.body);
        self.release(mark);
    }

    /// An expression.
    pub(super) fn expr(&mut self, expr: &ast::Expr<'s>) {
        use ast::ExprKind as Kind;
        match &expr.kind {
            Kind::Error
            | Kind::Number(..)
            | Kind::Text(_)
            | Kind::Bool(_)
            | Kind::None
            | Kind::Placeholder => {}
            Kind::Name(name) => self.name(name),
            Kind::Group(inner) | Kind::Unary(_, inner) | Kind::Field(inner, _) => self.expr(inner),
            Kind::Lambda(names, body) => {
                let mark = self.hidden.len();
                names.iter().for_each(|name| self.hide(name));
                self.expr(body);
                self.release(mark);
            }
            Kind::Interpolation(pieces) => {
                for piece in pieces {
                    if let ast::StringPart::Expr(inner, _) = piece {
                        self.expr(inner);
                    }
                }
            }
            Kind::Point(exprs) => self.each(exprs),
            Kind::List(elements) => {
                for ast::Element::Item(inner) | ast::Element::Spread(inner) in elements {
                    self.expr(inner);
                }
            }
            Kind::Record(fields) => {
                for field in fields {
                    match &field.value {
                        Some(value) => self.expr(value),
                        None => self.name(field.name.text),
                    }
                }
            }
            Kind::Comprehension(comprehension) => self.comprehension(comprehension),
            Kind::Block(block) => self.block(block),
            Kind::Binary(_, parts) | Kind::Pipe(parts) | Kind::Index(parts) => {
                self.each(&parts[..]);
            }
            Kind::Within(parts) | Kind::If(parts) => self.each(&parts[..]),
            Kind::Call(callee, args) => {
                self.expr(callee);
                args.iter().for_each(|arg| self.expr(&arg.value));
            }
        }
    }

    fn each(&mut self, exprs: &[ast::Expr<'s>]) {
        exprs.iter().for_each(|expr| self.expr(expr));
    }

    fn comprehension(&mut self, comprehension: &ast::Comprehension<'s>) {
        let mark = self.hidden.len();
        for generator in &comprehension.generators {
            self.expr(&generator.source);
            self.hide_all(&generator.pattern);
            generator.condition.iter().for_each(|condition| self.expr(condition));
        }
        self.expr(&comprehension.body);
        self.release(mark);
    }

    fn block(&mut self, block: &ast::Block<'s>) {
        let mark = self.hidden.len();
        for statement in &block.statements {
            match &statement.kind {
                StatementKind::Function(function) => self.hide(&function.name),
                StatementKind::Definition(definition) => self.hide_all(&definition.pattern),
                _ => {}
            }
        }
        for statement in &block.statements {
            match &statement.kind {
                StatementKind::Function(function) => self.function(function),
                StatementKind::Definition(definition) => self.expr(&definition.value),
                _ => {}
            }
        }
        self.expr(&block.value);
        self.release(mark);
    }
}
