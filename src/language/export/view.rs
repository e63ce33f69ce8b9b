//! The views of a drawing: how a point in space becomes a point on paper and a depth.
//!
//! Every view is a parallel projection and linear, so that the picture of a polynomial curve is
//! the polynomial curve of the pictures of its control points. Carlbom & Paciorek, *Planar
//! Geometric Projections and Viewing Transformations*, ACM Computing Surveys 10 (1978).

use std::f64::consts::FRAC_PI_4;

use glam::{DMat3, DVec2, DVec3};

use super::{Item, whole};
use crate::kernel::Bounds;

/// From where a drawing looks at the geometry. The z axis points up but in [`View::Top`] and
/// [`View::Bottom`].
///
/// [`View::project`] gives x to the right, y upward, and a depth that grows toward the viewer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum View {
    /// From above, against z: x to the right, y upward.
    #[default]
    Top,
    /// From the front, along y: x to the right, z upward.
    Front,
    /// From the right, against x: y to the right, z upward.
    Right,
    /// From below, along z: x to the right, y downward.
    Bottom,
    /// From the back, against y: x to the left, z upward.
    Back,
    /// From the left, along x: y to the left, z upward.
    Left,
    /// From the front, the right and above, along (−1, 1, −1): the axes stand at 120°, z upward,
    /// x down to the right, y up to the right, each shortened to √(2/3).
    Isometric,
    /// As from the front, with depth as [`Oblique`] draws it. What lies in a plane y = constant keeps
    /// its shape.
    Oblique,
}

/// How an oblique view draws depth; by default half as long and up to the right at 45°, the cabinet
/// projection. At full length it is the cavalier one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oblique {
    /// The direction on paper in which depth goes, in radians from the right upward.
    pub angle: f64,
    /// The length of a unit of depth on paper.
    pub ratio: f64,
}

impl Default for Oblique {
    fn default() -> Self {
        Self { angle: FRAC_PI_4, ratio: 0.5 }
    }
}

impl Oblique {
    /// The most that a unit of depth is long on paper.
    pub const MOST_RATIO: f64 = 2.0;

    /// A unit of depth on paper.
    fn depth(self) -> DVec2 {
        let (sine, cosine) = libm::sincos(self.angle);
        self.ratio * DVec2::new(cosine, sine)
    }

    /// As [`View::matrix`].
    pub(super) fn matrix(self) -> DMat3 {
        let DVec2 { x, y } = self.depth();
        rows(DVec3::new(1.0, x, 0.0), DVec3::new(0.0, y, 1.0), DVec3::NEG_Y)
    }

    /// As [`View::toward`].
    pub(super) fn toward(self) -> DVec3 {
        let DVec2 { x, y } = self.depth();
        DVec3::new(x, -1.0, y).normalize()
    }
}

fn rows(right: DVec3, up: DVec3, toward: DVec3) -> DMat3 {
    DMat3::from_cols(right, up, toward).transpose()
}

