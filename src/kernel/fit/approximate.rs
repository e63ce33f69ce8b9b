//! Curves near points: of so many control points, or of as few as keep a tolerance.

use glam::DVec3;

use super::{Ends, Interpolator, least::Approximator, spread};
use crate::{
    kernel::{GeomError, KnotVector, NurbsCurve, tolerance::PARAMETER_RELATIVE},
    limits::Limits,
};

/// How often the parameters of one trial are corrected.
const MAX_CORRECTIONS: usize = 12;

/// Each round halves the data of every span that misses, so that this many split any number.
const MAX_ROUNDS: usize = 64;

/// A correction that gains less than this share of the deviation is the last.
const LEAST_GAIN: f64 = 0.01;

/// Control points up to which every number is tried; above, halving finds a good one.
const FEW: usize = 64;

/// The curve of `n_control` control points that comes nearest to the points at the parameters,
/// through the first and the last.
///
/// Least squares over knots that spread the parameters evenly: Piegl & Tiller, *The NURBS Book*,
/// §9.4.1, (9.68) and (9.69).
///
/// # Errors
/// [`GeomError::BadDegree`], [`GeomError::DegreeTooHigh`]; [`GeomError::WrongCount`];
/// [`GeomError::Undetermined`] where many points share few parameters.
pub fn approximate(
    points: &[DVec3],
    parameters: &[f64],
    degree: usize,
    n_control: usize,
) -> Result<NurbsCurve, GeomError> {
    let knots = KnotVector::spreading(degree, n_control, parameters)?;
    Approximator::new(parameters, knots)?.curve(points)
}

/// A curve with every point within the tolerance, through the first and the last, with as few
/// control points as are found.
///
/// Knots are added where points are missed, then spread by what the curve found so needs, then
/// taken away one by one; after each fit the parameters move to the nearest places of the curve
/// unless they are fixed. Hoschek & Lasser, *Fundamentals of Computer Aided Geometric Design*,
/// §4.4 (parameter correction); de Boor, *A Practical Guide to Splines*, §XII (spreading).
///
/// # Errors
/// [`GeomError::BadDegree`], [`GeomError::DegreeTooHigh`]; [`GeomError::WrongCount`];
/// [`GeomError::ToleranceNotKept`] below the rounding of the coordinates.
pub fn approximate_within(
    points: &[DVec3],
    parameters: &[f64],
    degree: usize,
    tolerance: f64,
    are_fixed: bool,
) -> Result<NurbsCurve, GeomError> {
    let domain = [parameters[0], parameters[parameters.len() - 1]];
    let ends = domain.map(|t| vec![t; degree + 1]);
    let coarsest = KnotVector::for_points(degree, degree + 1, ends.concat())?;
    if points.len() <= degree {
        let needed = degree + 1;
        return Err(GeomError::BadDegree { degree, points: points.len(), needed });
    }
    let mut search =
        Search { points, degree, tolerance, are_fixed, left: Limits::DEFAULT.fit_steps };
    let Some(first) = search.grown(coarsest, parameters) else {
        return search.interpolated(parameters);
    };
    let spread = search.respread(first);
    Ok(search.thinned(spread).curve)
}

/// The search for a curve within the tolerance.
struct Search<'a> {
    points: &'a [DVec3],
    degree: usize,
    tolerance: f64,
    are_fixed: bool,
    /// Points that may still be looked at to save control points.
    left: usize,
}

/// A curve fitted to the points.
#[derive(Clone)]
struct Trial {
    curve: NurbsCurve,
    parameters: Vec<f64>,
    /// Distances of the points from the curve at their parameters.
    misses: Vec<f64>,
    worst: f64,
}

impl Trial {
    fn n_control(&self) -> usize {
        self.curve.control_points().len()
    }
}

