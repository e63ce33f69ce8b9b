//! The curve at a distance beside another one.

mod crossing;
mod cusp;
mod fit;
mod round;
mod straight;

use glam::{DVec3, DVec4};

use crate::{
    ConstructionError, GeomError, InputError, IntersectionError, Interval, LocalError, Side,
    curve::{CurveIntersection, NurbsCurve, editing::join::join_moving},
    frame::{angle_between, norm, unit},
    joint::joint_accuracy,
    tolerance::{LAST_BIT, OFFSET_JOINT_SHARE, Tolerance},
};

/// Last bits of a coordinate that a point of the offset may be off.
const MOST_ROUNDINGS: f64 = 64.0;

/// An offset curve, and where it is not what one may expect.
///
/// Beside a circle run circles, exactly; the radius 2 by 3 inward has passed the centre:
///
/// ```
/// use virote_kernel::{CircleForm, Frame, NurbsCurve, Tolerance, glam::DVec3};
///
/// let circle = NurbsCurve::ellipse(Frame::XY, [2.0, 2.0], CircleForm::NinePoint)?;
/// let outer = circle.offset(0.5, DVec3::Z, Tolerance::DEFAULT)?;
/// assert!(outer.curve.sample(9).iter().all(|point| (point.length() - 2.5).abs() < 1e-12));
/// assert!(circle.offset(-3.0, DVec3::Z, Tolerance::DEFAULT)?.is_reversed);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Offset {
    /// The curve.
    pub curve: NurbsCurve,
    /// A distance that no point of the curve is further from the true offset: none for an exact
    /// one.
    pub deviation: f64,
    /// Parameters of the original where the radius of curvature equals the distance, so that the
    /// offset stands still or turns back; of a stretch of them its two ends.
    pub cusps: Vec<f64>,
    /// Parameters of the original where a corner turns to the side of the offset, or a leg begins
    /// along which it runs backwards.
    pub folds: Vec<f64>,
    /// Whether all of it runs backwards: the distance is beyond every centre of curvature.
    pub is_reversed: bool,
    /// Where the offset crosses itself, by its own parameters.
    pub crossings: Vec<CurveIntersection>,
    /// A stretch of its own parameters on which it runs along itself; there may be more, and
    /// crossings are not known then.
    pub overlap: Option<Interval>,
    /// Whether it crosses itself so often that the crossings are not known.
    pub is_tangled: bool,
}

impl Offset {
    /// The curve that is the offset.
    fn exact(curve: NurbsCurve) -> Self {
        Self {
            curve,
            deviation: 0.0,
            cusps: Vec::new(),
            folds: Vec::new(),
            is_reversed: false,
            crossings: Vec::new(),
            overlap: None,
            is_tangled: false,
        }
    }

    /// The same, once it is known where it meets itself; `turns` are the parameters at which it
    /// turns back.
    fn crossed(self, turns: &[f64], aim: CurveOffsetTarget) -> Self {
        match crossing::crossings(&self.curve, turns, aim.rounding) {
            Ok(crossings) => Self { crossings, ..self },
            Err(GeomError::Intersection(IntersectionError::RunsAlongItself { start, end })) => {
                Self { overlap: Interval::new(start, end).ok(), ..self }
            }
            Err(GeomError::Intersection(IntersectionError::Tangled)) => {
                Self { is_tangled: true, ..self }
            }
            Err(_) => self,
        }
    }

    /// The same in units that are smaller by a factor.
    fn in_units(self, factor: f64) -> Self {
        let back = |meeting: CurveIntersection| CurveIntersection {
            point: meeting.point / factor,
            ..meeting
        };
        Self {
            curve: self.curve.in_units(1.0 / factor),
            deviation: self.deviation / factor,
            crossings: self.crossings.into_iter().map(back).collect(),
            ..self
        }
    }
}

