//! `gordon`: the surface through a network of curves.

use super::{
    network::NetworkPlaces,
    section::{apart, nurbs_within},
    sweep::tolerated,
};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{
        ConstructionReport, Curve, CurveAdjustment, Gordon, Network, NurbsCurve, NurbsSurface,
        ReportEntry, check_parameters, gordon as through,
    },
    value::{At, Choice, Ctx, Length, op},
};

op! {
    /// Surface through a network of curves, those along u and those along v.
    ///
    /// Where the curves meet is found unless it is given; they may be of any degree, direction,
    /// order and parameters. The first curve of each list gives the direction; others are reversed
    /// and reordered to it, and what stands out beyond the network is cut off. Where all curves of
    /// a direction close, so does the surface, as smooth at its seam as they are, and a curve across
    /// them that comes again, as one at their seam often does, counts once. Curves that meet
    /// the others at one set of parameters stay as they are, and are isocurves exactly, rational
    /// ones of one denominator too; others are run through with another parameter, twice
    /// continuously differentiable, and become splines of their degree, 3 or more, on as few knots
    /// as the tolerance needs. `report` tells what was done, and for each curve a bound of
    /// its distance from the surface, which is within the tolerance. Two and two curves make the
    /// Coons patch.
    /// Gordon (1969); Piegl & Tiller, *The NURBS Book*, §10.5.
    gordon in Surface -> NurbsSurface {
        /// The curves along u, two or more.
        u: Spanned<Vec<Curve>>,
        /// The curves along v, two or more.
        v: Spanned<Vec<Curve>>,
        /// The u of each v-curve.
        at_u: Option<Spanned<Vec<f64>>>,
        /// The v of each u-curve.
        at_v: Option<Spanned<Vec<f64>>>,
        /// Cubic splines between the curves, or one polynomial through all.
        blend: GordonBlend = GordonBlend::Spline,
        /// How far curves may be apart where they meet, and the surface from them; the document's.
        tolerance: Option<Spanned<Length>>,
    }
    example "gordon([line((0, 0), (1, 0)), line((0, 1), (1, 1, 1))], [line((0, 0), (0, 1)), line((1, 0), (1, 1, 1))])(0.5, 0.5)" => "(0.5, 0.5, 0.25)";
    example "gordon(u = [line((0, 0), (2, 0)), line((0, 1), (2, 1))], v = [line((2, 0), (2, 1)), line((0, 1), (0, 0))])(0.5, 1)" => "(1, 1, 0)";
    refuses "gordon(u = [line((0, 0), (1, 0)), line((0, 1), (1, 1))], v = [line((0, 0, 2), (0, 1, 2)), line((1, 0), (1, 1))])" => "E0609: `line((0, 1), (1, 1))` and `v[0]` do not meet: they are 2 apart at (0, 1, 1), more than the tolerance 1e-6; another pair does not meet either";
    refuses "gordon(u = [line((0, 0), (1, 0))], v = [line((0, 0), (0, 1)), line((1, 0), (1, 1))])" => "E0401: a network needs 2 curves `u` or more, found 1";
    scene r#"
        curves u = [for y in [0, 2, 4]: bezier((0, y, 0), (2, y, 4 - y/2), (4, y, 0))] with (color = "red")
        curves v = [for x in [0, 4]: line((x, 0), (x, 4))] with (color = "green")
        surface s = gordon(u = u, v = v) with (color = "lightgray")
    "#;
}

/// What is between the curves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum GordonBlend {
    Spline,
    Lagrange,
}

impl Choice for GordonBlend {
    const WORDS: &'static [&'static str] = &["spline", "lagrange"];
    const MEANINGS: &'static [Self] = &[Self::Spline, Self::Lagrange];
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let tolerance = tolerated(ctx, args.tolerance.as_ref())?;
    let spans = [args.u.span, args.v.span];
    let us = curves(ctx, "u", &args.u, tolerance)?;
    let vs = curves(ctx, "v", &args.v, tolerance)?;
    let [(of_u, apart_u), (of_v, apart_v)] = [once(&us, &vs, tolerance), once(&vs, &us, tolerance)];
    let kept = [of_u, of_v];
    // What is left of it, so that the surface is within it of the curves that come again too.
    let tolerance = tolerance - apart_u.max(apart_v);
    let [us, vs] = [(us, &kept[0]), (vs, &kept[1])]
        .map(|(curves, kept)| kept.iter().map(|&i| curves[i].clone()).collect::<Vec<_>>());
    let at = [("at_u", &args.at_u, "v", vs.len()), ("at_v", &args.at_v, "u", us.len())];
    for (name, given, family, needed) in at {
        let Some(given) = given else { continue };
        let got = given.value.len();
        if got != needed {
            let message =
                format!("`{name}` are {got} parameters, but there are {needed} curves `{family}`");
            return Diagnostic::error(Code::BadParameters, given.span, message)
                .hint(format!("give one for each curve of `{family}`, or leave `{name}` out to have them found"))
                .fail();
        }
        check_parameters(&given.value, needed).at(given.span)?;
    }
    let network = Network {
        curves: [&us, &vs],
        at: [&args.at_u, &args.at_v].map(|at| at.as_ref().map(|at| &at.value[..])),
        is_lagrange: args.blend == GordonBlend::Lagrange,
        tolerance,
    };
    let is_given = network.at.iter().any(Option::is_some);
    let made = through(network).map_err(|error| {
        NetworkPlaces { ctx, spans, kept: [&kept[0], &kept[1]], tolerance, is_given }.told(error)
    })?;
    Ok(with_report(made, [(&kept[0], args.u.value.len()), (&kept[1], args.v.value.len())]))
}

