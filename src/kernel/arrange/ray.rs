//! How often rings go around what lies on either side of an edge.
//!
//! A ray leaves the edge along an axis. Pieces of edges whose boxes it misses are left out, of those all
//! ahead of its start only the sides of their ends count, the others are halved: no crossing is solved for. Rings whose
//! box the start is outside of do not count: where few others are, only their pieces are asked.
//! Where a piece comes so near to the start that its side cannot be told, another start is taken.

use std::{borrow::Cow, collections::BTreeMap};

use glam::DVec3;

use super::{Arrangement, PlaneEdge};
use crate::{
    Bounds, NurbsCurve,
    box_tree::BoxTree,
    ceiling::RAY_STRIPS,
    curve::part::{CurvePart, parts},
    homogeneous,
    tolerance::LAST_BIT,
};

/// Where on an edge a ray may begin, by fractions.
const STARTS: [f64; 7] = [0.5, 0.382, 0.618, 0.25, 0.75, 0.1, 0.9];

/// Halvings of a piece in search of the side on which it passes a place.
const HALVINGS: usize = 60;

/// Last bits of its coordinates within which a piece is at a place.
const NEAR_ROUNDINGS: f64 = 16.0;

/// A side of an edge, seen along it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum EdgeSide {
    /// On which its rings have what they go around.
    Left,
    Right,
}

/// How often each group's rings go around what is on a side of an edge; others do not.
pub(crate) type Windings = Vec<(usize, i32)>;

/// A piece of an edge.
struct EdgePiece {
    edge: usize,
    part: CurvePart,
    /// Where it starts and ends: vertices, or places inside of the edge.
    ends: [DVec3; 2],
    bounds: Bounds,
}

/// A half-line along an axis.
#[derive(Clone, Copy)]
struct Ray {
    start: DVec3,
    /// 0 for x, 1 for y.
    axis: usize,
}

/// Pieces by strips along one axis.
struct Strips {
    /// The axis across the strips.
    axis: usize,
    start: f64,
    width: f64,
    pieces: Vec<Vec<usize>>,
}

/// The pieces of the rings of a group, in their order.
struct GroupPieces {
    group: usize,
    pieces: Vec<usize>,
}

/// The pieces of all edges, and where each group's are.
pub(crate) struct RaySearch<'a> {
    vertices: &'a [DVec3],
    edges: &'a [PlaneEdge],
    pieces: Vec<EdgePiece>,
    strips: [Strips; 2],
    /// By their numbers.
    groups: Vec<GroupPieces>,
    /// Around each of them, in the plane.
    boxes: BoxTree,
}

impl<'a> RaySearch<'a> {
    pub(crate) fn new(arrangement: &'a Arrangement) -> Self {
        let edges = &arrangement.edges;
        let mut pieces = Vec::new();
        for (number, edge) in edges.iter().enumerate() {
            let ends = edge.ends.map(|vertex| arrangement.vertices[vertex]);
            let made = pieces_of(&edge.curve, ends);
            pieces.extend(made.into_iter().map(|(part, ends, bounds)| EdgePiece {
                edge: number,
                part,
                ends,
                bounds,
            }));
        }
        let mut by_group: BTreeMap<usize, (Bounds, Vec<usize>)> = BTreeMap::new();
        for (number, piece) in pieces.iter().enumerate() {
            for &(group, _) in &edges[piece.edge].passes {
                let (whole, own) = by_group.entry(group).or_insert((piece.bounds, Vec::new()));
                *whole = whole.union(piece.bounds);
                own.push(number);
            }
        }
        let in_plane = |&(Bounds { min, max }, _): &(Bounds, _)| Bounds {
            min: min.with_z(0.0),
            max: max.with_z(0.0),
        };
        let boxes = BoxTree::new(by_group.values().map(in_plane).collect());
        let groups = by_group.into_iter();
        let groups = groups.map(|(group, (_, pieces))| GroupPieces { group, pieces }).collect();
        // A ray along x is looked up across y.
        let strips = [Strips::of(&pieces, 1), Strips::of(&pieces, 0)];
        Self { vertices: &arrangement.vertices, edges, pieces, strips, groups, boxes }
    }

    /// The windings on the left and on the right of an edge; none where they cannot be told.
    pub(crate) fn around(&self, number: usize) -> Option<[Windings; 2]> {
        STARTS.iter().find_map(|&fraction| self.around_at(number, fraction))
    }

