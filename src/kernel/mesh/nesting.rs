//! Whether the parts of a closed mesh enclose each place once or not at all.
//!
//! A part is what hangs together by vertices. How often the others go around one of its places is their
//! winding number there, the sum of the solid angles of their triangles over 4π: it must be 0 for a
//! part that faces outward and 1 for one that faces inward, which is a hole. Van Oosterom and Strackee,
//! *The solid angle of a plane triangle*, IEEE Trans. Biomed. Eng. 30 (1983).

use glam::DVec3;

use super::fault::MeshError;
use crate::{Bounds, work};

/// A winding number this far from a whole one belongs to a place beside a triangle.
const BESIDE: f64 = 0.25;

/// Triangles that hang together.
struct NestedShell<'a> {
    triangles: &'a [[DVec3; 3]],
    bounds: Bounds,
    volume: f64,
}

/// Checks that closed parts, none of which crosses itself or another one, face as they lie: those that
/// lie in no other outward, and each inside of another the other way than that.
///
/// # Errors
/// [`MeshError::Inverted`], [`MeshError::Doubled`], with a corner of the part.
pub(super) fn check_nesting(parts: &[Vec<[DVec3; 3]>]) -> Result<(), MeshError> {
    let parts: Vec<NestedShell<'_>> =
        parts.iter().filter_map(|part| NestedShell::new(part)).collect();
    for (index, part) in parts.iter().enumerate() {
        let others = || parts.iter().enumerate().filter(|&(other, _)| other != index);
        let around = |place: DVec3| {
            let holds = |other: &NestedShell<'_>| {
                other.bounds.min.cmple(place).all() && place.cmple(other.bounds.max).all()
            };
            others().map(|(_, other)| if holds(other) { other.winding(place) } else { 0.0 }).sum()
        };
        let clear = |number: &f64| (number - number.round()).abs() < BESIDE;
        let mut numbers = part.triangles.iter().map(|corners| around(corners[0]));
        let at = part.triangles[0][0];
        let wanted = if part.volume < 0.0 { 1.0 } else { 0.0 };
        match numbers.find(clear).map(f64::round) {
            Some(number) if (number - wanted).abs() < 0.5 => {}
            Some(number) if number < wanted => return Err(MeshError::Inverted { at }),
            _ => return Err(MeshError::Doubled { at }),
        }
    }
    Ok(())
}

impl<'a> NestedShell<'a> {
    fn new(triangles: &'a [[DVec3; 3]]) -> Option<Self> {
        let bounds = Bounds::of(triangles.iter().flatten().copied())?;
        let origin = triangles[0][0];
        let term = |&[a, b, c]: &[DVec3; 3]| (a - origin).dot((b - origin).cross(c - origin));
        Some(Self { triangles, bounds, volume: triangles.iter().map(term).sum::<f64>() / 6.0 })
    }

    /// How often it goes around a place.
    fn winding(&self, place: DVec3) -> f64 {
        let mut sum = 0.0;
        for corners in self.triangles {
            if !work::goes_on(1) {
                break;
            }
            let [a, b, c] = corners.map(|corner| corner - place);
            let [x, y, z] = [a, b, c].map(DVec3::length);
            let over = x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y;
            sum += 2.0 * libm::atan2(a.dot(b.cross(c)), over);
        }
        sum / (4.0 * std::f64::consts::PI)
    }
}
