//! Curves through points and near them, and what curves have in common: here and in geomcore.

use std::{hint::black_box, time::Instant};

use geomcore::{
    BSplineCurve, Point, PointParametrization, Tolerance, intersect_curve_curve,
    intersect_curve_surface,
};
use glam::DVec3;
use virote::kernel::{
    Curve, Ends, Grid, Interpolator, KnotVector, NurbsCurve, Parametrization, Surface, approximate,
    approximate_within,
};

use crate::{clamped_knots, distinct_knots, surfaces};

/// Points of the curves through and near points.
const N_DATA: usize = 10_000;

/// Waves of the curves that cross.
const N_WAVES: usize = 1000;

/// Control points along each side of the surface that lines pass through.
const N_NET: usize = 50;

/// Lines through it.
const N_LINES: usize = 100;

/// Rounds; each runs both once.
const N_ROUNDS: usize = 5;

/// Prints the least times of both in turn, and how many things both found or took.
fn compare(name: &str, ours: impl Fn() -> usize, theirs: impl Fn() -> usize) {
    let timed = |run: &dyn Fn() -> usize| {
        let start = Instant::now();
        let count = black_box(run());
        (start.elapsed().as_secs_f64() * 1e3, count)
    };
    let least = |a: (f64, usize), b: (f64, usize)| if b.0 < a.0 { b } else { a };
    let mut best = [(f64::INFINITY, 0); 2];
    for _ in 0..N_ROUNDS {
        best = [least(best[0], timed(&ours)), least(best[1], timed(&theirs))];
    }
    let [us, them] = best;
    println!("{name}");
    println!(
        "  virote {:9.3} ms ({})   geomcore {:9.3} ms ({})   {:6.1} times ours",
        us.0,
        us.1,
        them.0,
        them.1,
        them.0 / us.0
    );
}

/// A cubic of these control points, here and there.
fn both(points: &[DVec3]) -> (NurbsCurve, BSplineCurve) {
    let n = points.len();
    let knots = KnotVector::new(3, clamped_knots(n)).expect("clamped knots");
    let ours = NurbsCurve::polynomial(knots, points).expect("points for their knots");
    let (knots, times) = distinct_knots(n);
    let theirs =
        BSplineCurve::new(3, points.iter().copied().map(point).collect(), knots, times, false);
    (ours, theirs.expect("points for their knots"))
}

fn point(p: DVec3) -> Point {
    Point::new(p.x, p.y, p.z)
}

pub(crate) fn fits() {
    let place = |i: usize| {
        let t = i as f64 / 1000.0;
        DVec3::new(t, (3.0 * t).sin(), t.cos())
    };
    let points: Vec<DVec3> = (0..N_DATA).map(place).collect();
    let theirs: Vec<Point> = points.iter().copied().map(point).collect();
    let chord = PointParametrization::Chordal;
    let parameters = || Parametrization::Chord.parameters(&points).expect("points apart");
    compare(
        &format!("a cubic through {N_DATA} points (control points)"),
        || {
            let fit = Interpolator::new(&parameters(), 3, Ends::Averaged).expect("parameters");
            fit.curve(&points).expect("as many points").control_points().len()
        },
        || BSplineCurve::interpolate(&theirs, 3, chord).expect("points apart").poles().len(),
    );
    compare(
        &format!("the cubic of 100 control points nearest to {N_DATA} points"),
        || {
            approximate(&points, &parameters(), 3, 100)
                .expect("enough points")
                .control_points()
                .len()
        },
        || BSplineCurve::approximate(&theirs, 3, 100, chord).expect("enough").poles().len(),
    );
    compare(
        &format!("a cubic within 1e-3 of {N_DATA} points (control points)"),
        || {
            let found = approximate_within(&points, &parameters(), 3, 1e-3, false);
            found.expect("a tolerance above rounding").control_points().len()
        },
        || BSplineCurve::approximate_within(&theirs, 3, 1e-3, chord).expect("near").poles().len(),
    );
}

pub(crate) fn crossings() {
    let wave = |phase: f64| {
        let point = |i: usize| {
            let turn = i as f64 * std::f64::consts::FRAC_PI_2;
            DVec3::new(0.25 * i as f64, (turn + phase).sin(), 0.0)
        };
        both(&(0..4 * N_WAVES).map(point).collect::<Vec<DVec3>>())
    };
    let (first, second) = (wave(0.0), wave(1.3));
    let line =
        |from: DVec3, to: DVec3| both(&[0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0].map(|t| from.lerp(to, t)));
    let across = line(DVec3::new(0.0, 0.1, 0.0), DVec3::new(N_WAVES as f64, -0.1, 0.0));
    compare(
        &format!("the length of a curve of {N_WAVES} waves within 1e-9 (hundredths)"),
        || (first.0.length(first.0.domain()) * 100.0).round() as usize,
        || (first.1.length(1e-9) * 100.0).round() as usize,
    );
    let tolerance = Tolerance::DEFAULT;
    for (name, other) in [("another", &second), ("a line", &across)] {
        compare(
            &format!("a curve of {N_WAVES} waves and {name} (places)"),
            // Nothing is kept from one time to the next.
            || first.0.clone().intersections(&other.0.clone(), 1e-7).expect("places").len(),
            || intersect_curve_curve(&first.1, &other.1, tolerance).hits().len(),
        );
    }

    let height = |i: usize, j: usize| (0.7 * i as f64).sin() * (0.9 * j as f64).cos();
    let net = |i: usize, j: usize| (DVec3::new(i as f64, j as f64, height(i, j)), 1.0);
    let (ours, theirs) = surfaces::both(&Grid::from_fn(N_NET, N_NET, net));
    let ours = Surface::from(ours);
    let through = |i: usize| {
        let i = i as f64;
        line(DVec3::new(5.0 + 0.3 * i, 3.0, -5.0), DVec3::new(10.0 + 0.2 * i, 40.0 - 0.2 * i, 5.0))
    };
    let lines: Vec<(NurbsCurve, BSplineCurve)> = (0..N_LINES).map(through).collect();
    let near = virote::kernel::Tolerance::default();
    compare(
        &format!("{N_LINES} lines through a bicubic surface of {N_NET} x {N_NET} (places)"),
        || {
            let found = |line: &(NurbsCurve, BSplineCurve)| {
                ours.piercings(&Curve::from(line.0.clone()), near).expect("places").len()
            };
            lines.iter().map(found).sum()
        },
        || {
            let found = |line: &(NurbsCurve, BSplineCurve)| {
                intersect_curve_surface(&line.1, &theirs, tolerance).hits().len()
            };
            lines.iter().map(found).sum()
        },
    );
}
