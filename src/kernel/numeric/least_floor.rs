//! Whether what a search for a least value found is one, by other sizes than those that it began with.
//!
//! The sizes of unknowns at a start may be far from those over which a function bends: beside its end it is asked nearer,
//! where an unknown came to be small beside its size, and farther off, as long as rounding hides whether it rises. What
//! rises on one side alone has come to a level: it lies there if it came down to that at a place, and tends to what it
//! attains nowhere if it came nearer and nearer.

use super::{
    answers::{Answers, Wanted},
    least_beside::axis,
    least_problem::LeastEnd,
    least_search::LeastSearch,
};
use crate::{
    ceiling::EDGE_HALVINGS,
    tolerance::{
        LAST_BIT, LEAST_FAR, LEAST_LEVEL_RELATIVE, LEAST_LOWER_RELATIVE, LEAST_PROBE_RELATIVE,
        LEVEL_APPROACH, LEVEL_SHARE,
    },
};

/// By how many times nearer a function is asked each time, and how many times.
const NEARER: f64 = 1e3;
const N_NEARER: usize = 2;

/// By how many times farther off it is asked each time.
const FARTHER: f64 = 100.0;

/// Last bits of a value that a change of it must have to be seen.
const ROUNDINGS: f64 = 16.0;

/// How many times the unknowns' sizes away it is asked still farther off.
const FAR_OUT: f64 = 10.0;

/// How many times farther each time.
const OUTWARD: f64 = 8.0;

/// The share of the way to where a function became level up to which it was not yet.
const EDGE_WIDTH: f64 = 0.995;

/// How often it is looked behind what seemed level whether it falls on there.
const LEVEL_ROUNDS: usize = 3;

/// Unknowns that are looked along one by one; of more, along all together.
const MOST_NEARER: usize = 3;

/// What is beside the place at which a search settled.
pub(super) enum Floor {
    /// Nothing that is lower.
    Told,
    /// A place that is lower.
    Lower(Vec<f64>),
    /// That it does not settle there.
    Other(LeastEnd),
}

/// What a function does on one side of a place.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Hidden,
    Higher,
}

