//! The proof that two surfaces cross in one curve along a spline, and how near it is.
//!
//! For each parameter t the place in which the plane across the spline's chord c meets both surfaces solves
//! F(x; t) = (A(u, v) − B(s, t), (A(u, v) − C(t))·c) = 0. With the parameters p(t) of the spline as its middle,
//! a box ± r about them, and Y near the inverse of the Jacobian J, the operator of Krawczyk
//! K = p − Y F(p; t) + (I − Y J(box)) (± r) leads the box into its inside where |Y F| + |I − Y J| r < r: then each
//! box has exactly one such place, and the places are one smooth arc that the tube holds. F(p; t) is bounded for
//! all t at once by Bernstein coefficients (`piece`), J by the hulls of derivatives over the part of each patch
//! that all boxes are in; ends are moved outward by what rounding may change. A piece that fails is halved.
//!
//! Beyond its domain a surface goes on by the polynomials of its last patch: what is proven at an end of a domain
//! is proven of these.
//!
//! Krawczyk, *Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken*, Computing 4 (1969); Moore,
//! Kearfott & Cloud, *Introduction to Interval Analysis*, §8.2.

use glam::{DVec3, DVec4};

use super::piece::{Carrier, CarrierPatch, CurvePiece, Residual};
use crate::{
    Grid, Interval, bernstein,
    ceiling::{BOX_WIDENINGS, CERTIFICATE_HALVINGS},
    frame::unit,
    numeric::{
        enclosure::{outward, product, quotient, sum},
        linear::solved,
    },
    tolerance::LAST_BIT,
    work,
};

/// How far beyond a patch, by its width, its polynomials are asked.
const FURTHEST: f64 = 1.0;

/// The ranges of the coordinates of Su and Sv.
pub(in crate::trim) type SlopeRanges = [[[f64; 2]; 3]; 2];

