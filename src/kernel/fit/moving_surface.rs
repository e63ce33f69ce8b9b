//! Surfaces whose rows are splines through sections, where the parameters of these move.

use std::ops::RangeInclusive;

use glam::DVec4;

use super::{
    Ends, Interpolator,
    moving::{MovingSpline, SplineSpeeds},
    section_steps::SectionSteps,
};
use crate::{
    GeomError, Grid, KnotVector, NurbsSurface, PointSlopes, SectionParameters, VariedSurface,
    tolerance::EXACT_RELATIVE,
    varied::knots::{simple_inner, with_knots_twice},
};

impl VariedSurface {
    /// The surface whose rows are the splines that [`Interpolator::new`] makes of a degree at parameters, where these
    /// move too: on knots that do not move. None where the rows are others or have no slopes.
    fn with_moving_parameters(
        &self,
        degree: usize,
        parameters: &[f64],
        speeds: &[(usize, Vec<f64>)],
    ) -> Result<Option<Self>, GeomError> {
        let surface = self.surface();
        let fit = Interpolator::new(parameters, degree, Ends::Averaged)?;
        let knots = surface.knots_v();
        if fit.knots() != knots {
            return Ok(None);
        }
        let net = surface.control_points();
        let n_variables = self.slopes().n_variables();
        let rows = rows_of(net.as_slice(), net);
        let Some(moving) = MovingRows::new(&fit, parameters, &rows, speeds)? else {
            return Ok(None);
        };
        let own = self.slopes().by_variable();
        let twice = own_rows_twice(knots, own, net)?;
        let by_variable = (0..n_variables).filter_map(|variable| {
            let own = own.iter().position(|(idx, _)| *idx == variable);
            let moved = speeds.iter().position(|(idx, _)| *idx == variable);
            (own.is_some() || moved.is_some()).then(|| {
                let mut all = moving.slopes(moved);
                for (row, points) in own.into_iter().flat_map(|own| &twice[own]) {
                    moving.add(&mut all, *row, (points, 1.0));
                }
                (variable, all)
            })
        });
        let by_variable = by_variable.collect();
        let net = Grid::from_rows(with_knots_twice(knots, rows)?)?;
        let twice = knots.with(simple_inner(knots).unwrap_or(&[]));
        let slopes = PointSlopes::new(n_variables, net.as_slice().len(), by_variable)?;
        let fixed = NurbsSurface::new(surface.knots_u().clone(), twice, net)?;
        Self::new(fixed.into(), slopes).map(Some)
    }

    /// A skin that is made of sections at fixed parameters, as one whose parameters a rule finds and that move with the
    /// sections; none where the rule finds others, or no slopes are known.
    ///
    /// # Errors
    /// Where the work is ended.
    pub fn with_moving_sections(
        &self,
        rule: SectionParameters,
        degree: usize,
        parameters: &[f64],
    ) -> Result<Option<Self>, GeomError> {
        let (knots, net) = (self.surface().knots_v(), self.surface().control_points());
        let at =
            |&t: &f64| knots.with_basis(t, |span, basis| (knots.support(span), basis.to_vec()));
        let acting: Vec<(RangeInclusive<usize>, Vec<f64>)> = parameters.iter().map(at).collect();
        let section_points = |line: &[DVec4]| -> Vec<DVec4> {
            let at = |(support, basis): &(RangeInclusive<usize>, Vec<f64>)| -> DVec4 {
                line[support.clone()].iter().zip(basis).map(|(&point, &n)| point * n).sum()
            };
            acting.iter().map(at).collect()
        };
        let lines: Vec<Vec<DVec4>> =
            net.as_slice().chunks_exact(net.n_columns()).map(section_points).collect();
        let Some(steps) = SectionSteps::new(rule, lines) else { return Ok(None) };
        if !steps.are_of(parameters) {
            return Ok(None);
        }
        let mut speeds = Vec::new();
        for (variable, slopes) in self.slopes().by_variable() {
            let by_line = slopes.chunks_exact(net.n_columns()).enumerate();
            let moving = by_line.filter(|(_, line)| line.iter().any(|own| *own != DVec4::ZERO));
            let moving = moving.map(|(idx, line)| (idx, section_points(line))).collect();
            let Some(own) = steps.speeds(moving) else { return Ok(None) };
            speeds.push((*variable, own));
        }
        self.with_moving_parameters(degree, parameters, &speeds)
    }
}

/// What rows do where the parameters of their points move.
struct MovingRows {
    /// How fast the parameters move by each variable, in terms of `by_speed`.
    shares: Vec<Vec<f64>>,
    /// Control points of each row, for each speed.
    by_speed: Vec<Vec<Vec<DVec4>>>,
    /// How many there are of a row.
    n_points: usize,
}

