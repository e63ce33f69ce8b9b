//! Curves of high degree as cubics, several of them on one knot vector.

use glam::DVec4;

use crate::kernel::{
    Ends, GeomError, Interpolator, KnotVector, NurbsCurve, Side, tolerance::KNOT_RELATIVE,
};

/// Knots of a fit.
const MAX_KNOTS: usize = 2048;

/// Places of a span at which the distance is measured before it is bounded.
const N_PLACES: usize = 4;

/// How often the fit is made finer after its bound was too large.
const MAX_ROUNDS: usize = 4;

/// Cubic splines of the curves, all on one domain, on common knots with a knot at each of `at` and
/// three at each of `corners`; with a bound of the distance at equal parameters for each.
///
/// Ends and, one-sided, corners have the curves' points and derivatives, `at` their points; spans
/// are halved until the tolerance is kept.
///
/// # Errors
/// [`GeomError::ToleranceNotKept`] where 2048 knots do not suffice.
pub(in crate::kernel) fn refitted(
    curves: &[NurbsCurve],
    at: &[f64],
    corners: &[f64],
    tolerance: f64,
) -> Result<(Vec<NurbsCurve>, Vec<f64>), GeomError> {
    let domain = curves[0].domain();
    let same = KNOT_RELATIVE.sqrt() * domain.length();
    let ordered = |mut values: Vec<f64>| {
        values.sort_by(f64::total_cmp);
        values.dedup_by(|later, earlier| *later - *earlier <= same);
        values
    };
    let cuts = ordered([&[domain.start(), domain.end()], corners].concat());
    let is_cut = |t: f64| cuts.iter().any(|cut| (cut - t).abs() <= same);
    let inner: Vec<f64> = at.iter().copied().filter(|&t| !is_cut(t)).collect();
    let mut places = ordered([&cuts[..], &inner].concat());
    let mut allowed = 0.5 * tolerance;
    let mut round = 0;
    loop {
        let fits: Vec<NurbsCurve> =
            curves.iter().map(|curve| fit(curve, &places, &cuts)).collect::<Result<_, _>>()?;
        let mut more = Vec::new();
        let mut found = 0.0_f64;
        for ends in places.windows(2) {
            let miss = |(curve, fit): (&NurbsCurve, &NurbsCurve)| {
                (0..N_PLACES)
                    .map(|i| {
                        let f = (i as f64 + 0.5) / N_PLACES as f64;
                        let t = ends[0] + (ends[1] - ends[0]) * f;
                        curve.point_at(t).distance(fit.point_at(t))
                    })
                    .fold(0.0, f64::max)
            };
            let most = curves.iter().zip(&fits).map(miss).fold(0.0, f64::max);
            found = found.max(most);
            if allowed < most {
                more.push(0.5 * (ends[0] + ends[1]));
            }
        }
        if more.is_empty() {
            let bounds: Vec<f64> =
                curves.iter().zip(&fits).map(|(curve, fit)| curve.deviation_from(fit)).collect();
            let worst = bounds.iter().copied().fold(0.0, f64::max);
            if worst <= tolerance {
                return Ok((fits, bounds));
            }
            round += 1;
            allowed *= 0.25;
            if MAX_ROUNDS < round {
                return Err(GeomError::ToleranceNotKept { tolerance, found: worst });
            }
            continue;
        }
        if MAX_KNOTS < places.len() + more.len() {
            return Err(GeomError::ToleranceNotKept { tolerance, found });
        }
        places = ordered([&places[..], &more].concat());
    }
}

/// The cubic through the curve's points at the places, C2 but at the cuts.
fn fit(curve: &NurbsCurve, places: &[f64], cuts: &[f64]) -> Result<NurbsCurve, GeomError> {
    let mut knots: Vec<f64> = vec![places[0]];
    let mut points: Vec<DVec4> = Vec::new();
    for ends in cuts.windows(2) {
        let inside = |t: &&f64| ends[0] <= **t && **t <= ends[1];
        let own: Vec<f64> = places.iter().filter(inside).copied().collect();
        let values: Vec<DVec4> = own.iter().map(|&t| curve.point_at(t).extend(1.0)).collect();
        let slope = |t: f64, side: Side| curve.derivatives_beside(t, side, 1)[1].extend(0.0);
        let interpolator = Interpolator::new(&own, 3, Ends::Clamped)?;
        let slopes = [slope(ends[0], Side::Right), slope(ends[1], Side::Left)];
        let piece = interpolator.with_tangents(&values, slopes)?;
        knots.extend([ends[0]; 3]);
        knots.extend(&own[1..own.len() - 1]);
        points.pop();
        points.extend(piece);
    }
    knots.extend([places[places.len() - 1]; 4]);
    let points: Vec<glam::DVec3> = points.into_iter().map(DVec4::truncate).collect();
    NurbsCurve::polynomial(KnotVector::new(3, knots)?, &points)
}
