//! Laws of what two surfaces have in common: on both, complete, and the same either way around.

use std::sync::Arc;

use glam::{DAffine3, DMat3, DQuat, DVec3};
use proptest::{collection::vec, prelude::*, prop_assert, prop_assume, proptest};
use virote_kernel::{Direction, Grid, LevelSet, NurbsSurface, Surface, Tolerance};

use crate::some::{fraction, point, sphere};

const TOLERANCE: f64 = 1e-6;

/// Places along a side of the unit square where heights are compared.
const PLACES: usize = 24;

fn common(a: &NurbsSurface, b: &NurbsSurface) -> LevelSet {
    let [first, second] = [a, b].map(|surface| Surface::Nurbs(Arc::new(surface.clone())));
    let set = first.intersections(&second, Tolerance::DEFAULT).unwrap();
    for curve in &set.curves {
        for p in curve.sample(40) {
            assert!(a.closest(p).distance <= TOLERANCE, "{p} is off the first");
            assert!(b.closest(p).distance <= TOLERANCE, "{p} is off the second");
        }
    }
    set
}

fn total(set: &LevelSet) -> f64 {
    set.curves.iter().map(|curve| curve.length(curve.domain())).sum()
}

/// A bicubic height over the unit square: x = u, y = v.
fn heights(values: &[f64]) -> NurbsSurface {
    let points =
        Grid::from_fn(4, 4, |i, j| DVec3::new(i as f64 / 3.0, j as f64 / 3.0, values[4 * i + j]));
    NurbsSurface::bezier(&points).unwrap()
}

/// Where one height crosses another along a line between two places of the square, if their order
/// differs there.
fn crossing(a: &NurbsSurface, b: &NurbsSurface, ends: [[f64; 2]; 2]) -> Option<DVec3> {
    let at = |f: f64| [0, 1].map(|i| ends[0][i] * (1.0 - f) + ends[1][i] * f);
    let above = |f: f64| {
        let [u, v] = at(f);
        a.point_at(u, v).z - b.point_at(u, v).z
    };
    let (start, end) = (above(0.0), above(1.0));
    if 0.0 <= start * end {
        return None;
    }
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if (above(middle) < 0.0) == (start < 0.0) {
            low = middle;
        } else {
            high = middle;
        }
    }
    let [u, v] = at(low);
    Some(a.point_at(u, v))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10))]

    #[test]
    fn wherever_heights_change_their_order_there_is_a_curve(
        first in vec(-0.5..0.5f64, 16),
        second in vec(-0.5..0.5f64, 16),
    ) {
        let (a, b) = (heights(&first), heights(&second));
        let set = common(&a, &b);
        let place = |i: usize| i as f64 / PLACES as f64;
        for i in 0..=PLACES {
            for j in 0..PLACES {
                let (s, t, next) = (place(i), place(j), place(j + 1));
                for ends in [[[s, t], [s, next]], [[t, s], [next, s]]] {
                    let Some(p) = crossing(&a, &b, ends) else { continue };
                    let nearest = set.curves.iter().map(|curve| curve.closest(p, TOLERANCE).distance);
                    let nearest = nearest.fold(f64::INFINITY, f64::min);
                    // A curve along both surfaces may be beside the place where they are close.
                    prop_assert!(nearest <= 1e-4, "{p} is {nearest} from all curves");
                }
            }
        }
    }

    #[test]
    fn it_does_not_matter_which_comes_first(
        first in vec(-0.5..0.5f64, 16),
        second in vec(-0.5..0.5f64, 16),
    ) {
        let (a, b) = (heights(&first), heights(&second));
        let (one, other) = (common(&a, &b), common(&b, &a));
        prop_assert!((total(&one) - total(&other)).abs() <= 1e-4);
    }

    #[test]
    fn it_moves_with_the_surfaces(
        first in vec(-0.5..0.5f64, 16),
        second in vec(-0.5..0.5f64, 16),
        axis in point(),
        f in fraction(),
    ) {
        prop_assume!(0.1 < axis.length());
        let map = DAffine3 {
            matrix3: DMat3::from_quat(DQuat::from_axis_angle(axis.normalize(), 6.0 * f)),
            translation: axis,
        };
        let (a, b) = (heights(&first), heights(&second));
        let (still, moved) = (common(&a, &b), common(&a.transformed(&map), &b.transformed(&map)));
        prop_assert!((total(&still) - total(&moved)).abs() <= 1e-4);
    }

    #[test]
    fn spheres_cross_in_a_circle_or_not_at_all(way in point(), f in 0.05..1.5f64) {
        prop_assume!(0.1 < way.length() && 1e-3 < (f - 1.0).abs());
        let apart = 10.0 * f;
        let set = common(&sphere(DVec3::ZERO, 5.0), &sphere(way.normalize() * apart, 5.0));
        let squared = 25.0 - 0.25 * apart * apart;
        let around = if squared < 0.0 { 0.0 } else { std::f64::consts::TAU * squared.sqrt() };
        prop_assert!((total(&set) - around).abs() <= 1e-4, "{} of {around}", total(&set));
        prop_assert!(set.touches.is_empty() && set.uncertain.is_empty());
    }

    #[test]
    fn spheres_that_touch_do_so_in_a_point(way in point(), f in 0.2..3.0f64) {
        prop_assume!(0.1 < way.length());
        let direction = way.normalize();
        let set = common(&sphere(DVec3::ZERO, 2.0), &sphere(direction * (2.0 + f), f));
        prop_assert_eq!(set.curves.len(), 0);
        prop_assert_eq!(set.touches.len(), 1);
        prop_assert!(set.touches[0].distance(direction * 2.0) <= 1e-5);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn neighbours_meet_in_the_edge_that_they_share(
        heights in vec(-0.5..0.5f64, 16), f in 0.1..0.9f64, along_u in 0..2,
    ) {
        let net = Grid::from_fn(4, 4, |i, j| DVec3::new(i as f64, j as f64, heights[4 * i + j]));
        let along = if along_u == 0 { Direction::U } else { Direction::V };
        let [a, b] = NurbsSurface::bezier(&net).unwrap().split(along, f).unwrap();
        let edge = if along_u == 0 { a.isocurve_u(f) } else { a.isocurve_v(f) };
        let found = Surface::from(a).intersections(&b.into(), Tolerance::DEFAULT).unwrap();
        prop_assert!(found.curves.len() == 1 && found.touches.is_empty() && found.uncertain.is_empty());
        prop_assert!(found.curves[0].degree() == edge.degree());
        for point in found.curves[0].sample(20) {
            prop_assert!(edge.closest(point, 1e-9).distance < 1e-12);
        }
    }
}

