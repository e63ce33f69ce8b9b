//! Surfaces through grids of points that move: how much sums of their control points grow with the points.
//!
//! The columns of points become splines along u, and the rows of their control points splines along v. So what asks for a
//! sum of control points is passed on by the transposed equations of the rows to the control points of the columns, and
//! by those of the columns to the points, as for [curves](super::growth). Where a rule finds the parameters they move
//! with the points, each with the mean of what its lines have.

use std::sync::{Arc, OnceLock};

use glam::{DVec3, DVec4};

use super::{
    grid_lines::{FittedLines, GridLines, line_growths},
    growth::PointGrowths,
    moving::MovingSpline,
    moving_surface::are_near,
};
use crate::{
    Direction, GeomError, Grid, KnotVector, NurbsSurface, PointSlopes, VariedSurface,
    varied::SlopeWays,
};

impl VariedSurface {
    /// A surface through a grid of points, row after row along v, with the slopes that it has by these. None where it is
    /// not made of them so, or its slopes are not known: by [`Parametrization::Foley`](crate::Parametrization::Foley), of lines that are polygons, and
    /// where neighbours at one place part.
    ///
    /// # Errors
    /// [`CountError::WrongCount`](crate::CountError::WrongCount) unless there are slopes of each point; as for [`Interpolator::new`](crate::Interpolator::new).
    ///
    /// ```
    /// use std::sync::Arc;
    /// use virote_kernel::{Ends, FirstPass, Grid, GridLines, Interpolator, Jet, LineFit, PointSlopes, VariedSurface, glam::{DVec3, DVec4}};
    ///
    /// // The corner of a saddle rises; the middle does so by a quarter.
    /// let corners = Grid::from_fn(2, 2, |i, j| DVec3::new(i as f64, j as f64, (i * j) as f64));
    /// let lines = GridLines { degree: 1, ends: Ends::Averaged, parameters: &[0.0, 1.0], rule: None };
    /// let fit = LineFit::Through(Interpolator::new(lines.parameters, lines.degree, lines.ends)?);
    /// let saddle = Arc::new(FirstPass::new(&corners, &fit)?.second(&fit)?);
    /// let slopes = PointSlopes::new(1, 4, vec![(0, vec![DVec4::ZERO, DVec4::ZERO, DVec4::ZERO, DVec4::Z])])?;
    /// let varied = VariedSurface::through_grid(&saddle, [lines; 2], &corners, &slopes)?.expect("slopes");
    /// let half = Jet::with_slopes(0.5, &[0.0])?;
    /// assert_eq!(varied.derivatives_at([&half, &half], 0)?[0][0][2].slopes(), [0.25]);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    pub fn through_grid(
        surface: &Arc<NurbsSurface>,
        lines: [GridLines<'_>; 2],
        points: &Grid<DVec3>,
        slopes: &PointSlopes,
    ) -> Result<Option<Self>, GeomError> {
        slopes.check_points(points.as_slice().len())?;
        let turned = points.transposed();
        let (u, v) = (
            FittedLines::new(&lines[0], &turned, slopes, Direction::U)?,
            FittedLines::new(&lines[1], points, slopes, Direction::V)?,
        );
        let (Some(u), Some(v)) = (u, v) else { return Ok(None) };
        let is_fitted = |fitted: &FittedLines, own: &KnotVector| fitted.fit.knots() == own;
        if !is_fitted(&u, surface.knots_u()) || !is_fitted(&v, surface.knots_v()) {
            return Ok(None);
        }
        let found = surface.points_on_grid(lines[0].parameters, lines[1].parameters);
        let lifted = |grid: &Grid<DVec3>| -> Vec<DVec4> {
            grid.as_slice().iter().map(|point| point.extend(1.0)).collect()
        };
        if surface.is_rational() || !are_near(&lifted(&found), &lifted(points)) {
            return Ok(None);
        }
        let Some(growths) = GridGrowths::new([u, v], points)? else { return Ok(None) };
        let fixed = growths.on_fixed_knots(surface)?;
        let n_points = fixed.control_points().as_slice().len();
        let n_variables = slopes.n_variables();
        let variables: Vec<usize> = slopes.moving().map(|(variable, ..)| variable).collect();
        let slopes = if slopes.are_asked_rather() {
            let growths = Arc::new(growths);
            let (forward, given) = (Arc::clone(&growths), slopes.clone());
            let all = move || forward.all_slopes(&given).ok().flatten();
            let moving = moving_points(slopes, points);
            let sums = move |factors: &[f64]| growths.slopes(factors, &moving);
            let ways = SlopeWays { sums: Box::new(sums), all: Box::new(all) };
            PointSlopes::asked(n_variables, n_points, variables, ways)
        } else {
            let Some(all) = growths.all_slopes(slopes)? else { return Ok(None) };
            PointSlopes::new(n_variables, n_points, variables.into_iter().zip(all).collect())?
        };
        Ok(Some(Self::new(fixed, slopes)?.known_of_moving_knots(Arc::clone(surface))))
    }
}