    fn around_at(&self, number: usize, fraction: f64) -> Option<[Windings; 2]> {
        let edge = &self.edges[number];
        let t = edge.curve.domain().at(fraction);
        let [before, behind] = edge.curve.split(t).ok()?;
        let tangent = edge.curve.derivatives_at(t, 1)[1].try_normalize()?;
        let axis = usize::from(tangent.y.abs() < tangent.x.abs());
        let ray = Ray { start: behind.start(), axis };
        let mut windings: Windings = Vec::new();
        let mut add = |passes: &[(usize, i32)], times: i32| {
            for &(group, passes) in passes.iter().filter(|_| times != 0) {
                match windings.iter_mut().find(|winding| winding.0 == group) {
                    Some(winding) => winding.1 += times * passes,
                    None => windings.push((group, times * passes)),
                }
            }
        };
        let ends = edge.ends.map(|vertex| self.vertices[vertex]);
        let own = own_crossings(&before, ends[0], ray, true)?
            + own_crossings(&behind, ends[1], ray, false)?;
        add(&edge.passes, own);
        let around = self.groups_around(edge, ray.start);
        let is_around = |group: usize| {
            around.binary_search_by_key(&group, |&place| self.groups[place].group).is_ok()
        };
        for &piece in &*self.pieces_ahead(&around, ray) {
            let piece = &self.pieces[piece];
            if piece.edge == number || ray.misses(piece.bounds) {
                continue;
            }
            let passes = &self.edges[piece.edge].passes;
            if passes.iter().any(|&(group, _)| is_around(group)) {
                add(passes, ray.crossings(&piece.part, piece.ends, HALVINGS)?);
            }
        }
        // Those of groups that are not around it are not all counted, and nothing.
        windings.retain(|&(group, _)| is_around(group));
        let along = DVec3::from_array(if axis == 0 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] });
        let leaves_left = 0.0 < tangent.cross(along).z;
        let mut other = windings.clone();
        for &(group, passes) in &edge.passes {
            let passes = if leaves_left { -passes } else { passes };
            match other.iter_mut().find(|winding| winding.0 == group) {
                Some(winding) => winding.1 += passes,
                None => other.push((group, passes)),
            }
        }
        Some(if leaves_left { [windings, other] } else { [other, windings] })
    }

    /// The places, among all groups, of those that may go around the start of a ray on an edge.
    ///
    /// Rings whose box it is outside of do not, but for those that run along the edge: of an edge along their box
    /// rounding alone tells on which side of that a place of it is.
    fn groups_around(&self, edge: &PlaneEdge, start: DVec3) -> Vec<usize> {
        let mut around = self.boxes.beside(start.with_z(0.0), 0.0);
        let place_of =
            |group: usize| self.groups.binary_search_by_key(&group, |own| own.group).ok();
        around.extend(edge.passes.iter().filter_map(|&(group, _)| place_of(group)));
        around.sort_unstable();
        around.dedup();
        around
    }

    /// The pieces, of those of some groups or of all, that a ray may cross.
    fn pieces_ahead(&self, groups: &[usize], ray: Ray) -> Cow<'_, [usize]> {
        let in_strip = self.strips[ray.axis].at(ray.start);
        let own = || groups.iter().flat_map(|&place| &self.groups[place].pieces);
        if in_strip.len() <= own().count() {
            return Cow::Borrowed(in_strip);
        }
        let mut pieces: Vec<usize> = own().copied().collect();
        // Those of edges of several groups are among each.
        pieces.sort_unstable();
        pieces.dedup();
        Cow::Owned(pieces)
    }
}

impl Strips {
    fn of(pieces: &[EdgePiece], axis: usize) -> Self {
        let whole = pieces.iter().map(|piece| piece.bounds).reduce(Bounds::union);
        let [start, size] = whole.map_or([0.0, 0.0], |b| [b.min[axis], b.size()[axis]]);
        let sum: f64 = pieces.iter().map(|piece| piece.bounds.size()[axis]).sum();
        let n = (size * pieces.len() as f64 / sum).ceil();
        let n = if n.is_finite() { (n as usize).clamp(1, RAY_STRIPS) } else { 1 };
        let mut strips = Self { axis, start, width: size / n as f64, pieces: vec![Vec::new(); n] };
        for (number, piece) in pieces.iter().enumerate() {
            let [low, high] = [piece.bounds.min[axis], piece.bounds.max[axis]];
            for strip in strips.number(low)..=strips.number(high) {
                strips.pieces[strip].push(number);
            }
        }
        strips
    }

    fn number(&self, place: f64) -> usize {
        let number = ((place - self.start) / self.width).floor();
        if number.is_finite() { (number.max(0.0) as usize).min(self.pieces.len() - 1) } else { 0 }
    }

    fn at(&self, point: DVec3) -> &[usize] {
        &self.pieces[self.number(point[self.axis])]
    }
}

impl Ray {
    /// Whether it does not come to a box, other than along its border.
    fn misses(self, bounds: Bounds) -> bool {
        let (along, across) = (self.axis, 1 - self.axis);
        bounds.max[along] < self.start[along]
            || bounds.max[across] <= self.start[across]
            || self.start[across] < bounds.min[across]
    }

