//! Homogeneous points `(w·x, w·y, w·z, w)`, and quotients of their derivatives.

use glam::{DAffine3, DVec3, DVec4};
use smallvec::SmallVec;

use super::{GeomError, Grid, InputError, WeightError, tolerance::WEIGHT_RELATIVE};

/// The point in space.
pub(crate) fn project(point: DVec4) -> DVec3 {
    // One division: the quotient of each coordinate may round twice, but not where w is 1.
    point.truncate() * (1.0 / point.w)
}

/// The place of a control point; one of weight zero has none, and gives its direction instead.
pub(crate) fn place(point: DVec4) -> DVec3 {
    if point.w.abs() < f64::MIN_POSITIVE { point.truncate() } else { project(point) }
}

/// The same point where the origin lies elsewhere.
pub(crate) fn about(origin: DVec3, point: DVec4) -> DVec4 {
    (point.truncate() - point.w * origin).extend(point.w)
}

/// How fast the place of a control point moves.
pub(crate) fn place_speed(point: DVec4, speed: DVec4) -> DVec3 {
    let weight = if point.w.abs() < f64::MIN_POSITIVE { 1.0 } else { point.w };
    (speed.truncate() - speed.w * place(point)) / weight
}

/// Homogeneous points of weight one.
///
/// # Errors
/// [`InputError::NotFinite`].
pub(crate) fn unweighted(points: &[DVec3]) -> Result<Vec<DVec4>, GeomError> {
    let points: Vec<DVec4> = points.iter().map(|point| point.extend(1.0)).collect();
    check_finite(&points)?;
    Ok(points)
}

/// Homogeneous points; a weight of zero takes its point away.
///
/// # Errors
/// [`WeightError::WeightCount`], [`InputError::NotFinite`], [`WeightError::BadWeight`] below zero.
pub(crate) fn weighted(points: &[DVec3], weights: &[f64]) -> Result<Vec<DVec4>, GeomError> {
    if points.len() != weights.len() {
        return Err(
            WeightError::WeightCount { points: points.len(), weights: weights.len() }.into()
        );
    }
    if let Some(index) = weights.iter().position(|weight| !weight.is_finite()) {
        return Err(InputError::NotFinite { what: "weight", index }.into());
    }
    if let Some(index) = weights.iter().position(|&weight| weight < 0.0) {
        return Err(WeightError::BadWeight { index, weight: weights[index] }.into());
    }
    let points: Vec<DVec4> = points.iter().zip(weights).map(|(&p, &w)| (p * w).extend(w)).collect();
    check_finite(&points)?;
    Ok(points)
}

/// # Errors
/// [`InputError::NotFinite`].
pub(crate) fn check_finite(points: &[DVec4]) -> Result<(), GeomError> {
    match points.iter().position(|point| !point.is_finite()) {
        Some(index) => {
            Err(GeomError::Input(InputError::NotFinite { what: "control point", index }))
        }
        None => Ok(()),
    }
}

/// Factors along u and along v whose products the weights are, up to rounding.
pub(crate) fn weight_factors(net: &Grid<DVec4>) -> Option<[Vec<f64>; 2]> {
    let first = net.get(0, 0).w;
    let along_u: Vec<f64> = (0..net.n_rows()).map(|i| net.get(i, 0).w / first).collect();
    let along_v: Vec<f64> = net.row(0).iter().map(|point| point.w).collect();
    let are_products = along_u.iter().enumerate().all(|(i, a)| {
        let row = net.row(i).iter().zip(&along_v);
        row.into_iter().all(|(point, b)| (point.w - a * b).abs() <= WEIGHT_RELATIVE * point.w)
    });
    are_products.then_some([along_u, along_v])
}

/// Whether the weights differ by more than rounding.
pub(crate) fn have_different_weights(points: &[DVec4]) -> bool {
    let is_first = |point: &DVec4| point.w.to_bits() == points[0].w.to_bits();
    if points.iter().all(is_first) {
        return false;
    }
    let low = points.iter().map(|point| point.w).fold(f64::INFINITY, f64::min);
    let high = points.iter().map(|point| point.w).fold(f64::NEG_INFINITY, f64::max);
    WEIGHT_RELATIVE * high < high - low
}

