//! Arcs of a radius that touch two curves, or one from a point.

use std::f64::consts::PI;

use glam::DVec3;

use super::{
    PlaneEnd, PlaneEnds, TangentArc, TangentEnd, cross,
    pair::{ContactEnd, contact},
    sorted,
};
use crate::{
    CircleForm, ConstructionError, CurveIntersection, Frame, GeomError, IntersectionError,
    NurbsCurve, Tolerance,
    frame::{norm, unit},
    tolerance::{TANGENT_ACCURACY, WHOLE_TURN_SLACK},
};

/// Where a centre may be for one end: at a distance beside a smooth part of a curve, or around a point.
struct CenterLine<'p> {
    curve: NurbsCurve,
    /// How far to the right of the part.
    distance: f64,
    /// The part, over the same parameters up to their scale; or the point.
    of: ContactEnd<'p>,
}

/// A centre with the places where its circle touches.
struct TangentCenter {
    center: DVec3,
    places: [DVec3; 2],
    parameters: [Option<f64>; 2],
}

impl TangentArc {
    /// Every arc of a radius between both ends that touches each curve where it ends, in the order of the
    /// parameters: of each circle the shorter arc.
    ///
    /// An arc touches at the end of a curve too, if it goes on there as the curve does, but not in a corner. One whose ends
    /// are one within the tolerance is left out.
    ///
    /// # Errors
    /// [`ConstructionError::NotInOnePlane`]; [`ConstructionError::TangentAllAlong`] of curves that run alongside at
    /// twice the radius; `IntersectionError::Tangled`; [`GeomError::Jump`], `GeomError::Ended`; those of
    /// [`NurbsCurve::offset`].
    pub fn all(
        ends: [TangentEnd<'_>; 2],
        radius: f64,
        tolerance: Tolerance,
    ) -> Result<Vec<Self>, GeomError> {
        let plane = PlaneEnds::of(ends, tolerance)?;
        let distance = tolerance.distance_for(plane.scale);
        let in_plane = tolerance.with_distance(distance / plane.scale);
        let r = radius / plane.scale;
        let offsets =
            [offsets(&plane.ends[0], r, in_plane)?, offsets(&plane.ends[1], r, in_plane)?];
        let mut found = Vec::new();
        for own in &offsets[0] {
            for other in &offsets[1] {
                GeomError::go_on(1)?;
                for meeting in meetings([own, other], &plane, in_plane.distance)? {
                    found.extend(touching([own, other], &meeting));
                }
            }
        }
        let arc = |found: TangentCenter| {
            let points = [0, 1].map(|i| plane.point(ends[i], found.places[i], found.parameters[i]));
            let center = plane.in_space(found.center);
            let arms = found.places.map(|place| place - found.center);
            let turn = libm::atan2(cross(arms[0], arms[1]), arms[0].dot(arms[1]));
            let is_half = PI - turn.abs() <= WHOLE_TURN_SLACK;
            let sign = if turn < 0.0 && !is_half { -1.0 } else { 1.0 };
            let normal = plane.frame.z() * sign;
            Self { points, parameters: found.parameters, center, radius, normal, turn: turn.abs() }
        };
        let mut arcs: Vec<Self> = found.into_iter().map(arc).collect();
        arcs.retain(|arc| distance < norm(arc.points[1] - arc.points[0]));
        let places = |arc: &Self| [arc.points[0], arc.points[1], arc.center];
        Ok(sorted(arcs, places, |arc| arc.parameters, distance))
    }

    /// It as a curve on 0..1, from its start to its end: the shorter arc, or the rest of the circle.
    ///
    /// # Errors
    /// Those of [`NurbsCurve::arc`].
    pub fn curve(&self, is_long: bool) -> Result<NurbsCurve, GeomError> {
        let (normal, turn) = match is_long {
            true => (-self.normal, 2.0 * PI - self.turn),
            false => (self.normal, self.turn),
        };
        let frame = Frame::from_normal(self.center, normal, Some(self.points[0] - self.center))?;
        NurbsCurve::arc(frame, self.radius, 0.0, turn)
    }
}

/// Where centres may be for an end. A part that is an arc of the radius has none on the side of its own centre.
fn offsets(
    end: &PlaneEnd,
    radius: f64,
    tolerance: Tolerance,
) -> Result<Vec<CenterLine<'_>>, GeomError> {
    let parts = match end {
        PlaneEnd::Point(point) => {
            let frame = Frame::XY.at(*point);
            let curve = NurbsCurve::ellipse(frame, [radius; 2], CircleForm::NinePoint)?;
            return Ok(vec![CenterLine { curve, distance: radius, of: ContactEnd::Point(*point) }]);
        }
        PlaneEnd::Parts(parts) => parts,
    };
    let mut found = Vec::new();
    for part in parts {
        for distance in [radius, -radius] {
            match part.offset(distance, DVec3::Z, tolerance) {
                Ok(offset) => {
                    found.push(CenterLine {
                        curve: offset.curve,
                        distance,
                        of: ContactEnd::Part(part),
                    });
                }
                Err(GeomError::Construction(ConstructionError::VanishingOffset { .. })) => {}
                Err(other) => return Err(other),
            }
        }
    }
    Ok(found)
}

