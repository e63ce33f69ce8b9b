//! Where two curves meet, and where one meets itself.
//!
//! Pairs of Bézier pieces whose boxes are apart are dropped, the others halved, until the pieces
//! of a pair cross at so clear an angle that they meet at most once, or lie together within the
//! tolerance. No pair is dropped on the word of samples, so that no meeting is lost. After
//! Sederberg & Nishita, *Curve intersection using Bézier clipping*, CAD 22 (1990), with tangent
//! cones as in Sederberg & Meyers (1988).

mod circles;
mod contact;
mod corners;
mod distinct;
mod ends;
mod joined;
mod meeting;
pub(in crate::curve) mod newton;
mod pairs;
mod shared;
mod straight;

pub use self::meeting::CurveIntersection;

use std::sync::Arc;

use self::{
    corners::{FEW, KnownContacts},
    meeting::{ContactInterval, IntersectionSearch, ReportedIntersection},
    newton::{beside, comes_near, nearest_on, nearest_step},
    pairs::{PartPair, near_crossing},
    straight::LegMeeting,
};
use crate::{
    Bounds, GeomError, Interval,
    ceiling::{CURVE_PAIR_WORK, NEWTON_STEPS},
    curve::{
        NurbsCurve,
        representation::part::{CurvePart, parts},
    },
    frame::norm,
    homogeneous,
    numeric::newton::{NewtonStep, within_limits},
    sorting::sort_by,
    tolerance::{KNOT_RELATIVE, LAST_BIT},
    work,
};

/// Pairs of pieces that may besides come of each span.
const PAIRS_A_SPAN: usize = 16;

/// Last bits of a coordinate within which two places cannot be told apart.
const MOST_ROUNDINGS: f64 = 16.0;

/// A touch is as long as the root of the tolerance times the size; what is longer by this factor
/// is looked at for how the distance runs along it.
const LONGEST_TOUCH: f64 = 16.0;

impl NurbsCurve {
    /// Every place where the curve comes within `tolerance` of another, by the parameter of this.
    ///
    /// # Errors
    /// `IntersectionError::RunTogether` where they share a stretch and not single points,
    /// `IntersectionError::Tangled` where the meetings are too many.
    pub fn intersections(
        &self,
        other: &Self,
        tolerance: f64,
    ) -> Result<Vec<CurveIntersection>, GeomError> {
        let over_jumps = self.meetings_over_jumps(Some(other), tolerance);
        over_jumps.unwrap_or_else(|| self.meetings_with(other, tolerance, &mut work([self, other])))
    }

    /// [`Self::intersections`] with so much work `left`.
    pub(in crate::curve) fn meetings_with(
        &self,
        other: &Self,
        tolerance: f64,
        left: &mut usize,
    ) -> Result<Vec<CurveIntersection>, GeomError> {
        if let Some(factor) = self.unit_factor(&[other]) {
            let curves = [self, other].map(|curve| curve.in_units(factor));
            let found = curves[0].meetings_with(&curves[1], tolerance * factor, left);
            return Ok(in_units(found?, factor));
        }
        if let Some(found) = self.meetings_near_zero(Some(other), tolerance, left) {
            return found;
        }
        let mut search = IntersectionSearch::new(self, other, tolerance, *left);
        match search.leg_meeting() {
            Some(LegMeeting::Apart) => return Ok(Vec::new()),
            Some(LegMeeting::At(meeting)) => return Ok(vec![meeting]),
            None => {}
        }
        let pairs = search.near_pairs()?;
        *left = search.run(pairs)?;
        search.finish()
    }

    /// Every place where the curve comes within `tolerance` of itself, by the lesser parameter
    /// first. The seam of a closed curve is none.
    ///
    /// # Errors
    /// `IntersectionError::RunsAlongItself`, `IntersectionError::Tangled` where the
    /// meetings are too many.
    pub fn self_intersections(&self, tolerance: f64) -> Result<Vec<CurveIntersection>, GeomError> {
        let over_jumps = self.meetings_over_jumps(None, tolerance);
        over_jumps.unwrap_or_else(|| self.own_meetings(tolerance, &mut work([self, self])))
    }

