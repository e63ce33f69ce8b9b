//! `face` of a surface: the part of it within loops.

use super::{SurfaceOrFace, loops};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Face, NurbsCurve},
    ops::region::Border,
    value::{At, Choice, Ctx, Maybe, op},
};

op! {
    /// Part of a surface that lies to the left of closed curves on it; without loops all of it.
    ///
    /// Left is seen from the tip of Su × Sv: a hole runs clockwise. Loops lie on the surface within the
    /// document's tolerance, or are curves of its parameters, `(u, v)`, with `space = "uv"`, which are kept
    /// exactly. They may run over the seam of a closed surface and around its poles. A list of curves is joined
    /// first, as `join` does. Loops that cross, touch or contradict one another make no face.
    ///
    /// What is asked of a surface at parameters is asked of a face too, inside of it: `f(u, v)`, `normal`,
    /// `principal` ... `f.surface` is the surface, `f.edges` the border from corner to corner, `f.loops` one
    /// closed curve for each loop.
    face in Face -> Face {
        /// The surface.
        s: Spanned<SurfaceOrFace>,
        /// Closed curves, or lists of curves that are joined to one.
        loops: Spanned<Maybe<Vec<Border>>>,
        /// Whether loops are curves in space or of parameters.
        space: LoopSpace = LoopSpace::Space,
    }
    example "face(sphere((0, 0), 1))" => "face of a surface of degree 2 x 2, all of it";
    example "area(face(plane_patch((0, 0), (4, 0), (0, 4)), [circle((2, 2), 1)])) ~= pi" => "true";
    example "area(face(plane_patch((0, 0), (4, 0), (0, 4)), [reversed(circle((2, 2), 1))])) ~= 16 - pi" => "true";
    example "area(face(sphere((0, 0), 2), [polyline([(0, 0.5), (0.25, 0.5), (0.25, 1), (0, 1)], closed = true)], space = \"uv\")) ~= 2*pi" => "true";
    refuses "face(plane_patch((0, 0), (4, 0), (0, 4)), [line((1, 1), (2, 2))])" => "E0607: loop [0] does not close: its ends are 1.414 apart";
    refuses "face(plane_patch((0, 0), (4, 0), (0, 4)), [circle((2, 2, 1), 1)])" => "E0607: loop is 1 from the surface at (2.93, 2.368, 1)";
    scene r#"
        face f = face(plane_patch((0, 0), (4, 0), (0, 4)), [reversed(circle((2, 2), 1))]) with (color = "lightgray")
        curves border = f.edges with (color = "red")
    "#;
}

/// What loops are curves of.
#[derive(Clone, Copy, Debug, PartialEq)]
enum LoopSpace {
    Space,
    Parameters,
}

impl Choice for LoopSpace {
    const WORDS: &'static [&'static str] = &["xyz", "uv"];
    const MEANINGS: &'static [Self] = &[Self::Space, Self::Parameters];
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Face> {
    let (Spanned { value: of, span }, at) = (&args.s, args.loops.span);
    let Some(borders) = args.loops.value.0 else {
        return of.face(*span, ctx.tolerance).map(|face| (*face).clone());
    };
    if of.is_face() {
        let message = "a face has its loops already";
        let hint = "`split` and `trim` make parts of it; `f.surface` is its whole surface";
        return Diagnostic::error(Code::BadCall, at, message).hint(hint).fail();
    }
    let surface = std::sync::Arc::clone(of.nurbs().at(*span)?);
    let loops: Vec<NurbsCurve> = loops(&borders, at, ctx)?;
    let face = match args.space {
        LoopSpace::Space => Face::bounded(surface, &loops, ctx.tolerance),
        LoopSpace::Parameters => Face::within(surface, &loops, ctx.tolerance),
    };
    face.at(at)
}
