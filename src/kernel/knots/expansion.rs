//! Splines piece by piece: the Bézier form of a span, and expansions in powers about its ends.

use std::ops::{Add, Mul, Sub};

use super::{KnotVector, LocalParameter, SpanLookup};

/// The highest degree that is evaluated in powers: over half a span, rounding is at most 2ᵖ that
/// of the coefficients.
pub(crate) const POWER_DEGREE: usize = 5;

/// Turns the coefficients of a span, p + 1 of any kind, into those of its Bézier form: the
/// blossoms `f(a, … a, b, … b)` at the ends a and b of the span, by interpolation alone.
///
/// Ramshaw, *Blossoming: a connect-the-dots approach to splines*.
pub(crate) fn convert_to_bezier<T>(knots: &KnotVector, span: usize, points: &mut [T])
where
    T: Copy + Add<Output = T> + Mul<f64, Output = T>,
{
    let (p, u) = (knots.degree(), knots.as_slice());
    let (a, b) = (u[span], u[span + 1]);
    let between = |x: f64, left: f64, right: f64| (x - left) / (right - left);

    // From f(u_{i−p+1+k}, … u_{i+k}) to f(a, … a, u_{i+1}, … u_{i+k}), i the span and k the point.
    for n_at_a in 1..=p {
        for k in 0..=p - n_at_a {
            let alpha = between(a, u[span + k + n_at_a - p], u[span + k + 1]);
            points[k] = points[k] * (1.0 - alpha) + points[k + 1] * alpha;
        }
    }

    // On to f(a, … a, b, … b).
    for n_at_b in 1..p {
        for k in (n_at_b + 1..=p).rev() {
            let alpha = between(b, a, u[span + k - n_at_b + 1]);
            points[k] = points[k - 1] * (1.0 - alpha) + points[k] * alpha;
        }
    }
}

/// The expansions of a Bézier form in powers of s about its start and of s − 1 about its end:
/// `C(p, k)ΔᵏP₀` and `C(p, k)∇ᵏPₚ`, one after the other, added to others; the points are used up.
///
/// Farin, *Curves and Surfaces for CAGD*, §5.8.
pub(crate) fn add_in_powers<T>(points: &mut [T], expansions: &mut Vec<T>)
where
    T: Copy + Sub<Output = T> + Mul<f64, Output = T>,
{
    let (n, start) = (points.len(), expansions.len());
    expansions.extend_from_slice(points);
    expansions.extend_from_slice(points);
    let mut binomial = 1.0;
    for k in 0..n {
        expansions[start + k] = points[0] * binomial;
        expansions[start + n + k] = points[n - 1 - k] * binomial;
        for i in 1..n - k {
            points[i - 1] = points[i] - points[i - 1];
        }
        binomial *= (n - 1 - k) as f64 / (k + 1) as f64;
    }
}

/// The functions of a basis expanded in powers, for degrees up to [`POWER_DEGREE`].
#[derive(Debug)]
pub(crate) struct BasisExpansion {
    pub(crate) lookup: SpanLookup,
    /// The first function that acts on each half of a span.
    firsts: Vec<usize>,
    /// For each half of a span the coefficients of s⁰, s¹, …; each the p + 1 of the functions.
    coefficients: Vec<BasisValues>,
}

/// A value for each of the functions that act on a span; beyond p + 1 there are zeros.
pub(crate) type BasisValues = [f64; POWER_DEGREE + 1];

impl BasisExpansion {
    pub(crate) fn new(knots: &KnotVector) -> Self {
        let n = knots.degree() + 1;
        let (mut firsts, mut coefficients) = (Vec::new(), Vec::new());
        for span in knots.spans() {
            let mut halves = vec![[0.0; POWER_DEGREE + 1]; 2 * n];
            for function in 0..n {
                let (mut points, mut powers) = (vec![0.0; n], Vec::with_capacity(2 * n));
                points[function] = 1.0;
                convert_to_bezier(knots, span, &mut points);
                add_in_powers(&mut points, &mut powers);
                for (all, of_function) in halves.iter_mut().zip(powers) {
                    all[function] = of_function;
                }
            }
            firsts.extend([span + 1 - n; 2]);
            coefficients.extend(halves);
        }
        Self { lookup: SpanLookup::of_halves(knots), firsts, coefficients }
    }

    /// The first function that acts at a place.
    #[inline(always)]
    pub(crate) fn first(&self, place: LocalParameter) -> usize {
        self.firsts[place.piece]
    }

    /// The values of the `n` functions, p + 1.
    #[inline(always)]
    pub(crate) fn values(&self, place: LocalParameter, n: usize) -> BasisValues {
        let rows = &self.coefficients[place.piece * n..][..n];
        let mut values = rows[n - 1];
        for row in rows[..n - 1].iter().rev() {
            for i in 0..n {
                values[i] = values[i] * place.s + row[i];
            }
        }
        values
    }

    /// The values of the `n` functions with their first and second derivatives, by s.
    #[inline(always)]
    pub(crate) fn second_order(&self, place: LocalParameter, n: usize) -> [BasisValues; 3] {
        let rows = &self.coefficients[place.piece * n..][..n];
        let mut values = rows[n - 1];
        let (mut slopes, mut bends) = ([0.0; POWER_DEGREE + 1], [0.0; POWER_DEGREE + 1]);
        for row in rows[..n - 1].iter().rev() {
            for i in 0..n {
                bends[i] = bends[i] * place.s + slopes[i];
                slopes[i] = slopes[i] * place.s + values[i];
                values[i] = values[i] * place.s + row[i];
            }
        }
        [values, slopes, bends.map(|bend| 2.0 * bend)]
    }
}
