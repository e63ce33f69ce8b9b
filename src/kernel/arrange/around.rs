//! How often rings go around what lies on either side of an edge.
//!
//! A `ray` leaves the edge along an axis. Pieces of edges whose boxes it misses are left out. Rings whose
//! box the start is outside of do not count: where few others are, only their pieces are asked.
//! Where a piece comes so near to the start that its side cannot be told, another start is taken.

use std::{borrow::Cow, collections::BTreeMap};

use glam::DVec3;
use smallvec::SmallVec;

use super::{
    Arrangement, PlaneEdge,
    ray::{HALVINGS, Ray, pieces_of},
};
use crate::{
    Bounds, box_tree::BoxTree, ceiling::RAY_STRIPS, curve::part::CurvePart, homogeneous,
    tolerance::RAY_JOINT_SHARE,
};

/// Where on an edge a ray may begin, by fractions.
const STARTS: [f64; 7] = [0.5, 0.382, 0.618, 0.25, 0.75, 0.1, 0.9];

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

/// What a ray asks of a piece first: whose it is, and the box around it in the plane.
#[derive(Clone, Copy)]
struct PieceBox {
    piece: usize,
    edge: usize,
    low: [f64; 2],
    high: [f64; 2],
    /// How often the rings of the group in question run along its edge, less how often against it.
    passes: i32,
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
    pieces: Vec<PieceBox>,
}

/// The pieces of all edges, and where each group's are.
pub(crate) struct RaySearch<'a> {
    edges: &'a [PlaneEdge],
    pieces: Vec<EdgePiece>,
    /// The first piece of each edge, and behind them their number.
    first_pieces: Vec<usize>,
    strips: [Strips; 2],
    /// By their numbers.
    groups: Vec<GroupPieces>,
    /// Around each of them, in the plane.
    boxes: BoxTree,
}

impl<'a> RaySearch<'a> {
    pub(crate) fn new(arrangement: &'a Arrangement) -> Self {
        Self::of_groups(arrangement, |_| true)
    }

    /// That for the rings of some groups alone: nothing is told of others.
    pub(crate) fn of_groups(
        arrangement: &'a Arrangement,
        is_asked: impl Fn(usize) -> bool,
    ) -> Self {
        let edges = &arrangement.edges;
        let (mut pieces, mut first_pieces) = (Vec::new(), vec![0]);
        for (number, edge) in edges.iter().enumerate() {
            let ends = edge.ends.map(|vertex| arrangement.vertices[vertex]);
            let made = pieces_of(&edge.curve, ends);
            pieces.extend(made.into_iter().map(|(part, ends, bounds)| EdgePiece {
                edge: number,
                part,
                ends,
                bounds,
            }));
            first_pieces.push(pieces.len());
        }
        let mut by_group: BTreeMap<usize, (Bounds, Vec<PieceBox>)> = BTreeMap::new();
        for (number, EdgePiece { edge, bounds, .. }) in pieces.iter().enumerate() {
            for &(group, passes) in edges[*edge].passes.iter().filter(|pass| is_asked(pass.0)) {
                let (whole, own) = by_group.entry(group).or_insert((*bounds, Vec::new()));
                *whole = whole.union(*bounds);
                let [low, high] = [bounds.min, bounds.max].map(|corner| [corner.x, corner.y]);
                own.push(PieceBox { piece: number, edge: *edge, low, high, passes });
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
        Self { edges, pieces, first_pieces, strips, groups, boxes }
    }

    /// The windings on the left and on the right of an edge; none where they cannot be told.
    pub(crate) fn around(&self, number: usize) -> Option<[Windings; 2]> {
        STARTS.iter().find_map(|&fraction| self.around_at(number, fraction))
    }

    fn around_at(&self, number: usize, fraction: f64) -> Option<[Windings; 2]> {
        let edge = &self.edges[number];
        let EdgeAtPlace { tangent, before, behind } = self.at_place(number, fraction)?;
        let axis = usize::from(tangent.y.abs() < tangent.x.abs());
        let ray = Ray { start: behind.ends[0], axis };
        let own = before.crossings(ray, true)? + behind.crossings(ray, false)?;
        let around = self.groups_around(edge, ray.start);
        let mut windings = self.windings_ahead(number, &around, ray)?;
        let is_asked = |pass: &&(usize, i32)| self.place_of(pass.0).is_some();
        let passes = || edge.passes.iter().filter(is_asked);
        for &(group, passes) in passes().filter(|_| own != 0) {
            add(&mut windings, group, own * passes);
        }
        let along = DVec3::from_array(if axis == 0 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] });
        let leaves_left = 0.0 < tangent.cross(along).z;
        let mut other = windings.clone();
        for &(group, passes) in passes() {
            add(&mut other, group, if leaves_left { -passes } else { passes });
        }
        Some(if leaves_left { [windings, other] } else { [other, windings] })
    }

