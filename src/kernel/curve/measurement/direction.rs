//! The shape at a place of a curve of either kind, and what kind of place it is.

use glam::{DVec3, DVec4};

use crate::{
    GeomError, Interval, LocalError, Side, Tolerance,
    curve::{
        Curve, EvaluationPlace, LocalGeometry, NurbsCurve, ParametricCurve,
        evaluation::series::{self, Terms},
    },
    frame::{angle_between, norm, unit},
    homogeneous,
    tolerance::{PLACE_RELATIVE, SHORTEST_REACH, VANISHING_RELATIVE},
};

/// Derivatives of higher order than this are not looked at: the factorial of 170 is the last
/// that is a number.
const MAX_ORDER: usize = 150;

/// Order of the derivatives that tell tangent, curvature and torsion where the first one does not
/// vanish.
const SHAPE_ORDER: usize = 3;

/// Order of the last derivative of a function in which a direction is looked for.
const FUNCTION_ORDER: usize = 4;

/// How rounding grows with each derivative of a function, whose derivatives are exact.
const FUNCTION_GROWTH: f64 = 4.0;

/// What kind of place a parameter of a curve is.
///
/// The derivative of this cubic vanishes halfway, where it turns back:
///
/// ```
/// use virote_kernel::{Curve, CurvePointKind, NurbsCurve, Tolerance, glam::DVec3};
///
/// let corners = [(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)];
/// let curve = NurbsCurve::bezier(&corners.map(|(x, y)| DVec3::new(x, y, 0.0)))?;
/// let kind = |t| Curve::from(curve.clone()).place_kind_at(t, Tolerance::DEFAULT);
/// assert_eq!(kind(0.5)?, CurvePointKind::Cusp);
/// assert_eq!(kind(0.25)?, CurvePointKind::Regular);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurvePointKind {
    /// The tangent goes on, and the curve bends to the same side before and after it.
    Regular,
    /// The tangent goes on, and the curve bends to the other side after it.
    Inflection,
    /// The tangent turns back.
    Cusp,
    /// The tangent jumps to another direction.
    Corner,
}

/// How a curve leaves a place on one side: its direction, and the axis that it turns about unless
/// it is straight.
struct OneSidedDirection {
    tangent: DVec3,
    turn: Option<DVec3>,
}

impl Curve {
    /// The shape at `t`, at a knot that of the piece on one side; at an end of the domain that of
    /// the only piece there is.
    ///
    /// # Errors
    /// [`LocalError::VanishingTangent`] where the curve stays at one point, and as
    /// [`Self::point_at`].
    pub fn local_at(&self, t: f64, side: Side) -> Result<LocalGeometry, GeomError> {
        self.local_around(self.neighbourhood(t, side)?)
    }

    /// The shape at the place that is looked at.
    pub(in crate::curve) fn local_around(
        &self,
        around: EvaluationPlace,
    ) -> Result<LocalGeometry, GeomError> {
        let derivatives: Terms<DVec3> = match self {
            Self::Nurbs(curve) if curve.is_rational => curve.derivatives_of_shape(&around).into(),
            // A function may have a curvature, although no change of it.
            _ => match self.derivatives_around(&around, SHAPE_ORDER) {
                Err(_) => self.derivatives_around(&around, SHAPE_ORDER - 1)?.into(),
                Ok(derivatives) => derivatives.into(),
            },
        };
        if around.first(&around.terms(&derivatives), 1, 0) == Some(1) {
            return LocalGeometry::new(&derivatives, around);
        }
        let order = MAX_ORDER.min(SHAPE_ORDER * self.direction_order());
        LocalGeometry::new(&self.derivatives_around(&around, order)?, around)
    }

