//! Surfaces that turn about an axis, and those swung along a closed or open path around z.

use glam::{DAffine3, DMat3, DVec3, DVec4};

use crate::{
    Bounds, ConstructionError, CountError, Frame, GeomError, Grid, InputError, IntersectionError,
    NurbsCurve,
    frame::{norm, unit},
    homogeneous,
    surface::NurbsSurface,
    tolerance::{KNOT_RELATIVE, SIDE_STEP, VANISHING_RELATIVE},
};

/// A line with a direction: what something turns around.
///
/// A side of length 2 at a distance of 3 sweeps 2π·3·2: Pappus' first theorem.
///
/// ```
/// use std::f64::consts::TAU;
/// use virote_kernel::{Axis, NurbsCurve, NurbsSurface, Surface, glam::DVec3};
///
/// let side = NurbsCurve::line(DVec3::X * 3.0, DVec3::new(3.0, 0.0, 2.0))?;
/// let axis = Axis::new(DVec3::ZERO, DVec3::Z)?;
/// let (area, _) = Surface::from(NurbsSurface::revolved(&side, axis, TAU)?).area()?;
/// assert!((area - TAU * 6.0).abs() < 1e-10);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    foot: DVec3,
    direction: DVec3,
}

/// Where a curve meets an axis.
///
/// ```
/// use virote_kernel::{Axis, AxisContact, NurbsCurve, glam::DVec3};
///
/// let profile = NurbsCurve::line(DVec3::new(-1.0, 0.0, 1.0), DVec3::new(1.0, 0.0, 1.0))?;
/// let [contact] = Axis::new(DVec3::ZERO, DVec3::Z)?.contacts(&profile, 1e-6)?[..] else {
///     unreachable!("it crosses the axis once");
/// };
/// let AxisContact::Place { parameter, is_crossing } = contact else { unreachable!("in a point") };
/// assert!((parameter - 0.5).abs() < 1e-9 && is_crossing);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AxisContact {
    /// Between its ends it comes to the axis at this parameter; whether it goes on on the other
    /// side.
    Place {
        /// The parameter of the curve.
        parameter: f64,
        /// Whether it crosses rather than touches.
        is_crossing: bool,
    },
    /// It runs along the axis between these parameters.
    Stretch {
        /// The first parameter.
        start: f64,
        /// The last parameter.
        end: f64,
    },
}

impl Axis {
    /// The line through a point along a direction.
    ///
    /// # Errors
    /// [`InputError::ZeroAxis`], [`InputError::NotFinite`].
    pub fn new(foot: DVec3, direction: DVec3) -> Result<Self, GeomError> {
        if !foot.is_finite() {
            return Err(InputError::NotFinite { what: "origin", index: 0 }.into());
        }
        let direction =
            unit(direction).ok_or(GeomError::Input(InputError::ZeroAxis { what: "the axis" }))?;
        Ok(Self { foot, direction })
    }

    /// A point of it.
    #[must_use]
    pub fn foot(self) -> DVec3 {
        self.foot
    }

    /// Where it points to, of length 1.
    #[must_use]
    pub fn direction(self) -> DVec3 {
        self.direction
    }

    /// The turn about it by an angle.
    pub(crate) fn turn(self, angle: f64) -> DAffine3 {
        let around = DMat3::from_axis_angle(self.direction, angle);
        DAffine3 { matrix3: around, translation: self.foot - around * self.foot }
    }

    /// The part of a homogeneous point on the axis, and what goes out from there.
    fn parts(self, point: DVec4) -> [DVec3; 2] {
        let out = point.truncate() - self.foot * point.w;
        let along = self.direction * out.dot(self.direction);
        [self.foot * point.w + along, out - along]
    }

    /// The vector from the axis to a point.
    fn out(self, point: DVec3) -> DVec3 {
        self.parts(point.extend(1.0))[1]
    }

