//! Elementary functions of jets.
//!
//! All fail with [`LocalError::NotDifferentiable`] at a place where the function has a value but
//! not the derivatives, or has no value; and with [`LocalError::DerivativeBeyondNumbers`].

use super::{Jet, JetShape, JetTerms, series};
use crate::{GeomError, LocalError};

type JetResult = Result<Jet, GeomError>;

fn no_derivative(what: &'static str, at: f64) -> JetResult {
    Err(GeomError::Local(LocalError::NotDifferentiable { what, at }))
}

impl Jet {
    /// A constant power.
    ///
    /// # Errors
    /// Below zero for an exponent that is not whole; at zero where a derivative up to the order
    /// is infinite.
    pub fn power(&self, exponent: f64) -> JetResult {
        let (x, order) = (self.value(), self.order());
        let is_whole = exponent.fract() == 0.0;
        if x == 0.0 {
            // The k-th derivative at zero vanishes for k below the exponent.
            if exponent < 0.0 || (!is_whole && exponent < order as f64) {
                return no_derivative("the power", x);
            }
            let term =
                |k: usize| if (k as f64 - exponent).abs() < 0.5 && is_whole { 1.0 } else { 0.0 };
            return self.compose(&(0..=order).map(term).collect::<JetTerms>());
        }
        if x < 0.0 && !is_whole {
            return no_derivative("the power", x);
        }
        self.compose(&series::power(x, libm::pow(x, exponent), exponent, order))
    }

    /// The power to an exponent that varies, eᵉˡⁿˣ.
    ///
    /// # Errors
    /// At zero and below.
    pub fn power_of(&self, exponent: &Self) -> JetResult {
        if self.value() <= 0.0 {
            return no_derivative("a power whose exponent varies", self.value());
        }
        exponent.times(&self.ln()?).exp()
    }

    /// The square root.
    ///
    /// # Errors
    /// At zero and below.
    pub fn sqrt(&self) -> JetResult {
        let x = self.value();
        if x <= 0.0 {
            return no_derivative("the square root", x);
        }
        self.compose(&series::power(x, x.sqrt(), 0.5, self.order()))
    }

    /// The cube root.
    ///
    /// # Errors
    /// At zero.
    pub fn cbrt(&self) -> JetResult {
        let x = self.value();
        if x == 0.0 {
            return no_derivative("the cube root", x);
        }
        self.compose(&series::power(x, libm::cbrt(x), 1.0 / 3.0, self.order()))
    }

    /// The exponential function.
    ///
    /// # Errors
    /// On overflow alone.
    pub fn exp(&self) -> JetResult {
        self.compose(&series::cyclic([libm::exp(self.value()); 4], self.order()))
    }

    /// The natural logarithm.
    ///
    /// # Errors
    /// At zero and below.
    pub fn ln(&self) -> JetResult {
        if self.value() <= 0.0 {
            return no_derivative("the logarithm", self.value());
        }
        self.compose(&series::ln(self.value(), self.order()))
    }

    /// The logarithm to the base ten.
    ///
    /// # Errors
    /// At zero and below.
    pub fn log10(&self) -> JetResult {
        Ok(self.ln()?.scaled(std::f64::consts::LOG10_E))
    }

    /// The sine of radians.
    ///
    /// # Errors
    /// On overflow alone.
    pub fn sin(&self) -> JetResult {
        let (sine, cosine) = libm::sincos(self.value());
        self.compose(&series::cyclic([sine, cosine, -sine, -cosine], self.order()))
    }

    /// The cosine of radians.
    ///
    /// # Errors
    /// On overflow alone.
    pub fn cos(&self) -> JetResult {
        let (sine, cosine) = libm::sincos(self.value());
        self.compose(&series::cyclic([cosine, -sine, -cosine, sine], self.order()))
    }

    /// The tangent of radians.
    ///
    /// # Errors
    /// On overflow alone.
    pub fn tan(&self) -> JetResult {
        self.compose(&series::tangent(libm::tan(self.value()), 1.0, self.order()))
    }

    /// The angle with this sine.
    ///
    /// # Errors
    /// At −1 and 1, and beyond.
    pub fn asin(&self) -> JetResult {
        if 1.0 <= self.value().abs() {
            return no_derivative("the arc sine", self.value());
        }
        self.compose(&series::asin(self.value(), self.order()))
    }

