//! How smoothly one surface goes on in another across a common edge.
//!
//! Along the edge both sides are compared at more places than a difference of polynomials of their
//! degrees can have zeros, so that what agrees there agrees everywhere; of functions the places are
//! many, and that is all. For the geometric orders both sides are graphs over the common tangent
//! plane, whose Taylor polynomials do not depend on the parameters: G1 has the same plane, G2 the
//! same second fundamental tensor, G3 the same third derivatives. Peters, *Geometric continuity*,
//! in Farin, Hoschek & Kim (eds.), *Handbook of Computer Aided Geometric Design*, ch. 8.

use glam::{DVec3, DVec4};

use crate::{
    GeomError, JointTolerance, LocalError,
    frame::{angle_between, unit},
    joint_tolerance::Agreement,
    surface::{
        Edge, Surface, evaluation::two_sided::TwoSidedSample, measurement::border::SurfaceBorder,
    },
    tolerance::EXACT_RELATIVE,
};

/// The highest order that is compared.
const MAX_ORDER: usize = 3;

/// How two surfaces meet along an edge; of several lines the worst of each.
///
/// Orders are the largest up to 3 that hold, −1 where the edges are apart.
///
/// Two squares at a right angle have an edge, and no more, in common:
///
/// ```
/// use virote_kernel::{Edge, NurbsSurface, Surface, Tolerance, glam::DVec3};
///
/// let [o, x, y, z] = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
/// let floor = Surface::from(NurbsSurface::bilinear(o, y, x, x + y)?);
/// let wall = Surface::from(NurbsSurface::bilinear(x, x + y, x + z, x + y + z)?);
/// let joint = floor.continuity_with(Edge::U1, &wall, Edge::U0, Tolerance::DEFAULT)?;
/// assert_eq!(joint.g, 0);
/// assert!((joint.angle - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceContinuity {
    /// Equal derivatives across the edge, at places of equal fractions along it.
    pub c: i32,
    /// The same tangent plane, second fundamental tensor, third derivatives of the height over the
    /// plane.
    pub g: i32,
    /// Largest distance of the edges.
    pub gap: f64,
    /// Largest angle of the tangent planes, 0 where one surface goes on in the other and π where it
    /// turns back; in radians.
    pub angle: f64,
    /// Largest difference of normal curvatures in one direction; `None` where a surface has none.
    pub curvature_gap: Option<f64>,
    /// Equal derivatives of the homogeneous surfaces, which is more than equal ones in space.
    pub c_homogeneous: i32,
    /// Where what fails first of gap, angle and curvature is largest; `None` where nothing was
    /// compared.
    pub at: Option<DVec3>,
}

impl SurfaceContinuity {
    /// Nothing to see.
    const PERFECT: Self = Self {
        c: MAX_ORDER as i32,
        g: MAX_ORDER as i32,
        gap: 0.0,
        angle: 0.0,
        curvature_gap: Some(0.0),
        c_homogeneous: MAX_ORDER as i32,
        at: None,
    };

    /// The worse of each.
    fn or_worse(self, other: Self) -> Self {
        let rank = |joint: &Self| match joint.g {
            -1 => joint.gap,
            0 => joint.angle,
            _ => joint.curvature_gap.unwrap_or(f64::INFINITY),
        };
        let is_worse = self.at.is_none()
            || other.g < self.g
            || other.g == self.g && rank(&self) < rank(&other);
        Self {
            c: self.c.min(other.c),
            g: self.g.min(other.g),
            gap: self.gap.max(other.gap),
            angle: self.angle.max(other.angle),
            curvature_gap: self.curvature_gap.zip(other.curvature_gap).map(|(a, b)| a.max(b)),
            c_homogeneous: self.c_homogeneous.min(other.c_homogeneous),
            at: if is_worse { other.at } else { self.at },
        }
    }
}

