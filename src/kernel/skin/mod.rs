//! Surfaces through section curves, lines along v through the control points of all of them.
//!
//! `builder` decides how it is made; `sections` brings curves to one basis with weights that can be compared, and tells where in v
//! they stand; `align` turns them around and moves their seams until they run beside one another,
//! `corner` the seams of those with corners, `passage` tells which way closed ones run;
//! `spread` lets them run at constant speed; `along` are the ways to go from section to section;
//! `thin` leaves out knots that a tolerance does not need.

mod align;
mod aligned_section;
mod along;
mod builder;
mod corner;
mod passage;
mod sections;
mod spread;
mod thin;

pub use align::aligned;
pub use aligned_section::AlignedSection;
pub use along::Along;
pub use builder::{SectionSlope, SkinBuilder, SkinError, SkinInput, SkinnedSurface};
pub use corner::{corners_of_ring, with_seam_at_corner};
pub use sections::{CompatibleSections, SectionParameters};
pub use spread::at_constant_speed;

use glam::DVec4;

use super::{GeomError, Grid, NurbsSurface};

/// A surface through sections, and what is to be said about it.
///
/// Between two circles of one radius is a cylinder:
///
/// ```
/// use virote_kernel::{Along, CircleForm, CompatibleSections, Frame, NurbsCurve, glam::DVec3};
///
/// let circle = |z| NurbsCurve::ellipse(Frame::XY.at(DVec3::Z * z), [2.0, 2.0], CircleForm::NinePoint);
/// let sections = CompatibleSections::new(&[circle(0.0)?, circle(3.0)?])?;
/// let skin = sections.skinned(&Along::free(&[0.0, 1.0], 1)?)?;
/// let point = skin.surface.point_at(0.3, 0.5);
/// assert!((point.truncate().length() - 2.0).abs() < 1e-14 && (point.z - 1.5).abs() < 1e-14);
/// assert!(skin.bad_weight.is_none());
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Skin {
    /// u along the sections, v from one to the next.
    pub surface: NurbsSurface,
    /// The least weight of a control point that is not positive, by row and column.
    pub bad_weight: Option<(usize, usize, f64)>,
}

impl CompatibleSections {
    /// The surface that has the sections as isocurves, exactly.
    ///
    /// Piegl & Tiller, *The NURBS Book*, §10.3, in homogeneous space.
    ///
    /// # Errors
    /// `CountError::WrongCount` unless `along` is for as many sections;
    /// `WeightError::VanishingWeightsAt` where the weights between the sections leave no point;
    /// `InputError::NotFinite`.
    pub fn skinned(&self, along: &Along) -> Result<Skin, GeomError> {
        let lines: Result<Vec<Vec<DVec4>>, GeomError> =
            self.lines().iter().enumerate().map(|(i, line)| along.through(i, line)).collect();
        let net = Grid::from_rows(lines?)?;
        let mut bad_weight: Option<(usize, usize, f64)> = None;
        for i in 0..net.n_rows() {
            for (j, point) in net.row(i).iter().enumerate() {
                if point.w <= bad_weight.map_or(0.0, |(_, _, least)| least) {
                    bad_weight = Some((i, j, point.w));
                }
            }
        }
        let surface = NurbsSurface::new(self.knots().clone(), along.knots().clone(), net)?;
        Ok(Skin { surface, bad_weight })
    }
}
