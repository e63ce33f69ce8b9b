//! Laws of continuity: what counts as going on smoothly.

use glam::{DAffine3, DVec3};
use proptest::{prop_assert, prop_assert_eq, proptest};
use virote_kernel::{
    CircleForm, Continuity, Curve, Interval, JointTolerance, KnotVector, NurbsCurve, Tolerance,
};

use crate::some::curve;

fn joint(a: &NurbsCurve, b: &NurbsCurve) -> Continuity {
    let [a, b] = [a, b].map(|curve| Curve::from(curve.clone()));
    a.continuity_with(&b, Tolerance::DEFAULT).unwrap()
}

fn inside(curve: &NurbsCurve) -> Continuity {
    Curve::from(curve.clone()).continuity(Tolerance::DEFAULT).unwrap()
}

fn plane(points: &[[f64; 2]]) -> Vec<DVec3> {
    points.iter().map(|&[x, y]| DVec3::new(x, y, 0.0)).collect()
}

fn bezier(points: &[[f64; 2]]) -> NurbsCurve {
    NurbsCurve::bezier(&plane(points)).unwrap()
}

/// The cubic on 0..1 with these derivatives by order at 0.
fn starting_with(d: [DVec3; 4]) -> NurbsCurve {
    let p1 = d[0] + d[1] / 3.0;
    let p2 = d[2] / 6.0 + 2.0 * p1 - d[0];
    let p3 = d[3] / 6.0 + 3.0 * p2 - 3.0 * p1 + d[0];
    NurbsCurve::bezier(&[d[0], p1, p2, p3]).unwrap()
}

/// Derivatives at the start of a piece that goes on from derivatives `d` by the constraints with
/// β₁, β₂, β₃: the chain rule for a change of the parameter with these derivatives.
fn by_constraints(d: &[DVec3], [b1, b2, b3]: [f64; 3]) -> [DVec3; 4] {
    [
        d[0],
        b1 * d[1],
        b1 * b1 * d[2] + b2 * d[1],
        b1 * b1 * b1 * d[3] + 3.0 * b1 * b2 * d[2] + b3 * d[1],
    ]
}

fn cubic() -> NurbsCurve {
    let points = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [3.0, 2.0, 1.0], [4.0, 0.0, 3.0]];
    NurbsCurve::bezier(&points.map(DVec3::from)).unwrap()
}

#[test]
fn the_constraints_with_beta_make_geometric_continuity() {
    for scale in [1e-6, 1e-3, 1.0, 1e6] {
        let a = cubic().transformed(&DAffine3::from_scale(DVec3::splat(scale)));
        let d = a.derivatives_at(1.0, 3);
        let orders = |next: [DVec3; 4]| {
            let found = joint(&a, &starting_with(next));
            (found.c, found.g)
        };
        let (up, across) = (DVec3::Z * scale, d[1].cross(d[2]) / scale);
        let next = |betas| by_constraints(&d, betas);
        assert_eq!(orders(next([1.0, 0.0, 0.0])), (3, 3));
        assert_eq!(orders(next([1.0, 0.0, 2.0])), (2, 3));
        assert_eq!(orders(next([1.0, -3.0, 0.5])), (1, 3));
        assert_eq!(orders(next([2.0, 1.0, -4.0])), (0, 3));
        assert_eq!(orders(next([0.3, 0.0, 0.0])), (0, 3));
        let [d0, d1, d2, d3] = next([2.0, 1.0, -4.0]);
        assert_eq!(orders([d0, d1, d2, d3 + up]), (0, 2));
        assert_eq!(orders([d0, d1, d2 + across, d3]), (0, 1));
        assert_eq!(orders([d0, d1 + up, d2, d3]), (0, 0));
        assert_eq!(orders([d0, -d1, d2, d3]), (0, 0));
        assert_eq!(orders([d0 + up, d1, d2, d3]), (-1, -1));
    }
}