    /// [`Self::self_intersections`] with so much work `left`.
    pub(in crate::curve) fn own_meetings(
        &self,
        tolerance: f64,
        left: &mut usize,
    ) -> Result<Vec<CurveIntersection>, GeomError> {
        if let Some(factor) = self.unit_factor(&[]) {
            let found = self.in_units(factor).own_meetings(tolerance * factor, left);
            return Ok(in_units(found?, factor));
        }
        if let Some(found) = self.meetings_near_zero(None, tolerance, left) {
            return found;
        }
        let mut search = IntersectionSearch {
            is_same: true,
            ..IntersectionSearch::new(self, self, tolerance, *left)
        };
        let pieces: Vec<Arc<CurvePart>> = parts(self).into_iter().map(Arc::new).collect();
        let near = near_pairs(&pieces, tolerance).into_iter();
        let mut pairs: Vec<PartPair> =
            near.map(|(i, j)| (Arc::clone(&pieces[i]), Arc::clone(&pieces[j]))).collect();
        let mut alone = pieces;
        while work::goes_on(1)
            && let Some(part) = alone.pop()
        {
            // Whatever turns by less than half a turn does not come back to itself.
            if part.cone().is_within_half_turn() || search.is_tiny(&part) {
                continue;
            }
            let [left, right] = part.halves().map(Arc::new);
            pairs.push((Arc::clone(&left), Arc::clone(&right)));
            alone.extend([left, right]);
        }
        *left = search.run(pairs)?;
        search.finish()
    }
}

/// How much work the meetings of two curves are worth: control points of pairs of pieces.
pub(in crate::curve) fn work(curves: [&NurbsCurve; 2]) -> usize {
    let own = |curve: &NurbsCurve| (curve.degree() + 1) * curve.n_segments();
    CURVE_PAIR_WORK + PAIRS_A_SPAN * curves.into_iter().map(own).sum::<usize>()
}

/// Meetings that were found in other units.
fn in_units(mut meetings: Vec<CurveIntersection>, factor: f64) -> Vec<CurveIntersection> {
    meetings.iter_mut().for_each(|meeting| meeting.point /= factor);
    meetings
}

impl<'c> IntersectionSearch<'c> {
    fn new(first: &'c NurbsCurve, second: &'c NurbsCurve, tolerance: f64, left: usize) -> Self {
        let rounding = LAST_BIT * first.magnitude().max(second.magnitude());
        let tolerance = tolerance.max(MOST_ROUNDINGS * rounding);
        let size = Bounds::of(first.points()).map_or(0.0, Bounds::diagonal);
        let longest_touch = LONGEST_TOUCH * (tolerance * size).sqrt();
        let (meetings, contacts) = (Vec::new(), Vec::new());
        let is_same = false;
        Self {
            first,
            second,
            tolerance,
            is_same,
            longest_touch,
            rounding,
            left,
            meetings,
            contacts,
        }
    }

    /// Looks at all pairs; tells how much work is left.
    fn run(&mut self, pairs: Vec<PartPair>) -> Result<usize, GeomError> {
        let mut corners = Vec::new();
        self.look_at(pairs, |search, a, b| {
            let is_corner = search.may_be_corner(a, b);
            if is_corner {
                corners.push((Arc::clone(a), Arc::clone(b)));
            }
            is_corner
        })?;
        if FEW < corners.len() {
            let mut rest = Vec::new();
            for (a, b) in corners {
                match self.overlap(&a, &b) {
                    Some(contact) => self.contacts.push(contact),
                    None => rest.push((a, b)),
                }
            }
            corners = rest;
            let known = KnownContacts::of(&self.contacts);
            corners.retain(|(a, b)| work::goes_on(1) && !known.hold(a.interval, b.interval));
        }
        self.look_at(corners, |_, _, _| false)?;
        Ok(self.left)
    }

