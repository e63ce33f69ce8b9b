//! `continuity` of two curves, or of one.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::{Continuity, Curve, Side},
    value::{Angle, At, Ctx, IntoValue, Maybe, Record, Value, op},
};

op! {
    /// How smoothly a curve goes on in another, the end of `a` in the start of `b`; of one curve
    /// alone the worst of its inner knots, of its seam where it is closed, and of the places where
    /// it stands still.
    ///
    /// `c` and `g` are the largest orders up to 3 that hold, -1 where the points are apart: `c` of
    /// equal derivatives by the parameter, `g` of equal ones by arc length: 1 the same direction,
    /// 2 the same curvature vector, 3 the same change of it. `c_homogeneous` compares the
    /// homogeneous curves; `gap`, `angle` and `curvature_gap` tell how far points, tangents and
    /// curvature vectors differ, the last `none` where a curvature has no bound. Where a derivative
    /// vanishes the direction is that of the next one that does not: a cusp is C3 but only G0.
    /// A parametric curve has inner joints where its derivatives jump.
    ///
    /// Linkeová, *Curves and Surfaces for Computer Graphics*, §1.2; Barsky & DeRose, *Geometric
    /// continuity of parametric curves*.
    continuity in Measure -> Record {
        /// The first curve.
        a: Spanned<Curve>,
        /// The curve that goes on, if it is another.
        b: Spanned<Maybe<Curve>>,
    }
    example "continuity(line((0, 0), (1, 0)), line((1, 0), (3, 0))).c" => "0";
    example "continuity(line((0, 0), (1, 0)), line((1, 0), (3, 0))).g" => "3";
    example "continuity(polyline((0, 0), (1, 0), (1, 1))).angle" => "90deg";
    example "continuity(bezier((0, 0), (1, 1), (0, 1), (1, 0))).g" => "0";
    example "continuity(circle((0, 0), 1)).c" => "1";
    example "continuity(circle((0, 0), 1)).c_homogeneous" => "0";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let found = match args.b.value.0 {
        Some(b) => {
            // A single point has no direction: blame the curve that is one.
            b.tangent_at(b.domain().start(), Side::Right).at(args.b.span)?;
            args.a.value.continuity_with(&b, ctx.tolerance)
        }
        None => args.a.value.continuity(ctx.tolerance),
    };
    let Continuity { c, g, gap, angle, curvature_gap, c_homogeneous } = found.at(args.a.span)?;
    Ok(Record::new([
        (Arc::from("c"), i64::from(c).into_value()),
        (Arc::from("g"), i64::from(g).into_value()),
        (Arc::from("gap"), Value::number(gap)),
        (Arc::from("angle"), Angle(angle).into_value()),
        (Arc::from("curvature_gap"), curvature_gap.map_or(Value::None, Value::number)),
        (Arc::from("c_homogeneous"), i64::from(c_homogeneous).into_value()),
    ]))
}
