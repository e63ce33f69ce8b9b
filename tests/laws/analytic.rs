//! Laws of recognition: what is a line, circle, plane, cylinder, cone, sphere or torus is told as
//! that in any place, size and form, and what is not quite one is not.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::{DAffine3, DMat3, DVec3, DVec4};
use proptest::{
    prelude::{Strategy, any},
    prop_assert, proptest,
};
use virote_kernel::{
    AnalyticCurve, AnalyticForm, AnalyticSurface, Axis, CircleForm, Direction, Frame, Grid,
    Interval, NurbsCurve, NurbsSurface, join,
};

/// Points of edges nearer than this are one.
const SAME: f64 = 1e-6;

/// A rotation, a uniform scale and a translation.
fn similarity() -> impl Strategy<Value = (DAffine3, f64)> {
    let axis = (-1.0..1.0, -1.0..1.0, 0.1..1.0).prop_map(|(x, y, z)| DVec3::new(x, y, z));
    (axis, -PI..PI, 0.01..100.0, -50.0..50.0, -50.0..50.0).prop_map(|(axis, angle, size, x, y)| {
        let turn = DMat3::from_axis_angle(axis.normalize(), angle);
        (DAffine3 { matrix3: turn * size, translation: DVec3::new(x, y, x - y) }, size)
    })
}

/// The same surface in another form.
fn refined(surface: &NurbsSurface, way: [bool; 6], at: f64) -> NurbsSurface {
    let mut surface = surface.clone();
    if way[0] {
        surface = surface.elevate_degree(Direction::U, surface.degree_u() + 1).unwrap();
    }
    if way[1] {
        surface = surface.elevate_degree(Direction::V, surface.degree_v() + 2).unwrap();
    }
    if way[2] {
        let knot = surface.domain_u().at(at);
        surface = surface.insert_knots(Direction::U, &[knot, knot]).unwrap();
    }
    if way[3] {
        surface = surface.insert_knots(Direction::V, &[surface.domain_v().at(at)]).unwrap();
    }
    if way[4] {
        surface = surface.reversed(Direction::V);
    }
    if way[5] {
        surface = surface.swapped();
    }
    surface
}

fn arc(center: DVec3, radius: f64, from: f64, sweep: f64) -> NurbsCurve {
    let frame = Frame::from_axes(center, DVec3::X, DVec3::Z).unwrap();
    NurbsCurve::arc(frame, radius, from, sweep).unwrap()
}

fn turned(profile: &NurbsCurve, angle: f64) -> NurbsSurface {
    NurbsSurface::revolved(profile, Axis::new(DVec3::ZERO, DVec3::Z).unwrap(), angle).unwrap()
}

fn circle(radius: f64, height: f64, form: CircleForm) -> NurbsCurve {
    NurbsCurve::circle(DVec3::Z * height, radius, DVec3::X, DVec3::Z, form).unwrap()
}

fn line(from: [f64; 3], to: [f64; 3]) -> NurbsCurve {
    NurbsCurve::line(DVec3::from_array(from), DVec3::from_array(to)).unwrap()
}

