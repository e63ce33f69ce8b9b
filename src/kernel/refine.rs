//! The same spline on more knots, in parts, and at a higher degree.
//!
//! Works on lines of homogeneous points, so that a curve is one line and a surface as many as it
//! has rows or columns. Every new point is a convex combination of old ones, at any degree.

use glam::DVec4;

use super::{DegreeError, GeomError, KnotError, KnotVector, bezier, tolerance::KNOT_RELATIVE};

/// Lines of control points over one knot vector.
#[derive(Clone, Debug)]
pub(crate) struct ControlLines {
    pub(crate) knots: KnotVector,
    pub(crate) lines: Vec<Vec<DVec4>>,
}

impl ControlLines {
    /// The same splines with more knots; each of the new ones counts once. Knots within
    /// [`KNOT_RELATIVE`] of the domain of one another are one knot.
    ///
    /// Boehm's insertion from the last knot to the first, so that what lies behind is final: O(p)
    /// a knot. Piegl & Tiller, *The NURBS Book*, A5.4.
    ///
    /// # Errors
    /// `DomainError::ParameterOutside` the domain; [`KnotError::KnotMultiplicity`] above p + 1.
    pub(crate) fn with_knots(self, new: &[f64]) -> Result<Self, GeomError> {
        let new = self.one_of_each_cluster(new)?;
        let degree = self.knots.degree();
        let mut knots = self.knots.as_slice().to_vec();
        let mut lines = self.lines;
        let mut final_knots: Vec<f64> = Vec::new();
        let mut final_points: Vec<Vec<DVec4>> = vec![Vec::new(); lines.len()];
        for &t in new.iter().rev() {
            let next = knots.partition_point(|&knot| knot <= t);
            let times = next - knots.partition_point(|&knot| knot < t);
            // Points from `first` to `last` are replaced by one more.
            let (first, last) = (next - 1 - degree, next - 1 - times);
            final_knots.extend(knots.drain(knots.len().min(next + degree)..).rev());
            let fraction = |i: usize| (t - knots[i]) / (knots[i + degree] - knots[i]);
            let fractions: Vec<f64> = (first + 1..=last).map(fraction).collect();
            for (line, done) in lines.iter_mut().zip(&mut final_points) {
                done.extend(line.drain(last + 1..).rev());
                line.push(line[last]);
                for (j, &fraction) in fractions.iter().enumerate().rev() {
                    let i = first + 1 + j;
                    line[i] = bezier::blend(line[i - 1], line[i], fraction);
                }
            }
            knots.insert(next, t);
        }
        knots.extend(final_knots.iter().rev());
        for (line, done) in lines.iter_mut().zip(&final_points) {
            line.extend(done.iter().rev());
        }
        Ok(Self { knots: self.knots.part([&knots, &[], &[]]), lines })
    }

    /// New knots in order, those within rounding of another one equal to it.
    ///
    /// # Errors
    /// Those of [`Self::with_knots`].
    fn one_of_each_cluster(&self, new: &[f64]) -> Result<Vec<f64>, GeomError> {
        let domain = self.knots.domain();
        let snapped = |&t: &f64| Ok(self.knots.snapped(domain.clamp_inside(t)?));
        let mut new: Vec<f64> = new.iter().map(snapped).collect::<Result<_, GeomError>>()?;
        new.sort_by(f64::total_cmp);
        let same = KNOT_RELATIVE * domain.length();
        let is_old = |t: f64| 0 < self.knots.exact_multiplicity(t);
        for i in 1..new.len() {
            if new[i] - new[i - 1] <= same && !is_old(new[i]) {
                new[i] = new[i - 1];
            }
        }
        let most = self.knots.degree() + 1;
        for run in new.chunk_by(|a, b| a.total_cmp(b).is_eq()) {
            let (knot, times) = (run[0], self.knots.exact_multiplicity(run[0]) + run.len());
            if most < times {
                let index = self.knots.as_slice().partition_point(|&other| other < knot);
                return Err(KnotError::KnotMultiplicity { index, knot, times, most }.into());
            }
        }
        Ok(new)
    }

