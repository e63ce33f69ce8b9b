//! `arc_through`: the arc of a circle through three points.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{GeomError, InputError, NurbsCurve},
    value::{At, Ctx, op, rounded, shortest},
};

op! {
    /// Exact arc of a circle from `a` by way of `b` to `c`, on 0..1.
    ///
    /// In equal pieces of at most a quarter turn, like `arc`.
    arc_through in Curve -> NurbsCurve {
        /// Where it starts.
        a: Spanned<DVec3>,
        /// A point on the way.
        b: Spanned<DVec3>,
        /// Where it ends.
        c: Spanned<DVec3>,
    }
    example "arc_through((1, 0), (0, 1), (-1, 0))(0.5)" => "(0, 1, 0)";
    example "arc_through((3, 4), (5, 0), (0, -5)).end" => "(0, -5, 0)";
    example "norm(arc_through((3, 4), (5, 0), (0, -5))(0.7)) ~= 5 within 1e-14" => "true";
    refuses "arc_through((0, 0), (1, 1), (2, 2))" => "E0607: the three points lie on one line, so that no circle goes through them";
    refuses "arc_through((0, 0), (0, 0), (2, 2))" => "E0607: `a` and `b` are at one place";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let points = [args.a, args.b, args.c];
    let arc = NurbsCurve::arc_through(points.map(|point| point.value), ctx.tolerance.distance);
    if let Err(GeomError::Input(InputError::CoincidentPoints { first, second })) = arc {
        let names = ["a", "b", "c"];
        let gap = points[first].value.distance(points[second].value);
        let pair = format!("`{}` and `{}`", names[first], names[second]);
        let (message, hint) = if gap == 0.0 {
            (format!("{pair} are at one place"), "three different points determine a circle")
        } else {
            let (gap, limit) = (rounded(gap), shortest(ctx.tolerance.distance));
            let message = format!(
                "{pair} are {gap} apart, within the tolerance {limit}: they count as one place"
            );
            (
                message,
                "three different points determine a circle; a smaller `tolerance` at the top of the script tells these apart",
            )
        };
        return Diagnostic::error(Code::Degenerate, points[second].span, message)
            .label(format!("`{}`", names[second]))
            .also(points[first].span, format!("`{}`", names[first]))
            .hint(hint)
            .fail();
    }
    arc.at(ctx.span)
}
