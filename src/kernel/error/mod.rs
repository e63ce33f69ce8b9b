//! Why a piece of geometry cannot exist, or a question about it has no answer.
//!
//! Families by what is wrong: `input` has those of what geometry is made of, `construct` of what is
//! made, `question` of what is asked.

mod construct;
mod input;
mod question;

use thiserror::Error;

use super::{
    FaceError, FunctionFailure, JumpError, MeshError, PictureError, RegionError, ShellError,
    SolidError,
};

pub use construct::{ConstructionError, FitError, FormError, JointError};
pub use input::{CountError, DegreeError, DomainError, InputError, KnotError, WeightError};
pub use question::{IntersectionError, LocalError, MeasureError};

/// A request that has no geometric answer.
///
/// Carries numbers, and the indices of what is wrong among the arguments, which messages name as the
/// constructors do (`curves[1]`, `patches[0][2]`); never places in a script.
///
/// A family tells what kind of thing is wrong, its variant what, in numbers; the text is for people:
///
/// ```
/// use virote_kernel::{CountError, GeomError, NurbsCurve};
///
/// let found = NurbsCurve::bezier(&[]);
/// assert_eq!(found, Err(GeomError::Count(CountError::TooFewPoints { got: 0, needed: 1 })));
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
pub enum GeomError {
    /// Work that whoever started it has ended, and tells why.
    #[error("the work was ended")]
    Ended,
    /// Knots that no spline can have, or that are not where they are looked for.
    #[error(transparent)]
    Knots(#[from] KnotError),
    /// Weights that leave places without a point.
    #[error(transparent)]
    Weights(#[from] WeightError),
    /// A degree that is not possible there.
    #[error(transparent)]
    Degree(#[from] DegreeError),
    /// Not as many of something as are needed, or too many.
    #[error(transparent)]
    Count(#[from] CountError),
    /// A number or direction that makes no geometry.
    #[error(transparent)]
    Input(#[from] InputError),
    /// A parameter or length where there is nothing.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// Nothing that goes through data or stays within a tolerance.
    #[error(transparent)]
    Fit(#[from] FitError),
    /// A shape at a place that has none.
    #[error(transparent)]
    Local(#[from] LocalError),
    /// What another form cannot hold exactly.
    #[error(transparent)]
    Form(#[from] FormError),
    /// Curves and patches that do not meet as they should.
    #[error(transparent)]
    Joint(#[from] JointError),
    /// Meetings that are no single points.
    #[error(transparent)]
    Intersection(#[from] IntersectionError),
    /// A construction that comes to nothing there.
    #[error(transparent)]
    Construction(#[from] ConstructionError),
    /// What has no size that could be told.
    #[error(transparent)]
    Measure(#[from] MeasureError),
    /// Lines on surfaces and regions that do not exist.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// Regions that cannot be put together.
    #[error(transparent)]
    Region(#[from] RegionError),
    /// Parts of surfaces that are none.
    #[error(transparent)]
    Face(#[from] FaceError),
    /// Solids that are none.
    #[error(transparent)]
    Solid(#[from] SolidError),
    /// Surfaces that enclose nothing.
    #[error(transparent)]
    Shell(#[from] ShellError),
    /// A mesh that encloses nothing, or has colours that are none.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// A function that something is made of has no value.
    #[error(transparent)]
    Function(#[from] FunctionFailure),
    /// What is in pieces that do not meet.
    #[error(transparent)]
    Jump(#[from] JumpError),
}

pub(crate) use super::digits::{few_digits, place};
