//! Places by arc length.

use glam::DVec3;

use super::NurbsCurve;
use crate::kernel::{
    GeomError, Interval,
    tolerance::{LAST_BIT, LENGTH_RELATIVE},
};

/// Steps of Newton's method, each halving the bracket where it fails to do better.
const MAX_STEPS: usize = 100;

impl NurbsCurve {
    /// The parameter at which the curve is `length` long from its start.
    ///
    /// # Errors
    /// [`GeomError::LengthOutside`] below zero or beyond the whole length.
    pub fn parameter_at_length(&self, length: f64) -> Result<f64, GeomError> {
        let pieces = self.piece_lengths();
        let total: f64 = pieces.iter().map(|&(_, length)| length).sum();
        let slack = LENGTH_RELATIVE.sqrt() * total;
        if !(-slack..=total + slack).contains(&length) {
            return Err(GeomError::LengthOutside { got: length, total });
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
        let (mut low, mut high) = (piece.start(), piece.end());
        let rounding = LAST_BIT * self.magnitude();
        let mut t = piece.at(length / piece_length);
        for _ in 0..MAX_STEPS {
            let Ok(part) = Interval::new(piece.start(), t) else { return low };
            let excess = self.length_within(part, rounding) - length;
            if excess.abs() <= LENGTH_RELATIVE * piece_length {
                return t;
            }
            if excess < 0.0 {
                low = t;
            } else {
                high = t;
            }
            let speed = self.derivatives_at(t, 1)[1].length();
            let newton = t - excess / speed;
            let middle = 0.5 * (low + high);
            t = if low < newton && newton < high { newton } else { middle };
            if high <= low || t <= low && middle <= low {
                return t;
            }
        }
        t
    }
}
