//! Knot vectors made of others. None of these can break an invariant.

use super::KnotVector;
use crate::{GeomError, Interval, tolerance::KNOT_RELATIVE};

impl KnotVector {
    /// The knot nearest to `t` if it is closer than [`KNOT_RELATIVE`] of the domain, else `t`.
    pub(crate) fn snapped(&self, t: f64) -> f64 {
        let same = KNOT_RELATIVE * self.domain().length();
        let next = self.knots.partition_point(|&knot| knot < t);
        let near = |i: usize| self.knots.get(i).copied().filter(|knot| (knot - t).abs() <= same);
        near(next).or_else(|| near(next.wrapping_sub(1))).unwrap_or(t)
    }

    /// More knots, which lie between those there are.
    pub(crate) fn with(&self, more: &[f64]) -> Self {
        let mut knots = [self.as_slice(), more].concat();
        knots.sort_by(f64::total_cmp);
        Self::new_unchecked(self.degree, knots)
    }

    /// One knot less: the last of those at `t`, which is one of them.
    pub(crate) fn without(&self, t: f64) -> Self {
        let mut knots = self.knots.to_vec();
        knots.remove(knots.partition_point(|&knot| knot <= t) - 1);
        Self::new_unchecked(self.degree, knots)
    }

    /// Every knot replaced by `f(knot)`, which must not decrease.
    pub(crate) fn map(&self, f: impl Fn(f64) -> f64) -> Self {
        Self::new_unchecked(self.degree, self.knots.iter().map(|&knot| f(knot)).collect())
    }

    /// Some of the knots, and others at either end, as a vector of the same degree.
    pub(crate) fn part(&self, parts: [&[f64]; 3]) -> Self {
        Self::new_unchecked(self.degree, parts.concat())
    }

    /// The same knots over another domain.
    pub(crate) fn on(&self, target: Interval) -> Self {
        let domain = self.domain();
        self.map(|t| {
            if t <= domain.start() {
                target.start() - (domain.start() - t) / domain.length() * target.length()
            } else if domain.end() <= t {
                target.end() + (t - domain.end()) / domain.length() * target.length()
            } else {
                target.at(domain.fraction_of(t)).clamp(target.start(), target.end())
            }
        })
    }

    /// The knots of the spline run backwards, on the same domain.
    pub(crate) fn reversed(&self) -> Self {
        let domain = self.domain();
        let mirror = |t: f64| {
            if t <= domain.start() {
                domain.end() + (domain.start() - t)
            } else if domain.end() <= t {
                domain.start() - (t - domain.end())
            } else {
                (domain.start() + (domain.end() - t)).clamp(domain.start(), domain.end())
            }
        };
        let knots = self.knots.iter().rev().map(|&t| mirror(t)).collect();
        Self::new_unchecked(self.degree, knots)
    }

    /// The opposite numbers in order: exactly its own inverse.
    pub(crate) fn mirrored(&self) -> Self {
        Self::new_unchecked(self.degree, self.knots.iter().rev().map(|&t| -t).collect())
    }

    /// Knots for nearby splines of one degree less: of clamped ones every knot once less, but no
    /// inner knot gone.
    pub(crate) fn degree_lowered(&self) -> Self {
        let domain = self.domain();
        let is_inner = |t: f64| domain.start() < t && t < domain.end();
        let less = |(t, times): (f64, usize)| vec![t; (times - 1).max(usize::from(is_inner(t)))];
        let knots = self.distinct().into_iter().flat_map(less).collect();
        Self::new_unchecked(self.degree - 1, knots)
    }

    /// Knots for the same splines at one degree more: every knot once more, the domain kept.
    ///
    /// # Errors
    /// `DegreeError::DegreeTooHigh`.
    pub(crate) fn elevated(&self) -> Result<Self, GeomError> {
        let degree = self.degree + 1;
        super::check_degree(degree)?;
        let domain = self.domain();
        let more = |(knot, times): (f64, usize)| vec![knot; times + 1];
        let knots: Vec<f64> = self.distinct().into_iter().flat_map(more).collect();

        // Beyond the domain only as many as the degree needs.
        let first = knots.partition_point(|&knot| knot <= domain.start()) - 1 - degree;
        let last = knots.partition_point(|&knot| knot < domain.end()) + degree;
        Ok(Self::new_unchecked(degree, knots[first..=last].to_vec()))
    }
}
