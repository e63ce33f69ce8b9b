//! A curve in which surfaces meet, lifted to the parameters of both.
//!
//! In the plane across the curve at a parameter both surfaces have one common place, with its parameters and how
//! these change along it (`place`). Cubics between such places are a piece of the curve and of both curves of
//! parameters; their misses are bounded (`piece`), and a piece that misses by more than is allowed is halved.
//! Pieces end where a curve of parameters reaches a knot; where it leaves the domain through a seam or a pole the
//! next piece begins at its other side.

use glam::{DVec3, DVec4};

use super::{
    piece::CurvePiece,
    place::{CommonPlace, PlaceFinder},
};
use crate::{
    Interval, NurbsCurve, Side, bezier,
    ceiling::EDGE_PIECES,
    tolerance::{BORDER_END_SHARE, FIRST_LOOK, KNOT_RELATIVE, SHORTEST_EDGE_PIECE},
    work,
};

/// A piece of a curve in space and of both its curves of parameters, by Bézier points.
#[derive(Clone, Debug)]
pub(super) struct LiftedPiece {
    pub(super) ends: [f64; 2],
    pub(super) curve: Vec<DVec4>,
    /// With z = 0.
    pub(super) on: [Vec<DVec4>; 2],
}

/// Whether the curve stays as it is or becomes the one of the common places.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum LiftForm {
    Kept,
    Refitted,
}

/// The pieces of a curve, each within `allowed` of both surfaces where `limit` can be kept; `None` where the
/// curve itself is further away and is to be kept, or where no places are found.
pub(super) fn lifted(
    finder: &PlaceFinder<'_>,
    curve: &NurbsCurve,
    form: LiftForm,
    allowed: f64,
) -> Option<Vec<LiftedPiece>> {
    let mut lift = Lift { finder, curve, form, allowed, pieces: Vec::new() };
    lift.run()?;
    Some(lift.pieces)
}

struct Lift<'l, 's> {
    finder: &'l PlaceFinder<'s>,
    curve: &'l NurbsCurve,
    form: LiftForm,
    allowed: f64,
    pieces: Vec<LiftedPiece>,
}

impl Lift<'_, '_> {
    fn run(&mut self) -> Option<()> {
        let domain = self.curve.domain();
        let mut todo = self.finder.breaks(self.curve);
        todo.reverse();
        let first = todo.pop()?;
        let last = self.finder.at_end(first, Side::Right, None)?;
        let mut last = self.on_side_ahead(last, first);
        let mut t = first;
        while let Some(&target) = todo.last() {
            if !work::goes_on(1) || EDGE_PIECES < self.pieces.len() {
                return None;
            }
            let is_shortest = target - t <= SHORTEST_EDGE_PIECE * domain.length();
            let halved = 0.5 * (t + target);
            let guess = last.ahead(target - t);
            let Some(mut next) = self.place_at(target, guess) else {
                if is_shortest {
                    return None;
                }
                todo.push(halved);
                continue;
            };
            if self.leaves(&last, &next).is_some() {
                last = self.across_all(last, &next, t)?;
                continue;
            }
            let mut end = target;
            let mut knot = self.first_knot(&last, &next);
            if let Some((k, value, share)) = knot {
                let start = last.ahead((target - t) * share);
                match self.finder.at_knot(k, value, start, t + (target - t) * share) {
                    Some((at, place)) if t < at && at < target => (end, next) = (at, place),
                    // Beside a junction the places no longer tell where a knot is.
                    _ if is_shortest => knot = None,
                    _ => {
                        todo.push(halved);
                        continue;
                    }
                }
            }
            let piece = self.piece([t, end], [&last, &next])?;
            if !is_shortest && !self.is_near(&piece)? {
                todo.push(0.5 * (t + end));
                continue;
            }
            self.pieces.push(piece);
            t = end;
            if target <= end {
                todo.pop();
            }
            match self.next_start(knot, next, t, todo.last().copied())? {
                Some(next) => last = next,
                None => return Some(()),
            }
        }
        Some(())
    }

