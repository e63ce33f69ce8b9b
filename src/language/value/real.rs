//! Numbers in functions that may be differentiated: as they are, or as jets.

use std::borrow::Cow;

use crate::kernel::{GeomError, Jet, LocalError, Side};

/// A number, or one that carries its derivatives.
#[derive(Clone, Debug, PartialEq)]
pub enum Real {
    /// Depends on nothing.
    Plain(f64),
    /// Depends on the parameters of a function that is differentiated.
    Jet(Jet),
}

/// Two numbers brought to one form.
enum MatchedReals<'a> {
    Plain(f64, f64),
    Jets(Cow<'a, Jet>, Cow<'a, Jet>),
}

/// Functions of one number: that of jets, about the value that the plain function has.
macro_rules! functions {
    ($( $(#[$docs:meta])* $name:ident = $plain:path; )+) => { $(
        $(#[$docs])*
        ///
        /// # Errors
        /// [`LocalError::NotDifferentiable`], [`LocalError::DerivativeBeyondNumbers`] for jets.
        pub fn $name(&self) -> Result<Self, GeomError> {
            Ok(match self {
                Self::Plain(x) => Self::Plain($plain(*x)),
                Self::Jet(jet) => Self::Jet(jet.$name()?.with_value($plain(jet.value()))),
            })
        }
    )+ };
}

impl Real {
    functions! {
        /// The magnitude.
        abs = f64::abs;
        /// The square root.
        sqrt = f64::sqrt;
        /// The cube root.
        cbrt = libm::cbrt;
        /// The exponential function.
        exp = libm::exp;
        /// The natural logarithm.
        ln = libm::log;
        /// The logarithm to the base ten.
        log10 = libm::log10;
        /// The sine of radians.
        sin = libm::sin;
        /// The cosine of radians.
        cos = libm::cos;
        /// The tangent of radians.
        tan = libm::tan;
        /// The angle with this sine.
        asin = libm::asin;
        /// The angle with this cosine.
        acos = libm::acos;
        /// The angle with this tangent.
        atan = libm::atan;
        /// The hyperbolic sine.
        sinh = libm::sinh;
        /// The hyperbolic cosine.
        cosh = libm::cosh;
        /// The hyperbolic tangent.
        tanh = libm::tanh;
    }

    /// The number alone.
    #[must_use]
    pub fn value(&self) -> f64 {
        match self {
            Self::Plain(x) => *x,
            Self::Jet(jet) => jet.value(),
        }
    }

    /// The same derivatives about another value; for a value that was computed more exactly.
    #[must_use]
    pub fn with_value(self, value: f64) -> Self {
        match self {
            Self::Plain(_) => Self::Plain(value),
            Self::Jet(jet) => Self::Jet(jet.with_value(value)),
        }
    }

    /// The side of a knot that the number moves into as a parameter.
    #[must_use]
    pub fn side(&self) -> Side {
        match self {
            Self::Jet(jet) if !jet.is_growing() => Side::Left,
            _ => Side::Right,
        }
    }

    /// Whether it and its derivatives are numbers.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        match self {
            Self::Plain(x) => x.is_finite(),
            Self::Jet(jet) => jet.is_finite(),
        }
    }

    /// The derivative of order i by the first and j by the second parameter; of what depends on
    /// nothing zero.
    #[must_use]
    pub fn derivative(&self, i: usize, j: usize) -> f64 {
        match self {
            Self::Plain(x) if i + j == 0 => *x,
            Self::Plain(_) => 0.0,
            Self::Jet(jet) => jet.derivative(i, j),
        }
    }

    /// As a jet of the shape of another.
    #[must_use]
    pub fn like(&self, other: &Jet) -> Jet {
        match self {
            Self::Plain(x) => other.same(*x),
            Self::Jet(jet) => jet.clone(),
        }
    }

    fn with<'a>(&'a self, other: &'a Self) -> MatchedReals<'a> {
        use Cow::{Borrowed, Owned};
        match (self, other) {
            (Self::Plain(a), Self::Plain(b)) => MatchedReals::Plain(*a, *b),
            (Self::Jet(a), Self::Jet(b)) => MatchedReals::Jets(Borrowed(a), Borrowed(b)),
            (Self::Jet(a), Self::Plain(b)) => MatchedReals::Jets(Borrowed(a), Owned(a.same(*b))),
            (Self::Plain(a), Self::Jet(b)) => MatchedReals::Jets(Owned(b.same(*a)), Borrowed(b)),
        }
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        match self.with(other) {
            MatchedReals::Plain(a, b) => Self::Plain(a + b),
            MatchedReals::Jets(a, b) => Self::Jet(a.plus(&b)),
        }
    }

    /// The difference.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        match self.with(other) {
            MatchedReals::Plain(a, b) => Self::Plain(a - b),
            MatchedReals::Jets(a, b) => Self::Jet(a.minus(&b)),
        }
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        match self.with(other) {
            MatchedReals::Plain(a, b) => Self::Plain(a * b),
            MatchedReals::Jets(a, b) => Self::Jet(a.times(&b)),
        }
    }

    /// The product with a plain number.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        match self {
            Self::Plain(x) => Self::Plain(x * factor),
            Self::Jet(jet) => Self::Jet(jet.scaled(factor)),
        }
    }

    /// The quotient by a number that is not zero.
    ///
    /// # Errors
    /// As for [`Jet::over`].
    pub fn over(&self, other: &Self) -> Result<Self, GeomError> {
        Ok(match self.with(other) {
            MatchedReals::Plain(a, b) => Self::Plain(a / b),
            MatchedReals::Jets(a, b) => Self::Jet(a.over(&b)?.with_value(a.value() / b.value())),
        })
    }

    /// The angle of the direction (x, `self`).
    ///
    /// # Errors
    /// As for [`Jet::atan2`].
    pub fn atan2(&self, x: &Self) -> Result<Self, GeomError> {
        let angle = libm::atan2(self.value(), x.value());
        Ok(match self.with(x) {
            MatchedReals::Plain(..) => Self::Plain(angle),
            MatchedReals::Jets(y, x) => Self::Jet(y.atan2(&x)?.with_value(angle)),
        })
    }

    /// The length of the hypotenuse.
    ///
    /// # Errors
    /// As for [`Jet::norm`].
    pub fn hypot(&self, other: &Self) -> Result<Self, GeomError> {
        let length = libm::hypot(self.value(), other.value());
        Ok(match self.with(other) {
            MatchedReals::Plain(..) => Self::Plain(length),
            MatchedReals::Jets(a, b) => {
                Self::Jet(Jet::norm([&*a, &*b].into_iter())?.with_value(length))
            }
        })
    }

    /// The larger of two numbers; of equal ones the first.
    ///
    /// # Errors
    /// [`LocalError::NotDifferentiable`] where they are equal and their derivatives are not.
    pub fn max(self, other: Self) -> Result<Self, GeomError> {
        let is_other = self.value() < other.value();
        self.either(other, is_other, "the maximum")
    }

    /// The smaller of two numbers; of equal ones the first.
    ///
    /// # Errors
    /// [`LocalError::NotDifferentiable`] where they are equal and their derivatives are not.
    pub fn min(self, other: Self) -> Result<Self, GeomError> {
        let is_other = other.value() < self.value();
        self.either(other, is_other, "the minimum")
    }

    fn either(self, other: Self, is_other: bool, what: &'static str) -> Result<Self, GeomError> {
        if is_other {
            return Ok(other);
        }
        #[expect(clippy::float_cmp, reason = "only where both are one number is there a kink")]
        if self.value() == other.value() && !self.goes_with(&other) {
            return Err(LocalError::NotDifferentiable { what, at: self.value() }.into());
        }
        Ok(self)
    }

    /// Whether two numbers have the same derivatives, so that which of them is larger stays as it is.
    #[must_use]
    pub fn goes_with(&self, other: &Self) -> bool {
        match self.with(other) {
            MatchedReals::Jets(a, b) => a.has_slopes_of(&b),
            MatchedReals::Plain(..) => true,
        }
    }
}

impl From<f64> for Real {
    fn from(value: f64) -> Self {
        Self::Plain(value)
    }
}
