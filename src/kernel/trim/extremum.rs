//! What of a face is nearest to a point or reaches farthest.
//!
//! The least of a quantity over a face is taken on the border, or inside at a place where it is least for the
//! surface around it. The domain is divided into boxes: what a box can give at most is known from the part of the
//! surface over it, and a box that no arc of the border meets is inside or outside as a whole. Boxes that cannot
//! give less than what is known already are left out, and so are those on the border over which a derivative
//! keeps its sign; the others there are divided. Branch and bound: Ma & Hewitt, *Point inversion and projection
//! for NURBS curve and surface*, CAGD 20 (2003).

use glam::DVec3;

use super::{
    Face,
    edge::{Carrier, SlopeRanges, slope_ranges},
};
use crate::{
    Bounds, Direction, GeomError, Interval, NurbsSurface, Region, RegionSide, Tolerance,
    arrange::winding_about,
    ceiling::BISECTIONS,
    frame::norm,
    numeric::enclosure::{outward, product, sum},
    tolerance::EXTREMUM_RELATIVE,
};

/// A point of a face that is nearest to another.
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{Cutter, Face, Frame, NurbsSurface, Tolerance, glam::DVec3};
///
/// let sphere = Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, 1.0)?), Tolerance::DEFAULT)?;
/// let cut = Cutter::Plane(Frame::XY);
/// let upper = sphere.part_at(&[cut], DVec3::Z, Tolerance::DEFAULT)?;
/// let nearest = upper.closest(DVec3::new(3.0, 0.0, -4.0), Tolerance::DEFAULT)?;
/// assert!((nearest.distance - 20.0_f64.sqrt()).abs() < 1e-9);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaceClosestPoint {
    /// u and v of the surface.
    pub parameters: [f64; 2],
    /// The point.
    pub point: DVec3,
    /// How far it is.
    pub distance: f64,
}

/// What is least over a part of a surface, and where, if that is known.
struct LeastValue {
    value: f64,
    parameters: Option<[f64; 2]>,
}

/// A quantity that is least somewhere.
trait BoundedQuantity {
    /// Its least value over all of a surface.
    fn least(&self, part: &NurbsSurface) -> LeastValue;

    /// No more than its least value in a box.
    fn at_least(&self, hull: Bounds) -> f64;

    /// Whether its derivatives by u and v can both be zero, by the box and what Su and Sv are at most.
    fn may_be_stationary(&self, hull: Bounds, slopes: &SlopeRanges) -> bool;
}

/// How far along an axis, turned around for the upper end.
struct AxisRange {
    axis: usize,
    is_upper: bool,
}

impl AxisRange {
    fn of(&self, bounds: Bounds) -> f64 {
        if self.is_upper { -bounds.max[self.axis] } else { bounds.min[self.axis] }
    }
}

impl BoundedQuantity for AxisRange {
    fn least(&self, part: &NurbsSurface) -> LeastValue {
        LeastValue { value: self.of(part.bounds()), parameters: None }
    }

    fn at_least(&self, hull: Bounds) -> f64 {
        self.of(hull)
    }

    fn may_be_stationary(&self, _: Bounds, slopes: &SlopeRanges) -> bool {
        slopes.iter().all(|slope| holds_zero(slope[self.axis]))
    }
}

/// How far from a point.
struct DistanceTo(DVec3);

impl BoundedQuantity for DistanceTo {
    fn least(&self, part: &NurbsSurface) -> LeastValue {
        let foot = part.closest(self.0);
        LeastValue { value: foot.distance, parameters: Some(foot.parameters) }
    }

    fn at_least(&self, Bounds { min, max }: Bounds) -> f64 {
        norm((min - self.0).max(self.0 - max).max(DVec3::ZERO))
    }

    fn may_be_stationary(&self, Bounds { min, max }: Bounds, slopes: &SlopeRanges) -> bool {
        let away = |axis: usize| outward([min[axis] - self.0[axis], max[axis] - self.0[axis]]);
        slopes.iter().all(|slope| {
            let along = |axis: usize| product(away(axis), slope[axis]);
            holds_zero(sum(sum(along(0), along(1)), along(2)))
        })
    }
}

/// A box around a surface: that of its control points, or where weights are not positive its own.
fn hull(surface: &NurbsSurface) -> Bounds {
    let has_positive_weights = surface.control_points().iter().all(|point| 0.0 < point.w);
    match Bounds::of(surface.points().iter().copied()) {
        Some(hull) if has_positive_weights => hull,
        _ => surface.bounds(),
    }
}

fn holds_zero([low, high]: [f64; 2]) -> bool {
    low <= 0.0 && 0.0 <= high
}

/// A box of parameters, with how often it was halved.
struct DistanceCell {
    intervals: [Interval; 2],
    depth: usize,
}

impl Face {
    /// The smallest box with sides along the axes of space.
    ///
    /// # Errors
    /// Those of a search that was ended.
    pub fn bounds(&self, tolerance: Tolerance) -> Result<Bounds, GeomError> {
        let surface = &*self.plane.surface;
        let whole = surface.bounds();
        if self.is_whole() {
            return Ok(whole);
        }
        let distance = self.distance(tolerance);
        let border = self.border_bounds(distance)?;
        let (boxes, carrier) = (self.border_boxes(distance)?, Carrier::new(surface));
        let mut found = border;
        for axis in 0..3 {
            for is_upper in [false, true] {
                let reach = AxisRange { axis, is_upper };
                let known = border.map_or(f64::INFINITY, |border| reach.of(border));
                let inside = self.least_inside(known, &reach, (&boxes, &carrier))?;
                let value = inside.map_or(known, |inside| inside.value);
                let bounds = found.get_or_insert(whole);
                if is_upper {
                    bounds.max[axis] = -value;
                } else {
                    bounds.min[axis] = value;
                }
            }
        }
        Ok(found.unwrap_or(whole))
    }

