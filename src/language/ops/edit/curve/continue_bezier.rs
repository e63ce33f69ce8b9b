//! `continue_bezier` of a curve: the Bézier curve that goes on from it.

use std::sync::Arc;

use glam::DVec3;

use super::check_order;
use crate::{
    diag::{Result, Spanned},
    kernel::{NurbsCurve, Side},
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// Bézier curve on 0..1 that starts where a curve ends, with the same derivatives up to an
    /// order, by its own parameter.
    ///
    /// Its first control points, one more than the order, follow from that; the free ones come
    /// behind them, so that the degree is the order and the number of free points.
    /// Linkeová, *Curves and Surfaces for Computer Graphics*, §2.2.
    continue_bezier in Edit -> NurbsCurve {
        /// The curve that it goes on from.
        c: Arc<NurbsCurve>,
        /// The order of continuity, from 0 to 3.
        order: Spanned<usize>,
        /// The free control points, the last of which is its end.
        points: AtLeast<1, DVec3>,
    }
    example "continue_bezier(bezier((4, 1), (5, 0), (7, 0), (8, 2)), 2, [(0, 4)]).points" => "[(8, 2, 0), (9, 4, 0), (9, 8, 0), (0, 4, 0)]";
    refuses "continue_bezier(bezier((0, 0), (1, 2), (2, 0)), 4, [(4, 0)])" => "E0401: continuity is of order 0 to 3, found 4";
    derivative affine;
    scene r#"
        curve c = bezier((4, 1), (5, 0), (7, 0), (8, 2))
        curve next = continue_bezier(c, 2, [(0, 4)]) with (color = "red")
        curves polygons = [control_polygon(c), control_polygon(next)] with (color = "gray")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let order = check_order(args.order)?;
    let AtLeast(free) = args.points;
    let degree = order + free.len();
    let derivatives = args.c.derivatives_beside(args.c.domain().end(), Side::Left, order);

    // The k-th difference of the first control points is the k-th derivative over p(p − 1)….
    let mut falling = 1.0;
    let mut differences: Vec<DVec3> = Vec::with_capacity(order + 1);
    for (k, derivative) in derivatives.into_iter().enumerate() {
        differences.push(derivative / falling);
        falling *= (degree - k) as f64;
    }
    let mut points = Vec::with_capacity(degree + 1);
    while let Some(&point) = differences.first() {
        points.push(point);
        let n_left = differences.len() - 1;
        for k in 0..n_left {
            let next = differences[k + 1];
            differences[k] += next;
        }
        differences.truncate(n_left);
    }
    points.extend(free);
    NurbsCurve::bezier(&points).at(ctx.span)
}
