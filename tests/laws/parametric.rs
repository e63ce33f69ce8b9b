//! Curves and surfaces of functions, against closed forms.

use std::{
    f64::consts::{FRAC_PI_2, TAU},
    sync::Arc,
};

use glam::{DAffine3, DVec3};
use virote_kernel::{
    Curve, CurveFunction, FunctionFailure, GeomError, Grid, Interval, LocalError, ParametricCurve,
    ParametricSurface, Side, Surface, SurfaceFunction,
};

/// (2 cos t, 2 sin t, t), which has curvature 2/5; fails above 100.
#[derive(Debug)]
struct Helix;

impl CurveFunction for Helix {
    fn derivatives_at(&self, t: f64, order: usize) -> Result<Vec<DVec3>, FunctionFailure> {
        if 100.0 < t {
            return Err(FunctionFailure::new(std::fmt::Error));
        }
        let derivative = |k: usize| {
            let angle = t + k as f64 * FRAC_PI_2;
            let height = [t, 1.0, 0.0][k.min(2)];
            DVec3::new(2.0 * libm::cos(angle), 2.0 * libm::sin(angle), height)
        };
        Ok((0..=order).map(derivative).collect())
    }
}

/// (t², t³, 0), with a cusp at 0.
#[derive(Debug)]
struct Cusp;

impl CurveFunction for Cusp {
    fn derivatives_at(&self, t: f64, order: usize) -> Result<Vec<DVec3>, FunctionFailure> {
        let all = [
            DVec3::new(t * t, t * t * t, 0.0),
            DVec3::new(2.0 * t, 3.0 * t * t, 0.0),
            DVec3::new(2.0, 6.0 * t, 0.0),
            DVec3::new(0.0, 6.0, 0.0),
        ];
        Ok((0..=order).map(|k| all.get(k).copied().unwrap_or(DVec3::ZERO)).collect())
    }
}

/// The unit sphere, u its longitude and v its latitude.
#[derive(Debug)]
struct Sphere;

impl SurfaceFunction for Sphere {
    fn derivatives_at(&self, u: f64, v: f64, order: usize) -> Result<Grid<DVec3>, FunctionFailure> {
        let wave = |t: f64, k: usize| libm::cos(t + k as f64 * FRAC_PI_2);
        Ok(Grid::from_fn(order + 1, order + 1, |k, l| {
            let height = if k == 0 { wave(v - FRAC_PI_2, l) } else { 0.0 };
            DVec3::new(wave(u, k) * wave(v, l), wave(u - FRAC_PI_2, k) * wave(v, l), height)
        }))
    }
}

fn helix(end: f64) -> Result<Curve, GeomError> {
    let domain = Interval::new(0.0, end)?;
    ParametricCurve::new(domain, Arc::new(Helix)).map(Curve::from)
}

fn sphere() -> Surface {
    let longitudes = Interval::new(0.0, TAU).unwrap();
    let latitudes = Interval::new(-FRAC_PI_2, FRAC_PI_2).unwrap();
    ParametricSurface::new(longitudes, latitudes, Arc::new(Sphere)).unwrap().into()
}

#[track_caller]
fn near(found: DVec3, expected: DVec3) {
    assert!(found.distance(expected) < 1e-12, "{found} is not {expected}");
}

#[test]
fn a_helix_has_its_curvature_and_frame() {
    let helix = helix(TAU).unwrap();
    for t in [0.0, 1.0, TAU] {
        let local = helix.local_at(t, Side::Right).unwrap();
        assert!((local.curvature().unwrap() - 0.4).abs() < 1e-14);
        assert!((local.torsion().unwrap() - 0.2).abs() < 1e-14);
        near(local.normal().unwrap(), -DVec3::new(libm::cos(t), libm::sin(t), 0.0));
        let tangent = DVec3::new(-2.0 * libm::sin(t), 2.0 * libm::cos(t), 1.0) / libm::sqrt(5.0);
        near(helix.tangent_at(t, Side::Right).unwrap(), tangent);
    }
    // Like a NURBS, however large the tolerance is: its ends are apart.
    assert!(!helix.is_closed(6.0) && !helix.is_closed(6.3));
}

#[test]
fn a_cusp_has_a_tangent_on_either_side() {
    let domain = Interval::new(-1.0, 1.0).unwrap();
    let cusp = Curve::from(ParametricCurve::new(domain, Arc::new(Cusp)).unwrap());
    near(cusp.tangent_at(0.0, Side::Right).unwrap(), DVec3::X);
    near(cusp.tangent_at(0.0, Side::Left).unwrap(), -DVec3::X);
    let unbounded =
        GeomError::Local(LocalError::UnboundedCurvature { what: "curvature", parameter: 0.0 });
    assert_eq!(cusp.local_at(0.0, Side::Right).unwrap().curvature(), Err(unbounded));
}

