//! `reflection_lines`: mirrored light tubes.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Curve, NurbsCurve, Surface},
    value::{At, Ctx, op},
};

op! {
    /// Curves on a surface where the eye sees straight lights mirrored, in the order of the lights.
    ///
    /// A light is endless: the straight line that the given one lies on. It is seen at S where the
    /// ray r = 2(N·e)N − e, e towards the eye, meets it ahead of the surface; the surface
    /// mirrors on both of its sides, and hides nothing. Complete, and of the kind that `section`
    /// gives. A parametric surface is taken as a spline within a thousandth of the tolerance.
    /// Klass, *Correction of local surface irregularities using reflection lines*, CAD 12 (1980).
    reflection_lines in Measure -> Vec<NurbsCurve> {
        /// The surface.
        s: Surface,
        /// Where the eye is.
        eye: DVec3,
        /// The lights, straight curves.
        lights: Spanned<Vec<Curve>>,
    }
    example "len(reflection_lines(plane_patch((0, 0), (4, 0), (0, 4)), (0, 2, 1), [line((4, 0, 1), (4, 4, 1))]))" => "1";
    example "reflection_lines(plane_patch((0, 0), (4, 0), (0, 4)), (0, 2, 1), [line((4, 0, 1), (4, 4, 1))])[0](0).x ~= 2" => "true";
    refuses "reflection_lines(plane_patch((0, 0), (1, 0), (0, 1)), (0, 2, 1), [circle((0, 0), 1)])" => "E0301: light [0] is not a straight line from one end to another";
    scene r#"
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
        curves lines = reflection_lines(s, (10, -4, 8), [for x in -4..8: line((x, 0, 9), (x, 1, 9))])
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    let span = args.lights.span;
    let mut lights = Vec::with_capacity(args.lights.value.len());
    for (idx, light) in args.lights.value.iter().enumerate() {
        let domain = light.domain();
        let ends =
            [light.point_at(domain.start()).at(span)?, light.point_at(domain.end()).at(span)?];
        let is_straight = light.is_straight(ctx.tolerance).at(span)?;
        if !is_straight || ends[0].distance(ends[1]) <= ctx.tolerance.distance {
            let message = format!("light [{idx}] is not a straight line from one end to another");
            return Diagnostic::error(Code::WrongKind, span, message)
                .hint("a `line` is one; a bent light is as many of them as it needs")
                .fail();
        }
        lights.push([ends[0], ends[1] - ends[0]]);
    }
    let sets = args.s.reflection_lines(args.eye, &lights, ctx.tolerance).at(ctx.span)?;
    Ok(sets.into_iter().flat_map(|set| set.curves).collect())
}
