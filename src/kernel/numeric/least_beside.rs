//! Better places beside the end of a search for a least value.
//!
//! No slope leads away from a saddle, nor from a greatest value under curved conditions, where a search comes to that
//! begins on an axis of symmetry. Along the ways that the conditions leave free the function's curvature tells, with
//! that of the conditions that hold it: where it falls on both sides of a place, that is none of the least. Nocedal &
//! Wright, *Numerical Optimization*, §12.5.

use super::{
    answers::{Answers, Wanted},
    least_bending::{Bending, slopes_along},
    least_model::{HoldingCondition, Terms},
    least_newton::even_out,
    least_search::{LeastSearch, clamped},
    quadratic_program::dot,
    symmetric_eigen::symmetric_axes,
};
use crate::{
    ceiling::{CONDITION_CORRECTIONS, CURVATURE_UNKNOWNS, KINK_HULL_UNKNOWNS},
    tolerance::{
        KINK_ROUNDINGS, LAST_BIT, LEAST_BEND_RELATIVE, LEAST_FAR, LEAST_PROBE_RELATIVE,
        LEAST_SLOPE_RELATIVE,
    },
};

/// How many times farther than beside it is looked where the curvature is none: what falls with a higher power of
/// the distance falls by more there.
const REACHES: [f64; 3] = [1.0, 10.0, 100.0];

/// Two places on both sides of the best one, the better one first, with their merits.
pub(super) struct Bracket {
    merits: [f64; 2],
    /// Before and behind the best one.
    along: [f64; 2],
    place: Vec<f64>,
    values: Vec<f64>,
}

