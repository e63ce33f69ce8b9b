//! Surfaces whose lines are splines through points or sections, where the parameters of these move.

use std::ops::RangeInclusive;

use glam::{DVec3, DVec4};

use super::{
    Ends, Interpolator, Parametrization,
    moving::{MovingSpline, SplineSpeeds},
    section_steps::SectionSteps,
};
use crate::{
    Direction, GeomError, Grid, KnotVector, NurbsSurface, PointSlopes, SectionParameters,
    VariedSurface,
    tolerance::EXACT_RELATIVE,
    varied::knots::{simple_inner, with_knots_twice},
};

impl VariedSurface {
    /// The surface whose lines along a direction are the splines that [`Interpolator::new`] makes of a degree and
    /// ends at parameters, where these move too: on knots that do not move. None where the lines are others or have no slopes.
    ///
    /// # Errors
    /// Where the work is ended.
    pub fn with_moving_parameters(
        &self,
        along: Direction,
        (degree, ends): (usize, Ends),
        parameters: &[f64],
        speeds: &[(usize, Vec<f64>)],
    ) -> Result<Option<Self>, GeomError> {
        let surface = self.surface();
        let fit = Interpolator::new(parameters, degree, ends)?;
        let knots = match along {
            Direction::U => surface.knots_u(),
            Direction::V => surface.knots_v(),
        };
        if fit.knots() != knots {
            return Ok(None);
        }
        let net = surface.control_points();
        let n_variables = self.slopes().n_variables();
        let lines = lines_of(net.as_slice(), net, along);
        let Some(moving) = MovingLines::new((&fit, ends), parameters, &lines, speeds)? else {
            return Ok(None);
        };
        let own = self.slopes().by_variable();
        let twice = own_lines_twice(knots, own, net, along)?;
        let by_variable = (0..n_variables).filter_map(|variable| {
            let own = own.iter().position(|(idx, _)| *idx == variable);
            let moved = speeds.iter().position(|(idx, _)| *idx == variable);
            (own.is_some() || moved.is_some()).then(|| {
                let mut all = moving.slopes(moved, along);
                for (line, points) in own.into_iter().flat_map(|own| &twice[own]) {
                    moving.add(&mut all, along, *line, (points, 1.0));
                }
                (variable, all)
            })
        });
        let by_variable = by_variable.collect();
        let net = net_of(&with_knots_twice(knots, lines)?, along)?;
        let twice = knots.with(simple_inner(knots).unwrap_or(&[]));
        let [u, v] = match along {
            Direction::U => [twice, surface.knots_v().clone()],
            Direction::V => [surface.knots_u().clone(), twice],
        };
        let slopes = PointSlopes::new(n_variables, net.as_slice().len(), by_variable)?;
        let fixed = NurbsSurface::new(u, v, net)?;
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
        self.with_moving_parameters(Direction::V, (degree, Ends::Averaged), parameters, &speeds)
    }
}

/// What lines do where the parameters of their points move.
struct MovingLines {
    /// How fast the parameters move by each variable, in terms of `by_speed`.
    shares: Vec<Vec<f64>>,
    /// Control points of each line, for each speed.
    by_speed: Vec<Vec<Vec<DVec4>>>,
    /// How many there are of a line.
    n_points: usize,
}

