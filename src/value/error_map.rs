//! From an error of the kernel to a diagnostic: the code and the hint for each kind of failure.

use crate::{
    diag::{Code, Diagnostic, Result, Span},
    kernel::{FaceFault, GeomError, JumpError, MeshError, PictureError, ShellError},
    limits::Ceiling,
};

/// Pins an error of the kernel to the place in the script that caused it.
pub trait At<T> {
    /// The same result, blamed on `span`.
    ///
    /// # Errors
    /// The error as a diagnostic.
    fn at(self, span: Span) -> Result<T>;
}

impl<T> At<T> for std::result::Result<T, GeomError> {
    fn at(self, span: Span) -> Result<T> {
        self.map_err(|error| {
            if let Some(reason) = inside(&error) {
                return Box::new(asked_from(reason.clone(), span));
            }
            let mut diagnostic = Diagnostic::error(code_of(&error), span, error.to_string());
            diagnostic.elements = elements_of(&error);
            diagnostic.ceiling = ceiling_of(&error);
            Box::new(match hint_of(&error) {
                Some(hint) => diagnostic.hint(hint),
                None => diagnostic,
            })
        })
    }
}

/// The ceiling that an error of the kernel tells to be crossed.
fn ceiling_of(error: &GeomError) -> Option<&'static str> {
    match error {
        GeomError::TooManyVertices { .. } => Some(Ceiling::MESH_VERTICES),
        _ => None,
    }
}

/// What went wrong inside a function of the script that geometry is made of.
fn inside(error: &GeomError) -> Option<&Diagnostic> {
    match error {
        GeomError::Function(failure) => failure.reason(),
        _ => None,
    }
}

/// The mistake in a function, and who asked the function.
fn asked_from(reason: Diagnostic, span: Span) -> Diagnostic {
    let is_told =
        reason.primary.span == span || reason.others.iter().any(|other| other.span == span);
    if is_told { reason } else { reason.also(span, "asked from here") }
}

/// The elements of a list of the script that an error of the kernel is about, by their indices.
fn elements_of(error: &GeomError) -> Vec<Vec<usize>> {
    use GeomError as Error;
    match error {
        Error::Gap { index, .. } => vec![vec![*index], vec![index + 1]],
        Error::CoincidentPoints { first, second } => vec![vec![*first], vec![*second]],
        Error::PatchGap { before, next, .. } | Error::UnlikeWeights { before, next } => {
            vec![before.to_vec(), next.to_vec()]
        }
        Error::VanishingPatch { patch, .. } => vec![patch.to_vec()],
        Error::BadWeight { index, .. }
        | Error::BadEndWeight { index, .. }
        | Error::UnsortedKnots { index, .. }
        | Error::KnotMultiplicity { index, .. }
        | Error::ParametersNotIncreasing { index, .. }
        | Error::VanishingPiece { index, .. }
        | Error::NotScalar { index } => vec![vec![*index]],
        _ => Vec::new(),
    }
}

