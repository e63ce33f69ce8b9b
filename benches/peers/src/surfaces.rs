//! A million scattered places on a surface.

use glam::DVec3;
use virote::kernel::{Grid, KnotVector, NurbsSurface};

use crate::{GOLDEN, N_POINTS, clamped_knots, compare_parts, distinct_knots};

/// Control points along each side.
const N_SIDE: usize = 50;

pub(crate) fn compare_scattered() {
    println!("{N_POINTS} scattered places on a bicubic rational surface of {N_SIDE} x {N_SIDE}");
    let net = Grid::from_fn(N_SIDE, N_SIDE, |i, j| {
        let weight = 1.0 + 0.1 * ((3 * i + 5 * j) % 7) as f64;
        (DVec3::new(i as f64, j as f64, 0.1 * ((7 * i + 13 * j) % 11) as f64), weight)
    });
    let (ours, theirs) = both(&net);
    let places: Vec<[f64; 2]> = (0..N_POINTS)
        .map(|i| [(i as f64 * GOLDEN).fract(), (i as f64 * 0.754_877_666_246_692_7).fract()])
        .collect();

    println!(" points");
    let evaluator = ours.evaluator();
    let points = |places: &[[f64; 2]]| {
        let mut sum = DVec3::ZERO;
        evaluator.each_point(places, |point| sum += point);
        sum
    };
    let of_geomcore = |places: &[[f64; 2]]| {
        use geomcore::prelude::ParametricSurface;
        places.iter().map(|&[u, v]| in_glam(theirs.eval_point(u, v))).sum()
    };
    compare_parts("geomcore", &places, points, of_geomcore);

    println!(" points, first and second derivatives");
    let unit = 1.0 / N_SIDE as f64;
    let digest = |[s, su, sv, suu, suv, svv]: [DVec3; 6]| {
        s + (su + sv) * unit + (suu + suv + svv) * (unit * unit)
    };
    let second_order = |places: &[[f64; 2]]| {
        let mut sum = DVec3::ZERO;
        evaluator.each_second_order(places, |derivatives| sum += digest(derivatives));
        sum
    };
    let of_geomcore = |places: &[[f64; 2]]| {
        use geomcore::prelude::ParametricSurface;
        let vector = |v: geomcore::Vector| DVec3::new(v.x, v.y, v.z);
        let at = |&[u, v]: &[f64; 2]| {
            let (s, first, second) = theirs.eval_d2(u, v);
            let ([su, sv], [suu, suv, svv]) = (first.map(vector), second.map(vector));
            digest([in_glam(s), su, sv, suu, suv, svv])
        };
        places.iter().map(at).sum()
    };
    compare_parts("geomcore", &places, second_order, of_geomcore);
}

/// The bicubic surface of points with weights, here and in geomcore.
pub(crate) fn both(net: &Grid<(DVec3, f64)>) -> (NurbsSurface, geomcore::BSplineSurface) {
    let (n, m) = (net.n_rows(), net.n_columns());
    let knots = |n: usize| KnotVector::new(3, clamped_knots(n)).expect("clamped knots");
    let (points, weights) = (net.map(|&(point, _)| point), net.map(|&(_, weight)| weight));
    let ours = NurbsSurface::rational(knots(n), knots(m), &points, &weights);

    let pole = |p: &(DVec3, f64)| geomcore::Point::new(p.0.x, p.0.y, p.0.z);
    let poles = (0..n).map(|i| net.row(i).iter().map(pole).collect()).collect();
    let weights = (0..n).map(|i| weights.row(i).to_vec()).collect();
    let ((u, times_u), (v, times_v)) = (distinct_knots(n), distinct_knots(m));
    let theirs = geomcore::BSplineSurface::new_rational(
        3, 3, poles, weights, u, times_u, v, times_v, false, false,
    );
    (ours.expect("a net for its knots"), theirs.expect("a net for its knots"))
}

pub(crate) fn in_glam(point: geomcore::Point) -> DVec3 {
    DVec3::new(point.x, point.y, point.z)
}
