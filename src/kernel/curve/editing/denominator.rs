//! Several curves over one denominator, as fractions are before they are added.

use glam::{DVec3, DVec4};

use crate::{
    GeomError,
    curve::{NurbsCurve, make_compatible},
    homogeneous,
    tolerance::WEIGHT_RELATIVE,
};

/// The same curves on one degree, one knot vector, the domain of the first, and one set of
/// weights; so that sums of their homogeneous points stand for sums of their points.
///
/// Homogeneous points of curves with different weights do not add: A/a + B/b is not (A + B)/(a + b).
/// Each curve is multiplied, exactly, by every denominator among them that is not its own;
/// denominators that are multiples of one another count as one. The degree is the sum of those
/// of the different denominators, and more if a curve without weights is of a higher degree.
/// Without weights that differ this is [`make_compatible`].
///
/// # Errors
/// Those of [`make_compatible`]; `DegreeError::DegreeTooHigh`, `InputError::NotFinite`.
pub(crate) fn on_one_denominator(curves: &[NurbsCurve]) -> Result<Vec<NurbsCurve>, GeomError> {
    let Some(first) = curves.first() else { return Ok(Vec::new()) };
    let domain = first.domain();
    let curves: Vec<NurbsCurve> =
        curves.iter().map(|curve| curve.clamped().reparametrized(domain)).collect();

    // One curve for each different denominator, and which of them is whose.
    let mut different: Vec<&NurbsCurve> = Vec::new();
    let mut own: Vec<Option<usize>> = Vec::with_capacity(curves.len());
    for curve in &curves {
        own.push(if curve.is_rational {
            let known = position(&different, |other| have_one_denominator(curve, other))?;
            Some(known.unwrap_or_else(|| {
                different.push(curve);
                different.len() - 1
            }))
        } else {
            None
        });
    }
    let factors: Vec<NurbsCurve> =
        different.into_iter().map(denominator).collect::<Result<_, _>>()?;

    let mut multiplied = Vec::with_capacity(curves.len());
    for (curve, own) in curves.iter().zip(own) {
        let mut product = curve.clone();
        for (idx, factor) in factors.iter().enumerate() {
            if own != Some(idx) {
                product = product.reweighted(factor)?;
            }
        }
        multiplied.push(product);
    }
    let mut common = make_compatible(&multiplied)?;

    // What is left is a constant between them, and rounding.
    let weights = common.first().map_or(Vec::new(), NurbsCurve::weights);
    for curve in &mut common {
        let scale = weights[0] / curve.control_points[0].w;
        let point = |(point, &w): (&DVec4, &f64)| (point.truncate() * scale).extend(w);
        let points: Vec<DVec4> = curve.control_points.iter().zip(&weights).map(point).collect();
        homogeneous::check_finite(&points)?;
        *curve = NurbsCurve::new_unchecked(curve.knots.clone(), points);
    }
    Ok(common)
}

/// The weights of a clamped curve over the first of them, as a scalar spline.
fn denominator(curve: &NurbsCurve) -> Result<NurbsCurve, GeomError> {
    let first = curve.control_points[0].w;
    let value = |point: &DVec4| DVec3::new(point.w / first, 0.0, 0.0);
    let values: Vec<DVec3> = curve.control_points.iter().map(value).collect();
    NurbsCurve::polynomial(curve.knots.clone(), &values)
}

fn have_one_denominator(a: &NurbsCurve, b: &NurbsCurve) -> Result<bool, GeomError> {
    let both = make_compatible(&[denominator(a)?, denominator(b)?])?;
    let values = both.iter().map(NurbsCurve::points).collect::<Vec<_>>();
    let largest = values.iter().flatten().map(|value| value.x.abs()).fold(0.0, f64::max);
    let mut pairs = values[0].iter().zip(&values[1]);
    Ok(pairs.all(|(a, b)| (a.x - b.x).abs() <= WEIGHT_RELATIVE * largest))
}

/// The first place where `is_it` holds.
fn position(
    curves: &[&NurbsCurve],
    is_it: impl Fn(&NurbsCurve) -> Result<bool, GeomError>,
) -> Result<Option<usize>, GeomError> {
    for (idx, curve) in curves.iter().enumerate() {
        if is_it(curve)? {
            return Ok(Some(idx));
        }
    }
    Ok(None)
}
