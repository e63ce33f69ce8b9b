//! How a surface bends at one place, told from its derivatives there.
//!
//! The second fundamental form over a pair of unit vectors of the tangent plane is a symmetric
//! tensor, and all curvatures follow from it; it is the same however the surface is parametrized.
//! A curvature is positive where its centre lies on the side of Su × Sv. do Carmo, *Differential
//! Geometry of Curves and Surfaces*, §3-2 and §3-3; `pole` has it where Su × Sv vanishes.

use glam::DVec3;

use crate::{
    GeomError, Grid, InputError, LocalError, Tolerance,
    frame::{norm, unit},
    numeric::symmetric_eigen::mean_and_spread,
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
    pub(super) fn scaled(self, factor: f64) -> Self {
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

    /// What rounding leaves in a curvature here, of which less is none.
    #[must_use]
    pub fn rounding(&self) -> f64 {
        self.rounding
    }

    /// Half of the difference of the principal curvatures.
    fn spread(&self) -> f64 {
        let [_, spread] = mean_and_spread(self.tensor);
        spread
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
