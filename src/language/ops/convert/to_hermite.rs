//! `to_hermite`: a curve as points and tangents.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::NurbsCurve,
    value::{At, Ctx, IntoValue, Record, op},
};

op! {
    /// Points and derivatives at the joints of a cubic, `{points, tangents}`, of which `hermite`
    /// makes the same curve.
    ///
    /// The derivatives are those for one unit of parameter a segment, as `hermite` takes them.
    /// Refused where nothing but an approximation exists: for weights that differ, degrees above
    /// 3, segments that are not equally long in parameter, and corners.
    /// Linkeová, *Curves and Surfaces for Computer Graphics*, (2.26).
    to_hermite in Curve -> Record {
        /// The curve.
        c: Spanned<Arc<NurbsCurve>>,
    }
    example "to_hermite(bezier((1, 0), (0, 1), (3, 3), (4, 2))).tangents" => "[(-3, 3, 0), (3, -3, 0)]";
    example "to_hermite(bezier((0, 0), (1, 2), (2, 0)))" => "{points: [(0, 0, 0), (2, 0, 0)], tangents: [(2, 4, 0), (2, -4, 0)]}";
    refuses "to_hermite(circle((0, 0), 1))" => "E0611: a Hermite chain has no weights, but those of the curve differ";
    refuses "to_hermite(bezier((0, 0), (1, 2), (2, 0), (3, 1), (4, 0)))" => "E0611: a Hermite chain has degree 3, but the curve has degree 4";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let [points, tangents] = args.c.value.to_hermite().at(args.c.span)?;
    Ok(Record::new([
        ("points".into(), points.into_value()),
        ("tangents".into(), tangents.into_value()),
    ]))
}
