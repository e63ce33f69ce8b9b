//! Loops of edges, each with the region to its left.

use std::f64::consts::TAU;

use glam::DVec3;

use super::{
    Arrangement, EdgeSide, PlaneEdge,
    around::{RaySearch, Windings},
};
use crate::{
    GeomError, Interval, NurbsCurve, RegionError,
    ceiling::BISECTIONS,
    curve::join_chain,
    frame::norm,
    numeric::bisection::bisected,
    side_by_side,
    sorting::sort_by,
    tolerance::{EXACT_RELATIVE, PARAMETER_RELATIVE},
};

/// Edges for which a further thread pays.
const WORTH_A_THREAD: usize = 500;

/// Places of an edge that tell where it leaves a circle.
const LEAVING_STEPS: usize = 32;

/// The share of the way that the nearest edge goes at which edges about a vertex are put in order.
const CIRCLE_SHARE: f64 = 0.5;

/// A part of an edge's course: which, and whether along it.
pub(crate) type OrientedEdge = (usize, bool);

impl Arrangement {
    /// The loops around where `is_inside` holds of the windings; each by its arcs.
    ///
    /// # Errors
    /// [`RegionError::Unclear`] where arcs come too near one another to be told apart.
    pub(crate) fn loops(
        &self,
        is_inside: impl Fn(&Windings) -> bool + Sync,
        n_threads: usize,
    ) -> Result<Vec<Vec<NurbsCurve>>, GeomError> {
        let search = RaySearch::new(self);
        let numbers: Vec<usize> = (0..self.edges.len()).collect();
        let n_threads = n_threads.min(numbers.len() / WORTH_A_THREAD + 1);
        let sides = side_by_side::map(&numbers, n_threads, |&number| {
            GeomError::go_on(1)?;
            let around = search.around(number).ok_or_else(|| self.unclear(number))?;
            let [left, right] = around.map(|windings| is_inside(&windings));
            Ok::<_, GeomError>(match (left, right) {
                (true, false) => Some(EdgeSide::Left),
                (false, true) => Some(EdgeSide::Right),
                _ => None,
            })
        });
        let sides = sides.into_iter().collect::<Result<Vec<_>, _>>()?;
        self.loops_of(&sides)
    }

    /// The loops of edges with what is inside on the side that each tells; by their arcs.
    ///
    /// # Errors
    /// [`RegionError::Unclear`] where they do not close.
    pub(crate) fn loops_of(
        &self,
        sides: &[Option<EdgeSide>],
    ) -> Result<Vec<Vec<NurbsCurve>>, GeomError> {
        let mut exits: Vec<Vec<OrientedEdge>> = vec![Vec::new(); self.vertices.len()];
        let mut balance = vec![0_i64; self.vertices.len()];
        for (number, side) in sides.iter().enumerate() {
            let Some(side) = side else { continue };
            let step = (number, *side == EdgeSide::Left);
            let [from, to] = self.ends_of(step);
            exits[from].push(step);
            balance[from] += 1;
            balance[to] -= 1;
        }
        if let Some(vertex) = balance.iter().position(|&balance| balance != 0) {
            return Err(RegionError::Unclear { point: self.vertices[vertex] }.into());
        }
        let mut loops = Vec::new();
        let mut left_by = vec![None; exits.len()];
        for vertex in 0..exits.len() {
            while let Some(step) = exits[vertex].pop() {
                loops.extend(self.walk(step, &mut exits, &mut left_by)?);
            }
        }
        loops.iter().map(|steps| self.arcs_of(steps, |_| false)).collect()
    }

    /// The vertices where a step starts and ends.
    pub(crate) fn ends_of(&self, (edge, is_along): OrientedEdge) -> [usize; 2] {
        let [start, end] = self.edges[edge].ends;
        if is_along { [start, end] } else { [end, start] }
    }

    fn unclear(&self, edge: usize) -> GeomError {
        let edge = &self.edges[edge];
        RegionError::Unclear { point: edge.curve.point_at(edge.curve.domain().at(0.5)) }.into()
    }

    /// The loops on the way from a step until all of it is closed; what comes back to a vertex before
    /// is a loop of its own. `left_by` has the place on the way of the step from each vertex.
    pub(super) fn walk(
        &self,
        first: OrientedEdge,
        exits: &mut [Vec<OrientedEdge>],
        left_by: &mut [Option<usize>],
    ) -> Result<Vec<Vec<OrientedEdge>>, GeomError> {
        let (mut way, mut loops) = (vec![first], Vec::new());
        while let Some(&last) = way.last() {
            GeomError::go_on(1)?;
            let [from, at] = self.ends_of(last);
            left_by[from] = Some(way.len() - 1);
            if let Some(start) = left_by[at] {
                let steps = way.split_off(start);
                steps.iter().for_each(|&step| left_by[self.ends_of(step)[0]] = None);
                loops.push(steps);
                continue;
            }
            let place = match exits[at].len() {
                0 => return Err(RegionError::Unclear { point: self.vertices[at] }.into()),
                1 => 0,
                _ => self.next_clockwise(at, last, &exits[at])?,
            };
            way.push(exits[at].remove(place));
        }
        Ok(loops)
    }

