//! Derivatives as curves, and products of curves with scalar splines; both exact.

use glam::{DVec3, DVec4};

use crate::{
    DomainError, FormError, GeomError, InputError, KnotVector, PointEntries, WeightError, bezier,
    curve::{NurbsCurve, construction::chain::binomials},
    homogeneous, positive,
    tolerance::KNOT_RELATIVE,
};

impl NurbsCurve {
    /// The curve of derivative vectors, on the same domain.
    ///
    /// Of degree p − 1 for a polynomial curve. That of a rational one, (A′w − Aw′)/w², is a
    /// rational curve of degree 2p. Piegl & Tiller, *The NURBS Book*, (3.8) and (4.8).
    ///
    /// # Errors
    /// `DegreeError::DegreeTooHigh`, [`InputError::NotFinite`].
    pub fn hodograph(&self) -> Result<Self, GeomError> {
        if self.is_rational { self.rational_hodograph() } else { self.polynomial_hodograph() }
    }

    fn polynomial_hodograph(&self) -> Result<Self, GeomError> {
        let (p, u, points) = (self.degree(), self.knots.as_slice(), self.points());
        if p == 0 {
            return Self::polynomial(self.knots.clone(), &vec![DVec3::ZERO; points.len()]);
        }
        let legs = hodograph_legs(&self.knots);
        let slopes: Vec<DVec3> =
            legs.iter().map(|&(i, factor)| (points[i + 1] - points[i]) * factor).collect();
        let mut knots: Vec<f64> = legs.iter().map(|(i, _)| u[i + 1]).collect();
        knots.extend_from_slice(&u[points.len()..u.len() - 1]);
        Self::polynomial(KnotVector::new(p - 1, knots)?, &slopes)
    }

    /// By how much each control point counts in those of [`Self::hodograph`]; none where it has weights.
    #[must_use]
    pub fn factors_of_hodograph(&self) -> Option<PointEntries> {
        let legs = hodograph_legs(&self.knots).into_iter().enumerate();
        let both = |(made, (i, factor)): (usize, (usize, f64))| {
            [(made, i, -factor), (made, i + 1, factor)]
        };
        (!self.is_rational && 0 < self.degree()).then(|| legs.flat_map(both).collect())
    }

    fn rational_hodograph(&self) -> Result<Self, GeomError> {
        let (p, breaks) = (self.degree(), self.knots.breaks());
        let ends = breaks.windows(2);
        let pieces = ends.zip(self.pieces_between(&breaks)).map(|(ends, piece)| {
            let slope = |pair: &[DVec4]| (pair[1] - pair[0]) * (p as f64 / (ends[1] - ends[0]));
            let slopes: Vec<DVec4> = piece.windows(2).map(slope).collect();
            let weights = piece.iter().map(|point| point.w);
            let weights: Vec<f64> = weights.collect();
            let weight_slopes: Vec<f64> = slopes.iter().map(|slope| slope.w).collect();
            let rises = product(&slopes, &weights);
            let falls = product(&piece, &weight_slopes);
            let numerator: Vec<DVec4> = rises.iter().zip(&falls).map(|(a, b)| *a - *b).collect();
            let numerator = product(&numerator, &[1.0, 1.0]);
            let squares = product(&piece, &weights);
            let point = |(top, bottom): (&DVec4, &DVec4)| top.truncate().extend(bottom.w);
            numerator.iter().zip(&squares).map(point).collect()
        });
        let inner = &breaks[1..breaks.len() - 1];
        // C^(p − m) before, one less of the derivative, at degree 2p.
        let multiplicities: Vec<usize> =
            inner.iter().map(|&t| p + self.knots.exact_multiplicity(t) + 1).collect();
        Self::of_pieces(&breaks, pieces.collect(), &multiplicities)
    }

