//! How smoothly one face goes on in another along the edges that they share.
//!
//! The edges of one are looked at in many places; where the other has an edge there, both are compared as graphs over
//! the plane of the first: the same tangent plane is G1, the same second fundamental tensor G2. Peters, *Geometric
//! continuity*, in Farin, Hoschek & Kim (eds.), *Handbook of Computer Aided Geometric Design*, ch. 8.

use glam::DVec3;

use super::{Face, FaceError};
use crate::{
    GeomError, JointTolerance, NurbsCurve,
    frame::{angle_between, norm, unit},
    tolerance::{BEND_AGREES, EDGE_SHARE},
};

/// Places of each edge, in the middle of as many equal parts, at which faces are compared.
const N_PLACES: usize = 128;

/// The cosine between the ways of edges that faces share: at a corner of the other face one runs across.
const LEAST_COSINE: f64 = 0.9;

/// Neighbouring places of an edge that must be on the other face's border for faces to share it, so that a corner
/// alone is no edge.
const LEAST_RUN: usize = 2;

/// How two faces meet along the edges that they share: the worst of each.
///
/// The order is the largest up to 2 that holds. Two sides of a box have an edge, and no more, in common:
///
/// ```
/// use std::{f64::consts::FRAC_PI_2, sync::Arc};
/// use virote_kernel::{Face, NurbsSurface, Tolerance, glam::DVec3};
///
/// let [o, x, y, z] = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
/// let whole = |surface| Face::whole(Arc::new(surface), Tolerance::DEFAULT);
/// let floor = whole(NurbsSurface::bilinear(o, y, x, x + y)?)?;
/// let wall = whole(NurbsSurface::bilinear(x, x + y, x + z, x + y + z)?)?;
/// let joint = floor.continuity_with(&wall, Tolerance::DEFAULT)?;
/// assert_eq!(joint.g, 0);
/// assert!((joint.angle - FRAC_PI_2).abs() < 1e-9);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaceContinuity {
    /// 0 where they share an edge, 1 the tangent planes, 2 the second fundamental tensor as well.
    pub g: i32,
    /// Largest distance of the edges.
    pub gap: f64,
    /// Largest angle of the tangent planes, 0 where one goes on in the other and π where it turns back; radians.
    pub angle: f64,
    /// Largest difference of normal curvatures in one direction, one over model units.
    pub curvature_gap: f64,
    /// Where what fails first of angle and curvature is largest.
    pub at: DVec3,
}

/// A face beside a place of its border: where, out of it or into it, and how it bends there.
struct FaceSide {
    point: DVec3,
    /// The unit tangent of the edge, with the face to its left.
    along: DVec3,
    /// The unit tangent of the face into it, normal to the edge.
    inward: DVec3,
    normal: DVec3,
    derivatives: [DVec3; 6],
}

/// What is largest, and where.
struct Worst {
    value: f64,
    at: DVec3,
}

impl Worst {
    fn raise(&mut self, value: f64, at: DVec3) {
        if self.value < value {
            *self = Self { value, at };
        }
    }
}

impl Face {
    /// How another face goes on where this one ends, along all edges that they share.
    ///
    /// Where the edges are splines within an eighth of the tolerance, planes and bends are told apart no better than
    /// that allows.
    ///
    /// # Errors
    /// [`FaceError::NoCommonEdge`]; those of [`Self::edges`].
    pub fn continuity_with(
        &self,
        other: &Self,
        tolerance: impl Into<JointTolerance>,
    ) -> Result<FaceContinuity, GeomError> {
        let tolerance = tolerance.into();
        let edges = [self.edges(tolerance.document)?, other.edges(tolerance.document)?];
        let size = self.surface().bounds().union(other.surface().bounds()).diagonal();
        let distance = tolerance.distance_for(size, 0.0);
        let mut nearest = Worst { value: f64::NEG_INFINITY, at: self.border_place() };
        let mut found: Option<Joint> = None;
        // What is short beside the edges of one is long beside those of the other.
        for ([one, another], [own, others]) in
            [([self, other], [&edges[0], &edges[1]]), ([other, self], [&edges[1], &edges[0]])]
        {
            for edge in own {
                let mut run: Vec<[FaceSide; 2]> = Vec::new();
                for k in 0..N_PLACES {
                    GeomError::go_on(1)?;
                    let t = edge.domain().at((k as f64 + 0.5) / N_PLACES as f64);
                    let [point, way] = [0, 1].map(|order| edge.derivatives_at(t, 1)[order]);
                    let foot = foot_on(others, [point, way], distance);
                    if let Some((_, _, gap)) = foot {
                        nearest.raise(-gap, point);
                    }
                    let met = foot.filter(|&(_, along, gap)| {
                        gap <= distance && LEAST_COSINE <= cosine(way, along)
                    });
                    let sides = met.and_then(|(place, along, _)| {
                        Some([FaceSide::of(one, point, way)?, FaceSide::of(another, place, along)?])
                    });
                    match sides {
                        Some(sides) => run.push(sides),
                        None => Joint::take(&mut found, &mut run, &tolerance, distance),
                    }
                }
                Joint::take(&mut found, &mut run, &tolerance, distance);
            }
        }
        match found {
            Some(joint) => Ok(joint.told()),
            None => Err(FaceError::NoCommonEdge { gap: -nearest.value, point: nearest.at }.into()),
        }
    }
}

