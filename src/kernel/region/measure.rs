//! Areas and moments of what closed chains of arcs go around, by integrals along them.

use glam::{DMat3, DVec3};

use super::{PlaneLoop, Region, bounds_of};
use crate::{
    Bounds, ClosestPoint, Frame, Interval, MassProperties, NurbsCurve, Tolerance,
    arrange::winding_about,
    numeric::gauss_legendre::{SIXTEEN_NODES, nodes},
    tolerance::{LAST_BIT, QUADRATURE_RELATIVE},
};

/// Halvings of a piece whose integrals do not settle.
const HALVINGS: usize = 30;

/// Nodes of the rule of each piece.
const N_NODES: usize = 2 * SIXTEEN_NODES.len();

/// Moments about a point, about another one from which the way to it leads.
fn moved([area, x, y, xx, xy, yy]: Moments, way: DVec3) -> Moments {
    let [first, second] = [x + area * way.x, y + area * way.y];
    // The way to a place is the sum of both.
    let xx = xx + (x + first) * way.x;
    let yy = yy + (y + second) * way.y;
    let xy = xy + x * way.y + second * way.x;
    [area, first, second, xx, xy, yy]
}

/// Coordinates and velocities that are multiplied for the area, and for all moments.
const AREA_FACTORS: usize = 2;
const MOMENT_FACTORS: usize = 4;

/// Last bits of the size of a loop that integrals along it may be off.
const ROUNDINGS: f64 = 16.0;

/// Lines across a region on which places inside are looked for, by fractions of its height.
const LOOKS_ACROSS: [f64; 3] = [0.27, 0.48, 0.74];

/// Such places on each stretch of a line, by fractions.
const LOOKS_ALONG: [f64; 2] = [0.31, 0.69];

/// Area, first moments of x and y, second ones of xx, xy and yy.
type Moments = [f64; 6];

/// Where a point lies.
///
/// ```
/// use virote_kernel::{CircleForm, Frame, NurbsCurve, Region, RegionSide, Tolerance, glam::DVec3};
///
/// let circle = NurbsCurve::ellipse(Frame::XY, [2.0, 2.0], CircleForm::NinePoint)?;
/// let disc = Region::new(&circle, &[], Tolerance::DEFAULT)?;
/// assert_eq!(disc.side_of(DVec3::X, 1e-6), RegionSide::Inside);
/// assert_eq!(disc.side_of(DVec3::Y * 2.0, 1e-6), RegionSide::Border);
/// assert_eq!(disc.side_of(DVec3::Z, 1e-6), RegionSide::Outside);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RegionSide {
    /// In the inside.
    Inside,
    /// Beyond the border, or beside the plane.
    Outside,
    /// On the border, within the tolerance.
    Border,
}

