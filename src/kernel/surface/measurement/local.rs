//! The shape of a surface at one place: how it bends, told from its derivatives.
//!
//! The second fundamental form over a pair of unit vectors of the tangent plane is a symmetric
//! tensor, and all curvatures follow from it; it is the same however the surface is parametrized.
//! A curvature is positive where its centre lies on the side of Su × Sv. do Carmo, *Differential
//! Geometry of Curves and Surfaces*, §3-2 and §3-3; `pole` has it where Su × Sv vanishes.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    Frame, GeomError, Grid, InputError, LocalError, MeasureError, Side, Tolerance,
    frame::{norm, unit},
    surface::Surface,
    tolerance::VANISHING_RELATIVE,
};

/// What kind of place of a surface a pair of parameters is.
///
/// ```
/// use virote_kernel::{NurbsSurface, Surface, SurfacePointKind, Tolerance, glam::DVec3};
///
/// let saddle = NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::ONE)?;
/// let kind = Surface::from(saddle).kind_at(0.5, 0.5, Tolerance::DEFAULT)?;
/// assert_eq!(kind, SurfacePointKind::Hyperbolic);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurfacePointKind {
    /// Bent to one side in all directions.
    Elliptic,
    /// Bent in all directions but one.
    Parabolic,
    /// Bent to both sides.
    Hyperbolic,
    /// Not bent at all.
    Planar,
    /// Su × Sv vanishes.
    Singular,
}

/// The principal curvatures and their directions.
///
/// A cylinder of radius 2 bends by 1/2 around its axis, and not along it:
///
/// ```
/// use virote_kernel::{Frame, NurbsSurface, Surface, Tolerance, glam::DVec3};
///
/// let cylinder = Surface::from(NurbsSurface::cone(Frame::XY, [2.0, 2.0], 5.0)?);
/// let found = cylinder.shape_at(0.1, 0.5)?.principal(Tolerance::DEFAULT);
/// let mut bends = [found.k1.abs(), found.k2.abs()];
/// bends.sort_by(f64::total_cmp);
/// assert!(bends[0] < 1e-14 && (bends[1] - 0.5).abs() < 1e-14);
/// let straight = if found.k1.abs() < found.k2.abs() { found.d1 } else { found.d2 };
/// assert!((straight.dot(DVec3::Z).abs() - 1.0).abs() < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Principal {
    /// The smallest normal curvature.
    pub k1: f64,
    /// The largest normal curvature.
    pub k2: f64,
    /// Unit vector of the direction of `k1`.
    pub d1: DVec3,
    /// Unit vector of the direction of `k2`: normal × `d1`.
    pub d2: DVec3,
}

/// Second fundamental form in an orthonormal basis of the tangent plane, of a surface at a place.
///
/// On a sphere of radius 2 both principal curvatures are 1/2, so that their product is 1/4:
///
/// ```
/// use virote_kernel::{Frame, NurbsSurface, Surface};
///
/// let shape = Surface::from(NurbsSurface::sphere(Frame::XY, 2.0)?).shape_at(0.1, 0.4)?;
/// assert!((shape.gaussian() - 0.25).abs() < 1e-14);
/// assert!((shape.mean().abs() - 0.5).abs() < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SurfaceShape {
    pub(in crate::surface) point: DVec3,
    pub(in crate::surface) normal: DVec3,
    /// Unit vectors of the tangent plane; the second one is normal × the first.
    pub(in crate::surface) axes: [DVec3; 2],
    /// II(x, x), II(x, y), II(y, y).
    pub(in crate::surface) tensor: [f64; 3],
    /// How far the surface reaches around the place: the length that its size corresponds to.
    pub(in crate::surface) extent: f64,
    /// What rounding leaves in a curvature.
    pub(in crate::surface) rounding: f64,
}

