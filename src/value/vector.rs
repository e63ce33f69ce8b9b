//! Vectors in functions that may be differentiated: as they are, or of jets.

use glam::DVec3;

use super::Real;
use crate::kernel::{GeomError, Jet};

/// A point or vector, or one that carries its derivatives.
#[derive(Clone, Debug, PartialEq)]
pub enum Vector {
    /// Depends on nothing.
    Plain(DVec3),
    /// Coordinates that depend on the parameters of a function that is differentiated.
    Jets(Box<[Jet; 3]>),
}

impl Vector {
    /// The vector of three coordinates.
    #[must_use]
    pub fn new(coordinates: [Real; 3]) -> Self {
        let jet = coordinates.iter().find_map(|coordinate| match coordinate {
            Real::Jet(jet) => Some(jet.clone()),
            Real::Plain(_) => None,
        });
        match jet {
            Some(jet) => Self::Jets(Box::new(coordinates.map(|coordinate| coordinate.like(&jet)))),
            None => Self::Plain(DVec3::from(coordinates.map(|coordinate| coordinate.value()))),
        }
    }

    /// The three coordinates.
    #[must_use]
    pub fn coordinates(&self) -> [Real; 3] {
        match self {
            Self::Plain(vector) => vector.to_array().map(Real::Plain),
            Self::Jets(jets) => jets.as_ref().clone().map(Real::Jet),
        }
    }

    /// The vector alone.
    #[must_use]
    pub fn value(&self) -> DVec3 {
        match self {
            Self::Plain(vector) => *vector,
            Self::Jets(jets) => DVec3::from(jets.each_ref().map(Jet::value)),
        }
    }

    /// The same derivatives about another vector; for one that was computed more exactly.
    #[must_use]
    pub fn with_value(self, vector: DVec3) -> Self {
        match self {
            Self::Plain(_) => Self::Plain(vector),
            Self::Jets(jets) => {
                let [x, y, z] = *jets;
                let exact =
                    [x.with_value(vector.x), y.with_value(vector.y), z.with_value(vector.z)];
                Self::Jets(Box::new(exact))
            }
        }
    }

    /// The largest coefficient of its series by size; of a plain vector its largest coordinate.
    #[must_use]
    pub fn magnitude(&self) -> f64 {
        match self {
            Self::Plain(vector) => vector.abs().max_element(),
            Self::Jets(jets) => jets.iter().map(Jet::magnitude).fold(0.0, f64::max),
        }
    }

    fn zip(&self, other: &Self, f: impl Fn(&Real, &Real) -> Real) -> Self {
        let ([a, b, c], [x, y, z]) = (self.coordinates(), other.coordinates());
        Self::new([f(&a, &x), f(&b, &y), f(&c, &z)])
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        self.zip(other, Real::plus)
    }

    /// The difference.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        self.zip(other, Real::minus)
    }

    /// The product with a number.
    #[must_use]
    pub fn times(&self, factor: &Real) -> Self {
        Self::new(self.coordinates().map(|coordinate| coordinate.times(factor)))
    }

    /// The quotient by a number that is not zero.
    ///
    /// # Errors
    /// As for [`Jet::over`].
    pub fn over(&self, divisor: &Real) -> Result<Self, GeomError> {
        let [x, y, z] = self.coordinates();
        Ok(Self::new([x.over(divisor)?, y.over(divisor)?, z.over(divisor)?]))
    }

    /// The scalar product.
    #[must_use]
    pub fn dot(&self, other: &Self) -> Real {
        let ([a, b, c], [x, y, z]) = (self.coordinates(), other.coordinates());
        a.times(&x).plus(&b.times(&y)).plus(&c.times(&z))
    }

    /// The vector product.
    #[must_use]
    pub fn cross(&self, other: &Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.coordinates(), other.coordinates());
        let minor = |p: &Real, q: &Real, r: &Real, s: &Real| p.times(s).minus(&q.times(r));
        Self::new([minor(&b, &c, &y, &z), minor(&c, &a, &z, &x), minor(&a, &b, &x, &y)])
    }

    /// The length, without overflow on the way.
    ///
    /// # Errors
    /// As for [`Jet::norm`].
    pub fn norm(&self) -> Result<Real, GeomError> {
        let DVec3 { x, y, z } = self.value();
        let length = libm::hypot(libm::hypot(x, y), z);
        Ok(match self {
            Self::Plain(_) => Real::Plain(length),
            Self::Jets(jets) => Real::Jet(Jet::norm(jets.iter())?.with_value(length)),
        })
    }
}
