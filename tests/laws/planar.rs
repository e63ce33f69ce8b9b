//! Laws of meshes of plane regions.

use std::collections::BTreeMap;

use glam::{DVec2, DVec3};
use proptest::{collection::vec, prop_assert, prop_assume, proptest};
use virote_kernel::{Frame, GeomError, Mesh, PictureError, planar_mesh};

use crate::some::point;

/// A star around a centre: a corner for each radius.
fn star(center: DVec2, radii: &[f64]) -> Vec<DVec2> {
    let n = radii.len() as f64;
    let corner = |(i, radius): (usize, &f64)| {
        center + DVec2::from_angle(std::f64::consts::TAU * i as f64 / n) * *radius
    };
    radii.iter().enumerate().map(corner).collect()
}

fn area(polygon: &[DVec2]) -> f64 {
    let n = polygon.len();
    0.5 * (0..n).map(|i| polygon[i].perp_dot(polygon[(i + 1) % n])).sum::<f64>()
}

/// In space, in a plane that is askew.
fn placed(polygon: &[DVec2], frame: &Frame) -> Vec<DVec3> {
    polygon.iter().map(|p| frame.origin() + frame.x() * p.x + frame.y() * p.y).collect()
}

/// The triangles behind each side, by their corners in order.
fn sides(mesh: &Mesh) -> BTreeMap<(u32, u32), u32> {
    let turns = mesh.triangles().iter().flat_map(|&[a, b, c]| [(a, b, c), (b, c, a), (c, a, b)]);
    turns.map(|(a, b, c)| ((a, b), c)).collect()
}

proptest! {
    #[test]
    fn a_region_is_covered_once_by_triangles_that_are_no_slivers_where_others_would_do(
        outer in vec(5.0..9.0, 5..=40), hole in vec(0.2..0.9, 3..=20), other in vec(0.2..0.9, 3..=20),
        origin in point(), normal in point(),
    ) {
        prop_assume!(normal.length() > 0.1);
        let frame = Frame::from_normal(origin, normal, None).unwrap();
        let polygons = [
            star(DVec2::ZERO, &outer), star(DVec2::new(1.5, 0.3), &hole), star(DVec2::new(-1.5, 0.0), &other),
        ];
        // A star of few corners may not reach around its holes.
        prop_assume!(outer.len() > 7);
        let placed: Vec<Vec<DVec3>> = polygons.iter().map(|polygon| placed(polygon, &frame)).collect();
        let mesh = planar_mesh(&placed, 1e-6).unwrap();

        // As many triangles as Euler says, on the borders' vertices, all the same way up.
        let n: usize = polygons.iter().map(Vec::len).sum();
        prop_assert!(mesh.n_vertices() == n && mesh.triangles().len() == n + 2);
        let expected = area(&polygons[0]) - area(&polygons[1]) - area(&polygons[2]);
        let products = mesh.corners().map(|[a, b, c]| 0.5 * (b - a).cross(c - a).dot(frame.z()));
        let products: Vec<f64> = products.collect();
        prop_assert!(products.iter().all(|&product| 0.0 < product));
        prop_assert!((products.iter().sum::<f64>() - expected).abs() < 1e-11 * expected);

        // Sides of the borders have one triangle, all others two, and no circle of three corners
        // holds the fourth: Delaunay.
        let sides = sides(&mesh);
        let is_border = |a: u32, b: u32| {
            let mut first = 0;
            polygons.iter().any(|polygon| {
                let n = polygon.len() as u32;
                let own = first..first + n;
                first += n;
                own.contains(&a) && own.contains(&b) && {
                    let (i, k) = (a - own.start, b - own.start);
                    (i + 1) % n == k || (k + 1) % n == i
                }
            })
        };
        let at = |i: u32| mesh.vertices()[i as usize];
        for (&(a, b), &c) in &sides {
            let Some(&d) = sides.get(&(b, a)) else {
                prop_assert!(is_border(a, b));
                continue;
            };
            prop_assert!(!is_border(a, b));
            let angle = |tip: u32| (at(a) - at(tip)).angle_between(at(b) - at(tip));
            prop_assert!(angle(c) + angle(d) < std::f64::consts::PI + 1e-6);
        }
    }
}

#[test]
fn a_region_with_ten_thousand_corners_is_no_matter() {
    let radii: Vec<f64> = (0..10_000).map(|i| 1.0 + 0.1 * libm::sin(f64::from(i))).collect();
    let polygon = star(DVec2::ZERO, &radii);
    let mesh = planar_mesh(&[placed(&polygon, &Frame::XY)], 1e-6).unwrap();
    assert_eq!(mesh.triangles().len(), 9998);
    assert!((mesh.area() - area(&polygon)).abs() < 1e-10);
}

#[test]
fn borders_that_cross_by_far_or_by_a_hair_are_told() {
    let square = |x: f64, side: f64| {
        let corners = [[x, 0.0], [x + side, 0.0], [x + side, side], [x, side]];
        corners.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec()
    };
    let crossing = |polygons: &[Vec<DVec3>]| {
        matches!(
            planar_mesh(polygons, 1e-6),
            Err(GeomError::Picture(PictureError::Crossing { .. } | PictureError::Outside { .. }))
        )
    };
    assert!(crossing(&[square(0.0, 4.0), square(3.0, 2.0)]));
    assert!(crossing(&[square(0.0, 4.0), square(1e-17, 1.0)]));
    let bow = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.2]];
    assert!(crossing(&[bow.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec()]));
}

/// A strip is an area where it is wider than the distance, however large it is.
#[test]
fn a_strip_narrower_than_the_distance_has_no_area() {
    for (length, distance) in [(1e-3, 1e-9), (1.0, 1e-6), (50.0, 0.1)] {
        let strip = |width: f64| {
            let corner = |x: f64, y: f64| DVec3::new(x, y, 0.0);
            let corners =
                [corner(0.0, 0.0), corner(length, 0.0), corner(length, width), corner(0.0, width)];
            planar_mesh(&[corners.to_vec()], distance)
        };
        let mesh = strip(1.1 * distance).unwrap();
        assert!((mesh.area() / (1.1 * distance * length) - 1.0).abs() < 1e-9, "{length}");
        let square = strip(length).unwrap();
        assert!((square.area() / (length * length) - 1.0).abs() < 1e-12, "{length}");
        let refused = strip(0.9 * distance);
        let no_area = GeomError::Picture(PictureError::NoArea { index: 0, of: 1 });
        assert_eq!(refused.err(), Some(no_area), "{length}");
    }
}

/// Which corner comes first does not decide whether a sliver is an area: its height is to be twice the distance.
#[test]
fn a_sliver_has_an_area_or_none_whichever_corner_is_first() {
    for (height, has_area) in [(1.8e-3, false), (2.2e-3, true)] {
        let mut corners = [DVec3::ZERO, DVec3::X, DVec3::new(0.5, height, 0.0)];
        for first in 0..3 {
            let found = planar_mesh(&[corners.to_vec()], 1e-3);
            assert_eq!(found.is_ok(), has_area, "{height} from corner {first}");
            corners.rotate_left(1);
        }
    }
}