impl Surface {
    /// The shape at `(u, v)`: at a knot that of the piece after it.
    ///
    /// # Errors
    /// [`LocalError::NoNormal`]; [`LocalError::NoCurvature`] where Su × Sv vanishes and the
    /// curvatures have no limit that all directions agree on; as [`Self::point_at`].
    pub fn shape_at(&self, u: f64, v: f64) -> Result<SurfaceShape, GeomError> {
        if let Some((scaled, scale)) = self.scaled() {
            return Ok(scaled.shape_at(u, v)?.times(scale));
        }
        let derivatives = self.derivatives_at(u, v, 2)?;
        match self.regular_normal(&derivatives, u, v) {
            Some(normal) => {
                let shape = SurfaceShape::new(&derivatives, normal, self.widths_at(u, v));
                shape.ok_or(GeomError::Local(LocalError::NoCurvature { u, v }))
            }
            None => self.pole_shape(u, v),
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

/// Order across a collapsed edge of the last derivatives in which a direction is looked for.
const MAX_CROSS_ORDER: usize = 3;

impl SurfaceShape {
    /// The shape that derivatives up to order 2 tell where Su × Sv, along the unit normal, does
    /// not vanish; `None` where numbers overflow.
    pub(in crate::surface) fn new(
        derivatives: &Grid<DVec3>,
        normal: DVec3,
        widths: [f64; 2],
    ) -> Option<Self> {
        let (along_u, along_v) = (derivatives.get(1, 0), derivatives.get(0, 1));
        let x = unit(along_u)?;
        let y = normal.cross(x);
        // Steps in u and v that make unit steps along x and y.
        let length = norm(along_u);
        let (skew, height) = (along_v.dot(x), along_v.dot(y));
        let along_x = [1.0 / length, 0.0];
        let along_y = [-skew / (length * height), 1.0 / height];
        let second = [(2, 0), (1, 1), (0, 2)].map(|(k, l)| normal.dot(derivatives.get(k, l)));
        let form = |a: [f64; 2], b: [f64; 2]| {
            second[0] * a[0] * b[0]
                + second[1] * (a[0] * b[1] + a[1] * b[0])
                + second[2] * a[1] * b[1]
        };
        let tensor = [form(along_x, along_x), form(along_x, along_y), form(along_y, along_y)];
        let point = derivatives.get(0, 0);
        let extent = length * widths[0] + norm(along_v) * widths[1];
        let shortest = (length * widths[0]).min(height.abs() * widths[1]);
        let coordinates = point.abs().max_element() + extent;
        let rounding = VANISHING_RELATIVE * coordinates / shortest / shortest;
        let shape = Self { point, normal, axes: [x, y], tensor, extent, rounding };
        tensor.iter().all(|entry| entry.is_finite()).then_some(shape)
    }

    /// The shape of the surface that is larger by a factor.
    fn times(self, factor: f64) -> Self {
        Self {
            point: self.point * factor,
            tensor: self.tensor.map(|entry| entry / factor),
            extent: self.extent * factor,
            rounding: self.rounding / factor,
            ..self
        }
    }

    /// The point.
    #[must_use]
    pub fn point(&self) -> DVec3 {
        self.point
    }

    /// Unit vector along Su × Sv.
    #[must_use]
    pub fn normal(&self) -> DVec3 {
        self.normal
    }

    /// Gaussian curvature, the product of the principal curvatures.
    #[must_use]
    pub fn gaussian(&self) -> f64 {
        let [a, b, c] = self.tensor;
        a * c - b * b
    }

    /// Mean curvature, the mean of the principal curvatures.
    #[must_use]
    pub fn mean(&self) -> f64 {
        0.5 * (self.tensor[0] + self.tensor[2])
    }

    /// The smallest and the largest normal curvature.
    #[must_use]
    pub fn curvatures(&self) -> [f64; 2] {
        let (mean, radius) = (self.mean(), self.spread());
        [mean - radius, mean + radius]
    }

    /// The least and the greatest radius of curvature of the sections along the principal
    /// directions, without sign; infinite where the surface is flat within the tolerance's angle.
    /// do Carmo, *Differential Geometry of Curves and Surfaces*, §3-2.
    #[must_use]
    pub fn radii(&self, tolerance: Tolerance) -> [f64; 2] {
        let flat = self.flat_below(tolerance);
        let [a, b] = self.curvatures().map(f64::abs);
        [a.max(b), a.min(b)].map(|k| if k <= flat { f64::INFINITY } else { k.recip() })
    }

    /// Half of the difference of the principal curvatures.
    fn spread(&self) -> f64 {
        let [a, b, c] = self.tensor;
        libm::hypot(0.5 * (a - c), b)
    }

    /// The principal curvatures with their directions.
    ///
    /// At an umbilic, where they are equal within the tolerance's angle, every direction is a
    /// principal one, and `d1` is that of Su.
    #[must_use]
    pub fn principal(&self, tolerance: Tolerance) -> Principal {
        let [k1, k2] = self.curvatures();
        let ([x, y], [a, b, c]) = (self.axes, self.tensor);
        let is_umbilic =
            self.spread() <= self.flat_below(tolerance).max(tolerance.angle * k2.abs());
        if is_umbilic {
            return Principal { k1, k2, d1: x, d2: y };
        }
        // Cosine and sine of twice the angle of the direction of k1 from x, then of the angle.
        let (cosine, sine) = (0.5 * (c - a) / self.spread(), (0.0 - b) / self.spread());
        let larger = (0.5 * (1.0 + cosine.abs())).sqrt();
        let smaller = 0.5 * sine.abs() / larger;
        let (cosine, sine) = match cosine < 0.0 {
            true => (smaller, larger.copysign(sine)),
            false => (larger, smaller.copysign(sine)),
        };
        let d1 = x * cosine + y * sine;
        Principal { k1, k2, d1, d2: self.normal.cross(d1) }
    }

    /// Normal curvature in the direction of the tangent plane that is nearest to `direction`.
    ///
    /// # Errors
    /// [`LocalError::AcrossSurface`] for a direction along the normal, to within the tolerance's
    /// angle.
    pub fn normal_curvature(
        &self,
        direction: DVec3,
        tolerance: Tolerance,
    ) -> Result<f64, GeomError> {
        let direction =
            unit(direction).ok_or(GeomError::Input(InputError::ZeroAxis { what: "the vector" }))?;
        let [x, y] = self.axes.map(|axis| direction.dot(axis));
        let squared = x * x + y * y;
        if squared.sqrt() <= tolerance.angle {
            return Err(LocalError::AcrossSurface.into());
        }
        let [a, b, c] = self.tensor;
        Ok((a * x * x + 2.0 * b * x * y + c * y * y) / squared)
    }

    /// The kind of a regular place.
    #[must_use]
    pub fn kind(&self, tolerance: Tolerance) -> SurfacePointKind {
        let [k1, k2] = self.curvatures();
        let most = k1.abs().max(k2.abs());
        let flat = self.flat_below(tolerance);
        let none = flat.max(tolerance.angle * most);
        match (k1.abs() <= none, k2.abs() <= none) {
            _ if most <= flat => SurfacePointKind::Planar,
            (true, _) | (_, true) => SurfacePointKind::Parabolic,
            _ if (k1 < 0.0) == (k2 < 0.0) => SurfacePointKind::Elliptic,
            _ => SurfacePointKind::Hyperbolic,
        }
    }

    /// The curvature below which the surface is flat: turned by less than the tolerance's angle
    /// over its size, or bent by less than rounding.
    pub(in crate::surface) fn flat_below(&self, tolerance: Tolerance) -> f64 {
        (tolerance.angle / self.extent).max(self.rounding)
    }
}
