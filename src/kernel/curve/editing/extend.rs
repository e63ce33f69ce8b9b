//! A curve that goes on beyond its end.

use glam::{DAffine3, DMat3, DVec3, DVec4};

use crate::{
    ConstructionError, ConstructionReport, GeomError, InputError, Interval, WeightError, bezier,
    ceiling::{LENGTH_PIECES, PIECES, PROLONGATION_DOUBLINGS, PROLONGATION_STEPS, WEIGHT_HALVINGS},
    curve::{AnalyticCurve, NurbsCurve, join, measurement::measure::integral},
    frame::norm,
    homogeneous,
    numeric::newton::within_bracket,
    tolerance::{LAST_BIT, LENGTH_RELATIVE, PLACE_RELATIVE, VANISHING_RELATIVE},
};

impl NurbsCurve {
    /// The curve with its last polynomial piece going on until it is longer by `length`, on a
    /// domain that grows at its end.
    ///
    /// The piece stays one piece unless its weights would not stay positive. An arc of a circle that
    /// is to go on further than its polynomials reach, which is to the middle of what is missing
    /// from its circle, is repeated around the circle instead. Exact but for the
    /// parameter where the length is reached, which is found to 1e-13 of it.
    ///
    /// # Errors
    /// [`InputError::NotPositive`] for a length; [`ConstructionError::EndOfContinuation`] where no parameter
    /// has it; [`ConstructionError::ContinuationLost`] where rounding leaves no digits.
    pub fn extended(&self, length: f64) -> Result<Self, GeomError> {
        if !(length.is_finite() && 0.0 < length) {
            return Err(InputError::NotPositive { what: "the length", got: length }.into());
        }
        let clamped = self.clamped();
        let end = match clamped.parameter_beyond(length) {
            // No parameter of an arc's polynomials reaches around what is missing from its circle.
            Err(missed) => return clamped.turned_on(length)?.ok_or(missed),
            Ok(end) => end,
        };
        if end <= clamped.domain().end() {
            // The length is rounding.
            return Ok(clamped);
        }
        let longer = clamped.continued_to(end)?.with_positive_weights()?;
        // Far away the points of a high degree are large, and their differences rounding.
        let off = norm(longer.end() - clamped.beyond().point(end));
        if off.is_nan() || PLACE_RELATIVE * (length + clamped.magnitude()) < off {
            return Err(
                ConstructionError::ContinuationLost { degree: clamped.degree(), length }.into()
            );
        }
        Ok(longer)
    }

