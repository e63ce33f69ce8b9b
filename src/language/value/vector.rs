//! Vectors in functions that may be differentiated: as they are, or of jets.

use std::borrow::Cow;

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

/// Two vectors brought to one form.
enum MatchedVectors<'a> {
    Plain(DVec3, DVec3),
    Jets(Cow<'a, [Jet; 3]>, Cow<'a, [Jet; 3]>),
}

impl Vector {
    /// The vector of three coordinates.
    #[must_use]
    pub fn new(coordinates: [Real; 3]) -> Self {
        let still = coordinates.iter().find_map(|coordinate| match coordinate {
            Real::Jet(jet) => Some(jet.same(0.0)),
            Real::Plain(_) => None,
        });
        let Some(still) = still else {
            return Self::Plain(DVec3::from(coordinates.map(|coordinate| coordinate.value())));
        };
        Self::Jets(Box::new(coordinates.map(|coordinate| match coordinate {
            Real::Jet(jet) => jet,
            Real::Plain(number) => still.same(number),
        })))
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

    /// Both as vectors of jets, unless both are plain.
    fn with<'a>(&'a self, other: &'a Self) -> MatchedVectors<'a> {
        let like = |vector: &DVec3, jets: &[Jet; 3]| {
            Cow::Owned(vector.to_array().map(|coordinate| jets[0].same(coordinate)))
        };
        match (self, other) {
            (Self::Plain(a), Self::Plain(b)) => MatchedVectors::Plain(*a, *b),
            (Self::Jets(a), Self::Jets(b)) => {
                MatchedVectors::Jets(Cow::Borrowed(&**a), Cow::Borrowed(&**b))
            }
            (Self::Jets(a), Self::Plain(b)) => {
                MatchedVectors::Jets(Cow::Borrowed(&**a), like(b, a))
            }
            (Self::Plain(a), Self::Jets(b)) => {
                MatchedVectors::Jets(like(a, b), Cow::Borrowed(&**b))
            }
        }
    }

    fn of_jets(coordinate: impl FnMut(usize) -> Jet) -> Self {
        Self::Jets(Box::new([0, 1, 2].map(coordinate)))
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        match self.with(other) {
            MatchedVectors::Plain(a, b) => Self::Plain(a + b),
            MatchedVectors::Jets(a, b) => Self::of_jets(|axis| a[axis].plus(&b[axis])),
        }
    }

    /// The difference.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        match self.with(other) {
            MatchedVectors::Plain(a, b) => Self::Plain(a - b),
            MatchedVectors::Jets(a, b) => Self::of_jets(|axis| a[axis].minus(&b[axis])),
        }
    }

    /// The product with a number.
    #[must_use]
    pub fn times(&self, factor: &Real) -> Self {
        match (self, factor) {
            (Self::Plain(vector), Real::Plain(factor)) => Self::Plain(*vector * *factor),
            (Self::Plain(vector), Real::Jet(factor)) => {
                Self::of_jets(|axis| factor.same(vector[axis]).times(factor))
            }
            (Self::Jets(jets), Real::Plain(factor)) => {
                Self::of_jets(|axis| jets[axis].scaled(*factor))
            }
            (Self::Jets(jets), Real::Jet(factor)) => Self::of_jets(|axis| jets[axis].times(factor)),
        }
    }

    /// The quotient by a number that is not zero.
    ///
    /// # Errors
    /// As for [`Jet::over`].
    pub fn over(&self, divisor: &Real) -> Result<Self, GeomError> {
        let [x, y, z] = self.coordinates();
        Ok(Self::new([x.over(divisor)?, y.over(divisor)?, z.over(divisor)?]))
    }

    /// The scalar product of plain vectors.
    #[must_use]
    pub fn plain_dot(a: DVec3, b: DVec3) -> f64 {
        a.x * b.x + a.y * b.y + a.z * b.z
    }

    /// The vector product of plain vectors.
    #[must_use]
    pub fn plain_cross(a: DVec3, b: DVec3) -> DVec3 {
        DVec3::new(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)
    }

    /// The length of a plain vector, without overflow on the way.
    #[must_use]
    pub fn plain_norm(vector: DVec3) -> f64 {
        libm::hypot(libm::hypot(vector.x, vector.y), vector.z)
    }

    /// The scalar product.
    #[must_use]
    pub fn dot(&self, other: &Self) -> Real {
        match self.with(other) {
            MatchedVectors::Plain(a, b) => Real::Plain(Self::plain_dot(a, b)),
            MatchedVectors::Jets(a, b) => Real::Jet(Jet::dot(&a, &b)),
        }
    }

    /// The vector product.
    #[must_use]
    pub fn cross(&self, other: &Self) -> Self {
        match self.with(other) {
            MatchedVectors::Plain(a, b) => Self::Plain(Self::plain_cross(a, b)),
            MatchedVectors::Jets(a, b) => {
                let minor = |p: usize, q: usize| a[p].times(&b[q]).minus(&a[q].times(&b[p]));
                Self::Jets(Box::new([minor(1, 2), minor(2, 0), minor(0, 1)]))
            }
        }
    }

    /// The length, without overflow on the way.
    ///
    /// # Errors
    /// As for [`Jet::norm`].
    pub fn norm(&self) -> Result<Real, GeomError> {
        let length = Self::plain_norm(self.value());
        Ok(match self {
            Self::Plain(_) => Real::Plain(length),
            Self::Jets(jets) => Real::Jet(Jet::norm(jets.iter())?.with_value(length)),
        })
    }
}
