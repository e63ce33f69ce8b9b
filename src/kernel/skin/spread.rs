//! Sections that run at constant speed, so that equal parameters are equal parts of the length.

use crate::{
    GeomError, Interval, NurbsCurve,
    gordon::{NetworkParameterMap, RefitRequest, refitted},
    tolerance::{PLACE_RELATIVE, UNCHANGED_SHARE},
};

/// Parts of a span whose lengths are met.
const N_PARTS: usize = 32;

/// The degree of what becomes a spline.
const DEGREE: usize = 3;

/// The curves with the fraction of their length as parameter, on 0..1: as they are where they run
/// at constant speed, else as cubic splines within the tolerance, on common knots.
///
/// The ends of 32 parts of each span stand at their length exactly; between, the speed is even to the fourth
/// order of their width.
///
/// # Errors
/// `FitError::ToleranceNotKept`.
pub fn at_constant_speed(
    curves: &[NurbsCurve],
    tolerance: f64,
) -> Result<Vec<NurbsCurve>, GeomError> {
    let mut spread = Vec::with_capacity(curves.len());
    let mut waiting: Vec<(usize, NurbsCurve)> = Vec::new();
    let mut held: Vec<(f64, usize)> = Vec::new();
    for (k, curve) in curves.iter().enumerate() {
        spread.push(curve.reparametrized(Interval::UNIT));
        if curve.is_point() {
            continue;
        }
        let (fractions, parameters) = lengths(curve);
        let domain = curve.domain();
        let is_even = |(&f, &t): (&f64, &f64)| (domain.fraction_of(t) - f).abs() <= PLACE_RELATIVE;
        if fractions.iter().zip(&parameters).all(is_even) {
            continue;
        }
        let map = NetworkParameterMap::new(&fractions, &parameters, false)?;
        let near = UNCHANGED_SHARE * tolerance;
        let (run, rough) = map.applied(&curve.without_needless_knots(), near)?;
        held.extend(rough.into_iter().map(|(t, order)| (t, DEGREE - order)));
        waiting.push((k, run));
    }
    if waiting.is_empty() {
        return Ok(spread);
    }
    let (indices, runs): (Vec<usize>, Vec<NurbsCurve>) = waiting.into_iter().unzip();
    let wanted = RefitRequest { degree: DEGREE, at: Vec::new(), held, is_ring: false };
    let (fits, _) = refitted(&runs, &wanted, tolerance)?;
    for (k, fit) in indices.into_iter().zip(fits) {
        spread[k] = fit;
    }
    Ok(spread)
}

/// Fractions of the length, and the parameters where they are reached; both increase.
fn lengths(curve: &NurbsCurve) -> (Vec<f64>, Vec<f64>) {
    let mut parameters = vec![curve.domain().start()];
    let mut sums = vec![0.0];
    for span in curve.knots().spans() {
        for ends in curve.knots().span_interval(span).steps(N_PARTS).windows(2) {
            let Ok(part) = Interval::new(ends[0], ends[1]) else { continue };
            let length = curve.length(part);
            let before = sums[sums.len() - 1];
            // A part that stands still is passed over.
            if 0.0 < length {
                sums.push(before + length);
                parameters.push(ends[1]);
            }
        }
    }
    let last = sums.len() - 1;
    let total = sums[last];
    sums.iter_mut().for_each(|sum| *sum /= total);
    (sums[last], parameters[last]) = (1.0, curve.domain().end());
    (sums, parameters)
}