impl View {
    /// Every view with its name, in the order of the reference.
    pub const ALL: &'static [(&'static str, Self)] = &[
        ("top", Self::Top),
        ("front", Self::Front),
        ("right", Self::Right),
        ("bottom", Self::Bottom),
        ("back", Self::Back),
        ("left", Self::Left),
        ("isometric", Self::Isometric),
        ("oblique", Self::Oblique),
    ];

    /// The view of this name.
    ///
    /// ```
    /// use virote_language::export::View;
    ///
    /// assert_eq!(View::from_name("front"), Some(View::Front));
    /// assert_eq!(View::from_name("behind"), None);
    /// ```
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, _)| *known == name).map(|&(_, view)| view)
    }

    /// The view that suits some items: from above where all are flat, else the isometric one.
    #[must_use]
    pub fn fitting(items: &[Item]) -> Self {
        let is_flat = |whole: Bounds| whole.min.z >= whole.max.z;
        if whole(items).is_none_or(is_flat) { Self::Top } else { Self::Isometric }
    }

    /// The map from space to (right, up, depth toward the viewer); it has an inverse.
    #[must_use]
    pub fn matrix(self) -> DMat3 {
        match self {
            Self::Top => DMat3::IDENTITY,
            Self::Front => rows(DVec3::X, DVec3::Z, DVec3::NEG_Y),
            Self::Right => rows(DVec3::Y, DVec3::Z, DVec3::X),
            Self::Bottom => rows(DVec3::X, DVec3::NEG_Y, DVec3::NEG_Z),
            Self::Back => rows(DVec3::NEG_X, DVec3::Z, DVec3::Y),
            Self::Left => rows(DVec3::NEG_Y, DVec3::Z, DVec3::NEG_X),
            Self::Isometric => rows(
                DVec3::new(1.0, 1.0, 0.0) / 2.0_f64.sqrt(),
                DVec3::new(-1.0, 1.0, 2.0) / 6.0_f64.sqrt(),
                DVec3::new(1.0, -1.0, 1.0) / 3.0_f64.sqrt(),
            ),
            Self::Oblique => Oblique::default().matrix(),
        }
    }

    /// Where a point is drawn: x to the right, y upward, z its depth toward the viewer.
    ///
    /// ```
    /// use glam::DVec3;
    /// use virote_language::export::View;
    ///
    /// let p = DVec3::new(1.0, 2.0, 3.0);
    /// assert_eq!(View::Top.project(p), p);
    /// assert_eq!(View::Front.project(p), DVec3::new(1.0, 3.0, -2.0));
    /// assert_eq!(View::Right.project(p), DVec3::new(2.0, 3.0, 1.0));
    /// ```
    #[must_use]
    pub fn project(self, point: DVec3) -> DVec3 {
        self.matrix() * point
    }

    /// The unit direction in space from the geometry to the viewer: points along it are drawn at
    /// one place.
    #[must_use]
    pub fn toward(self) -> DVec3 {
        match self {
            Self::Oblique => Oblique::default().toward(),
            other => other.matrix().row(2),
        }
    }

    /// Where a point is drawn, without its depth.
    #[must_use]
    pub fn on_paper(self, point: DVec3) -> DVec2 {
        self.project(point).truncate()
    }
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3};

    use super::View;

    #[test]
    fn what_lies_toward_the_viewer_is_drawn_at_one_place_and_nearer() {
        for &(name, view) in View::ALL {
            let drawn = view.project(view.toward());
            assert!(drawn.truncate().length() < 1e-15, "{name}: {drawn}");
            assert!(0.8 < drawn.z, "{name}: {drawn}");
            assert!((view.toward().length() - 1.0).abs() < 1e-15, "{name}");
        }
    }

    #[test]
    fn no_view_is_a_mirror() {
        for &(name, view) in View::ALL {
            assert!((view.matrix().determinant() - 1.0).abs() < 1e-15, "{name}");
        }
    }

    #[test]
    fn opposite_views_mirror_what_is_to_the_right_or_up_and_see_the_other_side() {
        let p = DVec3::new(1.0, 2.0, 3.0);
        assert_eq!(View::Bottom.project(p), DVec3::new(1.0, -2.0, -3.0));
        assert_eq!(View::Back.project(p), DVec3::new(-1.0, 3.0, 2.0));
        assert_eq!(View::Left.project(p), DVec3::new(-2.0, 3.0, -1.0));
    }

    #[test]
    fn isometric_axes_stand_at_120_degrees_and_are_equally_long() {
        let axes = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| View::Isometric.on_paper(axis));
        for axis in axes {
            assert!((axis.length_squared() - 2.0 / 3.0).abs() < 1e-15);
        }
        let cosine = |a: DVec2, b: DVec2| a.dot(b) / (a.length() * b.length());
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            assert!((cosine(axes[a], axes[b]).abs() - 0.5).abs() < 1e-15);
        }
    }

    #[test]
    fn an_oblique_view_keeps_the_front_and_halves_the_depth() {
        assert_eq!(View::Oblique.on_paper(DVec3::new(3.0, 0.0, 4.0)), DVec2::new(3.0, 4.0));
        let depth = View::Oblique.on_paper(DVec3::Y);
        assert!((depth.length() - 0.5).abs() < 1e-15 && (depth.x - depth.y).abs() < 1e-15);
    }
}