/// Part of the tolerance by which a curve that comes again may miss where it was before.
const AGAIN: f64 = 0.5;

/// The indices of the curves; where those across them all close, without curves that come again in
/// either direction, and how far these are at most from where they were before.
fn once(curves: &[NurbsCurve], across: &[NurbsCurve], tolerance: f64) -> (Vec<usize>, f64) {
    let all: Vec<usize> = (0..curves.len()).collect();
    if !across.iter().all(|curve| curve.is_closed(tolerance)) {
        return (all, 0.0);
    }
    let same = AGAIN * tolerance;
    let (mut kept, mut farthest) = (Vec::new(), 0.0_f64);
    for &i in &all {
        let ways = [curves[i].clone(), curves[i].reversed()];
        let misses = kept.iter().flat_map(|&k: &usize| {
            let own = &curves[k];
            let meets = |way: &&NurbsCurve| {
                own.start().distance(way.start()).max(own.end().distance(way.end())) <= same
            };
            ways.iter().filter(meets).map(|way| apart(own, way))
        });
        let least = misses.fold(f64::INFINITY, f64::min);
        if least <= same {
            farthest = farthest.max(least);
        } else {
            kept.push(i);
        }
    }
    if kept.len() < 2 { (all, 0.0) } else { (kept, farthest) }
}

fn curves(
    ctx: &Ctx<'_>,
    name: &str,
    given: &Spanned<Vec<Curve>>,
    tolerance: f64,
) -> Result<Vec<NurbsCurve>> {
    let got = given.value.len();
    if got < 2 {
        let message = format!("a network needs 2 curves `{name}` or more, found {got}");
        return Diagnostic::error(Code::BadCall, given.span, message)
            .hint("sections without curves across them make a `skin`")
            .fail();
    }
    let nurbs = |(i, curve): (usize, &Curve)| {
        // Half of it, so that what is found within the tolerance of it is within it of the function.
        let curve = nurbs_within(curve, 0.25 * tolerance).at(given.span)?;
        if curve.is_point() {
            let (own, span) = ctx.element(given.span, i, name);
            let message = format!("{own} is one point");
            return Diagnostic::error(Code::Degenerate, span, message)
                .hint(
                    "a surface that ends in a point is a `skin` whose first or last section is one",
                )
                .fail();
        }
        Ok(NurbsCurve::clone(&curve))
    };
    given.value.iter().enumerate().map(nurbs).collect()
}

/// The surface with its report.
fn with_report(made: Gordon, kept: [(&[usize], usize); 2]) -> NurbsSurface {
    let Gordon { surface, at, mut changes, gap, seams } = made;
    for (changes, (kept, _)) in changes.iter_mut().zip(kept) {
        changes.iter_mut().for_each(|change| change.index = kept[change.index]);
    }
    let repeated =
        kept.map(|(kept, given)| (0..given).filter(|i| !kept.contains(i)).collect::<Vec<usize>>());
    // In the order in which the curves were given.
    let [at_u, at_v] = [0, 1].map(|f| {
        let mut pairs: Vec<(usize, f64)> =
            changes[1 - f].iter().map(|change| change.index).zip(at[f].iter().copied()).collect();
        pairs.sort_by_key(|&(index, _)| index);
        pairs.into_iter().map(|(_, t)| t).collect::<Vec<f64>>()
    });
    changes.iter_mut().for_each(|family| family.sort_by_key(|change| change.index));
    let net = surface.control_points();
    let both = |u: usize, v: usize| ConstructionReport::default().with("u", u).with("v", v);
    let family = |changes: &[CurveAdjustment]| {
        let one = |change: &CurveAdjustment| {
            ConstructionReport::default()
                .with("curve", change.index)
                .with("deviation", change.deviation)
                .with("at", change.worst_at)
                .with("reversed", change.is_reversed)
                .with("trimmed", change.is_trimmed)
                .with("seam", change.seam)
                .with("reparametrized", change.is_reparametrized)
                .with("refitted", change.is_refitted)
        };
        changes.iter().map(one).collect::<Vec<_>>()
    };
    let deviations = changes.iter().flatten().map(|change| change.deviation);
    let [u, v] = &changes;
    let [seam_u, seam_v] = seams.map(|angle| angle.map_or(ReportEntry::None, ReportEntry::Angle));
    let [repeated_u, repeated_v] = repeated;
    let (widest, [k, l]) = (gap.0, [kept[0].0[gap.1[0]], kept[1].0[gap.1[1]]]);
    let report = ConstructionReport::of("gordon")
        .with("at_u", at_u)
        .with("at_v", at_v)
        .with("deviation", deviations.fold(0.0, f64::max))
        .with("gap", ConstructionReport::default().with("max", widest).with("u", k).with("v", l))
        .with("u", family(u))
        .with("v", family(v))
        .with("repeated_u", repeated_u)
        .with("repeated_v", repeated_v)
        .with("seam_u", seam_u)
        .with("seam_v", seam_v)
        .with("degree", both(surface.degree_u(), surface.degree_v()))
        .with("control_points", both(net.n_rows(), net.n_columns()));
    surface.with_report(report)
}
