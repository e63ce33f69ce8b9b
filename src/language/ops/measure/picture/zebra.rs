//! `zebra`: the borders of mirrored stripes.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{NurbsCurve, Surface},
    value::{At, Ctx, op},
};

op! {
    /// Curves between the stripes that a polished surface mirrors, stripe by stripe.
    ///
    /// The surface is looked at along the light, from far away, inside a tube of equal stripes: what
    /// counts is the direction r = 2(N·l)N − l into which the ray is reflected, and not the angle
    /// of the normal, as it is for `isophotes`. The stripes are sectors about an axis across the
    /// light, z made normal to it, or x where the light comes along z; the light is in the middle of
    /// the last one. Stripes jump where surfaces meet with a corner, have kinks where they share a tangent
    /// plane only, and are smooth where they share curvature. Complete, and of the kind that
    /// `section` gives. A parametric surface is taken as a spline within a thousandth of the
    /// tolerance.
    zebra in Measure -> Vec<NurbsCurve> {
        /// The surface.
        s: Surface,
        /// The direction towards the light and the eye.
        light: Spanned<DVec3>,
        /// How many stripes there are all around, two or more.
        bands: Spanned<usize> = Spanned::unplaced(16),
    }
    example "len(zebra(cylinder((0, 0), 1, 2), (1, 0, 0), bands = 4))" => "8";
    example "zebra(plane_patch((0, 0), (1, 0), (0, 1)), (0, 0, 1))" => "[]";
    refuses "zebra(plane_patch((0, 0), (1, 0), (0, 1)), (0, 0, 1), bands = 1)" => "E0502: `bands` is 1; there are 2 to 1000 stripes";
    scene r#"
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
        curves lines = zebra(s, (1, 0, 1), bands = 24)
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    let bands = args.bands.value;
    if !(2..=MOST_BANDS).contains(&bands) {
        let message = format!("`bands` is {bands}; there are 2 to {MOST_BANDS} stripes");
        return Diagnostic::error(Code::Domain, args.bands.span, message).fail();
    }
    if args.light.value == DVec3::ZERO {
        return Diagnostic::error(Code::Degenerate, args.light.span, super::NO_LIGHT).fail();
    }
    let sets = args.s.zebra(args.light.value, bands, ctx.tolerance).at(ctx.span)?;
    Ok(sets.into_iter().flat_map(|set| set.curves).collect())
}

/// More stripes show nothing but grey.
const MOST_BANDS: usize = 1000;
