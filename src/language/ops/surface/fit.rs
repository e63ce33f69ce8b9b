//! What the operations that fit surfaces to grids have in common.

use glam::DVec3;

use super::{PerDirection, in_direction};
use crate::{
    diag::{Result, Span, Spanned},
    kernel::{
        ConstructionReport, Direction, FirstPass, Grid, LineFit, Lines, NurbsSurface,
        Parametrization, ReportEntry, check_parameters, columns_within, surface_within,
    },
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
pub(super) fn chord() -> Spanned<PerDirection<Parameters>> {
    let by_chord = Parameters::By(Parametrization::Chord);
    Spanned::unplaced(PerDirection { u: by_chord.clone(), v: by_chord })
}

/// A grid with where its points are to lie.
pub(super) struct GridData {
    pub(super) points: Spanned<Grid<DVec3>>,
    pub(super) parameters: Spanned<PerDirection<Parameters>>,
    pub(super) second_pass: SecondPass,
    /// The operation, for its report.
    pub(super) operation: &'static str,
}

impl GridData {
    /// The surface whose lines are fitted by what `fit` makes of a direction's parameters.
    pub(super) fn surface(
        self,
        fit: [&dyn Fn(Vec<f64>) -> Result<LineFit>; 2],
    ) -> Result<NurbsSurface> {
        let Self { points: Spanned { value: grid, span }, parameters, second_pass, operation } =
            self;
        let given = grid.clone();
        let mut places = [Vec::new(), Vec::new()];
        let mut noted = |along: Direction, found: Vec<f64>| {
            places[along].clone_from(&found);
            fit[along](found)
        };
        let place = parameters.span_or(span);
        let along_u = means(parameters.value.u, &grid.transposed(), [place, span])
            .and_then(|found| noted(Direction::U, found))
            .map_err(|found| in_direction(found, "u", "rows"))?;
        let first = FirstPass::new(&grid, &along_u).at(span)?;
        let rows = match second_pass {
            SecondPass::Data => grid,
            SecondPass::Control => first.points(),
        };
        let along_v = means(parameters.value.v, &rows, [place, span])
            .and_then(|found| noted(Direction::V, found))
            .map_err(|found| in_direction(found, "v", "points in a row"))?;
        let surface = first.second(&along_v).at(span)?;
        Ok(reporting(surface, operation, &given, places))
    }
}

impl GridData {
    /// The surface within a tolerance of the points, of these degrees.
    pub(super) fn surface_within(
        self,
        degrees: [usize; 2],
        tolerance: Spanned<f64>,
    ) -> Result<NurbsSurface> {
        let Self { points: Spanned { value: grid, span }, parameters, second_pass, operation } =
            self;
        let place = parameters.span_or(span);
        let found = means(parameters.value.u, &grid.transposed(), [place, span])
            .map_err(|found| in_direction(found, "u", "rows"))?;
        let u = Lines { parameters: found, degree: degrees[0] };
        let columns = columns_within(&grid, &u, tolerance.value).at(tolerance.span)?;
        let rows = match second_pass {
            SecondPass::Data => grid.clone(),
            SecondPass::Control => FirstPass::new(&grid, &columns).at(span)?.points(),
        };
        let found = means(parameters.value.v, &rows, [place, span])
            .map_err(|found| in_direction(found, "v", "points in a row"))?;
        let v = Lines { parameters: found, degree: degrees[1] };
        let surface =
            surface_within(&grid, [&u, &v], &columns, tolerance.value).at(tolerance.span)?;
        Ok(reporting(surface, operation, &grid, [u.parameters, v.parameters]))
    }
}

/// The surface with a report of where on it the points lie, and how far they are from it.
fn reporting(
    surface: NurbsSurface,
    operation: &str,
    points: &Grid<DVec3>,
    [us, vs]: [Vec<f64>; 2],
) -> NurbsSurface {
    let found = surface.points_on_grid(&us, &vs);
    let (mut worst, mut sum, mut at) = (0.0, 0.0, [us[0], vs[0]]);
    for (i, &u) in us.iter().enumerate() {
        for (j, &v) in vs.iter().enumerate() {
            let miss = found.get(i, j).distance(points.get(i, j));
            sum += miss;
            if worst < miss {
                (worst, at) = (miss, [u, v]);
            }
        }
    }
    let mean = sum / (us.len() * vs.len()) as f64;
    let place = ConstructionReport::default().with("u", at[0]).with("v", at[1]);
    let deviation = ConstructionReport::default()
        .with("max", ReportEntry::Length(worst))
        .with("mean", ReportEntry::Length(mean))
        .with("at", place);
    let net = surface.control_points();
    let counts = ConstructionReport::default().with("u", net.n_rows()).with("v", net.n_columns());
    let degree =
        ConstructionReport::default().with("u", surface.degree_u()).with("v", surface.degree_v());
    let report = ConstructionReport::of(operation)
        .with("degree", degree)
        .with("control_points", counts)
        .with("deviation", deviation)
        .with("parameters", ConstructionReport::default().with("u", us).with("v", vs));
    surface.with_report(report)
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
