//! `solve` from a start: unknowns for which several functions are zero together.

use std::cell::Cell;

use super::{
    no_derivatives, six_digits,
    unknowns::{Unknowns, asked, is_without_value, numbers, without_derivatives},
};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        GeomError, Jet, LeastSquares, LocalError, Wanted, find_system_root, solve_linear,
        tolerance::{DIFFERENCE_RELATIVE, ROOT_BESIDE_RELATIVE},
    },
    value::{At, Callback, CommonDimension, Ctx, Dimension, Real, Value},
};

/// The unknowns near the start, how they were found, and the dimension of what is to be zero, where all of it has one.
pub(super) fn solved(
    ctx: &mut Ctx<'_>,
    function: &Spanned<Callback>,
    start: &Spanned<Value>,
    within: Option<&Spanned<Value>>,
) -> Result<(Value, LeastSquares, Dimension)> {
    let is_varying = ctx.caller.is_varying(&function.value.0);
    // Where the search begins has no part in where the root is.
    let unknowns = Unknowns::new(&Spanned::new(without_derivatives(&start.value), start.span))?;
    let bounds = unknowns.bounds(within)?;
    unknowns.check_inside(&bounds, start.span)?;
    let (n_residuals, mut dim) = (Cell::new(0), Dimension::NONE);
    let (mut common, mut is_mixed) = (CommonDimension::default(), false);
    let mut ask = |place: &Value| {
        let value = asked(ctx, &function.value, place)?;
        let mut all = Vec::new();
        numbers(&value, function.span, &mut all)?;
        check_as_many(&n_residuals, all.len(), place, function.span)?;
        is_mixed |= all.iter().any(|number| common.take(number.looked_at()).is_err());
        if all.iter().any(|number| number.dim.length_power().is_none()) {
            dim = Dimension::OPEN;
        }
        Ok(all.into_iter().map(|number| number.value).collect())
    };
    let mut is_start = true;
    let found = find_system_root(
        |values, wanted| {
            let wanted = if is_varying { Wanted::Values } else { wanted };
            let is_tried = !std::mem::replace(&mut is_start, false);
            match unknowns.answers(values, wanted, &mut ask) {
                // A step too long; at the start it is the script's mistake.
                Err(found) if is_tried && is_without_value(&found) => {
                    Ok(vec![f64::INFINITY; n_residuals.get()].into())
                }
                other => other,
            }
        },
        &unknowns.values,
        &bounds,
    )?;
    if size(&found.first_residuals) <= 0.0 && is_zero_around(&unknowns, &mut ask) {
        let place = unknowns.rounded(&unknowns.values);
        let message = format!("what is to be 0 is 0 at the start, {place}, and all around it");
        return Diagnostic::error(Code::NoAnswer, function.span, message)
            .label("so it has no single root")
            .hint("it may not depend on the unknowns; else start elsewhere")
            .fail();
    }
    check_count(&unknowns, &found, function.span, &mut ask)?;
    let is_overdetermined = unknowns.values.len() < found.residuals.len();
    if found.is_root() || is_overdetermined && found.is_settled {
        let reals = match is_varying {
            true => varying(&unknowns, &found, (start.span, function.span), &mut ask)?,
            false => found.unknowns.iter().copied().map(Real::Plain).collect(),
        };
        let of_residuals = if is_mixed { Dimension::NONE } else { common.dimension() };
        return Ok((unknowns.found_by(dim).with_reals(&reals), found, of_residuals));
    }
    no_root(&unknowns, &found, start.span, within.is_some())
}

/// Whether the function yields as many numbers as before, one or more; the first count is kept.
fn check_as_many(count: &Cell<usize>, n: usize, place: &Value, span: Span) -> Result<()> {
    let n_before = if count.get() == 0 { n } else { count.get() };
    count.set(n_before);
    if n == n_before && n != 0 {
        return Ok(());
    }
    if n == 0 {
        let message = format!("the function yields no numbers at {place}");
        return Diagnostic::error(Code::WrongKind, span, message)
            .hint("it yields what is to be 0, a number or a list of such: `u => [u.a + u.b - 3, u.a - u.b]`")
            .fail();
    }
    let message = format!("the function yields {n} numbers at {place}, and {n_before} before");
    Diagnostic::error(Code::WrongKind, span, message).fail()
}

/// Why there is no root, where the search ended.
fn no_root<T>(
    unknowns: &Unknowns,
    found: &LeastSquares,
    start: Span,
    is_bounded: bool,
) -> Result<T> {
    let [left, first] = [&found.residuals, &found.first_residuals].map(|values| size(values));
    let within = if is_bounded { " within the bounds" } else { "" };
    let tends = if found.is_small() { ": the functions only tend to 0, or come near" } else { "" };
    let message = format!("no root was found from this start{within}{tends}");
    Diagnostic::error(Code::NoAnswer, start, message)
        .label(format!("the search ended at {}", unknowns.rounded(&found.unknowns)))
        .hint(format!(
            "of what is to be 0 there is {} left there, of {} at the start; another start may lead to a root",
            six_digits(left, None),
            six_digits(first, None)
        ))
        .fail()
}

/// The largest of some values by size.
fn size(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most: f64, value| most.max(value.abs()))
}

