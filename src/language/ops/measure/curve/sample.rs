//! `sample`: points of a curve.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::Curve,
    ops::list::check_length,
    value::{At, Ctx, op},
};

op! {
    /// Points of a curve at equal steps of its parameter, both ends included.
    sample in Measure -> Vec<DVec3> {
        /// The curve.
        c: Curve,
        /// How many points, two or more.
        n: Spanned<usize>,
    }
    example "sample(line((0, 0), (4, 2)), 3)" => "[(0, 0, 0), (2, 1, 0), (4, 2, 0)]";
    refuses "sample(line((0, 0), (4, 2)), 1)" => "E0601: a curve is sampled at 2 points or more, found 1";
    scene r#"
        curve c = bezier((0, 0), (1, 3), (3, -2), (4, 1))
        points places = sample(c, 9) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<DVec3>> {
    if args.n.value < 2 {
        let message = format!("a curve is sampled at 2 points or more, found {}", args.n.value);
        return Diagnostic::error(Code::TooFewPoints, args.n.span, message).fail();
    }
    check_length(args.n.value as f64, ctx)?;
    args.c.sample(args.n.value).at(ctx.span)
}
