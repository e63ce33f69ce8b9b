//! How fast curves and surfaces are evaluated and tessellated.

#![expect(clippy::unwrap_used, reason = "an example that cannot be built ends the benchmark")]

use divan::{Bencher, counter::ItemsCount};
use glam::DVec3;
use virote::kernel::{
    Grid, KnotVector, NurbsCurve, NurbsSurface, Side, grid_mesh, tessellate, tessellate_curve,
};

const MOST: usize = 20_000_000;

fn main() {
    divan::main();
}

/// A rational cubic of a hundred points.
fn curve() -> NurbsCurve {
    let n = 100;
    let point = |i: usize| {
        let t = i as f64;
        DVec3::new(t, libm::sin(t), libm::cos(2.0 * t))
    };
    let points: Vec<DVec3> = (0..n).map(point).collect();
    let weights: Vec<f64> = (0..n).map(|i| 1.0 + 0.1 * (i % 7) as f64).collect();
    let knots = KnotVector::uniform_clamped(3, n, 1.0).unwrap();
    NurbsCurve::rational(knots, &points, &weights).unwrap()
}

/// A rational bicubic of twenty by twenty points.
fn surface() -> NurbsSurface {
    let n = 20;
    let height = |i: usize, j: usize| libm::sin(0.7 * i as f64) * libm::cos(0.5 * j as f64);
    let points = Grid::from_fn(n, n, |i, j| DVec3::new(i as f64, j as f64, height(i, j)));
    let weights = Grid::from_fn(n, n, |i, j| 1.0 + 0.1 * ((3 * i + 5 * j) % 7) as f64);
    let knots = KnotVector::uniform_clamped(3, n, 1.0).unwrap();
    NurbsSurface::rational(knots.clone(), knots, &points, &weights).unwrap()
}

/// Numbers on 0..1 in an order that no cache foresees: multiples of the golden ratio.
fn scattered(n: usize) -> Vec<f64> {
    (0..n).map(|i| (i as f64 * 0.618_033_988_749_895).fract()).collect()
}

fn in_order(n: usize) -> Vec<f64> {
    (0..n).map(|i| i as f64 / (n - 1) as f64).collect()
}

fn each_point(bencher: Bencher<'_, '_>, ts: &[f64]) {
    let curve = curve();
    let sum = || ts.iter().map(|&t| curve.point_at(t)).sum::<DVec3>();
    bencher.counter(ItemsCount::new(ts.len())).bench(sum);
}

#[divan::bench]
fn curve_points_in_order(bencher: Bencher<'_, '_>) {
    each_point(bencher, &in_order(10_000));
}

#[divan::bench]
fn curve_points_at_random(bencher: Bencher<'_, '_>) {
    each_point(bencher, &scattered(10_000));
}

#[divan::bench]
fn curve_second_derivatives(bencher: Bencher<'_, '_>) {
    let (curve, ts) = (curve(), scattered(1_000));
    let sum = || ts.iter().map(|&t| curve.derivatives_at(t, 2)[2]).sum::<DVec3>();
    bencher.counter(ItemsCount::new(ts.len())).bench(sum);
}

#[divan::bench]
fn curve_tangents(bencher: Bencher<'_, '_>) {
    let (curve, ts) = (curve(), scattered(1_000));
    let tangents = || ts.iter().filter_map(|&t| curve.tangent_at(t, Side::Right).ok()).count();
    bencher.counter(ItemsCount::new(ts.len())).bench(tangents);
}

#[divan::bench]
fn curve_length(bencher: Bencher<'_, '_>) {
    let curve = curve();
    bencher.bench(|| curve.length(curve.domain()));
}

#[divan::bench]
fn curve_bounds(bencher: Bencher<'_, '_>) {
    let curve = curve();
    bencher.bench(|| curve.bounds());
}

#[divan::bench]
fn curve_tessellation(bencher: Bencher<'_, '_>) {
    let curve = curve();
    bencher.bench(|| tessellate_curve(&curve, 1e-4, MOST));
}

#[divan::bench]
fn surface_points_in_order(bencher: Bencher<'_, '_>) {
    let (surface, ts) = (surface(), in_order(100));
    let sum = || {
        let along_v = |&u: &f64| ts.iter().map(|&v| surface.point_at(u, v)).sum::<DVec3>();
        ts.iter().map(along_v).sum::<DVec3>()
    };
    bencher.counter(ItemsCount::new(ts.len() * ts.len())).bench(sum);
}

#[divan::bench]
fn surface_points_at_random(bencher: Bencher<'_, '_>) {
    let (surface, us, vs) = (surface(), scattered(10_000), in_order(10_000));
    let sum = || us.iter().zip(&vs).map(|(&u, &v)| surface.point_at(u, v)).sum::<DVec3>();
    bencher.counter(ItemsCount::new(us.len())).bench(sum);
}

#[divan::bench]
fn surface_normals_at_random(bencher: Bencher<'_, '_>) {
    let (surface, us, vs) = (surface(), scattered(1_000), in_order(1_000));
    let normals = || us.iter().zip(&vs).filter(|&(&u, &v)| surface.normal_at(u, v).is_ok()).count();
    bencher.counter(ItemsCount::new(us.len())).bench(normals);
}

#[divan::bench(args = [100, 1000])]
fn surface_grid_of_points(bencher: Bencher<'_, '_>, n: usize) {
    let (surface, ts) = (surface(), in_order(n));
    bencher.counter(ItemsCount::new(n * n)).bench(|| surface.points_on_grid(&ts, &ts));
}

#[divan::bench(args = [100, 1000])]
fn surface_grid_of_points_and_normals(bencher: Bencher<'_, '_>, n: usize) {
    let (surface, ts) = (surface(), in_order(n));
    bencher.counter(ItemsCount::new(n * n)).bench(|| surface.samples_on_grid(&ts, &ts, 1));
}

#[divan::bench(args = [100, 1000])]
fn surface_grid_mesh(bencher: Bencher<'_, '_>, n: usize) {
    let surface = surface();
    bencher.counter(ItemsCount::new(n * n)).bench(|| grid_mesh(&surface, n - 1, n - 1, MOST, 1));
}

#[divan::bench(args = [2, 4])]
fn surface_grid_mesh_by_threads(bencher: Bencher<'_, '_>, n_threads: usize) {
    let (surface, n) = (surface(), 1000);
    bencher
        .counter(ItemsCount::new(n * n))
        .bench(|| grid_mesh(&surface, n - 1, n - 1, MOST, n_threads));
}

#[divan::bench(args = [1e-2, 1e-3, 1e-4])]
fn surface_tessellation(bencher: Bencher<'_, '_>, tolerance: f64) {
    let surface = surface();
    bencher.bench(|| tessellate(&surface, tolerance, MOST));
}

#[divan::bench]
fn surface_bounds(bencher: Bencher<'_, '_>) {
    let surface = surface();
    bencher.bench(|| surface.bounds());
}
