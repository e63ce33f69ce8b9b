//! The slope of a function of one number that has no derivatives of its own.

use crate::ceiling::SLOPE_STEPS;

/// A slope, and how far it may be off.
///
/// ```
/// use virote_kernel::{Slope, find_slope};
///
/// let Slope { value, error } = find_slope(|x| Ok::<_, ()>(x.sqrt()), 4.0, 0.1)?;
/// assert!((value - 0.25).abs() < 1e-11 && error < 1e-10);
/// # Ok::<(), ()>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// The slope.
    pub value: f64,
    /// The difference that the last better answer made, or that of both sides.
    pub error: f64,
}

/// The slope of a function at a place, by central differences over a step and over ever smaller ones, and what they
/// tend to. Where they begin to part again, since the function has no more digits, the best is taken. What the slopes on
/// both sides differ by at last, as at a kink, counts as an error.
///
/// Ridders, *Accurate computation of F′(x) and F′(x) F″(x)*, Adv. Eng. Software 4 (1982).
///
/// ```
/// use virote_kernel::find_slope;
///
/// // A kink has no slope.
/// let found = find_slope(|x: f64| Ok::<_, ()>((x - 1.0).abs()), 1.0, 0.1)?;
/// assert!(0.5 < found.error);
/// # Ok::<(), ()>(())
/// ```
///
/// # Errors
/// Those of the function.
pub fn find_slope<E>(
    mut function: impl FnMut(f64) -> Result<f64, E>,
    at: f64,
    step: f64,
) -> Result<Slope, E> {
    let mut best = Slope { value: f64::NAN, error: f64::INFINITY };
    let here = function(at)?;
    let mut sides_apart = f64::INFINITY;
    // What the differences over one step and the larger ones tend to, by more and more of them.
    let mut before: Vec<f64> = Vec::new();
    for halvings in 0..SLOPE_STEPS {
        let reach = libm::ldexp(step, -halvings);
        let [low, high] = [at - reach, at + reach];
        let (below, above) = (function(low)?, function(high)?);
        let mut row = vec![(above - below) / (high - low)];
        let apart = ((above - here) - (here - below)) / reach;
        // It falls with the step where the function is smooth.
        let kink = 0.5 * (2.0 * apart - sides_apart).abs();
        sides_apart = apart;
        let mut power = 1.0;
        for (k, &larger) in before.iter().enumerate() {
            power *= 4.0;
            let smaller = row[k];
            let found = smaller + (smaller - larger) / (power - 1.0);
            let error = (found - smaller).abs().max((found - larger).abs()).max(kink);
            if error <= best.error {
                best = Slope { value: found, error };
            }
            row.push(found);
        }
        if let (Some(last), Some(previous)) = (row.last(), before.last())
            && 2.0 * best.error <= (last - previous).abs()
        {
            break;
        }
        before = row;
    }
    Ok(best)
}

#[cfg(test)]
mod tests {
    use super::find_slope;

    #[test]
    fn slopes_are_those_of_closed_forms() {
        let cases: [(fn(f64) -> f64, f64, f64); 4] = [
            (libm::exp, 1.0, std::f64::consts::E),
            (|x| x * x * x, -2.0, 12.0),
            (|x| 1.0 / x, 0.5, -4.0),
            (|_| 7.0, 3.0, 0.0),
        ];
        for (function, at, expected) in cases {
            let found = find_slope(|x| Ok::<_, ()>(function(x)), at, 0.05).expect("a slope");
            let off = (found.value - expected).abs();
            assert!(off < 1e-10 && off <= found.error.max(1e-12), "{found:?} for {expected}");
        }
        // What is known to six digits has a slope of some four.
        let rough = |x: f64| Ok::<_, ()>((libm::exp(x) * 1e6).round() / 1e6);
        let found = find_slope(rough, 1.0, 0.05).expect("a slope");
        assert!(
            (found.value - std::f64::consts::E).abs() < 1e-4 && found.error < 1e-3,
            "{found:?}"
        );
    }
}
