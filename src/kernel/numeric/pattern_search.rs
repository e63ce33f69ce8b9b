//! Uphill without derivatives: looks around a place, by steps that become shorter where none leads
//! higher.
//!
//! Hooke & Jeeves, *"Direct search" solution of numerical and statistical problems*, J. ACM 8 (1961).

/// A place with what a function is there.
pub(crate) type SearchPoint = ([f64; 2], f64);

/// The highest place that is come to: each of so many looks goes `step` times each of the ways from
/// where it is, at once where that is higher, and halves the step where none is.
///
/// `look` tells the height beside, and the place that stands for it inside of limits; none beyond
/// them.
///
/// # Errors
/// Those of `look`.
pub(crate) fn climbed<E>(
    (mut place, mut most): SearchPoint,
    mut step: [f64; 2],
    ways: &[[f64; 2]],
    n_looks: usize,
    mut look: impl FnMut([f64; 2]) -> Result<Option<SearchPoint>, E>,
) -> Result<SearchPoint, E> {
    for _ in 0..n_looks {
        let mut is_best = true;
        for way in ways {
            let beside = [0, 1].map(|i| place[i] + way[i] * step[i]);
            if let Some((there, height)) = look(beside)?
                && most < height
            {
                (place, most, is_best) = (there, height, false);
            }
        }
        if is_best {
            step = step.map(|step| 0.5 * step);
        }
    }
    Ok((place, most))
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use super::{SearchPoint, climbed};

    const CROSS: [[f64; 2]; 4] = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];

    fn hill([x, y]: [f64; 2]) -> f64 {
        -((x - 0.3) * (x - 0.3) + 2.0 * (y + 0.7) * (y + 0.7))
    }

    fn check(look: impl Fn([f64; 2]) -> Option<SearchPoint>, wanted: [f64; 2]) {
        let start = ([0.0, 0.0], hill([0.0, 0.0]));
        let Ok(([x, y], most)) =
            climbed(start, [0.5, 0.25], &CROSS, 80, |place| Ok::<_, Infallible>(look(place)));
        // The height is flat at its top, so that the place has half of the digits.
        assert!((x - wanted[0]).abs() < 1e-7 && (y - wanted[1]).abs() < 1e-7, "{x} {y}");
        assert!((most - hill(wanted)).abs() < 1e-13, "{most}");
    }

    #[test]
    fn a_hill_is_climbed_to_its_top() {
        check(|place| Some((place, hill(place))), [0.3, -0.7]);
    }

    #[test]
    fn limits_are_kept() {
        let inside = |[x, y]: [f64; 2]| [x.clamp(-1.0, 0.2), y.clamp(-0.5, 1.0)];
        check(|place| Some((inside(place), hill(inside(place)))), [0.2, -0.5]);
        check(|place| (-0.7 <= place[1]).then(|| (place, hill(place))), [0.3, -0.7]);
    }
}
