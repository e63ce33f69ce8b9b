//! Parts of surfaces, and the curves that surfaces share.
//!
//! A [`Face`] is a surface with the parts of its parameters that belong to it. These are regions of a
//! `plane` of parameters that is stretched so that its lengths are no shorter than those on the surface:
//! what is within the tolerance there is within it in space, and all that cuts faces is the arrangement
//! of plane arcs that regions are made by. `face` has the type, `loops` faces within loops of parameters,
//! `split` those within loops in space and the parts into which cutters divide a face, by the arcs of `cutter_arcs`, or of
//! `overlaid` where cutters lie on the face, that `pull` makes of curves, on plane patches by `on_plane`, through poles by `pole`, over knots by `stretch`, to where others cut by `height`, and by `division`, where surfaces narrow to a point by `pinch`, `touch` tells why a cutter divides nothing, `measure` integrals over faces, `area_and_flux` several by one, of round surfaces by `round_area`, `strip` what those of others go
//! along, `mesh` their triangles and `joined` those of faces and surfaces side by side, `border` their edges in
//! space by arcs of parameters that `lift` takes there, by `conic` as the conics that they are, `extremum` what of them is nearest or reaches farthest by what `bounded` tells of parts,
//! `clip` what of curves lies on them, `beside` what is at a distance beside them, `continuity` how they go on in others, `shell` what they enclose together where `border_edge` finds that they are
//! neighbours, `facing` which must turn to look alike.
//! `arc_of_parameters` has parts of curves of parameters, `edge_parameters` these by the parameter of an edge that is written.
//! `edge` has the curves on two surfaces at once, by places in space and by the parameters of both.

mod arc_of_parameters;
mod area_and_flux;
mod beside;
mod border;
mod border_bounds;
mod border_edge;
mod bounded;
mod clip;
mod conic;
mod continuity;
mod cutter_arcs;
mod division;
mod edge;
mod edge_parameters;
mod error;
mod extremum;
mod face;
mod facing;
mod height;
mod joined;
mod lift;
mod loops;
mod measure;
mod mesh;
mod on_plane;
mod overlaid;
mod pinch;
mod plane;
mod pole;
mod pull;
mod round_area;
mod seam;
mod shell;
mod split;
mod stretch;
mod strip;
mod touch;

pub use arc_of_parameters::ParameterArc;
pub(crate) use area_and_flux::AreaAndFlux;
pub use border::FaceEdge;
pub(crate) use border_edge::FaceBorderEdge;
pub use continuity::FaceContinuity;
pub use edge::{CurveEnd, SurfaceCurve, SurfaceCurveKind};
pub use edge_parameters::{EdgePath, FaceChart};
pub use error::FaceError;
pub use extremum::FaceClosestPoint;
pub use face::{Face, FacePart};
pub use facing::pieces_facing_unlike;
pub(crate) use joined::joined_meshes;
pub use joined::{SurfacePiece, tessellate_together};
pub(crate) use lift::affine_map;
pub(crate) use measure::amid;
pub(crate) use shell::{EnclosedShell, enclosed_shells, rims};
pub use split::Cutter;
pub use strip::AreaStrip;
