//! Stretches on which two curves are within the tolerance: short ones are touches, on long ones they
//! run together.

use super::{MAX_BISECTIONS, Search};
use crate::kernel::{GeomError, Interval};

/// Places of a stretch, besides its ends, that tell how far it goes.
const EXTENT_SAMPLES: usize = 8;

/// Places that tell how far beyond a stretch two curves run together.
const REACH_SAMPLES: usize = 32;

/// A stretch on which two curves are within the tolerance, by the parameters of both.
#[derive(Clone, Copy)]
pub(super) struct Contact {
    pub(super) first: Interval,
    pub(super) second: Interval,
}

impl Search<'_> {
    /// Notes a contact, as one with those that lie next to it on both curves.
    pub(super) fn touches(&mut self, mut contact: Contact) {
        // What is joined may reach others that neither reached alone.
        while let Some(idx) = self.contacts.iter().position(|other| {
            are_near(other.first, contact.first) && are_near(other.second, contact.second)
        }) {
            let other = self.contacts.swap_remove(idx);
            contact.first = hull(other.first, contact.first);
            contact.second = hull(other.second, contact.second);
        }
        self.contacts.push(contact);
    }

    /// Whether a stretch is longer than a touch may be.
    pub(super) fn is_long(&self, stretch: &Contact) -> bool {
        let start = self.first.point_at(stretch.first.start());
        let away = |t: f64| self.first.point_at(t).distance(start);
        // The ends of a closed curve are one place.
        let extent = stretch.first.steps(EXTENT_SAMPLES).into_iter().map(away).fold(0.0, f64::max);
        self.longest_touch < extent
    }

    /// That the curves run together about a stretch, and from where to where they do.
    pub(super) fn run_together(&self, stretch: &Contact) -> GeomError {
        let domain = self.first.domain();
        let is_on = |t: f64| {
            let place = self.first.point_at(t);
            self.second.closest(place, self.tolerance).distance <= self.tolerance
        };
        // A curve lies on itself everywhere; only others are followed.
        let reach = |from: f64, end: f64| {
            let at = |i: usize| from + (end - from) * i as f64 / REACH_SAMPLES as f64;
            let Some(off) = (1..=REACH_SAMPLES).find(|&i| !is_on(at(i))) else { return end };
            let (mut on, mut off) = (at(off - 1), at(off));
            for _ in 0..MAX_BISECTIONS {
                let middle = 0.5 * (on + off);
                if is_on(middle) { on = middle } else { off = middle }
            }
            on
        };
        let (start, end) = (stretch.first.start(), stretch.first.end());
        match self.is_same {
            true => GeomError::RunsAlongItself { start, end },
            false => {
                // The ends of the stretch need not be on both curves, something within it is.
                let steps = stretch.first.steps(REACH_SAMPLES);
                let on = || steps.iter().copied().filter(|&t| is_on(t));
                GeomError::RunTogether {
                    start: reach(on().next().unwrap_or(start), domain.start()),
                    end: reach(on().next_back().unwrap_or(end), domain.end()),
                }
            }
        }
    }
}

/// Whether the gap between two intervals is not wider than they are.
fn are_near(a: Interval, b: Interval) -> bool {
    let gap = (a.start() - b.end()).max(b.start() - a.end());
    gap <= a.length() + b.length()
}

fn hull(a: Interval, b: Interval) -> Interval {
    Interval::new(a.start().min(b.start()), a.end().max(b.end())).unwrap_or(a)
}
