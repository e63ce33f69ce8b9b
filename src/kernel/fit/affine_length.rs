//! Parameters by affine length.
//!
//! A parabola has constant speed in them, and the derivative of a cubic turns evenly: the spline nearest to
//! points whose parameters may slide is slow where it bends and fast where it is straight, as the cube root of
//! its curvature. From chord lengths points slide there in many small steps, or not at all. Blaschke, *Vorlesungen über
//! Differentialgeometrie II*, §3 (affine length); de Boor, Höllig & Sabin, *High accuracy geometric Hermite
//! interpolation*, CAGD 4 (1987): such splines have order six where those at given parameters have order four.

use glam::DVec3;

use crate::NurbsCurve;

/// Where a curve bends less than this share of its mean curvature it is as fast as there: affine length alone
/// stands still on a line.
const LEAST_BEND: f64 = 0.3;

/// Parameters of the points that lie on the curve at other ones, from the same first to the same last, by affine
/// length along the curve; the same where it does not bend.
pub(super) fn by_affine_length(curve: &NurbsCurve, parameters: &[f64]) -> Vec<f64> {
    let mut bends: Vec<(f64, f64)> = Vec::with_capacity(parameters.len());
    curve.evaluator().each_second_order(parameters, |[_, velocity, second]: [DVec3; 3]| {
        let speed = velocity.length();
        let cube = (speed * speed * speed).max(f64::MIN_POSITIVE);
        bends.push((speed, velocity.cross(second).length() / cube));
    });
    let along = |rate: &dyn Fn((f64, f64)) -> f64| {
        let mut sums = vec![0.0];
        for (bends, ends) in bends.windows(2).zip(parameters.windows(2)) {
            let step = 0.5 * (rate(bends[0]) + rate(bends[1])) * (ends[1] - ends[0]);
            sums.push(sums[sums.len() - 1] + step);
        }
        sums
    };
    let last = parameters.len() - 1;
    let least =
        LEAST_BEND * along(&|(speed, bend)| speed * bend)[last] / along(&|(speed, _)| speed)[last];
    let sums = along(&|(speed, bend)| speed * libm::cbrt((bend * bend + least * least).sqrt()));
    let whole = sums[last];
    if !(whole.is_finite() && 0.0 < whole) {
        return parameters.to_vec();
    }
    let [start, end] = [parameters[0], parameters[last]];
    let mut found: Vec<f64> =
        sums.iter().map(|sum| start + (end - start) * (sum / whole)).collect();
    found[last] = end;
    found
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::by_affine_length;
    use crate::{KnotVector, NurbsCurve};

    fn curve(points: &[[f64; 2]]) -> NurbsCurve {
        let knots = KnotVector::bezier(points.len() - 1).expect("a degree");
        let points: Vec<DVec3> = points.iter().map(|&[x, y]| DVec3::new(x, y, 0.0)).collect();
        NurbsCurve::polynomial(knots, &points).expect("points for their knots")
    }

    #[test]
    fn a_flat_parabola_keeps_its_parameters() {
        // Its curvature varies so little that the least bend changes nothing that counts.
        let parabola = curve(&[[0.0, 0.0], [1.0, 0.1], [2.0, 0.0]]);
        let parameters: Vec<f64> = (0..=100).map(|i| f64::from(i) / 100.0).collect();
        let found = by_affine_length(&parabola, &parameters);
        for (a, b) in found.iter().zip(&parameters) {
            assert!((a - b).abs() < 1e-3, "{a} for {b}");
        }
    }

    #[test]
    fn a_line_keeps_its_parameters() {
        let line = curve(&[[0.0, 0.0], [1.0, 2.0]]);
        assert_eq!(by_affine_length(&line, &[0.0, 0.2, 1.0]), [0.0, 0.2, 1.0]);
    }

    #[test]
    fn bends_take_more_of_the_parameters_than_what_is_straight() {
        let hook = curve(&[[0.0, 0.0], [10.0, 0.0], [10.0, 0.0], [10.0, 1.0]]);
        let parameters: Vec<f64> = (0..=100).map(|i| f64::from(i) / 100.0).collect();
        let found = by_affine_length(&hook, &parameters);
        assert!(found.is_sorted());
        assert!(found[0].abs() <= 0.0 && (found[100] - 1.0).abs() <= 0.0);
        // By length alone, what lies beyond x = 9 would take less than a fifth.
        let at = parameters.iter().position(|&t| 9.0 < hook.point_at(t).x).expect("it ends at 10");
        assert!(found[at] < 0.75, "{}", found[at]);
    }
}
