//! What a pixel is made of.

use glam::DVec3;

/// Samples on each side of a pixel.
pub(super) const SIDE: usize = 4;

/// A colour in bytes with levels from 0 to 1.
pub(super) fn levels(color: [u8; 3]) -> DVec3 {
    DVec3::from(color.map(f64::from)) / 255.0
}
