//! Section curves on one basis, and where in v they stand.

use glam::{DVec3, DVec4};

use crate::{
    CountError, GeomError, InputError, KnotVector, NurbsCurve,
    gordon::{RefitRequest, refitted},
    homogeneous::{about, place, place_speed},
    make_compatible,
    tolerance::{PARAMETER_RELATIVE, VANISHING_RELATIVE},
};

/// A rule for the parameters of sections.
///
/// Sections at 0, 1 and 4 stand by their distances at 1/4, by the roots of these at 1/(1 + √3):
///
/// ```
/// use virote_kernel::{CompatibleSections, NurbsCurve, SectionParameters, glam::DVec3};
///
/// let rung = |y: f64| NurbsCurve::line(DVec3::Y * y, DVec3::Y * y + DVec3::X);
/// let sections = CompatibleSections::new(&[rung(0.0)?, rung(1.0)?, rung(4.0)?])?;
/// let middle = |rule| sections.parameters(rule, false).map(|all| all[1]);
/// assert!((middle(SectionParameters::Average)? - 0.25).abs() < 1e-15);
/// assert!((middle(SectionParameters::Centripetal)? - 1.0 / (1.0 + 3.0_f64.sqrt())).abs() < 1e-15);
/// assert_eq!(middle(SectionParameters::Uniform)?, 0.5);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SectionParameters {
    /// The mean, over the lines of control points, of what the distances in each line make: homogeneous ones, which count
    /// weights as lengths, about the first control point of the first section.
    Average,
    /// The same with the square roots of the distances.
    Centripetal,
    /// As the average, with the distances of places, whatever their weights.
    Places,
    /// All steps the same.
    Uniform,
}

impl SectionParameters {
    /// A control point as the distances are told of: about an origin, or its place alone.
    pub(crate) fn measured(self, origin: DVec3, point: DVec4) -> DVec4 {
        match self {
            Self::Places => place(point).extend(0.0),
            _ => about(origin, point),
        }
    }

    /// How fast [`Self::measured`] moves where the control point does, and the origin.
    pub(crate) fn measured_speed(
        self,
        [origin, speed_of_origin]: [DVec3; 2],
        [point, speed]: [DVec4; 2],
    ) -> DVec4 {
        match self {
            Self::Places => place_speed(point, speed).extend(0.0),
            _ => about(origin, speed) - (point.w * speed_of_origin).extend(0.0),
        }
    }
}

/// Curves of one degree on one knot vector, whose weights are 1 in the mean of the ends.
///
/// A line and a parabola come to degree 2 and stay the curves they are:
///
/// ```
/// use virote_kernel::{CompatibleSections, NurbsCurve, glam::DVec3};
///
/// let line = NurbsCurve::line(DVec3::ZERO, DVec3::X)?;
/// let bend = NurbsCurve::bezier(&[DVec3::Z, DVec3::new(0.5, 0.0, 3.0), DVec3::X + DVec3::Z])?;
/// let sections = CompatibleSections::new(&[line, bend])?;
/// assert!(sections.curves().iter().all(|curve| curve.degree() == 2));
/// assert_eq!(sections.curves()[0].point_at(0.5), DVec3::new(0.5, 0.0, 0.0));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct CompatibleSections(Vec<NurbsCurve>);

impl CompatibleSections {
    /// The curves brought to one degree and one knot vector, exactly, on the domain of the first.
    ///
    /// Weights are first divided by the root of those at the two ends, as a common factor changes
    /// no curve, but every surface through it. A section that is a point takes the weights of its
    /// neighbour. Piegl & Tiller, *The NURBS Book*, §10.3.
    ///
    /// # Errors
    /// [`CountError::TooFewCurves`] below two; those of [`make_compatible`].
    pub fn new(curves: &[NurbsCurve]) -> Result<Self, GeomError> {
        let got = curves.len();
        if got < 2 {
            return Err(CountError::TooFewCurves { got, needed: 2 }.into());
        }
        let domain = curves.iter().find(|curve| !curve.is_point()).map(NurbsCurve::domain);
        let on_domain = |curve: &NurbsCurve| match domain {
            Some(domain) if curve.domain() != domain => curve.reparametrized(domain),
            _ => curve.clone(),
        };
        let normal: Vec<NurbsCurve> =
            curves.iter().map(on_domain).map(|curve| curve.with_unit_ends()).collect();
        let mut common = make_compatible(&normal)?;
        for i in 0..got {
            if !common[i].is_point() {
                continue;
            }
            let beside = if i == 0 { 1 } else { i - 1 };
            let place = common[i].start();
            let shaped =
                common[beside].control_points().iter().map(|p| (place * p.w).extend(p.w)).collect();
            common[i] = NurbsCurve::new_unchecked(common[i].knots().clone(), shaped);
        }
        Ok(Self(common))
    }

