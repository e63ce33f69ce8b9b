//! Places of a curve that stand out: inflections, vertices, extrema, corners and cusps, and where
//! it passes through a plane.
//!
//! Each is a change of sign of a polynomial, found from Bernstein coefficients and not between
//! samples.

use std::borrow::Cow;

use glam::{DAffine3, DVec3};

use crate::{
    Frame, Interval, Side, Tolerance,
    bernstein::{derivative, product},
    curve::{
        NurbsCurve,
        intersection::bend::{BernsteinPiece, RoundedPolynomial, longest},
        measurement::same_places::SamePlaces,
    },
    frame::angle_between,
    numeric::polynomial_roots::Signs,
    scale::needed_scale,
    tolerance::{KNOT_RELATIVE, LAST_BIT, SIDE_STEP, SIGN_RELATIVE, TOUCH_RELATIVE},
    valley::{Valley, edge},
};

/// Roundings of a height within which a curve lies in a plane.
const FLAT_ROUNDINGS: f64 = 8.0;

/// Cells of an arc at whose ends its height is asked for.
const FLAT_LOOKS: usize = 8;

impl NurbsCurve {
    /// The curve and the tolerance divided by a scale, where squares of its coordinates are no numbers:
    /// it has its places that stand out at the same parameters.
    fn at_plain_scale(&self, tolerance: Tolerance) -> Option<(Self, Tolerance)> {
        let scale = needed_scale(self.bounds().magnitude())?;
        Some((self.divided_by(scale), divided(tolerance, scale)))
    }

    fn divided_by(&self, scale: f64) -> Self {
        self.transformed(&DAffine3::from_scale(DVec3::splat(scale.recip())))
    }

    /// Parameters where the curve goes over from one way of bending to the other, in order.
    ///
    /// Of a planar curve, where the signed curvature changes its sign; of a curve in space, where
    /// its curvature vanishes. Corners are none, and a curve that is straight within the tolerance
    /// has none. Where a straight stretch lies between both ways
    /// of bending, the stretch's middle.
    #[must_use]
    pub fn inflections(&self, tolerance: Tolerance) -> Vec<f64> {
        if let Some((plain, tolerance)) = self.at_plain_scale(tolerance) {
            return plain.inflections(tolerance);
        }
        if self.is_straight(tolerance) {
            return Vec::new();
        }
        let pieces = self.pieces();
        let found = match self.plane_normal(tolerance) {
            Some(normal) => self.sign_changes(&pieces, |piece| piece.bend_about(normal), tolerance),
            None => self.vanishing(&pieces, BernsteinPiece::bend, BernsteinPiece::bend_rounding),
        };
        let corners = self.corners(tolerance);
        found.into_iter().filter(|t| !self.is_among(*t, &corners)).collect()
    }

    /// Parameters where the curvature has a local extremum, signed where the curve is planar, in
    /// order. A circle has none that stands out; at a cusp the curvature has no bound, which is none.
    #[must_use]
    pub fn vertices(&self, tolerance: Tolerance) -> Vec<f64> {
        if let Some((plain, tolerance)) = self.at_plain_scale(tolerance) {
            return plain.vertices(tolerance);
        }
        let normal = self.plane_normal(tolerance);
        let slope = |piece: &BernsteinPiece| piece.curvature_slope(normal);
        let mut found = self.sign_changes(&self.pieces(), slope, tolerance);
        let corners = self.corners(tolerance);
        let (cusps, near) = (self.cusps(tolerance), TOUCH_RELATIVE * self.domain().length());
        found.retain(|&t| {
            let is_cusp = cusps.iter().any(|cusp| (t - cusp).abs() <= near);
            !is_cusp && !self.is_among(t, &corners)
        });
        found
    }

    /// Parameters where the curve reaches furthest in a direction or against it, compared with its
    /// neighbourhood, in order; ends of an open curve are none.
    #[must_use]
    pub fn extrema(&self, direction: DVec3, tolerance: Tolerance) -> Vec<f64> {
        if let Some((plain, tolerance)) = self.at_plain_scale(tolerance) {
            return plain.extrema(direction, tolerance);
        }
        self.sign_changes(&self.pieces(), |piece| piece.along(direction), tolerance)
    }