    /// How often a piece from end to end crosses it from right to left, less how often from left to
    /// right; none where the piece is at its start.
    fn crossings(self, part: &CurvePart, ends: [DVec3; 2], n_halvings: usize) -> Option<i32> {
        let bounds = part.bounds.with(ends[0]).with(ends[1]);
        if self.misses(bounds) {
            return Some(0);
        }
        let (along, across) = (self.axis, 1 - self.axis);
        if self.start[along] < bounds.min[along] {
            let is_beyond = |point: DVec3| i32::from(self.start[across] < point[across]);
            let up = is_beyond(ends[1]) - is_beyond(ends[0]);
            return Some(if along == 0 { up } else { -up });
        }
        if n_halvings == 0 || bounds.diagonal() <= NEAR_ROUNDINGS * LAST_BIT * bounds.magnitude() {
            return None;
        }
        let halves = part.halves();
        let middle = homogeneous::project(halves[1].points[0]);
        let before = self.crossings(&halves[0], [ends[0], middle], n_halvings - 1)?;
        Some(before + self.crossings(&halves[1], [middle, ends[1]], n_halvings - 1)?)
    }
}

/// The Bézier pieces of a curve from one place to another, and their boxes.
fn pieces_of(curve: &NurbsCurve, ends: [DVec3; 2]) -> Vec<(CurvePart, [DVec3; 2], Bounds)> {
    let parts = parts(curve);
    let first = |part: &CurvePart| homogeneous::project(part.points[0]);
    let starts: Vec<DVec3> = parts
        .iter()
        .enumerate()
        .map(|(i, part)| if i == 0 { ends[0] } else { first(part) })
        .collect();
    let made = parts.into_iter().enumerate().map(|(i, part)| {
        let own = [starts[i], starts.get(i + 1).copied().unwrap_or(ends[1])];
        let bounds = part.bounds.with(own[0]).with(own[1]);
        (part, own, bounds)
    });
    made.collect()
}

/// How often the rest of an edge on one side of the start of a ray crosses that, other than there; it ends in
/// `vertex`, where others go on. None where the ray passes between that and the end of the curve.
fn own_crossings(curve: &NurbsCurve, vertex: DVec3, ray: Ray, ends_there: bool) -> Option<i32> {
    let ends = if ends_there { [vertex, curve.end()] } else { [curve.start(), vertex] };
    let mut pieces = pieces_of(curve, ends);
    let (part, ends, _) = if ends_there { pieces.pop()? } else { pieces.remove(0) };
    let mut sum = 0;
    for (part, ends, _) in &pieces {
        sum += ray.crossings(part, *ends, HALVINGS)?;
    }
    let (mut part, mut ends) = (part, ends);
    let across = 1 - ray.axis;
    for _ in 0..HALVINGS {
        let places: Vec<f64> =
            part.points.iter().map(|&point| homogeneous::place(point)[across]).collect();
        let rises = places.windows(2).all(|pair| pair[0] < pair[1]);
        // What runs one way comes back to the line of the ray nowhere.
        if rises || places.windows(2).all(|pair| pair[1] < pair[0]) {
            let [from, to] = ends.map(|end| end[across]);
            return if rises { from < to } else { to < from }.then_some(sum);
        }
        let [first, second] = part.halves();
        let middle = homogeneous::project(second.points[0]);
        let (far, near) = if ends_there { (first, second) } else { (second, first) };
        let (far_ends, near_ends) = match ends_there {
            true => ([ends[0], middle], [middle, ends[1]]),
            false => ([middle, ends[1]], [ends[0], middle]),
        };
        sum += ray.crossings(&far, far_ends, HALVINGS)?;
        (part, ends) = (near, near_ends);
    }
    None
}

/// How often closed chains of arcs go around a place; none where one of them is there.
pub(crate) fn winding_about<'c>(
    chains: impl Iterator<Item = &'c [NurbsCurve]>,
    place: DVec3,
) -> Option<i32> {
    let ray = Ray { start: place, axis: 0 };
    let mut sum = 0;
    for arcs in chains {
        for (i, arc) in arcs.iter().enumerate() {
            // The start of the next is the end of this one.
            let ends = [arc.start(), arcs[(i + 1) % arcs.len()].start()];
            let around = arc.bounds().with(ends[0]).with(ends[1]);
            let margin = NEAR_ROUNDINGS * LAST_BIT * around.magnitude();
            if ray.misses(Bounds { min: around.min - margin, max: around.max + margin }) {
                continue;
            }
            for (part, ends, _) in pieces_of(arc, ends) {
                sum += ray.crossings(&part, ends, HALVINGS)?;
            }
        }
    }
    Some(sum)
}
