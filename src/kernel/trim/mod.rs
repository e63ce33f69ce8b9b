//! Parts of surfaces: the curves that bound them.
//!
//! `edge` has the curves on two surfaces at once, by places in space and by the parameters of both.

mod edge;

pub use edge::{CurveEnd, SurfaceCurve, SurfaceCurveKind};