impl Region {
    /// Its area: Green's theorem, exact to rounding for borders of low degree, else to 1e-13.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.loops.iter().map(PlaneLoop::area).sum()
    }

    /// The length of all borders.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.loops.iter().map(PlaneLoop::length).sum()
    }

    /// Area, centroid and inertia of a skin of density one.
    #[must_use]
    pub fn mass(&self) -> MassProperties {
        let about = self.loops[0].bounds().center();
        let mut sum = Moments::default();
        for border in &self.loops {
            // About its own middle what a small hole leaves is not rounding of where that is.
            let own = border.bounds().center();
            add(&mut sum, moved(border.moments(own), own - about));
        }
        let [area, x, y, xx, xy, yy] = sum;
        let (x, y) = (x / area, y / area);
        let (xx, xy, yy) = (xx - area * x * x, xy - area * x * y, yy - area * y * y);
        let own = DMat3::from_cols(
            DVec3::new(yy, -xy, 0.0),
            DVec3::new(-xy, xx, 0.0),
            DVec3::new(0.0, 0.0, xx + yy),
        );
        let turn = self.frame.to_space().matrix3;
        MassProperties {
            amount: area,
            centroid: self.frame.point(about + DVec3::new(x, y, 0.0)),
            inertia: turn * own * turn.transpose(),
            relative_error: QUADRATURE_RELATIVE,
        }
    }

    /// The smallest box with sides along the axes of space.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        let arcs = self.loops[0].arcs.iter();
        let boxes = arcs.map(|arc| arc.transformed(&self.frame.to_space()).bounds());
        let whole = boxes.reduce(Bounds::union);
        whole.unwrap_or_else(|| unreachable!("a loop has an arc"))
    }

    /// Where a point is, the border as wide as the tolerance on either side.
    #[must_use]
    pub fn side_of(&self, point: DVec3, tolerance: f64) -> RegionSide {
        let local = self.frame.from_space().transform_point3(point);
        if tolerance < local.z.abs() {
            return RegionSide::Outside;
        }
        let local = local.with_z(0.0);
        let near = |border: &PlaneLoop| border.comes_near(local, tolerance);
        if self.loops.iter().any(near) {
            return RegionSide::Border;
        }
        match winding_about(self.loops.iter().map(|border| &border.arcs[..]), local) {
            Some(0) => RegionSide::Outside,
            Some(_) => RegionSide::Inside,
            None => RegionSide::Border,
        }
    }

    /// Some places of its borders and inside of it.
    pub(crate) fn some_places(&self, tolerance: Tolerance) -> Vec<DVec3> {
        let arcs = || self.loops.iter().flat_map(|border| &border.arcs);
        let mut places: Vec<DVec3> = Vec::new();
        places.extend(arcs().flat_map(|arc| [arc.start(), arc.point_at(arc.domain().at(0.5))]));
        let Some(Bounds { min, max }) = bounds_of(&self.loops) else { return places };
        for y in LOOKS_ACROSS.map(|at| min.y + (max.y - min.y) * at) {
            let line = Frame::ZX.at(DVec3::Y * y);
            let crossings = |arc: &NurbsCurve| {
                let parameters = match arc.bounds() {
                    Bounds { min, max } if min.y <= y && y <= max.y => {
                        arc.plane_parameters(line, tolerance)
                    }
                    _ => Vec::new(),
                };
                parameters.into_iter().map(|t| arc.point_at(t).x).collect::<Vec<f64>>()
            };
            let mut crossed: Vec<f64> = arcs().flat_map(crossings).collect();
            crossed.sort_by(f64::total_cmp);
            // One stretch of a line tells enough.
            let is_inside = |place: &DVec3| {
                winding_about(self.arcs(), *place).is_some_and(|winding| winding != 0)
            };
            let mut stretches = crossed.windows(2).map(|pair| -> Vec<DVec3> {
                let along = LOOKS_ALONG.map(|at| pair[0] + (pair[1] - pair[0]) * at);
                along.map(|x| DVec3::new(x, y, 0.0)).into_iter().filter(is_inside).collect()
            });
            let inside = stretches.find(|stretch| !stretch.is_empty());
            places.extend(inside.into_iter().flatten());
        }
        places.into_iter().map(|place| self.frame.point(place)).collect()
    }

    /// The nearest point of the region: of the inside where the point is above that, else of the border.
    #[must_use]
    pub fn closest(&self, point: DVec3, tolerance: f64) -> DVec3 {
        let local = self.frame.from_space().transform_point3(point).with_z(0.0);
        let foot = self.frame.point(local);
        if self.side_of(foot, 0.0) == RegionSide::Inside {
            return foot;
        }
        let nearest = self.loops.iter().flat_map(|border| &border.arcs);
        let nearest = nearest.map(|arc| arc.closest(local, tolerance));
        let nearest = nearest.min_by(|a, b| a.distance.total_cmp(&b.distance));
        nearest.map_or(foot, |ClosestPoint { point, .. }| self.frame.point(point))
    }
}

impl PlaneLoop {
    /// The area to its left, negative where it runs clockwise.
    pub(super) fn area(&self) -> f64 {
        self.integrals(self.bounds().center(), AREA_FACTORS)[0]
    }

    /// Whether it goes around no more, with an area given, than a strip as long as it of a width.
    pub(super) fn is_strip(&self, area: f64, width: f64) -> bool {
        // No curve is longer than the legs of its control points, but for weights below zero.
        let is_convex = |arc: &NurbsCurve| arc.control_points().iter().all(|point| 0.0 < point.w);
        let legs = |arc: &NurbsCurve| {
            arc.points().windows(2).map(|pair| pair[0].distance(pair[1])).sum::<f64>()
        };
        let is_wider = self.arcs.iter().all(is_convex)
            && width * self.arcs.iter().map(legs).sum::<f64>() < area.abs();
        !is_wider && area.abs() <= width * self.length()
    }

    pub(super) fn length(&self) -> f64 {
        self.arcs.iter().map(|arc| arc.length(arc.domain())).sum()
    }

    pub(super) fn bounds(&self) -> Bounds {
        let whole = self.arcs.iter().map(NurbsCurve::bounds).reduce(Bounds::union);
        whole.unwrap_or_else(|| unreachable!("a loop has an arc"))
    }

    /// Whether it comes within a distance of a point of the plane.
    fn comes_near(&self, point: DVec3, distance: f64) -> bool {
        let is_near = |arc: &NurbsCurve| {
            arc.bounds().contains(point, distance) && arc.foot_within(point, distance).is_some()
        };
        self.arcs.iter().any(is_near)
    }

