//! Curves of a function: any map of an interval into space that can tell its derivatives.

use std::{
    any::Any,
    fmt,
    sync::{Arc, OnceLock},
};

use glam::{DAffine3, DVec3};

use crate::{
    DomainError, FunctionFailure, GeomError, Interval, LocalError, Side,
    curve::{NurbsCurve, evaluation::series},
    frame::norm,
    tolerance::{KNOT_RELATIVE, LAST_BIT},
};

/// Even parts of a domain at whose ends a function is tried when a curve is made of it.
const PROBES: usize = 8;

/// The order of derivatives up to which a jump makes a function another one on its left.
const BEND_ORDER: usize = 2;

/// A map of parameters to points.
///
/// The unit circle by its angle, whose derivatives are quarter turns of it:
///
/// ```
/// use std::{f64::consts::{FRAC_PI_2, TAU}, sync::Arc};
/// use virote_kernel::{
///     Curve, CurveFunction, FunctionFailure, Interval, ParametricCurve, Side, glam::DVec3,
/// };
///
/// #[derive(Debug)]
/// struct Circle;
///
/// impl CurveFunction for Circle {
///     fn derivatives_at(&self, t: f64, order: usize) -> Result<Vec<DVec3>, FunctionFailure> {
///         let turned = |k: usize| t + k as f64 * FRAC_PI_2;
///         Ok((0..=order).map(|k| DVec3::new(turned(k).cos(), turned(k).sin(), 0.0)).collect())
///     }
/// }
///
/// let circle = Curve::from(ParametricCurve::new(Interval::new(0.0, TAU)?, Arc::new(Circle))?);
/// assert!((circle.length(circle.domain())? - TAU).abs() < 1e-9);
/// assert!((circle.local_at(1.0, Side::Right)?.curvature()? - 1.0).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
pub trait CurveFunction: fmt::Debug + Send + Sync {
    /// Point and derivatives at `t` by order, `order + 1` of them; exact up to rounding.
    ///
    /// # Errors
    /// Where the function has no such value, in words of its own.
    fn derivatives_at(&self, t: f64, order: usize) -> Result<Vec<DVec3>, FunctionFailure>;

    /// How far points may be off by rounding, beyond the last bits of their coordinates.
    fn rounding(&self) -> f64 {
        0.0
    }
}

/// A curve of a function. Cheap to clone.
///
/// Invariant: the function has a point at both ends of the domain.
///
/// A parabola as a function of jets, which carry the derivatives along:
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{
///     CurveFunction, FunctionFailure, Interval, Jet, ParametricCurve, glam::DVec3,
/// };
///
/// #[derive(Debug)]
/// struct Parabola;
///
/// impl CurveFunction for Parabola {
///     fn derivatives_at(&self, t: f64, order: usize) -> Result<Vec<DVec3>, FunctionFailure> {
///         let x = Jet::variable(t, order);
///         let y = x.times(&x);
///         Ok((0..=order).map(|k| DVec3::new(x.derivative(k, 0), y.derivative(k, 0), 0.0)).collect())
///     }
/// }
///
/// let parabola = ParametricCurve::new(Interval::new(-1.0, 1.0)?, Arc::new(Parabola))?;
/// assert_eq!(parabola.derivatives_at(0.5, 2)?[1], DVec3::new(1.0, 1.0, 0.0));
/// let spline = parabola.to_nurbs(1e-9)?;
/// assert!(spline.point_at(0.5).distance(DVec3::new(0.5, 0.25, 0.0)) < 1e-9);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct ParametricCurve {
    domain: Interval,
    function: Arc<dyn CurveFunction>,
    /// Where the parameter has been moved to since.
    pace: CurveParameterMap,
    /// Where space has been moved to since.
    map: DAffine3,
    /// Points at even steps of the domain.
    probes: [DVec3; PROBES + 1],
    /// The spline near it, once it was made.
    nurbs_approximation: Arc<OnceLock<Arc<NurbsCurve>>>,
    /// What the function may need to answer.
    _kept: Option<Arc<dyn Any + Send + Sync>>,
}

/// An even map of parameters, exact where it is known: `to[0]` at `from[0]`, `to[1]` at `from[1]`.
#[derive(Clone, Copy, Debug, PartialEq)]
enum CurveParameterMap {
    Same,
    Even { from: [f64; 2], to: [f64; 2] },
}

impl CurveParameterMap {
    fn at(self, t: f64) -> f64 {
        match self {
            Self::Same => t,
            Self::Even { from, to } => {
                let fraction = (t - from[0]) / (from[1] - from[0]);
                to[0] * (1.0 - fraction) + to[1] * fraction
            }
        }
    }

