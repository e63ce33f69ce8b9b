//! Places by arc length.

use glam::DVec3;

use crate::{
    DomainError, GeomError, Interval,
    ceiling::{LENGTH_STEPS, QUICK_LENGTH_STEPS},
    curve::NurbsCurve,
    numeric::{
        gauss_legendre::{self, SIXTEEN_NODES},
        newton::{NewtonResult, NewtonStep, within_bracket, within_limits},
    },
    tolerance::{LAST_BIT, LENGTH_RELATIVE},
};

/// The length of a curve from its start at many places, to be asked often.
#[derive(Debug)]
pub(crate) struct ArcLengths {
    /// Parts over which one rule of quadrature is exact to rounding, and the lengths before them.
    parts: Vec<(Interval, f64)>,
    total: f64,
}

impl ArcLengths {
    /// The length of the whole curve.
    pub(crate) fn total(&self) -> f64 {
        self.total
    }
}

/// The parameters of a curve at lengths from its start that only grow.
struct LengthWalk<'a> {
    curve: &'a NurbsCurve,
    /// The polynomial pieces, each with its length.
    pieces: Vec<(Interval, f64)>,
    /// The piece that was come to, and the length before it.
    idx: usize,
    before: f64,
    /// The lengths of that one, once a place in it was asked for; of no parts where one rule does not tell them.
    lengths: Option<ArcLengths>,
}

impl LengthWalk<'_> {
    /// The parameter at a length no less than that asked before.
    fn at(&mut self, length: f64) -> f64 {
        while let Some(&(piece, piece_length)) = self.pieces.get(self.idx) {
            let left = length - self.before;
            if left <= piece_length {
                return self.within(piece, piece_length, left);
            }
            (self.idx, self.before, self.lengths) =
                (self.idx + 1, self.before + piece_length, None);
        }
        self.curve.domain().end()
    }

    fn within(&mut self, piece: Interval, piece_length: f64, length: f64) -> f64 {
        let lengths = self.lengths.get_or_insert_with(|| {
            let lengths = self.curve.arc_lengths_within(piece);
            let is_told = (lengths.total - piece_length).abs() <= LENGTH_RELATIVE * piece_length;
            // The legs of a polyline are met at once.
            match is_told && 1 < self.curve.degree() {
                true => lengths,
                false => ArcLengths { parts: Vec::new(), total: 0.0 },
            }
        });
        if length <= 0.0 || piece_length <= length {
            return self.curve.at_length_of_piece(piece, piece_length, length);
        }
        let last = |step| NewtonStep::Last([step]);
        match self.curve.at_length_of_parts(lengths, length, last).settled() {
            Some([t]) => t,
            None => self.curve.at_length_of_piece(piece, piece_length, length),
        }
    }
}

impl NurbsCurve {
    /// What tells parameters by fractions of the length.
    pub(crate) fn arc_lengths(&self) -> ArcLengths {
        self.arc_lengths_within(self.domain())
    }

    /// [`Self::arc_lengths`] of a part.
    fn arc_lengths_within(&self, interval: Interval) -> ArcLengths {
        let mut parts = Vec::new();
        let mut total = 0.0;
        for piece in self.smooth_pieces(interval, LAST_BIT * self.magnitude()) {
            for part in piece.halves().into_iter().flat_map(Interval::halves) {
                parts.push((part, total));
                total += self.length_by_one_rule(part, part.end());
            }
        }
        ArcLengths { parts, total }
    }

    /// The length from the start of a part to a parameter in it.
    fn length_by_one_rule(&self, part: Interval, t: f64) -> f64 {
        let span = self.knots().span_at(part.at(0.5));
        Interval::new(part.start(), t).map_or(0.0, |interval| {
            gauss_legendre::integral_of_all(&SIXTEEN_NODES, interval, |nodes, speeds| {
                self.speeds_on(span, nodes, speeds);
            })
        })
    }

    /// The parameter at a fraction of the length.
    pub(crate) fn at_fraction(&self, lengths: &ArcLengths, fraction: f64) -> f64 {
        self.at_length_of_parts(lengths, fraction * lengths.total, |_| NewtonStep::Stay).place()[0]
    }

    /// The parameter at a length: Newton's method from linear interpolation, and what is done with the step that is left
    /// where it is near enough.
    fn at_length_of_parts(
        &self,
        lengths: &ArcLengths,
        length: f64,
        at_end: impl Fn(f64) -> NewtonStep<1>,
    ) -> NewtonResult<1> {
        let behind = lengths.parts.partition_point(|&(_, before)| before <= length);
        let Some(&(part, before)) = lengths.parts.get(behind.saturating_sub(1)) else {
            return NewtonResult::Stuck([self.domain().start()]);
        };
        let whole = lengths.parts.get(behind).map_or(lengths.total, |&(_, length)| length) - before;
        let speed = self.speed_on(part);
        let start = part.at(((length - before) / whole).clamp(0.0, 1.0));
        let limits = [part.start(), part.end()];
        within_limits(
            [limits],
            [start],
            QUICK_LENGTH_STEPS,
            |_, _| false,
            |[t]| {
                let excess = before + self.length_by_one_rule(part, t) - length;
                let step = -excess / speed(t);
                let is_near = excess.abs() <= LENGTH_RELATIVE * lengths.total;
                if step.is_nan() {
                    NewtonStep::Stay
                } else if !is_near {
                    NewtonStep::By([step])
                } else if step.abs() <= LAST_BIT.sqrt() * part.length() {
                    at_end(step)
                } else {
                    // In a cusp, where a step leads anywhere.
                    NewtonStep::Stay
                }
            },
        )
    }

