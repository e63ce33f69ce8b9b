//! Slopes of control points that are made where they are asked for: few of them act at a place of a curve, and what is
//! integrated along it asks for one sum of all.

use std::{
    fmt,
    ops::Range,
    sync::{
        OnceLock,
        atomic::{AtomicUsize, Ordering},
    },
};

use glam::{DVec3, DVec4};

use super::{listed::ListedSlopes, rows::VariableRows};
use crate::{Grid, work};

/// The slopes of a sum of control points, with a factor for each, by each of some variables.
pub(crate) type SumsOfSlopes = dyn Fn(&[f64]) -> Vec<DVec3> + Send + Sync;

/// The slopes of all control points at once, by each of the variables; none where they are not found so.
pub(crate) type AllSlopes = dyn Fn() -> Option<Vec<Vec<DVec4>>> + Send + Sync;

/// Two ways to the same slopes.
pub(crate) struct SlopeWays {
    /// For few control points, or a sum of all.
    pub(crate) sums: Box<SumsOfSlopes>,
    pub(crate) all: Box<AllSlopes>,
}

/// Slopes of polynomial control points, by sums of them.
pub(super) struct AskedSlopes {
    /// By which variables, in order.
    variables: Vec<usize>,
    ways: SlopeWays,
    /// Those of each point, by each of the variables.
    by_point: Vec<OnceLock<Vec<DVec3>>>,
    /// How many sums were found as such, not by their points.
    n_sums: AtomicUsize,
    /// All of them.
    listed: OnceLock<ListedSlopes>,
}

impl fmt::Debug for AskedSlopes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("AskedSlopes").field("variables", &self.variables).finish_non_exhaustive()
    }
}

impl AskedSlopes {
    pub(super) fn new(n_points: usize, variables: Vec<usize>, ways: SlopeWays) -> Self {
        let by_point = std::iter::repeat_with(OnceLock::new).take(n_points).collect();
        Self { variables, ways, by_point, n_sums: AtomicUsize::new(0), listed: OnceLock::new() }
    }

    pub(super) fn variables(&self) -> &[usize] {
        &self.variables
    }

    /// Adds the slopes of a sum of the points, with a factor for each, to those by all variables.
    pub(super) fn add_sum(&self, factors: &[f64], total: &mut [DVec3]) {
        if factors.iter().all(|factor| factor.abs() <= 0.0) {
            return;
        }
        let own = (self.ways.sums)(factors);
        self.variables.iter().zip(own).for_each(|(&variable, slope)| total[variable] += slope);
    }

    pub(super) fn is_fixed(&self) -> bool {
        self.variables.is_empty()
    }

    /// The slopes of a point by each of the variables; zero where work was ended.
    fn of_point(&self, point: usize) -> &[DVec3] {
        self.by_point[point].get_or_init(|| {
            if !work::goes_on(1) {
                return vec![DVec3::ZERO; self.variables.len()];
            }
            let mut factors = vec![0.0; self.by_point.len()];
            factors[point] = 1.0;
            (self.ways.sums)(&factors)
        })
    }

    /// The slopes of all points; zero where work was ended.
    pub(super) fn listed(&self) -> &ListedSlopes {
        self.listed.get_or_init(|| {
            let of = |idx: usize| {
                let point = |point| self.of_point(point)[idx].extend(0.0);
                (0..self.by_point.len()).map(point).collect()
            };
            let one_by_one = || (0..self.variables.len()).map(of).collect();
            let all = (self.ways.all)().unwrap_or_else(one_by_one);
            ListedSlopes::new(self.variables.iter().copied().zip(all).collect())
        })
    }

    /// Adds the slopes by all variables of something with this gradient by the control points.
    pub(super) fn add_through(&self, gradient: &[DVec4], all: &mut [f64]) {
        for axis in 0..3 {
            let factors: Vec<f64> = gradient.iter().map(|own| own[axis]).collect();
            if factors.iter().all(|factor| factor.abs() <= 0.0) {
                continue;
            }
            for (&variable, slope) in self.variables.iter().zip((self.ways.sums)(&factors)) {
                all[variable] += slope[axis];
            }
        }
    }

    /// Sums of the slopes of points in some ranges, with a row of factors for each and a sum for each column.
    ///
    /// Whoever asks for few places is told sums; once these cost as much as all points, points are found one by one, which
    /// further places need again. What depends on variables is asked by one thread, so that the bits hang on nothing else.
    pub(super) fn sums(
        &self,
        acting: impl Iterator<Item = Range<usize>>,
        factors: &Grid<f64>,
    ) -> VariableRows<DVec4> {
        let variables = self.variables.clone();
        let n_columns = factors.n_columns();
        let mut found = VariableRows::filled(variables, n_columns, DVec4::ZERO);
        let acting: Vec<usize> = acting.flatten().collect();
        let n_unknown =
            acting.iter().filter(|&&point| self.by_point[point].get().is_none()).count();
        if n_columns < n_unknown
            && self.n_sums.fetch_add(n_columns, Ordering::Relaxed) < self.by_point.len()
        {
            for column in 0..n_columns {
                if !work::goes_on(1) {
                    break;
                }
                let mut all = vec![0.0; self.by_point.len()];
                let own = acting.iter().enumerate();
                own.for_each(|(row, &point)| all[point] = factors.get(row, column));
                for (sums, slope) in found.rows_mut().zip((self.ways.sums)(&all)) {
                    sums[column] = slope.extend(0.0);
                }
            }
            return found;
        }
        for (row, &point) in acting.iter().enumerate() {
            for (sums, slope) in found.rows_mut().zip(self.of_point(point)) {
                let own = sums.iter_mut().zip(factors.row(row));
                own.for_each(|(sum, factor)| *sum += slope.extend(0.0) * *factor);
            }
        }
        found
    }
}
