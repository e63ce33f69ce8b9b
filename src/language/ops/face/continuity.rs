//! `continuity` of two faces along the edges that they share.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::Face,
    ops::measure::ContinuityOptions,
    value::{Angle, At, Ctx, Curvature, IntoValue, Length, LengthPower, Record, Value, op},
};

op! {
    /// How smoothly a face goes on in another across the edges that they share, as `{g, gap, angle, curvature_gap, at}`.
    ///
    /// `g` is the largest order up to 2 that holds along all of them: 0 an edge in common, 1 the same tangent plane, 2 the
    /// same second fundamental tensor. `gap`, `angle` and `curvature_gap` tell how far edges, tangent planes and normal
    /// curvatures differ at most, and `at` where: the place of the largest angle, or curvature gap where the planes agree.
    /// An edge is shared as far as it runs within the document's tolerance of one of the other face. Each is looked at in
    /// 129 places. Planes are one within 1e-9 rad and what edges leave open, which are known within an eighth of the
    /// tolerance; curvatures within a millionth. `tolerance`, `angle` and `curvature_gap` ask for other limits.
    continuity in Face -> Record {
        /// The first face.
        a: Spanned<Arc<Face>>,
        /// The face that goes on.
        b: Arc<Face>,
        /// How far the edges may be apart; otherwise the document's tolerance, at most a thousandth of the size.
        tolerance: Option<Spanned<Length>>,
        /// By how much tangent planes may differ for G1.
        angle: Option<Spanned<Angle>>,
        /// By how much normal curvatures may differ for G2.
        curvature_gap: Option<Spanned<Curvature>>,
    }
    example "{ let parts = split(sphere((0, 0), 2), by = XY)  continuity(parts[0], parts[1]).g }" => "2";
    example "{ let b = solid(cylinder((0, 0), 1, 3), cap = true)  continuity(b.faces[0], b.faces[1]).angle ~= 90deg within 1e-6deg }" => "true";
    refuses "continuity(face(plane_patch((0, 0), (1, 0), (0, 1))), face(plane_patch((3, 0), (1, 0), (0, 1))))" => "E0607: the faces share no edge: where they come nearest their borders are 2 apart, at (1, 0.003906, 0)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let asked = ContinuityOptions {
        tolerance: args.tolerance,
        angle: args.angle,
        curvature_gap: args.curvature_gap,
    };
    let tolerance = asked.over(ctx.tolerance)?;
    let found = args.a.value.continuity_with(&args.b, tolerance).at(args.a.span)?;
    Ok(Record::new([
        (Arc::from("g"), i64::from(found.g).into_value()),
        (Arc::from("gap"), Length(found.gap).into_value()),
        (Arc::from("angle"), Angle(found.angle).into_value()),
        (Arc::from("curvature_gap"), LengthPower::<-1>(found.curvature_gap).into_value()),
        (Arc::from("at"), Value::Point(found.at)),
    ]))
}
