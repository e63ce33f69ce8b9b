//! Regions grown and shrunk by a distance.
//!
//! The new border lies among the offsets of the arcs and what rounds the corners between them. These are cut
//! where they meet; a part belongs to the border where it is nowhere nearer to the old one than the
//! distance, which is the definition, and decides folds, cusps and what falls apart alike.

use std::f64::consts::TAU;

use glam::DVec3;

use super::{
    PlaneLoop, Region,
    boolean::{in_space, sorted},
    corner::corner_turn,
};
use crate::{
    ConstructionError, Frame, GeomError, InputError, NurbsCurve, Side, Tolerance,
    arrange::{self, Apart, Arrangement, Ring},
    frame::{norm, unit},
};

/// A mitred corner is no further than so many times the distance from the old one.
const LONGEST_MITRE: f64 = 10.0;

/// Tolerances by which a part of the new border may be nearer to the old one than the distance: its own
/// deviation, and that of where it is cut.
const SLACK: f64 = 4.0;

/// Where on a part of an offset its distance is looked at, by fractions.
const LOOKS: [f64; 3] = [0.5, 0.25, 0.75];

/// What becomes of corners that an offset tears open.
///
/// ```
/// use virote_kernel::{CornerStyle, NurbsCurve, Region, Tolerance, glam::DVec3};
///
/// let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0), (0.0, 0.0)];
/// let outline = NurbsCurve::polyline(&corners.map(|(x, y)| DVec3::new(x, y, 0.0)))?;
/// let square = Region::new(&outline, &[], Tolerance::DEFAULT)?;
/// let grown = square.offset(1.0, CornerStyle::Miter, Tolerance::DEFAULT)?;
/// assert!((grown[0].area() - 16.0).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CornerStyle {
    /// Arcs about them: all within the distance, and nothing else.
    Round,
    /// Both sides go on straight until they meet, no further than ten times the distance; beyond, as
    /// [`Self::Bevel`].
    Miter,
    /// A straight side cuts them off.
    Bevel,
}

/// Arcs of which the new border consists in part, and how near to the old one they may come.
#[derive(Default)]
struct Front {
    arcs: Vec<NurbsCurve>,
    /// The corner about which a straight arc runs, that may be nearer than the distance.
    corners: Vec<Option<DVec3>>,
}

impl Front {
    fn push(&mut self, arc: NurbsCurve, corner: Option<DVec3>) {
        self.arcs.push(arc);
        self.corners.push(corner);
    }
}

impl Region {
    /// The region grown by a distance, shrunk by a negative one: its parts, the largest first; none
    /// where nothing is left. Lines and arcs stay such; other borders keep the tolerance.
    ///
    /// # Errors
    /// [`InputError::NotFinite`]; those of [`NurbsCurve::offset`] and of [`Self::union`].
    pub fn offset(
        &self,
        distance: f64,
        corners: CornerStyle,
        tolerance: Tolerance,
    ) -> Result<Vec<Self>, GeomError> {
        if !distance.is_finite() {
            return Err(InputError::NotFinite { what: "the distance", index: 0 }.into());
        }
        let size = super::bounds_of(&self.loops).map_or(0.0, crate::Bounds::diagonal);
        let near = tolerance.distance_for(size);
        if distance.abs() <= near {
            return Ok(vec![self.clone()]);
        }
        let tolerance = tolerance.with_distance(near);
        let mut front = Front::default();
        for border in &self.loops {
            add_front(border, distance, corners, tolerance, &mut front)?;
        }
        let Front { arcs, corners } = front;
        let rings = [Ring { group: 0, arcs }];
        let arrangement =
            Arrangement::of(&rings, Apart::Nothing, near, 1).map_err(in_space(self.frame))?;
        let boxes: Vec<_> = self.loops.iter().flat_map(|border| &border.arcs).collect();
        let boxes: Vec<_> = boxes.into_iter().map(|arc| (arc, arc.bounds())).collect();
        let is_near = |point: DVec3, least: f64| {
            boxes.iter().any(|(arc, bounds)| {
                let off = (bounds.min - point).max(point - bounds.max).max(DVec3::ZERO);
                norm(off) < least && arc.closest(point, near).distance < least
            })
        };
        // At hollow corners the offsets of both sides go on behind their crossing, and end there.
        let mut n_ends = vec![0_usize; arrangement.vertices.len()];
        arrangement.edges.iter().flat_map(|edge| edge.ends).for_each(|end| n_ends[end] += 1);
        let sides = arrangement.edges.iter().map(|edge| {
            let is_loose = edge.ends.iter().any(|&end| n_ends[end] < 2);
            let is_border = !is_loose
                && LOOKS.into_iter().all(|fraction| {
                    let point = edge.curve.point_at(edge.curve.domain().at(fraction));
                    let own =
                        corners[edge.arc].map_or(distance.abs(), |corner| norm(point - corner));
                    !is_near(point, own.min(distance.abs()) - SLACK * near)
                });
            let runs_along = edge.passes.iter().all(|&(_, passes)| 0 < passes);
            let side = if runs_along { arrange::EdgeSide::Left } else { arrange::EdgeSide::Right };
            is_border.then_some(side)
        });
        let sides: Vec<_> = sides.collect();
        let loops = arrangement.loops_of(&sides).map_err(in_space(self.frame))?;
        sorted(loops, self.frame, near)
    }
}

