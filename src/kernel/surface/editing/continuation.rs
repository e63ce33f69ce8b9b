//! A Bézier patch that goes on from a side of a surface.

use glam::{DVec3, DVec4};

use crate::{
    CountError, GeomError, Grid, KnotVector, Side, bezier,
    refine::ControlLines,
    surface::{Direction, NurbsSurface},
};

impl NurbsSurface {
    /// The surface on 0..1 across a side, of Bézier form there, whose derivatives across it are
    /// those of this one up to an order; along the side it has the knots of this one.
    ///
    /// `across` is the direction that the side is an end of, `end` which one: [`Side::Right`] is
    /// where the parameter ends, so that the new surface begins there, and else ends there. `free`
    /// are its control points beyond those that follow from the order, in the same directions; of
    /// a rational surface each takes the weight of the point of the side that it belongs to.
    ///
    /// The k-th derivative of a Bézier curve at its end is p(p − 1)… times the k-th difference of
    /// its first points, also in homogeneous space, where it makes that of the rational one.
    /// Linkeová, *Curves and Surfaces for Computer Graphics*, (3.51).
    ///
    /// # Errors
    /// [`CountError::WrongCount`] unless there are as many free points along the side as the side
    /// has, and one or more across; `DegreeError::DegreeTooHigh`, `InputError::NotFinite`,
    /// `WeightError::VanishingWeightsAt`.
    pub fn continued(
        &self,
        across: Direction,
        end: Side,
        order: usize,
        free: &Grid<DVec3>,
    ) -> Result<Self, GeomError> {
        if end == Side::Left {
            let n = [free.n_rows(), free.n_columns()];
            let turned = Grid::from_fn(n[0], n[1], |i, j| match across {
                Direction::U => free.get(n[0] - 1 - i, j),
                Direction::V => free.get(i, n[1] - 1 - j),
            });
            let turned = self.reversed(across).continued(across, Side::Right, order, &turned)?;
            return Ok(turned.reversed(across));
        }
        let free = match across {
            Direction::U => free.transposed(),
            Direction::V => free.clone(),
        };
        let ControlLines { knots, lines } = self.clamped(across).lines(across);
        let needed = lines.len();
        if free.n_rows() != needed || free.n_columns() == 0 {
            let what = "rows of points along the side";
            return Err(CountError::WrongCount { what, needed, got: free.n_rows() }.into());
        }
        let degree = order + free.n_columns();
        let new_knots = KnotVector::bezier(degree)?;
        let last = knots.spans().last().unwrap_or(knots.degree());
        let width = knots.span_interval(last).length();
        let line = |(i, line): (usize, &Vec<DVec4>)| {
            let piece = bezier::piece(&knots, line, last);
            let mut points = continuation(&piece, width, order, degree);
            let weight = piece[piece.len() - 1].w;
            points.extend(free.row(i).iter().map(|&point| (point * weight).extend(weight)));
            points
        };
        let lines = lines.iter().enumerate().map(line).collect();
        let new = self.with_lines(across, ControlLines { knots: new_knots, lines });
        Self::new(new.knots_u, new.knots_v, new.control_points)
    }
}

/// The first `order + 1` control points of the Bézier curve of a degree on 0..1 that goes on from
/// a piece on an interval of a width.
fn continuation(piece: &[DVec4], width: f64, order: usize, degree: usize) -> Vec<DVec4> {
    let p = piece.len() - 1;

    // Differences at the end of the piece, each scaled to those of the new points.
    let mut tail: Vec<DVec4> = piece.iter().rev().copied().collect();
    let mut differences = Vec::with_capacity(order + 1);
    let mut scale = 1.0;
    for k in 0..=order {
        differences.push(if k <= p { tail[0] * scale } else { DVec4::ZERO });
        scale *= p.saturating_sub(k) as f64 / ((degree - k) as f64 * width);
        for i in 0..tail.len() - 1 {
            let next = tail[i + 1];
            tail[i] -= next;
        }
        tail.truncate(tail.len().max(2) - 1);
    }

    // Points of these differences.
    let mut points = Vec::with_capacity(degree + 1);
    while let Some(&point) = differences.first() {
        points.push(point);
        let n_left = differences.len() - 1;
        for k in 0..n_left {
            let next = differences[k + 1];
            differences[k] += next;
        }
        differences.truncate(n_left);
    }
    points
}
