//! The shape of a curve at one parameter, told from its derivative vectors alone.
//!
//! C' is a power of the parameter times a series V that does not vanish; V gives the tangent, and
//! its direction differentiated by arc length, once and twice, gives curvature and torsion. Where
//! the curve stands still these are limits, so that the shape decides and not the parameter. do
//! Carmo, *Differential Geometry of Curves and Surfaces*, §1-5.

use glam::DVec3;

use crate::{
    Frame, GeomError, LocalError, Side,
    curve::{
        CircleForm, NurbsCurve,
        evaluation::series::{self, Terms},
    },
    frame::norm,
    scale::scale_of,
};

/// Where a curve is looked at, and which lengths are rounding there.
///
/// The derivatives of (t, t²) at 0 tell the curvature 2, wherever they come from:
///
/// ```
/// use virote_kernel::{EvaluationPlace, LocalGeometry, Side, glam::DVec3};
///
/// let derivatives = [DVec3::ZERO, DVec3::X, DVec3::new(0.0, 2.0, 0.0), DVec3::ZERO];
/// let place = EvaluationPlace {
///     parameter: 0.0,
///     side: Side::Right,
///     reach: 1.0,
///     rounding: 1e-15,
///     growth: 4.0,
///     slack: 0.0,
/// };
/// assert_eq!(LocalGeometry::new(&derivatives, place)?.curvature()?, 2.0);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct EvaluationPlace {
    /// The parameter.
    pub parameter: f64,
    /// The side from which it is approached.
    pub side: Side,
    /// How far an expansion there reaches in the parameter: the width of the span.
    pub reach: f64,
    /// The length that rounding of the coordinates may leave in a first derivative over the reach.
    pub rounding: f64,
    /// By how much that grows with every further derivative.
    pub growth: f64,
    /// A parameter that is off by this fraction of the reach counts as the place itself: 0 to look
    /// exactly there.
    pub slack: f64,
}

impl EvaluationPlace {
    /// The terms of the Taylor series over the reach, which are lengths.
    pub(in crate::curve) fn terms(&self, derivatives: &[DVec3]) -> Terms<DVec3> {
        derivatives.iter().zip(series::powers(self.reach)).map(|(&d, power)| d * power).collect()
    }

    /// The index of the first term from `start` on that is more than rounding.
    pub(in crate::curve) fn first(
        &self,
        terms: &[DVec3],
        start: usize,
        order: usize,
    ) -> Option<usize> {
        (start..terms.len()).find(|&k| {
            let next = terms.get(k + 1).map_or(0.0, |&term| norm(term));
            self.rounding_of(order + k).max(self.slack * next) < norm(terms[k])
        })
    }

    /// The length that rounding may leave in the term of an order.
    pub(in crate::curve) fn rounding_of(&self, order: usize) -> f64 {
        self.rounding * libm::pow(self.growth, order.saturating_sub(1) as f64)
    }
}

/// Tangent, bending and its change at one parameter, from one side.
///
/// The parabola y = x² bends by 2 at its vertex:
///
/// ```
/// use virote_kernel::{Curve, NurbsCurve, Side, glam::DVec3};
///
/// let corners = [(-1.0, 1.0), (0.0, -1.0), (1.0, 1.0)];
/// let parabola = NurbsCurve::bezier(&corners.map(|(x, y)| DVec3::new(x, y, 0.0)))?;
/// let vertex = Curve::from(parabola).local_at(0.5, Side::Right)?;
/// assert!((vertex.curvature()? - 2.0).abs() < 1e-14);
/// assert!(vertex.center_of_curvature()?.distance(DVec3::new(0.0, 0.5, 0.0)) < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct LocalGeometry {
    parameter: f64,
    point: DVec3,
    tangent: DVec3,
    extent: f64,
    bending: Option<DVec3>,
    /// The derivative of `bending` by arc length, times `scale`.
    bending_slope: Option<DVec3>,
    /// A power of two near the extent, where its square is no number.
    scale: f64,
}