impl Search<'_> {
    fn keeps(&self, trial: &Trial) -> bool {
        trial.worst <= self.tolerance
    }

    /// The nearest curve over the knots, with its parameters corrected while that helps.
    fn trial(&mut self, knots: &KnotVector, parameters: &[f64]) -> Option<Trial> {
        let mut best = self.fitted(knots, parameters.to_vec())?;
        for _ in 0..MAX_CORRECTIONS {
            if self.are_fixed || self.keeps(&best) {
                break;
            }
            let Some(next) = self.fitted(knots, self.corrected(&best)) else { break };
            let gain = best.worst - next.worst;
            let is_last = gain < LEAST_GAIN * best.worst;
            if 0.0 < gain {
                best = next;
            }
            if is_last {
                break;
            }
        }
        Some(best)
    }

    fn fitted(&mut self, knots: &KnotVector, parameters: Vec<f64>) -> Option<Trial> {
        self.left = self.left.saturating_sub(self.points.len());
        let fit = Approximator::new(&parameters, knots.clone()).ok()?;
        let curve = fit.curve(self.points).ok()?;
        Some(self.measured(curve, parameters))
    }

    fn measured(&self, curve: NurbsCurve, parameters: Vec<f64>) -> Trial {
        let pairs = self.points.iter().zip(&parameters);
        let misses: Vec<f64> = pairs.map(|(p, &t)| curve.point_at(t).distance(*p)).collect();
        let worst = misses.iter().fold(0.0_f64, |worst, &miss| worst.max(miss));
        Trial { curve, parameters, misses, worst }
    }

    /// One step of each inner parameter towards the nearest place of the curve, in order.
    fn corrected(&self, trial: &Trial) -> Vec<f64> {
        let mut parameters = trial.parameters.clone();
        for i in 1..parameters.len() - 1 {
            let (t, point) = (parameters[i], self.points[i]);
            let derivatives = trial.curve.derivatives_at(t, 2);
            let [value, first, second] = derivatives[..] else { continue };
            let miss = value - point;
            let speed = first.length_squared();
            let bent = speed + miss.dot(second);
            let slope = if 0.0 < bent { bent } else { speed };
            if 0.0 < slope {
                let next = t - miss.dot(first) / slope;
                let next = next.max(parameters[i - 1]).min(parameters[i + 1]);
                if trial.curve.point_at(next).distance(point) < trial.misses[i] {
                    parameters[i] = next;
                }
            }
        }
        parameters
    }

    /// Adds knots where points are missed until none is; `None` where only a curve through all
    /// points would do.
    fn grown(&mut self, coarsest: KnotVector, parameters: &[f64]) -> Option<Trial> {
        let mut knots = coarsest;
        let mut start = parameters.to_vec();
        for _ in 0..MAX_ROUNDS {
            let trial = match self.trial(&knots, &start) {
                Some(trial) => trial,
                None => self.trial(&knots, parameters)?,
            };
            if self.keeps(&trial) {
                return Some(trial);
            }
            let more = spread::splits(&knots, &trial.parameters, &trial.misses, self.tolerance);
            if more.is_empty() || self.points.len() < knots.n_points() + more.len() {
                return None;
            }
            knots = knots.with(&more);
            start = trial.parameters;
        }
        None
    }

    /// The curve through all points, which no tolerance above rounding can refuse.
    fn interpolated(&self, parameters: &[f64]) -> Result<NurbsCurve, GeomError> {
        // Neighbours at one place are passed together.
        let same = PARAMETER_RELATIVE * (parameters[parameters.len() - 1] - parameters[0]);
        let mut apart: (Vec<f64>, Vec<DVec3>) = (Vec::new(), Vec::new());
        for (&t, &point) in parameters.iter().zip(self.points) {
            if apart.0.last().is_none_or(|&before| same < t - before) {
                apart.0.push(t);
                apart.1.push(point);
            }
        }
        let all = Interpolator::new(&apart.0, self.degree, Ends::Averaged)?;
        let trial = self.measured(all.curve(&apart.1)?, parameters.to_vec());
        if self.keeps(&trial) {
            return Ok(trial.curve);
        }
        Err(GeomError::ToleranceNotKept { tolerance: self.tolerance, found: trial.worst })
    }

    /// Fewer control points, with the knots where the curve needs them.
    fn respread(&mut self, first: Trial) -> Trial {
        let mut best = first;
        let (mut low, mut high) = (self.degree + 1, best.n_control());
        while low < high && 0 < self.left {
            let n = if high <= FEW { low } else { low.midpoint(high) };
            let knots = spread::by_need(&best.curve, n);
            let start = best.parameters.clone();
            match self.trial(&knots, &start).filter(|trial| self.keeps(trial)) {
                Some(trial) => (best, high) = (trial, n),
                None => low = n + 1,
            }
        }
        best
    }

    /// Takes knots away one by one, the least needed first.
    fn thinned(&mut self, first: Trial) -> Trial {
        let mut best = first;
        loop {
            let breaks = best.curve.knots().breaks();
            let mut without: Option<Trial> = None;
            for &t in &breaks[1..breaks.len() - 1] {
                if self.left == 0 {
                    return best;
                }
                let knots = best.curve.knots().without(t);
                let start = best.parameters.clone();
                let found = self.trial(&knots, &start).filter(|trial| self.keeps(trial));
                let is_better =
                    |found: &Trial| without.as_ref().is_none_or(|w| found.worst < w.worst);
                if let Some(found) = found.filter(is_better) {
                    without = Some(found);
                }
            }
            match without {
                Some(trial) => best = trial,
                None => return best,
            }
        }
    }
}
