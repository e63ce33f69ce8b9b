//! Length and extent of curves.

use std::borrow::Cow;

use glam::{DAffine3, DVec4};

use crate::{
    Bounds, Grid, Interval, KnotVector,
    bezier::{blend, cut_at},
    ceiling::{LENGTH_HALVINGS, LENGTH_PIECES, TURN_CUTS},
    curve::{NurbsCurve, representation::part::CurvePart},
    frame::norm,
    hull::TensorSpline,
    numeric::gauss_legendre::{self, SIXTEEN_NODES},
    tolerance::{LAST_BIT, LENGTH_RELATIVE},
    work,
};

/// Pieces of one span of any degree.
const LEAST_PIECES: usize = 100;

/// The square of the order up to which a degree is low.
const LOW: usize = 16;

/// A curve so many times its size away is measured about its middle.
const FAR: f64 = 4.0;

impl NurbsCurve {
    /// Arc length over the part of the interval that lies in the domain.
    ///
    /// Gauss-Legendre quadrature of the speed, each piece halved until both halves together agree
    /// with the whole to 1e-13 of the length or the rounding of the coordinates.
    ///
    /// A curve of degree 1 is as long as its legs.
    #[must_use]
    pub fn length(&self, interval: Interval) -> f64 {
        if self.degree() <= 1 {
            return self.length_of_legs(interval);
        }
        let near = self.near_origin();
        near.length_within(interval, LAST_BIT * near.magnitude())
    }

    /// The legs of a curve of degree 1 in an interval, each from end to end.
    pub(in crate::curve) fn length_of_legs(&self, interval: Interval) -> f64 {
        let leg = |span: usize| {
            let own = self.knots.span_interval(span);
            let ends = [own.start().max(interval.start()), own.end().min(interval.end())];
            if ends[1] <= ends[0] {
                return 0.0;
            }
            let [a, b] = ends.map(|t| self.velocity_on(span, t)[0]);
            norm(b - a)
        };
        self.knots.spans_within(interval).take_while(|_| work::goes_on(1)).map(leg).sum()
    }

    /// The curve about the middle of its box, if that is far away: differences of coordinates there
    /// are rounded like the curve, and not like its place.
    fn near_origin(&self) -> Cow<'_, Self> {
        match Bounds::of(self.points()) {
            Some(bounds) if FAR * bounds.diagonal() < bounds.magnitude() => {
                Cow::Owned(self.transformed(&DAffine3::from_translation(-bounds.center())))
            }
            _ => Cow::Borrowed(self),
        }
    }

    /// [`Self::length`] for coordinates that are rounded by so much.
    pub(in crate::curve) fn length_within(&self, interval: Interval, rounding: f64) -> f64 {
        if self.degree() <= 1 {
            return self.length_of_legs(interval);
        }
        let parts = self.narrow_parts(interval, rounding);
        let estimates: Vec<f64> = parts.iter().map(|part| length_by_rule(&part.points)).collect();
        // What all parts may be wrong by together is shared out among them.
        let total = estimates.iter().sum::<f64>();
        let share = total / estimates.len().max(1) as f64;
        let order = self.degree() + 1;
        let most = (LENGTH_PIECES * LOW / (order * order)).clamp(LEAST_PIECES, LENGTH_PIECES);
        let refined = |(part, estimate): (CurvePart, f64)| {
            let accuracy = LENGTH_RELATIVE * estimate.max(share) + rounding;
            refined_part(part.points.into_vec(), estimate, accuracy, most)
        };
        parts.into_iter().zip(estimates).map(refined).sum()
    }

    /// The speed on a part of one span.
    pub(in crate::curve) fn speed_on(&self, piece: Interval) -> impl Fn(f64) -> f64 + '_ {
        // One span for all nodes, so that none beside a knot falls on its wrong side.
        let span = self.knots.span_at(piece.at(0.5));
        move |t| norm(self.velocity_on(span, t)[1])
    }

    /// The smallest axis-aligned box around the curve, to rounding; not that of its control points.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        *self.bounds.get_or_make(|| {
            let Ok(constant) = KnotVector::bezier(0) else {
                unreachable!("degree 0 is below every ceiling")
            };
            let points = Grid::from_rows_of(self.control_points.len(), self.control_points.clone());
            TensorSpline { knots: [&constant, &self.knots], points: &points }.bounds()
        })
    }

    /// The interval cut to the domain, at the knots, and so often that no tangent of a piece is far
    /// from another: beside a cusp nodes on one side alone would agree on the wrong length.
    pub(crate) fn smooth_pieces(&self, interval: Interval, short: f64) -> Vec<Interval> {
        self.narrow_parts(interval, short).into_iter().map(|part| part.interval).collect()
    }

    /// [`Self::smooth_pieces`] with their control points.
    fn narrow_parts(&self, interval: Interval, short: f64) -> Vec<CurvePart> {
        let spans = self.knots.spans_within(interval).take_while(|_| work::goes_on(1));
        let parts = spans.map(|span| CurvePart::of_span(self, span));
        let within: Vec<CurvePart> = parts.filter_map(|part| part.within(interval)).collect();
        let most = within.len().saturating_mul(TURN_CUTS);
        let mut parts = Vec::new();
        let mut n_cuts = 0;
        let mut todo: Vec<(CurvePart, usize)> =
            within.into_iter().rev().map(|part| (part, 0)).collect();
        while work::goes_on(1)
            && let Some((part, n_halvings)) = todo.pop()
        {
            let is_smooth = part.cone().is_narrow() || part.bounds.diagonal() <= short;
            if is_smooth || LENGTH_HALVINGS <= n_halvings || most <= n_cuts {
                parts.push(part);
            } else {
                n_cuts += 1;
                let [left, right] = part.halves();
                todo.extend([(right, n_halvings + 1), (left, n_halvings + 1)]);
            }
        }
        parts
    }
}

