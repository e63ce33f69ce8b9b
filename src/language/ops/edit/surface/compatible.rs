//! `compatible`: surfaces on one basis.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::{NurbsSurface, make_surfaces_compatible},
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// The same surfaces on one pair of degrees and one pair of knot vectors, in the order given.
    ///
    /// The degrees are the highest among them, the domains those of the first surface, and every
    /// knot of one is a knot of all. Knots of different surfaces nearer to one another than 2e-9 of
    /// the domain become one. Piegl & Tiller, *The NURBS Book*, §10.3.
    compatible in Surface -> Vec<NurbsSurface> {
        /// The surfaces.
        surfaces: Spanned<AtLeast<1, Arc<NurbsSurface>>>,
    }
    example "[for s in compatible([bezier([[(0, 0), (0, 2)], [(1, 0), (1, 2)], [(4, 0), (4, 2)]]), refine(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), v = [0.5])]): [s.degree_u, len(s.points[0])]]" => "[[2, 3], [2, 3]]";
    derivative affine;
    scene r#"
        let both = compatible([bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 2), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]), insert_knot(translate(bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 2), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]), (5, -2)), u = 0.5)]) with (hidden = true)
        surfaces shown = both with (color = "lightgray")
        curves nets = flatten([for s in both: control_net(s)]) with (color = "red")
    "#;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsSurface>> {
    let surfaces: Vec<NurbsSurface> =
        args.surfaces.value.0.iter().map(|surface| (**surface).clone()).collect();
    make_surfaces_compatible(&surfaces).at(args.surfaces.span)
}
