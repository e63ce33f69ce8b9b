//! Surfaces within a tolerance of a grid of points, with few control points.
//!
//! Knots along u grow until curves of them come near to all columns, then knots along v until the
//! surface comes near to all points; then knots that are not needed go, the least needed first. At each
//! step the surface is the one of least squares, and the distances are those of all points.
//! Piegl & Tiller, *The NURBS Book*, §9.4.3; Lyche & Mørken, *Knot removal for parametric B-spline
//! curves and surfaces*, CAGD 4 (1987).

use glam::DVec3;

use super::{Approximator, Ends, FirstPass, Interpolator, LineFit, parameters::check_ends, spread};
use crate::{
    CountError, FitError, GeomError, Grid, KnotVector, NurbsSurface,
    ceiling::{FIT_ROUNDS, SINGLE_REMOVALS},
    knots::check_points,
};

/// The columns may use this part of the tolerance; the rest is left to the rows.
const SHARE_OF_COLUMNS: f64 = 0.5;

/// Data of one direction: the parameters of its points, and the degree.
///
/// Points of a plane need one patch within any tolerance:
///
/// ```
/// use virote_kernel::{Grid, Lines, columns_within, glam::DVec3, surface_within};
///
/// let points = Grid::from_fn(5, 5, |i, j| DVec3::new(i as f64, j as f64, (i + j) as f64));
/// let lines = Lines { parameters: vec![0.0, 1.0, 2.0, 3.0, 4.0], degree: 1 };
/// let columns = columns_within(&points, &lines, 1e-6)?;
/// let plane = surface_within(&points, [&lines, &lines], &columns, 1e-6)?;
/// assert_eq!(plane.n_patches(), [1, 1]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Lines {
    /// A parameter for each point of a line.
    pub parameters: Vec<f64>,
    /// Of the curves.
    pub degree: usize,
}

impl Lines {
    /// # Errors
    /// [`CountError::WrongCount`] unless there is a parameter for each of so many points.
    fn check_count(&self, needed: usize) -> Result<(), GeomError> {
        match self.parameters.len() {
            got if got == needed => Ok(()),
            got => Err(CountError::WrongCount { what: "parameters", needed, got }.into()),
        }
    }

    fn coarsest(&self) -> Result<KnotVector, GeomError> {
        check_points(self.degree, self.degree.saturating_add(1))?;
        check_ends(&self.parameters)?;
        let (first, last) = (self.parameters[0], self.parameters[self.parameters.len() - 1]);
        let ends = [first, last].map(|t| vec![t; self.degree + 1]);
        KnotVector::for_points(self.degree, self.degree + 1, ends.concat())
    }

    fn near(&self, knots: &KnotVector) -> Option<LineFit> {
        Approximator::new(&self.parameters, knots.clone()).ok().map(LineFit::Near)
    }

    fn through(&self) -> Result<LineFit, GeomError> {
        Interpolator::new(&self.parameters, self.degree, Ends::Averaged).map(LineFit::Through)
    }

    /// A fit whose largest misses at the parameters are within the tolerance, with knots where they
    /// would not be; the one through all points where no knots do.
    fn grown(
        &self,
        tolerance: f64,
        misses: impl Fn(&LineFit) -> Result<Vec<f64>, GeomError>,
    ) -> Result<LineFit, GeomError> {
        let mut knots = self.coarsest()?;
        for _ in 0..FIT_ROUNDS {
            GeomError::go_on(self.parameters.len())?;
            let Some(fit) = self.near(&knots) else { break };
            let misses = misses(&fit)?;
            if misses.iter().all(|&miss| miss <= tolerance) {
                return Ok(fit);
            }
            let more = spread::splits(&knots, &self.parameters, &misses, tolerance);
            if more.is_empty() || self.parameters.len() < knots.n_points() + more.len() {
                break;
            }
            knots = knots.with(&more);
        }
        self.through()
    }
}

