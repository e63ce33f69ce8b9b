//! `solid`: what surfaces and faces enclose.

use crate::{
    diag::{Result, Span, Spanned},
    kernel::{Face, Solid},
    ops::{face::SurfaceOrFace, solid::walls::of_walls},
    value::{Ctx, FromValue, Mismatch, Type, Value, op},
};

op! {
    /// What surfaces and faces enclose that close, whichever way each of them faces.
    ///
    /// Every place of every edge lies on one other edge within the document's tolerance, as for `volume`. Surfaces that hang together are a
    /// shell; shells keep apart. One within another is a void in it, one within a void a body of its own. With `cap` plane rims are closed
    /// by plane faces; rims in one plane together, what an odd number of them goes around.
    /// `s.faces` are its faces, which look outward, in the order of the argument, then the caps; `s.shells` those of each shell. A solid is
    /// itself.
    solid in Solid -> Solid {
        /// A surface or face, or a list of them.
        g: Spanned<SolidBorder>,
        /// Whether plane rims are closed.
        cap: bool = false,
    }
    example "solid(box((0, 0, 0), (1, 2, 3)))" => "solid of 6 faces";
    example "volume(solid(cylinder((0, 0), 1, 3), cap = true)) ~= 3*pi" => "true";
    example "volume(solid([sphere((0, 0), 2), sphere((0, 0), 1)])) ~= 4/3*pi*7" => "true";
    example "len(solid([cylinder((0, 0), 2, 3), cylinder((0, 0), 1, 3)], cap = true).faces)" => "4";
    refuses "solid(cylinder((0, 0), 1, 3))" => "E0612: the faces do not close: an edge is 3 from the nearest other edge, at (0.9927, 0.1204, 0)";
    picture "solid(cone((0, 0), 2, 1, 3), cap = true)";
}

/// What a solid is made of.
enum SolidBorder {
    Parts(Vec<SurfaceOrFace>),
    Solid(super::GivenSolid),
}

impl FromValue for SolidBorder {
    const TYPE: Type = Type::OneOf(&[
        Type::Surface,
        Type::Face,
        Type::Solid,
        Type::List(&Type::OneOf(&[Type::Surface, Type::Face]), 1),
    ]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Solid(solid) => Ok(Self::Solid(solid.clone())),
            Value::Surface(_) | Value::Face(_) => {
                SurfaceOrFace::from_value(value, span).map(|part| Self::Parts(vec![part]))
            }
            Value::List(items) if !items.is_empty() => {
                Vec::from_value(value, span).map(Self::Parts)
            }
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Solid> {
    let Spanned { value: border, span } = args.g;
    let parts = match border {
        SolidBorder::Solid(solid) => return Ok((*solid).clone()),
        SolidBorder::Parts(parts) => parts,
    };
    let face = |part: &SurfaceOrFace| Ok((*part.face(span, ctx.tolerance)?).clone());
    let faces: Vec<Face> = parts.iter().map(face).collect::<Result<_>>()?;
    let made = match args.cap {
        true => Solid::capped(&faces, ctx.tolerance),
        false => Solid::new(&faces, ctx.tolerance),
    };
    of_walls(
        ctx,
        made,
        span,
        "let what the faces are made of cross neither itself nor one another: `regions` of a plane outline are its parts, which `extrude` closes",
    )
}
