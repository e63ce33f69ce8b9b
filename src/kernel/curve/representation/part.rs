//! Bézier pieces of curves in search of one another: boxes, and cones of tangents.

use std::sync::OnceLock;

use glam::{DVec3, DVec4};
use smallvec::SmallVec;

use crate::{
    Bounds, Interval,
    bernstein::{derivative, product},
    bezier,
    curve::{NurbsCurve, intersection::bend::longest},
    frame::widest_angle,
    homogeneous,
    tolerance::KNOT_RELATIVE,
};

/// Two pieces cross clearly when their cones of tangents are this far apart, in radians.
const CLEAR_ANGLE: f64 = 0.1;

/// A Bézier piece of a curve.
#[derive(Clone)]
pub(crate) struct CurvePart {
    pub(crate) interval: Interval,
    /// Those of a cubic need no memory of their own.
    pub(crate) points: SmallVec<[DVec4; 4]>,
    pub(crate) bounds: Bounds,
    cone: OnceLock<DirectionCone>,
}

/// Directions within an angle of an axis; `None` stands for all of them.
#[derive(Clone, Copy)]
pub(crate) struct DirectionCone {
    axis: DVec3,
    angle: Option<f64>,
}

/// The pieces of a curve between its knots.
pub(crate) fn parts(curve: &NurbsCurve) -> Vec<CurvePart> {
    curve.knots().spans().map(|span| CurvePart::of_span(curve, span)).collect()
}

impl CurvePart {
    pub(crate) fn of_span(curve: &NurbsCurve, span: usize) -> Self {
        let points = bezier::piece(curve.knots(), curve.control_points(), span);
        Self::new(curve.knots().span_interval(span), points.into())
    }

    fn new(interval: Interval, points: SmallVec<[DVec4; 4]>) -> Self {
        let places = points.iter().map(|&point| homogeneous::place(point));
        let bounds = Bounds::of(places).unwrap_or(Bounds { min: DVec3::ZERO, max: DVec3::ZERO });
        Self { interval, points, bounds, cone: OnceLock::new() }
    }

    /// A cone that holds every tangent.
    pub(crate) fn cone(&self) -> DirectionCone {
        *self.cone.get_or_init(|| DirectionCone::of_velocity(&self.points))
    }

    /// What of it lies in an interval.
    pub(crate) fn within(self, interval: Interval) -> Option<Self> {
        let own = self.interval;
        let (start, end) = (own.start().max(interval.start()), own.end().min(interval.end()));
        let cut = Interval::new(start, end).ok()?;
        if cut == own {
            return Some(self);
        }
        let (before, _) = bezier::cut_at(&self.points, own.fraction_of(end));
        let from = own.length() * own.fraction_of(start) / (end - own.start());
        let (_, inside) = bezier::cut_at(&before, from);
        Some(Self::new(cut, inside.into()))
    }

    pub(crate) fn halves(&self) -> [Self; 2] {
        self.parts_at(0.5, self.interval.halves())
    }

    /// Both parts of it where it is cut at a fraction; none where one of them would be no wider than rounding.
    pub(crate) fn cut_at(&self, fraction: f64) -> Option<[Self; 2]> {
        let (own, t) = (self.interval, self.interval.at(fraction));
        let intervals = [Interval::new(own.start(), t), Interval::new(t, own.end())];
        let [Ok(before), Ok(behind)] = intervals else { return None };
        Some(self.parts_at(fraction, [before, behind]))
    }

    fn parts_at(&self, fraction: f64, [before, behind]: [Interval; 2]) -> [Self; 2] {
        let mut left = SmallVec::with_capacity(self.points.len());
        let mut right = self.points.clone();
        bezier::cut_off(&mut right, fraction, |point| left.push(point));
        [Self::new(before, left), Self::new(behind, right)]
    }

    /// Whether the boxes are within the tolerance of one another, and the control points across
    /// either chord, where two that run side by side are told apart.
    pub(crate) fn may_meet(&self, other: &Self, tolerance: f64) -> bool {
        self.bounds.is_near(other.bounds, tolerance)
            && !self.lies_beside(other, tolerance)
            && !other.lies_beside(self, tolerance)
    }

    /// Whether a plane along the chord parts the control points by more than the tolerance.
    fn lies_beside(&self, other: &Self, tolerance: f64) -> bool {
        let ends = |part: &Self| [0, part.points.len() - 1].map(|i| part.points[i]);
        let [own, others] = [ends(self), ends(other)].map(|ends| ends.map(homogeneous::place));
        let chord = own[1] - own[0];
        let between = 0.5 * (others[0] + others[1] - own[0] - own[1]);
        let across = between - chord * (between.dot(chord) / chord.length_squared());
        let Some(across) = across.try_normalize() else { return false };
        let height = |&point: &DVec4| homogeneous::place(point).dot(across);
        let highest = self.points.iter().map(height).fold(f64::NEG_INFINITY, f64::max);
        let lowest = other.points.iter().map(height).fold(f64::INFINITY, f64::min);
        tolerance < lowest - highest
    }

