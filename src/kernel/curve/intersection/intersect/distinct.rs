//! Meetings in order, each once.

use std::collections::BTreeMap;

use super::{
    contact::uneven,
    meeting::{ContactInterval, CurveIntersection, IntersectionSearch, ReportedIntersection},
    newton::{foot, place},
};
use crate::{
    GeomError, Interval, curve::NurbsCurve, sorting::sort_by, tolerance::KNOT_RELATIVE, work,
};

/// Places of an arc, its ends among them, at which two curves are compared.
const ARC_CELLS: usize = 16;

/// Tolerances beyond the end of a stretch where a meeting may still be the same one: two curves that
/// cross clearly are as far apart as the tolerance after some ten of them, on either side.
const CELL_MARGIN: f64 = 64.0;

impl IntersectionSearch<'_> {
    /// The meetings in order.
    ///
    /// # Errors
    /// `IntersectionError::RunTogether`, `IntersectionError::RunsAlongItself`.
    pub(super) fn finish(mut self) -> Result<Vec<CurveIntersection>, GeomError> {
        for stretch in self.joined_contacts() {
            let told = self.settled(stretch)?;
            self.meetings.extend(told);
        }
        let mut meetings = std::mem::take(&mut self.meetings);
        for ReportedIntersection { meeting, stretch } in &mut meetings {
            // Of one curve the lesser parameter is the first one.
            if !self.is_same {
                meeting.first = self.at_seam(self.first, meeting.first);
            }
            meeting.second = self.at_seam(self.second, meeting.second);
            if self.is_same && meeting.second < meeting.first {
                *meeting =
                    CurveIntersection { first: meeting.second, second: meeting.first, ..*meeting };
                *stretch = stretch.map(ContactInterval::swapped);
            }
        }
        let order = |a: &CurveIntersection, b: &CurveIntersection| {
            a.first.total_cmp(&b.first).then(a.second.total_cmp(&b.second))
        };
        sort_by(&mut meetings, |a, b| order(&a.meeting, &b.meeting));
        let kept = self.each_once(meetings);
        let mut meetings: Vec<CurveIntersection> =
            kept.into_iter().map(|told| told.meeting).collect();
        sort_by(&mut meetings, order);
        Ok(meetings)
    }

    /// Of meetings that are one, the one where the curves are nearest. A meeting is compared with
    /// those in the cells around its own alone: what is one lies on one stretch, or beside it.
    fn each_once(&self, meetings: Vec<ReportedIntersection>) -> Vec<ReportedIntersection> {
        let reach = |told: &ReportedIntersection| {
            told.stretch.map_or(0.0, |stretch| self.extent(self.first, stretch.first))
        };
        let width = 2.0 * meetings.iter().map(reach).fold(CELL_MARGIN * self.tolerance, f64::max);
        let cell = |told: &ReportedIntersection| {
            (told.meeting.point / width).to_array().map(|x| x.floor() as i64)
        };
        let mut kept: Vec<ReportedIntersection> = Vec::new();
        let mut by_cell: BTreeMap<[i64; 3], Vec<usize>> = BTreeMap::new();
        for told in meetings {
            let own = cell(&told);
            let near = around(own).filter_map(|cell| by_cell.get(&cell)).flatten().copied();
            let is_known = |&idx: &usize| work::goes_on(1) && self.are_one(&kept[idx], &told);
            match near.filter(is_known).min() {
                Some(known) if self.is_nearer(&told, &kept[known]) => {
                    if own != cell(&kept[known]) {
                        by_cell.entry(own).or_default().push(known);
                    }
                    kept[known] = told;
                }
                Some(_) => {}
                None => {
                    by_cell.entry(own).or_default().push(kept.len());
                    kept.push(told);
                }
            }
        }
        kept
    }

    /// A parameter; at the seam of a closed curve that of its start.
    fn at_seam(&self, curve: &NurbsCurve, t: f64) -> f64 {
        let domain = curve.domain();
        let is_near = domain.end() - t <= KNOT_RELATIVE.sqrt() * domain.length()
            && curve.point_at(t).distance(curve.start()) <= self.tolerance
            && curve.is_closed(self.tolerance);
        if is_near { domain.start() } else { t }
    }

    /// Whether two meetings are one: between them both curves stay at one place, or the one lies on
    /// the stretch of the other.
    fn are_one(&self, a: &ReportedIntersection, b: &ReportedIntersection) -> bool {
        let is_on = |told: &ReportedIntersection, other: &ReportedIntersection| {
            other.stretch.is_some_and(|ContactInterval { first, second }| {
                self.contains(self.first, first, told.meeting.first)
                    && self.contains(self.second, second, told.meeting.second)
            })
        };
        is_on(a, b)
            || is_on(b, a)
            || (a.stretch.is_some() || b.stretch.is_some())
                && self.stay_together(&a.meeting, &b.meeting)
            || a.meeting.point.distance(b.meeting.point) <= 2.0 * self.tolerance
                && self.are_beside(self.first, a.meeting.first, b.meeting.first)
                && self.are_beside(self.second, a.meeting.second, b.meeting.second)
    }

    /// Whether between two meetings both curves stay within the tolerance of one another, over the seams too:
    /// one that comes through the place again and again goes away between.
    fn stay_together(&self, a: &CurveIntersection, b: &CurveIntersection) -> bool {
        let arcs = |curve: &NurbsCurve, a: f64, b: f64| {
            let (low, high) = (a.min(b), a.max(b));
            let over_seam = curve
                .is_closed(self.tolerance)
                .then(|| Interval::new(high, low + curve.domain().length()).ok());
            Interval::new(low, high).ok().into_iter().chain(over_seam.flatten())
        };
        let others: Vec<Interval> = arcs(self.second, a.second, b.second).collect();
        let is_along = |curve: &NurbsCurve, arc: Interval, along: &NurbsCurve, other: Interval| {
            uneven(arc, ARC_CELLS).all(|t| {
                let p = place(curve, t);
                place(along, foot(along, other, p)).distance(p) <= self.tolerance
            })
        };
        arcs(self.first, a.first, b.first).any(|arc| {
            others.iter().any(|&other| {
                is_along(self.first, arc, self.second, other)
                    && is_along(self.second, other, self.first, arc)
            })
        })
    }

    /// Whether an interval, which may go over the seam, holds a parameter or its neighbourhood.
    fn contains(&self, curve: &NurbsCurve, interval: Interval, t: f64) -> bool {
        let period = curve.domain().length();
        let is_beside = |t: f64| {
            let gap = Interval::new(t, interval.start()).or(Interval::new(interval.end(), t));
            gap.map_or(interval.contains(t), |gap| self.is_one_place(curve, gap))
        };
        let turns = [t, t + period, t - period];
        let n = if curve.is_closed(self.tolerance) { turns.len() } else { 1 };
        turns[..n].iter().any(|&t| is_beside(t))
    }

    /// Whether a curve stays at one place between two parameters, over its seam too.
    fn are_beside(&self, curve: &NurbsCurve, a: f64, b: f64) -> bool {
        let (low, high) = (a.min(b), a.max(b));
        let period = curve.domain().length();
        let is_short = |start: f64, end: f64| {
            Interval::new(start, end).map_or(true, |arc| self.is_one_place(curve, arc))
        };
        is_short(low, high) || curve.is_closed(self.tolerance) && is_short(high, low + period)
    }

    /// Whether the curves are nearer at one meeting than at another, by more than rounding; a
    /// crossing is known better than a touch.
    fn is_nearer(&self, told: &ReportedIntersection, known: &ReportedIntersection) -> bool {
        let apart = |told: &ReportedIntersection| {
            let CurveIntersection { first, second, .. } = told.meeting;
            place(self.first, first).distance(place(self.second, second))
        };
        apart(told) + self.rounding < apart(known)
    }
}

/// A cell and those that have a corner in common with it.
fn around(cell: [i64; 3]) -> impl Iterator<Item = [i64; 3]> {
    (0..27).map(move |k| {
        let steps = [k % 3, k / 3 % 3, k / 9].map(|step| step - 1);
        [0, 1, 2].map(|axis| cell[axis].saturating_add(steps[axis]))
    })
}
