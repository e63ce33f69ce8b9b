//! Laws of the shape at one parameter: tangent, curvature, torsion, and singular places.

use glam::{DAffine3, DQuat, DVec3};
use proptest::{prop_assert, prop_assume, proptest};
use virote_kernel::{
    CircleForm, Curve, CurvePointKind, EvaluationPlace, GeomError, Interval, KnotVector,
    LocalError, LocalGeometry, NurbsCurve, Side, Tolerance,
};

use crate::some::{curve, fraction, parameter, point};

fn local(curve: &NurbsCurve, t: f64) -> LocalGeometry {
    beside(curve, t, Side::Right)
}

fn beside(curve: &NurbsCurve, t: f64, side: Side) -> LocalGeometry {
    Curve::from(curve.clone()).local_at(t, side).unwrap()
}

fn kind(curve: &NurbsCurve, t: f64) -> CurvePointKind {
    Curve::from(curve.clone()).place_kind_at(t, Tolerance::DEFAULT).unwrap()
}

/// The shape that derivative vectors alone tell.
fn told_by(derivatives: &[DVec3], side: Side) -> Result<LocalGeometry, GeomError> {
    let around = EvaluationPlace {
        parameter: 0.0,
        side,
        reach: 1.0,
        rounding: 1e-13,
        growth: 1.0,
        slack: 0.0,
    };
    LocalGeometry::new(derivatives, around)
}

#[track_caller]
fn near(got: f64, expected: f64) {
    assert!((got - expected).abs() <= 1e-12 * expected.abs().max(1.0), "{got}, not {expected}");
}

#[track_caller]
fn near_point(got: DVec3, expected: DVec3) {
    assert!(got.distance(expected) <= 1e-12 * (1.0 + expected.length()), "{got}, not {expected}");
}

/// (t, t², t³) on 0..1 with the weights 1, c, c², c³: the same points, at t = cs / (1 − s + cs).
fn twisted_cubic(c: f64) -> NurbsCurve {
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 3.0]]
        .map(|p| DVec3::from(p) / 3.0);
    let weights = [1.0, c, c * c, c * c * c];
    NurbsCurve::rational(KnotVector::bezier(3).unwrap(), &points, &weights).unwrap()
}

#[test]
fn the_twisted_cubic_has_the_curvature_and_torsion_of_its_closed_form() {
    for c in [1.0, 0.5, 3.0, 5.0] {
        let cubic = twisted_cubic(c);
        for i in 0..=20 {
            let s = f64::from(i) / 20.0;
            let t = c * s / (1.0 - s + c * s);
            let local = local(&cubic, s);
            let [p, q] = [9.0, 4.0].map(|k| 9.0 * t * t * t * t + k * t * t + 1.0);
            near(local.curvature().unwrap(), 2.0 * p.sqrt() / (q * q.sqrt()));
            near(local.torsion().unwrap(), 3.0 / p);
            let binormal = DVec3::new(3.0 * t * t, -3.0 * t, 1.0).normalize();
            near_point(local.binormal().unwrap(), binormal);
        }
    }
}

#[test]
fn a_circle_has_one_curvature_and_one_centre() {
    let (center, normal) = (DVec3::new(1.0, -2.0, 3.0), DVec3::new(1.0, 2.0, 2.0) / 3.0);
    for form in CircleForm::ALL {
        let circle = NurbsCurve::circle(center, 2.5, normal.any_orthogonal_vector(), normal, form);
        let circle = circle.unwrap();
        for i in 0..=40 {
            let local = local(&circle, f64::from(i) / 40.0);
            near(local.curvature().unwrap(), 0.4);
            near(local.radius_of_curvature().unwrap(), 2.5);
            near_point(local.center_of_curvature().unwrap(), center);
            near_point(local.binormal().unwrap(), normal);
            assert!(local.torsion().unwrap().abs() < 1e-10, "{form:?}");
            near(local.signed_curvature(-normal, 1e-9).unwrap(), -0.4);
        }
    }
}