/// Surfaces of every kind, made in several ways, with what they are.
fn known() -> Vec<(NurbsSurface, AnalyticForm)> {
    let cone = |radius| AnalyticForm::Cone { radius, half_angle: libm::atan(0.75) };
    let plane = AnalyticForm::Plane;
    let sphere = AnalyticForm::Sphere { radius: 4.0 };
    let torus = AnalyticForm::Torus { major: 5.0, minor: 2.0 };
    let tube = AnalyticForm::Cylinder { radius: 3.0 };
    let up = DVec3::new(0.0, 0.0, 7.0);
    let mut known = vec![
        (NurbsSurface::sphere(Frame::XY, 4.0).unwrap(), sphere),
        (turned(&arc(DVec3::ZERO, 4.0, -1.0, 1.3), 5.0), sphere),
        (turned(&arc(DVec3::ZERO, 4.0, 0.3, FRAC_PI_2 - 0.3), -2.0), sphere),
        (NurbsSurface::cone(Frame::XY, [3.0; 2], 7.0).unwrap(), tube),
        (turned(&line([3.0, 0.0, 7.0], [3.0, 0.0, 1.0]), 3.0), tube),
        (NurbsSurface::cone(Frame::XY, [0.0, 3.0], 4.0).unwrap(), cone(0.0)),
        (NurbsSurface::cone(Frame::XY, [3.0, 0.0], 4.0).unwrap(), cone(0.0)),
        (turned(&line([5.0, 0.0, 1.0], [2.0, 0.0, 5.0]), 2.0), cone(2.0)),
        (turned(&line([2.0, 0.0, 5.0], [5.0, 0.0, 9.0]), -4.0), cone(2.0)),
        (NurbsSurface::torus(Frame::XY, 5.0, 2.0).unwrap(), torus),
        (turned(&arc(DVec3::X * 5.0, 2.0, 1.0, TAU), 1.0), torus),
        (turned(&arc(DVec3::X * 5.0, 2.0, 2.0, 3.0), 4.5), torus),
        (turned(&line([0.0; 3], [3.0, 0.0, 0.0]), TAU), plane),
        (turned(&line([1.0, 0.0, 0.0], [3.0, 0.0, 0.0]), 6.0), plane),
        (
            NurbsSurface::ruled(
                &NurbsCurve::arc(Frame::XY, 2.0, 0.0, PI).unwrap(),
                &line([2.0, 0.0, 0.0], [-2.0, 0.0, 0.0]),
            )
            .unwrap(),
            plane,
        ),
        (
            NurbsSurface::bilinear(
                DVec3::ZERO,
                DVec3::Y,
                DVec3::X * 3.0,
                DVec3::new(2.0, 4.0, 0.0),
            )
            .unwrap(),
            plane,
        ),
    ];
    for form in CircleForm::ALL {
        known.push((NurbsSurface::extruded(&circle(3.0, 0.0, form), up).unwrap(), tube));
        let [low, high] = [(2.0, 0.0), (5.0, 4.0)].map(|(radius, z)| circle(radius, z, form));
        known.push((NurbsSurface::ruled(&low, &high).unwrap(), cone(2.0)));
    }
    known
}

/// How far a point is from a surface with an equation, in its coordinates.
fn gap(form: AnalyticForm, p: DVec3) -> f64 {
    let out = libm::hypot(p.x, p.y);
    match form {
        AnalyticForm::Plane => p.z,
        AnalyticForm::Cylinder { radius } => out - radius,
        AnalyticForm::Cone { radius, half_angle } => {
            (out - radius) * libm::cos(half_angle) - p.z * libm::sin(half_angle)
        }
        AnalyticForm::Sphere { radius } => p.length() - radius,
        AnalyticForm::Torus { major, minor } => libm::hypot(out - major, p.z) - minor,
    }
}

/// Which side is outward there.
fn outward(form: AnalyticForm, p: DVec3) -> DVec3 {
    let out = DVec3::new(p.x, p.y, 0.0).normalize();
    match form {
        AnalyticForm::Plane => DVec3::Z,
        AnalyticForm::Cylinder { .. } => out,
        AnalyticForm::Cone { half_angle, .. } => {
            out * libm::cos(half_angle) - DVec3::Z * libm::sin(half_angle)
        }
        AnalyticForm::Sphere { .. } => p.normalize(),
        AnalyticForm::Torus { major, .. } => (p - out * major).normalize(),
    }
}

fn sizes(form: AnalyticForm) -> [f64; 2] {
    match form {
        AnalyticForm::Plane => [0.0; 2],
        AnalyticForm::Cylinder { radius } | AnalyticForm::Sphere { radius } => [radius, 0.0],
        AnalyticForm::Cone { radius, .. } => [radius, 0.0],
        AnalyticForm::Torus { major, minor } => [major, minor],
    }
}

