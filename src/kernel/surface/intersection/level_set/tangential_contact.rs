//! Places where two surfaces touch, and what they share about these.
//!
//! Both are seen as heights over the plane at right angles to their common normal; e is the
//! difference of the heights. Newton's method finds where its slope vanishes, and its second
//! derivatives D there tell what the surfaces share: the point alone where D has eigenvalues of one
//! sign; two branches that cross, along the null vectors of D, where it has two signs; a line along
//! which they touch where one eigenvalue is zero. How far that holds is looked at on circles.
//!
//! Ye & Maekawa, *Differential geometry of intersection curves of two surfaces*, CAGD 16 (1999), §5;
//! Patrikalakis & Maekawa, *Shape Interrogation for Computer Aided Design and Manufacturing*, §6.

use glam::{DMat2, DVec2, DVec3};

use super::surface_pair::{PairParameters, SurfacePair, within};
use crate::{
    NurbsSurface,
    ceiling::{NEWTON_STEPS, STEP_SHORTENINGS, SURFACE_FOOT_STEPS},
    frame::unit,
    numeric::newton::{FREE, NewtonResult, NewtonStep, within_limits},
    numeric::symmetric_eigen::eigen_of_two,
    tolerance::{
        AREA_REACH, BEND_RELATIVE, CONTACT_SHARE, LAST_BIT, LEAST_STEP_SHARE, PLACE_RELATIVE,
        SIGN_RELATIVE,
    },
};

/// How far e may be from what D tells, as a fraction of the least that D tells at that distance.
const MODEL_SLACK: f64 = 0.2;

/// Places on a circle where e is looked at.
const N_LOOKS: u32 = 16;

/// The least and the largest reach of what is known about a contact, the first by the size of
/// parts that touch, the other by that of the surfaces.
const LEAST_REACH: f64 = 4.0;
const MOST_REACH: f64 = 0.25;

/// Directions next to one another, of those looked at, that are an area and no line.
const AREA_LOOKS: usize = 3;

/// Both surfaces about parameters where they are nearly parallel.
#[derive(Clone, Copy, Debug)]
pub(super) struct ParallelPair {
    pub(super) at: [f64; 4],
    pub(super) point: DVec3,
    /// Two axes in the tangent plane of the first, and its normal.
    axes: [DVec3; 3],
    /// From the point of the first to that of the second: in the plane, and over it.
    apart: DVec2,
    pub(super) rise: f64,
    /// How the second climbs over the plane, and whether it has the same side up.
    slope: DVec2,
    is_alike: bool,
    /// Steps in the parameters by steps in the plane.
    maps: [DMat2; 2],
    /// Second derivatives of the height of the second, and of the difference.
    bend: DMat2,
    difference: DMat2,
    /// How fast the parameters lead through space.
    speeds: [f64; 4],
}

/// What two surfaces share about a place where they touch.
#[derive(Clone, Debug)]
pub(super) enum TangentialContact {
    /// An area.
    Area,
    /// That place alone, as far as `ParameterRegion` goes.
    Point(ParameterRegion),
    /// Branches that cross.
    Branches(Box<BranchCrossing>),
    /// Perhaps a line along which they touch.
    Line,
}

/// Parameters of both surfaces about a place, within which all is known that they share.
#[derive(Clone, Copy, Debug)]
pub(super) struct ParameterRegion {
    pub(super) at: [f64; 4],
    pub(super) point: DVec3,
    pub(super) radius: f64,
    widths: [f64; 4],
}

/// A place where two branches cross.
#[derive(Clone, Debug)]
pub(super) struct BranchCrossing {
    pub(super) reach: ParameterRegion,
    pub(super) ways: [BranchDirection; 4],
}

/// A branch out of a junction.
#[derive(Clone, Copy, Debug)]
pub(super) struct BranchDirection {
    /// The junction, with the tangent along N × N.
    pub(super) place: PairParameters,
    /// Whether it leads out along this tangent, 1, or against it, −1.
    pub(super) sign: f64,
}

impl ParameterRegion {
    /// Whether parameters between these are within, on both surfaces.
    pub(super) fn holds(&self, low: [f64; 4], high: [f64; 4]) -> bool {
        (0..4).all(|i| {
            self.at[i] - self.widths[i] <= low[i] && high[i] <= self.at[i] + self.widths[i]
        })
    }
}

