//! What a surface is everywhere: planar, developable, minimal.
//!
//! Of a NURBS the curvature is looked at in more places of each patch than its numerator can have
//! zeros without vanishing: with the homogeneous point P, n·Suu and so on are proportional to
//! det(P, Pu, Pv, Puu), of degree 4p, so that LN − M² has degree 8p, and EN − 2FM + GL no more than
//! that. Sederberg & Zheng, *Algebraic methods for CAGD*, in *Handbook of CAGD*, ch. 15.

use glam::DVec3;

use crate::{
    GeomError, Interval, KnotVector, LocalError, Tolerance,
    ceiling::PATCH_PLACES,
    curve, homogeneous,
    surface::{NurbsSurface, Surface, SurfaceShape},
};

/// Places of a function in each direction.
const FUNCTION_PLACES: usize = 49;

impl Surface {
    /// Whether it lies within the tolerance of one plane; a straight one does.
    ///
    /// Told from the control points, which lie in the plane exactly when the surface does; of a
    /// function from points of it.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn is_planar(&self, tolerance: Tolerance) -> Result<bool, GeomError> {
        let points = match self {
            Self::Nurbs(surface) => surface.places(),
            Self::Parametric(_) => {
                let steps = |domain: Interval| domain.steps(FUNCTION_PLACES);
                self.points_on_grid(&steps(self.domain_u()), &steps(self.domain_v()))?.into_values()
            }
        };
        Ok(curve::lie_in_a_plane(&points, tolerance))
    }

    /// Whether it can be unrolled into a plane: its Gaussian curvature is zero, within the
    /// tolerance's angle over its size or over the radius of its other curvature.
    ///
    /// # Errors
    /// [`LocalError::NoNormal`] where it has no tangent plane anywhere, and as [`Self::point_at`].
    pub fn is_developable(&self, tolerance: Tolerance) -> Result<bool, GeomError> {
        self.is_everywhere(tolerance, |[k1, k2]| k1.abs().min(k2.abs()))
    }

    /// Whether its mean curvature is zero, to the same tolerance: a soap film.
    ///
    /// # Errors
    /// As [`Self::is_developable`].
    pub fn is_minimal(&self, tolerance: Tolerance) -> Result<bool, GeomError> {
        self.is_everywhere(tolerance, |[k1, k2]| 0.5 * (k1 + k2).abs())
    }

    /// Whether a measure of the principal curvatures vanishes wherever there are any.
    fn is_everywhere(
        &self,
        tolerance: Tolerance,
        measure: impl Fn([f64; 2]) -> f64,
    ) -> Result<bool, GeomError> {
        let vanishes = |shape: &SurfaceShape| {
            let curvatures = shape.curvatures();
            let most = curvatures[0].abs().max(curvatures[1].abs());
            measure(curvatures) <= shape.flat_below(tolerance).max(tolerance.angle * most)
        };
        let (us, vs) = self.inner_places();
        let mut has_shape = false;
        for &u in &us {
            for &v in &vs {
                let shape = match self.shape_at(u, v) {
                    Err(GeomError::Local(
                        LocalError::NoNormal { .. } | LocalError::NoCurvature { .. },
                    )) => continue,
                    shape => shape?,
                };
                if !vanishes(&shape) {
                    return Ok(false);
                }
                has_shape = true;
            }
        }
        match (us.first(), vs.first()) {
            (Some(&u), Some(&v)) if !has_shape => {
                Err(GeomError::Local(LocalError::NoNormal { u, v }))
            }
            _ => Ok(true),
        }
    }

    /// Parameters inside of the pieces.
    fn inner_places(&self) -> (Vec<f64>, Vec<f64>) {
        let inside =
            |piece: Interval, n: usize| (0..n).map(move |i| piece.at((i as f64 + 0.5) / n as f64));
        match self {
            Self::Nurbs(surface) => {
                let of_knots = |knots: &KnotVector| {
                    let n = (8 * knots.degree() + 1).min(PATCH_PLACES);
                    knots.spans().flat_map(|span| inside(knots.span_interval(span), n)).collect()
                };
                (of_knots(surface.knots_u()), of_knots(surface.knots_v()))
            }
            Self::Parametric(_) => {
                let of_domain = |domain| inside(domain, FUNCTION_PLACES).collect();
                (of_domain(self.domain_u()), of_domain(self.domain_v()))
            }
        }
    }
}

impl NurbsSurface {
    /// The control points; one of weight zero, which is a direction, as a step from the first.
    fn places(&self) -> Vec<DVec3> {
        let first = homogeneous::place(self.control_points.get(0, 0));
        let place = |&point: &glam::DVec4| match point.w.abs() < f64::MIN_POSITIVE {
            true => first + point.truncate(),
            false => homogeneous::place(point),
        };
        self.control_points.iter().map(place).collect()
    }
}
