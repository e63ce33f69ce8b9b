//! Several curves run through one after another, as one.

use glam::DVec3;

use crate::{
    CountError, GeomError, Interval, JointError, KnotError,
    curve::NurbsCurve,
    joint::{Joined, joint_accuracy, vanishing_span},
    refine::ControlLines,
    tolerance::{JOINT_REMOVAL_SHARE, PARAMETER_RELATIVE},
};

/// The curves one after another as one curve on the domain of the first and those of the others
/// behind it, each as long as it was.
///
/// All are elevated to the highest degree among them, and the weights of each are scaled so that
/// they begin where those before end. A joint keeps only the knots that its continuity needs: it
/// loses those that can go without a displacement beyond rounding, or beyond the gap that it had.
/// Far from the origin, where 1e-11 of the coordinates is much, that is a share of the tolerance, or rounding.
/// Ends that differ within the tolerance meet halfway.
///
/// ```
/// use virote_kernel::{NurbsCurve, glam::DVec3, join};
///
/// let [first, second] = [(0.0, 1.0), (1.0, 3.0)].map(|(a, b)| (DVec3::X * a, DVec3::X * b));
/// let parts = [NurbsCurve::line(first.0, first.1)?, NurbsCurve::line(second.0, second.1)?];
/// let whole = join(&parts, 1e-6)?;
/// assert!((whole.length(whole.domain()) - 3.0).abs() < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
///
/// # Errors
/// [`CountError::TooFewCurves`] for none; [`JointError::Gap`] wider than the tolerance;
/// [`KnotError::VanishingPiece`] for a domain too short beside the others;
/// `InputError::NotFinite` where the weights leave the numbers.
pub fn join(curves: &[NurbsCurve], tolerance: f64) -> Result<NurbsCurve, GeomError> {
    join_moving(curves, tolerance, JOINT_REMOVAL_SHARE * tolerance)
}

/// As [`join`], where taking out a knot of a joint moves nothing further than `most`, or rounding.
///
/// # Errors
/// Those of [`join`].
pub(in crate::curve) fn join_moving(
    curves: &[NurbsCurve],
    tolerance: f64,
    most: f64,
) -> Result<NurbsCurve, GeomError> {
    let [first, others @ ..] = curves else {
        return Err(CountError::TooFewCurves { got: 0, needed: 1 }.into());
    };
    if others.is_empty() {
        return Ok(first.clone());
    }
    check_gaps(curves, tolerance)?;
    check_domains(curves)?;

    let degree = curves.iter().map(NurbsCurve::degree).max().unwrap_or(0).max(1);
    let raised = |curve: &NurbsCurve| curve.clamped().elevate_degree(degree);
    let mut joined = Joined::new(raised(first)?.lines());
    for (before, next) in curves.iter().zip(others) {
        let gap = before.end().distance(next.start());
        let next = raised(next)?;
        let scale = joined.ends()[0].w / next.control_points[0].w;
        joined.append(&next.lines(), scale, joint_accuracy(next.magnitude(), most) + gap);
    }
    let ControlLines { knots, lines } = joined.finish()?;
    NurbsCurve::new(knots, lines.concat())
}

/// Pieces of one degree that begin where those before them end, as one curve that is displaced by no more than a
/// distance at each joint.
///
/// # Errors
/// Those of [`join`].
pub(crate) fn join_pieces(pieces: &[NurbsCurve], distance: f64) -> Result<NurbsCurve, GeomError> {
    let [first, others @ ..] = pieces else {
        return Err(CountError::TooFewCurves { got: 0, needed: 1 }.into());
    };
    let degree = pieces.iter().map(NurbsCurve::degree).max().unwrap_or(0);
    let raised = |curve: &NurbsCurve| curve.elevate_degree(degree);
    let mut joined = Joined::new(raised(first)?.lines());
    for next in others {
        joined.append(&raised(next)?.lines(), 1.0, distance);
    }
    let ControlLines { knots, lines } = joined.finish()?;
    NurbsCurve::new(knots, lines.concat())
}

/// Curves that were found to follow one another as one, as [`join`], but for spans of parameters that rounding has
/// left.
///
/// # Errors
/// Those of [`join`].
pub(crate) fn join_chain(curves: &[NurbsCurve], tolerance: f64) -> Result<NurbsCurve, GeomError> {
    match curves {
        [single] => Ok(single.clone()),
        _ => join(&without_vanishing_spans(curves)?, tolerance),
    }
}

/// The curves without spans that [`join`] would refuse: what is before and behind of each is a curve of its own.
///
/// # Errors
/// Those of [`NurbsCurve::trimmed`].
fn without_vanishing_spans(curves: &[NurbsCurve]) -> Result<Vec<NurbsCurve>, GeomError> {
    let total: f64 = curves.iter().map(|curve| curve.domain().length()).sum();
    let mut parts = Vec::with_capacity(curves.len());
    for curve in curves {
        if vanishing_span(&curve.knots, total).is_none() {
            parts.push(curve.clone());
            continue;
        }
        let breaks = curve.knots.breaks();
        let least = 2.0 * PARAMETER_RELATIVE * total;
        for run in breaks.chunk_by(|before, behind| least < behind - before) {
            if let [start, .., end] = *run {
                parts.push(curve.trimmed(Interval::new(start, end)?)?);
            }
        }
    }
    Ok(parts)
}

/// # Errors
/// [`JointError::Gap`].
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
            return Err(JointError::Gap { index, gap, tolerance, reversed }.into());
        }
    }
    Ok(())
}

/// # Errors
/// [`KnotError::VanishingPiece`].
fn check_domains(curves: &[NurbsCurve]) -> Result<(), GeomError> {
    let total: f64 = curves.iter().map(|curve| curve.domain().length()).sum();
    for (index, curve) in curves.iter().enumerate() {
        if let Some(length) = vanishing_span(&curve.knots, total) {
            return Err(KnotError::VanishingPiece { index, length, total }.into());
        }
    }
    Ok(())
}