/// Of the angle between the lines along two ways.
fn cosine(one: DVec3, other: DVec3) -> f64 {
    one.dot(other).abs() / (norm(one) * norm(other)).max(f64::MIN_POSITIVE)
}

/// The nearest place of edges to a point on a way, with the way of the edge there and the distance; of edges within the
/// distance that which runs most along the way.
fn foot_on(
    edges: &[NurbsCurve],
    [point, way]: [DVec3; 2],
    distance: f64,
) -> Option<(DVec3, DVec3, f64)> {
    let mut nearest: Option<(DVec3, DVec3, f64)> = None;
    for edge in edges {
        let least = nearest.map_or(f64::INFINITY, |nearest| nearest.2.max(distance));
        if edge.bounds().distance(point) <= least {
            let foot = edge.closest(point, distance);
            let along = edge.derivatives_at(foot.parameter, 1)[1];
            let is_better = nearest.is_none_or(|(_, before, gap)| {
                if gap <= distance && foot.distance <= distance {
                    return cosine(way, before) < cosine(way, along);
                }
                foot.distance < gap
            });
            if is_better {
                nearest = Some((foot.point, along, foot.distance));
            }
        }
    }
    nearest
}

impl FaceSide {
    /// The side of a face at a place of an edge with a way; none where it has no tangent plane.
    fn of(face: &Face, point: DVec3, way: DVec3) -> Option<Self> {
        let [u, v] = face.surface().closest(point).parameters;
        let normal = face.surface().normal_at(u, v).ok()?;
        let along = unit(way - normal * way.dot(normal))?;
        let derivatives = face.surface().evaluator().second_order_at(u, v);
        Some(Self { point, along, inward: normal.cross(along), normal, derivatives })
    }

    /// The second fundamental tensor in the directions of two tangents, with a normal that is a sign times the own;
    /// none where the parameters have no area.
    fn bend(&self, tangents: [DVec3; 2], sign: f64) -> Option<[f64; 3]> {
        let [_, su, sv, suu, suv, svv] = self.derivatives;
        let area = su.cross(sv).dot(self.normal);
        let by =
            |d: DVec3| [d.cross(sv).dot(self.normal) / area, su.cross(d).dot(self.normal) / area];
        let second = [suu, suv, svv].map(|d| d.dot(self.normal) * sign);
        let form = |[a, b]: [f64; 2], [c, d]: [f64; 2]| {
            second[0] * a * c + second[1] * (a * d + b * c) + second[2] * b * d
        };
        let [x, y] = tangents.map(by);
        let found = [form(x, x), form(x, y), form(y, y)];
        found.iter().all(|part| part.is_finite()).then_some(found)
    }
}

/// What was found along the edges so far.
struct Joint {
    gap: f64,
    angle: Worst,
    curvature: Worst,
    is_smooth: bool,
    bends_alike: bool,
}

impl Joint {
    /// Looks at a stretch that faces share, if it is one, and empties it.
    fn take(
        found: &mut Option<Self>,
        run: &mut Vec<[FaceSide; 2]>,
        tolerance: &JointTolerance,
        distance: f64,
    ) {
        if LEAST_RUN <= run.len() {
            for sides in &*run {
                let none = || Worst { value: f64::NEG_INFINITY, at: sides[0].point };
                let joint = found.get_or_insert_with(|| Self {
                    gap: 0.0,
                    angle: none(),
                    curvature: none(),
                    is_smooth: true,
                    bends_alike: true,
                });
                joint.look_at(sides, tolerance, distance);
            }
        }
        run.clear();
    }

    fn look_at(&mut self, [a, b]: &[FaceSide; 2], tolerance: &JointTolerance, distance: f64) {
        let gap = norm(a.point - b.point);
        self.gap = self.gap.max(gap);
        let out = -a.inward;
        let turned = angle_between(out, b.inward);
        self.angle.raise(turned, a.point);
        // Both along the edge of the first, and over normals on one side.
        let sign = |side: &FaceSide, across: DVec3| a.along.cross(across).dot(side.normal).signum();
        let bends =
            (a.bend([a.along, out], sign(a, out)), b.bend([a.along, b.inward], sign(b, b.inward)));
        let (Some(of_a), Some(of_b)) = bends else {
            self.bends_alike = false;
            return;
        };
        let largest = |[x, y, z]: [f64; 3]| (0.5 * (x + z)).abs() + libm::hypot(0.5 * (x - z), y);
        let (size, difference) = (
            largest(of_a).max(largest(of_b)),
            largest([of_a[0] - of_b[0], of_a[1] - of_b[1], of_a[2] - of_b[2]]),
        );
        self.curvature.raise(difference, a.point);
        // Beside the true edge, by as much as edges may be, planes differ as the bends do.
        let beside = EDGE_SHARE * distance + gap;
        let plane = tolerance.angle.unwrap_or(tolerance.document.angle + 2.0 * size * beside);
        let bend = tolerance.curvature_gap.unwrap_or(BEND_AGREES * size);
        self.is_smooth &= turned <= plane;
        self.bends_alike &= difference <= bend;
    }

    fn told(self) -> FaceContinuity {
        let g = match (self.is_smooth, self.bends_alike) {
            (false, _) => 0,
            (true, false) => 1,
            (true, true) => 2,
        };
        FaceContinuity {
            g,
            gap: self.gap,
            angle: self.angle.value.max(0.0),
            curvature_gap: self.curvature.value.max(0.0),
            at: if g == 0 { self.angle.at } else { self.curvature.at },
        }
    }
}
