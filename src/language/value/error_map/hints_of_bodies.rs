//! What to do about parts of surfaces and about solids.

use crate::kernel::{FaceError, SolidError};

/// What to do about loops that bound no part of a surface.
pub(super) fn of_face(error: &FaceError) -> String {
    let hint = match error {
        FaceError::Open { .. } => {
            "a loop ends where it begins, on the surface: `join` the curves along it"
        }
        FaceError::OffDomain { .. } => {
            "the domain is `s.domain_u` by `s.domain_v`; a loop over a seam is cut there"
        }
        FaceError::BothSides { .. } => {
            "loops run with the face to their left: a hole clockwise, seen from where the normal points"
        }
        FaceError::EndsInside { .. } => "let it go on to the border or to another curve",
        FaceError::Apart { .. } => "make a face of each",
        FaceError::OffSurface { .. } => {
            "curves on a surface lie on it within the document's `tolerance`"
        }
        FaceError::BeyondCentre { .. } => {
            "an offset by less, or to the other side, passes none; `trim` the face to what bends less"
        }
        FaceError::NoCommonEdge { .. } => {
            "an edge is shared where it runs within the tolerance of one of the other: `tolerance` allows more"
        }
        FaceError::TooSmall { .. } => {
            "leave it out, make it larger, or state a smaller `tolerance`"
        }
        FaceError::Misses { .. } => "leave it out, or move it to where the face is",
        FaceError::TouchesAt { .. } | FaceError::TouchesAlong { .. } => {
            "leave it out, or move it until it goes through the face; curves from border to border divide it as well"
        }
        FaceError::Covered { .. } => {
            "leave it out; the border of a cutter that lies on a face divides it where it goes over it"
        }
        FaceError::RunsAlong { .. } => {
            "a cutter crosses the face; give the curves that bound the part"
        }
        FaceError::RunsTogether { .. } => {
            "make both of one surface, or let them cross clearly; curves that bound the part cut as well"
        }
        FaceError::NoPartAt { .. } => "give a point on the face, beside the cuts",
        FaceError::OnCut { .. } => "give a point beside the cuts",
        FaceError::OpenShell { .. } => {
            "`solid(..., cap = true)` closes plane rims, `face(region(...))` a plane hole; faces of one cut share its edge"
        }
        FaceError::CrowdedShell { others, .. } if others.len() % 2 == 1 => {
            "bodies that share an edge are solids of their own: give the faces of each, or move one by more than the tolerance"
        }
        FaceError::CrowdedShell { .. } | FaceError::OneSided { .. } => {
            "leave out the faces that do not belong to the border"
        }
        FaceError::Narrow { .. } | FaceError::NearEdges { .. } => {
            "state a smaller `tolerance` at the top of the script"
        }
        FaceError::PartsMissArea { .. } | FaceError::AcrossPlane { .. } => {
            "please report it; moving a cutter a little may help"
        }
        FaceError::TouchesItself { .. } => {
            "part the region there, or keep its holes apart by more than the tolerance"
        }
        FaceError::Nothing => "a loop that runs the other way leaves what is on its other side",
    };
    hint.to_owned()
}

/// What to do about solids.
pub(super) fn of_solid(error: &SolidError) -> String {
    let hint = match error {
        SolidError::AlongPlane { .. } => {
            "give a vector that leaves the plane by more, `r.plane.z` for one"
        }
        SolidError::AxisOffPlane { .. } => {
            "`axis` and `about` are a line in the plane of the region, beside it or along its border"
        }
        SolidError::AcrossAxis { .. } => {
            "cut off what lies on one side, by `difference` of regions"
        }
        SolidError::PointOnAxis { .. } => {
            "move the region by more than the tolerance away from the axis, or let it run along the axis"
        }
        SolidError::ShellsMeet { .. } => {
            "move one of them by more than the tolerance; what crosses is no single solid"
        }
        SolidError::CrossesItself { .. } => {
            "let what the faces are made of cross neither itself nor one another: `regions` of a plane outline are its parts, which `extrude` closes"
        }
        SolidError::Overlaid { .. } => {
            "let sections follow one another without running back, and paths not run along themselves"
        }
        SolidError::Pinched { .. } => {
            "widen it there by more than the tolerance, or make a solid of each side"
        }
        SolidError::Thin { .. } => "state a smaller `tolerance` at the top of the script",
        SolidError::UnclearNesting { .. } => "move one of the shells a little",
        SolidError::UnevenRim { .. } => {
            "close it by a surface of its own, `coons` for one, and give that too"
        }
        SolidError::UnmatchedEdge { .. } => {
            "let the edges of neighbours be the same curves, or state a smaller `tolerance` at the top of the script"
        }
        SolidError::UnclearSide { .. } => {
            "ask about a point that is further from edges and corners"
        }
        SolidError::UncertainCut { .. }
        | SolidError::TouchesPlane { .. }
        | SolidError::TouchesAlong { .. } => "move the plane by more than the tolerance",
        SolidError::ThinTip { .. } => {
            "move the plane through that place or clearly away from it, or state a smaller `tolerance` at the top of the script"
        }
        SolidError::ThinSection { .. } => {
            "move the plane to where the solid is thicker, or state a smaller `tolerance` at the top of the script"
        }
        SolidError::ThinCut { .. } => {
            "move the plane through the edge or clearly away from it, or state a smaller `tolerance` at the top of the script"
        }
        SolidError::OpenRim { .. } => "give the surfaces that are missing; `cap` closes whole rims",
    };
    hint.to_owned()
}
