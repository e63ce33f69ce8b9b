//! `classify` of a surface: what kind of place a pair of parameters is.

use super::inside;
use crate::{
    diag::{Result, Spanned},
    kernel::SurfacePointKind,
    ops::face::SurfaceOrFace,
    value::{At, Choice, Ctx, op},
};

op! {
    /// Kind of place of a surface.
    ///
    /// `"elliptic"` where it bends to one side, `"hyperbolic"` where it bends to both, `"parabolic"` where
    /// it is straight in one direction only and `"planar"` where it is in all; `"singular"` where Su × Sv
    /// vanishes, as at the apex of a cone or at a pole, whatever the shape is there.
    ///
    /// Linkeová, *Curves and Surfaces for Computer Graphics*, Definitions 1.26 and 1.29.
    classify in Measure -> SurfacePointKind {
        /// The surface, or a part of one.
        s: SurfaceOrFace,
        /// The first parameter, inside its domain.
        u: Spanned<f64>,
        /// The second parameter.
        v: Spanned<f64>,
    }
    example "classify(torus((0, 0), 3, 1), 0, 0)" => "\"elliptic\"";
    example "classify(torus((0, 0), 3, 1), 0, 0.25)" => "\"parabolic\"";
    example "classify(torus((0, 0), 3, 1), 0, 0.5)" => "\"hyperbolic\"";
    example "classify(bilinear((0, 0), (0, 1), (1, 0), (1, 1)), 0.5, 0.5)" => "\"planar\"";
    example "classify(bilinear((0, 0), (0, 0), (1, 0), (1, 1)), 0, 0.5)" => "\"singular\"";
    refuses "classify(plane_patch((0, 0), (1, 0), (0, 1)), 2, 0)" => "E0606: parameter 2 is outside the domain 0..1";
}

impl Choice for SurfacePointKind {
    const WORDS: &'static [&'static str] =
        &["elliptic", "parabolic", "hyperbolic", "planar", "singular"];
    const MEANINGS: &'static [Self] =
        &[Self::Elliptic, Self::Parabolic, Self::Hyperbolic, Self::Planar, Self::Singular];
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<SurfacePointKind> {
    let (u, v) = inside(&args.s, args.u, args.v)?;
    args.s.kind_at(u, v, ctx.tolerance).at(ctx.span)
}