impl Surface {
    /// How `next` goes on across its edge where this surface ends at an edge, whichever way the
    /// edges run.
    ///
    /// Points are compared by the document's distance, directions and all that is higher by its
    /// angle, relative to the size of the pieces. Where a distance, an angle or a curvature gap is
    /// asked for, it decides in their place on points, tangent planes and normal curvatures, and the
    /// orders by the parameters are no higher than the geometric one. Edges that are one curve with
    /// different parameters meet, but no better than C0.
    ///
    /// # Errors
    /// [`LocalError::NoNormal`] where a surface has no tangent plane along the whole edge, and as
    /// [`Self::point_at`].
    pub fn continuity_with(
        &self,
        edge: Edge,
        next: &Self,
        next_edge: Edge,
        tolerance: impl Into<JointTolerance>,
    ) -> Result<SurfaceContinuity, GeomError> {
        let (a, b) = (SurfaceBorder::edge(self, edge), SurfaceBorder::edge(next, next_edge));
        let is_reversed = a.runs_against(&b)?;
        joint(&a, &b, is_reversed, tolerance.into())
    }

    /// The edges of both that are nearest to one another.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn nearest_edges(&self, other: &Self) -> Result<(Edge, Edge), GeomError> {
        let (mut nearest, mut least) = ((Edge::U1, Edge::U0), f64::INFINITY);
        for edge in Edge::ALL {
            for other_edge in Edge::ALL {
                let (a, b) =
                    (SurfaceBorder::edge(self, edge), SurfaceBorder::edge(other, other_edge));
                let [with, against] = a.distances(&b)?;
                if with.min(against) < least {
                    (nearest, least) = ((edge, other_edge), with.min(against));
                }
            }
        }
        Ok(nearest)
    }

    /// The worst continuity across the lines of its inner knots, and across its seams where it is
    /// closed.
    ///
    /// # Errors
    /// As [`Self::continuity_with`].
    pub fn continuity(
        &self,
        tolerance: impl Into<JointTolerance>,
    ) -> Result<SurfaceContinuity, GeomError> {
        let tolerance = tolerance.into();
        let closed_within = tolerance.closed_within();
        let mut worst = SurfaceContinuity::PERFECT;
        for [before, after] in SurfaceBorder::inner_knots(self) {
            worst = worst.or_worse(joint(&before, &after, false, tolerance)?);
        }
        let seams = [
            (self.is_closed_u(closed_within)?, [Edge::U1, Edge::U0]),
            (self.is_closed_v(closed_within)?, [Edge::V1, Edge::V0]),
        ];
        for (is_closed, edges) in seams {
            let [end, start] = edges.map(|edge| SurfaceBorder::edge(self, edge));
            if is_closed && end.length()? > closed_within {
                worst = worst.or_worse(joint(&end, &start, false, tolerance)?);
            }
        }
        Ok(worst)
    }
}

/// Compares both sides along the line.
fn joint(
    a: &SurfaceBorder<'_>,
    b: &SurfaceBorder<'_>,
    is_reversed: bool,
    tolerance: JointTolerance,
) -> Result<SurfaceContinuity, GeomError> {
    let mut pairs = a.pairs(b, is_reversed)?;
    let allowed = |pairs: &[[TwoSidedSample; 2]]| {
        let sizes = pairs.iter().flatten().map(|side| side.extent);
        let rounding = pairs.iter().flatten().map(|side| side.rounding).fold(0.0, f64::max);
        tolerance.distance_for(sizes.fold(0.0, f64::max), rounding)
    };
    let distance = allowed(&pairs);
    let has_equal_parameters = pairs.iter().all(|[a, b]| a.point().distance(b.point()) <= distance);
    let mut further = None;
    if !has_equal_parameters {
        // The edges may be one curve all the same.
        pairs = a.nearest_pairs(b)?;
        further = b.farthest_from(a)?;
    }
    let distance = allowed(&pairs);
    let mut found = JointFindings { further, ..JointFindings::default() };
    for [a, b] in &pairs {
        found.look_at(a, b, distance, tolerance);
    }
    let mut joint = found.joint(distance);
    if found.n_planes == 0 && 0 <= joint.g {
        let (u, v) = a.place(a.along().start());
        return Err(LocalError::NoNormal { u, v }.into());
    }
    if !has_equal_parameters {
        joint.c = if joint.g < 0 { -1 } else { 0 };
        joint.c_homogeneous = joint.c.min(joint.c_homogeneous);
    }
    Ok(joint)
}

