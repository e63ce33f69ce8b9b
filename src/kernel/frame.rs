//! Places with three directions: planes, and coordinate systems in space.

use glam::{DAffine3, DMat3, DVec3};

use super::{GeomError, InputError, tolerance::VANISHING_RELATIVE};

/// An origin with three unit vectors at right angles, right-handed.
///
/// ```
/// use virote_kernel::{Frame, glam::DVec3};
///
/// let wall = Frame::from_normal(DVec3::new(0.0, 5.0, 0.0), DVec3::Y, Some(DVec3::X))?;
/// assert_eq!(wall.y(), DVec3::NEG_Z);
/// assert_eq!(wall.point(DVec3::new(2.0, 3.0, 0.0)), DVec3::new(2.0, 5.0, -3.0));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    origin: DVec3,
    x: DVec3,
    y: DVec3,
    z: DVec3,
    is_of_curve: bool,
}

impl Frame {
    /// The plane of x and y; its normal is z.
    pub const XY: Self = Self::plane([DVec3::X, DVec3::Y, DVec3::Z]);
    /// The plane of y and z; its normal is x.
    pub const YZ: Self = Self::plane([DVec3::Y, DVec3::Z, DVec3::X]);
    /// The plane of z and x; its normal is y.
    pub const ZX: Self = Self::plane([DVec3::Z, DVec3::X, DVec3::Y]);

    /// The plane of x and z, seen from the front: its second direction is z, its normal −y.
    pub(crate) const XZ: Self = Self::plane([DVec3::X, DVec3::Z, DVec3::NEG_Y]);

    const fn plane([x, y, z]: [DVec3; 3]) -> Self {
        Self { origin: DVec3::ZERO, x, y, z, is_of_curve: false }
    }

    /// The frame at `origin` with z along `normal` and x as near to the given direction as that
    /// allows; without one, as near to (1, 0, 0), or to (0, 1, 0) where that is the normal's line.
    ///
    /// # Errors
    /// [`InputError::ZeroAxis`] for a direction of length zero, [`InputError::ParallelAxes`] for an x
    /// along the normal; [`InputError::NotFinite`] for an origin.
    pub fn from_normal(origin: DVec3, normal: DVec3, x: Option<DVec3>) -> Result<Self, GeomError> {
        if !origin.is_finite() {
            return Err(InputError::NotFinite { what: "origin", index: 0 }.into());
        }
        let z =
            unit(normal).ok_or(GeomError::Input(InputError::ZeroAxis { what: "the normal" }))?;
        let x = match x {
            Some(x) => {
                let x =
                    unit(x).ok_or(GeomError::Input(InputError::ZeroAxis { what: "the x axis" }))?;
                across(x, z)
            }
            None => across(DVec3::X, z).or_else(|| across(DVec3::Y, z)),
        };
        let x = x.ok_or(GeomError::Input(InputError::ParallelAxes {
            first: "the x axis",
            second: "the normal",
        }))?;
        Ok(Self { origin, ..Self::plane([x, z.cross(x), z]) })
    }

    /// The frame at `origin` with x along `x` and y in the half plane of `y`.
    ///
    /// # Errors
    /// [`InputError::ZeroAxis`] where one is zero, [`InputError::ParallelAxes`] where they are
    /// parallel; [`InputError::NotFinite`].
    pub fn from_axes(origin: DVec3, x: DVec3, y: DVec3) -> Result<Self, GeomError> {
        let ux = unit(x).ok_or(GeomError::Input(InputError::ZeroAxis { what: "the x axis" }))?;
        let uy = unit(y).ok_or(GeomError::Input(InputError::ZeroAxis { what: "the y axis" }))?;
        let uy = across(uy, ux).ok_or(GeomError::Input(InputError::ParallelAxes {
            first: "the y axis",
            second: "the x axis",
        }))?;
        Self::from_normal(origin, ux.cross(uy), Some(ux))
    }

    /// The moving trihedron of a curve: x its tangent, y its normal on the side of `bending`, z its
    /// binormal.
    ///
    /// # Errors
    /// [`InputError::ZeroAxis`] where one is zero or both are parallel; [`InputError::NotFinite`].
    pub fn of_curve(origin: DVec3, tangent: DVec3, bending: DVec3) -> Result<Self, GeomError> {
        Ok(Self { is_of_curve: true, ..Self::from_axes(origin, tangent, bending)? })
    }

    /// Whether it is the trihedron of a curve.
    #[must_use]
    pub fn is_of_curve(self) -> bool {
        self.is_of_curve
    }

    /// The same directions elsewhere.
    #[must_use]
    pub fn at(self, origin: DVec3) -> Self {
        Self { origin, ..self }
    }

