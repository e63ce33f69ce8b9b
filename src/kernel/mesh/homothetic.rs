//! Bounds of surfaces whose sections are alike: S(u, v) = A(v) + r(v)·D(u).
//!
//! One curve, carried along and scaled: spheres, tori, cylinders, cones and all other surfaces of
//! revolution, swung ones, extrusions and translations. Their second derivatives are r·D'', r'·D' and
//! A'' + r''·D, so that curves are bounded, each once, and not all the patches between them.
//! Piegl & Tiller, *The NURBS Book*, §8.3 to §8.6.

use glam::{DVec3, DVec4};

use super::quotient::{CurveHulls, curve_hulls};
use crate::{
    Direction, Grid, Interval, NurbsSurface,
    homogeneous::{place, weight_factors},
    refine::ControlLines,
    tolerance::EXACT_RELATIVE,
};

/// The Bézier pieces of the two curves that make a surface.
#[derive(Debug)]
pub(super) struct HomotheticSections {
    /// The direction of D.
    along: Direction,
    /// D.
    section: Vec<CurvePiece>,
    /// A with r as the fourth coordinate.
    carried: Vec<CurvePiece>,
}

/// A piece of a rational curve.
#[derive(Debug)]
struct CurvePiece {
    domain: Interval,
    /// What value, first and second derivative are hulls of, by fractions of the piece.
    hulls: CurveHulls,
    /// Value, first and second derivative in the middle, by the parameter.
    middle: [DVec4; 3],
}

/// Places of control points: D, and A with r.
type Sections = [Vec<DVec4>; 2];

impl HomotheticSections {
    /// Those of a clamped surface with positive weights, on these knots more along u and along v.
    pub(super) fn of(surface: &NurbsSurface, new: &[Vec<f64>; 2]) -> Option<Self> {
        let net = surface.control_points();
        if !net.iter().all(|point| 0.0 < point.w) {
            return None;
        }
        let weights = weight_factors(net)?;
        let places = net.map(|&point| place(point));
        Direction::BOTH.into_iter().find_map(|along| {
            let [section, carried] = match along {
                Direction::U => sections(&places)?,
                Direction::V => sections(&places.transposed())?,
            };
            let across = along.other();
            let pieces = |along: Direction, values: &[DVec4]| {
                let knots = surface.lines(along).knots;
                pieces(
                    ControlLines { knots, lines: Vec::new() },
                    values,
                    &weights[along],
                    &new[along],
                )
            };
            let (section, carried) = (pieces(along, &section)?, pieces(across, &carried)?);
            Some(Self { along, section, carried })
        })
    }

    /// The parameters of the pieces along u and along v.
    pub(super) fn domains(&self) -> [Vec<Interval>; 2] {
        let of = |pieces: &[CurvePiece]| pieces.iter().map(|piece| piece.domain).collect();
        self.along.pair(of(&self.section), of(&self.carried))
    }

    /// Vectors in whose hulls Suu, Suv and Svv are over a piece, by fractions of it; and Su, Sv, Suu, Suv and
    /// Svv in its middle, by the parameters.
    pub(super) fn second(&self, [i, j]: [usize; 2], hulls: &mut [Vec<DVec3>; 3]) -> [DVec3; 5] {
        let (section, carried) = match self.along {
            Direction::U => (&self.section[i], &self.carried[j]),
            Direction::V => (&self.section[j], &self.carried[i]),
        };
        let range = |values: &[DVec4]| -> [f64; 2] {
            let sizes = values.iter().map(|value| value.w);
            sizes.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], r| {
                [low.min(r), high.max(r)]
            })
        };
        let [d, d1, d2] = &section.hulls;
        let [a, a1, a2] = &carried.hulls;
        hulls.iter_mut().for_each(Vec::clear);
        let [along, both, across] = hulls;
        let times = |sizes: [f64; 2], vectors: &[DVec4], products: &mut Vec<DVec3>| {
            products
                .extend(sizes.iter().flat_map(|&r| vectors.iter().map(move |d| d.truncate() * r)));
        };
        times(range(a), d2, along);
        times(range(a1), d1, both);
        across.extend(a2.iter().flat_map(|a| d.iter().map(|d| a.truncate() + d.truncate() * a.w)));
        let [d, d1, d2] = section.middle.map(DVec4::truncate);
        let [a, a1, a2] = carried.middle;
        let mut middle =
            [d1 * a.w, a1.truncate() + d * a1.w, d2 * a.w, d1 * a1.w, a2.truncate() + d * a2.w];
        if self.along == Direction::V {
            hulls.swap(0, 2);
            middle.swap(0, 1);
            middle.swap(2, 4);
        }
        middle
    }
}