impl LocalGeometry {
    /// The shape that derivatives by order, from order 0, tell about.
    ///
    /// Four of them are enough where the first one does not vanish; where m − 1 vanish, 3m + 1
    /// are, and with fewer there is a tangent only.
    ///
    /// # Errors
    /// [`LocalError::VanishingTangent`] where all but order 0 vanish.
    pub fn new(derivatives: &[DVec3], around: EvaluationPlace) -> Result<Self, GeomError> {
        let parameter = around.parameter;
        let terms = around.terms(derivatives);
        let standing = GeomError::Local(LocalError::VanishingTangent { parameter });
        let first = around.first(&terms, 1, 0).ok_or(standing.clone())?;
        let extent = norm(terms[first]);

        // The velocity without the power of the parameter that vanishes, in units of the extent.
        let velocity: Terms<DVec3> =
            (first..terms.len()).map(|k| terms[k] / extent * k as f64).collect();
        let speed = series::norms(&velocity);
        let direction = series::quotient(&velocity, &speed);
        // Before the place an odd power of the parameter is negative.
        let sign = if around.side == Side::Left && first.is_multiple_of(2) { -1.0 } else { 1.0 };
        let by_length = |terms: &[DVec3], order: usize| {
            let slope = series::derivative(terms);
            let vanishing = slope.get(..first - 1)?;
            let is_rounding =
                |(j, &term): (usize, &DVec3)| norm(term) * extent <= around.rounding_of(order + j);
            let is_bounded = vanishing.iter().enumerate().all(is_rounding);
            is_bounded.then(|| series::quotient(&slope[first - 1..], &speed))
        };

        let bending = by_length(&direction, first + 1);
        let slope = bending.as_ref().and_then(|bending| by_length(bending, 2 * first + 1));
        let leading = |terms: Option<Terms<DVec3>>| terms.and_then(|terms| terms.first().copied());
        let (bending, slope) = (leading(bending), leading(slope));
        let scale = scale_of(extent);
        let is_straight = |k: DVec3| norm(k) * extent <= around.rounding_of(2 * first);
        Some(Self {
            parameter,
            point: derivatives[0],
            tangent: sign * direction[0],
            extent,
            bending: bending
                .map(|k| if is_straight(k) { DVec3::ZERO } else { k / extent })
                .filter(|k| k.is_finite()),
            bending_slope: slope
                .map(|k| sign * k / (extent / scale) / extent)
                .filter(|k| k.is_finite()),
            scale,
        })
        .filter(|found| found.tangent.is_finite())
        .ok_or(standing)
    }

    /// The point.
    #[must_use]
    pub fn point(&self) -> DVec3 {
        self.point
    }

    /// Unit tangent, in the direction of growing parameters; a limit where the curve stands still.
    #[must_use]
    pub fn tangent(&self) -> DVec3 {
        self.tangent
    }

    /// The length over which the shape was looked at.
    pub(in crate::curve) fn extent(&self) -> f64 {
        self.extent
    }

    /// Derivative of the tangent by arc length: towards the centre of curvature, as long as the
    /// curvature is large. `None` where it has no bound.
    #[must_use]
    pub fn curvature_vector(&self) -> Option<DVec3> {
        self.bending
    }

    /// Derivative of the curvature vector by arc length; `None` where it has no bound.
    #[must_use]
    pub fn curvature_slope(&self) -> Option<DVec3> {
        self.bending_slope.map(|slope| slope / self.scale).filter(|slope| slope.is_finite())
    }

    /// Curvature, not negative; 0 where the curve is straight.
    ///
    /// # Errors
    /// [`LocalError::UnboundedCurvature`] at cusps and other places where the curve stands still.
    pub fn curvature(&self) -> Result<f64, GeomError> {
        self.bending.map(norm).ok_or_else(|| self.unbounded("curvature"))
    }

    /// Principal unit normal, towards the centre of curvature.
    ///
    /// # Errors
    /// [`LocalError::Straight`], [`LocalError::UnboundedCurvature`].
    pub fn normal(&self) -> Result<DVec3, GeomError> {
        Ok(self.bent("principal normal")? / self.curvature()?)
    }

    /// Unit binormal, tangent × normal.
    ///
    /// # Errors
    /// [`LocalError::Straight`], [`LocalError::UnboundedCurvature`].
    pub fn binormal(&self) -> Result<DVec3, GeomError> {
        Ok(self.frame_for("binormal")?.z())
    }

    /// The moving trihedron of Frenet: tangent, principal normal, binormal.
    ///
    /// # Errors
    /// [`LocalError::Straight`], [`LocalError::UnboundedCurvature`].
    pub fn frame(&self) -> Result<Frame, GeomError> {
        self.frame_for("frame")
    }

    /// The frame, for a question that an error names.
    ///
    /// # Errors
    /// [`LocalError::Straight`], [`LocalError::UnboundedCurvature`].
    pub fn frame_for(&self, what: &'static str) -> Result<Frame, GeomError> {
        Frame::of_curve(self.point, self.tangent, self.bent(what)?)
    }

