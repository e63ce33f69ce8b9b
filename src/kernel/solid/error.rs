//! Why there is no such solid.

use glam::DVec3;
use thiserror::Error;

use crate::{
    digits::line_between,
    error::{few_digits, place},
};

/// What keeps faces and regions from making a solid.
///
/// ```
/// use virote_kernel::{CircleForm, Frame, GeomError, NurbsCurve, Region, Solid, SolidError, Tolerance, glam::DVec3};
///
/// let disc = NurbsCurve::ellipse(Frame::XY, [1.0; 2], CircleForm::NinePoint)?;
/// let disc = Region::new(&disc, &[], Tolerance::DEFAULT)?;
/// let found = Solid::extruded(&disc, DVec3::X, Tolerance::DEFAULT);
/// assert!(matches!(found, Err(GeomError::Solid(SolidError::AlongPlane { .. }))));
/// # Ok::<(), GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum SolidError {
    /// A way that leaves the plane of a region by no more than the tolerance.
    #[error(
        "the vector leaves the plane of the region by {}, within the tolerance {}, so that nothing is enclosed",
        few_digits(*height), few_digits(*tolerance)
    )]
    AlongPlane { height: f64, tolerance: f64 },
    /// An axis that is not in the plane of a region.
    #[error("the axis does not lie in the plane of the region: it is up to {} away from it", few_digits(*by))]
    AxisOffPlane { by: f64 },
    /// A region on both sides of an axis.
    #[error("the region reaches over the axis at {}, so that the solid would go through itself", place(*point))]
    AcrossAxis { point: DVec3 },
    /// A region that comes to the axis in a point.
    #[error(
        "the solid would touch itself at {}: the region comes to the axis in this point alone",
        place(*point)
    )]
    PointOnAxis { point: DVec3 },
    /// Shells that meet.
    #[error(
        "face [{}] and face [{}] meet at {} without a common edge; shells of a solid keep apart",
        faces[0], faces[1], place(*point)
    )]
    ShellsMeet { faces: [usize; 2], point: DVec3 },
    /// Faces that go through one another.
    #[error("the faces go through one another near {}; those of a solid meet in their edges alone", place(*point))]
    CrossesItself { point: DVec3 },
    /// Faces that lie on one another.
    #[error(
        "parts of the faces lie on one another near {}, as of a wall that runs back over itself; those of a solid meet in their edges alone",
        place(*point)
    )]
    Overlaid { point: DVec3 },
    /// A face that narrows to a point.
    #[error("the solid would touch itself at {}, where face [{face}] narrows to a point", place(*point))]
    Pinched { face: usize, point: DVec3 },
    /// Faces that enclose nothing that is thicker than the tolerance.
    #[error(
        "what the faces enclose near {} is {} thick on average, less than the tolerance {}",
        place(*point), few_digits(*thickness), few_digits(*tolerance)
    )]
    Thin { point: DVec3, thickness: f64, tolerance: f64 },
    /// A shell of which cannot be told whether it lies in another.
    #[error("whether the shell at {} lies within another one cannot be told", place(*point))]
    UnclearNesting { point: DVec3 },
    /// A rim that no plane face can close.
    #[error("the rim at {} does not lie in a plane: it leaves one by {}", place(*point), few_digits(*by))]
    UnevenRim { point: DVec3, by: f64 },
    /// Open edges that do not close.
    #[error("the edges without a neighbour do not make a closed rim: one ends at {}, {} from the next", place(*point), few_digits(*gap))]
    OpenRim { point: DVec3, gap: f64 },
    /// A side of a plane whose volume is not what the faces there tell.
    #[error(
        "this side of the plane encloses {} more or less than its faces tell, where {} could be rounding: a part of the cut may be missing",
        few_digits(*missing), few_digits(*allowed)
    )]
    UncertainCut { missing: f64, allowed: f64 },
    /// A plane beside an edge that runs along it.
    #[error(
        "the plane passes {} beside the edge at {}, which runs along it there: what it cuts off is as thin as the tolerance {}",
        few_digits(*thickness), place(*point), few_digits(*tolerance)
    )]
    ThinCut { point: DVec3, thickness: f64, tolerance: f64 },
    /// A plane beside a place to which a face narrows.
    #[error(
        "the plane passes {} beside {}, where a face narrows to a point: too near for the tolerance {}",
        few_digits(*thickness), place(*point), few_digits(*tolerance)
    )]
    ThinTip { point: DVec3, thickness: f64, tolerance: f64 },
    /// A plane that cuts where the solid is hardly thicker than the tolerance.
    #[error(
        "the plane cuts the solid where it is {} thick, at {}: too thin for the tolerance {}",
        few_digits(*thickness), place(*point), few_digits(*tolerance)
    )]
    ThinSection { point: DVec3, thickness: f64, tolerance: f64 },
    /// A side of a plane that touches itself in the plane.
    #[error("this side of the plane would touch itself at {}, where parts of it meet in the plane alone", place(*point))]
    TouchesPlane { point: DVec3 },
    /// A side of a plane that touches itself along a line in the plane.
    #[error(
        "this side of the plane would touch itself along {}, where parts of it meet in the plane alone",
        line_between(*ends)
    )]
    TouchesAlong { ends: [DVec3; 2] },
    /// An edge that is not gone along by two faces from end to end.
    #[error("the edge at {} has no other one along all of it, so that no faces share it", place(*point))]
    UnmatchedEdge { point: DVec3 },
    /// A place of which cannot be told whether it is inside.
    #[error(
        "whether {}, which is {} from the nearest face, is inside cannot be told",
        place(*point), few_digits(*distance)
    )]
    UnclearSide { point: DVec3, distance: f64 },
}
