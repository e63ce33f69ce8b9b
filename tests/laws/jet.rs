//! Jets: the rules of differentiation, closed forms, and places without a derivative.

use glam::DVec3;
use proptest::prelude::{prop_assert, proptest};
use virote_kernel::{
    GeomError, Jet, LocalError, NurbsCurve, NurbsSurface,
    jet::{across, along},
};

const ORDER: usize = 4;

#[track_caller]
fn same(found: &Jet, expected: &Jet) {
    for i in 0..=found.order() {
        for j in 0..=found.order() - i {
            let (found, expected) = (found.derivative(i, j), expected.derivative(i, j));
            let error = (found - expected).abs() / expected.abs().max(1.0);
            assert!(error < 1e-12, "({i}, {j}): {found} is not {expected}");
        }
    }
}

/// Derivatives by order, from order 0.
#[track_caller]
fn derivatives(found: &Jet, expected: &[f64]) {
    for (k, &expected) in expected.iter().enumerate() {
        let found = found.derivative(k, 0);
        let error = (found - expected).abs() / expected.abs().max(1.0);
        assert!(error < 1e-12, "order {k}: {found} is not {expected}");
    }
}

/// Jets of one and of two variables about places with both signs.
fn places() -> Vec<Jet> {
    let mut jets: Vec<Jet> =
        [-0.9, -0.3, 0.2, 0.7].iter().map(|&x| Jet::variable(x, ORDER)).collect();
    let [u, v] = Jet::variables(0.6, -0.8, 3);
    jets.extend([u.times(&v), u.plus(&v.scaled(0.5)), u.minus(&v.times(&v).scaled(0.2))]);
    jets
}

#[test]
fn inverse_functions_undo_each_other() {
    for x in places() {
        same(&x.exp().unwrap().ln().unwrap(), &x);
        same(&x.sin().unwrap().asin().unwrap(), &x);
        same(&x.tan().unwrap().atan().unwrap(), &x);
        same(&x.cbrt().unwrap().power(3.0).unwrap(), &x);
        let square = x.times(&x);
        same(&square.sqrt().unwrap(), &x.abs().unwrap());
        let exp = x.exp().unwrap();
        same(&x.over(&exp).unwrap().times(&exp), &x);
        let ten = x.scaled(std::f64::consts::LN_10).exp().unwrap();
        same(&ten.log10().unwrap(), &x);
    }
}

#[test]
fn addition_theorems_hold() {
    for x in places() {
        let one = x.same(1.0);
        let square = |jet: Jet| jet.times(&jet);
        same(&square(x.sin().unwrap()).plus(&square(x.cos().unwrap())), &one);
        same(&square(x.cosh().unwrap()).minus(&square(x.sinh().unwrap())), &one);
        same(&x.tan().unwrap(), &x.sin().unwrap().over(&x.cos().unwrap()).unwrap());
        same(&x.tanh().unwrap(), &x.sinh().unwrap().over(&x.cosh().unwrap()).unwrap());
        let right_angle = x.same(std::f64::consts::FRAC_PI_2);
        same(&x.acos().unwrap().plus(&x.asin().unwrap()), &right_angle);
        let exp = x.exp().unwrap();
        same(&exp.power_of(&x).unwrap(), &x.times(&x).exp().unwrap());
        same(&exp.power(-2.5).unwrap(), &x.scaled(-2.5).exp().unwrap());
    }
}

#[test]
fn polar_coordinates_come_back() {
    for x in places() {
        let (radius, angle) = (x.exp().unwrap(), x.scaled(3.0));
        let [a, b] = [angle.cos().unwrap(), angle.sin().unwrap()].map(|part| part.times(&radius));
        same(&Jet::norm([&a, &b].into_iter()).unwrap(), &radius);
        same(&b.atan2(&a).unwrap(), &angle);
    }
}

#[test]
fn derivatives_are_the_closed_forms() {
    let x: f64 = 0.4;
    let jet = Jet::variable(x, ORDER);
    let (s, c) = libm::sincos(x);
    derivatives(&jet.sin().unwrap(), &[s, c, -s, -c, s]);
    derivatives(&jet.cos().unwrap(), &[c, -s, -c, s, c]);
    let e = libm::exp(x);
    derivatives(&jet.exp().unwrap(), &[e; 5]);
    derivatives(&jet.ln().unwrap(), &[libm::log(x), 2.5, -6.25, 31.25, -234.375]);
    let p = 1.0 + x * x;
    let slopes = [1.0 / p, -2.0 * x / (p * p), (6.0 * x * x - 2.0) / (p * p * p)];
    derivatives(&jet.atan().unwrap(), &[libm::atan(x), slopes[0], slopes[1], slopes[2]]);
    let r = (1.0 - x * x).sqrt();
    let third = (1.0 + 2.0 * x * x) / libm::pow(r, 5.0);
    derivatives(&jet.asin().unwrap(), &[libm::asin(x), 1.0 / r, x / libm::pow(r, 3.0), third]);
    let t = libm::tan(x);
    let second = 2.0 * t * (1.0 + t * t);
    derivatives(&jet.tan().unwrap(), &[t, 1.0 + t * t, second]);
    derivatives(
        &jet.power(2.5).unwrap(),
        &[
            libm::pow(x, 2.5),
            2.5 * libm::pow(x, 1.5),
            3.75 * libm::pow(x, 0.5),
            1.875 * libm::pow(x, -0.5),
        ],
    );
}