#[test]
fn derivative_vectors_alone_tell_the_helix() {
    let (r, c) = (2.0, 1.0);
    for i in 0..10 {
        let (sin, cos) = libm::sincos(f64::from(i));
        let derivatives = [
            DVec3::new(r * cos, r * sin, c * f64::from(i)),
            DVec3::new(-r * sin, r * cos, c),
            DVec3::new(-r * cos, -r * sin, 0.0),
            DVec3::new(r * sin, -r * cos, 0.0),
        ];
        let local = told_by(&derivatives, Side::Right).unwrap();
        near(local.curvature().unwrap(), r / (r * r + c * c));
        near(local.torsion().unwrap(), c / (r * r + c * c));
        near_point(local.normal().unwrap(), DVec3::new(-cos, -sin, 0.0));
        let frame = local.frame().unwrap();
        near_point(frame.x(), DVec3::new(-r * sin, r * cos, c) / 5.0_f64.sqrt());
        near_point(frame.z(), DVec3::new(c * sin, -c * cos, r) / 5.0_f64.sqrt());
    }
}

#[test]
fn where_the_parameter_stands_still_the_shape_decides() {
    // The unit circle (sin s², cos s²) at s = 0, by its Taylor series.
    let mut derivatives = vec![DVec3::ZERO; 7];
    derivatives[0] = DVec3::Y;
    derivatives[2] = DVec3::X * 2.0;
    derivatives[4] = DVec3::Y * -12.0;
    derivatives[6] = DVec3::X * -120.0;
    for (side, tangent) in [(Side::Right, DVec3::X), (Side::Left, -DVec3::X)] {
        let local = told_by(&derivatives, side).unwrap();
        near_point(local.tangent(), tangent);
        near(local.curvature().unwrap(), 1.0);
        near_point(local.normal().unwrap(), -DVec3::Y);
        near(local.torsion().unwrap(), 0.0);
    }
    // (s², s³) bends without bound.
    let cusp = [DVec3::ZERO, DVec3::ZERO, DVec3::X * 2.0, DVec3::Y * 6.0, DVec3::ZERO];
    let local = told_by(&cusp, Side::Left).unwrap();
    near_point(local.tangent(), -DVec3::X);
    assert!(matches!(
        local.curvature(),
        Err(GeomError::Local(LocalError::UnboundedCurvature { .. }))
    ));
    // (s, s³) is straight at 0, and its curvature grows from there.
    let inflection = [DVec3::ZERO, DVec3::X, DVec3::ZERO, DVec3::Y * 6.0];
    let local = told_by(&inflection, Side::Right).unwrap();
    assert_eq!(local.curvature(), Ok(0.0));
    assert!(matches!(local.normal(), Err(GeomError::Local(LocalError::Straight { .. }))));
    near_point(local.curvature_slope().unwrap(), DVec3::Y * 6.0);
}