/// What an offset is put together of.
#[derive(Default)]
struct OffsetPieces {
    /// In order.
    pieces: Vec<NurbsCurve>,
    /// Parameters of the original at which a corner turns to the side of the offset.
    folds: Vec<f64>,
    /// Parameters of the offset at which it turns back there.
    turns: Vec<f64>,
    /// Where each smooth part begins, by the parameter of the original and by that of the offset.
    starts: Vec<(f64, f64)>,
}

/// What an offset needs to know besides the curve.
#[derive(Clone, Copy)]
struct CurveOffsetTarget {
    distance: f64,
    normal: DVec3,
    accuracy: f64,
    /// A length that rounding of the coordinates may leave.
    rounding: f64,
    /// How large the coordinates were when they were rounded.
    magnitude: f64,
}

impl CurveOffsetTarget {
    /// Where the offset of a point lies, for the direction of the curve there.
    fn side(self, tangent: DVec3, parameter: f64) -> Result<DVec3, GeomError> {
        let side = unit(tangent.cross(self.normal))
            .ok_or(GeomError::Construction(ConstructionError::AlongNormal { parameter }))?;
        Ok(side * self.distance)
    }
}

impl NurbsCurve {
    /// The curve at a distance to the right, seen against the normal: `C + d·(T × n)/|T × n|`, so
    /// that a curve counter-clockwise about the normal grows for a positive distance.
    ///
    /// Exact for polygons in a plane normal to `normal`, whose corners stay corners, and for
    /// circular arcs there. Others are pieces of degree 5 with the same parameters, no point of
    /// which is further than the tolerance from the true offset; at a corner an arc about it is
    /// put in, with parameters of its own.
    ///
    /// # Errors
    /// [`InputError::ZeroAxis`] for the normal; [`GeomError::Jump`]; [`ConstructionError::AlongNormal`] where the curve runs
    /// along it; [`LocalError::VanishingTangent`] of a point; [`ConstructionError::OffsetTooFar`]; [`ConstructionError::NoOffset`] where it turns too fast to be followed; [`ConstructionError::VanishingOffset`] of a circle of that radius.
    pub fn offset(
        &self,
        distance: f64,
        normal: DVec3,
        tolerance: Tolerance,
    ) -> Result<Offset, GeomError> {
        self.offset_of_moved(distance, normal, tolerance, self.magnitude())
    }

    /// The same of a curve that was moved nearer to zero, and whose coordinates were rounded when they were as large as
    /// `magnitude`: up to that an arc is one.
    pub(crate) fn offset_of_moved(
        &self,
        distance: f64,
        normal: DVec3,
        tolerance: Tolerance,
        magnitude: f64,
    ) -> Result<Offset, GeomError> {
        let normal =
            unit(normal).ok_or(GeomError::Input(InputError::ZeroAxis { what: "the normal" }))?;
        self.check_connected()?;
        if let Some(factor) = self.unit_factor(&[]) {
            let tolerance = tolerance.with_distance(tolerance.distance * factor);
            let (curve, distance) = (self.in_units(factor), distance * factor);
            let found = curve.offset_of_moved(distance, normal, tolerance, magnitude * factor);
            return found.map(|found| found.in_units(factor)).map_err(|error| match error {
                GeomError::Construction(ConstructionError::VanishingOffset { radius }) => {
                    GeomError::Construction(ConstructionError::VanishingOffset {
                        radius: radius / factor,
                    })
                }
                other => other,
            });
        }
        let rounding = MOST_ROUNDINGS * LAST_BIT * (self.magnitude() + distance.abs());
        let accuracy = tolerance.distance.max(rounding);
        let aim = CurveOffsetTarget { distance, normal, accuracy, rounding, magnitude };
        if distance.abs() <= rounding {
            // Beside itself by less than its coordinates are rounded.
            return Ok(Offset { deviation: distance.abs(), ..Offset::exact(self.clone()) });
        }
        let start = self.start();
        let size = self.points().into_iter().map(|point| norm(point - start)).fold(0.0, f64::max);
        if size <= 0.0 {
            return Err(LocalError::VanishingTangent { parameter: self.domain().start() }.into());
        }
        if size <= LAST_BIT * distance.abs() {
            return Err(ConstructionError::OffsetTooFar { distance }.into());
        }
        if let Some(offset) = straight::offset(self, aim)? {
            return Ok(offset.crossed(&[], aim));
        }
        let start = self.domain().start();
        let runs_backwards = || cusp::speed(self, aim, start, Side::Right) < 0.0;
        if let Some(curve) = round::offset(self, aim)? {
            return Ok(Offset { is_reversed: runs_backwards(), ..Offset::exact(curve) });
        }
        // What the joints may move, up to degree 5 of their knots each, is left to them.
        let moved = 5.0 * joint_accuracy(self.magnitude(), OFFSET_JOINT_SHARE * accuracy);
        let piece_aim =
            CurveOffsetTarget { accuracy: (accuracy - moved).max(0.5 * accuracy), ..aim };
        let OffsetPieces { pieces, folds, mut turns, starts } =
            self.offset_pieces(piece_aim, tolerance)?;
        let curve = match pieces.as_slice() {
            [piece] => piece.clone(),
            // The pieces meet by construction; what is between them is rounding.
            _ => join_moving(&pieces, f64::INFINITY, OFFSET_JOINT_SHARE * accuracy)?,
        };
        let cusps = cusp::cusps(self, aim);
        turns.extend(cusps.iter().filter_map(|&t| {
            let (own, moved) = *starts.iter().rev().find(|start| start.0 <= t)?;
            Some(moved + (t - own))
        }));
        let is_reversed = cusps.is_empty() && folds.is_empty() && runs_backwards();
        let offset =
            Offset { deviation: accuracy, cusps, folds, is_reversed, ..Offset::exact(curve) };
        Ok(offset.crossed(&turns, aim))
    }

