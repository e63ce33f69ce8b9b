//! Rational patches whose weights differ much, as patches whose weights differ little.
//!
//! Where one weight is a billion times another nearly all of a patch lies over so small a part of
//! its domain that no sample falls there. Weights wᵢ·αⁱ give the same points at other parameters:
//! with them the ends of a patch weigh the same. What is left is cut in halves, each on a domain
//! of its own, until the weights of each are alike, so that its points are spread over its domain.
//! Farin, *Curves and Surfaces for CAGD*, §13.6.

use glam::DVec4;

use crate::{
    Grid, KnotVector, bezier,
    ceiling::PIECES,
    surface::{Direction, NurbsSurface},
};

/// Weights of a patch that differ by no larger factor are alike: derivatives along it differ by no
/// more than the square of that.
const ALIKE: f64 = 32.0;

/// The patches that a surface consists of, on domains of their own and with weights that are
/// alike; `None` where the weights of the surface are alike as they are.
pub(in crate::surface) fn evened(surface: &NurbsSurface) -> Option<Vec<NurbsSurface>> {
    if ratio(surface.control_points().iter()) <= ALIKE {
        return None;
    }
    let knots_u = KnotVector::bezier(surface.degree_u()).ok()?;
    let knots_v = KnotVector::bezier(surface.degree_v()).ok()?;
    let patches = surface.decompose();
    let mut open: Vec<Grid<DVec4>> =
        patches.iter().map(|patch| balanced(patch.control_points())).collect();
    let mut even = Vec::new();
    while let Some(net) = open.pop() {
        let lines = |net: &Grid<DVec4>| {
            (0..net.n_rows()).map(|i| ratio(net.row(i).iter())).fold(1.0, f64::max)
        };
        let (along_u, along_v) = (lines(&net.transposed()), lines(&net));
        let is_full = PIECES <= open.len() + even.len();
        if along_u.max(along_v) <= ALIKE || is_full {
            even.push(NurbsSurface::new_unchecked(knots_u.clone(), knots_v.clone(), net));
            continue;
        }
        let along = if along_u < along_v { Direction::V } else { Direction::U };
        open.extend(halves(&net, along));
    }
    Some(even)
}

/// The largest weight in units of the smallest.
fn ratio<'a>(points: impl Iterator<Item = &'a DVec4>) -> f64 {
    let range = (f64::INFINITY, f64::NEG_INFINITY);
    let (low, high) = points.fold(range, |(a, b), point| (a.min(point.w), b.max(point.w)));
    if 0.0 < low { high / low } else { f64::INFINITY }
}

/// The net with rows and columns scaled so that opposite edges weigh the same on average.
fn balanced(net: &Grid<DVec4>) -> Grid<DVec4> {
    let (n, m) = (net.n_rows() - 1, net.n_columns() - 1);
    let step = |from: &[DVec4], to: &[DVec4], degree: usize| -> f64 {
        let sum: f64 = from.iter().zip(to).map(|(a, b)| libm::log(a.w / b.w)).sum();
        if sum.is_finite() { sum / (from.len() * degree.max(1)) as f64 } else { 0.0 }
    };
    let along_u = step(net.row(0), net.row(n), n);
    let along_v = step(&net.column(0), &net.column(m), m);
    Grid::from_fn(n + 1, m + 1, |i, j| {
        net.get(i, j) * libm::exp(along_u * i as f64 + along_v * j as f64)
    })
}

fn halves(net: &Grid<DVec4>, along: Direction) -> [Grid<DVec4>; 2] {
    let rows = if along == Direction::U { net.transposed() } else { net.clone() };
    let cut: Vec<[Vec<DVec4>; 2]> =
        (0..rows.n_rows()).map(|i| bezier::cut_at(rows.row(i), 0.5).into()).collect();
    [0, 1].map(|half| {
        let half = Grid::from_fn(rows.n_rows(), rows.n_columns(), |i, j| cut[i][half][j]);
        if along == Direction::U { half.transposed() } else { half }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_weight_is_told_in_units_of_the_smallest() {
        let of = |weights: &[f64]| {
            let points: Vec<DVec4> =
                weights.iter().map(|&w| DVec4::new(3.0, -2.0, 9.0, w)).collect();
            ratio(points.iter())
        };
        assert!((of(&[2.0, 9.0, 4.0]) - 4.5).abs() < 1e-15);
        assert!((of(&[5.0, 5.0]) - 1.0).abs() < 1e-15);
        assert!(of(&[1.0, 0.0]).is_infinite() && of(&[1.0, -1.0]).is_infinite());
    }

    #[test]
    fn a_balanced_net_has_opposite_edges_of_one_weight() {
        let weight = |i: usize, j: usize| libm::exp(0.7 * i as f64 - 0.2 * j as f64);
        let net = Grid::from_fn(3, 4, |i, j| DVec4::new(1.0, 2.0, 3.0, 1.0) * weight(i, j));
        let balanced = balanced(&net);
        for (found, given) in balanced.iter().zip(net.iter()) {
            assert!((found.w - balanced.get(0, 0).w).abs() < 1e-12, "{found}");
            assert!((*found / found.w - *given / given.w).length() < 1e-12);
        }
    }
}
