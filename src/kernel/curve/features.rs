//! Places of a curve that stand out: inflections, vertices, extrema, corners and cusps, and where
//! it passes through a plane.
//!
//! Each is a change of sign of a polynomial, found from Bernstein coefficients and not between
//! samples.

use glam::DVec3;

use super::{
    NurbsCurve,
    bend::{Piece, Rounded, longest},
};
use crate::kernel::{
    Frame, Side, Tolerance,
    bernstein::{derivative, product},
    roots::Signs,
    tolerance::{KNOT_RELATIVE, LAST_BIT, SIDE_STEP, SIGN_RELATIVE, TOUCH_RELATIVE},
};

impl NurbsCurve {
    /// Parameters where the curve goes over from one way of bending to the other, in order.
    ///
    /// Of a planar curve, where the signed curvature changes its sign; of a curve in space, where
    /// its curvature vanishes. Corners are none. Where a straight stretch lies between both ways
    /// of bending, the stretch's middle.
    #[must_use]
    pub fn inflections(&self, tolerance: Tolerance) -> Vec<f64> {
        let pieces = self.pieces();
        let found = match self.plane_normal(tolerance) {
            Some(normal) => self.sign_changes(&pieces, |piece| piece.bend_about(normal), tolerance),
            None => self.vanishing(&pieces, Piece::bend, Piece::bend_rounding),
        };
        let corners = self.corners(tolerance);
        found.into_iter().filter(|t| !self.is_among(*t, &corners)).collect()
    }

    /// Parameters where the curvature has a local extremum, signed where the curve is planar, in
    /// order. A circle has none that stands out.
    #[must_use]
    pub fn vertices(&self, tolerance: Tolerance) -> Vec<f64> {
        let normal = self.plane_normal(tolerance);
        let slope = |piece: &Piece| piece.curvature_slope(normal);
        let found = self.sign_changes(&self.pieces(), slope, tolerance);
        let corners = self.corners(tolerance);
        found.into_iter().filter(|t| !self.is_among(*t, &corners)).collect()
    }

    /// Parameters where the curve reaches furthest in a direction or against it, compared with its
    /// neighbourhood, in order; ends of an open curve are none.
    #[must_use]
    pub fn extrema(&self, direction: DVec3, tolerance: Tolerance) -> Vec<f64> {
        self.sign_changes(&self.pieces(), |piece| piece.along(direction), tolerance)
    }

    /// Parameters where the tangent jumps to another direction without turning back, in order.
    #[must_use]
    pub fn corners(&self, tolerance: Tolerance) -> Vec<f64> {
        let turns_back = |a: DVec3, b: DVec3| (a + b).length() <= tolerance.angle;
        self.joints(tolerance, |a, b| tolerance.angle < a.angle_between(b) && !turns_back(a, b))
    }

    /// Parameters where the curve turns back on itself, in order.
    #[must_use]
    pub fn cusps(&self, tolerance: Tolerance) -> Vec<f64> {
        let mut found = self.standstills();
        found.retain(|&t| self.turns_back(t));
        found.extend(self.joints(tolerance, |a, b| (a + b).length() <= tolerance.angle));
        found.sort_by(f64::total_cmp);
        self.without_repeats(found)
    }

    /// Parameters inside the domain where the derivative vanishes, in order.
    pub(super) fn standstills(&self) -> Vec<f64> {
        let rounding = |piece: &Piece| SIGN_RELATIVE * longest(&piece.velocity);
        self.vanishing(&self.pieces(), |piece| piece.velocity.clone(), rounding)
    }

    /// Parameters where the curve passes through a plane or touches it, in order. A piece that
    /// lies in the plane is told by its ends.
    #[must_use]
    pub fn plane_parameters(&self, plane: Frame, tolerance: Tolerance) -> Vec<f64> {
        let mut signs = Signs::default();
        let height = |t: f64| (self.point_at(t) - plane.origin()).dot(plane.z());
        let mut candidates = self.knots().breaks();
        for piece in self.decompose() {
            let heights: Vec<f64> = piece
                .control_points()
                .iter()
                .map(|point| (point.truncate() - plane.origin() * point.w).dot(plane.z()))
                .collect();
            let rounding = LAST_BIT * self.magnitude();
            signs.follow(piece.domain(), &heights, rounding);
        }
        candidates.extend(signs.changes().iter().map(|&(t, _)| t));
        candidates.extend(self.extrema(plane.z(), tolerance));
        candidates.retain(|&t| height(t).abs() <= tolerance.distance);
        candidates.sort_by(f64::total_cmp);
        if self.is_closed(tolerance.distance) {
            let end = self.domain().end();
            let near = KNOT_RELATIVE.sqrt() * self.domain().length();
            let has_start = candidates.first().is_some_and(|t| t - self.domain().start() <= near);
            candidates.retain(|t| !has_start || near < end - t);
        }
        self.without_repeats(candidates)
    }

