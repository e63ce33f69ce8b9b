//! Whether surfaces close, and which way they face.
//!
//! Every place of every edge must lie on one other edge, of the same or of another surface. Edges
//! need not match one to one: four arcs may close a circle. Seen along such a pair, surfaces that
//! face alike have their boundaries run against one another.

use glam::DVec3;
use thiserror::Error;

use super::{
    Edge, Surface,
    border::{Border, Nearest},
};
use crate::kernel::{
    Bounds, GeomError, Tolerance, digits::few_digits, tolerance::VANISHING_RELATIVE,
};

/// Why surfaces enclose nothing. Edges are called as in scripts, surfaces by their index.
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum ShellError {
    /// An edge without a neighbour.
    #[error(
        "the surfaces do not close: edge \"{edge}\"{} is {} from the nearest other edge, at {}",
        if *n_surfaces < 2 { String::new() } else { format!(" of surface [{surface}]") },
        few_digits(*gap), place(*point)
    )]
    Open { surface: usize, n_surfaces: usize, edge: &'static str, gap: f64, point: DVec3 },
    /// The only edge there is.
    #[error("the surface does not close: there is no edge but \"{edge}\"")]
    Alone { edge: &'static str },
    /// More than two surfaces at one edge.
    #[error(
        "edge \"{edge}\" of surface [{surface}] meets {others} other edges at {}; what encloses a volume has two surfaces at each edge",
        place(*point)
    )]
    Crowded { surface: usize, edge: &'static str, others: usize, point: DVec3 },
    /// Surfaces that cannot face alike.
    #[error(
        "the surfaces have one side only, like a Möbius strip: edge \"{edge}\" of surface [{surface}] meets its neighbour turned over"
    )]
    OneSided { surface: usize, edge: &'static str },
}

/// A measured point for a message.
fn place(point: DVec3) -> String {
    format!("({}, {}, {})", few_digits(point.x), few_digits(point.y), few_digits(point.z))
}

/// Places of each edge where its neighbour is looked for.
const PLACES: usize = 48;

/// Surfaces that hang together, with the sign that makes them face alike.
#[derive(Clone, Debug)]
pub(super) struct Shell {
    /// Index of a surface, and 1 or −1.
    pub(super) surfaces: Vec<(usize, f64)>,
    /// Whether all signs are 1.
    pub(super) was_oriented: bool,
}

/// An edge that has a length.
struct Rim<'a> {
    surface: usize,
    edge: Edge,
    border: Border<'a>,
    /// Places between its ends: the point, and the way of the boundary with the surface to its left.
    places: Vec<(DVec3, DVec3)>,
    bounds: Bounds,
    /// The longest step from place to place.
    slack: f64,
    nearest: Nearest,
}

/// Two surfaces that share an edge, and whether one of them must turn.
struct Pair {
    surfaces: [usize; 2],
    must_turn: bool,
    edge: Edge,
}

/// The shells that the surfaces make.
///
/// # Errors
/// [`ShellError`], of gaps that at the place which is furthest from all other edges; as
/// [`Surface::point_at`].
pub(super) fn oriented(
    surfaces: &[Surface],
    tolerance: Tolerance,
) -> Result<Vec<Shell>, GeomError> {
    let rims = rims(surfaces, tolerance)?;
    let allowed = allowed(&rims, tolerance);
    let mut pairs = Vec::new();
    let mut gap: Option<(f64, usize, DVec3)> = None;
    for (idx, rim) in rims.iter().enumerate() {
        for &(point, way) in &rim.places {
            let mut others: Vec<(f64, usize)> = (0..rims.len())
                .filter(|&other| other != idx)
                .map(|other| (rims[other].distance_at_least(point), other))
                .collect();
            others.sort_by(|a, b| a.0.total_cmp(&b.0));
            let mut touching = Vec::new();
            let mut least = f64::INFINITY;
            for (could_be, other_idx) in others {
                if least.max(allowed) < could_be {
                    break;
                }
                let (distance, other_way) = rims[other_idx].nearest(point)?;
                least = least.min(distance);
                if distance <= allowed {
                    touching.push((other_idx, way.dot(other_way)));
                }
            }
            match touching[..] {
                [] => {
                    if gap.is_none_or(|(most, ..)| most < least) {
                        gap = Some((least, idx, point));
                    }
                }
                [(other, along)] => pairs.push(Pair {
                    surfaces: [rim.surface, rims[other].surface],
                    must_turn: 0.0 < along,
                    edge: rim.edge,
                }),
                _ => {
                    return Err(ShellError::Crowded {
                        surface: rim.surface,
                        edge: rim.edge.word(),
                        others: touching.len(),
                        point,
                    }
                    .into());
                }
            }
        }
    }
    if let Some((gap, idx, point)) = gap {
        let (surface, edge) = (rims[idx].surface, rims[idx].edge.word());
        if !gap.is_finite() {
            return Err(ShellError::Alone { edge }.into());
        }
        let n_surfaces = surfaces.len();
        return Err(ShellError::Open { surface, n_surfaces, edge, gap, point }.into());
    }
    hanging_together(surfaces.len(), &pairs)
}

