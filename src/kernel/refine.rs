//! The same spline on more knots, and at a higher degree.
//!
//! Works on lines of homogeneous points, so that a curve is one line and a surface as many as it
//! has rows or columns.

use glam::DVec4;

use super::{GeomError, KnotVector, bezier};

/// Lines of control points over one knot vector.
#[derive(Clone, Debug)]
pub(in crate::kernel) struct Lines {
    pub(in crate::kernel) knots: KnotVector,
    pub(in crate::kernel) lines: Vec<Vec<DVec4>>,
}

impl Lines {
    /// The same splines with more knots; each of the new ones counts once.
    ///
    /// Boehm's insertion, one knot after another; every new point is a convex combination of two.
    /// Piegl & Tiller, *The NURBS Book*, (5.15).
    ///
    /// # Errors
    /// [`GeomError::ParameterOutside`] the domain; [`GeomError::KnotMultiplicity`] above p + 1.
    pub(in crate::kernel) fn with_knots(mut self, new: &[f64]) -> Result<Self, GeomError> {
        for &t in new {
            let t = self.knots.snapped(self.knots.domain().clamp_inside(t)?);
            self.insert(t)?;
        }
        Ok(self)
    }

    /// One knot more, which is in the domain.
    ///
    /// # Errors
    /// [`GeomError::KnotMultiplicity`] above p + 1.
    pub(in crate::kernel) fn insert(&mut self, t: f64) -> Result<(), GeomError> {
        let degree = self.knots.degree();
        let knots = self.knots.as_slice();
        let next = knots.partition_point(|&knot| knot <= t);
        let times = next - knots.partition_point(|&knot| knot < t);
        if degree < times {
            let (index, most) = (next - times, degree + 1);
            return Err(GeomError::KnotMultiplicity { index, knot: t, times: times + 1, most });
        }
        // Points from `first` to `last` are replaced by one more.
        let (first, last) = (next - 1 - degree, next - 1 - times);
        for line in &mut self.lines {
            line.insert(last, line[last]);
            for i in (first + 1..=last).rev() {
                let fraction = (t - knots[i]) / (knots[i + degree] - knots[i]);
                line[i] = bezier::blend(line[i - 1], line[i], fraction);
            }
        }
        self.knots = self.knots.with_knot(t);
        Ok(())
    }

    /// The same splines at a higher degree, by one at a time.
    ///
    /// # Errors
    /// [`GeomError::DegreeTooLow`] below the degree there is, [`GeomError::DegreeTooHigh`].
    pub(in crate::kernel) fn elevated(mut self, degree: usize) -> Result<Self, GeomError> {
        let from = self.knots.degree();
        if degree < from {
            return Err(GeomError::DegreeTooLow { from, to: degree });
        }
        for _ in from..degree {
            let knots = self.knots.elevated()?;
            let lines = self.lines.iter().map(|line| elevate_line(&self.knots, &knots, line));
            self = Self { lines: lines.collect(), knots };
        }
        Ok(self)
    }
}

/// Control points of a spline on knots of one degree more.
///
/// Point i is the blossom of the raised polynomial at the knots i + 1 … i + p + 1, which is the
/// mean of the old blossom over all ways to leave out one of them.
/// Ramshaw, *Blossoms are polar forms*, §6.
fn elevate_line(old: &KnotVector, new: &KnotVector, line: &[DVec4]) -> Vec<DVec4> {
    let degree = new.degree();
    let spans: Vec<usize> = new.spans().collect();
    let blossom = |i: usize| {
        // Any span in the support has the same blossom; the middle one rounds least.
        let nearest = |&&span: &&usize| (2 * span).abs_diff(2 * i + degree);
        let Some(&span) = spans.iter().min_by_key(nearest) else { return DVec4::ZERO };
        let middle = new.span_interval(span).at(0.5);
        let mut arguments = new.as_slice()[i + 1..=i + degree].to_vec();
        // Far arguments first, where the corners that are cut lie far apart too.
        arguments.sort_by(|a, b| (b - middle).abs().total_cmp(&(a - middle).abs()));
        let mut sum = DVec4::ZERO;
        for left_out in 0..degree {
            let mut rest = arguments.clone();
            rest.remove(left_out);
            sum += bezier::blossom(old, line, old.span_at(middle), &rest);
        }
        sum / degree as f64
    };
    (0..new.n_points()).map(blossom).collect()
}