    /// Parameters where the tangent jumps to another direction without turning back, in order.
    #[must_use]
    pub fn corners(&self, tolerance: Tolerance) -> Vec<f64> {
        if let Some((plain, tolerance)) = self.at_plain_scale(tolerance) {
            return plain.corners(tolerance);
        }
        let turns_back = |a: DVec3, b: DVec3| (a + b).length() <= tolerance.angle;
        self.joints(tolerance, |a, b| tolerance.angle < angle_between(a, b) && !turns_back(a, b))
    }

    /// Parameters where the curve turns back on itself, in order.
    #[must_use]
    pub fn cusps(&self, tolerance: Tolerance) -> Vec<f64> {
        if let Some((plain, tolerance)) = self.at_plain_scale(tolerance) {
            return plain.cusps(tolerance);
        }
        let mut found = self.standstills();
        found.retain(|&t| self.turns_back(t));
        found.extend(self.joints(tolerance, |a, b| (a + b).length() <= tolerance.angle));
        found.sort_by(f64::total_cmp);
        self.without_repeats(found)
    }

    /// Parameters inside the domain where the derivative vanishes, in order.
    pub(in crate::curve) fn standstills(&self) -> Vec<f64> {
        let rounding = |piece: &BernsteinPiece| SIGN_RELATIVE * longest(&piece.velocity);
        self.vanishing(&self.pieces(), |piece| piece.velocity.clone(), rounding)
    }

