//! Jets: numbers that carry their derivatives along, as truncated Taylor series.
//!
//! Whatever is computed with jets has the derivatives of the result to the order of the jets, exact
//! up to rounding, because every rule is one for series and none a difference. Griewank & Walther,
//! *Evaluating Derivatives*, ch. 13. A function of one variable is applied by its own series, which
//! `series` has, so that one rule serves jets of one, of two
//! and of several variables.

mod apply;
mod moving_end;
mod series;

use glam::DVec3;

use super::{GeomError, Grid, LocalError};

pub use moving_end::moved_end;

/// The coefficients of a jet, behind a pointer: numbers lie on the stack of calls within calls.
type JetTerms = Vec<f64>;

/// A truncated Taylor series in one or two variables, or of first order in several. Invariant: as many
/// coefficients as its shape needs. Of what jets of several shapes make together the derivatives that one of them does
/// not tell are no numbers.
///
/// The derivatives of t·sin t at 0 are 0, 0, 2:
///
/// ```
/// use virote_kernel::Jet;
///
/// let t = Jet::variable(0.0, 2);
/// let product = t.times(&t.sin()?);
/// assert_eq!([0, 1, 2].map(|order| product.derivative(order, 0)), [0.0, 0.0, 2.0]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Jet {
    shape: JetShape,
    /// By total degree, within a degree by the power of the second variable; of several variables the value
    /// and then the slope by each.
    coefficients: JetTerms,
}

/// Of how many variables, and to which order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum JetShape {
    One { order: usize },
    Two { order: usize },
    Several { n_variables: usize },
}

impl JetShape {
    fn order(self) -> usize {
        match self {
            Self::One { order } | Self::Two { order } => order,
            Self::Several { .. } => 1,
        }
    }

    fn n_coefficients(self) -> usize {
        match self {
            Self::One { order } => order + 1,
            Self::Two { order } => (order + 1) * (order + 2) / 2,
            Self::Several { n_variables } => n_variables + 1,
        }
    }

    /// Where the coefficient of the powers i and j of at most two variables stands.
    fn place(self, i: usize, j: usize) -> usize {
        let degree = i + j;
        match self {
            Self::Two { .. } => degree * (degree + 1) / 2 + j,
            Self::One { .. } | Self::Several { .. } => degree,
        }
    }

    /// The powers of all coefficients in at most two variables, in their order.
    fn powers(self) -> impl Iterator<Item = (usize, usize)> {
        (0..=self.order()).flat_map(move |degree| {
            let last = if matches!(self, Self::Two { .. }) { degree } else { 0 };
            (0..=last).map(move |j| (degree - j, j))
        })
    }
}

impl Jet {
    /// The variable itself at a place, to an order.
    #[must_use]
    pub fn variable(value: f64, order: usize) -> Self {
        Self::constant(value, JetShape::One { order }).with_slope(1)
    }

    /// Both variables at a place, to a total order.
    #[must_use]
    pub fn variables(u: f64, v: f64, order: usize) -> [Self; 2] {
        let shape = JetShape::Two { order };
        [Self::constant(u, shape).with_slope(1), Self::constant(v, shape).with_slope(2)]
    }

    /// One of several variables at a place, to the first order.
    ///
    /// ```
    /// use virote_kernel::Jet;
    ///
    /// let [x, y] = [Jet::one_of(0, 2, 3.0), Jet::one_of(1, 2, 5.0)];
    /// assert_eq!(x.times(&y).times(&x).slopes(), [30.0, 9.0]);
    /// ```
    #[must_use]
    pub fn one_of(idx: usize, n_variables: usize, value: f64) -> Self {
        Self::constant(value, JetShape::Several { n_variables }).with_slope(idx + 1)
    }

    /// A number and its slope by each of several variables.
    ///
    /// # Errors
    /// [`LocalError::DerivativeBeyondNumbers`].
    pub fn with_slopes(value: f64, slopes: &[f64]) -> Result<Self, GeomError> {
        Self::of_several(std::iter::once(value).chain(slopes.iter().copied()).collect())
    }

    /// The same of the number and its slopes in one.
    pub(crate) fn of_several(coefficients: Vec<f64>) -> Result<Self, GeomError> {
        let shape = JetShape::Several { n_variables: coefficients.len() - 1 };
        Self { shape, coefficients }.checked()
    }

    /// Of how many variables it is a series of the first order; none if it is of a higher one.
    #[must_use]
    pub fn n_variables(&self) -> Option<usize> {
        match self.shape {
            JetShape::Several { n_variables } => Some(n_variables),
            JetShape::One { .. } | JetShape::Two { .. } => None,
        }
    }