    /// Looks at pairs, but for those that are passed over, until nothing is to be halved.
    fn look_at(
        &mut self,
        pairs: Vec<PartPair>,
        mut is_passed_over: impl FnMut(&Self, &Arc<CurvePart>, &Arc<CurvePart>) -> bool,
    ) -> Result<(), GeomError> {
        let mut todo = pairs;
        let cost = self.first.degree() + self.second.degree() + 2;
        while work::goes_on(1)
            && let Some((a, b)) = todo.pop()
        {
            let Some(left) = self.left.checked_sub(cost) else { return Err(self.tangled()) };
            self.left = left;
            if self.is_settled(&a, &b) || is_passed_over(self, &a, &b) {
                continue;
            }
            let halve_first = b.bounds.diagonal() <= a.bounds.diagonal();
            let (whole, other) = if halve_first { (&a, &b) } else { (&b, &a) };
            for half in whole.halves() {
                if half.may_meet(other, self.tolerance) {
                    let (half, other) = (Arc::new(half), Arc::clone(other));
                    todo.push(if halve_first { (half, other) } else { (other, half) });
                }
            }
        }
        Ok(())
    }

    /// Whether a pair needs no further halving; what it came to is noted.
    fn is_settled(&mut self, a: &CurvePart, b: &CurvePart) -> bool {
        if self.is_joint(a, b) {
            return true;
        }
        if a.cone().crosses_clearly(b.cone())
            && !self.are_neighbours(a, b)
            && let Some(start) = near_crossing(a, b)
            && let Some(meeting) = self.crossing([a.interval, b.interval], start)
        {
            self.meetings.push(ReportedIntersection::crossing(meeting));
            return true;
        }
        if let Some(meeting) = self.end_joint(a, b) {
            self.meetings.push(ReportedIntersection::crossing(meeting));
            return true;
        }
        if self.is_tiny(a) && self.is_tiny(b) {
            let place = homogeneous::project(a.points[0]);
            if nearest_on(self.second, b.interval, place) <= self.tolerance {
                self.contacts.push(ContactInterval { first: a.interval, second: b.interval });
            }
            return true;
        }
        if self.lies_along(a, b) {
            self.contacts.push(ContactInterval { first: a.interval, second: b.interval });
            return true;
        }
        false
    }

    /// Whether both are one curve's neighbours and together turn by less than half a turn, so that
    /// they share their joint and nothing else.
    fn is_joint(&self, a: &CurvePart, b: &CurvePart) -> bool {
        self.are_neighbours(a, b)
            && (a.cone().with(b.cone()).is_within_half_turn() || self.is_tiny(a) && self.is_tiny(b))
    }

    /// Whether both follow one another along one curve, over its seam too.
    fn are_neighbours(&self, a: &CurvePart, b: &CurvePart) -> bool {
        let domain = self.first.domain();
        let near = KNOT_RELATIVE * domain.length();
        let touches = |end: f64, start: f64| (end - start).abs() <= near;
        let over_seam = touches(a.interval.start(), domain.start())
            && touches(b.interval.end(), domain.end())
            && self.first.is_closed(self.tolerance);
        self.is_same && (touches(a.interval.end(), b.interval.start()) || over_seam)
    }

    fn is_tiny(&self, part: &CurvePart) -> bool {
        part.bounds.diagonal() <= self.tolerance
    }