    /// An edge cut at a fraction of it; none where it has no direction there.
    fn at_place(&self, number: usize, fraction: f64) -> Option<EdgeAtPlace<'_>> {
        let own = &self.pieces[self.first_pieces[number]..self.first_pieces[number + 1]];
        let t = self.edges[number].curve.domain().at(fraction);
        let number = own.partition_point(|piece| piece.part.interval.end() <= t);
        let at = own.get(number)?.part.interval.fraction_of(t);
        // A part that is rounding would tell nothing.
        if !(RAY_JOINT_SHARE..=1.0 - RAY_JOINT_SHARE).contains(&at) {
            let (before, behind) = own.split_at(number + usize::from(RAY_JOINT_SHARE < at));
            let [(last, before), (first, behind)] = [before.split_last()?, behind.split_first()?];
            let tangent = direction_at_start(&first.part)?;
            let before =
                EdgeRest { others: before, near: Cow::Borrowed(&last.part), ends: last.ends };
            let behind =
                EdgeRest { others: behind, near: Cow::Borrowed(&first.part), ends: first.ends };
            return Some(EdgeAtPlace { tangent, before, behind });
        }
        let (before, behind) = (&own[..number], &own[number + 1..]);
        let piece = &own[number];
        let [low, high] = piece.part.cut_at(at)?;
        let tangent = direction_at_start(&high)?;
        let middle = homogeneous::project(high.points[0]);
        let before =
            EdgeRest { others: before, near: Cow::Owned(low), ends: [piece.ends[0], middle] };
        let behind =
            EdgeRest { others: behind, near: Cow::Owned(high), ends: [middle, piece.ends[1]] };
        Some(EdgeAtPlace { tangent, before, behind })
    }

    /// The places, among all groups, of those that may go around the start of a ray on an edge.
    ///
    /// Rings whose box it is outside of do not, but for those that run along the edge: of an edge along their box
    /// rounding alone tells on which side of that a place of it is.
    fn groups_around(&self, edge: &PlaneEdge, start: DVec3) -> Vec<usize> {
        let place = start.with_z(0.0);
        let mut around = Vec::new();
        self.boxes.visit_near(Bounds { min: place, max: place }, 0.0, |group| around.push(group));
        around.extend(edge.passes.iter().filter_map(|&(group, _)| self.place_of(group)));
        around.sort_unstable();
        around.dedup();
        around
    }

    /// The place of a group among those that are asked.
    fn place_of(&self, group: usize) -> Option<usize> {
        self.groups.binary_search_by_key(&group, |own| own.group).ok()
    }

    /// How often the rings of some groups go around the start of a ray by their edges but for one; none where a piece is
    /// there. The pieces of these are asked, or those that are in the way of the ray, whichever are fewer.
    fn windings_ahead(&self, own: usize, groups: &[usize], ray: Ray) -> Option<Windings> {
        let mut windings: Windings = Vec::new();
        let in_strip = self.strips[ray.axis].at(ray.start);
        let crossings = |number: usize| {
            let piece = &self.pieces[number];
            ray.crossings(&piece.part, piece.ends, HALVINGS)
        };
        let n_own: usize = groups.iter().map(|&place| self.groups[place].pieces.len()).sum();
        if in_strip.len() <= n_own {
            let is_around = |group: usize| {
                groups.binary_search_by_key(&group, |&place| self.groups[place].group).is_ok()
            };
            for &number in in_strip {
                let EdgePiece { edge, bounds, .. } = self.pieces[number];
                let passes = self.edges[edge].passes.iter();
                let mut passes = passes.filter(|&&(group, _)| is_around(group)).peekable();
                if edge == own || ray.misses(bounds) || passes.peek().is_none() {
                    continue;
                }
                let times = crossings(number)?;
                for &(group, passes) in passes.filter(|_| times != 0) {
                    add(&mut windings, group, times * passes);
                }
            }
            return Some(windings);
        }
        for GroupPieces { group, pieces } in groups.iter().map(|&place| &self.groups[place]) {
            let mut winding = 0;
            for piece in pieces
                .iter()
                .filter(|piece| piece.edge != own && !ray.misses_between(piece.low, piece.high))
            {
                winding += piece.passes * crossings(piece.piece)?;
            }
            if winding != 0 {
                add(&mut windings, *group, winding);
            }
        }
        Some(windings)
    }
}

/// Counts that rings of a group go around so many times more.
fn add(windings: &mut Windings, group: usize, times: i32) {
    match windings.iter_mut().find(|winding| winding.0 == group) {
        Some(winding) => winding.1 += times,
        None => windings.push((group, times)),
    }
}

/// The direction in which a piece begins; none where it stands still there.
fn direction_at_start(part: &CurvePart) -> Option<DVec3> {
    let (first, second) = (part.points.first()?, part.points.get(1)?);
    // As the derivative of a quotient.
    (second.truncate() * first.w - first.truncate() * second.w).try_normalize()
}

/// An edge at a place of it.
struct EdgeAtPlace<'a> {
    tangent: DVec3,
    before: EdgeRest<'a>,
    behind: EdgeRest<'a>,
}

/// What of an edge is on one side of a place of it: the piece that comes there, from end to end, and the others.
struct EdgeRest<'a> {
    others: &'a [EdgePiece],
    near: Cow<'a, CurvePart>,
    ends: [DVec3; 2],
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

impl EdgeRest<'_> {
    /// How often it crosses a ray from the place, other than there, where it ends or begins; none where the ray passes
    /// between a vertex and the end of the curve.
    fn crossings(self, ray: Ray, ends_there: bool) -> Option<i32> {
        let mut sum = 0;
        for EdgePiece { part, ends, .. } in self.others {
            sum += ray.crossings(part, *ends, HALVINGS)?;
        }
        let (mut part, mut ends) = (self.near, self.ends);
        let across = 1 - ray.axis;
        for _ in 0..HALVINGS {
            let places = part.points.iter().map(|&point| homogeneous::place(point)[across]);
            let places: SmallVec<[f64; 8]> = places.collect();
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
            (part, ends) = (Cow::Owned(near), near_ends);
        }
        None
    }
}