    /// How far the control points are from the chord at most.
    pub(crate) fn deviation_from_chord(&self) -> f64 {
        let ends = [self.points[0], self.points[self.points.len() - 1]].map(homogeneous::project);
        let chord = ends[1] - ends[0];
        let off = |&point: &DVec4| {
            let from_start = homogeneous::place(point) - ends[0];
            let along = from_start.dot(chord) / chord.length_squared();
            let along = if along.is_finite() { along.clamp(0.0, 1.0) } else { 0.0 };
            from_start.distance(chord * along)
        };
        self.points.iter().map(off).fold(0.0, f64::max)
    }
}

impl DirectionCone {
    const EVERYTHING: Self = Self { axis: DVec3::ZERO, angle: None };

    /// A cone that holds every tangent of a piece.
    fn of_velocity(points: &[DVec4]) -> Self {
        let n = points.len();
        let velocity: SmallVec<[DVec3; 4]> =
            if 1 < n && points.iter().all(|point| point.w.total_cmp(&points[0].w).is_eq()) {
                let leg = |pair: &[DVec4]| (pair[1] - pair[0]).truncate() * (n - 1) as f64;
                points.windows(2).map(leg).collect()
            } else {
                let numerator: Vec<DVec3> = points.iter().map(|point| point.truncate()).collect();
                let weight: Vec<f64> = points.iter().map(|point| point.w).collect();
                let times = |vector: DVec3, factor: f64| vector * factor;
                let grown = product(&derivative(&numerator), &weight, times);
                let shrunk = product(&numerator, &derivative(&weight), times);
                grown.iter().zip(&shrunk).map(|(&a, &b)| a - b).collect()
            };
        let rounding = longest(&velocity) * KNOT_RELATIVE;
        let clear = || velocity.iter().copied().filter(|slope| rounding < slope.length());
        let Some(axis) = clear().map(DVec3::normalize).sum::<DVec3>().try_normalize() else {
            return Self::EVERYTHING;
        };
        Self { axis, angle: Some(widest_angle(clear(), axis)) }
    }

    pub(crate) fn is_within_half_turn(self) -> bool {
        self.angle.is_some_and(|angle| angle < std::f64::consts::FRAC_PI_2)
    }

    /// Whether it is at most a quarter turn wide, so that the speed in it stays away from zero.
    pub(crate) fn is_narrow(self) -> bool {
        self.angle.is_some_and(|angle| angle <= std::f64::consts::FRAC_PI_4)
    }

    /// The opposite directions.
    pub(crate) fn reversed(self) -> Self {
        Self { axis: -self.axis, ..self }
    }

    /// A cone around both.
    pub(crate) fn with(self, other: Self) -> Self {
        let (Some(own), Some(others)) = (self.angle, other.angle) else { return Self::EVERYTHING };
        let Some(axis) = (self.axis + other.axis).try_normalize() else { return Self::EVERYTHING };
        let angle =
            (own + axis.angle_between(self.axis)).max(others + axis.angle_between(other.axis));
        Self { axis, angle: Some(angle) }
    }