    /// The angle with this cosine.
    ///
    /// # Errors
    /// At −1 and 1, and beyond.
    pub fn acos(&self) -> JetResult {
        if 1.0 <= self.value().abs() {
            return no_derivative("the arc cosine", self.value());
        }
        let asin = self.compose(&series::asin(self.value(), self.order()))?;
        Ok(asin.scaled(-1.0).with_value(libm::acos(self.value())))
    }

    /// The angle with this tangent.
    ///
    /// # Errors
    /// On overflow alone.
    pub fn atan(&self) -> JetResult {
        self.compose(&series::atan(self.value(), self.order()))
    }

    /// The angle of the direction (x, `self`).
    ///
    /// # Errors
    /// Where both are zero.
    pub fn atan2(&self, x: &Self) -> JetResult {
        let size = self.value().abs().max(x.value().abs());
        if size == 0.0 {
            return no_derivative("the angle of a direction", size);
        }
        // The angle against the direction at the place, which is zero there.
        let (sine, cosine) = (self.value() / size, x.value() / size);
        let (y, x) = (self.scaled(1.0 / size), x.scaled(1.0 / size));
        let along = x.scaled(cosine).plus(&y.scaled(sine));
        let across = y.scaled(cosine).minus(&x.scaled(sine)).with_value(0.0);
        Ok(across.over(&along)?.atan()?.with_value(libm::atan2(sine, cosine)))
    }

    /// The hyperbolic sine.
    ///
    /// # Errors
    /// On overflow alone.
    pub fn sinh(&self) -> JetResult {
        let (sine, cosine) = (libm::sinh(self.value()), libm::cosh(self.value()));
        self.compose(&series::cyclic([sine, cosine, sine, cosine], self.order()))
    }

    /// The hyperbolic cosine.
    ///
    /// # Errors
    /// On overflow alone.
    pub fn cosh(&self) -> JetResult {
        let (sine, cosine) = (libm::sinh(self.value()), libm::cosh(self.value()));
        self.compose(&series::cyclic([cosine, sine, cosine, sine], self.order()))
    }

    /// The hyperbolic tangent.
    ///
    /// # Errors
    /// On overflow alone.
    pub fn tanh(&self) -> JetResult {
        self.compose(&series::tangent(libm::tanh(self.value()), -1.0, self.order()))
    }

    /// The magnitude.
    ///
    /// # Errors
    /// At zero.
    pub fn abs(&self) -> JetResult {
        match self.value() {
            x if 0.0 < x => Ok(self.clone()),
            x if x < 0.0 => Ok(self.scaled(-1.0)),
            x => no_derivative("the magnitude", x),
        }
    }

    /// The scalar product of vectors.
    #[must_use]
    pub fn dot(a: &[Self; 3], b: &[Self; 3]) -> Self {
        if let JetShape::Several { .. } = a[0].shape
            && a.iter().chain(b).all(|jet| jet.shape == a[0].shape)
        {
            let [of_a, of_b] = [a, b].map(|all| [0, 1, 2].map(|axis: usize| all[axis].value()));
            let coefficient = |i: usize| {
                let [x, y, z] = [0, 1, 2].map(|axis: usize| match i {
                    0 => of_a[axis] * of_b[axis],
                    i => {
                        let [own, other] = [a, b].map(|all| all[axis].coefficients[i]);
                        own * of_b[axis] + of_a[axis] * other
                    }
                });
                x + y + z
            };
            let coefficients = (0..a[0].coefficients.len()).map(coefficient).collect();
            return Self { shape: a[0].shape, coefficients };
        }
        let [x, y, z] = [0, 1, 2].map(|axis| a[axis].times(&b[axis]));
        x.plus(&y).plus(&z)
    }

    /// The length of a vector of jets, without overflow on the way.
    ///
    /// # Errors
    /// Where it is zero.
    pub fn norm<'j>(coordinates: impl Iterator<Item = &'j Self> + Clone) -> JetResult {
        let size = coordinates.clone().map(|jet| jet.value().abs()).fold(0.0, f64::max);
        if size == 0.0 {
            return no_derivative("the length of a vector", size);
        }
        // Along an axis it is a magnitude, whose derivatives rounding does not touch, however near zero it is.
        let mut others =
            coordinates.clone().filter(|jet| !jet.coefficients().iter().all(|&c| c == 0.0));
        if let (Some(only), None) = (others.next(), others.next()) {
            return only.abs();
        }
        let squares = coordinates.map(|jet| jet.scaled(1.0 / size)).map(|jet| jet.times(&jet));
        let Some(sum) = squares.reduce(|sum, square| sum.plus(&square)) else {
            unreachable!("without coordinates the size is zero")
        };
        Ok(sum.sqrt()?.scaled(size))
    }
}
