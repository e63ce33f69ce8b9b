//! Area and volume, and how they are spread: centroids and inertia.
//!
//! Integrals over the inside of a closed shell are integrals over its surfaces by the theorem of
//! Gauss: with the flux f = p·(Su × Sv) that of 1 is ∮f/3, that of p is ∮p f/4, that of p pᵀ is
//! ∮p pᵀ f/5. Mirtich, *Fast and accurate computation of polyhedral mass properties*, JGT 1 (1996).

use glam::{DAffine3, DMat3, DVec3};

use crate::{
    Bounds, GeomError, MeasureError, Tolerance,
    scale::{needed_scale, scaled_back},
    surface::{
        Surface,
        measurement::{
            quadrature::{Density, IntegralValues, ONE_MOMENT, QuantityKinds, integral},
            shell::oriented,
        },
    },
};

/// Even parts of each domain at whose ends points tell where a surface is.
const PARTS: usize = 8;

/// How much there is of something of density one, and how it is spread.
///
/// A ball has the volume 4/3·πr³, and about each axis the inertia 2/5·mr²:
///
/// ```
/// use virote_kernel::{Frame, NurbsSurface, Surface, Tolerance, volume_mass};
///
/// let ball = Surface::from(NurbsSurface::sphere(Frame::XY, 1.0)?);
/// let found = volume_mass(&[ball], Tolerance::DEFAULT)?;
/// let volume = 4.0 / 3.0 * std::f64::consts::PI;
/// assert!((found.amount - volume).abs() < 1e-10 && found.centroid.length() < 1e-10);
/// assert!((found.inertia.x_axis.x - 0.4 * volume).abs() < 1e-10);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct MassProperties {
    /// Area or volume.
    pub amount: f64,
    /// The centre of gravity.
    pub centroid: DVec3,
    /// The inertia tensor about the centroid.
    pub inertia: DMat3,
    /// What is known of the error, as a fraction.
    pub relative_error: f64,
}

impl Surface {
    /// Its area, and by which fraction that may be wrong.
    ///
    /// # Errors
    /// As [`Self::point_at`]; [`MeasureError::TooSmallToMeasure`].
    pub fn area(&self) -> Result<(f64, f64), GeomError> {
        let Some(scale) =
            needed_scale(probed(std::slice::from_ref(self))?.map_or(0.0, Bounds::magnitude))
        else {
            let found = integral(self, ONE_MOMENT, |_, normal| [normal.length()])?;
            return Ok((found.values[0], found.relative_error()));
        };
        let plain = self.transformed(&DAffine3::from_scale(DVec3::splat(scale.recip())))?;
        let (area, relative_error) = plain.area()?;
        Ok((scaled_back(area, scale, 2, "area")?, relative_error))
    }
}

/// The skins that surfaces are, of density one.
///
/// The half of a sphere has its centroid halfway up: Archimedes.
///
/// ```
/// use virote_kernel::{Axis, Frame, NurbsCurve, NurbsSurface, area_mass, glam::DVec3};
///
/// let quarter = NurbsCurve::arc(Frame::ZX, 1.0, 0.0, std::f64::consts::FRAC_PI_2)?;
/// let axis = Axis::new(DVec3::ZERO, DVec3::Z)?;
/// let dome = NurbsSurface::revolved(&quarter, axis, std::f64::consts::TAU)?;
/// assert!((area_mass(&[dome.into()])?.centroid.z - 0.5).abs() < 1e-10);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
///
/// # Errors
/// [`MeasureError::NothingThere`] for an area of zero, [`MeasureError::TooLargeToMeasure`], and as [`Surface::point_at`].
pub fn area_mass(surfaces: &[Surface]) -> Result<MassProperties, GeomError> {
    let about = middle(surfaces)?;
    let mut sum = MassIntegral::default();
    for surface in surfaces {
        let part = integral(surface, MOMENT_KINDS, |point, normal| {
            moments(point - about, normal.length())
        })?;
        sum.add(part, 1.0);
    }
    sum.mass(about, [1.0; 3]).ok_or_else(|| sum.without("area"))
}

