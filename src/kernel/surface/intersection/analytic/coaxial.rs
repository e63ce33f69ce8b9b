//! Circles in which cylinders, cones, spheres and tori about one axis, and planes across it, cross.
//!
//! Where they cross at so small an angle that no search tells the circles apart, such as a ball and the hole of a
//! thin ring, the lines and circles that turn about the axis still do. Every circle is looked at before it is told.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use super::{super::level_set::ClosestPointTracker, AnalyticForm, AnalyticSurface};
use crate::{
    CircleForm, Direction, Frame, Interval, LevelSet, NurbsCurve, NurbsSurface, Tolerance,
    frame::norm,
    sorting::sort_by,
    tolerance::{ANALYTIC_RELATIVE, COAXIAL_SINE, CONTACT_SHARE},
};

/// Part of the tolerance by which axes that are one may miss one another.
const AXIS_SHARE: f64 = 0.1 * CONTACT_SHARE;

/// Surfaces that keep within so many tolerances of one another where they cross, or all but do, run together.
pub(super) const LEAST_DEPTH: f64 = 4.0;

/// Part of the tolerance by which meridians that touch may miss one another.
const TOUCH_SHARE: f64 = 0.1 * CONTACT_SHARE;

/// Places of a circle that are looked at.
const N_LOOKS: u32 = 24;

/// What turns about an axis, in the half plane of the distance from the axis and the height.
#[derive(Clone, Copy, Debug)]
enum MeridianLine {
    /// Points with this product with a unit vector.
    Straight {
        normal: DVec2,
        offset: f64,
    },
    Round {
        center: DVec2,
        radius: f64,
    },
}

impl NurbsSurface {
    /// The circles in which it crosses or touches another surface about the same axis, along N × N of the two; none where they
    /// have no common axis, only a part of a circle, or run together within some tolerances.
    pub(in crate::surface) fn coaxial_circles(
        &self,
        other: &Self,
        distance: f64,
    ) -> Option<Vec<NurbsCurve>> {
        let touch = [TOUCH_SHARE, CONTACT_SHARE].map(|share| share * distance);
        self.circles_about(other, distance, touch)
    }

    /// What it has in common with another surface about the same axis where both touch within the tolerance, or all but do,
    /// along a circle: such circles, by which they miss one another being told as rounding or not, and those of other
    /// places. A search would take those beside one another for many.
    pub(in crate::surface) fn coaxial_touches(
        &self,
        other: &Self,
        distance: f64,
    ) -> Option<LevelSet> {
        let curves = self.circles_about(other, distance, [distance; 2])?;
        let rounding =
            ANALYTIC_RELATIVE * self.bounds().magnitude().max(other.bounds().magnitude());
        let (mut contacts, mut uncertain) = (Vec::new(), Vec::new());
        for circle in &curves {
            let point = circle.start();
            let feet = [self, other].map(|surface| surface.closest(point));
            let [a, b] = [(self, feet[0]), (other, feet[1])].map(|(surface, foot)| {
                surface.normal_at(foot.parameters[0], foot.parameters[1]).ok()
            });
            if norm(a?.cross(b?)) <= Tolerance::DEFAULT.angle {
                let gap = norm(feet[0].point - feet[1].point);
                if gap <= rounding { &mut contacts } else { &mut uncertain }.push(point);
            }
        }
        let is_touched = !(contacts.is_empty() && uncertain.is_empty());
        is_touched.then(|| LevelSet { curves, contacts, uncertain, ..LevelSet::default() })
    }

    /// The circles in which both cross, and those along which they touch within the first distance of `touch`, whose
    /// places are on both within the second.
    fn circles_about(
        &self,
        other: &Self,
        distance: f64,
        [touch, near]: [f64; 2],
    ) -> Option<Vec<NurbsCurve>> {
        let (axis, [one, another]) = self.meridians(other, distance)?;
        let sides = [self, other].map(|surface| surface.plane_quadrilateral(distance));
        let turns = |surface: &Self, sides: &Option<_>| {
            sides.is_some() || surface.turns_fully(axis, distance)
        };
        if !turns(self, &sides[0]) || !turns(other, &sides[1]) {
            return None;
        }
        let mut circles = Vec::new();
        for place in one.places_on(another, [touch, LEAST_DEPTH * distance])? {
            if place.x < -distance {
                continue;
            }
            let center = axis.point(DVec3::Z * place.y);
            let frame = axis.at(center);
            let sides = sides.iter().flatten();
            if !sides.into_iter().all(|sides| are_clear(sides, center, place.x, distance)) {
                return None;
            }
            let circle = (distance < place.x)
                .then(|| NurbsCurve::ellipse(frame, [place.x; 2], CircleForm::NinePoint).ok())??;
            if self.has_all_of(&circle, [near, distance])?
                && other.has_all_of(&circle, [near, distance])?
            {
                circles.push(self.directed_across(other, circle)?);
            }
        }
        Some(circles)
    }