#[test]
fn a_scalar_curvature_is_not_enough() {
    // Linkeová, exercise 2.2: the figure eight crosses itself with curvature 0.07857 on both
    // branches, but to opposite sides.
    let piece = |c: [[f64; 2]; 4]| {
        starting_with({
            let c = plane(&c);
            [c[0], c[1], 2.0 * c[2], 6.0 * c[3]]
        })
    };
    let pieces = [
        piece([[0.0, 0.0], [9.0, 9.0], [0.0, -9.0], [-3.0, 0.0]]),
        piece([[6.0, 0.0], [0.0, -9.0], [-9.0, 9.0], [3.0, 0.0]]),
        piece([[0.0, 0.0], [-9.0, 9.0], [0.0, -9.0], [3.0, 0.0]]),
        piece([[-6.0, 0.0], [0.0, -9.0], [9.0, 9.0], [-3.0, 0.0]]),
    ];
    let found = [0, 1, 2, 3].map(|i| joint(&pieces[i], &pieces[(i + 1) % 4]));
    assert_eq!(found.map(|joint| joint.c), [1, 1, 1, 1]);
    assert_eq!(found.map(|joint| joint.g), [2, 1, 2, 1]);
    // Twice 0.0785674…, for the vectors are opposite.
    let gap = found[1].curvature_gap.unwrap();
    assert!((gap - 2.0 * 9.0 * 18.0 / (162.0 * 162.0_f64.sqrt())).abs() < 1e-12, "{gap}");
}

#[test]
fn opposite_tangents_are_not_g1() {
    // Vukašinović & Duhovnik, Fig. 1.34.
    let p = bezier(&[[0.0, 0.0], [1.0, 2.0], [3.0, 3.0], [5.0, 3.0]]);
    let r = bezier(&[[5.0, 3.0], [4.0, 3.0], [3.0, 1.0], [2.0, 0.0]]);
    let found = joint(&p, &r);
    assert_eq!((found.c, found.g, found.gap), (0, 0, 0.0));
    assert!((found.angle - std::f64::consts::PI).abs() < 1e-15);
}

#[test]
fn collinear_segments_and_joined_parabolas() {
    // Vukašinović & Duhovnik, (1.59) and the example of §1.5.3.
    let line = |a, b| NurbsCurve::line(a, b).unwrap();
    let middle = DVec3::new(1.0, 2.0, 2.0);
    let (f, g) = (line(DVec3::ZERO, middle), line(middle, 3.0 * middle));
    assert_eq!((joint(&f, &g).c, joint(&f, &g).g), (0, 3));
    let unit = |c: &NurbsCurve| c.reparametrized(Interval::new(0.0, c.length(c.domain())).unwrap());
    assert_eq!(joint(&unit(&f), &unit(&g)).c, 3);
    let f = bezier(&[[-1.0, 0.0], [-1.0, 1.0], [0.0, 1.0]]);
    let g = bezier(&[[0.0, 1.0], [1.0, 1.0], [1.0, 0.0]]);
    assert_eq!((joint(&f, &g).c, joint(&f, &g).g), (1, 2));
}

#[test]
fn circles_are_smoother_in_space_than_their_homogeneous_curves() {
    // The NURBS Book, Example 7.2 and §10.3; every circle is smooth by its arc length.
    let expected = [(1, 0), (1, 0), (1, 0), (1, -1)];
    for (form, (c, c_homogeneous)) in CircleForm::ALL.into_iter().zip(expected) {
        let circle = NurbsCurve::circle(DVec3::ONE, 2.0, DVec3::X, DVec3::Z, form).unwrap();
        let found = inside(&circle);
        assert_eq!((found.c, found.g), (c, 3), "{form:?}");
        if form != CircleForm::DegreeFive {
            assert_eq!(found.c_homogeneous, c_homogeneous, "{form:?}");
        }
    }
    // The knots 1/4 and 3/4 of the square form can be removed.
    let form = CircleForm::SevenSquare;
    let square = NurbsCurve::circle(DVec3::ZERO, 1.0, DVec3::X, DVec3::Z, form).unwrap();
    for t in [0.25, 0.75] {
        let [a, b] = square.split(t).unwrap();
        assert_eq!((joint(&a, &b).c, joint(&a, &b).c_homogeneous), (3, 3));
    }
}

#[test]
fn a_knot_of_multiplicity_s_takes_s_orders() {
    for s in 1..=4 {
        let knots = [vec![0.0; 5], vec![1.0; s], vec![3.0; 5]].concat();
        let knots = KnotVector::new(4, knots).unwrap();
        let points: Vec<DVec3> = (0..knots.n_points())
            .map(|i| DVec3::new(i as f64, f64::from(i as u32 * i as u32 % 7), i as f64 * 0.3))
            .collect();
        let curve = NurbsCurve::polynomial(knots, &points).unwrap();
        assert_eq!(inside(&curve).c, 4 - s as i32);
        assert_eq!(inside(&curve).c_homogeneous, 4 - s as i32, "{:?}", inside(&curve));
    }
}

