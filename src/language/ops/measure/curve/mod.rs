//! Questions about curves.

pub(super) mod at;
pub(super) mod basis_table;
pub(super) mod binormal;
pub(super) mod binormal_line;
pub(super) mod center_of_curvature;
pub(super) mod classify;
pub(super) mod closest;
pub(super) mod continuity;
pub(super) mod corners;
pub(super) mod curvature;
pub(super) mod curvature_comb;
pub(super) mod curvature_table;
pub(super) mod cusps;
pub(super) mod derivative;
pub(super) mod divide;
pub(super) mod extrema;
pub(super) mod frame;
pub(super) mod inflections;
pub(super) mod intersect;
pub(super) mod is_closed;
pub(super) mod is_planar;
pub(super) mod is_straight;
pub(super) mod knot_class;
pub(super) mod length;
pub(super) mod normal;
pub(super) mod normal_line;
pub(super) mod normal_plane;
pub(super) mod osculating_circle;
pub(super) mod osculating_plane;
pub(super) mod parameter_at_length;
pub(super) mod radius_of_curvature;
pub(super) mod rectifying_plane;
pub(super) mod sample;
pub(super) mod section;
pub(super) mod self_intersections;
pub(super) mod signed_curvature;
pub(super) mod tangent;
pub(super) mod tangent_line;
pub(super) mod torsion;
pub(super) mod varying;
pub(super) mod vertices;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Curve, LocalGeometry, Side},
    ops::list::check_length,
    value::{At, Ctx},
};

/// A parameter of a curve, inside its domain.
fn inside(curve: &Curve, t: Spanned<f64>) -> Result<f64> {
    curve.domain().clamp_inside(t.value).at(t.span)
}

/// The shape of a curve at a parameter.
fn local(curve: &Curve, t: Spanned<f64>, side: Side) -> Result<LocalGeometry> {
    curve.local_at(inside(curve, t)?, side).at(t.span)
}

/// Elements of a list that take the room of one segment.
const SEGMENT_SIZE: usize = 16;

/// Evenly spaced parameters of a curve, both ends among them.
pub(super) fn sample_parameters(
    curve: &Curve,
    samples: Spanned<usize>,
    ctx: &Ctx<'_>,
) -> Result<Vec<f64>> {
    if samples.value < 2 {
        let message = format!("a curve is sampled at 2 places or more, found {}", samples.value);
        let span = samples.span_or(ctx.span);
        return Diagnostic::error(Code::TooFewPoints, span, message).fail();
    }
    check_length(samples.value as f64, ctx)?;
    Ok(curve.domain().steps(samples.value - 1))
}

/// Fails where so many samples, times a number, would be more segments than a list has room for.
pub(super) fn check_segments(samples: Spanned<usize>, times: usize, ctx: &Ctx<'_>) -> Result<()> {
    let (n, most) = (samples.value.saturating_mul(times), ctx.limits.list_length / SEGMENT_SIZE);
    if n <= most {
        return Ok(());
    }
    let message = format!("{n} segments at once; at most {most} are possible");
    Diagnostic::error(Code::TooLarge, samples.span_or(ctx.span), message).fail()
}
