//! What can be asked of a surface at one place: its shape, forms, tangents and tangent plane.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    Frame, GeomError, Grid, LocalError, MeasureError, Side, Tolerance,
    frame::{norm, unit},
    surface::{Surface, SurfacePointKind, SurfaceShape},
    tolerance::{CLEAR_SHAPE, VANISHING_RELATIVE},
};

/// Order across a collapsed edge of the last derivatives in which a direction is looked for.
const MAX_CROSS_ORDER: usize = 3;

impl Surface {
    /// The shape at `(u, v)`: at a knot that of the piece after it.
    ///
    /// # Errors
    /// [`LocalError::NoNormal`]; [`LocalError::NoCurvature`] where Su × Sv vanishes and the
    /// curvatures have no limit that all directions agree on; as [`Self::point_at`].
    pub fn shape_at(&self, u: f64, v: f64) -> Result<SurfaceShape, GeomError> {
        if let Some((scaled, scale)) = self.scaled() {
            return Ok(scaled.shape_at(u, v)?.scaled(scale));
        }
        let derivatives = self.derivatives_at(u, v, 2)?;
        match self.regular_normal(&derivatives, u, v) {
            Some(normal) => {
                let shape = SurfaceShape::new(&derivatives, normal, self.widths_at(u, v));
                let is_clear = |shape: &SurfaceShape| shape.rounding * shape.extent <= CLEAR_SHAPE;
                shape
                    .filter(is_clear)
                    .or_else(|| self.shape_near_pole(u, v))
                    .or(shape)
                    .ok_or(GeomError::Local(LocalError::NoCurvature { u, v }))
            }
            None => self.shape_near_pole(u, v).map_or_else(|| self.pole_shape(u, v), Ok),
        }
    }

    /// Gaussian curvature at `(u, v)`.
    ///
    /// # Errors
    /// [`MeasureError::TooSmallToMeasure`] where the product of curvatures that do not vanish is
    /// less than the smallest number, and as [`Self::shape_at`].
    pub fn gaussian_at(&self, u: f64, v: f64) -> Result<f64, GeomError> {
        let shape = self.shape_at(u, v)?;
        let gaussian = shape.gaussian();
        let [k1, k2] = shape.curvatures().map(f64::abs);
        let is_lost = shape.rounding < k1.min(k2) && gaussian.abs() < f64::MIN_POSITIVE;
        if is_lost {
            return Err(MeasureError::TooSmallToMeasure { what: "Gaussian curvature" }.into());
        }
        Ok(gaussian)
    }

    /// Coefficients E, F and G of the first fundamental form.
    ///
    /// # Errors
    /// [`MeasureError::TooSmallToMeasure`] where a square is less than the smallest number, and as
    /// [`Self::point_at`].
    pub fn first_form_at(&self, u: f64, v: f64) -> Result<[f64; 3], GeomError> {
        let [_, along_u, along_v] = self.tangents_at(u, v)?;
        let is_lost =
            |along: DVec3| 0.0 < norm(along) && along.length_squared() < f64::MIN_POSITIVE;
        if is_lost(along_u) || is_lost(along_v) {
            return Err(MeasureError::TooSmallToMeasure { what: "first fundamental form" }.into());
        }
        Ok([along_u.dot(along_u), along_u.dot(along_v), along_v.dot(along_v)])
    }

    /// Coefficients L, M and N of the second fundamental form, about the normal or its limit.
    ///
    /// # Errors
    /// [`LocalError::NoNormal`], and as [`Self::point_at`].
    pub fn second_form_at(&self, u: f64, v: f64) -> Result<[f64; 3], GeomError> {
        let normal = self.normal_at(u, v)?;
        let derivatives = self.derivatives_at(u, v, 2)?;
        Ok([(2, 0), (1, 1), (0, 2)].map(|(k, l)| normal.dot(derivatives.get(k, l))))
    }

