//! Regions grown and shrunk by a distance.
//!
//! The new border lies among the offsets of the arcs and what goes about the corners between them. These are cut
//! where they meet; a part belongs to the border where nothing covers it: it is nowhere nearer to the old border
//! than the distance, which is the definition, and decides folds, cusps and what falls apart alike. A corner that
//! is not rounded covers its wedge, and nothing beyond.

use std::f64::consts::TAU;

use glam::DVec3;

use super::{
    PlaneLoop, Region,
    boolean::{in_space, sorted},
    corner::corner_turn,
};
use crate::{
    Bounds, ClosestPoint, ConstructionError, Frame, GeomError, InputError, MeshError, NurbsCurve,
    Side, Tolerance,
    arrange::{self, Apart, Arrangement, Ring, winding_about},
    frame::{norm, unit},
    tolerance::{LAST_BIT, OFFSET_RELATIVE, OFFSET_SHARE},
};

/// A mitred corner is no further than so many times the distance from the old one.
const LONGEST_MITRE: f64 = 10.0;

/// Tolerances by which a part of the new border may be nearer to the old one than the distance: its own
/// deviation, and that of where it is cut.
const SLACK: f64 = 4.0;

/// Last bits of its coordinates by which a region is as it was.
const ROUNDINGS: f64 = 1024.0;

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
    /// Both sides go on straight until they meet; no further than ten times the distance, where a straight side
    /// across cuts them off.
    Miter,
    /// A straight side cuts them off.
    Bevel,
}

/// What the new border consists of in part, and what it keeps away from at corners that are not rounded.
#[derive(Default)]
struct Front {
    arcs: Vec<NurbsCurve>,
    wedges: Vec<Wedge>,
    /// Corners, torn open or hollow, beyond which nothing is covered by the sides that end there.
    corners: Vec<DVec3>,
}

impl Front {
    /// Adds straight sides from point to point.
    fn push_lines(&mut self, points: &[DVec3]) -> Result<(), GeomError> {
        for ends in points.windows(2) {
            self.arcs.push(NurbsCurve::line(ends[0], ends[1])?);
        }
        Ok(())
    }
}

/// What a corner covers that is not rounded.
struct Wedge {
    /// It and the corners of the new border about it, counter-clockwise.
    outline: Vec<DVec3>,
}

impl Wedge {
    /// Between a corner and a chain of points about it, which turns as the distance has it.
    fn new(corner: DVec3, chain: &[DVec3], distance: f64) -> Self {
        let mut outline = vec![corner];
        outline.extend(chain);
        if distance < 0.0 {
            outline.reverse();
        }
        Self { outline }
    }

    /// Whether a point lies inside, farther than so much from its sides.
    fn covers(&self, point: DVec3, depth: f64) -> bool {
        let ends = self.outline.iter().zip(self.outline.iter().cycle().skip(1));
        ends.into_iter().all(|(&from, &to)| {
            unit(to - from).is_some_and(|along| depth < along.cross(point - from).z)
        })
    }
}

/// What the new border keeps away from.
struct OldBorder<'r> {
    arcs: Vec<(&'r NurbsCurve, Bounds)>,
    loops: &'r [PlaneLoop],
    wedges: &'r [Wedge],
    corners: &'r [DVec3],
    distance: f64,
    /// How near places are one.
    near: f64,
}

impl OldBorder<'_> {
    /// Whether a point lies where the region grows to, or where it shrinks from.
    fn covers(&self, point: DVec3) -> bool {
        let least = self.distance.abs() - SLACK * self.near;
        let is_near = self.arcs.iter().any(|(arc, bounds)| {
            let off = (bounds.min - point).max(point - bounds.max).max(DVec3::ZERO);
            norm(off) < least && {
                let foot = arc.closest(point, self.near);
                foot.distance < least
                    && (self.corners.is_empty() || self.is_beside(arc, &foot, point))
            }
        });
        is_near
            || !self.corners.is_empty()
                && (self.wedges.iter().any(|wedge| wedge.covers(point, SLACK * self.near))
                    || self.is_behind(point))
    }

    /// Whether a point is beside an arc, on the side to which it moves: straight away from its foot, where that is an
    /// end of the arc too, and not about a corner.
    fn is_beside(&self, arc: &NurbsCurve, foot: &ClosestPoint, point: DVec3) -> bool {
        let is_at = |place: DVec3| norm(place - foot.point) <= self.near;
        if self.corners.iter().any(|&corner| is_at(corner)) {
            return false;
        }
        let Some(along) = unit(arc.velocity_at(foot.parameter)[1]) else { return true };
        let away = point - foot.point;
        let slack = SLACK * self.near;
        let is_straight = away.dot(along).abs() <= slack;
        -slack < away.dot(along.cross(DVec3::Z)) * self.distance.signum()
            && (is_straight || !is_at(arc.start()) && !is_at(arc.end()))
    }

    /// Whether a point lies on the side of the old border from which it moves.
    fn is_behind(&self, point: DVec3) -> bool {
        let chains = self.loops.iter().map(|border| &border.arcs[..]);
        winding_about(chains, point).is_some_and(|winding| (winding != 0) == (0.0 < self.distance))
    }
}

