//! Contacts that lie next to one another, put together.
//!
//! Halving comes down to many short contacts. A sweep along the first curve keeps those that it has
//! not left behind in the order of the second curve, where what lies next to a contact is its
//! neighbour: time grows with their number, not with its square.

use std::collections::BTreeMap;

use super::meeting::{ContactInterval, IntersectionSearch};
use crate::{Interval, curve::NurbsCurve, sorting::sort_by, work};

/// Contacts that the sweep has not left behind, by their place in the order of the second curve.
type OpenContacts = BTreeMap<usize, ContactInterval>;

impl IntersectionSearch<'_> {
    /// The contacts, those as one that lie next to one another on both curves, over the seams too.
    pub(super) fn joined_contacts(&self) -> Vec<ContactInterval> {
        let mut contacts = self.contacts.clone();
        sort_by(&mut contacts, |a, b| a.second.start().total_cmp(&b.second.start()));
        let mut ranked: Vec<(usize, ContactInterval)> = contacts.into_iter().enumerate().collect();
        sort_by(&mut ranked, |(_, a), (_, b)| a.first.start().total_cmp(&b.first.start()));
        let (mut open, mut joined) = (OpenContacts::new(), Vec::new());
        for (rank, contact) in ranked {
            if !work::goes_on(1) {
                break;
            }
            self.place_contact(rank, contact, &mut open, &mut joined);
        }
        joined.extend(open.into_values());
        self.joined_over_seams(joined)
    }

    /// Puts a contact among the open ones, as one with its neighbours that it reaches; those that
    /// the sweep has left behind are done.
    fn place_contact(
        &self,
        mut rank: usize,
        mut contact: ContactInterval,
        open: &mut OpenContacts,
        done: &mut Vec<ContactInterval>,
    ) {
        loop {
            let before = open.range(..rank).next_back();
            let behind = open.range(rank..).next();
            let step = [before, behind].into_iter().flatten().find_map(|(&other, &known)| {
                let is_left = self.is_apart(self.first, known.first, contact.first);
                let joined = self.hull(known, contact, [0.0; 2]);
                (is_left || joined.is_some()).then_some((other, known, joined))
            });
            // What is joined may reach others that neither reached alone.
            let Some((other, known, joined)) = step else { break };
            open.remove(&other);
            match joined {
                Some(joined) => (rank, contact) = (rank.min(other), joined),
                None => done.push(known),
            }
        }
        open.insert(rank, contact);
    }

    /// Contacts of closed curves, those as one that lie on both sides of a seam.
    fn joined_over_seams(&self, contacts: Vec<ContactInterval>) -> Vec<ContactInterval> {
        let closed = [self.first, self.second].map(|curve| curve.is_closed(self.tolerance));
        let is_beside = |curve: &NurbsCurve, interval: Interval| {
            let domain = curve.domain();
            let rests = [
                Interval::new(domain.start(), interval.start()),
                Interval::new(interval.end(), domain.end()),
            ];
            rests.into_iter().any(|rest| rest.map_or(true, |rest| self.is_one_place(curve, rest)))
        };
        let at_seam = |contact: &ContactInterval| {
            closed[0] && is_beside(self.first, contact.first)
                || closed[1] && is_beside(self.second, contact.second)
        };
        let (beside, mut joined): (Vec<_>, Vec<_>) = contacts.into_iter().partition(at_seam);
        let mut seam: Vec<ContactInterval> = Vec::new();
        for mut contact in beside {
            while let Some((idx, both)) = seam.iter().enumerate().find_map(|(idx, &known)| {
                if !work::goes_on(1) {
                    return None;
                }
                Some((idx, self.hull_over_seams(known, contact, closed)?))
            }) {
                seam.swap_remove(idx);
                contact = both;
            }
            seam.push(contact);
        }
        joined.extend(seam);
        joined
    }

    /// Two contacts as one, where seams may lie between them.
    fn hull_over_seams(
        &self,
        a: ContactInterval,
        b: ContactInterval,
        closed: [bool; 2],
    ) -> Option<ContactInterval> {
        let turns = |is_closed: bool| if is_closed { &[0.0, -1.0, 1.0][..] } else { &[0.0] };
        turns(closed[0]).iter().find_map(|&first| {
            turns(closed[1]).iter().find_map(|&second| self.hull(a, b, [first, second]))
        })
    }

    /// Two contacts as one, if nothing is between them that can be told, the second of them so many
    /// periods further along each curve.
    fn hull(
        &self,
        a: ContactInterval,
        b: ContactInterval,
        turns: [f64; 2],
    ) -> Option<ContactInterval> {
        let joined = |curve: &NurbsCurve, a: Interval, b: Interval, turn: f64| {
            let period = curve.domain().length();
            let b = Interval::new(b.start() + turn * period, b.end() + turn * period).ok()?;
            let hull = Interval::new(a.start().min(b.start()), a.end().max(b.end())).ok()?;
            (hull.length() <= period && !self.is_apart(curve, a, b)).then_some(hull)
        };
        Some(ContactInterval {
            first: joined(self.first, a.first, b.first, turns[0])?,
            second: joined(self.second, a.second, b.second, turns[1])?,
        })
    }

    /// Whether something is between two intervals of a curve.
    fn is_apart(&self, curve: &NurbsCurve, a: Interval, b: Interval) -> bool {
        let gap = Interval::new(a.end().min(b.end()), a.start().max(b.start()));
        gap.is_ok_and(|gap| !self.is_one_place(curve, gap))
    }
}
