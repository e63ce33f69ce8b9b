//! Places by arc length.

use glam::DVec3;

use crate::{
    DomainError, GeomError, Interval,
    ceiling::{LENGTH_STEPS, QUICK_LENGTH_STEPS},
    curve::NurbsCurve,
    numeric::{
        gauss_legendre::{self, SIXTEEN_NODES},
        newton::{NewtonStep, within_bracket, within_limits},
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

impl NurbsCurve {
    /// What tells parameters by fractions of the length.
    pub(crate) fn arc_lengths(&self) -> ArcLengths {
        let mut parts = Vec::new();
        let mut total = 0.0;
        for piece in self.smooth_pieces(self.domain(), LAST_BIT * self.magnitude()) {
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

    /// The parameter at a fraction of the length: Newton's method from linear interpolation.
    pub(crate) fn at_fraction(&self, lengths: &ArcLengths, fraction: f64) -> f64 {
        let length = fraction * lengths.total;
        let behind = lengths.parts.partition_point(|&(_, before)| before <= length);
        let Some(&(part, before)) = lengths.parts.get(behind.saturating_sub(1)) else {
            return self.domain().start();
        };
        let whole = lengths.parts.get(behind).map_or(lengths.total, |&(_, length)| length) - before;
        let speed = self.speed_on(part);
        let start = part.at(((length - before) / whole).clamp(0.0, 1.0));
        let limits = [part.start(), part.end()];
        let found = within_limits(
            [limits],
            [start],
            QUICK_LENGTH_STEPS,
            |_, _| false,
            |[t]| {
                let excess = before + self.length_by_one_rule(part, t) - length;
                let step = -excess / speed(t);
                match step.is_nan() || excess.abs() <= LENGTH_RELATIVE * lengths.total {
                    true => NewtonStep::Stay,
                    false => NewtonStep::By([step]),
                }
            },
        );
        found.place()[0]
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
        let inner =
            (1..n_parts).map(|i| self.at_length(&pieces, total * i as f64 / n_parts as f64));
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
