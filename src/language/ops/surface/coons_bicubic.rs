//! `coons_bicubic`: the surface within four boundary curves with derivatives across them.

use super::{
    boundary::{Boundary, NamedEdge, pair, place, verb},
    turned::BoundaryAngle,
};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        ConstructionReport, CrossFields, Curve, Direction, Interval, NurbsSurface, ReportEntry,
        Twists,
    },
    value::{Angle, At, Choice, Ctx, op, rounded},
};

op! {
    /// Coons surface within four curves that also takes derivatives across them.
    ///
    /// Exact as `coons` is. At each corner the data must agree: a cross field begins with the
    /// derivative of the boundary that it crosses to, else it is an error; and the derivatives of
    /// both cross fields, the twists, are one. Where these differ, `"average"` takes their mean and
    /// moves the control points of the fields next to that corner, which a warning and `report`
    /// tell; `"error"` refuses. Where the surface fills a hole, that turns it against its
    /// neighbours beside the corner: `report` tells the largest angle reached along the boundary as `angle`,
    /// and that along each of the four curves as `angles`; the parameter `angle` demands one. Its domains are those of `u[0]` and `v[0]`, by which derivatives
    /// count. Piegl & Tiller, *The NURBS Book*, (10.37) to (10.43), A10.4.
    coons_bicubic in Surface -> NurbsSurface {
        /// The two curves along u: at v = 0 and at v = 1.
        u: Spanned<Vec<Curve>>,
        /// The two curves along v: at u = 0 and at u = 1.
        v: Spanned<Vec<Curve>>,
        /// Derivatives Sv along each of the u-curves, as curves of vectors.
        cross_u: Spanned<Vec<Curve>>,
        /// Derivatives Su along each of the v-curves, as curves of vectors.
        cross_v: Spanned<Vec<Curve>>,
        /// What to do where the twists of the fields differ.
        twists: OnTwists = OnTwists::Average,
        /// The largest angle along the boundary between the surface and the tangent plane that the
        /// cross fields ask for; more is an error.
        angle: Option<Spanned<Angle>>,
    }
    example "coons_bicubic(u = [line((0, 0), (1, 0)), line((0, 1), (1, 1))], v = [line((0, 0), (0, 1)), line((1, 0), (1, 1))], cross_u = [line((0, 1), (0, 1)), line((0, 1), (0, 1))], cross_v = [line((1, 0), (1, 0)), line((1, 0), (1, 0))])(0.5, 0.25) ~= (0.5, 0.25)" => "true";
    refuses "coons_bicubic(u = [line((0, 0), (1, 0)), line((0, 1), (1, 1))], v = [line((0, 0), (0, 1)), line((1, 0), (1, 1))], cross_u = [line((0, 2), (0, 2)), line((0, 2), (0, 2))], cross_v = [line((1, 0), (1, 0)), line((1, 0), (1, 0))])" => "E0607: at the corner u = 0, v = 0 `cross_u[0]` starts with (0, 2, 0), but the derivative of `v[0]` there is (0, 1, 0): they differ by 1";
    refuses "coons_bicubic(u = [line((0, 0), (1, 0)), line((0, 1), (1, 1))], v = [line((0, 0), (0, 1)), line((1, 0), (1, 1))], cross_u = [bezier((0, 1), (0, 1, 1), (0, 1)), line((0, 1), (0, 1))], cross_v = [line((1, 0), (1, 0)), line((1, 0), (1, 0))], angle = 5deg)" => "E0608: along `u[0]` the surface is turned by 12.5288 degrees against what its cross field asks for, at parameter 0.5, more than the 5 allowed";
    scene r#"
        curves u = [line((0, 0), (4, 0)), line((0, 4), (4, 4))] with (color = "red")
        curves v = [for x in [0, 4]: bezier((x, 0, 0), (x, 2, 3), (x, 4, 0))] with (color = "green")
        let steep = [for z in [6, -6]: bezier([for f in [1, 1, -3, 1, 1]: (0, 4, f*z)])] with (hidden = true)
        let level = [line((4, 0), (4, 0)), line((4, 0), (4, 0))] with (hidden = true)
        surface s = coons_bicubic(u = u, v = v, cross_u = steep, cross_v = level) with (color = "lightgray")
    "#;
}

/// What to do about twists that contradict one another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum OnTwists {
    Average,
    Error,
}

impl Choice for OnTwists {
    const WORDS: &'static [&'static str] = &["average", "error"];
    const MEANINGS: &'static [Self] = &[Self::Average, Self::Error];
}

const CORNERS: [[usize; 2]; 4] = [[0, 0], [0, 1], [1, 0], [1, 1]];

/// The boundary with the fields, all over its domains.
struct CoonsData {
    boundary: Boundary,
    cross_u: [NamedEdge; 2],
    cross_v: [NamedEdge; 2],
    over: [Interval; 2],
    tolerance: f64,
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let boundary = Boundary { u: pair("u", &args.u, ctx)?, v: pair("v", &args.v, ctx)? };
    let tolerance = ctx.tolerance.distance;
    boundary.check([args.u.span, args.v.span], tolerance)?;
    let over = [boundary.u[0].curve.domain(), boundary.v[0].curve.domain()];
    let on = |edges: [NamedEdge; 2], domain: Interval| {
        edges.map(|edge| NamedEdge { curve: edge.curve.clamped().reparametrized(domain), ..edge })
    };
    let data = CoonsData {
        boundary: Boundary { u: on(boundary.u, over[0]), v: on(boundary.v, over[1]) },
        cross_u: on(pair("cross_u", &args.cross_u, ctx)?, over[0]),
        cross_v: on(pair("cross_v", &args.cross_v, ctx)?, over[1]),
        over,
        tolerance,
    };
    data.check_slopes([args.cross_u.span, args.cross_v.span])?;