proptest! {
    #[test]
    fn the_formulas_of_frenet(curve in curve(), f in 0.1..0.9) {
        let span = curve.knots().span_at(parameter(&curve, f));
        let inside = curve.knots().span_interval(span);
        let (t, h) = (inside.at(0.5), 1e-3 * inside.length());
        let here = local(&curve, t);
        let (Ok(frame), Ok(curvature), Ok(torsion)) = (here.frame(), here.curvature(), here.torsion())
        else { return Ok(()) };
        prop_assume!(curvature * curve.bounds().diagonal() < 1e3 && 1e-3 < curvature && torsion.abs() < 1e3);
        let speed = curve.derivatives_at(t, 1)[1].length();
        prop_assume!(0.1 < speed * inside.length());
        // The fourth-order difference quotient by arc length.
        let slope = |of: fn(&LocalGeometry) -> DVec3| {
            let at = |k: f64| of(&local(&curve, t + k * h));
            (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * h * speed)
        };
        let allowed = 1e-4 * libm::pow(1.0 + curvature + torsion.abs(), 5.0);
        let is_near = |a: DVec3, b: DVec3| a.distance(b) < allowed;
        prop_assert!(is_near(slope(LocalGeometry::tangent), curvature * frame.y()));
        let bend = -curvature * frame.x() + torsion * frame.z();
        prop_assert!(is_near(slope(|l| l.normal().unwrap()), bend));
        prop_assert!(is_near(slope(|l| l.binormal().unwrap()), -torsion * frame.y()));
    }

    #[test]
    fn motion_carries_the_shape_along_and_scaling_divides_it(
        curve in curve(), f in fraction(), axis in point(), by in point(), s in 0.001..1000.0,
    ) {
        prop_assume!(0.1 < axis.length());
        let turn = DQuat::from_axis_angle(axis.normalize(), axis.length());
        let moved = curve.transformed(&DAffine3::from_scale_rotation_translation(DVec3::splat(s), turn, by));
        let t = parameter(&curve, f);
        let (a, b) = (local(&curve, t), local(&moved, t));
        prop_assert!(b.tangent().distance(turn * a.tangent()) < 1e-9);
        let (Ok(k), Ok(frame)) = (a.curvature(), a.frame()) else { return Ok(()) };
        prop_assume!(1e-3 < k && k < 1e3);
        prop_assert!((b.curvature().unwrap() * s - k).abs() < 1e-8 * k);
        prop_assert!(b.normal().unwrap().distance(turn * frame.y()) < 1e-6);
        let (torsion, other) = (a.torsion().unwrap(), b.torsion().unwrap());
        prop_assert!((other * s - torsion).abs() < 1e-5 * (1.0 + torsion.abs() + k));
    }

    #[test]
    fn reversal_turns_tangent_and_binormal_and_nothing_else(curve in curve(), f in 0.01..0.99) {
        let (t, domain) = (parameter(&curve, f), curve.domain());
        let (a, b) = (local(&curve, t), local(&curve.reversed(), domain.start() + domain.end() - t));
        prop_assert!(a.tangent().distance(-b.tangent()) < 1e-9);
        let (Ok(k), Ok(frame)) = (a.curvature(), a.frame()) else { return Ok(()) };
        prop_assume!(1e-3 < k && k < 1e3);
        prop_assert!((b.curvature().unwrap() - k).abs() < 1e-8 * k);
        prop_assert!(b.normal().unwrap().distance(frame.y()) < 1e-6);
        prop_assert!(b.binormal().unwrap().distance(-frame.z()) < 1e-6);
        let (torsion, other) = (a.torsion().unwrap(), b.torsion().unwrap());
        prop_assert!((other - torsion).abs() < 1e-5 * (1.0 + torsion.abs() + k));
    }

    #[test]
    fn another_domain_leaves_the_shape(curve in curve(), f in fraction(), length in 0.001..1000.0) {
        let other = curve.reparametrized(Interval::new(-1.0, length).unwrap());
        let (a, b) = (local(&curve, parameter(&curve, f)), local(&other, parameter(&other, f)));
        prop_assert!(a.tangent().distance(b.tangent()) < 1e-8);
        let (Ok(k), Ok(l)) = (a.curvature(), b.curvature()) else { return Ok(()) };
        prop_assert!((k - l).abs() < 1e-6 * (1.0 + k));
    }
}

fn bezier(points: &[[f64; 3]], scale: f64) -> NurbsCurve {
    let points: Vec<DVec3> = points.iter().map(|&point| DVec3::from(point) * scale).collect();
    NurbsCurve::bezier(&points).unwrap()
}

/// From micrometres to kilometres in a document in millimetres, and further.
const SCALES: [f64; 5] = [1e-6, 1e-3, 1.0, 1e6, 1e9];

#[test]
fn kinds_of_places_are_the_same_at_every_scale() {
    let s_bend = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, -1.0, 0.0], [3.0, 0.0, 0.0]];
    let cusp = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]];
    let space_cusp = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 1e-3]];
    // Bends to one side all the way although the curvature vanishes halfway: x⁴.
    let flat =
        [[-1.0, 1.0, 0.0], [-0.5, -1.0, 0.0], [0.0, 1.0, 0.0], [0.5, -1.0, 0.0], [1.0, 1.0, 0.0]];
    for scale in SCALES {
        let kind = |points: &[[f64; 3]], t| kind(&bezier(points, scale), t);
        assert_eq!(kind(&s_bend, 0.5), CurvePointKind::Inflection);
        assert_eq!(kind(&s_bend, 0.5 + 1e-11), CurvePointKind::Inflection);
        assert_eq!(kind(&s_bend, 0.5 + 1e-6), CurvePointKind::Regular);
        assert_eq!(kind(&cusp, 0.5), CurvePointKind::Cusp);
        assert_eq!(kind(&cusp, 0.5 - 1e-12), CurvePointKind::Cusp);
        assert_eq!(kind(&cusp, 0.4), CurvePointKind::Regular);
        assert_eq!(kind(&space_cusp, 0.5), CurvePointKind::Regular);
        assert_eq!(kind(&flat, 0.5), CurvePointKind::Regular);
    }
}

