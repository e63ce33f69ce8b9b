//! The curve at a distance beside another one.

mod fit;
mod round;
mod straight;

use glam::{DVec3, DVec4};

use super::{NurbsCurve, join};
use crate::kernel::{
    GeomError, Side,
    frame::unit,
    tolerance::{CUSP_SLACK, LAST_BIT, Tolerance, VANISHING_RELATIVE},
};

/// Last bits of a coordinate that a point of the offset may be off.
const MOST_ROUNDINGS: f64 = 64.0;

/// Parameters at which each piece is asked for its bend.
const N_SAMPLES: usize = 16;

/// Steps that narrow a change of sign down to the last bit, or a minimum to half of them.
const MAX_STEPS: usize = 60;

/// An offset curve, and where it is not what one may expect.
#[derive(Clone, Debug, PartialEq)]
pub struct Offset {
    /// The curve.
    pub curve: NurbsCurve,
    /// A distance that no point of the curve is further from the true offset: none for an exact one.
    pub deviation: f64,
    /// Parameters of the original where the radius of curvature equals the distance, so that the
    /// offset stands still or turns back.
    pub cusps: Vec<f64>,
    /// Parameters of the original where a corner is turned on its inner side, so that the offset
    /// crosses itself.
    pub crossings: Vec<f64>,
}

/// What an offset needs to know besides the curve.
#[derive(Clone, Copy)]
struct Aim {
    distance: f64,
    normal: DVec3,
    accuracy: f64,
    /// A length that rounding of the coordinates may leave.
    rounding: f64,
}

impl Aim {
    /// Where the offset of a point lies, for the direction of the curve there.
    fn side(self, tangent: DVec3, parameter: f64) -> Result<DVec3, GeomError> {
        let side = unit(tangent.cross(self.normal)).ok_or(GeomError::AlongNormal { parameter })?;
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
    /// [`GeomError::ZeroAxis`] for the normal; [`GeomError::AlongNormal`] where the curve runs
    /// along it; [`GeomError::NoOffset`] where it turns too fast to be followed; [`GeomError::VanishingOffset`] of a circle of that radius.
    pub fn offset(
        &self,
        distance: f64,
        normal: DVec3,
        tolerance: Tolerance,
    ) -> Result<Offset, GeomError> {
        let normal = unit(normal).ok_or(GeomError::ZeroAxis { what: "the normal" })?;
        let rounding = MOST_ROUNDINGS * LAST_BIT * (self.magnitude() + distance.abs());
        let accuracy = tolerance.distance.max(rounding);
        let aim = Aim { distance, normal, accuracy, rounding };
        let exact = |curve: NurbsCurve| Offset {
            curve,
            deviation: 0.0,
            cusps: Vec::new(),
            crossings: Vec::new(),
        };
        if distance.abs() <= 0.0 {
            return Ok(exact(self.clone()));
        }
        if let Some(offset) = straight::offset(self, aim)? {
            return Ok(offset);
        }
        if let Some(curve) = round::offset(self, aim)? {
            return Ok(exact(curve));
        }
        let (pieces, crossings) = self.offset_pieces(aim, tolerance)?;
        let curve = match pieces.as_slice() {
            [piece] => piece.clone(),
            // The pieces meet by construction; what is between them is rounding.
            _ => join(&pieces, f64::INFINITY)?,
        };
        let deviation = accuracy;
        Ok(Offset { curve, deviation, cusps: self.offset_cusps(aim), crossings })
    }

    /// Pieces that follow the offset from end to end, and the corners that make it cross itself.
    fn offset_pieces(
        &self,
        aim: Aim,
        tolerance: Tolerance,
    ) -> Result<(Vec<Self>, Vec<f64>), GeomError> {
        let parts = self.smooth_parts(tolerance.angle)?;
        let is_closed = self.is_closed(tolerance.distance);
        let (mut pieces, mut crossings) = (Vec::new(), Vec::new());
        for (index, part) in parts.iter().enumerate() {
            pieces.extend(fit::pieces(part, aim)?);
            let next = match parts.get(index + 1) {
                None if is_closed => &parts[0],
                Some(next) => next,
                None => continue,
            };
            let corner = round::corner(part, next, aim)?;
            if corner.is_inner {
                crossings.push(part.domain().end());
            }
            pieces.extend(corner.arc);
        }
        Ok((pieces, crossings))
    }

    /// The parts between corners and cusps.
    fn smooth_parts(&self, angle: f64) -> Result<Vec<Self>, GeomError> {
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
            if angle < left?.angle_between(right?) {
                let [left, right] = rest.split(t)?;
                parts.push(left);
                rest = right;
            }
        }
        parts.push(rest);
        Ok(parts)
    }

