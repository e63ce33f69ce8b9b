//! Taking knots away from a curve that has more than its tolerance needs.

use super::search::{FEW, FitSearch, FittedCurve};
use crate::{KnotVector, NurbsCurve, removal::removal};

impl FitSearch<'_> {
    /// Takes many knots away together: of those whose removal alone would be within the tolerance
    /// as many as may go, no two of them neighbours.
    pub(super) fn thinned_at_once(&mut self, first: FittedCurve) -> FittedCurve {
        let mut best = first;
        while FEW < best.n_control() {
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
        let (knots, points) = (curve.knots().as_slice(), curve.control_points());
        let inner = self.degree + 1..points.len();
        let mut costs: Vec<(f64, usize)> = inner
            .map(|i| (removal(self.degree, knots, points, i).displacement, i))
            .filter(|&(cost, _)| cost <= self.tolerance)
            .collect();
        costs.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
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

    /// Takes knots away one by one, the least needed first.
    pub(super) fn thinned(&mut self, first: FittedCurve) -> FittedCurve {
        let mut best = first;
        while best.n_control() <= FEW {
            let breaks = best.curve.knots().breaks();
            let mut without: Option<FittedCurve> = None;
            for &t in &breaks[1..breaks.len() - 1] {
                if self.left == 0 {
                    return best;
                }
                let knots = best.curve.knots().without(t);
                let start = best.parameters.clone();
                let found = self.trial(&knots, &start).filter(|trial| self.keeps(trial));
                let is_better =
                    |found: &FittedCurve| without.as_ref().is_none_or(|w| found.worst < w.worst);
                if let Some(found) = found.filter(is_better) {
                    without = Some(found);
                }
            }
            match without {
                Some(trial) => best = trial,
                None => return best,
            }
        }
        best
    }
}