/// A fit of the columns of a grid, the lines along u, that leaves enough of the tolerance to the rows.
///
/// # Errors
/// `DegreeError::DegreeTooHigh`, [`CountError::WrongCount`], and those of [`Interpolator::new`].
pub fn columns_within(
    points: &Grid<DVec3>,
    u: &Lines,
    tolerance: f64,
) -> Result<LineFit, GeomError> {
    u.check_count(points.n_rows())?;
    u.grown(SHARE_OF_COLUMNS * tolerance, |fit| {
        let first = FirstPass::new(points, fit)?.points().map(|point| point.extend(1.0));
        let mut worst = vec![0.0; points.n_rows()];
        for j in 0..points.n_columns() {
            let LineFit::Near(near) = fit else { continue };
            for (i, value) in near.values(&first.column(j)).enumerate() {
                let miss = value.truncate().distance(points.get(i, j));
                worst[i] = f64::max(worst[i], miss);
            }
        }
        Ok(worst)
    })
}

/// The surface within the tolerance of all points at their parameters, over knots along u no more
/// than those of `columns`.
///
/// # Errors
/// [`FitError::ToleranceNotKept`] below the rounding of the coordinates, and as [`columns_within`].
pub fn surface_within(
    points: &Grid<DVec3>,
    [u, v]: [&Lines; 2],
    columns: &LineFit,
    tolerance: f64,
) -> Result<NurbsSurface, GeomError> {
    u.check_count(points.n_rows())?;
    v.check_count(points.n_columns())?;
    let data = Data { points, lines: [u, v], tolerance };
    let first = FirstPass::new(points, columns)?;
    let rows = v.grown(tolerance, |fit| Ok(data.misses(&first.second(fit)?).0))?;
    let surface = first.second(&rows)?;
    let (_, found) = data.misses(&surface);
    if tolerance < found || found.is_nan() {
        return Err(FitError::ToleranceNotKept { tolerance, found }.into());
    }
    data.thinned(surface)
}

/// A grid that a surface comes near to.
struct Data<'a> {
    points: &'a Grid<DVec3>,
    lines: [&'a Lines; 2],
    tolerance: f64,
}

impl Data<'_> {
    /// The largest distance of the points of each column, and of all, at their parameters.
    fn misses(&self, surface: &NurbsSurface) -> (Vec<f64>, f64) {
        let [u, v] = self.lines;
        let found = surface.points_on_grid(&u.parameters, &v.parameters);
        let miss = |i, j| found.get(i, j).distance(self.points.get(i, j));
        let (n_rows, n_columns) = (self.points.n_rows(), self.points.n_columns());
        let worst = |j: usize| (0..n_rows).map(|i| miss(i, j)).fold(0.0, f64::max);
        let all: Vec<f64> = (0..n_columns).map(worst).collect();
        let most = all.iter().copied().fold(0.0, f64::max);
        (all, most)
    }

    fn fitted(&self, knots: [&KnotVector; 2]) -> Option<(NurbsSurface, f64)> {
        let u = self.lines[0].near(knots[0])?;
        let v = self.lines[1].near(knots[1])?;
        let surface = FirstPass::new(self.points, &u).ok()?.second(&v).ok()?;
        let (_, most) = self.misses(&surface);
        (most <= self.tolerance).then_some((surface, most))
    }

    /// Takes knots away while all points stay within the tolerance: each time the one without which
    /// they stay nearest, of the direction with more control points first.
    fn thinned(&self, first: NurbsSurface) -> Result<NurbsSurface, GeomError> {
        let size = self.points.n_rows() * self.points.n_columns();
        let mut left = crate::ceiling::FIT_STEPS / size.max(1);
        let mut best = first;
        loop {
            let mut without: Option<(NurbsSurface, f64)> = None;
            for along in [0, 1] {
                let knots = [best.knots_u(), best.knots_v()];
                if SINGLE_REMOVALS < knots[along].n_points() {
                    continue;
                }
                let breaks = knots[along].breaks();
                for &t in &breaks[1..breaks.len() - 1] {
                    if left == 0 {
                        return Ok(best);
                    }
                    left -= 1;
                    GeomError::go_on(size)?;
                    let fewer = knots[along].without(t);
                    let mut tried = knots;
                    tried[along] = &fewer;
                    let found = self.fitted(tried);
                    let is_better = |found: &(NurbsSurface, f64)| {
                        without.as_ref().is_none_or(|before| found.1 < before.1)
                    };
                    if let Some(found) = found.filter(is_better) {
                        without = Some(found);
                    }
                }
            }
            match without {
                Some((surface, _)) => best = surface,
                None => return Ok(best),
            }
        }
    }
}
