//! Where a curve passes through a surface or touches it.
//!
//! As in `surface_intersection`, with pieces of the curve and their cones of tangents: a piece and a part of the
//! surface whose cones are clear of one another have one point in common at most, which Newton's
//! method finds.

use std::sync::Arc;

use super::{
    bezier_segment::{BezierSegment, LyingPiece},
    far::piercings_near_zero,
    pair::{SurfacePart, SurfacePatches},
    results::CurveSurfaceIntersection,
    scaled::CommonScale,
};
use crate::{
    Bounds, Curve, GeomError, NurbsCurve, NurbsSurface, Surface, Tolerance,
    ceiling::{CROSSING_STEPS, SURFACE_PAIRS},
    frame::norm,
    nearest::BoxedPiece,
    numeric::{
        linear::solved,
        newton::{NewtonStep, within_limits},
    },
    sorting::sort_by,
    tolerance::{FLAT_SHARE, LAST_BIT, PLACE_RELATIVE},
    work,
};

/// Roundings of places below which nothing is told apart, whatever the tolerance.
const TOLD_ROUNDINGS: f64 = 64.0;

impl Surface {
    /// Every place that a curve has in common with the surface, within the tolerance's distance, by
    /// the parameter on the curve.
    ///
    /// # Errors
    /// [`super::PictureError::RunsAlong`] where they share a stretch; for functions as
    /// [`crate::ParametricSurface::to_nurbs`].
    pub fn piercings(
        &self,
        curve: &Curve,
        tolerance: Tolerance,
    ) -> Result<Vec<CurveSurfaceIntersection>, GeomError> {
        let spline = self.splined(super::plane::SPLINE_SHARE * tolerance.distance)?;
        let curve = curve.spline()?;
        let magnitude = curve.bounds().magnitude().max(spline.bounds().magnitude());
        if let Some(scale) = CommonScale::needed(magnitude) {
            let surface = scale.surface(&Self::Nurbs(spline))?;
            let curve = scale.curve(&Curve::Nurbs(curve));
            return scale.piercings(surface.piercings(&curve, scale.tolerance(tolerance)));
        }
        if let Some(found) = piercings_near_zero(&curve, &spline, tolerance) {
            return found;
        }
        let size = curve.bounds().diagonal().max(spline.bounds().diagonal());
        let rounding = LAST_BIT * magnitude;
        let tolerance = tolerance.distance_for(size).max(TOLD_ROUNDINGS * rounding);
        let touch_size = (tolerance * size).sqrt();
        let search =
            PiercingSearch { curve: &curve, surface: &spline, tolerance, touch_size, rounding };
        search.run()
    }
}

/// A search for what a curve and a surface share.
pub(super) struct PiercingSearch<'a> {
    pub(super) curve: &'a NurbsCurve,
    pub(super) surface: &'a NurbsSurface,
    pub(super) tolerance: f64,
    /// Pieces that touch are no larger than this.
    touch_size: f64,
    /// What a distance may be wrong by.
    pub(super) rounding: f64,
}

