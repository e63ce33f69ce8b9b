//! `continuity` of two curves, or of one.

use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, Side},
    ops::measure::continuity_limits::{ContinuityOptions, continuity_fields},
    value::{Angle, At, Ctx, Curvature, Length, Maybe, Record, op},
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
    /// What counts as equal is decided by the document's tolerance: points by its distance,
    /// directions within 1e-9 rad, and all that is higher to 1e-9 of its size. `tolerance`, `angle`
    /// and `curvature_gap` ask for other limits of the fields `gap`, `angle` and `curvature_gap`; an
    /// order fails where the field exceeds its limit, and `c` is then no higher than `g`.
    ///
    /// Linkeová, *Curves and Surfaces for Computer Graphics*, §1.2; Barsky & DeRose, *Geometric
    /// continuity of parametric curves*.
    continuity in Measure -> Record {
        /// The first curve.
        a: Spanned<Curve>,
        /// The curve that goes on, if it is another.
        b: Spanned<Maybe<Curve>>,
        /// How far points may be apart at a joint; otherwise the document's tolerance, at most a
        /// thousandth of the size.
        tolerance: Option<Spanned<Length>>,
        /// By how much tangents may differ for G1.
        angle: Option<Spanned<Angle>>,
        /// By how much curvature vectors may differ for G2.
        curvature_gap: Option<Spanned<Curvature>>,
    }
    example "continuity(line((0, 0), (1, 0)), line((1, 0), (3, 0))).c" => "0";
    example "continuity(line((0, 0), (1, 0)), line((1, 0), (3, 0))).g" => "3";
    example "continuity(polyline((0, 0), (1, 0), (1, 1))).angle" => "90deg";
    example "continuity(bezier((0, 0), (1, 1), (0, 1), (1, 0))).g" => "0";
    example "continuity(circle((0, 0), 1)).c" => "1";
    example "continuity(circle((0, 0), 1)).c_homogeneous" => "0";
    example "continuity(line((0, 0), (1, 0)), line((1, 0.01), (2, 0.01)), tolerance = 0.02).g" => "3";
    example "continuity(polyline((0, 0), (1, 0), (2, 0.01)), angle = 1deg).g" => "3";
    example "continuity(arc((0, 0), 10, 0deg, 90deg), arc((0, 1), 9, 90deg, 180deg), curvature_gap = 0.02).g" => "2";
    example "continuity(arc((0, 0), 10, 0deg, 90deg), arc((0, 1), 9, 90deg, 180deg), curvature_gap = 0.02/1mm).g" => "2";
    refuses "continuity(circle((0, 0), 1), angle = 0deg)" => "E0607: the angle must be positive, found 0deg";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let asked = ContinuityOptions {
        tolerance: args.tolerance,
        angle: args.angle,
        curvature_gap: args.curvature_gap,
    };
    let tolerance = asked.over(ctx.tolerance)?;
    let found = match args.b.value.0 {
        Some(b) => {
            // A single point has no direction: blame the curve that is one.
            b.tangent_at(b.domain().start(), Side::Right).at(args.b.span)?;
            args.a.value.continuity_with(&b, tolerance)
        }
        None => args.a.value.continuity(tolerance),
    };
    Ok(Record::new(continuity_fields(found.at(args.a.span)?)))
}
