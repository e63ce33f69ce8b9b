//! Comparisons as conditions: by how much the sides that a function of the script compares differ.
//!
//! What a search has to keep is written as a comparison; that it holds is no number, its difference is.

use super::{
    function::ScriptFunction,
    ir::{BinaryOp, Comprehension, Element, Expr, ExprKind},
    machine::Machine,
    operator,
};
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    value::{Comparison, Function, Relation, Value},
};

impl Machine<'_> {
    /// What a function of the script compares, with the arguments given: its body is one comparison or
    /// several, joined by `and`, in a list or a comprehension, behind definitions or in a branch of `if`.
    ///
    /// # Errors
    /// A function that is no such one, and whatever goes wrong inside.
    pub(super) fn comparisons(
        &mut self,
        function: &Value,
        args: &[Value],
        span: Span,
    ) -> Result<Vec<Comparison>> {
        let script = match function {
            Value::Function(Function::Closure(closure)) => {
                closure.as_any().downcast_ref::<ScriptFunction>()
            }
            _ => None,
        };
        let Some(script) = script else { return no_comparison(function, span) };
        let parameters = &script.lambda().parameters;
        let required = parameters.iter().filter(|parameter| parameter.default.is_none()).count();
        if args.len() < required || parameters.len() < args.len() {
            let message = format!("this function must take {} unknown, in one value", args.len());
            return Diagnostic::error(Code::BadCall, span, message)
                .hint("several unknowns come as one point, list or record: `u => u.x + u.y <= 5`")
                .fail();
        }
        let mut slots: Vec<Option<Value>> = args.iter().cloned().map(Some).collect();
        slots.resize(parameters.len(), None);
        self.step(span)?;
        let mut found = Vec::new();
        self.enter(script, slots, |machine, body| machine.compare(body, &mut found))?;
        Ok(found)
    }

    fn compare(&mut self, expr: &Expr, found: &mut Vec<Comparison>) -> Result<()> {
        match &expr.kind {
            ExprKind::Binary(BinaryOp::And, sides) => {
                sides.iter().try_for_each(|side| self.compare(side, found))
            }
            ExprKind::Binary(op, sides) => {
                let (relation, [less, more]) = match op {
                    BinaryOp::Equal | BinaryOp::Near => (Relation::Equal, [1, 0]),
                    BinaryOp::Less | BinaryOp::LessEqual => (Relation::NotNegative, [0, 1]),
                    BinaryOp::Greater | BinaryOp::GreaterEqual => (Relation::NotNegative, [1, 0]),
                    _ => return no_condition(expr),
                };
                let values = [self.eval(&sides[0])?, self.eval(&sides[1])?];
                let places = operator::OperandPlaces {
                    whole: expr.span,
                    left: sides[more].span,
                    right: sides[less].span,
                };
                let (minus, tolerance) = (BinaryOp::Subtract, self.env.tolerance);
                let difference =
                    operator::binary(minus, &values[more], &values[less], places, tolerance)?;
                found.push(Comparison { relation, difference, span: expr.span });
                Ok(())
            }
            ExprKind::Block(block) => {
                self.define(block)?;
                self.compare(&block.value, found)
            }
            ExprKind::If(parts) => {
                let is_first = self.truth(&parts[0], "the condition of `if`")?;
                self.compare(if is_first { &parts[1] } else { &parts[2] }, found)
            }
            ExprKind::List(elements) => elements.iter().try_for_each(|element| match element {
                Element::Item(item) => self.compare(item, found),
                Element::Spread(item) => self.compare(item, found),
                Element::Grown { slot, span } => {
                    self.compare(&Expr { kind: ExprKind::Local(*slot), span: *span }, found)
                }
            }),
            ExprKind::Comprehension(each) => self.compare_each(each, 0, expr.span, found),
            _ => no_condition(expr),
        }
    }
}

impl Machine<'_> {
    /// What a comprehension compares for each of its elements.
    fn compare_each(
        &mut self,
        comprehension: &Comprehension,
        level: usize,
        span: Span,
        found: &mut Vec<Comparison>,
    ) -> Result<()> {
        let Some(generator) = comprehension.generators.get(level) else {
            self.check_length(found.len() + 1, span)?;
            return self.compare(&comprehension.body, found);
        };
        let source = self.eval(&generator.source)?;
        for item in self.iterate(&source, generator.source.span)? {
            if self.bind(generator, item, span)? {
                self.compare_each(comprehension, level + 1, span, found)?;
            }
        }
        Ok(())
    }
}

fn no_condition<T>(expr: &Expr) -> Result<T> {
    let message = "a condition must be a comparison by `<=`, `>=`, `==` or `~=`";
    Diagnostic::error(Code::WrongKind, expr.span, message)
        .hint("several stand in a list or are joined by `and`: `[for r in radii: r >= 3mm]`")
        .fail()
}

fn no_comparison<T>(function: &Value, span: Span) -> Result<T> {
    let message =
        format!("conditions are given by a function that compares, found {}", function.phrase());
    Diagnostic::error(Code::WrongKind, span, message)
        .hint("for example `subject = u => u.x + u.y <= 5 and u.x >= u.y`")
        .fail()
}