    /// The first place, at the side of a seam to which the curve goes from there: a foot tells either.
    fn on_side_ahead(&self, first: CommonPlace, t: f64) -> CommonPlace {
        let step = FIRST_LOOK * self.curve.domain().length();
        let mut ahead = first;
        ahead.at = first.ahead(step);
        self.across_all(first, &ahead, t).unwrap_or(first)
    }

    /// The place at the end of a piece.
    fn place_at(&self, t: f64, guess: [f64; 4]) -> Option<CommonPlace> {
        match self.curve.domain().end() <= t {
            true => self.finder.at_end(t, Side::Left, Some(guess)),
            false => self.finder.place(t, Side::Left, Some(guess)),
        }
    }

    /// Where the next piece starts behind one that ends in a place; none behind the end of the curve.
    fn next_start(
        &mut self,
        knot: Option<(usize, f64, f64)>,
        place: CommonPlace,
        t: f64,
        target: Option<f64>,
    ) -> Option<Option<CommonPlace>> {
        let Some(target) = target else { return Some(None) };
        let Some((k, value, _)) = knot else { return self.finder.behind(t, place).map(Some) };
        if !self.is_domain_end(k, value) {
            return Some(Some(place));
        }
        let end = self.curve.domain().end();
        let rest = self.curve.end().distance(place.point);
        if end <= target && rest <= BORDER_END_SHARE * self.finder.tolerance {
            self.end_here(end);
            return Some(None);
        }
        self.finder.across(&place, k, t).map(Some)
    }

    /// Lets the last piece go to the end of the curve.
    fn end_here(&mut self, end: f64) {
        if let Some(piece) = self.pieces.last_mut() {
            piece.ends[1] = end;
        }
    }

    fn is_domain_end(&self, k: usize, value: f64) -> bool {
        let domain = self.finder.domains[k];
        value <= domain.start() || domain.end() <= value
    }

    /// The parameter that leaves its domain at once on the way from one place to the next.
    fn leaves(&self, from: &CommonPlace, to: &CommonPlace) -> Option<usize> {
        (0..4).find(|&k| {
            let domain = self.finder.domains[k];
            let slack = KNOT_RELATIVE * domain.length();
            let [a, b] = [from.at[k], to.at[k]];
            a <= domain.start() + slack && b < domain.start() - slack
                || domain.end() - slack <= a && domain.end() + slack < b
        })
    }

    /// The place as it is at the other sides of all ends of domains that it leaves on the way to the next: seams of
    /// both surfaces may be in one place.
    fn across_all(&self, mut place: CommonPlace, to: &CommonPlace, t: f64) -> Option<CommonPlace> {
        for _ in 0..place.at.len() {
            let Some(k) = self.leaves(&place, to) else { break };
            place = self.finder.across(&place, k, t)?;
        }
        self.leaves(&place, to).is_none().then_some(place)
    }

    /// The first knot between two places: the parameter, the knot, and about how far on the way it is.
    fn first_knot(&self, from: &CommonPlace, to: &CommonPlace) -> Option<(usize, f64, f64)> {
        let mut first: Option<(usize, f64, f64)> = None;
        for k in 0..4 {
            let slack = KNOT_RELATIVE * self.finder.domains[k].length();
            let [a, b] = [from.at[k], to.at[k]];
            let [low, high] = [a.min(b) + slack, a.max(b) - slack];
            let knots = &self.finder.knots[k];
            let range = knots.partition_point(|&t| t <= low)..knots.partition_point(|&t| t < high);
            for &knot in knots.get(range).unwrap_or_default() {
                let share = (knot - a) / (b - a);
                if first.is_none_or(|(_, _, least)| share < least) {
                    first = Some((k, knot, share));
                }
            }
        }
        first
    }