    fn slope(self) -> f64 {
        match self {
            Self::Same => 1.0,
            Self::Even { from, to } => (to[1] - to[0]) / (from[1] - from[0]),
        }
    }
}

impl ParametricCurve {
    /// The curve of a function on a domain; the function is tried at the ends and at places
    /// between them.
    ///
    /// # Errors
    /// [`GeomError::Function`] where the function fails, [`LocalError::BeyondNumbers`].
    pub fn new(domain: Interval, function: Arc<dyn CurveFunction>) -> Result<Self, GeomError> {
        Self {
            domain,
            function,
            pace: CurveParameterMap::Same,
            map: DAffine3::IDENTITY,
            probes: [DVec3::ZERO; PROBES + 1],
            nurbs_approximation: Arc::default(),
            _kept: None,
        }
        .probed()
    }

    /// The same with its points known.
    fn probed(mut self) -> Result<Self, GeomError> {
        for (i, t) in self.domain.steps(PROBES).into_iter().enumerate() {
            self.probes[i] = self.point_at(t)?;
        }
        self.nurbs_approximation = Arc::default();
        Ok(self)
    }

    /// The parameters that have a point.
    #[must_use]
    pub fn domain(&self) -> Interval {
        self.domain
    }

    /// The function itself.
    #[must_use]
    pub fn function(&self) -> &Arc<dyn CurveFunction> {
        &self.function
    }

