//! `station`: a section set up along a spine.

use super::apply;
use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, Side},
    value::{At, Ctx, Geometry, Value, op},
};

op! {
    /// A planar section moved so that it stands across a spine.
    ///
    /// Its point at the parameter `anchor` comes to lie on `spine(at)`, without an anchor that
    /// point of its plane which is nearest to the origin, and its plane is turned by the smallest
    /// angle that makes it normal to the spine. Where two turns are equal, that counts which
    /// takes the upper side of the plane (z, else y, else x) forward. A straight section is
    /// turned to be normal to the spine. Piegl & Tiller, *The NURBS Book*, §10.4.
    station in Transform -> Geometry {
        /// The section.
        section: Spanned<Curve>,
        /// The spine.
        spine: Curve,
        /// The parameter of the spine where the section is to stand.
        at: Spanned<f64>,
        /// The parameter of the section's point that is to lie on the spine.
        anchor: Option<Spanned<f64>>,
    }
    example "station(circle((0, 0), 1), line((5, 0, 0), (5, 0, 9)), 0.5).start" => "(6, 0, 4.5)";
    example "station(polyline((0, 0), (1, 0), (0, 2)), line((0, 0), (0, 3)), 1, anchor = 1).start ~= (-1, 3)" => "true";
    refuses "station(circle((0, 0), 1), line((5, 0, 0), (5, 0, 9)), 2)" => "E0606: parameter 2 is outside the domain 0..1";
    refuses "station(helix((0, 0), 2, 3, 1), line((5, 0, 0), (5, 0, 9)), 0.5)" => "E0607: the curve is not planar: it leaves its plane by 2.19";
    scene r#"
        curve spine = bezier((0, 0, 0), (4, 0, 4), (4, 6, -2), (0, 6, 2)) with (color = "gray")
        curves sections = [for t in linspace(0, 1, 6): station(circle((0, 0), 1), spine, t)]
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Geometry> {
    let (section, spine) = (args.section.value, args.spine);
    let at = spine.domain().clamp_inside(args.at.value).at(args.at.span)?;
    let tangent = spine.tangent_at(at, Side::Right).at(args.at.span)?;
    let spline = section.spline().at(args.section.span)?;
    let plane = spline.plane_across(tangent, ctx.tolerance.distance).at(args.section.span)?;
    let anchor = match args.anchor {
        None => plane.origin(),
        Some(t) => {
            section.point_at(section.domain().clamp_inside(t.value).at(t.span)?).at(t.span)?
        }
    };
    let map = plane.at(anchor).turned_to(tangent, spine.point_at(at).at(args.at.span)?);
    apply(&Geometry(Value::Curve(section)), &map, ctx.span)
}
