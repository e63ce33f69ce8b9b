//! Lines that touch two curves, or one from a point.

use glam::DVec3;

use super::{
    PlaneEnd, PlaneEnds, TangentEnd, TangentLine, cross,
    dual::{Chart, DualPiece},
    pair::{ContactEnd, contact},
    sorted,
};
use crate::{
    ConstructionError, GeomError, IntersectionError, Tolerance,
    frame::{norm, unit},
    tolerance::{DUAL_MEETING, TANGENT_ACCURACY},
};

impl TangentLine {
    /// Every line between both ends that touches each curve where it ends, in the order of the parameters.
    ///
    /// A line touches at the end of a curve too, if it goes on there as the curve does, but not in a corner, nor where the
    /// curve stands still. Straight parts of curves touch nothing but what lies on them, and are left out; so is a line
    /// no longer than the tolerance.
    ///
    /// # Errors
    /// [`ConstructionError::NotInOnePlane`]; [`ConstructionError::TangentAllAlong`] of curves that have a stretch in
    /// common; `IntersectionError::Tangled`; [`GeomError::Jump`], `GeomError::Ended`.
    pub fn all(ends: [TangentEnd<'_>; 2], tolerance: Tolerance) -> Result<Vec<Self>, GeomError> {
        let plane = PlaneEnds::of(ends, tolerance)?;
        let pieces = [duals(&plane.ends[0])?, duals(&plane.ends[1])?];
        let mut found = Vec::new();
        for (own, others) in pieces[0].iter().zip(&pieces[1]) {
            for first in own {
                for second in others.iter().filter(|other| near(first, other)) {
                    GeomError::go_on(1)?;
                    for start in meetings([first, second], &plane)? {
                        found.extend(touching(&plane, [first, second], start));
                    }
                }
            }
        }
        let line = |(places, parameters): ([DVec3; 2], [Option<f64>; 2])| {
            let points = [0, 1].map(|i| plane.point(ends[i], places[i], parameters[i]));
            Self { points, parameters }
        };
        let distance = tolerance.distance_for(plane.scale);
        let mut lines: Vec<Self> = found.into_iter().map(line).collect();
        lines.retain(|line| distance < norm(line.points[1] - line.points[0]));
        let points = |line: &Self| [line.points[0], line.points[1], line.points[1]];
        Ok(sorted(lines, points, |line| line.parameters, distance))
    }
}

/// The lines of an end in both charts.
fn duals(end: &PlaneEnd) -> Result<[Vec<DualPiece>; 2], GeomError> {
    match end {
        PlaneEnd::Point(point) => {
            let [flat, steep] = Chart::BOTH.map(|chart| DualPiece::of_point(*point, chart));
            Ok([flat?, steep?])
        }
        PlaneEnd::Parts(parts) => DualPiece::of_parts(parts),
    }
}

fn near(first: &DualPiece, second: &DualPiece) -> bool {
    first.bounds.is_near(second.bounds, DUAL_MEETING)
}

/// Near which parameters both have one line.
fn meetings(pieces: [&DualPiece; 2], plane: &PlaneEnds) -> Result<Vec<[f64; 2]>, GeomError> {
    let at = |piece: &DualPiece, fraction: f64| {
        piece.of.map_or(0.0, |(_, interval)| interval.at(fraction))
    };
    let found = match pieces[0].curve.intersections(&pieces[1].curve, DUAL_MEETING) {
        Ok(found) => found,
        Err(GeomError::Intersection(IntersectionError::RunTogether { start, end })) => {
            let t = at(pieces[0], 0.5 * (start + end));
            let place =
                contact_end(&plane.ends[0], pieces[0]).map_or(DVec3::ZERO, |end| end.at(t)[0]);
            let point = plane.in_space(place);
            return Err(ConstructionError::TangentAllAlong { what: "lines", point }.into());
        }
        Err(other) => return Err(other),
    };
    let both = |fractions: [f64; 2]| [0, 1].map(|i| at(pieces[i], fractions[i]));
    Ok(found.into_iter().map(|meeting| both([meeting.first, meeting.second])).collect())
}

/// The ends of the line that touches beside parameters, and these, if it does.
fn touching(
    plane: &PlaneEnds,
    pieces: [&DualPiece; 2],
    start: [f64; 2],
) -> Option<([DVec3; 2], [Option<f64>; 2])> {
    let end = |i: usize| contact_end(&plane.ends[i], pieces[i]);
    let ends = [end(0)?, end(1)?];
    let parameters = contact(ends, start, |[t, s]| {
        let ([a, da, dda], [b, db, ddb]) = (ends[0].at(t), ends[1].at(s));
        let way = b - a;
        let values = [cross(da, way), cross(db, way)];
        let slopes = [[cross(dda, way), cross(da, db)], [cross(da, db), cross(ddb, way)]];
        (values, slopes)
    });
    let at = [0, 1].map(|i| ends[i].at(parameters[i]));
    let way = unit(at[1][0] - at[0][0])?;
    let touches = |i: usize| match (ends[i].is_curve(), unit(at[i][1])) {
        (false, _) => true,
        (true, Some(tangent)) => cross(tangent, way).abs() <= TANGENT_ACCURACY,
        (true, None) => false,
    };
    let told = |i: usize| ends[i].is_curve().then_some(parameters[i]);
    (touches(0) && touches(1)).then(|| ([at[0][0], at[1][0]], [told(0), told(1)]))
}

/// What a piece is of.
fn contact_end<'p>(end: &'p PlaneEnd, piece: &DualPiece) -> Option<ContactEnd<'p>> {
    match (end, piece.of) {
        (PlaneEnd::Point(point), _) => Some(ContactEnd::Point(*point)),
        (PlaneEnd::Parts(parts), of) => parts.get(of?.0).map(ContactEnd::Part),
    }
}