    /// How far points may be off by the function's own rounding.
    pub(in crate::curve) fn rounding(&self) -> f64 {
        let columns = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| norm(self.map.matrix3 * axis));
        self.function.rounding() * columns.into_iter().fold(0.0, f64::max)
    }

    /// The point at the start of the domain.
    #[must_use]
    pub fn start(&self) -> DVec3 {
        self.probes[0]
    }

    /// The point at the end of the domain.
    #[must_use]
    pub fn end(&self) -> DVec3 {
        self.probes[PROBES]
    }

    /// Points at nine even steps of the domain.
    pub(in crate::curve) fn probes(&self) -> &[DVec3] {
        &self.probes
    }

    /// Point at parameter `t`.
    ///
    /// # Errors
    /// As [`Self::derivatives_at`].
    pub fn point_at(&self, t: f64) -> Result<DVec3, GeomError> {
        Ok(self.derivatives_at(t, 0)?[0])
    }

    /// Point and derivatives at `t` by order, `order + 1` of them.
    ///
    /// # Errors
    /// [`GeomError::Function`] where the function fails, [`LocalError::BeyondNumbers`] where a
    /// coordinate overflows.
    pub fn derivatives_at(&self, t: f64, order: usize) -> Result<Vec<DVec3>, GeomError> {
        let mut derivatives = self.function.derivatives_at(self.pace.at(t), order)?;
        let (slope, mut factor) = (self.pace.slope(), 1.0);
        for (k, derivative) in derivatives.iter_mut().enumerate() {
            *derivative = match k {
                0 => self.map.transform_point3(*derivative),
                _ => self.map.transform_vector3(*derivative) * factor,
            };
            factor *= slope;
        }
        match derivatives.iter().position(|derivative| !derivative.is_finite()) {
            Some(order) => Err(GeomError::Local(LocalError::BeyondNumbers { order, parameter: t })),
            None => Ok(derivatives),
        }
    }

    /// Whether it keeps something alive for its function.
    #[must_use]
    pub fn is_keeping(&self) -> bool {
        self._kept.is_some()
    }

    /// The same curve, which keeps something alive that its function needs, as do all that are made of it.
    #[must_use]
    pub fn keeping(&self, kept: Arc<dyn Any + Send + Sync>) -> Self {
        Self { _kept: Some(kept), ..self.clone() }
    }

    /// The image under an affine map.
    #[must_use]
    pub fn transformed(&self, map: &DAffine3) -> Self {
        Self {
            map: *map * self.map,
            probes: self.probes.map(|point| map.transform_point3(point)),
            nurbs_approximation: Arc::default(),
            ..self.clone()
        }
    }

    /// The same points run through backwards, on the same domain.
    ///
    /// # Errors
    /// As [`Self::derivatives_at`].
    pub fn reversed(&self) -> Result<Self, GeomError> {
        let (start, end) = (self.domain.start(), self.domain.end());
        let pace = CurveParameterMap::Even {
            from: [start, end],
            to: [self.pace.at(end), self.pace.at(start)],
        };
        Self { pace, ..self.clone() }.probed()
    }

    /// The same points over another domain.
    ///
    /// # Errors
    /// As [`Self::derivatives_at`].
    pub fn reparametrized(&self, domain: Interval) -> Result<Self, GeomError> {
        let ends = [self.domain.start(), self.domain.end()];
        let pace = CurveParameterMap::Even {
            from: [domain.start(), domain.end()],
            to: ends.map(|end| self.pace.at(end)),
        };
        Self { domain, pace, ..self.clone() }.probed()
    }

    /// The part over an interval, with the parameters that it had.
    ///
    /// # Errors
    /// [`DomainError::ParameterOutside`] the domain, [`DomainError::NarrowInterval`], and as
    /// [`Self::derivatives_at`].
    pub fn trimmed(&self, interval: Interval) -> Result<Self, GeomError> {
        let inside = |t: f64| self.domain.clamp_inside(t);
        let (start, end) = (inside(interval.start())?, inside(interval.end())?);
        if end - start <= KNOT_RELATIVE * self.domain.length() {
            return Err(DomainError::NarrowInterval { start, end }.into());
        }
        self.on(Interval::new(start, end)?)
    }

    /// Where the function is asked for its piece on one side of `t`: what a condition decides at a parameter holds
    /// from there on, so that where derivatives jump the left side is asked just before.
    pub(in crate::curve) fn beside(&self, t: f64, side: Side) -> f64 {
        let is_inside = self.domain.start() < t && t < self.domain.end();
        if side == Side::Right || !is_inside {
            return t;
        }
        let length = self.domain.length();
        let before = t - 2.0 * LAST_BIT * length.max(t.abs());
        let [here, there] = [t, before].map(|t| self.derivatives_at(t, BEND_ORDER));
        let jumps = match (here, there) {
            (Ok(here), Ok(there)) => {
                let powers = || series::powers(length);
                let sizes = there.iter().zip(powers()).map(|(d, power)| norm(*d) * power);
                let size: f64 = sizes.sum();
                let pairs = here.iter().zip(&there).zip(powers());
                let mut apart = pairs.map(|((a, b), power)| norm(*a - *b) * power);
                apart.any(|apart| LAST_BIT.sqrt() * size < apart)
            }
            (here, there) => here.is_err() && there.is_ok(),
        };
        if jumps { before } else { t }
    }

    /// Both parts at `t`, each on its part of the domain.
    ///
    /// # Errors
    /// [`DomainError::ParameterOutside`] the domain, [`DomainError::ParameterAtEnd`] of it, and as
    /// [`Self::derivatives_at`].
    pub fn split(&self, t: f64) -> Result<[Self; 2], GeomError> {
        let (domain, t) = (self.domain, self.domain.clamp_inside(t)?);
        let near = KNOT_RELATIVE * domain.length();
        if t - domain.start() <= near || domain.end() - t <= near {
            return Err(DomainError::ParameterAtEnd { parameter: t, domain }.into());
        }
        let parts = [Interval::new(domain.start(), t)?, Interval::new(t, domain.end())?];
        Ok([self.on(parts[0])?, self.on(parts[1])?])
    }

    /// The curve of the derivative vectors, on the same domain.
    ///
    /// # Errors
    /// As [`Self::derivatives_at`].
    pub fn hodograph(&self) -> Result<Self, GeomError> {
        Self::new(self.domain, Arc::new(Hodograph(self.clone())))
    }

    /// The curve of the function on another domain, also beyond its own.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub(in crate::curve) fn on(&self, domain: Interval) -> Result<Self, GeomError> {
        Self { domain, ..self.clone() }.probed()
    }

    /// The spline near the curve, where it was made before.
    pub(in crate::curve) fn known_stand_in(&self) -> Option<Arc<NurbsCurve>> {
        self.nurbs_approximation.get().map(Arc::clone)
    }

    /// Keeps the spline near the curve for the next question.
    pub(in crate::curve) fn keep_stand_in(&self, spline: NurbsCurve) -> Arc<NurbsCurve> {
        // Another thread may have been first, with the same spline.
        Arc::clone(self.nurbs_approximation.get_or_init(|| Arc::new(spline)))
    }
}

/// The derivative of a curve.
#[derive(Debug)]
struct Hodograph(ParametricCurve);

impl CurveFunction for Hodograph {
    fn derivatives_at(&self, t: f64, order: usize) -> Result<Vec<DVec3>, FunctionFailure> {
        let mut derivatives = self.0.derivatives_at(t, order + 1).map_err(FunctionFailure::new)?;
        derivatives.remove(0);
        Ok(derivatives)
    }
}

/// Curves are equal when they are one function in memory, moved alike.
impl PartialEq for ParametricCurve {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.function, &other.function)
            && self.domain == other.domain
            && self.pace == other.pace
            && self.map == other.map
    }
}
