//! `divide` a curve by arc length.

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::{CountError, Curve, GeomError},
    ops::list::check_length,
    value::{At, Ctx, op},
};

op! {
    /// Points that divide a curve into `n` parts of equal length: n + 1 of them, from its start to
    /// its end.
    ///
    /// Of a parametric curve they are points of the function, at lengths that `length` tells.
    divide in Measure -> Vec<DVec3> {
        /// The curve.
        c: Curve,
        /// How many parts.
        n: Spanned<usize>,
    }
    example "divide(line((0, 0), (4, 0)), 4)" => "[(0, 0, 0), (1, 0, 0), (2, 0, 0), (3, 0, 0), (4, 0, 0)]";
    refuses "divide(line((0, 0), (4, 0)), 0)" => "E0607: the number of parts is 0; at least 1 is needed";
    scene r#"
        curve c = bezier((0, 0), (1, 3), (3, -2), (4, 1))
        points places = divide(c, 8) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<DVec3>> {
    let n = args.n.value;
    if n == 0 {
        let err = GeomError::Count(CountError::CountTooSmall {
            what: "the number of parts",
            got: 0,
            needed: 1,
        });
        return Err(err).at(args.n.span);
    }
    check_length(n as f64 + 1.0, ctx)?;
    args.c.divided(n).at(ctx.span)
}
