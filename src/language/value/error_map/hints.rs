//! What to do about errors of the kernel, where the message alone does not tell.

use super::hints_of_bodies::{of_face, of_solid};
use crate::kernel::{
    ConstructionError, CountError, DegreeError, DomainError, FaceFault, FitError, FormError,
    GeomError, InputError, IntersectionError, JointError, JumpError, KnotError, LocalError,
    MeasureError, MeshError, PictureError, RegionError, ShellError, WeightError,
};

/// What to do about an error of the kernel, where the message alone does not tell.
#[must_use]
pub fn hint_of(error: &GeomError) -> Option<String> {
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
        GeomError::Intersection(error) => of_intersection(error),
        GeomError::Construction(error) => of_construction(error),
        GeomError::Measure(error) => of_measure(error),
        GeomError::Shell(error) => of_shell(error),
        GeomError::Mesh(error) => of_mesh(error),
        GeomError::Jump(jump) => Some(of_jump(jump)),
        GeomError::Picture(error) => Some(of_picture(error)),
        GeomError::Region(error) => Some(of_region(error)),
        GeomError::Face(error) => Some(of_face(error)),
        GeomError::Solid(error) => Some(of_solid(error)),
        GeomError::Function(_) | GeomError::Ended => None,
    }
}

fn of_knots(error: &KnotError) -> Option<String> {
    Some(match error {
        KnotError::VanishingPatch { .. } => {
            "`reparametrize` the patches to similar domains".to_owned()
        }
        KnotError::VanishingPiece { .. } => {
            "`reparametrize` the curves to similar domains".to_owned()
        }
        KnotError::KnotCount { points, degree, .. } => format!(
            "the number of knots is points + degree + 1 = {points} + {degree} + 1; without `knots` they are made"
        ),
        KnotError::UnsortedKnots { .. } => "sort the knots".to_owned(),
        KnotError::KnotMultiplicity { most, .. } => format!("repeat a knot {most} times at most"),
        KnotError::DomainTooWide { .. } => {
            "knots are parameters, such as 0 to 1, and no coordinates".to_owned()
        }
        _ => return None,
    })
}

fn of_weights(error: &WeightError) -> Option<String> {
    Some(match error {
        WeightError::WeightCount { .. } => "give one weight for each control point".to_owned(),
        WeightError::BadWeight { .. } => {
            "the larger a weight, the nearer the curve comes to its point; at zero the point is gone"
                .to_owned()
        }
        WeightError::BadEndWeight { .. } => {
            "a weight of zero takes its point away, which the ends cannot do without".to_owned()
        }
        _ => return None,
    })
}

fn of_degree(error: &DegreeError) -> Option<String> {
    Some(match error {
        DegreeError::DegreeTooLow { .. } => {
            "name the degree of the result; `reduce(c, tolerance)` makes it lower".to_owned()
        }
        _ => return None,
    })
}

fn of_count(error: &CountError) -> Option<String> {
    Some(match error {
        CountError::TangentCount { .. } => "give one tangent for each point".to_owned(),
        CountError::ColumnLength { name, got, expected } => {
            let change = if got < expected { "add to" } else { "take from" };
            let values = got.abs_diff(*expected);
            format!(
                "a table has a value of each column in each row: {change} {name:?} {values} {}",
                if values == 1 { "value" } else { "values" }
            )
        }
        _ => return None,
    })
}

fn of_input(error: &InputError) -> Option<String> {
    Some(match error {
        InputError::NotPositive { got, .. } if !got.is_finite() => {
            "scale it down, or state a larger `unit`".to_owned()
        }
        InputError::Collinear => "points within the `tolerance` of a line lie on it; a straight curve is made by `line` or `polyline`".to_owned(),
        _ => return None,
    })
}

fn of_domain(error: &DomainError) -> Option<String> {
    Some(match error {
        DomainError::OtherDomain { .. } => "`reparametrize` one of them".to_owned(),
        DomainError::ParameterOutside { .. } => {
            "`reparametrize` gives it another domain; a place by length is `parameter_at_length`"
                .to_owned()
        }
        _ => return None,
    })
}