impl<F, E> LeastSearch<'_, F>
where
    F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
{
    /// Whether a place beside is better, such as beside a saddle or an inflection; the search goes there.
    pub(super) fn leaves_for_better(&mut self) -> Result<bool, E> {
        self.penalties.iter_mut().for_each(|penalty| *penalty = 2.0 * *penalty + 1.0);
        let is_kinked = self.settle_between_kinks()?;
        let bending = self.bending()?;
        if let Some(Bending { axes, stretch, .. }) = &bending
            && self.is_free()
            && self.leaves_by_newton(axes, stretch, is_kinked)?
        {
            return Ok(true);
        }
        if let Some(best) = self.look_beside()?
            && self.leaves_for(best, LEAST_PROBE_RELATIVE)?
        {
            return Ok(true);
        }
        if let Some(bending) = &bending
            && self.leaves_along(bending)?
        {
            return Ok(true);
        }
        self.bending = bending.filter(|_| !is_kinked);
        self.is_unproven = false;
        // Of so many unknowns that the hull takes too long, planes that were nowhere above the function count.
        let is_many = KINK_HULL_UNKNOWNS[0] < self.place.len() && !self.asked.has_differences;
        let is_shown = is_kinked && is_many && self.is_shown;
        if !is_shown && self.is_beside_kinks(is_kinked)? {
            self.leaves_by_hull()
        } else {
            Ok(false)
        }
    }

    /// By how much the function bends at most along an unknown, as far as both sides of the place tell.
    pub(super) fn bend_beside(&self) -> f64 {
        let bends = self.beside.iter().map(|sides| self.bend(*sides, LEAST_PROBE_RELATIVE).abs());
        bends.filter(|bend| bend.is_finite()).fold(0.0, f64::max)
    }

    /// Whether along each unknown the function bends over a tenth of the way as it does over the whole: across a kink it
    /// bends the more the less of the way is looked at, and beside one not at all.
    pub(super) fn bends_evenly(&mut self) -> Result<bool, E> {
        let reach = 0.1 * LEAST_PROBE_RELATIVE;
        let rounding = KINK_ROUNDINGS * LAST_BIT * self.merit(&self.values).abs();
        for (k, sides) in self.beside.clone().into_iter().enumerate() {
            let far = self.bend(sides, LEAST_PROBE_RELATIVE);
            let near = self.sides(&axis(self.place.len(), k), reach, &[])?.along;
            let near = self.bend(near, reach);
            let unlike = (near - far).abs() - rounding / (reach * reach);
            if 0.5 * near.abs().max(far.abs()) < unlike {
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn bend(&self, [before, behind]: [f64; 2], reach: f64) -> f64 {
        let here = self.merit(&self.values);
        (before - here + (behind - here)) / (reach * reach)
    }

    /// Looks at both sides along each unknown, and keeps what is there; those of which the better one is best.
    pub(super) fn look_beside(&mut self) -> Result<Option<Bracket>, E> {
        let n = self.place.len();
        self.beside.clear();
        let mut best: Option<Bracket> = None;
        for k in 0..n {
            let sides = self.sides(&axis(n, k), LEAST_PROBE_RELATIVE, &[])?;
            self.beside.push(sides.along);
            if best.as_ref().is_none_or(|best| sides.merits[0] < best.merits[0]) {
                best = Some(sides);
            }
        }
        Ok(best)
    }

    /// Goes to a place that is lower than this one, and where nothing holds the unknowns on from it as long as that is twice
    /// as far each time.
    fn leaves_for(&mut self, lower: Bracket, reach: f64) -> Result<bool, E> {
        if !self.is_lower(lower.merits[0], reach) {
            return Ok(false);
        }
        let parts = lower.place.iter().zip(&self.place).zip(&self.units);
        let way: Vec<f64> = parts.map(|((there, here), unit)| (there - here) / unit).collect();
        let mut best = (lower.place, lower.values);
        let mut times = 1.0;
        while self.is_free() && times * reach <= LEAST_FAR {
            let farther = self.moved(&way, 2.0 * times)?;
            if self.merit(&best.1) <= self.merit(&farther.1) {
                break;
            }
            best = farther;
            times *= 2.0;
        }
        self.leave_for(best, times * reach);
        Ok(true)
    }

    /// The places on both sides along a way, led back to where the conditions hold and those that are held are zero.
    fn sides(&mut self, way: &[f64], reach: f64, held: &[usize]) -> Result<Bracket, E> {
        let [before, behind] =
            [self.led_along(way, -reach, held)?, self.led_along(way, reach, held)?];
        let merits = [self.merit(&before.1), self.merit(&behind.1)];
        let along = merits;
        let is_before = merits[0] <= merits[1];
        let merits = if is_before { merits } else { [merits[1], merits[0]] };
        let (place, values) = if is_before { before } else { behind };
        Ok(Bracket { merits, along, place, values })
    }

    /// The place along a way, led back to where the conditions hold and those that are held are zero, and the values there.
    pub(super) fn led_along(
        &mut self,
        way: &[f64],
        reach: f64,
        held: &[usize],
    ) -> Result<(Vec<f64>, Vec<f64>), E> {
        let mut step: Vec<f64> = way.iter().map(|part| reach * part).collect();
        let mut best = self.moved(&step, 1.0)?;
        if held.is_empty() {
            return Ok(best);
        }
        for _ in 0..CONDITION_CORRECTIONS {
            let Some(next) = self.led_back(&step, held)? else { break };
            let taken = next.0.iter().zip(&self.place).zip(&self.units);
            step = taken.map(|((x, from), unit)| (x - from) / unit).collect();
            if self.merit(&next.1) < self.merit(&best.1) {
                best = next;
            }
        }
        Ok(best)
    }

    /// How the function bends along the ways that what holds the place leaves free; none where that is not known.
    fn bending(&mut self) -> Result<Option<Bending>, E> {
        let terms = Terms {
            gradients: &self.slopes,
            values: &self.weighted(&self.values),
            limits: &self.limits(&self.place),
            n_equations: self.problem.n_equations,
        };
        let n = self.place.len();
        let Some(holding) = terms.holding().filter(|_| n <= CURVATURE_UNKNOWNS) else {
            return Ok(None);
        };
        let mut ways = match self.is_free() {
            true => (0..n).map(|k| axis(n, k)).collect(),
            false => free_ways(&holding, n),
        };
        let shares = self.shares(&holding);
        let Some(mut curvature) = self.curvature(&ways, &shares)? else { return Ok(None) };
        let stretch = even_out(&mut ways, &mut curvature);
        let axes = symmetric_axes(curvature);
        let held = holding.iter().map(|condition| condition.idx).collect();
        Ok(Some(Bending { ways, stretch, axes, held, shares }))
    }

    /// Whether a place is lower along a way on which the function does not bend up; the search goes there.
    fn leaves_along(&mut self, Bending { ways, axes, held, .. }: &Bending) -> Result<bool, E> {
        let most = axes.iter().map(|(bend, _)| bend.abs()).fold(0.0, f64::max);
        for (_, axis) in axes.iter().filter(|(bend, _)| *bend <= LEAST_BEND_RELATIVE * most) {
            let part =
                |k: usize| -> f64 { ways.iter().zip(axis).map(|(way, part)| part * way[k]).sum() };
            let way: Vec<f64> = (0..self.place.len()).map(part).collect();
            let length = dot(&way, &way).sqrt();
            let way: Vec<f64> = way.iter().map(|part| part / length).collect();
            for reach in REACHES {
                let reach = reach * LEAST_PROBE_RELATIVE;
                let sides = self.sides(&way, reach, held)?;
                if self.leaves_for(sides, reach)? {
                    return Ok(true);
                }
            }
        }
        Ok(false)
    }

    /// What the function and each condition count for, where some of these hold it.
    fn shares(&self, holding: &[HoldingCondition]) -> Vec<f64> {
        let mut shares = vec![0.0; self.values.len()];
        shares[0] = 1.0;
        for held in holding {
            if let Some(share) = shares.get_mut(held.idx + 1) {
                *share = -held.multiplier;
            }
        }
        shares
    }

    /// The curvature along and between ways of the function with the conditions that hold it: by gradients beside,
    /// or by values where it has none. None where something has no value beside.
    fn curvature(&mut self, ways: &[Vec<f64>], shares: &[f64]) -> Result<Option<Vec<Vec<f64>>>, E> {
        let base = self.inner_place();
        let bends = match self.asked.has_differences {
            true => self.bends_of_values(&base, ways, shares)?,
            false => self.bends_of_gradients(&base, ways, shares)?,
        };
        Ok(Some(bends).filter(|bends| bends.iter().flatten().all(|bend| bend.is_finite())))
    }

    /// The place, or where a bound is near one that leaves room beside it.
    fn inner_place(&self) -> Vec<f64> {
        let rooms = self.problem.bounds.iter().zip(&self.units).map(|([low, high], unit)| {
            let room = (2.0 * LEAST_PROBE_RELATIVE * unit).min(0.5 * (high - low));
            [low + room, high - room]
        });
        clamped(&self.place, &rooms.collect::<Vec<_>>())
    }

    fn bends_of_values(
        &mut self,
        base: &[f64],
        ways: &[Vec<f64>],
        shares: &[f64],
    ) -> Result<Vec<Vec<f64>>, E> {
        let reach = LEAST_PROBE_RELATIVE;
        let mut value_at = |steps: &[(f64, &Vec<f64>)]| {
            let place = self.beside(base, steps);
            let values = self.asked.values(&place)?;
            Ok::<_, E>(dot(&self.weighted(&values), shares))
        };
        let here = value_at(&[])?;
        let mut behind = Vec::with_capacity(ways.len());
        let mut bends = vec![vec![0.0; ways.len()]; ways.len()];
        for (i, way) in ways.iter().enumerate() {
            behind.push(value_at(&[(reach, way)])?);
            let before = value_at(&[(-reach, way)])?;
            bends[i][i] = (behind[i] - here + before - here) / (reach * reach);
            for (j, other) in ways.iter().enumerate().take(i) {
                let both = value_at(&[(reach, way), (reach, other)])?;
                let bend = (both - behind[i] - (behind[j] - here)) / (reach * reach);
                (bends[i][j], bends[j][i]) = (bend, bend);
            }
        }
        Ok(bends)
    }

    fn bends_of_gradients(
        &mut self,
        base: &[f64],
        ways: &[Vec<f64>],
        shares: &[f64],
    ) -> Result<Vec<Vec<f64>>, E> {
        let reaches: Vec<f64> = ways.iter().map(|way| self.curvature_reach(way)).collect();
        let slopes = |gradients: &[Vec<f64>]| slopes_along(ways, gradients, shares);
        let here = match self.is_free() {
            true => slopes(&self.slopes),
            false => slopes(&self.gradients_at(base)?),
        };
        let mut rows = Vec::with_capacity(ways.len());
        for (way, &reach) in ways.iter().zip(&reaches) {
            let there = slopes(&self.gradients_at(&self.beside(base, &[(reach, way)]))?);
            rows.push(
                there.iter().zip(&here).map(|(there, here)| (there - here) / reach).collect(),
            );
        }
        let rows: Vec<Vec<f64>> = rows;
        let mean = |i: usize, j: usize| 0.5 * (rows[i][j] + rows[j][i]);
        Ok((0..ways.len()).map(|i| (0..ways.len()).map(|j| mean(i, j)).collect()).collect())
    }

    /// A place some steps beside another.
    fn beside(&self, base: &[f64], steps: &[(f64, &Vec<f64>)]) -> Vec<f64> {
        let part = |k: usize| -> f64 { steps.iter().map(|(share, way)| share * way[k]).sum() };
        let moved = base.iter().zip(&self.units).enumerate();
        let place: Vec<f64> = moved.map(|(k, (x, unit))| x + part(k) * unit).collect();
        clamped(&place, self.problem.bounds)
    }
}

pub(super) fn axis(n: usize, along: usize) -> Vec<f64> {
    (0..n).map(|k| if k == along { 1.0 } else { 0.0 }).collect()
}

/// Ways of length one at right angles to one another and to what holds a place.
pub(super) fn free_ways(holding: &[HoldingCondition], n: usize) -> Vec<Vec<f64>> {
    let mut left: Vec<Vec<f64>> = (0..n).map(|k| axis(n, k)).collect();
    let mut normals: Vec<Vec<f64>> = holding.iter().map(|held| held.normal.clone()).collect();
    let mut ways = Vec::new();
    let mut n_free = n;
    // The normals first, the longest of what is left of them each time, then the axes.
    while let Some(normal) = longest(&mut normals) {
        project_out(&normal, &mut normals);
        project_out(&normal, &mut left);
        n_free -= 1;
        if n_free == 0 {
            return ways;
        }
    }
    for _ in 0..n_free {
        let Some(way) = longest(&mut left) else { break };
        project_out(&way, &mut left);
        ways.push(way);
    }
    ways
}

/// Takes the longest of some ways out, with its length made one; none where nothing is left of them.
fn longest(ways: &mut Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let length = |way: &[f64]| dot(way, way).sqrt();
    let (idx, most) = (ways.iter().map(|way| length(way)).enumerate())
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .filter(|(_, most)| LEAST_SLOPE_RELATIVE < *most)?;
    Some(ways.swap_remove(idx).into_iter().map(|part| part / most).collect())
}

fn project_out(unit: &[f64], ways: &mut [Vec<f64>]) {
    for way in ways {
        let along = dot(way, unit);
        way.iter_mut().zip(unit).for_each(|(part, unit)| *part -= along * unit);
    }
}
