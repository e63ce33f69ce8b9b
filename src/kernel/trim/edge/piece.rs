//! How far a piece of a curve is from the surface that its parameters tell: bounds, not samples.
//!
//! With polynomial parameters p(t) a Bézier patch S of bidegree (p, q) is a rational curve of degree 3(p + q),
//! and S∘p − C a quotient of polynomials of one degree whose denominator has positive coefficients: it is
//! within the hull of the quotients of coefficients.
//! Farouki & Rajan, *Algorithms for polynomials in Bernstein form*, CAGD 5 (1988).

use std::{cell::RefCell, collections::BTreeMap, rc::Rc};

use glam::{DVec3, DVec4};

use crate::{
    Grid, Interval, KnotVector, NurbsSurface, Side, bernstein, bezier,
    tolerance::{LAST_BIT, OVERSHOOT_RELATIVE},
};

/// A surface with the Bézier patches that were asked for.
#[derive(Debug)]
pub(in crate::trim) struct Carrier<'s> {
    pub(super) surface: &'s NurbsSurface,
    /// Those with points, along u and along v.
    spans: [Vec<usize>; 2],
    patches: RefCell<BTreeMap<[usize; 2], Rc<CarrierPatch>>>,
}

/// A Bézier patch and what its derivatives are made of, by fractions of the patch.
#[derive(Debug)]
pub(super) struct CarrierPatch {
    pub(super) domains: [Interval; 2],
    pub(super) net: Grid<DVec4>,
    /// The homogeneous derivatives along u and along v.
    pub(super) by: [Grid<DVec4>; 2],
    /// The largest coordinate of a numerator, the least and the largest weight.
    magnitude: f64,
    weights: [f64; 2],
    /// Su and Sv are no longer than this.
    fastest: [f64; 2],
}

impl<'s> Carrier<'s> {
    pub(in crate::trim) fn new(surface: &'s NurbsSurface) -> Self {
        let spans = [surface.knots_u(), surface.knots_v()].map(|knots| knots.spans().collect());
        Self { surface, spans, patches: RefCell::default() }
    }

    pub(super) fn knots(&self, along: usize) -> &KnotVector {
        if along == 0 { self.surface.knots_u() } else { self.surface.knots_v() }
    }

    pub(super) fn patch(&self, spans: [usize; 2]) -> Rc<CarrierPatch> {
        let mut patches = self.patches.borrow_mut();
        let patch = || Rc::new(CarrierPatch::new(self.surface, spans));
        Rc::clone(patches.entry(spans).or_insert_with(patch))
    }

    /// The spans along a direction that an interval of parameters is in, each with whether it is the first
    /// and whether it is the last.
    pub(super) fn spans_over(
        &self,
        along: usize,
        [low, high]: [f64; 2],
    ) -> impl Iterator<Item = (usize, [bool; 2])> {
        let (spans, last) = (&self.spans[along], self.spans[along].len() - 1);
        spans.iter().enumerate().filter_map(move |(i, &span)| {
            let ends = [i == 0, i == last];
            let over = self.knots(along).span_interval(span);
            let is_touched = (ends[0] || over.start() <= high) && (ends[1] || low <= over.end());
            is_touched.then_some((span, ends))
        })
    }

    /// The spans beside one, before and behind it.
    fn spans_beside(&self, along: usize, span: usize) -> [Option<usize>; 2] {
        let spans = &self.spans[along];
        let i = spans.partition_point(|&other| other < span);
        [i.checked_sub(1).map(|i| spans[i]), spans.get(i + 1).copied()]
    }

    /// The spans that parameters are in, of the two at a knot the one behind it.
    fn spans_at(&self, at: [f64; 2]) -> [usize; 2] {
        let at = self.within(at);
        [0, 1].map(|i| self.knots(i).span_beside(at[i], Side::Right))
    }

    /// The parameters of the surface nearest to some.
    pub(super) fn within(&self, at: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|i| {
            let domain = self.knots(i).domain();
            at[i].clamp(domain.start(), domain.end())
        })
    }
}

impl CarrierPatch {
    fn new(surface: &NurbsSurface, spans: [usize; 2]) -> Self {
        let knots = [surface.knots_u(), surface.knots_v()];
        let net = bezier::patch(knots, surface.control_points(), spans[0], spans[1]);
        let domains = [0, 1].map(|i| knots[i].span_interval(spans[i]));
        let by_u = slope(&net);
        let by_v = slope(&net.transposed()).transposed();
        let weight = |fold: fn(f64, f64) -> f64, start| net.iter().map(|p| p.w).fold(start, fold);
        let weights = [weight(f64::min, f64::INFINITY), weight(f64::max, 0.0)];
        let magnitude = net.iter().map(|p| p.truncate().length()).fold(0.0, f64::max);
        // Su = (Pu − S·wu)/w, seen from one of its points.
        let center = net.get(0, 0).truncate() / net.get(0, 0).w;
        let away = |p: &DVec4| (p.truncate() - center * p.w).length();
        let reach = net.iter().map(|p| away(p) / p.w).fold(0.0, f64::max);
        let fastest = [&by_u, &by_v].map(|by| {
            let along = by.iter().map(|p| away(p) + reach * p.w.abs()).fold(0.0, f64::max);
            along / weights[0]
        });
        Self { domains, net, by: [by_u, by_v], magnitude, weights, fastest }
    }

