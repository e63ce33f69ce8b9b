//! Arcs of circles in the plane z = 0, which cross in a closed form.
//!
//! Circles that cross at a clear angle do so in two places, and come within the tolerance of one another beside these
//! alone. What is less clear, as where they touch or an arc ends beside a crossing, is left to the search.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3, DVec4};
use smallvec::SmallVec;

use super::meeting::{CurveIntersection, IntersectionSearch};
use crate::{
    Interval,
    bernstein::product,
    bezier,
    curve::NurbsCurve,
    homogeneous,
    sorting::sort_by,
    tolerance::{CIRCLE_JOINT_RELATIVE, CIRCLE_SHARE},
};

/// The least sine of the angle at which circles cross clearly.
const CLEAR_SINE: f64 = 0.1;

/// Tolerances, over the sine of the angle at a crossing, within which no arc may end beside it.
const CLEARANCE: f64 = 64.0;

/// Pieces of a curve that is looked at, whether it is a circle.
const MOST_PIECES: usize = 16;

/// Roundings beyond the tolerance at which circles are apart for certain.
const APART_ROUNDINGS: f64 = 16.0;

/// The radius of a circle, in terms of the size of its arc: the centres of larger ones are lost in rounding, as of a straight
/// side of degree 2.
const MOST_RADIUS: f64 = 64.0;

/// A curve of degree 2 that runs along a circle, once around at most, and turns back nowhere.
struct CircularArc {
    center: DVec2,
    radius: f64,
    /// 1 if it runs counter-clockwise, else −1.
    sense: f64,
    ends: [DVec2; 2],
    pieces: SmallVec<[CircularPiece; 4]>,
}

/// A Bézier piece, which turns by less than half a turn, as its weights are positive.
struct CircularPiece {
    interval: Interval,
    points: [DVec4; 3],
}

impl NurbsCurve {
    /// Where it crosses another curve of the plane z = 0, where both are arcs of circles that cross clearly, or keep
    /// further apart than the tolerance for certain; none where [`Self::intersections`] must tell.
    pub(crate) fn circle_crossings(
        &self,
        other: &Self,
        tolerance: f64,
    ) -> Option<Vec<CurveIntersection>> {
        if self.degree() != 2 || other.degree() != 2 {
            return None;
        }
        let search = IntersectionSearch::new(self, other, tolerance, 0);
        let tolerance = search.tolerance;
        let [a, b] = [CircularArc::of(self, tolerance)?, CircularArc::of(other, tolerance)?];
        let way = b.center - a.center;
        let distance = way.length();
        let slack = (1.0 + 4.0 * CIRCLE_SHARE) * tolerance + APART_ROUNDINGS * search.rounding;
        let (sum, difference) = (a.radius + b.radius, (a.radius - b.radius).abs());
        if sum + slack < distance || distance + slack < difference {
            return Some(Vec::new());
        }
        let along = 0.5 * (distance + (a.radius - b.radius) * sum / distance);
        let half = ((a.radius - along) * (a.radius + along)).sqrt();
        let sine = distance * half / (a.radius * b.radius);
        let reach = CLEARANCE * tolerance / sine;
        // Not so where it is no number.
        let is_clear = CLEAR_SINE <= sine && reach <= half.min(a.radius).min(b.radius);
        if !is_clear {
            return None;
        }
        let (foot, across) = (a.center + way * (along / distance), way.perp() * (half / distance));
        let mut found = Vec::with_capacity(2);
        for place in [foot + across, foot - across] {
            if [&a, &b].iter().any(|arc| arc.ends.iter().any(|end| end.distance(place) <= reach)) {
                return None;
            }
            if let (Some((own, t)), Some((its, s))) = (a.piece_at(place), b.piece_at(place)) {
                found.push(search.crossing([own, its], [t, s])?);
            }
        }
        sort_by(&mut found, |a, b| a.first.total_cmp(&b.first));
        Some(found)
    }

    /// Whether it is an arc of a circle in the plane z = 0 that comes to itself nowhere but at the end where it closes.
    pub(crate) fn is_circular_arc(&self, tolerance: f64) -> bool {
        self.degree() == 2 && CircularArc::of(self, tolerance).is_some()
    }
}

