//! Pieces of curves that run side by side and of which neither ends where the other does.
//!
//! Halving such pairs down to the tolerance takes most of the time that long stretches take. Where both pieces are straight
//! within the tolerance, what they have in common is told by the feet of their ends. Pieces that come to one another in a
//! corner alone tell nothing where their neighbours are known to lie along one another up to there.

use super::{
    meeting::{ContactInterval, IntersectionSearch},
    newton::{nearest_on, nearest_parameter},
};
use crate::{
    Interval,
    curve::{NurbsCurve, representation::part::CurvePart},
    homogeneous,
    sorting::sort_by,
};

/// So many pairs and fewer are halved: a touch comes to no more.
pub(super) const FEW: usize = 64;

/// Pieces of fewer tolerances are halved at once: what crosses them may turn within them.
const SHORTEST: f64 = 64.0;

/// Contacts about a piece that are looked at: a curve runs past a place but a few times.
const N_LOOKS: usize = 8;

impl IntersectionSearch<'_> {
    /// Whether what two pieces have in common may be looked at when all contacts of other pieces are known.
    pub(super) fn may_be_corner(&self, a: &CurvePart, b: &CurvePart) -> bool {
        let shortest = a.bounds.diagonal().min(b.bounds.diagonal());
        SHORTEST * self.tolerance < shortest && self.are_straight(a, b)
    }

    /// What two straight pieces have in common, of which each reaches beyond an end of the other; none where that is no
    /// longer than a place.
    pub(super) fn overlap(&self, a: &CurvePart, b: &CurvePart) -> Option<ContactInterval> {
        let feet = |[of, part]: [&CurvePart; 2], curve: &NurbsCurve| {
            let ends = [of.points[0], of.points[of.points.len() - 1]].map(homogeneous::project);
            let interval = part.interval;
            let [s, t] = ends.map(|end| nearest_parameter(curve, interval, end, interval.at(0.5)));
            Interval::new(s.min(t), s.max(t)).ok()
        };
        let contact = ContactInterval {
            first: feet([b, a], self.first)?,
            second: feet([a, b], self.second)?,
        };
        let is_long = !self.is_one_place(self.first, contact.first)
            && !self.is_one_place(self.second, contact.second);
        let is_along = |t: f64| {
            nearest_on(self.second, contact.second, self.first.point_at(t)) <= self.tolerance
        };
        let places = [0.0, 0.5, 1.0].map(|share| contact.first.at(share));
        (is_long && places.into_iter().all(is_along)).then_some(contact)
    }
}

/// Contacts in the order of either curve.
pub(super) struct KnownContacts {
    by_first: Vec<ContactInterval>,
    by_second: Vec<ContactInterval>,
}

impl KnownContacts {
    pub(super) fn of(contacts: &[ContactInterval]) -> Self {
        let mut by_first = contacts.to_vec();
        let mut by_second = contacts.to_vec();
        sort_by(&mut by_first, |a, b| a.first.start().total_cmp(&b.first.start()));
        sort_by(&mut by_second, |a, b| a.second.start().total_cmp(&b.second.start()));
        Self { by_first, by_second }
    }

    /// Whether an interval of the first curve is in one contact and one of the second curve in another, and these are
    /// neighbours on both curves: all that the intervals share belongs to the stretch that they make.
    pub(super) fn hold(&self, first: Interval, second: Interval) -> bool {
        let holding = |contacts: &'_ [ContactInterval], of: Side, interval: Interval| {
            let behind = contacts.partition_point(|known| of(known).start() <= interval.start());
            let near = contacts[behind.saturating_sub(N_LOOKS)..behind].to_vec();
            near.into_iter().filter(move |known| interval.end() <= of(known).end())
        };
        let others: Vec<ContactInterval> =
            holding(&self.by_second, |known| known.second, second).collect();
        let are_beside = |a: Interval, b: Interval| a.start() <= b.end() && b.start() <= a.end();
        holding(&self.by_first, |known| known.first, first).any(|one| {
            let is_beside = |other: &ContactInterval| {
                are_beside(one.first, other.first) && are_beside(one.second, other.second)
            };
            others.iter().any(is_beside)
        })
    }
}

/// The interval of a contact on one of the curves.
type Side = fn(&ContactInterval) -> Interval;

#[cfg(test)]
mod tests {
    use super::*;

    fn interval([start, end]: [f64; 2]) -> Interval {
        Interval::new(start, end).expect("an interval")
    }

    /// Whether contacts of which two are neighbours, and a third is far from both, hold two intervals.
    #[track_caller]
    fn check(first: [f64; 2], second: [f64; 2], expected: bool) {
        let contact =
            |first, second| ContactInterval { first: interval(first), second: interval(second) };
        let known = KnownContacts::of(&[
            contact([10.0, 12.0], [20.0, 22.0]),
            contact([2.0, 4.0], [7.0, 9.0]),
            contact([0.0, 2.0], [5.0, 7.0]),
        ]);
        assert_eq!(known.hold(interval(first), interval(second)), expected);
    }

    #[test]
    fn pieces_in_neighbouring_contacts_are_held() {
        check([1.5, 2.0], [7.0, 7.5], true);
        check([2.0, 2.5], [6.5, 7.0], true);
        check([0.5, 1.0], [5.5, 6.0], true);
        check([0.0, 2.0], [7.0, 9.0], true);
        check([10.0, 12.0], [20.0, 22.0], true);
    }

    #[test]
    fn pieces_beyond_contacts_or_in_ones_that_are_apart_are_not() {
        check([1.5, 2.5], [6.0, 6.5], false);
        check([1.0, 1.5], [6.5, 7.5], false);
        check([0.5, 1.0], [20.5, 21.0], false);
        check([10.5, 11.0], [7.5, 8.0], false);
        check([4.5, 5.0], [8.0, 8.5], false);
        check([3.0, 3.5], [3.0, 4.0], false);
        check([-1.0, -0.5], [5.5, 6.0], false);
    }
}