/// What a closed set of surfaces holds, of density one; the surfaces' own orientations need not
/// agree.
///
/// A shell that is oriented alike throughout counts positive where it points outward and negative
/// where it points inward, so that it is a hole in another; the whole is not negative. Any other is
/// taken to point outward.
///
/// A box of six sides:
///
/// ```
/// use virote_kernel::{NurbsSurface, Tolerance, glam::DVec3, volume_mass};
///
/// let [x, y, z] = [DVec3::X, DVec3::Y * 2.0, DVec3::Z * 3.0];
/// let side = |o: DVec3, a: DVec3, b: DVec3| NurbsSurface::bilinear(o, o + b, o + a, o + a + b);
/// let o = DVec3::ZERO;
/// let sides = [side(o, y, x)?, side(z, x, y)?, side(o, x, z)?, side(y, z, x)?, side(o, z, y)?, side(x, y, z)?];
/// let found = volume_mass(&sides.map(Into::into), Tolerance::DEFAULT)?;
/// assert!((found.amount - 6.0).abs() < 1e-12);
/// assert!(found.centroid.distance(DVec3::new(0.5, 1.0, 1.5)) < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
///
/// # Errors
/// [`GeomError::Shell`] where the surfaces enclose nothing; [`MeasureError::NothingThere`] for a volume of zero, [`MeasureError::TooLargeToMeasure`], and as [`Surface::point_at`].
pub fn volume_mass(
    surfaces: &[Surface],
    tolerance: Tolerance,
) -> Result<MassProperties, GeomError> {
    let enclosed = EnclosedFlux::of(surfaces, tolerance, MOMENT_KINDS, moments)?;
    enclosed.sum.volume(enclosed.about)
}

/// How much a closed set of surfaces holds, as [`volume_mass`] tells it.
///
/// The half of a ball:
///
/// ```
/// use virote_kernel::{Axis, Frame, NurbsCurve, NurbsSurface, Tolerance, glam::DVec3, signed_volume};
///
/// let quarter = NurbsCurve::arc(Frame::ZX, 1.0, 0.0, std::f64::consts::FRAC_PI_2)?;
/// let floor = NurbsCurve::line(quarter.end(), DVec3::ZERO)?;
/// let axis = Axis::new(DVec3::ZERO, DVec3::Z)?;
/// let turned = |line| NurbsSurface::revolved(line, axis, std::f64::consts::TAU);
/// let half = signed_volume(&[turned(&quarter)?.into(), turned(&floor)?.into()], Tolerance::DEFAULT)?;
/// assert!((half.amount - 2.0 / 3.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct SignedVolume {
    /// The volume.
    pub amount: f64,
    /// What is known of the error, as a fraction.
    pub relative_error: f64,
    /// The point from which the fluxes of the way through the surfaces add up to three times the volume.
    pub about: DVec3,
    /// The sign that the flux through each surface has in this sum.
    pub signs: Vec<f64>,
}

/// How much a closed set of surfaces holds, with which signs of the surfaces.
///
/// # Errors
/// As [`volume_mass`].
pub fn signed_volume(
    surfaces: &[Surface],
    tolerance: Tolerance,
) -> Result<SignedVolume, GeomError> {
    let EnclosedFlux { sum, about, signs } =
        EnclosedFlux::of(surfaces, tolerance, ONE_MOMENT, |_, flux| [flux])?;
    let (amount, relative_error) = sum.amount_of_volume()?;
    Ok(SignedVolume { amount, relative_error, about, signs })
}

/// Moments of the flux through closed surfaces, of the way from a point.
struct EnclosedFlux<const N: usize> {
    sum: MassIntegral<N>,
    about: DVec3,
    signs: Vec<f64>,
}

