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
    let mut sums = SpanSums::new(knots.degree() + 1);
    let (mut span, mut pairs) = (knots.degree(), parameters.iter().zip(points));
    found.each_second_order(parameters, |[value, velocity, _]| {
        let Some((&t, &point)) = pairs.next() else { return };
        let direction = velocity.try_normalize().unwrap_or(DVec3::ZERO);
        let counts = PointCounts { direction, less: 1.0 - along };
        let own = knots.span_from(span, t);
        if own != span {
            sums.move_into(span - knots.degree(), n_inner, &mut band, &mut steps);
            span = own;
        }
        knots.with_basis_on(span, t, |shares| sums.add(shares, counts, point - value));
    });
    sums.move_into(span - knots.degree(), n_inner, &mut band, &mut steps);
    band.solve(&mut steps)?;
    let mut points = old;
    for (point, step) in points[1..].iter_mut().zip(steps.chunks_exact(3)) {
        *point += DVec3::from_slice(step);
    }
    points.iter().all(|point| point.is_finite()).then_some(points)
}

/// Control points that act on a span of a cubic, and pairs of them: numbers that the compiler knows make loops faster.
const CUBIC: usize = 4;
const CUBIC_PAIRS: usize = CUBIC * (CUBIC + 1) / 2;

/// How much an error counts by its direction: whole, and so much less along one.
#[derive(Clone, Copy)]
struct PointCounts {
    direction: DVec3,
    less: f64,
}

impl PointCounts {
    /// Adds to the sums of control points what they share of an error.
    #[inline(always)]
    fn share_out(
        self,
        missing: DVec3,
        shares: &[f64],
        blocks: &mut [[f64; 6]],
        steps: &mut [DVec3],
    ) {
        let Self { direction, less } = self;
        let DVec3 { x, y, z } = direction;
        let [lx, ly, lz] = [less * x, less * y, less * z];
        let counts = [1.0 - lx * x, -lx * y, -lx * z, 1.0 - ly * y, -ly * z, 1.0 - lz * z];
        let missing = missing - less * missing.dot(direction) * direction;
        let mut blocks = blocks.iter_mut();
        for (j, (&share, step)) in shares.iter().zip(steps).enumerate() {
            *step += share * missing;
            for (&other, block) in shares[j..].iter().zip(&mut blocks) {
                let both = share * other;
                for (sum, count) in block.iter_mut().zip(counts) {
                    *sum += both * count;
                }
            }
        }
    }
}

/// The sums that the points over a span add to the equations: of the control points that act there,
/// the first row by row.
struct SpanSums {
    /// A symmetric block for each pair of control points: xx, xy, xz, yy, yz, zz.
    blocks: Vec<[f64; 6]>,
    steps: Vec<DVec3>,
}

impl SpanSums {
    fn new(n: usize) -> Self {
        Self { blocks: vec![[0.0; 6]; n * (n + 1) / 2], steps: vec![DVec3::ZERO; n] }
    }

    fn add(&mut self, shares: &[f64], counts: PointCounts, missing: DVec3) {
        let (blocks, steps) = (&mut self.blocks[..], &mut self.steps[..]);
        let cubic = <&[f64; CUBIC]>::try_from(shares).ok();
        match (cubic, blocks.first_chunk_mut::<CUBIC_PAIRS>(), steps.first_chunk_mut::<CUBIC>()) {
            (Some(shares), Some(blocks), Some(steps)) => {
                counts.share_out(missing, shares, blocks, steps);
            }
            _ => counts.share_out(missing, shares, blocks, steps),
        }
    }

    /// Adds the sums to the equations of the inner control points; the first and the last stay. Begins
    /// anew.
    fn move_into(
        &mut self,
        first: usize,
        n_inner: usize,
        band: &mut SymmetricBand,
        to: &mut [f64],
    ) {
        let inner = |j: usize| (first + j).checked_sub(1).filter(|&i| i < n_inner);
        let n = self.steps.len();
        let mut blocks = self.blocks.iter_mut();
        for (j, step) in self.steps.iter_mut().enumerate() {
            let (row, step) = (inner(j), std::mem::take(step));
            if let Some(row) = row {
                to[3 * row..][..3].iter_mut().zip(step.to_array()).for_each(|(to, x)| *to += x);
            }
            for (k, block) in (j..n).zip(&mut blocks) {
                let [xx, xy, xz, yy, yz, zz] = std::mem::take(block);
                if let (Some(row), Some(column)) = (row, inner(k)) {
                    let block = DMat3::from_cols_array(&[xx, xy, xz, xy, yy, yz, xz, yz, zz]);
                    band.add(3 * row, 3 * column, block);
                }
            }
        }
    }
}
