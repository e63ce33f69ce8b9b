//! Claims that test the elements of a list: which one decided, by how much, and how many fail.

use super::{ClaimPlaces, Verdict, shown};
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    eval::{
        function::ScriptFunction,
        ir::{Expr, ExprKind, UnaryOp},
        machine::Machine,
    },
    syntax::ast::Unit,
    value::{Function, List, Value, Witness, WitnessOf},
};

impl Machine<'_> {
    /// What a claim that compares nothing came to, and which element of a list decided it.
    pub(super) fn plain_verdict(&mut self, value: &Value, claim: &Expr) -> Result<Verdict> {
        match value {
            Value::Bool(holds) => {
                let own = self.witness.take().filter(|(span, _)| is_decided_by(claim, *span));
                Ok(match own {
                    Some((span, witness)) => self.list_verdict(&witness, *holds, claim, span),
                    None => Verdict { holds: *holds, ..Verdict::default() },
                })
            }
            other => {
                let message =
                    format!("a check takes something true or false, found {}", other.phrase());
                Diagnostic::error(Code::CheckNotBool, claim.span, message)
                    .hint("compare it with something: `==`, `<`, `~=`")
                    .fail()
            }
        }
    }

    fn list_verdict(
        &mut self,
        Witness { of, list, test }: &Witness,
        holds: bool,
        claim: &Expr,
        span: Span,
    ) -> Verdict {
        let passes = holds != is_denied(claim);
        let mut told = ListWords { passes, unit: self.env.unit, distances: None, n_failing: None };
        let (mut shown, mut places) = (Verdict::default(), ClaimPlaces::default());
        if !holds {
            if let WitnessOf::Element(idx) = of
                && let Some(element) = list.get(*idx)
            {
                places.note(&element);
            }
            let verdicts = self.verdicts(of, list, test.as_ref(), span);
            told.n_failing = verdicts.n_failing;
            if let Some(verdict) = verdicts.shown {
                told.distances = verdict.apart.is_some().then(|| verdict.distances());
                shown = verdict;
            }
        }
        let witness = Some(told.sentence(of, list));
        for point in shown.places {
            places.add(point);
        }
        Verdict { holds, witness, places: places.of_failure(holds), ..shown }
    }

    /// What the test says of the element that decided, or of the first where all fail; and how many fail.
    /// Both are more than the claim needed, so that what goes wrong in them leaves them out.
    fn verdicts(
        &mut self,
        of: &WitnessOf,
        list: &List,
        test: Option<&Value>,
        span: Span,
    ) -> ListVerdicts {
        let (first, is_counted) = match of {
            WitnessOf::Element(idx) => (Some(*idx), true),
            WitnessOf::All => ((!list.is_empty()).then_some(0), false),
        };
        let element = first.and_then(|idx| list.get(idx));
        let shown = match (element, test) {
            (Some(element), Some(test)) => self.verdict_of(test, element, span),
            _ => None,
        };
        let n_failing = if is_counted { self.n_failing(list, test, span) } else { None };
        ListVerdicts { shown, n_failing }
    }

    /// What a function of the script that compares says of an element.
    fn verdict_of(&mut self, test: &Value, element: Value, span: Span) -> Option<Verdict> {
        let Value::Function(Function::Closure(closure)) = test else { return None };
        let script = closure.as_any().downcast_ref::<ScriptFunction>()?;
        let mut slots = vec![Some(element)];
        slots.resize(script.lambda().parameters.len(), None);
        let mut verdict = None;
        self.step(span).ok()?;
        let found = self.enter(script, slots, |machine, body| {
            verdict = Some(machine.verdict(body)?);
            Ok(())
        });
        found.ok().and(verdict).map(|verdict| Verdict { witness: None, ..verdict })
    }

    /// How many elements fail.
    fn n_failing(&mut self, list: &List, test: Option<&Value>, span: Span) -> Option<usize> {
        let mut n = 0;
        for element in list.values() {
            let passes = match test {
                Some(test) => self.apply(test, vec![element], span).ok()?,
                None => element,
            };
            n += usize::from(!matches!(passes, Value::Bool(true)));
        }
        Some(n)
    }
}

/// What is told of a claim about a list beyond its truth.
struct ListVerdicts {
    shown: Option<Verdict>,
    n_failing: Option<usize>,
}

/// What goes into the sentence about a list.
struct ListWords {
    /// Whether the test of the list holds, whatever the claim makes of that.
    passes: bool,
    unit: Unit,
    /// Of the element that is told of.
    distances: Option<String>,
    n_failing: Option<usize>,
}

impl ListWords {
    /// What decided the test of a list.
    fn sentence(&self, of: &WitnessOf, list: &List) -> String {
        let n = list.len();
        match of {
            WitnessOf::Element(idx) => {
                let verb = if self.passes { "passes" } else { "fails" };
                let element = list.get(*idx).unwrap_or(Value::None);
                let element = element_text(&element, self.unit);
                let mut text = format!("element [{idx}] is {element}, which {verb}");
                if let (false, Some(distances)) = (self.passes, &self.distances) {
                    text = format!("{text}: {distances}");
                }
                if let (false, Some(n_failing)) = (self.passes, self.n_failing) {
                    text = format!("{text}; {n_failing} of {n} fail");
                }
                text
            }
            WitnessOf::All if n == 0 => "the list is empty".to_owned(),
            WitnessOf::All if self.passes => format!("all {n} elements pass"),
            WitnessOf::All => match &self.distances {
                Some(distances) => {
                    format!("none of the {n} elements passes; element [0]: {distances}")
                }
                None => format!("none of the {n} elements passes"),
            },
        }
    }
}

fn element_text(element: &Value, unit: Unit) -> String {
    match element {
        Value::Number(_)
        | Value::Point(_)
        | Value::Text(_)
        | Value::Bool(_)
        | Value::List(_)
        | Value::Record(_) => shown(element, unit),
        other => other.phrase(),
    }
}

/// Whether the call at a place is the claim, or what it denies.
fn is_decided_by(claim: &Expr, call: Span) -> bool {
    match &claim.kind {
        ExprKind::Unary(UnaryOp::Not, inner) => is_decided_by(inner, call),
        _ => claim.span == call,
    }
}

/// Whether the claim is that its innermost part does not hold.
fn is_denied(claim: &Expr) -> bool {
    match &claim.kind {
        ExprKind::Unary(UnaryOp::Not, inner) => !is_denied(inner),
        _ => false,
    }
}
