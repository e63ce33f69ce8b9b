//! Knot vectors and the B-spline functions over them;
//! `change` makes other vectors of one, `fast` has the basis of the usual degrees, `lookup` finds
//! the pieces of many parameters and `expansion` writes them in powers.
//!
//! Conventions of *The NURBS Book*: degree p, all knots u₀ … uₘ, m = n + p + 1 for n + 1 control
//! points, domain [u_p, u_{n+1}], the last span closed on the right.

mod change;
mod checks;
mod class;
mod expansion;
mod fast;
mod faults;
mod lookup;
mod reciprocals;

pub(crate) use checks::check_points;
pub use class::KnotClass;
pub(crate) use expansion::{BasisExpansion, POWER_DEGREE, add_in_powers, convert_to_bezier};
pub(crate) use fast::acting;
use faults::{check_multiplicities, disorder};
pub(crate) use lookup::{BATCH, LocalParameter, SpanLookup};
use reciprocals::Reciprocals;

use std::{ops::RangeInclusive, sync::Arc};

use super::{DegreeError, GeomError, Grid, Interval, KnotError, tolerance::KNOT_RELATIVE};

/// From which side a place is approached, where the two sides can differ.
///
/// The tangent of a polygon jumps at a corner:
///
/// ```
/// use virote_kernel::{NurbsCurve, Side, glam::DVec3};
///
/// let corner = NurbsCurve::polyline(&[DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y])?;
/// let t = corner.domain().at(0.5);
/// assert_eq!(corner.tangent_at(t, Side::Left)?, DVec3::X);
/// assert_eq!(corner.tangent_at(t, Side::Right)?, DVec3::Y);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// From smaller parameters.
    Left,
    /// From larger parameters.
    Right,
}

/// Knots `u₀ ≤ … ≤ uₘ` of a basis of degree p.
///
/// Invariants: finite; knots that differ are further apart than [`KNOT_RELATIVE`] of the domain;
/// none stands more than p + 1 times; the domain is not empty.
///
/// Its functions sum to one everywhere in the domain:
///
/// ```
/// use virote_kernel::KnotVector;
///
/// let knots = KnotVector::new(2, vec![0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0])?;
/// let mut basis = [0.0; 3];
/// knots.basis_at(knots.span_at(0.3), 0.3, &mut basis);
/// assert!((basis.iter().sum::<f64>() - 1.0).abs() < 1e-15);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct KnotVector {
    degree: usize,
    knots: Arc<[f64]>,
    /// What the knots' differences cost to divide by, computed once.
    reciprocals: Reciprocals,
}

impl KnotVector {
    /// The given knots; those closer than [`KNOT_RELATIVE`] of the domain to their predecessor
    /// become equal to it.
    ///
    /// # Errors
    /// [`DegreeError::DegreeTooHigh`], [`KnotError::TooFewKnots`], `InputError::NotFinite`,
    /// [`KnotError::UnsortedKnots`], [`KnotError::DomainTooWide`], [`KnotError::EmptyDomain`],
    /// [`KnotError::KnotMultiplicity`].
    pub fn new(degree: usize, mut knots: Vec<f64>) -> Result<Self, GeomError> {
        check_degree(degree)?;
        let (got, needed) = (knots.len(), 2 * (degree + 1));
        if got < needed {
            return Err(KnotError::TooFewKnots { degree, needed, got }.into());
        }
        // Those in order are finite if the first and the last are.
        let are_in_order = knots.windows(2).all(|pair| pair[0] <= pair[1]);
        if !(are_in_order && knots[0].is_finite() && knots[got - 1].is_finite()) {
            return Err(disorder(&knots));
        }

        let (start, end) = (knots[degree], knots[got - degree - 1]);
        if !(end - start).is_finite() {
            return Err(KnotError::DomainTooWide { start, end }.into());
        }
        // The cause before its consequence: a knot repeated too often can leave no domain.
        check_multiplicities(degree, &knots)?;
        let domain = Interval::new(start, end)
            .map_err(|_| GeomError::Knots(KnotError::EmptyDomain { at: start }))?;
        let same = KNOT_RELATIVE * domain.length();
        let (mut previous, mut is_changed) = (knots[0], false);
        for knot in &mut knots[1..] {
            if *knot - previous <= same {
                is_changed |= knot.to_bits() != previous.to_bits();
                *knot = previous;
            }
            previous = *knot;
        }
        if is_changed {
            check_multiplicities(degree, &knots)?;
        }
        Ok(Self::new_unchecked(degree, knots))
    }