    /// What is left and right of a parameter of the domain, clamped there; at an end one of them
    /// is of no use.
    pub(crate) fn cut_at(&self, t: f64) -> (Self, Self) {
        let degree = self.knots.degree();
        let missing = vec![t; degree.saturating_sub(self.knots.exact_multiplicity(t))];
        let Ok(lines) = self.clone().with_knots(&missing) else {
            unreachable!("a knot that stands less than p times can stand once more")
        };
        let knots = lines.knots.as_slice();
        let next = knots.partition_point(|&knot| knot <= t);
        // A knot that stands p + 1 times is a break, with a point on each side of it.
        let n_missing = (degree + 1).saturating_sub(lines.knots.exact_multiplicity(t));
        let own = vec![t; n_missing];
        let left = lines.knots.part([&knots[..next], &own, &[]]);
        let right = lines.knots.part([&own, &knots[next + n_missing - degree - 1..], &[]]);
        let (n_left, n_right) = (left.n_points(), right.n_points());
        let first = |line: &Vec<DVec4>| line[..n_left].to_vec();
        let last = |line: &Vec<DVec4>| line[line.len() - n_right..].to_vec();
        (
            Self { knots: left, lines: lines.lines.iter().map(first).collect() },
            Self { knots: right, lines: lines.lines.iter().map(last).collect() },
        )
    }

    /// The same splines with knots that stand p + 1 times at both ends.
    pub(crate) fn clamped(&self) -> Self {
        let domain = self.knots.domain();
        self.cut_at(domain.start()).1.cut_at(domain.end()).0
    }

    /// The same splines at a higher degree, clamped unless it is the one they have.
    ///
    /// # Errors
    /// [`DegreeError::DegreeTooLow`] below the degree there is, [`DegreeError::DegreeTooHigh`].
    pub(crate) fn elevated(self, degree: usize) -> Result<Self, GeomError> {
        let from = self.knots.degree();
        if degree < from {
            return Err(DegreeError::DegreeTooLow { from, to: degree }.into());
        }
        if degree == from {
            return Ok(self);
        }
        // Refuse a degree above the ceiling by its own name.
        KnotVector::bezier(degree)?;
        let mut lines = self.clamped();
        for _ in from..degree {
            lines = lines.elevated_once()?;
        }
        Ok(lines)
    }

    /// [`Self::elevated`] by one, of clamped splines.
    fn elevated_once(&self) -> Result<Self, GeomError> {
        let knots = self.knots.elevated()?;
        let mut elevated = Self { knots, lines: vec![Vec::new(); self.lines.len()] };
        for piece in self.unbroken_pieces() {
            for (line, points) in elevated.lines.iter_mut().zip(piece.elevated_points()?) {
                line.extend(points);
            }
        }
        Ok(elevated)
    }

    /// The parts between knots that stand p + 1 times.
    fn unbroken_pieces(&self) -> Vec<Self> {
        let degree = self.knots.degree();
        let mut rest = self.clone();
        let mut pieces = Vec::new();
        for (t, times) in self.knots.distinct() {
            let domain = rest.knots.domain();
            if degree < times && domain.start() < t && t < domain.end() {
                let (left, right) = rest.cut_at(t);
                pieces.push(left);
                rest = right;
            }
        }
        pieces.push(rest);
        pieces
    }

    /// Control points at one degree more, of clamped splines without breaks.
    ///
    /// The blossom of the raised polynomial at p + 1 arguments is the mean of the old blossom over
    /// all ways to leave out one of them. With every (p + 1)-th of the new knots left out, the
    /// others refine the old ones, and the old blossom at p neighbours among them is a control
    /// point of the refined spline: all is convex.
    /// Prautzsch, *Degree elevation of B-spline curves*, CAGD 1 (1984).
    fn elevated_points(&self) -> Result<Vec<Vec<DVec4>>, GeomError> {
        let knots = self.knots.elevated()?;
        let (degree, n_points) = (knots.degree(), knots.n_points());
        let domain = knots.domain();
        let mut sums = vec![vec![DVec4::ZERO; n_points]; self.lines.len()];
        for left_out in 0..degree {
            // A knot of which no copy is left out stands once more than among the old ones.
            let mut missing = Vec::new();
            let mut index = 0;
            for (t, times) in knots.distinct() {
                let first_left_out = index + (left_out + degree - index % degree) % degree;
                index += times;
                if domain.start() < t && t < domain.end() && index <= first_left_out {
                    missing.push(t);
                }
            }
            let refined = self.clone().with_knots(&missing)?;
            for (sum, line) in sums.iter_mut().zip(&refined.lines) {
                let mut n_before = 0;
                for (i, sum) in sum.iter_mut().enumerate() {
                    n_before += usize::from(0 < i && i % degree != left_out);
                    *sum += line[n_before];
                }
            }
        }
        let mean = |sums: Vec<DVec4>| sums.into_iter().map(|sum| sum / degree as f64).collect();
        Ok(sums.into_iter().map(mean).collect())
    }
}
