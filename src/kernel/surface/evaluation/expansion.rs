//! A surface in powers: the basis functions along u, and each row of control points along v.

use glam::{DVec3, DVec4};

use crate::{
    Grid, KnotVector, homogeneous,
    knots::{BATCH, BasisExpansion, LocalParameter, SpanLookup, add_in_powers, convert_to_bezier},
};

/// A surface in powers.
#[derive(Debug)]
pub(in crate::surface) struct SurfaceExpansion {
    basis: BasisExpansion,
    /// The halves of the spans along v.
    lookup: SpanLookup,
    n_halves: usize,
    /// For each row of control points and each half of a span along v the coefficients of s⁰, s¹, …
    rows: Vec<DVec4>,
}

impl SurfaceExpansion {
    pub(super) fn new([knots_u, knots]: [&KnotVector; 2], control_points: &Grid<DVec4>) -> Self {
        let n_halves = 2 * knots.spans().count();
        let n_rows = control_points.n_rows();
        let mut rows = Vec::with_capacity(n_rows * n_halves * (knots.degree() + 1));
        let mut points = Vec::with_capacity(knots.degree() + 1);
        for i in 0..n_rows {
            for span in knots.spans() {
                points.clear();
                points.extend_from_slice(&control_points.row(i)[knots.support(span)]);
                convert_to_bezier(knots, span, &mut points);
                add_in_powers(&mut points, &mut rows);
            }
        }
        let basis = BasisExpansion::new(knots_u);
        Self { basis, lookup: SpanLookup::of_halves(knots), n_halves, rows }
    }

    pub(super) fn places_at(&self, u: f64, v: f64) -> [LocalParameter; 2] {
        [self.basis.lookup.place_at(u), self.lookup.place_at(v)]
    }

    /// The coefficients along v of the rows that act.
    #[inline(always)]
    fn acting(
        &self,
        places: [LocalParameter; 2],
        [n_u, n_v]: [usize; 2],
    ) -> impl Iterator<Item = &[DVec4]> {
        let first = self.basis.first(places[0]);
        (first..first + n_u)
            .map(move |i| &self.rows[(i * self.n_halves + places[1].piece) * n_v..][..n_v])
    }

    #[inline(always)]
    pub(super) fn point(&self, places: [LocalParameter; 2], n: [usize; 2]) -> DVec3 {
        let of_u = self.basis.values(places[0], n[0]);
        let mut sum = DVec4::ZERO;
        for (row, &n_u) in self.acting(places, n).zip(&of_u) {
            let mut value = row[n[1] - 1];
            for &coefficient in row[..n[1] - 1].iter().rev() {
                value = value * places[1].s + coefficient;
            }
            sum += value * n_u;
        }
        homogeneous::project(sum)
    }

    #[inline(always)]
    pub(super) fn second_order(&self, places: [LocalParameter; 2], n: [usize; 2]) -> [DVec3; 6] {
        let of_u = self.basis.second_order(places[0], n[0]);
        let mut sums = [DVec4::ZERO; 6];
        for (i, row) in self.acting(places, n).enumerate() {
            let [value, slope, half_bend] = second_order_in_powers(&row[..n[1]], places[1].s);
            sums[0] += value * of_u[0][i];
            sums[1] += value * of_u[1][i];
            sums[2] += slope * of_u[0][i];
            sums[3] += value * of_u[2][i];
            sums[4] += slope * of_u[1][i];
            sums[5] += half_bend * of_u[0][i];
        }
        sums[5] *= 2.0;
        let per_u = self.basis.lookup.per_width(places[0].piece);
        let per_v = self.lookup.per_width(places[1].piece);
        let [s, su, sv, suu, suv, svv] = homogeneous::second_order(sums);
        [
            s,
            su * per_u,
            sv * per_v,
            suu * (per_u * per_u),
            suv * (per_u * per_v),
            svv * (per_v * per_v),
        ]
    }

    /// Looks up many places before any is used, so that none waits for its lookup.
    #[inline(always)]
    pub(super) fn each<T>(
        &self,
        parameters: &[[f64; 2]],
        at: impl Fn([LocalParameter; 2]) -> T,
        mut visit: impl FnMut(T),
    ) {
        let (mut us, mut vs) = ([0.0; BATCH], [0.0; BATCH]);
        let (mut places_u, mut places_v) =
            ([LocalParameter::default(); BATCH], [LocalParameter::default(); BATCH]);
        for parameters in parameters.chunks(BATCH) {
            let n = parameters.len();
            for ((u, v), parameters) in us.iter_mut().zip(&mut vs).zip(parameters) {
                [*u, *v] = *parameters;
            }
            self.basis.lookup.places_at(&us[..n], &mut places_u);
            self.lookup.places_at(&vs[..n], &mut places_v);
            for (&u, &v) in places_u[..n].iter().zip(&places_v) {
                visit(at([u, v]));
            }
        }
    }
}

/// The value of Σ Cₖsᵏ, its derivative, and half of its second one.
#[inline(always)]
fn second_order_in_powers(coefficients: &[DVec4], s: f64) -> [DVec4; 3] {
    let n = coefficients.len();
    let mut value = coefficients[n - 1];
    let (mut slope, mut half_bend) = (DVec4::ZERO, DVec4::ZERO);
    if 1 < n {
        slope = value;
        value = value * s + coefficients[n - 2];
    }
    if 2 < n {
        half_bend = slope;
        slope = slope * s + value;
        value = value * s + coefficients[n - 3];
        for &coefficient in coefficients[..n - 3].iter().rev() {
            half_bend = half_bend * s + slope;
            slope = slope * s + value;
            value = value * s + coefficient;
        }
    }
    [value, slope, half_bend]
}
