//! Points that are sums of others, as the control points that an operation makes of those it is given.
//!
//! A linear operation on control points is a matrix, and their slopes pass through it: the slopes of a sum of the points
//! that are made are those of one sum of the given ones, by the transposed matrix. So nothing is done for each variable
//! until somebody asks. Griewank & Walther, *Evaluating Derivatives*, §3.2 (the reverse mode).

use std::{
    ops::Range,
    sync::{Arc, OnceLock},
};

use glam::{DMat3, DVec3, DVec4};

use super::{PointSlopes, SlopeWays};
use crate::{CountError, GeomError, Jet, work};

/// How points grow with others: entries of a matrix, each with the point that is made, the one that is given, and how.
///
/// A quarter turn about z of the only point, which moves along x:
///
/// ```
/// use virote_kernel::{PointFactors, PointMap, PointSlopes, glam::{DMat3, DVec3, DVec4}};
///
/// let given = PointSlopes::new(1, 1, vec![(0, vec![DVec4::X])])?;
/// let turn = DMat3::from_cols(DVec3::Y, -DVec3::X, DVec3::Z);
/// let map = PointMap::new(vec![given], 1, PointFactors::Mixed(vec![(0, 0, turn)]))?;
/// assert_eq!(map.grown(&[DVec3::X]), [DVec3::Y]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub enum PointFactors {
    /// Each coordinate with the same one, all alike.
    Alike(Vec<(usize, usize, f64)>),
    /// Coordinates with others.
    Mixed(Vec<(usize, usize, DMat3)>),
}

/// Points that grow with others as a matrix tells, and so with whatever moves these. Invariant: entries are of points that
/// there are.
///
/// The middle of two points, the second of which rises with the only variable:
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{PointFactors, PointMap, PointSlopes, glam::{DVec3, DVec4}};
///
/// let given = PointSlopes::new(1, 2, vec![(0, vec![DVec4::ZERO, DVec4::Y])])?;
/// let halves = PointFactors::Alike(vec![(0, 0, 0.5), (0, 1, 0.5)]);
/// let map = Arc::new(PointMap::new(vec![given], 1, halves)?);
/// assert_eq!(map.grown(&[DVec3::ZERO, DVec3::X]), [DVec3::X * 0.5]);
/// assert_eq!(map.slopes_of(0..1).through(&[DVec4::Y]), [0.5]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Debug)]
pub struct PointMap {
    /// The slopes of the given points, in sets, one behind the other.
    given: Vec<PointSlopes>,
    n_variables: usize,
    /// By which variables any of them moves, in order.
    variables: Vec<usize>,
    rows: MapRows,
    /// Of each given point the variables that move it, and how.
    by_given: OnceLock<Vec<Vec<(usize, DVec3)>>>,
}

/// The matrix by the points that are made.
#[derive(Debug)]
enum MapRows {
    Alike(SparseRows<f64>),
    Mixed(SparseRows<DMat3>),
}

/// Rows of a sparse matrix, one behind the other.
#[derive(Debug)]
struct SparseRows<T> {
    starts: Vec<usize>,
    entries: Vec<(usize, T)>,
}

impl<T: Copy> SparseRows<T> {
    /// Of entries in any order, each with its row and column; a row has its own in theirs.
    fn new(n_rows: usize, entries: Vec<(usize, usize, T)>) -> Self {
        let mut starts = vec![0; n_rows + 1];
        entries.iter().for_each(|(row, ..)| starts[row + 1] += 1);
        (0..n_rows).for_each(|row| starts[row + 1] += starts[row]);
        let mut ends = starts.clone();
        let Some((_, column, own)) = entries.first().copied() else {
            return Self { starts, entries: Vec::new() };
        };
        let mut sorted = vec![(column, own); entries.len()];
        for (row, column, own) in entries {
            sorted[ends[row]] = (column, own);
            ends[row] += 1;
        }
        Self { starts, entries: sorted }
    }

    fn row(&self, row: usize) -> &[(usize, T)] {
        &self.entries[self.starts[row]..self.starts[row + 1]]
    }
}

