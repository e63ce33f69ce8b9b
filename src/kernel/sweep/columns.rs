//! Columns of control points of a swept surface: through placements of the section, or about the
//! control points of the path.

use glam::{DVec3, DVec4};

use super::{MovingSection, PlacementFit, SKIN_DEGREE};
use crate::{
    Ends, GeomError, Grid, Interpolator, Interval, KnotVector, NurbsSurface, Side, homogeneous,
};

/// Steps of a span in which the derivatives at its ends are taken: differences of the fourth order
/// are then right to rounding.
const STENCIL: f64 = 256.0;

/// Spans are within the cell of a turn that are no longer than it, but for rounding.
const CELL_SLACK: f64 = 1.01;

impl MovingSection<'_> {
    /// The surface through placements at the nodes of these knots.
    pub(super) fn fitted(&mut self, knots: &KnotVector) -> Result<PlacementFit, GeomError> {
        let at = knots.greville();
        let columns = self.columns(&at)?;
        self.through(&Interpolator::on_knots(&at, knots.clone())?, &columns, at)
    }

    /// The section's control points at each of the parameters.
    fn columns(&mut self, at: &[f64]) -> Result<Vec<Vec<DVec4>>, GeomError> {
        at.iter().map(|&t| self.placed(t)).collect()
    }

    /// The surface whose lines along v pass through the columns.
    fn through(
        &self,
        fit: &Interpolator,
        columns: &[Vec<DVec4>],
        at: Vec<f64>,
    ) -> Result<PlacementFit, GeomError> {
        let rows: Vec<Vec<DVec4>> = (0..self.section.control_points().len())
            .map(|i| fit.through(&columns.iter().map(|column| column[i]).collect::<Vec<_>>()))
            .collect::<Result<_, _>>()?;
        let (own, along) = (self.section.knots().clone(), fit.knots().clone());
        Ok(PlacementFit { surface: NurbsSurface::new(own, along, Grid::from_rows(rows)?)?, at })
    }

    /// The cubic skin through `n` placements at even parameters, or of the highest degree that
    /// fewer allow. Where the path comes back to its start, and the section with it, it is
    /// periodic: its seam is as smooth as the rest.
    ///
    /// Piegl & Tiller, *The NURBS Book*, A10.2.
    pub(super) fn skinned(&mut self, n: usize, tolerance: f64) -> Result<PlacementFit, GeomError> {
        let at = self.path.domain().steps(n - 1);
        let mut columns = self.columns(&at)?;
        let apart =
            |(a, b): (&DVec4, &DVec4)| homogeneous::place(*a).distance(homogeneous::place(*b));
        let gap = columns[0].iter().zip(&columns[n - 1]).map(apart).fold(0.0, f64::max);
        if self.frames.is_closed() && SKIN_DEGREE + 1 < n && gap <= tolerance {
            columns.pop();
            return self.through(&Interpolator::periodic(&at, SKIN_DEGREE)?, &columns, at);
        }
        let fit = Interpolator::new(&at, SKIN_DEGREE.min(n - 1), Ends::Averaged)?;
        self.through(&fit, &columns, at)
    }

    /// The surface whose columns are the section about each control point of the path, which has
    /// these knots: no equations are solved, and nothing swings out.
    pub(super) fn offset(&mut self, knots: &KnotVector) -> Result<PlacementFit, GeomError> {
        let path = self.path.elevate_degree(knots.degree())?;
        let mut missing = knots.as_slice().to_vec();
        for t in path.knots().as_slice() {
            if let Some(i) = missing.iter().position(|knot| knot.to_bits() == t.to_bits()) {
                missing.remove(i);
            }
        }
        let path = path.insert_knots(&missing)?;
        let at = path.knots().greville();
        let columns: Vec<Vec<DVec4>> = path
            .control_points()
            .iter()
            .zip(&at)
            .map(|(&origin, &t)| self.placed_about(origin, t))
            .collect::<Result<_, _>>()?;
        let net = Grid::from_rows(columns)?.transposed();
        let surface = NurbsSurface::new(self.section.knots().clone(), path.knots().clone(), net)?;
        Ok(PlacementFit { surface, at })
    }

    /// Gives the columns next to the ends, and next to knots where nothing else holds both sides
    /// together, the derivatives of the true surface: a path that goes on smoothly, over its seam
    /// too, sweeps a surface without a crease.
    pub(super) fn joined(&mut self, fit: &mut PlacementFit) -> Result<(), GeomError> {
        let knots = fit.surface.knots_v().clone();
        let p = knots.degree();
        if p < 3 {
            return Ok(());
        }
        let net = fit.surface.control_points();
        let mut rows: Vec<Vec<DVec4>> = (0..net.n_rows()).map(|i| net.row(i).to_vec()).collect();
        for span in knots.spans() {
            let interval = knots.span_interval(span);
            if self.turning_about(interval).is_some() {
                continue;
            }
            let is_joint = |t: f64| p <= knots.exact_multiplicity(t);
            // The control points of the span are those from span - p to span.
            let sides = [
                (interval.start(), interval.length(), span - p),
                (interval.end(), -interval.length(), span),
            ];
            for (t, length, column) in sides.into_iter().filter(|&(t, ..)| is_joint(t)) {
                let next = if 0.0 < length { column + 1 } else { column - 1 };
                let derivatives = self.derivatives(t, length / STENCIL)?;
                for (row, derivative) in rows.iter_mut().zip(derivatives) {
                    row[next] = row[column] + derivative * (length / p as f64);
                }
            }
        }
        fit.surface =
            NurbsSurface::new(self.section.knots().clone(), knots, Grid::from_rows(rows)?)?;
        Ok(())
    }

    /// The derivatives by t of what [`Self::placed`] tells, from one side: those of the path, and what is beside it
    /// as the quartic through five places a step apart. Differences of places on the path would lose
    /// the digits that its coordinates have far from the origin.
    fn derivatives(&mut self, t: f64, step: f64) -> Result<Vec<DVec4>, GeomError> {
        const WEIGHTS: [f64; 5] = [-25.0 / 12.0, 4.0, -3.0, 4.0 / 3.0, -0.25];
        let mut sums = vec![DVec3::ZERO; self.section.control_points().len()];
        for (k, weight) in WEIGHTS.into_iter().enumerate() {
            let at = t + k as f64 * step;
            let share = if self.keeps_weights { self.path.homogeneous_at(at).w } else { 1.0 };
            for (sum, beside) in sums.iter_mut().zip(self.beside(at)?) {
                *sum += beside * (share * weight / step);
            }
        }
        let side = if 0.0 < step { Side::Right } else { Side::Left };
        let along = if self.keeps_weights {
            let span = self.path.knots().span_beside(t, side);
            self.path.homogeneous_derivatives(span, t, 1)[1]
        } else {
            self.path.derivatives_beside(t, side, 1)[1].extend(0.0)
        };
        let own = self.section.control_points().iter();
        Ok(own.zip(sums).map(|(p, sum)| along * p.w + sum.extend(0.0)).collect())
    }

    /// The cell of a turn that a span is within.
    pub(super) fn turning_about(&self, span: Interval) -> Option<[f64; 2]> {
        let turns = |&[before, behind]: &[f64; 2]| {
            let is_inside = before <= span.at(0.5) && span.at(0.5) <= behind;
            is_inside && span.length() <= CELL_SLACK * (behind - before)
        };
        self.frames.flips().iter().copied().find(turns)
    }

    /// How far control points of the section are apart at most between two parameters.
    pub(super) fn gap(&mut self, before: f64, behind: f64) -> Result<f64, GeomError> {
        let ends = [self.placed(before)?, self.placed(behind)?]
            .map(|points| points.into_iter().map(homogeneous::place).collect::<Vec<_>>());
        let apart = ends[0].iter().zip(&ends[1]).map(|(a, b)| a.distance(*b));
        Ok(apart.fold(0.0, f64::max))
    }
}