    /// The one place where two pieces that cross clearly come nearest, if they meet there; it is looked
    /// for from a start.
    fn crossing(
        &self,
        [first, second]: [Interval; 2],
        start: [f64; 2],
    ) -> Option<CurveIntersection> {
        let limits = [beside(self.first, first), beside(self.second, second)];
        let is_still = |last: [f64; 2], next: [f64; 2]| {
            (0..2).all(|i| (next[i] - last[i]).abs() <= LAST_BIT * next[i].abs())
        };
        let found = within_limits(limits, start, NEWTON_STEPS, is_still, |[t, s]| {
            let (p, q) = (self.first.velocity_at(t), self.second.velocity_at(s));
            NewtonStep::perhaps(nearest_step(p[0] - q[0], p[1], q[1]))
        });
        let [t, s] = found.unless_stuck()?;
        let t = self.first.domain().without_dust(t);
        let s = self.second.domain().without_dust(s);
        let is_inside = |interval: Interval, t: f64| {
            let slack = KNOT_RELATIVE.sqrt() * interval.length();
            interval.start() - slack <= t && t <= interval.end() + slack
        };
        (is_inside(first, t) && is_inside(second, s)).then(|| self.meeting(t, s))?
    }

    /// The meeting at these parameters, if the points are within the tolerance, or as near as the last bits of
    /// the parameters let them come.
    fn meeting(&self, first: f64, second: f64) -> Option<CurveIntersection> {
        let (p, q) = (self.first.point_at(first), self.second.point_at(second));
        let apart = p.distance(q);
        let is_met = apart <= self.tolerance || {
            let step =
                |curve: &NurbsCurve, t: f64| norm(curve.velocity_at(t)[1]) * LAST_BIT * t.abs();
            apart <= self.tolerance + step(self.first, first) + step(self.second, second)
        };
        is_met.then(|| CurveIntersection { first, second, point: p.midpoint(q) })
    }

    /// Whether the tolerance does not tell either piece from its chord.
    fn are_straight(&self, a: &CurvePart, b: &CurvePart) -> bool {
        a.deviation_from_chord().max(b.deviation_from_chord()) <= self.tolerance
    }

    /// Whether all of the shorter piece that can be told lies within the tolerance of the other:
    /// they touch, or run together.
    fn lies_along(&self, a: &CurvePart, b: &CurvePart) -> bool {
        let (short, other, curve) = if a.bounds.diagonal() <= b.bounds.diagonal() {
            (a, b, self.second)
        } else {
            (b, a, self.first)
        };
        if !self.are_straight(a, b) {
            return false;
        }
        let ends =
            [short.points[0], short.points[short.points.len() - 1]].map(homogeneous::project);
        let places = [ends[0], ends[0].midpoint(ends[1]), ends[1]];
        // What is outside of its box is none of its places.
        places.iter().all(|&place| other.bounds.contains(place, self.tolerance))
            && places.into_iter().all(|place| comes_near(curve, other, place, self.tolerance))
    }
}

/// Pairs of pieces whose boxes are within the tolerance of one another, in order. Found along the
/// axis on which the pieces spread most, so that not all pairs are looked at.
fn near_pairs(pieces: &[Arc<CurvePart>], tolerance: f64) -> Vec<(usize, usize)> {
    let axis = longest_axis(pieces);
    let order = by_start(pieces, axis);
    let mut pairs = Vec::new();
    for (place, &i) in order.iter().enumerate() {
        let end = pieces[i].bounds.max[axis] + tolerance;
        let beside = order[place + 1..].iter().take_while(|&&j| pieces[j].bounds.min[axis] <= end);
        let near =
            beside.filter(|&&j| work::goes_on(1) && pieces[i].may_meet(&pieces[j], tolerance));
        pairs.extend(near.map(|&j| (i.min(j), i.max(j))));
    }
    pairs.sort_unstable();
    pairs
}

/// The axis on which the pieces spread most.
fn longest_axis(pieces: &[Arc<CurvePart>]) -> usize {
    let whole = pieces.iter().map(|piece| piece.bounds).reduce(Bounds::union);
    whole.map_or(0, |whole| (whole.max - whole.min).max_position())
}

/// The pieces in the order in which they start along an axis.
fn by_start(pieces: &[Arc<CurvePart>], axis: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..pieces.len()).collect();
    sort_by(&mut order, |&i, &j| pieces[i].bounds.min[axis].total_cmp(&pieces[j].bounds.min[axis]));
    order
}