impl PointMap {
    /// So many points made of given ones, whose slopes are by the same variables and stand in sets one behind the other.
    ///
    /// # Errors
    /// [`CountError::WrongCount`] for an entry of a point that there is not, or slopes by other variables.
    pub fn new(
        given: Vec<PointSlopes>,
        n_made: usize,
        factors: PointFactors,
    ) -> Result<Self, GeomError> {
        let n_given: usize = given.iter().map(PointSlopes::n_points).sum();
        let n_variables = given.first().map_or(0, PointSlopes::n_variables);
        let wrong = |what, needed, got| CountError::WrongCount { what, needed, got };
        if let Some(other) = given.iter().find(|own| own.n_variables() != n_variables) {
            return Err(wrong("variables", n_variables, other.n_variables()).into());
        }
        let ends: (usize, usize) = match &factors {
            PointFactors::Alike(all) => ends(all),
            PointFactors::Mixed(all) => ends(all),
        };
        if n_made < ends.0 || n_given < ends.1 {
            let [needed, got] = if n_made < ends.0 { [ends.0, n_made] } else { [ends.1, n_given] };
            return Err(wrong("points", needed, got).into());
        }
        let rows = match factors {
            PointFactors::Alike(all) => MapRows::Alike(SparseRows::new(n_made, all)),
            PointFactors::Mixed(all) => MapRows::Mixed(SparseRows::new(n_made, all)),
        };
        let mut variables: Vec<usize> = given.iter().flat_map(PointSlopes::variables).collect();
        variables.sort_unstable();
        variables.dedup();
        Ok(Self { given, n_variables, variables, rows, by_given: OnceLock::new() })
    }

    /// By how much the points grow where the given ones move so far.
    #[must_use]
    pub fn grown(&self, steps: &[DVec3]) -> Vec<DVec3> {
        match &self.rows {
            MapRows::Alike(rows) => rows.sums(|at, factor| steps[at] * factor),
            MapRows::Mixed(rows) => rows.sums(|at, factor| factor * steps[at]),
        }
    }

    /// The slopes of some of the points, which weights do not move.
    #[must_use]
    pub fn slopes_of(self: &Arc<Self>, made: Range<usize>) -> PointSlopes {
        let is_any = match &self.rows {
            MapRows::Alike(rows) => rows.starts[made.start] < rows.starts[made.end],
            MapRows::Mixed(rows) => rows.starts[made.start] < rows.starts[made.end],
        };
        let variables = if is_any { self.variables.clone() } else { Vec::new() };
        let [of_sums, of_all] = [Arc::clone(self), Arc::clone(self)];
        let (n_points, range) = (made.len(), made.clone());
        let ways = SlopeWays {
            sums: Box::new(move |factors| of_sums.sums(range.clone(), factors)),
            all: Box::new(move || of_all.all(made.clone())),
        };
        PointSlopes::asked(self.n_variables, n_points, variables, ways)
    }

    /// Whether all slopes are numbers, whichever are asked for.
    #[must_use]
    pub fn has_finite_slopes(&self) -> bool {
        let factors = match &self.rows {
            MapRows::Alike(rows) => rows.entries.iter().map(|own| own.1.abs()).sum(),
            MapRows::Mixed(rows) => {
                let size = |own: &DMat3| own.to_cols_array().iter().map(|own| own.abs()).sum();
                rows.entries.iter().map(|(_, own)| -> f64 { size(own) }).sum::<f64>()
            }
        };
        let slopes = self.by_given().iter().flatten().map(|(_, slope)| slope.abs().element_sum());
        (factors * slopes.sum::<f64>()).is_finite()
    }

    /// A point that is made, with its value; none if it grows with nothing.
    ///
    /// # Errors
    /// [`LocalError::DerivativeBeyondNumbers`](crate::LocalError::DerivativeBeyondNumbers).
    pub fn point(&self, made: usize, value: DVec3) -> Result<Option<[Jet; 3]>, GeomError> {
        let mut all = [0, 1, 2].map(|axis| {
            let mut own = vec![0.0; 1 + self.n_variables];
            own[0] = value[axis];
            own
        });
        let mut add = |variable: usize, slope: DVec3| {
            (0..3).for_each(|axis| all[axis][1 + variable] += slope[axis]);
        };
        let n_entries = match &self.rows {
            MapRows::Alike(rows) => rows.add(made, self.by_given(), &mut add, |own, s| s * own),
            MapRows::Mixed(rows) => rows.add(made, self.by_given(), &mut add, |own, s| own * s),
        };
        if n_entries == 0 {
            return Ok(None);
        }
        let [x, y, z] = all.map(Jet::of_several);
        Ok(Some([x?, y?, z?]))
    }

