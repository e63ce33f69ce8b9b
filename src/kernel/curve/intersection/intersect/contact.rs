//! Stretches on which two curves are within the tolerance: touches of any order, or stretches that
//! the curves share.
//!
//! A touch is where the distance rises from one floor to the tolerance, over a way as long as the
//! floor; or where it rises within two pieces, since polynomials that share an arc share it as far
//! as one of them goes. Nothing is read off parameters, so that another parametrization, place or
//! size makes no difference.

use std::f64::consts::GOLDEN_RATIO;

use super::{
    meeting::{ContactInterval, CurveIntersection, IntersectionSearch, ReportedIntersection},
    newton::{foot, inside, place},
};
use crate::{
    GeomError, IntersectionError, Interval,
    ceiling::BISECTIONS,
    curve::NurbsCurve,
    numeric::bisection::bisected,
    tolerance::{KNOT_RELATIVE, LAST_BIT},
    valley::{Valley, round},
};

/// Places of a stretch, besides its ends, that tell how far it goes.
const EXTENT_SAMPLES: usize = 8;

/// Places that tell how far beyond a stretch two curves run together.
const REACH_SAMPLES: usize = 32;

/// Contacts this many tolerances apart are one: what is between them was too short to be told.
const ONE_CONTACT: f64 = 4.0;

/// A touch leaves its neighbourhood where the curves are this share of the tolerance apart.
const APART_SHARE: f64 = 0.5;

/// A floor longer than this share of the stretch is shared, as far as the distance tells.
const FLOOR_SHARE: f64 = 0.5;

/// Roundings within which a tolerance is too small to tell a floor from its sides.
const FEW_ROUNDINGS: f64 = 1e4;

