//! `trim` of a face by cutters: the part beside a point, or beside a plane.

use glam::DVec3;

use super::{Cutters, SurfaceOrFace};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::Cutter,
    value::{At, Ctx, FromValue, IntoValue, Mismatch, Type, Value, op},
};

op! {
    /// Part of a surface or face beside a point, of those into which cutters divide it as `split` does.
    ///
    /// `keep` is a point on the face, beside the cuts, or `"above"` or `"below"` where the cutter is a plane: above
    /// is where its normal points. Where more than one part is on that side, all of them are the answer, as a list.
    /// A plane that misses leaves all of the face, or is an error where that is on the other side.
    trim in Face -> TrimmedParts {
        /// The surface or face.
        s: Spanned<SurfaceOrFace>,
        /// A curve on it, a plane, a surface or face, or a list of them.
        by: Spanned<Cutters>,
        /// What stays.
        keep: Spanned<Keep>,
    }
    example "area(trim(sphere((0, 0), 1), by = plane((0, 0, 0.5), (0, 0, 1)), keep = \"above\")) ~= pi" => "true";
    example "area(trim(plane_patch((0, 0), (4, 0), (0, 4)), by = cylinder((2, 2, -1), 1, 2), keep = (0, 0))) ~= 16 - pi" => "true";
    refuses "trim(sphere((0, 0), 1), by = plane((0, 0, 5), (0, 0, 1)), keep = \"above\")" => "E0607: nothing of the face is above the plane";
    refuses "trim(sphere((0, 0), 1), by = XY, keep = (0, 0, 3))" => "E0607: (0, 0, 3) is 2 from the face: it tells no part of it";
    scene r#"
        face part = trim(sphere((0, 0), 2), by = cylinder((1.2, 0, -3), 0.5, 6), keep = (-2, 0))
    "#;
}

/// Which part stays.
#[derive(Clone)]
enum Keep {
    At(DVec3),
    Above,
    Below,
}

impl FromValue for Keep {
    const TYPE: Type = Type::OneOf(&[Type::Point, Type::Choice(&["above", "below"])]);

    fn from_value(value: &Value, _: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Point(point) => Ok(Self::At(*point)),
            Value::Text(word) if &**word == "above" => Ok(Self::Above),
            Value::Text(word) if &**word == "below" => Ok(Self::Below),
            Value::Text(_) => Err(Mismatch::kind(Self::TYPE, value).code(Code::BadChoice)),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

/// One part, or several.
struct TrimmedParts(Value);

impl IntoValue for TrimmedParts {
    const RETURNS: Type = Type::OneOf(&[Type::Face, Type::List(&Type::Face, 2)]);

    fn into_value(self) -> Value {
        self.0
    }
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<TrimmedParts> {
    let face = args.s.value.face(args.s.span, ctx.tolerance)?;
    let Spanned { value: Cutters(cutters), span: by } = &args.by;
    let is_above = match args.keep.value {
        Keep::At(point) => {
            let misplaced = |err: &crate::kernel::GeomError| {
                use crate::kernel::{FaceError, GeomError};
                matches!(err, GeomError::Face(FaceError::NoPartAt { .. } | FaceError::OnCut { .. }))
            };
            let part = face.part_at(cutters, point, ctx.tolerance);
            let span = match &part {
                Err(err) if misplaced(err) => args.keep.span,
                _ => *by,
            };
            return part.at(span).map(|part| TrimmedParts(part.into_value()));
        }
        Keep::Above => true,
        Keep::Below => false,
    };
    let side = if is_above { "above" } else { "below" };
    let [Cutter::Plane(plane)] = cutters[..] else {
        let message = format!("only of one plane a side is \"{side}\"");
        return Diagnostic::error(Code::BadCall, args.keep.span, message)
            .hint("`keep` is a point of the part that stays, where there are other cutters")
            .fail();
    };
    let mut parts = face.beside_plane(plane, is_above, ctx.tolerance).at(*by)?;
    match parts.len() {
        0 => {
            let message = format!("nothing of the face is {side} the plane");
            Diagnostic::error(Code::Degenerate, *by, message)
                .hint("above is where the plane's normal points")
                .fail()
        }
        1 => Ok(TrimmedParts(parts.remove(0).into_value())),
        _ => Ok(TrimmedParts(parts.into_value())),
    }
}