impl MovingRows {
    /// Of rows on the knots of a spline; none where they are not the splines through their points, or have no slopes.
    ///
    /// All speeds are sums of those of the single parameters, which are looked at where they are fewer.
    fn new(
        fit: &Interpolator,
        parameters: &[f64],
        rows: &[Vec<DVec4>],
        speeds: &[(usize, Vec<f64>)],
    ) -> Result<Option<Self>, GeomError> {
        let moves = |&k: &usize| speeds.iter().any(|(_, own)| own[k] != 0.0);
        let moving: Vec<usize> = (0..parameters.len()).filter(moves).collect();
        let (given, shares): (Vec<Vec<f64>>, Vec<Vec<f64>>) = if moving.len() < speeds.len() {
            let single = |&k: &usize| unit(parameters.len(), k);
            let of = |(_, own): &(usize, Vec<f64>)| moving.iter().map(|&k| own[k]).collect();
            (moving.iter().map(single).collect(), speeds.iter().map(of).collect())
        } else {
            let own = |(_, own): &(usize, Vec<f64>)| own.clone();
            let alone = (0..speeds.len()).map(|idx| unit(speeds.len(), idx));
            (speeds.iter().map(own).collect(), alone.collect())
        };
        let tangents = [DVec4::ZERO; 2];
        let mut by_speed = Vec::with_capacity(rows.len());
        for row in rows {
            let values: Vec<DVec4> =
                parameters.iter().map(|&t| homogeneous_at(fit.knots(), row, t)).collect();
            let ends = Ends::Averaged;
            let spline = MovingSpline::new((fit, ends), parameters, &values, tangents)?;
            let Some(spline) = spline.filter(|spline| are_near(spline.points(), row)) else {
                return Ok(None);
            };
            let values = &vec![DVec4::ZERO; values.len()];
            let all: Vec<SplineSpeeds<'_>> = given
                .iter()
                .map(|parameters| SplineSpeeds { parameters, values, tangents })
                .collect();
            by_speed.push(spline.slopes(&all)?);
        }
        let n_points = fit.knots().with(simple_inner(fit.knots()).unwrap_or(&[])).n_points();
        Ok(Some(Self { shares, by_speed, n_points }))
    }

    /// The slopes of the net of all rows by one of the variables; none move by none.
    fn slopes(&self, variable: Option<usize>) -> Vec<DVec4> {
        let mut all = vec![DVec4::ZERO; self.by_speed.len() * self.n_points];
        let Some(variable) = variable else { return all };
        for (row, by_speed) in self.by_speed.iter().enumerate() {
            for (points, &share) in by_speed.iter().zip(&self.shares[variable]) {
                if share != 0.0 {
                    self.add(&mut all, row, (points, share));
                }
            }
        }
        all
    }

    /// Adds a share of control points of a row to those of a net.
    fn add(&self, net: &mut [DVec4], row: usize, (points, share): (&[DVec4], f64)) {
        let own = net[row * self.n_points..].iter_mut();
        own.zip(points).for_each(|(sum, &point)| *sum += point * share);
    }
}

fn unit(n: usize, along: usize) -> Vec<f64> {
    (0..n).map(|k| if k == along { 1.0 } else { 0.0 }).collect()
}

/// For each variable the rows of slopes that are not zero, over the knots of which each inner one stands twice.
fn own_rows_twice(
    knots: &KnotVector,
    slopes: &[(usize, Vec<DVec4>)],
    net: &Grid<DVec4>,
) -> Result<Vec<Vec<(usize, Vec<DVec4>)>>, GeomError> {
    let (mut places, mut rows) = (Vec::new(), Vec::new());
    for (variable, (_, slopes)) in slopes.iter().enumerate() {
        for (idx, row) in rows_of(slopes, net).into_iter().enumerate() {
            if row.iter().any(|slope| *slope != DVec4::ZERO) {
                places.push((variable, idx));
                rows.push(row);
            }
        }
    }
    let mut all = vec![Vec::new(); slopes.len()];
    for ((variable, idx), row) in places.into_iter().zip(with_knots_twice(knots, rows)?) {
        all[variable].push((idx, row));
    }
    Ok(all)
}

/// Rows of a net, or of slopes in its order.
fn rows_of(points: &[DVec4], net: &Grid<DVec4>) -> Vec<Vec<DVec4>> {
    points.chunks_exact(net.n_columns()).map(<[DVec4]>::to_vec).collect()
}

fn homogeneous_at(knots: &KnotVector, line: &[DVec4], t: f64) -> DVec4 {
    knots.with_basis(t, |span, values| {
        line[knots.support(span)].iter().zip(values).map(|(&point, &n)| point * n).sum()
    })
}

pub(super) fn are_near(a: &[DVec4], b: &[DVec4]) -> bool {
    let size = b.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
    let pairs = a.iter().zip(b);
    pairs.map(|(a, b)| (a - b).abs().max_element()).fold(0.0, f64::max) <= EXACT_RELATIVE * size
}
