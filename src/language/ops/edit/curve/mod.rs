//! Edits of curves: each makes a new curve.

pub(super) mod continue_bezier;
pub(super) mod decompose;
pub(super) mod elevate;
pub(super) mod extend;
pub(super) mod insert_knot;
pub(super) mod join;
pub(super) mod offset;
pub(super) mod reduce;
pub(super) mod refine;
pub(super) mod remove_knot;
pub(super) mod reparametrize;
pub(super) mod reversed;
pub(super) mod split;
pub(super) mod standard_form;
pub(super) mod to_nurbs;
pub(super) mod trim;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::KnotVector,
    value::shortest,
};

/// The highest order of continuity that the language speaks of.
const HIGHEST_ORDER: usize = 3;

/// An order of continuity that the language speaks of.
pub(super) fn check_order(order: Spanned<usize>) -> Result<usize> {
    if order.value <= HIGHEST_ORDER {
        return Ok(order.value);
    }
    let message = format!("continuity is of order 0 to {HIGHEST_ORDER}, found {}", order.value);
    Diagnostic::error(Code::BadCall, order.span, message)
        .hint("order 1 keeps the derivative, 2 the bend too, 3 its change; 0 joins the ends only")
        .fail()
}

/// Fails where a knot would stand more often than its degree allows.
pub(in crate::ops::edit) fn not_too_often(
    knots: &KnotVector,
    t: Spanned<f64>,
    times: Spanned<usize>,
) -> Result<()> {
    let stands = knots.multiplicity(t.value);
    let most = knots.degree() + 1;
    if times.value <= most.saturating_sub(stands) || !knots.domain().contains(t.value) {
        return Ok(());
    }
    let message = format!(
        "knot {} would stand {} times; at degree {} it stands {most} times at most",
        shortest(t.value),
        stands.saturating_add(times.value),
        knots.degree()
    );
    let hint = match most.saturating_sub(stands) {
        0 => format!("it stands {stands} times already"),
        1 => "insert it once at most".to_owned(),
        more => format!("insert it {more} times at most"),
    };
    Diagnostic::error(Code::BadKnots, times.span_or(t.span), message).hint(hint).fail()
}

/// Fails for a knot that is to be changed no times.
pub(super) fn at_least_once(done: &str, times: Spanned<usize>) -> Result<()> {
    if 0 < times.value {
        return Ok(());
    }
    let message = format!("a knot is {done} once or more often, found 0 times");
    Diagnostic::error(Code::BadKnots, times.span, message).fail()
}
