//! Operations that make curves.

mod approximate;
mod arc;
mod arc_tangent;
mod arc_through;
mod beta_spline;
mod bezier;
mod bspline;
mod circle;
mod clamped;
mod conic;
mod conic_kind;
mod coons_bspline;
mod coons_cubic;
mod cubic_spline;
mod ellipse;
pub(super) mod fit;
mod helix;
mod hermite;
mod interpolate;
mod lagrange;
mod line;
mod line_tangent;
mod nurbs;
pub(super) mod parametric;
mod polyline;
mod polynomial;
mod tangent_ends;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{GeomError, KnotError, KnotVector},
    value::{At, Op},
};

pub(super) static OPS: &[&Op] = &[
    &line::OP,
    &polyline::OP,
    &bezier::OP,
    &clamped::OP,
    &bspline::OP,
    &nurbs::OP,
    &interpolate::OP,
    &cubic_spline::OP,
    &lagrange::OP,
    &approximate::OP,
    &hermite::OP,
    &coons_cubic::OP,
    &coons_bspline::OP,
    &beta_spline::OP,
    &polynomial::OP,
    &arc::OP,
    &arc_through::OP,
    &line_tangent::OP,
    &arc_tangent::OP,
    &circle::OP,
    &ellipse::OP,
    &conic::OP,
    &parametric::OP,
    &conic_kind::OP,
    &helix::OP,
];

/// Knots of degree `degree` for so many points: those that are given, else uniform and clamped
/// on 0..1.
pub(super) fn knots_for(
    knots: Option<Spanned<Vec<f64>>>,
    degree: Spanned<usize>,
    n_points: Spanned<usize>,
) -> Result<KnotVector> {
    check_degree(degree, n_points)?;
    let Some(knots) = knots else {
        let knots = KnotVector::uniform_clamped(degree.value, n_points.value, 1.0);
        return knots.at(degree.span_or(n_points.span));
    };
    let (found, needed) = (knots.value.len(), n_points.value + degree.value + 1);
    if found != needed {
        let (points, degree) = (n_points.value, degree.value);
        let error = GeomError::Knots(KnotError::KnotCount { points, degree, needed, got: found });
        return Err(error).at(knots.span);
    }
    KnotVector::new(degree.value, knots.value).at(knots.span)
}

/// Fails unless the degree is at least one and lower than the number of points.
pub(super) fn check_degree(degree: Spanned<usize>, n_points: Spanned<usize>) -> Result<()> {
    if degree.value == 0 {
        return Diagnostic::error(
            Code::BadDegree,
            degree.span,
            "the degree must be 1 or more, found 0",
        )
        .fail();
    }
    if n_points.value <= degree.value {
        let message = format!(
            "{} too few for degree {}, which needs {} or more",
            match n_points.value {
                1 => "1 point is".to_owned(),
                n => format!("{n} points are"),
            },
            degree.value,
            degree.value + 1
        );
        return Diagnostic::error(Code::TooFewPoints, n_points.span, message)
            .hint(match n_points.value {
                0 | 1 => "give more points".to_owned(),
                n => format!("give more points, or `degree = {}`", n - 1),
            })
            .fail();
    }
    Ok(())
}

/// Fails unless there are as many points as a uniform cubic needs.
pub(super) fn check_cubic(n_points: Spanned<usize>, is_closed: bool) -> Result<()> {
    if is_closed {
        return check_closed(n_points);
    }
    if 4 <= n_points.value {
        return Ok(());
    }
    let message = format!("a cubic needs 4 points or more, found {}", n_points.value);
    Diagnostic::error(Code::TooFewPoints, n_points.span, message)
        .hint(match n_points.value {
            3 => "give one more; with `closed = true` 3 are enough".to_owned(),
            n => format!("give {} more", 4 - n),
        })
        .fail()
}

/// Fails unless there are as many points as a closed curve needs.
fn check_closed(n_points: Spanned<usize>) -> Result<()> {
    if 3 <= n_points.value {
        return Ok(());
    }
    let message = format!("a closed curve needs 3 points or more, found {}", n_points.value);
    Diagnostic::error(Code::TooFewPoints, n_points.span, message)
        .hint(format!("give {} more", 3 - n_points.value))
        .fail()
}
