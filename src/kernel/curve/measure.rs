//! Length and extent of curves.

use super::{NurbsCurve, part::Part};
use crate::{
    kernel::{
        Bounds, Grid, Interval, KnotVector,
        frame::norm,
        hull::Spline,
        tolerance::{LAST_BIT, LENGTH_RELATIVE},
    },
    limits::work,
};

/// Halvings of a piece whose length does not settle: enough for a cusp, whose error falls by four
/// with each.
const MAX_HALVINGS: usize = 40;

/// Pieces of one span of a low degree; only noise needs more than some hundred, and has no better
/// answer.
pub(super) const MAX_PIECES: usize = 10_000;

/// Pieces of one span of any degree.
const LEAST_PIECES: usize = 100;

/// The square of the order up to which a degree is low.
const LOW: usize = 16;

/// Cuts for a span, on average, where the tangent turns; a cusp takes some fifty, and more only what
/// turns at random.
const MAX_CUTS: usize = 200;

/// Positive nodes on −1..1 and weights of the Gauss-Legendre rule with 16 nodes.
///
/// Abramowitz & Stegun, *Handbook of Mathematical Functions*, Table 25.4.
const GAUSS_16: [[f64; 2]; 8] = [
    [0.09501250983763744, 0.1894506104550685],
    [0.2816035507792589, 0.18260341504492358],
    [0.45801677765722737, 0.16915651939500254],
    [0.6178762444026438, 0.14959598881657674],
    [0.755404408355003, 0.12462897125553388],
    [0.8656312023878318, 0.09515851168249279],
    [0.9445750230732326, 0.062253523938647894],
    [0.9894009349916499, 0.027152459411754096],
];

impl NurbsCurve {
    /// Arc length over the part of the interval that lies in the domain.
    ///
    /// Gauss-Legendre quadrature of the speed, each piece halved until both halves together agree
    /// with the whole to 1e-13 of the length or the rounding of the coordinates.
    #[must_use]
    pub fn length(&self, interval: Interval) -> f64 {
        self.length_within(interval, LAST_BIT * self.magnitude())
    }

    /// [`Self::length`] for coordinates that are rounded by so much.
    pub(super) fn length_within(&self, interval: Interval, rounding: f64) -> f64 {
        let pieces = self.smooth_pieces(interval, rounding);
        let estimates: Vec<f64> =
            pieces.iter().map(|&piece| quadrature(&self.speed_on(piece), piece)).collect();
        let accuracy = LENGTH_RELATIVE * estimates.iter().sum::<f64>() + rounding;
        let order = self.degree() + 1;
        let most = (MAX_PIECES * LOW / (order * order)).clamp(LEAST_PIECES, MAX_PIECES);
        let refined = |(piece, estimate): (Interval, f64)| {
            refined(&self.speed_on(piece), (piece, estimate), accuracy, most)
        };
        pieces.into_iter().zip(estimates).map(refined).sum()
    }

    /// The speed on a part of one span.
    pub(super) fn speed_on(&self, piece: Interval) -> impl Fn(f64) -> f64 + '_ {
        // One span for all nodes, so that none beside a knot falls on its wrong side.
        let span = self.knots.span_at(piece.at(0.5));
        move |t| norm(self.velocity_on(span, t)[1])
    }

    /// The smallest axis-aligned box around the curve, to rounding; not that of its control points.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        let Ok(constant) = KnotVector::bezier(0) else {
            unreachable!("degree 0 is below every ceiling")
        };
        let points = Grid::from_rows_of(self.control_points.len(), self.control_points.clone());
        Spline { knots: [&constant, &self.knots], points: &points }.bounds()
    }

    /// The interval cut to the domain, at the knots, and so often that no tangent of a piece is far
    /// from another: beside a cusp nodes on one side alone would agree on the wrong length.
    pub(super) fn smooth_pieces(&self, interval: Interval, short: f64) -> Vec<Interval> {
        let (knots, domain) = (self.knots.as_slice(), self.domain());
        let [first, last] = [interval.start(), interval.end()]
            .map(|t| self.knots.span_at(t.clamp(domain.start(), domain.end())));
        let overlaps = |&span: &usize| {
            let (start, end) = (knots[span], knots[span + 1]);
            start < end && interval.start() < end && start < interval.end()
        };
        let spans: Vec<usize> = (first..=last).filter(overlaps).collect();
        let mut pieces = Vec::new();
        let most = spans.len().saturating_mul(MAX_CUTS);
        let mut n_cuts = 0;
        let mut todo: Vec<(Part, usize)> =
            spans.into_iter().rev().map(|span| (Part::of_span(self, span), 0)).collect();
        while work::goes_on(1)
            && let Some((part, n_halvings)) = todo.pop()
        {
            let own = part.interval;
            let (start, end) = (own.start().max(interval.start()), own.end().min(interval.end()));
            let Ok(piece) = Interval::new(start, end) else { continue };
            let is_smooth = part.cone.is_narrow() || part.bounds.diagonal() <= short;
            if is_smooth || MAX_HALVINGS <= n_halvings || most <= n_cuts {
                pieces.push(piece);
            } else {
                n_cuts += 1;
                let [left, right] = part.halves();
                todo.extend([(right, n_halvings + 1), (left, n_halvings + 1)]);
            }
        }
        pieces
    }
}

/// The integral of a speed, to 1e-13 of it or to the rounding of coordinates.
pub(super) fn integral(
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
        let may_halve = n_halvings < MAX_HALVINGS && n_pieces < most;
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
pub(super) fn quadrature(speed: &impl Fn(f64) -> f64, piece: Interval) -> f64 {
    let (middle, half) = (piece.at(0.5), 0.5 * piece.length());
    let pair = |&[node, weight]: &[f64; 2]| {
        weight * (speed(middle - half * node) + speed(middle + half * node))
    };
    half * GAUSS_16.iter().map(pair).sum::<f64>()
}
