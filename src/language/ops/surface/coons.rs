//! `coons`: the surface within four boundary curves.

use super::{
    boundary::{Boundary, pair},
    with_area,
};
use crate::{
    diag::{Result, Spanned},
    kernel::{Blend, Curve, NurbsSurface},
    value::{At, Choice, Ctx, op},
};

op! {
    /// Coons surface within four curves: the surface between the u-curves plus the one between the
    /// v-curves less the one of the corners.
    ///
    /// Exact for curves of any degrees and knots. Curves of different weights are brought over one
    /// denominator, which adds their degrees; parametric ones are converted within the document's
    /// tolerance. Its domains are those of `u[0]` and `v[0]`. Blend `"linear"` goes straight across,
    /// `"cubic"` leaves each boundary level, so that neighbours whose other boundaries go on
    /// smoothly meet smoothly. Piegl & Tiller, *The NURBS Book*, (10.34) to (10.36).
    coons in Surface -> NurbsSurface {
        /// The two curves along u: at v = 0 and at v = 1.
        u: Spanned<Vec<Curve>>,
        /// The two curves along v: at u = 0 and at u = 1.
        v: Spanned<Vec<Curve>>,
        /// How it goes from each boundary to the opposite one.
        blend: Blend = Blend::Linear,
    }
    example "coons(u = [line((0, 0), (2, 0)), bezier((0, 2), (1, 2, 1), (2, 2))], v = [line((0, 0), (0, 2)), line((2, 0), (2, 2))])(0.5, 1)" => "(1, 2, 0.5)";
    example "coons(u = [line((0, 0), (2, 0)), line((0, 2), (2, 2, 1))], v = [line((0, 0), (0, 2)), line((2, 0), (2, 2, 1))]).points" => "[[(0, 0, 0), (0, 2, 0)], [(2, 0, 0), (2, 2, 1)]]";
    refuses "coons(u = [line((0, 0), (2, 0)), line((0, 3), (2, 3))], v = [line((0, 0), (0, 2)), line((2, 0), (2, 2))])" => "E0609: `u[1]` starts at (0, 3, 0), but `v[0]` ends at (0, 2, 0): 1 apart, more than the tolerance 1e-6";
    refuses "coons(u = [line((0, 0), (2, 0))], v = [line((0, 0), (0, 2)), line((2, 0), (2, 2))])" => "E0401: `u` takes two curves, found 1";
    derivative shape;
    scene r#"
        curves u = [bezier((0, 0, 0), (2, 0, 3), (4, 0, 0)), bezier((0, 4, 0), (2, 4, -2), (4, 4, 0))] with (color = "red")
        curves v = [bezier((0, 0, 0), (-1, 2, 1), (0, 4, 0)), line((4, 0, 0), (4, 4, 0))] with (color = "green")
        surface s = coons(u = u, v = v) with (color = "lightgray")
    "#;
}

impl Choice for Blend {
    const WORDS: &'static [&'static str] = &["linear", "cubic"];
    const MEANINGS: &'static [Self] = &[Self::Linear, Self::Cubic];
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let boundary = Boundary { u: pair("u", &args.u, ctx)?, v: pair("v", &args.v, ctx)? };
    boundary.check([args.u.span, args.v.span], ctx.tolerance.distance)?;
    let [u, v] = boundary.curves();
    let surface = NurbsSurface::coons(u, v, args.blend).at(ctx.span)?;
    Ok(with_area(ctx, surface))
}
