//! Laws of lines and arcs that touch curves: how many there are, and that they touch.

use std::f64::consts::TAU;

use glam::{DAffine3, DVec3};
use proptest::{collection::vec, prop_assert, prop_assert_eq, prop_assume, proptest};
use virote_kernel::{
    CircleForm, Frame, NurbsCurve, TangentArc, TangentEnd, TangentLine, Tolerance,
};

use crate::some::motion;

fn circle(center: DVec3, radius: f64) -> NurbsCurve {
    NurbsCurve::ellipse(Frame::XY.at(center), [radius; 2], CircleForm::NinePoint).unwrap()
}

fn between<'c>(a: &'c NurbsCurve, b: &'c NurbsCurve) -> [TangentEnd<'c>; 2] {
    [TangentEnd::Curve(a), TangentEnd::Curve(b)]
}

fn plane_curve(coordinates: &[f64]) -> NurbsCurve {
    let points: Vec<DVec3> =
        coordinates.chunks(2).map(|pair| DVec3::new(pair[0], pair[1], 0.0)).collect();
    NurbsCurve::bezier(&points).unwrap()
}

/// The sine of the angle between a curve and a way at a parameter.
fn sine(curve: &NurbsCurve, t: f64, way: DVec3) -> f64 {
    curve.derivatives_at(t, 1)[1].normalize().cross(way.normalize()).length()
}

/// How often numbers change their sign.
fn changes(values: &[f64]) -> usize {
    values.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count()
}

/// Numbers that are so near to zero between changes of sign that more may hide there.
fn are_clear(values: &[f64]) -> bool {
    let most = values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    values.windows(3).all(|three| {
        let bends = three[1].abs() < three[0].abs().min(three[2].abs());
        !bends || 0.0 >= three[0] * three[2] || 1e-3 * most < three[1].abs()
    })
}