    /// Where a curve comes within `distance` of the axis between its ends.
    ///
    /// # Errors
    /// [`ConstructionError::OnAxis`] for a curve that lies on the axis.
    pub fn contacts(
        self,
        curve: &NurbsCurve,
        distance: f64,
    ) -> Result<Vec<AxisContact>, GeomError> {
        let points: Vec<DVec3> = curve
            .control_points()
            .iter()
            .filter(|point| point.w != 0.0)
            .map(|&point| homogeneous::place(point))
            .collect();
        if points.iter().all(|&point| norm(self.out(point)) <= distance) {
            return Err(ConstructionError::OnAxis.into());
        }
        let outs = points.iter().map(|&point| self.out(point));
        let farthest = outs.clone().max_by(|a, b| norm(*a).total_cmp(&norm(*b)));
        if let Some(aside) = farthest.and_then(unit)
            && outs.clone().all(|out| distance < out.dot(aside))
            && curve.control_points().iter().all(|point| 0.0 <= point.w)
        {
            // The whole hull is on one side.
            return Ok(Vec::new());
        }
        let height = |point: &DVec3| (*point - self.foot).dot(self.direction);
        let heights = points.iter().map(height);
        let (low, high) = heights
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| (low.min(h), high.max(h)));
        let size = Bounds::of(points.iter().copied()).map_or(0.0, Bounds::diagonal);
        let end = |h: f64| self.foot + self.direction * h;
        let line = NurbsCurve::line(end(low - size), end(high + size))?;
        let domain = curve.domain();
        let is_at_end = |t: f64| {
            [domain.start(), domain.end()].into_iter().any(|end| {
                (t - end).abs() <= KNOT_RELATIVE * domain.length()
                    || curve.point_at(t).distance(curve.point_at(end)) <= distance
            })
        };
        match curve.intersections(&line, distance) {
            Ok(meetings) => {
                let inside = meetings.into_iter().map(|meeting| meeting.first);
                let contact = |parameter: f64| AxisContact::Place {
                    parameter,
                    is_crossing: self.is_crossed(curve, parameter),
                };
                Ok(inside.filter(|&t| !is_at_end(t)).map(contact).collect())
            }
            Err(GeomError::Intersection(IntersectionError::Tangled)) => Ok(Vec::new()),
            Err(GeomError::Intersection(IntersectionError::RunTogether { start, end })) => {
                Ok(vec![AxisContact::Stretch { start, end }])
            }
            Err(other) => Err(other),
        }
    }

    /// Whether a curve that is on the axis at `t` has it between its two sides.
    fn is_crossed(self, curve: &NurbsCurve, t: f64) -> bool {
        let (domain, step) = (curve.domain(), SIDE_STEP * curve.domain().length());
        let beside = |t: f64| self.out(curve.point_at(t.clamp(domain.start(), domain.end())));
        beside(t - step).dot(beside(t + step)) < 0.0
    }
}

impl NurbsSurface {
    /// The surface of a curve turned about an axis by an angle, counter-clockwise for a positive
    /// one: u around on 0..1 from the curve's own place in arcs of at most a quarter turn, v along
    /// the curve.
    ///
    /// Control points nearer to the axis than rounding are on it, so that a pole is a point.
    /// Piegl & Tiller, *The NURBS Book*, A8.1, without its trigonometry for each control point.
    ///
    /// A segment beside the axis becomes a cylinder, exactly:
    ///
    /// ```
    /// use virote_kernel::{Axis, NurbsCurve, NurbsSurface, glam::DVec3};
    ///
    /// let side = NurbsCurve::line(DVec3::X, DVec3::X + DVec3::Z)?;
    /// let axis = Axis::new(DVec3::ZERO, DVec3::Z)?;
    /// let pipe = NurbsSurface::revolved(&side, axis, std::f64::consts::TAU)?;
    /// assert!((pipe.point_at(0.3, 0.5).truncate().length() - 1.0).abs() < 1e-14);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`InputError::BadTurn`] for an angle of zero or beyond a full turn, [`ConstructionError::OnAxis`],
    /// [`CountError::TooManyPoints`], [`InputError::NotFinite`].
    pub fn revolved(profile: &NurbsCurve, axis: Axis, angle: f64) -> Result<Self, GeomError> {
        let turn = std::f64::consts::TAU;
        let sweep = angle.abs();
        if !(sweep.is_finite() && 0.0 < sweep && sweep <= turn * (1.0 + KNOT_RELATIVE)) {
            return Err(InputError::BadTurn { turns: angle / turn }.into());
        }
        let arc = NurbsCurve::arc(Frame::XY, 1.0, 0.0, sweep.min(turn))?;
        let points = profile.control_points();
        check_size(arc.control_points().len(), points.len())?;

        let reach = |point: &DVec4| point.truncate().abs().max_element();
        let size = points.iter().map(reach).fold(0.0, f64::max);
        let size = size.max(norm(axis.foot));
        let mut is_off_axis = false;
        let mut split = |&point: &DVec4| {
            let [on, out] = axis.parts(point);
            if norm(out) <= VANISHING_RELATIVE * size {
                return ([on, DVec3::ZERO, DVec3::ZERO], point.w);
            }
            is_off_axis = true;
            // A negative angle turns the other way.
            ([on, out, axis.direction.cross(out) * angle.signum()], point.w)
        };
        let parts: Vec<([DVec3; 3], f64)> = points.iter().map(&mut split).collect();
        if !is_off_axis {
            return Err(ConstructionError::OnAxis.into());
        }
        let net = Grid::from_fn(arc.control_points().len(), points.len(), |i, j| {
            let around = arc.control_points()[i];
            let ([on, out, across], weight) = parts[j];
            (on * around.w + out * around.x + across * around.y).extend(weight * around.w)
        });
        homogeneous::check_finite(net.as_slice())?;
        Ok(Self::new_unchecked(arc.knots().clone(), profile.knots().clone(), net))
    }