/// A largest value with its place.
#[derive(Clone, Copy, Debug, Default)]
struct LargestValue(f64, Option<DVec3>);

impl LargestValue {
    fn raise(&mut self, value: f64, point: DVec3) {
        if self.1.is_none() || self.0 < value {
            *self = Self(value, Some(point));
        }
    }
}

/// What was found along an edge so far.
#[derive(Debug)]
struct JointFindings {
    c: usize,
    c_homogeneous: usize,
    g: usize,
    gap: LargestValue,
    angle: LargestValue,
    curvature: LargestValue,
    /// Places where both sides have a tangent plane.
    n_planes: usize,
    has_curvature: bool,
    /// The place of the second edge that is furthest from the first, with its distance.
    further: Option<(f64, DVec3)>,
}

impl Default for JointFindings {
    /// All orders hold before anything was looked at; the count is one above the order.
    fn default() -> Self {
        let most = MAX_ORDER + 1;
        let none = LargestValue::default();
        Self {
            c: most,
            c_homogeneous: most,
            g: most,
            gap: none,
            angle: none,
            curvature: none,
            n_planes: 0,
            has_curvature: true,
            further: None,
        }
    }
}

impl JointFindings {
    fn look_at(
        &mut self,
        a: &TwoSidedSample,
        b: &TwoSidedSample,
        distance: f64,
        asked: JointTolerance,
    ) {
        let point = a.point();
        self.gap.raise(point.distance(b.point()), point);
        let turn = if a.is_end == b.is_end { -1.0 } else { 1.0 };
        let size = point.abs().max_element() + a.extent.max(b.extent);
        let exact = EXACT_RELATIVE * size;
        let bounds = SurfaceJointTolerance {
            sides: [a, b],
            distance,
            exact,
            relative: asked.document.angle,
            turn,
        };
        let mut c = bounds.order(1.0, |side| side.across().map(|d| d.extend(0.0)));
        let to_length = DVec3::ONE.extend(size);
        let weight = a.homogeneous.get(0, 0).w;
        let mut homogeneous =
            bounds.order(weight, |side| side.homogeneous_across().map(|d| d * to_length));
        // Where there are tangent planes, what agrees by the parameters agrees without them.
        if let Some(geometric) = self.look_at_shapes(&bounds, asked) {
            let g = 1 + geometric.order(c.saturating_sub(1));
            self.g = self.g.min(g);
            (c, homogeneous) = (c.min(g), homogeneous.min(g));
        }
        self.c = self.c.min(c);
        self.c_homogeneous = self.c_homogeneous.min(homogeneous);
    }

