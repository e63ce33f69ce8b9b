//! The search for the zero set of a polynomial on a Bézier patch.
//!
//! A cell whose coefficients have one sign is dropped. One where a slope has one sign holds graphs,
//! whose ends are roots on its sides. All others are cut, until what is left is smaller than the
//! tolerance, or rounding: places where the slopes vanish, where branches cross or the field only
//! touches zero. Of a zero set that counts under conditions only, such as on the lit side, cells
//! where one fails are dropped, and those cut where it is open.

use std::{cell::LazyCell, ops::Mul};

use super::{branch::Branch, resting_place::FieldSlopes};
use crate::{
    Direction, Grid, Interval, bernstein,
    ceiling::{CELLS, MANY_CELLS},
    numeric::polynomial_roots::Signs,
    surface::intersection::square,
    work,
};

/// Where cells are cut: no half, so that lines of round parameters are not sides of cells.
const CUT: f64 = 0.4871;

/// Places of a candidate for a line of contact where the field is looked at.
const N_PROBES: usize = 7;

/// A part of a patch, with the field on it.
#[derive(Clone, Debug)]
pub(super) struct PatchCell {
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
    field: Grid<f64>,
    conditions: Vec<PositivityCondition>,
}

/// A polynomial that must not be negative.
#[derive(Clone, Debug)]
pub(super) struct PositivityCondition {
    pub(super) values: Grid<f64>,
    /// Coefficients up to this are rounding.
    pub(super) rounding: f64,
}

/// What the field's zero set on one patch consists of.
#[derive(Debug, Default)]
pub(super) struct PatchZeroSet {
    pub(super) branches: Vec<Branch>,
    /// Middles and extents, by fractions of the patch, of cells that are left.
    pub(super) rest: Vec<[[f64; 2]; 2]>,
}

/// Why a search has no result.
#[derive(Clone, Copy, Debug)]
pub(super) enum SearchFailure {
    /// A place, by fractions of the patch, around which the zeros do not resolve.
    Unresolved([f64; 2]),
    /// The work was ended.
    Ended,
}

/// How finely a patch is searched.
#[derive(Clone, Copy, Debug)]
pub(super) struct SearchResolution {
    /// Coefficients up to this are rounding.
    pub(super) rounding: f64,
    /// How far a step over the whole patch may lead in space, along u and along v.
    pub(super) extents: [f64; 2],
    /// The size in space of cells that are not cut.
    pub(super) tolerance: f64,
}

impl PatchCell {
    fn parts(&self, along: Direction) -> [Self; 2] {
        let cut = |field: &Grid<f64>| match along {
            Direction::U => square::cut_v(&field.transposed(), CUT).map(|field| field.transposed()),
            Direction::V => square::cut_v(field, CUT),
        };
        let middle = self.low[along] * (1.0 - CUT) + self.high[along] * CUT;
        let mut parts = cut(&self.field).map(|field| {
            let conditions = Vec::with_capacity(self.conditions.len());
            Self { low: self.low, high: self.high, field, conditions }
        });
        for PositivityCondition { values, rounding } in &self.conditions {
            for (part, values) in parts.iter_mut().zip(cut(values)) {
                part.conditions.push(PositivityCondition { values, rounding: *rounding });
            }
        }
        (parts[0].high[along], parts[1].low[along]) = (middle, middle);
        parts
    }

    /// Whether a condition fails all over; those that hold all over are taken away.
    fn fails(&mut self) -> bool {
        let range = |condition: &PositivityCondition| square::range(&condition.values);
        let fails = |condition: &PositivityCondition| range(condition)[1] < -condition.rounding;
        if self.conditions.iter().any(fails) {
            return true;
        }
        self.conditions.retain(|condition| range(condition)[0] < -condition.rounding);
        false
    }

    /// The direction in which it is longer: in space, or, where a search is long, by how much the field
    /// changes. About places where many lines end these can be much closer to one another than they
    /// are long.
    fn longer(&self, extents: [f64; 2], by_change: bool) -> Direction {
        let longer = |[u, v]: [f64; 2]| if u < v { Direction::V } else { Direction::U };
        if !by_change {
            return longer(extents);
        }
        let change = |field: &Grid<f64>| {
            let [least, most] = square::range(&square::slope_u(field));
            most.max(-least)
        };
        longer([change(&self.field), change(&self.field.transposed())])
    }

