//! Bounds of the derivatives of a surface, piece by piece.
//!
//! A piece is a Bézier patch, or a part of one. Its second derivatives are in the hulls that
//! `quotient` finds, and first ones no further from those in the middle than these and half of the
//! piece allow.
//! Piegl & Tiller, *The NURBS Book*, (4.8); Filip, Magedson & Markot, *Surface algorithms using
//! bounds on derivatives*, CAGD 3 (1986).

use std::ops::RangeInclusive;

use glam::{DVec3, DVec4};

use super::{
    alike::AlikePieces,
    homothetic::HomotheticSections,
    quotient::SecondHulls,
    reach::{Reach, in_lanes},
};
use crate::{
    Direction, Grid, Interval, KnotVector, NurbsSurface, bezier, ceiling::WEIGHT_QUARTERINGS,
    frame::unit, homogeneous::place, side_by_side, tolerance::EXACT_RELATIVE, work,
};

/// The pieces of a surface with what bounds its derivatives there.
#[derive(Debug)]
pub(super) struct DerivativeBounds {
    /// Where the pieces along u and along v begin and end.
    pub(super) ends: [Vec<f64>; 2],
    pub(super) alike: AlikePieces,
    pub(super) pieces: Grid<PieceBounds>,
    /// The normal of the plane that it is.
    pub(super) plane: Option<DVec3>,
}

/// Bounds over one piece, of derivatives by the parameters.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct PieceBounds {
    /// Of the lengths of Suu, Suv and Svv.
    pub(super) second: [f64; 3],
    /// Least and most of what they are along the normal in the middle.
    pub(super) lift: [[f64; 2]; 3],
    /// Of the lengths of what they are across it.
    pub(super) across: [f64; 3],
    /// That normal, if there is one.
    pub(super) normal: Option<DVec3>,
    /// Of the lengths of Su and Sv.
    pub(super) first: [f64; 2],
    /// How far Su and Sv may be from those in the middle.
    pub(super) spread: [f64; 2],
    /// Su, Sv, Suu and Suv, Svv in the middle.
    pub(super) middle: [DVec3; 5],
}

impl DerivativeBounds {
    /// Those of about as many pieces along u and along v as wanted, found by up to `n_threads` threads; of no use
    /// when the work was ended.
    pub(super) fn of(surface: &NurbsSurface, wanted: [usize; 2], n_threads: usize) -> Self {
        let mut clamped = surface.clone();
        for along in Direction::BOTH {
            clamped = clamped.with_lines(along, clamped.lines(along).clamped());
        }
        let new = |wanted: [usize; 2]| {
            Direction::BOTH.map(|along| missing_knots(clamped.knots(along), wanted[along]))
        };
        let strips = {
            let [along_u, along_v] = new([0; 2]);
            [[along_u, Vec::new()], [Vec::new(), along_v]].map(|new| refined(clamped.clone(), &new))
        };
        let n_parts = Direction::BOTH.map(|along| n_parts(clamped.knots(along), wanted[along]));
        let alike = AlikePieces::of(strips.each_ref(), n_parts);
        let new = new(wanted);
        let (domains, alike, pieces) = match HomotheticSections::of(&clamped, &new) {
            Some(sections) => {
                let domains = sections.domains();
                let alike = alike.of_as_many(domains.each_ref().map(Vec::len));
                let pieces = of_homothetic(&sections, &domains, &alike);
                (domains, alike, pieces)
            }
            None => {
                let refined = refined(clamped, &new);
                let domains = Direction::BOTH.map(|along| -> Vec<Interval> {
                    let knots = refined.knots(along);
                    knots.spans().map(|span| knots.span_interval(span)).collect()
                });
                let alike = alike.of_as_many(domains.each_ref().map(Vec::len));
                let pieces = of_patches(surface, &refined, &alike, n_threads);
                (domains, alike, pieces)
            }
        };
        let ends = domains.map(|domains| -> Vec<f64> {
            let starts = domains.iter().map(|interval| interval.start());
            starts.chain(domains.last().map(|interval| interval.end())).collect()
        });
        let plane = plane(surface, &pieces, &ends);
        Self { ends, alike, pieces, plane }
    }
}

fn refined(mut surface: NurbsSurface, new: &[Vec<f64>; 2]) -> NurbsSurface {
    for along in Direction::BOTH {
        if let Ok(lines) = surface.lines(along).with_knots(&new[along]) {
            surface = surface.with_lines(along, lines);
        }
    }
    surface
}