    /// The same where all of these cross by more than a search takes for a touch, and the surfaces meet nowhere else.
    pub(in crate::surface) fn coaxial_crossings(
        &self,
        other: &Self,
        distance: f64,
    ) -> Option<Vec<NurbsCurve>> {
        let circles = self.coaxial_circles(other, distance)?;
        let is_clear = |circle: &NurbsCurve| {
            let point = circle.start();
            let normals = [self, other].map(|surface| {
                let [u, v] = surface.closest(point).parameters;
                surface.normal_at(u, v).ok()
            });
            matches!(normals, [Some(a), Some(b)] if COAXIAL_SINE < norm(a.cross(b)))
        };
        if circles.is_empty() || !circles.iter().all(is_clear) {
            return None;
        }
        // In the order of parameters of the first that has some across them, balls last, as a search finds them.
        let (axis, _) = self.meridians(other, distance)?;
        let is_ball = matches!(
            self.analytic(distance).map(|found| found.form),
            Some(AnalyticForm::Sphere { .. })
        );
        let in_turn = if is_ball { [other, self] } else { [self, other] };
        let around = in_turn
            .into_iter()
            .find_map(|surface| Some((surface, surface.direction_around(axis, distance)?.other())));
        let place = |circle: &NurbsCurve| {
            around
                .map_or(0.0, |(surface, across)| surface.closest(circle.start()).parameters[across])
        };
        let mut places: Vec<(f64, NurbsCurve)> =
            circles.into_iter().map(|circle| (place(&circle), circle)).collect();
        sort_by(&mut places, |a, b| a.0.total_cmp(&b.0));
        // Parametrized by about their length, as all that is found of surfaces.
        let along = |(_, circle): (f64, NurbsCurve)| {
            let domain = Interval::new(0.0, circle.length(circle.domain())).ok()?;
            Some(circle.reparametrized(domain))
        };
        places.into_iter().map(along).collect()
    }

    /// The ends of its sides where it is a plane of four corners, which is convex.
    fn plane_quadrilateral(&self, distance: f64) -> Option<[[DVec3; 2]; 4]> {
        let has_four = self.control_points.as_slice().len() == 4;
        let is_plane = || {
            let found = self.analytic(distance);
            matches!(found.map(|found| found.form), Some(AnalyticForm::Plane))
        };
        (has_four && is_plane()).then(|| self.edges().map(|edge| [edge.start(), edge.end()]))
    }

    /// Whether it goes all around an axis: along one of its parameters, or as a sphere with both of its poles.
    fn turns_fully(&self, axis: Frame, distance: f64) -> bool {
        let is_sphere = matches!(
            self.analytic(distance).map(|found| found.form),
            Some(AnalyticForm::Sphere { .. })
        );
        is_sphere && has_poles(self, distance) || self.direction_around(axis, distance).is_some()
    }

    /// The direction along which it goes all around an axis, if along one.
    pub(super) fn direction_around(&self, axis: Frame, distance: f64) -> Option<Direction> {
        let domains = [self.domain_u(), self.domain_v()];
        let is_around = |along: Direction| {
            let places = [0.2, 0.4, 0.7].map(|at| domains.map(|domain| domain.at(at)));
            places.iter().all(|&[u, v]| {
                let [point, along_u, along_v] = self.tangents_at(u, v);
                let way = [along_u, along_v][along];
                let arm = point - axis.origin();
                let out = arm - axis.z() * arm.dot(axis.z());
                let skew =
                    way.dot(axis.z()).abs().max(way.dot(out).abs() / norm(out).max(distance));
                skew <= Tolerance::DEFAULT.angle.sqrt() * norm(way)
            })
        };
        let is_closed = [self.is_closed_u(distance), self.is_closed_v(distance)];
        Direction::BOTH.into_iter().find(|&along| is_closed[along] && is_around(along))
    }