/// Points that move with a variable, by row and column, and how fast.
type MovingPoints = Vec<(usize, usize, DVec3)>;

/// The points that move with each variable that moves any.
fn moving_points(slopes: &PointSlopes, points: &Grid<DVec3>) -> Vec<MovingPoints> {
    let n_columns = points.n_columns();
    let of = |(_, range, own): (usize, std::ops::Range<usize>, &[DVec4])| {
        let moving = range.filter(|idx| own[*idx] != DVec4::ZERO);
        moving.map(|idx| (idx / n_columns, idx % n_columns, own[idx].truncate())).collect()
    };
    slopes.moving().map(of).collect()
}

/// What tells how sums of the control points of a surface grow with the points that it goes through.
#[derive(Debug)]
struct GridGrowths {
    /// Along u and along v.
    lines: [FittedLines; 2],
    points: Grid<DVec3>,
    /// The columns of points, where their parameters move.
    columns: Vec<Option<MovingSpline<'static>>>,
    /// The control points of the columns: a row for each.
    values: Grid<DVec4>,
    /// Their rows, where the parameters move, as they are asked for.
    rows: Vec<OnceLock<Option<MovingSpline<'static>>>>,
}

impl GridGrowths {
    /// None where lines have no slopes.
    fn new(lines: [FittedLines; 2], points: &Grid<DVec3>) -> Result<Option<Self>, GeomError> {
        let [along_u, along_v] = &lines;
        let (mut columns, mut values) = (Vec::new(), Vec::new());
        let turned = points.transposed();
        for j in 0..points.n_columns() {
            let column: Vec<DVec4> = turned.row(j).iter().map(|point| point.extend(1.0)).collect();
            values.push(along_u.fit.through(&column)?);
            columns.push(match along_u.rule {
                None => None,
                Some(_) => match along_u.spline(&column)? {
                    None => return Ok(None),
                    spline => spline,
                },
            });
        }
        let values = Grid::from_rows(along_u.on_knots(values)?)?.transposed();
        let rows: Vec<OnceLock<_>> = (0..values.n_rows()).map(|_| OnceLock::new()).collect();
        // One says of all whether they have slopes.
        if along_v.rule.is_some() && along_v.spline(values.row(0))?.is_none() {
            return Ok(None);
        }
        Ok(Some(Self { lines, points: points.clone(), columns, values, rows }))
    }

