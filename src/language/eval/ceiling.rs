//! The ceilings that the machine keeps while it evaluates: steps, depth, memory, and how large a
//! value may be.

use super::machine::Machine;
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    kernel::{Curve, Surface},
    limits::{
        Ceiling, Limits,
        work::{self, End, Watch},
    },
    value::{Value, ValueExtent},
};

impl Machine<'_> {
    /// Counts a step of evaluation.
    pub(super) fn step(&mut self, span: Span) -> Result<()> {
        self.steps(1, span)
    }

    /// Whether so many more steps can be counted.
    pub(super) fn has_steps(&self, n: u64) -> bool {
        self.steps.saturating_add(n) <= self.env.limits.steps
    }

    /// Counts steps of evaluation.
    pub(super) fn steps(&mut self, n: u64, span: Span) -> Result<()> {
        work::count(n);
        self.steps = self.steps.saturating_add(n);
        if self.steps <= self.env.limits.steps {
            return self.check_memory(span);
        }
        self.ended(End::Steps, span)
    }

    /// Counts the copying or the comparing of parts of a value.
    pub(super) fn passes(&mut self, n_parts: u64, span: Span) -> Result<()> {
        match n_parts / work::PARTS_A_STEP {
            0 => Ok(()),
            n => self.steps(n, span),
        }
    }

    /// Fails when the run holds more memory than it may, or is no longer wanted.
    pub(super) fn check_memory(&mut self, span: Span) -> Result<()> {
        if self.env.stop.is_stopped() {
            return self.ended(End::Stopped, span);
        }
        if self.env.gauge.held() <= self.env.limits.memory_bytes {
            return Ok(());
        }
        self.ended(End::Memory, span)
    }

    /// What an operation may take from now on.
    pub(super) fn watch(&self) -> Watch {
        let Limits { memory_bytes, steps, .. } = *self.env.limits;
        let steps = steps.saturating_sub(self.steps);
        Watch { gauge: self.env.gauge.clone(), memory_bytes, stop: self.env.stop.clone(), steps }
    }

    /// Fails because there is no more to be had.
    pub(super) fn ended<T>(&mut self, end: End, span: Span) -> Result<T> {
        let limits = self.env.limits;
        let label = "under way here";
        match end {
            End::Steps => {
                let message = format!("this takes more than {} steps of evaluation", limits.steps);
                let found = Diagnostic::error(Code::TooLarge, span, message).label(label);
                found.crossing(Ceiling::STEPS).fail()
            }
            End::Stopped => {
                self.is_full = true;
                let message = "the evaluation was stopped";
                Diagnostic::error(Code::Stopped, span, message).label(label).fail()
            }
            End::Memory => {
                self.is_full = true;
                out_of_memory(limits, span).fail()
            }
        }
    }

    /// The value, unless it is deeper or larger than whoever walks through it can bear.
    #[cfg_attr(target_family = "wasm", inline(never))]
    pub(super) fn check_extent(&self, value: Value, span: Span) -> Result<Value> {
        let (ValueExtent { depth, size, .. }, limits) = (value.extent(), self.env.limits);
        let (message, ceiling) = if limits.value_depth < depth {
            let most = limits.value_depth;
            let message = format!(
                "lists, records and functions lie more than {most} deep inside one another"
            );
            (message, Ceiling::VALUE_DEPTH)
        } else if limits.value_size < size {
            (format!("a value of more than {} parts", limits.value_size), Ceiling::VALUE_SIZE)
        } else if let Some(excess) = too_fine(&value, limits) {
            excess
        } else {
            return Ok(value);
        };
        Diagnostic::error(Code::TooLarge, span, message).crossing(ceiling).fail()
    }

    #[inline(never)]
    pub(super) fn too_deep<T>(
        &self,
        message: String,
        ceiling: &'static str,
        span: Span,
    ) -> Result<T> {
        Diagnostic::error(Code::RecursionTooDeep, span, message)
            .label("one call too many")
            .hint("does every recursion reach its end?")
            .crossing(ceiling)
            .fail()
    }
}

/// The finding that the run holds more memory than it may.
pub(crate) fn out_of_memory(limits: &Limits, span: Span) -> Diagnostic {
    let message = format!("the script needs more than {} bytes of memory", limits.memory_bytes);
    Diagnostic::error(Code::TooLarge, span, message)
        .label("under way here")
        .crossing(Ceiling::MEMORY)
}

/// What is too much about a curve or surface, if anything, and the ceiling on it.
fn too_fine(value: &Value, limits: &Limits) -> Option<(String, &'static str)> {
    let (degree, n_points) = match &value.looked_at() {
        Value::Curve(Curve::Nurbs(curve)) => (curve.degree(), curve.control_points().len()),
        Value::Surface(Surface::Nurbs(surface)) => {
            (surface.degree_u().max(surface.degree_v()), surface.control_points().as_slice().len())
        }
        _ => return None,
    };
    let kind = value.kind();
    if limits.degree < degree {
        let message = format!("a {kind} of degree {degree}, more than {}", limits.degree);
        Some((message, Ceiling::DEGREE))
    } else if limits.control_points < n_points {
        let most = limits.control_points;
        let message = format!("a {kind} of {n_points} control points, more than {most}");
        Some((message, Ceiling::CONTROL_POINTS))
    } else {
        None
    }
}
