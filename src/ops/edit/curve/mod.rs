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

use crate::diag::{Code, Diagnostic, Result, Spanned};

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

/// Fails for a knot that is to be changed no times.
pub(super) fn at_least_once(done: &str, times: Spanned<usize>) -> Result<()> {
    if 0 < times.value {
        return Ok(());
    }
    let message = format!("a knot is {done} once or more often, found 0 times");
    Diagnostic::error(Code::BadKnots, times.span, message).fail()
}
