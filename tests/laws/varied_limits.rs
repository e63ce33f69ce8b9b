//! Slopes of control points that are made where they are asked for, at the end of what numbers hold.

use glam::DVec4;
use proptest::prelude::{ProptestConfig, prop_assert, proptest};
use virote_kernel::{
    Ends, GeomError, Interpolator, Jet, Parametrization, PointSlopes, Side, interpolate_varied,
};

use crate::varied::moving_points;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    /// Slopes that are asked for grow in proportion with those of the points as long as numbers go, and are refused beyond.
    #[test]
    fn slopes_beyond_numbers_are_refused_and_never_others(
        (points, slopes) in moving_points(),
        ends in proptest::sample::select(vec![Ends::Bessel, Ends::Natural, Ends::NotAKnot]),
        power in 1015..1022,
        at in 0.0..1.0,
    ) {
        let n = points.len();
        let rule = Parametrization::Chord;
        let fit = Interpolator::new(&rule.parameters(&points).unwrap(), 3, ends).unwrap();
        let asked = |factor: f64| {
            let alone = |i: usize| {
                let own = |k: usize| if k == i { slopes[k] * factor } else { DVec4::ZERO };
                (i, (0..n).map(own).collect())
            };
            let all = PointSlopes::new(n, n, (0..n).map(alone).collect()).unwrap();
            let varied = interpolate_varied((&fit, ends), rule, &points, &all)?.unwrap();
            let still = Jet::with_slopes(at, &vec![0.0; n])?;
            let mut found = varied.derivatives_beside(&still, Side::Right, 2)?.concat();
            found.push(varied.length(fit.knots().domain())?);
            Ok::<_, GeomError>(found)
        };
        let factor = libm::pow(2.0, f64::from(power));
        let small = asked(1.0).unwrap();
        match asked(factor) {
            Ok(found) => for (found, small) in found.iter().zip(&small) {
                for (found, small) in found.slopes().iter().zip(small.slopes()) {
                    prop_assert!((found - factor * small).abs() <= 0.0, "{found:e} of {small:e}");
                }
            },
            Err(_) => {
                let most = small.iter().flat_map(Jet::slopes).fold(0.0, |most: f64, slope| most.max(slope.abs()));
                prop_assert!(f64::MAX / factor < 1e3 * most, "{most:e}");
            }
        }
    }
}
