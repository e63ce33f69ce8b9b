//! Arbitrary knots, curves and surfaces, and a few known ones.

use std::f64::consts::TAU;

use glam::{DAffine3, DMat3, DVec3};
use proptest::{
    collection::vec,
    prelude::{Just, Strategy, any},
};
use virote_kernel::{Grid, KnotVector, NurbsCurve, NurbsSurface};

/// Knots of degree 1 to 5 with up to four spans, clamped or not.
pub(crate) fn knots() -> impl Strategy<Value = KnotVector> {
    (1..=5usize).prop_flat_map(|degree| {
        (Just(degree), vec((0.1..2.0, 1..=degree), 1..=4), any::<bool>(), -3.0..3.0)
            .prop_map(|(degree, spans, is_clamped, start)| build(degree, &spans, is_clamped, start))
    })
}

fn build(degree: usize, spans: &[(f64, usize)], is_clamped: bool, start: f64) -> KnotVector {
    let mut knots: Vec<f64> = match is_clamped {
        true => vec![start; degree + 1],
        false => (0..=degree).map(|i| start - 0.4 * (degree - i) as f64).collect(),
    };
    let mut end = start;
    for (i, &(width, times)) in spans.iter().enumerate() {
        end += width;
        let is_last = i + 1 == spans.len();
        knots.extend(vec![end; if is_last { 1 } else { times }]);
    }
    knots.extend((1..=degree).map(|i| if is_clamped { end } else { end + 0.3 * i as f64 }));
    KnotVector::new(degree, knots).unwrap()
}

pub(crate) fn point() -> impl Strategy<Value = DVec3> {
    (-10.0..10.0, -10.0..10.0, -10.0..10.0).prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

/// A turn about some axis, and a shift.
pub(crate) fn motion() -> impl Strategy<Value = DAffine3> {
    (point(), 0.0..TAU, point()).prop_map(|(axis, angle, shift)| {
        let axis = axis.try_normalize().unwrap_or(DVec3::Z);
        DAffine3 { translation: shift, ..DAffine3::from_axis_angle(axis, angle) }
    })
}

/// A fraction of a domain, the ends not left out.
pub(crate) fn fraction() -> impl Strategy<Value = f64> {
    (0..=1000u32).prop_map(|i| f64::from(i) / 1000.0)
}

/// A curve with weights between 0.2 and 5, or all one.
pub(crate) fn curve() -> impl Strategy<Value = NurbsCurve> {
    knots().prop_flat_map(|knots| {
        let n = knots.n_points();
        (Just(knots), vec(point(), n), weights(n)).prop_map(|(knots, points, weights)| {
            NurbsCurve::rational(knots, &points, &weights).unwrap()
        })
    })
}

pub(crate) fn surface() -> impl Strategy<Value = NurbsSurface> {
    (knots(), knots()).prop_flat_map(|(knots_u, knots_v)| {
        let (n, m) = (knots_u.n_points(), knots_v.n_points());
        let net = (vec(point(), n * m), weights(n * m));
        (Just((knots_u, knots_v)), net).prop_map(move |((knots_u, knots_v), (points, weights))| {
            let points = Grid::new(n, m, points).unwrap();
            let weights = Grid::new(n, m, weights).unwrap();
            NurbsSurface::rational(knots_u, knots_v, &points, &weights).unwrap()
        })
    })
}

fn weights(n: usize) -> impl Strategy<Value = Vec<f64>> {
    (any::<bool>(), vec(0.2..5.0, n)).prop_map(move |(is_rational, weights)| match is_rational {
        true => weights,
        false => vec![1.0; n],
    })
}

pub(crate) fn affine_map() -> impl Strategy<Value = DAffine3> {
    (point(), point(), point(), point()).prop_map(|(x, y, z, translation)| DAffine3 {
        matrix3: DMat3::from_cols(x, y, z) * 0.1,
        translation,
    })
}

/// The parameter at a fraction of the domain.
pub(crate) fn parameter(curve: &NurbsCurve, fraction: f64) -> f64 {
    curve.domain().at(fraction)
}

/// The sphere, u around its axis and v upward; both poles are collapsed edges.
pub(crate) fn sphere(center: DVec3, radius: f64) -> NurbsSurface {
    let s = std::f64::consts::FRAC_1_SQRT_2;
    let around: [(f64, f64); 9] = [
        (1.0, 0.0),
        (1.0, 1.0),
        (0.0, 1.0),
        (-1.0, 1.0),
        (-1.0, 0.0),
        (-1.0, -1.0),
        (0.0, -1.0),
        (1.0, -1.0),
        (1.0, 0.0),
    ];
    let upward: [(f64, f64); 5] = [(0.0, -1.0), (1.0, -1.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    let weight = |i: usize| if i.is_multiple_of(2) { 1.0 } else { s };
    let points = Grid::from_fn(9, 5, |i, j| {
        let ((x, y), (rho, z)) = (around[i], upward[j]);
        center + radius * DVec3::new(rho * x, rho * y, z)
    });
    let weights = Grid::from_fn(9, 5, |i, j| weight(i) * weight(j));
    let knots = |joints: &[f64]| {
        let inner = joints.iter().flat_map(|&t| [t, t]);
        let knots = [0.0; 3].into_iter().chain(inner).chain([1.0; 3]).collect();
        KnotVector::new(2, knots).unwrap()
    };
    NurbsSurface::rational(knots(&[0.25, 0.5, 0.75]), knots(&[0.5]), &points, &weights).unwrap()
}

/// Whether two points are one, relative to the size of what they belong to.
pub(crate) fn are_near(a: DVec3, b: DVec3, tolerance: f64) -> bool {
    a.distance(b) <= tolerance * (1.0 + a.length().max(b.length()))
}
