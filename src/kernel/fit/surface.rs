//! Surfaces through a grid of points and near one: curves along u first, then along v.
//!
//! Piegl & Tiller, *The NURBS Book*, §9.2.5 and §9.4.3.

use glam::{DVec3, DVec4};

use super::{Approximator, Interpolator, Parametrization};
use crate::{CountError, GeomError, Grid, InputError, NurbsSurface, tolerance::PARAMETER_RELATIVE};

/// How the lines of a grid in one direction become splines.
///
/// ```
/// use virote_kernel::{Ends, FirstPass, Grid, Interpolator, LineFit, glam::DVec3};
///
/// // Four points of z = xy: the surface through them is that saddle.
/// let corners = Grid::from_fn(2, 2, |i, j| DVec3::new(i as f64, j as f64, (i * j) as f64));
/// let through = LineFit::Through(Interpolator::new(&[0.0, 1.0], 1, Ends::Averaged)?);
/// let saddle = FirstPass::new(&corners, &through)?.second(&through)?;
/// assert_eq!(saddle.point_at(0.5, 0.5), DVec3::new(0.5, 0.5, 0.25));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub enum LineFit {
    /// Through all values.
    Through(Interpolator),
    /// Near them.
    Near(Approximator),
}

impl LineFit {
    fn control_points(&self, values: &[DVec4]) -> Result<Vec<DVec4>, GeomError> {
        match self {
            Self::Through(fit) => fit.through(values),
            Self::Near(fit) => fit.near(values),
        }
    }

    fn knots(&self) -> &crate::KnotVector {
        match self {
            Self::Through(fit) => fit.knots(),
            Self::Near(fit) => fit.knots(),
        }
    }
}

/// A grid of points whose columns, the lines along u, have become control points.
///
/// Piegl & Tiller, *The NURBS Book*, §9.2.5: curves through the columns of points, then curves through
/// their control points.
///
/// ```
/// use virote_kernel::{Ends, FirstPass, Grid, Interpolator, LineFit, glam::DVec3};
///
/// let heights = Grid::from_fn(4, 3, |i, j| DVec3::new(i as f64, j as f64, (i * i) as f64));
/// let fit = |at: &[f64]| Interpolator::new(at, 2, Ends::Averaged).map(LineFit::Through);
/// let (u, v) = (fit(&[0.0, 1.0, 2.0, 3.0])?, fit(&[0.0, 1.0, 2.0])?);
/// let surface = FirstPass::new(&heights, &u)?.second(&v)?;
/// assert!(surface.point_at(2.0, 1.0).distance(DVec3::new(2.0, 1.0, 4.0)) < 1e-13);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct FirstPass<'a> {
    u: &'a LineFit,
    /// Row i holds control point i of every column.
    points: Grid<DVec4>,
}

impl<'a> FirstPass<'a> {
    /// The columns fitted along u.
    ///
    /// # Errors
    /// [`CountError::WrongCount`] unless the grid has a row for each parameter.
    pub fn new(points: &Grid<DVec3>, u: &'a LineFit) -> Result<Self, GeomError> {
        let lifted = points.map(|point| point.extend(1.0));
        let columns = each_row(&lifted.transposed(), u)?;
        Ok(Self { u, points: columns.transposed() })
    }

    /// The points that stand now where the data stood.
    #[must_use]
    pub fn points(&self) -> Grid<DVec3> {
        self.points.map(|point| point.truncate())
    }

    /// The surface, with the rows fitted along v.
    ///
    /// # Errors
    /// [`CountError::WrongCount`] unless the grid has a column for each parameter.
    pub fn second(&self, v: &LineFit) -> Result<NurbsSurface, GeomError> {
        let net = each_row(&self.points, v)?.map(|point| point.truncate());
        NurbsSurface::polynomial(self.u.knots().clone(), v.knots().clone(), &net)
    }
}

fn each_row(grid: &Grid<DVec4>, fit: &LineFit) -> Result<Grid<DVec4>, GeomError> {
    let rows: Result<Vec<Vec<DVec4>>, GeomError> =
        (0..grid.n_rows()).map(|i| fit.control_points(grid.row(i))).collect();
    Grid::from_rows(rows?)
}

impl Parametrization {
    /// One parameter for each column of a grid, from 0 to 1: the mean of what its rows have. Rows
    /// that are one point, such as poles, say nothing.
    ///
    /// Piegl & Tiller, *The NURBS Book*, A9.3.
    ///
    /// # Errors
    /// [`InputError::CoincidentPoints`] for neighbouring columns that are at one place in each row;
    /// [`CountError::TooFewPoints`], [`InputError::NotFinite`].
    pub fn mean_parameters(self, grid: &Grid<DVec3>) -> Result<Vec<f64>, GeomError> {
        let counts = [grid.n_rows(), grid.n_columns()];
        for (got, needed) in counts.into_iter().zip([1, 2]) {
            if got < needed {
                return Err(CountError::TooFewPoints { got, needed: 2 }.into());
            }
        }
        let mut sums = vec![0.0; grid.n_columns()];
        let mut n_rows = 0;
        for i in 0..grid.n_rows() {
            match self.loose_parameters(grid.row(i)) {
                Ok(parameters) => {
                    sums.iter_mut().zip(parameters).for_each(|(sum, t)| *sum += t);
                    n_rows += 1;
                }
                Err(GeomError::Input(InputError::CoincidentPoints { .. })) => {}
                Err(other) => return Err(other),
            }
        }
        if n_rows == 0 {
            return Err(InputError::CoincidentPoints { first: 0, second: 1 }.into());
        }
        let mut parameters: Vec<f64> =
            sums.into_iter().map(|sum| sum / f64::from(n_rows)).collect();
        let last = parameters.len() - 1;
        parameters[last] = 1.0;
        match parameters.windows(2).position(|pair| pair[1] - pair[0] <= PARAMETER_RELATIVE) {
            Some(first) => {
                Err(GeomError::Input(InputError::CoincidentPoints { first, second: first + 1 }))
            }
            None => Ok(parameters),
        }
    }
}