    /// Parameters where the curve passes through a plane or touches it, in order. A piece that
    /// lies in the plane is told by its ends. What is nearer than the rounding of places is in it.
    #[must_use]
    pub fn plane_parameters(&self, plane: Frame, tolerance: Tolerance) -> Vec<f64> {
        let magnitude = self.magnitude().max(plane.origin().abs().max_element());
        if let Some(scale) = needed_scale(magnitude) {
            let plane = plane.at(plane.origin() / scale);
            return self.divided_by(scale).plane_parameters(plane, divided(tolerance, scale));
        }
        let rounding = FLAT_ROUNDINGS * LAST_BIT * magnitude;
        let tolerance = tolerance.with_distance(tolerance.distance.max(rounding));
        let parts = self.connected_parts();
        let of_part = |part: &Cow<'_, Self>| {
            let found = match part.near_zero() {
                Some(near) => near.plane_parameters_of_part(plane, tolerance),
                None => part.plane_parameters_of_part(plane, tolerance),
            };
            let told = found.into_iter().map(|t| part.domain().far_from_zero(t));
            told.map(|t| self.on_whole(part, t)).collect::<Vec<f64>>()
        };
        parts.iter().flat_map(of_part).collect()
    }

    /// [`Self::plane_parameters`] of a curve that does not jump.
    fn plane_parameters_of_part(&self, plane: Frame, tolerance: Tolerance) -> Vec<f64> {
        let mut signs = Signs::default();
        let height = |t: f64| (self.point_at(t) - plane.origin()).dot(plane.z());
        let mut candidates = self.knots().breaks();
        let rounding = LAST_BIT * self.magnitude();
        for piece in self.decompose() {
            let heights: Vec<f64> = piece
                .control_points()
                .iter()
                .map(|point| (point.truncate() - plane.origin() * point.w).dot(plane.z()))
                .collect();
            signs.follow(piece.domain(), &heights, rounding);
        }
        candidates.extend(self.extrema(plane.z(), tolerance));
        candidates.retain(|&t| height(t).abs() <= tolerance.distance);
        // Where the height changes its sign it is none, however far the next parameter is above the plane.
        candidates.extend(signs.changes().iter().map(|&(t, _)| t));
        candidates.sort_by(f64::total_cmp);
        let mut candidates = self.told_in_plane(candidates, |t| height(t).abs(), tolerance);
        if self.is_closed(tolerance.distance) {
            let (start, end) = (self.domain().start(), self.domain().end());
            let near = KNOT_RELATIVE.sqrt() * self.domain().length();
            let stays = |a: f64, b: f64| {
                b - a <= near && highest(&|t| height(t).abs(), a, b) <= tolerance.distance
            };
            let has_start = candidates.first().is_some_and(|&t| stays(start, t));
            candidates.retain(|&t| !has_start || !stays(t, end));
        }
        self.without_repeats(candidates)
    }

    /// Of candidates between which the curve does not leave the plane's neighbourhood the nearest;
    /// of those between which it stays at one height the first and the last.
    fn told_in_plane(
        &self,
        sorted: Vec<f64>,
        height: impl Fn(f64) -> f64,
        tolerance: Tolerance,
    ) -> Vec<f64> {
        let rounding = FLAT_ROUNDINGS * LAST_BIT * self.magnitude();
        let highest = |a: f64, b: f64| highest(&height, a, b);
        let mut told: Vec<f64> = Vec::new();
        for run in sorted.chunk_by(|&a, &b| highest(a, b) <= tolerance.distance) {
            let level = run.iter().map(|&t| height(t)).fold(f64::INFINITY, f64::min) + rounding;
            let lowest: Vec<f64> = run.iter().copied().filter(|&t| height(t) <= level).collect();
            for flat in lowest.chunk_by(|&a, &b| highest(a, b) <= level) {
                let [first, .., last] = *flat else {
                    told.extend_from_slice(flat);
                    continue;
                };
                let bottom = self.touched([first, last], &height, tolerance);
                told.extend(bottom.map_or(vec![first, last], |bottom| vec![bottom]));
            }
        }
        told
    }

    /// The one place where a curve touches a plane about a floor, unless it lies in the plane there.
    fn touched(
        &self,
        [first, last]: [f64; 2],
        height: &impl Fn(f64) -> f64,
        tolerance: Tolerance,
    ) -> Option<f64> {
        let is_near = |t: f64| height(t) <= tolerance.distance;
        let start = edge(&is_near, first, self.domain().start());
        let stretch = Interval::new(start, edge(&is_near, last, self.domain().end())).ok()?;
        let valley = Valley::of(height, stretch, LAST_BIT * self.magnitude());
        let is_touch = valley.is_single
            && valley.rises_to(0.5 * tolerance.distance, [false; 2])
            && valley.floor.length() <= 0.5 * stretch.length();
        is_touch.then_some(valley.bottom)
    }

    /// Where a polynomial of the pieces changes its sign, at the seam of a closed curve too.
    fn sign_changes(
        &self,
        pieces: &[BernsteinPiece],
        of: impl Fn(&BernsteinPiece) -> RoundedPolynomial,
        tolerance: Tolerance,
    ) -> Vec<f64> {
        let mut signs = Signs::default();
        for piece in pieces {
            let RoundedPolynomial { coefficients, rounding } = of(piece);
            signs.follow(piece.interval, &coefficients, rounding);
        }
        let at_seam = self.is_closed(tolerance.distance) && signs.changes_at_seam();
        let seam = at_seam.then(|| self.domain().start());
        // Where the curve jumps nothing passes from one side to the other.
        let jumps = self.jumps();
        let is_jump = |t: f64| jumps.iter().any(|&(at, _)| self.is_among(t, &[at]));
        let changes = signs.changes().iter().map(|&(t, _)| t).filter(|&t| !is_jump(t));
        if !at_seam {
            return self.without_repeats(changes.collect());
        }
        // The seam is told once: what rounding leaves beside it on either side is that.
        let same = SamePlaces::of(self);
        let others = changes.filter(|&t| !same.is_end(t));
        same.once(seam.into_iter().chain(others).collect())
    }

    /// Where a polynomial vector of the pieces vanishes: where its length has a minimum of nothing.
    fn vanishing(
        &self,
        pieces: &[BernsteinPiece],
        of: impl Fn(&BernsteinPiece) -> Vec<DVec3>,
        rounding: impl Fn(&BernsteinPiece) -> f64,
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
        let turns = |&(left, right): &(f64, f64)| {
            let before = self.tangent_at(left, Side::Left);
            let behind = self.tangent_at(right, Side::Right);
            before.ok().zip(behind.ok()).is_some_and(|(before, behind)| differ(before, behind))
        };
        let jumps = self.jumps();
        let is_jump = |t: f64| jumps.iter().any(|(at, _)| at.total_cmp(&t).is_eq());
        pairs.filter(|&(left, _)| !is_jump(left)).filter(turns).map(|(_, t)| t).collect()
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
    pub(in crate::curve) fn without_repeats(&self, sorted: Vec<f64>) -> Vec<f64> {
        if sorted.len() < 2 { sorted } else { SamePlaces::of(self).once(sorted) }
    }
}

/// The greatest height at some places of an arc; of none if that has no length.
fn highest(height: &impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    let arc = Interval::new(a, b).map(|arc| arc.steps(FLAT_LOOKS));
    arc.map_or(0.0, |places| places.into_iter().map(height).fold(0.0, f64::max))
}

/// A tolerance for what is divided by a scale.
fn divided(tolerance: Tolerance, scale: f64) -> Tolerance {
    tolerance.with_distance(tolerance.distance / scale)
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
