//! `split` of a surface: both parts at a parameter.

use super::one_of;
use crate::{
    diag::{Result, Spanned},
    kernel::Surface,
    value::{At, Ctx, op},
};

op! {
    /// Both parts of a surface at a parameter of one direction, each with the parameters it had.
    ///
    /// Exact: `[left, right]`, the first with the smaller parameters. `join` makes the same surface
    /// of them.
    split in Edit -> Vec<Surface> {
        /// The surface.
        s: Surface,
        /// Where to cut u, inside the domain and at none of its ends.
        u: Option<Spanned<f64>>,
        /// Where to cut v; one of both is given.
        v: Option<Spanned<f64>>,
    }
    example "split(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), u = 0.25)[1].domain_u" => "0.25..1";
    example "split(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), v = 0.5)[0](1, 0.5)" => "(2, 0.5, 0)";
    refuses "split(plane_patch((0, 0), (1, 0), (0, 1)), u = 0)" => "E0606: parameter 0 is an end of the domain 0..1; there is nothing to split";
    refuses "split(plane_patch((0, 0), (1, 0), (0, 1)))" => "E0401: neither `u` nor `v` is given";
    refuses "split(plane_patch((0, 0), (1, 0), (0, 1)), u = 0.5, v = 0.5)" => "E0401: one of `u` and `v` is wanted, found both";
    derivative shape;
    scene r#"
        let parts = split(bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]), u = 0.5) with (hidden = true)
        surface left = parts[0]
        surface right = translate(parts[1], (1, 0))
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Surface>> {
    let (along, t) = one_of(args.u, args.v, ctx, "split the parts again for a cut across")?;
    args.s.split(along, t.value).map(Vec::from).at(t.span)
}
