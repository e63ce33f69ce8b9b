//! Splines near points that may slide along them.
//!
//! What a curve misses points by is their distance across it. Where along it they are is free, so
//! that only the part of an error across the curve is made least: Gauss and Newton's step towards
//! the nearest curve, parameters and all, where fits at fixed parameters in turn with corrections
//! of the parameters take hundreds of rounds. Wang, Pottmann & Liu, *Fitting B-spline curves to
//! point clouds by curvature-based squared distance minimization*, ACM TOG 25 (2006), §3 (tangent
//! distance).

use glam::{DMat3, DVec3};

use crate::{NurbsCurve, numeric::symmetric_band::SymmetricBand};

/// The control points of the spline over the knots of a polynomial curve, from its first to its
/// last control point, which comes nearest to the points across the directions that the curve has
/// at the parameters; of the square of an error along them only the share `along` counts. `None` if
/// rounding leaves none.
///
/// Normal equations in a band: O(n·p²) for n points and O(m·p²) for m control points.
pub(super) fn slid(
    curve: &NurbsCurve,
    parameters: &[f64],
    points: &[DVec3],
    along: f64,
) -> Option<Vec<DVec3>> {
    let (knots, found) = (curve.knots(), curve.evaluator());
    let old: Vec<DVec3> = curve.control_points().iter().map(|point| point.truncate()).collect();
    let n_inner = old.len().checked_sub(2)?;
    let mut band = SymmetricBand::new(3 * n_inner, 3 * (knots.degree() + 1));
    let mut steps = vec![0.0; 3 * n_inner];
    for (&t, &point) in parameters.iter().zip(points) {
        let [value, velocity, _] = found.second_order_at(t);
        let direction = velocity.try_normalize().unwrap_or(DVec3::ZERO);
        let onto = DMat3::from_cols(
            direction * direction.x,
            direction * direction.y,
            direction * direction.z,
        );
        let counts = DMat3::IDENTITY - (1.0 - along) * onto;
        let missing = counts * (point - value);
        knots.with_basis(t, |span, shares| {
            let first = span - knots.degree();
            // The first and the last control point stay.
            let inner = |j: usize| (first + j).checked_sub(1).filter(|&i| i < n_inner);
            for (j, &share) in shares.iter().enumerate() {
                let Some(row) = inner(j) else { continue };
                for axis in 0..3 {
                    steps[3 * row + axis] += share * missing[axis];
                }
                for (k, &other) in shares.iter().enumerate().skip(j) {
                    if let Some(column) = inner(k) {
                        band.add(3 * row, 3 * column, share * other * counts);
                    }
                }
            }
        });
    }
    band.solve(&mut steps)?;
    let mut points = old;
    for (point, step) in points[1..].iter_mut().zip(steps.chunks_exact(3)) {
        *point += DVec3::from_slice(step);
    }
    points.iter().all(|point| point.is_finite()).then_some(points)
}