    /// Whether both lie on one cylinder, cone, sphere or torus.
    pub(in crate::surface) fn is_coaxially_on(&self, other: &Self, distance: f64) -> bool {
        let meridians = self.meridians(other, distance);
        meridians.is_some_and(|(_, [one, another])| one.is_near(another, distance))
    }

    /// The axis about which both turn, and what does so.
    fn meridians(&self, other: &Self, distance: f64) -> Option<(Frame, [MeridianLine; 2])> {
        let forms = [self.analytic(distance)?, other.analytic(distance)?];
        let has_axis = |found: &&AnalyticSurface| {
            !matches!(found.form, AnalyticForm::Sphere { .. } | AnalyticForm::Plane)
        };
        let is_ball = |found: &AnalyticSurface| matches!(found.form, AnalyticForm::Sphere { .. });
        let axis = match forms.iter().find(has_axis) {
            Some(found) => found.frame,
            None if forms.iter().all(is_ball) => forms[0].frame,
            // A ball turns about each axis through its centre: that of a plane says nothing of where a circle begins.
            None => return None,
        };
        let allowed = AXIS_SHARE * distance;
        let [one, another] = [0, 1].map(|i| MeridianLine::of(&forms[i], axis, allowed));
        Some((axis, [one?, another?]))
    }

    /// Whether all of a curve is on the surface, as near as the first distance, false where nothing of it is as near as the
    /// second; none of a part.
    pub(super) fn has_all_of(
        &self,
        curve: &NurbsCurve,
        [near, distance]: [f64; 2],
    ) -> Option<bool> {
        let (domain, mut tracker) = (curve.domain(), ClosestPointTracker::new(self));
        let mut places = (0..N_LOOKS).map(|i| {
            let point = curve.point_at(domain.at(f64::from(i) / f64::from(N_LOOKS)));
            tracker.distance(point, near)
        });
        let first = places.next()?;
        match (first <= near, distance < first) {
            (true, _) => places.all(|gap| gap <= near).then_some(true),
            (_, true) => places.all(|gap| distance < gap).then_some(false),
            _ => None,
        }
    }

    /// A curve of both so that it runs along the product of their normals.
    pub(super) fn directed_across(&self, other: &Self, curve: NurbsCurve) -> Option<NurbsCurve> {
        let derivatives = curve.derivatives_at(curve.domain().at(1.0 / TAU), 1);
        let normal = |surface: &Self| {
            let [u, v] = surface.closest(derivatives[0]).parameters;
            surface.normal_at(u, v).ok()
        };
        let across = normal(self)?.cross(normal(other)?);
        Some(if across.dot(derivatives[1]) < 0.0 { curve.reversed() } else { curve })
    }
}

/// Whether a surface is closed along one of its parameters, and narrows to points at both ends of the other.
pub(super) fn has_poles(surface: &NurbsSurface, distance: f64) -> bool {
    let is_closed = [surface.is_closed_u(distance), surface.is_closed_v(distance)];
    let is_point = |edge: NurbsCurve| edge.bounds().diagonal() <= distance;
    let [start_u, end_u, start_v, end_v] = surface.edges();
    is_closed[1] && is_point(start_u) && is_point(end_u)
        || is_closed[0] && is_point(start_v) && is_point(end_v)
}

/// Whether a circle in the plane of a convex quadrilateral crosses none of its sides and passes none nearby.
fn are_clear(sides: &[[DVec3; 2]; 4], center: DVec3, radius: f64, distance: f64) -> bool {
    let is_outside = |&[start, end]: &[DVec3; 2]| {
        let (way, arm) = (end - start, center - start);
        let along = (arm.dot(way) / way.length_squared()).clamp(0.0, 1.0);
        radius + distance < norm(arm - way * along)
    };
    let is_within = |[start, _]: &[DVec3; 2]| norm(*start - center) < radius - distance;
    sides.iter().all(is_outside) || sides.iter().all(is_within)
}

