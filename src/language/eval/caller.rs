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
        self.apply(function, args, span)
    }

    fn comparisons(
        &mut self,
        function: &Value,
        args: &[Value],
        span: Span,
    ) -> Result<Vec<Comparison>> {
        Machine::comparisons(self, function, args, span)
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
