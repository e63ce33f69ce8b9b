//! Surfaces that cross beside an edge of one, nearer than the tolerance or just so, over its length or in a part of
//! it; and edges and corners that lie on another surface within the tolerance and do not cross it.
//!
//! A sheet climbs from its edge by a slope m, the edge is at heights h₀ and h₁ over a plate at its ends. Where the height
//! h₀ + (h₁ − h₀) v + m u is zero both cross: in a line from edge to edge that the heights tell.

use std::sync::Arc;

use virote_kernel::{
    Direction, FunctionFailure, Grid, Interval, LevelSet, NurbsSurface, ParametricSurface, Surface,
    SurfaceFunction, Tolerance,
    glam::{DAffine3, DVec3},
};

use crate::crossing_turned::{fractions, orientations, turn};

const TOLERANCE: Tolerance = Tolerance::DEFAULT;

/// Cases of an orientation.
const N_CASES: u64 = 2;

/// What a case has by its number: the slope, and sizes of the heights at both ends of the edge.
fn slope_and_heights(n: u64) -> (f64, [f64; 2]) {
    let [a, b, c, ..] = fractions(n);
    let power = |from: f64, to: f64, share: f64| libm::pow(10.0, from + (to - from) * share);
    (power(-4.0, 0.0, a), [power(-8.5, -5.3, b), power(-8.5, -5.3, c)])
}

fn placement(n: u64) -> DAffine3 {
    let [x, y, z, ..] = fractions(n + 1000);
    DAffine3::from_translation(DVec3::new(x, -2.0 * y, z)) * turn(n)
}

/// A unit square that climbs along x from its edge x = 0.
fn sheet(slope: f64, [h0, h1]: [f64; 2]) -> NurbsSurface {
    let at = |x: f64, y: f64, height: f64| DVec3::new(x, y, height + slope * x);
    NurbsSurface::bilinear(at(0.0, 0.0, h0), at(0.0, 1.0, h1), at(1.0, 0.0, h0), at(1.0, 1.0, h1))
        .unwrap()
}

/// The same as a function.
#[derive(Debug)]
struct Sheet {
    slope: f64,
    heights: [f64; 2],
    place: DAffine3,
}

impl SurfaceFunction for Sheet {
    fn derivatives_at(&self, u: f64, v: f64, order: usize) -> Result<Grid<DVec3>, FunctionFailure> {
        let [h0, h1] = self.heights;
        let rise = h1 - h0;
        let place = self.place;
        Ok(Grid::from_fn(order + 1, order + 1, |k, l| match (k, l) {
            (0, 0) => place.transform_point3(DVec3::new(u, v, h0 + rise * v + self.slope * u)),
            (1, 0) => place.transform_vector3(DVec3::new(1.0, 0.0, self.slope)),
            (0, 1) => place.transform_vector3(DVec3::new(0.0, 1.0, rise)),
            _ => DVec3::ZERO,
        }))
    }
}

/// A plate about all of it at height zero, flat or of nine points.
fn plate(n: u64, place: DAffine3) -> Surface {
    let at = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    let flat =
        NurbsSurface::bilinear(at(-3.0, -3.0), at(-3.0, 3.0), at(3.0, -3.0), at(3.0, 3.0)).unwrap();
    let raised = || {
        let along_u = flat.elevate_degree(Direction::U, 1).unwrap();
        along_u.elevate_degree(Direction::V, 1).unwrap()
    };
    let plate = if n.is_multiple_of(2) { flat.clone() } else { raised() };
    plate.transformed(&place).into()
}

fn sheets(slope: f64, heights: [f64; 2], place: DAffine3) -> [Surface; 2] {
    let function = Sheet { slope, heights, place };
    let unit = Interval::UNIT;
    let function = ParametricSurface::new(unit, unit, Arc::new(function)).unwrap();
    [sheet(slope, heights).transformed(&place).into(), function.into()]
}

fn length(found: &LevelSet) -> f64 {
    found.curves.iter().map(|curve| curve.length(curve.domain())).sum()
}

/// Sheets with edges at such heights cross the plate in one curve as long as heights and slope tell.
#[track_caller]
fn check(heights: impl Fn([f64; 2]) -> [f64; 2], expected: impl Fn([f64; 2], f64) -> f64) {
    for n in 0..N_CASES * orientations() {
        let (slope, sizes) = slope_and_heights(n);
        let (place, heights) = (placement(n), heights(sizes));
        let expected = expected(heights, slope);
        for surface in sheets(slope, heights, place) {
            let found = surface.intersections(&plate(n, place), TOLERANCE).unwrap();
            assert_eq!(found.curves.len(), 1, "{n}");
            assert!((length(&found) - expected).abs() < 1e-5, "{n}: {} {expected}", length(&found));
            assert!(found.touches.is_empty() && found.contacts.is_empty(), "{n}: {found:?}");
        }
    }
}