impl MeridianLine {
    /// That of a surface about an axis; none of one about another.
    fn of(found: &AnalyticSurface, axis: Frame, allowed: f64) -> Option<Self> {
        let way = found.frame.origin() - axis.origin();
        let height = way.dot(axis.z());
        let is_on_axis = norm(way - axis.z() * height) <= allowed;
        let sense = found.frame.z().dot(axis.z());
        let is_along =
            norm(found.frame.z() - axis.z() * sense.signum()) <= Tolerance::DEFAULT.angle;
        let is_round = matches!(found.form, AnalyticForm::Sphere { .. });
        let is_plane = matches!(found.form, AnalyticForm::Plane);
        if !(is_on_axis || is_plane) || !(is_along || is_round) {
            return None;
        }
        Some(match found.form {
            AnalyticForm::Plane => Self::Straight { normal: DVec2::Y, offset: height },
            AnalyticForm::Cylinder { radius } => {
                Self::Straight { normal: DVec2::X, offset: radius }
            }
            AnalyticForm::Cone { radius, half_angle } => {
                let (sine, cosine) = libm::sincos(half_angle);
                let normal = DVec2::new(cosine, -sine * sense.signum());
                Self::Straight { normal, offset: normal.dot(DVec2::new(radius, height)) }
            }
            AnalyticForm::Sphere { radius } => Self::Round { center: DVec2::Y * height, radius },
            AnalyticForm::Torus { major, minor } => {
                Self::Round { center: DVec2::new(major, height), radius: minor }
            }
        })
    }

    /// Whether both are one within a distance.
    fn is_near(self, other: Self, distance: f64) -> bool {
        match (self, other) {
            (Self::Straight { normal, offset }, Self::Straight { normal: its, offset: away }) => {
                normal.distance(its) <= Tolerance::DEFAULT.angle
                    && (offset - away).abs() <= distance
            }
            (
                Self::Round { center, radius },
                Self::Round { center: its_center, radius: its_radius },
            ) => center.distance(its_center) + (radius - its_radius).abs() <= distance,
            _ => false,
        }
    }

    /// The places of both; one where they touch up to the first depth, none where they keep, or pass one another,
    /// within the second.
    fn places_on(self, other: Self, [touch, depth]: [f64; 2]) -> Option<Vec<DVec2>> {
        match (self, other) {
            (Self::Straight { normal, offset }, Self::Straight { normal: its, offset: away }) => {
                let sine = normal.perp_dot(its);
                let is_clear = Tolerance::DEFAULT.angle.sqrt() < sine.abs();
                is_clear.then(|| vec![(its.perp() * offset - normal.perp() * away) / -sine])
            }
            (Self::Straight { normal, offset }, Self::Round { center, radius })
            | (Self::Round { center, radius }, Self::Straight { normal, offset }) => {
                chord(center, radius, normal, offset - normal.dot(center), [touch, depth])
            }
            (
                Self::Round { center, radius },
                Self::Round { center: its_center, radius: its_radius },
            ) => {
                let way = its_center - center;
                let length = way.length();
                // How far the one reaches into the other, and out of it.
                let into = radius + its_radius - length;
                let out = length - (radius - its_radius).abs();
                let least = into.abs().min(out.abs());
                if least <= touch && depth < length {
                    // From outside towards the other's centre, from inside away from the lesser one's.
                    let is_away = out.abs() <= touch && radius < its_radius;
                    let side = if is_away { -radius } else { radius };
                    return Some(vec![center + way * (side / length)]);
                }
                if least <= depth {
                    return None;
                }
                if into < 0.0 || out < 0.0 {
                    return Some(Vec::new());
                }
                let squares = length * length + (radius - its_radius) * (radius + its_radius);
                chord(center, radius, way / length, 0.5 * squares / length, [0.0; 2])
            }
        }
    }
}

/// The places of a circle on a line at a distance from its centre; one where it touches up to the first depth, none
/// where it is nearer to touching than the second.
fn chord(
    center: DVec2,
    radius: f64,
    normal: DVec2,
    distance: f64,
    [touch, depth]: [f64; 2],
) -> Option<Vec<DVec2>> {
    let inside = radius - distance.abs();
    if inside.abs() <= touch && depth < radius {
        return Some(vec![center + normal * distance]);
    }
    if inside.abs() <= depth {
        return None;
    }
    if inside < 0.0 {
        return Some(Vec::new());
    }
    let half = (inside * (radius + distance.abs())).sqrt();
    let foot = center + normal * distance;
    Some([half, -half].map(|along| foot + normal.perp() * along).to_vec())
}