impl CircularArc {
    /// A curve as one, if it is within a small part of the tolerance of a circle that is much larger than that.
    fn of(curve: &NurbsCurve, tolerance: f64) -> Option<Self> {
        let domain = curve.domain();
        let is_flat = |point: &DVec4| point.z.abs() <= 0.0 && 0.0 < point.w;
        let is_plane = curve.control_points().iter().all(is_flat);
        // Far from zero parameters have too few digits.
        if MOST_PIECES < curve.n_segments() || !is_plane || domain.near_zero().is_some() {
            return None;
        }
        let piece = |span: usize| {
            let points = bezier::piece(curve.knots(), curve.control_points(), span);
            let interval = curve.knots().span_interval(span);
            Some(CircularPiece { interval, points: points.try_into().ok()? })
        };
        let pieces: Option<SmallVec<[CircularPiece; 4]>> =
            curve.knots().spans().map(piece).collect();
        let pieces = pieces?;
        let allowed = CIRCLE_SHARE * tolerance;
        let goes_on = |pair: &[CircularPiece]| {
            let [[.., end], [start, ..]] = [&pair[0], &pair[1]].map(CircularPiece::places);
            end.distance(start) <= allowed
        };
        if !pieces.windows(2).all(goes_on) {
            return None;
        }
        let ends = [curve.start(), curve.end()].map(DVec3::truncate);
        let gap = ends[0].distance(ends[1]);
        let last = if gap <= tolerance { 2.0 / 3.0 } else { 1.0 };
        let middle = curve.point_at(domain.at(0.5 * last)).truncate();
        let last =
            if gap <= tolerance { curve.point_at(domain.at(last)).truncate() } else { ends[1] };
        let center = circumcenter([ends[0], middle, last]);
        let radius = center.distance(ends[0]);
        let size = ends[0].distance(middle).max(ends[0].distance(last));
        // Not so where it is no number.
        let is_told = CLEARANCE * tolerance < radius && radius <= MOST_RADIUS * size;
        if !is_told {
            return None;
        }
        let mut turn = 0.0_f64;
        for piece in &pieces {
            let own = piece.turn(center, radius, allowed)?;
            if own * turn < 0.0 {
                return None;
            }
            turn += own;
        }
        let is_closed = gap <= allowed;
        // An arc that nearly closes may come to itself.
        let is_open = CLEARANCE * tolerance < gap && turn.abs() < TAU;
        let goes_once = (turn.abs() - TAU).abs() <= CIRCLE_JOINT_RELATIVE;
        (is_open || is_closed && goes_once).then(|| Self {
            center,
            radius,
            sense: turn.signum(),
            ends,
            pieces,
        })
    }

    /// The interval of the piece on which a place of the circle is, and about the parameter there; none where the arc does
    /// not come to it.
    fn piece_at(&self, place: DVec2) -> Option<(Interval, f64)> {
        let out = place - self.center;
        let slack = CIRCLE_JOINT_RELATIVE * self.radius * self.radius;
        let is_on = |piece: &&CircularPiece| {
            let [start, _, end] = piece.places();
            let [from, to] = [start - self.center, end - self.center];
            -slack <= self.sense * from.perp_dot(out)
                && -slack <= self.sense * out.perp_dot(to)
                && 0.0 < out.dot(from + to)
        };
        let piece = self.pieces.iter().find(is_on)?;
        Some((piece.interval, piece.interval.at(piece.fraction_at(place))))
    }
}

impl CircularPiece {
    /// The places of its control points.
    fn places(&self) -> [DVec2; 3] {
        self.points.map(|point| homogeneous::project(point).truncate())
    }

    /// The angle by which it turns about a centre, if all of it is as near as that to the circle about it: the quotient of
    /// x² + y² − r²w² and w² is twice the radius times how far it misses.
    fn turn(&self, center: DVec2, radius: f64, allowed: f64) -> Option<f64> {
        let local =
            self.points.map(|point| (point.truncate().truncate() - center * point.w, point.w));
        let misses = product(&local, &local, |(p, w), (q, v)| p.dot(q) - radius * radius * w * v);
        let weights = product(&local, &local, |(_, w), (_, v)| w * v);
        let most = 2.0 * radius * allowed;
        let is_round = misses.iter().zip(weights).all(|(miss, w)| miss.abs() <= most * w);
        let [(from, _), (middle, _), (to, _)] = local;
        // Both halves of its hull turn the same way.
        let ways = [from.perp_dot(middle), middle.perp_dot(to)];
        let is_one_way = ways.iter().all(|&way| 0.0 < way) || ways.iter().all(|&way| way < 0.0);
        (is_round && is_one_way).then(|| libm::atan2(from.perp_dot(to), from.dot(to)))
    }

    /// About the fraction of its interval at which it comes to a place: where (1 − t)²w₀ and t²w₂ are as the areas of that
    /// place with the legs across from both ends.
    fn fraction_at(&self, place: DVec2) -> f64 {
        let [start, middle, end] = self.places().map(|corner| corner - place);
        let [at_start, at_end] = [middle.perp_dot(end), start.perp_dot(middle)].map(f64::abs);
        let ratio = (at_end * self.points[0].w / (at_start * self.points[2].w)).sqrt();
        let fraction = ratio / (1.0 + ratio);
        if fraction.is_finite() { fraction } else { 0.5 }
    }
}

