//! The edges of sheets, and where corners lie on them.

use std::sync::OnceLock;

use glam::{DVec3, DVec4};

use super::surface_patch::SurfacePatch;
use crate::{
    Bounds, GeomError, Interval, NurbsCurve, bezier,
    ceiling::{EDGE_FOOT_STEPS, PARAMETER_HALVINGS},
    curve::ArcLengths,
    homogeneous::project,
    numeric::newton::{to_foot, try_within_limits},
    sorting::sort_by,
    surface::Crease,
    tolerance::LAST_BIT,
    work,
};

/// An edge of a sheet: u0, u1, v0 or v1 by its number.
#[derive(Debug)]
pub(super) struct PatchEdge {
    pub(super) sheet: usize,
    pub(super) number: usize,
    pub(super) curve: NurbsCurve,
    /// Found when it is asked for the first time: edges that are points need none.
    lengths: OnceLock<ArcLengths>,
    /// What its ends are welded to.
    pub(super) corners: [u32; 2],
    /// Whether it is one point.
    pub(super) is_point: bool,
}

/// A place on an edge where a corner is.
#[derive(Clone, Copy, Debug)]
pub(super) struct EdgeCorner {
    pub(super) parameter: f64,
    /// How much of the edge's length is before it.
    pub(super) fraction: f64,
    pub(super) corner: u32,
}

impl EdgeCorner {
    /// Whether it is at the place of another one, to the last bit.
    pub(super) fn is_at(&self, other: &Self) -> bool {
        let bits = |corner: &Self| [corner.parameter, corner.fraction].map(f64::to_bits);
        bits(self) == bits(other)
    }
}

/// A part of an edge that may hold corners.
struct EdgePart {
    points: Vec<DVec4>,
    interval: Interval,
    corners: Vec<u32>,
    n_halvings: usize,
}

impl PatchEdge {
    /// An edge of the sheet of this index.
    pub(super) fn new(
        sheet: usize,
        number: usize,
        curve: NurbsCurve,
        corners: [u32; 2],
        weld: f64,
    ) -> Self {
        let size = Bounds::of(curve.points()).map_or(0.0, Bounds::diagonal);
        let lengths = OnceLock::new();
        Self { sheet, number, curve, lengths, corners, is_point: size <= weld }
    }

    /// A box that it is in; none where weights do not tell.
    pub(super) fn hull(&self) -> Option<Bounds> {
        hull(self.curve.control_points())
    }

    pub(super) fn domain(&self) -> Interval {
        self.curve.domain()
    }

    fn lengths(&self) -> &ArcLengths {
        self.lengths.get_or_init(|| self.curve.arc_lengths())
    }

    /// The parameter before which a fraction of its length is.
    pub(super) fn parameter(&self, fraction: f64) -> f64 {
        self.curve.at_fraction(self.lengths(), fraction)
    }

    /// How much of its length is before a parameter.
    pub(super) fn fraction(&self, parameter: f64) -> f64 {
        self.curve.fraction_at(self.lengths(), parameter)
    }

    /// The point of its surface.
    ///
    /// # Errors
    /// Those of [`SurfacePatch::point_at`].
    pub(super) fn point(&self, sheet: &SurfacePatch<'_>, t: f64) -> Result<DVec3, GeomError> {
        let [u, v] = sheet.domains();
        match self.number {
            0 => sheet.point_at(u.start(), t),
            1 => sheet.point_at(u.end(), t),
            2 => sheet.point_at(t, v.start()),
            _ => sheet.point_at(t, v.end()),
        }
    }

    /// Where lines end on it along which its surface has a break.
    pub(super) fn breaks<'a>(&self, sheet: &'a SurfacePatch<'_>) -> &'a [Crease] {
        // Lines of constant u end on edges along u.
        &sheet.breaks[usize::from(self.number < 2)]
    }

