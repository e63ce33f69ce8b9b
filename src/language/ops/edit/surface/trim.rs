//! `trim` of a surface: a part of it.

use super::some_of;
use crate::{
    diag::{Result, Spanned},
    kernel::Surface,
    value::{At, Ctx, ParameterRange, op},
};

op! {
    /// Part of a surface over ranges of its parameters, which it keeps; without `u` or `v` all of
    /// that direction.
    ///
    /// Exact. The result begins and ends at its control points where it was cut.
    trim in Edit -> Surface {
        /// The surface.
        s: Surface,
        /// The range of u, inside the surface's domain.
        u: Option<Spanned<ParameterRange>>,
        /// The range of v.
        v: Option<Spanned<ParameterRange>>,
    }
    example "trim(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), u = 0.5..1).points" => "[[(1, 0, 0), (1, 1, 0)], [(2, 0, 0), (2, 1, 0)]]";
    example "trim(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), u = 0.5..1, v = 0..0.25).domain_v" => "0..0.25";
    refuses "trim(plane_patch((0, 0), (1, 0), (0, 1)), u = 0.5..2)" => "E0606: parameter 2 is outside the domain 0..1";
    refuses "trim(plane_patch((0, 0), (1, 0), (0, 1)))" => "E0401: neither `u` nor `v` is given";
    derivative shape;
    scene r#"
        let s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (hidden = true)
        curves whole = wireframe(s, 5, 5) with (color = "gray")
        surface part = trim(s, u = 0.2..0.8, v = 0..0.6)
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Surface> {
    let ranges = some_of(args.u, args.v, ctx, "a..b")?;
    ranges
        .into_iter()
        .try_fold(args.s, |s, (along, range)| s.trimmed(along, range.value.0).at(range.span))
}
