//! The curves in which planes cut planes, quadrics and tori, exactly.
//!
//! A curve that was found within the tolerance tells which part of which conic is meant; the conic is that of the
//! surface's equation in coordinates of the plane. Arcs of ellipses are images of arcs of circles. All others are
//! pieces between the tangents at their ends, of a middle weight that the equation q tells: with
//! r = (1−t)²A + 2t(1−t)wB + t²C, where B is the pole of AC, q(r) = 0 leaves w² = −q(A, C) / 2q(B, B). Each piece
//! is put into the equation before it is told, in more places than a polynomial can vanish in that does not vanish.
//! Farin, *Curves and Surfaces for CAGD*, §12; Piegl & Tiller, *The NURBS Book*, §7.3.

mod carrier;
mod ellipse_around;
mod plane_conic;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::{DVec2, DVec3, DVec4};

use self::{
    carrier::ExactCarrier,
    plane_conic::{Ellipse, PlaneConic},
};
use crate::{
    Frame, Interval, KnotVector, NurbsCurve, NurbsSurface,
    ceiling::CONIC_HALVINGS,
    frame::angle_between,
    tolerance::{ANALYTIC_RELATIVE, KNOT_RELATIVE},
};

/// Even parts of each span of a curve between which it turns by less than half a turn.
const PARTS: usize = 4;

/// The largest weight in the middle of a piece whose ends have weight one: beyond it the parameter runs unevenly.
const LARGEST_WEIGHT: f64 = 2.0;

/// Where within each piece it is compared with what was found.
const COMPARED: [f64; 3] = [0.2, 0.5, 0.8];

impl NurbsSurface {
    /// Curves that were found where a plane cuts it, each as the exact line or conic where it is one up to rounding
    /// and within the tolerance of what was found.
    pub(in crate::surface) fn exact_in_plane(
        &self,
        curves: Vec<NurbsCurve>,
        plane: Frame,
        tolerance: f64,
    ) -> Vec<NurbsCurve> {
        if curves.is_empty() {
            return curves;
        }
        let Some(carrier) = ExactCarrier::of(self, tolerance) else { return curves };
        let allowed = ANALYTIC_RELATIVE * self.bounds().magnitude();
        let exact = |curve: NurbsCurve| {
            let search = ConicSearch { carrier: &carrier, found: &curve, allowed, tolerance };
            search.exact(plane).unwrap_or(curve)
        };
        curves.into_iter().map(exact).collect()
    }
}

/// A piece between two parameters, by its Bézier points.
type ConicPiece = ([f64; 2], [DVec4; 3]);

/// An exact curve near one that was found.
struct ConicSearch<'a> {
    carrier: &'a ExactCarrier,
    found: &'a NurbsCurve,
    /// What is rounding.
    allowed: f64,
    tolerance: f64,
}

