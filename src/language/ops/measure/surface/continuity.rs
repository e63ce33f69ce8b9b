//! `continuity` of two surfaces across an edge, or of one.

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Continuity, Edge, Surface, SurfaceContinuity},
    ops::measure::continuity_limits::{ContinuityOptions, continuity_fields},
    value::{Angle, At, Ctx, Curvature, Length, Maybe, Record, Value, op},
};

op! {
    /// How smoothly a surface goes on in another across an edge; of one surface alone the worst
    /// across the lines of its inner knots, and across its seam where it is closed.
    ///
    /// `c` and `g` are the largest orders up to 3 that hold along the whole edge, -1 where the edges
    /// are apart. `c` wants equal derivatives across the edge, at places of equal fractions along it.
    /// `g` does not look at the parameters: 1 wants the same tangent plane, 2 the same second
    /// fundamental tensor, 3 the same third derivatives of the height over that plane.
    /// `c_homogeneous` compares the homogeneous surfaces. `gap`, `angle` and `curvature_gap` tell how far
    /// points, tangent planes and normal curvatures differ at most, and `at` is where: the place of the
    /// largest gap if the edges are apart, else of the largest angle, or curvature gap where the planes
    /// agree. The edges may run opposite ways.
    ///
    /// What counts as equal is decided by the document's tolerance: points by its distance, tangent
    /// planes within 1e-9 rad, and all that is higher to 1e-9 of its size. `tolerance`, `angle` and
    /// `curvature_gap` ask for other limits of the fields `gap`, `angle` and `curvature_gap`; an order
    /// fails where the field exceeds its limit, and `c` is then no higher than `g`.
    ///
    /// Of NURBS each piece is compared in more places than a difference of its degree could have
    /// zeros; of `parametric` surfaces in 129. Linkeová, *Curves and Surfaces for Computer Graphics*,
    /// Definitions 1.32 to 1.34; Peters, *Geometric continuity*.
    continuity in Measure -> Record {
        /// The first surface.
        a: Spanned<Surface>,
        /// The surface that goes on, if it is another.
        b: Spanned<Maybe<Surface>>,
        /// The edge of the first where it goes on.
        edge_a: Spanned<Maybe<Edge>>,
        /// The edge of the second where it begins.
        edge_b: Spanned<Maybe<Edge>>,
        /// How far the edges may be apart; otherwise the document's tolerance, at most a thousandth
        /// of the size.
        tolerance: Option<Spanned<Length>>,
        /// By how much tangent planes may differ for G1.
        angle: Option<Spanned<Angle>>,
        /// By how much normal curvatures may differ for G2.
        curvature_gap: Option<Spanned<Curvature>>,
    }
    example "continuity(bilinear((0, 0), (0, 1), (1, 0), (1, 1)), bilinear((1, 0), (1, 1), (3, 0), (3, 1)), \"u1\", \"u0\").c" => "0";
    example "continuity(bilinear((0, 0), (0, 1), (1, 0), (1, 1)), bilinear((1, 0), (1, 1), (3, 0), (3, 1)), \"u1\", \"u0\").g" => "3";
    example "continuity(bspline([[(0, 0), (0, 1)], [(1, 0), (1, 1)], [(1, 0, 1), (1, 1, 1)]], degree = 1)).angle" => "90deg";
    example "continuity(bspline([[(0, 0), (0, 1)], [(1, 0), (1, 1)], [(2, 0, 0.01), (2, 1, 0.01)]], degree = 1), angle = 1deg).g" => "3";
    refuses "continuity(plane_patch((0, 0), (1, 0), (0, 1)), plane_patch((0, 0), (1, 0), (0, 1)))" => "E0401: two surfaces are compared along one edge of each";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let a = &args.a.value;
    let asked = ContinuityOptions {
        tolerance: args.tolerance,
        angle: args.angle,
        curvature_gap: args.curvature_gap,
    };
    let tolerance = asked.over(ctx.tolerance)?;
    let found = match (args.b.value.0, args.edge_a.value.0, args.edge_b.value.0) {
        (None, None, None) => a.continuity(tolerance),
        (Some(b), Some(edge_a), Some(edge_b)) => a.continuity_with(edge_a, &b, edge_b, tolerance),
        (b, ..) => {
            let message = "two surfaces are compared along one edge of each";
            let mistake = Diagnostic::error(Code::BadCall, ctx.span, message);
            let (one, other) = match b {
                Some(b) => a.nearest_edges(&b).at(ctx.span)?,
                None => (Edge::U1, Edge::U0),
            };
            let words = format!("\"{}\", \"{}\"", one.word(), other.word());
            return mistake
                .hint(format!("the nearest are {words}: write `continuity(a, b, {words})`"))
                .fail();
        }
    };
    let found = found.at(args.a.span)?;
    let SurfaceContinuity { c, g, gap, angle, curvature_gap, c_homogeneous, at } = found;
    let at = at.map_or(Value::None, Value::Point);
    let fields = continuity_fields(Continuity { c, g, gap, angle, curvature_gap, c_homogeneous });
    Ok(Record::new(fields.into_iter().chain([("at".into(), at)])))
}