    /// Parameters between knots where the derivative vanishes: minima of the speed, found by halves
    /// of its slope, which are zero.
    fn standstills(&self) -> Vec<f64> {
        let mut found = Vec::new();
        for span in self.knots.spans() {
            let interval = self.knots.span_interval(span);
            let slope = |t: f64| {
                let derivatives = self.derivatives_on(span, t, 2);
                derivatives[1].dot(derivatives[2])
            };
            for pair in interval.steps(N_SAMPLES).windows(2) {
                let (mut low, mut high) = (pair[0], pair[1]);
                if 0.0 < slope(low) || slope(high) < 0.0 {
                    continue;
                }
                for _ in 0..MAX_STEPS {
                    let middle = 0.5 * (low + high);
                    if slope(middle) < 0.0 { low = middle } else { high = middle }
                }
                let velocity = self.velocity_on(span, high)[1];
                if velocity.length() * interval.length() <= VANISHING_RELATIVE * self.magnitude() {
                    found.push(high);
                }
            }
        }
        found
    }

    /// Where `1 + d·κ` vanishes, κ positive for a turn to the left.
    fn offset_cusps(&self, aim: Aim) -> Vec<f64> {
        let mut cusps: Vec<f64> = Vec::new();
        for span in self.knots.spans() {
            let speed = |t: f64| {
                let derivatives = self.derivatives_on(span, t, 2);
                let [first, second] =
                    [1, 2].map(|k| derivatives[k].reject_from_normalized(aim.normal));
                let length = first.length();
                1.0 + aim.distance * first.cross(second).dot(aim.normal)
                    / (length * length * length)
            };
            let interval = self.knots.span_interval(span);
            let parameters = interval.steps(N_SAMPLES);
            for pair in parameters.windows(2) {
                if let Some(t) = root(&speed, pair[0], pair[1]) {
                    let is_new = |last: &f64| *last + interval.length() * CUSP_SLACK < t;
                    if cusps.last().is_none_or(is_new) {
                        cusps.push(t);
                    }
                }
            }
        }
        cusps
    }
}

/// Where a function of an interval vanishes, crossing zero or only touching it.
fn root(f: &impl Fn(f64) -> f64, start: f64, end: f64) -> Option<f64> {
    let (mut low, mut high) = (start, end);
    let (at_low, at_high) = (f(low), f(high));
    if !(at_low.is_finite() && at_high.is_finite()) {
        return None;
    }
    if at_low.abs() <= CUSP_SLACK {
        return Some(low);
    }
    if at_high.abs() <= CUSP_SLACK {
        return Some(high);
    }
    if at_low.signum() * at_high.signum() < 0.0 {
        for _ in 0..MAX_STEPS {
            let middle = 0.5 * (low + high);
            if f(middle).signum() * at_low.signum() < 0.0 { high = middle } else { low = middle }
        }
        return Some(0.5 * (low + high));
    }
    // The least absolute value in between, by thirds.
    for _ in 0..MAX_STEPS {
        let third = (high - low) / 3.0;
        let (a, b) = (low + third, high - third);
        if f(a).abs() < f(b).abs() { high = b } else { low = a }
    }
    let least = 0.5 * (low + high);
    (f(least).abs() <= CUSP_SLACK).then_some(least)
}

/// The homogeneous points of a polynomial piece.
fn unweighted(points: &[DVec3]) -> Vec<DVec4> {
    points.iter().map(|point| point.extend(1.0)).collect()
}
