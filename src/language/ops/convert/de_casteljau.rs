//! `de_casteljau`: corner cutting, level by level.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::NurbsCurve,
    value::{At, Ctx, op},
};

op! {
    /// All levels of points of de Casteljau's algorithm for a Bézier curve.
    ///
    /// Level 0 is the control polygon, each next one divides the legs of the one before it in the
    /// ratio of the parameter, the last is the point of the curve. With weights the legs are
    /// divided in homogeneous space. Farin, *Curves and Surfaces for CAGD*, §4.2.
    de_casteljau in Curve -> Vec<Vec<DVec3>> {
        /// The curve, of one Bézier segment.
        c: Spanned<Arc<NurbsCurve>>,
        /// The parameter, inside the curve's domain.
        t: Spanned<f64>,
    }
    example "de_casteljau(bezier((2, 0), (4, 1), (3, 2)), 0.5)" => "[[(2, 0, 0), (4, 1, 0), (3, 2, 0)], [(3, 0.5, 0), (3.5, 1.5, 0)], [(3.25, 1, 0)]]";
    refuses "de_casteljau(polyline((0, 0), (1, 2), (3, 1)), 0.5)" => "E0611: a Bézier curve has one segment, but the curve has 2";
    derivative affine;
    scene r#"
        curve c = bezier((0, 0), (1, 3), (3, -2), (4, 1))
        let levels = de_casteljau(c, 0.4) with (hidden = true)
        curves legs = [for level in levels[0..2]: polyline(level)] with (color = "gray")
        points found = levels[3] with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Vec<DVec3>>> {
    let (curve, span) = (args.c.value, args.c.span);
    let t = curve.domain().clamp_inside(args.t.value).at(args.t.span)?;
    ctx.made_by(&|| Some(curve.factors_of_levels(t)));
    curve.de_casteljau(t).map_or_else(
        || {
            let message = match curve.n_segments() {
                1 => "the curve has one segment, but not in Bézier form".to_owned(),
                n => format!("a Bézier curve has one segment, but the curve has {n}"),
            };
            Diagnostic::error(Code::NotExact, span, message)
                .hint("`to_bezier` gives its segments as Bézier curves")
                .fail()
        },
        Ok,
    )
}
