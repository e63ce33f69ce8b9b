//! Curves that are given as chains of segments: Hermite, Coons, Beta-spline, power basis.

use glam::{DVec3, DVec4};

use crate::{
    CountError, FormError, GeomError, InputError, Interval, KnotVector, PointEntries,
    curve::NurbsCurve, homogeneous,
};

impl NurbsCurve {
    /// The cubic through the points with these derivatives, one unit of parameter a segment, C1.
    ///
    /// Each segment from A to B with derivatives a and b has the Bézier points A, A + a/3,
    /// B − b/3, B. Linkeová, *Curves and Surfaces for Computer Graphics*, (2.13) and (2.25).
    ///
    /// The derivatives are met, whatever they are:
    ///
    /// ```
    /// use virote_kernel::{NurbsCurve, Side, glam::DVec3};
    ///
    /// let curve = NurbsCurve::hermite(&[DVec3::ZERO, DVec3::X], &[DVec3::Y, DVec3::NEG_Y])?;
    /// assert_eq!(curve.derivatives_at(0.0, 1)[1], DVec3::Y);
    /// assert!(curve.point_at(0.5).distance(DVec3::new(0.5, 0.25, 0.0)) < 1e-15);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`CountError::TooFewPoints`] below two, [`CountError::TangentCount`],
    /// [`InputError::NotFinite`].
    pub fn hermite(points: &[DVec3], tangents: &[DVec3]) -> Result<Self, GeomError> {
        let n = points.len();
        if n < 2 {
            return Err(CountError::TooFewPoints { got: n, needed: 2 }.into());
        }
        if tangents.len() != n {
            return Err(CountError::TangentCount { points: n, tangents: tangents.len() }.into());
        }
        let polygon: Vec<DVec3> =
            hermite_corners(n).map(|(i, share)| points[i] + tangents[i] * share / 3.0).collect();
        let mut knots = vec![0.0; 4];
        (1..n - 1).for_each(|i| knots.extend([i as f64; 2]));
        knots.extend([(n - 1) as f64; 4]);
        Self::polynomial(KnotVector::new(3, knots)?, &polygon)
    }

    /// By how much each of so many points counts in the control points of [`Self::beta_spline`].
    #[must_use]
    pub fn factors_of_beta_spline(
        n_points: usize,
        bias: f64,
        tension: f64,
        is_closed: bool,
    ) -> PointEntries {
        let n_around = if is_closed { n_points + 3 } else { n_points };
        let sum = beta_sum(bias, tension);
        let of = |(made, terms): (usize, [(usize, f64); 3])| {
            terms.map(|(i, factor)| (made, i % n_points, factor / sum))
        };
        let all = beta_corners(n_around, bias, tension).into_iter().enumerate().flat_map(of);
        all.filter(|entry| entry.2 != 0.0).collect()
    }

    /// By how much each of so many points, and behind them each tangent, counts in the control points of [`Self::hermite`].
    #[must_use]
    pub fn factors_of_hermite(n_points: usize) -> PointEntries {
        let both = |(made, (i, share)): (usize, (usize, f64))| {
            [(made, i, 1.0), (made, n_points + i, share / 3.0)]
        };
        let all = hermite_corners(n_points).enumerate().flat_map(both);
        all.filter(|entry| entry.2 != 0.0).collect()
    }

    /// The uniform B-spline of degree p, not clamped, one unit of parameter a segment; a closed
    /// one begins with the segment of points 0 … p and has as many segments as points.
    ///
    /// A segment of the uniform cubic begins at (P₀ + 4·P₁ + P₂)/6:
    ///
    /// ```
    /// use virote_kernel::{NurbsCurve, glam::DVec3};
    ///
    /// let points = [(0.0, 0.0), (6.0, 6.0), (12.0, 0.0), (18.0, 6.0)];
    /// let curve = NurbsCurve::uniform(3, &points.map(|(x, y)| DVec3::new(x, y, 0.0)), false)?;
    /// assert!(curve.start().distance(DVec3::new(6.0, 4.0, 0.0)) < 1e-14);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// `DegreeError::BadDegree` below p + 1 points, for a closed one [`CountError::TooFewPoints`]
    /// below three; `DegreeError::DegreeTooHigh`, [`InputError::NotFinite`].
    pub fn uniform(degree: usize, points: &[DVec3], is_closed: bool) -> Result<Self, GeomError> {
        let points = if is_closed { wrapped(points, degree)? } else { points.to_vec() };
        Self::polynomial(KnotVector::uniform(degree, points.len())?, &points)
    }

