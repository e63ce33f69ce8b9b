//! How bright a surface is: a lamp over the viewer's left shoulder, and light from everywhere.
//!
//! Both sides of a surface are lit alike. What faces the viewer has its own colour, what turns
//! away gets darker, what faces the lamp lighter. Lambert, *Photometria*, 1760. Stripes are those of
//! [`crate::kernel::Surface::zebra`] with the light at the viewer.

use std::f64::consts::TAU;

use glam::DVec3;

use super::super::{Stripes, projection::Projection};

/// Light from everywhere, as a part of the light on what faces the viewer.
const AMBIENT: f64 = 0.42;
/// The same where colours have a meaning.
const AMBIENT_OF_MAP: f64 = 0.75;
/// The lamp: to the right, up, toward the viewer.
const LAMP: DVec3 = DVec3::new(-0.4, 0.5, 0.77);
/// Views within this cosine of the z axis have their stripes about x.
const ALONG_Z: f64 = 0.999_999;
/// Light and dark of stripes.
const STRIPES: [f64; 2] = [0.95, 0.1];
/// How much white a unit of brightness above that of the own colour adds.
const SHEEN: f64 = 1.6;

/// The light of a view.
pub(super) struct Light<'a> {
    projection: &'a Projection,
    lamp: DVec3,
    stripes: Option<StripeLight>,
    /// Cosine between the lamp and the viewer.
    facing: f64,
}

/// A light that is mirrored as stripes.
struct StripeLight {
    /// The direction to it.
    toward: DVec3,
    /// Across that and the axis of the stripes.
    aside: DVec3,
    /// How many stripes there are all around.
    n_stripes: usize,
}

impl StripeLight {
    fn new(stripes: Stripes, ahead: DVec3) -> Self {
        let toward = stripes.light.unwrap_or(ahead).normalize_or(ahead);
        // The axis is z made normal to the way, or x where that comes along z.
        let axis = if toward.z.abs() < ALONG_Z { DVec3::Z } else { DVec3::X };
        Self { toward, aside: axis.cross(toward).normalize(), n_stripes: stripes.n_stripes }
    }

    /// The stripe that a normal mirrors; the light is in the middle of the first.
    fn stripe(&self, normal: DVec3) -> usize {
        let (ahead, aside) = (normal.dot(self.toward), normal.dot(self.aside));
        let angle = libm::atan2(2.0 * ahead * aside, 2.0 * ahead * ahead - 1.0);
        let share = angle / TAU + 1.0;
        (share * self.n_stripes as f64 + 0.5) as usize
    }
}

impl<'a> Light<'a> {
    pub(super) fn new(projection: &'a Projection, stripes: Option<Stripes>) -> Self {
        let (toward, up) = (projection.ahead(), projection.up());
        let right = up.cross(toward).normalize();
        let up = toward.cross(right);
        let lamp = (LAMP.x * right + LAMP.y * up + LAMP.z * toward).normalize();
        let stripes = stripes.map(|stripes| StripeLight::new(stripes, toward));
        Self { projection, lamp, stripes, facing: lamp.dot(toward) }
    }

    /// Whether places of one triangle may differ much.
    pub(super) fn is_sharp(&self) -> bool {
        self.stripes.is_some()
    }

    /// The colour of a place of a surface with its unit normal. `face` is the normal of its triangle,
    /// which tells the side that is seen; `is_map` whether its colours have a meaning.
    pub(super) fn shade(
        &self,
        color: DVec3,
        place: DVec3,
        [normal, face]: [DVec3; 2],
        is_map: bool,
    ) -> DVec3 {
        if let Some(stripes) = &self.stripes {
            return DVec3::splat(STRIPES[stripes.stripe(normal) % 2]);
        }
        // A normal that disagrees with its triangle is on the triangle's side.
        let normal = if normal.dot(face) < 0.0 { -normal } else { normal };
        let normal = if face.dot(self.projection.toward(place)) < 0.0 { -normal } else { normal };
        let ambient = if is_map { AMBIENT_OF_MAP } else { AMBIENT };
        let lit = normal.dot(self.lamp).max(0.0) / self.facing;
        let brightness = ambient + (1.0 - ambient) * lit;
        if brightness <= 1.0 || is_map {
            color * brightness.min(1.0)
        } else {
            color.lerp(DVec3::ONE, (SHEEN * (brightness - 1.0)).min(1.0))
        }
    }
}