/// Whether points, sides and the start are as they are told.
fn is_as_told(surface: &NurbsSurface, found: &AnalyticSurface) -> bool {
    let map = found.frame.from_space();
    let allowed = 1e-12 * surface.bounds().magnitude();
    let mut is_so = true;
    for u in surface.domain_u().steps(8) {
        for v in surface.domain_v().steps(8) {
            let local = map.transform_point3(surface.point_at(u, v));
            is_so &= gap(found.form, local).abs() < allowed;
        }
    }
    let (u, v) = (surface.domain_u().at(0.37), surface.domain_v().at(0.61));
    let local = map.transform_point3(surface.point_at(u, v));
    let side = map.transform_vector3(surface.normal_at(u, v).unwrap());
    let side = side.dot(outward(found.form, local));
    is_so &= (side - if found.is_outward { 1.0 } else { -1.0 }).abs() < 1e-9;
    if found.form == AnalyticForm::Plane {
        return is_so;
    }
    // Around the axis it goes on from the half plane of x.
    let corners = [0.0, 1.0].map(|f| {
        map.transform_point3(surface.point_at(surface.domain_u().at(f), surface.domain_v().at(f)))
    });
    let angle = |p: DVec3| libm::atan2(p.y, p.x).abs();
    is_so && corners.into_iter().any(|p| libm::hypot(p.x, p.y) < allowed || angle(p) < 1e-9)
}

proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig::with_cases(32))]

    #[test]
    fn surfaces_are_recognised_in_any_place_size_and_form(
        (map, size) in similarity(),
        way in any::<[bool; 6]>(),
        at in 0.1..0.9,
    ) {
        for (surface, form) in known() {
            let surface = refined(&surface, way, at).transformed(&map);
            let found = surface.analytic(SAME * size);
            prop_assert!(found.is_some(), "{form:?} {way:?}");
            let Some(found) = found else { continue };
            prop_assert!(
                std::mem::discriminant(&found.form) == std::mem::discriminant(&form),
                "{form:?} {found:?}"
            );
            for (got, expected) in sizes(found.form).into_iter().zip(sizes(form)) {
                let large = surface.bounds().magnitude();
                prop_assert!((got - expected * size).abs() < 1e-12 * large, "{form:?} {found:?}");
            }
            prop_assert!(is_as_told(&surface, &found), "{form:?} {found:?} {way:?}");
        }
    }

    #[test]
    fn pieces_are_recognised_too(
        from in 0.0..0.6,
        width in 0.05..0.4,
        way in any::<[bool; 6]>(),
    ) {
        for (surface, form) in known() {
            let surface = refined(&surface, way, 0.4);
            let part = [Direction::U, Direction::V].into_iter().fold(surface, |part, along| {
                let domain = part.domain(along);
                let ends = [from, from + width].map(|fraction| domain.at(fraction));
                part.trimmed(along, Interval::new(ends[0], ends[1]).unwrap()).unwrap()
            });
            let found = part.analytic(SAME);
            prop_assert!(found.is_some(), "{form:?} {way:?}");
            let Some(found) = found else { continue };
            prop_assert!(
                std::mem::discriminant(&found.form) == std::mem::discriminant(&form),
                "{form:?} {found:?}"
            );
            prop_assert!(is_as_told(&part, &found), "{form:?} {found:?}");
        }
    }

    #[test]
    fn lines_and_arcs_are_recognised_in_any_place_size_and_form(
        (map, size) in similarity(),
        turn in 0.1..TAU,
        at in 0.1..0.9,
    ) {
        let form = |curve: NurbsCurve| {
            let elevated = curve.elevate_degree(curve.degree() + 1).unwrap();
            elevated.insert_knots(&[elevated.domain().at(at)]).unwrap().transformed(&map)
        };
        let arc = form(NurbsCurve::arc(Frame::XY, 3.0, 0.7, turn).unwrap());
        let Some(AnalyticCurve::Circle { frame, radius, turn: found }) = arc.analytic() else {
            return Err(proptest::test_runner::TestCaseError::fail("no arc"));
        };
        let large = arc.bounds().magnitude();
        prop_assert!((radius - 3.0 * size).abs() < 1e-12 * large);
        prop_assert!((found - turn).abs() < 1e-9);
        let places = [0.0, found].map(|angle| {
            let place = DVec3::new(libm::cos(angle), libm::sin(angle), 0.0) * radius;
            frame.point(place)
        });
        prop_assert!(places[0].distance(arc.start()) < 1e-12 * large);
        prop_assert!(places[1].distance(arc.end()) < 1e-9 * size);
        let line = form(line([1.0, 2.0, 3.0], [4.0, 6.0, 3.0]));
        let Some(AnalyticCurve::Line { start, direction, length }) = line.analytic() else {
            return Err(proptest::test_runner::TestCaseError::fail("no line"));
        };
        prop_assert!((length - 5.0 * size).abs() < 1e-12 * line.bounds().magnitude());
        let end = start + direction * length;
        prop_assert!(end.distance(line.end()) < 1e-12 * line.bounds().magnitude());
    }
}