    /// Of the exits the first in the sense of a clock behind where a step comes in, other than back.
    fn next_clockwise(
        &self,
        at: usize,
        last: OrientedEdge,
        exits: &[OrientedEdge],
    ) -> Result<usize, GeomError> {
        let center = self.vertices[at];
        let reach = |&(edge, is_along): &OrientedEdge| {
            let curve = &self.edges[edge].curve;
            let steps = curve.domain().steps(LEAVING_STEPS).into_iter();
            let reach = steps.map(|t| norm(curve.point_at(t) - center)).fold(0.0, f64::max);
            (reach, is_along)
        };
        let back = (last.0, !last.1);
        let radius = exits.iter().chain([&back]).map(|step| reach(step).0);
        let radius = CIRCLE_SHARE * radius.fold(f64::INFINITY, f64::min);
        let angle = |&(edge, is_along): &OrientedEdge| {
            let leaves = leaving(&self.edges[edge], center, radius, is_along);
            libm::atan2(leaves.y - center.y, leaves.x - center.x)
        };
        let from = angle(&back);
        let onward = exits.iter().enumerate().filter(|(_, exit)| **exit != back);
        let turns = onward.map(|(i, exit)| (i, (from - angle(exit)).rem_euclid(TAU)));
        let mut turns: Vec<(usize, f64)> = turns.collect();
        sort_by(&mut turns, |a, b| a.1.total_cmp(&b.1));
        let is_near = |a: f64, b: f64| (b - a).abs() <= EXACT_RELATIVE;
        match turns[..] {
            [(only, _)] => Ok(only),
            [(first, turn), (_, next), ..] if !is_near(turn, next) && !is_near(turn, 0.0) => {
                Ok(first)
            }
            _ => Err(RegionError::Unclear { point: center }.into()),
        }
    }

    /// The arcs along a loop; those that follow one another on one given arc are one, unless they are cut at the
    /// vertex between them.
    pub(crate) fn arcs_of(
        &self,
        steps: &[OrientedEdge],
        is_cut_at: impl Fn(usize) -> bool,
    ) -> Result<Vec<NurbsCurve>, GeomError> {
        let begins_cut = |&step: &OrientedEdge| is_cut_at(self.ends_of(step)[0]);
        let mut parts: Vec<(usize, Interval, bool)> = Vec::new();
        for step in steps {
            let PlaneEdge { arc, interval, .. } = self.edges[step.0];
            let part = (arc, interval, step.1);
            match parts.last_mut() {
                Some(last)
                    if !begins_cut(step)
                        && let Some(whole) = self.follows(last, part) =>
                {
                    last.1 = whole;
                }
                _ => parts.push(part),
            }
        }
        if let [first, .., last] = parts[..]
            && !steps.first().is_some_and(begins_cut)
            && let Some(whole) = self.follows(&last, first)
        {
            parts[0].1 = whole;
            parts.pop();
        }
        let arc = |&(arc, interval, is_along): &(usize, Interval, bool)| {
            let whole = &self.arcs[arc];
            let part = match interval == whole.domain() {
                true => whole.clone(),
                false => whole.trimmed(interval)?,
            };
            Ok(if is_along { part } else { part.reversed() })
        };
        parts.iter().map(arc).collect()
    }

    /// What two parts of one arc are together, where the second goes on as the first ends.
    fn follows(
        &self,
        &(arc, before, is_along): &(usize, Interval, bool),
        (next, behind, next_along): (usize, Interval, bool),
    ) -> Option<Interval> {
        if arc != next || is_along != next_along {
            return None;
        }
        let (low, high) = if is_along { (before, behind) } else { (behind, before) };
        let slack = PARAMETER_RELATIVE * self.arcs[arc].domain().length();
        let meets = (high.start() - low.end()).abs() <= slack;
        meets.then(|| Interval::new(low.start(), high.end()).ok())?
    }
}

/// Where an edge from or to the centre of a circle first leaves it.
fn leaving(edge: &PlaneEdge, center: DVec3, radius: f64, is_along: bool) -> DVec3 {
    let domain = edge.curve.domain();
    let at = |x: f64| edge.curve.point_at(domain.at(if is_along { x } else { 1.0 - x }));
    let is_within = |x: f64| norm(at(x) - center) <= radius;
    let step = |i: usize| i as f64 / LEAVING_STEPS as f64;
    let first = (1..=LEAVING_STEPS).find(|&i| !is_within(step(i))).unwrap_or(LEAVING_STEPS);
    at(bisected([step(first - 1), step(first)], BISECTIONS, is_within)[1])
}

/// One curve along arcs that follow one another.
///
/// # Errors
/// Those of [`crate::join`].
pub(crate) fn joined(arcs: &[NurbsCurve]) -> Result<NurbsCurve, GeomError> {
    join_chain(arcs, f64::INFINITY)
}
