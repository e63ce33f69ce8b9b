//! The search for nearest places on a spline: over the boxes of its patches, and on each over its parts.

use glam::{DVec3, DVec4};

use super::{
    ClosestPointTree, SearchTarget, SplineParameters,
    gap::DistanceBounds,
    patch::{BezierPatch, PatchPart},
    spans::KnotSpan,
};
use crate::{
    Direction,
    ceiling::{NEAREST_LENIENCIES, PATCH_HALVINGS},
    tolerance::{LAST_BIT, NEAREST_RELATIVE},
    work,
};

/// Parts looked at before the search becomes content with less, of all for one place and of a patch for all. Only where a
/// whole line is nearly equally near, askew to the parameters, are there that many.
const MANY_PARTS: usize = 1000;

/// How many times less the search is content with after that many parts.
const LENIENCY: f64 = 8.0;

/// Parts after which planes too are tried to keep a part away, and whatever comes nearer is gone down from.
const EASY_PARTS: usize = MANY_PARTS / 8;

/// Parts looked at, whatever comes: for the sake of numbers out of range.
const MOST_PARTS: usize = 100 * MANY_PARTS;

/// Last bits of the coordinates that what was placed in space may be off.
const COORDINATE_ROUNDINGS: f64 = 16.0;

/// Fourth powers of larger coordinates have no place among the numbers.
const LARGE: f64 = (1_u128 << 120) as f64 * (1_u128 << 120) as f64;

/// One search.
struct ClosestPointSearch<'a> {
    whole: &'a ClosestPointTree,
    points: &'a [DVec4],
    n_columns: usize,
    p: DVec3,
    /// Lengths are multiplied by this.
    unit: f64,
    wanted: SearchTarget,
    /// What a distance may be wrong by.
    rounding: f64,
    best: f64,
    /// Patches by their spans, and places on them.
    found: Vec<([usize; 2], [f64; 2])>,
    /// Patches by their spans, and the corners of parts that are equally near everywhere.
    stretches: Vec<([usize; 2], [[f64; 2]; 2])>,
    patch: BezierPatch,
    gap: DistanceBounds<'a>,
    todo: Vec<PatchPart>,
    n_parts: usize,
    /// Distances that differ by less are equal.
    alike: f64,
    /// Whether a patch had so many parts that equal is what is within the tolerance.
    is_crowded: bool,
}

impl ClosestPointTree {
    /// The places that are nearest to `p`; `points` are those that it was made of. Stretches are
    /// looked for with [`SearchTarget::AllWithin`] only.
    pub(crate) fn places(
        &self,
        points: &[DVec4],
        p: DVec3,
        wanted: SearchTarget,
    ) -> SplineParameters {
        ClosestPointSearch::new(self, points, p, wanted).places(wanted)
    }
}

impl<'a> ClosestPointSearch<'a> {
    /// For the places nearest to `p`; `points` are those that the whole was made of.
    fn new(
        whole: &'a ClosestPointTree,
        points: &'a [DVec4],
        p: DVec3,
        wanted: SearchTarget,
    ) -> Self {
        let size = whole.magnitude.max(p.abs().max_element());
        let unit = if size < LARGE { 1.0 } else { 1.0 / size };
        let degrees = [whole.along[0].degree, whole.along[1].degree];
        let rounding = NEAREST_RELATIVE * size * unit;
        let best = match wanted {
            SearchTarget::OneWithin(distance) => distance * unit + rounding,
            SearchTarget::One | SearchTarget::AllWithin(_) => f64::INFINITY,
        };
        Self {
            whole,
            points,
            n_columns: points.len() / whole.n_rows(),
            p,
            unit,
            wanted: SearchTarget::One,
            rounding,
            best,
            found: Vec::new(),
            stretches: Vec::new(),
            patch: BezierPatch::new(degrees),
            gap: DistanceBounds::new(degrees, &whole.factors),
            todo: Vec::new(),
            n_parts: 0,
            alike: 0.0,
            is_crowded: false,
        }
    }

