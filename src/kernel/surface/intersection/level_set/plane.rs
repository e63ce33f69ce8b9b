//! Plane sections of surfaces, exact fields: the height above the plane times the denominator.

use super::{
    CommonScale, LevelSet, ScalarField, ZeroSetParts, square,
    verify::{self, CurveOrigin},
};
use crate::{
    Frame, GeomError, Grid, NurbsCurve, NurbsSurface, Surface, Tolerance, tolerance::LAST_BIT,
};

/// Rounding of a height, in last bits of what it is computed of.
const ROUNDING: f64 = 16.0 * LAST_BIT;

/// Part of the tolerance that a spline in the place of a function uses up.
pub(super) const SPLINE_SHARE: f64 = 0.25;

impl Surface {
    /// The lines in which a plane cuts the surface or touches it, within the tolerance's distance
    /// and complete; a function is cut as a spline that near.
    ///
    /// A patch that lies in the plane is told by its border, a line along which the plane touches
    /// the surface as a line, a point in which it touches as a point. Lines are exact where they are conics, and cubic splines in the
    /// plane, parametrized about by their length.
    ///
    /// # Errors
    /// [`super::PictureError::Unresolved`] where the surface runs so near along the plane that rounding
    /// decides where it cuts; for functions as [`crate::ParametricSurface::to_nurbs`].
    pub fn section(&self, plane: Frame, tolerance: Tolerance) -> Result<LevelSet, GeomError> {
        if let Some((scaled, scale)) = CommonScale::of(self) {
            return scale.lines(scaled.section(scale.plane(plane), scale.tolerance(tolerance)));
        }
        match self {
            Self::Nurbs(surface) => surface.section(plane, tolerance),
            Self::Parametric(_) => {
                let distance = tolerance.distance;
                let spline = self.splined(SPLINE_SHARE * distance)?;
                let rest = tolerance.with_distance((1.0 - SPLINE_SHARE) * distance);
                spline.section(plane, rest)
            }
        }
    }
}

impl NurbsSurface {
    /// As [`Surface::section`].
    ///
    /// # Errors
    /// [`super::PictureError::Unresolved`] where the surface runs so near along the plane that rounding
    /// decides where it cuts.
    pub fn section(&self, plane: Frame, tolerance: Tolerance) -> Result<LevelSet, GeomError> {
        if let Some(near) = self.near_zero() {
            return self.told_here(near.section(plane, tolerance));
        }
        let distance = self.line_tolerance(tolerance)?;
        let circle = self.circle_of_ball(plane, distance).map(|circle| vec![circle]);
        let circles = circle.or_else(|| self.circles_across(plane, distance));
        let ellipse = || self.ellipse_around(plane, distance).map(|ellipse| vec![ellipse]);
        if let Some(curves) = circles.or_else(ellipse) {
            return Ok(LevelSet { curves, ..LevelSet::default() });
        }
        let mut found = self.lines_in(plane, distance, tolerance)?;
        found.curves = self.exact_in_plane(found.curves, plane, distance);
        Ok(found)
    }

    /// The circles that it has in a plane across the axis about which it turns, where it crosses that in nothing else.
    fn circles_across(&self, plane: Frame, distance: f64) -> Option<Vec<NurbsCurve>> {
        self.plane_about(plane).ok()?.coaxial_crossings(self, distance)
    }

    fn lines_in(
        &self,
        plane: Frame,
        distance: f64,
        tolerance: Tolerance,
    ) -> Result<LevelSet, GeomError> {
        let found = self.zeros_of_height(plane, distance);
        if verify::is_certain(&found, distance) {
            return found;
        }
        // Where lines cross at a small angle, rounding of the heights may leave crumbs of them.
        let again = self
            .plane_about(plane)
            .and_then(|patch| Surface::from(patch).intersections(&self.clone().into(), tolerance));
        if verify::is_certain(&again, distance) {
            return again;
        }
        found.or_else(|refused| again.map_err(|_| refused))
    }

    /// A piece of the plane about all of the surface that could be in it.
    fn plane_about(&self, plane: Frame) -> Result<Self, GeomError> {
        let bounds = self.bounds();
        let center = bounds.center() - plane.origin();
        let [x, y] = [plane.x() * bounds.diagonal(), plane.y() * bounds.diagonal()];
        let foot = plane.origin() + center - plane.z() * center.dot(plane.z());
        Self::bilinear(foot - x - y, foot - x + y, foot + x - y, foot + x + y)
    }

    /// The lines along which the height above the plane vanishes.
    fn zeros_of_height(&self, plane: Frame, tolerance: f64) -> Result<LevelSet, GeomError> {
        let (origin, normal) = (plane.origin(), plane.z());
        let height = |point: &glam::DVec4| (point.truncate() - origin * point.w).dot(normal);
        let heights = self.control_points.map(height);
        let magnitude = |points: &Grid<glam::DVec4>| {
            let sizes = points.iter().map(|p| p.truncate().length() + origin.length() * p.w.abs());
            sizes.fold(0.0, f64::max)
        };
        let rounding = ROUNDING * magnitude(&self.control_points);
        let spans = [&self.knots_u, &self.knots_v].map(|knots| knots.spans().collect::<Vec<_>>());
        let mut collected = ZeroSetParts::new(tolerance);
        for &span_u in &spans[0] {
            for &span_v in &spans[1] {
                let (rows, columns) = (self.knots_u.support(span_u), self.knots_v.support(span_v));
                let [least, most] = range_of(&heights, rows, columns);
                if rounding < least || most < -rounding {
                    continue;
                }
                let patch = self.patch(span_u, span_v);
                let values = patch.control_points.map(height);
                let least_weight =
                    patch.control_points.iter().map(|p| p.w).fold(f64::INFINITY, f64::min);
                let is_zero = square::largest(&values) <= tolerance * least_weight;
                let rounding = ROUNDING * magnitude(&patch.control_points);
                let conditions = Vec::new();
                let patch = &patch;
                let field =
                    ScalarField { patch, values, rounding, is_zero, conditions, basis: None };
                collected.add(field)?;
            }
        }
        let found = collected.finish()?;
        let meeting = CurveOrigin::Section { surface: self, plane, touches: &found.touches };
        verify::verify(&found.curves, &meeting, tolerance)?;
        Ok(found)
    }
}

/// The least and the largest of some rows and columns.
fn range_of(
    values: &Grid<f64>,
    rows: std::ops::RangeInclusive<usize>,
    columns: std::ops::RangeInclusive<usize>,
) -> [f64; 2] {
    let inner = rows.flat_map(|i| values.row(i)[columns.clone()].iter().copied());
    inner.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], value| {
        [least.min(value), most.max(value)]
    })
}
