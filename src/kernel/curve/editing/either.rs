//! Edits of a curve of either kind: a NURBS stays one, and a function too.

use glam::DVec3;

use crate::{
    ConstructionError, GeomError, InputError, Interval, Tolerance,
    ceiling::DOMAIN_DOUBLINGS,
    curve::{Curve, Offset, ParametricCurve},
    frame::norm,
};

impl Curve {
    /// The curve beside it at a distance; of a function near its stand-in.
    ///
    /// # Errors
    /// Those of [`crate::curve::NurbsCurve::offset`], and as [`Self::spline`].
    pub fn offset(
        &self,
        distance: f64,
        normal: DVec3,
        tolerance: Tolerance,
    ) -> Result<Offset, GeomError> {
        self.spline()?.offset(distance, normal, tolerance)
    }

    /// The same points run through backwards, on the same domain.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn reversed(&self) -> Result<Self, GeomError> {
        match self {
            Self::Nurbs(curve) => Ok(curve.reversed().into()),
            Self::Parametric(curve) => curve.reversed().map(Self::from),
        }
    }

    /// The same points over another domain.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn reparametrized(&self, domain: Interval) -> Result<Self, GeomError> {
        match self {
            Self::Nurbs(curve) => Ok(curve.reparametrized(domain).into()),
            Self::Parametric(curve) => curve.reparametrized(domain).map(Self::from),
        }
    }

    /// The part over an interval, with the parameters that it had.
    ///
    /// # Errors
    /// `DomainError::ParameterOutside` the domain, `DomainError::NarrowInterval`, and as
    /// [`Self::point_at`].
    pub fn trimmed(&self, interval: Interval) -> Result<Self, GeomError> {
        match self {
            Self::Nurbs(curve) => curve.trimmed(interval).map(Self::from),
            Self::Parametric(curve) => curve.trimmed(interval).map(Self::from),
        }
    }

    /// Both parts at `t`, each on its part of the domain.
    ///
    /// # Errors
    /// `DomainError::ParameterOutside` the domain, `DomainError::ParameterAtEnd` of it, and as
    /// [`Self::point_at`].
    pub fn split(&self, t: f64) -> Result<[Self; 2], GeomError> {
        match self {
            Self::Nurbs(curve) => curve.split(t).map(|parts| parts.map(Self::from)),
            Self::Parametric(curve) => curve.split(t).map(|parts| parts.map(Self::from)),
        }
    }

    /// The curve of the derivative vectors, on the same domain.
    ///
    /// # Errors
    /// Those of [`crate::curve::NurbsCurve::hodograph`], and as [`Self::point_at`].
    pub fn hodograph(&self) -> Result<Self, GeomError> {
        match self {
            Self::Nurbs(curve) => curve.hodograph().map(Self::from),
            Self::Parametric(curve) => curve.hodograph().map(Self::from),
        }
    }

    /// The curve prolonged by a length: a NURBS as its last piece goes on, a function as far as it
    /// has values beyond the domain.
    ///
    /// # Errors
    /// Those of [`crate::curve::NurbsCurve::extended`], and as [`Self::spline`].
    pub fn extended(&self, length: f64) -> Result<Self, GeomError> {
        match self {
            Self::Nurbs(curve) => curve.extended(length).map(Self::from),
            Self::Parametric(curve) => curve.extended(length, 1.0).map(Self::from),
        }
    }

    /// [`Self::extended`] before the start.
    ///
    /// # Errors
    /// Those of [`Self::extended`].
    pub fn extended_at_start(&self, length: f64) -> Result<Self, GeomError> {
        match self {
            Self::Nurbs(curve) => curve.extended_at_start(length).map(Self::from),
            Self::Parametric(curve) => curve.extended(length, -1.0).map(Self::from),
        }
    }
}

impl ParametricCurve {
    /// The curve on a domain that goes on at its end for a sign of 1, at its start for −1, until
    /// it is longer by `length`.
    fn extended(&self, length: f64, sign: f64) -> Result<Self, GeomError> {
        if !(length.is_finite() && 0.0 < length) {
            return Err(InputError::NotPositive { what: "the length", got: length }.into());
        }
        let domain = self.domain();
        let end = if 0.0 < sign { domain.end() } else { domain.start() };
        let speed = norm(self.derivatives_at(end, 1)?[1]);
        let first = length / speed;
        let mut step = if first < domain.length() { first } else { domain.length() };
        // Up to `low` it is `reached` longer, so that each step follows the function only from there.
        let (mut low, mut reached) = (end, 0.0);
        for _ in 0..DOMAIN_DOUBLINGS {
            let far = end + sign * step;
            let beyond = Interval::new(low.min(far), low.max(far))?;
            let rest = self.on(beyond)?.nurbs_approximation()?;
            let more = rest.length(beyond);
            if length <= reached + more {
                let missing = length - reached;
                let from_start = if 0.0 < sign { missing } else { more - missing };
                let t = rest.parameter_at_length(from_start.clamp(0.0, more))?;
                return self.on(match 0.0 < sign {
                    true => Interval::new(domain.start(), t),
                    false => Interval::new(t, domain.end()),
                }?);
            }
            (low, reached) = (far, reached + more);
            step *= 2.0;
        }
        Err(GeomError::Construction(ConstructionError::EndOfContinuation {
            wanted: length,
            reached,
        }))
    }
}
