//! `join` of surfaces: a grid of patches as one.

use std::sync::Arc;

use super::check_size;
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Grid, NurbsSurface, join_patches},
    value::{At, Ctx, op},
};

op! {
    /// A grid of patches as one surface: `patches[i][j]`, i along u, j along v, as `decompose` gives
    /// them.
    ///
    /// Exact: each keeps the lengths of its domains, behind those before it; all get the highest
    /// degrees among them. A joint keeps only the knots that its continuity needs, so that
    /// bicubic patches that meet C² become one spline surface with simple knots. Gaps up to the
    /// document's tolerance are closed halfway. One strip of patches is `[[a, b]]` along v and
    /// `[[a], [b]]` along u. Linkeová, *Curves and Surfaces for Computer Graphics*, §3.7.
    join in Edit -> NurbsSurface {
        /// The patches, of which a single one stays as it is.
        patches: Spanned<Vec<Vec<Arc<NurbsSurface>>>>,
    }
    example "join([[bilinear((0, 0), (0, 1), (1, 0), (1, 1))], [bilinear((1, 0), (1, 1), (3, 0), (3, 1))]]).patches" => "[2, 1]";
    example "join(decompose(clamped([for i in 0..4: [for j in 0..4: (i, j, if i == 2 then 1 else 0)]]))).knots_u" => "[0, 0, 0, 0, 1, 2, 2, 2, 2]";
    example "join(decompose(plane_patch((0, 0), (1, 0), (0, 1)))).patches" => "[1, 1]";
    refuses "join([[plane_patch((0, 0), (1, 0), (0, 1)), plane_patch((2, 0), (1, 0), (0, 1))]])" => "E0609: `patches[0][1]` begins 2.236 from where `patches[0][0]` ends along v, more than the tolerance 1e-6";
    derivative shape;
    scene r#"
        let a = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (hidden = true)
        let b = continue_bezier(a, "u1", 1, [[(8, 0, 1), (8, 2, 2), (8, 4, 1)]]) with (hidden = true)
        surface s = join([[a], [b]])
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let span = args.patches.span;
    let rows = args.patches.value.into_iter();
    let rows = rows.map(|row| row.iter().map(|patch| NurbsSurface::clone(patch)).collect());
    let rows: Vec<Vec<NurbsSurface>> = rows.collect();
    let expected = rows.first().map_or(0, Vec::len);
    if let Some(row) = rows.iter().position(|row| row.len() != expected) {
        let got = rows[row].len();
        let message = format!(
            "row {row} has {got} patches, row 0 has {expected}; every row needs the same number"
        );
        return Diagnostic::error(Code::RaggedGrid, span, message).fail();
    }
    let grid = Grid::from_rows(rows).at(span)?;
    if let [single] = grid.as_slice() {
        return Ok(single.clone());
    }
    if grid.as_slice().is_empty() {
        return Diagnostic::error(Code::BadCall, span, "a patch or more are needed, found none")
            .fail();
    }
    let n_rows: usize = (0..grid.n_rows()).map(|i| grid.row(i)[0].knots_u().n_points()).sum();
    let n_columns = grid.row(0).iter().map(|patch| patch.knots_v().n_points()).sum();
    check_size(n_rows, n_columns, ctx)?;
    join_patches(&grid, ctx.tolerance.distance).at(span)
}