/// The bounds of a surface of two curves over all pieces.
fn of_homothetic(
    sections: &HomotheticSections,
    domains: &[Vec<Interval>; 2],
    alike: &AlikePieces,
) -> Grid<PieceBounds> {
    let lengths = domains
        .each_ref()
        .map(|domains| -> Vec<f64> { domains.iter().map(|interval| interval.length()).collect() });
    alike.grid(|i, j| {
        if !work::goes_on(1) {
            return PieceBounds::UNBOUNDED;
        }
        let middle = sections.middle([i, j]);
        let second = |reaches: &mut [Reach; 3]| sections.add_second([i, j], reaches);
        PieceBounds::new(middle, [lengths[0][i], lengths[1][j]], second)
    })
}

/// The bounds of any other one, whose Bézier patches are those of `refined`.
fn of_patches(
    surface: &NurbsSurface,
    refined: &NurbsSurface,
    alike: &AlikePieces,
    n_threads: usize,
) -> Grid<PieceBounds> {
    let spans = Direction::BOTH.map(|along| refined.knots(along).spans().collect::<Vec<_>>());
    let row = |&i: &usize| -> Vec<PieceBounds> {
        let (rows, domain_u) = piece_of(refined.knots_u(), spans[0][i]);
        let mut hulls = SecondHulls::default();
        let piece = |&j: &usize| {
            if !work::goes_on(1) {
                return PieceBounds::UNBOUNDED;
            }
            let net = refined.control_points();
            let (columns, domain_v) = piece_of(refined.knots_v(), spans[1][j]);
            let (first, n_columns) = (*columns.start(), columns.count());
            let points =
                rows.clone().flat_map(|row| net.row(row)[first..][..n_columns].iter().copied());
            let net = Grid::from_rows_of(n_columns, points.collect());
            bend(surface, &net, [domain_u, domain_v], 0, &mut hulls)
        };
        alike.firsts(Direction::V).iter().map(piece).collect()
    };
    let rows = side_by_side::map(alike.firsts(Direction::U), n_threads, row);
    let [rows_of, columns_of] = Direction::BOTH.map(|along| alike.kinds(along));
    alike.grid(|i, j| rows[rows_of[i]][columns_of[j]])
}

/// The control points of a span, and its parameters.
fn piece_of(knots: &KnotVector, span: usize) -> (RangeInclusive<usize>, Interval) {
    (knots.support(span), knots.span_interval(span))
}

/// In how many parts each span goes, for about as many as wanted.
fn n_parts(knots: &KnotVector, wanted: usize) -> usize {
    let n_spans = knots.breaks().len().max(2) - 1;
    ((wanted + n_spans / 2) / n_spans).max(1)
}

/// The knots that make Bézier pieces of a clamped spline, about as many as wanted.
fn missing_knots(knots: &KnotVector, wanted: usize) -> Vec<f64> {
    let (degree, breaks, n_parts) = (knots.degree(), knots.breaks(), n_parts(knots, wanted));
    let mut missing = Vec::new();
    for pair in breaks.windows(2) {
        let times = if pair[0] <= breaks[0] { degree } else { knots.exact_multiplicity(pair[0]) };
        missing.extend(vec![pair[0]; degree.saturating_sub(times)]);
        let Ok(span) = Interval::new(pair[0], pair[1]) else { continue };
        for t in span.steps(n_parts).into_iter().skip(1).take(n_parts - 1) {
            missing.extend(vec![t; degree]);
        }
    }
    missing
}

/// The normal of the plane that the surface lies in without a fold; none of another surface.
fn plane(
    surface: &NurbsSurface,
    pieces: &Grid<PieceBounds>,
    ends: &[Vec<f64>; 2],
) -> Option<DVec3> {
    let mut sum = DVec3::ZERO;
    for (i, u) in ends[0].windows(2).enumerate() {
        for (j, v) in ends[1].windows(2).enumerate() {
            let [along_u, along_v, ..] = pieces.row(i)[j].middle;
            sum += along_u.cross(along_v) * ((u[1] - u[0]) * (v[1] - v[0]));
        }
    }
    let normal = unit(sum)?;
    let net = surface.control_points();
    let center = place(net.get(net.n_rows() / 2, net.n_columns() / 2));
    let offsets = || net.iter().map(|point| point.truncate() - center * point.w);
    let size = offsets().map(DVec3::length).fold(0.0, f64::max);
    let is_flat = offsets().all(|offset| normal.dot(offset).abs() <= EXACT_RELATIVE * size);
    let faces = |bend: &PieceBounds| 0.0 < normal.dot(bend.middle[0].cross(bend.middle[1]));
    (is_flat && pieces.iter().all(faces)).then_some(normal)
}

