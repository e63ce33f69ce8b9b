//! Why there is no such face.

use glam::DVec3;
use thiserror::Error;

use crate::{
    Interval,
    digits::{line_between, plain},
    error::{few_digits, place},
};

/// What keeps loops and cutters from bounding a part of a surface.
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{Face, FaceError, Frame, GeomError, NurbsCurve, NurbsSurface, Tolerance, glam::DVec3};
///
/// let sphere = Arc::new(NurbsSurface::sphere(Frame::XY, 1.0)?);
/// let line = NurbsCurve::line(DVec3::new(0.1, 0.5, 0.0), DVec3::new(0.2, 0.5, 0.0))?;
/// let found = Face::within(sphere, &[line], Tolerance::DEFAULT);
/// assert!(matches!(found, Err(GeomError::Face(FaceError::Open { index: 0, .. }))));
/// # Ok::<(), GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum FaceError {
    /// A loop that does not close.
    #[error("loop [{index}] does not close: its ends are {} apart", few_digits(*gap))]
    Open { index: usize, gap: f64 },
    /// A curve of parameters that leaves the domain.
    #[error(
        "loop [{index}] reaches from u = {} to {}, v = {} to {}, beyond the surface, which has u = {} to {}, v = {} to {}",
        plain(u[0]), plain(u[1]), plain(v[0]), plain(v[1]),
        plain(domains[0].start()), plain(domains[0].end()), plain(domains[1].start()), plain(domains[1].end())
    )]
    OffDomain { index: usize, u: [f64; 2], v: [f64; 2], domains: [Interval; 2] },
    /// A curve away from the surface that it should lie on.
    #[error("{what} is {} from the surface at {}", few_digits(*distance), place(*point))]
    OffSurface { what: &'static str, index: usize, point: DVec3, distance: f64 },
    /// Loops of which one has to its left what another has to its right.
    #[error("at {} the loops contradict one another: each has the face to its left", place(*point))]
    BothSides { point: DVec3 },
    /// A curve that divides nothing.
    #[error("a curve ends inside of the face at {}, so that it divides nothing", place(*point))]
    EndsInside { point: DVec3 },
    /// Several parts where one is wanted.
    #[error("there are {n_parts} separate parts, one at {} and one at {}", place(points[0]), place(points[1]))]
    Apart { n_parts: usize, points: Vec<DVec3> },
    /// Nothing to the left of all loops.
    #[error("the loops leave nothing of the surface")]
    Nothing,
    /// A cutter that does not reach the face.
    #[error("cutter [{index}] does not meet the face")]
    Misses { index: usize },
    /// A cutter that is hardly more than a place within the tolerance.
    #[error(
        "cutter [{index}] is {} across at {}: with a tolerance of {} it is one place, which divides nothing",
        few_digits(*size), place(*point), few_digits(*tolerance)
    )]
    TooSmall { index: usize, size: f64, tolerance: f64, point: DVec3 },
    /// A cutter that comes to the face in points alone.
    #[error(
        "cutter [{index}] only touches the face, at {}{}, so that it divides nothing",
        place(*point), if *n_points == 1 { String::new() } else { format!(" and {} more", n_points - 1) }
    )]
    TouchesAt { index: usize, point: DVec3, n_points: usize },
    /// A cutter that comes to the face along a line without crossing it.
    #[error(
        "cutter [{index}] only touches the face, along {}, {} long, so that it divides nothing",
        line_between(*ends), few_digits(*length)
    )]
    TouchesAlong { index: usize, ends: [DVec3; 2], length: f64 },
    /// A cutter that lies on all of the face.
    #[error("cutter [{index}] lies on all of the face, so that it divides nothing")]
    Covered { index: usize },
    /// A plane in which the face lies.
    #[error("cutter [{index}] runs along the surface near {}", place(*point))]
    RunsAlong { index: usize, point: DVec3 },
    /// A surface that has an area in common with that of the face without being of one carrier with it.
    #[error(
        "the face and cutter [{index}] run together near {} without being parts of one surface",
        place(*point)
    )]
    RunsTogether { index: usize, point: DVec3 },
    /// A place that tells no part.
    #[error("{} is {} from the face: it tells no part of it", place(*point), few_digits(*distance))]
    NoPartAt { point: DVec3, distance: f64 },
    /// An edge of a face beside which there is none of another.
    #[error(
        "the faces do not close: {}{}, at {}",
        if *n_faces < 2 { "an edge".to_owned() } else { format!("an edge of face [{face}]") },
        if gap.is_finite() {
            format!(" is {} from the nearest other edge", few_digits(*gap))
        } else {
            " is the only one there is".to_owned()
        },
        place(*point)
    )]
    OpenShell { face: usize, n_faces: usize, gap: f64, point: DVec3 },
    /// More than two faces at one edge.
    #[error(
        "an edge of face [{face}] meets {} other edges at {}, of faces {others:?}; what encloses a volume has two faces at each edge",
        others.len(), place(*point)
    )]
    CrowdedShell { face: usize, others: Vec<usize>, point: DVec3 },
    /// Edges that are hardly further apart than the tolerance.
    #[error(
        "edges of face [{}] and face [{}] are {} apart at {}, too near to be told apart at the tolerance {}",
        faces[0], faces[1], few_digits(*gap), place(*point), few_digits(*tolerance)
    )]
    NearEdges { faces: [usize; 2], gap: f64, tolerance: f64, point: DVec3 },
    /// Faces that cannot look alike.
    #[error(
        "the faces have one side only, like a Möbius strip: face [{}] meets face [{}] turned over", faces[0], faces[1]
    )]
    OneSided { faces: [usize; 2] },
    /// A face whose edges are one to each other.
    #[error(
        "face [{face}] is {} wide on average, within the tolerance {}, so that its own edges near {} are one",
        few_digits(*width), few_digits(*tolerance), place(*point)
    )]
    Narrow { face: usize, width: f64, tolerance: f64, point: DVec3 },
    /// A border that comes back to itself.
    #[error("the border touches itself at {}", place(*point))]
    TouchesItself { point: DVec3 },
    /// Parts that are not all of the face.
    #[error(
        "the parts of the face could not be proven: their parameters miss those of the whole by a fraction of {}",
        few_digits(*excess)
    )]
    PartsMissArea { excess: f64 },
    /// A part on both sides of a plane that should have cut it.
    #[error(
        "a part of the face reaches {} below the plane and {} above it, so that a part of the cut is missing, near {}",
        few_digits(-heights[0]), few_digits(heights[1]), place(*point)
    )]
    AcrossPlane { heights: [f64; 2], point: DVec3 },
    /// An offset further away than what the surface bends around.
    #[error(
        "an offset by {} passes the centres of curvature, the nearest {} away, at {}",
        plain(*distance), few_digits(*radius), place(*point)
    )]
    BeyondCentre { point: DVec3, radius: f64, distance: f64 },
    /// Faces without an edge in common.
    #[error(
        "the faces share no edge: {}",
        if gap.is_finite() {
            format!("where they come nearest their borders are {} apart, at {}", few_digits(*gap), place(*point))
        } else {
            "one of them has no border".to_owned()
        }
    )]
    NoCommonEdge { gap: f64, point: DVec3 },
    /// A place on a cut.
    #[error("{} lies on a cut: it tells no part of the face", place(*point))]
    OnCut { point: DVec3 },
}
