//! Several curves on one degree and one knot vector.

use super::NurbsCurve;
use crate::kernel::{GeomError, Interval, KnotVector, tolerance::KNOT_RELATIVE};

/// A knot with its multiplicity.
type Knot = (f64, usize);

/// The same curves on the highest degree among them, the domain of the first, and one knot vector
/// with every knot of any of them as often as it stands in one.
///
/// Knots of different curves closer than [`KNOT_RELATIVE`] of the domain are taken for one. Curves
/// that agree already come back as they are; others are clamped. Piegl & Tiller, *The NURBS
/// Book*, §10.3.
///
/// # Errors
/// [`GeomError::KnotMultiplicity`] where merged knots stand too often.
pub fn make_compatible(curves: &[NurbsCurve]) -> Result<Vec<NurbsCurve>, GeomError> {
    let Some(first) = curves.first() else { return Ok(Vec::new()) };
    if curves.iter().all(|curve| curve.knots == first.knots) {
        return Ok(curves.to_vec());
    }

    // Bring all to one degree and one domain.
    let degree = curves.iter().map(NurbsCurve::degree).max().unwrap_or(0);
    let domain = first.domain();
    let raised =
        |curve: &NurbsCurve| Ok(curve.clamped().elevate_degree(degree)?.reparametrized(domain));
    let curves: Vec<NurbsCurve> = curves.iter().map(raised).collect::<Result<_, GeomError>>()?;

    // Insert into each what only others have.
    let common = common_knots(&curves, domain);
    let refined = |curve: &NurbsCurve| {
        let knots = curve.knots.map(|t| nearest(&common, t));
        let missing = missing_knots(&common, &knots);
        curve.on_knots(knots).insert_knots(&missing)
    };
    curves.iter().map(refined).collect()
}

/// Every knot of any of the curves as often as it stands in one of them.
fn common_knots(curves: &[NurbsCurve], domain: Interval) -> Vec<Knot> {
    let mut all: Vec<Knot> = curves.iter().flat_map(|curve| curve.knots.distinct()).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let same = KNOT_RELATIVE * domain.length();
    let mut common: Vec<Knot> = Vec::new();
    for (t, times) in all {
        match common.last_mut() {
            Some((last, most)) if t - *last <= same => *most = times.max(*most),
            _ => common.push((t, times)),
        }
    }
    // Rounding must not move the domain.
    if let Some((last, _)) = common.last_mut() {
        *last = domain.end();
    }
    common
}

fn nearest(common: &[Knot], t: f64) -> f64 {
    let next = common.partition_point(|&(knot, _)| knot < t);
    let around = &common[next.saturating_sub(1)..common.len().min(next + 1)];
    let distance = |a: &&Knot| (a.0 - t).abs();
    let nearest = around.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    nearest.map_or(t, |&(knot, _)| knot)
}

fn missing_knots(common: &[Knot], knots: &KnotVector) -> Vec<f64> {
    let missing = |&(t, times): &Knot| vec![t; times.saturating_sub(knots.times(t))];
    common.iter().flat_map(missing).collect()
}
