//! The length of a curve whose control points depend on variables.

use glam::{DVec3, DVec4};

use super::{CurvePoint, VariedCurve};
use crate::{
    GeomError, Interval, Jet, LocalError,
    numeric::{
        gauss_legendre::{EIGHT_NODES, GaussRule, SIXTEEN_NODES},
        integral::find_integral,
        integral_error::IntegralError,
    },
    tolerance::{GRADIENT_RELATIVE, LAST_BIT},
};

/// Halvings of a piece before its gradient is looked for where it is not smooth: with more the time that they took is
/// lost more often than it is won.
const MOST_HALVINGS: usize = 3;

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
        if !self.slopes().is_fixed() {
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
        let found = match self.length_gradient_by_rules(span, piece)? {
            Some(found) => found,
            None => self.length_gradient_by_pieces(span, piece)?,
        };
        for (sum, part) in gradient[knots.support(span)].iter_mut().zip(found) {
            *sum += part;
        }
        Ok(())
    }

    /// The gradient where two rules agree on it, over the piece or over some halves of it, as they do on nearly every
    /// span; what differs about a jump in the middle, and cancels, is no part of the integral.
    fn length_gradient_by_rules(
        &self,
        span: usize,
        piece: Interval,
    ) -> Result<Option<Vec<DVec4>>, GeomError> {
        let mut sum = vec![DVec4::ZERO; self.curve().degree() + 1];
        let mut allowed = None;
        let mut waiting = vec![([piece.start(), piece.end()], 0)];
        while let Some(([start, end], n_halvings)) = waiting.pop() {
            let (eight, _) = self.length_gradient_by(&EIGHT_NODES, span, [start, end])?;
            let (sixteen, size) = self.length_gradient_by(&SIXTEEN_NODES, span, [start, end])?;
            let allowed = DVec4::splat(*allowed.get_or_insert(GRADIENT_RELATIVE * size));
            if eight.iter().zip(&sixteen).all(|(a, b)| (a - b).abs().cmple(allowed).all()) {
                sum.iter_mut().zip(sixteen).for_each(|(sum, part)| *sum += part);
            } else if n_halvings < MOST_HALVINGS {
                let middle = 0.5 * (start + end);
                waiting.extend([[middle, end], [start, middle]].map(|half| (half, n_halvings + 1)));
            } else {
                return Ok(None);
            }
        }
        Ok(Some(sum))
    }

    /// The gradient by one rule, and the integral of its largest component.
    fn length_gradient_by<const HALF: usize>(
        &self,
        rule: &GaussRule<HALF>,
        span: usize,
        [start, end]: [f64; 2],
    ) -> Result<(Vec<DVec4>, f64), GeomError> {
        let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
        let (mut sum, mut size) = (vec![DVec4::ZERO; self.curve().degree() + 1], 0.0);
        for &[node, weight] in rule {
            for t in [middle - half * node, middle + half * node] {
                let mut most = 0.0_f64;
                self.length_density(span, t, |i, part| {
                    sum[i] += weight * half * part;
                    most = most.max(part.abs().max_element());
                })?;
                size += weight * half * most;
            }
        }
        Ok((sum, size))
    }

    /// The gradient to the accuracy, in as many pieces as that takes.
    fn length_gradient_by_pieces(
        &self,
        span: usize,
        piece: Interval,
    ) -> Result<Vec<DVec4>, GeomError> {
        let density = |t: f64| {
            let mut parts = Vec::with_capacity(4 * (self.curve().degree() + 1));
            self.length_density(span, t, |_, part| parts.extend(part.to_array()))?;
            Ok(parts)
        };
        let ends = [piece.start(), piece.end()];
        let found =
            find_integral(density, ends, GRADIENT_RELATIVE, 0.0).map_err(|error| match error {
                IntegralError::Function(error) => error,
                IntegralError::Unsettled { at, .. } => no_derivative(at),
            })?;
        Ok(found.value.chunks_exact(4).map(DVec4::from_slice).collect())
    }

    /// Tells `each` the gradient of the speed by the control points that act on a span, one after the other.
    fn length_density(
        &self,
        span: usize,
        t: f64,
        mut each: impl FnMut(usize, DVec4),
    ) -> Result<(), GeomError> {
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
            for (i, (&n, &dn)) in values.iter().zip(slopes).enumerate() {
                // T·dC' of a control point that moves, C' = (A' − C·w')/w.
                let by_point = tangent * ((dn - n * along.w / value.w) / value.w);
                let by_weight = -place.dot(by_point) - n / value.w * speed;
                each(i, by_point.extend(by_weight));
            }
            Ok(())
        })
    }
}

fn no_derivative(at: f64) -> GeomError {
    GeomError::Local(LocalError::NotDifferentiable { what: "the length", at })
}
