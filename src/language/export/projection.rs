//! How a drawing sees space: a view by its name or a camera, from afar or from where it stands.
//!
//! Every projection maps straight lines to straight lines and planes to planes, and keeps the order
//! of what lies behind one another, so that what hides what can be asked of its image; NURBS curves
//! stay NURBS curves. Carlbom & Paciorek, *Planar Geometric Projections and Viewing
//! Transformations*, ACM Computing Surveys 10 (1978).

use glam::{DAffine3, DMat3, DMat4, DVec3, DVec4};
use thiserror::Error;

use super::{
    legend::four_digits,
    view::{Oblique, View},
};
use crate::kernel::{Bounds, GeomError, NurbsCurve};

/// A camera that looks along z within this cosine has y for its up.
const ALONG_Z: f64 = 0.999_999;

/// A view in perspective stands this many diagonals of what is drawn away, where no camera is given.
const DISTANCE: f64 = 2.0;

/// What is nearest to a camera is drawn at most this many times as large as what it looks at.
const MOST_MAGNIFIED: f64 = 20.0;

/// A camera that stands too near is told to stand so many times as far away as the nearest there is.
const ROOM: f64 = 2.0;

/// From where a drawing looks, and how.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Viewpoint {
    /// The side from which it looks, where there is no camera; without one from above.
    pub view: Option<View>,
    /// The angle at which an oblique view draws depth, as in [`Oblique`].
    pub oblique_angle: Option<f64>,
    /// How long an oblique view draws a unit of depth, as in [`Oblique`].
    pub oblique_ratio: Option<f64>,
    /// Where the viewer stands.
    pub camera: Option<DVec3>,
    /// What the viewer looks at; without it the middle of what is drawn.
    pub look_at: Option<DVec3>,
    /// Whether what is nearer is drawn larger.
    pub is_perspective: bool,
}

/// Why there is no view from somewhere.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum ViewpointError {
    /// The camera looks at the place where it stands.
    #[error(
        "the camera looks at the place where it stands, which gives no direction; move one of the two"
    )]
    NoDirection,
    /// A place to look at where it changes nothing.
    #[error(
        "a place to look at needs a camera or perspective: a named view sees all places from one direction"
    )]
    NothingLooks,
    /// A camera where there is a view already.
    #[error("a camera and a named view are two places to look from; leave one of them out")]
    TwoPlaces,
    /// An angle or ratio of depth in a view that has none.
    #[error("an angle and a ratio of depth go with the view `oblique` alone")]
    NotOblique,
    /// An oblique view in perspective.
    #[error("an oblique view is parallel; choose another view or a camera for perspective")]
    ObliquePerspective,
    /// Something of what is drawn is behind the camera, or close before it.
    #[error("the camera stands among what is drawn or too near to it; ({}, {}, {}) in the same direction is far enough", four_digits(far.x), four_digits(far.y), four_digits(far.z))]
    TooNear {
        /// A place that is far enough.
        far: DVec3,
    },
}

/// The map from space to paper.
#[derive(Clone, Debug)]
pub(super) struct Projection {
    /// To (right, up, depth toward the viewer), in perspective with the place that the camera looks
    /// at as the origin.
    map: DAffine3,
    /// The unit direction from what is drawn to the viewer, in perspective from what it looks at.
    toward: DVec3,
    eye: Option<Eye>,
    /// How many times larger than at the place that is looked at anything is drawn.
    magnification: f64,
}

/// Where the viewer stands.
#[derive(Clone, Copy, Debug)]
struct Eye {
    place: DVec3,
    /// From what it looks at.
    distance: f64,
}

impl Projection {
    /// What a viewpoint means for what lies in a box.
    ///
    /// # Errors
    /// [`ViewpointError`].
    pub(super) fn new(viewpoint: &Viewpoint, bounds: Bounds) -> Result<Self, ViewpointError> {
        let usual = Oblique::default();
        let oblique = Oblique {
            angle: viewpoint.oblique_angle.unwrap_or(usual.angle),
            ratio: viewpoint.oblique_ratio.unwrap_or(usual.ratio),
        };
        if viewpoint.camera.is_some() && viewpoint.view.is_some() {
            return Err(ViewpointError::TwoPlaces);
        }
        let has_depth = viewpoint.oblique_angle.or(viewpoint.oblique_ratio).is_some();
        if has_depth && viewpoint.view != Some(View::Oblique) {
            return Err(ViewpointError::NotOblique);
        }
        let target = viewpoint.look_at.unwrap_or_else(|| bounds.center());
        let parallel = match (viewpoint.camera, viewpoint.view.unwrap_or_default()) {
            (Some(camera), _) => {
                let toward = direction(target, camera).ok_or(ViewpointError::NoDirection)?;
                Self::from_afar(camera_axes(toward), None)
            }
            (None, View::Oblique) if viewpoint.is_perspective => {
                return Err(ViewpointError::ObliquePerspective);
            }
            (None, View::Oblique) => Self::from_afar(oblique.matrix(), Some(oblique.toward())),
            (None, view) => Self::from_afar(view.matrix(), None),
        };
        if viewpoint.is_perspective {
            let whole = bounds.diagonal();
            let away = if 0.0 < whole { DISTANCE * whole } else { 1.0 };
            let place = viewpoint.camera.unwrap_or(target + away * parallel.toward);
            return parallel.in_perspective(place, target, bounds);
        }
        if viewpoint.look_at.is_some() && viewpoint.camera.is_none() {
            return Err(ViewpointError::NothingLooks);
        }
        Ok(parallel)
    }