    /// Its widths along u and v.
    fn widths(&self) -> [f64; 2] {
        [0, 1].map(|i| self.high[i] - self.low[i])
    }
}

/// The zero set of a field where the conditions hold; `n_left` cells may be looked at.
///
/// # Errors
/// A place, by fractions of the patch, around which it does not resolve; where the work was ended.
pub(super) fn search(
    field: Grid<f64>,
    conditions: Vec<PositivityCondition>,
    fineness: SearchResolution,
    n_left: &mut usize,
) -> Result<PatchZeroSet, SearchFailure> {
    let mut found = PatchZeroSet::default();
    let whole = field.clone();
    let slopes = LazyCell::new(|| FieldSlopes::of(&whole));
    let is_crossing = |place: [f64; 2]| slopes.bends_both_ways(place, fineness.extents);
    let mut todo = vec![PatchCell { low: [0.0; 2], high: [1.0; 2], field, conditions }];
    while let Some(mut cell) = todo.pop() {
        let middle = [0, 1].map(|i| 0.5 * (cell.low[i] + cell.high[i]));
        if *n_left == 0 {
            return Err(SearchFailure::Unresolved(middle));
        }
        if !work::goes_on(1) {
            return Err(SearchFailure::Ended);
        }
        *n_left -= 1;
        let [least, most] = square::range(&cell.field);
        if fineness.rounding < least || most < -fineness.rounding || cell.fails() {
            continue;
        }
        let is_open = !cell.conditions.is_empty();
        let branches = (!is_open)
            .then(|| {
                graphs(&cell, &cell.field, fineness.rounding)
                    .or_else(|| contacts(&cell, fineness.rounding, is_crossing))
            })
            .flatten();
        if let Some(branches) = branches {
            found.branches.extend(branches);
            continue;
        }
        let widths = cell.widths();
        let extents = [0, 1].map(|i| fineness.extents[i] * widths[i]);
        let is_small = extents[0].max(extents[1]) <= fineness.tolerance;
        let is_rounding = most.max(-least) <= fineness.rounding;
        if is_small || is_rounding && !is_open {
            if !is_open {
                found.rest.push([middle, widths]);
            }
            continue;
        }
        let is_long = *n_left + MANY_CELLS < CELLS;
        let by_change = is_long && is_open && fineness.tolerance < extents[0].min(extents[1]);
        todo.extend(cell.parts(cell.longer(extents, by_change)));
    }
    Ok(found)
}

/// The branches in a cell where one of the slopes has one sign for certain; none are told where the
/// field only touches zero on a side, which takes a closer look.
fn graphs(cell: &PatchCell, field: &Grid<f64>, rounding: f64) -> Option<Vec<Branch>> {
    let swapped = field.transposed();
    let by_v = steadiness(&swapped, rounding);
    let by_u = steadiness(field, rounding);
    if by_u == 0.0 && by_v == 0.0 {
        return None;
    }
    let (rising, is_swapped, steady) = match by_u.abs() <= by_v.abs() {
        true => (field, false, by_v),
        false => (&swapped, true, by_u),
    };
    let branches =
        Branch::all([cell.low, cell.high], rising.clone(), is_swapped, 0.0 < steady, rounding);
    (!branches.is_empty() || !touches_low_side(rising, 0.0 < steady, rounding)).then_some(branches)
}

/// Whether the side on which a field that rises or falls along v is lowest may touch zero.
fn touches_low_side(field: &Grid<f64>, is_rising: bool, rounding: f64) -> bool {
    let last = field.n_columns() - 1;
    let lowest = |values: Vec<f64>| values.into_iter().fold(f64::INFINITY, f64::min);
    let highest = |values: Vec<f64>| values.into_iter().fold(f64::NEG_INFINITY, f64::max);
    let (low, high) = if is_rising { (0, last) } else { (last, 0) };
    lowest(field.column(low)) <= rounding && -rounding <= highest(field.column(high))
}