fn of_fit(error: &FitError) -> Option<String> {
    Some(match error {
        FitError::KnotNeeded { error, .. } | FitError::NotReducible { error, .. }
            if error.is_finite() =>
        {
            format!("a tolerance of {} allows it; or keep the curve as it is", raised(*error))
        }
        FitError::NoSurfaceNear { .. } => {
            "allow a larger tolerance, or `trim` away what has no smooth offset".to_owned()
        }
        FitError::Undetermined { .. } => "ask for fewer control points".to_owned(),
        FitError::ParametersNotIncreasing { .. } => {
            "give the data in the order of their parameters, each parameter once".to_owned()
        }
        FitError::NoSplineNear { .. } | FitError::NoSplineNearAt { .. } => {
            "the function changes too fast there: take a part of it, or a larger tolerance where there is one"
                .to_owned()
        }
        _ => return None,
    })
}

fn of_local(error: &LocalError) -> Option<String> {
    Some(match error {
        LocalError::VanishingTangent { .. } | LocalError::UnboundedCurvature { .. } => {
            "the curve stands still there: are points repeated?".to_owned()
        }
        LocalError::NoCurvature { .. } | LocalError::NoNormal { .. } => {
            "the parametrization is singular there, as where control points are repeated".to_owned()
        }
        LocalError::AcrossSurface => {
            "directions of the tangent plane are those of `tangent_u` and `tangent_v`".to_owned()
        }
        LocalError::Straight { .. } => {
            "a straight place has a tangent and a normal plane, but no direction across stands out"
                .to_owned()
        }
        LocalError::NoSide { .. } => {
            "give the `normal` of the plane that the curve is seen from".to_owned()
        }
        _ => return None,
    })
}

fn of_form(error: &FormError) -> Option<String> {
    Some(match error {
        FormError::NotNurbs { what } => match *what {
            "curve" => "`to_nurbs(c, tolerance)` makes a NURBS of it".to_owned(),
            _ => "`to_nurbs(s, tolerance)` makes a NURBS of it".to_owned(),
        },
        FormError::TooManySegments { .. } | FormError::UnevenSegments { .. } => {
            "`to_bezier` gives its segments one by one".to_owned()
        }
        FormError::TooRough { .. } => "`split` it there, and take the parts".to_owned(),
        FormError::NotScalar { .. } => "give the values as points `(value, 0)`".to_owned(),
        _ => return None,
    })
}

fn of_joint(error: &JointError) -> Option<String> {
    Some(match error {
        JointError::Gap { reversed: Some(index), .. } => {
            format!("`reversed(curves[{index}])` would fit")
        }
        JointError::Gap { .. } => "give the curves in order, end to start".to_owned(),
        JointError::PatchGap { .. } => {
            "`patches[i][j]` goes on behind `patches[i - 1][j]` along u and behind `patches[i][j - 1]` along v; `swap_uv`, `reverse_u` and `reverse_v` turn patches".to_owned()
        }
        _ => return None,
    })
}

fn of_intersection(error: &IntersectionError) -> Option<String> {
    Some(match error {
        IntersectionError::RunTogether { .. } | IntersectionError::RunsAlongItself { .. } => {
            "curves that share a stretch have no single points there; `trim` it away".to_owned()
        }
        IntersectionError::Tangled => {
            "`trim` the curves to where they should meet; what runs together has no single points"
                .to_owned()
        }
    })
}

fn of_construction(error: &ConstructionError) -> Option<String> {
    Some(match error {
        ConstructionError::Crease { along, parameter, .. } => {
            format!("`split(s, {along} = {parameter})` gives parts that have offsets")
        }
        ConstructionError::AlongNormal { .. } => "give another `normal`".to_owned(),
        ConstructionError::EndOfContinuation { .. }
        | ConstructionError::ContinuationLost { .. } => {
            "`join` a `line` or an `arc` to its end to go further".to_owned()
        }
        ConstructionError::PathCusp { .. } => {
            "`split` it there, and sweep along both parts".to_owned()
        }
        ConstructionError::PathCorners { .. } => {
            "`corner = \"miter\"` lets both sides meet in the plane that halves the angle; or round the path, or `split` it there".to_owned()
        }
        ConstructionError::MixedSections { .. } => {
            "cut the closed one where the open one begins, or take it as it is with `align = false`"
                .to_owned()
        }
        ConstructionError::TangentAllAlong { .. } => {
            "`trim` the curves to what should be touched".to_owned()
        }
        ConstructionError::ClosedBetweenRails => {
            "`split` the section, or give one rail, to which z points".to_owned()
        }
        _ => return None,
    })
}

fn of_measure(error: &MeasureError) -> Option<String> {
    Some(match error {
        MeasureError::TooLargeToMeasure { .. } => {
            "scale it down, or state a larger `unit`".to_owned()
        }
        MeasureError::TooSmallToMeasure { .. } => {
            "scale it up, or state a smaller `unit`".to_owned()
        }
        _ => return None,
    })
}