proptest! {
    #[test]
    fn circles_have_as_many_common_tangents_as_their_distance_tells(
        r in 0.2..3.0_f64, s in 0.2..3.0_f64, d in 0.1..8.0_f64, turn in 0.0..TAU, map in motion(),
    ) {
        let clear = [r + s - d, (r - s).abs() - d].map(f64::abs);
        prop_assume!(clear.iter().all(|gap| 1e-2 < *gap));
        let centers = [DVec3::ZERO, DVec3::new(libm::cos(turn), libm::sin(turn), 0.0) * d];
        let (a, b) = (circle(centers[0], r).transformed(&map), circle(centers[1], s).transformed(&map));
        let lines = TangentLine::all(between(&a, &b), Tolerance::DEFAULT).unwrap();
        let wanted = if r + s < d { 4 } else if (r - s).abs() < d { 2 } else { 0 };
        prop_assert_eq!(lines.len(), wanted);
        for line in &lines {
            let way = line.points[1] - line.points[0];
            let [t, u] = line.parameters.map(Option::unwrap);
            prop_assert!(sine(&a, t, way) < 1e-9 && sine(&b, u, way) < 1e-9);
            // By Pythagoras, from the sum of the radii or their difference.
            let squares = [r + s, r - s].map(|sum| d * d - sum * sum);
            prop_assert!(squares.iter().any(|square| (way.length_squared() - square).abs() < 1e-9));
        }
    }

    #[test]
    fn circles_have_as_many_tangent_arcs_as_the_circles_of_their_centres_meet(
        r in 0.2..3.0_f64, s in 0.2..3.0_f64, d in 0.1..8.0_f64, radius in 0.2..5.0_f64, map in motion(),
    ) {
        let reach = |own: f64| [own + radius, (own - radius).abs()];
        let pairs: Vec<[f64; 2]> =
            reach(r).into_iter().flat_map(|p| reach(s).map(|q| [p, q])).collect();
        prop_assume!(pairs.iter().all(|[p, q]| {
            1e-2 < (p + q - d).abs() && 1e-2 < ((p - q).abs() - d).abs() && 1e-2 < p.min(*q)
        }));
        let wanted = 2 * pairs.iter().filter(|[p, q]| (p - q).abs() < d && d < p + q).count();
        let (a, b) = (circle(DVec3::ZERO, r).transformed(&map), circle(DVec3::X * d, s).transformed(&map));
        let arcs = TangentArc::all(between(&a, &b), radius, Tolerance::DEFAULT).unwrap();
        prop_assert_eq!(arcs.len(), wanted);
        for arc in &arcs {
            let curve = arc.curve(false).unwrap();
            prop_assert!(curve.start().distance(arc.points[0]) < 1e-9);
            prop_assert!(curve.end().distance(arc.points[1]) < 1e-9);
            let [t, u] = arc.parameters.map(Option::unwrap);
            prop_assert!(sine(&a, t, curve.derivatives_at(0.0, 1)[1]) < 1e-8);
            prop_assert!(sine(&b, u, curve.derivatives_at(1.0, 1)[1]) < 1e-8);
        }
    }

    #[test]
    fn from_a_point_a_curve_is_touched_wherever_its_tangent_turns_past_it(
        coordinates in vec(-3.0..3.0, 8..=12), x in -4.0..4.0, y in -4.0..4.0,
    ) {
        let coordinates = &coordinates[..coordinates.len() / 2 * 2];
        let (curve, from) = (plane_curve(coordinates), DVec3::new(x, y, 0.0));
        let passes: Vec<f64> = (0..=4000).map(|k| {
            let found = curve.derivatives_at(f64::from(k) / 4000.0, 1);
            (found[0] - from).cross(found[1]).z
        }).collect();
        prop_assume!(are_clear(&passes));
        let speeds = (0..=4000).map(|k| curve.derivatives_at(f64::from(k) / 4000.0, 1)[1].length());
        prop_assume!(speeds.fold(f64::INFINITY, f64::min) > 0.05);
        let ends = [TangentEnd::Point(from), TangentEnd::Curve(&curve)];
        let lines = TangentLine::all(ends, Tolerance::DEFAULT).unwrap();
        prop_assert_eq!(lines.len(), changes(&passes));
        for line in &lines {
            prop_assert!(sine(&curve, line.parameters[1].unwrap(), line.points[1] - from) < 1e-9);
        }
    }

    #[test]
    fn a_curve_and_a_circle_have_a_tangent_wherever_the_curves_own_is_a_radius_from_the_centre(
        coordinates in vec(-3.0..3.0, 8..=10), x in 3.0..6.0, radius in 0.3..2.0_f64, shift in -2.0..2.0,
    ) {
        let coordinates = &coordinates[..coordinates.len() / 2 * 2];
        let (curve, center) = (plane_curve(coordinates), DVec3::new(x, shift, 0.0));
        let sides = [radius, -radius].map(|radius: f64| {
            let height = |k: i32| {
                let found = curve.derivatives_at(f64::from(k) / 4000.0, 1);
                (center - found[0]).cross(found[1].normalize()).z - radius
            };
            (0..=4000).map(height).collect::<Vec<f64>>()
        });
        prop_assume!(sides.iter().all(|side| are_clear(side)));
        let speeds = (0..=4000).map(|k| curve.derivatives_at(f64::from(k) / 4000.0, 1)[1].length());
        prop_assume!(speeds.fold(f64::INFINITY, f64::min) > 0.05);
        let round = circle(center, radius);
        let lines = TangentLine::all(between(&curve, &round), Tolerance::DEFAULT).unwrap();
        prop_assert_eq!(lines.len(), changes(&sides[0]) + changes(&sides[1]));
    }
}

#[test]
fn tangents_are_the_same_in_every_unit_and_far_from_the_origin() {
    for scale in [1e-3, 1e3] {
        let map = DAffine3::from_translation(DVec3::new(4e3, -2e3, 0.0) * scale)
            * DAffine3::from_scale(DVec3::splat(scale));
        let [a, b] = [(DVec3::ZERO, 2.0), (DVec3::X * 6.0, 1.0)]
            .map(|(center, radius)| circle(center, radius).transformed(&map));
        let tolerance = Tolerance::DEFAULT.with_distance(1e-6 * scale);
        let lines = TangentLine::all(between(&a, &b), tolerance).unwrap();
        assert_eq!(lines.len(), 4);
        let arcs = TangentArc::all(between(&a, &b), 4.0 * scale, tolerance).unwrap();
        // Centres at 6 or 2 from one and at 5 or 3 from the other, 6 apart: only 2 and 3 do not meet.
        assert_eq!(arcs.len(), 6);
    }
}