    pub(super) fn has_positive_weights(&self) -> bool {
        0.0 < self.weights[0]
    }

    fn degrees(&self) -> [usize; 2] {
        [self.net.n_rows() - 1, self.net.n_columns() - 1]
    }
}

fn slope(net: &Grid<DVec4>) -> Grid<DVec4> {
    let degree = net.n_rows() - 1;
    if degree == 0 {
        return net.map(|_| DVec4::ZERO);
    }
    Grid::from_fn(degree, net.n_columns(), |i, j| {
        (net.get(i + 1, j) - net.get(i, j)) * degree as f64
    })
}

/// A polynomial piece of a curve with its parameters on two surfaces, all by Bernstein coefficients.
#[derive(Clone, Debug)]
pub(super) struct CurvePiece {
    pub(super) curve: Vec<DVec4>,
    /// Of each surface u and v.
    pub(super) on: [[Vec<f64>; 2]; 2],
}

impl CurvePiece {
    pub(super) fn halves(&self) -> [Self; 2] {
        let (before, behind) = bezier::cut_at(&self.curve, 0.5);
        let cut = self.on.each_ref().map(|on| on.each_ref().map(|t| bernstein::halves(t)));
        let part = |curve, i: usize| Self {
            curve,
            on: cut.each_ref().map(|on| on.each_ref().map(|halves| halves[i].clone())),
        };
        [part(before, 0), part(behind, 1)]
    }

    /// Where its middle is on a surface.
    pub(super) fn middle(&self, surface: usize) -> [f64; 2] {
        self.on[surface].each_ref().map(|t| bernstein::value(t, 0.5))
    }

    /// What a surface at the piece's parameters and the piece are apart. `None` where that is not bounded:
    /// where weights are not positive, or the parameters lead far out of one patch.
    pub(super) fn residual(&self, carrier: &Carrier<'_>, surface: usize) -> Option<Residual> {
        let on = &self.on[surface];
        let spans = carrier.spans_at(self.middle(surface));
        let patch = carrier.patch(spans);
        let weights = self.curve.iter().map(|p| p.w);
        let (lightest, heaviest) =
            weights.fold((f64::INFINITY, 0.0_f64), |(low, high), w| (low.min(w), high.max(w)));
        if !patch.has_positive_weights() || lightest <= 0.0 {
            return None;
        }
        let local = [0, 1].map(|i| -> Vec<f64> {
            on[i].iter().map(|&t| patch.domains[i].fraction_of(t)).collect()
        });
        let beside = self.overshoot(carrier, (spans, &patch), &local)?;

        let center = self.curve[self.curve.len() / 2];
        let center = center.truncate() / center.w;
        let seen = |p: &DVec4| (p.truncate() - center * p.w).extend(p.w);
        let curve: Vec<DVec4> = self.curve.iter().map(seen).collect();
        let along = along(&patch.net.map(seen), &local);
        let times =
            |a: DVec4, b: DVec4| (a.truncate() * b.w - b.truncate() * a.w).extend(a.w * b.w);
        let both = bernstein::product(&along, &curve, times);
        if both.iter().any(|p| p.w <= 0.0 || p.is_nan()) {
            return None;
        }
        let coefficients = both.iter().map(|p| p.truncate() / p.w).collect();

        // Each coefficient is a sum of products with shares that sum up to one, and each step of it adds
        // a last bit for each of its terms.
        let [p, q] = patch.degrees();
        let n_roundings = (16 * (p + q) + 4 * self.curve.len() + 32) as f64;
        let growth: f64 = [0, 1].map(|i| growth(&local[i], patch.degrees()[i])).iter().product();
        let far = center.length();
        let heavy = patch.weights[1] * growth;
        let lightest = both.iter().map(|p| p.w).fold(f64::INFINITY, f64::min);
        if lightest <= LAST_BIT * n_roundings * heavy * heaviest {
            return None;
        }
        let of_curve =
            self.curve.iter().map(|p| p.truncate().length() + far * p.w).fold(0.0, f64::max);
        let of_surface = patch.magnitude * growth + far * heavy;
        let size = (of_surface * heaviest + of_curve * heavy) / lightest;
        let of_parameters: f64 = (0..2)
            .map(|i| {
                let domain = patch.domains[i];
                let t = domain.start().abs().max(domain.end().abs());
                8.0 * t / domain.length() * patch.fastest[i]
            })
            .sum();
        let rounding = LAST_BIT * (n_roundings * size + of_parameters);
        Some(Residual { coefficients, room: beside + rounding })
    }

