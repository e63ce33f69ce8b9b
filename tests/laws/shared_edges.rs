//! Graphs that have a whole edge in common: what they share beside it is told, once.

use std::{f64::consts::FRAC_PI_2, sync::Arc};

use virote_kernel::{
    FunctionFailure, GeomError, Grid, Interval, KnotVector, NurbsSurface, ParametricSurface,
    PictureError, Surface, SurfaceFunction, Tolerance, glam::DVec3,
};

/// z = 0.3 sin x.
#[derive(Debug)]
struct Wave;

impl SurfaceFunction for Wave {
    fn derivatives_at(&self, u: f64, v: f64, order: usize) -> Result<Grid<DVec3>, FunctionFailure> {
        Ok(Grid::from_fn(order + 1, order + 1, |k, l| match (k, l) {
            (0, 0) => DVec3::new(u, v, 0.3 * libm::sin(u)),
            (0, 1) => DVec3::Y,
            (_, 0) => {
                let x = if k == 1 { 1.0 } else { 0.0 };
                DVec3::new(x, 0.0, 0.3 * libm::sin(u + k as f64 * FRAC_PI_2))
            }
            _ => DVec3::ZERO,
        }))
    }
}

fn spline(height: impl Fn(f64, f64) -> f64) -> Surface {
    let knots = KnotVector::uniform_clamped(3, 6, 1.0).unwrap();
    let points = Grid::from_fn(6, 6, |i, j| {
        let (x, y) = (2.0 * i as f64, 2.0 * j as f64);
        DVec3::new(x, y, height(x, y))
    });
    NurbsSurface::polynomial(knots.clone(), knots, &points).unwrap().into()
}

/// Another curve ends in the edge x = 0, where the slopes of both are one; about it they hardly cross.
#[test]
fn graphs_that_share_an_edge_tell_each_curve_once() {
    let waves = spline(|x, y| libm::sin(x) * libm::cos(0.5 * y));
    let all = Interval::new(0.0, 10.0).unwrap();
    for along in [all, Interval::new(0.5, 9.5).unwrap()] {
        let wave = ParametricSurface::new(all, along, Arc::new(Wave)).unwrap();
        let found = waves.intersections(&wave.into(), Tolerance::DEFAULT).unwrap();
        assert_eq!(found.curves.len(), 5);
        let edge = &found.curves[0];
        assert!((edge.length(edge.domain()) - along.length()).abs() < 1e-9);
        let from_edge = |curve: &&virote_kernel::NurbsCurve| {
            [curve.start(), curve.end()].iter().any(|end| end.x.abs() < 1e-6 && 1.0 < end.y)
        };
        assert_eq!(found.curves[1..].iter().filter(from_edge).count(), 1);
        for curve in &found.curves {
            for t in curve.domain().steps(20) {
                let point = curve.point_at(t);
                assert!((point.z - 0.3 * libm::sin(point.x)).abs() < 1e-6, "{point}");
            }
        }
    }
}

/// The spline that stands in for the function leaves the edge by less than the tolerance, to either side.
#[test]
fn an_edge_within_the_other_surface_is_told_or_refused() {
    let waves = spline(|x, y| libm::sin(x) * libm::cos(0.5 * y));
    let [xs, ys] = [10.0, 11.0].map(|end| Interval::new(-1.0, end).unwrap());
    let wave = ParametricSurface::new(xs, ys, Arc::new(Wave)).unwrap();
    match waves.intersections(&wave.into(), Tolerance::DEFAULT) {
        Ok(found) => {
            let is_on_one = |y: f64| {
                let place = DVec3::Y * y;
                found.curves.iter().any(|curve| curve.closest(place, 1e-6).distance < 1e-5)
            };
            assert!((0..=20).all(|i| is_on_one(0.5 * i as f64)));
        }
        Err(GeomError::Picture(PictureError::EdgeLost { point })) => {
            assert!(point.x.abs() < 1e-6 && point.z.abs() < 1e-6, "{point}");
        }
        Err(other) => unreachable!("{other}"),
    }
}