impl<F, E> LeastSearch<'_, F>
where
    F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
{
    /// What is beside the place at which the search settled, where no condition tells of other sizes; `first` is where the
    /// first of its rounds began. It may rest where all around is as low.
    pub(super) fn floor(&mut self, first: &[f64], may_rest: bool) -> Result<Floor, E> {
        if 1 < self.values.len() {
            return Ok(Floor::Told);
        }
        let n = self.place.len();
        let unbounded: Vec<usize> = (0..n)
            .filter(|&k| self.problem.bounds[k].iter().any(|end| end.is_infinite()))
            .collect();
        let small: Vec<usize> = (unbounded.iter().copied())
            .filter(|&k| self.place[k].abs() < LEAST_PROBE_RELATIVE * self.units[k])
            .collect();
        if let Some(lower) = self.lower_nearer(&small)? {
            return Ok(Floor::Lower(lower));
        }
        if self.beside.len() != n {
            self.look_beside()?;
        }
        let mut n_hidden = 0;
        for &k in &unbounded {
            let mut sides = [0, 1].map(|side| self.side(self.beside[k][side]));
            if let Some(lower) = self.lower_farther(k, &mut sides)? {
                return Ok(Floor::Lower(lower));
            }
            if let Some(lower) = self.lower_outward(k, first[k], &mut sides)? {
                return Ok(Floor::Lower(lower));
            }
            match sides {
                [Side::Higher, Side::Higher] => {}
                [Side::Hidden, Side::Hidden] => n_hidden += 1,
                _ if self.tends(k, first[k])? => {
                    return Ok(Floor::Other(LeastEnd::Unattained));
                }
                _ => {}
            }
        }
        match 0 < n && n_hidden == n {
            true => self.level(&unbounded, first, may_rest),
            false => Ok(Floor::Told),
        }
    }

    /// Whether the function is the same on both sides in each unknown, and by two oblique ways as well.
    pub(super) fn is_flat(&mut self) -> Result<bool, E> {
        let n = self.place.len();
        let along = (0..n).map(|k| (0..n).map(|i| if i == k { 1.0 } else { 0.0 }).collect());
        let oblique = [2.0, 3.0].map(|turn| (0..n).map(|k| libm::cos(turn * k as f64)).collect());
        let ways: Vec<Vec<f64>> = along.chain(oblique).collect();
        for way in &ways {
            for side in [-LEAST_PROBE_RELATIVE, LEAST_PROBE_RELATIVE] {
                #[expect(clippy::float_cmp, reason = "a flat function yields one number")]
                if self.moved(way, side)?.1[0] != self.values[0] {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }

    /// What a place is all around which rounding hides what the function does.
    fn level(&mut self, along: &[usize], first: &[f64], may_rest: bool) -> Result<Floor, E> {
        if !may_rest {
            return Ok(Floor::Other(LeastEnd::Flat));
        }
        for &k in along {
            if self.tends(k, first[k])? {
                return Ok(Floor::Other(LeastEnd::Unattained));
            }
        }
        let here = self.merit(&self.values);
        let is_level = |&k: &usize| self.beside[k].iter().all(|merit| (merit - here).abs() <= 0.0);
        let is_plateau = along.iter().all(is_level);
        Ok(if is_plateau { Floor::Told } else { Floor::Other(LeastEnd::Flat) })
    }

    /// A lower place farther out from zero along an unknown that is many times its size away; where the function is no
    /// higher there, that side of it is hidden: the search came to where rounding hides how it falls.
    fn lower_outward(
        &mut self,
        k: usize,
        first: f64,
        sides: &mut [Side; 2],
    ) -> Result<Option<Vec<f64>>, E> {
        let out = self.place[k] / self.units[k];
        let size = if first == 0.0 { self.units[k] } else { self.units[k].min(first.abs()) };
        if sides.contains(&Side::Hidden) || self.place[k].abs() < FAR_OUT * size {
            return Ok(None);
        }
        let way: Vec<f64> = axis(self.place.len(), k).iter().map(|part| part * out).collect();
        let most = LEAST_FAR * self.place[k].abs().max(1.0).max(self.units[k]);
        let (mut lower, mut least) = (None, self.merit(&self.values));
        let mut times = OUTWARD;
        while times * self.place[k].abs() <= most {
            let (place, values) = self.moved(&way, times - 1.0)?;
            let merit = self.merit(&values);
            if merit.is_infinite() {
                // Numbers end there.
                break;
            }
            if least < merit || self.is_still(k, &place) {
                return Ok(None);
            }
            if lower.is_none() && self.is_lower(merit, times) {
                lower = Some(place);
            }
            least = merit;
            times *= OUTWARD;
        }
        sides[usize::from(0.0 < out)] = Side::Hidden;
        Ok(lower)
    }

    /// Whether an unknown is the same at another place.
    fn is_still(&self, k: usize, place: &[f64]) -> bool {
        (place[k] - self.place[k]).abs() <= 0.0
    }

    /// A change of the value here that rounding does not hide.
    fn visible(&self) -> f64 {
        ROUNDINGS * LAST_BIT * self.merit(&self.values).abs()
    }

    fn side(&self, merit: f64) -> Side {
        let rise = merit - self.merit(&self.values);
        if rise <= self.visible() { Side::Hidden } else { Side::Higher }
    }

    /// A lower place nearer beside this one than the unknowns' sizes tell to look, along some of them.
    fn lower_nearer(&mut self, along: &[usize]) -> Result<Option<Vec<f64>>, E> {
        let n = self.place.len();
        let is_along = |k: usize| along.contains(&k);
        let oblique = [1.0, -1.0].map(|turn| -> Vec<f64> {
            let part = |k: usize| if k.is_multiple_of(2) { 1.0 } else { turn };
            (0..n).map(|k| if is_along(k) { part(k) } else { 0.0 }).collect()
        });
        let mut ways: Vec<Vec<f64>> = match along.len() {
            0..=MOST_NEARER => along.iter().map(|&k| axis(n, k)).collect(),
            _ => Vec::new(),
        };
        if 1 < along.len() {
            ways.extend(oblique);
        }
        for way in ways {
            let mut reach = LEAST_PROBE_RELATIVE;
            for _ in 0..N_NEARER {
                reach /= NEARER;
                for side in [-reach, reach] {
                    let (place, values) = self.moved(&way, side)?;
                    if self.is_lower(self.merit(&values), reach.abs()) {
                        return Ok(Some(place));
                    }
                }
            }
        }
        Ok(None)
    }

    /// A lower place farther off along an unknown, on those of its sides on which rounding hides what the function does;
    /// they become higher where it rises first.
    fn lower_farther(&mut self, k: usize, sides: &mut [Side; 2]) -> Result<Option<Vec<f64>>, E> {
        let way = axis(self.place.len(), k);
        let most = LEAST_FAR * self.place[k].abs().max(1.0).max(self.units[k]);
        let mut reach = LEAST_PROBE_RELATIVE * FARTHER;
        while sides.contains(&Side::Hidden) && reach * self.units[k] <= most {
            for (side, sign) in sides.iter_mut().zip([-1.0, 1.0]) {
                if *side == Side::Higher {
                    continue;
                }
                let (place, values) = self.moved(&way, sign * reach)?;
                let merit = self.merit(&values);
                if self.is_lower(merit, reach) {
                    return Ok(Some(place));
                }
                // A bound ends a way.
                let is_held = self.is_still(k, &place);
                *side = if is_held { Side::Higher } else { self.side(merit) };
            }
            reach *= FARTHER;
        }
        Ok(None)
    }

    /// Whether the function came nearer and nearer to the value here along an unknown, from where that began, rather than
    /// down to it at a place.
    fn tends(&mut self, k: usize, first: f64) -> Result<bool, E> {
        let here = self.merit(&self.values);
        let is_sloped = self.slopes.first().is_some_and(|slopes| 0.0 < slopes[k].abs());
        let mut from = 0.0;
        for round in 0..LEVEL_ROUNDS {
            let whole = self.rise_before(k, first, from)?;
            if whole.is_nan() || whole <= LEAST_LOWER_RELATIVE * here.abs() {
                // It lies level where it began, if it has no slope.
                return Ok(round == 0 && is_sloped);
            }
            // Of few digits above rounding little can be told.
            if 0 < round && LEAST_LEVEL_RELATIVE * whole < self.visible() {
                break;
            }
            let [before, level] = self.level_from(k, first, (from, whole))?;
            let share = from + 0.9 * (level.0 - from);
            let near = self.rise_before(k, first, share)?;
            let powers = [near / before.1, whole / before.1].map(libm::log);
            if near < LEVEL_SHARE * whole && powers[0] < LEVEL_APPROACH * powers[1] {
                return Ok(true);
            }
            from = level.0;
        }
        Ok(false)
    }

    /// By how much the function is higher than here at a share of the way to here along an unknown from where that began.
    fn rise_before(&mut self, k: usize, first: f64, share: f64) -> Result<f64, E> {
        let back = (first - self.place[k]) / self.units[k];
        let way: Vec<f64> = axis(self.place.len(), k).iter().map(|part| part * back).collect();
        let values = self.moved(&way, 1.0 - share)?.1;
        Ok(self.merit(&values) - self.merit(&self.values))
    }

    /// Shares of that way, the one close behind the other, before and behind which the function becomes level, with how much
    /// higher it is there; from one on at which it is so much higher.
    fn level_from(
        &mut self,
        k: usize,
        first: f64,
        (from, whole): (f64, f64),
    ) -> Result<[(f64, f64); 2], E> {
        let level = self.visible().max(LEAST_LEVEL_RELATIVE * whole);
        let mut edge = [(from, whole), (1.0, 0.0)];
        for _ in 0..EDGE_HALVINGS {
            if EDGE_WIDTH * (edge[1].0 - from) < edge[0].0 - from {
                break;
            }
            let share = 0.5 * (edge[0].0 + edge[1].0);
            let rise = self.rise_before(k, first, share)?;
            edge[usize::from(rise <= level)] = (share, rise);
        }
        Ok(edge)
    }
}