impl PiercingSearch<'_> {
    fn run(&self) -> Result<Vec<CurveSurfaceIntersection>, GeomError> {
        let flat = FLAT_SHARE * self.tolerance;
        let mut todo = self.near_pairs();
        let mut crossings = Vec::new();
        let mut lying: Vec<LyingPiece> = Vec::new();
        let mut unresolved: Vec<LyingPiece> = Vec::new();
        let mut n_pairs = 0;
        while work::goes_on(1)
            && let Some((piece, part)) = todo.pop()
        {
            n_pairs += 1;
            if SURFACE_PAIRS < n_pairs {
                return Err(self.runs_along(piece.ends));
            }
            let is_crossed = part.is_crossed_by(piece.axis, piece.angle);
            if is_crossed && let Some(place) = self.crossing(&piece, &part) {
                crossings.push(place);
                continue;
            }
            let sizes = [piece.bounds.diagonal(), part.bounds.diagonal()];
            let widest = sizes[0].max(sizes[1]);
            let is_flat = piece.deviation().max(part.thickness()) <= flat;
            if is_flat && widest <= self.touch_size && !is_crossed {
                lying.push(LyingPiece::new(&piece, widest));
                continue;
            }
            if widest <= self.tolerance {
                unresolved.push(LyingPiece::new(&piece, widest));
                continue;
            }
            let halves: [_; 2] = if sizes[1] <= sizes[0] {
                piece.halves().map(|half| (Arc::new(half), Arc::clone(&part)))
            } else {
                part.halves().map(|half| (Arc::clone(&piece), Arc::new(half)))
            };
            let is_near = |(piece, part): &(Arc<BezierSegment>, Arc<SurfacePart>)| {
                !part.is_beside(piece.bounds, &piece.places, self.tolerance)
            };
            todo.extend(halves.into_iter().filter(is_near));
        }
        // Beside a crossing, its neighbours come as near; where there is none, they are what there is.
        unresolved.retain(|piece| !crossings.iter().any(|place| self.is_at(piece, place)));
        lying.extend(unresolved);
        let touches = self.touches(lying)?;
        Ok(self.in_order(self.nearest_places(crossings, touches)))
    }

    /// Pieces of the curve and parts of the surface that are near to one another; no piece is larger
    /// than its part, lest a long one is near to all that its box holds.
    fn near_pairs(&self) -> Vec<(Arc<BezierSegment>, Arc<SurfacePart>)> {
        let mut patches = SurfacePatches::new(self.surface);
        let spans = self.curve.knots().spans();
        let whole = spans.map(|span| Arc::new(BezierSegment::of_span(self.curve, span))).collect();
        let pairs = self.surface.patch_boxes().near_pieces(whole, self.tolerance);
        let mut todo = Vec::new();
        for (piece, spans) in pairs {
            let part = patches.part(spans);
            let part =
                part.filter(|part| !part.is_beside(piece.bounds, &piece.places, self.tolerance));
            todo.extend(part.map(|part| (piece, part)));
        }
        todo
    }

    /// Whether a place is within the tolerance of a piece.
    fn is_at(&self, piece: &LyingPiece, place: &CurveSurfaceIntersection) -> bool {
        let here = Bounds { min: place.point, max: place.point };
        piece.bounds.is_near(here, self.tolerance)
    }

    /// The one place of a piece and a part that cross clearly, if it is in both.
    fn crossing(
        &self,
        piece: &BezierSegment,
        part: &SurfacePart,
    ) -> Option<CurveSurfaceIntersection> {
        let [u, v] = part.middle();
        let start = [0.5 * (piece.ends[0] + piece.ends[1]), u, v];
        let domains = [self.curve.domain(), self.surface.domain_u(), self.surface.domain_v()];
        let limits = domains.map(|domain| [domain.start(), domain.end()]);
        let is_still = |last: [f64; 3], next: [f64; 3]| {
            (0..3).all(|i| (next[i] - last[i]).abs() <= LAST_BIT * domains[i].length())
        };
        let found = within_limits(limits, start, CROSSING_STEPS, is_still, |at| {
            let derivatives = self.curve.velocity_at(at[0]);
            let [point, by_u, by_v] = self.surface.tangents_at(at[1], at[2]);
            let apart = derivatives[0] - point;
            let mut columns = [derivatives[1], -by_u, -by_v];
            // At a pole a parameter is as good as any other: it stays.
            let stays = [1, 2]
                .map(|k| norm(columns[k]) * domains[k].length() <= TOLD_ROUNDINGS * self.rounding);
            for (k, other) in [(1, 2), (2, 1)] {
                if stays[k - 1] {
                    columns[k] = columns[0].cross(columns[other]);
                }
            }
            let matrix = std::array::from_fn(|i| std::array::from_fn(|k| columns[k][i]));
            let step = solved(matrix, (-apart).to_array());
            let moved = |step: [f64; 3]| {
                std::array::from_fn(|k| if 0 < k && stays[k - 1] { 0.0 } else { step[k] })
            };
            NewtonStep::perhaps(step.map(moved))
        });
        let [t, u, v] = found.unless_stuck()?;
        let slack = PLACE_RELATIVE * (piece.ends[1] - piece.ends[0]);
        let is_inside = piece.ends[0] - slack <= t && t <= piece.ends[1] + slack;
        (is_inside && part.holds([u, v])).then(|| self.piercing(t, [u, v]))?
    }

    /// The place at parameters of both, if they meet there.
    pub(super) fn piercing(&self, t: f64, uv: [f64; 2]) -> Option<CurveSurfaceIntersection> {
        let (p, q) = (self.curve.point_at(t), self.surface.point_at(uv[0], uv[1]));
        let apart = p.distance(q);
        // The last bits of the parameters may not let them come nearer.
        let is_met = apart <= self.tolerance || {
            let [_, by_u, by_v] = self.surface.tangents_at(uv[0], uv[1]);
            let steps = [(self.curve.velocity_at(t)[1], t), (by_u, uv[0]), (by_v, uv[1])];
            let reach: f64 = steps.iter().map(|&(by, at)| norm(by) * LAST_BIT * at.abs()).sum();
            apart <= self.tolerance + reach
        };
        is_met.then(|| CurveSurfaceIntersection { t, uv, point: p.midpoint(q) })
    }

    /// In the order of the curve, each place once.
    fn in_order(&self, mut found: Vec<CurveSurfaceIntersection>) -> Vec<CurveSurfaceIntersection> {
        let domain = self.curve.domain();
        let near = LAST_BIT.sqrt() * domain.length();
        if self.curve.is_closed(self.tolerance) {
            let at_end = |place: &&mut CurveSurfaceIntersection| {
                domain.end() - place.t <= near
                    && norm(place.point - self.curve.end()) <= 2.0 * self.tolerance
            };
            found.iter_mut().filter(at_end).for_each(|place| place.t = domain.start());
        }
        let order = |a: &CurveSurfaceIntersection, b: &CurveSurfaceIntersection| {
            let [a, b] = [a, b].map(|place| (place.t, place.uv[0], place.uv[1]));
            a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.total_cmp(&b.2))
        };
        sort_by(&mut found, order);
        let mut kept: Vec<CurveSurfaceIntersection> = Vec::new();
        for place in found {
            let known = kept.iter_mut().rev().find(|other| {
                (place.t - other.t).abs() <= near.max(LAST_BIT.sqrt())
                    && norm(place.point - other.point) <= self.tolerance
            });
            match known {
                Some(other) => {
                    let is_before = (place.uv[0], place.uv[1]) < (other.uv[0], other.uv[1]);
                    if is_before {
                        other.uv = place.uv;
                    }
                }
                None => kept.push(place),
            }
        }
        kept
    }
}