/// The same with one control point moved or weighted otherwise.
fn changed(surface: &NurbsSurface, [row, column]: [usize; 2], by: DVec4) -> NurbsSurface {
    let net = surface.control_points();
    let moved = Grid::from_fn(net.n_rows(), net.n_columns(), |i, j| {
        let point = net.get(i, j);
        if [i, j] == [row, column] { point + by * point.w } else { point }
    });
    NurbsSurface::new(surface.knots_u().clone(), surface.knots_v().clone(), moved).unwrap()
}

#[track_caller]
fn is_none_of_them(surface: &NurbsSurface) {
    assert_eq!(surface.analytic(SAME), None);
}

#[test]
fn a_control_point_moved_by_a_ten_millionth_is_seen() {
    for (surface, form) in known() {
        let net = surface.control_points();
        for place in [[0, 0], [net.n_rows() / 2, net.n_columns() / 2], [1, net.n_columns() - 1]] {
            for by in [DVec4::X, DVec4::Y, DVec4::Z] {
                let moved = changed(&surface, place, by * 1e-7);
                let is_in_plane = form == AnalyticForm::Plane && by != DVec4::Z;
                // What moves along the surface, or with a seam's half, is another matter.
                if let Some(found) = moved.analytic(SAME) {
                    assert!(is_in_plane && is_as_told(&moved, &found), "{form:?} {place:?} {by}");
                }
            }
        }
    }
}

#[test]
fn a_weight_changed_by_a_ten_millionth_is_seen() {
    let cone = NurbsSurface::cone(Frame::XY, [2.0, 5.0], 4.0).unwrap();
    let net = cone.control_points();
    for place in [[1, 0], [3, 1]] {
        let weight = net.get(place[0], place[1]);
        is_none_of_them(&changed(&cone, place, DVec4::W * (1e-7 / weight.w)));
    }
}

#[test]
fn ellipsoids_and_the_like_are_none_of_them() {
    let flatten = DAffine3::from_scale(DVec3::new(1.0, 1.0, 1.0 + 1e-9));
    for (surface, form) in known() {
        if !matches!(form, AnalyticForm::Sphere { .. } | AnalyticForm::Torus { .. }) {
            continue;
        }
        is_none_of_them(&surface.transformed(&flatten));
    }
    let widen = DAffine3::from_scale(DVec3::new(1.0, 1.0 + 1e-9, 1.0));
    for (surface, form) in known() {
        if form != AnalyticForm::Plane {
            is_none_of_them(&surface.transformed(&widen));
        }
    }
}