impl ConicSearch<'_> {
    fn exact(&self, plane: Frame) -> Option<NurbsCurve> {
        let center = self.found.bounds().center() - plane.origin();
        let plane = plane.at(plane.origin() + center - plane.z() * center.dot(plane.z()));
        let line = self.line();
        if line.is_some() {
            return line;
        }
        let conics = self.carrier.conics(plane).into_iter();
        let found = conics.filter_map(|conic| {
            let [start, end] =
                [self.found.start(), self.found.end()].map(|end| self.onto(&conic, end));
            let ends = [start?, end?];
            let curve = self.ellipse(&conic, ends).or_else(|| self.pieces(&conic, ends))?;
            (self.carrier.holds(&curve, self.allowed) && self.is_near(&curve)).then_some(curve)
        });
        found.into_iter().next()
    }

    /// The nearest place of a conic, within the tolerance.
    fn onto(&self, conic: &PlaneConic, point: DVec3) -> Option<DVec2> {
        let start = conic.local(point);
        conic.onto(start).filter(|place| place.distance(start) <= self.tolerance)
    }

    /// The line between the ends.
    fn line(&self) -> Option<NurbsCurve> {
        let (start, end) = (self.found.start(), self.found.end());
        let domain = self.found.domain();
        let way = end - start;
        let is_near = |point: DVec3| {
            let across = (point - start).cross(way);
            across.length() <= self.tolerance * way.length()
        };
        if way.length() <= self.tolerance || !self.found.points().into_iter().all(is_near) {
            return None;
        }
        let knots = vec![domain.start(), domain.start(), domain.end(), domain.end()];
        let line = NurbsCurve::polynomial(KnotVector::new(1, knots).ok()?, &[start, end]).ok()?;
        self.carrier.holds(&line, self.allowed).then_some(line)
    }

    /// The arc of an ellipse.
    fn ellipse(&self, conic: &PlaneConic, [start, end]: [DVec2; 2]) -> Option<NurbsCurve> {
        let ellipse = conic.ellipse(start)?;
        let is_closed = self.found.start() == self.found.end();
        let from = ellipse.angle(start);
        // The angle is followed along what was found.
        let (mut sweep, mut last) = (0.0, from);
        let on_found = self.places().into_iter().map(|t| conic.local(self.found.point_at(t)));
        for place in on_found.chain([if is_closed { start } else { end }]) {
            let angle = ellipse.angle(place);
            if self.tolerance < place.distance(ellipse.place(angle, 1.0)) {
                return None;
            }
            let step = (angle - last + PI).rem_euclid(TAU) - PI;
            (sweep, last) = (sweep + step, angle);
        }
        let n_turns = libm::round(sweep / TAU);
        if is_closed && (n_turns.abs() - 1.0).abs() > 0.0 {
            return None;
        }
        let (end, sweep) = if is_closed { (start, n_turns * TAU) } else { (end, sweep) };
        arc_of(&ellipse, conic, [start, end], sweep, self.found.domain())
    }

    /// Pieces of any conic between tangents.
    fn pieces(&self, conic: &PlaneConic, [first, last]: [DVec2; 2]) -> Option<NurbsCurve> {
        let domain = self.found.domain();
        let n_parts = libm::ceil(self.turn() / FRAC_PI_2 - KNOT_RELATIVE).max(1.0) as usize;
        let steps = domain.steps(n_parts);
        let mut places = vec![first];
        for &t in &steps[1..n_parts] {
            places.push(self.onto(conic, self.found.point_at(t))?);
        }
        places.push(last);
        let part = |k: usize| ([steps[k], steps[k + 1]], [places[k], places[k + 1]], 0);
        let mut todo: Vec<_> = (0..n_parts).rev().map(part).collect();
        let mut pieces: Vec<ConicPiece> = Vec::new();
        while let Some((interval, [from, to], n_halvings)) = todo.pop() {
            if let Some((pole, weight)) =
                conic.between(from, to).filter(|&(_, w)| w <= LARGEST_WEIGHT)
            {
                let points = [(from, 1.0), (pole, weight), (to, 1.0)];
                pieces.push((interval, points.map(|(place, weight)| conic.point(place, weight))));
                continue;
            }
            if n_halvings == CONIC_HALVINGS {
                return None;
            }
            let t = 0.5 * (interval[0] + interval[1]);
            let middle = self.onto(conic, self.found.point_at(t))?;
            todo.push(([t, interval[1]], [middle, to], n_halvings + 1));
            todo.push(([interval[0], t], [from, middle], n_halvings + 1));
        }
        assembled(&pieces)
    }

    /// Parameters along what was found, its ends but the last among them.
    fn places(&self) -> Vec<f64> {
        let knots = self.found.knots();
        let steps = |span| knots.span_interval(span).steps(PARTS).into_iter().take(PARTS);
        knots.spans().flat_map(steps).collect()
    }

    /// The angle by which what was found turns, all bends taken together; radians.
    fn turn(&self) -> f64 {
        let ends = [self.found.domain().end()];
        let points: Vec<DVec3> =
            self.places().into_iter().chain(ends).map(|t| self.found.point_at(t)).collect();
        let legs: Vec<DVec3> = points.windows(2).map(|pair| pair[1] - pair[0]).collect();
        legs.windows(2).map(|pair| angle_between(pair[0], pair[1])).sum()
    }

    /// Whether a curve is within the tolerance of what was found.
    fn is_near(&self, curve: &NurbsCurve) -> bool {
        let intervals = curve.knots().spans().map(|span| curve.knots().span_interval(span));
        let mut places =
            intervals.flat_map(|interval: Interval| COMPARED.map(|at| interval.at(at)));
        places.all(|t| {
            let point = curve.point_at(t);
            self.found.foot_within(point, self.tolerance).is_some()
        })
    }
}

/// The arc of an ellipse in the plane of a conic between two places, by an angle of its circle that leads from the first to
/// the last, at an even pace over a domain.
fn arc_of(
    ellipse: &Ellipse,
    conic: &PlaneConic,
    [start, end]: [DVec2; 2],
    sweep: f64,
    domain: Interval,
) -> Option<NurbsCurve> {
    let from = ellipse.angle(start);
    let n_pieces = libm::ceil(sweep.abs() / FRAC_PI_2 - KNOT_RELATIVE).max(1.0);
    let step = sweep / n_pieces;
    let weight = libm::cos(0.5 * step);
    let corner = |k: f64| match k {
        k if k <= 0.0 => start,
        k if n_pieces <= k => end,
        k => ellipse.place(from + step * k, 1.0),
    };
    let piece = |k: usize| {
        let k = k as f64;
        let middle = ellipse.place(from + step * (k + 0.5), weight.recip());
        let points = [(corner(k), 1.0), (middle, weight), (corner(k + 1.0), 1.0)];
        let ends = [k, k + 1.0].map(|k| domain.at(k / n_pieces));
        (ends, points.map(|(place, weight)| conic.point(place, weight)))
    };
    assembled(&(0..n_pieces as usize).map(piece).collect::<Vec<_>>())
}

/// Pieces of degree 2 that follow one another as one curve.
fn assembled(pieces: &[ConicPiece]) -> Option<NurbsCurve> {
    let (first, last) = (pieces.first()?, pieces.last()?);
    let mut knots = vec![first.0[0]; 3];
    let mut points = vec![first.1[0]];
    for (ends, own) in pieces {
        points.extend_from_slice(&own[1..]);
        knots.extend([ends[1]; 2]);
    }
    knots.push(last.0[1]);
    NurbsCurve::new(KnotVector::new(2, knots).ok()?, points).ok()
}