/// The code under which an error of the kernel is reported.
#[must_use]
pub fn code_of(error: &GeomError) -> Code {
    use GeomError as Error;
    match error {
        Error::TooFewPoints { .. } | Error::BadDegree { .. } => Code::TooFewPoints,
        Error::TooManyPoints { .. }
        | Error::DegreeTooHigh { .. }
        | Error::OrderTooHigh { .. }
        | Error::TooManyVertices { .. } => Code::TooLarge,
        Error::DegreeTooLow { .. } | Error::LowestDegree { .. } => Code::BadDegree,
        Error::KnotNeeded { .. }
        | Error::NotReducible { .. }
        | Error::NoSurfaceNear { .. }
        | Error::NoSplineNear { .. }
        | Error::NoSplineNearAt { .. } => Code::BeyondTolerance,
        Error::Jump(_) => Code::Degenerate,
        Error::Gap { .. } | Error::PatchGap { .. } => Code::Gap,
        Error::Shell(_) => Code::OpenShell,
        Error::Mesh(fault) => code_of_mesh(fault),
        Error::RationalFor { .. }
        | Error::DegreeTooHighFor { .. }
        | Error::UnevenSegments { .. }
        | Error::TooRough { .. }
        | Error::TooManySegments { .. }
        | Error::OtherForm { .. }
        | Error::UnlikeWeights { .. } => Code::NotExact,
        Error::KnotCount { .. }
        | Error::TooFewKnots { .. }
        | Error::UnsortedKnots { .. }
        | Error::KnotMultiplicity { .. }
        | Error::NoKnot { .. }
        | Error::VanishingPiece { .. }
        | Error::VanishingPatch { .. }
        | Error::EmptyDomain { .. }
        | Error::DomainTooWide { .. } => Code::BadKnots,
        Error::WeightCount { .. }
        | Error::BadWeight { .. }
        | Error::BadEndWeight { .. }
        | Error::VanishingWeights { .. }
        | Error::VanishingWeightsAt { .. } => Code::BadWeights,
        Error::RaggedGrid { .. } | Error::GridSize { .. } => Code::RaggedGrid,
        Error::ParameterOutside { .. }
        | Error::ParameterAtEnd { .. }
        | Error::OtherDomain { .. }
        | Error::LengthOutside { .. }
        | Error::EmptyInterval { .. }
        | Error::NarrowInterval { .. } => Code::OutsideDomain,
        Error::NotPositive { got, .. } if !got.is_finite() => Code::Domain,
        Error::NotFinite { .. }
        | Error::TooLargeToMeasure { .. }
        | Error::TooSmallToMeasure { .. }
        | Error::BeyondNumbers { .. }
        | Error::BeyondNumbersAt { .. } => Code::Domain,
        Error::NotDifferentiable { .. } | Error::DerivativeBeyondNumbers => Code::NoDerivative,
        Error::TooFewCurves { .. } | Error::TangentCount { .. } => Code::BadCall,
        Error::Function(_) => inside(error).map_or(Code::Domain, |reason| reason.code),
        Error::DuplicateColumn { .. } | Error::ColumnLength { .. } | Error::NotNurbs { .. } => {
            Code::WrongKind
        }
        Error::WrongCount { .. } | Error::ParametersNotIncreasing { .. } => Code::BadParameters,
        _ => Code::Degenerate,
    }
}

fn code_of_mesh(fault: &MeshError) -> Code {
    match fault {
        MeshError::Open { .. } | MeshError::Unoriented { .. } => Code::OpenShell,
        MeshError::BadFace { fault: FaceFault::TooFew { .. }, .. } => Code::TooFewPoints,
        MeshError::BadFace { fault: FaceFault::NoVertex { .. }, .. } => Code::IndexOutside,
        _ => Code::Degenerate,
    }
}