#[test]
fn a_hyperboloid_is_no_cone() {
    let turn = DAffine3::from_axis_angle(DVec3::Z, 0.3);
    let low = circle(3.0, 0.0, CircleForm::NinePoint);
    let high = circle(3.0, 5.0, CircleForm::NinePoint).transformed(&turn);
    is_none_of_them(&NurbsSurface::ruled(&low, &high).unwrap());
}

#[test]
fn what_covers_its_quadric_twice_is_no_face_of_it() {
    let ring = circle(3.0, 0.0, CircleForm::NinePoint);
    let twice = join(&[ring.clone(), ring.clone()], SAME).unwrap();
    assert_eq!(twice.analytic(), None);
    is_none_of_them(&NurbsSurface::extruded(&twice, DVec3::Z).unwrap());
    let wider = twice.transformed(&DAffine3::from_scale(DVec3::splat(2.0)));
    is_none_of_them(&NurbsSurface::ruled(&twice, &wider).unwrap());
    let there_and_back = join(&[ring.clone(), ring.reversed()], SAME).unwrap();
    assert_eq!(there_and_back.analytic(), None);
    is_none_of_them(&NurbsSurface::extruded(&there_and_back, DVec3::Z).unwrap());
}

#[test]
fn what_turns_back_is_no_face_of_it() {
    let [a, b, c] = [0.0, 3.0, 1.0].map(|x| DVec3::X * x);
    let fold = NurbsCurve::bezier(&[a, b, c]).unwrap();
    assert_eq!(fold.analytic(), None);
    is_none_of_them(&NurbsSurface::extruded(&fold, DVec3::Y).unwrap());
    is_none_of_them(&turned(&fold.transformed(&DAffine3::from_translation(DVec3::X)), 2.0));
    let upright = DAffine3::from_mat3_translation(
        DMat3::from_cols(DVec3::Z, DVec3::Y, DVec3::X),
        DVec3::X * 2.0,
    );
    is_none_of_them(&turned(&fold.transformed(&upright), 2.0));
    let bow = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]];
    let [a, b, c, d] = bow.map(|[x, y]| DVec3::new(x, y, 0.0));
    is_none_of_them(&NurbsSurface::bilinear(a, b, c, d).unwrap());
}

#[test]
fn a_double_cone_and_a_spindle_are_none_of_them() {
    is_none_of_them(&turned(&line([-2.0, 0.0, -2.0], [3.0, 0.0, 3.0]), TAU));
    is_none_of_them(&NurbsSurface::torus(Frame::XY, 2.0, 3.0).unwrap());
    is_none_of_them(&NurbsSurface::torus(Frame::XY, 2.0, 2.0).unwrap());
}

#[test]
fn a_disc_that_is_almost_flat_is_no_part_of_a_huge_sphere() {
    for rise in [1e-5, 1e-6, 1e-7, 1e-8] {
        let slope = line([1.0, 0.0, 0.0], [2.0, 0.0, rise]);
        let found = turned(&slope, TAU).analytic(SAME).map(|found| found.form);
        assert!(matches!(found, None | Some(AnalyticForm::Cone { .. })), "{found:?}");
    }
}

#[test]
fn what_is_no_wider_than_points_that_are_one_is_none_of_them() {
    is_none_of_them(&NurbsSurface::torus(Frame::XY, 1.0, 0.5 * SAME).unwrap());
    is_none_of_them(&NurbsSurface::cone(Frame::XY, [0.5 * SAME; 2], 1.0).unwrap());
}

#[test]
fn numbers_are_those_of_the_script() {
    let frame = Frame::XY.at(DVec3::new(30.0, 0.1, -7.0));
    let ball = NurbsSurface::sphere(frame, 4.3).unwrap();
    let found = ball.analytic(SAME).unwrap();
    assert_eq!(found.form, AnalyticForm::Sphere { radius: 4.3 });
    assert_eq!(found.frame.origin(), frame.origin());
    assert_eq!([found.frame.x(), found.frame.z()], [DVec3::X, DVec3::Z]);
}
