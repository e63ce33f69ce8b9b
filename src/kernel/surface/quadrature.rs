//! Integrals over a surface, piece by piece, to nearly all digits.
//!
//! The tensor rule of Gauss and Legendre with 8 × 8 nodes is exact where the integrand is a
//! polynomial of degree 15 in each parameter, as it is for volumes of bicubic patches. Each cell
//! is compared with its four quarters, and the cell that changes most is cut next.

use std::{cmp::Ordering, collections::BinaryHeap};

use glam::DVec3;

use super::Surface;
use crate::kernel::{
    GeomError, Interval,
    tolerance::{LAST_BIT, QUADRATURE_RELATIVE},
};

/// Positive nodes on −1..1 and weights of the Gauss-Legendre rule with 8 nodes.
///
/// Abramowitz & Stegun, *Handbook of Mathematical Functions*, Table 25.4.
const GAUSS_8: [[f64; 2]; 4] = [
    [0.183_434_642_495_649_8, 0.362_683_783_378_362],
    [0.525_532_409_916_329, 0.313_706_645_877_887_3],
    [0.796_666_477_413_626_7, 0.222_381_034_453_374_5],
    [0.960_289_856_497_536_3, 0.101_228_536_290_376_3],
];

/// Even parts of each domain of a function, which has no knots, that are looked at first.
const FUNCTION_PARTS: usize = 4;

/// Cuts beyond which an integral has the accuracy that it has: only a surface with folds or edges
/// inside of a piece comes here.
const MAX_CUTS: usize = 1000;
const MAX_FUNCTION_CUTS: usize = 200;

/// An integral of several quantities.
#[derive(Clone, Copy, Debug)]
pub(super) struct Integral<const N: usize> {
    pub(super) values: [f64; N],
    /// What is known of the error, as a fraction of the integral of the absolute values; the
    /// largest of all quantities.
    pub(super) relative_error: f64,
}

/// A rectangle of parameters.
#[derive(Clone, Copy, Debug)]
struct Cell {
    u: Interval,
    v: Interval,
}

/// A cell with its integral by quarters, and by how much that differs from that by the whole.
struct Known<const N: usize> {
    cell: Cell,
    quarters: [[f64; N]; 4],
    changes: [f64; N],
    /// The largest change as a fraction of what is allowed.
    urgency: f64,
}

/// The integral over du·dv of quantities that depend on a point and on Su × Sv.
///
/// # Errors
/// As [`Surface::point_at`].
pub(super) fn integral<const N: usize>(
    surface: &Surface,
    density: impl Fn(DVec3, DVec3) -> [f64; N],
) -> Result<Integral<N>, GeomError> {
    let rule = |cell: Cell| quadrature(surface, cell, &density);
    let mut estimates = Vec::new();
    let mut sizes = [0.0_f64; N];
    for cell in cells(surface) {
        let (values, absolute) = rule(cell)?;
        estimates.push((cell, values));
        sizes.iter_mut().zip(absolute).for_each(|(sum, size)| *sum += size);
    }
    let allowed = sizes.map(|size| QUADRATURE_RELATIVE * size + f64::MIN_POSITIVE);
    let known = |cell: Cell, estimate: [f64; N]| -> Result<Known<N>, GeomError> {
        let mut quarters = [[0.0; N]; 4];
        let mut changes = estimate.map(|value| -value);
        for (quarter, values) in cell.quarters().into_iter().zip(&mut quarters) {
            *values = rule(quarter)?.0;
            changes.iter_mut().zip(*values).for_each(|(change, value)| *change += value);
        }
        let changes = changes.map(f64::abs);
        let urgency = changes.iter().zip(allowed).map(|(change, allowed)| change / allowed);
        Ok(Known { cell, quarters, changes, urgency: urgency.fold(0.0, f64::max) })
    };
    let mut heap = BinaryHeap::new();
    let mut changes = [0.0_f64; N];
    for (cell, estimate) in estimates {
        let known = known(cell, estimate)?;
        changes.iter_mut().zip(known.changes).for_each(|(sum, change)| *sum += change);
        heap.push(known);
    }
    let most = match surface {
        Surface::Nurbs(_) => MAX_CUTS,
        Surface::Parametric(_) => MAX_FUNCTION_CUTS,
    };
    for _ in 0..most {
        let is_done = changes.iter().zip(allowed).all(|(&change, allowed)| change <= allowed);
        let Some(worst) = (if is_done { None } else { heap.pop() }) else { break };
        for (quarter, values) in worst.cell.quarters().into_iter().zip(worst.quarters) {
            let known = known(quarter, values)?;
            changes.iter_mut().zip(known.changes).for_each(|(sum, change)| *sum += change);
            heap.push(known);
        }
        changes.iter_mut().zip(worst.changes).for_each(|(sum, change)| *sum -= change);
    }
    let mut values = [0.0; N];
    for known in heap.into_sorted_vec() {
        for quarter in known.quarters {
            values.iter_mut().zip(quarter).for_each(|(sum, value)| *sum += value);
        }
    }
    let errors =
        changes.iter().zip(sizes).map(|(change, size)| change.abs() / size.max(f64::MIN_POSITIVE));
    Ok(Integral { values, relative_error: errors.fold(LAST_BIT, f64::max) })
}

