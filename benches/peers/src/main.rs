//! Virote's geometry beside that of other crates: the same curve, the same surface, the same
//! points, in one run on one thread, turn and turn about. Prints times and their ratios.

mod nearest;
mod searches;
mod surfaces;

use std::{hint::black_box, time::Instant};

use glam::{DVec3, DVec4};
use virote::kernel::{Grid, KnotVector, NurbsCurve, NurbsSurface};

/// Points along each side of the grid of the comparison.
const N_GRID: usize = 1000;

/// Control points along each side of the surface.
const N_NET: usize = 20;

/// Control points, and evaluations, of the curve.
const N_CURVE: usize = 100;
const N_POINTS: usize = 1_000_000;

/// Rounds; each runs both sides once.
const N_ROUNDS: usize = 9;

/// Items that are timed at once.
const PART: usize = 10_000;

/// Its multiples are spread evenly and in no order.
const GOLDEN: f64 = 0.618_033_988_749_895;

fn main() {
    // Only what finds something, where that is asked for.
    if std::env::args().nth(1).is_some_and(|what| what == "searches") {
        searches::fits();
        searches::crossings();
        return;
    }
    let net = net();
    let ours = surface(&net);
    println!("grid of {N_GRID} x {N_GRID}, bicubic rational: points, unit normals, triangles");
    let grid = || our_grid(&ours);
    compare("curvo", N_ROUNDS, grid, curvo_grid(&net));
    compare("truck-geometry", 3, grid, truck_grid(&net));
    compare("geomcore", 3, grid, geomcore_grid(&net));

    curves();
    surfaces::compare_scattered();
    nearest::on_a_curve();
    nearest::on_a_surface();
    searches::fits();
    searches::crossings();
}

/// A million places on a curve.
fn curves() {
    println!("{N_POINTS} places on a rational cubic of {N_CURVE} control points");
    let curve = curve();
    let prepare = || drop(black_box(curve.clone().evaluator().clone()));
    println!("  virote prepares it in {:.1} us", fastest(prepare) * 1e6);
    let in_order = parameters();
    let at_random: Vec<f64> = (0..N_POINTS).map(|i| (i as f64 * GOLDEN).fract()).collect();
    for (order, ts) in [("in order", &in_order), ("at random", &at_random)] {
        let evaluator = curve.evaluator();
        let points = |ts: &[f64]| {
            let mut sum = DVec3::ZERO;
            evaluator.each_point(ts, |point| sum += point);
            sum
        };
        println!(" points {order}");
        compare_parts("geomcore", ts, points, geomcore_curve(&curve));
        compare_parts("curvo", ts, points, curvo_curve(&curve));
        compare_parts("truck-geometry", ts, points, truck_curve(&curve));

        println!(" points {order}, one by one");
        let one_by_one = |ts: &[f64]| ts.iter().map(|&t| evaluator.point_at(t)).sum();
        compare_parts("geomcore", ts, one_by_one, geomcore_curve(&curve));

        println!(" points {order}, one by one from the knots");
        let unprepared = |ts: &[f64]| ts.iter().map(|&t| curve.point_at(t)).sum();
        compare_parts("geomcore", ts, unprepared, geomcore_curve(&curve));

        println!(" points, first and second derivatives {order}, one by one from the knots");
        let unprepared = |ts: &[f64]| {
            let at = |&t: &f64| {
                let found = curve.derivatives_at(t, 2);
                in_units_of_spans([found[0], found[1], found[2]])
            };
            ts.iter().map(at).sum()
        };
        compare_parts("geomcore", ts, unprepared, geomcore_second_order(&curve));

        println!(" points, first and second derivatives {order}");
        let second_order = |ts: &[f64]| {
            let mut sum = DVec3::ZERO;
            evaluator.each_second_order(ts, |derivatives| sum += in_units_of_spans(derivatives));
            sum
        };
        compare_parts("geomcore", ts, second_order, geomcore_second_order(&curve));
    }
}

/// The least of many times, in seconds.
fn fastest(run: impl Fn()) -> f64 {
    let time = |_| {
        let start = Instant::now();
        run();
        start.elapsed().as_secs_f64()
    };
    (0..100).map(time).fold(f64::INFINITY, f64::min)
}