/// What to do about an error of the kernel, where the message alone does not tell.
#[must_use]
#[expect(clippy::too_many_lines, reason = "one table")]
pub fn hint_of(error: &GeomError) -> Option<String> {
    use GeomError as Error;
    Some(match error {
        Error::VanishingTangent { .. } | Error::UnboundedCurvature { .. } => {
            "the curve stands still there: are points repeated?".to_owned()
        }
        Error::DegreeTooLow { .. } => {
            "name the degree of the result; `reduce(c, tolerance)` makes it lower".to_owned()
        }
        Error::KnotNeeded { error, .. } | Error::NotReducible { error, .. }
            if error.is_finite() =>
        {
            format!("a tolerance of {} allows it; or keep the curve as it is", raised(*error))
        }
        Error::Gap { reversed: Some(index), .. } => {
            format!("`reversed(curves[{index}])` would fit")
        }
        Error::Gap { .. } => "give the curves in order, end to start".to_owned(),
        Error::Crease { along, parameter, .. } => {
            format!("`split(s, {along} = {parameter})` gives parts that have offsets")
        }
        Error::NoSurfaceNear { .. } => {
            "allow a larger tolerance, or `trim` away what has no smooth offset".to_owned()
        }
        Error::PatchGap { .. } => {
            "`patches[i][j]` goes on behind `patches[i - 1][j]` along u and behind `patches[i][j - 1]` along v; `swap_uv`, `reverse_u` and `reverse_v` turn patches".to_owned()
        }
        Error::VanishingPatch { .. } => "`reparametrize` the patches to similar domains".to_owned(),
        Error::VanishingPiece { .. } => "`reparametrize` the curves to similar domains".to_owned(),
        Error::RunTogether { .. } | Error::RunsAlongItself { .. } => {
            "curves that share a stretch have no single points there; `trim` it away".to_owned()
        }
        Error::TooLargeToMeasure { .. } => {
            "scale it down, or state a larger `unit`".to_owned()
        }
        Error::TooSmallToMeasure { .. } => "scale it up, or state a smaller `unit`".to_owned(),
        Error::NotPositive { got, .. } if !got.is_finite() => {
            "scale it down, or state a larger `unit`".to_owned()
        }
        Error::AlongNormal { .. } => "give another `normal`".to_owned(),
        Error::NotNurbs { what } => match *what {
            "curve" => "`to_nurbs(c, tolerance)` makes a NURBS of it".to_owned(),
            _ => "`to_nurbs(s, tolerance)` makes a NURBS of it".to_owned(),
        },
        Error::NoCurvature { .. } | Error::NoNormal { .. } => {
            "the parametrization is singular there, as where control points are repeated".to_owned()
        }
        Error::AcrossSurface => {
            "directions of the tangent plane are those of `tangent_u` and `tangent_v`".to_owned()
        }
        Error::Mesh(error) => return hint_about_mesh(error),
        Error::Shell(error @ (ShellError::Open { .. } | ShellError::Alone { .. })) => {
            match error.slit() {
                Some([gap, allowed]) => format!(
                    "edges are one within {allowed}: let both run through the same points, or raise the document's `tolerance` above {gap}"
                ),
                None => "a volume needs surfaces that close it; `area` needs none".to_owned(),
            }
        }
        Error::Shell(ShellError::Crowded { .. }) => {
            "give the surfaces of one body at a time, and each of them once".to_owned()
        }
        Error::Undetermined { .. } => "ask for fewer control points".to_owned(),
        Error::Straight { .. } => {
            "a straight place has a tangent and a normal plane, but no direction across stands out"
                .to_owned()
        }
        Error::NoSide { .. } => {
            "give the `normal` of the plane that the curve is seen from".to_owned()
        }
        _ => return hint_about_input(error),
    })
}

/// A number with two digits, no smaller.
fn raised(x: f64) -> String {
    let rounded: f64 = format!("{x:.1e}").parse().unwrap_or(x);
    let step = libm::pow(10.0, libm::log10(x.abs()).floor() - 1.0);
    let up = if rounded < x { rounded + step } else { rounded };
    super::rounded(up)
}

fn hint_about_mesh(error: &MeshError) -> Option<String> {
    let hint = match error {
        MeshError::BelowRounding { .. } => {
            "allow a larger tolerance, or bring the geometry nearer to the origin"
        }
        MeshError::Open { .. } => {
            "a volume needs a mesh that closes it, `area` needs none; `border(m)` shows the holes"
        }
        MeshError::BadFace { fault: FaceFault::Crosses, .. } => {
            "list the corners in their order around the face, or give it in parts that do not cross"
        }
        MeshError::BadFace { .. } | MeshError::BadColor { .. } | MeshError::Unoriented { .. } => {
            return None;
        }
    };
    Some(hint.to_owned())
}