/// The centre of the circle through three places; no number where they are on a line.
fn circumcenter([a, b, c]: [DVec2; 3]) -> DVec2 {
    let (to_b, to_c) = (b - a, c - a);
    let out = to_c.perp() * to_b.length_squared() - to_b.perp() * to_c.length_squared();
    a - out / (2.0 * to_b.perp_dot(to_c))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use glam::DVec3;

    use crate::{CircleForm, CurveIntersection, Frame, NurbsCurve};

    const TOLERANCE: f64 = 1e-6;

    fn circle(x: f64, y: f64, radius: f64) -> NurbsCurve {
        let frame = Frame::XY.at(DVec3::new(x, y, 0.0));
        NurbsCurve::ellipse(frame, [radius; 2], CircleForm::NinePoint).expect("a circle")
    }

    /// Whether the search finds the same places.
    #[track_caller]
    fn check_against_search(own: &NurbsCurve, other: &NurbsCurve, found: &[CurveIntersection]) {
        let searched = own.intersections(other, TOLERANCE).expect("places");
        assert_eq!(found.len(), searched.len());
        for (place, known) in found.iter().zip(&searched) {
            assert!(place.point.distance(known.point) < 1e-14, "{place:?} {known:?}");
            assert!((place.first - known.first).abs() < 1e-14, "{place:?} {known:?}");
            assert!((place.second - known.second).abs() < 1e-14, "{place:?} {known:?}");
        }
    }

    #[test]
    fn circles_cross_where_both_radii_reach() {
        let (own, other) = (circle(0.0, 0.0, 1.3), circle(1.1, 0.4, 0.9));
        let found = own.circle_crossings(&other, TOLERANCE).expect("a clear crossing");
        assert_eq!(found.len(), 2);
        for place in &found {
            assert!((place.point.length() - 1.3).abs() < 1e-14, "{place:?}");
            let away = place.point.distance(DVec3::new(1.1, 0.4, 0.0));
            assert!((away - 0.9).abs() < 1e-14, "{place:?}");
            assert!(own.point_at(place.first).distance(place.point) < 1e-14, "{place:?}");
            assert!(other.point_at(place.second).distance(place.point) < 1e-14, "{place:?}");
        }
        check_against_search(&own, &other, &found);
    }

    #[test]
    fn circles_that_keep_apart_have_nothing_in_common() {
        let own = circle(0.0, 0.0, 1.0);
        for other in [circle(2.1, 0.0, 1.0), circle(0.2, 0.0, 0.7), circle(0.0, 0.0, 3.0)] {
            assert_eq!(own.circle_crossings(&other, TOLERANCE), Some(Vec::new()));
        }
    }

    #[test]
    fn what_is_not_clear_is_left_to_the_search() {
        let own = circle(0.0, 0.0, 1.0);
        // They touch, touch within the tolerance, are one, or cross in the seam of one of them.
        let unclear = [
            circle(2.0, 0.0, 1.0),
            circle(0.5, 0.0, 0.5),
            circle(2.0 + 0.9 * TOLERANCE, 0.0, 1.0),
            circle(1.9999, 0.0, 1.0),
            own.clone(),
            circle(1.0, 1.0, 1.0),
        ];
        for other in unclear {
            assert_eq!(own.circle_crossings(&other, TOLERANCE), None);
        }
        let ellipse =
            NurbsCurve::ellipse(Frame::XY, [1.0, 0.9], CircleForm::NinePoint).expect("an ellipse");
        assert_eq!(own.circle_crossings(&ellipse, TOLERANCE), None);
        let bent =
            NurbsCurve::bezier(&[DVec3::X, DVec3::ONE.with_z(0.0), DVec3::Y]).expect("a curve");
        assert_eq!(own.circle_crossings(&bent, TOLERANCE), None);
    }

    #[test]
    fn arcs_cross_only_where_both_are() {
        let upper = NurbsCurve::arc(Frame::XY, 1.0, 0.0, PI).expect("an arc");
        let right = NurbsCurve::arc(Frame::XY.at(DVec3::X * -0.3), 1.0, -FRAC_PI_2, PI);
        let right = right.expect("an arc");
        let found = upper.circle_crossings(&right, TOLERANCE).expect("a clear crossing");
        assert_eq!(found.len(), 1);
        check_against_search(&upper, &right, &found);
        let lower = NurbsCurve::arc(Frame::XY.at(DVec3::Y * -0.5), 1.0, PI, PI).expect("an arc");
        assert_eq!(upper.circle_crossings(&lower, TOLERANCE), Some(Vec::new()));
    }

    #[test]
    fn straight_sides_of_degree_two_are_left_to_the_search() {
        let own = circle(0.0, 0.0, 1.0);
        for end in [DVec3::new(0.31, 1.7, 0.0), DVec3::new(-1.3, 0.77, 0.0)] {
            let start = DVec3::new(0.123, -0.456, 0.0);
            let side = NurbsCurve::bezier(&[start, end]).expect("a side");
            let raised = side.elevate_degree(2).expect("a side");
            assert_eq!(own.circle_crossings(&raised, TOLERANCE), None);
            assert!(!raised.is_circular_arc(TOLERANCE));
        }
        let flat = NurbsCurve::arc(Frame::XY, 1.0, 0.0, 1e-3).expect("an arc");
        assert!(!flat.is_circular_arc(1e-12));
    }

    #[test]
    fn an_arc_that_closes_once_comes_to_itself_nowhere_else() {
        assert!(circle(3.0, 4.0, 2.0).is_circular_arc(TOLERANCE));
        let arc = |turn: f64| NurbsCurve::arc(Frame::XY, 1.0, 0.3, turn).expect("an arc");
        assert!(arc(5.0).is_circular_arc(TOLERANCE));
        assert!(!arc(2.0 * PI - 1e-7).is_circular_arc(TOLERANCE));
    }
}
