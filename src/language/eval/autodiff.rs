//! Calls of geometry and of operations in functions that are differentiated.
//!
//! The point and every mistake are those of the plain parameters; the derivatives come on top. What
//! operators do to derivatives stands in the table of operators.

use std::{cell::Cell, sync::Arc};

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{Interval, PointEntries, Surface},
    value::{
        At, CARRIES_DERIVATIVES, Call, Ctx, FromValue, IntoValue, Making, Op, Real, RealCurve,
        RealSurface, Settling, Value, looked_at, through_shape, through_told, varies, with_form_of,
        with_slopes_of_points,
    },
};

/// A parameter inside a domain.
fn inside(domain: Interval, t: Spanned<Real>) -> Result<Real> {
    let clamped = domain.clamp_inside(t.value.value()).at(t.span)?;
    Ok(t.value.with_value(clamped))
}

/// The point of a curve at a parameter, either of which may carry derivatives.
pub(super) fn point_on_curve(curve: &Value, t: Spanned<Real>, span: Span) -> Result<Value> {
    let curve = read::<RealCurve>(curve, span)?;
    let t = inside(curve.domain(), t)?;
    let Some(jet) = curve.jet_of(&t).at(span)? else {
        return curve.point_at(t.value()).at(span).map(Value::Point);
    };
    // At a knot the piece counts that the parameter moves into.
    Ok(curve.series_beside(&jet, t.side(), 0).at(span)?.remove(0).into_value())
}

/// The point of a surface at parameters, any of which may carry derivatives.
pub(super) fn point_on_surface(
    surface: &Value,
    [u, v]: [Spanned<Real>; 2],
    span: Span,
) -> Result<Value> {
    let surface = read::<RealSurface>(surface, span)?;
    let (u, v) = (inside(surface.domain_u(), u)?, inside(surface.domain_v(), v)?);
    let Some(jets) = surface.jets_of([&u, &v], None).at(span)? else {
        return surface.point_at(u.value(), v.value()).at(span).map(Value::Point);
    };
    let series = surface.series_at(jets.each_ref(), 0).at(span)?;
    Ok(series.row(0)[0].clone().into_value())
}

/// Geometry that is called.
fn read<T: FromValue>(geometry: &Value, span: Span) -> Result<T> {
    T::from_value(geometry, span).map_err(|mismatch| {
        Box::new(Diagnostic::error(mismatch.code, span, mismatch.sentence("this", T::TYPE)))
    })
}

/// What an operation answers; where derivatives pass through it as a whole, with them.
pub(super) fn run(op: &'static Op, ctx: &mut Ctx<'_>, call: Call) -> Result<Value> {
    let is_varying = op.is_affine
        && (call.positional.iter().any(|arg| varies(&arg.value))
            || call.named.iter().any(|(_, arg)| varies(&arg.value)));
    if !is_varying || op.derives_itself.is_some_and(|derives| derives(&call)) {
        return (op.run)(ctx, call);
    }
    if op.has_given_control_points {
        let n_warnings = ctx.caller.n_warnings();
        let answer = (op.run)(ctx, plain(&call))?;
        if let Some(found) = with_slopes_of_points(op, &call, &answer) {
            return Ok(found);
        }
        ctx.caller.keep_warnings(n_warnings);
    }
    if let Some(settling) = op.settling
        && let Some(found) = settled((op, settling), ctx, &call)?
    {
        return Ok(found);
    }
    let is_of_shape = is_of_shape(op, &call);
    beside(op, is_of_shape, ctx, call)
}

/// Whether what an operation answers to a call depends on shapes alone: a rule may look at knots; what is listed does
/// not.
fn is_of_shape(op: &Op, call: &Call) -> bool {
    let is_listed = |settling: &&Settling| {
        call.named.iter().any(|(name, given)| {
            &*name.value == settling.parameter && matches!(given.value, Value::List(_))
        })
    };
    op.is_of_shape && op.settling.as_ref().is_none_or(is_listed)
}

