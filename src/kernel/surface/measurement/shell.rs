//! Whether surfaces close, and which way they face.
//!
//! Every place of every edge must lie on one other edge, of the same or of another surface. Edges
//! need not match one to one: four arcs may close a circle. Seen along such a pair, surfaces that
//! face alike have their boundaries run against one another.

use glam::DVec3;
use thiserror::Error;

use crate::{
    Bounds, GeomError, Tolerance,
    digits::few_digits,
    frame::unit,
    sorting::sort_by,
    surface::{
        Edge, Surface,
        measurement::border::{LineDistance, SurfaceBorder},
    },
    tolerance::{DETAIL_RELATIVE, FINER_FACTOR, VANISHING_RELATIVE},
};

/// Why surfaces enclose nothing. Edges are called as in scripts, surfaces by their index.
///
/// ```
/// use virote_kernel::{Frame, GeomError, NurbsSurface, ShellError, Surface, Tolerance, volume_mass};
///
/// // A cylinder without its lids encloses nothing.
/// let pipe = Surface::from(NurbsSurface::cone(Frame::XY, [1.0, 1.0], 2.0)?);
/// let found = volume_mass(&[pipe], Tolerance::DEFAULT);
/// assert!(matches!(found, Err(GeomError::Shell(ShellError::Open { .. }))));
/// # Ok::<(), GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum ShellError {
    /// An edge without a neighbour.
    #[error(
        "the surfaces do not close: edge \"{edge}\"{} is {} from the nearest other edge, at {}",
        if *n_surfaces < 2 { String::new() } else { format!(" of surface [{surface}]") },
        few_digits(*gap), place(*point)
    )]
    Open {
        surface: usize,
        n_surfaces: usize,
        edge: &'static str,
        gap: f64,
        point: DVec3,
        /// How far apart edges may be that are one.
        allowed: f64,
        /// How large all edges are together.
        size: f64,
    },
    /// The only edge there is.
    #[error("the surface does not close: there is no edge but \"{edge}\"")]
    Alone { edge: &'static str },
    /// More than two surfaces at one edge.
    #[error(
        "edge \"{edge}\" of surface [{surface}] meets {n_others} other edges at {}, {others}; what encloses a volume has two surfaces at each edge",
        place(*point)
    )]
    Crowded { surface: usize, edge: &'static str, n_others: usize, others: String, point: DVec3 },
    /// Surfaces that cannot face alike.
    #[error(
        "the surfaces have one side only, like a Möbius strip: edge \"{edge}\" of surface [{surface}] meets its neighbour turned over"
    )]
    OneSided { surface: usize, edge: &'static str },
}

impl ShellError {
    /// For a gap that is small beside the whole, the gap and the tolerance that it is beyond.
    #[must_use]
    pub fn slit(&self) -> Option<[String; 2]> {
        match *self {
            Self::Open { gap, allowed, size, .. } if gap < DETAIL_RELATIVE * size => {
                Some([gap, allowed].map(few_digits))
            }
            _ => None,
        }
    }
}

/// A measured point for a message.
fn place(point: DVec3) -> String {
    format!("({}, {}, {})", few_digits(point.x), few_digits(point.y), few_digits(point.z))
}

/// Places of each edge where its neighbour is looked for.
const PLACES: usize = 48;

/// Surfaces that hang together, with the sign that makes them face alike.
#[derive(Clone, Debug)]
pub(in crate::surface) struct Shell {
    /// Index of a surface, and 1 or −1.
    pub(in crate::surface) surfaces: Vec<(usize, f64)>,
    /// Whether all signs are 1.
    pub(in crate::surface) was_oriented: bool,
    /// Whether all edges have neighbours.
    pub(in crate::surface) is_closed: bool,
}

