//! How bright a surface is: a lamp over the viewer's left shoulder, and light from everywhere.
//!
//! Both sides of a surface are lit alike. What faces the viewer has its own colour, what turns
//! away gets darker, what faces the lamp lighter. Lambert, *Photometria*, 1760. Stripes are those of
//! [`crate::kernel::Surface::zebra`] with the light at the viewer.

use std::f64::consts::TAU;

use glam::DVec3;

use super::super::View;

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
pub(super) struct Light {
    toward: DVec3,
    lamp: DVec3,
    /// Across the way to the viewer and the axis of the stripes.
    aside: DVec3,
    /// How many stripes there are all around.
    stripes: Option<usize>,
    /// Cosine between the lamp and the viewer.
    facing: f64,
}

impl Light {
    pub(super) fn new(view: View, stripes: Option<usize>) -> Self {
        let toward = view.toward();
        let up = view.matrix().row(1);
        let right = up.cross(toward).normalize();
        let up = toward.cross(right);
        let lamp = (LAMP.x * right + LAMP.y * up + LAMP.z * toward).normalize();
        // The axis is z made normal to the way, or x where that comes along z.
        let axis = if toward.z.abs() < ALONG_Z { DVec3::Z } else { DVec3::X };
        let aside = axis.cross(toward).normalize();
        Self { toward, lamp, aside, stripes, facing: lamp.dot(toward) }
    }

    /// Whether places of one triangle may differ much.
    pub(super) fn is_sharp(&self) -> bool {
        self.stripes.is_some()
    }

    /// The stripe that a normal mirrors; the viewer is in the middle of the first.
    fn stripe(&self, normal: DVec3, n_stripes: usize) -> usize {
        let (ahead, aside) = (normal.dot(self.toward), normal.dot(self.aside));
        let angle = libm::atan2(2.0 * ahead * aside, 2.0 * ahead * ahead - 1.0);
        let share = angle / TAU + 1.0;
        (share * n_stripes as f64 + 0.5) as usize
    }

    /// The colour of a place of a surface. `face` is the normal of its triangle, which tells the
    /// side that is seen; `is_map` whether its colours have a meaning.
    pub(super) fn shade(&self, color: DVec3, normal: DVec3, face: DVec3, is_map: bool) -> DVec3 {
        // A normal that disagrees with its triangle is on the triangle's side.
        let normal = if normal.dot(face) < 0.0 { -normal } else { normal };
        let normal = if face.dot(self.toward) < 0.0 { -normal } else { normal };
        if let Some(n_stripes) = self.stripes {
            return DVec3::splat(STRIPES[self.stripe(normal, n_stripes) % 2]);
        }
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