/// Poles and corners of either surface that are on the other one too, where both have one tangent
/// plane.
pub(super) fn poles(surfaces: [&NurbsSurface; 2], tolerance: f64) -> Vec<DVec3> {
    let bounds = surfaces.map(NurbsSurface::bounds);
    let touch = |point: DVec3| {
        if !bounds.iter().all(|bounds| bounds.contains(point, tolerance)) {
            return false;
        }
        let [a, b] = surfaces.map(|surface| {
            let foot = surface.closest(point);
            let [u, v] = foot.parameters;
            surface.normal_at(u, v).ok().filter(|_| foot.distance <= tolerance)
        });
        a.zip(b).is_some_and(|(a, b)| a.cross(b).length() <= LAST_BIT.sqrt())
    };
    let edges = surfaces.into_iter().flat_map(NurbsSurface::edges);
    let mut ends: Vec<DVec3> = Vec::new();
    for end in edges.flat_map(|edge| [edge.start(), edge.end()]) {
        if !ends.contains(&end) {
            ends.push(end);
        }
    }
    ends.into_iter().filter(|&end| touch(end)).collect()
}

/// A surface over a plane.
struct HeightField {
    point: DVec3,
    map: DMat2,
    slope: DVec2,
    bend: DMat2,
    speeds: [f64; 2],
    normal: DVec3,
}

impl HeightField {
    fn new([point, u, v, uu, uv, vv]: [DVec3; 6], [x, y, z]: [DVec3; 3]) -> Option<Self> {
        let flat = |vector: DVec3| DVec2::new(vector.dot(x), vector.dot(y));
        let map = DMat2::from_cols(flat(u), flat(v)).inverse();
        let slope = map.transpose() * DVec2::new(u.dot(z), v.dot(z));
        let upward = z - x * slope.x - y * slope.y;
        let [uu, uv, vv] = [uu, uv, vv].map(|second| second.dot(upward));
        let second = DMat2::from_cols(DVec2::new(uu, uv), DVec2::new(uv, vv));
        let bend = map.transpose() * second * map;
        let normal = unit(u.cross(v))?;
        let height = Self { point, map, slope, bend, speeds: [u.length(), v.length()], normal };
        (map.is_finite() && bend.is_finite()).then_some(height)
    }
}

impl ParallelPair {
    /// `None` where a surface has no normal, or the normals are far from parallel.
    pub(super) fn new(crossing: &SurfacePair<'_>, at: [f64; 4]) -> Option<Self> {
        let [first, second] =
            [0, 1].map(|i| crossing.surfaces[i].second_order_at(at[2 * i], at[2 * i + 1]));
        let normal = unit(first[1].cross(first[2]))?;
        let x = unit(first[1])?;
        let axes = [x, normal.cross(x), normal];
        let (a, b) = (HeightField::new(first, axes)?, HeightField::new(second, axes)?);
        let facing = b.normal.dot(normal);
        let way = b.point - a.point;
        let seen = Self {
            at,
            point: a.point.midpoint(b.point),
            axes,
            apart: DVec2::new(way.dot(axes[0]), way.dot(axes[1])),
            rise: way.dot(normal),
            slope: b.slope,
            is_alike: 0.0 < facing,
            maps: [a.map, b.map],
            bend: b.bend,
            difference: a.bend - b.bend,
            speeds: [a.speeds[0], a.speeds[1], b.speeds[0], b.speeds[1]],
        };
        (0.5 <= facing.abs()).then_some(seen)
    }

    /// The step in the plane to where the slope of e vanishes, but not along a line of zeros; none
    /// where surfaces of that size bend alike.
    fn step(&self, size: f64) -> DVec2 {
        let right = self.slope - self.bend * self.apart;
        let [(weak, along), (strong, across)] = eigen_of_two(self.difference);
        let bend = self.bend.x_axis.abs().max_element().max(self.bend.y_axis.abs().max_element());
        let rounding = SIGN_RELATIVE * (bend + 1.0 / size);
        let part = |value: f64, axis: DVec2| match value.abs() <= rounding {
            true => DVec2::ZERO,
            false => axis * (axis.dot(right) / value),
        };
        let rest = if weak.abs() <= BEND_RELATIVE * strong.abs() { 0.0 } else { 1.0 };
        part(strong, across) + rest * part(weak, along)
    }