#[test]
fn mixed_derivatives_are_the_closed_forms() {
    // sin(u·v) at (2, 0.3).
    let [u, v] = Jet::variables(2.0, 0.3, 3);
    let wave = u.times(&v).sin().unwrap();
    let (s, c) = libm::sincos(0.6);
    let expected = [
        ((1, 0), 0.3 * c),
        ((0, 1), 2.0 * c),
        ((1, 1), c - 0.6 * s),
        ((2, 0), -0.09 * s),
        ((2, 1), -0.6 * s - 0.18 * c),
        ((0, 3), -8.0 * c),
    ];
    for ((i, j), expected) in expected {
        assert!((wave.derivative(i, j) - expected).abs() < 1e-13, "({i}, {j})");
    }
}

#[test]
fn high_orders_are_exact_too() {
    // The n-th derivative of 1/(1 - x) at 0 is n!.
    let x = Jet::variable(0.0, 20);
    let geometric = x.same(1.0).over(&x.same(1.0).minus(&x)).unwrap();
    let factorial: f64 = (1..=20).map(f64::from).product();
    assert!((geometric.derivative(20, 0) / factorial - 1.0).abs() < 1e-14);
}

#[test]
fn places_without_a_derivative_are_told() {
    let zero = Jet::variable(0.0, 2);
    let one = Jet::variable(1.0, 2);
    let found = [
        zero.sqrt(),
        zero.cbrt(),
        zero.abs(),
        zero.ln(),
        zero.log10(),
        zero.power(-1.0),
        zero.power(1.5),
        zero.power_of(&one),
        zero.atan2(&zero),
        Jet::norm([&zero, &zero].into_iter()),
        one.over(&zero),
        one.asin(),
        one.scaled(-1.0).acos(),
        one.scaled(-1.0).sqrt(),
        one.scaled(-1.0).power(0.5),
    ];
    for (i, found) in found.into_iter().enumerate() {
        assert!(
            matches!(found, Err(GeomError::Local(LocalError::NotDifferentiable { .. }))),
            "{i}: {found:?}"
        );
    }
    assert_eq!(
        Jet::variable(1e308, 1).exp(),
        Err(GeomError::Local(LocalError::DerivativeBeyondNumbers))
    );
    assert_eq!(
        Jet::variable(1e-300, 2).ln(),
        Err(GeomError::Local(LocalError::DerivativeBeyondNumbers))
    );
}

#[test]
fn powers_at_zero_have_the_derivatives_that_exist() {
    derivatives(&Jet::variable(0.0, 4).power(2.0).unwrap(), &[0.0, 0.0, 2.0, 0.0, 0.0]);
    derivatives(&Jet::variable(0.0, 4).power(0.0).unwrap(), &[1.0, 0.0, 0.0, 0.0, 0.0]);
    derivatives(&Jet::variable(0.0, 2).power(2.5).unwrap(), &[0.0, 0.0, 0.0]);
}

#[test]
fn a_curve_along_a_jet_is_the_composition() {
    // The parabola (2s, s², 0) at s = sin t.
    let points = [DVec3::ZERO, DVec3::X, DVec3::new(2.0, 1.0, 0.0)];
    let parabola = NurbsCurve::bezier(&points).unwrap();
    let s = Jet::variable(0.3, ORDER).sin().unwrap();
    let [x, y, z] = along(&parabola.derivatives_at(s.value(), ORDER), &s).unwrap();
    same(&x, &s.scaled(2.0));
    same(&y, &s.times(&s));
    same(&z, &s.same(0.0));
}

#[test]
fn a_surface_at_jets_is_the_composition() {
    // The saddle (a, b, ab) at a = u², b = u + v.
    let corner = |x: f64, y: f64| DVec3::new(x, y, x * y);
    let saddle = NurbsSurface::bilinear(
        corner(0.0, 0.0),
        corner(0.0, 1.0),
        corner(1.0, 0.0),
        corner(1.0, 1.0),
    )
    .unwrap();
    let [u, v] = Jet::variables(0.7, 0.2, 3);
    let (a, b) = (u.times(&u), u.plus(&v));
    let derivatives = saddle.derivatives_at(a.value(), b.value(), 3);
    let [x, y, z] = across(&derivatives, &a, &b).unwrap();
    same(&x, &a);
    same(&y, &b);
    same(&z, &a.times(&b));
}

proptest! {
    /// The chain rule: along a line, a function of two variables is one of a single variable.
    #[test]
    fn two_variables_along_a_line_are_one(
        place in (0.1..2.0, 0.1..2.0),
        direction in (-1.0..1.0, -1.0..1.0),
    ) {
        let f = |u: &Jet, v: &Jet| {
            let wave = u.times(v).sin().unwrap().plus(&u.sqrt().unwrap());
            let bell = wave.times(&wave).plus(&v.times(v)).atan2(&u.exp().unwrap()).unwrap();
            bell.over(&u.plus(v).cosh().unwrap()).unwrap()
        };
        let (a, b): (f64, f64) = direction;
        let [u, v] = Jet::variables(place.0, place.1, 3);
        let surface = f(&u, &v);
        let t = Jet::variable(0.0, 3);
        let line = |start: f64, slope: f64| t.scaled(slope).with_value(start);
        let curve = f(&line(place.0, a), &line(place.1, b));
        let binomials = [[1.0, 0.0, 0.0, 0.0], [1.0, 1.0, 0.0, 0.0], [1.0, 2.0, 1.0, 0.0], [1.0, 3.0, 3.0, 1.0]];
        for (k, row) in binomials.iter().enumerate() {
            let term = |j: usize| row[j] * surface.derivative(k - j, j)
                * libm::pow(a, (k - j) as f64) * libm::pow(b, j as f64);
            let sum: f64 = (0..=k).map(term).sum();
            let size = (0..=k).map(|j| term(j).abs()).fold(1.0, f64::max);
            prop_assert!((curve.derivative(k, 0) - sum).abs() < 1e-12 * size, "order {k}");
        }
    }
}