    /// The clamped curve with its last piece, an arc of a circle, repeated around the circle until
    /// it is longer by `length`; `None` if that is none, or would take too many.
    fn turned_on(&self, length: f64) -> Result<Option<Self>, GeomError> {
        let last = self.knots.span_interval(self.knots.span_at(self.domain().end()));
        let piece = self.trimmed(last)?;
        let Some(AnalyticCurve::Circle { frame, radius, turn }) = piece.analytic() else {
            return Ok(None);
        };
        let n_whole = (length / (radius * turn)).floor();
        if (PIECES as f64) < n_whole {
            return Ok(None);
        }
        let n_whole = n_whole as usize;
        let copy = |k: usize| {
            let around = DMat3::from_axis_angle(frame.z(), turn * (k + 1) as f64);
            let centre = frame.origin();
            piece.transformed(&DAffine3::from_mat3_translation(around, centre - around * centre))
        };
        let mut pieces: Vec<Self> =
            [self.clone()].into_iter().chain((0..n_whole).map(copy)).collect();
        let rest = length - n_whole as f64 * radius * turn;
        let next = copy(n_whole);
        let t = next.parameter_at_length(rest.clamp(0.0, radius * turn))?;
        // Nothing, where the length is a whole number of arcs.
        pieces.extend(Interval::new(last.start(), t).and_then(|part| next.trimmed(part)).ok());
        let widths = pieces.iter().map(|piece| piece.domain().length()).sum::<f64>();
        let start = self.domain().start();
        let joined = match &pieces[..] {
            [only] => only.clone(),
            _ => join(&pieces, PLACE_RELATIVE * (length + self.magnitude()))?,
        };
        Ok(Some(joined.reparametrized(Interval::new(start, start + widths)?)))
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
        Self { knots, control_points, report: ConstructionReport::NONE, ..self.clone() }
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
            let own = bezier::blossom(&self.knots, &self.control_points, span, arguments);
            // Equal weights stay equal, whatever rounding says far away.
            *point = if self.is_rational { own } else { own.truncate().extend(point.w) };
        }
        Self::new(knots, points)
    }

    /// More knots in the last span, until no weight is below zero.
    fn with_positive_weights(self) -> Result<Self, GeomError> {
        let span = self.knots.span_interval(self.knots.span_at(self.domain().end()));
        let mut curve = self;
        for _ in 0..WEIGHT_HALVINGS {
            if curve.control_points.iter().all(|point| 0.0 < point.w) {
                return Ok(curve);
            }
            let of_span = |&i: &usize| span.start() <= curve.knots.span_interval(i).start();
            let middle = |i: usize| curve.knots.span_interval(i).at(0.5);
            let middles: Vec<f64> = curve.knots.spans().filter(of_span).map(middle).collect();
            curve = curve.insert_knots(&middles)?;
        }
        Err(GeomError::Weights(WeightError::VanishingWeights { parameter: span.end() }))
    }

    /// The parameter behind the domain where the last piece, going on, has the given length.
    fn parameter_beyond(&self, length: f64) -> Result<f64, GeomError> {
        let start = self.domain().end();
        let span = self.knots.span_at(start);

        let piece = bezier::piece(&self.knots, &self.control_points, span);
        let far = |&point: &DVec4| homogeneous::place(point).distance(self.end());
        if piece.iter().map(far).fold(0.0, f64::max) <= VANISHING_RELATIVE * self.magnitude() {
            return Err(
                ConstructionError::EndOfContinuation { wanted: length, reached: 0.0 }.into()
            );
        }

        // A bracket without a pole.
        let beyond = self.beyond();
        let first = start + length / beyond.speed(start);
        let width = self.knots.span_interval(span).length();
        let mut step = if first.is_finite() { (first - start).min(width) } else { width };
        let (mut low, mut high, mut pole) = (start, None, f64::INFINITY);
        // The length to `low`, so that each step measures what it adds.
        let mut known = 0.0;
        if first <= start {
            return Ok(start);
        }
        for _ in 0..PROLONGATION_STEPS {
            let t = if pole.is_finite() { 0.5 * (low + pole) } else { start + step };
            // Beyond all numbers there is no parameter.
            let Ok(added) = Interval::new(low, t) else { break };
            if Interval::new(self.domain().start(), t).is_err() {
                break;
            }
            if self.is_rational && self.continued_to(t).is_err() {
                pole = t;
            } else {
                let more = beyond.length(added);
                // Nor is there a length.
                if !more.is_finite() || length <= known + more {
                    high = Some(t);
                    break;
                }
                (low, known) = (t, known + more);
                step *= 2.0;
            }
            if libm::ldexp(width, PROLONGATION_DOUBLINGS[usize::from(self.n_segments() == 1)])
                < step
            {
                break;
            }
        }
        match high {
            Some(high) => Ok(beyond.reached(length, [low, high], known, first)),
            None => Err(GeomError::Construction(ConstructionError::EndOfContinuation {
                wanted: length,
                reached: known,
            })),
        }
    }

    /// The last piece, to be looked at beyond the domain.
    fn beyond(&self) -> EndExtrapolation {
        let start = self.domain().end();
        let span = self.knots.span_at(start);
        let piece = bezier::piece(&self.knots, &self.control_points, span);
        let degree = piece.len() - 1;
        let mut differences: Vec<DVec4> = piece.into_iter().rev().collect();
        let mut coefficients = Vec::with_capacity(degree + 1);
        let mut binomial = 1.0;
        for k in 0..=degree {
            coefficients.push(differences[0] * binomial);
            for j in 0..degree - k {
                let next = differences[j + 1];
                differences[j] -= next;
            }
            binomial *= (degree - k) as f64 / (k + 1) as f64;
        }
        if !self.is_rational {
            coefficients.iter_mut().skip(1).for_each(|term| term.w = 0.0);
        }
        let width = self.knots.span_interval(span).length();
        EndExtrapolation { start, width, coefficients, rounding: LAST_BIT * self.magnitude() }
    }
}

/// A polynomial piece by the powers of how far a parameter is beyond its end, in widths of the
/// piece: all of one sign where it grows, so that it has digits far away.
struct EndExtrapolation {
    start: f64,
    width: f64,
    coefficients: Vec<DVec4>,
    rounding: f64,
}

impl EndExtrapolation {
    fn point(&self, t: f64) -> DVec3 {
        let s = (t - self.start) / self.width;
        let add = |value: DVec4, &term: &DVec4| value * s + term;
        homogeneous::project(self.coefficients.iter().rev().fold(DVec4::ZERO, add))
    }

    fn speed(&self, t: f64) -> f64 {
        let s = (t - self.start) / self.width;
        let (mut value, mut slope) = (DVec4::ZERO, DVec4::ZERO);
        for &term in self.coefficients.iter().rev() {
            slope = slope * s + value;
            value = value * s + term;
        }
        let velocity = slope.truncate() - value.truncate() * (slope.w / value.w);
        norm(velocity / value.w) / self.width
    }

    fn length(&self, interval: Interval) -> f64 {
        let degree = self.coefficients.len();
        integral(&|t| self.speed(t), interval, self.rounding, LENGTH_PIECES / (degree * degree))
    }

    /// The parameter of a length inside of a bracket, at whose start it is `known`: Newton's method
    /// from `first`, with halves where it leaves the bracket.
    fn reached(&self, length: f64, bracket: [f64; 2], mut known: f64, first: f64) -> f64 {
        let [mut low, high] = bracket;
        let start = if low < first && first <= high { first } else { high };
        let is_still = |t: f64, next: f64| (next - t).abs() <= LAST_BIT * t.abs();
        within_bracket(bracket, start, PROLONGATION_STEPS, is_still, |t| {
            let more = Interval::new(low, t).map_or(0.0, |part| self.length(part));
            let missing = length - known - more;
            // The next place beyond is measured from here.
            if 0.0 < missing {
                (low, known) = (t, known + more);
            }
            let is_there = missing.abs() <= LENGTH_RELATIVE * length;
            (!is_there).then(|| [-missing, self.speed(t)])
        })
    }
}
