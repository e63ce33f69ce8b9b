//! Edits of surfaces: each makes a new surface, or curves and points of one.

pub(super) mod border;
pub(super) mod compatible;
pub(super) mod continue_bezier;
pub(super) mod control_net;
pub(super) mod corners;
pub(super) mod de_casteljau;
pub(super) mod decompose;
pub(super) mod edge;
pub(super) mod edges;
pub(super) mod elevate;
pub(super) mod flip;
pub(super) mod insert_knot;
pub(super) mod join;
pub(super) mod offset;
pub(super) mod orient;
pub(super) mod power_coefficients;
pub(super) mod refine;
pub(super) mod reparametrize;
pub(super) mod reverse_u;
pub(super) mod reverse_v;
pub(super) mod split;
pub(super) mod swap_uv;
pub(super) mod trim;
pub(super) mod wireframe;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{CountError, Direction, Edge, GeomError, NurbsSurface},
    value::{At, Choice, Ctx},
};

impl Choice for Edge {
    const WORDS: &'static [&'static str] = &["u0", "u1", "v0", "v1"];
    const MEANINGS: &'static [Self] = &Self::ALL;
}

/// What was given for u, for v, or for both, with its direction.
fn given<T>(u: Option<Spanned<T>>, v: Option<Spanned<T>>) -> Vec<(Direction, Spanned<T>)> {
    let u = u.map(|value| (Direction::U, value));
    let v = v.map(|value| (Direction::V, value));
    u.into_iter().chain(v).collect()
}

/// What was given for u, for v, or for both; it fails where neither was.
fn some_of<T>(
    u: Option<Spanned<T>>,
    v: Option<Spanned<T>>,
    ctx: &Ctx<'_>,
    what: &str,
) -> Result<Vec<(Direction, Spanned<T>)>> {
    let found = given(u, v);
    if !found.is_empty() {
        return Ok(found);
    }
    let message = "neither `u` nor `v` is given";
    Diagnostic::error(Code::BadCall, ctx.span, message)
        .hint(format!("write `u = {what}`, `v = {what}`, or both"))
        .fail()
}

/// The one of u and v that was given.
fn one_of<T>(
    u: Option<Spanned<T>>,
    v: Option<Spanned<T>>,
    ctx: &Ctx<'_>,
    remedy: &str,
) -> Result<(Direction, Spanned<T>)> {
    let mut found = given(u, v);
    match (found.pop(), found.pop()) {
        (Some(only), None) => Ok(only),
        (None, _) => {
            let message = "neither `u` nor `v` is given";
            Diagnostic::error(Code::BadCall, ctx.span, message)
                .hint("give one of them, by its name: `u = ...` or `v = ...`")
                .fail()
        }
        (Some((_, second)), Some((_, first))) => {
            let message = "one of `u` and `v` is wanted, found both";
            Diagnostic::error(Code::BadCall, second.span, message)
                .also(first.span, "the other one")
                .hint(remedy)
                .fail()
        }
    }
}

/// Fails where a surface would have more control points than are allowed.
fn check_size(n_u: usize, n_v: usize, ctx: &Ctx<'_>) -> Result<()> {
    let (got, most) = (n_u.saturating_mul(n_v), ctx.limits.control_points);
    if got <= most {
        Ok(())
    } else {
        Err(GeomError::Count(CountError::TooManyPoints { got, most })).at(ctx.span)
    }
}

/// Fails where more knots along a direction would make too many control points.
fn check_more(
    surface: &NurbsSurface,
    along: Direction,
    n_more: usize,
    ctx: &Ctx<'_>,
) -> Result<()> {
    let n_along = surface.knots(along).n_points().saturating_add(n_more);
    check_size(n_along, surface.knots(along.other()).n_points(), ctx)
}
