//! `curvature_comb` of a surface: the porcupines of its isocurves.

use std::sync::Arc;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    export::N_ISOCURVES,
    kernel::{Curve, Interval, Surface},
    ops::measure::curve::{
        check_segments,
        curvature_comb::{CombSide, comb},
    },
    value::{At, Ctx, IntoValue, Record, op},
};

op! {
    /// Curvature combs along isocurves of a surface, `{teeth, envelopes}`: the teeth of all, and the
    /// polyline of the tips of each.
    ///
    /// A tooth is as long as the curvature of the isocurve as a curve in space, and lies along its
    /// principal normal, as in the surface combs of modelling programs: on a circle of latitude
    /// of a sphere it is square to the axis. It is not the normal curvature of the surface, which
    /// `normal_curvature` tells. First come the isocurves at the parameters `u`, which run along
    /// v, then those at `v`; without both those that a picture draws, at even steps and at edges.
    curvature_comb in Measure -> Record {
        /// The surface.
        s: Spanned<Surface>,
        /// The parameters u of isocurves.
        u: Option<Spanned<Vec<f64>>>,
        /// The parameters v of isocurves.
        v: Option<Spanned<Vec<f64>>>,
        /// How many teeth each isocurve has, two or more.
        samples: Spanned<usize> = Spanned::unplaced(100),
        /// Length of a tooth where the curvature is 1.
        scale: f64 = 1.0,
        /// Away from the centre of curvature or towards it.
        side: CombSide = CombSide::Outside,
    }
    example "curvature_comb(cylinder((0, 0), 2, 1), v = [0.5], samples = 5).teeth[0].end ~= (2.5, 0, 0.5)" => "true";
    example "curvature_comb(cylinder((0, 0), 2, 1), u = [0], samples = 3).teeth[1].end ~= (2, 0, 0.5)" => "true";
    example "len(curvature_comb(cylinder((0, 0), 2, 1), samples = 5).envelopes)" => "17";
    refuses "curvature_comb(cylinder((0, 0), 2, 1), v = [2])" => "E0606: parameter 2 is outside the domain 0..1";
    refuses "curvature_comb(cylinder((0, 0), 2, 1), u = [])" => "E0601: there are no parameters, so that no isocurve is asked for";
    scene r#"
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
        let comb = curvature_comb(s, u = [0, 0.5, 1], v = [0, 0.5, 1], samples = 40) with (hidden = true)
        curves teeth = comb.teeth with (color = "gray")
        curves envelopes = comb.envelopes with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let n_asked: usize = [&args.u, &args.v].into_iter().flatten().map(|at| at.value.len()).sum();
    check_segments(args.samples, n_asked, ctx)?;
    let curves = match (&args.u, &args.v) {
        (None, None) => drawn(ctx, &args.s)?,
        (u, v) => asked(&args.s.value, u.as_ref(), v.as_ref())?,
    };
    if curves.is_empty() {
        let span = args.u.or(args.v).map_or(args.s.span, |given| given.span);
        let message = "there are no parameters, so that no isocurve is asked for";
        return Diagnostic::error(Code::TooFewPoints, span, message)
            .hint("without `u` and `v` there is a comb along each isocurve that a picture draws")
            .fail();
    }
    check_segments(args.samples, curves.len(), ctx)?;
    let sign = args.side.signed(args.scale);
    let (mut teeth, mut envelopes) = (Vec::new(), Vec::with_capacity(curves.len()));
    for curve in &curves {
        let comb = comb(ctx, curve, args.samples, sign)?;
        teeth.extend(comb.teeth);
        envelopes.push(comb.envelope);
    }
    Ok(Record::new([
        (Arc::from("teeth"), teeth.into_value()),
        (Arc::from("envelopes"), envelopes.into_value()),
    ]))
}

/// The isocurves at the parameters that are given.
fn asked(
    s: &Surface,
    u: Option<&Spanned<Vec<f64>>>,
    v: Option<&Spanned<Vec<f64>>>,
) -> Result<Vec<Spanned<Curve>>> {
    let mut curves = Vec::new();
    if let Some(Spanned { value, span }) = u {
        for &u in value {
            let u = s.domain_u().clamp_inside(u).at(*span)?;
            curves.push(Spanned::new(s.isocurve_u(u).at(*span)?, *span));
        }
    }
    if let Some(Spanned { value, span }) = v {
        for &v in value {
            let v = s.domain_v().clamp_inside(v).at(*span)?;
            curves.push(Spanned::new(s.isocurve_v(v).at(*span)?, *span));
        }
    }
    Ok(curves)
}

/// The isocurves that pictures draw: a seam once, and no poles.
fn drawn(ctx: &Ctx<'_>, s: &Spanned<Surface>) -> Result<Vec<Spanned<Curve>>> {
    let (surface, span) = (&s.value, s.span);
    let steps = |domain: Interval| domain.steps(N_ISOCURVES + 1);
    let same = ctx.tolerance.distance_for(surface.bounds().at(span)?.diagonal());
    let closed_u = surface.is_closed_u(same).at(span)?;
    let closed_v = surface.is_closed_v(same).at(span)?;
    let mut curves = Vec::new();
    for u in steps(surface.domain_u()).into_iter().skip(usize::from(closed_u)) {
        curves.push(surface.isocurve_u(u).at(span)?);
    }
    for v in steps(surface.domain_v()).into_iter().skip(usize::from(closed_v)) {
        curves.push(surface.isocurve_v(v).at(span)?);
    }
    let mut extended = Vec::with_capacity(curves.len());
    for curve in curves {
        if same < curve.bounds().at(span)?.diagonal() {
            extended.push(Spanned::new(curve, span));
        }
    }
    Ok(extended)
}
