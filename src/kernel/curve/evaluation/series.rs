//! Power series of vectors, cut off after so many terms: `terms[k]` goes with the k-th power.

use glam::DVec3;
use smallvec::SmallVec;

/// Terms, in memory of their own from the fifth on: four of them tell tangent, curvature and torsion.
pub(in crate::curve) type Terms<T> = SmallVec<[T; 4]>;

/// `stepᵏ / k!` by k, without end: what makes terms of a Taylor series of derivatives.
pub(in crate::curve) fn powers(step: f64) -> impl Iterator<Item = f64> {
    let next = move |power: &mut f64, k: usize| {
        *power *= if k == 0 { 1.0 } else { step / k as f64 };
        Some(*power)
    };
    (0..).scan(1.0, next)
}

/// The series of a vector's length; its first term is not zero.
pub(in crate::curve) fn norms(vectors: &[DVec3]) -> Terms<f64> {
    let mut norms: Terms<f64> = Terms::with_capacity(vectors.len());
    for k in 0..vectors.len() {
        let square: f64 = (0..=k).map(|i| vectors[i].dot(vectors[k - i])).sum();
        let known: f64 = (1..k).map(|i| norms[i] * norms[k - i]).sum();
        norms.push(match k {
            0 => square.sqrt(),
            _ => (square - known) / (2.0 * norms[0]),
        });
    }
    norms
}

/// The quotient, as long as the shorter series; the first term of the divisor is not zero.
pub(in crate::curve) fn quotient(vectors: &[DVec3], divisor: &[f64]) -> Terms<DVec3> {
    let mut quotient: Terms<DVec3> = Terms::with_capacity(vectors.len());
    for (k, &vector) in vectors.iter().enumerate().take(divisor.len()) {
        let known: DVec3 = (0..k).map(|i| quotient[i] * divisor[k - i]).sum();
        quotient.push((vector - known) / divisor[0]);
    }
    quotient
}

/// The derivative, one term shorter.
pub(in crate::curve) fn derivative(vectors: &[DVec3]) -> Terms<DVec3> {
    vectors.iter().enumerate().skip(1).map(|(k, &vector)| vector * k as f64).collect()
}

/// The cross product with the derivative: of a velocity, along the binormal.
pub(in crate::curve) fn cross_derivative(vectors: &[DVec3]) -> Terms<DVec3> {
    let slope = derivative(vectors);
    let term = |k: usize| (0..=k).map(|i| vectors[i].cross(slope[k - i])).sum();
    (0..slope.len()).map(term).collect()
}