    /// The derivatives of first order: by the variable, by both, or by each of several.
    #[must_use]
    pub fn slopes(&self) -> &[f64] {
        let last = match self.shape {
            JetShape::One { order } => order.min(1),
            JetShape::Two { order } => 2 * order.min(1),
            JetShape::Several { n_variables } => n_variables,
        };
        &self.coefficients[1..=last]
    }

    fn constant(value: f64, shape: JetShape) -> Self {
        let mut coefficients: JetTerms = vec![0.0; shape.n_coefficients()];
        coefficients[0] = value;
        Self { shape, coefficients }
    }

    fn with_slope(mut self, place: usize) -> Self {
        if let Some(slope) = self.coefficients.get_mut(place) {
            *slope = 1.0;
        }
        self
    }

    /// A number that depends on nothing, in the shape of this jet.
    #[must_use]
    pub fn same(&self, value: f64) -> Self {
        Self::constant(value, self.shape)
    }

    /// The same derivatives about another value; for a value that was computed more exactly.
    #[must_use]
    pub fn with_value(mut self, value: f64) -> Self {
        self.coefficients[0] = value;
        self
    }

    /// The coefficients of the series, the value first.
    #[must_use]
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    /// A series of this shape with other coefficients; those that are not given are zero.
    #[must_use]
    pub fn with_coefficients(&self, coefficients: &[f64]) -> Self {
        let mut all = coefficients.to_vec();
        all.resize(self.shape.n_coefficients(), 0.0);
        Self { shape: self.shape, coefficients: all }
    }

    /// The number itself.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.coefficients[0]
    }

    /// The order to which derivatives are known.
    #[must_use]
    pub fn order(&self) -> usize {
        self.shape.order()
    }

    /// Whether it grows with its first variable, or stays; of several with the first that it depends on.
    #[must_use]
    pub fn is_growing(&self) -> bool {
        let slope = match self.shape {
            JetShape::Several { .. } => self.slopes().iter().find(|slope| **slope != 0.0),
            _ => self.coefficients.get(1),
        };
        slope.is_none_or(|slope| 0.0 <= *slope)
    }

    /// Whether it depends on some of several variables, which may grow or fall: then it passes its value to both
    /// sides. A series of a higher order goes into one side.
    #[must_use]
    pub fn goes_both_ways(&self) -> bool {
        self.n_variables().is_some() && self.slopes().iter().any(|slope| 0.0 < slope.abs())
    }

    /// Whether the derivatives are those of another jet; the values may differ.
    #[must_use]
    pub fn has_slopes_of(&self, other: &Self) -> bool {
        self.shape == other.shape && self.coefficients[1..] == other.coefficients[1..]
    }

    /// Whether every coefficient is a number.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.coefficients.iter().all(|coefficient| coefficient.is_finite())
    }

    /// The largest coefficient by size.
    #[must_use]
    pub fn magnitude(&self) -> f64 {
        self.coefficients.iter().fold(0.0, |most: f64, coefficient| most.max(coefficient.abs()))
    }

    /// The jet, unless arithmetic has left the numbers.
    fn checked(self) -> Result<Self, GeomError> {
        if self.is_finite() {
            Ok(self)
        } else {
            Err(GeomError::Local(LocalError::DerivativeBeyondNumbers))
        }
    }

    /// The derivative of order i by the first and j by the second variable.
    #[must_use]
    pub fn derivative(&self, i: usize, j: usize) -> f64 {
        let factorial = |n: usize| (1..=n).fold(1.0, |product, k| product * k as f64);
        let has_second = matches!(self.shape, JetShape::Two { .. });
        let is_known = i.saturating_add(j) <= self.shape.order() && (j == 0 || has_second);
        if !is_known {
            return 0.0;
        }
        self.coefficients[self.shape.place(i, j)] * factorial(i) * factorial(j)
    }

    /// The same series in the shape of another: what it does not tell is no number.
    fn in_shape_of(&self, other: &Self) -> Self {
        let is_alike = std::mem::discriminant(&self.shape) == std::mem::discriminant(&other.shape);
        let n_known = if is_alike { self.coefficients.len() } else { 1 };
        let n = other.coefficients.len();
        let known = self.coefficients.iter().copied().take(n_known.min(n));
        let coefficients = known.chain(std::iter::repeat(f64::NAN)).take(n).collect();
        Self { shape: other.shape, coefficients }
    }

    fn zip(&self, other: &Self, f: impl Fn(f64, f64) -> f64) -> Self {
        if self.shape != other.shape {
            return self.zip(&other.in_shape_of(self), f);
        }
        let pairs = self.coefficients.iter().zip(&other.coefficients);
        Self { shape: self.shape, coefficients: pairs.map(|(&a, &b)| f(a, b)).collect() }
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        self.zip(other, |a, b| a + b)
    }

    /// The difference.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        self.zip(other, |a, b| a - b)
    }

    /// The product with a number.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let coefficients = self.coefficients.iter().map(|&a| a * factor).collect();
        Self { shape: self.shape, coefficients }
    }

    /// The product: Cauchy's, cut off at the order.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let shape = self.shape;
        if shape != other.shape {
            return self.times(&other.in_shape_of(self));
        }
        if let JetShape::Several { .. } = shape {
            let (a, b) = (self.value(), other.value());
            return self.zip(other, |slope, other| slope * b + a * other).with_value(a * b);
        }
        let mut product = Self::constant(0.0, shape);
        for (i, j) in shape.powers() {
            let mut sum = 0.0;
            for p in 0..=i {
                for q in 0..=j {
                    sum += self.coefficients[shape.place(p, q)]
                        * other.coefficients[shape.place(i - p, j - q)];
                }
            }
            product.coefficients[shape.place(i, j)] = sum;
        }
        product
    }

    /// The quotient.
    ///
    /// # Errors
    /// [`LocalError::NotDifferentiable`] where the divisor is zero,
    /// [`LocalError::DerivativeBeyondNumbers`].
    pub fn over(&self, other: &Self) -> Result<Self, GeomError> {
        let (shape, divisor) = (self.shape, other.value());
        if divisor == 0.0 {
            return Err(LocalError::NotDifferentiable { what: "a quotient", at: divisor }.into());
        }
        if shape != other.shape {
            return self.over(&other.in_shape_of(self));
        }
        if let JetShape::Several { .. } = shape {
            let value = self.value() / divisor;
            let slopes = self.zip(other, |slope, other| (slope - value * other) / divisor);
            return slopes.with_value(value).checked();
        }
        let mut quotient = Self::constant(0.0, shape);
        for (i, j) in shape.powers() {
            let mut rest = self.coefficients[shape.place(i, j)];
            for p in 0..=i {
                for q in usize::from(p == 0)..=j {
                    rest -= other.coefficients[shape.place(p, q)]
                        * quotient.coefficients[shape.place(i - p, j - q)];
                }
            }
            quotient.coefficients[shape.place(i, j)] = rest / divisor;
        }
        quotient.checked()
    }

    /// The series Σ sₖ·hᵏ of the part h that varies, by Horner's scheme.
    ///
    /// # Errors
    /// [`LocalError::DerivativeBeyondNumbers`].
    pub fn compose(&self, series: &[f64]) -> Result<Self, GeomError> {
        if let (JetShape::Several { .. }, [value, slope, ..]) = (self.shape, series) {
            return self.scaled(*slope).with_value(*value).checked();
        }
        let varying = self.clone().with_value(0.0);
        let mut sum = self.same(0.0);
        for &term in series.iter().rev() {
            sum = sum.times(&varying);
            sum.coefficients[0] += term;
        }
        sum.checked()
    }
}