    /// A surface on its own knots over those over which slopes are told.
    fn on_fixed_knots(&self, surface: &Arc<NurbsSurface>) -> Result<Arc<NurbsSurface>, GeomError> {
        let [along_u, along_v] = &self.lines;
        if along_u.rule.is_none() && along_v.rule.is_none() {
            return Ok(Arc::clone(surface));
        }
        let rows = |net: &Grid<DVec4>| (0..net.n_rows()).map(|i| net.row(i).to_vec()).collect();
        let net = Grid::from_rows(along_v.on_knots(rows(surface.control_points()))?)?;
        let net = Grid::from_rows(along_u.on_knots(rows(&net.transposed()))?)?.transposed();
        let net = net.map(|point| point.truncate());
        NurbsSurface::polynomial(along_u.knots(), along_v.knots(), &net).map(Arc::new)
    }

    /// A row of the control points of the columns as its parameters move.
    fn row(&self, idx: usize) -> Option<&MovingSpline<'static>> {
        let [_, along_v] = &self.lines;
        let made = || along_v.spline(self.values.row(idx)).ok().flatten();
        self.rows[idx].get_or_init(made).as_ref()
    }

    /// The slopes of a sum of control points with these factors, by each variable that moves any.
    fn slopes(&self, factors: &[f64], moving: &[MovingPoints]) -> Vec<DVec3> {
        let [along_u, along_v] = &self.lines;
        let [n_rows, n_columns] = [self.points.n_rows(), self.points.n_columns()];
        let mut by_value = vec![vec![0.0; self.rows.len()]; n_columns];
        let mut by_v = vec![DVec4::ZERO; n_columns];
        let each_row = factors.chunks_exact(factors.len() / self.rows.len()).enumerate();
        for (idx, own) in each_row.filter(|(_, own)| own.iter().any(|factor| *factor != 0.0)) {
            let spline = along_v.rule.as_ref().map(|_| self.row(idx));
            let growths = line_growths(&along_v.fit, spline, own, &mut by_v);
            by_value.iter_mut().zip(growths).for_each(|(column, growth)| column[idx] = growth);
        }
        let mut by_u = vec![DVec4::ZERO; n_rows];
        let mut rows = vec![PointGrowths::default(); n_rows];
        rows.iter_mut().for_each(|row| row.by_value = vec![0.0; n_columns]);
        for (j, own) in by_value.iter().enumerate() {
            let spline = along_u.rule.as_ref().map(|_| self.columns[j].as_ref());
            let growths = line_growths(&along_u.fit, spline, own, &mut by_u);
            rows.iter_mut().zip(growths).for_each(|(row, growth)| row.by_value[j] = growth);
        }
        let mut columns = vec![PointGrowths::default(); n_columns];
        for (lines, rule, by_parameter) in
            [(&mut columns, &along_u.rule, &by_u), (&mut rows, &along_v.rule, &by_v)]
        {
            let Some(rule) = rule else { continue };
            for (idx, line) in lines.iter_mut().enumerate() {
                line.steps = rule.steps(idx, by_parameter);
            }
        }
        let slope = |own: &MovingPoints| {
            own.iter()
                .map(|&(i, j, speed)| rows[i].with(j, speed) + columns[j].with(i, speed))
                .sum()
        };
        moving.iter().map(slope).collect()
    }

    /// The slopes of all control points by each variable that moves any; none where the parameters have none.
    fn all_slopes(&self, slopes: &PointSlopes) -> Result<Option<Vec<Vec<DVec4>>>, GeomError> {
        let [along_u, along_v] = &self.lines;
        let [n_rows, n_columns] = [self.points.n_rows(), self.points.n_columns()];
        let own: Vec<Grid<DVec4>> = slopes
            .by_variable()
            .iter()
            .map(|(_, own)| Grid::from_fn(n_rows, n_columns, |i, j| own[i * n_columns + j]))
            .collect();
        let turned: Vec<Grid<DVec4>> = own.iter().map(Grid::transposed).collect();
        let speeds = |lines: &FittedLines, points: &Grid<DVec3>, slopes: &[Grid<DVec4>]| {
            let Some(rule) = &lines.rule else { return Some(Vec::new()) };
            slopes.iter().map(|slopes| rule.speeds(points, slopes)).collect()
        };
        let (Some(by_u), Some(by_v)) = (
            speeds(along_u, &self.points.transposed(), &turned),
            speeds(along_v, &self.points, &own),
        ) else {
            return Ok(None);
        };
        let mut columns = Vec::with_capacity(n_columns);
        for j in 0..n_columns {
            let values: Vec<Vec<DVec4>> = turned.iter().map(|own| own.row(j).to_vec()).collect();
            columns.push(along_u.line_slopes(self.columns[j].as_ref(), &values, &by_u)?);
        }
        let mut all = vec![Vec::new(); own.len()];
        for idx in 0..self.rows.len() {
            let values: Vec<Vec<DVec4>> = (0..own.len())
                .map(|variable| columns.iter().map(|column| column[variable][idx]).collect())
                .collect();
            let spline = along_v.rule.as_ref().and_then(|_| self.row(idx));
            let found = along_v.line_slopes(spline, &values, &by_v)?;
            all.iter_mut().zip(found).for_each(|(all, own)| all.extend(own));
        }
        Ok(Some(all))
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::{DVec3, DVec4};

    use super::GridLines;
    use crate::{
        Ends, FirstPass, Grid, Interpolator, LineFit, NurbsSurface, Parametrization, PointSlopes,
        VariedSurface,
    };

    const N_ROWS: usize = 5;
    const N_COLUMNS: usize = 6;

    fn grid() -> Grid<DVec3> {
        Grid::from_fn(N_ROWS, N_COLUMNS, |i, j| {
            let (u, v) = (i as f64, j as f64);
            DVec3::new(u + 0.2 * libm::sin(v), 1.3 * v + 0.1 * libm::cos(3.0 * u), libm::sin(u * v))
        })
    }

    /// Of some points each, and of all together.
    fn slopes() -> PointSlopes {
        let n_points = N_ROWS * N_COLUMNS;
        let one = |moving: usize| {
            let mut own = vec![DVec4::ZERO; n_points];
            own[moving] = DVec4::new(0.3, 1.0, -0.7, 0.0);
            own
        };
        let wave = |i: usize| DVec4::new(1.0, libm::cos(i as f64), libm::sin(i as f64), 0.0);
        let mut all: Vec<Vec<DVec4>> = [0, 3, 8, 17, 29].map(one).into();
        all.push((0..n_points).map(wave).collect());
        // So many that slopes are asked for.
        let again = all.clone().into_iter().cycle().take(60);
        PointSlopes::new(60, n_points, again.enumerate().collect()).unwrap()
    }

    fn surface(grid: &Grid<DVec3>, found: [&[f64]; 2], [u, v]: [(usize, Ends); 2]) -> NurbsSurface {
        let fit = |at: &[f64], (degree, ends)| {
            LineFit::Through(Interpolator::new(at, degree, ends).unwrap())
        };
        FirstPass::new(grid, &fit(found[0], u)).unwrap().second(&fit(found[1], v)).unwrap()
    }

    fn parameters(grid: &Grid<DVec3>, rules: [Option<Parametrization>; 2]) -> [Vec<f64>; 2] {
        [(grid.transposed(), rules[0]), (grid.clone(), rules[1])].map(|(rows, rule)| match rule {
            Some(rule) => rule.mean_parameters(&rows).unwrap(),
            None => (0..rows.n_columns()).map(|k| (k * (k + 2)) as f64).collect(),
        })
    }

    #[test]
    fn surfaces_through_grids_grow_with_the_points() {
        let (grid, slopes) = (grid(), slopes());
        let chord = Some(Parametrization::Chord);
        let centripetal = Some(Parametrization::Centripetal);
        for rules in [[chord; 2], [centripetal, chord], [None, chord], [chord, None], [None; 2]] {
            for ends in [
                [(3, Ends::Bessel); 2],
                [(2, Ends::Averaged), (3, Ends::Natural)],
                [(3, Ends::NotAKnot), (4, Ends::Averaged)],
                [(3, Ends::Quadratic), (3, Ends::Averaged)],
            ] {
                let [us, vs] = parameters(&grid, rules);
                let lines = |k: usize, parameters| GridLines {
                    degree: ends[k].0,
                    ends: ends[k].1,
                    parameters,
                    rule: rules[k],
                };
                let given = Arc::new(surface(&grid, [&us, &vs], ends));
                let at = [lines(0, &us), lines(1, &vs)];
                let varied = VariedSurface::through_grid(&given, at, &grid, &slopes);
                let varied = varied.unwrap().unwrap();
                let n_points = varied.surface().control_points().as_slice().len();
                for (variable, all) in &slopes.by_variable()[..6] {
                    let moved = |h: f64| {
                        let points = grid.as_slice().iter().zip(all);
                        let points =
                            points.map(|(point, own)| *point + own.truncate() * h).collect();
                        let moved = Grid::new(N_ROWS, N_COLUMNS, points).unwrap();
                        let [us, vs] = parameters(&moved, rules);
                        surface(&moved, [&us, &vs], ends)
                    };
                    let h = 1e-5;
                    let (ahead, behind) = (moved(h), moved(-h));
                    let listed = &varied.slopes().by_variable()[*variable].1;
                    for (u, v) in [(0.11, 0.83), (0.52, 0.34), (0.97, 0.02), (0.0, 0.5)] {
                        let [u, v] = [given.domain_u().at(u), given.domain_v().at(v)];
                        let expected = (ahead.point_at(u, v) - behind.point_at(u, v)) / (2.0 * h);
                        let mut factors = vec![DVec4::ZERO; n_points];
                        let (ku, kv) = (varied.surface().knots_u(), varied.surface().knots_v());
                        let mut found = DVec3::ZERO;
                        ku.with_basis(u, |span_u, basis_u| {
                            kv.with_basis(v, |span_v, basis_v| {
                                for (i, n) in ku.support(span_u).zip(basis_u) {
                                    for (j, m) in kv.support(span_v).zip(basis_v) {
                                        let idx = i * kv.n_points() + j;
                                        factors[idx] = DVec4::new(n * m, 0.0, 0.0, 0.0);
                                        found += listed[idx].truncate() * n * m;
                                    }
                                }
                            });
                        });
                        let error = found.distance(expected);
                        assert!(error < 1e-7, "{rules:?} {ends:?} {variable} {u} {v}: {error}");
                        let asked = varied.slopes().through(&factors)[*variable];
                        assert!((asked - found.x).abs() < 1e-12, "{rules:?} {ends:?}: {asked}");
                    }
                }
            }
        }
    }

    #[test]
    fn points_that_part_have_no_slopes() {
        let pole = Grid::from_fn(3, 4, |i, j| match i {
            0 => DVec3::ZERO,
            _ => DVec3::new(i as f64, j as f64 * i as f64, 0.5 * i as f64),
        });
        let chord = Parametrization::Chord;
        let (us, vs) = (
            chord.mean_parameters(&pole.transposed()).unwrap(),
            chord.mean_parameters(&pole).unwrap(),
        );
        let lines = |degree, parameters| GridLines {
            degree,
            ends: Ends::Averaged,
            parameters,
            rule: Some(chord),
        };
        let ends = [(2, Ends::Averaged), (3, Ends::Averaged)];
        let given = Arc::new(surface(&pole, [&us, &vs], ends));
        let at = [lines(2, &us[..]), lines(3, &vs[..])];
        let slopes = |n_moving: usize| {
            let own = (0..12).map(|i| if i < n_moving { DVec4::Z } else { DVec4::ZERO }).collect();
            PointSlopes::new(1, 12, vec![(0, own)]).unwrap()
        };
        let of =
            |n_moving| VariedSurface::through_grid(&given, at, &pole, &slopes(n_moving)).unwrap();
        assert!(of(1).is_none());
        assert!(of(4).is_some());
    }
}