impl<const N: usize> EnclosedFlux<N> {
    /// The sum of what a function makes of the way to a point and the flux of it there, itself the first.
    fn of(
        surfaces: &[Surface],
        tolerance: Tolerance,
        kinds: QuantityKinds<N>,
        density: impl Fn(DVec3, f64) -> [f64; N],
    ) -> Result<Self, GeomError> {
        let about = middle(surfaces)?;
        let shells = oriented(surfaces, tolerance, false)?;
        let mut whole = MassIntegral::default();
        let mut signs = vec![0.0; surfaces.len()];
        for shell in shells {
            let mut sum = MassIntegral::default();
            for &(idx, sign) in &shell.surfaces {
                let part = integral(&surfaces[idx], kinds, |point, normal| {
                    let arm = point - about;
                    let made_of = arm.length() * normal.length();
                    Density {
                        values: density(arm, arm.dot(normal)),
                        parts: density(arm.abs(), made_of),
                    }
                })?;
                sum.add(part, sign);
            }
            let turn = whole.add_shell(&sum, shell.was_oriented);
            for (idx, sign) in shell.surfaces {
                signs[idx] = sign * turn;
            }
        }
        if whole.flux() < 0.0 {
            signs.iter_mut().for_each(|sign| *sign = -*sign);
        }
        Ok(Self { sum: whole, about, signs })
    }
}

/// Whether surfaces close.
///
/// # Errors
/// As [`Surface::point_at`].
pub(crate) fn are_closed(surfaces: &[Surface], tolerance: Tolerance) -> Result<bool, GeomError> {
    match oriented(surfaces, tolerance, false) {
        Ok(_) => Ok(true),
        Err(GeomError::Shell(_)) => Ok(false),
        Err(error) => Err(error),
    }
}

/// For each surface, whether it must turn over so that those that hang together face alike: outward
/// where they close, otherwise as the first of them.
///
/// # Errors
/// [`GeomError::Shell`] of surfaces with one side only, and of more than two at an edge; as
/// [`Surface::point_at`].
pub fn facing_unlike(surfaces: &[Surface], tolerance: Tolerance) -> Result<Vec<bool>, GeomError> {
    let about = middle(surfaces)?;
    let mut turns = vec![false; surfaces.len()];
    for shell in oriented(surfaces, tolerance, true)? {
        let mut flux = 0.0;
        for &(idx, sign) in shell.surfaces.iter().filter(|_| shell.is_closed) {
            let part =
                integral(
                    &surfaces[idx],
                    ONE_MOMENT,
                    |point, normal| [(point - about).dot(normal)],
                )?;
            flux += sign * part.values[0];
        }
        if !flux.is_finite() {
            return Err(MeasureError::TooLargeToMeasure { what: "volume" }.into());
        }
        for (idx, sign) in shell.surfaces {
            turns[idx] = (sign < 0.0) != (flux < 0.0);
        }
    }
    Ok(turns)
}

/// The kinds of [`moments`]: of the orders 0, 1 and 2.
pub(crate) const MOMENT_KINDS: QuantityKinds<10> =
    QuantityKinds { numbers: [0, 1, 1, 1, 2, 2, 2, 2, 2, 2], are_moments: true };

/// A density times 1, x, y, z, and the products of these.
pub(crate) fn moments(arm: DVec3, density: f64) -> [f64; 10] {
    let DVec3 { x, y, z } = arm;
    [1.0, x, y, z, x * x, y * y, z * z, x * y, y * z, z * x].map(|factor| factor * density)
}

/// The middle of the surfaces, about which integrals cancel least.
fn middle(surfaces: &[Surface]) -> Result<DVec3, GeomError> {
    Ok(probed(surfaces)?.map_or(DVec3::ZERO, Bounds::center))
}

/// The box of points at the ends of even parts.
fn probed(surfaces: &[Surface]) -> Result<Option<Bounds>, GeomError> {
    let mut points = Vec::new();
    for surface in surfaces {
        let (us, vs) = (surface.domain_u().steps(PARTS), surface.domain_v().steps(PARTS));
        points.extend(surface.points_on_grid(&us, &vs)?.into_values());
    }
    Ok(Bounds::of(points))
}