impl IntersectionSearch<'_> {
    /// Whether a curve is at one place all along an interval.
    pub(super) fn is_one_place(&self, curve: &NurbsCurve, interval: Interval) -> bool {
        self.extent(curve, interval) <= ONE_CONTACT * self.tolerance
    }

    /// How far a stretch of a curve goes from its start.
    pub(super) fn extent(&self, curve: &NurbsCurve, interval: Interval) -> f64 {
        let start = place(curve, interval.start());
        let away = |t: f64| place(curve, t).distance(start);
        // The ends of a closed curve are one place.
        uneven(interval, EXTENT_SAMPLES).map(away).fold(0.0, f64::max)
    }

    /// How the distance runs along a stretch.
    fn valley(&self, stretch: ContactInterval) -> Valley {
        let apart = |t: f64| {
            let p = place(self.first, t);
            place(self.second, foot(self.second, stretch.second, p)).distance(p)
        };
        Valley::of(apart, stretch.first, self.rounding)
    }

    /// Whether the curves are one place only at a stretch.
    fn is_touch(&self, stretch: ContactInterval, valley: &Valley) -> bool {
        let extent = self.extent(self.first, stretch.first);
        if extent <= ONE_CONTACT * self.tolerance {
            return true;
        }
        let is_short = extent <= self.longest_touch;
        if is_short && self.tolerance <= FEW_ROUNDINGS * self.rounding {
            return true;
        }
        let floor = self.extent(self.first, valley.floor);
        let is_narrow = floor <= FLOOR_SHARE * extent;
        let over_end = if is_short { self.leaves_over_end(stretch, valley) } else { [false; 2] };
        let rises = valley.rises_to(APART_SHARE * self.tolerance, over_end);
        let is_single = valley.is_single && rises && (is_narrow || self.ends_within(stretch));
        is_single || is_short && is_narrow && (rises || !valley.is_single)
    }

    /// At which ends of a stretch the first curve goes beyond the end of the second one at which they are nearest: a
    /// curve that ends on another does so at once.
    fn leaves_over_end(&self, stretch: ContactInterval, valley: &Valley) -> [bool; 2] {
        let domain = self.second.domain();
        let dust = KNOT_RELATIVE * domain.length();
        let end_at = |t: f64| {
            let foot = foot(self.second, stretch.second, place(self.first, t));
            let ends = [foot <= domain.start() + dust, domain.end() - dust <= foot];
            ends.contains(&true).then_some(ends)
        };
        let nearest = end_at(valley.bottom).filter(|_| !self.second.is_closed(self.tolerance));
        let ends = [stretch.first.start(), stretch.first.end()];
        ends.map(|t| nearest.is_some() && end_at(t) == nearest)
    }

    /// Whether a stretch of one piece of each curve ends where both pieces go on.
    fn ends_within(&self, stretch: ContactInterval) -> bool {
        let sides = |curve: &NurbsCurve, interval: Interval| {
            let span = curve.knots().span_interval(curve.knots().span_at(interval.at(0.5)));
            let before = Interval::new(span.start(), interval.start());
            let behind = Interval::new(interval.end(), span.end());
            [before, behind].map(|rest| rest.is_ok_and(|rest| !self.is_one_place(curve, rest)))
        };
        let first = sides(self.first, stretch.first);
        let second = sides(self.second, stretch.second);
        // The other curve may run against this one.
        first == [true, true] && second == [true, true]
    }

    /// What a stretch comes to: the place where the curves touch, if they do so within the
    /// tolerance.
    ///
    /// # Errors
    /// [`IntersectionError::RunTogether`], [`IntersectionError::RunsAlongItself`].
    pub(super) fn settled(
        &self,
        stretch: ContactInterval,
    ) -> Result<Option<ReportedIntersection>, GeomError> {
        let valley = self.valley(stretch);
        if !self.is_touch(stretch, &valley) {
            return Err(self.run_together(stretch));
        }
        if self.is_fold(stretch) {
            return Ok(None);
        }
        let both = [stretch.first, stretch.second];
        let crossing = self.crossing(both, both.map(|interval| interval.at(0.5)));
        let second = foot(self.second, stretch.second, place(self.first, valley.bottom));
        let dust = LAST_BIT * self.second.domain().length();
        let (first, second) = (inside(self.first, valley.bottom), inside(self.second, second));
        let touch = self.meeting(first, round(second, dust));
        // A crossing is known to the last bit, a touch is not.
        let apart = |meeting: &CurveIntersection| {
            let ends = [self.first.point_at(meeting.first), self.second.point_at(meeting.second)];
            ends[0].distance(ends[1])
        };
        let is_better = |crossing: &CurveIntersection| {
            valley.floor.contains(crossing.first) == touch.is_none()
                || touch.is_some_and(|touch| apart(crossing) + self.rounding < apart(&touch))
        };
        let meeting = crossing.filter(is_better).or(touch);
        Ok(meeting.map(|meeting| ReportedIntersection { meeting, stretch: Some(stretch) }))
    }

    /// Whether a curve comes to itself by turning back between both sides.
    fn is_fold(&self, stretch: ContactInterval) -> bool {
        let gap = Interval::new(stretch.first.end(), stretch.second.start());
        self.is_same && gap.map_or(true, |gap| self.is_one_place(self.first, gap))
    }

    /// That there is too much to be told; of a stretch that goes on and on, that it does.
    pub(super) fn tangled(&self) -> GeomError {
        let contacts = self.joined_contacts();
        let together = contacts.into_iter().find_map(|stretch| self.settled(stretch).err());
        together.unwrap_or(GeomError::Intersection(IntersectionError::Tangled))
    }

    /// That the curves run together about a stretch, and from where to where they do.
    pub(super) fn run_together(&self, stretch: ContactInterval) -> GeomError {
        let domain = self.first.domain();
        let is_on = |t: f64| {
            let p = place(self.first, t);
            self.second.closest(p, self.tolerance).distance <= self.tolerance
        };
        // A curve lies on itself everywhere; only others are followed.
        let reach = |from: f64, end: f64| {
            let at = |i: usize| from + (end - from) * i as f64 / REACH_SAMPLES as f64;
            let Some(off) = (1..=REACH_SAMPLES).find(|&i| !is_on(at(i))) else { return end };
            bisected([at(off - 1), at(off)], BISECTIONS, is_on)[0]
        };
        let (start, end) = (stretch.first.start(), stretch.first.end());
        if self.is_same {
            let [start, end] = [start, end].map(|t| inside(self.first, t));
            return GeomError::Intersection(IntersectionError::RunsAlongItself { start, end });
        }
        // The ends of the stretch need not be on both curves, something within it is.
        let steps = stretch.first.steps(REACH_SAMPLES);
        let on = || steps.iter().copied().filter(|&t| is_on(t));
        let before = reach(on().next().unwrap_or(start), domain.start().min(start));
        let behind = reach(on().next_back().unwrap_or(end), domain.end().max(end));
        let is_over_seam = behind > domain.end() || before < domain.start();
        let [start, end] = match is_over_seam && behind - before < domain.length() {
            true => [before, behind].map(|t| inside(self.first, t)),
            false => [before.max(domain.start()), behind.min(domain.end())],
        };
        GeomError::Intersection(IntersectionError::RunTogether { start, end })
    }
}

/// The ends of an interval and places in it at uneven distances: at even ones a curve that comes back again and
/// again may always be at the same place.
pub(super) fn uneven(interval: Interval, n: usize) -> impl Iterator<Item = f64> {
    let inside = (1..n).map(move |i| interval.at((i as f64 * GOLDEN_RATIO).fract()));
    [interval.start(), interval.end()].into_iter().chain(inside)
}
