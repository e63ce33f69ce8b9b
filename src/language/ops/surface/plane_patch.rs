//! `plane_patch`: the parallelogram of two edges.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Frame, NurbsSurface},
    value::{At, Ctx, op},
};

op! {
    /// Flat surface of two edges that meet at a corner: origin + u·x + v·y, u and v on 0..1.
    plane_patch in Surface -> NurbsSurface {
        /// The corner at u = 0, v = 0.
        origin: DVec3,
        /// The edge from there along u.
        x: Spanned<DVec3>,
        /// The edge from there along v, not parallel to the other.
        y: Spanned<DVec3>,
    }
    example "plane_patch((0, 0, 1), (4, 0), (1, 2))(0.5, 1)" => "(3, 2, 1)";
    refuses "plane_patch((0, 0), (1, 0), (2, 0))" => "E0607: the edges `x` and `y` are parallel, so that no surface is between them";
    derivative affine;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let (origin, x, y) = (args.origin, args.x, args.y);
    for (name, edge) in [("x", x), ("y", y)] {
        if edge.value == DVec3::ZERO {
            let message = format!("the edge `{name}` has length zero");
            return Diagnostic::error(Code::Degenerate, edge.span, message).fail();
        }
    }
    if Frame::from_axes(origin, x.value, y.value).is_err() {
        let message = "the edges `x` and `y` are parallel, so that no surface is between them";
        return Diagnostic::error(Code::Degenerate, y.span, message)
            .also(x.span, "the edge `x`")
            .fail();
    }
    let corner = |u: f64, v: f64| origin + x.value * u + y.value * v;
    let [near, far] = [0.0, 1.0].map(|u| [corner(u, 0.0), corner(u, 1.0)]);
    NurbsSurface::bilinear(near[0], near[1], far[0], far[1]).at(x.span)
}