/// The sphere of radius 1 and z = 1 + 2xy touch at (0, 0, 1) and cross there: x² + y² + 4xy(1 + xy) = 0
/// has two loops through it.
#[test]
fn loops_through_a_pole_end_there_as_they_do_elsewhere() {
    let saddle = Grid::from_fn(3, 3, |i, j| {
        let (x, y) = (i as f64 - 1.0, j as f64 - 1.0);
        DVec3::new(x, y, 1.0 + 2.0 * x * y)
    });
    let saddle = Surface::from(NurbsSurface::bezier(&saddle).unwrap());
    let pole = DVec3::Z;
    for turn in [0.0, 0.3] {
        let tilt = DAffine3::from_rotation_x(turn);
        let sphere = Surface::from(sphere(DVec3::ZERO, 1.0).transformed(&tilt));
        let found = sphere.intersections(&saddle, Tolerance::DEFAULT).unwrap();
        assert_eq!(found.curves.len(), 2, "turned by {turn}");
        for curve in found.curves {
            assert!(curve.start().distance(pole) < 1e-5 && curve.end().distance(pole) < 1e-5);
            for DVec3 { x, y, .. } in curve.sample(50) {
                assert!((x * x + y * y + 4.0 * x * y * (1.0 + x * y)).abs() < 1e-5);
            }
        }
    }
}

#[test]
fn a_surface_runs_together_with_itself() {
    let sphere = Surface::from(sphere(DVec3::ZERO, 3.0));
    assert!(sphere.intersections(&sphere, Tolerance::DEFAULT).is_err());
}

/// x′ = (u − ½)² − ε² turns back between u = ½ ± ε.
#[test]
fn a_fold_narrower_than_any_grid_is_found() {
    let e = 1e-4;
    let power = [-1.0 / 24.0, 0.25 - e * e, -0.5, 1.0 / 3.0];
    let x = [
        power[0],
        power[0] + power[1] / 3.0,
        power[0] + power[1] * (2.0 / 3.0) + power[2] / 3.0,
        power.iter().sum(),
    ];
    let net = Grid::from_fn(4, 2, |i, j| DVec3::new(x[i], j as f64, 0.0));
    let surface = Surface::from(NurbsSurface::bezier(&net).unwrap());
    let folds = surface.defects(Tolerance::DEFAULT).unwrap().folds;
    assert!(!folds.is_empty());
    assert!(folds.iter().all(|[u, _]| ((u - 0.5).abs() - e).abs() < 1e-9), "{folds:?}");
}
