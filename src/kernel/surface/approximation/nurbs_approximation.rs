//! Splines near the surface of a function.
//!
//! Biquintic patches take the function's exact partial derivatives of orders up to two in each
//! direction at the crossings of parameter lines: Hermite interpolation in both directions. Lines
//! are added, in the direction that needs them, until every cell between them agrees with the
//! function. A line along which derivatives jump is found and kept as a crease.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec3;

use crate::{
    Bounds, Direction, FitError, GeomError, Grid, JumpError,
    ceiling::{CREASE_HALVINGS, CREASES, STAND_IN_CELLS},
    frame::norm,
    surface::{
        NurbsSurface, ParametricSurface,
        approximation::lines::{
            FIRST_PARTS, LineCell, MixedDerivatives, ORDER, ParameterLines, between, combined, net,
            point_of,
        },
    },
    tolerance::{
        BOX_RELATIVE, KNOT_RELATIVE, LAST_BIT, SUSPICIOUS_CELL_RELATIVE, UNBOUNDED_RELATIVE,
    },
};

/// Places of a cell in each direction at which its distance from the function is measured.
const N_PLACES: usize = 6;

/// Part of the tolerance that a cell may use up at those places, so that it holds between them.
const SAFETY: f64 = 0.5;

/// Part of the tolerance that a cell's edge may use up, beyond which its direction is refined.
const EDGE_SHARE: f64 = 0.1;

/// By how much a box becomes coarser where the function has edges without derivatives.
const COARSER: f64 = 1e3;

/// Halvings that make a smooth cell near.
const SMOOTH_HALVINGS: usize = 4;

impl ParametricSurface {
    /// A biquintic spline on the same domain whose points are within `tolerance` of the
    /// function's at the same parameters, with the function's derivatives up to the second in
    /// each direction at all crossings of its knots. C2 but along creases, which are lines of
    /// constant parameter.
    ///
    /// Half of the tolerance is kept at 36 places of each cell.
    ///
    /// # Errors
    /// [`FitError::NoSplineNearAt`] where [`STAND_IN_CELLS`] do not suffice; and where the function has
    /// no derivatives, as [`Self::derivatives_at`].
    pub fn to_nurbs(&self, tolerance: f64) -> Result<NurbsSurface, GeomError> {
        let mut maker = KnotLineFit {
            surface: self,
            tolerance,
            lines: [ParameterLines::new(self.domain_u()), ParameterLines::new(self.domain_v())],
            nodes: BTreeMap::new(),
            settled: BTreeSet::new(),
        };
        while maker.refine()? {
            GeomError::go_on(maker.nodes.len())?;
        }
        maker.spline()
    }

    /// The smallest axis-aligned box around the surface, to 1e-8 of its size, and to 1e-5 where
    /// that takes too many cells.
    ///
    /// # Errors
    /// As [`Self::to_nurbs`].
    pub fn bounds(&self) -> Result<Bounds, GeomError> {
        let mut probes = Vec::new();
        for u in self.domain_u().steps(FIRST_PARTS) {
            for v in self.domain_v().steps(FIRST_PARTS) {
                probes.push(self.point_at(u, v)?);
            }
        }
        let size = |bounds: Bounds| {
            BOX_RELATIVE * bounds.diagonal() + LAST_BIT.sqrt() * bounds.magnitude()
        };
        let tolerance = Bounds::of(probes.iter().copied()).map_or(0.0, size);
        if tolerance <= 0.0 {
            return self.to_nurbs(BOX_RELATIVE).map(|spline| spline.bounds());
        }
        let spline = match self.to_nurbs(tolerance) {
            // A square root at an edge.
            Err(GeomError::Fit(_)) => self.to_nurbs(COARSER * tolerance)?,
            spline => spline?,
        };
        Ok(probes.into_iter().fold(spline.bounds(), Bounds::with))
    }
}

/// The search for lines.
struct KnotLineFit<'s> {
    surface: &'s ParametricSurface,
    tolerance: f64,
    lines: [ParameterLines; 2],
    nodes: BTreeMap<[u64; 2], MixedDerivatives>,
    /// Cells that are near the function, by their lines.
    settled: BTreeSet<[u64; 4]>,
}