    fn by_given(&self) -> &[Vec<(usize, DVec3)>] {
        self.by_given.get_or_init(|| {
            let of = |slopes: &PointSlopes| {
                let mut own = vec![Vec::new(); slopes.n_points()];
                for (variable, moving, slopes) in slopes.moving() {
                    for idx in moving.filter(|&idx| slopes[idx] != DVec4::ZERO) {
                        own[idx].push((variable, slopes[idx].truncate()));
                    }
                }
                own
            };
            self.given.iter().flat_map(of).collect()
        })
    }

    /// The slopes of a sum of some of the points, by each of the variables.
    fn sums(&self, made: Range<usize>, factors: &[f64]) -> Vec<DVec3> {
        let mut total = vec![DVec3::ZERO; self.n_variables];
        match &self.rows {
            MapRows::Alike(rows) => {
                let mut by_given = vec![0.0; self.n_given()];
                for (row, factor) in made.zip(factors).filter(|(_, factor)| 0.0 < factor.abs()) {
                    rows.row(row).iter().for_each(|(at, own)| by_given[*at] += factor * own);
                }
                for (slopes, from) in self.sets() {
                    slopes.add_sum(&by_given[from..from + slopes.n_points()], &mut total);
                }
            }
            MapRows::Mixed(rows) => {
                let mut by_given = vec![DMat3::ZERO; self.n_given()];
                for (row, factor) in made.zip(factors).filter(|(_, factor)| 0.0 < factor.abs()) {
                    rows.row(row).iter().for_each(|(at, own)| by_given[*at] += *own * *factor);
                }
                for axis in 0..3 {
                    let gradient: Vec<DVec4> =
                        by_given.iter().map(|own| own.row(axis).extend(0.0)).collect();
                    for (slopes, from) in self.sets() {
                        let own = slopes.through(&gradient[from..from + slopes.n_points()]);
                        total.iter_mut().zip(own).for_each(|(sum, slope)| sum[axis] += slope);
                    }
                }
            }
        }
        self.variables.iter().map(|&variable| total[variable]).collect()
    }

    /// The slopes of some of the points by each of the variables; none where work was ended.
    fn all(&self, made: Range<usize>) -> Option<Vec<Vec<DVec4>>> {
        let n_numbers = made.len() * self.variables.len();
        if !work::goes_on(1 + n_numbers as u64 / work::PARTS_A_STEP) {
            return None;
        }
        let mut speeds = vec![DVec3::ZERO; self.n_given()];
        let mut by_variable = vec![vec![DVec4::ZERO; made.len()]; self.variables.len()];
        for (variable, own) in self.variables.iter().zip(&mut by_variable) {
            speeds.fill(DVec3::ZERO);
            for (slopes, from) in self.sets() {
                let Some((moving, slopes)) = slopes.moving_with(*variable) else { continue };
                moving.for_each(|idx| speeds[from + idx] = slopes[idx].truncate());
            }
            let sums = match &self.rows {
                MapRows::Alike(rows) => rows.some_sums(made.clone(), |at, own| speeds[at] * own),
                MapRows::Mixed(rows) => rows.some_sums(made.clone(), |at, own| own * speeds[at]),
            };
            own.iter_mut().zip(sums).for_each(|(own, sum)| *own = sum.extend(0.0));
        }
        Some(by_variable)
    }

    fn n_given(&self) -> usize {
        self.given.iter().map(PointSlopes::n_points).sum()
    }

    /// The sets of slopes, each with its first given point.
    fn sets(&self) -> impl Iterator<Item = (&PointSlopes, usize)> {
        self.given.iter().scan(0, |end, own| {
            let from = *end;
            *end += own.n_points();
            Some((own, from))
        })
    }
}

impl<T: Copy> SparseRows<T> {
    fn sums(&self, part: impl Fn(usize, T) -> DVec3) -> Vec<DVec3> {
        self.some_sums(0..self.starts.len() - 1, part)
    }

    fn some_sums(&self, rows: Range<usize>, part: impl Fn(usize, T) -> DVec3) -> Vec<DVec3> {
        rows.map(|row| self.row(row).iter().map(|(at, own)| part(*at, *own)).sum()).collect()
    }

