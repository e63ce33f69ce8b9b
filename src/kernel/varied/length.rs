//! The length of a curve whose control points depend on variables.

use glam::{DVec3, DVec4};

use super::{CurvePoint, VariedCurve};
use crate::{
    GeomError, Interval, Jet, LocalError,
    numeric::{integral::find_integral, integral_error::IntegralError},
    tolerance::{GRADIENT_RELATIVE, LAST_BIT},
};

impl VariedCurve {
    /// The arc length over an interval of the domain, with its slopes.
    ///
    /// Those are integrals of T·dC', found by control point and piece by piece.
    ///
    /// # Errors
    /// [`LocalError::NotDifferentiable`] where the curve stands still.
    pub fn length(&self, interval: Interval) -> Result<Jet, GeomError> {
        let curve = self.curve();
        let mut gradient = vec![DVec4::ZERO; curve.control_points().len()];
        if !self.slopes().by_variable().is_empty() {
            for piece in curve.smooth_pieces(interval, LAST_BIT * curve.magnitude()) {
                self.add_length_gradient(piece, &mut gradient)?;
            }
        }
        Jet::with_slopes(curve.length(interval), &self.slopes().through(&gradient))
    }

    /// Adds the gradient of the length of a part of one span, by its acting control points.
    fn add_length_gradient(
        &self,
        piece: Interval,
        gradient: &mut [DVec4],
    ) -> Result<(), GeomError> {
        let knots = self.curve().knots();
        let span = knots.span_at(piece.at(0.5));
        let density = |t: f64| self.length_density(span, t);
        let ends = [piece.start(), piece.end()];
        let found =
            find_integral(density, ends, GRADIENT_RELATIVE, 0.0).map_err(|error| match error {
                IntegralError::Function(error) => error,
                IntegralError::Unsettled { at, .. } => no_derivative(at),
            })?;
        for (sum, part) in gradient[knots.support(span)].iter_mut().zip(found.value.chunks_exact(4))
        {
            *sum += DVec4::from_slice(part);
        }
        Ok(())
    }

    /// The gradient of the speed by the control points that act on a span, one behind the other.
    fn length_density(&self, span: usize, t: f64) -> Result<Vec<f64>, GeomError> {
        let knots = self.curve().knots();
        let points = &self.curve().control_points()[knots.support(span)];
        knots.with_slopes(span, t, |values, slopes| {
            let CurvePoint { value, along, place, velocity } =
                CurvePoint::new(points, values, slopes);
            let speed = velocity.length();
            if speed <= LAST_BIT * (along.truncate() / value.w).length() {
                return Err(no_derivative(t));
            }
            let tangent: DVec3 = velocity / speed;
            let mut gradient = Vec::with_capacity(4 * values.len());
            for (&n, &dn) in values.iter().zip(slopes) {
                // T·dC' of a control point that moves, C' = (A' − C·w')/w.
                let by_point = tangent * ((dn - n * along.w / value.w) / value.w);
                let by_weight = -place.dot(by_point) - n / value.w * speed;
                gradient.extend(by_point.extend(by_weight).to_array());
            }
            Ok(gradient)
        })
    }
}

fn no_derivative(at: f64) -> GeomError {
    GeomError::Local(LocalError::NotDifferentiable { what: "the length", at })
}
