//! A surface near a grid of points, of as few control points as are found to keep a tolerance.

use glam::DVec3;

use super::{Approximator, Ends, FirstPass, Interpolator, LineFit, spread};
use crate::{
    kernel::{GeomError, Grid, KnotVector, NurbsSurface},
    limits::Limits,
};

/// Each round halves the data of every span that misses, so that this many split any number.
const MAX_ROUNDS: usize = 64;

/// A surface with every point within the tolerance at its parameters, through the corners.
///
/// Knots are added where rows or columns are missed, then taken away one by one, the first that
/// is not needed first.
///
/// # Errors
/// [`GeomError::BadDegree`], [`GeomError::DegreeTooHigh`]; [`GeomError::WrongCount`];
/// [`GeomError::ToleranceNotKept`] below the rounding of the coordinates.
pub fn approximate_grid_within(
    points: &Grid<DVec3>,
    parameters: [&[f64]; 2],
    degrees: [usize; 2],
    tolerance: f64,
) -> Result<NurbsSurface, GeomError> {
    let coarsest = |k: usize| KnotVector::spreading(degrees[k], degrees[k] + 1, parameters[k]);
    let mut search = Search { points, parameters, tolerance, left: Limits::DEFAULT.fit_steps };
    match search.grown([coarsest(0)?, coarsest(1)?]) {
        Some(surface) => Ok(search.thinned(surface)),
        None => search.interpolated(degrees),
    }
}

struct Search<'a> {
    points: &'a Grid<DVec3>,
    parameters: [&'a [f64]; 2],
    tolerance: f64,
    /// Points that may still be looked at to save control points.
    left: usize,
}

impl Search<'_> {
    fn fitted(&mut self, knots: [&KnotVector; 2]) -> Option<NurbsSurface> {
        self.left = self.left.saturating_sub(self.points.as_slice().len());
        let near = |k: usize| {
            Approximator::new(self.parameters[k], knots[k].clone()).ok().map(LineFit::Near)
        };
        FirstPass::new(self.points, &near(0)?).ok()?.second(&near(1)?).ok()
    }

    /// The largest miss in each row and in each column.
    fn misses(&self, surface: &NurbsSurface) -> [Vec<f64>; 2] {
        let [us, vs] = self.parameters;
        let mut worst = [vec![0.0_f64; us.len()], vec![0.0_f64; vs.len()]];
        for (i, &u) in us.iter().enumerate() {
            for (j, &v) in vs.iter().enumerate() {
                let miss = surface.point_at(u, v).distance(self.points.get(i, j));
                worst[0][i] = worst[0][i].max(miss);
                worst[1][j] = worst[1][j].max(miss);
            }
        }
        worst
    }

    fn worst(&self, surface: &NurbsSurface) -> f64 {
        self.misses(surface)[0].iter().fold(0.0, |worst, &miss| worst.max(miss))
    }

    /// Adds knots where points are missed until none is.
    fn grown(&mut self, coarsest: [KnotVector; 2]) -> Option<NurbsSurface> {
        let mut knots = coarsest;
        for _ in 0..MAX_ROUNDS {
            let surface = self.fitted([&knots[0], &knots[1]])?;
            let misses = self.misses(&surface);
            if misses[0].iter().all(|&miss| miss <= self.tolerance) {
                return Some(surface);
            }
            let mut n_more = 0;
            for k in 0..2 {
                let most = self.parameters[k].len() - knots[k].n_points();
                let mut more =
                    spread::splits(&knots[k], self.parameters[k], &misses[k], self.tolerance);
                more.truncate(most);
                n_more += more.len();
                knots[k] = knots[k].with(&more);
            }
            if n_more == 0 {
                return None;
            }
        }
        None
    }

    /// The surface through all points, which no tolerance above rounding can refuse.
    fn interpolated(&self, degrees: [usize; 2]) -> Result<NurbsSurface, GeomError> {
        let through = |k: usize| {
            Interpolator::new(self.parameters[k], degrees[k], Ends::Averaged).map(LineFit::Through)
        };
        let surface = FirstPass::new(self.points, &through(0)?)?.second(&through(1)?)?;
        let found = self.worst(&surface);
        if found <= self.tolerance {
            return Ok(surface);
        }
        Err(GeomError::ToleranceNotKept { tolerance: self.tolerance, found })
    }

    /// Takes away every knot without which the tolerance is kept.
    fn thinned(&mut self, first: NurbsSurface) -> NurbsSurface {
        let mut best = first;
        for along_u in [true, false] {
            let own = if along_u { best.knots_u() } else { best.knots_v() };
            let breaks = own.breaks();
            for &t in &breaks[1..breaks.len() - 1] {
                if self.left == 0 {
                    return best;
                }
                let (u, v) = (best.knots_u().clone(), best.knots_v().clone());
                let (u, v) = if along_u { (u.without(t), v) } else { (u, v.without(t)) };
                let found = self.fitted([&u, &v]);
                if let Some(found) = found.filter(|found| self.worst(found) <= self.tolerance) {
                    best = found;
                }
            }
        }
        best
    }
}
