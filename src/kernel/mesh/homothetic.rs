//! Bounds of surfaces whose sections are alike: S(u, v) = A(v) + r(v)·D(u).
//!
//! One curve, carried along and scaled: spheres, tori, cylinders, cones and all other surfaces of
//! revolution, swung ones, extrusions and translations. Their second derivatives are r·D'', r'·D' and
//! A'' + r''·D, so that curves are bounded, each once, and not all the patches between them.
//! Piegl & Tiller, *The NURBS Book*, §8.3 to §8.6.

use glam::{DVec3, DVec4};

use super::{
    quotient::{CurveHulls, curve_hulls},
    reach::{self, Reach, VectorLanes, in_lanes},
};
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
    section: Vec<SectionPiece>,
    /// A with r as the fourth coordinate.
    carried: Vec<CarriedPiece>,
}

/// A piece of D.
#[derive(Debug)]
struct SectionPiece {
    domain: Interval,
    /// What value, first and second derivative are hulls of, by fractions of the piece.
    hulls: [Vec<VectorLanes>; 3],
    /// Value, first and second derivative in the middle, by the parameter.
    middle: [DVec3; 3],
}

/// A piece of A with r.
#[derive(Debug)]
struct CarriedPiece {
    domain: Interval,
    /// Least and most of r and of its derivative.
    sizes: [[f64; 2]; 2],
    /// What the second derivative is a hull of, by fractions of the piece.
    bends: Vec<DVec4>,
    middle: [DVec4; 3],
}

/// A piece of a rational curve.
struct RationalPiece {
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
            let section = section.into_iter().map(SectionPiece::new).collect();
            let carried = carried.into_iter().map(CarriedPiece::new).collect();
            Some(Self { along, section, carried })
        })
    }

    /// The parameters of the pieces along u and along v.
    pub(super) fn domains(&self) -> [Vec<Interval>; 2] {
        let section = self.section.iter().map(|piece| piece.domain).collect();
        let carried = self.carried.iter().map(|piece| piece.domain).collect();
        self.along.pair(section, carried)
    }

    fn pair(&self, [i, j]: [usize; 2]) -> (&SectionPiece, &CarriedPiece) {
        match self.along {
            Direction::U => (&self.section[i], &self.carried[j]),
            Direction::V => (&self.section[j], &self.carried[i]),
        }
    }

    /// Su, Sv, Suu, Suv and Svv in the middle of a piece, by the parameters.
    pub(super) fn middle(&self, place: [usize; 2]) -> [DVec3; 5] {
        let (section, carried) = self.pair(place);
        let ([d, d1, d2], [a, a1, a2]) = (section.middle, carried.middle);
        let mut middle =
            [d1 * a.w, a1.truncate() + d * a1.w, d2 * a.w, d1 * a1.w, a2.truncate() + d * a2.w];
        if self.along == Direction::V {
            middle.swap(0, 1);
            middle.swap(2, 4);
        }
        middle
    }

    /// Adds vectors in whose hulls Suu, Suv and Svv are over a piece, by fractions of it.
    pub(super) fn add_second(&self, place: [usize; 2], reaches: &mut [Reach; 3]) {
        let (section, carried) = self.pair(place);
        let [d, d1, d2] = &section.hulls;
        let [along, both, across] = match self.along {
            Direction::U => [0, 1, 2],
            Direction::V => [2, 1, 0],
        };
        for (i, sizes, vectors) in [(along, carried.sizes[0], d2), (both, carried.sizes[1], d1)] {
            let n_sizes = if sizes[0] < sizes[1] { 2 } else { 1 };
            for &r in &sizes[..n_sizes] {
                vectors.iter().for_each(|&some| reaches[i].add(reach::times(some, r)));
            }
        }
        for a in &carried.bends {
            let carry = |some| reach::plus(reach::times(some, a.w), a.truncate());
            d.iter().for_each(|&some| reaches[across].add(carry(some)));
        }
    }
}

impl SectionPiece {
    fn new(piece: RationalPiece) -> Self {
        let hulls = piece.hulls.map(|hull| {
            let vectors: Vec<DVec3> = hull.into_iter().map(DVec4::truncate).collect();
            in_lanes(&vectors).collect()
        });
        Self { domain: piece.domain, hulls, middle: piece.middle.map(DVec4::truncate) }
    }
}

impl CarriedPiece {
    fn new(piece: RationalPiece) -> Self {
        let [value, first, bends] = piece.hulls;
        let range = |values: Vec<DVec4>| -> [f64; 2] {
            let sizes = values.iter().map(|value| value.w);
            sizes.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], r| {
                [low.min(r), high.max(r)]
            })
        };
        let sizes = [range(value), range(first)];
        Self { domain: piece.domain, sizes, bends, middle: piece.middle }
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
) -> Option<Vec<RationalPiece>> {
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
        Some(RationalPiece {
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