proptest! {
    #[test]
    fn pieces_of_a_split_go_on_as_smoothly_as_can_be(curve in curve(), f in 0.01..0.99) {
        // Amid a span; knots have their own law.
        let span = curve.knots().span_at(curve.domain().at(f));
        let t = curve.knots().span_interval(span).at(0.5);
        let [a, b] = curve.split(t).unwrap();
        let found = joint(&a, &b);
        prop_assert_eq!((found.c, found.g, found.c_homogeneous), (3, 3, 3));
        prop_assert!(found.gap < 1e-12 && found.angle < 1e-10);
    }

    #[test]
    fn the_joint_backwards_is_the_same(a in curve(), b in curve(), s in 0.01..100.0) {
        let b = b.transformed(&DAffine3::from_translation(a.end() - b.start()));
        let b = b.transformed(&DAffine3::from_translation(a.end()))
            .transformed(&DAffine3::from_scale(DVec3::splat(s)))
            .transformed(&DAffine3::from_translation(-2.0 * s * a.end() + a.end()));
        let forth = joint(&a, &b);
        let back = joint(&b.reversed(), &a.reversed());
        prop_assert_eq!((forth.c, forth.g, forth.c_homogeneous), (back.c, back.g, back.c_homogeneous));
        prop_assert!((forth.angle - back.angle).abs() < 1e-9);
    }

    #[test]
    fn limits_that_are_asked_for_decide(a in curve(), b in curve(), gap in 1e-4..1.0) {
        let b = b.transformed(&DAffine3::from_translation(a.end() - b.start() + gap * DVec3::Z));
        let [a, b] = [a, b].map(Curve::from);
        let found = a.continuity_with(&b, Tolerance::DEFAULT).unwrap();
        prop_assert_eq!(found.g, -1);
        let asked = |distance: f64, angle: f64, curvature_gap: f64| {
            let [distance, angle, curvature_gap] = [distance, angle, curvature_gap].map(Some);
            let document = Tolerance::DEFAULT;
            let asked = JointTolerance { document, distance, angle, curvature_gap };
            let joint = a.continuity_with(&b, asked).unwrap();
            (joint.g, joint.c <= joint.g)
        };
        // A thousandth above and below each, where rounding does not count.
        let (above, below) = (1.001, 0.999);
        let (gap, angle) = (found.gap, found.angle);
        if let Some(bend) = found.curvature_gap && 1e-3 < angle && 1e-3 < bend {
            prop_assert_eq!(asked(below * gap, above * angle, above * bend), (-1, true));
            prop_assert_eq!(asked(above * gap, below * angle, above * bend), (0, true));
            prop_assert_eq!(asked(above * gap, above * angle, below * bend), (1, true));
            let (g, holds) = asked(above * gap, above * angle, above * bend);
            prop_assert!(2 <= g && holds);
        }
    }
}

/// A knot that was put in without a change is smooth to every order, one that counts to the degree less its
/// multiplicity, at every place and on every domain.
#[test]
fn derivatives_are_the_same_on_both_sides_of_a_knot_that_does_not_count() {
    let points = plane(&[
        [0.0, 0.0],
        [1.0, 2.0],
        [3.0, -1.0],
        [4.0, 3.0],
        [6.0, 1.0],
        [7.0, 5.0],
        [9.0, 0.0],
    ]);
    for (start, end) in [(0.0, 1.0), (-3.0, 500.0), (2.0, 2.001)] {
        for (far, size) in [(0.0, 1.0), (1e5, 1.0), (0.0, 1e-6)] {
            let at = |f: f64| start + f * (end - start);
            let knots = [0.0, 0.0, 0.0, 0.0, 0.4, 0.7, 0.7, 1.0, 1.0, 1.0, 1.0].map(at);
            let knots = KnotVector::new(3, knots.to_vec()).unwrap();
            let places: Vec<DVec3> = points.iter().map(|&p| p * size + DVec3::X * far).collect();
            let curve = NurbsCurve::polynomial(knots, &places).unwrap();
            let refined = Curve::from(curve.insert_knots(&[at(0.2), at(0.55), at(0.55)]).unwrap());
            for order in 1..=3 {
                for (f, smooth_to) in [(0.2, 3), (0.4, 2), (0.55, 3), (0.6, 3), (0.7, 1)] {
                    let is_smooth = refined.is_smooth_at(at(f), order);
                    assert_eq!(is_smooth, order <= smooth_to, "{f} of {start}..{end}, {order}");
                }
            }
        }
    }
}
