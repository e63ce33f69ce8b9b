//! `decompose` of a curve: its Bézier pieces.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::NurbsCurve,
    ops::list::check_length,
    value::{Ctx, op},
};

op! {
    /// Bézier curves that a curve consists of, each on its own part of the domain.
    ///
    /// Exact. `join` makes the same curve of them, unless it jumps. Piegl & Tiller, *The NURBS Book*, A5.6.
    decompose | to_bezier in Edit -> Vec<NurbsCurve> {
        /// The curve.
        c: Arc<NurbsCurve>,
    }
    example "len(decompose(circle((0, 0), 1)))" => "4";
    example "decompose(clamped((1, 1), (3, 1), (5, 7), (7, 1), (9, 4)))[0].points" => "[(1, 1, 0), (3, 1, 0), (4, 4, 0), (5, 4, 0)]";
    refuses "decompose(parametric(t => (t, t^2), 0..2))" => "E0301: `decompose`: `c` must be a NURBS curve, found a parametric curve";
    derivative affine;
    scene r#"
        let pieces = decompose(bspline((0, 0), (1, 2), (3, 1), (4, 3), (6, 0), (7, 1))) with (hidden = true)
        curves odd = [pieces[0], pieces[2]]
        curve even = pieces[1] with (color = "red")
        curves polygons = [for piece in pieces: control_polygon(piece)] with (color = "gray")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    check_length((args.c.n_segments() * (args.c.degree() + 1)) as f64, ctx)?;
    Ok(args.c.decompose())
}