    /// Every homogeneous point times the scalar spline that the x coordinate of `factor` is: the
    /// same points in space, with other weights.
    ///
    /// Piegl & Tiller, *The NURBS Book*, (10.15).
    ///
    /// # Errors
    /// [`FormError::RationalFor`], [`FormError::NotScalar`], [`DomainError::OtherDomain`],
    /// [`InputError::NotPositive`] for the factor; `DegreeError::DegreeTooHigh`,
    /// [`InputError::NotFinite`].
    pub fn reweighted(&self, factor: &Self) -> Result<Self, GeomError> {
        if factor.is_rational {
            return Err(FormError::RationalFor { what: "a scalar spline" }.into());
        }
        let values = factor.points();
        if let Some(index) = values.iter().position(|value| value.with_x(0.0) != DVec3::ZERO) {
            return Err(FormError::NotScalar { index }.into());
        }
        let (domain, other) = (self.domain(), factor.domain());
        let same = KNOT_RELATIVE * domain.length();
        let gap = (domain.start() - other.start()).abs().max((domain.end() - other.end()).abs());
        if same < gap {
            return Err(DomainError::OtherDomain { domain, other }.into());
        }
        let as_weights: Vec<DVec4> = values.iter().map(|v| DVec3::ZERO.extend(v.x)).collect();
        positive::check_curve(&factor.knots, &as_weights).map_err(|error| match error {
            GeomError::Weights(WeightError::VanishingWeights { parameter }) => {
                GeomError::Input(InputError::NotPositive {
                    what: "the factor",
                    got: factor.point_at(parameter).x,
                })
            }
            other => other,
        })?;
        let factor = factor.reparametrized(domain);

        let mut breaks = [self.knots.breaks(), factor.knots.breaks()].concat();
        breaks.sort_by(f64::total_cmp);
        breaks.dedup_by(|later, earlier| *later - *earlier <= same);
        let pairs = self.pieces_between(&breaks).into_iter().zip(factor.pieces_between(&breaks));
        let pieces = pairs.map(|(piece, factor)| {
            let values: Vec<f64> = factor.iter().map(|&p| homogeneous::project(p).x).collect();
            product(&piece, &values)
        });
        let degrees = [self.degree(), factor.degree()];
        let multiplicity = |&t: &f64| {
            let times = [self.knots.multiplicity(t), factor.knots.multiplicity(t)];
            let both = [0, 1].map(|i| if times[i] == 0 { 0 } else { degrees[1 - i] + times[i] });
            both[0].max(both[1])
        };
        let multiplicities: Vec<usize> =
            breaks[1..breaks.len() - 1].iter().map(multiplicity).collect();
        Self::of_pieces(&breaks, pieces.collect(), &multiplicities)
    }

    /// Bézier points over each interval between breaks, none of which holds a knot inside.
    fn pieces_between(&self, breaks: &[f64]) -> Vec<Vec<DVec4>> {
        let p = self.degree();
        let piece = |ends: &[f64]| {
            let span = self.knots.span_at(0.5 * (ends[0] + ends[1]));
            let point = |n_at_end: usize| {
                let arguments: Vec<f64> =
                    (0..p).map(|k| if k < n_at_end { ends[1] } else { ends[0] }).collect();
                bezier::blossom(&self.knots, &self.control_points, span, &arguments)
            };
            (0..=p).map(point).collect()
        };
        breaks.windows(2).map(piece).collect()
    }
}

/// The legs of a control polygon that are control points of the derivative, each with the first point and the factor p over
/// the width of what both have in common: where a knot stands p + 1 times, no function lives between its points.
///
/// Piegl & Tiller, *The NURBS Book*, (3.3).
fn hodograph_legs(knots: &KnotVector) -> Vec<(usize, f64)> {
    let (p, u) = (knots.degree(), knots.as_slice());
    let leg = |i: usize| {
        let width = u[i + p + 1] - u[i + 1];
        (0.0 < width).then(|| (i, p as f64 / width))
    };
    (0..knots.n_points() - 1).filter_map(leg).collect()
}

/// Bernstein coefficients of the product of two polynomials given by theirs.
///
/// Farouki & Rajan, *Algorithms for polynomials in Bernstein form*.
fn product(a: &[DVec4], b: &[f64]) -> Vec<DVec4> {
    let (p, q) = (a.len() - 1, b.len() - 1);
    let (of_a, of_b, of_both) = (binomials(p), binomials(q), binomials(p + q));
    let mut sums = vec![DVec4::ZERO; p + q + 1];
    for (i, &point) in a.iter().enumerate() {
        for (j, &factor) in b.iter().enumerate() {
            sums[i + j] += point * (factor * of_a[i] * of_b[j] / of_both[i + j]);
        }
    }
    sums
}
