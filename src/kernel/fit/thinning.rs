//! Taking knots away from a curve that has more than its tolerance needs.

use super::{fitted::FittedCurve, search::FitSearch};
use crate::{
    KnotVector, NurbsCurve,
    ceiling::{KNOTS_TRIED, SINGLE_REMOVALS},
    removal::removal,
    sorting::sort_by,
};

impl FitSearch<'_> {
    /// Takes many knots away together: of those whose removal alone would be within the tolerance
    /// as many as may go, no two of them neighbours.
    pub(super) fn thinned_at_once(&mut self, first: FittedCurve) -> FittedCurve {
        let mut best = first;
        while self.degree + 1 < best.n_control() {
            let spare = self.spare_knots(&best.curve);
            let mut n = spare.len();
            let found = loop {
                if n == 0 || self.left == 0 {
                    return best;
                }
                let without = |knots: KnotVector, &t: &f64| knots.without(t);
                let knots = spare[..n].iter().fold(best.curve.knots().clone(), without);
                let start = best.parameters.clone();
                match self.trial(&knots, &start).filter(|trial| self.keeps(trial)) {
                    Some(trial) => break trial,
                    None => n /= 4,
                }
            };
            best = found;
        }
        best
    }

    /// Inner knots that the curve needs least, no two of them neighbours, the least needed first.
    fn spare_knots(&self, curve: &NurbsCurve) -> Vec<f64> {
        let knots = curve.knots().as_slice();
        let costs = self.costs(curve).into_iter().filter(|&(cost, _)| cost <= self.tolerance);
        let mut is_taken = vec![false; knots.len() + 1];
        let mut spare = Vec::new();
        for (_, i) in costs {
            if !(is_taken[i - 1] || is_taken[i + 1]) {
                is_taken[i] = true;
                spare.push(knots[i]);
            }
        }
        spare
    }

    /// What the removal of each inner knot would displace, the least first.
    pub(super) fn costs(&self, curve: &NurbsCurve) -> Vec<(f64, usize)> {
        let (knots, points) = (curve.knots().as_slice(), curve.control_points());
        let inner = self.degree + 1..points.len();
        let mut costs: Vec<(f64, usize)> =
            inner.map(|i| (removal(self.degree, knots, points, i).displacement, i)).collect();
        sort_by(&mut costs, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        costs
    }

    /// Takes knots away one by one, of those that cost least the first that can go; whether it ended because none can.
    pub(super) fn thinned(&mut self, first: FittedCurve) -> (FittedCurve, bool) {
        let mut best = first;
        while best.n_control() <= SINGLE_REMOVALS && 0 < self.left {
            let costs = self.costs(&best.curve);
            let (knots, start) = (best.curve.knots().clone(), best.parameters.clone());
            let without = |&(_, i): &(f64, usize)| {
                let trial = self.trial(&knots.without(knots.as_slice()[i]), &start)?;
                self.keeps(&trial).then_some(trial)
            };
            match costs.iter().take(KNOTS_TRIED).find_map(without) {
                Some(trial) => best = trial,
                None => return (best, true),
            }
        }
        (best, false)
    }
}
