//! `continue_bezier` of a surface: the patch that goes on from one of its sides.

use std::sync::Arc;

use super::Edge;
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Direction, NurbsSurface},
    ops::edit::curve::check_order,
    value::{At, Ctx, Rows, op},
};

op! {
    /// Patch that goes on from a side of a surface with the same derivatives across it up to an
    /// order, by its own parameter; it is a Bézier patch where the surface is one along the side.
    ///
    /// Parametrized in the directions of the surface: beyond "u1" it begins at its own "u0", before
    /// "u0" it ends at its own "u1"; across the side its domain is 0..1, along it that of the
    /// surface. The control points at the side, one more than the order, follow from that; the free
    /// ones come beyond them, in a grid with its rows along u like all grids. The points beyond
    /// a rational surface take the weights of its side.
    /// Linkeová, *Curves and Surfaces for Computer Graphics*, (3.51).
    continue_bezier in Edit -> NurbsSurface {
        /// The surface that it goes on from.
        s: Arc<NurbsSurface>,
        /// The side where it does.
        side: Edge,
        /// The order of continuity, from 0 to 3.
        order: Spanned<usize>,
        /// The free control points: as many along the side as the surface has there, one or more
        /// across.
        net: Spanned<Rows>,
    }
    example "continue_bezier(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), \"u1\", 1, [[(6, 0), (6, 1)]]).points" => "[[(2, 0, 0), (2, 1, 0)], [(3, 0, 0), (3, 1, 0)], [(6, 0, 0), (6, 1, 0)]]";
    example "continue_bezier(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), \"v0\", 0, [[(0, -1)], [(2, -1)]]).points" => "[[(0, -1, 0), (0, 0, 0)], [(2, -1, 0), (2, 0, 0)]]";
    refuses "continue_bezier(plane_patch((0, 0), (1, 0), (0, 1)), \"u1\", 1, [[(6, 0)]])" => "E0605: the side has 2 control points, so that the net must have k rows of 2 points, k one or more; found 1 x 1";
    refuses "continue_bezier(plane_patch((0, 0), (1, 0), (0, 1)), \"u2\", 1, [[(6, 0), (6, 1)]])" => "E0402: `continue_bezier`: `side` must be one of \"u0\", \"u1\", \"v0\" or \"v1\", found the string \"u2\"";
    derivative affine;
    scene r#"
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
        surface next = continue_bezier(s, "u1", 1, [[(8, 0, 1), (8, 2, 2), (8, 4, 1)]])
    "#;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    check_order(args.order)?;
    let (across, end) = args.side.place();
    let Rows(net) = args.net.value;
    let needed = args.s.knots(across.other()).n_points();
    let (rows, columns) = (net.n_rows(), net.n_columns());
    let (along, is_some, wanted) = match across {
        Direction::U => (columns, 0 < rows, format!("k rows of {needed} points")),
        Direction::V => (rows, 0 < columns, format!("{needed} rows of k points")),
    };
    if along != needed || !is_some {
        let message = format!(
            "the side has {needed} control points, so that the net must have {wanted}, k one or more; found {rows} x {columns}"
        );
        return Diagnostic::error(Code::RaggedGrid, args.net.span, message).fail();
    }
    args.s.continued(across, end, args.order.value, &net).at(args.net.span)
}
