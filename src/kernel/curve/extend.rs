//! A curve that goes on beyond its end.

use glam::DVec4;

use super::NurbsCurve;
use crate::kernel::{
    GeomError, Interval, Receipt, bezier,
    frame::norm,
    homogeneous, positive,
    tolerance::{LAST_BIT, LENGTH_RELATIVE, VANISHING_RELATIVE},
};

/// Doublings of the last span's width before a length counts as out of reach: its knots are still
/// told apart from those of the curve.
const MAX_DOUBLINGS: usize = 30;

/// Steps to the parameter of a length; Newton's method takes five or so.
const MAX_STEPS: usize = 100;

/// Halvings of the last span that make its weights positive; more only where the denominator all
/// but vanishes.
const MAX_HALVINGS: usize = 8;

impl NurbsCurve {
    /// The curve with its last polynomial piece going on until it is longer by `length`, on a
    /// domain that grows at its end.
    ///
    /// The piece stays one piece unless its weights would not stay positive. Exact but for the
    /// parameter where the length is reached, which is found to 1e-13 of it.
    ///
    /// # Errors
    /// [`GeomError::NotPositive`] for a length; [`GeomError::EndOfContinuation`] where no parameter
    /// has it: an arc goes on to the middle of what is missing from its circle.
    pub fn extended(&self, length: f64) -> Result<Self, GeomError> {
        if !(length.is_finite() && 0.0 < length) {
            return Err(GeomError::NotPositive { what: "the length", got: length });
        }
        let clamped = self.clamped();
        let end = clamped.parameter_beyond(length)?;
        if end <= clamped.domain().end() {
            // The length is rounding.
            return Ok(clamped);
        }
        clamped.continued_to(end)?.with_positive_weights()
    }

    /// [`Self::extended`] before the start, on a domain that grows there.
    ///
    /// # Errors
    /// Those of [`Self::extended`].
    pub fn extended_at_start(&self, length: f64) -> Result<Self, GeomError> {
        self.mirrored().extended(length).map(|curve| curve.mirrored())
    }

    /// The same points at the opposite parameters: exactly its own inverse.
    fn mirrored(&self) -> Self {
        let control_points = self.control_points.iter().rev().copied().collect();
        let knots = self.knots.mirrored();
        Self { knots, control_points, receipt: Receipt::NONE, ..self.clone() }
    }

    /// The last piece of a clamped curve prolonged or cut, so that the domain ends at `end`.
    fn continued_to(&self, end: f64) -> Result<Self, GeomError> {
        let degree = self.degree();
        let old_end = self.domain().end();
        let knots = self.knots.map(|t| if t < old_end { t } else { end });
        let span = self.knots.span_at(old_end);
        let mut points: Vec<DVec4> = self.control_points.clone();
        for (i, point) in points.iter_mut().enumerate().take(span + 1).skip(span - degree) {
            let arguments = &knots.as_slice()[i + 1..=i + degree];
            *point = bezier::blossom(&self.knots, &self.control_points, span, arguments);
        }
        positive::check_curve(&knots, &points)?;
        Self::new(knots, points)
    }

    /// More knots in the last span, until no weight is below zero.
    fn with_positive_weights(self) -> Result<Self, GeomError> {
        let span = self.knots.span_interval(self.knots.span_at(self.domain().end()));
        let mut curve = self;
        for _ in 0..MAX_HALVINGS {
            if curve.control_points.iter().all(|point| 0.0 < point.w) {
                return Ok(curve);
            }
            let of_span = |&i: &usize| span.start() <= curve.knots.span_interval(i).start();
            let middle = |i: usize| curve.knots.span_interval(i).at(0.5);
            let middles: Vec<f64> = curve.knots.spans().filter(of_span).map(middle).collect();
            curve = curve.insert_knots(&middles)?;
        }
        Err(GeomError::VanishingWeights { parameter: span.end() })
    }

    /// The parameter behind the domain where the last piece, going on, has the given length.
    fn parameter_beyond(&self, length: f64) -> Result<f64, GeomError> {
        let start = self.domain().end();
        let span = self.knots.span_at(start);

        let piece = bezier::piece(&self.knots, &self.control_points, span);
        let far = |&point: &DVec4| homogeneous::place(point).distance(self.end());
        if piece.iter().map(far).fold(0.0, f64::max) <= VANISHING_RELATIVE * self.magnitude() {
            return Err(GeomError::EndOfContinuation { wanted: length, reached: 0.0 });
        }

        // A bracket without a pole.
        let first = start + length / norm(self.velocity_on(span, start)[1]);
        let width = self.knots.span_interval(span).length();
        let mut step = if first.is_finite() { (first - start).min(width) } else { width };
        let (mut low, mut high, mut pole) = (start, None, f64::INFINITY);
        // The length to `low`, so that each step measures what it adds.
        let mut known = 0.0;
        if first <= start {
            return Ok(start);
        }
        for _ in 0..MAX_STEPS {
            let t = if pole.is_finite() { 0.5 * (low + pole) } else { start + step };
            if self.continued_to(t).is_err() {
                pole = t;
            } else {
                let more = self.length_beyond(low, t);
                if length <= known + more {
                    high = Some(t);
                    break;
                }
                (low, known) = (t, known + more);
                step *= 2.0;
            }
            if libm::ldexp(width, MAX_DOUBLINGS as i32) < step {
                break;
            }
        }
        match high {
            Some(high) => Ok(self.reached(length, [low, high], known, first)),
            None => Err(GeomError::EndOfContinuation { wanted: length, reached: known }),
        }
    }

    /// The parameter of a length inside of a bracket, at whose start it is `known`: Newton's method
    /// from `first`, with halves where it leaves the bracket.
    fn reached(&self, length: f64, bracket: [f64; 2], mut known: f64, first: f64) -> f64 {
        let [mut low, mut high] = bracket;
        let span = self.knots.span_at(self.domain().end());
        let mut t = if low < first && first <= high { first } else { high };
        for _ in 0..MAX_STEPS {
            let more = self.length_beyond(low, t);
            let missing = length - known - more;
            if missing.abs() <= LENGTH_RELATIVE * length {
                break;
            }
            if 0.0 < missing {
                (low, known) = (t, known + more);
            } else {
                high = t;
            }
            let next = t + missing / norm(self.velocity_on(span, t)[1]);
            let next = if low < next && next < high { next } else { 0.5 * (low + high) };
            if (next - t).abs() <= LAST_BIT * t.abs() {
                break;
            }
            t = next;
        }
        t
    }

    /// The length of the last piece between two parameters.
    fn length_beyond(&self, from: f64, to: f64) -> f64 {
        Interval::new(from, to).map_or(0.0, |part| self.length_of_piece(part))
    }
}