fn of_shell(error: &ShellError) -> Option<String> {
    Some(match error {
        error @ (ShellError::Open { .. } | ShellError::Alone { .. }) => match error.slit() {
            Some([gap, allowed]) => format!(
                "edges are one within {allowed}: let both run through the same points, or raise the document's `tolerance` above {gap}"
            ),
            None => "a volume needs surfaces that close it; `area` needs none".to_owned(),
        },
        ShellError::Crowded { .. } => {
            "give the surfaces of one body at a time, and each of them once".to_owned()
        }
        _ => return None,
    })
}

/// A number with two digits, no smaller.
#[must_use]
pub fn raised(x: f64) -> String {
    let rounded: f64 = format!("{x:.1e}").parse().unwrap_or(x);
    let step = libm::pow(10.0, libm::log10(x.abs()).floor() - 1.0);
    let up = if rounded < x { rounded + step } else { rounded };
    super::super::rounded(up)
}

fn of_mesh(error: &MeshError) -> Option<String> {
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
        MeshError::OfSeveral { fault, .. } => return of_mesh(fault),
        MeshError::Inverted { .. } => {
            "list the corners of each face counter-clockwise, seen from outside"
        }
        MeshError::Doubled { .. } => {
            "give the parts as meshes of their own: `union` makes them one; a hole faces the other way"
        }
        MeshError::CrossesItself { .. } => {
            "make it of parts that do not cross, whose `union` is one body"
        }
        MeshError::Pinched { .. } => "give the parts as meshes of their own",
        MeshError::TouchesItself { .. } => {
            "move one of the meshes by more than the document's tolerance, so that they overlap or keep apart"
        }
        MeshError::Unproven { .. } => {
            "please report it; moving one of the meshes a little may help"
        }
        MeshError::BadFace { .. } | MeshError::BadColor { .. } | MeshError::Unoriented { .. } => {
            return None;
        }
    };
    Some(hint.to_owned())
}

/// How to part what jumps.
fn of_jump(jump: &JumpError) -> String {
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

/// What to do about regions that cannot be put together.
fn of_region(error: &RegionError) -> String {
    let hint = match error {
        RegionError::OtherPlane { .. } => {
            "regions are put together in one plane; `project` or `place` the curves into it"
        }
        RegionError::Unclear { .. } | RegionError::Thin { .. } => {
            "let borders run along one another exactly or cross clearly, or state a smaller `tolerance`"
        }
        RegionError::TooSmall { .. } => {
            "leave it out, make it larger, or state a smaller `tolerance`"
        }
        RegionError::NoRoom { .. } => {
            "the arc must touch both sides of the corner, beside the arcs of its neighbours; take a smaller radius"
        }
        RegionError::NoCorner { .. } => {
            "`corners(r.outer)` has the parameters of the corners, `r.outer(t)` the points"
        }
    };
    hint.to_owned()
}

/// What to do about lines on surfaces and regions.
fn of_picture(error: &PictureError) -> String {
    let hint = match error {
        PictureError::Unresolved { .. } => {
            "move or turn the plane or the light a little; a surface that runs along a line has none there"
        }
        PictureError::SurfacesRunTogether { .. } => {
            "surfaces that share an area have no curve there; `trim` it away, or move one of them"
        }
        PictureError::TooTangled { .. }
        | PictureError::OffSurface { .. }
        | PictureError::ToldTwice { .. }
        | PictureError::EndsInside { .. }
        | PictureError::EdgeLost { .. }
        | PictureError::SmallLoop { .. } => {
            "`trim` the surfaces to where they should cross, or state a larger `tolerance`"
        }
        PictureError::RunsAlong { .. } => {
            "a curve that lies in the surface has no single points there; `trim` it away"
        }
        PictureError::Open { .. } => "a region has a closed border; `join` the curves around it",
        PictureError::OffPlane { .. } => "`project(c, plane)` brings a curve into a plane",
        PictureError::Crossing { .. } => {
            "a border goes around once and apart from others; `offset` or move one"
        }
        PictureError::Outside { .. } | PictureError::HoleInHole { .. } => {
            "the first curve is the outer border, all others are holes in it"
        }
        PictureError::NoArea { .. } => {
            "a border goes once around: one that crosses itself, as a bow tie does, takes its area back; give its corners in the order in which they stand around it"
        }
    };
    hint.to_owned()
}
