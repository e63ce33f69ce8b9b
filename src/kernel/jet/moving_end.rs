//! Integrals whose ends vary.

use super::Jet;

/// By how much an integral grows as its end moves from the value of a jet along all that varies in it.
///
/// The integrand is asked at jets between, and answers with its components there. What varies has no powers
/// beyond the order n of the jet, so that the integrand is a polynomial of degree n − 1 along the way, which a
/// rule with n nodes adds up exactly: Fejér's first. Waldvogel, *Fast construction of the Fejér and Clenshaw–Curtis
/// quadrature rules*, BIT 46 (2006).
///
/// The integral of x² from 0 on, as its end moves from 3 on:
///
/// ```
/// use virote_kernel::{Jet, jet::moved_end};
///
/// let end = Jet::variable(3.0, 2);
/// let gain = moved_end(&end, |x| Ok::<_, ()>(vec![x.times(x)]))?.remove(0);
/// assert!((gain.derivative(1, 0) - 9.0).abs() < 1e-14 && (gain.derivative(2, 0) - 6.0).abs() < 1e-14);
/// # Ok::<(), ()>(())
/// ```
///
/// # Errors
/// Those of the integrand.
pub fn moved_end<E>(
    end: &Jet,
    mut integrand: impl FnMut(&Jet) -> Result<Vec<Jet>, E>,
) -> Result<Vec<Jet>, E> {
    let way = end.clone().with_value(0.0);
    let mut sum: Vec<Jet> = Vec::new();
    for [fraction, weight] in fejer(end.order().max(1)) {
        let at = way.scaled(fraction).with_value(end.value());
        let parts = integrand(&at)?;
        let parts: Vec<Jet> = parts.iter().map(|part| part.times(&way).scaled(weight)).collect();
        if sum.is_empty() {
            sum = parts;
        } else {
            sum.iter_mut().zip(&parts).for_each(|(sum, part)| *sum = sum.plus(part));
        }
    }
    Ok(sum)
}

/// The nodes of Fejér's first rule on 0..1, each with its weight.
fn fejer(n: usize) -> impl Iterator<Item = [f64; 2]> {
    (0..n).map(move |k| {
        let angle = (k as f64 + 0.5) * std::f64::consts::PI / n as f64;
        let term = |j: usize| {
            let j = j as f64;
            libm::cos(2.0 * j * angle) / (4.0 * j * j - 1.0)
        };
        let sum: f64 = (1..=n / 2).map(term).sum();
        [0.5 - 0.5 * libm::cos(angle), (1.0 - 2.0 * sum) / n as f64]
    })
}