/// An edge that has a length.
struct ShellEdge<'a> {
    surface: usize,
    edge: Edge,
    border: SurfaceBorder<'a>,
    /// Places between its ends: the point, and the way of the boundary with the surface to its left.
    places: Vec<(DVec3, DVec3)>,
    ends: [DVec3; 2],
    bounds: Bounds,
    /// The longest step from place to place.
    slack: f64,
    nearest: LineDistance,
}

/// Two surfaces that share an edge, and whether one of them must turn.
struct EdgeNeighbours {
    surfaces: [usize; 2],
    must_turn: bool,
    edge: Edge,
}

/// A place of an edge that several others touch: which, and the cosines of their ways with its own.
struct TouchingEdges {
    rim: usize,
    point: DVec3,
    others: Vec<(usize, f64)>,
}

/// What the places of all edges meet.
#[derive(Default)]
struct EdgeContacts {
    pairs: Vec<EdgeNeighbours>,
    /// Whether some place of the edge has one neighbour.
    has_pair: Vec<bool>,
    crowds: Vec<TouchingEdges>,
    /// Surfaces with places that have no neighbour.
    with_ends: Vec<usize>,
}

/// Another edge that is near enough to a place.
struct EdgeContact {
    rim: usize,
    /// The cosine between the ways.
    along: f64,
    /// Whether it comes that near with an end.
    is_end: bool,
}

/// The shells that the surfaces make.
///
/// Where the tolerance leaves open which edges belong together, finer ones decide: what closes
/// within one of them closes. Where an edge `may_end` without a neighbour, shells may be open.
///
/// # Errors
/// [`ShellError`], of gaps that at the place which is furthest from all other edges; as
/// [`Surface::point_at`].
pub(in crate::surface) fn oriented(
    surfaces: &[Surface],
    tolerance: Tolerance,
    may_end: bool,
) -> Result<Vec<Shell>, GeomError> {
    let edges = edges(surfaces)?;
    let Some(whole) = edges.iter().map(|edge| edge.bounds).reduce(Bounds::union) else {
        return hanging_together(surfaces.len(), &EdgeContacts::default());
    };
    let least = VANISHING_RELATIVE * whole.magnitude();
    let mut allowed = tolerance.distance_for(whole.diagonal()).max(least);
    let first = within(surfaces.len(), &edges, allowed, false);
    match &first {
        Err(GeomError::Shell(ShellError::Open { .. } | ShellError::Alone { .. })) if may_end => {
            return within(surfaces.len(), &edges, allowed, true);
        }
        Err(GeomError::Shell(ShellError::Crowded { .. } | ShellError::OneSided { .. })) => {
            while least < allowed {
                allowed = (allowed * FINER_FACTOR).max(least);
                if let Ok(shells) = within(surfaces.len(), &edges, allowed, false) {
                    return Ok(shells);
                }
            }
        }
        _ => {}
    }
    first
}

