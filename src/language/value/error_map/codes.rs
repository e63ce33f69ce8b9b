//! The code of each error of the kernel.

use super::inside;
use crate::{
    diag::Code,
    kernel::{
        ConstructionError, CountError, DegreeError, DomainError, FaceError, FaceFault, FitError,
        FormError, GeomError, InputError, IntersectionError, JointError, JumpError, KnotError,
        LocalError, MeasureError, MeshError, PictureError, RegionError, ShellError, SolidError,
        WeightError,
    },
};

/// The code under which an error of the kernel is reported.
#[must_use]
pub fn code_of(error: &GeomError) -> Code {
    match error {
        GeomError::Knots(error) => of_knots(error),
        GeomError::Weights(error) => of_weights(error),
        GeomError::Degree(error) => of_degree(error),
        GeomError::Count(error) => of_count(error),
        GeomError::Input(error) => of_input(error),
        GeomError::Domain(error) => of_domain(error),
        GeomError::Fit(error) => of_fit(error),
        GeomError::Local(error) => of_local(error),
        GeomError::Form(error) => of_form(error),
        GeomError::Joint(error) => of_joint(error),
        GeomError::Measure(error) => of_measure(error),
        GeomError::Construction(error) => of_construction(error),
        GeomError::Picture(error) => of_picture(error),
        GeomError::Jump(error) => of_jump(error),
        GeomError::Intersection(
            IntersectionError::RunTogether { .. }
            | IntersectionError::RunsAlongItself { .. }
            | IntersectionError::Tangled,
        )
        | GeomError::Ended => Code::Degenerate,
        GeomError::Region(error) => of_region(error),
        GeomError::Face(error) => of_face(error),
        GeomError::Solid(error) => of_solid(error),
        GeomError::Shell(error) => of_shell(error),
        GeomError::Mesh(fault) => of_mesh(fault),
        GeomError::Function(_) => inside(error).map_or(Code::Domain, |reason| reason.code),
    }
}

const fn of_region(error: &RegionError) -> Code {
    match error {
        RegionError::OtherPlane { .. } | RegionError::NoCorner { .. } => Code::Degenerate,
        RegionError::Unclear { .. } | RegionError::TooSmall { .. } | RegionError::Thin { .. } => {
            Code::WithinTolerance
        }
        RegionError::NoRoom { .. } => Code::NoRoom,
    }
}

const fn of_face(error: &FaceError) -> Code {
    match error {
        FaceError::OffDomain { .. } => Code::OutsideDomain,
        // Where an even number of faces meet, all of them may belong to what touches itself.
        FaceError::CrowdedShell { others, .. } if others.len() % 2 == 1 => Code::NotManifold,
        FaceError::OpenShell { .. }
        | FaceError::CrowdedShell { .. }
        | FaceError::OneSided { .. } => Code::OpenShell,
        FaceError::RunsTogether { .. } => Code::RunTogether,
        FaceError::BeyondCentre { .. } => Code::BeyondCentre,
        FaceError::Narrow { .. } | FaceError::NearEdges { .. } | FaceError::TooSmall { .. } => {
            Code::WithinTolerance
        }
        FaceError::TouchesItself { .. } => Code::NotManifold,
        FaceError::PartsMissArea { .. } | FaceError::AcrossPlane { .. } => Code::Unproven,
        FaceError::Open { .. }
        | FaceError::BothSides { .. }
        | FaceError::EndsInside { .. }
        | FaceError::Apart { .. }
        | FaceError::OffSurface { .. }
        | FaceError::Misses { .. }
        | FaceError::TouchesAt { .. }
        | FaceError::TouchesAlong { .. }
        | FaceError::Covered { .. }
        | FaceError::RunsAlong { .. }
        | FaceError::NoPartAt { .. }
        | FaceError::NoCommonEdge { .. }
        | FaceError::OnCut { .. }
        | FaceError::Nothing => Code::Degenerate,
    }
}

const fn of_solid(error: &SolidError) -> Code {
    match error {
        SolidError::AlongPlane { .. }
        | SolidError::AxisOffPlane { .. }
        | SolidError::AcrossAxis { .. } => Code::Degenerate,
        SolidError::PointOnAxis { .. }
        | SolidError::ShellsMeet { .. }
        | SolidError::TouchesPlane { .. }
        | SolidError::TouchesAlong { .. }
        | SolidError::Pinched { .. }
        | SolidError::Overlaid { .. }
        | SolidError::CrossesItself { .. } => Code::NotManifold,
        SolidError::Thin { .. }
        | SolidError::UnclearNesting { .. }
        | SolidError::UnmatchedEdge { .. }
        | SolidError::UnclearSide { .. }
        | SolidError::ThinCut { .. }
        | SolidError::ThinTip { .. }
        | SolidError::ThinSection { .. }
        | SolidError::UncertainCut { .. } => Code::WithinTolerance,
        SolidError::UnevenRim { .. } | SolidError::OpenRim { .. } => Code::OpenShell,
    }
}