/// Adds the offsets of a loop's arcs and what goes about its corners.
fn add_front(
    border: &PlaneLoop,
    distance: f64,
    corners: CornerStyle,
    tolerance: Tolerance,
    front: &mut Front,
) -> Result<(), GeomError> {
    let n = border.arcs.len();
    for (i, arc) in border.arcs.iter().enumerate() {
        for piece in lines_and_rounds(arc)? {
            match piece.offset(distance, DVec3::Z, tolerance) {
                Ok(offset) => {
                    let branches = offset.curve.parts_at(&offset.cusps)?.into_iter();
                    branches.filter(|branch| !runs_back(branch, &piece)).for_each(|branch| {
                        front.push(branch, None);
                    });
                }
                // All of it comes to one point.
                Err(GeomError::Construction(ConstructionError::VanishingOffset { .. })) => {}
                Err(error) => return Err(error),
            }
        }
        let next = &border.arcs[(i + 1) % n];
        let corner = next.start();
        let angle = corner_turn(arc, next, tolerance)?;
        if angle.abs() <= tolerance.angle || angle * distance < 0.0 {
            continue;
        }
        let ends = [
            arc.tangent_at(arc.domain().end(), Side::Left)?,
            next.tangent_at(next.domain().start(), Side::Right)?,
        ];
        let sides = ends.map(|tangent| tangent.cross(DVec3::Z) * distance);
        let [from, to] = sides.map(|side| corner + side);
        if norm(to - from) <= tolerance.distance {
            continue;
        }
        let middle = unit(sides[0] + sides[1]);
        let reach = 1.0 / libm::cos(0.5 * angle);
        match (corners, middle) {
            (CornerStyle::Miter, Some(middle)) if reach <= LONGEST_MITRE => {
                let tip = corner + middle * (distance.abs() * reach);
                front.push(NurbsCurve::line(from, tip)?, None);
                front.push(NurbsCurve::line(tip, to)?, None);
            }
            (CornerStyle::Miter | CornerStyle::Bevel, _) => {
                front.push(NurbsCurve::line(from, to)?, Some(corner));
            }
            (CornerStyle::Round, _) => front.push(arc_about(corner, from, to, distance)?, None),
        }
    }
    Ok(())
}

/// An arc in the parts that its joints leave, so that lines and circular arcs among them are such.
fn lines_and_rounds(arc: &NurbsCurve) -> Result<Vec<NurbsCurve>, GeomError> {
    let joints = arc.knots().distinct().into_iter();
    let joints = joints.filter(|&(_, times)| arc.degree() <= times).map(|(joint, _)| joint);
    let joints: Vec<f64> = joints.collect();
    match joints.len() <= 2 || arc.analytic().is_some() {
        true => Ok(vec![arc.clone()]),
        false => arc.parts_at(&joints),
    }
}

/// Whether an offset runs against its arc: behind the centres of curvature, where the arc is nearer than the distance.
fn runs_back(offset: &NurbsCurve, arc: &NurbsCurve) -> bool {
    let t = offset.domain().at(0.5);
    arc.domain().contains(t) && offset.velocity_at(t)[1].dot(arc.velocity_at(t)[1]) < 0.0
}

/// The arc about a corner from one place to another, counter-clockwise for a positive distance.
pub(super) fn arc_about(
    center: DVec3,
    from: DVec3,
    to: DVec3,
    sense: f64,
) -> Result<NurbsCurve, GeomError> {
    let (a, b) = (from - center, to - center);
    let angle = libm::atan2(a.cross(b).z, a.dot(b));
    let angle = match 0.0 < sense {
        true => angle.rem_euclid(TAU),
        false => -((-angle).rem_euclid(TAU)),
    };
    let (frame, angle) = match 0.0 < angle {
        true => (Frame::from_axes(center, a, DVec3::Z.cross(a))?, angle),
        false => (Frame::from_axes(center, a, a.cross(DVec3::Z))?, -angle),
    };
    NurbsCurve::arc(frame, norm(a), 0.0, angle)
}
