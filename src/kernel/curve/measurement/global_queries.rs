//! Questions about all of a curve of either kind.
//!
//! A NURBS answers exactly. For a function its stand-in does, and what is told of it is found on
//! the function itself: parameters by Newton's method on its exact derivatives.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    Bounds, Frame, GeomError, Interval, Tolerance,
    ceiling::POLISHING_STEPS,
    curve::{
        ClosestPoint, Curve, CurveIntersection, NurbsCurve, ParametricCurve,
        intersection::intersect::newton::nearest_step, representation::function,
    },
    frame::norm,
    numeric::newton::{NewtonStep, improved, try_within_limits},
    tolerance::{LAST_BIT, SIDE_STEP, TOUCH_RELATIVE},
};

impl Curve {
    /// The NURBS that it is, or the spline that stands in for a function: of degree 11, with its
    /// exact derivatives at the knots, 1e-13 of its size from it. Corners and places without
    /// derivatives are knots; beside those it may be 1e-6 of the size away.
    ///
    /// # Errors
    /// `FitError::NoSplineNear`, [`GeomError::Jump`] and as [`Self::point_at`] for a function.
    /// So do all questions below.
    pub fn spline(&self) -> Result<Arc<NurbsCurve>, GeomError> {
        match self {
            Self::Nurbs(curve) => Ok(Arc::clone(curve)),
            Self::Parametric(curve) => curve.nurbs_approximation(),
        }
    }

    /// Arc length over the part of the interval that lies in the domain.
    ///
    /// # Errors
    /// As [`Self::spline`].
    pub fn length(&self, interval: Interval) -> Result<f64, GeomError> {
        self.spline().map(|spline| spline.length(interval))
    }

    /// The parameter at which the curve is `length` long from its start.
    ///
    /// # Errors
    /// `DomainError::LengthOutside`, and as [`Self::spline`].
    pub fn parameter_at_length(&self, length: f64) -> Result<f64, GeomError> {
        self.spline()?.parameter_at_length(length)
    }

    /// The ends of `n_parts` parts of equal length, in order.
    ///
    /// # Errors
    /// As [`Self::spline`].
    pub fn divided(&self, n_parts: usize) -> Result<Vec<DVec3>, GeomError> {
        let parameters = self.spline()?.division(n_parts);
        parameters.into_iter().map(|t| self.point_at(t)).collect()
    }

    /// The smallest axis-aligned box around the curve, to rounding.
    ///
    /// # Errors
    /// As [`Self::spline`].
    pub fn bounds(&self) -> Result<Bounds, GeomError> {
        match self {
            Self::Nurbs(curve) => Ok(curve.bounds()),
            Self::Parametric(curve) => curve.box_around(&*curve.nurbs_approximation()?),
        }
    }

    /// The nearest point to `p`; places whose distances differ by less than `tolerance` count as
    /// equally near.
    ///
    /// # Errors
    /// As [`Self::spline`].
    pub fn closest(&self, p: DVec3, tolerance: f64) -> Result<ClosestPoint, GeomError> {
        let foot = self.spline()?.closest(p, tolerance);
        let Self::Parametric(curve) = self else { return Ok(foot) };
        let parameter = curve.nearer(foot.parameter, p)?;
        let point = curve.point_at(parameter)?;
        Ok(ClosestPoint { parameter, point, distance: norm(point - p), ..foot })
    }

    /// As [`NurbsCurve::inflections`].
    ///
    /// # Errors
    /// As [`Self::spline`].
    pub fn inflections(&self, tolerance: Tolerance) -> Result<Vec<f64>, GeomError> {
        let Self::Parametric(curve) = self else {
            return Ok(self.nurbs()?.inflections(tolerance));
        };
        let spline = curve.nurbs_approximation()?;
        match spline.plane_normal(tolerance) {
            Some(normal) => {
                let question = function::bend_about(normal, curve.domain().length());
                curve.smooth_changes(&spline, &question, tolerance)
            }
            None => {
                let mut found = Vec::new();
                for t in spline.inflections(tolerance) {
                    if curve.is_straight_at(t)? {
                        found.push(t);
                    }
                }
                Ok(found)
            }
        }
    }