    fn in_space(&self, step: DVec2) -> DVec3 {
        self.axes[0] * step.x + self.axes[1] * step.y
    }

    /// The parameters a step further, each surface by its own.
    fn moved(&self, first: DVec2, second: DVec2) -> [f64; 4] {
        let steps = self.steps(first, second);
        std::array::from_fn(|i| self.at[i] + steps[i])
    }

    /// The parameters' steps there.
    fn steps(&self, first: DVec2, second: DVec2) -> [f64; 4] {
        let [a, b] = [self.maps[0] * first, self.maps[1] * second];
        [a.x, a.y, b.x, b.y]
    }

    /// The direction in which e bends least.
    pub(super) fn along(&self) -> DVec3 {
        self.in_space(eigen_of_two(self.difference)[0].1)
    }

    /// How much it bends across that.
    pub(super) fn strongest(&self) -> f64 {
        eigen_of_two(self.difference)[1].0.abs()
    }

    /// The parameters that lead a way through space further.
    pub(super) fn ahead(&self, way: DVec3) -> [f64; 4] {
        let step = DVec2::new(way.dot(self.axes[0]), way.dot(self.axes[1]));
        self.moved(step, step)
    }

    pub(super) fn reach(&self, radius: f64) -> ParameterRegion {
        let widths = self.speeds.map(|speed| 0.5 * radius / speed);
        ParameterRegion { at: self.at, point: self.point, radius, widths }
    }
}

