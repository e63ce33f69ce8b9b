//! Calls with places left open by `_`: isocurves, and functions of what is left out.

use std::sync::Arc;

use super::{autodiff::through, ir::CallExpr, machine::Machine};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    value::{At, Call, FromValue, Function, Partial, Type, Value, varies},
};

impl Machine<'_> {
    /// A call with `_`: of geometry an isocurve, else a function of what is left out.
    #[inline(never)]
    pub(super) fn partial(&mut self, callee: Value, call: &CallExpr, span: Span) -> Result<Value> {
        let (mut positional, mut named) = (Vec::new(), Vec::new());
        for arg in &call.args {
            let value = match &arg.value {
                Some(expr) => Some(self.eval(expr)?),
                None => None,
            };
            match &arg.label {
                None => positional.push(value),
                Some((label, _)) => named.push((Arc::clone(label), value)),
            }
        }
        if let Some(geometry) = self.isocurve(&callee, &positional, &named, call)? {
            return Ok(geometry);
        }
        if !Type::Function.accepts(&callee) {
            let message = format!("{} cannot be called", callee.phrase());
            return Diagnostic::error(Code::NotCallable, span, message).fail();
        }
        Ok(Value::Function(Function::Partial(Arc::new(Partial { callee, positional, named }))))
    }

    /// `s(u, _)` and `s(_, v)` are curves, `c(_)` is the curve itself.
    fn isocurve(
        &self,
        callee: &Value,
        positional: &[Option<Value>],
        named: &[(Arc<str>, Option<Value>)],
        call: &CallExpr,
    ) -> Result<Option<Value>> {
        if !named.is_empty() {
            return Ok(None);
        }
        let parameter = |value: &Value, idx: usize| {
            let span = call.args[idx].span;
            f64::from_value(value, span).map(|t| (t, span)).map_err(|mismatch| {
                let message = mismatch.sentence("a parameter of a surface", Type::Ratio);
                Box::new(Diagnostic::error(mismatch.code, span, message))
            })
        };
        if varies(callee) || positional.iter().flatten().any(varies) {
            let given = positional.iter().flatten().cloned();
            let args: Vec<Value> = std::iter::once(callee.clone()).chain(given).collect();
            let is_open: Vec<bool> = positional.iter().map(Option::is_none).collect();
            if !matches!(callee.kind(), "curve" | "surface") {
                return Ok(None);
            }
            return through(("this isocurve", true), call.callee.span, &args, |args| {
                let mut given = args.iter().skip(1).cloned();
                let open = is_open.iter().map(|is_open| if *is_open { None } else { given.next() });
                let open: Vec<Option<Value>> = open.collect();
                let found = self.isocurve(&args[0], &open, named, call)?;
                Ok(found.unwrap_or(Value::None))
            })
            .map(|found| (!matches!(found, Value::None)).then_some(found));
        }
        Ok(Some(match (callee, positional) {
            (Value::Curve(_), [None]) => callee.clone(),
            (Value::Surface(_), [None, None]) => callee.clone(),
            (Value::Surface(surface), [Some(u), None]) => {
                let (u, span) = parameter(u, 0)?;
                let u = surface.domain_u().clamp_inside(u).at(span)?;
                Value::Curve(surface.isocurve_u(u).at(span)?)
            }
            (Value::Surface(surface), [None, Some(v)]) => {
                let (v, span) = parameter(v, 1)?;
                let v = surface.domain_v().clamp_inside(v).at(span)?;
                Value::Curve(surface.isocurve_v(v).at(span)?)
            }
            _ => return Ok(None),
        }))
    }

    /// Calls what was left open with the arguments for its placeholders.
    #[inline(never)]
    pub(super) fn fill(&mut self, partial: &Partial, call: Call, place: Span) -> Result<Value> {
        let n_open = partial.positional.iter().filter(|arg| arg.is_none()).count()
            + partial.named.iter().filter(|(_, arg)| arg.is_none()).count();
        if call.positional.len() != n_open || !call.named.is_empty() {
            let found = call.positional.len() + call.named.len();
            let message =
                format!("{n_open} arguments are left open with `_`, but {found} are given");
            return Diagnostic::error(Code::BadCall, call.span, message).fail();
        }
        let span = call.span;
        let mut given = call.positional.into_iter();
        let mut next = |arg: &Option<Value>| match arg {
            Some(value) => Some(Spanned::new(value.clone(), span)),
            None => given.next(),
        };
        let positional: Vec<Spanned<Value>> =
            partial.positional.iter().filter_map(&mut next).collect();
        let named = partial
            .named
            .iter()
            .filter_map(|(label, arg)| Some((Spanned::new(Arc::clone(label), span), next(arg)?)))
            .collect();
        self.invoke(&partial.callee, Call { span, positional, named }, place)
    }
}
