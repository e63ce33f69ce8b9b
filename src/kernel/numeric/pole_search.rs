//! Poles near the least value that a search found.
//!
//! Towards a pole a function falls over each tenth of the way by no less than over the tenth before, however near that
//! is; towards a least value it falls by less and less, even where its slope has no end there.

use crate::tolerance::{
    LEAST_GAIN_RELATIVE, LEAST_PROBE_RELATIVE, POLE_FALL_RELATIVE, POLE_NEAREST, POLE_SHRINKAGE,
};

/// How many times nearer a function is asked each time whether it looks like a pole, and how many times it is.
const NEARER: f64 = 64.0;
const N_NEARER: i32 = 3;

/// By how many times a function rises more so much farther from its least value, at least, where that is no pole: the
/// root of a distance does by eight.
const LEAST_RISE: f64 = 6.0;

/// Parts of the way to a pole, by equal factors.
const PARTS: usize = 4;

/// How often the way is halved, by its powers, where there is no value at its near end: numbers end there.
const SHORTENINGS: usize = 3;

/// Rounds of steps towards a pole, at most: they come to most of them.
const ROUNDS: usize = 400;

/// More of them are taken up to so many steps: of few unknowns whose sizes differ by the thousand.
const STEPS: usize = 12_288;

/// A value below which numbers end soon.
pub(super) const END_OF_NUMBERS: f64 = -1e150;

/// A place with the value there.
type ValuedPoint = (Vec<f64>, f64);

/// A place that a search came to, and how to go on from it.
pub(super) struct PoleSearch<G, S> {
    /// The best place so far.
    pub(super) best: ValuedPoint,
    /// Ways from a place, the first of which is asked whether anything looks like a pole; by their number.
    pub(super) n_ways: usize,
    /// The place so far along a way from another, with the value there; none where there is none, or not all
    /// conditions hold.
    pub(super) go: G,
    /// How far along a way from a place numbers are apart.
    pub(super) spacing: S,
}

impl<E, G, S> PoleSearch<G, S>
where
    G: FnMut(&[f64], usize, f64) -> Result<Option<ValuedPoint>, E>,
    S: Fn(&[f64], usize) -> f64,
{
    /// The place near which the function falls without bound, if there is one.
    ///
    /// # Errors
    /// Those of the function.
    pub(super) fn pole(mut self, first_ways: &[usize]) -> Result<Option<Vec<f64>>, E> {
        let mut is_steep = self.best.1 < END_OF_NUMBERS;
        for way in first_ways {
            is_steep = is_steep || self.is_steep(*way)?;
        }
        if !is_steep {
            return Ok(None);
        }
        self.approach()?;
        let mut is_pole = self.best.1 < END_OF_NUMBERS && !self.is_corner()?;
        for way in 0..self.n_ways {
            for side in [-1.0, 1.0] {
                is_pole = is_pole || self.falls_on(way, side)?;
            }
        }
        Ok(is_pole.then_some(self.best.0))
    }

    /// The value beside the best place.
    fn value(&mut self, way: usize, reach: f64) -> Result<Option<f64>, E> {
        Ok((self.go)(&self.best.0, way, reach)?.map(|(_, value)| value))
    }

    /// Whether a function rises beside its least value as it only does beside a pole or where its slope has no end, or
    /// falls.
    fn is_steep(&mut self, way: usize) -> Result<bool, E> {
        for side in [-1.0, 1.0] {
            let mut farther: Option<f64> = None;
            for k in 0..N_NEARER {
                let reach = side * LEAST_PROBE_RELATIVE * libm::pow(NEARER, -f64::from(k));
                let Some(value) = self.value(way, reach)? else { continue };
                let rise = value - self.best.1;
                let gain = LEAST_GAIN_RELATIVE * (self.best.1.abs() + rise.abs());
                let is_steep = farther.is_some_and(|farther| farther < LEAST_RISE * rise);
                if rise < -gain || gain < rise && is_steep {
                    return Ok(true);
                }
                farther = Some(rise);
            }
        }
        Ok(false)
    }

    /// Goes to what is lower along each of the ways, by steps of half the length each time that none is, and of twice the
    /// length where one was: unknowns come near one before the other. It ends where numbers do not tell places apart.
    fn approach(&mut self) -> Result<(), E> {
        let mut reach = LEAST_PROBE_RELATIVE;
        for _ in 0..ROUNDS.max(STEPS / self.n_ways.max(1)) {
            if reach <= POLE_NEAREST || self.best.1 <= END_OF_NUMBERS {
                break;
            }
            let (mut is_apart, mut is_lower) = (false, false);
            for way in 0..self.n_ways {
                if (self.spacing)(&self.best.0, way) <= reach {
                    is_apart = true;
                    is_lower |= self.step(way, reach)?;
                }
            }
            if !is_apart {
                break;
            }
            reach = if is_lower { LEAST_PROBE_RELATIVE.min(2.0 * reach) } else { 0.5 * reach };
        }
        Ok(())
    }

    /// Goes one step along a way to what is lower, if that is on either side.
    fn step(&mut self, way: usize, reach: f64) -> Result<bool, E> {
        for side in [-reach, reach] {
            let there = (self.go)(&self.best.0, way, side)?;
            if let Some(there) = there.filter(|(_, value)| *value < self.best.1) {
                self.best = there;
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// How near to the best place a function is asked on a way.
    fn nearest(&self, way: usize) -> f64 {
        NEARER * (self.spacing)(&self.best.0, way).max(POLE_NEAREST)
    }

    /// Whether all ways end at the best place: the value there, however low, is one.
    fn is_corner(&mut self) -> Result<bool, E> {
        for way in 0..self.n_ways {
            if !(self.ends_behind(way, -1.0)? || self.ends_behind(way, 1.0)?) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether a way that comes from one side ends at the best place.
    fn ends_behind(&mut self, way: usize, side: f64) -> Result<bool, E> {
        let nearest = self.nearest(way);
        let behind = (self.go)(&self.best.0, way, -side * nearest)?;
        Ok(behind.is_some_and(|(place, _)| place == self.best.0))
    }

    /// Whether the function falls towards the best place from one side of a way by no less the nearer it is asked. It does
    /// not where the way ends behind that place, on which there is a value.
    fn falls_on(&mut self, way: usize, side: f64) -> Result<bool, E> {
        if self.ends_behind(way, side)? {
            return Ok(false);
        }
        let mut nearest = self.nearest(way);
        for _ in 0..SHORTENINGS {
            let is_told = nearest * NEARER * NEARER < LEAST_PROBE_RELATIVE;
            if is_told && self.value(way, side * nearest)?.is_some() {
                break;
            }
            nearest = (nearest * LEAST_PROBE_RELATIVE).sqrt();
        }
        let part = libm::pow(nearest / LEAST_PROBE_RELATIVE, 1.0 / PARTS as f64);
        let mut values = Vec::with_capacity(PARTS + 1);
        for k in 0..=PARTS {
            let reach = LEAST_PROBE_RELATIVE * libm::pow(part, k as f64);
            let Some(value) = self.value(way, side * reach)? else { return Ok(false) };
            values.push(value);
        }
        let falls: Vec<f64> = values.windows(2).map(|pair| pair[0] - pair[1]).collect();
        // What is far from a pole may change by more, with other terms.
        let near = &falls[1..];
        let goes_on = near.windows(2).all(|pair| POLE_SHRINKAGE * pair[0] <= pair[1]);
        let least = POLE_FALL_RELATIVE * values[PARTS].abs();
        Ok(goes_on && 0.0 < near[0] && least < near.iter().sum())
    }
}
