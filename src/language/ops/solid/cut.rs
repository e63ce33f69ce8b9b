//! `cut`: the side of a plane.

use std::sync::Arc;

use super::GivenSolid;
use crate::{
    diag::{Result, Spanned},
    kernel::{Frame, Solid},
    value::{At, Choice, Ctx, IntoValue, Type, Value, op},
};

op! {
    /// The part of a solid on one side of a plane, closed by plane faces; `none` where there is nothing.
    ///
    /// Above is where the plane's normal points. Its faces are the parts of the solid's faces there, then the plane ones. Where the side
    /// falls apart, it is one solid of several shells. Its volume must be what its faces tell. What the plane has of the solid is
    /// `section(s, plane)`.
    cut in Solid -> CutPart {
        /// The solid.
        s: GivenSolid,
        /// The plane.
        plane: Spanned<Arc<Frame>>,
        /// Which side stays.
        keep: Side = Side::Below,
    }
    example "volume(cut(solid(sphere((0, 0), 2)), plane((0, 0, 1), (0, 0, 1)), keep = \"above\")) ~= 5/3*pi within 1e-6" => "true";
    example "cut(solid(box((0, 0, 0), (1, 2, 3))), plane((0, 0, 5), (0, 0, 1)), keep = \"above\")" => "none";
    refuses "cut(sphere((0, 0), 2), XY)" => "E0301: `cut`: `s` must be a solid, found a surface";
    scene r#"
        region ring = region(circle((3, 0), 1), holes = [circle((3, 0), 0.6)]) with (hidden = true)
        solid half = cut(revolve(ring, axis = (0, 1, 0)), plane((0, 0, 0), (1, 0, 1)))
    "#;
}

/// A side of a plane.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Below,
    Above,
}

impl Choice for Side {
    const WORDS: &'static [&'static str] = &["below", "above"];
    const MEANINGS: &'static [Self] = &[Self::Below, Self::Above];
}

/// A solid, or what is left where there is nothing.
struct CutPart(Option<Solid>);

impl IntoValue for CutPart {
    const RETURNS: Type = Type::OneOf(&[Type::Solid, Type::None]);

    fn into_value(self) -> Value {
        self.0.map_or(Value::None, |solid| Value::Solid(Arc::new(solid)))
    }
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<CutPart> {
    let is_above = args.keep == Side::Above;
    Ok(CutPart(args.s.cut(*args.plane.value, is_above, ctx.tolerance).at(args.plane.span)?))
}
