//! Laws of what two surfaces have in common: on both, complete, and the same either way around.

use std::sync::Arc;

use glam::{DAffine3, DMat3, DQuat, DVec3};
use proptest::{collection::vec, prelude::*, prop_assert, prop_assume, proptest};
use virote::kernel::{Grid, LevelSet, NurbsSurface, Surface, Tolerance};

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
