//! Integrals over a rational patch beside the slopes that are told of them.

use std::sync::Arc;

use super::*;
use crate::{Grid, KnotVector, NurbsSurface, PointSlopes};

/// A rational patch, of which one variable moves everything and another one the weights alone.
fn varied() -> VariedSurface {
    let wave = |k: usize, factor: f64| libm::sin(factor * (k + 1) as f64);
    let net = Grid::from_fn(3, 3, |i, j| {
        let (k, weight) = (3 * i + j, 1.0 + 0.3 * wave(3 * i + j, 1.3));
        (DVec3::new(i as f64, j as f64 + 0.2 * wave(k, 0.9), wave(k, 2.1)) * weight).extend(weight)
    });
    let slope = |k: usize| DVec4::new(wave(k, 0.7), wave(k, 1.9), wave(k, 2.9), 0.1 * wave(k, 3.7));
    let weight = |k: usize| DVec4::W * wave(k, 0.4);
    let by_variable = vec![(0, (0..9).map(slope).collect()), (1, (0..9).map(weight).collect())];
    let slopes = PointSlopes::new(2, 9, by_variable).expect("slopes");
    let knots = KnotVector::uniform_clamped(2, 3, 1.0).expect("knots");
    let surface = NurbsSurface::new(knots.clone(), knots, net).expect("a patch");
    VariedSurface::new(Arc::new(surface), slopes).expect("slopes")
}

/// An integral over the patch by the tensor rule on sixteen squares.
fn integral(surface: &NurbsSurface, integrand: &dyn Fn(DVec3, DVec3) -> f64) -> f64 {
    let quarters: Vec<Interval> = (0..4)
        .map(|k| Interval::new(0.25 * k as f64, 0.25 * (k + 1) as f64).expect("a quarter"))
        .collect();
    let places = || quarters.iter().flat_map(|side| nodes(&EIGHT_NODES, *side));
    let mut sum = 0.0;
    for (u, weight_u) in places() {
        for (v, weight_v) in places() {
            let d = surface.derivatives_at(u, v, 1);
            let across = d.row(1)[0].cross(d.row(0)[1]);
            sum += weight_u * weight_v / 16.0 * integrand(d.row(0)[0], across);
        }
    }
    sum
}

#[test]
fn integrals_grow_by_their_slopes() {
    let varied = varied();
    let (about, center) = (DVec3::new(0.3, -0.8, 2.0), DVec3::new(1.1, 0.4, -0.6));
    let (d, e) = (DVec3::new(1.0, -0.5, 0.25), DVec3::new(0.2, 0.7, -1.0));
    let check = |found: Result<SurfaceIntegral, GeomError>, of: &dyn Fn(DVec3, DVec3) -> f64| {
        let found = found.expect("slopes");
        assert!(found.relative_error < 1e-9, "{}", found.relative_error);
        for (variable, slope) in found.slopes.iter().enumerate() {
            let h = 1e-4;
            let at = |step: f64| integral(&varied.moved(&[(variable, step)]).expect("room"), of);
            let expected = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
            assert!((slope - expected).abs() < 1e-8, "{variable}: {slope}, not {expected}");
        }
    };
    check(varied.area_slopes(), &|_, n| n.length());
    check(varied.volume_slopes(about), &|s, n| (s - about).dot(n) / 3.0);
    let arm = |s: DVec3, along: DVec3| (s - center).dot(along);
    check(varied.area_moment_slopes(center, d), &|s, n| arm(s, d) * n.length());
    check(varied.area_second_moment_slopes(center, [d, e]), &|s, n| {
        arm(s, d) * arm(s, e) * n.length()
    });
    let held = center - about;
    check(varied.volume_moment_slopes(about, center, d), &|s, n| {
        let a = s - about;
        a.dot(n) * (a.dot(d) / 4.0 - held.dot(d) / 3.0)
    });
    check(varied.volume_second_moment_slopes([about, center], [d, e]), &|s, n| {
        let a = s - about;
        let mixed = a.dot(d) * held.dot(e) + held.dot(d) * a.dot(e);
        a.dot(n) * (a.dot(d) * a.dot(e) / 5.0 - mixed / 4.0 + held.dot(d) * held.dot(e) / 3.0)
    });
}
