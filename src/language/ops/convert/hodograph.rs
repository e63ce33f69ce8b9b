//! `hodograph`: the derivative as a curve.

use crate::{
    diag::{Result, Spanned},
    kernel::Curve,
    value::{At, Ctx, op},
};

op! {
    /// Curve of a curve's derivative vectors, on the same domain; exact, also with weights.
    ///
    /// Its degree is one less; with weights it is twice as high. At a corner it jumps.
    /// That of a parametric curve is parametric.
    /// Piegl & Tiller, *The NURBS Book*, (3.8) and (4.8).
    hodograph in Curve -> Curve {
        /// The curve.
        c: Spanned<Curve>,
    }
    example "hodograph(bezier((0, 0), (1, 2), (2, 0))).points" => "[(2, 4, 0), (2, -4, 0)]";
    example "hodograph(circle((0, 0), 1))(0.3) ~= derivative(circle((0, 0), 1), 0.3) within 1e-13" => "true";
    derivative affine;
    scene r#"
        curve c = bezier((0, 0), (1, 3), (4, 3), (4, 0))
        curve third = scale(hodograph(c), 1/3) with (color = "red")
        points origin = [(0, 0)] with (color = "gray")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Curve> {
    ctx.made_by(&|| args.c.value.nurbs().ok()?.factors_of_hodograph());
    args.c.value.hodograph().at(args.c.span)
}
