//! A spline near a function: quintic pieces with its exact points and derivatives at their ends.

use glam::DVec3;

use super::{NurbsCurve, ParametricCurve, join};
use crate::kernel::{GeomError, Interval};

/// Places of a piece at which its distance from the function is measured.
const N_PLACES: usize = 16;

/// Part of the tolerance that a piece may use up at those places, so that it holds between them.
const SAFETY: f64 = 0.5;

/// Pieces that a function may take.
const MAX_PIECES: usize = 4096;

impl ParametricCurve {
    /// A quintic spline on the same domain whose points are within `tolerance` of the function's
    /// at the same parameters; C2, and with the function's point, first and second derivative at
    /// each knot.
    ///
    /// Hermite interpolation, whose error falls with the sixth power of a piece's width; a piece
    /// is halved until half of the tolerance holds at 16 places of it.
    /// de Boor, *A Practical Guide to Splines*, ch. I.
    ///
    /// # Errors
    /// [`GeomError::NoSplineNear`] where 4096 pieces do not suffice; and where the function has
    /// no second derivative, as [`Self::derivatives_at`].
    pub fn to_nurbs(&self, tolerance: f64) -> Result<NurbsCurve, GeomError> {
        let mut pieces = Vec::new();
        let mut todo = vec![self.domain()];
        while let Some(part) = todo.pop() {
            let piece = self.quintic(part)?;
            if self.is_near(&piece, SAFETY * tolerance)? {
                pieces.push(piece);
            } else if MAX_PIECES <= pieces.len() + todo.len() {
                return Err(GeomError::NoSplineNear { tolerance, parameter: part.start() });
            } else {
                let [before, behind] = part.halves();
                todo.extend([behind, before]);
            }
        }
        match pieces.len() {
            1 => Ok(pieces.swap_remove(0)),
            _ => join(&pieces, tolerance).map(|curve| curve.reparametrized(self.domain())),
        }
    }

    /// The quintic with the function's derivatives up to the second at both ends.
    fn quintic(&self, part: Interval) -> Result<NurbsCurve, GeomError> {
        let (h, start) = (part.length(), self.derivatives_at(part.start(), 2)?);
        let end = self.derivatives_at(part.end(), 2)?;
        let [p, q] = [start[0], end[0]];
        let points: [DVec3; 6] = [
            p,
            p + start[1] * (h / 5.0),
            p + start[1] * (2.0 * h / 5.0) + start[2] * (h * h / 20.0),
            q - end[1] * (2.0 * h / 5.0) + end[2] * (h * h / 20.0),
            q - end[1] * (h / 5.0),
            q,
        ];
        NurbsCurve::bezier(&points).map(|piece| piece.reparametrized(part))
    }

    fn is_near(&self, piece: &NurbsCurve, allowed: f64) -> Result<bool, GeomError> {
        for i in 0..N_PLACES {
            // No place at an end, where both agree, nor at the middle alone.
            let t = piece.domain().at((i as f64 + 0.5) / N_PLACES as f64);
            if allowed < self.point_at(t)?.distance(piece.point_at(t)) {
                return Ok(false);
            }
        }
        Ok(true)
    }
}