/// What to do about points, knots, weights and parameters that make no geometry.
fn hint_about_input(error: &GeomError) -> Option<String> {
    use GeomError as Error;
    Some(match error {
        Error::KnotCount { points, degree, .. } => format!(
            "the number of knots is points + degree + 1 = {points} + {degree} + 1; without `knots` they are made"
        ),
        Error::UnsortedKnots { .. } => "sort the knots".to_owned(),
        Error::KnotMultiplicity { most, .. } => format!("repeat a knot {most} times at most"),
        Error::WeightCount { .. } => "give one weight for each control point".to_owned(),
        Error::BadWeight { .. } => {
            "the larger a weight, the nearer the curve comes to its point; at zero the point is gone"
                .to_owned()
        }
        Error::BadEndWeight { .. } => {
            "a weight of zero takes its point away, which the ends cannot do without".to_owned()
        }
        Error::ParametersNotIncreasing { .. } => {
            "give the data in the order of their parameters, each parameter once".to_owned()
        }
        Error::OtherDomain { .. } => "`reparametrize` one of them".to_owned(),
        Error::EndOfContinuation { .. } | Error::ContinuationLost { .. } => {
            "`join` a `line` or an `arc` to its end to go further".to_owned()
        }
        Error::TangentCount { .. } => "give one tangent for each point".to_owned(),
        Error::Collinear => "a straight curve is made by `line` or `polyline`".to_owned(),
        Error::TooManySegments { .. } | Error::UnevenSegments { .. } => {
            "`to_bezier` gives its segments one by one".to_owned()
        }
        Error::TooRough { .. } => "`split` it there, and take the parts".to_owned(),
        Error::ParameterOutside { .. } => {
            "`reparametrize` gives it another domain; a place by length is `parameter_at_length`"
                .to_owned()
        }
        Error::DomainTooWide { .. } => {
            "knots are parameters, such as 0 to 1, and no coordinates".to_owned()
        }
        Error::NotScalar { .. } => "give the values as points `(value, 0)`".to_owned(),
        _ => return hint_of_function(error),
    })
}

/// How to part what jumps.
fn hint_of_jump(jump: &JumpError) -> String {
    match jump {
        JumpError::Curve { parameter, .. } => {
            format!("`split(c, {parameter})` gives both sides of the jump")
        }
        JumpError::Surface { along, at, .. } => {
            format!("`split(s, {along} = {at})` gives both sides of the jump")
        }
        JumpError::Function { .. } => {
            "a curve is connected: make one of each side, up to the jump".to_owned()
        }
        JumpError::FunctionAt { .. } => {
            "a surface is connected: make one of each side, up to the jump".to_owned()
        }
    }
}

/// What to do about a function that no spline comes near, and about lines on surfaces.
fn hint_of_function(error: &GeomError) -> Option<String> {
    use GeomError as Error;
    Some(match error {
        Error::Jump(jump) => hint_of_jump(jump),
        Error::Picture(error) => return hint_of_picture(error),
        Error::Tangled => {
            "`trim` the curves to where they should meet; what runs together has no single points"
                .to_owned()
        }
        Error::NoSplineNear { .. } | Error::NoSplineNearAt { .. } => {
            "the function changes too fast there: take a part of it, or a larger tolerance where there is one"
                .to_owned()
        }
        _ => return None,
    })
}

/// What to do about lines on surfaces and regions.
fn hint_of_picture(error: &PictureError) -> Option<String> {
    use PictureError as Error;
    let hint = match error {
        Error::Unresolved { .. } => {
            "move or turn the plane or the light a little; a surface that runs along a line has none there"
        }
        Error::SurfacesRunTogether { .. } => {
            "surfaces that share an area have no curve there; `trim` it away, or move one of them"
        }
        Error::TooTangled { .. }
        | Error::OffSurface { .. }
        | Error::ToldTwice { .. }
        | Error::EndsInside { .. } => {
            "`trim` the surfaces to where they should cross, or state a larger `tolerance`"
        }
        Error::RunsAlong { .. } => {
            "a curve that lies in the surface has no single points there; `trim` it away"
        }
        Error::Open { .. } => "a region has a closed border; `join` the curves around it",
        Error::OffPlane { .. } => "`project(c, plane)` brings a curve into a plane",
        Error::Crossing { .. } => {
            "a border goes around once and apart from others; `offset` or move one"
        }
        Error::Outside { .. } | Error::HoleInHole { .. } => {
            "the first curve is the outer border, all others are holes in it"
        }
        Error::NoArea { .. } => {
            "a border goes once around: one that crosses itself, as a bow tie does, takes its area back; give its corners in the order in which they stand around it"
        }
    };
    Some(hint.to_owned())
}