    /// The parallel one with these rows.
    fn from_afar(matrix: DMat3, toward: Option<DVec3>) -> Self {
        Self {
            map: DAffine3::from_mat3(matrix),
            toward: toward.unwrap_or_else(|| matrix.row(2)),
            eye: None,
            magnification: 1.0,
        }
    }

    /// The same from a place.
    fn in_perspective(
        self,
        place: DVec3,
        target: DVec3,
        bounds: Bounds,
    ) -> Result<Self, ViewpointError> {
        let matrix = self.map.matrix3;
        let map = DAffine3::from_mat3_translation(matrix, -(matrix * target));
        let distance = place.distance(target);
        if !distance.is_finite() {
            // So far away that all rays are parallel.
            return Ok(self);
        }
        let nearest = bounds.corners().map(|corner| map.transform_point3(corner).z);
        let nearest = nearest.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let magnification = distance / (distance - nearest);
        if !(0.0 < magnification && magnification <= MOST_MAGNIFIED) {
            let far = target + (ROOM * nearest).max(bounds.diagonal()) * self.toward;
            return Err(ViewpointError::TooNear { far });
        }
        let eye = Some(Eye { place, distance });
        Ok(Self { map, eye, magnification: magnification.max(1.0), ..self })
    }

    /// How near to the truth something in space must be that is drawn within a distance of its image,
    /// in depth too.
    pub(super) fn in_space(&self, near: f64) -> f64 {
        near / (self.magnification * self.magnification)
    }

    /// Where a point is drawn: x to the right, y upward, z its depth toward the viewer.
    pub(super) fn project(&self, point: DVec3) -> DVec3 {
        let seen = self.map.transform_point3(point);
        self.eye.map_or(seen, |eye| seen * (eye.distance / (eye.distance - seen.z)))
    }

    /// The image of a curve.
    ///
    /// # Errors
    /// As [`NurbsCurve::projected`].
    pub(super) fn curve(&self, curve: &NurbsCurve) -> Result<NurbsCurve, GeomError> {
        let seen = curve.transformed(&self.map);
        let Some(eye) = self.eye else { return Ok(seen) };
        let mut central = DMat4::IDENTITY;
        central.w_axis = DVec4::W;
        central.z_axis = DVec4::new(0.0, 0.0, 1.0, -1.0 / eye.distance);
        seen.projected(&central)
    }

    /// A box around the image of a box.
    pub(super) fn bounds(&self, bounds: Bounds) -> Bounds {
        let corners = bounds.corners().map(|corner| self.project(corner));
        corners.into_iter().fold(Bounds { min: corners[0], max: corners[0] }, Bounds::with)
    }

    /// A direction from a place in space to the viewer, of any length.
    pub(super) fn toward(&self, place: DVec3) -> DVec3 {
        self.eye.map_or(self.toward, |eye| eye.place - place)
    }

    /// The unit direction from what is looked at to the viewer.
    pub(super) fn ahead(&self) -> DVec3 {
        self.toward
    }

    /// The direction in space that is drawn upward.
    pub(super) fn up(&self) -> DVec3 {
        self.map.matrix3.row(1)
    }
}

/// The unit direction from one place to another, however near or far they are.
fn direction(from: DVec3, to: DVec3) -> Option<DVec3> {
    let half = 0.5 * to - 0.5 * from;
    (half / half.abs().max_element()).try_normalize()
}