/// Runs both over parts of the work, part by part in turn, and adds up what each part took at
/// least: so short a time is rarely interrupted. Prints what one of the items takes.
fn compare_parts<T>(
    name: &str,
    items: &[T],
    ours: impl Fn(&[T]) -> DVec3,
    theirs: impl Fn(&[T]) -> DVec3,
) {
    let (mut us, mut them) = (0.0, 0.0);
    let parts = items.chunks(PART);
    let mut least = vec![[f64::INFINITY; 2]; parts.len()];
    for _ in 0..N_ROUNDS {
        for (part, least) in parts.clone().zip(&mut least) {
            let (time, our_sum) = timed(|| ours(part));
            least[0] = least[0].min(time);
            let (time, their_sum) = timed(|| theirs(part));
            least[1] = least[1].min(time);
            let difference = our_sum.distance(their_sum) / our_sum.length();
            assert!(difference < 1e-9, "{name} computes something else: {difference}");
        }
    }
    for [ours, theirs] in least {
        (us, them) = (us + ours, them + theirs);
    }
    let (us, them) = (us * 1e6 / items.len() as f64, them * 1e6 / items.len() as f64);
    let ratio = them / us;
    println!("  virote {us:9.1} ns   {name:15} {them:9.1} ns   {ratio:6.1} times ours");
}

/// The sum of a point and its derivatives, in a unit that makes them alike in size.
fn in_units_of_spans([point, first, second]: [DVec3; 3]) -> DVec3 {
    let unit = 1.0 / N_CURVE as f64;
    point + first * unit + second * (unit * unit)
}

/// Runs both in turn; a run answers with a sum of points, which must agree.
fn compare(name: &str, n_rounds: usize, ours: impl Fn() -> DVec3, theirs: impl Fn() -> DVec3) {
    let (mut our_times, mut their_times) = (Vec::new(), Vec::new());
    for _ in 0..n_rounds {
        let (time, our_sum) = timed(&ours);
        our_times.push(time);
        let (time, their_sum) = timed(&theirs);
        their_times.push(time);
        let difference = our_sum.distance(their_sum) / our_sum.length();
        assert!(difference < 1e-9, "{name} computes something else: {difference}");
    }
    let (us, them) = (median(our_times), median(their_times));
    let ratio = them / us;
    println!("  virote {us:9.1} ms   {name:15} {them:9.1} ms   {ratio:6.1} times ours");
}