/// That there are as many equations as unknowns on which they depend, or more: of a point in the plane nothing
/// depends on z.
fn check_count(
    unknowns: &Unknowns,
    found: &LeastSquares,
    span: Span,
    ask: &mut dyn FnMut(&Value) -> Result<Vec<Real>>,
) -> Result<()> {
    let n_equations = found.residuals.len();
    if unknowns.values.len() <= n_equations {
        return Ok(());
    }
    let slopes = slopes(unknowns, &found.unknowns, ask)?;
    let moves = |column: &usize| slopes.iter().any(|row| row[*column].abs() > 0.0);
    let n_moving = (0..unknowns.values.len()).filter(moves).count();
    if n_moving <= n_equations {
        return Ok(());
    }
    let numbers = if n_equations == 1 { "number" } else { "numbers" };
    let message = format!(
        "the function yields {n_equations} {numbers} for {n_moving} unknowns, which have no single root"
    );
    Diagnostic::error(Code::NoAnswer, span, message)
        .hint("let it yield as many as there are unknowns, or more; of what is left free, `minimize` with `subject` finds the best")
        .fail()
}

/// Whether all is zero at two places beside the start; where it fails it is not.
fn is_zero_around(unknowns: &Unknowns, ask: &mut dyn FnMut(&Value) -> Result<Vec<Real>>) -> bool {
    [ROOT_BESIDE_RELATIVE, -0.5 * ROOT_BESIDE_RELATIVE].iter().all(|reach| {
        // By different shares, lest their differences stay.
        let moved = unknowns.values.iter().enumerate().map(|(idx, &at)| {
            let size = if 0.0 < at.abs() { at.abs() } else { 1.0 };
            at + reach * size * (1.0 + 1.0 / (idx as f64 + 2.0))
        });
        let place = unknowns.with(&moved.collect::<Vec<f64>>());
        ask(&place).is_ok_and(|values| values.iter().all(|value| value.value().abs() <= 0.0))
    })
}

/// A root with the derivatives that it has by what the functions take from around them, since they stay zero
/// there: by the theorem of implicit functions, with differences for their slopes by the unknowns, whose rounding
/// goes out with each step. Griewank & Walther, *Evaluating Derivatives*, §15.1.
fn varying(
    unknowns: &Unknowns,
    found: &LeastSquares,
    (start, span): (Span, Span),
    ask: &mut dyn FnMut(&Value) -> Result<Vec<Real>>,
) -> Result<Vec<Real>> {
    let root = &found.unknowns;
    let slopes = slopes(unknowns, root, ask)?;
    // What no function depends on is where the search began.
    let moving: Vec<usize> = (0..root.len())
        .filter(|&column| slopes.iter().any(|row| row[column].abs() > 0.0))
        .collect();
    let mut places: Vec<Real> = root.iter().copied().map(Real::Plain).collect();
    let like = ask(&unknowns.with(root))?.into_iter().find_map(|value| match value {
        Real::Jet(jet) => Some(jet),
        Real::Plain(_) => None,
    });
    let Some(like) = like else { return Ok(places) };
    if moving.len() != slopes.len() {
        return no_derivatives(span);
    }
    let matrix: Vec<Vec<f64>> =
        slopes.iter().map(|row| moving.iter().map(|&column| row[column]).collect()).collect();
    for place in &mut places {
        *place = Real::Jet(place.like(&like));
    }
    for _ in 0..like.order() + 2 {
        let left: Vec<Jet> =
            ask(&unknowns.with_reals(&places))?.iter().map(|value| value.like(&like)).collect();
        let mut steps = vec![vec![0.0]; moving.len()];
        for term in 1..like.coefficients().len() {
            let right = left.iter().map(|jet| jet.coefficients()[term]).collect();
            let Some(found) = solve_linear(matrix.clone(), right) else {
                let what = "a root where the equations do not cross";
                let at = root.first().copied().unwrap_or_default();
                return Err(GeomError::from(LocalError::NotDifferentiable { what, at })).at(start);
            };
            steps.iter_mut().zip(found).for_each(|(steps, step)| steps.push(step));
        }
        for (&column, steps) in moving.iter().zip(&steps) {
            let before = places[column].like(&like);
            places[column] = Real::Jet(before.minus(&like.with_coefficients(steps)));
        }
    }
    Ok(places)
}

/// The slopes of each function by all unknowns, by central differences.
fn slopes(
    unknowns: &Unknowns,
    root: &[f64],
    ask: &mut dyn FnMut(&Value) -> Result<Vec<Real>>,
) -> Result<Vec<Vec<f64>>> {
    let mut slopes: Vec<Vec<f64>> = Vec::new();
    for (column, (&at, &start)) in root.iter().zip(&unknowns.values).enumerate() {
        let size = at.abs().max((at - start).abs());
        let step = DIFFERENCE_RELATIVE * if 0.0 < size { size } else { 1.0 };
        let mut beside = |step: f64| -> Result<(f64, Vec<Real>)> {
            let mut moved = root.to_vec();
            moved[column] += step;
            Ok((moved[column], ask(&unknowns.with(&moved))?))
        };
        let ((low, before), (high, behind)) = (beside(-step)?, beside(step)?);
        slopes.resize(before.len(), Vec::new());
        for (row, (before, behind)) in slopes.iter_mut().zip(before.iter().zip(&behind)) {
            row.push((behind.value() - before.value()) / (high - low));
        }
    }
    Ok(slopes)
}