    /// The kind of place; a curvature counts as none below the tolerance's angle over the size of
    /// the surface there, or over the radius of the other curvature.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn kind_at(
        &self,
        u: f64,
        v: f64,
        tolerance: Tolerance,
    ) -> Result<SurfacePointKind, GeomError> {
        if let Some((scaled, _)) = self.scaled() {
            return scaled.kind_at(u, v, tolerance);
        }
        let derivatives = self.derivatives_at(u, v, 2)?;
        let Some(normal) = self.regular_normal(&derivatives, u, v) else {
            return Ok(SurfacePointKind::Singular);
        };
        let shape = SurfaceShape::new(&derivatives, normal, self.widths_at(u, v));
        Ok(shape.map_or(SurfacePointKind::Singular, |shape| shape.kind(tolerance)))
    }

    /// The tangent plane: x along Su where that does not vanish, z the normal.
    ///
    /// # Errors
    /// [`LocalError::NoNormal`], and as [`Self::point_at`].
    pub fn tangent_plane_at(&self, u: f64, v: f64) -> Result<Frame, GeomError> {
        let normal = self.normal_at(u, v)?;
        Frame::from_normal(self.point_at(u, v)?, normal, self.tangent_u_at(u, v).ok())
    }

    /// Unit vector along Su; where that vanishes its limit.
    ///
    /// # Errors
    /// [`LocalError::NoTangentAlong`], and as [`Self::point_at`].
    pub fn tangent_u_at(&self, u: f64, v: f64) -> Result<DVec3, GeomError> {
        match self.isocurve_v(v)?.tangent_at(u, Side::Right) {
            Err(GeomError::Local(LocalError::VanishingTangent { .. })) => self
                .collapsed_tangent([u, v], true)?
                .ok_or(GeomError::Local(LocalError::NoTangentAlong { what: "u", u, v })),
            tangent => tangent,
        }
    }

    /// Unit vector along Sv; where that vanishes its limit.
    ///
    /// # Errors
    /// [`LocalError::NoTangentAlong`], and as [`Self::point_at`].
    pub fn tangent_v_at(&self, u: f64, v: f64) -> Result<DVec3, GeomError> {
        match self.isocurve_u(u)?.tangent_at(v, Side::Right) {
            Err(GeomError::Local(LocalError::VanishingTangent { .. })) => self
                .collapsed_tangent([u, v], false)?
                .ok_or(GeomError::Local(LocalError::NoTangentAlong { what: "v", u, v })),
            tangent => tangent,
        }
    }

    /// The direction of Su, or of Sv, on an edge that is collapsed to a point: its limit from
    /// inside of the domain.
    fn collapsed_tangent(
        &self,
        [u, v]: [f64; 2],
        is_along_u: bool,
    ) -> Result<Option<DVec3>, GeomError> {
        let derivatives = self.derivatives_at(u, v, MAX_CROSS_ORDER + 1)?;
        let [width_u, width_v] = self.widths_at(u, v);
        let (across, step, width) = match is_along_u {
            true => (self.domain_v().inward(v), width_v, width_u),
            false => (self.domain_u().inward(u), width_u, width_v),
        };
        let Some(across) = across else { return Ok(None) };
        let get = |along: usize, across: usize| match is_along_u {
            true => derivatives.get(along, across),
            false => derivatives.get(across, along),
        };
        let size = get(0, 0).abs().max_element() + norm(get(0, 1)) * step;
        let mut power = width;
        for k in 1..=MAX_CROSS_ORDER {
            power *= across * step;
            let term = get(1, k) * power;
            if VANISHING_RELATIVE * size < norm(term) {
                return Ok(unit(term));
            }
        }
        Ok(None)
    }

    /// The unit normal where Su × Sv is more than rounding.
    fn regular_normal(&self, derivatives: &Grid<DVec3>, u: f64, v: f64) -> Option<DVec3> {
        let normal = derivatives.get(1, 0).cross(derivatives.get(0, 1));
        let [width_u, width_v] = self.widths_at(u, v);
        let is_regular = self.fold_area() < normal.length() * width_u * width_v;
        unit(normal).filter(|_| is_regular)
    }

    /// The surface divided by a power of two near its size, with that power, where squares of its
    /// coordinates are no numbers.
    pub(in crate::surface) fn scaled(&self) -> Option<(Self, f64)> {
        match self {
            Self::Nurbs(surface) => {
                let (scaled, scale) = surface.scaled.as_ref()?;
                Some((Self::Nurbs(Arc::clone(scaled)), *scale))
            }
            Self::Parametric(surface) => {
                let (scaled, scale) = surface.scaled()?;
                Some((Self::Parametric(Arc::clone(scaled)), scale))
            }
        }
    }

    /// The steps in u and v that the size of the surface corresponds to at a place.
    pub(in crate::surface) fn widths_at(&self, u: f64, v: f64) -> [f64; 2] {
        match self {
            Self::Nurbs(surface) => surface.span_widths(u, v),
            Self::Parametric(_) => [self.domain_u().length(), self.domain_v().length()],
        }
    }

    /// The area of Su × Sv over these steps that is rounding and no area.
    pub(in crate::surface) fn fold_area(&self) -> f64 {
        match self {
            Self::Nurbs(surface) => surface.fold_area,
            Self::Parametric(surface) => surface.fold_area(),
        }
    }
}
