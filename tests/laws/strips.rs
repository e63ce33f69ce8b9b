//! Laws of the strips that integrals over regions and faces go along: they fill the region, lie within it, and do not overlap.

use std::{
    f64::consts::{PI, TAU},
    sync::Arc,
};

use glam::{DAffine3, DQuat, DVec3};
use proptest::{collection::vec, prelude::ProptestConfig, prop_assert, proptest};
use virote_kernel::{
    AreaStrip, CircleForm, Cutter, Face, Frame, KnotVector, NurbsCurve, NurbsSurface, Region,
    RegionSide, Tolerance, find_integral,
};

const TOLERANCE: Tolerance = Tolerance::DEFAULT;

/// A closed curve of degree 3 around a place, through places on rays.
fn blob(x: f64, y: f64, radii: &[f64]) -> Region {
    let n = radii.len();
    let place = |i: usize| {
        let (angle, radius) = (TAU * i as f64 / n as f64, radii[i % n]);
        DVec3::new(x + radius * libm::cos(angle), y + radius * libm::sin(angle), 0.0)
    };
    let points: Vec<DVec3> = (0..n + 3).map(place).collect();
    let knots = KnotVector::uniform(3, points.len()).unwrap();
    Region::new(&NurbsCurve::polynomial(knots, &points).unwrap(), &[], TOLERANCE).unwrap()
}

fn disc(x: f64, y: f64, radius: f64) -> Region {
    let frame = Frame::XY.at(DVec3::new(x, y, 0.0));
    let circle = NurbsCurve::ellipse(frame, [radius; 2], CircleForm::NinePoint).unwrap();
    Region::new(&circle, &[], TOLERANCE).unwrap()
}

/// The integral of a function over strips.
fn integral(strips: &[AreaStrip<'_>], f: impl Fn(DVec3) -> f64) -> f64 {
    let of = |ends: [f64; 2], ask: &dyn Fn(f64) -> f64| {
        let found = find_integral(|x| Ok::<_, ()>(vec![ask(x)]), ends, 1e-11, 1e-13);
        found.unwrap().value[0]
    };
    let one = |strip: &AreaStrip<'_>| {
        let across = strip.across();
        of([0.0, 1.0], &|s| {
            let y = across.start() + across.length() * s * s * (3.0 - 2.0 * s);
            let places = strip.places_at(y);
            let within = places.windows(2).filter(|ends| ends[0] < ends[1]).map(|ends| {
                of([ends[0], ends[1]], &|x| {
                    let (point, stretch) = strip.at([x, y]);
                    stretch * f(point)
                })
            });
            6.0 * across.length() * s * (1.0 - s) * within.sum::<f64>()
        })
    };
    strips.iter().map(one).sum()
}

/// The area and the first moments, beside those by Green's theorem.
#[track_caller]
fn check(region: &Region) {
    let strips = region.area_strips().unwrap();
    let mass = region.mass();
    let found = integral(&strips, |_| 1.0);
    assert!(
        (found - mass.amount).abs() < 1e-9 * (1.0 + mass.amount),
        "{found}, not {}",
        mass.amount
    );
    for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
        let found = integral(&strips, |point| point.dot(axis));
        let expected = mass.amount * mass.centroid.dot(axis);
        assert!((found - expected).abs() < 1e-8 * (1.0 + mass.amount), "{found}, not {expected}");
    }
}

proptest! {
    // Each is four long sums.
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn strips_fill_what_boundaries_enclose(radii in vec(1.0..3.0_f64, 5..12), turn in 0.0..TAU, hole in 0.1..0.5_f64) {
        let whole = blob(0.0, 0.0, &radii);
        let holes = [disc(0.3, 0.1, hole), disc(2.2, 0.0, 0.7)];
        let parts = Region::difference(&[vec![whole], holes.to_vec()].concat(), TOLERANCE, 1).unwrap();
        let map = DAffine3::from_quat(DQuat::from_rotation_z(turn));
        for part in parts {
            check(&part.transformed(&map).unwrap());
        }
    }

    #[test]
    fn strips_lie_inside(radii in vec(1.0..3.0_f64, 5..9), across in 0.01..0.99_f64, along in 0.01..0.99_f64) {
        let region = blob(0.0, 0.0, &radii);
        for strip in region.strips().unwrap() {
            let y = strip.across().at(across);
            let [start, end] = strip.ends_at(y);
            let place = DVec3::new(start + along * (end - start), y, 0.0);
            prop_assert!(region.side_of(place, 1e-9) != RegionSide::Outside);
        }
    }
}

#[test]
fn straight_sides_along_x_and_corners_at_one_height_do_no_harm() {
    let polygon = |corners: &[[f64; 2]]| {
        let mut points: Vec<DVec3> = corners.iter().map(|&[x, y]| DVec3::new(x, y, 0.0)).collect();
        points.push(points[0]);
        Region::new(&NurbsCurve::polyline(&points).unwrap(), &[], TOLERANCE).unwrap()
    };
    // A comb, a saw, and a slot with straight sides.
    check(&polygon(&[
        [0., 0.],
        [5., 0.],
        [5., 3.],
        [4., 3.],
        [4., 1.],
        [3., 1.],
        [3., 3.],
        [2., 3.],
        [2., 1.],
        [1., 1.],
        [1., 3.],
        [0., 3.],
    ]));
    check(&polygon(&[[0., 0.], [1., 1.], [2., 0.], [3., 1.], [4., 0.], [4., 2.], [0., 2.]]));
    let slot = Region::union(
        &[
            disc(0.0, 0.0, 1.0),
            polygon(&[[0., -1.], [4., -1.], [4., 1.], [0., 1.]]),
            disc(4.0, 0.0, 1.0),
        ],
        TOLERANCE,
        1,
    )
    .unwrap();
    check(&slot[0]);
}

#[test]
fn a_sphere_divided_by_a_plane_has_the_moments_of_archimedes() {
    let sphere = Arc::new(NurbsSurface::sphere(Frame::XY, 2.0).unwrap());
    for normal in [DVec3::Z, DVec3::X, DVec3::new(1.0, 2.0, 3.0), DVec3::new(-1.0, 0.2, 0.1)] {
        let normal = normal.normalize();
        let plane = Frame::from_normal(normal * 0.5, normal, None).unwrap();
        let parts = Face::whole(Arc::clone(&sphere), TOLERANCE).unwrap();
        let parts = parts.split(&[Cutter::Plane(plane)], TOLERANCE).unwrap();
        for part in &parts {
            let is_cap = 0.5 < part.mass().unwrap().centroid.dot(normal);
            let strips = part.strips().unwrap();
            let (area, height) = if is_cap { (6.0 * PI, 1.25) } else { (10.0 * PI, -0.75) };
            let found = integral(&strips, |_| 1.0);
            assert!((found - area).abs() < 1e-5, "{found}, not {area}");
            let found = integral(&strips, |point| point.dot(normal));
            assert!((found - area * height).abs() < 1e-5, "{found}, not {}", area * height);
        }
        assert_eq!(parts.len(), 2);
    }
}