/// A point of a curve at a parameter that varies, from its derivatives at the parameter's value.
///
/// Faà di Bruno's formula, as the composition of series.
///
/// # Errors
/// [`LocalError::DerivativeBeyondNumbers`].
pub fn along(derivatives: &[DVec3], t: &Jet) -> Result<[Jet; 3], GeomError> {
    let coordinate = |axis: usize| {
        let mut factorial = 1.0;
        let term = |(k, derivative): (usize, &DVec3)| {
            factorial *= k.max(1) as f64;
            derivative[axis] / factorial
        };
        t.compose(&derivatives.iter().enumerate().map(term).collect::<JetTerms>())
    };
    Ok([coordinate(0)?, coordinate(1)?, coordinate(2)?])
}

/// A point of a surface at parameters that vary, from its derivatives at their values: row k,
/// column l of the grid holds the one of order k in u and l in v.
///
/// # Errors
/// [`LocalError::DerivativeBeyondNumbers`].
pub fn across(derivatives: &Grid<DVec3>, u: &Jet, v: &Jet) -> Result<[Jet; 3], GeomError> {
    let coordinate = |axis: usize| {
        let varying = u.clone().with_value(0.0);
        let mut sum = u.same(0.0);
        // Horner's scheme in u; its coefficients are series in v.
        for k in (0..=u.order()).rev() {
            let factorial = |n: usize| (1..=n).fold(1.0, |product, m| product * m as f64);
            let is_told = |l: usize| k < derivatives.n_rows() && l < derivatives.n_columns();
            let derivative = |l: usize| if is_told(l) { derivatives.get(k, l)[axis] } else { 0.0 };
            let term = |l: usize| derivative(l) / (factorial(k) * factorial(l));
            let along_v =
                v.compose(&(0..=v.order().saturating_sub(k)).map(term).collect::<JetTerms>())?;
            sum = sum.times(&varying).plus(&along_v);
        }
        sum.checked()
    };
    Ok([coordinate(0)?, coordinate(1)?, coordinate(2)?])
}
