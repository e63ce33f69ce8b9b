//! Curves and surfaces whose control points vary: slopes against closed forms, and against central
//! differences of the curves and surfaces themselves.

use std::sync::Arc;

use glam::{DVec3, DVec4};
use proptest::{
    collection::vec,
    prelude::{ProptestConfig, Strategy, prop_assert, prop_assume, proptest},
};
use virote_kernel::{
    CircleForm, Frame, Jet, NurbsCurve, NurbsSurface, PointSlopes, Side, Surface, VariedCurve,
    VariedSurface,
};

use crate::some;

/// Half the distance between the places of a central difference.
const STEP: f64 = 1e-5;

/// Of the size of what is compared; the error of a central difference of coordinates of size ten.
const NEAR: f64 = 1e-6;

/// Homogeneous slopes; weights change slowly.
fn slopes(n: usize) -> impl Strategy<Value = Vec<DVec4>> {
    vec((some::point(), -0.1..0.1), n)
        .prop_map(|all| all.iter().map(|(p, w)| p.extend(*w)).collect())
}

fn varied_curve() -> impl Strategy<Value = VariedCurve> {
    some::curve().prop_flat_map(|curve| {
        let n = curve.control_points().len();
        slopes(n).prop_map(move |own| {
            let slopes = PointSlopes::new(3, n, vec![(1, own)]).unwrap();
            VariedCurve::new(Arc::new(curve.clone()), slopes).unwrap()
        })
    })
}

fn varied_surface() -> impl Strategy<Value = VariedSurface> {
    some::surface().prop_flat_map(|surface| {
        let n = surface.control_points().as_slice().len();
        slopes(n).prop_map(move |own| {
            let slopes = PointSlopes::new(2, n, vec![(0, own)]).unwrap();
            VariedSurface::new(Arc::new(surface.clone()), slopes).unwrap()
        })
    })
}

fn central(ask: impl Fn(f64) -> f64) -> f64 {
    (ask(STEP) - ask(-STEP)) / (2.0 * STEP)
}

