//! Lowering of expressions.

use std::{collections::BTreeMap, sync::Arc};

use super::{
    super::ir::{
        Arg, BinaryOp, CallExpr, Comprehension, Element, Expr, ExprKind, Generator, Group, Lambda,
        Parameter, StringPart, TextFormat, UnaryOp,
    },
    Lowerer,
    growing::growing,
    scope::{Captures, Siblings},
};
use crate::{
    diag::{Code, Diagnostic, Span, Spanned},
    syntax::ast::{self, Pattern, Unit},
    value::{Dimension, Number, Value, in_unit_of, radians_of},
};

/// A whole number as it is written, with its sign.
fn whole(expr: &ast::Expr<'_>) -> Option<i32> {
    match &expr.kind {
        ast::ExprKind::Unary(UnaryOp::Negate, inner) => whole(inner).map(|number| -number),
        ast::ExprKind::Number(value, None) if value.fract() == 0.0 && *value < 100.0 => {
            Some(*value as i32)
        }
        _ => None,
    }
}

impl<'s> Lowerer<'_, 's> {
    /// Lowers an expression.
    pub(super) fn expr(&mut self, expr: &ast::Expr<'s>) -> Expr {
        let span = self.at(expr.span);
        let kind = match &expr.kind {
            ast::ExprKind::Error | ast::ExprKind::Placeholder => return self.poison(span),
            ast::ExprKind::Number(value, unit) => {
                ExprKind::Constant(Value::Number(self.number(*value, *unit)))
            }
            ast::ExprKind::Text(text) => ExprKind::Constant(Value::text(text)),
            ast::ExprKind::Bool(truth) => ExprKind::Constant(Value::Bool(*truth)),
            ast::ExprKind::None => ExprKind::Constant(Value::None),
            ast::ExprKind::Name(name) => return self.resolve(name, expr.span),
            ast::ExprKind::Group(inner) => return Expr { span, ..self.expr(inner) },
            ast::ExprKind::Interpolation(pieces) => ExprKind::Text(self.pieces(pieces)),
            ast::ExprKind::Point(coordinates) => self.point(coordinates, span),
            ast::ExprKind::List(elements) => ExprKind::List(self.elements(elements)),
            ast::ExprKind::Record(fields) => ExprKind::Record(self.fields(fields)),
            ast::ExprKind::Comprehension(comprehension) => self.comprehension(comprehension),
            ast::ExprKind::Block(block) => self.block(block),
            ast::ExprKind::Unary(op, operand) => ExprKind::Unary(*op, Box::new(self.expr(operand))),
            ast::ExprKind::Binary(BinaryOp::Power, sides) => self.power(sides, span),
            ast::ExprKind::Binary(op, sides) => ExprKind::Binary(*op, self.each(sides)),
            ast::ExprKind::Within(parts) => ExprKind::Within(self.each(parts)),
            ast::ExprKind::Index(parts) => ExprKind::Index(self.each(parts)),
            ast::ExprKind::If(parts) => ExprKind::If(self.each(parts)),
            ast::ExprKind::Call(callee, args) => self.call(callee, args, None),
            ast::ExprKind::Pipe(sides) => self.pipe(sides),
            ast::ExprKind::Field(subject, name) => {
                let value = Box::new(self.expr(subject));
                let (field, place) = (Arc::<str>::from(name.text), self.at(name.span));
                if let Some(whole) = self.whole_of(subject, &value) {
                    self.noted.part_uses.push((whole, Arc::clone(&field), place));
                }
                if let ExprKind::Global(idx) = value.kind
                    && self.imports.contains(&idx)
                {
                    self.uses.narrow(idx, &field);
                }
                ExprKind::Field(value, field, place)
            }
            ast::ExprKind::Lambda(names, body) => self.lambda(names, body),
        };
        Expr { kind, span }
    }

    fn each<const N: usize>(&mut self, exprs: &[ast::Expr<'s>; N]) -> Box<[Expr; N]> {
        Box::new(std::array::from_fn(|i| self.expr(&exprs[i])))
    }

    /// A power. An exponent behind a unit is that of the unit: `5mm^2` is five square millimetres.
    fn power(&mut self, sides: &[ast::Expr<'s>; 2], span: Span) -> ExprKind {
        let [base, exponent] = sides;
        let ast::ExprKind::Number(value, Some(unit)) = base.kind else {
            return ExprKind::Binary(BinaryOp::Power, self.each(sides));
        };
        if let Some(number) = whole(exponent).and_then(|power| {
            in_unit_of(value, &format!("{}^{power}", unit.name()), self.unit.name())
        }) {
            return ExprKind::Constant(Value::Number(number));
        }
        let at = self.at(base.span);
        let constant = |number| Expr { kind: ExprKind::Constant(Value::Number(number)), span: at };
        let unit = constant(self.number(1.0, Some(unit)));
        let raised = ExprKind::Binary(BinaryOp::Power, Box::new([unit, self.expr(exponent)]));
        let sides = [constant(Number::bare(value)), Expr { kind: raised, span }];
        ExprKind::Binary(BinaryOp::Multiply, Box::new(sides))
    }

    /// A literal in document units or radians.
    fn number(&self, value: f64, unit: Option<Unit>) -> Number {
        match unit {
            None => Number::bare(value),
            Some(Unit::Deg) => Number::angle(radians_of(value)),
            Some(Unit::Rad) => Number::angle(value),
            Some(Unit::Turn) => Number::angle(value * std::f64::consts::TAU),
            Some(unit) => Number { value: convert(value, unit, self.unit), dim: Dimension::LENGTH },
        }
    }

    fn pieces(&mut self, pieces: &[ast::StringPart<'s>]) -> Vec<StringPart> {
        pieces
            .iter()
            .map(|piece| match piece {
                ast::StringPart::Text(text) => StringPart::Text(Arc::from(text.as_str())),
                ast::StringPart::Expr(expr, format) => {
                    let format = format.map(|format| TextFormat {
                        digits: format.digits,
                        unit: format.unit.map(Arc::from),
                        span: self.at(format.span),
                    });
                    StringPart::Expr(self.expr(expr), format)
                }
            })
            .collect()
    }

    fn point(&mut self, coordinates: &[ast::Expr<'s>], span: Span) -> ExprKind {
        let mut lowered: Vec<Expr> = coordinates.iter().map(|expr| self.expr(expr)).collect();
        if lowered.len() == 2 {
            lowered
                .push(Expr { kind: ExprKind::Constant(Value::number(0.0)), span: span.at_end() });
        }
        match <[Expr; 3]>::try_from(lowered) {
            Ok(coordinates) => ExprKind::Point(Box::new(coordinates)),
            // The parser has told that a point has two or three coordinates.
            Err(_) => self.poison(span).kind,
        }
    }

    fn elements(&mut self, elements: &[ast::Element<'s>]) -> Vec<Element> {
        elements
            .iter()
            .map(|element| match element {
                ast::Element::Item(expr) => Element::Item(self.expr(expr)),
                ast::Element::Spread(expr) => Element::Spread(self.expr(expr)),
            })
            .collect()
    }

    fn fields(&mut self, fields: &[ast::Field<'s>]) -> Vec<(Arc<str>, Expr)> {
        let mut seen: BTreeMap<&str, Span> = BTreeMap::new();
        for field in fields {
            let span = self.at(field.name.span);
            if let Some(&first) = seen.get(field.name.text) {
                let message = format!("the record has two fields `{}`", field.name.text);
                self.report(
                    Diagnostic::error(Code::Duplicate, span, message)
                        .label("named again here")
                        .also(first, "the first one"),
                );
            }
            seen.entry(field.name.text).or_insert(span);
        }
        fields
            .iter()
            .map(|field| {
                let value = match &field.value {
                    Some(value) => self.expr(value),
                    None => self.resolve(field.name.text, field.name.span),
                };
                (Arc::from(field.name.text), value)
            })
            .collect()
    }

    fn comprehension(&mut self, comprehension: &ast::Comprehension<'s>) -> ExprKind {
        let mark = self.scopes.mark();
        let generators = comprehension
            .generators
            .iter()
            .map(|generator| {
                let source = self.expr(&generator.source);
                let (slot, parts) = self.element_pattern(&generator.pattern, mark);
                let condition = generator.condition.as_ref().map(|condition| self.expr(condition));
                Generator { slot, source, parts, condition }
            })
            .collect();
        let body = self.expr(&comprehension.body);
        self.scopes.release(mark);
        ExprKind::Comprehension(Box::new(Comprehension { generators, body }))
    }

    /// Slots for an element and for the variables that take it apart, in a comprehension whose scope
    /// began at `mark`.
    fn element_pattern(
        &mut self,
        pattern: &Pattern<'s>,
        mark: usize,
    ) -> (usize, Vec<(usize, Expr)>) {
        let bind = |this: &mut Self, name: &ast::Name<'s>| this.bind_once(name, mark, "variables");
        if let Pattern::Name(name) = pattern {
            return (bind(self, name), Vec::new());
        }
        let slot = self.scopes.reserve();
        let whole = |span| Expr { kind: ExprKind::Local(slot), span };
        let parts = self.take_apart(pattern, whole);
        let parts = parts.into_iter().map(|(name, expr)| (bind(self, &name), expr)).collect();
        (slot, parts)
    }

    /// The names of a pattern and how each is got from the whole.
    pub(super) fn take_apart(
        &mut self,
        pattern: &Pattern<'s>,
        whole: impl Fn(Span) -> Expr,
    ) -> Vec<(ast::Name<'s>, Expr)> {
        match pattern {
            Pattern::Anonymous | Pattern::Name(_) => Vec::new(),
            Pattern::List(names, span) => {
                let pattern_span = self.at(*span);
                let n_names = names.len();
                let element = |(i, name): (usize, &ast::Name<'s>)| {
                    let span = self.at(name.span);
                    let list = Expr {
                        kind: ExprKind::Exactly(Box::new(whole(pattern_span)), n_names),
                        span: pattern_span,
                    };
                    let idx = Expr { kind: ExprKind::Constant(Value::number(i as f64)), span };
                    (*name, Expr { kind: ExprKind::Index(Box::new([list, idx])), span })
                };
                names.iter().enumerate().map(element).collect()
            }
            Pattern::Record(names, _) => names
                .iter()
                .map(|name| {
                    let span = self.at(name.span);
                    let field = ExprKind::Field(Box::new(whole(span)), Arc::from(name.text), span);
                    (*name, Expr { kind: field, span })
                })
                .collect(),
        }
    }

    /// A call; `piped` stands before its arguments.
    fn call(
        &mut self,
        callee: &ast::Expr<'s>,
        args: &[ast::Arg<'s>],
        piped: Option<&ast::Expr<'s>>,
    ) -> ExprKind {
        if self.is_script_call(callee) {
            return self.script(piped, args, callee);
        }
        let callee_place = called_name(callee);
        let callee = self.expr(callee);
        let mut lowered: Vec<Arg> = Vec::with_capacity(args.len() + 1);
        if let Some(piped) = piped {
            lowered.push(Arg {
                label: None,
                span: self.at(piped.span),
                value: Some(self.expr(piped)),
                taken: None,
            });
        }
        lowered.extend(self.args(args));
        self.note_labels(callee_place, args);
        let is_partial = lowered.iter().any(|arg| arg.value.is_none());
        ExprKind::Call(Box::new(CallExpr { callee, args: lowered, is_partial }))
    }

    /// Notes the labels of arguments of a call of the name at this place.
    fn note_labels(&mut self, callee: Option<Span>, args: &[ast::Arg<'s>]) {
        let Some(callee) = callee.map(|place| self.at(place)) else { return };
        for label in args.iter().filter_map(|arg| arg.name.as_ref()) {
            self.noted.part_uses.push((callee, Arc::from(label.text), self.at(label.span)));
        }
    }

    /// Arguments in order; a placeholder has no value.
    pub(super) fn args(&mut self, args: &[ast::Arg<'s>]) -> Vec<Arg> {
        args.iter()
            .map(|arg| {
                let label = arg.name.map(|name| (Arc::from(name.text), self.at(name.span)));
                let value = match arg.value.kind {
                    ast::ExprKind::Placeholder => None,
                    _ => Some(self.expr(&arg.value)),
                };
                Arg { label, value, taken: None, span: self.at(arg.value.span) }
            })
            .collect()
    }

    /// `a |> f(b)` is `f(a, b)`, `a |> f` is `f(a)`.
    fn pipe(&mut self, sides: &[ast::Expr<'s>; 2]) -> ExprKind {
        let [subject, target] = sides;
        match &target.kind {
            ast::ExprKind::Call(callee, args) => self.call(callee, args, Some(subject)),
            _ => self.call(target, &[], Some(subject)),
        }
    }

    fn lambda(&mut self, names: &[ast::Name<'s>], body: &ast::Expr<'s>) -> ExprKind {
        self.scopes.enter_function(Arc::default(), Captures::default());
        let parameters = names
            .iter()
            .map(|name| {
                self.bind_once(name, 0, "parameters");
                Parameter { name: Arc::from(name.text), default: None }
            })
            .collect();
        let body = growing(self.expr(body));
        let (n_slots, captures) = self.scopes.leave();
        let lambda = Lambda { name: None, parameters, body, n_slots };
        ExprKind::Lambda(Arc::new(Group { lambdas: vec![lambda] }), 0, captures.sources())
    }

    /// A named function in a scope of its own; `captures` are shared by its group.
    pub(super) fn function(
        &mut self,
        function: &ast::Function<'s>,
        siblings: Arc<Siblings<'s>>,
        captures: Captures<'s>,
    ) -> (Lambda, Captures<'s>) {
        self.scopes.enter_function(siblings, captures);
        // Defaults see the parameters before them.
        let parameters = function
            .parameters
            .iter()
            .map(|parameter| {
                let default = parameter.default.as_ref().map(|default| self.expr(default));
                self.bind_once(&parameter.name, 0, "parameters");
                let name: Arc<str> = Arc::from(parameter.name.text);
                let places = (self.at(function.name.span), self.at(parameter.name.span));
                self.noted.parts.push((places.0, Arc::clone(&name), places.1));
                Parameter { name, default }
            })
            .collect();
        let body = growing(self.expr(&function.body));
        let (n_slots, captures) = self.scopes.leave();
        (Lambda { name: Some(Arc::from(function.name.text)), parameters, body, n_slots }, captures)
    }

    /// A literal that must be known before anything runs.
    pub(super) fn literal(&mut self, expr: &ast::Expr<'s>) -> Option<Spanned<Number>> {
        match self.expr(expr) {
            Expr { kind: ExprKind::Constant(Value::Number(number)), span } => {
                Some(Spanned::new(number, span))
            }
            _ => None,
        }
    }
}

/// The place of the name that is called.
fn called_name(callee: &ast::Expr<'_>) -> Option<Span> {
    match &callee.kind {
        ast::ExprKind::Name(_) => Some(callee.span),
        ast::ExprKind::Field(_, name) => Some(name.span),
        ast::ExprKind::Group(inner) => called_name(inner),
        _ => None,
    }
}

/// A length from one unit to another; whole ratios stay exact.
pub(crate) fn convert(value: f64, from: Unit, to: Unit) -> f64 {
    let micrometres =
        |unit: Unit| unit.millimetres().map_or(1, |size| (size * 1000.0).round() as i64);
    let (from, to) = (micrometres(from), micrometres(to));
    if from % to == 0 {
        value * (from / to) as f64
    } else if to % from == 0 {
        value / (to / from) as f64
    } else {
        value * from as f64 / to as f64
    }
}

#[cfg(test)]
mod tests {
    use super::convert;
    use crate::syntax::ast::Unit;

    #[test]
    #[expect(clippy::float_cmp, reason = "exactness is the claim")]
    fn whole_ratios_stay_exact() {
        assert_eq!(
            [
                convert(1.0, Unit::Ft, Unit::In),
                convert(0.57, Unit::Mm, Unit::Mm),
                convert(13.0, Unit::Mm, Unit::M)
            ],
            [12.0, 0.57, 0.013]
        );
    }
}