impl KnotLineFit<'_> {
    /// Adds lines where cells are not near the function; whether there were any.
    fn refine(&mut self) -> Result<bool, GeomError> {
        let (n_u, n_v) = (self.lines[0].n_cells(), self.lines[1].n_cells());
        let mut halved = [BTreeSet::new(), BTreeSet::new()];
        for i in 0..n_u {
            for j in 0..n_v {
                // A cell between lines that come anyway waits for them.
                if halved[0].contains(&i) && halved[1].contains(&j) {
                    continue;
                }
                let cell = self.cell(i, j);
                let key = [cell.u[0], cell.u[1], cell.v[0], cell.v[1]].map(f64::to_bits);
                if self.settled.contains(&key) {
                    continue;
                }
                let Some(corners) = self.corners(cell)? else { return Ok(true) };
                let [across_u, across_v] = self.needs(cell, &corners)?;
                if !across_u && !across_v {
                    self.settled.insert(key);
                }
                for (direction, needs, idx) in
                    [(Direction::U, across_u, i), (Direction::V, across_v, j)]
                {
                    if !needs {
                        continue;
                    }
                    if self.finds_crease(direction, cell)? {
                        return Ok(true);
                    }
                    halved[direction].insert(idx);
                }
                let n_cells = (n_u + halved[0].len()) * (n_v + halved[1].len());
                if STAND_IN_CELLS < n_cells {
                    return Err(self.not_near(cell.u[0], cell.v[0]));
                }
            }
        }
        for (lines, halved) in self.lines.iter_mut().zip(&halved) {
            let middle = |&i: &usize| 0.5 * (lines.parameters[i] + lines.parameters[i + 1]);
            let middles: Vec<f64> = halved.iter().map(middle).collect();
            lines.add(&middles);
        }
        Ok(halved.iter().any(|halved| !halved.is_empty()))
    }

    fn cell(&self, i: usize, j: usize) -> LineCell {
        let ((u, places_u), (v, places_v)) = (self.lines[0].cell(i), self.lines[1].cell(j));
        LineCell { u, v, places_u, places_v }
    }

    /// The derivatives at the corners of a cell; none where that made a line a crease.
    fn corners(&mut self, cell: LineCell) -> Result<Option<[MixedDerivatives; 4]>, GeomError> {
        let mut corners = Vec::with_capacity(4);
        for (i, u) in cell.places_u.into_iter().enumerate() {
            for (j, v) in cell.places_v.into_iter().enumerate() {
                match self.node(u, v) {
                    Ok(node) => corners.push(node),
                    Err(error) if self.surface.point_at(u, v).is_err() => return Err(error),
                    Err(error) => {
                        return match self.is_crease_through(cell, [i, j]) {
                            true => Ok(None),
                            false => Err(error),
                        };
                    }
                }
            }
        }
        Ok(corners.try_into().ok())
    }

    /// Makes a line through a corner without derivatives a crease, if there are some beside it.
    fn is_crease_through(&mut self, cell: LineCell, [i, j]: [usize; 2]) -> bool {
        let (u, v) = (cell.u[i], cell.v[j]);
        let inside = |lines: &ParameterLines, t: f64, k: usize| {
            t + if k == 0 { lines.step(t) } else { -lines.step(t) }
        };
        let beside = [inside(&self.lines[0], u, i), inside(&self.lines[1], v, j)];
        let places = [(0, u, (beside[0], cell.places_v[j])), (1, v, (cell.places_u[i], beside[1]))];
        for (direction, t, (place_u, place_v)) in places {
            if !self.lines[direction].is_crease(t)
                && node_at(self.surface, place_u, place_v).is_ok()
            {
                self.lines[direction].creases.push(t);
                return true;
            }
        }
        false
    }

    fn node(&mut self, u: f64, v: f64) -> Result<MixedDerivatives, GeomError> {
        let key = [u, v].map(f64::to_bits);
        if let Some(node) = self.nodes.get(&key) {
            return Ok(node.clone());
        }
        let mut node = node_at(self.surface, u, v)?;
        self.calm(Direction::U, u, &mut node);
        self.calm(Direction::V, v, &mut node);
        self.nodes.insert(key, node.clone());
        Ok(node)
    }

    /// Takes derivatives without a bound away from a node beside an end of the domain where there
    /// are none.
    fn calm(&self, direction: Direction, t: f64, node: &mut MixedDerivatives) {
        let lines = &self.lines[direction];
        let step = lines.step(t);
        let is_beside = |end: f64| lines.is_crease(end) && (t - end).abs() <= 2.0 * step;
        if ![lines.domain.start(), lines.domain.end()].into_iter().any(is_beside) {
            return;
        }
        let order = |k: usize| match direction {
            Direction::U => node.get(k, 0),
            Direction::V => node.get(0, k),
        };
        if norm(order(2)) * step <= UNBOUNDED_RELATIVE * norm(order(1)) {
            return;
        }
        *node = Grid::from_fn(ORDER + 1, ORDER + 1, |k, l| {
            if [k, l][direction] == 0 { node.get(k, l) } else { DVec3::ZERO }
        });
    }

    /// Whether a cell needs more lines of constant u, and of constant v.
    fn needs(
        &self,
        cell: LineCell,
        corners: &[MixedDerivatives; 4],
    ) -> Result<[bool; 2], GeomError> {
        let net = net(cell, corners);
        let places = |i: usize| (i as f64 + 0.5) / N_PLACES as f64;
        let apart = |a: f64, b: f64| -> Result<f64, GeomError> {
            let (u, v) = (between(cell.places_u, a), between(cell.places_v, b));
            Ok(norm(self.surface.point_at(u, v)? - point_of(&net, a, b)))
        };
        let is_beyond = |distance: f64, allowed: f64| distance.is_nan() || allowed < distance;
        let mut is_far = false;
        'places: for i in 0..N_PLACES {
            for j in 0..N_PLACES {
                if is_beyond(apart(places(i), places(j))?, SAFETY * self.tolerance) {
                    is_far = true;
                    break 'places;
                }
            }
        }
        if !is_far {
            return Ok([false; 2]);
        }
        let mut needs = [false; 2];
        for i in 0..N_PLACES {
            for side in [0.0, 1.0] {
                let allowed = EDGE_SHARE * self.tolerance;
                needs[0] |= is_beyond(apart(places(i), side)?, allowed);
                needs[1] |= is_beyond(apart(side, places(i))?, allowed);
            }
        }
        // What shows on no edge is a twist.
        Ok(if needs == [false; 2] { [true; 2] } else { needs })
    }

    /// Makes the line across a narrow cell a crease at which derivatives jump.
    fn finds_crease(&mut self, direction: Direction, cell: LineCell) -> Result<bool, GeomError> {
        let lines = &self.lines[direction];
        let (ends, places) = match direction {
            Direction::U => (cell.u, cell.places_u),
            Direction::V => (cell.v, cell.places_v),
        };
        let width = ends[1] - ends[0];
        if SUSPICIOUS_CELL_RELATIVE * lines.domain.length() < width {
            return Ok(false);
        }
        if width <= 2.0 * KNOT_RELATIVE * lines.domain.length() || CREASES <= lines.creases.len() {
            return Err(self.not_near(cell.u[0], cell.v[0]));
        }
        let ([mut low, mut high], resolution) = (places, lines.step(ends[0]));
        for n_halvings in 0..CREASE_HALVINGS {
            let middle = 0.5 * (low + high);
            if high - low <= resolution {
                break;
            }
            let part = |from: f64, to: f64| match direction {
                Direction::U => LineCell { u: [from, to], places_u: [from, to], ..cell },
                Direction::V => LineCell { v: [from, to], places_v: [from, to], ..cell },
            };
            if self.is_rough(part(low, middle), direction) {
                high = middle;
            } else if self.is_rough(part(middle, high), direction) {
                low = middle;
            } else if n_halvings < SMOOTH_HALVINGS {
                return Ok(false);
            } else if self.jump(cell, direction, [low, middle], width)
                < self.jump(cell, direction, [middle, high], width)
            {
                low = middle;
            } else {
                high = middle;
            }
        }
        let at = high;
        let near = 2.0 * KNOT_RELATIVE * self.lines[direction].domain.length();
        let is_inside = near < at - ends[0] && near < ends[1] - at;
        let at = match (is_inside, at - ends[0] < ends[1] - at) {
            (true, _) => at,
            (false, true) => ends[0],
            (false, false) => ends[1],
        };
        let lines = &mut self.lines[direction];
        if lines.is_crease(at) {
            return Ok(false);
        }
        lines.creases.push(at);
        lines.add(&[at]);
        Ok(true)
    }

    /// The largest difference of derivatives in a direction, as lengths over a width; without
    /// derivatives it has no bound.
    fn jump(&self, cell: LineCell, direction: Direction, places: [f64; 2], width: f64) -> f64 {
        let at = |t: f64| match direction {
            Direction::U => node_at(self.surface, t, cell.places_v[0]),
            Direction::V => node_at(self.surface, cell.places_u[0], t),
        };
        let [Ok(a), Ok(b)] = places.map(at) else { return f64::INFINITY };
        let order = |node: &MixedDerivatives, k: usize| match direction {
            Direction::U => node.get(k, 0),
            Direction::V => node.get(0, k),
        };
        let difference = |k: usize| norm(order(&a, k) - order(&b, k));
        (difference(1) * width).max(difference(2) * 0.5 * width * width)
    }

    /// Whether a cell needs lines in a direction; where it cannot be told it does.
    fn is_rough(&self, cell: LineCell, direction: Direction) -> bool {
        let corner = |u: f64, v: f64| node_at(self.surface, u, v);
        let corners = || -> Result<[MixedDerivatives; 4], GeomError> {
            let ([a, b], [c, d]) = (cell.places_u, cell.places_v);
            Ok([corner(a, c)?, corner(a, d)?, corner(b, c)?, corner(b, d)?])
        };
        corners().and_then(|corners| self.needs(cell, &corners)).map_or(true, |n| n[direction])
    }

    fn spline(&mut self) -> Result<NurbsSurface, GeomError> {
        let ((knots_u, rows), (knots_v, columns)) = (self.lines[0].rows()?, self.lines[1].rows()?);
        self.check_jumps()?;
        let mut points = Vec::with_capacity(rows.len() * columns.len());
        for row in &rows {
            for column in &columns {
                let node = self.node(row.place, column.place)?;
                points.push(combined(&node, &row.weights, &column.weights));
            }
        }
        let points = Grid::new(rows.len(), columns.len(), points)?;
        NurbsSurface::polynomial(knots_u, knots_v, &points)
    }

    /// # Errors
    /// [`JumpError::FunctionAt`] where the two sides of a crease are apart.
    fn check_jumps(&self) -> Result<(), GeomError> {
        for (direction, lines) in Direction::BOTH.into_iter().zip(&self.lines) {
            let is_inner = |t: &&f64| lines.domain.start() < **t && **t < lines.domain.end();
            for &crease in lines.creases.iter().filter(is_inner) {
                for &other in &self.lines[direction.other()].parameters {
                    let at = |t: f64| match direction {
                        Direction::U => self.surface.point_at(t, other),
                        Direction::V => self.surface.point_at(other, t),
                    };
                    let step = lines.step(crease);
                    let gap = norm(at(crease - step)? - at(crease + step)?);
                    if self.tolerance < gap {
                        let [u, v] = direction.pair(crease, other);
                        return Err(JumpError::FunctionAt { u, v, gap }.into());
                    }
                }
            }
        }
        Ok(())
    }

    fn not_near(&self, u: f64, v: f64) -> GeomError {
        GeomError::Fit(FitError::NoSplineNearAt { tolerance: self.tolerance, u, v })
    }
}

fn node_at(surface: &ParametricSurface, u: f64, v: f64) -> Result<MixedDerivatives, GeomError> {
    let all = surface.derivatives_at(u, v, 2 * ORDER)?;
    Ok(Grid::from_fn(ORDER + 1, ORDER + 1, |k, l| all.get(k, l)))
}
