//! What of a face is nearest to a point or reaches farthest.
//!
//! The least of a quantity over a face is taken on the border, or inside at a place where it is least for the
//! surface around it. The domain is divided into boxes: what a box gives at least is known from the part of the
//! surface over it (`bounded`), and a box that no arc of the border meets is inside or outside as a whole. Boxes that
//! cannot give less than what is known already are left out, and so are those on the border over which a derivative
//! keeps its sign, but beside seams, poles and creases, where none need vanish; the others there are divided, and with
//! them the arcs. Branch and bound: Ma & Hewitt, *Point inversion and projection for NURBS curve and surface*, CAGD 20
//! (2003).

use std::rc::Rc;

use glam::DVec3;

use super::{
    Face,
    bounded::{AxisRange, BoundedQuantity, DistanceTo, LeastValue, hull},
    edge::Carrier,
    plane::ParameterPlane,
};
use crate::{
    Bounds, Direction, GeomError, Interval, NurbsSurface, Region, RegionSide, Tolerance,
    arrange::winding_about,
    ceiling::BISECTIONS,
    curve::part::{CurvePart, parts},
    tolerance::{EXTREMUM_RELATIVE, LAST_BIT},
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

/// A box of parameters, with how often it was halved, and what of the border comes near it.
struct FaceCell {
    intervals: [Interval; 2],
    depth: usize,
    border: Vec<Rc<CurvePart>>,
}

impl FaceCell {
    /// The surface over it; none of one that is too narrow to be cut out.
    fn part_of(&self, surface: &NurbsSurface) -> Option<NurbsSurface> {
        Direction::BOTH.into_iter().zip(self.intervals).try_fold(
            surface.clone(),
            |part, (along, interval)| match interval == part.domain(along) {
                true => Some(part),
                false => part.trimmed(along, interval).ok(),
            },
        )
    }

    /// Its halves, with what of the border comes into `bounds`, the box in the plane of parameters.
    ///
    /// Halved is mostly what the border goes across, so that much of it comes to lie on one side alone; the longer side
    /// where it goes across both.
    fn halves(&self, border: Vec<Rc<CurvePart>>, bounds: Bounds) -> [Self; 2] {
        let size = bounds.size();
        let reach = border
            .iter()
            .map(|piece| piece.bounds)
            .reduce(Bounds::union)
            .map_or(size, |all| all.max.min(bounds.max) - all.min.max(bounds.min));
        let across = [0, 1].map(|axis| reach[axis] / size[axis]);
        let turned = usize::from(self.depth.is_multiple_of(HALVINGS_ACROSS));
        let along = match across {
            [u, v] if 2.0 * u < v => turned,
            [u, v] if 2.0 * v < u => 1 - turned,
            _ => usize::from(size.x < size.y),
        };
        self.intervals[along].halves().map(|half| {
            let mut intervals = self.intervals;
            intervals[along] = half;
            Self { intervals, depth: self.depth + 1, border: border.clone() }
        })
    }
}

/// Of so many halvings of a box one is along the border.
const HALVINGS_ACROSS: usize = 4;

/// Last bits of places that pieces of the border are no larger than.
const PLACE_BITS: f64 = 64.0;

/// What of pieces of the border comes into a box of the plane of parameters, halved until it is no larger, as far as
/// there are digits.
fn coming_into(bounds: Bounds, pieces: &[Rc<CurvePart>]) -> Result<Vec<Rc<CurvePart>>, GeomError> {
    let extent = |bounds: Bounds| bounds.size().max_element();
    let least = extent(bounds).max(PLACE_BITS * LAST_BIT * bounds.magnitude());
    let (mut todo, mut found) = (pieces.to_vec(), Vec::new());
    while let Some(piece) = todo.pop() {
        GeomError::go_on(1)?;
        if !piece.bounds.is_near(bounds, 0.0) {
            continue;
        }
        if extent(piece.bounds) <= least {
            found.push(piece);
        } else {
            todo.extend(piece.halves().map(Rc::new));
        }
    }
    Ok(found)
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
        let search = ExtremumSearch::of(self, distance)?;
        let mut found = border;
        for axis in 0..3 {
            for is_upper in [false, true] {
                let reach = AxisRange { axis, is_upper };
                let known = border.map_or(f64::INFINITY, |border| reach.of(border));
                let inside = self.least_inside(known, &reach, &search)?;
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
        if self.is_whole() || self.side_of_parameters(foot.parameters, 0.0) == RegionSide::Inside {
            return Ok(of(foot.parameters));
        }
        let on_border = match self.closest_on_border(point, distance)? {
            Some(on_border) => of(surface.closest(on_border).parameters),
            None => return Ok(of(foot.parameters)),
        };
        let (known, to) = (on_border.distance, DistanceTo(point));
        let inside = self.least_inside(known, &to, &ExtremumSearch::of(self, distance)?)?;
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
        search: &ExtremumSearch<'_>,
    ) -> Result<Option<LeastValue>, GeomError> {
        let slack = EXTREMUM_RELATIVE * hull(&self.plane.surface).diagonal();
        let mut found: Option<LeastValue> = None;
        let mut todo = vec![FaceCell {
            intervals: self.plane.domains(),
            depth: 0,
            border: search.border.clone(),
        }];
        while let Some(cell) = todo.pop() {
            GeomError::go_on(1)?;
            let best = found.as_ref().map_or(known, |found| found.value) - slack;
            let Some(part) = cell.part_of(&self.plane.surface) else { continue };
            let hull = hull(&part);
            if best <= quantity.at_least(hull) {
                continue;
            }
            let place = |end: fn(Interval) -> f64| self.plane.place(cell.intervals.map(end));
            let bounds = Bounds { min: place(Interval::start), max: place(Interval::end) };
            let border = coming_into(bounds, &cell.border)?;
            // What is least on the border is known: inside both derivatives vanish there, but for tips and creases.
            if (border.is_empty() && !self.is_within(bounds.center()))
                || !(search.may_be_bent(&self.plane, cell.intervals)
                    || quantity.may_be_stationary(&part, &search.carrier))
            {
                continue;
            }
            let there = quantity.least(&part);
            if best <= there.value {
                continue;
            }
            let is_inside = |parameters| self.is_within(self.plane.place(parameters));
            if border.is_empty() || there.parameters.is_some_and(is_inside) {
                found = Some(there);
            } else if cell.depth < 2 * BISECTIONS {
                todo.extend(cell.halves(border, bounds));
            }
        }
        Ok(found)
    }

    /// Whether a place of the plane of parameters is inside; of one on the border that is not said.
    fn is_within(&self, place: DVec3) -> bool {
        let winds = |part: &Region| winding_about(part.arcs(), place).is_some_and(|n| n != 0);
        self.parts.iter().any(winds)
    }
}

/// What is known of a face before boxes of its domain are looked at.
struct ExtremumSearch<'f> {
    /// The border's arcs between their knots, in the plane of parameters. Seams that the face goes over and poles
    /// are no border.
    border: Vec<Rc<CurvePart>>,
    carrier: Carrier<'f>,
    /// Whether the surface goes on over the start, and the end, of u and of v, at a seam or a pole. There it may have
    /// a crease or a tip.
    goes_on: [[bool; 2]; 2],
}

impl<'f> ExtremumSearch<'f> {
    fn of(face: &'f Face, distance: f64) -> Result<Self, GeomError> {
        let surface = &*face.plane.surface;
        let arcs = face.border_arcs(distance)?;
        let [u0, u1, v0, v1] = surface.edges().map(|edge| edge.bounds().diagonal() <= distance);
        let [u, v] = face.plane.is_closed;
        Ok(Self {
            border: arcs.iter().flat_map(|arc| parts(&arc.in_plane)).map(Rc::new).collect(),
            carrier: Carrier::new(surface),
            goes_on: [[u || u0, u || u1], [v || v0, v || v1]],
        })
    }

    /// Whether a box of the domain reaches an edge of it over which the surface goes on, or a crease.
    fn may_be_bent(&self, plane: &ParameterPlane, intervals: [Interval; 2]) -> bool {
        let domains = plane.domains();
        (0..2).any(|i| {
            let (start, end) = (intervals[i].start(), intervals[i].end());
            if plane.creases[i].iter().any(|&crease| start <= crease && crease <= end) {
                return true;
            }
            let [at_start, at_end] = self.goes_on[i];
            at_start && start <= domains[i].start() || at_end && domains[i].end() <= end
        })
    }
}