/// The length of a Bézier curve by one rule.
///
/// Its points alone are asked, by parameters from its own start: beside the end of a domain, where
/// unequal weights crowd a curve, those of the whole have no digits left.
/// The last two points of de Casteljau's algorithm tell point and derivative: Farin, *Curves and
/// Surfaces for CAGD*, §5.3.
fn length_by_rule(points: &[DVec4]) -> f64 {
    let degree = (points.len() - 1) as f64;
    let mut row = Vec::with_capacity(points.len());
    let speed = |t: f64| {
        row.clear();
        row.extend_from_slice(points);
        for n_left in (2..points.len()).rev() {
            for i in 0..n_left {
                row[i] = blend(row[i], row[i + 1], t);
            }
        }
        let [a, b] = [row[0], row[1]];
        let (at, slope) = (blend(a, b, t), (b - a) * degree);
        norm(slope.truncate() - at.truncate() * (slope.w / at.w)) / at.w
    };
    gauss_legendre::integral(&SIXTEEN_NODES, Interval::UNIT, speed)
}

/// The length of a Bézier curve from an estimate: it is halved, up to `most` times, until both
/// halves together agree with the whole.
fn refined_part(points: Vec<DVec4>, estimate: f64, accuracy: f64, most: usize) -> f64 {
    let mut length = 0.0;
    let mut todo = vec![(points, estimate, 0)];
    let mut n_pieces = 0;
    while work::goes_on(1)
        && let Some((points, estimate, n_halvings)) = todo.pop()
    {
        let (left, right) = cut_at(&points, 0.5);
        let lengths = [&left, &right].map(|half| length_by_rule(half));
        let sum = lengths[0] + lengths[1];
        n_pieces += 1;
        let may_halve = n_halvings < LENGTH_HALVINGS && n_pieces < most;
        // In this order a sum that is no number ends the search.
        if may_halve && accuracy < (sum - estimate).abs() {
            todo.push((right, lengths[1], n_halvings + 1));
            todo.push((left, lengths[0], n_halvings + 1));
        } else {
            length += sum;
        }
    }
    length
}

/// The integral of a speed, to 1e-13 of it or to the rounding of coordinates.
pub(in crate::curve) fn integral(
    speed: &impl Fn(f64) -> f64,
    interval: Interval,
    rounding: f64,
    most: usize,
) -> f64 {
    let estimate = quadrature(speed, interval);
    refined(speed, (interval, estimate), LENGTH_RELATIVE * estimate + rounding, most)
}

/// An integral from an estimate: each piece is halved, up to `most` times, until both halves
/// together agree with the whole.
fn refined(
    speed: &impl Fn(f64) -> f64,
    (piece, estimate): (Interval, f64),
    accuracy: f64,
    most: usize,
) -> f64 {
    let mut length = 0.0;
    let mut todo = vec![(piece, estimate, 0)];
    let mut n_pieces = 0;
    while work::goes_on(1)
        && let Some((piece, estimate, n_halvings)) = todo.pop()
    {
        let halves = piece.halves();
        let lengths = halves.map(|half| quadrature(speed, half));
        let sum = lengths[0] + lengths[1];
        n_pieces += 1;
        let may_halve = n_halvings < LENGTH_HALVINGS && n_pieces < most;
        // In this order a sum that is no number ends the search.
        if may_halve && accuracy < (sum - estimate).abs() {
            let half = |i: usize| (halves[i], lengths[i], n_halvings + 1);
            todo.extend([half(1), half(0)]);
        } else {
            length += sum;
        }
    }
    length
}

/// The integral of a speed by one rule.
fn quadrature(speed: &impl Fn(f64) -> f64, piece: Interval) -> f64 {
    gauss_legendre::integral(&SIXTEEN_NODES, piece, speed)
}