    /// Barsky's cubic Beta-spline, uniformly shaped, one unit of parameter a segment.
    ///
    /// At each joint the unit tangent and the curvature vector agree, and the derivative behind
    /// it is `bias` times the one before. Bias 1 and tension 0 give the uniform cubic B-spline.
    /// Barsky, *The Beta-spline*, University of Utah 1981.
    ///
    /// # Errors
    /// [`CountError::TooFewPoints`] below four, closed below three; [`InputError::NotPositive`] for
    /// the bias; [`InputError::TensionTooLow`]; [`InputError::NotFinite`].
    pub fn beta_spline(
        points: &[DVec3],
        bias: f64,
        tension: f64,
        is_closed: bool,
    ) -> Result<Self, GeomError> {
        if !(bias.is_finite() && 0.0 < bias) {
            return Err(InputError::NotPositive { what: "the bias", got: bias }.into());
        }
        let sum = beta_sum(bias, tension);
        if !sum.is_finite() {
            return Err(InputError::NotFinite { what: "control point", index: 0 }.into());
        }
        if sum <= 0.0 {
            return Err(InputError::TensionTooLow { tension, above: tension - sum }.into());
        }
        let points = if is_closed { wrapped(points, 3)? } else { points.to_vec() };
        let got = points.len();
        if got < 4 {
            return Err(CountError::TooFewPoints { got, needed: 4 }.into());
        }
        let terms = |terms: [(usize, f64); 3]| {
            let [first, second, third] = terms.map(|(i, factor)| points[i] * factor);
            (first + second + third) / sum
        };
        let polygon: Vec<DVec3> = beta_corners(got, bias, tension).into_iter().map(terms).collect();
        let n_segments = got - 3;
        let inner = (1..n_segments).flat_map(|i| [i as f64; 3]);
        let knots = [0.0; 4].into_iter().chain(inner).chain([n_segments as f64; 4]).collect();
        Self::polynomial(KnotVector::new(3, knots)?, &polygon)
    }

    /// The polynomial Σ cᵢ tⁱ over a domain, as a Bézier curve.
    ///
    /// The control points are its blossom at the ends of the domain, where that of tⁱ is the i-th
    /// elementary symmetric function over C(n, i). Ramshaw, *Blossoms are polar forms*, §5.
    ///
    /// x = t, y = t²: the control point of the parabola over 0..2 is (1, 0).
    ///
    /// ```
    /// use virote_kernel::{Interval, NurbsCurve, glam::DVec3};
    ///
    /// let parabola = NurbsCurve::power_form(&[DVec3::ZERO, DVec3::X, DVec3::Y], Interval::new(0.0, 2.0)?)?;
    /// assert_eq!(parabola.points()[1], DVec3::X);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`CountError::TooFewPoints`] without coefficients, `DegreeError::DegreeTooHigh`,
    /// [`InputError::NotFinite`].
    pub fn power_form(coefficients: &[DVec3], domain: Interval) -> Result<Self, GeomError> {
        let Some(degree) = coefficients.len().checked_sub(1) else {
            return Err(CountError::TooFewPoints { got: 0, needed: 1 }.into());
        };
        let knots = KnotVector::bezier(degree)?.on(domain);
        let point = |weights: Vec<f64>| {
            let terms = coefficients.iter().zip(weights);
            terms.fold(DVec3::ZERO, |sum, (&c, weight)| sum + c * weight)
        };
        let points: Vec<DVec3> = power_weights(degree + 1, domain).into_iter().map(point).collect();
        Self::polynomial(knots, &points)
    }

    /// Coefficients cᵢ of Σ cᵢ tⁱ, lowest first: the inverse of [`Self::power_form`].
    ///
    /// # Errors
    /// [`FormError::RationalFor`] with weights, [`FormError::TooManySegments`] above one.
    pub fn power_coefficients(&self) -> Result<Vec<DVec3>, GeomError> {
        let what = "a polynomial in t";
        if self.is_rational {
            return Err(FormError::RationalFor { what }.into());
        }
        if self.n_segments() != 1 {
            return Err(FormError::TooManySegments { what, got: self.n_segments() }.into());
        }
        let coefficients = powers(self.clamped().points(), self.domain());
        let finite: Vec<DVec4> = coefficients.iter().map(|c| c.extend(1.0)).collect();
        homogeneous::check_finite(&finite)?;
        Ok(coefficients)
    }
}

/// What the weights of a Beta-spline's points at a joint come to.
fn beta_sum(bias: f64, tension: f64) -> f64 {
    2.0 * (bias * bias * bias) + beta_bend(bias, tension) + 2.0
}