fn timed(run: impl Fn() -> DVec3) -> (f64, DVec3) {
    let start = Instant::now();
    let sum = black_box(run());
    (start.elapsed().as_secs_f64() * 1e3, sum)
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Something of a result that shows whether it is the same: the diagonal and its normals.
fn digest(point: impl Fn(usize) -> DVec3, normal: impl Fn(usize) -> DVec3) -> DVec3 {
    let on_diagonal = |i: usize| i * (N_GRID + 1);
    (0..N_GRID).map(on_diagonal).map(|i| point(i) + normal(i)).fold(DVec3::ZERO, |a, b| a + b)
}

fn clamped_knots(n: usize) -> Vec<f64> {
    let inner = (0..=n - 3).map(|i| i as f64 / (n - 3) as f64);
    [0.0; 3].into_iter().chain(inner).chain([1.0; 3]).collect()
}

fn grid_parameters() -> Vec<f64> {
    (0..N_GRID).map(|i| i as f64 / (N_GRID - 1) as f64).collect()
}

fn parameters() -> Vec<f64> {
    (0..N_POINTS).map(|i| i as f64 / (N_POINTS - 1) as f64).collect()
}

fn net() -> Grid<DVec4> {
    Grid::from_fn(N_NET, N_NET, |i, j| {
        let height = (((7 * i + 13 * j) % 11) as f64) * 0.1;
        let weight = 1.0 + 0.1 * ((3 * i + 5 * j) % 7) as f64;
        (DVec3::new(i as f64, j as f64, height) * weight).extend(weight)
    })
}

fn surface(net: &Grid<DVec4>) -> NurbsSurface {
    let knots = KnotVector::new(3, clamped_knots(N_NET)).expect("clamped knots");
    NurbsSurface::new(knots.clone(), knots, net.clone()).expect("a net for its knots")
}

fn curve() -> NurbsCurve {
    let point = |i: usize| DVec3::new(i as f64, ((7 * i) % 11) as f64, ((5 * i) % 13) as f64);
    let points: Vec<DVec3> = (0..N_CURVE).map(point).collect();
    let weights: Vec<f64> = (0..N_CURVE).map(|i| 1.0 + 0.1 * (i % 7) as f64).collect();
    let knots = KnotVector::new(3, clamped_knots(N_CURVE)).expect("clamped knots");
    NurbsCurve::rational(knots, &points, &weights).expect("points for their knots")
}

/// Two triangles for each cell of the grid.
fn triangles() -> Vec<[u32; 3]> {
    let n = N_GRID as u32;
    let mut triangles = Vec::with_capacity(2 * (N_GRID - 1) * (N_GRID - 1));
    for i in 0..n - 1 {
        for a in i * n..i * n + n - 1 {
            triangles.extend([[a, a + n, a + n + 1], [a, a + n + 1, a + 1]]);
        }
    }
    triangles
}

fn our_grid(surface: &NurbsSurface) -> DVec3 {
    let ts = grid_parameters();
    let samples = surface.samples_on_grid(&ts, &ts, 1);
    black_box(triangles());
    let (points, normals) = (samples.points.as_slice(), samples.normals.as_slice());
    digest(|i| points[i], |i| normals[i])
}

fn curvo_grid(net: &Grid<DVec4>) -> impl Fn() -> DVec3 {
    let row = |i: usize| {
        let points = net.row(i).iter();
        points.map(|point| nalgebra::Point4::new(point.x, point.y, point.z, point.w)).collect()
    };
    let surface = curvo::prelude::NurbsSurface3D::new(
        3,
        3,
        clamped_knots(N_NET),
        clamped_knots(N_NET),
        (0..N_NET).map(row).collect(),
    );
    move || {
        let mesh = surface.regular_tessellate(N_GRID - 1, N_GRID - 1);
        let (points, normals) = (mesh.points(), mesh.normals());
        let point = |i: usize| DVec3::new(points[i].x, points[i].y, points[i].z);
        digest(point, |i| DVec3::new(normals[i].x, normals[i].y, normals[i].z))
    }
}

fn truck_grid(net: &Grid<DVec4>) -> impl Fn() -> DVec3 {
    use truck_geometry::prelude::{
        BSplineSurface, KnotVec, NurbsSurface, ParametricSurface3D, Vector4,
    };
    let row = |i: usize| {
        net.row(i).iter().map(|point| Vector4::new(point.x, point.y, point.z, point.w)).collect()
    };
    let knots = || KnotVec::from(clamped_knots(N_NET));
    let surface: NurbsSurface<Vector4> =
        NurbsSurface::new(BSplineSurface::new((knots(), knots()), (0..N_NET).map(row).collect()));
    move || {
        let ts = grid_parameters();
        let mut points = Vec::with_capacity(N_GRID * N_GRID);
        let mut normals = Vec::with_capacity(N_GRID * N_GRID);
        for &u in &ts {
            for &v in &ts {
                points.push(surface.subs(u, v));
                normals.push(surface.normal(u, v));
            }
        }
        black_box(triangles());
        let point = |i: usize| DVec3::new(points[i].x, points[i].y, points[i].z);
        digest(point, |i| DVec3::new(normals[i].x, normals[i].y, normals[i].z))
    }
}

/// Distinct knots with multiplicities, as geomcore wants them.
fn distinct_knots(n: usize) -> (Vec<f64>, Vec<u32>) {
    let knots: Vec<f64> = clamped_knots(n)[3..=n].to_vec();
    let mut times = vec![1; knots.len()];
    let last = times.len() - 1;
    (times[0], times[last]) = (4, 4);
    (knots, times)
}

fn geomcore_grid(net: &Grid<DVec4>) -> impl Fn() -> DVec3 {
    use geomcore::{BSplineSurface, Point, prelude::ParametricSurface};
    let point = |point: &DVec4| {
        let place = point.truncate() / point.w;
        Point::new(place.x, place.y, place.z)
    };
    let poles = (0..N_NET).map(|i| net.row(i).iter().map(point).collect()).collect();
    let weights = (0..N_NET).map(|i| net.row(i).iter().map(|point| point.w).collect()).collect();
    let ((u, times_u), (v, times_v)) = (distinct_knots(N_NET), distinct_knots(N_NET));
    let surface =
        BSplineSurface::new_rational(3, 3, poles, weights, u, times_u, v, times_v, false, false)
            .expect("a net for its knots");
    move || {
        let ts = grid_parameters();
        let mut points = Vec::with_capacity(N_GRID * N_GRID);
        let mut normals = Vec::with_capacity(N_GRID * N_GRID);
        for &u in &ts {
            for &v in &ts {
                let (point, [along_u, along_v]) = surface.eval_d1(u, v);
                points.push(DVec3::new(point.x, point.y, point.z));
                let vector = |v: geomcore::Vector| DVec3::new(v.x, v.y, v.z);
                normals.push(vector(along_u).cross(vector(along_v)).normalize());
            }
        }
        black_box(triangles());
        digest(|i| points[i], |i| normals[i])
    }
}

fn in_geomcore(curve: &NurbsCurve) -> geomcore::BSplineCurve {
    let poles = curve.points().into_iter().map(|p| geomcore::Point::new(p.x, p.y, p.z)).collect();
    let (knots, times) = distinct_knots(N_CURVE);
    geomcore::BSplineCurve::new_rational(3, poles, curve.weights(), knots, times, false)
        .expect("points for their knots")
}

fn geomcore_second_order(curve: &NurbsCurve) -> impl Fn(&[f64]) -> DVec3 {
    use geomcore::prelude::ParametricCurve;
    let curve = in_geomcore(curve);
    move |ts: &[f64]| {
        let digest = |&t: &f64| {
            let (point, first, second) = curve.eval_d2(t);
            let vector = |v: geomcore::Vector| DVec3::new(v.x, v.y, v.z);
            let point = DVec3::new(point.x, point.y, point.z);
            in_units_of_spans([point, vector(first), vector(second)])
        };
        ts.iter().map(digest).fold(DVec3::ZERO, |sum, p| sum + p)
    }
}

fn geomcore_curve(curve: &NurbsCurve) -> impl Fn(&[f64]) -> DVec3 {
    use geomcore::prelude::ParametricCurve;
    let curve = in_geomcore(curve);
    move |ts: &[f64]| {
        ts.iter()
            .map(|&t| curve.eval_point(t))
            .fold(DVec3::ZERO, |sum, point| sum + DVec3::new(point.x, point.y, point.z))
    }
}

fn curvo_curve(curve: &NurbsCurve) -> impl Fn(&[f64]) -> DVec3 {
    let points = curve.control_points().iter();
    let points = points.map(|p| nalgebra::Point4::new(p.x, p.y, p.z, p.w)).collect();
    let curve = curvo::prelude::NurbsCurve3D::try_new(3, points, clamped_knots(N_CURVE))
        .expect("points for their knots");
    move |ts: &[f64]| {
        ts.iter()
            .map(|&t| curve.point_at(t))
            .fold(DVec3::ZERO, |sum, point| sum + DVec3::new(point.x, point.y, point.z))
    }
}

fn truck_curve(curve: &NurbsCurve) -> impl Fn(&[f64]) -> DVec3 {
    use truck_geometry::prelude::{BSplineCurve, KnotVec, NurbsCurve, ParametricCurve, Vector4};
    let points = curve.control_points().iter();
    let points = points.map(|p| Vector4::new(p.x, p.y, p.z, p.w)).collect();
    let curve: NurbsCurve<Vector4> =
        NurbsCurve::new(BSplineCurve::new(KnotVec::from(clamped_knots(N_CURVE)), points));
    move |ts: &[f64]| {
        ts.iter()
            .map(|&t| curve.subs(t))
            .fold(DVec3::ZERO, |sum, point| sum + DVec3::new(point.x, point.y, point.z))
    }
}