/// The rows of a camera in this direction from what it looks at: z is up, or y where it looks along
/// z, as in [`View::Top`] and [`View::Bottom`].
fn camera_axes(toward: DVec3) -> DMat3 {
    let up = if toward.z.abs() < ALONG_Z { DVec3::Z } else { DVec3::Y * toward.z.signum() };
    let right = up.cross(toward).normalize();
    DMat3::from_cols(right, toward.cross(right), toward).transpose()
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3};

    use super::{super::view::View, Projection, Viewpoint, ViewpointError};
    use crate::kernel::{Bounds, Frame, NurbsCurve};

    const CUBE: Bounds = Bounds { min: DVec3::NEG_ONE, max: DVec3::ONE };

    fn seen(viewpoint: Viewpoint) -> Projection {
        Projection::new(&viewpoint, CUBE).expect("a view")
    }

    #[test]
    fn a_camera_far_away_sees_what_the_named_view_from_its_side_does() {
        for &(name, view) in View::ALL.iter().filter(|(_, view)| *view != View::Oblique) {
            let camera = Some(1e3 * view.toward());
            let own = seen(Viewpoint { camera, ..Viewpoint::default() });
            let named = seen(Viewpoint { view: Some(view), ..Viewpoint::default() });
            let p = DVec3::new(0.3, -0.7, 0.9);
            assert!(own.project(p).distance(named.project(p)) < 1e-15, "{name}");
        }
    }

    #[test]
    fn what_lies_on_one_ray_from_the_camera_is_drawn_at_one_place_and_the_nearer_before() {
        let camera = DVec3::new(5.0, -4.0, 3.0);
        let viewpoint =
            Viewpoint { camera: Some(camera), is_perspective: true, ..Viewpoint::default() };
        let projection = seen(viewpoint);
        let far = DVec3::new(-1.0, 0.8, 0.2);
        let [a, b] = [0.2, 0.5].map(|part| projection.project(far.lerp(camera, part)));
        assert!(a.truncate().distance(b.truncate()) < 1e-14 && a.z < b.z, "{a} {b}");
        // What is looked at stays in the middle, and what lies beside it keeps its size.
        let middle = projection.project(DVec3::ZERO);
        assert!(middle.length() < 1e-15);
        let beside = projection.project(camera.cross(DVec3::Z).normalize());
        assert!(beside.truncate().distance(DVec2::NEG_X) < 1e-15, "{beside}");
    }

    #[test]
    fn the_image_of_a_circle_has_the_images_of_its_points() {
        let camera = Some(DVec3::new(3.0, -2.0, 2.5));
        let viewpoint = Viewpoint { camera, is_perspective: true, ..Viewpoint::default() };
        let projection = seen(viewpoint);
        let circle = NurbsCurve::arc(Frame::XY, 1.0, 0.0, std::f64::consts::TAU).expect("a circle");
        let image = projection.curve(&circle).expect("an image");
        for t in circle.domain().steps(40) {
            let distance = image.point_at(t).distance(projection.project(circle.point_at(t)));
            assert!(distance < 1e-14, "{t} {distance}");
        }
    }

    #[test]
    fn a_camera_among_what_is_drawn_is_told_where_there_is_room() {
        let camera = Some(DVec3::new(1.1, 0.1, 0.0));
        let near = Viewpoint { camera, is_perspective: true, ..Viewpoint::default() };
        let Err(ViewpointError::TooNear { far }) = Projection::new(&near, CUBE) else {
            unreachable!("it stands too near")
        };
        assert!(Projection::new(&Viewpoint { camera: Some(far), ..near }, CUBE).is_ok());
        // From afar it sees everything.
        assert!(Projection::new(&Viewpoint { is_perspective: false, ..near }, CUBE).is_ok());
    }

    #[test]
    fn a_camera_at_any_distance_has_its_direction() {
        let named = seen(Viewpoint { view: Some(View::Right), ..Viewpoint::default() });
        for x in [1e-300, 1e-200, 1e200, f64::MAX] {
            for is_perspective in [false, 1.0 < x] {
                let camera = Some(DVec3::new(x, 0.0, 0.0));
                let own = seen(Viewpoint { camera, is_perspective, ..Viewpoint::default() });
                let p = DVec3::new(0.3, -0.7, 0.9);
                assert_eq!(own.project(p), named.project(p), "{x}");
            }
        }
    }

    #[test]
    fn what_gives_no_view_is_refused() {
        let refused = |viewpoint| Projection::new(&viewpoint, CUBE).err();
        let base = Viewpoint::default();
        let camera = Some(DVec3::ZERO);
        assert_eq!(refused(Viewpoint { camera, ..base }), Some(ViewpointError::NoDirection));
        let oblique = Viewpoint { view: Some(View::Oblique), is_perspective: true, ..base };
        assert_eq!(refused(oblique), Some(ViewpointError::ObliquePerspective));
        let both = Viewpoint { camera: Some(DVec3::X), view: Some(View::Top), ..base };
        assert_eq!(refused(both), Some(ViewpointError::TwoPlaces));
        let depth = Viewpoint { view: Some(View::Top), oblique_ratio: Some(1.0), ..base };
        assert_eq!(refused(depth), Some(ViewpointError::NotOblique));
        let look_at = Some(DVec3::ONE);
        assert_eq!(refused(Viewpoint { look_at, ..base }), Some(ViewpointError::NothingLooks));
    }
}