/// Walks from surface to surface over their common edges.
fn hanging_together(n_surfaces: usize, pairs: &[Pair]) -> Result<Vec<Shell>, GeomError> {
    let mut neighbours: Vec<Vec<(usize, bool, Edge)>> = vec![Vec::new(); n_surfaces];
    for pair in pairs {
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
        shells.push(Shell { surfaces: members, was_oriented });
    }
    Ok(shells)
}

/// The edges that have a length: a collapsed one closes itself.
fn rims(surfaces: &[Surface], tolerance: Tolerance) -> Result<Vec<Rim<'_>>, GeomError> {
    let mut rims = Vec::new();
    for (surface_idx, surface) in surfaces.iter().enumerate() {
        for edge in Edge::ALL {
            let border = Border::edge(surface, edge);
            let along = border.along();
            let mut places = Vec::with_capacity(PLACES);
            for i in 0..PLACES {
                let (point, tangent) = border.step(along.at((i as f64 + 0.5) / PLACES as f64))?;
                places.push((point, boundary_sign(edge) * tangent));
            }
            let Some(bounds) = Bounds::of(places.iter().map(|&(point, _)| point)) else { continue };
            let steps = places.windows(2).map(|pair| pair[0].0.distance(pair[1].0));
            let slack = steps.fold(0.0, f64::max);
            if tolerance.distance_for(size(surface)?).max(rounding(&bounds)) < border.length()? {
                let nearest = border.nearest()?;
                rims.push(Rim {
                    surface: surface_idx,
                    edge,
                    border,
                    places,
                    bounds,
                    slack,
                    nearest,
                });
            }
        }
    }
    Ok(rims)
}

/// 1 where the edge runs with the surface to its left, seen from the tip of Su × Sv.
fn boundary_sign(edge: Edge) -> f64 {
    match edge {
        Edge::U0 | Edge::V1 => -1.0,
        Edge::U1 | Edge::V0 => 1.0,
    }
}

/// How large a surface is, about.
fn size(surface: &Surface) -> Result<f64, GeomError> {
    let (us, vs) = (surface.domain_u().steps(4), surface.domain_v().steps(4));
    let points = surface.points_on_grid(&us, &vs)?;
    Ok(Bounds::of(points.into_values()).map_or(0.0, Bounds::diagonal))
}

fn allowed(rims: &[Rim<'_>], tolerance: Tolerance) -> f64 {
    let whole = rims.iter().map(|rim| rim.bounds).reduce(Bounds::union);
    whole.map_or(0.0, |whole| tolerance.distance_for(whole.diagonal()).max(rounding(&whole)))
}

fn rounding(bounds: &Bounds) -> f64 {
    VANISHING_RELATIVE * bounds.magnitude()
}

impl Rim<'_> {
    /// Less than the distance of the point from the edge, which leaves the box of its places by no
    /// more than their steps.
    fn distance_at_least(&self, point: DVec3) -> f64 {
        point.distance(point.clamp(self.bounds.min, self.bounds.max)) - 2.0 * self.slack
    }

    /// How far the nearest place is, and the way of the boundary there.
    fn nearest(&self, point: DVec3) -> Result<(f64, DVec3), GeomError> {
        let (foot, tangent) = self.border.step(self.nearest.parameter(point)?)?;
        Ok((foot.distance(point), boundary_sign(self.edge) * tangent))
    }
}