    /// The given knots for a number of control points.
    ///
    /// # Errors
    /// [`DegreeError::BadDegree`] with fewer than p + 1 points, `CountError::TooManyPoints`,
    /// [`KnotError::KnotCount`], and those of [`Self::new`].
    pub fn for_points(degree: usize, n_points: usize, knots: Vec<f64>) -> Result<Self, GeomError> {
        check_points(degree, n_points)?;
        let (got, needed) = (knots.len(), n_points + degree + 1);
        if got != needed {
            return Err(KnotError::KnotCount { points: n_points, degree, needed, got }.into());
        }
        Self::new(degree, knots)
    }

    /// The knots `0 … 0 1 … 1` of a Bézier curve.
    ///
    /// # Errors
    /// [`DegreeError::DegreeTooHigh`].
    pub fn bezier(degree: usize) -> Result<Self, GeomError> {
        check_degree(degree)?;
        Self::uniform_clamped(degree, degree + 1, 1.0)
    }

    /// Evenly spaced knots on `0..end`, the ends p + 1 times.
    ///
    /// # Errors
    /// [`DegreeError::DegreeTooHigh`], [`DegreeError::BadDegree`], `CountError::TooManyPoints`,
    /// [`KnotError::EmptyDomain`].
    pub fn uniform_clamped(degree: usize, n_points: usize, end: f64) -> Result<Self, GeomError> {
        check_points(degree, n_points)?;
        let domain = Interval::new(0.0, end)
            .map_err(|_| GeomError::Knots(KnotError::EmptyDomain { at: 0.0 }))?;
        let n_spans = n_points - degree;
        let mut knots = vec![0.0; degree];
        knots.extend(domain.steps(n_spans));
        knots.extend(vec![end; degree]);
        Ok(Self::new_unchecked(degree, knots))
    }

    /// The whole numbers from −p, not clamped: domain `0..(n_points - p)`, one unit a span.
    ///
    /// # Errors
    /// [`DegreeError::DegreeTooHigh`], [`DegreeError::BadDegree`], `CountError::TooManyPoints`.
    pub fn uniform(degree: usize, n_points: usize) -> Result<Self, GeomError> {
        check_points(degree, n_points)?;
        let knots = (0..=n_points + degree).map(|i| i as f64 - degree as f64).collect();
        Ok(Self::new_unchecked(degree, knots))
    }

    /// Knots that keep the invariants by construction.
    fn new_unchecked(degree: usize, knots: Vec<f64>) -> Self {
        let reciprocals = Reciprocals::new(degree, &knots);
        Self { degree, knots: knots.into(), reciprocals }
    }

    /// Polynomial degree p of the pieces.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// All knots u₀ … uₘ.
    #[must_use]
    pub fn as_slice(&self) -> &[f64] {
        &self.knots
    }

    /// How many control points, and basis functions, go with the knots: n + 1.
    #[must_use]
    pub fn n_points(&self) -> usize {
        self.knots.len() - self.degree - 1
    }

    /// # Errors
    /// [`KnotError::KnotCount`] unless the knots are for that many control points.
    pub(crate) fn check_points(&self, points: usize) -> Result<(), GeomError> {
        if points == self.n_points() {
            return Ok(());
        }
        let (degree, got) = (self.degree, self.knots.len());
        Err(GeomError::Knots(KnotError::KnotCount {
            points,
            degree,
            needed: points + degree + 1,
            got,
        }))
    }

    /// Where the basis sums to one: `[u_p, u_{n+1}]`.
    #[must_use]
    pub fn domain(&self) -> Interval {
        match Interval::new(self.knots[self.degree], self.knots[self.n_points()]) {
            Ok(domain) => domain,
            Err(_) => unreachable!("constructors refuse knots without a domain"),
        }
    }