    /// The places.
    fn places(mut self, wanted: SearchTarget) -> SplineParameters {
        self.run();
        self.improve();
        if let SearchTarget::AllWithin(tolerance) = wanted {
            // Only with the least distance known are parts left out that are further away: of a curve
            // that winds around the place nearly all of it is nearly equally far.
            self.wanted = SearchTarget::AllWithin(tolerance * self.unit);
            self.n_parts = 0;
            let nearest = self.found.clone();
            self.run();
            if self.is_crowded {
                // A stretch is nearly equally near, and no minimum on it is clear: within the tolerance it is one.
                (self.found, self.alike) = (nearest, tolerance * self.unit);
                self.stretches.clear();
                self.n_parts = 0;
                self.run();
            }
        }
        self.finish()
    }

    fn run(&mut self) {
        let mut nodes = vec![(0.0, self.whole.tree.root())];
        self.is_crowded = false;
        while (self.has_nothing() || work::goes_on(1))
            && !self.is_crowded
            && let Some((least, node)) = nodes.pop()
        {
            if self.limit() < least {
                continue;
            }
            match self.whole.tree.children(node) {
                Some(children) => {
                    let mut pair = children
                        .map(|child| (self.whole.tree.least(child, self.p, self.unit), child));
                    if pair[0].0 < pair[1].0 {
                        pair.swap(0, 1);
                    }
                    nodes.extend(pair);
                }
                None => self.look_at_patch(self.whole.tree.spans(node)),
            }
        }
    }

    /// Whether anything is of interest, however far away.
    fn has_nothing(&self) -> bool {
        self.found.is_empty() && self.best.is_infinite()
    }

    /// What is further away than this is of no interest.
    fn limit(&self) -> f64 {
        match self.wanted {
            SearchTarget::AllWithin(tolerance) => self.best + tolerance,
            SearchTarget::One | SearchTarget::OneWithin(_) => {
                let many = (self.n_parts / MANY_PARTS).min(NEAREST_LENIENCIES);
                let leniency = (0..many).fold(1.0, |all, _| all * LENIENCY);
                self.best - self.rounding * leniency
            }
        }
    }

    fn look_at_patch(&mut self, spans: [usize; 2]) {
        let whole = self.whole;
        let net = (self.points, self.n_columns);
        self.patch.take(&whole.along, spans, net, (self.p, self.unit));
        if self.patch.is_beyond(self.limit()) {
            return;
        }
        self.gap.start(self.patch.net());
        self.todo.push(PatchPart::whole([whole.along[0].degree, whole.along[1].degree]));
        let n_before = self.n_parts;
        while (self.has_nothing() || work::goes_on(1))
            && let Some(cell) = self.todo.pop()
        {
            self.gap.next();
            self.n_parts += 1;
            let finds_all = matches!(self.wanted, SearchTarget::AllWithin(_)) && self.alike <= 0.0;
            if finds_all && MANY_PARTS < self.n_parts - n_before {
                self.is_crowded = true;
                self.todo.clear();
                return;
            }
            let before = self.best;
            self.note_corners(cell, spans);
            if EASY_PARTS < self.n_parts && self.best < before {
                self.descend_from_found();
            }
            if let Some(direction) = self.direction_to_halve(cell, spans) {
                let is_left_nearer = self.gap.halve(direction);
                let [left, right] = cell.halves(direction);
                self.todo.extend(if is_left_nearer { [right, left] } else { [left, right] });
            }
        }
    }