    /// The image under an affine map, made orthonormal again; x keeps its direction.
    ///
    /// # Errors
    /// [`InputError::ZeroAxis`] where the map flattens the plane; [`InputError::NotFinite`].
    pub fn transformed(self, map: &DAffine3) -> Result<Self, GeomError> {
        let axis = |axis: DVec3| map.transform_vector3(axis);
        let origin = map.transform_point3(self.origin);
        let image = Self::from_axes(origin, axis(self.x), axis(self.y))?;
        Ok(Self { is_of_curve: self.is_of_curve, ..image })
    }

    /// The rigid map that takes the origin to `to` and turns the normal into the unit vector
    /// `normal` by the smallest angle; they must not be opposite.
    #[must_use]
    pub fn turned_to(self, normal: DVec3, to: DVec3) -> DAffine3 {
        // Rodrigues' formula: I + [a]× + [a]×²/(1 + cos), where a = z × normal.
        let (axis, cosine) = (self.z.cross(normal), self.z.dot(normal));
        let cross = DMat3::from_cols(
            DVec3::new(0.0, axis.z, -axis.y),
            DVec3::new(-axis.z, 0.0, axis.x),
            DVec3::new(axis.y, -axis.x, 0.0),
        );
        let matrix3 = DMat3::IDENTITY + cross + cross * cross * (1.0 / (1.0 + cosine));
        DAffine3 { matrix3, translation: to - matrix3 * self.origin }
    }

    /// Where it stands.
    #[must_use]
    pub fn origin(self) -> DVec3 {
        self.origin
    }

    /// First direction.
    #[must_use]
    pub fn x(self) -> DVec3 {
        self.x
    }

    /// Second direction.
    #[must_use]
    pub fn y(self) -> DVec3 {
        self.y
    }

    /// Third direction, the normal of the plane.
    #[must_use]
    pub fn z(self) -> DVec3 {
        self.z
    }

    /// The point with the given coordinates in the frame.
    #[must_use]
    pub fn point(self, local: DVec3) -> DVec3 {
        self.origin + self.x * local.x + self.y * local.y + self.z * local.z
    }

    /// The map from coordinates in the frame to coordinates in space.
    #[must_use]
    pub fn to_space(self) -> DAffine3 {
        DAffine3 { matrix3: DMat3::from_cols(self.x, self.y, self.z), translation: self.origin }
    }

    /// The map from coordinates in space to coordinates in the frame.
    #[must_use]
    pub fn from_space(self) -> DAffine3 {
        let matrix3 = DMat3::from_cols(self.x, self.y, self.z).transpose();
        DAffine3 { matrix3, translation: -(matrix3 * self.origin) }
    }
}

/// The length of `v`, also where its square is out of range.
pub(crate) fn norm(v: DVec3) -> f64 {
    let squared = v.length_squared();
    if squared.is_normal() {
        return squared.sqrt();
    }
    let largest = v.abs().max_element();
    if 0.0 < largest && largest.is_finite() { largest * (v / largest).length() } else { largest }
}

/// The angle between two directions, 0 to π, accurate also where they are nearly parallel.
pub(crate) fn angle_between(a: DVec3, b: DVec3) -> f64 {
    libm::atan2(a.cross(b).length(), a.dot(b))
}

/// The unit vector along `v`, at any length that is not zero.
///
/// ```
/// use virote_kernel::{glam::DVec3, unit};
///
/// assert_eq!(unit(DVec3::Y * 1e-300), Some(DVec3::Y));
/// assert_eq!(unit(DVec3::ZERO), None);
/// ```
pub fn unit(v: DVec3) -> Option<DVec3> {
    let largest = v.abs().max_element();
    if !largest.is_finite() || largest <= 0.0 {
        return None;
    }
    // Dividing first keeps the square of the length from under- or overflowing.
    let scaled = v / largest;
    let unit = scaled / scaled.length();
    unit.is_finite().then_some(unit)
}

/// The unit vector along the part of `v` that is normal to the unit vector `axis`.
pub(crate) fn across(v: DVec3, axis: DVec3) -> Option<DVec3> {
    let v = unit(v)?;
    let part = v - axis * v.dot(axis);
    if part.length() <= VANISHING_RELATIVE {
        return None;
    }
    // Once more, because the first difference may have lost digits.
    let part = unit(part)?;
    unit(part - axis * part.dot(axis))
}

/// The widest angle between directions and an axis, none of them zero; radians, 0 without
/// directions.
pub(crate) fn widest_angle(directions: impl Iterator<Item = DVec3>, axis: DVec3) -> f64 {
    let axis_squared = axis.length_squared();
    let cosine =
        |direction: DVec3| direction.dot(axis) / (direction.length_squared() * axis_squared).sqrt();
    // The widest angle has the least cosine.
    libm::acos(directions.map(cosine).fold(1.0, f64::min).max(-1.0))
}