    /// The cubics between two places.
    fn piece(&self, ends: [f64; 2], [start, end]: [&CommonPlace; 2]) -> Option<LiftedPiece> {
        let third = (ends[1] - ends[0]) / 3.0;
        let hermite = |a: DVec3, along_a: DVec3, b: DVec3, along_b: DVec3| {
            vec![a, a + along_a * third, b - along_b * third, b]
        };
        let homogeneous =
            |points: Vec<DVec3>| points.into_iter().map(|p| p.extend(1.0)).collect::<Vec<_>>();
        let on = [0, 1].map(|surface| {
            let pair = |of: [f64; 4]| DVec3::new(of[2 * surface], of[2 * surface + 1], 0.0);
            let mut points =
                hermite(pair(start.at), pair(start.speeds), pair(end.at), pair(end.speeds));
            // What is beyond a border by rounding, or by the bend of a cubic along one.
            for point in &mut points {
                let within = self.finder.carriers[surface].within([point.x, point.y]);
                *point = DVec3::new(within[0], within[1], 0.0);
            }
            homogeneous(points)
        });
        let curve = match self.form {
            LiftForm::Kept => {
                let span = self.curve.knots().span_beside(ends[0], Side::Right);
                let whole = self.curve.knots().span_interval(span);
                let points = bezier::piece(self.curve.knots(), self.curve.control_points(), span);
                cut_between(&points, ends.map(|t| whole.fraction_of(t)))
            }
            LiftForm::Refitted => {
                homogeneous(hermite(start.point, start.velocity, end.point, end.velocity))
            }
        };
        let is_finite = curve.iter().chain(&on[0]).chain(&on[1]).all(|p| p.is_finite());
        is_finite.then_some(LiftedPiece { ends, curve, on })
    }

    /// Whether a piece is as near to both surfaces as is allowed; `None` where no halving helps.
    fn is_near(&self, piece: &LiftedPiece) -> Option<bool> {
        let bounded = piece.coefficients();
        let misses = [0, 1].map(|surface| {
            let residual = bounded.residual(&self.finder.carriers[surface], surface);
            residual.map_or(f64::INFINITY, |residual| residual.length())
        });
        if misses[0].max(misses[1]) <= self.allowed {
            return Some(true);
        }
        // The curve itself is that far away where it is looked at.
        let is_kept = self.form == LiftForm::Kept;
        let is_far = |end: usize| {
            let point = bounded.curve[if end == 0 { 0 } else { bounded.curve.len() - 1 }];
            let point = point.truncate() / point.w;
            (0..2).any(|surface| {
                let at = bounded.on[surface]
                    .each_ref()
                    .map(|t| t[if end == 0 { 0 } else { t.len() - 1 }]);
                self.finder.point(surface, at).distance(point) > self.allowed
            })
        };
        if is_kept && (is_far(0) || is_far(1)) { None } else { Some(false) }
    }
}

impl LiftedPiece {
    /// The piece as what its misses are bounded of.
    pub(super) fn coefficients(&self) -> CurvePiece {
        let on = self.on.each_ref().map(|points| {
            [points.iter().map(|p| p.x).collect(), points.iter().map(|p| p.y).collect()]
        });
        CurvePiece { curve: self.curve.clone(), on }
    }
}

/// The Bézier points between two fractions of a Bézier curve.
fn cut_between(points: &[DVec4], [from, to]: [f64; 2]) -> Vec<DVec4> {
    crate::bernstein::part(points, [from, to])
}

/// Pieces of an interval that two splines have, both by Bézier points.
pub(super) fn pieces_of(curve: &NurbsCurve) -> Vec<(Interval, Vec<DVec4>)> {
    let knots = curve.knots();
    let piece =
        |span| (knots.span_interval(span), bezier::piece(knots, curve.control_points(), span));
    knots.spans().map(piece).collect()
}