    /// The fraction of the length at a parameter.
    pub(crate) fn fraction_at(&self, lengths: &ArcLengths, t: f64) -> f64 {
        let behind = lengths.parts.partition_point(|(part, _)| part.start() <= t);
        let part = lengths.parts.get(behind.saturating_sub(1));
        part.map_or(0.0, |&(part, before)| {
            (before + self.length_by_one_rule(part, t.min(part.end()))) / lengths.total
        })
    }

    /// The parameter at which the curve is `length` long from its start.
    ///
    /// # Errors
    /// [`DomainError::LengthOutside`] below zero or beyond the whole length.
    pub fn parameter_at_length(&self, length: f64) -> Result<f64, GeomError> {
        if let Some(factor) = self.unit_factor(&[]) {
            let found = self.in_units(factor).parameter_at_length(length * factor);
            return found.map_err(|error| match error {
                GeomError::Domain(DomainError::LengthOutside { total, .. }) => {
                    GeomError::Domain(DomainError::LengthOutside {
                        got: length,
                        total: total / factor,
                    })
                }
                other => other,
            });
        }
        let pieces = self.piece_lengths();
        let total: f64 = pieces.iter().map(|&(_, length)| length).sum();
        let slack = LENGTH_RELATIVE.sqrt() * total;
        if !(-slack..=total + slack).contains(&length) {
            return Err(DomainError::LengthOutside { got: length, total }.into());
        }
        Ok(self.at_length(&pieces, length.clamp(0.0, total)))
    }

    /// The ends of `n_parts` parts of equal length, in order; the first is the curve's start and
    /// the last its end.
    #[must_use]
    pub fn divided(&self, n_parts: usize) -> Vec<DVec3> {
        self.division(n_parts).into_iter().map(|t| self.point_at(t)).collect()
    }

    /// The parameters of the ends of `n_parts` parts of equal length, in order; the first is the
    /// start of the domain and the last its end.
    #[must_use]
    pub fn division(&self, n_parts: usize) -> Vec<f64> {
        if let Some(factor) = self.unit_factor(&[]) {
            return self.in_units(factor).division(n_parts);
        }
        let pieces = self.piece_lengths();
        let total: f64 = pieces.iter().map(|&(_, length)| length).sum();
        let mut walk = LengthWalk { curve: self, pieces, idx: 0, before: 0.0, lengths: None };
        let inner = (1..n_parts).map(|i| walk.at(total * i as f64 / n_parts as f64));
        let domain = self.domain();
        [domain.start()].into_iter().chain(inner).chain([domain.end()]).collect()
    }

    /// Each polynomial piece's interval and length.
    fn piece_lengths(&self) -> Vec<(Interval, f64)> {
        let intervals = self.knots().spans().map(|span| self.knots().span_interval(span));
        let rounding = LAST_BIT * self.magnitude();
        intervals.map(|interval| (interval, self.length_within(interval, rounding))).collect()
    }

    fn at_length(&self, pieces: &[(Interval, f64)], length: f64) -> f64 {
        let mut left = length;
        for &(interval, piece_length) in pieces {
            if left <= piece_length {
                return self.at_length_of_piece(interval, piece_length, left);
            }
            left -= piece_length;
        }
        self.domain().end()
    }

    /// Newton's method on the length from the piece's start, kept inside a bracket.
    fn at_length_of_piece(&self, piece: Interval, piece_length: f64, length: f64) -> f64 {
        if length <= 0.0 {
            return piece.start();
        }
        if piece_length <= length {
            return piece.end();
        }
        let rounding = LAST_BIT * self.magnitude();
        let bracket = [piece.start(), piece.end()];
        let start = piece.at(length / piece_length);
        let is_still = |t: f64, next: f64| t.total_cmp(&next).is_eq();
        within_bracket(bracket, start, LENGTH_STEPS, is_still, |t| {
            let part = Interval::new(piece.start(), t).ok()?;
            let excess = self.length_within(part, rounding) - length;
            let is_there = excess.abs() <= LENGTH_RELATIVE * piece_length;
            (!is_there).then(|| [excess, self.derivatives_at(t, 1)[1].length()])
        })
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use crate::{Interval, KnotVector, NurbsCurve};

    #[test]
    fn the_parts_of_a_division_are_equally_long() {
        let place = |i: i32| {
            let x = f64::from(i);
            DVec3::new(x, 2.0 * libm::sin(1.3 * x), libm::cos(0.7 * x))
        };
        let points: Vec<DVec3> = (0..12).map(place).collect();
        let knots = KnotVector::uniform_clamped(3, 12, 1.0).expect("knots");
        let wave = NurbsCurve::polynomial(knots, &points).expect("a wave");
        // In its second half a cusp, near which one rule tells no length.
        let corners = [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]];
        let cusp =
            NurbsCurve::bezier(&corners.map(|[x, y]| DVec3::new(x, y, 0.0))).expect("a cusp");
        for curve in [wave, cusp] {
            let whole = curve.length(curve.domain());
            for n in [3, 50, 701] {
                let ends = curve.division(n);
                assert_eq!(ends.len(), n + 1);
                for (i, &end) in ends.iter().enumerate().skip(1) {
                    let part = Interval::new(curve.domain().start(), end).expect("a part");
                    let off = (curve.length(part) / whole - i as f64 / n as f64).abs();
                    assert!(off < 4e-13, "{i} of {n}: {off:e}");
                }
            }
        }
    }
}