    /// What kind of place `t` is; a parameter that misses a singular place by rounding counts as
    /// that place. The ends of a closed curve are one place, those of an open one are regular.
    ///
    /// # Errors
    /// As [`Self::local_at`].
    pub fn place_kind_at(&self, t: f64, tolerance: Tolerance) -> Result<CurvePointKind, GeomError> {
        let domain = self.domain();
        if let Self::Parametric(curve) = self {
            let near = PLACE_RELATIVE * domain.length();
            let spline = curve.nurbs_approximation()?;
            if let Some(&at) = spline.breaks().iter().find(|at| (t - **at).abs() <= near) {
                return Self::Nurbs(spline).place_kind_at(at, tolerance);
            }
        }
        let t = self.neighbourhood(t, Side::Right)?.parameter;
        let (before, after) = match (t <= domain.start(), domain.end() <= t) {
            (false, false) => (t, t),
            _ if self.is_closed(tolerance.distance) => (domain.end(), domain.start()),
            _ => return Ok(CurvePointKind::Regular),
        };
        let (before, after) =
            (self.approach(before, Side::Left)?, self.approach(after, Side::Right)?);
        let angle = angle_between(before.tangent, after.tangent);
        Ok(if tolerance.angle < std::f64::consts::PI - angle && tolerance.angle < angle {
            CurvePointKind::Corner
        } else if tolerance.angle < angle {
            CurvePointKind::Cusp
        } else {
            match (before.turn, after.turn) {
                (Some(before), Some(after)) if before.dot(after) < 0.0 => {
                    CurvePointKind::Inflection
                }
                _ => CurvePointKind::Regular,
            }
        })
    }

    fn approach(&self, t: f64, side: Side) -> Result<OneSidedDirection, GeomError> {
        let around = EvaluationPlace { slack: PLACE_RELATIVE, ..self.neighbourhood(t, side)? };
        let order = MAX_ORDER.min(2 * self.direction_order() + 2);
        let terms = around.terms(&self.derivatives_around(&around, order)?);
        let standing = GeomError::Local(LocalError::VanishingTangent { parameter: t });
        let first = around.first(&terms, 1, 0).ok_or(standing.clone())?;
        let leading = unit(terms[first]).ok_or(standing)?;
        let sign = |power: usize| {
            if around.side == Side::Left && !power.is_multiple_of(2) { -1.0 } else { 1.0 }
        };

        // The velocity is a power of the parameter times this; its cross product with its own
        // derivative is along the binormal.
        let extent = terms[first].length();
        let velocity: Vec<DVec3> =
            (first..terms.len()).map(|k| terms[k] / extent * k as f64).collect();
        let turns: Vec<DVec3> =
            series::cross_derivative(&velocity).into_iter().map(|turn| turn * extent).collect();
        let turn = around.first(&turns, 0, first + 1);
        Ok(OneSidedDirection {
            tangent: sign(first - 1) * leading,
            turn: turn.and_then(|k| Some(sign(k) * unit(turns[k])?)),
        })
    }

    /// What is looked at from a side of `t`, and what counts as rounding there.
    pub(in crate::curve) fn neighbourhood(
        &self,
        t: f64,
        side: Side,
    ) -> Result<EvaluationPlace, GeomError> {
        match self {
            Self::Nurbs(curve) => Ok(curve.neighbourhood(t, side)),
            Self::Parametric(curve) => curve.neighbourhood(t, side),
        }
    }

    pub(in crate::curve) fn derivatives_around(
        &self,
        around: &EvaluationPlace,
        order: usize,
    ) -> Result<Vec<DVec3>, GeomError> {
        self.derivatives_beside(around.parameter, around.side, order)
    }

    /// Order of the last derivative in which a direction is looked for: beyond it every one
    /// vanishes of a NURBS, whose tangent has a numerator of at most twice the degree.
    fn direction_order(&self) -> usize {
        match self {
            Self::Nurbs(curve) if curve.is_rational => 2 * curve.degree(),
            Self::Nurbs(curve) => curve.degree(),
            Self::Parametric(_) => FUNCTION_ORDER,
        }
    }
}

impl NurbsCurve {
    /// Unit tangent at `t`, in the direction of growing parameters.
    ///
    /// At a corner the one of the given side. Where the derivative vanishes, the limit from that
    /// side: the direction of the next derivative that does not vanish.
    ///
    /// # Errors
    /// [`LocalError::VanishingTangent`] where the curve stays at one point.
    pub fn tangent_at(&self, t: f64, side: Side) -> Result<DVec3, GeomError> {
        let around = self.neighbourhood(t, side);
        let span = self.knots.span_beside(around.parameter, around.side);
        let [_, velocity] = self.velocity_on(span, around.parameter);
        match unit(velocity).filter(|_| around.rounding < velocity.length() * around.reach) {
            Some(tangent) => Ok(tangent),
            None => Curve::from(self.clone()).local_at(t, side).map(|local| local.tangent()),
        }
    }