    /// The sections with polynomial splines, of degree 3 or more, in place of rational ones.
    ///
    /// # Errors
    /// `FitError::ToleranceNotKept`.
    pub fn polynomial(&self, tolerance: f64) -> Result<Self, GeomError> {
        let knots = self.knots();
        let degree = knots.degree().max(3);
        let rational: Vec<NurbsCurve> = self
            .0
            .iter()
            .filter(|curve| curve.is_rational() && !curve.is_point())
            .cloned()
            .collect();
        if rational.is_empty() {
            return Ok(self.clone());
        }
        let domain = knots.domain();
        let is_ring = rational.iter().all(|curve| curve.is_closed(tolerance));
        // Corners keep their knots.
        let held = knots.distinct().into_iter().filter(|&(_, times)| knots.degree() <= times + 1);
        let held = held.map(|(t, times)| (t, times + degree - knots.degree())).collect();
        let at = vec![domain.start(), domain.end()];
        let (fits, _) =
            refitted(&rational, &RefitRequest { degree, at, held, is_ring }, tolerance)?;
        let mut fits = fits.into_iter();
        let own = |curve: &NurbsCurve| match curve.is_rational() {
            true if curve.is_point() => NurbsCurve::bezier(&[curve.start()]),
            true => Ok(fits.next().unwrap_or_else(|| curve.clone())),
            false => Ok(curve.clone()),
        };
        let curves: Vec<NurbsCurve> = self.0.iter().map(own).collect::<Result<_, _>>()?;
        Self::new(&curves)
    }

    /// Curves of one degree on one knot vector.
    pub(super) fn of(curves: Vec<NurbsCurve>) -> Self {
        Self(curves)
    }

    /// The curves.
    #[must_use]
    pub fn curves(&self) -> &[NurbsCurve] {
        &self.0
    }

    /// The first `n` of them.
    #[must_use]
    pub fn first(&self, n: usize) -> Self {
        Self(self.0[..n].to_vec())
    }

    /// The knots of all of them.
    #[must_use]
    pub fn knots(&self) -> &KnotVector {
        self.0[0].knots()
    }

    /// Control point i of every section, for each i.
    pub(super) fn lines(&self) -> Vec<Vec<DVec4>> {
        let line = |i: usize| self.0.iter().map(|curve| curve.control_points()[i]).collect();
        (0..self.knots().n_points()).map(line).collect()
    }

    /// The lines as a rule measures their steps.
    fn measured_lines(&self, rule: SectionParameters) -> Vec<Vec<DVec4>> {
        let mut lines = self.lines();
        if self.0.iter().any(NurbsCurve::is_rational) {
            let origin = place(lines[0][0]);
            for point in lines.iter_mut().flatten() {
                *point = rule.measured(origin, *point);
            }
        }
        lines
    }

    /// One parameter a section, from 0 to 1; lines of control points at one place say nothing.
    ///
    /// Piegl & Tiller, *The NURBS Book*, (10.8), of rational sections with the distances of
    /// homogeneous points, (10.14), about the first control point, so that they do not depend on where the
    /// sections lie. With `is_closed` the first section counts once more at the end.
    ///
    /// # Errors
    /// [`InputError::CoincidentPoints`] with the indices of two sections that are one.
    pub fn parameters(
        &self,
        rule: SectionParameters,
        is_closed: bool,
    ) -> Result<Vec<f64>, GeomError> {
        let n_steps = self.0.len() - usize::from(!is_closed);
        if rule == SectionParameters::Uniform {
            return Ok((0..=n_steps).map(|k| k as f64 / n_steps as f64).collect());
        }
        let lines = self.measured_lines(rule);
        let step = |line: &[DVec4], k: usize| {
            let distance = (line[(k + 1) % line.len()] - line[k]).length();
            if rule == SectionParameters::Centripetal { distance.sqrt() } else { distance }
        };
        let lengths: Vec<f64> =
            lines.iter().map(|line| (0..n_steps).map(|k| step(line, k)).sum()).collect();
        let least = VANISHING_RELATIVE * lengths.iter().copied().fold(0.0, f64::max);
        let counts: Vec<(&Vec<DVec4>, f64)> =
            lines.iter().zip(lengths).filter(|&(_, length)| least < length).collect();

        let mut parameters = vec![0.0];
        for k in 0..n_steps {
            let sum: f64 = counts.iter().map(|(line, length)| step(line, k) / length).sum();
            let mean = sum / counts.len().max(1) as f64;
            if !PARAMETER_RELATIVE.lt(&mean) {
                let second = (k + 1) % self.0.len();
                return Err(InputError::CoincidentPoints { first: k, second }.into());
            }
            parameters.push(parameters[k] + mean);
        }
        parameters[n_steps] = 1.0;
        Ok(parameters)
    }
}

impl NurbsCurve {
    /// The same curve with weights whose product at both ends is 1.
    fn with_unit_ends(&self) -> Self {
        if !self.is_rational() && self.control_points()[0].w.to_bits() == 1.0_f64.to_bits() {
            return self.clone();
        }
        let domain = self.domain();
        let [start, end] = [domain.start(), domain.end()].map(|t| self.homogeneous_at(t).w);
        let factor = 1.0 / (start.sqrt() * end.sqrt());
        let scaled = self.control_points().iter().map(|&point| point * factor).collect();
        Self::new_unchecked(self.knots().clone(), scaled)
    }

    /// Whether all control points are at one place.
    #[must_use]
    pub fn is_point(&self) -> bool {
        let points = self.points();
        let size = points.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
        points.iter().all(|point| point.distance(points[0]) <= VANISHING_RELATIVE * size)
    }
}
