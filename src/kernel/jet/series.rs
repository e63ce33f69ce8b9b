//! Taylor coefficients of elementary functions about a place, by the recurrences that their
//! differential equations give.
//!
//! Griewank & Walther, *Evaluating Derivatives*, Table 13.2. Each function answers `order + 1`
//! coefficients, the value first.

use super::JetTerms;

/// (1 + x)ⁿ about 0 is the binomial series; about `x` every term is the one before times
/// (n − k + 1)/(k·x). `value` is `x` to the `exponent`; `x` is not zero.
pub(super) fn power(x: f64, value: f64, exponent: f64, order: usize) -> JetTerms {
    let next = |term: &mut f64, k: usize| {
        if 0 < k {
            *term *= (exponent - k as f64 + 1.0) / (k as f64 * x);
        }
        Some(*term)
    };
    (0..=order).scan(value, next).collect()
}

/// Functions whose k-th derivatives go round in a circle of four.
pub(super) fn cyclic(derivatives: [f64; 4], order: usize) -> JetTerms {
    let mut factorial = 1.0;
    let term = |k: usize| {
        factorial *= k.max(1) as f64;
        derivatives[k % 4] / factorial
    };
    (0..=order).map(term).collect()
}

pub(super) fn ln(x: f64, order: usize) -> JetTerms {
    integral(libm::log(x), &power(x, 1.0 / x, -1.0, order)[..order])
}

/// y' = 1 + sign·y².
pub(super) fn tangent(value: f64, sign: f64, order: usize) -> JetTerms {
    let mut terms: JetTerms = vec![value];
    for k in 0..order {
        let square: f64 = (0..=k).map(|i| terms[i] * terms[k - i]).sum();
        let one = if k == 0 { 1.0 } else { 0.0 };
        terms.push((one + sign * square) / (k + 1) as f64);
    }
    terms
}

/// y' = g with (1 − x²)·g' = x·g; `x` lies between −1 and 1.
pub(super) fn asin(x: f64, order: usize) -> JetTerms {
    let rest = (1.0 - x) * (1.0 + x);
    let mut slopes: JetTerms = vec![1.0 / rest.sqrt()];
    for k in 0..order {
        let before = if k == 0 { 0.0 } else { slopes[k - 1] };
        let (n, next) = (k as f64, (k + 1) as f64);
        slopes.push(((2.0 * n + 1.0) * x * slopes[k] + n * before) / (rest * next));
    }
    integral(libm::asin(x), &slopes[..order])
}

/// y' = g with (1 + x²)·g = 1.
pub(super) fn atan(x: f64, order: usize) -> JetTerms {
    let mut slopes = JetTerms::new();
    // Divided by the larger of 1 and x², so that no square overflows.
    let inverse = if x.abs() <= 1.0 { 1.0 } else { 1.0 / x };
    let (square, linear, denominator) = (
        inverse * inverse,
        x * inverse * inverse,
        inverse * inverse + (x * inverse) * (x * inverse),
    );
    for k in 0..=order {
        let before = |n: usize| if n <= k { slopes[k - n] } else { 0.0 };
        let one = if k == 0 { square } else { 0.0 };
        let lower = if k == 0 { 0.0 } else { 2.0 * linear * before(1) };
        let lowest = if k < 2 { 0.0 } else { square * before(2) };
        slopes.push((one - lower - lowest) / denominator);
    }
    integral(libm::atan(x), &slopes[..order])
}

/// The series with this value and these coefficients of its derivative.
fn integral(value: f64, slopes: &[f64]) -> JetTerms {
    let terms = slopes.iter().enumerate().map(|(k, slope)| slope / (k + 1) as f64);
    std::iter::once(value).chain(terms).collect()
}