    /// What follows the offset from end to end.
    fn offset_pieces(
        &self,
        aim: CurveOffsetTarget,
        tolerance: Tolerance,
    ) -> Result<OffsetPieces, GeomError> {
        let parts = self.smooth_parts(tolerance.angle)?;
        let is_closed = self.is_closed(tolerance.distance);
        let mut found = OffsetPieces::default();
        let mut end = self.domain().start();
        for (index, part) in parts.iter().enumerate() {
            found.starts.push((part.domain().start(), end));
            end += part.domain().length();
            found.pieces.extend(fit::pieces(part, aim)?);
            let next = match parts.get(index + 1) {
                None if is_closed => &parts[0],
                Some(next) => next,
                None => continue,
            };
            let corner = round::corner(part, next, aim)?;
            let behind = end + corner.arc.iter().map(|arc| arc.domain().length()).sum::<f64>();
            if corner.is_inner {
                found.folds.push(part.domain().end());
                found.turns.extend([end, behind]);
            }
            end = behind;
            found.pieces.extend(corner.arc);
        }
        Ok(found)
    }

    /// The parts between corners and cusps.
    pub(crate) fn smooth_parts(&self, angle: f64) -> Result<Vec<Self>, GeomError> {
        let domain = self.domain();
        let corners = self.knots.distinct().into_iter();
        let mut places: Vec<f64> =
            corners.filter(|&(_, times)| self.degree() <= times).map(|(t, _)| t).collect();
        places.extend(self.standstills());
        places.sort_by(f64::total_cmp);
        let mut rest = self.clamped();
        let mut parts = Vec::new();
        for t in places {
            if t <= rest.domain().start() || domain.end() <= t {
                continue;
            }
            let [left, right] = [Side::Left, Side::Right].map(|side| self.tangent_at(t, side));
            if angle < angle_between(left?, right?) {
                let [left, right] = rest.split(t)?;
                parts.push(left);
                rest = right;
            }
        }
        parts.push(rest);
        Ok(parts)
    }
}

/// The homogeneous points of a polynomial piece.
fn unweighted(points: &[DVec3]) -> Vec<DVec4> {
    points.iter().map(|point| point.extend(1.0)).collect()
}