/// The bounds over a piece with this net and these parameters.
fn bend(
    surface: &NurbsSurface,
    net: &Grid<DVec4>,
    domains: [Interval; 2],
    n_quarterings: usize,
    hulls: &mut SecondHulls,
) -> PieceBounds {
    match net.iter().all(|point| 0.0 < point.w) {
        true => of_positive(surface, net, domains, hulls),
        false if n_quarterings < WEIGHT_QUARTERINGS => {
            let (halves_u, halves_v) = (domains[0].halves(), domains[1].halves());
            let mut all = PieceBounds::default();
            for (half, domain_u) in bezier::halves(net, Direction::U).iter().zip(halves_u) {
                for (quarter, domain_v) in bezier::halves(half, Direction::V).iter().zip(halves_v) {
                    let domains = [domain_u, domain_v];
                    all = all.union(bend(surface, quarter, domains, n_quarterings + 1, hulls));
                }
            }
            all
        }
        false => PieceBounds::UNBOUNDED,
    }
}

impl PieceBounds {
    /// What is known of nothing.
    const UNBOUNDED: Self = Self {
        second: [f64::INFINITY; 3],
        lift: [[f64::NEG_INFINITY, f64::INFINITY]; 3],
        across: [f64::INFINITY; 3],
        normal: None,
        first: [f64::INFINITY; 2],
        spread: [f64::INFINITY; 2],
        middle: [DVec3::ZERO; 5],
    };

    /// Those of a piece of these lengths along u and along v; `add_second` adds vectors in whose hulls Suu, Suv
    /// and Svv are, by fractions of it.
    fn new(middle: [DVec3; 5], [a, b]: [f64; 2], add_second: impl FnOnce(&mut [Reach; 3])) -> Self {
        let normal = unit(middle[0].cross(middle[1]));
        let scales = [a * a, a * b, b * b];
        let mut reaches = scales.map(|scale| Reach::new(normal.unwrap_or(DVec3::ZERO), scale));
        add_second(&mut reaches);
        let second = reaches.each_ref().map(Reach::length);
        let across = reaches.each_ref().map(Reach::across);
        let lift = reaches.each_ref().map(Reach::lift);
        let spread = [0, 1].map(|i| 0.5 * (a * second[i] + b * second[i + 1]));
        let first = [0, 1].map(|i| middle[i].length() + spread[i]);
        Self { second, lift, across, normal, first, spread, middle }
    }

    /// How many times longer a step along u is than one along v.
    pub(super) fn ratio(&self) -> f64 {
        let ratio = self.middle[0].length() / self.middle[1].length();
        if ratio.is_normal() { ratio } else { 1.0 }
    }

    /// Bounds over two pieces; the middle is that of the second one, and there is no normal.
    fn union(self, other: Self) -> Self {
        fn max<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
            std::array::from_fn(|i| a[i].max(b[i]))
        }
        let first = max(self.first, other.first);
        Self {
            second: max(self.second, other.second),
            first,
            spread: first.map(|length| 2.0 * length),
            middle: other.middle,
            ..Self::UNBOUNDED
        }
    }
}

/// The bounds over a piece with positive weights.
fn of_positive(
    surface: &NurbsSurface,
    net: &Grid<DVec4>,
    domains: [Interval; 2],
    hulls: &mut SecondHulls,
) -> PieceBounds {
    let [u, v] = domains.map(|domain| domain.at(0.5));
    let at_middle = surface.derivatives_at(u, v, 2);
    let middle = [(1, 0), (0, 1), (2, 0), (1, 1), (0, 2)].map(|(k, l)| at_middle.get(k, l));
    let center = place(net.get(net.n_rows() / 2, net.n_columns() / 2));
    let hulls = hulls.of(net, center);
    PieceBounds::new(middle, domains.map(Interval::length), |reaches| {
        for (reach, hull) in reaches.iter_mut().zip(hulls) {
            in_lanes(hull).for_each(|vectors| reach.add(vectors));
        }
    })
}
