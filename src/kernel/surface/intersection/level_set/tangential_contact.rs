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

use glam::{DVec2, DVec3};

use super::{
    parallel_pair::{ParallelPair, ParameterRegion},
    surface_pair::{PairParameters, SurfacePair, within},
};
use crate::{
    Bounds, NurbsSurface,
    ceiling::{NEWTON_STEPS, STEP_SHORTENINGS, SURFACE_FOOT_STEPS},
    frame::unit,
    numeric::newton::{FREE, NewtonResult, NewtonStep, within_limits},
    numeric::symmetric_eigen::eigen_of_two,
    tolerance::{
        AREA_REACH, BEND_RELATIVE, CONTACT_SHARE, LAST_BIT, LEAST_STEP_SHARE, PLACE_RELATIVE,
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

/// How much of what is known about a place a closed curve about it may take, and by which factor it may
/// be larger than second derivatives tell.
const LOOP_REACH: f64 = 0.4;
pub(super) const LOOP_SLACK: f64 = 1.25;

/// Directions next to one another, of those looked at, that are an area and no line.
const AREA_LOOKS: usize = 3;

/// What two surfaces share about a place where they touch.
#[derive(Clone, Debug)]
pub(super) enum TangentialContact {
    /// An area.
    Area,
    /// That place alone, as far as `ParameterRegion` goes.
    Point(ParameterRegion),
    /// A small closed curve about that place.
    Loop(Box<LoopAround>),
    /// Branches that cross.
    Branches(Box<BranchCrossing>),
    /// Perhaps a line along which they touch.
    Line,
}

/// A closed curve about a place where the surfaces are nearly parallel, and all that they share there.
#[derive(Clone, Copy, Debug)]
pub(super) struct LoopAround {
    pub(super) reach: ParameterRegion,
    /// Parameters beside a place of the curve, and how far that is from the one that it goes around.
    pub(super) start: [f64; 4],
    pub(super) half_axis: f64,
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

    /// Whether the surfaces reach through one another in a small closed curve about it.
    pub(super) fn may_loop_about(&self, seen: &ParallelPair) -> bool {
        seen.rise.abs() <= self.tolerance && self.tolerance < half_axis(seen)
    }

    /// A place of a box that a small closed curve goes around or passes, so that it is no touch in a point.
    pub(super) fn loop_beside(&self, seen: &ParallelPair, around: Bounds) -> Option<DVec3> {
        let reach = LOOP_SLACK * half_axis(seen);
        let is_loop = self.may_loop_about(seen) && around.contains(seen.point, reach);
        is_loop.then_some(seen.point)
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
            let half_axis = half_axis(seen);
            if half_axis <= self.tolerance {
                return Some(TangentialContact::Point(reach));
            }
            let start = seen.moved(along * half_axis, along * half_axis - seen.apart);
            let is_held = half_axis <= LOOP_REACH * reach.radius
                && circle(LOOP_SLACK * half_axis)
                    .all(|step| self.is_inside(seen.moved(step, step - seen.apart)));
            let around = LoopAround { reach, start, half_axis };
            return is_held.then(|| TangentialContact::Loop(Box::new(around)));
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
                let told = 0.5 * place.dot(seen.difference * place) - seen.rise;
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

/// The longer half axis of the ellipse in which −rise + x·Dx/2 vanishes; nothing where that is no ellipse.
fn half_axis(seen: &ParallelPair) -> f64 {
    let [(weak, _), (strong, _)] = eigen_of_two(seen.difference);
    let is_definite = BEND_RELATIVE * strong.abs() < weak.abs() && 0.0 < weak * strong;
    if is_definite { (2.0 * seen.rise / weak).max(0.0).sqrt() } else { 0.0 }
}

/// Steps in the plane that lead around a contact.
fn circle(radius: f64) -> impl Iterator<Item = DVec2> {
    (0..N_LOOKS).map(move |i| {
        let (sine, cosine) =
            libm::sincos(std::f64::consts::TAU * f64::from(i) / f64::from(N_LOOKS));
        DVec2::new(cosine, sine) * radius
    })
}