impl Region {
    /// The region grown by a distance, shrunk by a negative one: its parts, the largest first; none
    /// where nothing is left. Lines and arcs stay such; other borders keep the tolerance.
    ///
    /// # Errors
    /// [`InputError::NotFinite`]; [`MeshError::BelowRounding`] where places as far out as the new border are rounded by
    /// more than the tolerance; those of [`NurbsCurve::offset`] and of [`Self::union`].
    pub fn offset(
        &self,
        distance: f64,
        corners: CornerStyle,
        tolerance: Tolerance,
    ) -> Result<Vec<Self>, GeomError> {
        if !distance.is_finite() {
            return Err(InputError::NotFinite { what: "the distance", index: 0 }.into());
        }
        let bounds = super::bounds_of(&self.loops);
        let (size, magnitude) = bounds.map_or((0.0, 0.0), |b| (b.diagonal(), b.magnitude()));
        // A distance within the tolerance tells folds from borders as others do.
        if distance.abs() <= (OFFSET_RELATIVE * size).max(ROUNDINGS * LAST_BIT * magnitude) {
            return Ok(vec![self.clone()]);
        }
        // No place of a region is as far from its border as that is from itself.
        if size < -distance {
            return Ok(Vec::new());
        }
        let rounding = LAST_BIT * (magnitude + distance.abs());
        if tolerance.distance < rounding {
            let tolerance = tolerance.distance;
            return Err(MeshError::BelowRounding { tolerance, rounding }.into());
        }
        let near = tolerance.distance_for(size).min(OFFSET_SHARE * distance.abs()).max(rounding);
        let tolerance = tolerance.with_distance(near);
        // Where the plane has its origin beside the region, coordinates were rounded farther out.
        let far = magnitude + norm(self.frame.origin());
        let mut front = Front::default();
        for border in &self.loops {
            add_front(border, (distance, far), corners, tolerance, &mut front)?;
        }
        let Front { arcs, wedges, corners } = front;
        let rings = [Ring { group: 0, arcs }];
        let arrangement =
            Arrangement::of(&rings, Apart::Nothing, near, 1).map_err(in_space(self.frame))?;
        let arcs = self.loops.iter().flat_map(|border| &border.arcs);
        let arcs = arcs.map(|arc| (arc, arc.bounds())).collect();
        let old = OldBorder {
            arcs,
            loops: &self.loops,
            wedges: &wedges,
            corners: &corners,
            distance,
            near,
        };
        // At hollow corners the offsets of both sides go on behind their crossing, and end there.
        let mut n_ends = vec![0_usize; arrangement.vertices.len()];
        arrangement.edges.iter().flat_map(|edge| edge.ends).for_each(|end| n_ends[end] += 1);
        let sides = arrangement.edges.iter().map(|edge| {
            let is_loose = edge.ends.iter().any(|&end| n_ends[end] < 2);
            let is_border = !is_loose
                && LOOKS.into_iter().all(|fraction| {
                    let point = edge.curve.point_at(edge.curve.domain().at(fraction));
                    !old.covers(point)
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

/// Adds the offsets of a loop's arcs, whose coordinates were rounded as far out as `far`, and what goes about its corners.
fn add_front(
    border: &PlaneLoop,
    (distance, far): (f64, f64),
    corners: CornerStyle,
    tolerance: Tolerance,
    front: &mut Front,
) -> Result<(), GeomError> {
    let n = border.arcs.len();
    for (i, arc) in border.arcs.iter().enumerate() {
        for piece in lines_and_rounds(arc)? {
            match piece.offset_of_moved(distance, DVec3::Z, tolerance, far) {
                Ok(offset) => {
                    let branches = offset.curve.parts_at(&offset.cusps)?.into_iter();
                    front.arcs.extend(branches.filter(|branch| !runs_back(branch, &piece)));
                }
                // All of it comes to one point.
                Err(GeomError::Construction(ConstructionError::VanishingOffset { .. })) => {}
                Err(error) => return Err(error),
            }
        }
        let next = &border.arcs[(i + 1) % n];
        let corner = next.start();
        let angle = corner_turn(arc, next, tolerance)?;
        let is_hollow = angle * distance < 0.0;
        // What goes on behind the crossing at a corner all but straight is not known to be covered.
        let is_sharp = 2.0 * SLACK * tolerance.distance < distance.abs() * (1.0 - libm::cos(angle));
        let is_open = match corners {
            CornerStyle::Round => !is_hollow,
            CornerStyle::Miter | CornerStyle::Bevel => !is_hollow || is_sharp,
        };
        if angle.abs() <= tolerance.angle || !is_open {
            continue;
        }
        let ends = [
            arc.tangent_at(arc.domain().end(), Side::Left)?,
            next.tangent_at(next.domain().start(), Side::Right)?,
        ];
        let [from, to] = ends.map(|tangent| corner + tangent.cross(DVec3::Z) * distance);
        if norm(to - from) <= tolerance.distance {
            continue;
        }
        if corners == CornerStyle::Round {
            front.arcs.push(arc_about(corner, from, to, distance)?);
            continue;
        }
        front.corners.push(corner);
        if is_hollow {
            // Where what is beside a side ends, should a cut corner nearby leave that open.
            front.push_lines(&[from, corner, to])?;
            continue;
        }
        let mut chain = vec![from, to];
        if corners == CornerStyle::Miter {
            chain.splice(1..1, mitre([from, to], ends, angle, distance));
        }
        front.push_lines(&chain)?;
        front.wedges.push(Wedge::new(corner, &chain, distance));
    }
    Ok(())
}

/// Where both sides of a corner go to from the ends of their offsets: the place where they meet, or those at which
/// what cuts them off does.
fn mitre([from, to]: [DVec3; 2], tangents: [DVec3; 2], angle: f64, distance: f64) -> Vec<DVec3> {
    let (sine, cosine) = (libm::sin(0.5 * angle).abs(), libm::cos(0.5 * angle));
    let is_whole = 1.0 <= LONGEST_MITRE * cosine;
    let onward = distance.abs()
        * match is_whole {
            true => sine / cosine,
            false => (LONGEST_MITRE - cosine) / sine,
        };
    let tips = vec![from + tangents[0] * onward, to - tangents[1] * onward];
    if is_whole { vec![0.5 * (tips[0] + tips[1])] } else { tips }
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