    let [[a, b], [c, d]] =
        [&data.cross_u, &data.cross_v].map(|fields| fields.clone().map(|f| f.curve));
    let fields = CrossFields { cross_u: [a, b], cross_v: [c, d] };
    let differing: Vec<Twists> = CORNERS
        .into_iter()
        .map(|corner| fields.twists(corner))
        .filter(|twists| tolerance < data.moves(twists))
        .collect();
    for twists in &differing {
        let told = data.disagreement(twists);
        if args.twists == OnTwists::Error {
            return Diagnostic::error(Code::Degenerate, args.cross_u.span, told)
                .also(args.cross_v.span, "the other")
                .hint("`twists = \"average\"` takes their mean, and changes the fields beside the corner")
                .fail();
        }
        let message = format!("{told}; their mean {} is taken", place(twists.mean()));
        ctx.warn(
            Diagnostic::warning(Code::Unclean, args.cross_u.span, message)
                .also(args.cross_v.span, "the other")
                .hint("the fields are changed beside the corner; `report` tells how"),
        );
    }
    let corners: Vec<[usize; 2]> = differing.iter().map(|twists| twists.corner).collect();
    let corrected = fields.with_mean_twists(&corners).at(ctx.span)?;
    let all_turned = data.turned(&corrected);
    let turned = BoundaryAngle::largest(&all_turned);
    if let Some(angle) = args.angle.filter(|angle| angle.value.0 < turned.angle) {
        return turned.refused(angle);
    }
    let [u, v] = data.boundary.curves();
    let surface = NurbsSurface::coons_bicubic(u, v, &corrected).at(ctx.span)?;
    let facts: Vec<ReportEntry> = differing.iter().map(|twists| data.fact(twists)).collect();
    let report = ConstructionReport::of("coons_bicubic")
        .with("averaged_twists", ReportEntry::List(facts))
        .with("angle", turned.fact())
        .with("angles", BoundaryAngle::facts(&all_turned));
    Ok(surface.with_report(report))
}

impl CoonsData {
    /// Fails where a cross field does not begin with the derivative of the boundary there.
    fn check_slopes(&self, spans: [Span; 2]) -> Result<()> {
        for [i, j] in CORNERS {
            let along_u = (&self.cross_v[i], j, &self.boundary.u[j], i, self.over[0], spans[1]);
            let along_v = (&self.cross_u[j], i, &self.boundary.v[i], j, self.over[1], spans[0]);
            for (field, at, curve, end, domain, span) in [along_u, along_v] {
                let t = [domain.start(), domain.end()][end];
                let slope = curve.curve.derivatives_at(t, 1)[1];
                let found = field.end(at);
                if found.distance(slope) * domain.length() <= self.tolerance {
                    continue;
                }
                let message = format!(
                    "at the corner u = {}, v = {} `{}` {} with {}, but the derivative of `{}` there is {}: they differ by {}",
                    rounded(self.at(Direction::U, i)),
                    rounded(self.at(Direction::V, j)),
                    field.name,
                    verb(at),
                    place(found),
                    curve.name,
                    place(slope),
                    rounded(found.distance(slope))
                );
                return Diagnostic::error(Code::Degenerate, span, message)
                    .hint("`cross_u` are Sv along the u-curves, `cross_v` are Su along the v-curves: vectors that end as the boundaries there do")
                    .fail();
            }
        }
        Ok(())
    }

    /// The largest angle between the surface of these fields and what the given ones ask for, along each
    /// boundary.
    fn turned(&self, made: &CrossFields) -> Vec<BoundaryAngle> {
        let along_u = self.boundary.u.iter().zip(&self.cross_u).zip(&made.cross_u);
        let along_v = self.boundary.v.iter().zip(&self.cross_v).zip(&made.cross_v);
        let turned = |((edge, given), made): ((&NamedEdge, &NamedEdge), _)| {
            BoundaryAngle::along((&edge.name, &edge.curve), [&given.curve, made])
        };
        along_u.chain(along_v).map(turned).collect()
    }

    /// How far the difference of two twists would move the surface.
    fn moves(&self, twists: &Twists) -> f64 {
        let area = self.over[0].length() * self.over[1].length();
        twists.of_cross_u.distance(twists.of_cross_v) * area
    }

    /// An end of a domain.
    fn at(&self, along: Direction, end: usize) -> f64 {
        let domain = self.over[along];
        [domain.start(), domain.end()][end]
    }

    fn disagreement(&self, twists: &Twists) -> String {
        let [i, j] = twists.corner;
        format!(
            "at the corner u = {}, v = {} the derivative of `{}` is {}, that of `{}` is {}: the twists differ by {}",
            rounded(self.at(Direction::U, i)),
            rounded(self.at(Direction::V, j)),
            self.cross_u[j].name,
            place(twists.of_cross_u),
            self.cross_v[i].name,
            place(twists.of_cross_v),
            rounded(twists.of_cross_u.distance(twists.of_cross_v))
        )
    }

    fn fact(&self, twists: &Twists) -> ReportEntry {
        let [i, j] = twists.corner;
        ReportEntry::Record(
            ConstructionReport::default()
                .with("u", self.at(Direction::U, i))
                .with("v", self.at(Direction::V, j))
                .with("cross_u", twists.of_cross_u)
                .with("cross_v", twists.of_cross_v)
                .with("twist", twists.mean())
                .with(
                    "difference",
                    ReportEntry::Length(twists.of_cross_u.distance(twists.of_cross_v)),
                ),
        )
    }
}
