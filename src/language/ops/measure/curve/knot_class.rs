//! `knot_class` of a curve.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::{KnotClass, NurbsCurve},
    value::{Ctx, IntoValue, Record, Value, op},
};

op! {
    /// What kind of knots a curve has, as `{class, clamped, uniform, periodic, bezier}`.
    ///
    /// `clamped` (also called open): both ends of the domain stand degree + 1 times. `uniform`: all
    /// spans of the domain are equally wide and no inner knot stands twice. `periodic`: the spans
    /// beyond each end repeat those at the other. `bezier`: clamped, and every inner knot stands
    /// degree times or more. `class` is the word that says most: `"bezier"`, `"clamped"`,
    /// `"periodic"` or `"unclamped"`, the last three also with `"uniform "` before them.
    /// Piegl & Tiller, *The NURBS Book*, §2.2 and §12.2.
    knot_class in Measure -> Record {
        /// The curve.
        c: Arc<NurbsCurve>,
    }
    example "knot_class(bezier((0, 0), (1, 2), (2, 0))).class" => "\"bezier\"";
    example "knot_class(bspline([(0, 0), (1, 2), (2, 0), (3, 1), (4, 0)], closed = true)).class" => "\"uniform periodic\"";
    example "knot_class(insert_knot(bspline([(0, 0), (1, 2), (2, 0), (3, 1), (4, 0)]), 0.25)).class" => "\"clamped\"";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let class = args.c.knots().class();
    let KnotClass { is_clamped, is_uniform, is_periodic, is_bezier } = class;
    Ok(Record::new([
        (Arc::from("class"), Value::text(class.word())),
        (Arc::from("clamped"), is_clamped.into_value()),
        (Arc::from("uniform"), is_uniform.into_value()),
        (Arc::from("periodic"), is_periodic.into_value()),
        (Arc::from("bezier"), is_bezier.into_value()),
    ]))
}