    /// Where a polynomial of the pieces changes its sign, at the seam of a closed curve too.
    fn sign_changes(
        &self,
        pieces: &[Piece],
        of: impl Fn(&Piece) -> Rounded,
        tolerance: Tolerance,
    ) -> Vec<f64> {
        let mut signs = Signs::default();
        for piece in pieces {
            let Rounded { coefficients, rounding } = of(piece);
            signs.follow(piece.interval, &coefficients, rounding);
        }
        let at_seam = self.is_closed(tolerance.distance) && signs.changes_at_seam();
        let seam = at_seam.then(|| self.domain().start());
        let found = seam.into_iter().chain(signs.changes().iter().map(|&(t, _)| t)).collect();
        self.without_repeats(found)
    }

    /// Where a polynomial vector of the pieces vanishes: where its length has a minimum of nothing.
    fn vanishing(
        &self,
        pieces: &[Piece],
        of: impl Fn(&Piece) -> Vec<DVec3>,
        rounding: impl Fn(&Piece) -> f64,
    ) -> Vec<f64> {
        let most = pieces.iter().map(|piece| longest(&of(piece))).fold(0.0, f64::max);
        let mut found = Vec::new();
        for piece in pieces {
            let vector = of(piece);
            if longest(&vector) <= rounding(piece) {
                continue;
            }
            let slope = product(&vector, &derivative(&vector), DVec3::dot);
            let mut signs = Signs::default();
            signs.follow(piece.interval, &slope, rounding(piece) * longest(&vector));
            let minima = signs.changes().iter().filter(|&&(_, sign)| sign > 0).map(|&(t, _)| t);
            let ends = [piece.interval.start(), piece.interval.end()];
            let length = |t: f64| {
                let local = piece.interval.fraction_of(t);
                value_of(&vector, local).length()
            };
            found.extend(minima.chain(ends).filter(|&t| length(t) <= TOUCH_RELATIVE * most));
        }
        found.retain(|&t| self.domain().start() < t && t < self.domain().end());
        found.sort_by(f64::total_cmp);
        self.without_repeats(found)
    }

    /// Interior knots, and the seam of a closed curve, where the tangents of both sides differ so.
    fn joints(&self, tolerance: Tolerance, differ: impl Fn(DVec3, DVec3) -> bool) -> Vec<f64> {
        let domain = self.domain();
        let knots = self.knots().distinct();
        let inner = knots.iter().filter(|&&(t, times)| {
            domain.start() < t && t < domain.end() && self.degree() <= times
        });
        let seam = self.is_closed(tolerance.distance).then_some((domain.end(), domain.start()));
        let pairs = seam.into_iter().chain(inner.map(|&(t, _)| (t, t)));
        let jumps = |&(left, right): &(f64, f64)| {
            let before = self.tangent_at(left, Side::Left);
            let behind = self.tangent_at(right, Side::Right);
            before.ok().zip(behind.ok()).is_some_and(|(before, behind)| differ(before, behind))
        };
        pairs.filter(jumps).map(|(_, t)| t).collect()
    }

    /// Whether the velocity points back behind a place where it vanishes.
    fn turns_back(&self, t: f64) -> bool {
        let width = |side: Side| {
            self.knots().span_interval(self.knots().span_beside(t, side)).length() * SIDE_STEP
        };
        let velocity = |t: f64| self.derivatives_at(t, 1)[1];
        let (before, behind) = (velocity(t - width(Side::Left)), velocity(t + width(Side::Right)));
        before.dot(behind) < 0.0
    }

    fn is_among(&self, t: f64, others: &[f64]) -> bool {
        let near = KNOT_RELATIVE * self.domain().length();
        others.iter().any(|other| (t - other).abs() <= near)
    }

    /// Sorted parameters without those that are one within rounding.
    pub(super) fn without_repeats(&self, mut sorted: Vec<f64>) -> Vec<f64> {
        let near = LAST_BIT.sqrt() * self.domain().length();
        sorted.dedup_by(|later, earlier| *later - *earlier <= near);
        sorted
    }
}

/// The value of a vector polynomial at a local parameter.
fn value_of(coefficients: &[DVec3], t: f64) -> DVec3 {
    let mut row = coefficients.to_vec();
    for n_left in (1..row.len()).rev() {
        for i in 0..n_left {
            row[i] = row[i].lerp(row[i + 1], t);
        }
    }
    row[0]
}