/// The image of a homogeneous point under an affine map.
pub(crate) fn transformed(point: DVec4, map: &DAffine3) -> DVec4 {
    (map.matrix3 * point.truncate() + map.translation * point.w).extend(point.w)
}

/// Derivatives in space from homogeneous derivatives by order, both from order 0.
///
/// Division of truncated Taylor series, which is Leibniz' rule without its binomials.
/// Piegl & Tiller, *The NURBS Book*, A4.2.
pub(crate) fn quotient(derivatives: &[DVec4]) -> Vec<DVec3> {
    let mut series = series(derivatives);
    let mut factorial = 1.0;
    for (k, term) in series.iter_mut().enumerate().skip(1) {
        factorial *= k as f64;
        *term *= factorial;
    }
    series
}

/// Coefficients of the power series in space from homogeneous derivatives by order.
pub(crate) fn series(derivatives: &[DVec4]) -> Vec<DVec3> {
    let mut series: Vec<DVec3> = Vec::with_capacity(derivatives.len());
    let scaled = over_factorials(derivatives);
    for (k, numerator) in scaled.iter().enumerate() {
        let mut sum = numerator.truncate();
        for i in 1..=k {
            sum -= scaled[i].w * series[k - i];
        }
        series.push(sum / scaled[0].w);
    }
    series
}

/// Derivatives of a surface up to order two along u and v: more of them need memory of their own.
const SECOND_ORDER: usize = 9;

/// Derivatives in space from homogeneous derivatives, `[k][l]` by u and by v.
///
/// Piegl & Tiller, *The NURBS Book*, A4.4, as the division of Taylor series in two variables.
pub(crate) fn quotient_grid(derivatives: &Grid<DVec4>) -> Grid<DVec3> {
    let (n_rows, n_columns) = (derivatives.n_rows(), derivatives.n_columns());
    let factorials: SmallVec<[f64; 4]> = factorials().take(n_rows.max(n_columns)).collect();
    let mut scaled: SmallVec<[DVec4; SECOND_ORDER]> = derivatives.iter().copied().collect();
    for (row, of_row) in scaled.chunks_exact_mut(n_columns).zip(&factorials) {
        row.iter_mut().zip(&factorials).for_each(|(term, factorial)| *term /= of_row * factorial);
    }
    let mut series: SmallVec<[DVec3; SECOND_ORDER]> = SmallVec::with_capacity(n_rows * n_columns);
    for k in 0..n_rows {
        for l in 0..n_columns {
            let mut sum = scaled[k * n_columns + l].truncate();
            for i in 0..=k {
                for j in usize::from(i == 0)..=l {
                    sum -= scaled[i * n_columns + j].w * series[(k - i) * n_columns + l - j];
                }
            }
            series.push(sum / scaled[0].w);
        }
    }
    Grid::from_fn(n_rows, n_columns, |k, l| {
        series[k * n_columns + l] * (factorials[k] * factorials[l])
    })
}

/// Derivatives in space of homogeneous ones, both as S, Su, Sv, Suu, Suv, Svv.
///
/// Piegl & Tiller, *The NURBS Book*, (4.20).
#[inline(always)]
pub(crate) fn second_order([value, u, v, uu, uv, vv]: [DVec4; 6]) -> [DVec3; 6] {
    let per_weight = 1.0 / value.w;
    let s = value.truncate() * per_weight;
    let su = (u.truncate() - s * u.w) * per_weight;
    let sv = (v.truncate() - s * v.w) * per_weight;
    let suu = (uu.truncate() - su * (2.0 * u.w) - s * uu.w) * per_weight;
    let suv = (uv.truncate() - su * v.w - sv * u.w - s * uv.w) * per_weight;
    let svv = (vv.truncate() - sv * (2.0 * v.w) - s * vv.w) * per_weight;
    [s, su, sv, suu, suv, svv]
}

fn over_factorials(derivatives: &[DVec4]) -> SmallVec<[DVec4; 4]> {
    derivatives.iter().zip(factorials()).map(|(&d, f)| d / f).collect()
}

/// 0!, 1!, and so on.
fn factorials() -> impl Iterator<Item = f64> {
    let next = |factorial: &mut f64, k: usize| {
        *factorial *= k.max(1) as f64;
        Some(*factorial)
    };
    (0..).scan(1.0, next)
}