/// The shells, where points nearer than `allowed` are one.
///
/// An edge that lies within that is collapsed: it closes itself. Several edges may run together for
/// a while, as those of a deck and of two sides of a hull before they end in a point; the places
/// where each has one neighbour tell how they belong together. Edges that run together all along
/// must pass each other in pairs.
fn within(
    n_surfaces: usize,
    edges: &[ShellEdge<'_>],
    allowed: f64,
    may_end: bool,
) -> Result<Vec<Shell>, GeomError> {
    let rims: Vec<&ShellEdge<'_>> =
        edges.iter().filter(|edge| 2.0 * allowed < edge.bounds.diagonal()).collect();
    let met = meet(n_surfaces, &rims, allowed, may_end)?;
    let shells = hanging_together(n_surfaces, &met)?;
    let mut signs = vec![1.0; n_surfaces];
    for &(surface, sign) in shells.iter().flat_map(|shell| &shell.surfaces) {
        signs[surface] = sign;
    }
    for TouchingEdges { rim, point, others } in met.crowds {
        if met.has_pair[rim] {
            continue;
        }
        let sign_of = |rim: usize| signs[rims[rim].surface];
        let passing = others.iter().map(|&(other, along)| sign_of(other) * along).sum::<f64>();
        if (sign_of(rim) + passing).abs() < 0.5 {
            continue;
        }
        let called = |&(other, _): &(usize, f64)| {
            format!("\"{}\" of [{}]", rims[other].edge.word(), rims[other].surface)
        };
        return Err(ShellError::Crowded {
            surface: rims[rim].surface,
            edge: rims[rim].edge.word(),
            n_others: others.len(),
            others: others.iter().map(called).collect::<Vec<_>>().join(", "),
            point,
        }
        .into());
    }
    Ok(shells)
}

/// # Errors
/// [`ShellError::Open`] and [`ShellError::Alone`]; as [`Surface::point_at`].
fn meet(
    n_surfaces: usize,
    rims: &[&ShellEdge<'_>],
    allowed: f64,
    may_end: bool,
) -> Result<EdgeContacts, GeomError> {
    let mut met = EdgeContacts { has_pair: vec![false; rims.len()], ..EdgeContacts::default() };
    let mut gap: Option<(f64, usize, DVec3)> = None;
    for (idx, rim) in rims.iter().enumerate() {
        for &(point, way) in &rim.places {
            let (least, touching) = touching(rims, idx, point, way, allowed)?;
            let inner: Vec<&EdgeContact> = touching.iter().filter(|touch| !touch.is_end).collect();
            let partner = match (&touching[..], &inner[..]) {
                ([], _) => {
                    if gap.is_none_or(|(most, ..)| most < least) {
                        gap = Some((least, idx, point));
                    }
                    met.with_ends.push(rim.surface);
                    continue;
                }
                ([one], _) => Some(one),
                (_, [one]) => Some(*one),
                _ => None,
            };
            if let Some(&EdgeContact { rim: other, along, .. }) = partner {
                met.has_pair[idx] = true;
                met.pairs.push(EdgeNeighbours {
                    surfaces: [rim.surface, rims[other].surface],
                    must_turn: 0.0 < along,
                    edge: rim.edge,
                });
            } else {
                let others = touching.iter().map(|touch| (touch.rim, touch.along)).collect();
                met.crowds.push(TouchingEdges { rim: idx, point, others });
            }
        }
    }
    let Some((gap, idx, point)) = gap.filter(|_| !may_end) else { return Ok(met) };
    let (surface, edge) = (rims[idx].surface, rims[idx].edge.word());
    if !gap.is_finite() {
        return Err(ShellError::Alone { edge }.into());
    }
    let whole = rims.iter().map(|rim| rim.bounds).reduce(Bounds::union);
    let size = whole.map_or(0.0, Bounds::diagonal);
    Err(ShellError::Open { surface, n_surfaces, edge, gap, point, allowed, size }.into())
}

/// The other edges that are near enough to a place of one, and how far the nearest is.
fn touching(
    rims: &[&ShellEdge<'_>],
    idx: usize,
    point: DVec3,
    way: DVec3,
    allowed: f64,
) -> Result<(f64, Vec<EdgeContact>), GeomError> {
    let mut others: Vec<(f64, usize)> = (0..rims.len())
        .filter(|&other| other != idx)
        .map(|other| (rims[other].distance_at_least(point), other))
        .collect();
    sort_by(&mut others, |a, b| a.0.total_cmp(&b.0));
    let mut touching = Vec::new();
    let mut least = f64::INFINITY;
    for (could_be, rim) in others {
        if least.max(allowed) < could_be {
            break;
        }
        let (foot, other_way) = rims[rim].nearest(point)?;
        let distance = foot.distance(point);
        least = least.min(distance);
        if distance <= allowed {
            let along = unit(way).zip(unit(other_way)).map_or(0.0, |(a, b)| a.dot(b));
            let is_end = rims[rim].ends.iter().any(|end| end.distance(foot) <= allowed);
            touching.push(EdgeContact { rim, along, is_end });
        }
    }
    Ok((least, touching))
}

/// Walks from surface to surface over their common edges.
fn hanging_together(n_surfaces: usize, met: &EdgeContacts) -> Result<Vec<Shell>, GeomError> {
    let mut has_end = vec![false; n_surfaces];
    met.with_ends.iter().for_each(|&surface| has_end[surface] = true);
    let mut neighbours: Vec<Vec<(usize, bool, Edge)>> = vec![Vec::new(); n_surfaces];
    for pair in &met.pairs {
        let [a, b] = pair.surfaces;
        neighbours[a].push((b, pair.must_turn, pair.edge));
    }
    let mut signs: Vec<Option<f64>> = vec![None; n_surfaces];
    let mut shells = Vec::new();
    for start in 0..n_surfaces {
        if signs[start].is_some() {
            continue;
        }
        signs[start] = Some(1.0);
        let mut members = vec![(start, 1.0)];
        let mut n_visited = 0;
        while let Some(&(surface, own)) = members.get(n_visited) {
            n_visited += 1;
            for &(next, must_turn, edge) in &neighbours[surface] {
                let sign = if must_turn { -own } else { own };
                match signs[next] {
                    None => {
                        signs[next] = Some(sign);
                        members.push((next, sign));
                    }
                    Some(known) if known * sign < 0.0 => {
                        return Err(ShellError::OneSided { surface, edge: edge.word() }.into());
                    }
                    Some(_) => {}
                }
            }
        }
        let was_oriented = members.iter().all(|&(_, sign)| 0.0 < sign);
        let is_closed = members.iter().all(|&(surface, _)| !has_end[surface]);
        shells.push(Shell { surfaces: members, was_oriented, is_closed });
    }
    Ok(shells)
}

/// The edges that have a length.
fn edges(surfaces: &[Surface]) -> Result<Vec<ShellEdge<'_>>, GeomError> {
    let mut edges = Vec::new();
    for (surface_idx, surface) in surfaces.iter().enumerate() {
        for edge in Edge::ALL {
            let border = SurfaceBorder::edge(surface, edge);
            let along = border.along();
            let mut places = Vec::with_capacity(PLACES);
            for i in 0..PLACES {
                let (point, tangent) = border.step(along.at((i as f64 + 0.5) / PLACES as f64))?;
                places.push((point, boundary_sign(edge) * tangent));
            }
            let ends = [border.step(along.start())?.0, border.step(along.end())?.0];
            let points = places.iter().map(|&(point, _)| point).chain(ends);
            let Some(bounds) = Bounds::of(points) else { continue };
            if bounds.diagonal() <= VANISHING_RELATIVE * bounds.magnitude() {
                continue;
            }
            let steps = places.windows(2).map(|pair| pair[0].0.distance(pair[1].0));
            let slack = steps.fold(0.0, f64::max);
            let nearest = border.nearest()?;
            edges.push(ShellEdge {
                surface: surface_idx,
                edge,
                border,
                places,
                ends,
                bounds,
                slack,
                nearest,
            });
        }
    }
    Ok(edges)
}

/// 1 where the edge runs with the surface to its left, seen from the tip of Su × Sv.
fn boundary_sign(edge: Edge) -> f64 {
    match edge {
        Edge::U0 | Edge::V1 => -1.0,
        Edge::U1 | Edge::V0 => 1.0,
    }
}

impl ShellEdge<'_> {
    /// Less than the distance of the point from the edge, which leaves the box of its places by no
    /// more than their steps.
    fn distance_at_least(&self, point: DVec3) -> f64 {
        point.distance(point.clamp(self.bounds.min, self.bounds.max)) - 2.0 * self.slack
    }

    /// The nearest place, and the way of the boundary there.
    fn nearest(&self, point: DVec3) -> Result<(DVec3, DVec3), GeomError> {
        let (foot, tangent) = self.border.step(self.nearest.parameter(point)?)?;
        Ok((foot, boundary_sign(self.edge) * tangent))
    }
}