/// Near which places both have one centre.
fn meetings(
    [own, other]: [&CenterLine<'_>; 2],
    plane: &PlaneEnds,
    distance: f64,
) -> Result<Vec<CurveIntersection>, GeomError> {
    // Offsets are within the tolerance of the true ones.
    match own.curve.intersections(&other.curve, 2.0 * distance) {
        Err(GeomError::Intersection(IntersectionError::RunTogether { start, end })) => {
            let point = plane.in_space(own.curve.point_at(0.5 * (start + end)));
            Err(ConstructionError::TangentAllAlong { what: "arcs", point }.into())
        }
        found => found,
    }
}

/// The centre beside a meeting whose circle touches both ends, if there is one.
fn touching(offsets: [&CenterLine<'_>; 2], meeting: &CurveIntersection) -> Option<TangentCenter> {
    let at = [meeting.first, meeting.second];
    let ends = offsets.map(|line| line.of);
    let start = [0, 1].map(|i| {
        let domain = ends[i].limits();
        let fraction = offsets[i].curve.domain().fraction_of(at[i]);
        domain[0] + (domain[1] - domain[0]) * fraction
    });
    let center = |i: usize, t: f64| beside(ends[i].at(t), offsets[i].distance);
    let parameters = match [ends[0].is_curve(), ends[1].is_curve()] {
        [true, true] => contact(ends, start, |[t, s]| {
            let ([a, da], [b, db]) = (center(0, t), center(1, s));
            ([a.x - b.x, a.y - b.y], [[da.x, -db.x], [da.y, -db.y]])
        }),
        // The centre is as far from the point as the radius.
        [true, false] => contact(ends, start, |[t, _]| {
            let (away, slope) = from_point(center(0, t), ends[1], offsets[1].distance);
            ([away, 0.0], [[slope, 0.0], [0.0, 1.0]])
        }),
        [false, true] => contact(ends, start, |[_, s]| {
            let (away, slope) = from_point(center(1, s), ends[0], offsets[0].distance);
            ([0.0, away], [[1.0, 0.0], [0.0, slope]])
        }),
        [false, false] => return None,
    };
    let at = |i: usize| center(i, parameters[i])[0];
    let radius = offsets[0].distance.abs();
    let (center, gap) = match [ends[0].is_curve(), ends[1].is_curve()] {
        [true, true] => (at(0).midpoint(at(1)), norm(at(0) - at(1))),
        [true, false] => (at(0), (norm(at(0) - ends[1].at(0.0)[0]) - radius).abs()),
        _ => (at(1), (norm(at(1) - ends[0].at(0.0)[0]) - radius).abs()),
    };
    let told = |i: usize| ends[i].is_curve().then_some(parameters[i]);
    let places = [0, 1].map(|i| ends[i].at(parameters[i])[0]);
    (gap <= TANGENT_ACCURACY * (1.0 + radius)).then(|| TangentCenter {
        center,
        places,
        parameters: [told(0), told(1)],
    })
}

/// The place at a distance to the right of a curve, and its velocity: C′ (1 + d·κ).
fn beside([place, velocity, acceleration]: [DVec3; 3], distance: f64) -> [DVec3; 2] {
    let speed = norm(velocity);
    let Some(tangent) = unit(velocity) else { return [DVec3::NAN; 2] };
    let right = DVec3::new(tangent.y, -tangent.x, 0.0);
    let curvature = cross(tangent, acceleration) / (speed * speed);
    [place + right * distance, velocity * (1.0 + distance * curvature)]
}

/// By how much the square of a centre's distance from a point exceeds that of the radius, and its slope.
fn from_point([center, velocity]: [DVec3; 2], point: ContactEnd<'_>, radius: f64) -> (f64, f64) {
    let away = center - point.at(0.0)[0];
    (away.length_squared() - radius * radius, 2.0 * away.dot(velocity))
}
