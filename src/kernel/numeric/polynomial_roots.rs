//! Where polynomials change their sign.
//!
//! Coefficients of one sign mean a polynomial of one sign, and a single change of sign among them
//! a single root; whatever has more is halved. Lane & Riesenfeld, *Bounds on a polynomial*, BIT 21
//! (1981). Nothing is sampled, so that no pair of roots is lost between samples.

use super::{bisection, newton::within_bracket};
use crate::{
    Interval, bernstein,
    ceiling::{BISECTIONS, ROOT_CLUSTER_HALVINGS, SIGN_PARTS},
    tolerance::LAST_BIT,
    work,
};

/// Follows the sign of a piecewise polynomial along its pieces, in order, and notes where it
/// changes.
///
/// Where the function is zero along a stretch and has different signs before and behind it, the
/// change is in the middle of the stretch. A root that is touched and not crossed is no change.
#[derive(Debug, Default)]
pub(crate) struct Signs {
    first: i8,
    current: i8,
    zero_from: Option<f64>,
    changes: Vec<(f64, i8)>,
}

impl Signs {
    /// Goes on over a piece: Bernstein coefficients, of which those up to `rounding` have no sign.
    pub(crate) fn follow(&mut self, interval: Interval, coefficients: &[f64], rounding: f64) {
        let mut todo = vec![(Interval::UNIT, coefficients.to_vec(), 0)];
        let mut n_parts = 0;
        while work::goes_on(1)
            && let Some((part, coefficients, n_halvings)) = todo.pop()
        {
            n_parts += 1;
            let signs = signs(&coefficients, rounding);
            let n_changes = signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
            let Some((&start, &end)) = signs.first().zip(signs.last()) else {
                self.zero_from.get_or_insert(interval.at(part.start()));
                continue;
            };
            if n_changes > 1 && n_halvings < ROOT_CLUSTER_HALVINGS && n_parts < SIGN_PARTS {
                let [left, right] = bernstein::halves(&coefficients);
                let [before, behind] = part.halves();
                todo.push((behind, right, n_halvings + 1));
                todo.push((before, left, n_halvings + 1));
                continue;
            }
            self.arrive(interval.at(part.start()), start);
            if start != end {
                let root = interval.at(part.at(crossing(&coefficients, start)));
                self.changes.push((interval.without_dust(root), end));
                self.current = end;
            }
        }
    }

    /// A sign at a place, after whatever came before it.
    fn arrive(&mut self, place: f64, sign: i8) {
        let stretch = self.zero_from.take();
        if self.current == 0 {
            self.first = sign;
        } else if sign != self.current {
            self.changes.push((stretch.map_or(place, |from| 0.5 * (from + place)), sign));
        }
        self.current = sign;
    }

    /// Whether the sign behind the last piece differs from that before the first: a change at the
    /// seam of a closed curve.
    pub(crate) fn changes_at_seam(&self) -> bool {
        self.first != self.current
    }

    /// The places where the sign changes, in order, each with the sign behind it.
    pub(crate) fn changes(&self) -> &[(f64, i8)] {
        &self.changes
    }
}

/// The signs of those coefficients that have one.
fn signs(coefficients: &[f64], rounding: f64) -> Vec<i8> {
    let clear = coefficients.iter().filter(|value| rounding < value.abs());
    clear.map(|&value| if value < 0.0 { -1 } else { 1 }).collect()
}

/// The one root of a polynomial on 0..1 that begins with sign `start`.
fn crossing(coefficients: &[f64], start: i8) -> f64 {
    let is_before = |t: f64| 0.0 < bernstein::value(coefficients, t) * f64::from(start);
    let [low, high] = bisection::bisected([0.0, 1.0], BISECTIONS, is_before);
    0.5 * (low + high)
}

/// The root on 0..1 of a polynomial that grows or falls; of one without a root the end that is
/// nearer to one. Newton's method within a bracket that is halved where it leads out.
pub(crate) fn monotone_root(coefficients: &[f64], slopes: &[f64]) -> f64 {
    let last = coefficients.len() - 1;
    let sign = if coefficients[0] <= coefficients[last] { 1.0 } else { -1.0 };
    if 0.0 <= sign * coefficients[0] {
        return 0.0;
    }
    if sign * coefficients[last] <= 0.0 {
        return 1.0;
    }
    let start = coefficients[0] / (coefficients[0] - coefficients[last]);
    let is_still = |t: f64, next: f64| (next - t).abs() <= LAST_BIT;
    within_bracket([0.0, 1.0], start, BISECTIONS, is_still, |t| {
        Some([coefficients, slopes].map(|values| sign * bernstein::value(values, t)))
    })
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "exactness is the claim")]
mod tests {
    use super::{Signs, monotone_root};
    use crate::Interval;

    fn changes(pieces: &[&[f64]]) -> Vec<(f64, i8)> {
        let mut signs = Signs::default();
        for (i, piece) in pieces.iter().enumerate() {
            let interval = Interval::new(i as f64, i as f64 + 1.0).unwrap();
            signs.follow(interval, piece, 0.0);
        }
        signs.changes().to_vec()
    }

    #[test]
    fn crossings_are_found_and_touches_are_not() {
        // 2t − 1.
        assert_eq!(changes(&[&[-1.0, 1.0]]), [(0.5, 1)]);
        // (2t − 1)².
        assert_eq!(changes(&[&[1.0, -1.0, 1.0]]), []);
        // (t − 1/4)(t − 3/4) = 3/16 − t + t².
        let found = changes(&[&[3.0 / 16.0, 3.0 / 16.0 - 0.5, 3.0 / 16.0]]);
        assert_eq!(found.len(), 2);
        assert!((found[0].0 - 0.25).abs() < 1e-15 && (found[1].0 - 0.75).abs() < 1e-15);
    }

    #[test]
    fn a_change_at_a_joint_is_one_change() {
        assert_eq!(changes(&[&[-1.0, 0.0], &[0.0, 2.0]]), [(1.0, 1)]);
        assert_eq!(changes(&[&[-1.0, 0.0], &[0.0, -2.0]]), []);
    }

    #[test]
    fn a_change_over_a_stretch_of_zeros_is_in_its_middle() {
        assert_eq!(changes(&[&[-1.0, 0.0], &[0.0, 0.0], &[0.0, 1.0]]), [(1.5, 1)]);
    }

    #[test]
    fn the_root_of_what_grows_or_falls_is_found_to_the_last_bit() {
        // t² − 1/2 and its slope 2t, and both turned over.
        let wanted = std::f64::consts::FRAC_1_SQRT_2;
        let grows = monotone_root(&[-0.5, -0.5, 0.5], &[0.0, 2.0]);
        let falls = monotone_root(&[0.5, 0.5, -0.5], &[0.0, -2.0]);
        assert!((grows - wanted).abs() <= f64::EPSILON && (falls - grows).abs() <= 0.0);
        // Without a root the nearer end.
        assert_eq!(monotone_root(&[1.0, 2.0], &[1.0]), 0.0);
        assert_eq!(monotone_root(&[-2.0, -1.0], &[1.0]), 1.0);
    }
}
