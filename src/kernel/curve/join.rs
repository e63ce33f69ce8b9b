//! Several curves run through one after another, as one.

use glam::DVec3;

use super::NurbsCurve;
use crate::kernel::{
    GeomError, KnotVector,
    removal::removal,
    tolerance::{JOINT_RELATIVE, KNOT_RELATIVE},
};

/// The curves one after another as one curve on the domain of the first and those of the others
/// behind it, each as long as it was.
///
/// All are elevated to the highest degree among them, and the weights of each are scaled so that
/// they begin where those before end. A joint keeps only the knots that its continuity needs: it
/// loses those that can go without a displacement beyond rounding, or beyond the gap that it had.
/// Ends that differ within the tolerance meet halfway.
///
/// # Errors
/// [`GeomError::TooFewCurves`] below two; [`GeomError::Gap`] wider than the tolerance;
/// [`GeomError::VanishingPiece`] for a domain too short beside the others;
/// [`GeomError::NotFinite`] where the weights leave the numbers.
pub fn join(curves: &[NurbsCurve], tolerance: f64) -> Result<NurbsCurve, GeomError> {
    let [first, others @ ..] = curves else {
        return Err(GeomError::TooFewCurves { got: 0, needed: 2 });
    };
    if others.is_empty() {
        return Err(GeomError::TooFewCurves { got: 1, needed: 2 });
    }
    check_gaps(curves, tolerance)?;
    check_domains(curves)?;

    let degree = curves.iter().map(NurbsCurve::degree).max().unwrap_or(0).max(1);
    let raised = |curve: &NurbsCurve| curve.clamped().elevate_degree(degree);
    let first = raised(first)?;
    let mut knots = first.knots.as_slice().to_vec();
    let mut points = first.control_points;
    for (before, next) in curves.iter().zip(others) {
        let gap = before.end().distance(next.start());
        let next = raised(next)?;
        let joint = knots[knots.len() - 1];
        let (end, start) = (points[points.len() - 1], next.control_points[0]);

        // Put the next one behind the others.
        let shift = joint - next.domain().start();
        let scale = end.w / start.w;
        knots.pop();
        knots.extend(
            next.knots.as_slice()[degree + 1..].iter().map(|knot| (knot + shift).max(joint)),
        );
        let n_before = points.len();
        points[n_before - 1] = (end + start * scale) * 0.5;
        points.extend(next.control_points[1..].iter().map(|&point| point * scale));

        // Take out what the joint does not need.
        let accuracy = JOINT_RELATIVE * next.magnitude() + gap;
        for times in (1..=degree).rev() {
            let index = n_before + times - 1;
            let removal = removal(degree, &knots, &points, index);
            if accuracy < removal.displacement {
                break;
            }
            points.splice(removal.range, removal.points);
            knots.remove(index);
        }
    }
    NurbsCurve::new(KnotVector::new(degree, knots)?, points)
}

/// # Errors
/// [`GeomError::Gap`].
fn check_gaps(curves: &[NurbsCurve], tolerance: f64) -> Result<(), GeomError> {
    for (index, pair) in curves.windows(2).enumerate() {
        let (end, start) = (pair[0].end(), pair[1].start());
        let gap = end.distance(start);
        let is_met = gap <= tolerance;
        if !is_met {
            let fits = |a: DVec3, b: DVec3| a.distance(b) <= tolerance;
            let reversed = if fits(end, pair[1].end()) {
                Some(index + 1)
            } else {
                fits(pair[0].start(), start).then_some(index)
            };
            return Err(GeomError::Gap { index, gap, tolerance, reversed });
        }
    }
    Ok(())
}

/// # Errors
/// [`GeomError::VanishingPiece`].
fn check_domains(curves: &[NurbsCurve]) -> Result<(), GeomError> {
    let total: f64 = curves.iter().map(|curve| curve.domain().length()).sum();
    for (index, curve) in curves.iter().enumerate() {
        let spans = curve.knots.spans().map(|span| curve.knots.span_interval(span).length());
        let length = spans.fold(f64::INFINITY, f64::min);
        // Twice, because the sum of the domains rounds.
        if length <= 2.0 * KNOT_RELATIVE * total {
            return Err(GeomError::VanishingPiece { index, length, total });
        }
    }
    Ok(())
}