/// Integrals of several surfaces together: an amount, and behind it moments.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MassIntegral<const N: usize = 10>(IntegralValues<N>);

impl<const N: usize> Default for MassIntegral<N> {
    fn default() -> Self {
        Self(IntegralValues { values: [0.0; N], errors: [0.0; N], sizes: [0.0; N] })
    }
}

impl<const N: usize> MassIntegral<N> {
    pub(crate) fn add(&mut self, part: IntegralValues<N>, sign: f64) {
        for i in 0..N {
            self.0.values[i] += sign * part.values[i];
            self.0.errors[i] += part.errors[i];
            self.0.sizes[i] += part.sizes[i];
        }
    }

    /// What is known of the error, as a fraction of the amount, and of the sizes of moments.
    fn relative_error(&self) -> f64 {
        let of_amount = self.0.errors[0] / self.0.values[0].abs().max(f64::MIN_POSITIVE);
        self.0.relative_error().max(of_amount)
    }

    /// Adds the moments of a shell; one that was not oriented is taken to look outward. The sign that it was
    /// given.
    pub(crate) fn add_shell(&mut self, shell: &Self, was_oriented: bool) -> f64 {
        let turn = if !was_oriented && shell.flux() < 0.0 { -1.0 } else { 1.0 };
        self.add(shell.0, turn);
        turn
    }

    /// The flux of the way from the place that they are about: three times the volume.
    pub(crate) fn flux(&self) -> f64 {
        self.0.values[0]
    }

    /// The volume that shells hold, which is not negative, and by which fraction it may be wrong.
    ///
    /// # Errors
    /// Those of [`Self::without`].
    pub(crate) fn amount_of_volume(&self) -> Result<(f64, f64), GeomError> {
        let amount = self.flux().abs() / 3.0;
        let is_known = 0.0 < amount && amount.is_finite();
        if is_known { Ok((amount, self.relative_error())) } else { Err(self.without("volume")) }
    }

    /// Why they say nothing: they overflow, or there is nothing.
    pub(crate) fn without(&self, what: &'static str) -> GeomError {
        if self.0.values.iter().all(|value| value.is_finite()) {
            GeomError::Measure(MeasureError::NothingThere { what })
        } else {
            GeomError::Measure(MeasureError::TooLargeToMeasure { what })
        }
    }
}

impl MassIntegral {
    /// What shells about a place hold, which is not negative.
    ///
    /// # Errors
    /// Those of [`Self::without`].
    pub(crate) fn volume(mut self, about: DVec3) -> Result<MassProperties, GeomError> {
        if self.0.values[0] < 0.0 {
            self.0.values = self.0.values.map(|value| -value);
        }
        self.mass(about, [3.0, 4.0, 5.0]).ok_or_else(|| self.without("volume"))
    }

    /// What they say, each order of moments divided by its own number; `None` of nothing.
    pub(crate) fn mass(
        &self,
        about: DVec3,
        [of_one, of_point, of_product]: [f64; 3],
    ) -> Option<MassProperties> {
        let [m, x, y, z, xx, yy, zz, xy, yz, zx] = self.0.values;
        let amount = m / of_one;
        let arm = DVec3::new(x, y, z) / of_point / amount;
        let products = DMat3::from_cols(
            DVec3::new(xx, xy, zx),
            DVec3::new(xy, yy, yz),
            DVec3::new(zx, yz, zz),
        ) * (1.0 / of_product);
        let shift = DMat3::from_cols(arm * arm.x, arm * arm.y, arm * arm.z) * amount;
        let about_centroid = products - shift;
        let trace = about_centroid.x_axis.x + about_centroid.y_axis.y + about_centroid.z_axis.z;
        let inertia = DMat3::from_diagonal(DVec3::splat(trace)) - about_centroid;
        let mass = MassProperties {
            amount,
            centroid: about + arm,
            inertia,
            relative_error: self.relative_error(),
        };
        (0.0 < amount && mass.centroid.is_finite()).then_some(mass)
    }
}