/// D and A with r of a grid of places whose columns are alike; none where they are not.
fn sections(places: &Grid<DVec3>) -> Option<Sections> {
    let (n, m) = (places.n_rows(), places.n_columns());
    let reach = |&(i, j): &(usize, usize)| places.get(i, j).distance_squared(places.get(0, j));
    let all = (0..n).flat_map(|i| (0..m).map(move |j| (i, j)));
    let (far, widest) = all.max_by(|a, b| reach(a).total_cmp(&reach(b)))?;
    let section: Vec<DVec3> =
        (0..n).map(|i| places.get(i, widest) - places.get(0, widest)).collect();
    let size = section[far].length_squared();
    if size <= 0.0 {
        return None;
    }
    let scale = |j| (places.get(far, j) - places.get(0, j)).dot(section[far]) / size;
    let carried: Vec<DVec4> = (0..m).map(|j| places.get(0, j).extend(scale(j))).collect();
    let allowed = EXACT_RELATIVE * size.sqrt();
    let is_like = |(i, j): (usize, usize)| {
        let expected = carried[j].truncate() + section[i] * carried[j].w;
        places.get(i, j).distance(expected) <= allowed
    };
    let mut all = (0..n).flat_map(|i| (0..m).map(move |j| (i, j)));
    all.all(is_like).then(|| [section.iter().map(|d| d.extend(0.0)).collect(), carried])
}

/// The Bézier pieces of a rational curve of four coordinates on more knots.
fn pieces(
    lines: ControlLines,
    values: &[DVec4],
    weights: &[f64],
    new: &[f64],
) -> Option<Vec<CurvePiece>> {
    let weighted = |(value, &weight): (&DVec4, &f64)| *value * weight;
    let numerators = values.iter().zip(weights).map(weighted).collect();
    let denominators = weights.iter().map(|&weight| DVec4::splat(weight)).collect();
    let lines = ControlLines { lines: vec![numerators, denominators], ..lines };
    let lines = lines.with_knots(new).ok()?;
    let [numerators, denominators] = &lines.lines[..] else { return None };
    let piece = |span: usize| {
        let (domain, points) = (lines.knots.span_interval(span), lines.knots.support(span));
        let weights: Vec<f64> = denominators[points.clone()].iter().map(|one| one.w).collect();
        let values = &numerators[points];
        Some(CurvePiece {
            domain,
            hulls: curve_hulls(values, &weights),
            middle: middle(values, &weights, domain.length())?,
        })
    };
    lines.knots.spans().map(piece).collect()
}

/// Value, first and second derivative in the middle of a Bézier curve over an interval of this length.
fn middle(values: &[DVec4], weights: &[f64], length: f64) -> Option<[DVec4; 3]> {
    let mut points: Vec<(DVec4, f64)> =
        values.iter().copied().zip(weights.iter().copied()).collect();
    let degree = points.len().checked_sub(1)? as f64;
    let mut bend = (DVec4::ZERO, 0.0);
    while 2 < points.len() {
        if let [a, b, c] = points[..] {
            let times = degree * (degree - 1.0) / (length * length);
            bend = ((a.0 - b.0 * 2.0 + c.0) * times, (a.1 - b.1 * 2.0 + c.1) * times);
        }
        let halves = points
            .windows(2)
            .map(|pair| ((pair[0].0 + pair[1].0) * 0.5, 0.5 * (pair[0].1 + pair[1].1)));
        points = halves.collect();
    }
    let [a, b] = points[..] else { return None };
    let times = degree / length;
    let (slope, slope_weight) = ((b.0 - a.0) * times, (b.1 - a.1) * times);
    let weight = 0.5 * (a.1 + b.1);
    let value = (a.0 + b.0) * (0.5 / weight);
    let first = (slope - value * slope_weight) / weight;
    let second = (bend.0 - first * (2.0 * slope_weight) - value * bend.1) / weight;
    Some([value, first, second])
}