    /// As [`NurbsCurve::vertices`].
    ///
    /// # Errors
    /// As [`Self::spline`].
    pub fn vertices(&self, tolerance: Tolerance) -> Result<Vec<f64>, GeomError> {
        let Self::Parametric(curve) = self else {
            return Ok(self.nurbs()?.vertices(tolerance));
        };
        let spline = curve.nurbs_approximation()?;
        let normal = spline.plane_normal(tolerance);
        let question = function::curvature_slope(normal, curve.domain().length());
        let mut found = curve.smooth_changes(&spline, &question, tolerance)?;
        let (cusps, near) = (spline.cusps(tolerance), TOUCH_RELATIVE * curve.domain().length());
        found.retain(|t| cusps.iter().all(|cusp| near < (t - cusp).abs()));
        Ok(found)
    }

    /// As [`NurbsCurve::extrema`].
    ///
    /// # Errors
    /// As [`Self::spline`].
    pub fn extrema(&self, direction: DVec3, tolerance: Tolerance) -> Result<Vec<f64>, GeomError> {
        match self {
            Self::Nurbs(curve) => Ok(curve.extrema(direction, tolerance)),
            Self::Parametric(curve) => curve.sign_changes(
                &*curve.nurbs_approximation()?,
                &function::along(direction),
                curve.is_closed(tolerance.distance),
            ),
        }
    }

    /// As [`NurbsCurve::corners`].
    ///
    /// # Errors
    /// As [`Self::spline`].
    pub fn corners(&self, tolerance: Tolerance) -> Result<Vec<f64>, GeomError> {
        self.spline().map(|spline| spline.corners(tolerance))
    }

    /// As [`NurbsCurve::cusps`].
    ///
    /// # Errors
    /// As [`Self::spline`].
    pub fn cusps(&self, tolerance: Tolerance) -> Result<Vec<f64>, GeomError> {
        let near = self.spline()?.cusps(tolerance);
        match self {
            Self::Nurbs(_) => Ok(near),
            Self::Parametric(curve) => curve.standing(near),
        }
    }

    /// As [`NurbsCurve::plane_parameters`].
    ///
    /// # Errors
    /// As [`Self::spline`].
    pub fn plane_parameters(
        &self,
        plane: Frame,
        tolerance: Tolerance,
    ) -> Result<Vec<f64>, GeomError> {
        let spline = self.spline()?;
        let near = spline.plane_parameters(plane, tolerance);
        let Self::Parametric(curve) = self else { return Ok(near) };
        let (domain, step) = (curve.domain(), SIDE_STEP * curve.domain().length());
        let question = function::height(plane.origin(), plane.z(), spline.magnitude());
        let height = |t: f64| -> Result<f64, GeomError> {
            Ok((curve.point_at(t)? - plane.origin()).dot(plane.z()))
        };
        let polished = |t: f64| -> Result<f64, GeomError> {
            let sides = [(t - step).max(domain.start()), (t + step).min(domain.end())];
            let crosses = height(sides[0])? * height(sides[1])? < 0.0;
            if crosses { curve.polished(t, sides, &question) } else { Ok(t) }
        };
        near.into_iter().map(polished).collect()
    }

    /// Every place where the curve comes within `tolerance` of another, by the parameter of this.
    ///
    /// # Errors
    /// `IntersectionError::RunTogether`, and as [`Self::spline`].
    pub fn intersections(
        &self,
        other: &Self,
        tolerance: f64,
    ) -> Result<Vec<CurveIntersection>, GeomError> {
        let near = self.spline()?.intersections(&*other.spline()?, tolerance)?;
        self.polished_meetings(other, near)
    }

    /// Every place where the curve comes within `tolerance` of itself, by the lesser parameter
    /// first.
    ///
    /// # Errors
    /// `IntersectionError::RunTogether`, and as [`Self::spline`].
    pub fn self_intersections(&self, tolerance: f64) -> Result<Vec<CurveIntersection>, GeomError> {
        let near = self.spline()?.self_intersections(tolerance)?;
        self.polished_meetings(self, near)
    }