    /// Index i of the span `[u_i, u_{i+1})` that holds `t`; the last one also holds its right
    /// end. Outside the domain the first or the last span answers. O(log n), O(1) for even knots.
    ///
    /// Piegl & Tiller, *The NURBS Book*, A2.1.
    #[must_use]
    #[inline]
    pub fn span_at(&self, t: f64) -> usize {
        // Even knots need no search.
        let even = (t - self.knots[self.degree]) * self.reciprocals.mean_span;
        let guess = self.degree.saturating_add(even as u32 as usize);
        let is_inside = guess < self.n_points();
        if is_inside && self.knots[guess] <= t && t < self.knots[guess + 1] {
            return guess;
        }
        self.searched_span(t)
    }

    /// [`Self::span_at`] of any knots.
    fn searched_span(&self, t: f64) -> usize {
        let (first, last) = (self.degree, self.n_points());
        let inside = &self.knots[first..=last];
        let t = t.max(inside[0]);
        let mut span = inside.partition_point(|&knot| knot <= t).min(last - first) - 1;
        // At the end of the domain, back over the knots that stand there.
        while inside[span] >= inside[span + 1] {
            span -= 1;
        }
        first + span
    }

    /// The span that ends or begins at `t`, where `t` is a knot; the span that holds it, else.
    #[must_use]
    pub fn span_beside(&self, t: f64, side: Side) -> usize {
        let (first, last) = (self.degree, self.n_points());
        let inside = &self.knots[first..=last];
        let (start, end) = (inside[0], inside[last - first]);
        match side {
            Side::Left if start < t => {
                first + inside.partition_point(|&knot| knot < t.min(end)) - 1
            }
            // At the start there is nothing on the left.
            Side::Left | Side::Right => self.span_at(t),
        }
    }

    /// Each knot once, with its multiplicity, over the whole vector.
    #[must_use]
    pub fn distinct(&self) -> Vec<(f64, usize)> {
        self.knots.chunk_by(|a, b| a.total_cmp(b).is_eq()).map(|run| (run[0], run.len())).collect()
    }

    /// The knots that stand degree + 1 times or more, each once.
    pub(crate) fn full_breaks(&self) -> Vec<f64> {
        let runs = self.knots.chunk_by(|a, b| a.total_cmp(b).is_eq());
        runs.filter(|run| self.degree < run.len()).map(|run| run[0]).collect()
    }

    /// How often `t` stands among the knots; closer than [`KNOT_RELATIVE`] of the domain counts.
    #[must_use]
    pub fn multiplicity(&self, t: f64) -> usize {
        let same = KNOT_RELATIVE * self.domain().length();
        self.knots.iter().filter(|&&knot| (knot - t).abs() <= same).count()
    }

    /// How often exactly `t` stands among the knots.
    pub(crate) fn exact_multiplicity(&self, t: f64) -> usize {
        self.knots.partition_point(|&knot| knot <= t) - self.knots.partition_point(|&knot| knot < t)
    }

    /// The ends of the domain and the distinct knots between them.
    #[must_use]
    pub fn breaks(&self) -> Vec<f64> {
        let domain = self.domain();
        self.distinct().into_iter().map(|(t, _)| t).filter(|&t| domain.contains(t)).collect()
    }

    /// The mean of p consecutive knots for each control point; of degree 0 the middles of spans.
    #[must_use]
    pub fn greville(&self) -> Vec<f64> {
        let p = self.degree;
        let mean = |i: usize| match p {
            0 => 0.5 * (self.knots[i] + self.knots[i + 1]),
            _ => {
                // Equal knots have exactly themselves as their mean.
                let first = self.knots[i + 1];
                let above: f64 = self.knots[i + 1..=i + p].iter().map(|knot| knot - first).sum();
                first + above / p as f64
            }
        };
        (0..self.n_points()).map(mean).collect()
    }

    /// Spans of the domain that have a width, by index.
    pub fn spans(&self) -> impl Iterator<Item = usize> {
        (self.degree..self.n_points()).filter(|&i| self.knots[i] < self.knots[i + 1])
    }