/// The weight of the middle one of three points at a joint.
fn beta_bend(bias: f64, tension: f64) -> f64 {
    4.0 * (bias * bias) + 4.0 * bias + tension
}

/// The Bézier points of a Beta-spline of so many points, four or more: those that each is made of, with what they count of
/// [`beta_sum`].
fn beta_corners(n_points: usize, bias: f64, tension: f64) -> Vec<[(usize, f64); 3]> {
    let (squared, cubed) = (bias * bias, bias * bias * bias);
    let bend = beta_bend(bias, tension);
    let joint = |i: usize| [(i, 2.0 * cubed), (i + 1, bend), (i + 2, 2.0)];
    let between = |i: usize, before: f64, after: f64| [(i, before), (i + 1, after), (i, 0.0)];
    let segment = |i: usize| {
        let first =
            between(i, 2.0 * cubed + 4.0 * squared + 2.0 * bias + tension, 2.0 + 2.0 * bias);
        let second =
            between(i, 2.0 * cubed + 2.0 * squared, 2.0 * squared + 4.0 * bias + tension + 2.0);
        [first, second, joint(i)]
    };
    std::iter::once(joint(0)).chain((1..n_points - 2).flat_map(segment)).collect()
}

/// The control points of a chain of cubics through so many points: each with the one that it stands by, and by how much
/// of a third of the tangent there it is off.
fn hermite_corners(n_points: usize) -> impl Iterator<Item = (usize, f64)> {
    let last = n_points.saturating_sub(1);
    let inner = (0..n_points).flat_map(move |i| {
        [(0 < i).then_some((i, -1.0)), (i < last).then_some((i, 1.0))].into_iter().flatten()
    });
    std::iter::once((0, 0.0)).chain(inner).chain(std::iter::once((last, 0.0)))
}

/// By how much each of so many coefficients of powers counts in each Bézier point over a domain: the blossom of a power is
/// the mean of the products of as many of the arguments.
///
/// Ramshaw, *Blossoms are polar forms* (1989).
pub(crate) fn power_weights(n_coefficients: usize, domain: Interval) -> Vec<Vec<f64>> {
    let degree = n_coefficients.saturating_sub(1);
    let binomials = binomials(degree);
    // symmetric[i] sums the products of i of the arguments.
    let with = |symmetric: &mut [f64], n_before: usize, argument: f64| {
        for i in (1..=n_before + 1).rev() {
            symmetric[i] += argument * symmetric[i - 1];
        }
    };
    let mut of_ends = vec![0.0; degree + 1];
    of_ends[0] = 1.0;
    let row = |n_at_end: usize| {
        let mut symmetric = of_ends.clone();
        // An argument of zero adds nothing.
        if domain.start() != 0.0 {
            (n_at_end..degree).for_each(|k| with(&mut symmetric, k, domain.start()));
        }
        if n_at_end < degree {
            with(&mut of_ends, n_at_end, domain.end());
        }
        symmetric.iter().zip(&binomials).map(|(e, binomial)| e / binomial).collect()
    };
    (0..n_coefficients).map(row).collect()
}

/// Coefficients of the powers of a parameter, lowest first, of a Bézier form over a domain.
pub(crate) fn powers(points: Vec<DVec3>, domain: Interval) -> Vec<DVec3> {
    // Coefficients in the fraction of the domain are differences of Bézier points.
    let (degree, mut differences) = (points.len() - 1, points);
    for level in 1..=degree {
        for i in (level..=degree).rev() {
            differences[i] = differences[i] - differences[i - 1];
        }
    }
    let mut scale = 1.0;
    let mut local: Vec<DVec3> = Vec::with_capacity(degree + 1);
    for (difference, binomial) in differences.into_iter().zip(binomials(degree)) {
        local.push(difference * (binomial / scale));
        scale *= domain.length();
    }
    // Horner's shift from powers of t − start to powers of t.
    for i in 0..degree {
        for j in (i..degree).rev() {
            let shift = local[j + 1] * domain.start();
            local[j] -= shift;
        }
    }
    local
}

/// The points of a closed spline with the first p of them again at the end.
fn wrapped(points: &[DVec3], degree: usize) -> Result<Vec<DVec3>, GeomError> {
    let got = points.len();
    if got < 3 {
        return Err(CountError::TooFewPoints { got, needed: 3 }.into());
    }
    Ok(points.iter().cycle().take(got + degree).copied().collect())
}

/// C(n, 0) … C(n, n).
pub(in crate::curve) fn binomials(n: usize) -> Vec<f64> {
    let mut row = vec![1.0];
    for i in 0..n {
        row.push(row[i] * (n - i) as f64 / (i + 1) as f64);
    }
    row
}