    /// Point and derivatives up to [`SHAPE_ORDER`] by a parameter of which the weight's change adds
    /// nothing along the tangent: where weights differ by orders of magnitude, the bending would be
    /// lost in it.
    ///
    /// With A and w the Taylor coefficients of the homogeneous curve about its point, over the
    /// weight there, the parameter t + w₁t² + (w₁² + w₂)t³ makes of A/w the series
    /// A₁t + A₂t² + (A₃ + w₁A₂)t³.
    fn derivatives_of_shape(&self, around: &EvaluationPlace) -> [DVec3; SHAPE_ORDER + 1] {
        let span = self.knots.span_beside(around.parameter, around.side);
        let support = &self.control_points[self.knots.support(span)];
        let orders = SHAPE_ORDER.min(self.degree());
        let sum = |basis: &[f64], of: &dyn Fn(DVec4) -> DVec4| -> DVec4 {
            support.iter().zip(basis).map(|(&point, &n)| of(point) * n).sum()
        };
        let (at, terms) = self.knots.with_derivatives(span, around.parameter, orders, |rows| {
            let value = sum(&rows[..support.len()], &|point| point);
            let at = homogeneous::project(value);
            // In one rounding: the products are large beside what is left of them.
            let about = |point: DVec4| {
                (-at).mul_add(DVec3::splat(point.w), point.truncate()).extend(point.w)
            };
            let mut terms = [DVec4::ZERO; SHAPE_ORDER + 1];
            for (term, row) in terms.iter_mut().zip(rows.chunks_exact(support.len())) {
                *term = sum(row, &about) / value.w;
            }
            (at, terms)
        });
        // What the point itself lost by rounding.
        let lost = terms[0].truncate();
        let [_, first, second, third] = terms.map(|term| term.truncate() - lost * term.w);
        [at, first, second, third + 3.0 * terms[1].w * second]
    }

    fn neighbourhood(&self, t: f64, side: Side) -> EvaluationPlace {
        let parameter = self.knots.snapped(t);
        let side = only_side(self.domain(), parameter, side);
        let span = self.knots.span_beside(parameter, side);
        let points = &self.control_points[self.knots.support(span)];
        let magnitude = |&point| homogeneous::place(point).abs().max_element();
        let largest = points.iter().map(|point| point.w).fold(0.0, f64::max);
        EvaluationPlace {
            parameter,
            side,
            reach: self.knots.span_interval(span).length(),
            rounding: VANISHING_RELATIVE * points.iter().map(magnitude).fold(0.0, f64::max),
            growth: self.degree().max(1) as f64 * largest / self.homogeneous_at(parameter).w,
            slack: 0.0,
        }
    }
}

impl ParametricCurve {
    /// Unit tangent at `t`; where the derivative vanishes the limit from one side.
    ///
    /// # Errors
    /// [`LocalError::VanishingTangent`] where it has no limit that four derivatives show, and as
    /// [`Self::derivatives_at`].
    pub fn tangent_at(&self, t: f64, side: Side) -> Result<DVec3, GeomError> {
        let around = self.neighbourhood(t, side)?;
        for order in 1..=FUNCTION_ORDER {
            let derivatives = self.derivatives_at(around.parameter, order)?;
            if around.first(&around.terms(&derivatives), 1, 0).is_some() {
                return LocalGeometry::new(&derivatives, around).map(|local| local.tangent());
            }
        }
        Err(GeomError::Local(LocalError::VanishingTangent { parameter: t }))
    }

    /// The place with the reach over which the first derivatives keep to the size of the curve.
    fn neighbourhood(&self, t: f64, side: Side) -> Result<EvaluationPlace, GeomError> {
        let domain = self.domain();
        let t = self.beside(t, side);
        let derivatives = self.derivatives_at(t, 1)?;
        let travel = norm(derivatives[1]) * domain.length();
        let coordinates = [self.start(), self.end(), derivatives[0]];
        let farthest = coordinates.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
        let size = farthest.max(travel);
        let reach = match 0.0 < size {
            true => domain.length() * (farthest / travel).clamp(SHORTEST_REACH, 1.0),
            false => domain.length(),
        };
        Ok(EvaluationPlace {
            parameter: t,
            side: only_side(domain, t, side),
            reach,
            rounding: VANISHING_RELATIVE * size,
            growth: FUNCTION_GROWTH,
            slack: 0.0,
        })
    }
}

/// The side on which a place of the domain has a curve.
fn only_side(domain: Interval, t: f64, side: Side) -> Side {
    match side {
        Side::Left if t <= domain.start() => Side::Right,
        Side::Right if domain.end() <= t => Side::Left,
        side => side,
    }
}