    /// Torsion: how fast the osculating plane turns about the tangent; positive for a right-handed
    /// screw.
    ///
    /// # Errors
    /// [`LocalError::Straight`], [`LocalError::UnboundedCurvature`].
    pub fn torsion(&self) -> Result<f64, GeomError> {
        let (binormal, curvature) = (self.frame_for("torsion")?.z(), norm(self.bent("torsion")?));
        let slope = self.bending_slope.ok_or_else(|| self.unbounded("torsion"))?;
        Ok(binormal.dot(slope) / (curvature * self.scale))
    }

    /// Radius of the osculating circle.
    ///
    /// # Errors
    /// [`LocalError::Straight`], [`LocalError::UnboundedCurvature`].
    pub fn radius_of_curvature(&self) -> Result<f64, GeomError> {
        Ok(1.0 / norm(self.bent("radius of curvature")?))
    }

    /// Centre of the osculating circle.
    ///
    /// # Errors
    /// [`LocalError::Straight`], [`LocalError::UnboundedCurvature`].
    pub fn center_of_curvature(&self) -> Result<DVec3, GeomError> {
        let bending = self.bent("centre of curvature")?;
        let curvature = norm(bending);
        Ok(self.point + bending / curvature / curvature)
    }

    /// The circle that agrees with the curve up to the second derivative, from the point in the
    /// direction of the tangent.
    ///
    /// # Errors
    /// [`LocalError::Straight`], [`LocalError::UnboundedCurvature`].
    pub fn osculating_circle(&self) -> Result<NurbsCurve, GeomError> {
        let (frame, radius) = (self.frame_for("osculating circle")?, self.radius_of_curvature()?);
        let center = self.center_of_curvature()?;
        NurbsCurve::circle(center, radius, -frame.y(), frame.z(), CircleForm::NinePoint)
    }

    /// The plane normal to the tangent; x is the principal normal, where there is one.
    ///
    /// # Errors
    /// `InputError::NotFinite`.
    pub fn normal_plane(&self) -> Result<Frame, GeomError> {
        Frame::from_normal(self.point, self.tangent, self.normal().ok())
    }

    /// The plane of tangent and principal normal; x is the tangent.
    ///
    /// # Errors
    /// [`LocalError::Straight`], [`LocalError::UnboundedCurvature`].
    pub fn osculating_plane(&self) -> Result<Frame, GeomError> {
        let frame = self.frame_for("osculating plane")?;
        Frame::from_axes(self.point, frame.x(), frame.y())
    }

    /// The plane of binormal and tangent; x is the binormal.
    ///
    /// # Errors
    /// [`LocalError::Straight`], [`LocalError::UnboundedCurvature`].
    pub fn rectifying_plane(&self) -> Result<Frame, GeomError> {
        let frame = self.frame_for("rectifying plane")?;
        Frame::from_axes(self.point, frame.z(), frame.x())
    }

    /// Curvature with the sign of the turn about a unit normal: positive counter-clockwise as seen
    /// from its tip.
    ///
    /// # Errors
    /// [`LocalError::UnboundedCurvature`]; [`LocalError::NoSide`] where the curve bends in a plane that holds
    /// the normal, to within an angle.
    pub fn signed_curvature(&self, normal: DVec3, angle: f64) -> Result<f64, GeomError> {
        let bending = self.bending.ok_or_else(|| self.unbounded("curvature"))?;
        let curvature = norm(bending);
        let turn = self.tangent.cross(bending).dot(normal);
        if curvature <= 0.0 {
            return Ok(0.0);
        }
        if turn.abs() <= angle * curvature {
            return Err(LocalError::NoSide { parameter: self.parameter, normal }.into());
        }
        Ok(curvature.copysign(turn))
    }

    /// The curvature vector, for a question that needs it to be more than zero.
    fn bent(&self, what: &'static str) -> Result<DVec3, GeomError> {
        let bending = self.bending.ok_or_else(|| self.unbounded(what))?;
        if bending.abs().max_element() <= 0.0 {
            return Err(LocalError::Straight { what, parameter: self.parameter }.into());
        }
        Ok(bending)
    }

    fn unbounded(&self, what: &'static str) -> GeomError {
        GeomError::Local(LocalError::UnboundedCurvature { what, parameter: self.parameter })
    }
}