/// What an operation answers that finds something by a rule: with that held, and how it moves on top; none where that
/// is not known, or nothing is found.
fn settled(
    (op, settling): (&'static Op, &Settling),
    ctx: &mut Ctx<'_>,
    call: &Call,
) -> Result<Option<Value>> {
    let moving = settling.moving.filter(|(applies, _)| applies(call)).map(|(_, moving)| moving);
    if moving.is_none() && settling.held.is_none() && settling.known.is_none() {
        return Ok(None);
    }
    let n_before = ctx.caller.n_warnings();
    let answer = (op.run)(ctx, plain(call))?;
    let Value::Surface(Surface::Nurbs(surface)) = &answer else { return Ok(None) };
    let report = surface.report().map(IntoValue::into_value);
    let Some(Value::Record(report)) = report else { return Ok(None) };
    if let Some(known) = settling.known
        && let Some(varied) = known(call, surface, &report).at(call.span)?
    {
        return Ok(Some(Value::JetSurface(varied.into())));
    }
    if moving.is_none() && settling.held.is_none() {
        ctx.caller.keep_warnings(n_before);
        return Ok(None);
    }
    let Some(found) = report.get(settling.parameter) else { return Ok(None) };
    let n_warnings = ctx.caller.n_warnings();
    let mut held = call.clone();
    let mut hold = |name: &'static str, value: Value| {
        held.named.retain(|(own, _)| &*own.value != name);
        let name = Spanned::new(Arc::from(name), call.span);
        held.named.push((name, Spanned::new(value, call.span)));
    };
    for (name, value) in settling.held.map(|held| held(&report)).unwrap_or_default() {
        hold(name, value);
    }
    if moving.is_some() {
        hold(settling.parameter, found.clone());
    }
    let is_of_shape = is_of_shape(op, &held);
    let fixed = beside(op, is_of_shape, ctx, held);
    ctx.caller.keep_warnings(n_warnings);
    let Some(moving) = moving else {
        return Ok(fixed.ok().and_then(|fixed| with_form_of(&fixed, &answer)));
    };
    let Value::JetSurface(fixed) = fixed? else { return Ok(None) };
    let moved = moving(call, &fixed, found).at(call.span)?;
    Ok(moved.and_then(|moved| with_form_of(&Value::JetSurface(moved.into()), &answer)))
}

/// A call without derivatives.
fn plain(call: &Call) -> Call {
    let mut plain = call.clone();
    arguments(&mut plain).for_each(|arg| arg.value = looked_at(&arg.value));
    plain
}

fn arguments(call: &mut Call) -> impl Iterator<Item = &mut Spanned<Value>> {
    call.positional.iter_mut().chain(call.named.iter_mut().map(|(_, arg)| arg))
}

/// What an operation answers at its arguments and beside them, with derivatives.
fn beside(op: &'static Op, is_of_shape: bool, ctx: &mut Ctx<'_>, mut call: Call) -> Result<Value> {
    let args: Vec<Value> = arguments(&mut call).map(|arg| arg.value.clone()).collect();
    let mut n_warnings = None;
    let told = Cell::new(None);
    let span = call.span;
    let run = |args: &[Value]| {
        let mut call = call.clone();
        arguments(&mut call).zip(args).for_each(|(place, value)| place.value = value.clone());
        // Only of the arguments themselves is it asked how its answer is made, and told what it says.
        if n_warnings.is_none() {
            ctx.making = Making::Asked;
        }
        let found = (op.run)(ctx, call);
        if let Making::Told(entries) = std::mem::take(&mut ctx.making) {
            told.set(Some(entries));
        }
        let n = *n_warnings.get_or_insert_with(|| ctx.caller.n_warnings());
        ctx.caller.keep_warnings(n);
        found
    };
    let name = format!("`{}`", op.name);
    through_kind((&name, is_of_shape), span, &args, run, &|| told.take())
}

/// What something answers to values that carry derivatives, with them; whether it depends on the shape of
/// curves alone is told with its name.
pub(super) fn through(
    kind: (&str, bool),
    span: Span,
    args: &[Value],
    run: impl FnMut(&[Value]) -> Result<Value>,
) -> Result<Value> {
    through_kind(kind, span, args, run, &|| None)
}

/// The same of something that may tell how its answer is made of points.
fn through_kind(
    (what, is_of_shape): (&str, bool),
    span: Span,
    args: &[Value],
    mut run: impl FnMut(&[Value]) -> Result<Value>,
    told: &dyn Fn() -> Option<PointEntries>,
) -> Result<Value> {
    let found = match is_of_shape {
        true => through_shape(args, &mut run),
        false => through_told(args, &mut run, told),
    };
    found?.or_else(|reason| {
        let message = format!("{what}: {}", reason.message());
        Diagnostic::error(Code::NoDerivative, span, message).hint(reason.hint()).fail()
    })
}

/// Fails: nothing there could carry the derivatives on.
pub(super) fn no_derivative<T>(what: &str, span: Span) -> Result<T> {
    let message = format!("{what} cannot be differentiated");
    Diagnostic::error(Code::NoDerivative, span, message).hint(CARRIES_DERIVATIVES).fail()
}