    /// The nearest point of it.
    ///
    /// # Errors
    /// Those of a search that was ended.
    pub fn closest(
        &self,
        point: DVec3,
        tolerance: Tolerance,
    ) -> Result<FaceClosestPoint, GeomError> {
        let surface = &*self.plane.surface;
        let distance = self.distance(tolerance);
        let of = |parameters: [f64; 2]| {
            let point_there = surface.point_at(parameters[0], parameters[1]);
            let distance = point_there.distance(point);
            FaceClosestPoint { parameters, point: point_there, distance }
        };
        let foot = surface.closest(point);
        if self.side_of_parameters(foot.parameters, 0.0) == RegionSide::Inside {
            return Ok(of(foot.parameters));
        }
        let on_border = match self.closest_on_border(point, distance)? {
            Some(on_border) => of(surface.closest(on_border).parameters),
            None => return Ok(of(foot.parameters)),
        };
        let (known, to) = (on_border.distance, DistanceTo(point));
        let (boxes, carrier) = (self.border_boxes(distance)?, Carrier::new(surface));
        let inside = self.least_inside(known, &to, (&boxes, &carrier))?;
        Ok(inside.and_then(|inside| inside.parameters).map_or(on_border, of))
    }

    /// Where a point is, the border and the face as thick as the tolerance.
    ///
    /// # Errors
    /// Those of a search that was ended.
    pub fn side_of(&self, point: DVec3, tolerance: Tolerance) -> Result<RegionSide, GeomError> {
        let distance = self.distance(tolerance);
        let foot = self.plane.surface.closest(point);
        if distance < foot.distance {
            return Ok(RegionSide::Outside);
        }
        // Seams and poles are borders of the parameters alone.
        Ok(match self.closest_on_border(point, distance)? {
            Some(border) if border.distance(point) <= 2.0 * distance => RegionSide::Border,
            _ if self.side_of_parameters(foot.parameters, distance) == RegionSide::Outside => {
                RegionSide::Outside
            }
            _ => RegionSide::Inside,
        })
    }

    /// The least of a quantity inside, where that is below what is known by more than the digits of something of
    /// the size of the surface.
    fn least_inside(
        &self,
        known: f64,
        quantity: &dyn BoundedQuantity,
        (boxes, carrier): (&[Bounds], &Carrier<'_>),
    ) -> Result<Option<LeastValue>, GeomError> {
        let slack = EXTREMUM_RELATIVE * hull(&self.plane.surface).diagonal();
        let mut found: Option<LeastValue> = None;
        let mut todo = vec![DistanceCell { intervals: self.plane.domains(), depth: 0 }];
        while let Some(DistanceCell { intervals, depth }) = todo.pop() {
            GeomError::go_on(1)?;
            let [from, to] =
                [Interval::start, Interval::end].map(|end| self.plane.place(intervals.map(end)));
            let is_met = boxes.iter().any(|border| {
                border.min.x <= to.x
                    && from.x <= border.max.x
                    && border.min.y <= to.y
                    && from.y <= border.max.y
            });
            let middle = self.plane.place(intervals.map(|interval| interval.at(0.5)));
            if !is_met && !self.is_within(middle) {
                continue;
            }
            // What is least on the border is known: inside both derivatives vanish there.
            let ranges = intervals.map(|interval| [interval.start(), interval.end()]);
            let slopes = slope_ranges(carrier, ranges);
            let part = Direction::BOTH.into_iter().zip(intervals).try_fold(
                (*self.plane.surface).clone(),
                |part, (along, interval)| match interval == part.domain(along) {
                    true => Ok(part),
                    false => part.trimmed(along, interval),
                },
            );
            // Too narrow to be cut out.
            let Ok(part) = part else { continue };
            let best = found.as_ref().map_or(known, |found| found.value) - slack;
            let hull = hull(&part);
            if best <= quantity.at_least(hull)
                || slopes.is_some_and(|slopes| !quantity.may_be_stationary(hull, &slopes))
            {
                continue;
            }
            let there = quantity.least(&part);
            if best <= there.value {
                continue;
            }
            let is_inside = |parameters| self.is_within(self.plane.place(parameters));
            if !is_met || there.parameters.is_some_and(is_inside) {
                found = Some(there);
            } else if depth < 2 * BISECTIONS {
                let halved = match depth % 2 {
                    0 => intervals[0].halves().map(|u| [u, intervals[1]]),
                    _ => intervals[1].halves().map(|v| [intervals[0], v]),
                };
                todo.extend(halved.map(|intervals| DistanceCell { intervals, depth: depth + 1 }));
            }
        }
        Ok(found)
    }

    /// Whether a place of the plane of parameters is inside; of one on the border that is not said.
    fn is_within(&self, place: DVec3) -> bool {
        let winds = |part: &Region| winding_about(part.arcs(), place).is_some_and(|n| n != 0);
        self.parts.iter().any(winds)
    }

    /// The boxes of the border's arcs between their knots, in the plane of parameters. Seams that the face goes
    /// over and poles are no border.
    fn border_boxes(&self, distance: f64) -> Result<Vec<Bounds>, GeomError> {
        let arcs = self.border_arcs(distance)?;
        let pieces = arcs.iter().flat_map(|arc| arc.in_plane.decompose());
        Ok(pieces.filter_map(|piece| Bounds::of(piece.points())).collect())
    }
}
