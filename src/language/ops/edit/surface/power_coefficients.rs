//! `power_coefficients`: a polynomial surface in the power basis.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::NurbsSurface,
    value::{At, Ctx, op},
};

op! {
    /// Coefficients of a surface of one polynomial patch: that of u^i v^j is `[i][j]`.
    ///
    /// Of a surface of several patches take one by `decompose`.
    /// Piegl & Tiller, *The NURBS Book*, §1.5.
    power_coefficients in Surface -> Vec<Vec<DVec3>> {
        /// The surface, without weights and of one patch.
        s: Spanned<Arc<NurbsSurface>>,
    }
    example "power_coefficients(bilinear((0, 0), (0, 1), (1, 0), (1, 1, 2)))" => "[[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (0, 0, 2)]]";
    example "power_coefficients(bezier([[(0, 0), (0, 1)], [(1, 0), (1, 1)], [(2, 0, 1), (2, 1, 1)]]))" => "[[(0, 0, 0), (0, 1, 0)], [(2, 0, 0), (0, 0, 0)], [(0, 0, 1), (0, 0, 0)]]";
    refuses "power_coefficients(sphere((0, 0), 1))" => "E0611: a polynomial in u and v has no weights, but those of the surface differ";
    refuses "power_coefficients(coons_bspline([for i in 0..4: [for j in 0..3: (i, j)]]))" => "E0611: a polynomial in u and v has one patch, but the surface has 2 along u and 1 along v";
    derivative affine;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Vec<DVec3>>> {
    ctx.made_by(&|| args.s.value.factors_of_powers());
    let grid = args.s.value.power_coefficients().at(args.s.span)?;
    let row = |i: usize| (0..grid.n_columns()).map(|j| grid.get(i, j)).collect();
    Ok((0..grid.n_rows()).map(row).collect())
}