    /// The swung surface: its point at (u, v) is (s·x·X, s·x·Y, z) of the point (x, ·, z) of the
    /// profile at u and the point (X, Y, ·) of the trajectory at v.
    ///
    /// Piegl & Tiller, *The NURBS Book*, (10.1) to (10.6).
    ///
    /// # Errors
    /// [`CountError::TooManyPoints`], [`InputError::NotFinite`].
    pub fn swung(
        profile: &NurbsCurve,
        trajectory: &NurbsCurve,
        scale: f64,
    ) -> Result<Self, GeomError> {
        let (rows, columns) = (profile.control_points(), trajectory.control_points());
        check_size(rows.len(), columns.len())?;
        let net = Grid::from_fn(rows.len(), columns.len(), |i, j| {
            let (p, t) = (rows[i], columns[j]);
            DVec4::new(scale * p.x * t.x, scale * p.x * t.y, p.z * t.w, p.w * t.w)
        });
        homogeneous::check_finite(net.as_slice())?;
        Ok(Self::new_unchecked(profile.knots().clone(), trajectory.knots().clone(), net))
    }

    /// The curve moved along a vector: u along the curve, v on 0..1 along the vector.
    ///
    /// Piegl & Tiller, *The NURBS Book*, §8.3.
    ///
    /// ```
    /// use virote_kernel::{NurbsCurve, NurbsSurface, glam::DVec3};
    ///
    /// let bend = NurbsCurve::bezier(&[DVec3::ZERO, DVec3::new(1.0, 2.0, 0.0), DVec3::X * 2.0])?;
    /// let wall = NurbsSurface::extruded(&bend, DVec3::Z * 4.0)?;
    /// assert_eq!(wall.point_at(0.5, 0.25), DVec3::new(1.0, 1.0, 1.0));
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`InputError::NotFinite`], [`CountError::TooManyPoints`].
    pub fn extruded(curve: &NurbsCurve, vector: DVec3) -> Result<Self, GeomError> {
        let moved = curve.transformed(&DAffine3::from_translation(vector));
        check_size(2, curve.control_points().len())?;
        homogeneous::check_finite(moved.control_points())?;
        Self::ruled(curve, &moved)
    }
}

/// # Errors
/// [`CountError::TooManyPoints`].
pub(crate) fn check_size(n_rows: usize, n_columns: usize) -> Result<(), GeomError> {
    let (got, most) = (n_rows.saturating_mul(n_columns), crate::ceiling::CONTROL_POINTS);
    if got <= most {
        Ok(())
    } else {
        Err(GeomError::Count(CountError::TooManyPoints { got, most }))
    }
}