#[test]
fn maps_move_points_and_turn_derivatives() {
    let map = DAffine3::from_translation(DVec3::new(5.0, 0.0, 0.0))
        * DAffine3::from_scale(DVec3::splat(3.0));
    let (before, after) = (helix(TAU).unwrap(), helix(TAU).unwrap().transformed(&map));
    let (before, after) =
        (before.derivatives_at(1.0, 3).unwrap(), after.derivatives_at(1.0, 3).unwrap());
    near(after[0], 3.0 * before[0] + DVec3::new(5.0, 0.0, 0.0));
    (1..=3).for_each(|k| near(after[k], 3.0 * before[k]));
    let ball = sphere().transformed(&map).unwrap();
    near(ball.point_at(0.0, 0.0).unwrap(), DVec3::new(8.0, 0.0, 0.0));
    near(ball.tangents_at(0.0, 0.0).unwrap()[1], DVec3::new(0.0, 3.0, 0.0));
}

#[test]
fn a_sphere_has_its_normal_also_at_the_poles() {
    let sphere = sphere();
    near(sphere.normal_at(1.0, 0.5).unwrap(), sphere.point_at(1.0, 0.5).unwrap());
    near(sphere.normal_at(1.0, FRAC_PI_2).unwrap(), DVec3::Z);
    near(sphere.normal_at(1.0, -FRAC_PI_2).unwrap(), -DVec3::Z);
    assert!(sphere.is_closed_u(1e-12).unwrap() && !sphere.is_closed_v(1e-12).unwrap());
}

#[test]
fn isocurves_are_the_surface_along_a_line() {
    let sphere = sphere();
    let parallel = sphere.isocurve_v(0.5).unwrap();
    let local = parallel.local_at(2.0, Side::Right).unwrap();
    assert!((local.curvature().unwrap() - 1.0 / libm::cos(0.5)).abs() < 1e-12);
    let meridian = sphere.isocurve_u(0.5).unwrap();
    near(meridian.point_at(0.2).unwrap(), sphere.point_at(0.5, 0.2).unwrap());
    near(
        meridian.derivatives_at(0.2, 2).unwrap()[2],
        sphere.derivatives_at(0.5, 0.2, 2).unwrap().get(0, 2),
    );
}

#[test]
fn a_failing_function_is_found_when_a_curve_is_made_of_it() {
    let failure = helix(101.0).unwrap_err();
    assert!(
        matches!(&failure, GeomError::Function(reason) if reason.reason::<std::fmt::Error>().is_some())
    );
}

#[test]
fn what_overflows_is_no_point() {
    let map = DAffine3::from_scale(DVec3::splat(1e308));
    let huge = helix(1.0).unwrap().transformed(&map);
    assert_eq!(
        huge.point_at(0.0),
        Err(GeomError::Local(LocalError::BeyondNumbers { order: 0, parameter: 0.0 }))
    );
}

#[test]
fn curves_and_surfaces_are_equal_where_function_domain_and_place_are() {
    let (function, other): (Arc<dyn CurveFunction>, Arc<dyn CurveFunction>) =
        (Arc::new(Helix), Arc::new(Helix));
    let domain = |end: f64| Interval::new(0.0, end).unwrap();
    let curve = |end: f64, function: &Arc<dyn CurveFunction>| {
        ParametricCurve::new(domain(end), Arc::clone(function)).unwrap()
    };
    let shift = DAffine3::from_translation(DVec3::X);
    assert!(curve(1.0, &function) == curve(1.0, &function));
    assert!(curve(1.0, &function) != curve(2.0, &function));
    assert!(curve(1.0, &function) != curve(1.0, &other));
    assert!(curve(1.0, &function) != curve(1.0, &function).transformed(&shift));

    let (function, other): (Arc<dyn SurfaceFunction>, Arc<dyn SurfaceFunction>) =
        (Arc::new(Sphere), Arc::new(Sphere));
    let surface = |[u, v]: [f64; 2], function: &Arc<dyn SurfaceFunction>| {
        ParametricSurface::new(domain(u), domain(v), Arc::clone(function)).unwrap()
    };
    let whole = surface([1.0, 1.0], &function);
    assert!(whole == surface([1.0, 1.0], &function));
    assert!(whole != surface([2.0, 1.0], &function));
    assert!(whole != surface([1.0, 1.5], &function));
    assert!(whole != surface([1.0, 1.0], &other));
    assert!(whole != whole.transformed(&shift).unwrap());
}

#[test]
fn a_surface_is_smooth_around_what_lies_within_its_four_sides() {
    let sphere = sphere();
    assert!(sphere.is_smooth_around(1.0, 0.5));
    for (u, v) in [(0.0, 0.5), (TAU, 0.5), (1.0, -FRAC_PI_2), (1.0, FRAC_PI_2)] {
        assert!(!sphere.is_smooth_around(u, v), "({u}, {v})");
    }
}

#[test]
fn the_nearest_point_of_a_sphere_is_towards_the_place_at_every_size() {
    for size in [1e-200, 1e-3, 1.0, 1e3, 1e200] {
        let Surface::Parametric(sphere) = sphere() else { unreachable!("it is a function") };
        let map = DAffine3::from_scale(DVec3::splat(size));
        let sphere = sphere.transformed(&map).unwrap();
        // Of 7 times (2, 3, 6) / 7 from the middle.
        let found = sphere.closest(DVec3::new(2.0, 3.0, 6.0) * size).unwrap();
        near(found.point / size, DVec3::new(2.0, 3.0, 6.0) / 7.0);
        assert!((found.distance / size - 6.0).abs() < 1e-12, "{size:e}");
    }
}
