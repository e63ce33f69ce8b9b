//! `compatible`: curves on one basis.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, NurbsCurve, make_compatible},
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// The same curves on one degree and one knot vector, in the order given.
    ///
    /// The degree is the highest among them, the domain that of the first curve, and every knot of
    /// one is a knot of all. Parametric curves are followed within the document's
    /// tolerance. Piegl & Tiller, *The NURBS Book*, §10.3.
    compatible in Curve -> Vec<NurbsCurve> {
        /// The curves.
        curves: Spanned<AtLeast<1, Curve>>,
    }
    example "[for c in compatible([line((0, 0), (2, 0)), clamped((0, 0), (1, 2), (3, 2), (4, 0), degree = 2)]): c.knots]" => "[[0, 0, 0, 0.5, 1, 1, 1], [0, 0, 0, 0.5, 1, 1, 1]]";
    example "compatible([line((0, 0), (2, 0)), bezier((0, 0), (1, 2), (2, 0))])[0].points" => "[(0, 0, 0), (1, 0, 0), (2, 0, 0)]";
    refuses "compatible([])" => "E0301: `compatible`: `curves` must be a list of 1 or more curves, found an empty list";
    derivative affine;
    scene r#"
        let both = compatible([line((0, 0), (4, -1)), clamped((0, 0), (1, 2), (3, 2), (4, 0), degree = 2)]) with (hidden = true)
        curves curves_of_one_kind = both
        curves polygons = [for c in both: control_polygon(c)] with (color = "gray")
        points vertices = flatten([for c in both: c.points]) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    let nurbs =
        |curve: &Curve| curve.nurbs_within(ctx.tolerance.distance).map(Arc::unwrap_or_clone);
    let curves: std::result::Result<Vec<NurbsCurve>, _> =
        args.curves.value.0.iter().map(nurbs).collect();
    let curves = curves.at(args.curves.span)?;
    make_compatible(&curves).at(args.curves.span)
}
