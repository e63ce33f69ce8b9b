//! Tangents and curvature of curves.

use glam::DVec3;

use super::NurbsCurve;
use crate::kernel::{GeomError, Side, frame::unit, homogeneous, tolerance::VANISHING_RELATIVE};

impl NurbsCurve {
    /// Unit tangent at `t`, in the direction of growing parameters.
    ///
    /// At a corner the one of the given side. Where the derivative vanishes, the limit from that
    /// side: the direction of the next derivative that does not vanish.
    ///
    /// # Errors
    /// [`GeomError::VanishingTangent`] where the curve stays at one point.
    pub fn tangent_at(&self, t: f64, side: Side) -> Result<DVec3, GeomError> {
        let domain = self.domain();
        let side = match side {
            Side::Left if t <= domain.start() => Side::Right,
            Side::Right if domain.end() <= t => Side::Left,
            side => side,
        };
        let span = self.knots.span_beside(t, side);
        let (width, rounding) = (self.knots.span_interval(span).length(), self.rounding(span));
        let [_, velocity] = self.velocity_on(span, t);
        let tangent = if rounding < velocity.length() * width {
            unit(velocity)
        } else {
            self.limit_tangent(span, t, side)
        };
        tangent.ok_or(GeomError::VanishingTangent { parameter: t })
    }

    /// The direction of the first derivative that does not vanish.
    fn limit_tangent(&self, span: usize, t: f64, side: Side) -> Option<DVec3> {
        let (width, rounding) = (self.knots.span_interval(span).length(), self.rounding(span));
        // The numerator of a rational tangent has at most twice the degree.
        let order = if self.is_rational { 2 * self.degree() } else { self.degree() };
        let mut step = 1.0;
        for (k, &derivative) in self.derivatives_on(span, t, order).iter().enumerate().skip(1) {
            step *= width / k as f64;
            if rounding < derivative.length() * step {
                // Before `t` the lower derivatives are odd powers of a negative step.
                let is_backward = side == Side::Left && k % 2 == 0;
                return unit(if is_backward { -derivative } else { derivative });
            }
        }
        None
    }

    /// Curvature at `t`, not negative; at a knot that of the piece to its right.
    ///
    /// # Errors
    /// [`GeomError::VanishingDerivative`] where the derivative vanishes.
    pub fn curvature_at(&self, t: f64) -> Result<f64, GeomError> {
        let span = self.knots.span_at(t);
        let derivatives = self.derivatives_on(span, t, 2);
        let (first, second) = (derivatives[1], derivatives[2]);
        let speed = first.length();
        if speed * self.knots.span_interval(span).length() <= self.rounding(span) {
            return Err(GeomError::VanishingDerivative { parameter: t });
        }
        Ok(first.cross(second).length() / (speed * speed * speed))
    }

    /// Principal unit normal at `t`: normal to the tangent, towards the centre of curvature.
    ///
    /// # Errors
    /// [`GeomError::VanishingDerivative`] where the derivative vanishes, [`GeomError::Straight`] where
    /// the curvature does.
    pub fn normal_at(&self, t: f64) -> Result<DVec3, GeomError> {
        let span = self.knots.span_at(t);
        let derivatives = self.derivatives_on(span, t, 2);
        let (width, rounding) = (self.knots.span_interval(span).length(), self.rounding(span));
        let tangent = unit(derivatives[1]).filter(|_| rounding < derivatives[1].length() * width);
        let tangent = tangent.ok_or(GeomError::VanishingDerivative { parameter: t })?;
        let across = derivatives[2] - tangent * derivatives[2].dot(tangent);
        let is_bent = rounding < across.length() * width * width;
        unit(across).filter(|_| is_bent).ok_or(GeomError::Straight { parameter: t })
    }

    /// A length over one span that rounding of the coordinates may leave.
    fn rounding(&self, span: usize) -> f64 {
        let magnitude = |&point| homogeneous::place(point).abs().max_element();
        let points = &self.control_points[self.knots.support(span)];
        VANISHING_RELATIVE * points.iter().map(magnitude).fold(0.0, f64::max)
    }
}
