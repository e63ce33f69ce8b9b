//! Laws of quadrics: affine images of each kind are told as that kind, in any form, and what was moved
//! off it is told as none.

use glam::{DAffine3, DMat3, DVec3, DVec4};
use proptest::{
    prelude::{Strategy, any},
    prop_assert_eq, proptest,
};
use virote_kernel::{
    Axis, Direction, Frame, Grid, KnotVector, NurbsCurve, NurbsSurface, QuadricKind,
};

fn about_z(profile: &NurbsCurve, angle: f64) -> NurbsSurface {
    NurbsSurface::revolved(profile, Axis::new(DVec3::ZERO, DVec3::Z).unwrap(), angle).unwrap()
}

fn line(a: [f64; 3], b: [f64; 3]) -> NurbsCurve {
    NurbsCurve::polyline(&[a.into(), b.into()]).unwrap()
}

/// A Bézier curve by homogeneous control points.
fn bezier(points: Vec<[f64; 4]>) -> NurbsCurve {
    let knots = [0.0, 1.0].iter().flat_map(|&t| vec![t; points.len()]).collect();
    let knots = KnotVector::new(points.len() - 1, knots).unwrap();
    NurbsCurve::new(knots, points.into_iter().map(DVec4::from).collect()).unwrap()
}

fn extruded(profile: &NurbsCurve) -> NurbsSurface {
    let lines = profile.control_points().iter();
    let rows = lines.map(|&p| vec![p, p + DVec4::new(0.0, 0.0, 1.5 * p.w, 0.0)]).collect();
    let ends = KnotVector::new(1, vec![0.0, 0.0, 1.0, 1.0]).unwrap();
    NurbsSurface::new(profile.knots().clone(), ends, Grid::from_rows(rows).unwrap()).unwrap()
}

/// x² − z² = 1 from (5/4, −3/4) over (1, 0): (1 + t², 2t)/(1 − t²) for t from −1/3 to 1/3.
fn hyperbola() -> NurbsCurve {
    let s = 1.0 / 9.0;
    bezier(vec![
        [1.0 + s, 0.0, -2.0 / 3.0, 1.0 - s],
        [1.0 - s, 0.0, 0.0, 1.0 + s],
        [1.0 + s, 0.0, 2.0 / 3.0, 1.0 - s],
    ])
}

/// z² − x² = 1 from (0, 1) on: (2t, 1 + t²)/(1 − t²) for t from 0 to 1/3.
fn half_of_hyperbola() -> NurbsCurve {
    let s = 1.0 / 9.0;
    bezier(vec![
        [0.0, 0.0, 1.0, 1.0],
        [1.0 / 3.0, 0.0, 1.0, 1.0],
        [2.0 / 3.0, 0.0, 1.0 + s, 1.0 - s],
    ])
}

fn arc(from: f64, sweep: f64) -> NurbsCurve {
    NurbsCurve::arc(Frame::from_axes(DVec3::ZERO, DVec3::X, DVec3::Y).unwrap(), 1.5, from, sweep)
        .unwrap()
}

fn meridian(from: f64, sweep: f64) -> NurbsCurve {
    NurbsCurve::arc(Frame::from_axes(DVec3::ZERO, DVec3::X, DVec3::Z).unwrap(), 1.5, from, sweep)
        .unwrap()
}

/// z = a x² + b y² + c xy over a rectangle, of bidegree (2, 2).
fn graph([a, b, c]: [f64; 3]) -> NurbsSurface {
    // Blossoms of x and y on −1..2.
    let ends = [(-1.0, -1.0), (-1.0, 2.0), (2.0, 2.0)];
    let row = |&(r, s): &(f64, f64)| -> Vec<DVec4> {
        let point = |&(t, w): &(f64, f64)| {
            let (x, y) = (0.5 * (r + s), 0.5 * (t + w));
            DVec4::new(x, y, a * r * s + b * t * w + c * x * y, 1.0)
        };
        ends.iter().map(point).collect()
    };
    let knots = KnotVector::new(2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0]).unwrap();
    let rows: Vec<Vec<DVec4>> = ends.iter().map(row).collect();
    NurbsSurface::new(knots.clone(), knots, Grid::from_rows(rows).unwrap()).unwrap()
}

