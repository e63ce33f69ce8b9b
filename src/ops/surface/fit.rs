//! What the operations that fit surfaces to grids have in common.

use glam::DVec3;

use super::{Both, in_direction};
use crate::{
    diag::{Result, Span, Spanned},
    kernel::{FirstPass, Grid, LineFit, NurbsSurface, Spacing, check_parameters},
    ops::curve::fit::Parameters,
    value::{At, Choice},
};

/// Whose distances give the parameters along v.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SecondPass {
    /// Those of the points.
    Data,
    /// Those of the control points that the fit along u made of them.
    Control,
}

impl Choice for SecondPass {
    const WORDS: &'static [&'static str] = &["data", "control"];
    const MEANINGS: &'static [Self] = &[Self::Data, Self::Control];
}

/// By the distance of the points, in both directions.
pub(super) fn chord() -> Spanned<Both<Parameters>> {
    let by_chord = Parameters::By(Spacing::Chord);
    Spanned::unplaced(Both { u: by_chord.clone(), v: by_chord })
}

/// A grid with where its points are to lie.
pub(super) struct Data {
    pub(super) points: Spanned<Grid<DVec3>>,
    pub(super) parameters: Spanned<Both<Parameters>>,
    pub(super) second_pass: SecondPass,
}

impl Data {
    /// The surface whose lines are fitted by what `fit` makes of a direction's parameters.
    pub(super) fn surface(
        self,
        fit: [&dyn Fn(Vec<f64>) -> Result<LineFit>; 2],
    ) -> Result<NurbsSurface> {
        let Self { points: Spanned { value: grid, span }, parameters, second_pass } = self;
        let place = parameters.span_or(span);
        let along_u = means(parameters.value.u, &grid.transposed(), [place, span])
            .and_then(fit[0])
            .map_err(|found| in_direction(found, "u", "rows"))?;
        let first = FirstPass::new(&grid, &along_u).at(span)?;
        let rows = match second_pass {
            SecondPass::Data => grid,
            SecondPass::Control => first.points(),
        };
        let along_v = means(parameters.value.v, &rows, [place, span])
            .and_then(fit[1])
            .map_err(|found| in_direction(found, "v", "points in a row"))?;
        first.second(&along_v).at(span)
    }
}

/// One parameter for each column.
fn means(parameters: Parameters, rows: &Grid<DVec3>, places: [Span; 2]) -> Result<Vec<f64>> {
    match parameters {
        Parameters::Listed(listed) => {
            check_parameters(&listed, rows.n_columns()).at(places[0])?;
            Ok(listed)
        }
        Parameters::By(spacing) => spacing.mean_parameters(rows).at(places[1]),
    }
}
