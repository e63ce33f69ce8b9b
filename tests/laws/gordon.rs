//! Laws of surfaces through networks.

use proptest::{collection::vec, prelude::Strategy, prop_assert, proptest};
use virote_kernel::{Grid, KnotVector, Network, NurbsCurve, NurbsSurface, gordon};

use crate::some::point;

/// A polynomial surface of degree 3 whose isocurves are far apart.
fn sheet() -> impl Strategy<Value = NurbsSurface> {
    vec(point(), 30).prop_map(|points| {
        let at = |i: usize, j: usize| {
            glam::DVec3::new(20.0 * i as f64, 20.0 * j as f64, 0.0) + 0.3 * points[5 * i + j]
        };
        let knots = |n: usize| KnotVector::uniform_clamped(3, n, 1.0).unwrap();
        NurbsSurface::polynomial(knots(6), knots(5), &Grid::from_fn(6, 5, at)).unwrap()
    })
}

/// Parameters from 0 to 1 that keep apart.
fn parameters() -> impl Strategy<Value = Vec<f64>> {
    vec(0.3..1.0, 1..4).prop_map(|steps| {
        let total: f64 = steps.iter().sum();
        let mut sum = 0.0;
        let mut all = vec![0.0];
        all.extend(steps.iter().map(|step| {
            sum += step / total;
            sum
        }));
        let last = all.len() - 1;
        all[last] = 1.0;
        all
    })
}

proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig::with_cases(32))]

    #[test]
    fn curves_of_a_network_are_isocurves(
        sheet in sheet(),
        at_u in parameters(),
        at_v in parameters(),
        are_given in proptest::prelude::any::<bool>(),
        is_lagrange in proptest::prelude::any::<bool>(),
    ) {
        let us: Vec<NurbsCurve> = at_v.iter().map(|&v| sheet.isocurve_v(v)).collect();
        let vs: Vec<NurbsCurve> = at_u.iter().map(|&u| sheet.isocurve_u(u)).collect();
        let at = if are_given { [Some(&at_u[..]), Some(&at_v[..])] } else { [None, None] };
        let network = Network { curves: [&us, &vs], at, is_lagrange, tolerance: 1e-6 };
        let made = gordon(network).unwrap();
        for f in [0.0, 0.13, 0.5, 0.77, 1.0] {
            for (&v, curve) in at_v.iter().zip(&us) {
                prop_assert!(made.surface.point_at(f, v).distance(curve.point_at(f)) < 1e-10);
            }
            for (&u, curve) in at_u.iter().zip(&vs) {
                prop_assert!(made.surface.point_at(u, f).distance(curve.point_at(f)) < 1e-10);
            }
        }
        prop_assert!(made.changes.iter().flatten().all(|change| change.deviation < 1e-10));
    }

    #[test]
    fn order_and_direction_of_the_others_do_not_matter(sheet in sheet(), at_u in parameters(), at_v in parameters(), flips in vec(proptest::prelude::any::<bool>(), 8)) {
        let us: Vec<NurbsCurve> = at_v.iter().map(|&v| sheet.isocurve_v(v)).collect();
        let vs: Vec<NurbsCurve> = at_u.iter().map(|&u| sheet.isocurve_u(u)).collect();
        let made = |us: &[NurbsCurve], vs: &[NurbsCurve]| {
            gordon(Network { curves: [us, vs], at: [None, None], is_lagrange: false, tolerance: 1e-6 }).unwrap()
        };
        let plain = made(&us, &vs).surface;
        let shuffled = |curves: &[NurbsCurve], flips: &[bool]| {
            let mut others: Vec<NurbsCurve> = curves[1..].iter().zip(flips).map(|(c, &flip)| if flip { c.reversed() } else { c.clone() }).collect();
            others.reverse();
            [&curves[..1], &others].concat()
        };
        let other = made(&shuffled(&us, &flips), &shuffled(&vs, &flips[4..]));
        for (u, v) in [(0.1, 0.3), (0.5, 0.9), (0.8, 0.6)] {
            prop_assert!(plain.point_at(u, v).distance(other.surface.point_at(u, v)) < 1e-9);
        }
    }
}