#[test]
fn corners_and_turns_at_knots_are_told_apart() {
    let polyline = |points: &[[f64; 2]]| {
        let points: Vec<DVec3> = points.iter().map(|&[x, y]| DVec3::new(x, y, 0.0)).collect();
        NurbsCurve::polyline(&points).unwrap()
    };
    let square = polyline(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]]);
    for t in [0.0, 1.0, 2.0, 3.0, 4.0] {
        assert_eq!(kind(&square, t), CurvePointKind::Corner);
    }
    let back = polyline(&[[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [-1.0, 0.0]]);
    assert_eq!(kind(&back, 1.0), CurvePointKind::Cusp);
    assert_eq!(kind(&back, 2.0), CurvePointKind::Regular);
    assert_eq!(kind(&back, 0.0), CurvePointKind::Regular);
    // Two quarter circles that make an S: the bend changes its side at the knot.
    let h = std::f64::consts::FRAC_1_SQRT_2;
    let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [1.0, 2.0], [2.0, 2.0]];
    let points = points.map(|[x, y]| DVec3::new(x, y, 0.0));
    let knots = KnotVector::new(2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0]).unwrap();
    let s = NurbsCurve::rational(knots, &points, &[1.0, h, 1.0, h, 1.0]).unwrap();
    assert_eq!(kind(&s, 1.0), CurvePointKind::Inflection);
    near(beside(&s, 1.0, Side::Left).signed_curvature(DVec3::Z, 1e-9).unwrap(), 1.0);
    near(beside(&s, 1.0, Side::Right).signed_curvature(DVec3::Z, 1e-9).unwrap(), -1.0);
}

#[test]
fn lines_and_planes_are_the_same_at_every_scale() {
    let bent = [[0.0, 0.0, 0.0], [1.0, 1.01e-3, 0.0], [2.0, 0.0, 0.0], [3.0, 1.0, 0.0]];
    let on_a_line = [[0.1, 0.2, 0.3], [0.3, 0.6, 0.9], [0.2, 0.4, 0.6], [0.7, 1.4, 2.1]];
    let in_space = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0], [3.0, 1.0, 0.02]];
    for scale in SCALES {
        let verdict = |points: &[[f64; 3]]| {
            let curve = Curve::from(bezier(points, scale));
            (
                curve.is_straight(Tolerance::DEFAULT).unwrap(),
                curve.is_planar(Tolerance::DEFAULT).unwrap(),
            )
        };
        assert_eq!(verdict(&bent), (false, true));
        assert_eq!(verdict(&on_a_line), (true, true));
        assert_eq!(verdict(&in_space), (false, false));
        assert!(!bezier(&bent, scale).is_closed(Tolerance::DEFAULT.distance));
    }
    let point = Curve::from(NurbsCurve::bezier(&[DVec3::ONE]).unwrap());
    assert_eq!(point.is_straight(Tolerance::DEFAULT), Ok(true));
    assert_eq!(point.is_planar(Tolerance::DEFAULT), Ok(true));
}

#[test]
fn a_bend_in_the_plane_of_sight_has_no_side() {
    let arch = bezier(&[[0.0, 0.0, 0.0], [1.0, 0.0, 2.0], [2.0, 0.0, 0.0]], 1.0);
    let local = local(&arch, 0.5);
    assert!(matches!(
        local.signed_curvature(DVec3::Z, 1e-9),
        Err(GeomError::Local(LocalError::NoSide { .. }))
    ));
    near(local.signed_curvature(DVec3::Y, 1e-9).unwrap(), 2.0);
}
