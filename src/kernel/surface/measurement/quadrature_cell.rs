//! Cells of an integral over a surface, with what their halves tell of how well they are known.

use crate::{Direction, Interval, tolerance::LAST_BIT};

/// A rectangle of parameters of a part of the surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct QuadratureCell {
    pub(super) part: usize,
    pub(super) u: Interval,
    pub(super) v: Interval,
}

/// A quantity over a cell, its absolute value, and what it is made of.
#[derive(Clone, Copy, Debug)]
pub(super) struct CellEstimate<const N: usize> {
    pub(super) values: [f64; N],
    pub(super) absolute: [f64; N],
    pub(super) parts: [f64; N],
}

/// A cell with its integral by the whole, and by the halves along u and along v.
pub(super) struct IntegratedCell<const N: usize> {
    pub(super) cell: QuadratureCell,
    /// None along a way along which the whole is exact.
    pub(super) halves: [Option<[CellEstimate<N>; 2]>; 2],
    pub(super) values: [f64; N],
    pub(super) absolute: [f64; N],
    pub(super) parts: [f64; N],
    /// How much the halves differ from the whole, along u and along v.
    pub(super) changes: [[f64; N]; 2],
    /// By how much more than the changes it may be off.
    factors: [[f64; N]; 2],
}

/// Changes that hardly fade are not taken to go on for longer than this many times the last.
const MOST_TO_COME: f64 = 64.0;

/// Cells whose changes are this fraction of the largest change nearly as much.
const NEARLY: f64 = 0.25;

/// What of the size of a sum of many terms is rounding.
pub(super) const ROUNDING: f64 = 64.0 * LAST_BIT;

impl<const N: usize> IntegratedCell<N> {
    pub(super) fn new(
        cell: QuadratureCell,
        whole: CellEstimate<N>,
        halves: [Option<[CellEstimate<N>; 2]>; 2],
    ) -> Self {
        let sum = |[a, b]: &[CellEstimate<N>; 2], i: usize| a.values[i] + b.values[i];
        let change = |pair: &Option<[CellEstimate<N>; 2]>, i: usize| {
            pair.as_ref().map_or(0.0, |pair| sum(pair, i) - whole.values[i])
        };
        let changes = halves.each_ref().map(|pair| std::array::from_fn(|i| change(pair, i)));
        // What either pair of halves corrects.
        let values = std::array::from_fn(|i| whole.values[i] + changes[0][i] + changes[1][i]);
        let finest = halves.iter().flatten().next();
        let of_finest = |of: fn(&CellEstimate<N>) -> &[f64; N]| -> [f64; N] {
            finest.map_or(*of(&whole), |[a, b]| std::array::from_fn(|i| of(a)[i] + of(b)[i]))
        };
        let absolute = of_finest(|estimate| &estimate.absolute);
        let parts = of_finest(|estimate| &estimate.parts);
        let changes = changes.map(|change: [f64; N]| change.map(f64::abs));
        Self { cell, halves, values, absolute, parts, changes, factors: [[1.0; N]; 2] }
    }

    /// With what is known from the cell of which it is a half along a direction.
    pub(super) fn after(mut self, whole: &Self, direction: Direction) -> Self {
        self.factors = whole.factors;
        for i in 0..N {
            let (change, before) = (self.changes[direction][i], whole.changes[direction][i]);
            let is_rounding = change <= ROUNDING * self.absolute[i].max(self.parts[i]);
            let to_come = if is_rounding { 1.0 } else { change / (before - change).max(0.0) };
            self.factors[direction][i] = to_come.clamp(1.0, MOST_TO_COME);
        }
        self
    }

    /// How far quantity `i` may be off.
    pub(super) fn change(&self, i: usize) -> f64 {
        [0, 1].map(|along| self.factors[along][i] * self.changes[along][i]).into_iter().sum()
    }

    /// The largest change as a fraction of what is allowed.
    pub(super) fn urgency(&self, allowed: [f64; N]) -> f64 {
        (0..N).map(|i| self.change(i) / allowed[i]).fold(0.0, f64::max)
    }

    /// The parameter by which it changes more: u or v.
    pub(super) fn direction(&self, allowed: [f64; N]) -> Direction {
        let along = |along: Direction| {
            let change = |i: usize| self.factors[along][i] * self.changes[along][i];
            (0..N).map(|i| change(i) / allowed[i]).fold(0.0, f64::max)
        };
        let [u, v] = Direction::BOTH.map(along);
        if u < v { Direction::V } else { Direction::U }
    }
}

impl QuadratureCell {
    /// The halves across u or across v.
    pub(super) fn halves(self, direction: Direction) -> [Self; 2] {
        let Self { part, u, v } = self;
        match direction {
            Direction::U => u.halves().map(|u| Self { part, u, v }),
            Direction::V => v.halves().map(|v| Self { part, u, v }),
        }
    }
}

/// Which cells are cut next, at most so many: those that change nearly as much as the one that changes most, down to
/// where what all others change together is allowed, so that they need not be looked at one by one.
pub(super) fn cells_to_cut<const N: usize>(
    all: &[IntegratedCell<N>],
    mut changes: [f64; N],
    allowed: [f64; N],
    n_most: usize,
) -> Vec<bool> {
    let mut order: Vec<(f64, usize)> =
        all.iter().enumerate().map(|(idx, cell)| (cell.urgency(allowed), idx)).collect();
    order.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let mut is_cut = vec![false; all.len()];
    let least = order.first().map_or(0.0, |(most, _)| NEARLY * most);
    for (_, idx) in order.into_iter().take(n_most).take_while(|(urgency, _)| least <= *urgency) {
        is_cut[idx] = true;
        changes.iter_mut().enumerate().for_each(|(i, left)| *left -= all[idx].change(i));
        if (0..N).all(|i| changes[i] <= allowed[i]) {
            break;
        }
    }
    is_cut
}