impl MovingLines {
    /// Of lines on the knots of a spline; none where they are not the splines through their points, or have no slopes.
    ///
    /// All speeds are sums of those of the single parameters, which are looked at where they are fewer.
    fn new(
        (fit, ends): (&Interpolator, Ends),
        parameters: &[f64],
        lines: &[Vec<DVec4>],
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
        let mut by_speed = Vec::with_capacity(lines.len());
        for line in lines {
            let values: Vec<DVec4> =
                parameters.iter().map(|&t| homogeneous_at(fit.knots(), line, t)).collect();
            let spline = MovingSpline::new((fit, ends), parameters, &values, tangents)?;
            let Some(spline) = spline.filter(|spline| are_near(spline.points(), line)) else {
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

    /// The slopes of the net of all lines by one of the variables; none move by none.
    fn slopes(&self, variable: Option<usize>, along: Direction) -> Vec<DVec4> {
        let mut all = vec![DVec4::ZERO; self.by_speed.len() * self.n_points];
        let Some(variable) = variable else { return all };
        for (line, by_speed) in self.by_speed.iter().enumerate() {
            for (points, &share) in by_speed.iter().zip(&self.shares[variable]) {
                if share != 0.0 {
                    self.add(&mut all, along, line, (points, share));
                }
            }
        }
        all
    }

    /// Adds a share of control points of a line to those of a net.
    fn add(
        &self,
        net: &mut [DVec4],
        along: Direction,
        line: usize,
        (points, share): (&[DVec4], f64),
    ) {
        let n_lines = self.by_speed.len();
        let [first, step] = match along {
            Direction::V => [line * self.n_points, 1],
            Direction::U => [line, n_lines],
        };
        let own = net[first..].iter_mut().step_by(step);
        own.zip(points).for_each(|(sum, &point)| *sum += point * share);
    }
}

fn unit(n: usize, along: usize) -> Vec<f64> {
    (0..n).map(|k| if k == along { 1.0 } else { 0.0 }).collect()
}

/// For each variable the lines of slopes that are not zero, over the knots of which each inner one stands twice.
fn own_lines_twice(
    knots: &KnotVector,
    slopes: &[(usize, Vec<DVec4>)],
    net: &Grid<DVec4>,
    along: Direction,
) -> Result<Vec<Vec<(usize, Vec<DVec4>)>>, GeomError> {
    let (mut places, mut lines) = (Vec::new(), Vec::new());
    for (variable, (_, slopes)) in slopes.iter().enumerate() {
        for (idx, line) in lines_of(slopes, net, along).into_iter().enumerate() {
            if line.iter().any(|slope| *slope != DVec4::ZERO) {
                places.push((variable, idx));
                lines.push(line);
            }
        }
    }
    let mut all = vec![Vec::new(); slopes.len()];
    for ((variable, idx), line) in places.into_iter().zip(with_knots_twice(knots, lines)?) {
        all[variable].push((idx, line));
    }
    Ok(all)
}

impl Parametrization {
    /// How fast the means of the parameters of rows of points move with these: by each variable. None by
    /// [`Parametrization::Foley`], and where points of a row are at one place.
    ///
    /// # Errors
    /// As for [`Self::mean_parameters`].
    pub fn mean_speeds(
        self,
        rows: &Grid<DVec3>,
        slopes: &[(usize, Grid<DVec3>)],
    ) -> Result<Option<Vec<(usize, Vec<f64>)>>, GeomError> {
        let n = rows.n_rows() as f64;
        let mut all = Vec::new();
        for (variable, slopes) in slopes {
            let mut sums = vec![0.0; rows.n_columns()];
            for i in 0..rows.n_rows() {
                let row = rows.row(i);
                let parameters = self.parameters(row)?;
                let own: Vec<DVec4> = slopes.row(i).iter().map(|slope| slope.extend(0.0)).collect();
                let Some(speeds) = self.speeds(row, &parameters, &own) else { return Ok(None) };
                sums.iter_mut().zip(speeds).for_each(|(sum, speed)| *sum += speed / n);
            }
            all.push((*variable, sums));
        }
        Ok(Some(all))
    }
}

/// Rows or columns of a net, or of slopes in its order.
fn lines_of(points: &[DVec4], net: &Grid<DVec4>, along: Direction) -> Vec<Vec<DVec4>> {
    let n = net.n_columns();
    match along {
        Direction::V => points.chunks_exact(n).map(<[DVec4]>::to_vec).collect(),
        Direction::U => (0..n).map(|j| points[j..].iter().step_by(n).copied().collect()).collect(),
    }
}

fn net_of(lines: &[Vec<DVec4>], along: Direction) -> Result<Grid<DVec4>, GeomError> {
    let grid = Grid::from_rows(lines.to_vec())?;
    Ok(if along == Direction::U { grid.transposed() } else { grid })
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