const fn of_construction(error: &ConstructionError) -> Code {
    match error {
        ConstructionError::Crease { .. }
        | ConstructionError::EndOfContinuation { .. }
        | ConstructionError::ContinuationLost { .. }
        | ConstructionError::AlongNormal { .. }
        | ConstructionError::NoOffset { .. }
        | ConstructionError::OffsetTooFar { .. }
        | ConstructionError::VanishingOffset { .. }
        | ConstructionError::VanishingSection
        | ConstructionError::PointSection
        | ConstructionError::PointPath
        | ConstructionError::PathCusp { .. }
        | ConstructionError::PathCorners { .. }
        | ConstructionError::ClosedBetweenRails
        | ConstructionError::PointBetween { .. }
        | ConstructionError::OnlyPoints
        | ConstructionError::MixedSections { .. }
        | ConstructionError::NoTurn
        | ConstructionError::NotInOnePlane { .. }
        | ConstructionError::TangentAllAlong { .. }
        | ConstructionError::OnAxis => Code::Degenerate,
    }
}

const fn of_picture(error: &PictureError) -> Code {
    match error {
        PictureError::Unresolved { .. }
        | PictureError::SurfacesRunTogether { .. }
        | PictureError::TooTangled { .. }
        | PictureError::OffSurface { .. }
        | PictureError::ToldTwice { .. }
        | PictureError::EndsInside { .. }
        | PictureError::EdgeLost { .. }
        | PictureError::SmallLoop { .. }
        | PictureError::RunsAlong { .. }
        | PictureError::Open { .. }
        | PictureError::OffPlane { .. }
        | PictureError::NoArea { .. }
        | PictureError::Crossing { .. }
        | PictureError::Outside { .. }
        | PictureError::HoleInHole { .. } => Code::Degenerate,
    }
}

const fn of_jump(error: &JumpError) -> Code {
    match error {
        JumpError::Curve { .. }
        | JumpError::Surface { .. }
        | JumpError::Function { .. }
        | JumpError::FunctionAt { .. } => Code::Degenerate,
    }
}

const fn of_shell(error: &ShellError) -> Code {
    match error {
        ShellError::Open { .. }
        | ShellError::Alone { .. }
        | ShellError::Crowded { .. }
        | ShellError::OneSided { .. } => Code::OpenShell,
    }
}

const fn of_knots(error: &KnotError) -> Code {
    match error {
        KnotError::KnotCount { .. }
        | KnotError::TooFewKnots { .. }
        | KnotError::UnsortedKnots { .. }
        | KnotError::KnotMultiplicity { .. }
        | KnotError::NoKnot { .. }
        | KnotError::VanishingPiece { .. }
        | KnotError::VanishingPatch { .. }
        | KnotError::EmptyDomain { .. }
        | KnotError::DomainTooWide { .. } => Code::BadKnots,
    }
}

const fn of_weights(error: &WeightError) -> Code {
    match error {
        WeightError::WeightCount { .. }
        | WeightError::BadWeight { .. }
        | WeightError::BadEndWeight { .. }
        | WeightError::VanishingWeights { .. }
        | WeightError::VanishingWeightsAt { .. } => Code::BadWeights,
    }
}

const fn of_degree(error: &DegreeError) -> Code {
    match error {
        DegreeError::BadDegree { .. } => Code::TooFewPoints,
        DegreeError::DegreeTooHigh { .. } | DegreeError::OrderTooHigh { .. } => Code::TooLarge,
        DegreeError::DegreeTooLow { .. } | DegreeError::LowestDegree { .. } => Code::BadDegree,
    }
}

const fn of_count(error: &CountError) -> Code {
    match error {
        CountError::TooFewPoints { .. } => Code::TooFewPoints,
        CountError::TooManyPoints { .. } | CountError::TooManyVertices { .. } => Code::TooLarge,
        CountError::TooFewCurves { .. } | CountError::TangentCount { .. } => Code::BadCall,
        CountError::WrongCount { .. } => Code::BadParameters,
        CountError::RaggedGrid { .. } | CountError::GridSize { .. } => Code::RaggedGrid,
        CountError::DuplicateColumn { .. } | CountError::ColumnLength { .. } => Code::WrongKind,
        CountError::CountTooSmall { .. }
        | CountError::AttributeCount { .. }
        | CountError::NoSuchVertex { .. } => Code::Degenerate,
    }
}

