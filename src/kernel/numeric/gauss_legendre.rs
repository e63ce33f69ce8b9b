//! Integrals by the rules of Gauss and Legendre.
//!
//! A rule with n nodes is exact for polynomials up to degree 2n − 1. Abramowitz & Stegun, *Handbook
//! of Mathematical Functions*, §25.4.30 and Table 25.4.

use crate::Interval;

/// A rule on −1..1 by its positive nodes, each with its weight; the negative ones mirror them.
pub(crate) type GaussRule<const HALF: usize> = [[f64; 2]; HALF];

/// The rule with 8 nodes.
pub(crate) const EIGHT_NODES: GaussRule<4> = [
    [0.183_434_642_495_649_8, 0.362_683_783_378_362],
    [0.525_532_409_916_329, 0.313_706_645_877_887_3],
    [0.796_666_477_413_626_7, 0.222_381_034_453_374_5],
    [0.960_289_856_497_536_3, 0.101_228_536_290_376_3],
];

/// The rule with 16 nodes.
pub(crate) const SIXTEEN_NODES: GaussRule<8> = [
    [0.09501250983763744, 0.1894506104550685],
    [0.2816035507792589, 0.18260341504492358],
    [0.45801677765722737, 0.16915651939500254],
    [0.6178762444026438, 0.14959598881657674],
    [0.755404408355003, 0.12462897125553388],
    [0.8656312023878318, 0.09515851168249279],
    [0.9445750230732326, 0.062253523938647894],
    [0.9894009349916499, 0.027152459411754096],
];

/// The integral of a function over an interval by one rule.
pub(crate) fn integral<const HALF: usize>(
    rule: &GaussRule<HALF>,
    interval: Interval,
    mut value: impl FnMut(f64) -> f64,
) -> f64 {
    let (middle, half) = (interval.at(0.5), 0.5 * interval.length());
    let pair = |&[node, weight]: &[f64; 2]| {
        weight * (value(middle - half * node) + value(middle + half * node))
    };
    half * rule.iter().map(pair).sum::<f64>()
}

/// [`integral`], to the last bit, of a function that is told all nodes at once, two by two, and makes values of them.
pub(crate) fn integral_of_all<const HALF: usize>(
    rule: &GaussRule<HALF>,
    interval: Interval,
    values: impl FnOnce(&[f64], &mut [f64]),
) -> f64 {
    let (middle, half) = (interval.at(0.5), 0.5 * interval.length());
    let nodes = rule.map(|[node, _]| [middle - half * node, middle + half * node]);
    let mut found = [[0.0; 2]; HALF];
    values(nodes.as_flattened(), found.as_flattened_mut());
    half * rule.iter().zip(found).map(|([_, weight], [a, b])| weight * (a + b)).sum::<f64>()
}

/// The nodes of a rule in an interval, each with its share of the mean value there.
pub(crate) fn nodes<const HALF: usize>(
    rule: &GaussRule<HALF>,
    interval: Interval,
) -> impl Iterator<Item = (f64, f64)> {
    let (middle, half) = (interval.at(0.5), 0.5 * interval.length());
    rule.iter().flat_map(move |&[node, weight]| {
        [(middle - half * node, 0.5 * weight), (middle + half * node, 0.5 * weight)]
    })
}

#[cfg(test)]
mod tests {
    use super::{EIGHT_NODES, GaussRule, SIXTEEN_NODES, integral, integral_of_all, nodes};
    use crate::Interval;

    /// ∫ tⁿ over −1..1 is 2 / (n + 1) for even n; the rule misses that by 2²ⁿ⁺¹ (n!)⁴ / (2n + 1) (2n)!²
    /// first where its nodes are n and the power 2n.
    #[track_caller]
    fn check_is_exact_up_to<const HALF: usize>(rule: &GaussRule<HALF>, degree: u32) {
        let interval = Interval::new(-1.0, 1.0).expect("an interval");
        let found = |n: u32| integral(rule, interval, |t| libm::pow(t, f64::from(n)));
        let error = |n: u32| (found(n) * f64::from(n + 1) / 2.0 - 1.0).abs();
        for n in (0..=degree).step_by(2) {
            assert!(error(n) < 1e-14, "degree {n} by {}", error(n));
        }
        assert!(1e-9 < error(degree + 1), "degree {} by {}", degree + 1, error(degree + 1));
    }

    #[test]
    fn a_rule_with_n_nodes_is_exact_up_to_degree_2n_less_1() {
        check_is_exact_up_to(&EIGHT_NODES, 15);
        check_is_exact_up_to(&SIXTEEN_NODES, 31);
    }

    #[test]
    fn an_integral_is_over_its_interval() {
        let interval = Interval::new(1.0, 3.0).expect("an interval");
        assert!((integral(&EIGHT_NODES, interval, |t| t * t * t) - 20.0).abs() < 1e-13);
    }

    #[test]
    fn values_made_at_once_have_the_same_integral_to_the_last_bit() {
        let interval = Interval::new(0.3, 2.9).expect("an interval");
        let by_one = integral(&SIXTEEN_NODES, interval, libm::exp);
        let at_once = integral_of_all(&SIXTEEN_NODES, interval, |nodes, values| {
            values.iter_mut().zip(nodes).for_each(|(value, &t)| *value = libm::exp(t));
        });
        assert_eq!(by_one.to_bits(), at_once.to_bits());
    }

    #[test]
    fn the_shares_of_the_nodes_are_one_and_their_mean_is_the_middle() {
        let interval = Interval::new(-1.0, 5.0).expect("an interval");
        let (mut shares, mut mean) = (0.0, 0.0);
        for (t, share) in nodes(&EIGHT_NODES, interval) {
            assert!(interval.contains(t));
            (shares, mean) = (shares + share, mean + t * share);
        }
        assert!((shares - 1.0_f64).abs() < 1e-15 && (mean - 2.0_f64).abs() < 1e-15);
    }
}