    /// How far beyond its patch the piece may lead the surface away from the patch's polynomials; `None`
    /// where that is more than a little.
    fn overshoot(
        &self,
        carrier: &Carrier<'_>,
        (spans, patch): ([usize; 2], &CarrierPatch),
        local: &[Vec<f64>; 2],
    ) -> Option<f64> {
        let mut beyond = [0.0_f64; 2];
        let mut touched = [vec![spans[0]], vec![spans[1]]];
        for i in 0..2 {
            let low = local[i].iter().copied().fold(f64::INFINITY, f64::min);
            let high = local[i].iter().copied().fold(f64::NEG_INFINITY, f64::max);
            beyond[i] = f64::max(-low, high - 1.0).max(0.0);
            let next = carrier.spans_beside(i, spans[i]);
            let by = beyond[i] * patch.domains[i].length();
            for (span, is_touched) in next.into_iter().zip([low < 0.0, 1.0 < high]) {
                let Some(span) = span.filter(|_| is_touched) else { continue };
                if carrier.knots(i).span_interval(span).length() < by {
                    return None;
                }
                touched[i].push(span);
            }
        }
        let furthest = beyond[0].max(beyond[1]);
        if furthest == 0.0 {
            return Some(0.0);
        }
        let mut fastest = [0.0_f64; 2];
        for &span_u in &touched[0] {
            for &span_v in &touched[1] {
                let next = carrier.patch([span_u, span_v]);
                if !next.has_positive_weights() {
                    return None;
                }
                for (i, fastest) in fastest.iter_mut().enumerate() {
                    let scale = patch.domains[i].length() / next.domains[i].length();
                    *fastest = f64::max(*fastest, next.fastest[i] * scale);
                }
            }
        }
        // So little beyond a patch its polynomials go on no more than half as fast again.
        let [p, q] = patch.degrees();
        let growth = libm::pow(1.0 + 2.0 * furthest, (p + q) as f64) - 1.0;
        let [light, heavy] = patch.weights;
        let is_little = growth * heavy <= OVERSHOOT_RELATIVE * light;
        // Once along the patch's own polynomials, and back along those that count there.
        is_little.then(|| 3.0 * (beyond[0] * fastest[0] + beyond[1] * fastest[1]))
    }
}

/// How much larger than its coefficients a polynomial of that degree may be along another one.
fn growth(t: &[f64], degree: usize) -> f64 {
    let most = t.iter().map(|t| t.abs() + (1.0 - t).abs()).fold(1.0, f64::max);
    libm::pow(most, degree as f64)
}

/// Vectors in whose hull a difference is all along a piece, but for some room in every direction.
#[derive(Clone, Debug)]
pub(super) struct Residual {
    pub(super) coefficients: Vec<DVec3>,
    pub(super) room: f64,
}

impl Residual {
    /// A bound of its length.
    pub(super) fn length(&self) -> f64 {
        self.coefficients.iter().map(|v| v.length()).fold(0.0, f64::max) + self.room
    }

    /// A bound of what it is along a vector, by absolute value.
    pub(super) fn along(&self, vector: DVec3) -> f64 {
        let most = self.coefficients.iter().map(|v| v.dot(vector).abs()).fold(0.0, f64::max);
        most * (1.0 + 8.0 * LAST_BIT) + self.room * vector.length() * (1.0 + 8.0 * LAST_BIT)
    }
}

/// The homogeneous curve that a patch is along polynomial parameters.
fn along(net: &Grid<DVec4>, local: &[Vec<f64>; 2]) -> Vec<DVec4> {
    let rows = basis_along(net.n_rows() - 1, &local[0]);
    let columns = basis_along(net.n_columns() - 1, &local[1]);
    let mut sum: Vec<DVec4> = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        let mut line = vec![DVec4::ZERO; columns[0].len()];
        for (column, &point) in columns.iter().zip(net.row(i)) {
            line.iter_mut().zip(column).for_each(|(sum, share)| *sum += point * *share);
        }
        let part = bernstein::product(row, &line, |share, point: DVec4| point * share);
        if sum.is_empty() {
            sum = part;
        } else {
            sum.iter_mut().zip(part).for_each(|(sum, more)| *sum += more);
        }
    }
    sum
}

/// The Bernstein polynomials of a degree at a polynomial, as polynomials.
fn basis_along(degree: usize, t: &[f64]) -> Vec<Vec<f64>> {
    let falling: Vec<f64> = t.iter().map(|t| 1.0 - t).collect();
    let mut basis = vec![vec![1.0]];
    for _ in 0..degree {
        let times = |factor: &[f64], other: &[f64]| bernstein::product(factor, other, |a, b| a * b);
        let n = basis.len();
        basis = (0..=n)
            .map(|i| match i {
                0 => times(&falling, &basis[0]),
                i if i == n => times(t, &basis[n - 1]),
                _ => {
                    let rising = times(t, &basis[i - 1]);
                    let both = times(&falling, &basis[i]).into_iter().zip(rising);
                    both.map(|(a, b)| a + b).collect()
                }
            })
            .collect();
    }
    basis
}
