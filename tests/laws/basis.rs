//! Laws of the basis functions.

use proptest::{prop_assert, proptest};
use virote_kernel::KnotVector;

use crate::some::{fraction, knots};

fn basis(knots: &KnotVector, t: f64) -> Vec<f64> {
    let mut values = vec![0.0; knots.degree() + 1];
    knots.basis_at(knots.span_at(t), t, &mut values);
    values
}

proptest! {
    #[test]
    fn partition_of_unity(knots in knots(), f in fraction()) {
        let sum: f64 = basis(&knots, knots.domain().at(f)).iter().sum();
        prop_assert!((sum - 1.0).abs() < 1e-14, "{sum}");
    }

    #[test]
    fn non_negativity(knots in knots(), f in fraction()) {
        prop_assert!(basis(&knots, knots.domain().at(f)).iter().all(|&value| 0.0 <= value));
    }

    #[test]
    fn a_span_holds_its_parameter(knots in knots(), f in fraction()) {
        let t = knots.domain().at(f);
        let span = knots.span_at(t);
        let (start, end) = (knots.as_slice()[span], knots.as_slice()[span + 1]);
        prop_assert!(start < end && start <= t);
        prop_assert!(t < end || (t <= end && knots.domain().end() <= end));
    }

    #[test]
    fn derivatives_of_every_order_sum_to_zero(knots in knots(), f in fraction()) {
        let derivatives = knots.basis_derivatives_at(knots.domain().at(f), 6);
        for k in 1..=6 {
            let largest = derivatives.row(k).iter().fold(1.0_f64, |a, b| a.max(b.abs()));
            let sum: f64 = derivatives.row(k).iter().sum();
            prop_assert!(sum.abs() <= 1e-12 * largest, "order {k}: {sum}");
        }
    }

    #[test]
    fn values_are_their_own_derivatives_of_order_zero(knots in knots(), f in fraction()) {
        let t = knots.domain().at(f);
        let values = basis(&knots, t);
        let derivatives = knots.basis_derivatives_at(t, 0);
        prop_assert!(values.iter().zip(derivatives.row(0)).all(|(a, b)| (a - b).abs() < 1e-15));
    }
}