/// A bound of the distance between a piece and the curve in which the surfaces cross beside it, where it is
/// proven that there is one and that the bound is no more than `limit`.
pub(super) fn radius(carriers: &[Carrier<'_>; 2], piece: CurvePiece, limit: f64) -> Option<f64> {
    let mut most = 0.0_f64;
    let mut todo = vec![(piece, 0)];
    while let Some((piece, n_halvings)) = todo.pop() {
        if !work::goes_on(1) {
            return None;
        }
        match contracted(carriers, &piece).filter(|&radius| radius <= limit) {
            Some(radius) => most = most.max(radius),
            None if n_halvings == CERTIFICATE_HALVINGS => return None,
            None => todo.extend(piece.halves().map(|half| (half, n_halvings + 1))),
        }
    }
    Some(most)
}

/// The radius of the tube about a piece that the operator leads into its inside.
fn contracted(carriers: &[Carrier<'_>; 2], piece: &CurvePiece) -> Option<f64> {
    let residuals = [piece.residual(&carriers[0], 0)?, piece.residual(&carriers[1], 1)?];
    let [first, last] = [piece.curve.first()?, piece.curve.last()?].map(|p| p.truncate() / p.w);
    let chord = unit(last - first)?;
    let inverse = inverse(carriers, piece, chord)?;
    // Rows of Y on what A and what B miss.
    let rows = inverse.map(|[x, y, z, along]| {
        let both = DVec3::new(x, y, z);
        [both + chord * along, both]
    });
    let rest = rows.map(|[of_a, of_b]| residuals[0].along(of_a) + residuals[1].along(of_b));
    let ranges: [[f64; 2]; 4] = std::array::from_fn(|i| {
        let t = &piece.on[i / 2][i % 2];
        [
            t.iter().copied().fold(f64::INFINITY, f64::min),
            t.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        ]
    });
    let rounding = |i: usize| 4.0 * LAST_BIT * ranges[i][0].abs().max(ranges[i][1].abs());
    let mut box_radii: [f64; 4] = std::array::from_fn(|i| 2.0 * rest[i] + rounding(i));
    for _ in 0..BOX_WIDENINGS {
        let slopes = [0, 1].map(|surface| {
            let around = |i: usize| {
                let [low, high] = ranges[2 * surface + i];
                let radius = box_radii[2 * surface + i];
                outward([low - radius, high + radius])
            };
            slope_ranges(&carriers[surface], [around(0), around(1)])
        });
        let [Some(of_a), Some(of_b)] = slopes else { return None };
        let spread = spread(&rows, [&of_a, &of_b]);
        let image = |radii: [f64; 4]| -> [f64; 4] {
            std::array::from_fn(|i| {
                let moved: f64 = (0..4).map(|k| spread[i][k] * radii[k]).sum();
                (rest[i] + moved) * (1.0 + 16.0 * LAST_BIT)
            })
        };
        let inside = image(box_radii);
        if inside.iter().zip(&box_radii).all(|(inner, outer)| inner < outer) {
            // What is in the box is in its image, and so on.
            let radii = image(image(inside));
            return Some(reach(&residuals, [&of_a, &of_b], radii));
        }
        for i in 0..4 {
            box_radii[i] = box_radii[i].max(1.5 * inside[i]);
        }
        if !box_radii.iter().all(|radius| radius.is_finite()) {
            return None;
        }
    }
    None
}

/// An inverse of the Jacobian in the middle of a piece, but for rounding.
fn inverse(carriers: &[Carrier<'_>; 2], piece: &CurvePiece, chord: DVec3) -> Option<[[f64; 4]; 4]> {
    let [a, b] = [0, 1].map(|surface| {
        let [u, v] = carriers[surface].within(piece.middle(surface));
        carriers[surface].surface.tangents_at(u, v)
    });
    let columns = [a[1], a[2], -b[1], -b[2]];
    let along = [a[1].dot(chord), a[2].dot(chord), 0.0, 0.0];
    let matrix: [[f64; 4]; 4] = std::array::from_fn(|i| match i {
        3 => along,
        _ => std::array::from_fn(|k| columns[k][i]),
    });
    let column = |k: usize| solved(matrix, std::array::from_fn(|i| f64::from(u8::from(i == k))));
    let columns = [column(0)?, column(1)?, column(2)?, column(3)?];
    Some(std::array::from_fn(|i| columns.map(|column| column[i])))
}

/// Bounds of |I − Y J|.
fn spread(rows: &[[DVec3; 2]; 4], slopes: [&SlopeRanges; 2]) -> [[f64; 4]; 4] {
    std::array::from_fn(|i| {
        std::array::from_fn(|k| {
            let surface = k / 2;
            let sign = if surface == 0 { -1.0 } else { 1.0 };
            let row = rows[i][surface] * sign;
            let one = if i == k { 1.0 } else { 0.0 };
            let range = (0..3).fold([one; 2], |range, axis| {
                let step = slopes[surface][k % 2][axis];
                sum(range, product([row[axis]; 2], step))
            });
            range[0].abs().max(range[1].abs())
        })
    })
}

/// How far in space a box of parameters reaches from the spline, seen from the surface that tells less.
fn reach(residuals: &[Residual; 2], slopes: [&SlopeRanges; 2], radii: [f64; 4]) -> f64 {
    let one = |surface: usize| {
        let along = |i: usize| {
            let most = slopes[surface][i].map(|[low, high]| low.abs().max(high.abs()));
            DVec3::from_array(most).length() * radii[2 * surface + i]
        };
        (residuals[surface].length() + along(0) + along(1)) * (1.0 + 16.0 * LAST_BIT)
    };
    one(0).min(one(1))
}

/// The ranges of Su and Sv over a box of parameters.
pub(in crate::trim) fn slope_ranges(
    carrier: &Carrier<'_>,
    ranges: [[f64; 2]; 2],
) -> Option<SlopeRanges> {
    let mut found: Option<SlopeRanges> = None;
    for (span_u, ends_u) in carrier.spans_over(0, ranges[0]) {
        for (span_v, ends_v) in carrier.spans_over(1, ranges[1]) {
            let patch = carrier.patch([span_u, span_v]);
            let here = slopes_on(&patch, ranges, [ends_u, ends_v])?;
            found = Some(match found {
                None => here,
                Some(all) => std::array::from_fn(|i| {
                    std::array::from_fn(|axis| {
                        let ([a, b], [c, d]) = (all[i][axis], here[i][axis]);
                        [a.min(c), b.max(d)]
                    })
                }),
            });
        }
    }
    found
}

/// The same over the part of a box that is in one patch; beyond an end of the domain the patch goes on.
fn slopes_on(
    patch: &CarrierPatch,
    ranges: [[f64; 2]; 2],
    ends: [[bool; 2]; 2],
) -> Option<SlopeRanges> {
    if !patch.has_positive_weights() {
        return None;
    }
    let local = [0, 1].map(|i| local_range(patch.domains[i], ranges[i], ends[i]));
    if local.iter().any(|&[low, high]| low < -FURTHEST || 1.0 + FURTHEST < high) {
        return None;
    }
    let net = part(&patch.net, local);
    let middle = net.get(net.n_rows() / 2, net.n_columns() / 2);
    let center = middle.truncate() / middle.w;
    let seen = |p: &DVec4| (p.truncate() - center * p.w).extend(p.w);
    let size = |grid: &Grid<DVec4>| grid.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    // Each level of cutting adds two last bits, each twice as much where it leads out of the patch.
    let n_levels = (patch.net.n_rows() + patch.net.n_columns()) as f64;
    let beyond = local.iter().map(|&[low, high]| f64::max(-low, high - 1.0)).fold(0.0, f64::max);
    let growth = libm::pow(1.0 + 2.0 * beyond, n_levels);
    let rounding = |grid: &Grid<DVec4>, far: f64| {
        8.0 * LAST_BIT * n_levels * growth * size(grid) * (1.0 + far)
    };
    let far = center.abs().max_element();
    let of_net = rounding(&patch.net, far);
    let net = net.map(seen);
    let weight = range(net.iter().map(|p| p.w), of_net);
    if weight[0] <= 0.0 {
        return None;
    }
    let mut away = [[0.0; 2]; 3];
    for (axis, range_of) in away.iter_mut().enumerate() {
        let height = range(net.iter().map(|p| p[axis]), of_net);
        // Quotients of coefficients, of which each has its own rounding.
        *range_of = quotient(height, weight)?;
        let quotients = range(net.iter().map(|p| p[axis] / p.w), 2.0 * of_net / weight[0]);
        *range_of = [range_of[0].max(quotients[0]), range_of[1].min(quotients[1])];
    }
    let mut found = [[[0.0; 2]; 3]; 2];
    for (i, found) in found.iter_mut().enumerate() {
        let of_slope = rounding(&patch.by[i], far);
        let by = part(&patch.by[i], local).map(seen);
        let weight_by = range(by.iter().map(|p| p.w), of_slope);
        for (axis, found) in found.iter_mut().enumerate() {
            let along = range(by.iter().map(|p| p[axis]), of_slope);
            let turned = product(away[axis], weight_by);
            let numerator = sum(along, [-turned[1], -turned[0]]);
            let by_fraction = quotient(numerator, weight)?;
            *found = quotient(by_fraction, outward([patch.domains[i].length(); 2]))?;
        }
    }
    Some(found)
}

/// The fractions of a span that a range of parameters is, with room for rounding.
fn local_range(
    domain: Interval,
    [low, high]: [f64; 2],
    [is_first, is_last]: [bool; 2],
) -> [f64; 2] {
    let room = |t: f64| {
        let size = t.abs() + domain.start().abs() + domain.end().abs();
        4.0 * LAST_BIT * size / domain.length()
    };
    let (low, high) = (domain.fraction_of(low) - room(low), domain.fraction_of(high) + room(high));
    [if is_first { low } else { low.max(0.0) }, if is_last { high } else { high.min(1.0) }]
}

fn range(values: impl Iterator<Item = f64>, room: f64) -> [f64; 2] {
    let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
        [low.min(value), high.max(value)]
    });
    outward([low - room, high + room])
}

/// The control points of a net over a part of its square: blossoms of the part's ends.
fn part(net: &Grid<DVec4>, local: [[f64; 2]; 2]) -> Grid<DVec4> {
    let lines = |net: &Grid<DVec4>, ends: [f64; 2]| {
        let rows: Vec<Vec<DVec4>> =
            (0..net.n_rows()).map(|i| bernstein::part(net.row(i), ends)).collect();
        Grid::from_fn(net.n_rows(), net.n_columns(), |i, j| rows[i][j])
    };
    lines(&lines(net, local[1]).transposed(), local[0]).transposed()
}