    fn polished_meetings(
        &self,
        other: &Self,
        near: Vec<CurveIntersection>,
    ) -> Result<Vec<CurveIntersection>, GeomError> {
        match (self, other) {
            (Self::Nurbs(_), Self::Nurbs(_)) => Ok(near),
            _ => near.into_iter().map(|meeting| self.polished_meeting(other, meeting)).collect(),
        }
    }

    /// The nearest approach beside a meeting of stand-ins, by Newton's method on both tangents.
    fn polished_meeting(
        &self,
        other: &Self,
        near: CurveIntersection,
    ) -> Result<CurveIntersection, GeomError> {
        let [own, others] = [self.domain(), other.domain()];
        let apart = |t: f64, s: f64| -> Result<f64, GeomError> {
            Ok(norm(self.point_at(t)? - other.point_at(s)?))
        };
        let start = (near.first, near.second, apart(near.first, near.second)?);
        let (t, s, _) = improved(start, POLISHING_STEPS, |&(t, s, distance)| {
            let (Ok(a), Ok(b)) = (self.derivatives_at(t, 1), other.derivatives_at(s, 1)) else {
                return Ok(None);
            };
            let Some([dt, ds]) = nearest_step(a[0] - b[0], a[1], b[1]) else { return Ok(None) };
            let next = (t + dt).clamp(own.start(), own.end());
            let next_of_other = (s + ds).clamp(others.start(), others.end());
            let is_beside = (next - t).abs() <= SIDE_STEP * own.length()
                && (next_of_other - s).abs() <= SIDE_STEP * others.length();
            if !is_beside {
                return Ok(None);
            }
            let nearer = apart(next, next_of_other)?;
            Ok::<_, GeomError>((nearer < distance).then_some((next, next_of_other, nearer)))
        })?;
        let point = self.point_at(t)?.midpoint(other.point_at(s)?);
        Ok(CurveIntersection { first: t, second: s, point })
    }
}

impl ParametricCurve {
    /// Parameters where a number changes its sign, without corners.
    fn smooth_changes(
        &self,
        spline: &NurbsCurve,
        question: &function::DerivativeQuestion<impl Fn(&[DVec3]) -> function::MeasuredSeries>,
        tolerance: Tolerance,
    ) -> Result<Vec<f64>, GeomError> {
        let corners = spline.corners(tolerance);
        let near = LAST_BIT.sqrt() * self.domain().length();
        let is_corner = |t: f64| corners.iter().any(|corner| (t - corner).abs() <= near);
        let mut found = self.sign_changes(spline, question, self.is_closed(tolerance.distance))?;
        found.retain(|&t| !is_corner(t));
        Ok(found)
    }

    /// The parameter of the foot of `p` beside one that is nearly it.
    fn nearer(&self, t: f64, p: DVec3) -> Result<f64, GeomError> {
        let domain = self.domain();
        let mut distance = norm(self.point_at(t)? - p);
        let is_still = |[t]: [f64; 1], [next]: [f64; 1]| (next - t).abs() <= LAST_BIT * t.abs();
        let limits = [domain.start(), domain.end()];
        let found = try_within_limits([limits], [t], POLISHING_STEPS, is_still, |[t]| {
            let Ok(d) = self.derivatives_at(t, 2) else { return Ok(NewtonStep::Stuck) };
            let away = d[0] - p;
            let step = -away.dot(d[1]) / (d[1].length_squared() + away.dot(d[2]));
            let next = (t + step).clamp(domain.start(), domain.end());
            let is_beside = (next - t).abs() <= SIDE_STEP * domain.length();
            if !is_beside {
                return Ok(NewtonStep::Stuck);
            }
            let nearer = norm(self.point_at(next)? - p);
            // Where the distance is flat the slope still knows where the foot is.
            let is_worse = distance + LAST_BIT * (distance + norm(p)) < nearer;
            distance = if is_worse { distance } else { nearer };
            Ok::<_, GeomError>(if is_worse { NewtonStep::Stuck } else { NewtonStep::By([step]) })
        })?;
        Ok(found.place()[0])
    }
}