    /// The squares of the distances of the corners are among the coefficients, with their rounding: the root of
    /// that is far more than a distance is wrong by, so that a corner that may be nearer is looked at itself.
    fn note_corners(&mut self, cell: PatchPart, spans: [usize; 2]) {
        let has_rows = 0 < self.whole.along[0].degree;
        for corner in [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]] {
            if !has_rows && 0.0 < corner[0] {
                break;
            }
            let limit = self.best * self.best;
            if !self.has_nothing() && !self.gap.may_be_below(corner, limit) {
                continue;
            }
            let place = cell.at(corner);
            let squared = self.patch.squared_at(place);
            if squared < limit || self.has_nothing() {
                self.note(place, squared.sqrt(), spans);
            }
        }
    }

    /// Goes down on the whole patch from the place that was found last: where a valley is askew to the parameters the
    /// corners of parts come nearer to its lowest place by the size of a part each.
    fn descend_from_found(&mut self) {
        let degrees = [self.whole.along[0].degree, self.whole.along[1].degree];
        if let Some(&(spans, place)) = self.found.last() {
            let minimum =
                self.patch.minimum(PatchPart::whole(degrees), place, self.rounding, f64::INFINITY);
            if minimum.squared < self.best * self.best {
                self.note(minimum.place, minimum.squared.sqrt(), spans);
            }
        }
    }

    /// Finds the minimum on a part that can have but one, and tells how to halve another.
    fn direction_to_halve(&mut self, cell: PatchPart, spans: [usize; 2]) -> Option<Direction> {
        let limit = self.limit();
        let is_done = limit < 0.0 || MOST_PARTS < self.n_parts;
        if is_done || self.gap.is_never_below(limit * limit) {
            return None;
        }
        if EASY_PARTS < self.n_parts && self.patch.is_part_beyond(cell, limit) {
            return None;
        }
        if matches!(self.wanted, SearchTarget::AllWithin(_)) && self.is_equally_near() {
            // A whole stretch is equally near.
            for place in [cell.low, cell.high] {
                self.note(place, self.best, spans);
            }
            self.stretches.push((spans, [cell.low, cell.high]));
            return None;
        }
        if self.gap.is_convex(limit * limit) {
            let start = cell.at(self.gap.place_of_least());
            let sought = self.distance_limit();
            let minimum = self.patch.minimum(cell, start, self.rounding, sought);
            if minimum.is_beyond {
                return None;
            }
            self.note(minimum.place, minimum.squared.sqrt(), spans);
            if minimum.is_stationary && self.gap.is_convex(minimum.squared) {
                return None;
            }
        }
        self.gap.direction_to_halve(cell.n_halvings, PATCH_HALVINGS)
    }

    /// Whether all of the part is as far away as the nearest, up to the rounding of coordinates or to what is alike.
    fn is_equally_near(&mut self) -> bool {
        let size = self.whole.magnitude.max(self.p.abs().max_element()) * self.unit;
        let rounding = (COORDINATE_ROUNDINGS * LAST_BIT * size).max(self.alike);
        let of_square = (2.0 * self.best + rounding) * rounding;
        self.gap.is_nothing(self.best * self.best, of_square)
    }

    /// What is further away than this is not kept.
    fn distance_limit(&self) -> f64 {
        match self.wanted {
            SearchTarget::One | SearchTarget::OneWithin(_) => self.best,
            SearchTarget::AllWithin(_) => self.limit(),
        }
    }

    fn note(&mut self, place: [f64; 2], distance: f64, spans: [usize; 2]) {
        if !self.has_nothing() && self.distance_limit() < distance {
            return;
        }
        if let SearchTarget::One = self.wanted {
            self.found.clear();
        }
        self.best = self.best.min(distance);
        self.found.push((spans, place));
    }

    /// The one nearest place, which may be nearest up to rounding only, improved as far as that goes.
    fn improve(&mut self) {
        let along = &self.whole.along;
        if let &[(spans, place)] = &self.found[..] {
            self.patch.take(along, spans, (self.points, self.n_columns), (self.p, self.unit));
            let cell = PatchPart::whole([along[0].degree, along[1].degree]);
            self.found[0].1 = self.patch.minimum(cell, place, self.rounding, f64::INFINITY).place;
        }
    }

    /// The parameters of what was found.
    fn finish(&self) -> SplineParameters {
        let along = &self.whole.along;
        let parameters = |spans: [usize; 2], place: [f64; 2]| {
            [0, 1].map(|direction| {
                let KnotSpan { start, end, .. } = along[direction].spans[spans[direction]];
                start * (1.0 - place[direction]) + end * place[direction]
            })
        };
        let single = self.found.iter().map(|&(spans, place)| parameters(spans, place)).collect();
        let of_stretch = |&(spans, ends): &([usize; 2], [[f64; 2]; 2])| {
            ends.map(|place| parameters(spans, place))
        };
        SplineParameters { single, stretches: self.stretches.iter().map(of_stretch).collect() }
    }
}