/// A surface of each kind.
fn kinds(sweep: f64) -> Vec<(QuadricKind, NurbsSurface)> {
    use QuadricKind as Kind;
    vec![
        (Kind::Sphere, about_z(&meridian(-1.2, 2.5), sweep)),
        (Kind::Cylinder, extruded(&arc(0.3, sweep))),
        (Kind::Cone, about_z(&line([1.0, 0.0, 0.0], [0.25, 0.0, 2.0]), sweep)),
        (Kind::EllipticParaboloid, graph([1.0, 0.7, 0.3])),
        (Kind::HyperbolicParaboloid, graph([1.0, -0.7, 0.3])),
        (Kind::ParabolicCylinder, graph([1.0, 0.0, 0.0])),
        (
            Kind::HyperbolicCylinder,
            extruded(&bezier(vec![
                [10.0 / 9.0, -2.0 / 3.0, 0.0, 8.0 / 9.0],
                [8.0 / 9.0, 0.0, 0.0, 10.0 / 9.0],
                [10.0 / 9.0, 2.0 / 3.0, 0.0, 8.0 / 9.0],
            ])),
        ),
        (Kind::HyperboloidOfOneSheet, about_z(&hyperbola(), sweep)),
        (Kind::HyperboloidOfTwoSheets, about_z(&half_of_hyperbola(), sweep)),
        (Kind::Plane, graph([0.0, 0.0, 0.0])),
    ]
}

/// What an affine map that is no similarity makes of a kind.
fn squeezed(kind: QuadricKind) -> QuadricKind {
    match kind {
        QuadricKind::Sphere => QuadricKind::Ellipsoid,
        QuadricKind::Cylinder => QuadricKind::EllipticCylinder,
        QuadricKind::Cone => QuadricKind::EllipticCone,
        other => other,
    }
}

fn turn() -> impl Strategy<Value = DMat3> {
    let axis = (-1.0..1.0, -1.0..1.0, 0.1..1.0_f64).prop_map(|(x, y, z)| DVec3::new(x, y, z));
    (axis, -3.0..3.0).prop_map(|(axis, angle)| DMat3::from_axis_angle(axis.normalize(), angle))
}

fn refined(surface: NurbsSurface, elevates: bool, at: f64) -> NurbsSurface {
    let knot = surface.domain_u().at(at);
    let surface = surface.insert_knots(Direction::U, &[knot]).unwrap();
    match elevates {
        true => surface.elevate_degree(Direction::V, surface.degree_v() + 1).unwrap(),
        false => surface,
    }
}

proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig::with_cases(48))]

    #[test]
    fn an_affine_image_of_a_quadric_is_told_as_its_kind(
        (one, other) in (turn(), turn()),
        squeeze in 0.2..0.7,
        size in 0.01..100.0,
        at in proptest::array::uniform3(-5.0..5.0),
        sweep in 1.5..6.2,
        (elevates, knot) in (any::<bool>(), 0.2..0.8),
    ) {
        for (kind, surface) in kinds(sweep) {
            let surface = refined(surface, elevates, knot);
            let translation = DVec3::from(at);
            let similar = DAffine3 { matrix3: one * size, translation };
            prop_assert_eq!(surface.transformed(&similar).quadric(), Some(kind));
            let matrix3 = one * DMat3::from_diagonal(DVec3::new(1.0, squeeze, 0.8 * squeeze)) * other;
            let image = surface.transformed(&DAffine3 { matrix3: matrix3 * size, translation });
            prop_assert_eq!(image.quadric(), Some(squeezed(kind)));
        }
    }

    #[test]
    fn a_surface_with_a_point_beside_its_quadric_is_told_as_none(
        turn in turn(),
        by in 1e-9..1e-2,
        sweep in 1.5..6.2,
        (i, j) in (0..3_usize, 0..2_usize),
    ) {
        for (kind, surface) in kinds(sweep) {
            let net = surface.control_points();
            let (i, j) = (i.min(net.n_rows() - 1), j.min(net.n_columns() - 1));
            let net = Grid::from_fn(net.n_rows(), net.n_columns(), |k, l| {
                let point = net.get(k, l);
                let step = if (k, l) == (i, j) { by * point.w } else { 0.0 };
                point + DVec4::new(0.37, -0.21, 0.53, 0.0) * step
            });
            let moved = NurbsSurface::new(surface.knots_u().clone(), surface.knots_v().clone(), net);
            let moved = moved.unwrap().transformed(&DAffine3::from_mat3(turn));
            prop_assert_eq!(moved.quadric(), None, "{:?}", kind);
        }
    }
}