    /// Adds what variables do to the point of a row; how many entries that has.
    fn add(
        &self,
        row: usize,
        by_given: &[Vec<(usize, DVec3)>],
        add: &mut dyn FnMut(usize, DVec3),
        part: impl Fn(T, DVec3) -> DVec3,
    ) -> usize {
        for (at, own) in self.row(row) {
            by_given[*at].iter().for_each(|(variable, slope)| add(*variable, part(*own, *slope)));
        }
        self.row(row).len()
    }
}

/// How many rows and columns entries are of.
fn ends<T>(entries: &[(usize, usize, T)]) -> (usize, usize) {
    let larger = |most: (usize, usize), own: &(usize, usize, T)| {
        (most.0.max(own.0.saturating_add(1)), most.1.max(own.1.saturating_add(1)))
    };
    entries.iter().fold((0, 0), larger)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::{DMat3, DVec3, DVec4};

    use super::{PointFactors, PointMap};
    use crate::PointSlopes;

    /// Three points in two sets that two variables move.
    fn given() -> Vec<PointSlopes> {
        let first = vec![(0, vec![DVec4::X, DVec4::Y]), (1, vec![DVec4::ZERO, DVec4::Z * 2.0])];
        let second = vec![(1, vec![DVec4::new(1.0, 2.0, 3.0, 0.0)])];
        vec![PointSlopes::new(2, 2, first).unwrap(), PointSlopes::new(2, 1, second).unwrap()]
    }

    fn check(factors: PointFactors, expected: [[DVec3; 2]; 2]) {
        let map = Arc::new(PointMap::new(given(), 2, factors).unwrap());
        let slopes = map.slopes_of(0..2);
        for (variable, expected) in expected.into_iter().enumerate() {
            for axis in 0..3 {
                for made in 0..2 {
                    let mut gradient = [DVec4::ZERO; 2];
                    gradient[made][axis] = 1.0;
                    let off = slopes.through(&gradient)[variable] - expected[made][axis];
                    assert!(off.abs() <= 0.0, "{off}");
                    let point = map.point(made, DVec3::ONE).unwrap().unwrap();
                    let off = point[axis].slopes()[variable] - expected[made][axis];
                    assert!(off.abs() <= 0.0, "{off}");
                }
            }
            let own: Vec<DVec4> = expected.iter().map(|slope| slope.extend(0.0)).collect();
            assert_eq!(map.slopes_of(0..2).by_variable()[variable], (variable, own));
            let last = map.slopes_of(1..2);
            let last = last.by_variable().iter().find(|own| own.0 == variable).map(|own| own.1[0]);
            assert_eq!(last.unwrap_or(DVec4::ZERO), expected[1].extend(0.0));
        }
    }

    #[test]
    fn slopes_pass_through_the_matrix() {
        let alike = vec![(0, 0, 2.0), (0, 1, 1.0), (1, 2, -1.0), (1, 1, 0.5)];
        let last = DVec3::new(1.0, 2.0, 3.0);
        check(
            PointFactors::Alike(alike),
            [[DVec3::new(2.0, 1.0, 0.0), DVec3::Y * 0.5], [DVec3::Z * 2.0, DVec3::Z - last]],
        );
        // A quarter turn about z, and a coordinate alone.
        let turn = DMat3::from_cols(DVec3::Y, -DVec3::X, DVec3::Z);
        let height = DMat3::from_cols(DVec3::ZERO, DVec3::ZERO, DVec3::Y);
        let mixed = vec![(0, 0, turn), (1, 2, turn), (1, 1, height), (0, 1, turn)];
        check(
            PointFactors::Mixed(mixed),
            [
                [DVec3::Y - DVec3::X, DVec3::ZERO],
                [DVec3::Z * 2.0, DVec3::new(-2.0, 1.0, 3.0) + DVec3::Y * 2.0],
            ],
        );
    }

    #[test]
    fn entries_of_points_that_are_not_are_refused() {
        for entry in [(2, 0, 1.0), (0, 3, 1.0)] {
            assert!(PointMap::new(given(), 2, PointFactors::Alike(vec![entry])).is_err());
        }
        let other = PointSlopes::new(3, 1, Vec::new()).unwrap();
        let sets = [given(), vec![other]].concat();
        assert!(PointMap::new(sets, 1, PointFactors::Alike(Vec::new())).is_err());
    }
}
