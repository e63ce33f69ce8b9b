//! `trim` of a face by cutters: the part beside a point, or beside a plane.

use glam::DVec3;

use super::{Cutters, SurfaceOrFace};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{Cutter, FaceError, GeomError},
    value::{At, Ctx, FromValue, IntoValue, Mismatch, Type, Value, op},
};

op! {
    /// Part of a surface or face beside a point, of those into which cutters divide it as `split` does.
    ///
    /// `keep` is a point on the face, beside the cuts, or `"above"` or `"below"` where the cutter is a plane: above
    /// is where its normal points; or `"inside"` or `"outside"` where it is a solid. Where more than one part is on
    /// that side, all of them are the answer, as a list; `none` where nothing is. A plane or solid that misses or only
    /// touches leaves all of the face, or nothing. What lies on the border of the solid is inside: of a solid's own faces
    /// nothing is outside.
    trim in Face -> TrimmedParts {
        /// The surface or face.
        s: Spanned<SurfaceOrFace>,
        /// A curve on it, a plane, a surface or face, a solid, or a list of them.
        by: Spanned<Cutters>,
        /// What stays.
        keep: Spanned<Keep>,
    }
    example "area(trim(sphere((0, 0), 1), by = plane((0, 0, 0.5), (0, 0, 1)), keep = \"above\")) ~= pi" => "true";
    example "[for f in trim(cylinder((0, 0), 1, 4), by = solid(cylinder((0, 0, 1), 1, 2), cap = true), keep = \"outside\"): area(f)] ~= [2*pi, 2*pi]" => "true";
    example "trim(sphere((0, 0), 1), by = plane((0, 0, 5), (0, 0, 1)), keep = \"above\")" => "none";
    refuses "trim(sphere((0, 0), 1), by = XY, keep = (0, 0, 3))" => "E0607: (0, 0, 3) is 2 from the face: it tells no part of it";
    scene r#"
        face part = trim(sphere((0, 0), 2), by = cylinder((1.2, 0, -3), 0.5, 6), keep = (-2, 0))
    "#;
}

/// Which part stays.
#[derive(Clone)]
enum Keep {
    At(DVec3),
    /// Of a plane.
    Above,
    Below,
    /// Of a solid.
    Inside,
    Outside,
}

impl FromValue for Keep {
    const TYPE: Type =
        Type::OneOf(&[Type::Point, Type::Choice(&["above", "below", "inside", "outside"])]);

    fn from_value(value: &Value, _: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Point(point) => Ok(Self::At(*point)),
            Value::Text(word) if &**word == "above" => Ok(Self::Above),
            Value::Text(word) if &**word == "below" => Ok(Self::Below),
            Value::Text(word) if &**word == "inside" => Ok(Self::Inside),
            Value::Text(word) if &**word == "outside" => Ok(Self::Outside),
            Value::Text(_) => Err(Mismatch::kind(Self::TYPE, value).code(Code::BadChoice)),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

/// One part, or several, or what is left where there is none.
struct TrimmedParts(Value);

impl IntoValue for TrimmedParts {
    const RETURNS: Type = Type::OneOf(&[Type::Face, Type::List(&Type::Face, 2), Type::None]);

    fn into_value(self) -> Value {
        self.0
    }
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<TrimmedParts> {
    let face = args.s.value.face(args.s.span, ctx.tolerance)?;
    let Spanned { value: Cutters { cutters, solid }, span: by } = &args.by;
    let by = *by;
    let mistake = |message: String, hint: &str| {
        Diagnostic::error(Code::BadCall, args.keep.span, message).hint(hint).fail()
    };
    let mut parts = match args.keep.value {
        Keep::At(point) => {
            let part = face.part_at(cutters, point, ctx.tolerance);
            let span = match &part {
                Err(err) if is_misplaced(err) => args.keep.span,
                _ => by,
            };
            return part.at(span).map(|part| TrimmedParts(part.into_value()));
        }
        Keep::Above | Keep::Below => {
            let is_above = matches!(args.keep.value, Keep::Above);
            let [Cutter::Plane(plane)] = cutters[..] else {
                let side = if is_above { "above" } else { "below" };
                let hint =
                    "`keep` is a point of the part that stays, where there are other cutters";
                return mistake(format!("only of one plane a side is \"{side}\""), hint);
            };
            face.beside_plane(plane, is_above, ctx.tolerance).at(by)?
        }
        Keep::Inside | Keep::Outside => {
            let is_inside = matches!(args.keep.value, Keep::Inside);
            let Some(solid) = solid else {
                let side = if is_inside { "inside" } else { "outside" };
                let hint = "`keep` is a point of the part that stays, where there are other cutters; `solid(...)` makes one of surfaces that close";
                return mistake(format!("only of one solid a side is \"{side}\""), hint);
            };
            solid.parts_of(&face, is_inside, ctx.tolerance).at(by)?
        }
    };
    Ok(TrimmedParts(match parts.len() {
        0 => Value::None,
        1 => parts.remove(0).into_value(),
        _ => parts.into_value(),
    }))
}

/// Whether the point is the mistake, not the cutters.
fn is_misplaced(err: &GeomError) -> bool {
    matches!(err, GeomError::Face(FaceError::NoPartAt { .. } | FaceError::OnCut { .. }))
}