/// How little the slope along u varies if it has one sign: the sign, times up to one; zero if it
/// has none.
fn steadiness(field: &Grid<f64>, rounding: f64) -> f64 {
    let slack = 2.0 * field.n_rows() as f64 * rounding;
    let [least, most] = square::range(&square::slope_u(field));
    if slack < least {
        least / most
    } else if most < -slack {
        -(most / least)
    } else {
        0.0
    }
}

/// Branches along which the field touches zero: there a slope vanishes whose own slope has one
/// sign, so that the field is nowhere else zero. In small cells also a field that crosses zero twice is zero along such
/// a branch, to rounding; `is_crossing` tells its places.
fn contacts(
    cell: &PatchCell,
    rounding: f64,
    is_crossing: impl Fn([f64; 2]) -> bool,
) -> Option<Vec<Branch>> {
    let touches = |branch: &Branch| {
        (0..=N_PROBES).all(|i| {
            let place = branch.place(i as f64 / N_PROBES as f64);
            let local = [0, 1].map(|k| (place[k] - cell.low[k]) / cell.widths()[k]);
            square::value(&cell.field, local).abs() <= rounding && !is_crossing(place)
        })
    };
    let along = |slopes: Grid<f64>, is_swapped: bool| {
        let (whole, field) = match is_swapped {
            true => (cell.field.transposed(), slopes.transposed()),
            false => (cell.field.clone(), slopes),
        };
        let bend = steadiness(&field.transposed(), rounding);
        if bend == 0.0 || !keeps_sign_on_sides(&whole, bend, rounding) {
            return None;
        }
        let branches = Branch::all([cell.low, cell.high], field, is_swapped, 0.0 < bend, rounding);
        let are_touching = !branches.is_empty() && branches.iter().all(touches);
        are_touching.then_some(branches)
    };
    along(square::slope_v(&cell.field), false).or_else(|| along(square::slope_u(&cell.field), true))
}

/// Whether a field that bends to one side along v is on that side of zero where v begins and ends. What
/// only touches zero between is so; where it is not, the line of least slope leaves the cell and the field
/// crosses zero beside it.
fn keeps_sign_on_sides(field: &Grid<f64>, bend: f64, rounding: f64) -> bool {
    [0, field.n_columns() - 1].into_iter().all(|column| {
        let side: Vec<f64> =
            field.column(column).iter().map(|value| value * bend.signum()).collect();
        let mut signs = Signs::default();
        signs.follow(Interval::UNIT, &side, rounding);
        signs.changes().is_empty() && -rounding <= bernstein::value(&side, 0.5)
    })
}

/// Sides of a patch: which parameter is constant, and at which end.
pub(super) type PatchSides = Vec<(usize, f64)>;

/// The field without the factors that vanish along sides of the patch, and these sides. `None`
/// where nothing is left; `is_small` tells which coefficients are rounding.
pub(super) fn without_sides<T: Copy + Mul<f64, Output = T>>(
    field: &Grid<T>,
    is_small: impl Fn(&T) -> bool,
) -> Option<(Grid<T>, PatchSides)> {
    let mut field = field.clone();
    let mut sides = Vec::new();
    // Each of the four in turn, as often as it is a factor.
    for (constant, end) in [(0, 0.0), (0, 1.0), (1, 0.0), (1, 1.0)] {
        let field_seen = if constant == 0 { field.clone() } else { field.transposed() };
        let mut turned = if end > 0.5 { square::turned_u(&field_seen) } else { field_seen };
        let mut n_factors = 0;
        while turned.row(0).iter().all(&is_small) {
            if turned.n_rows() == 1 {
                return None;
            }
            turned = square::over_u(&turned);
            n_factors += 1;
        }
        if 0 < n_factors {
            sides.push((constant, end));
            let back = if end > 0.5 { square::turned_u(&turned) } else { turned };
            field = if constant == 0 { back } else { back.transposed() };
        }
    }
    Some((field, sides))
}
