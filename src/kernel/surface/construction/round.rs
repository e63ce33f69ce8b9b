//! Round primitives: exact surfaces of revolution about the z direction of a frame.
//!
//! Each is made about the z axis of space, where its coordinates are round numbers, and then
//! placed: u goes around from x, v upward, so that Su × Sv points outward.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec3;

use crate::{
    Frame, GeomError, InputError, NurbsCurve,
    surface::{Axis, NurbsSurface},
};

impl NurbsSurface {
    /// The sphere about the origin of a frame, v from the lower pole to the upper one.
    ///
    /// ```
    /// use virote_kernel::{Frame, NurbsSurface, Surface};
    ///
    /// let sphere = Surface::from(NurbsSurface::sphere(Frame::XY, 2.0)?);
    /// assert!((sphere.area()?.0 / (16.0 * std::f64::consts::PI) - 1.0).abs() < 1e-12);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`InputError::NotPositive`] for the radius, [`InputError::NotFinite`].
    pub fn sphere(frame: Frame, radius: f64) -> Result<Self, GeomError> {
        around(frame, &NurbsCurve::arc(MERIDIAN, radius, -FRAC_PI_2, PI)?)
    }

    /// The cone between circles of two radii, the first about the origin of a frame and the second
    /// at a height above; a radius may be zero. Equal ones make a cylinder, a height of zero a
    /// ring or disc.
    ///
    /// The side of a cone of radius 3 and height 4 has the area π·3·5:
    ///
    /// ```
    /// use virote_kernel::{Frame, NurbsSurface, Surface};
    ///
    /// let cone = Surface::from(NurbsSurface::cone(Frame::XY, [3.0, 0.0], 4.0)?);
    /// assert!((cone.area()?.0 / (15.0 * std::f64::consts::PI) - 1.0).abs() < 1e-12);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`InputError::NotPositive`] for a negative radius, or two that are zero;
    /// [`InputError::NotFinite`].
    pub fn cone(frame: Frame, radii: [f64; 2], height: f64) -> Result<Self, GeomError> {
        let [low, high] = radii;
        for got in [low.min(high), low.max(high)] {
            if !(got.is_finite() && 0.0 <= got) {
                return Err(InputError::NotPositive { what: "the radius", got }.into());
            }
        }
        if low.max(high) <= 0.0 {
            return Err(InputError::NotPositive { what: "the radius", got: 0.0 }.into());
        }
        let top = DVec3::new(high, 0.0, height);
        around(frame, &NurbsCurve::line(DVec3::new(low, 0.0, 0.0), top)?)
    }

    /// The torus about the origin of a frame, v around the tube from the outer equator upward.
    ///
    /// (√(x² + y²) − R)² + z² = r² at every point:
    ///
    /// ```
    /// use virote_kernel::{Frame, NurbsSurface};
    ///
    /// let p = NurbsSurface::torus(Frame::XY, 3.0, 1.0)?.point_at(0.2, 0.7);
    /// assert!(((p.truncate().length() - 3.0).hypot(p.z) - 1.0).abs() < 1e-14);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`InputError::NotPositive`] for a radius, [`InputError::NotFinite`].
    pub fn torus(frame: Frame, major: f64, minor: f64) -> Result<Self, GeomError> {
        if !(major.is_finite() && 0.0 < major) {
            return Err(InputError::NotPositive { what: "the major radius", got: major }.into());
        }
        let tube = MERIDIAN.at(DVec3::new(major, 0.0, 0.0));
        around(frame, &NurbsCurve::arc(tube, minor, 0.0, TAU)?)
    }
}

/// The half plane of a meridian: x outward, y upward.
const MERIDIAN: Frame = Frame::XZ;

/// The meridian turned about z once, placed.
fn around(frame: Frame, meridian: &NurbsCurve) -> Result<NurbsSurface, GeomError> {
    let axis = Axis::new(DVec3::ZERO, DVec3::Z)?;
    let surface = NurbsSurface::revolved(meridian, axis, TAU)?.transformed(&frame.to_space());
    crate::homogeneous::check_finite(surface.control_points().as_slice())?;
    Ok(surface)
}