const fn of_input(error: &InputError) -> Code {
    match error {
        InputError::NotPositive { got, .. } if !got.is_finite() => Code::Domain,
        InputError::NotFinite { .. } => Code::Domain,
        InputError::NotPositive { .. }
        | InputError::NotUnit { .. }
        | InputError::ZeroAxis { .. }
        | InputError::ParallelAxes { .. }
        | InputError::SingularTransform
        | InputError::CoincidentPoints { .. }
        | InputError::Collinear
        | InputError::BadTurn { .. }
        | InputError::TensionTooLow { .. } => Code::Degenerate,
    }
}

const fn of_domain(error: &DomainError) -> Code {
    match error {
        DomainError::EmptyInterval { .. }
        | DomainError::NarrowInterval { .. }
        | DomainError::ParameterOutside { .. }
        | DomainError::ParameterAtEnd { .. }
        | DomainError::OtherDomain { .. }
        | DomainError::LengthOutside { .. } => Code::OutsideDomain,
    }
}

const fn of_fit(error: &FitError) -> Code {
    match error {
        FitError::KnotNeeded { .. }
        | FitError::NotReducible { .. }
        | FitError::NoSurfaceNear { .. }
        | FitError::NoSplineNear { .. }
        | FitError::NoSplineNearAt { .. } => Code::BeyondTolerance,
        FitError::ParametersNotIncreasing { .. } => Code::BadParameters,
        FitError::NoFit | FitError::Undetermined { .. } | FitError::ToleranceNotKept { .. } => {
            Code::Degenerate
        }
    }
}

const fn of_local(error: &LocalError) -> Code {
    match error {
        LocalError::OffFace { .. } => Code::OutsideDomain,
        LocalError::BeyondNumbers { .. } | LocalError::BeyondNumbersAt { .. } => Code::Domain,
        LocalError::NotDifferentiable { .. } | LocalError::DerivativeBeyondNumbers => {
            Code::NoDerivative
        }
        LocalError::VanishingTangent { .. }
        | LocalError::UnboundedCurvature { .. }
        | LocalError::Straight { .. }
        | LocalError::NoSide { .. }
        | LocalError::NoNormal { .. }
        | LocalError::NoCurvature { .. }
        | LocalError::NoTangentAlong { .. }
        | LocalError::AcrossSurface => Code::Degenerate,
    }
}

const fn of_form(error: &FormError) -> Code {
    match error {
        FormError::RationalFor { .. }
        | FormError::DegreeTooHighFor { .. }
        | FormError::UnevenSegments { .. }
        | FormError::TooRough { .. }
        | FormError::TooManySegments { .. }
        | FormError::OtherForm { .. } => Code::NotExact,
        FormError::NotNurbs { .. } => Code::WrongKind,
        FormError::NotScalar { .. }
        | FormError::NoConic { .. }
        | FormError::MixedConics { .. }
        | FormError::NotPlanar { .. } => Code::Degenerate,
    }
}

const fn of_joint(error: &JointError) -> Code {
    match error {
        JointError::Gap { .. } | JointError::PatchGap { .. } => Code::Gap,
        JointError::UnlikeWeights { .. } => Code::NotExact,
    }
}

const fn of_measure(error: &MeasureError) -> Code {
    match error {
        MeasureError::TooLargeToMeasure { .. } | MeasureError::TooSmallToMeasure { .. } => {
            Code::Domain
        }
        MeasureError::NothingThere { .. } => Code::Degenerate,
    }
}

const fn of_mesh(fault: &MeshError) -> Code {
    match fault {
        MeshError::Open { .. } | MeshError::Unoriented { .. } | MeshError::Inverted { .. } => {
            Code::OpenShell
        }
        MeshError::OfSeveral { fault, .. } => of_mesh(fault),
        MeshError::Pinched { .. } | MeshError::TouchesItself { .. } => Code::NotManifold,
        MeshError::Unproven { .. } => Code::Unproven,
        MeshError::BadFace { fault, .. } => match fault {
            FaceFault::TooFew { .. } => Code::TooFewPoints,
            FaceFault::NoVertex { .. } => Code::IndexOutside,
            FaceFault::Repeats { .. } | FaceFault::Crosses | FaceFault::NoPolygon => {
                Code::Degenerate
            }
        },
        MeshError::BadColor { .. }
        | MeshError::BelowRounding { .. }
        | MeshError::CrossesItself { .. }
        | MeshError::Doubled { .. } => Code::Degenerate,
    }
}