    /// Whether no direction of one is near one of the other or its opposite.
    pub(crate) fn crosses_clearly(self, other: Self) -> bool {
        let (Some(own), Some(others)) = (self.angle, other.angle) else { return false };
        let between = self.axis.angle_between(other.axis);
        let between = between.min(std::f64::consts::PI - between);
        own + others + CLEAR_ANGLE < between
    }
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, DVec4};

    use super::{CurvePart, DirectionCone, parts};
    use crate::{Frame, Interval, KnotVector, NurbsCurve, homogeneous};

    /// A bow with weights that pull its tangents, and an arc of a third of a turn.
    fn rational() -> Vec<CurvePart> {
        let corners = [[0.0, 0.0, 0.0], [1.0, 3.0, 1.0], [4.0, 2.0, -1.0], [6.0, 0.0, 2.0]];
        let (knots, weights) = (KnotVector::bezier(3).unwrap(), [1.0, 5.0, 0.3, 2.0]);
        let bow = NurbsCurve::rational(knots, &corners.map(DVec3::from), &weights);
        let arc = NurbsCurve::arc(Frame::XY, 2.0, 0.5, 2.0);
        [bow, arc].into_iter().flat_map(|made| parts(&made.unwrap())).collect()
    }

    fn point(part: &CurvePart, fraction: f64) -> DVec3 {
        let mut left = part.points.to_vec();
        while 1 < left.len() {
            left = left.windows(2).map(|pair| pair[0].lerp(pair[1], fraction)).collect();
        }
        homogeneous::place(left[0])
    }

    fn straight(from: [f64; 3], to: [f64; 3]) -> CurvePart {
        let ends = [from, to].map(|end| DVec3::from(end).extend(1.0));
        CurvePart::new(Interval::UNIT, ends.as_slice().into())
    }

    #[test]
    fn every_chord_of_a_narrow_piece_lies_in_its_cone() {
        for whole in rational() {
            for part in whole.halves().iter().flat_map(CurvePart::halves) {
                let (cone, n) = (part.cone(), 50);
                let angle = cone.angle.unwrap();
                assert!(cone.is_within_half_turn());
                for i in 0..n {
                    let [a, b] = [i, i + 1].map(|i| point(&part, f64::from(i) / f64::from(n)));
                    assert!((b - a).angle_between(cone.axis) <= angle + 1e-9, "{i}: {angle}");
                }
            }
        }
    }

    #[test]
    fn a_cone_of_an_arc_is_hardly_wider_than_its_turn() {
        let arc = NurbsCurve::arc(Frame::XY, 2.0, 0.0, 0.4).unwrap();
        let cone = parts(&arc)[0].cone();
        let angle = cone.angle.unwrap();
        assert!((0.2 - 1e-9..0.21).contains(&angle), "{angle}");
        assert!(cone.is_narrow() && cone.with(cone.reversed()).angle.is_none());
        assert_eq!(cone.with(cone).angle, Some(angle));
    }

    #[test]
    fn a_piece_within_an_interval_has_the_points_of_the_whole() {
        for whole in rational() {
            let own = whole.interval;
            let (from, to) = (own.at(0.2), own.at(0.7));
            let cut = whole.clone().within(Interval::new(from, to).unwrap()).unwrap();
            let [before, behind] = whole.cut_at(0.2).unwrap();
            for f in [0.0, 0.25, 0.5, 1.0] {
                assert!(point(&cut, f).distance(point(&whole, 0.2 + 0.5 * f)) < 1e-13);
                assert!(point(&before, f).distance(point(&whole, 0.2 * f)) < 1e-13);
                assert!(point(&behind, f).distance(point(&whole, 0.2 + 0.8 * f)) < 1e-13);
            }
            assert!((cut.interval.start(), cut.interval.end()) == (from, to));
            assert!(whole.cut_at(0.0).is_none() && whole.cut_at(1.0).is_none());
        }
    }

    #[test]
    fn pieces_side_by_side_do_not_meet_although_their_boxes_do() {
        let diagonal = straight([0.0, 0.0, 0.0], [4.0, 4.0, 0.0]);
        let beside = straight([0.5, 0.0, 0.0], [4.5, 4.0, 0.0]);
        let across = straight([0.0, 4.0, 0.0], [4.0, 0.0, 0.0]);
        // They are half of the square root of a half apart.
        assert!(!diagonal.may_meet(&beside, 0.35) && diagonal.may_meet(&beside, 0.36));
        assert!(diagonal.may_meet(&across, 0.0));
        assert!(!diagonal.may_meet(&straight([6.0, 0.0, 0.0], [7.0, 1.0, 0.0]), 1.9));
        assert!(diagonal.cone().crosses_clearly(across.cone()));
        assert!(!diagonal.cone().crosses_clearly(beside.cone()));
        assert!(!diagonal.cone().crosses_clearly(beside.cone().reversed()));
        assert!(!diagonal.cone().crosses_clearly(DirectionCone::EVERYTHING));
    }

    #[test]
    fn a_control_point_beyond_the_chord_is_as_far_as_the_end() {
        let place = |x: f64, y: f64| DVec4::new(x, y, 0.0, 1.0);
        let check = |middle: DVec4, expected: f64| {
            let points = [place(0.0, 0.0), middle, place(2.0, 0.0)];
            let hook = CurvePart::new(Interval::UNIT, points.as_slice().into());
            let found = hook.deviation_from_chord();
            assert!((found - expected).abs() < 1e-15, "{middle}: {found}");
        };
        check(place(1.0, 3.0), 3.0);
        check(place(5.0, 4.0), 5.0);
        check(place(-3.0, 4.0), 5.0);
        check(2.0 * place(0.5, -1.0), 1.0);
    }
}