    /// The moments of what is to its left about a point.
    fn moments(&self, about: DVec3) -> Moments {
        self.integrals(about, MOMENT_FACTORS)
    }

    /// The same, right for those among whose integrands are no more coordinates and velocities than `n_factors`.
    fn integrals(&self, about: DVec3, n_factors: usize) -> Moments {
        let size = IntegralSize::of(self.bounds());
        let mut sum = Moments::default();
        let mut end = self.arcs[self.arcs.len() - 1].end() - about;
        for arc in &self.arcs {
            // Within the tolerance the end before is another place: a straight leg leads here.
            let start = arc.start() - about;
            add(&mut sum, leg(end, start));
            end = arc.end() - about;
            if arc.degree() == 1 {
                let points = arc.points();
                let legs = points.windows(2);
                legs.for_each(|pair| add(&mut sum, leg(pair[0] - about, pair[1] - about)));
                continue;
            }
            for span in arc.knots().spans() {
                let interval = arc.knots().span_interval(span);
                let piece = SpanPiece { arc, span, about };
                let rough = piece.over(interval);
                add(
                    &mut sum,
                    match piece.is_exact(n_factors) {
                        true => rough,
                        false => piece.settled(size, interval, rough, HALVINGS),
                    },
                );
            }
        }
        sum
    }
}

fn add(sum: &mut Moments, moments: Moments) {
    sum.iter_mut().zip(moments).for_each(|(sum, moment)| *sum += moment);
}

/// What is integrated by y, for the moments in their order.
fn integrands(DVec3 { x, y, .. }: DVec3) -> Moments {
    [x, 0.5 * x * x, x * y, x * x * x / 3.0, 0.5 * x * x * y, x * y * y]
}

/// The integrals along a straight leg: Simpson's rule, exact up to cubics.
fn leg(from: DVec3, to: DVec3) -> Moments {
    let [a, b, c] = [from, from.midpoint(to), to].map(integrands);
    std::array::from_fn(|i| (to.y - from.y) * (a[i] + 4.0 * b[i] + c[i]) / 6.0)
}

/// What of the integrals along a loop is rounding, for the moments in their order.
#[derive(Clone, Copy)]
struct IntegralSize {
    rounding: Moments,
}

impl IntegralSize {
    /// Of a loop within a box: last bits of its size, and those of its coordinates, by which places far from the
    /// origin are moved.
    fn of(bounds: Bounds) -> Self {
        let size = bounds.diagonal();
        let bits = LAST_BIT * (ROUNDINGS * size + bounds.magnitude());
        let [line, area, volume] = [size, size * size, size * size * size].map(|part| part * bits);
        Self { rounding: [line, area, area, volume, volume, volume] }
    }
}

/// An arc within one span, and the point about which moments are.
struct SpanPiece<'a> {
    arc: &'a NurbsCurve,
    span: usize,
    about: DVec3,
}

impl SpanPiece<'_> {
    /// Whether the rule is exact for products of so many coordinates, the last one a velocity: of n nodes it is so up to
    /// degree 2n - 1.
    fn is_exact(&self, n_factors: usize) -> bool {
        !self.arc.is_rational() && n_factors * self.arc.degree() <= 2 * N_NODES
    }

    /// The integrals along a part of it by one rule.
    fn over(&self, interval: Interval) -> Moments {
        let mut sum = Moments::default();
        for (t, weight) in nodes(&SIXTEEN_NODES, interval) {
            let [point, velocity] = self.arc.velocity_on(self.span, t);
            let factor = weight * interval.length() * velocity.y;
            add(&mut sum, integrands(point - self.about).map(|value| value * factor));
        }
        sum
    }

    /// The same, halved until both halves together agree with the whole.
    fn settled(
        &self,
        size: IntegralSize,
        interval: Interval,
        rough: Moments,
        n_halvings: usize,
    ) -> Moments {
        let halves = interval.halves();
        let parts = halves.map(|half| self.over(half));
        let mut sum = Moments::default();
        parts.iter().for_each(|&part| add(&mut sum, part));
        let is_settled =
            (0..6).all(|i| (sum[i] - rough[i]).abs() <= size.rounding[i] || !sum[i].is_finite());
        if is_settled || n_halvings == 0 {
            return sum;
        }
        let mut sum = Moments::default();
        for (half, part) in halves.into_iter().zip(parts) {
            add(&mut sum, self.settled(size, half, part, n_halvings - 1));
        }
        sum
    }
}