/// What the surface is made of, or for a function even parts.
fn cells(surface: &Surface) -> Vec<Cell> {
    let [us, vs]: [Vec<Interval>; 2] = match surface {
        Surface::Nurbs(surface) => [surface.knots_u(), surface.knots_v()]
            .map(|knots| knots.spans().map(|span| knots.span_interval(span)).collect()),
        Surface::Parametric(surface) => [surface.domain_u(), surface.domain_v()].map(|domain| {
            let ends = domain.steps(FUNCTION_PARTS);
            ends.windows(2).filter_map(|ends| Interval::new(ends[0], ends[1]).ok()).collect()
        }),
    };
    us.iter().flat_map(|&u| vs.iter().map(move |&v| Cell { u, v })).collect()
}

/// The rule on one cell, of the quantities and of their absolute values.
///
/// What is added up is the difference from the middle of the cell, so that what does not change
/// has its exact integral.
fn quadrature<const N: usize>(
    surface: &Surface,
    cell: Cell,
    density: &impl Fn(DVec3, DVec3) -> [f64; N],
) -> Result<([f64; N], [f64; N]), GeomError> {
    let at = |u: f64, v: f64| -> Result<[f64; N], GeomError> {
        let [point, along_u, along_v] = surface.tangents_at(u, v)?;
        Ok(density(point, along_u.cross(along_v)))
    };
    let nodes = |interval: Interval| {
        let (middle, half) = (interval.at(0.5), 0.5 * interval.length());
        GAUSS_8.into_iter().flat_map(move |[node, weight]| {
            [(middle - half * node, 0.5 * weight), (middle + half * node, 0.5 * weight)]
        })
    };
    let middle = at(cell.u.at(0.5), cell.v.at(0.5))?;
    let (mut means, mut absolute) = ([0.0; N], [0.0; N]);
    for (u, weight_u) in nodes(cell.u) {
        for (v, weight_v) in nodes(cell.v) {
            let weight = weight_u * weight_v;
            for (i, value) in at(u, v)?.into_iter().enumerate() {
                means[i] += weight * (value - middle[i]);
                absolute[i] += weight * value.abs();
            }
        }
    }
    means.iter_mut().zip(middle).for_each(|(mean, value)| *mean += value);
    let size = cell.u.length() * cell.v.length();
    Ok((means.map(|mean| mean * size), absolute.map(|mean| mean * size)))
}

impl Cell {
    fn quarters(self) -> [Self; 4] {
        let ([u0, u1], [v0, v1]) = (self.u.halves(), self.v.halves());
        [(u0, v0), (u0, v1), (u1, v0), (u1, v1)].map(|(u, v)| Self { u, v })
    }
}

/// Ordered by how much they change.
impl<const N: usize> Ord for Known<N> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.urgency.total_cmp(&other.urgency)
    }
}

impl<const N: usize> PartialOrd for Known<N> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<const N: usize> PartialEq for Known<N> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl<const N: usize> Eq for Known<N> {}