/// The ends of the line are in the sheet.
#[test]
fn a_curve_along_an_edge_is_told_however_near() {
    check(|[h0, h1]| [-h0, -h1], |[h0, h1], slope| libm::hypot(1.0, (h1 - h0) / slope));
}

#[test]
fn a_curve_that_cuts_off_a_corner_is_told_however_near() {
    check(|[h0, h1]| [-h0, h1], |[h0, h1], slope| libm::hypot(h0 / (h0 - h1), h0 / slope));
}

/// A place of such a curve found just beyond the edge is far from the curve's end.
#[test]
fn a_curve_that_leaves_a_surface_at_a_small_angle_is_told_once() {
    let place = DAffine3::from_translation(DVec3::X * 0.09);
    let at = |x: f64, y: f64, z: f64| place.transform_point3(DVec3::new(x, y, z));
    let [low, high] = [-5.1e-9, 1.1e-8];
    let sheet = NurbsSurface::bilinear(
        at(0.0, 0.0, low),
        at(0.0, 1.0, high),
        at(1.0, 0.0, 0.14),
        at(1.0, 1.0, 0.14),
    );
    let found = Surface::from(sheet.unwrap()).intersections(&plate(0, place), TOLERANCE).unwrap();
    assert_eq!(found.curves.len(), 1);
    assert!((length(&found) - low / (low - high)).abs() < 1e-9, "{}", length(&found));
}

#[test]
fn an_edge_that_does_not_reach_the_other_surface_within_the_tolerance_is_told() {
    for n in 0..N_CASES * orientations() {
        let (slope, [h0, h1]) = slope_and_heights(n);
        // Farther than a spline may be from the function that it stands in for.
        let [h0, h1] = [h0.max(2e-8), h1.max(2e-8)];
        let place = placement(n);
        for surface in sheets(slope, [h0, h1], place) {
            let found = surface.intersections(&plate(n, place), TOLERANCE).unwrap();
            assert!(found.curves.is_empty(), "{n}: {found:?}");
            let told: Vec<DVec3> = found.contacts.iter().chain(&found.touches).copied().collect();
            let heights = told.iter().map(|&point| place.inverse().transform_point3(point).z);
            assert!(heights.into_iter().all(|height| height.abs() <= 1.001e-6), "{n}: {told:?}");
            match h0.max(h1) <= 1e-6 {
                true => assert_eq!(found.contacts.len(), 1, "{n}: {found:?}"),
                false if h0.min(h1) <= 1e-6 => assert!(!told.is_empty(), "{n}"),
                false => assert!(told.is_empty(), "{n}"),
            }
        }
    }
}

#[test]
fn a_corner_on_another_surface_is_a_touch() {
    for n in 0..N_CASES * orientations() {
        let place = placement(n);
        let [x, y, h, slope, ..] = fractions(n);
        let height = [0.0, 9e-7, -9e-7, 1.2e-6][n as usize % 4] * (0.5 + 0.5 * h);
        let corner = DVec3::new(x, y, height);
        let up = DVec3::Z * (0.1 + slope);
        let sheet = NurbsSurface::bilinear(
            corner,
            corner + DVec3::X + up,
            corner + DVec3::Y + up,
            corner + DVec3::X + DVec3::Y + up * 1.5,
        );
        let sheet = Surface::from(sheet.unwrap().transformed(&place));
        let found = sheet.intersections(&plate(n, place), TOLERANCE).unwrap();
        assert!(length(&found) < 1e-4, "{n}: {found:?}");
        if height.abs() <= 1e-6 && found.curves.is_empty() {
            let at = place.transform_point3(corner);
            assert!(matches!(found.touches[..], [touch] if touch.distance(at) < 1e-9), "{n}");
        }
        if 1e-6 < height {
            assert!(found.touches.is_empty(), "{n}: {found:?}");
        }
    }
}

/// Patches about a point that share nothing but that.
#[test]
fn opposite_patches_touch_in_the_point_that_they_share() {
    let patch = |x: f64, y: f64| {
        let at = |u: f64, v: f64| DVec3::new(x * u, y * v, u * v);
        NurbsSurface::bilinear(at(0.0, 0.0), at(0.0, 1.0), at(1.0, 0.0), at(1.0, 1.0)).unwrap()
    };
    let [one, other] = [patch(1.0, 1.0), patch(-1.0, -1.0)].map(Surface::from);
    let found = one.intersections(&other, TOLERANCE).unwrap();
    assert!(found.curves.is_empty() && found.contacts.is_empty());
    assert!(matches!(found.touches[..], [touch] if touch.length() < 1e-9), "{found:?}");
}
