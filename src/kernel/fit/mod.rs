//! Curves and surfaces through points, and near them.
//!
//! `parameters` says where on the curve each point is to lie; `equation` holds
//! the equations that follow, which are solved in time linear in the number of points; `interpolate` makes
//! those of a spline through points, `sloped` with derivatives at the ends, `periodic`
//! those of a closed one, `through` the splines, `moving` what they do where their points vary, `growth` the same asked for each control point, by the `leg_growths` of parameters,
//! `varied_spline` the curves that vary so, `moving_grid` surfaces through grids by their `grid_lines`, `moving_surface` surfaces whose rows are splines, `moving_skin` of skins by the `section_steps` between their sections, `lagrange` the single polynomial. `least` comes nearest to points with a given basis,
//! `slide` with the parameters too, `spread` makes that basis, `search` looks for the smallest that keeps a tolerance, `fitted` holds what it finds, `balanced` does so by what the `span_errors` are, from parameters
//! by `affine_length`, and attempts what its `balance` tells, `sample` from some of many points, `kinks` where
//! data have corners, and `approximate` puts these together; `surface` does it all for grids, `within` to a tolerance.

mod affine_length;
mod approximate;
mod balance;
mod balanced;
mod equation;
mod fitted;
mod grid_lines;
mod growth;
mod interpolate;
mod kinks;
mod lagrange;
mod least;
mod leg_growths;
mod moving;
mod moving_grid;
mod moving_skin;
mod moving_surface;
mod parameters;
mod periodic;
mod sample;
mod search;
mod section_steps;
mod slide;
mod sloped;
mod span_errors;
mod spread;
mod surface;
mod thinning;
mod through;
mod varied_spline;
mod within;

pub use approximate::{approximate, approximate_within};
pub use grid_lines::GridLines;
pub use interpolate::{Ends, Interpolator};
pub use lagrange::lagrange;
pub use least::Approximator;
pub(crate) use least::FitCondition;

pub use parameters::{Parametrization, check_parameters};
pub use surface::{FirstPass, LineFit};
pub use varied_spline::{interpolate_varied, interpolate_varied_ring};
pub use within::{Lines, columns_within, surface_within};
