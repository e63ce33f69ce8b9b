//! What built-ins may ask of the machine that calls them.

use std::sync::Arc;

use super::{
    lanes::bounded,
    machine::Machine,
    parametric::{GeometryFunction, holds_jets},
};
use crate::{
    diag::{Diagnostic, Result, Span},
    kernel::{CurveFunction, SurfaceFunction},
    value::{Bounded, Caller, Comparison, Switch, Value, Witness},
};

impl Caller for Machine<'_> {
    fn call(&mut self, function: &Value, args: Vec<Value>, span: Span) -> Result<Value> {
        let had_varying_texts = self.has_varying_texts;
        let found = self.apply(function, args, span);
        // Whoever differentiates asks for no texts.
        if !found.as_ref().is_ok_and(may_hold_text) {
            self.has_varying_texts = had_varying_texts;
        }
        found
    }

    fn comparisons(
        &mut self,
        function: &Value,
        args: &[Value],
        span: Span,
    ) -> Result<Vec<Comparison>> {
        let had_varying_texts = self.has_varying_texts;
        let found = Machine::comparisons(self, function, args, span);
        self.has_varying_texts = had_varying_texts;
        found
    }

    fn bounded(&self, function: &Value) -> Option<Box<dyn Bounded>> {
        bounded(self, function)
    }

    fn is_varying(&self, function: &Value) -> bool {
        holds_jets(function)
    }

    fn curve_function(&self, function: &Value, span: Span) -> Result<Arc<dyn CurveFunction>> {
        Ok(GeometryFunction::new(self, function, span)?)
    }

    fn surface_function(&self, function: &Value, span: Span) -> Result<Arc<dyn SurfaceFunction>> {
        Ok(GeometryFunction::new(self, function, span)?)
    }

    fn decided(&mut self, span: Span, witness: Witness) {
        self.witness = Some((span, witness));
    }

    fn note_switches(&mut self, noted: Option<Vec<Switch>>) -> Option<Vec<Switch>> {
        std::mem::replace(&mut self.switches, noted)
    }

    fn made_varying_text(&mut self) {
        self.has_varying_texts = true;
    }

    fn has_varying_texts(&self) -> bool {
        self.has_varying_texts
    }

    fn warn(&mut self, warning: Diagnostic) {
        self.warnings.push(warning);
    }

    fn n_warnings(&self) -> usize {
        self.warnings.len()
    }

    fn keep_warnings(&mut self, n: usize) {
        self.warnings.truncate(n);
    }
}

fn may_hold_text(value: &Value) -> bool {
    match value {
        Value::Number(_) | Value::Jet(_) | Value::Point(_) | Value::JetPoint(_) => false,
        Value::Curve(_) | Value::JetCurve(_) | Value::Surface(_) | Value::JetSurface(_) => false,
        Value::List(items) => items.numbers().is_none() && items.iter().any(may_hold_text),
        _ => true,
    }
}