    /// Those that may reach into an interval, found without a look at the others.
    pub(crate) fn spans_within(&self, interval: Interval) -> impl Iterator<Item = usize> {
        let [first, last] = [interval.start(), interval.end()].map(|t| self.span_at(t));
        (first..=last).filter(|&i| self.knots[i] < self.knots[i + 1])
    }

    /// The parameters of a span that has a width.
    #[must_use]
    pub fn span_interval(&self, span: usize) -> Interval {
        match Interval::new(self.knots[span], self.knots[span + 1]) {
            Ok(interval) => interval,
            Err(_) => self.domain(),
        }
    }

    /// The control points, by index, that the curve depends on over a span.
    #[must_use]
    pub fn support(&self, span: usize) -> RangeInclusive<usize> {
        span - self.degree..=span
    }

    /// Values at `t` of the p + 1 functions that live on `span`, written into `values`.
    ///
    /// Exactly 0 and 1 at the ends of a clamped domain. O(p²); beyond the span the polynomials go
    /// on. Piegl & Tiller, *The NURBS Book*, A2.2, with the blend as one fraction.
    pub fn basis_at(&self, span: usize, t: f64, values: &mut [f64]) {
        self.basis_of_degree(self.degree, span, t, values);
    }

    fn basis_of_degree(&self, degree: usize, span: usize, t: f64, values: &mut [f64]) {
        values[0] = 1.0;
        for q in 1..=degree {
            self.raise(q, span, t, values);
        }
    }

    /// Turns values of degree q − 1 on a span into values of degree q, in place.
    fn raise(&self, q: usize, span: usize, t: f64, values: &mut [f64]) {
        let (lefts, rights) = (&self.knots[span + 1 - q..=span], &self.knots[span + 1..=span + q]);
        let mut carried = 0.0;
        // Between knots that stand as often as the degree all quotients are one.
        if lefts[0] >= lefts[q - 1] && rights[0] >= rights[q - 1] {
            let alpha = (t - lefts[0]) / (rights[0] - lefts[0]);
            let stays = 1.0 - alpha;
            for value in &mut values[..q] {
                let to_next = alpha * *value;
                *value = carried + stays * *value;
                carried = to_next;
            }
            values[q] = carried;
            return;
        }
        for (value, (&left, &right)) in values[..q].iter_mut().zip(lefts.iter().zip(rights)) {
            let alpha = (t - left) / (right - left);
            let to_next = alpha * *value;
            *value = carried + (1.0 - alpha) * *value;
            carried = to_next;
        }
        values[q] = carried;
    }

    /// Derivatives at `t` of the p + 1 functions that live on its span, by order up to `order`:
    /// row k holds the k-th ones; rows above p are zero.
    ///
    /// Piegl & Tiller, *The NURBS Book*, (2.7), applied k times to the basis of degree p − k.
    #[must_use]
    pub fn basis_derivatives_at(&self, t: f64, order: usize) -> Grid<f64> {
        self.basis_derivatives_on(self.span_at(t), t, order)
    }

    /// [`Self::basis_derivatives_at`] with the span given.
    #[must_use]
    pub fn basis_derivatives_on(&self, span: usize, t: f64, order: usize) -> Grid<f64> {
        let p = self.degree;
        let mut values = vec![0.0; (order + 1) * (p + 1)];
        self.fill_derivatives(span, t, &mut values);
        Grid::from_rows_of(p + 1, values)
    }

    /// Turns values of degree q − 1 on a span into derivatives of degree q, in place.
    fn differentiate(&self, q: usize, span: usize, values: &mut [f64]) {
        let mut carried = 0.0;
        let windows = self.knots[span + 1 - q..].iter().zip(&self.knots[span + 1..]);
        for (value, (left, right)) in values[..q].iter_mut().zip(windows) {
            let slope = q as f64 * *value / (right - left);
            *value = carried - slope;
            carried = slope;
        }
        values[q] = carried;
    }
}

fn check_degree(degree: usize) -> Result<(), GeomError> {
    let most = crate::ceiling::DEGREE;
    if degree <= most {
        Ok(())
    } else {
        Err(GeomError::Degree(DegreeError::DegreeTooHigh { degree, most }))
    }
}