impl SurfacePair<'_> {
    /// Where the normals are parallel and the way between the surfaces is along them, near
    /// parameters; where that is so along a line, at its nearest place.
    pub(super) fn touch_near(&self, start: [f64; 4]) -> Option<ParallelPair> {
        let near = CONTACT_SHARE * self.touch_size() * CONTACT_SHARE;
        let found = within_limits(
            [FREE; 4],
            start,
            NEWTON_STEPS,
            |_, _| false,
            |at| {
                let Some(seen) = ParallelPair::new(self, at) else { return NewtonStep::Stuck };
                let step = seen.step(self.size);
                if !step.is_finite() || self.size < step.length() {
                    return NewtonStep::Stuck;
                }
                let steps = seen.steps(step, step - seen.apart);
                // The last step squares what is small.
                let is_near = step.length() + seen.apart.length() <= near;
                if is_near { NewtonStep::Last(steps) } else { NewtonStep::By(steps) }
            },
        );
        ParallelPair::new(self, found.settled()?)
    }

    /// Whether the surfaces meet there, up to what counts as such.
    pub(super) fn is_contact(&self, seen: &ParallelPair) -> bool {
        seen.rise.abs() <= self.contact
    }

    /// What a contact is; `None` where that cannot be told from second derivatives.
    pub(super) fn contact(&self, seen: &ParallelPair) -> Option<TangentialContact> {
        let [(weak, along), (strong, across)] = eigen_of_two(seen.difference);
        if self.share_area(seen) {
            return Some(TangentialContact::Area);
        }
        let widest = MOST_REACH * self.size;
        if strong.abs() * widest * widest <= self.contact {
            // Where both are that near all over, what they bend by is rounding.
            return None;
        }
        if weak.abs() <= BEND_RELATIVE * strong.abs() {
            return Some(TangentialContact::Line);
        }
        let reach = seen.reach(self.radius(seen, weak.abs(), widest)?);
        if 0.0 < weak * strong {
            return Some(TangentialContact::Point(reach));
        }
        let [a, b] = [across * weak.abs().sqrt(), along * strong.abs().sqrt()];
        let way = |direction: DVec2| {
            let outward = unit(seen.in_space(direction)).unwrap_or(DVec3::ZERO);
            // Along n × Dq is N × N there, turned over where the second has the other side up.
            let climb = seen.axes[2].cross(seen.in_space(seen.difference * direction));
            let is_along = (0.0 < climb.dot(outward)) == seen.is_alike;
            let sign = if is_along { 1.0 } else { -1.0 };
            BranchDirection {
                place: PairParameters { at: seen.at, point: seen.point, tangent: outward * sign },
                sign,
            }
        };
        let ways = [a + b, a - b, -a - b, b - a].map(way);
        Some(TangentialContact::Branches(Box::new(BranchCrossing { reach, ways })))
    }

    /// How far about a contact e is what D tells, where D counts by `scale` at least.
    pub(super) fn radius(&self, seen: &ParallelPair, scale: f64, most: f64) -> Option<f64> {
        let is_so = |radius: f64| {
            let steps = circle(radius).chain(circle(0.5 * radius));
            steps.filter_map(|step| self.difference_inside(seen, step)).all(|(place, height)| {
                let told = 0.5 * place.dot(seen.difference * place);
                (height - told).abs() <= MODEL_SLACK * 0.5 * scale * place.length_squared()
            })
        };
        let least = LEAST_REACH * self.touch_size();
        let halved = |radius: &f64| Some(0.5 * radius);
        std::iter::successors(Some(most), halved)
            .take_while(|&radius| least <= radius)
            .find(|&radius| is_so(radius))
    }

    /// Whether the surfaces are one in a sector about a place.
    fn share_area(&self, seen: &ParallelPair) -> bool {
        let radius = AREA_REACH * self.size;
        let near = 2.0 * self.contact;
        let [_, (strong, _)] = eigen_of_two(seen.difference);
        if near < strong.abs() * radius * radius {
            return false;
        }
        let is_one = |look: Option<(DVec2, f64)>| look.is_some_and(|(_, e)| e.abs() <= near);
        let look = |step: DVec2| is_one(self.difference_at(seen, step));
        let are_one: Vec<bool> =
            circle(radius).map(|step| look(step) && look(0.5 * step)).collect();
        let from = |i: usize| (0..AREA_LOOKS).all(|k| are_one[(i + k) % are_one.len()]);
        (0..are_one.len()).any(from)
    }

    /// As `difference_at`, where a surface ends before at most there.
    fn difference_inside(&self, seen: &ParallelPair, step: DVec2) -> Option<(DVec2, f64)> {
        let ahead = seen.moved(step, step);
        let share = (0..4).fold(1.0, |share: f64, i| {
            let (whole, inside) =
                (ahead[i] - seen.at[i], within(self.domains[i], ahead[i]) - seen.at[i]);
            if inside.abs() < whole.abs() { share.min(inside / whole) } else { share }
        });
        // The foot may be beyond an end that the step itself is not.
        let shares =
            std::iter::successors(Some(share), |share| Some(0.5 * share)).take(STEP_SHORTENINGS);
        shares
            .take_while(|share| LEAST_STEP_SHARE <= *share)
            .find_map(|share| self.difference_at(seen, step * share))
    }

    /// The place about a step from a contact, and e there; infinite where no foot is found.
    fn difference_at(&self, seen: &ParallelPair, step: DVec2) -> Option<(DVec2, f64)> {
        let [x, y, z] = seen.axes;
        let [u, v, s, t] = seen.moved(step, step);
        if !self.is_inside([u, v, seen.at[2], seen.at[3]]) {
            return None;
        }
        let top = self.point_within(0, [u, v]);
        let flat = |way: DVec3| DVec2::new(way.dot(x), way.dot(y));
        let place = flat(top - seen.point);
        let way = |foot: [f64; 2]| top - self.point_within(1, foot);
        let found = within_limits(
            [FREE; 2],
            [s, t],
            SURFACE_FOOT_STEPS,
            |_, _| false,
            |[s, t]| {
                if !self.is_inside([u, v, s, t]) {
                    return NewtonStep::Stuck;
                }
                let off = flat(way([s, t]));
                match off.length() <= PLACE_RELATIVE * step.length() {
                    true => NewtonStep::Stay,
                    false => NewtonStep::By((seen.maps[1] * off).to_array()),
                }
            },
        );
        match found {
            NewtonResult::Settled(foot) => Some((place, way(foot).dot(z))),
            NewtonResult::Unsettled(_) => Some((place, f64::INFINITY)),
            NewtonResult::Stuck(_) => None,
        }
    }
}

/// Steps in the plane that lead around a contact.
fn circle(radius: f64) -> impl Iterator<Item = DVec2> {
    (0..N_LOOKS).map(move |i| {
        let (sine, cosine) =
            libm::sincos(std::f64::consts::TAU * f64::from(i) / f64::from(N_LOOKS));
        DVec2::new(cosine, sine) * radius
    })
}