    /// Its ends, and between them those of the corners `near` that are no further than `weld` from
    /// it, in order; of several that are no further apart than that, one. `slack` is how far its
    /// points may be from its curve.
    ///
    /// # Errors
    /// Those of [`SurfacePatch::point_at`].
    pub(super) fn cuts(
        &self,
        sheet: &SurfacePatch<'_>,
        corners: &[DVec3],
        near: &[u32],
        [weld, slack]: [f64; 2],
    ) -> Result<Vec<EdgeCorner>, GeomError> {
        let mut found = Vec::new();
        for (about, span, corner) in self.feet(corners, near, weld + slack) {
            let place = corners[corner as usize];
            let Some(parameter) = self.foot(sheet, place, [about, weld], span)? else { continue };
            let fraction = self.fraction(parameter);
            found.push(EdgeCorner { parameter, fraction, corner });
        }
        // No two places of a shorter stretch are further apart than the weld.
        let least = if found.is_empty() { 0.0 } else { weld / self.lengths().total() };
        if !found.is_empty() {
            for line in self.breaks(sheet) {
                let fraction = self.fraction(line.at);
                let is_near = |cut: &&mut EdgeCorner| (cut.fraction - fraction).abs() <= least;
                for cut in found.iter_mut().filter(is_near) {
                    *cut = EdgeCorner { parameter: line.at, fraction, ..*cut };
                }
            }
        }
        sort_by(&mut found, |a, b| a.fraction.total_cmp(&b.fraction).then(a.corner.cmp(&b.corner)));
        let ([first, last], domain) = (self.corners, self.domain());
        let mut cuts = vec![EdgeCorner { parameter: domain.start(), fraction: 0.0, corner: first }];
        for cut in found {
            let before = cuts[cuts.len() - 1].fraction;
            if least < cut.fraction - before && least < 1.0 - cut.fraction {
                cuts.push(cut);
            }
        }
        cuts.push(EdgeCorner { parameter: domain.end(), fraction: 1.0, corner: last });
        Ok(cuts)
    }

    /// Parameters near which the curve is no further than `reach` from corners, and the spans that
    /// they are in.
    fn feet(&self, corners: &[DVec3], near: &[u32], reach: f64) -> Vec<(f64, Interval, u32)> {
        let is_inner = |corner: &u32| !self.corners.contains(corner);
        let is_near = |hull: Option<Bounds>, corner: u32| {
            hull.is_none_or(|hull| hull.contains(corners[corner as usize], reach))
        };
        let (knots, whole) = (self.curve.knots(), self.hull());
        let near: Vec<u32> = near
            .iter()
            .copied()
            .filter(|&corner| is_near(whole, corner))
            .filter(is_inner)
            .collect();
        let mut feet = Vec::new();
        if near.is_empty() {
            return feet;
        }
        for span in knots.spans() {
            let interval = knots.span_interval(span);
            let points = bezier::piece(knots, self.curve.control_points(), span);
            let corners = near.clone();
            let mut todo = vec![EdgePart { points, interval, corners, n_halvings: 0 }];
            while work::goes_on(1)
                && let Some(mut part) = todo.pop()
            {
                let hull = hull(&part.points);
                part.corners.retain(|&corner| is_near(hull, corner));
                if part.corners.is_empty() {
                    continue;
                }
                let is_place = hull.is_some_and(|hull| hull.diagonal() <= reach);
                if is_place || PARAMETER_HALVINGS <= part.n_halvings {
                    let middle = part.interval.at(0.5);
                    feet.extend(part.corners.iter().map(|&corner| (middle, interval, corner)));
                } else {
                    todo.extend(part.halves());
                }
            }
        }
        feet
    }

    /// The parameter in a span where a place is nearest to the surface's own edge, by Newton's
    /// method; none if that is further than the weld.
    fn foot(
        &self,
        sheet: &SurfacePatch<'_>,
        place: DVec3,
        [start, weld]: [f64; 2],
        span: Interval,
    ) -> Result<Option<f64>, GeomError> {
        let limits = [span.start(), span.end()];
        let is_still =
            |[t]: [f64; 1], [next]: [f64; 1]| (next - t).abs() <= LAST_BIT * span.length();
        let found = try_within_limits([limits], [start], EDGE_FOOT_STEPS, is_still, |[t]| {
            let offset = place - self.point(sheet, t)?;
            Ok::<_, GeomError>(to_foot(offset, self.curve.derivatives_at(t, 1)[1]))
        })?;
        let [t] = found.place();
        Ok((self.point(sheet, t)?.distance(place) <= weld).then_some(t))
    }
}

impl EdgePart {
    /// Both halves, the second first.
    fn halves(self) -> [Self; 2] {
        let (left, right) = bezier::cut_at(&self.points, 0.5);
        let [before, behind] = self.interval.halves();
        let n_halvings = self.n_halvings + 1;
        let half = |points, interval, corners| Self { points, interval, corners, n_halvings };
        [half(right, behind, self.corners.clone()), half(left, before, self.corners)]
    }
}

/// The box around control points; none where weights do not tell.
fn hull(points: &[DVec4]) -> Option<Bounds> {
    let are_positive = points.iter().all(|point| 0.0 < point.w);
    are_positive.then(|| Bounds::of(points.iter().map(|&point| project(point)))).flatten()
}
