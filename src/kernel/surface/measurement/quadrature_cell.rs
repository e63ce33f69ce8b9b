//! Cells of an integral over a surface, with what their halves tell of how well they are known.

use std::{cmp::Reverse, collections::BinaryHeap};

use crate::{
    Direction, Interval,
    tolerance::{LAST_BIT, QUADRATURE_RELATIVE},
};

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

/// What of the size of a sum of many terms is rounding.
const ROUNDING: f64 = 64.0 * LAST_BIT;

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

/// What cells sum up to: how much they may be off, their absolute values, and what they are made of.
#[derive(Clone, Copy)]
struct CellTotals<const N: usize> {
    changes: [f64; N],
    absolute: [f64; N],
    parts: [f64; N],
}

impl<const N: usize> CellTotals<N> {
    fn of(cells: &[IntegratedCell<N>]) -> Self {
        let mut totals = Self { changes: [0.0; N], absolute: [0.0; N], parts: [0.0; N] };
        cells.iter().for_each(|cell| totals.add(cell, 1.0));
        totals
    }

    /// Adds a cell, or takes it away.
    fn add(&mut self, cell: &IntegratedCell<N>, sign: f64) {
        for i in 0..N {
            self.changes[i] += sign * cell.change(i);
            self.absolute[i] += sign * cell.absolute[i];
            self.parts[i] += sign * cell.parts[i];
        }
    }
}

/// The cells of an integral, of which the one that changes most is always at hand.
pub(super) struct IntegralCells<const N: usize> {
    cells: Vec<IntegratedCell<N>>,
    totals: CellTotals<N>,
    /// How urgently each is to be cut, as bits of a number that is not negative, and its number.
    queue: BinaryHeap<(u64, Reverse<usize>)>,
    /// For each quantity the number of its kind.
    kinds: [usize; N],
}

impl<const N: usize> IntegralCells<N> {
    pub(super) fn new(cells: Vec<IntegratedCell<N>>, kinds: [usize; N]) -> Self {
        let (totals, queue) = (CellTotals::of(&cells), BinaryHeap::new());
        let mut all = Self { cells, totals, queue, kinds };
        (0..all.cells.len()).for_each(|number| all.wait(number));
        all
    }

    /// Puts a cell into the queue.
    fn wait(&mut self, number: usize) {
        let urgency = self.cells[number].urgency(self.allowed());
        self.queue.push((urgency.to_bits(), Reverse(number)));
    }

    /// Of each quantity the largest of its kind.
    fn largest(&self, sums: [f64; N]) -> [f64; N] {
        let of_kind = |i: usize| (0..N).filter(move |&k| self.kinds[k] == self.kinds[i]);
        std::array::from_fn(|i| of_kind(i).map(|k| sums[k]).fold(0.0, f64::max))
    }

    /// By how much each quantity may be off.
    pub(super) fn allowed(&self) -> [f64; N] {
        let sizes = self.largest(self.totals.absolute);
        let made_of = self.largest(self.totals.parts);
        std::array::from_fn(|i| {
            QUADRATURE_RELATIVE * sizes[i] + ROUNDING * made_of[i] + f64::MIN_POSITIVE
        })
    }

    /// Whether the integral is beyond numbers.
    pub(super) fn is_beyond_numbers(&self) -> bool {
        let CellTotals { changes, absolute, parts } = &self.totals;
        !changes.iter().chain(absolute).chain(parts).all(|sum| sum.is_finite())
    }

    fn is_done(&self) -> bool {
        self.totals.changes.into_iter().zip(self.allowed()).all(|(change, most)| change <= most)
    }

    /// The cell that is to be cut next; none where what all may be off is allowed.
    pub(super) fn most_urgent(&mut self) -> Option<usize> {
        if self.is_done() {
            // What was added and taken away has rounding.
            self.totals = CellTotals::of(&self.cells);
            if self.is_done() {
                return None;
            }
        }
        self.queue.pop().map(|(_, Reverse(number))| number)
    }

    pub(super) fn cell(&self, number: usize) -> &IntegratedCell<N> {
        &self.cells[number]
    }

    /// Puts the halves of a cell in its place.
    pub(super) fn replace(&mut self, number: usize, [first, second]: [IntegratedCell<N>; 2]) {
        self.totals.add(&self.cells[number], -1.0);
        self.totals.add(&first, 1.0);
        self.totals.add(&second, 1.0);
        self.cells[number] = first;
        self.cells.push(second);
        self.wait(number);
        self.wait(self.cells.len() - 1);
    }

    pub(super) fn values(&self) -> [f64; N] {
        std::array::from_fn(|i| self.cells.iter().map(|cell| cell.values[i]).sum())
    }

    /// How far each quantity may be off, and the sizes of their kinds, with what they were at some time before, unless
    /// what they may be off is allowed.
    pub(super) fn errors_and_sizes(mut self, before: Option<[f64; N]>) -> [[f64; N]; 2] {
        self.totals = CellTotals::of(&self.cells);
        let values = self.values();
        let since = before.filter(|_| !self.is_done()).unwrap_or(values);
        let error = |i: usize| {
            let rounding = LAST_BIT * self.totals.parts[i];
            self.totals.changes[i].max((values[i] - since[i]).abs()).max(rounding)
        };
        [std::array::from_fn(error), self.largest(self.totals.absolute)]
    }
}