    /// Which geometric orders agree at a place, apart from a gap; none where a side has no tangent
    /// plane.
    fn look_at_shapes(
        &mut self,
        bounds: &SurfaceJointTolerance<'_>,
        asked: JointTolerance,
    ) -> Option<Agreement<MAX_ORDER>> {
        let [a, b] = bounds.sides;
        let point = a.point();
        // Unit tangent of the edge, and out of the first surface into the second.
        let along = unit(a.along())?;
        let (out, into) = (a.conormal(along, 1.0)?, b.conormal(along, -1.0)?);
        self.n_planes += 1;
        let turned = angle_between(out, into);
        self.angle.raise(turned, point);
        let relative = bounds.relative;
        let noise = |order: usize| a.noise(order).max(b.noise(order));
        let plane =
            (turned <= asked.angle.unwrap_or(relative).max(noise(1)), asked.angle.is_some());
        let is_asked = asked.curvature_gap.is_some();
        let (Some(of_a), Some(of_b)) = (a.height_over([along, out]), b.height_over([along, into]))
        else {
            self.has_curvature = false;
            return Some(Agreement { orders: [plane, (false, is_asked), (false, false)] });
        };
        let bend = of_a.bend_from(&of_b);
        self.curvature.raise(bend, point);
        let extent = a.extent.min(b.extent);
        let agree = |[a, b]: [&[f64]; 2], order: usize| {
            let largest = |values: &mut dyn Iterator<Item = f64>| {
                values.fold(0.0, |most: f64, x| most.max(x.abs()))
            };
            let difference = largest(&mut a.iter().zip(b).map(|(x, y)| x - y));
            let size = largest(&mut a.iter().chain(b).copied());
            let factorial: f64 = (2..=order).map(|k| k as f64).product();
            let unseen = |apart: f64| factorial * apart / libm::pow(extent, order as f64);
            let apart = noise(order).max(unseen(bounds.exact));
            difference <= (relative * size.max(unseen(extent))).max(apart)
        };
        let second = match asked.curvature_gap {
            Some(gap) => bend <= gap.max(noise(2)),
            None => agree([&of_a.second, &of_b.second], 2),
        };
        let third = agree([&of_a.third, &of_b.third], 3);
        Some(Agreement { orders: [plane, (second, is_asked), (third, false)] })
    }

    fn joint(&self, distance: f64) -> SurfaceContinuity {
        let mut gap = self.gap;
        if let Some((further, point)) = self.further {
            gap.raise(further, point);
        }
        let order = |count: usize| count as i32 - 1;
        let g = if distance < gap.0 { -1 } else { order(self.g) };
        let at = match g {
            -1 => gap,
            0 => self.angle,
            _ => self.curvature,
        };
        SurfaceContinuity {
            c: order(self.c),
            g,
            gap: gap.0,
            angle: self.angle.0,
            curvature_gap: self.has_curvature.then_some(self.curvature.0),
            c_homogeneous: order(self.c_homogeneous),
            at: at.1.or(gap.1),
        }
    }
}

/// What counts as equal at a place of an edge.
struct SurfaceJointTolerance<'a> {
    sides: [&'a TwoSidedSample; 2],
    distance: f64,
    /// By how far two ways to write one surface differ.
    exact: f64,
    /// Of anything else, relative to its size.
    relative: f64,
    /// −1 where the parameters across the edge run against one another.
    turn: f64,
}

impl SurfaceJointTolerance<'_> {
    /// What rounding leaves in the terms of an order.
    fn rounding(&self, order: usize) -> f64 {
        self.sides.map(|side| side.rounding_of(order)).into_iter().fold(0.0, f64::max)
    }

    /// How many orders, from 0 on, agree; `weight` multiplies what is in space.
    fn order(
        &self,
        weight: f64,
        derivatives: impl Fn(&TwoSidedSample) -> [DVec4; MAX_ORDER + 1],
    ) -> usize {
        let step = self.sides[0].reach.min(self.sides[1].reach);
        let [a, b] = self.sides.map(|side| {
            let mut power = 1.0;
            let mut terms = derivatives(side);
            for (k, term) in terms.iter_mut().enumerate() {
                power *= if k == 0 { 1.0 } else { step / k as f64 };
                *term *= power;
            }
            terms
        });
        let sizes = a[1..].iter().chain(&b[1..]).map(|term| term.length());
        let relative = self.relative * sizes.fold(0.0, f64::max);
        let agrees = |k: usize| {
            let allowed = match k {
                0 => self.distance * weight,
                _ => relative.max(self.rounding(k).max(self.exact) * weight),
            };
            let turn = if k % 2 == 1 { self.turn } else { 1.0 };
            (a[k] - turn * b[k]).length() <= allowed
        };
        (0..=MAX_ORDER).take_while(|&k| agrees(k)).count()
    }
}