fn is_near(a: f64, b: f64, size: f64) -> bool {
    (a - b).abs() <= NEAR * (1.0 + size + a.abs())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// C, C' and C'' at a place that moves too.
    #[test]
    fn derivatives_of_a_curve_grow_by_their_slopes(varied in varied_curve(), at in 0.1..0.9) {
        let t = varied.curve().domain().at(at);
        // Not where a piece ends within the step.
        prop_assume!(varied.curve().knots().breaks().iter().all(|knot| 3.0 * STEP < (knot - t).abs()));
        let jet = Jet::with_slopes(t, &[0.0, 0.5, 1.0]).unwrap();
        let found = varied.derivatives_beside(&jet, Side::Right, 2).unwrap();
        let moved = |h: f64| varied.moved(&[(1, h)]).unwrap();
        for (order, vector) in found.iter().enumerate() {
            let by_all = |h: f64| moved(h).derivatives_at(t + 0.5 * h, order)[order];
            let by_place = |h: f64| varied.curve().derivatives_at(t + h, order)[order];
            for (axis, part) in vector.iter().enumerate() {
                let size = by_all(0.0).length() * 1e3;
                let slopes = part.slopes();
                prop_assert!(slopes[0].abs() <= 0.0);
                prop_assert!(is_near(slopes[1], central(|h| by_all(h)[axis]), size));
                prop_assert!(is_near(slopes[2], central(|h| by_place(h)[axis]), size));
            }
        }
    }

    #[test]
    fn the_length_grows_by_its_slopes(varied in varied_curve()) {
        let domain = varied.curve().domain();
        let Ok(found) = varied.length(domain) else { return Ok(()) };
        let expected = central(|h| varied.moved(&[(1, h)]).unwrap().length(domain));
        prop_assert!(is_near(found.slopes()[1], expected, found.value()), "{found:?} {expected}");
    }

    #[test]
    fn derivatives_of_a_surface_grow_by_their_slopes(
        varied in varied_surface(),
        u in 0.1..0.9,
        v in 0.1..0.9,
    ) {
        let surface = varied.surface();
        let [u, v] = [surface.domain_u().at(u), surface.domain_v().at(v)];
        let is_inside = |knots: Vec<f64>, t: f64| knots.iter().all(|knot| 3.0 * STEP < (knot - t).abs());
        prop_assume!(is_inside(surface.knots_u().breaks(), u) && is_inside(surface.knots_v().breaks(), v));
        let jets = [Jet::with_slopes(u, &[0.3, 1.0]).unwrap(), Jet::with_slopes(v, &[-0.2, 0.0]).unwrap()];
        let found = varied.derivatives_at(jets.each_ref(), 1).unwrap();
        for (k, l) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let by_all = |h: f64| {
                let moved = varied.moved(&[(0, h)]).unwrap();
                moved.derivatives_at(u + 0.3 * h, v - 0.2 * h, 1).get(k, l)
            };
            let by_u = |h: f64| surface.derivatives_at(u + h, v, 1).get(k, l);
            for axis in 0..3 {
                let size = by_all(0.0).length() * 1e3;
                let slopes = found.row(k)[l][axis].slopes();
                prop_assert!(is_near(slopes[0], central(|h| by_all(h)[axis]), size));
                prop_assert!(is_near(slopes[1], central(|h| by_u(h)[axis]), size));
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn the_area_grows_by_its_slopes(varied in varied_surface()) {
        let area = |h: f64| Surface::from(varied.moved(&[(0, h)]).unwrap()).area().unwrap();
        let Ok(found) = varied.area_slopes() else { return Ok(()) };
        // Where the surface folds neither the area nor its slope is known to many digits.
        prop_assume!(found.relative_error < 1e-9 && area(0.0).1 < 1e-11);
        let expected = central(|h| area(h).0);
        prop_assert!(is_near(found.slopes[0], expected, area(0.0).0), "{found:?} {expected}");
    }
}

/// A sphere whose radius grows: every control point goes outward as far as it is.
fn growing_ball(radius: f64) -> VariedSurface {
    let ball = NurbsSurface::sphere(Frame::XY, radius).unwrap();
    let points = ball.control_points().as_slice();
    let outward: Vec<DVec4> = points.iter().map(|p| (p.truncate() / radius).extend(0.0)).collect();
    let slopes = PointSlopes::new(1, points.len(), vec![(0, outward)]).unwrap();
    VariedSurface::new(Arc::new(ball), slopes).unwrap()
}

/// d(4πr²)/dr = 8πr, d(4/3·πr³)/dr = 4πr².
#[test]
fn a_ball_grows_by_its_area_and_its_area_by_eight_pi_r() {
    let (varied, pi) = (growing_ball(1.5), std::f64::consts::PI);
    let area = varied.area_slopes().unwrap().slopes[0];
    assert!((area - 12.0 * pi).abs() < 1e-10 * area, "{area}");
    let volume = varied.volume_slopes(DVec3::ZERO).unwrap().slopes[0].abs();
    assert!((volume - 9.0 * pi).abs() < 1e-10 * volume, "{volume}");
}

/// What encloses nothing anew holds as much about any point.
#[test]
fn the_volume_of_a_closed_surface_grows_alike_about_any_point() {
    let varied = growing_ball(0.7);
    let about = |x: f64| varied.volume_slopes(DVec3::new(x, -x, 2.0 * x)).unwrap().slopes[0];
    assert!((about(0.0) - about(3.0)).abs() < 1e-10);
}

/// What is moved takes its centre along; what grows about its centre leaves it where it is.
#[test]
fn the_centre_of_a_ball_goes_where_the_ball_goes() {
    let (still, center) = (growing_ball(1.5), DVec3::new(0.0, 0.0, 0.0));
    let ball = Arc::clone(still.surface());
    let points = ball.control_points().as_slice();
    let along = points.iter().map(|p| (DVec3::new(2.0, -1.0, 0.5) * p.w).extend(0.0)).collect();
    let slopes = PointSlopes::new(1, points.len(), vec![(0, along)]).unwrap();
    let moved = VariedSurface::new(ball, slopes).unwrap();
    let (pi, about) = (std::f64::consts::PI, DVec3::new(3.0, 1.0, -2.0));
    let sign = still.volume_slopes(about).unwrap().slopes[0].signum();
    for (axis, speed) in [(DVec3::X, 2.0), (DVec3::Y, -1.0), (DVec3::Z, 0.5)] {
        let of = |varied: &VariedSurface| {
            let volume = varied.volume_moment_slopes(about, center, axis).unwrap().slopes[0];
            let area = varied.area_moment_slopes(center, axis).unwrap().slopes[0];
            [sign * volume / (4.5 * pi), area / (9.0 * pi)]
        };
        for (moved, still) in of(&moved).into_iter().zip(of(&still)) {
            assert!((moved - speed).abs() < 1e-10 && still.abs() < 1e-10, "{moved} {still}");
        }
    }
}

/// A circle of radius r has the circumference 2πr; that of weights that change alike does not change.
#[test]
fn a_circle_grows_by_two_pi_r() {
    let circle =
        NurbsCurve::circle(DVec3::ZERO, 2.0, DVec3::X, DVec3::Z, CircleForm::NinePoint).unwrap();
    let points = circle.control_points();
    let outward = points.iter().map(|p| (p.truncate() / 2.0).extend(0.0)).collect();
    let heavier = points.to_vec();
    let slopes = PointSlopes::new(2, points.len(), vec![(0, outward), (1, heavier)]).unwrap();
    let varied = VariedCurve::new(Arc::new(circle), slopes).unwrap();
    let found = varied.length(varied.curve().domain()).unwrap();
    assert!((found.slopes()[0] - std::f64::consts::TAU).abs() < 1e-12);
    assert!(found.slopes()[1].abs() < 1e-12);
}

/// A leg that has no length has none that grows in proportion: |h| has no derivative at 0.
#[test]
fn a_leg_without_length_has_no_slope() {
    let points = [DVec3::ZERO, DVec3::X, DVec3::X];
    let curve = NurbsCurve::polyline(&points).unwrap();
    let slopes =
        PointSlopes::new(1, 3, vec![(0, vec![DVec4::ZERO, DVec4::ZERO, DVec4::Y])]).unwrap();
    let varied = VariedCurve::new(Arc::new(curve), slopes).unwrap();
    assert!(varied.length(varied.curve().domain()).is_err());
}
