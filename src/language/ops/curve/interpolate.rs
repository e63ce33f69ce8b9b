//! `interpolate`: the spline through points.

use std::sync::Arc;

use glam::{DVec3, DVec4};

use super::fit::{Parameters, chord, distinct_parameters, moves_knots, slopes_of, two_tangents};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        ConstructionReport, Curve, Ends, Interpolator, NurbsCurve, Parametrization, PointSlopes,
        interpolate_varied, interpolate_varied_ring,
    },
    value::{At, AtLeast, CARRIES_DERIVATIVES, Call, Ctx, RealCurve, Value, Vector, op, varies},
};

op! {
    /// Spline through points, on 0..1 or over the parameters that are listed.
    ///
    /// A cubic has its knots at the points and obeys a condition at each end: the tangent of the
    /// parabola through three points ("bessel"), no bending ("natural"), a parabola as the last
    /// segment ("quadratic"), given derivatives ("clamped"), no knot at the second point
    /// ("not-a-knot"). With "averaged", and of any other degree, the knots are averages of the
    /// parameters and no condition is needed. Fewer points than degree + 1 lower the degree,
    /// except where tangents or "natural" make up for them. A closed curve is periodic: its seam
    /// is as smooth as its other joints. Farin, *Curves and Surfaces for CAGD*, §9; Piegl &
    /// Tiller, *The NURBS Book*, (9.8), (9.22), (9.23).
    interpolate in Curve -> RealCurve {
        /// The points, two or more.
        points: Spanned<AtLeast<2, Vector>>,
        /// The degree.
        degree: Spanned<usize> = Spanned::unplaced(3),
        /// Where on the curve the points lie: by a rule, or listed. A closed curve takes one more,
        /// for its return to the first point.
        parameters: Spanned<Parameters> = chord(),
        /// What a cubic does where it begins and ends.
        ends: Spanned<Ends> = Spanned::unplaced(Ends::Bessel),
        /// The derivatives by the parameter at the start and at the end, of a cubic.
        tangents: Option<Spanned<Vec<DVec3>>>,
        /// A derivative by the parameter for each point; of degree 2 or 3.
        derivatives: Option<Spanned<Vec<DVec3>>>,
        /// Whether the curve goes back to its first point, which may stand at the end again.
        closed: bool = false,
    }
    example "interpolate((0, 0), (1, 1), (2, 0)).degree" => "2";
    example "interpolate((0, 0), (1, 1), (2, 0), (3, 1))(1/3) ~= (1, 1)" => "true";
    example "interpolate([(0, 0), (1, 0)], tangents = [(0, 3), (0, -3)])(0.5)" => "(0.5, 0.75, 0)";
    example "interpolate((1, 0), (0, 1), (-1, 0), (0, -1), closed = true)(0.75) ~= (0, -1)" => "true";
    example "gradient(r => length(interpolate([(r, 0), (0, r), (-r, 0), (0, -r)], closed = true)), 2) ~= length(interpolate([(1, 0), (0, 1), (-1, 0), (0, -1)], closed = true))" => "true";
    refuses "interpolate((0, 0), (1, 1), (1, 1), (2, 0))" => "E0607: points 1 and 2 are at one place";
    refuses "interpolate((0, 0), (1, 1), (2, 0), parameters = [0, 2, 1])" => "E0610: parameter 2 is 1, not above the 2 before it; parameters increase";
    refuses "interpolate((0, 0), (1, 1), (2, 0), ends = \"clamped\")" => "E0401: \"clamped\" ends need their tangents";
    derivative affine unless has_known_slopes;
    scene r#"
        points p = [(0, 0), (1, 2), (3, 1), (4, 3), (6, 0), (7, 1)] with (color = "red")
        curve c = interpolate(p)
    "#;
}

/// Whether the slopes of the spline are those of its equations: where nothing but the points moves, and the knots
/// either stay or move with them by a smooth rule.
fn has_known_slopes(call: &Call) -> bool {
    let is_known = |name: &str, given: &Value| match name {
        "points" => true,
        "degree" | "ends" | "closed" => !varies(given),
        "parameters" => moves_knots(call) || stays(given),
        _ => false,
    };
    call.named.iter().all(|(name, given)| is_known(&name.value, &given.value))
}

/// Whether parameters are the same wherever the points are.
fn stays(parameters: &Value) -> bool {
    match parameters {
        Value::Text(rule) => &**rule == "uniform",
        listed => !varies(listed),
    }
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<RealCurve> {
    check_degree(args.degree)?;
    check_conditions(&args)?;
    let AtLeast(vectors) = &args.points.value;
    let points: Vec<DVec3> = vectors.iter().map(Vector::value).collect();
    let Some(slopes) = slopes_of(vectors, args.points.span)? else {
        return spline(ctx, args, points).map(|curve| RealCurve::from(Curve::from(curve)));
    };
    let (span, degree) = (args.points.span, args.degree.value);
    let rule = match args.parameters.value {
        Parameters::By(rule) if rule != Parametrization::Uniform => rule,
        _ => return on_fixed_knots(ctx, args, points, &slopes),
    };
    if args.closed {
        return closed_varied(ctx, (degree, rule, args.parameters), (points, &slopes), span);
    }
    let parameters = distinct_parameters(args.parameters, Spanned::new(&points[..], span))?;
    let ends = ends_for(args.ends.value, points.len(), degree);
    let fit = Interpolator::new(&parameters, degree, ends).at(span)?;
    let varied = interpolate_varied((&fit, ends), rule, &points, &slopes).at(span)?;
    varied.map_or_else(|| no_slopes(ctx.span), |varied| Ok(Arc::new(varied).into()))
}

/// The curve through points that vary, whose parameters do not.
fn on_fixed_knots(
    ctx: &Ctx<'_>,
    args: Args,
    points: Vec<DVec3>,
    slopes: &PointSlopes,
) -> Result<RealCurve> {
    let (span, degree) = (args.points.span, args.degree.value);
    let (fit, curve, parameters);
    if args.closed {
        let (around, found) = ring(ctx, args.parameters, (points, span))?;
        fit = Interpolator::periodic(&found, degree).at(span)?;
        curve = fit.curve(&around[..around.len() - 1]).at(span)?;
        parameters = found;
    } else {
        parameters = distinct_parameters(args.parameters, Spanned::new(&points[..], span))?;
        let ends = ends_for(args.ends.value, points.len(), degree);
        fit = Interpolator::new(&parameters, degree, ends).at(span)?;
        curve = fit.curve(&points).at(span)?;
    }
    Ok(Arc::new(fit.varied(reporting(curve, parameters), slopes).at(span)?).into())
}

/// Fails: a polygon tears where a corner moves along it, and so do others.
fn no_slopes<T>(span: Span) -> Result<T> {
    let message = "`interpolate`: its knots move with what is differentiated, and no derivative is known of that";
    Diagnostic::error(Code::NoDerivative, span, message).hint(CARRIES_DERIVATIVES).fail()
}

/// With as few points the curve of a lower degree has these ends too.
fn ends_for(ends: Ends, n_points: usize, degree: usize) -> Ends {
    match ends {
        Ends::Bessel | Ends::Quadratic if n_points <= degree => Ends::Averaged,
        ends => ends,
    }
}

fn spline(ctx: &Ctx<'_>, args: Args, points: Vec<DVec3>) -> Result<NurbsCurve> {
    if args.closed {
        return closed(ctx, args, points);
    }
    let span = args.points.span;
    let parameters = distinct_parameters(args.parameters, Spanned::new(&points[..], span))?;
    let degree = args.degree.value;
    if let Some(derivatives) = args.derivatives {
        let interpolator = Interpolator::with_derivatives(&parameters, degree).at(span)?;
        let curve = interpolator.curve_with_derivatives(&points, &derivatives.value);
        return Ok(reporting(curve.at(derivatives.span)?, parameters));
    }
    if let Some(tangents) = args.tangents {
        let tangents = two_tangents(&tangents)?;
        let interpolator = Interpolator::new(&parameters, degree, Ends::Clamped).at(span)?;
        let curve = interpolator.curve_with_tangents(&points, tangents).at(span)?;
        return Ok(reporting(curve, parameters));
    }
    let ends = ends_for(args.ends.value, points.len(), degree);
    let interpolator = Interpolator::new(&parameters, degree, ends).at(span)?;
    Ok(reporting(interpolator.curve(&points).at(span)?, parameters))
}

/// The curve with a report of where on it the points lie.
fn reporting(curve: NurbsCurve, parameters: Vec<f64>) -> NurbsCurve {
    let degree = curve.degree();
    curve.with_report(
        ConstructionReport::of("interpolate").with("degree", degree).with("parameters", parameters),
    )
}

/// The points of a closed curve, the first of them at the end again, and where on it they lie.
fn ring(
    ctx: &Ctx<'_>,
    parameters: Spanned<Parameters>,
    (mut around, span): (Vec<DVec3>, Span),
) -> Result<(Vec<DVec3>, Vec<f64>)> {
    let first = around[0];
    if around.len() > 1 && ctx.tolerance.distance < around[around.len() - 1].distance(first) {
        around.push(first);
    }
    let n_points = around.len() - 1;
    if n_points < 3 {
        let message = format!("a closed curve needs 3 points apart or more, found {n_points}");
        return Diagnostic::error(Code::TooFewPoints, span, message).fail();
    }
    around[n_points] = first;
    let listed = parameters.span;
    let parameters = distinct_parameters(parameters, Spanned::new(&around[..], span))
        .map_err(|mistake| about_return(mistake, listed, n_points))?;
    Ok((around, parameters))
}

/// The periodic curve.
fn closed(ctx: &Ctx<'_>, args: Args, points: Vec<DVec3>) -> Result<NurbsCurve> {
    let span = args.points.span;
    let (around, parameters) = ring(ctx, args.parameters, (points, span))?;
    let interpolator = Interpolator::periodic(&parameters, args.degree.value).at(span)?;
    Ok(reporting(interpolator.curve(&around[..around.len() - 1]).at(span)?, parameters))
}

/// The same through points that vary.
fn closed_varied(
    ctx: &Ctx<'_>,
    (degree, rule, parameters): (usize, Parametrization, Spanned<Parameters>),
    (points, slopes): (Vec<DVec3>, &PointSlopes),
    span: Span,
) -> Result<RealCurve> {
    let (around, _) = ring(ctx, parameters, (points, span))?;
    let last = around.len() - 1;
    if degree != 3 {
        return no_slopes(ctx.span);
    }
    let returning = |(variable, own): &(usize, Vec<DVec4>)| {
        let mut own = own[..last].to_vec();
        own.extend(own.first().copied());
        (*variable, own)
    };
    let by_variable = slopes.by_variable().iter().map(returning).collect();
    let slopes = PointSlopes::new(slopes.n_variables(), around.len(), by_variable).at(span)?;
    let varied = interpolate_varied_ring(rule, &around, &slopes).at(span)?;
    varied.map_or_else(|| no_slopes(ctx.span), |varied| Ok(Arc::new(varied).into()))
}

/// Tells what the number of parameters of a closed curve counts.
fn about_return(mistake: Box<Diagnostic>, listed: Span, n_points: usize) -> Box<Diagnostic> {
    if mistake.primary.span != listed {
        return mistake;
    }
    let hint = format!(
        "a closed curve takes one parameter for each of its {n_points} points and one for its return to the first"
    );
    Box::new(mistake.hint(hint))
}

fn check_degree(degree: Spanned<usize>) -> Result<()> {
    if degree.value > 0 {
        return Ok(());
    }
    Diagnostic::error(Code::BadDegree, degree.span, "the degree must be 1 or more, found 0").fail()
}

/// Fails where two arguments say different things about the same.
fn check_conditions(args: &Args) -> Result<()> {
    let complain = |span: Span, message: &str, hint: &str| {
        Diagnostic::error(Code::BadCall, span, message).hint(hint).fail()
    };
    let degree = args.degree.value;
    let ends = (args.ends.span != Span::default()).then_some(args.ends.span);
    let tangents = args.tangents.as_ref().map(|tangents| tangents.span);
    let derivatives = args.derivatives.as_ref().map(|derivatives| derivatives.span);
    if let (true, Some(span)) = (args.closed, ends.or(tangents)) {
        return complain(span, "a closed curve has no ends", "leave this out, or `closed`");
    }
    if let (true, Some(span)) = (args.closed, derivatives) {
        return complain(
            span,
            "a closed curve takes no derivatives",
            "leave this out, or `closed`",
        );
    }
    if let (Some(span), Some(_)) = (tangents.or(ends), derivatives) {
        let message = "`derivatives` already say how the curve begins and ends";
        return complain(span, message, "leave this out, or `derivatives`");
    }
    if let (Some(span), false) = (derivatives, (2..=3).contains(&degree)) {
        let message = format!("`derivatives` need degree 2 or 3, found degree {degree}");
        return complain(span, &message, "write `degree = 3`");
    }
    if let (Some(span), false) = (tangents, degree == 3) {
        let message = format!("`tangents` need degree 3, found degree {degree}");
        return complain(span, &message, "write `degree = 3`");
    }
    match (ends, args.ends.value, tangents) {
        (Some(span), Ends::Clamped, None) => complain(
            span,
            "\"clamped\" ends need their tangents",
            "write `tangents = [start, end]`",
        ),
        (Some(span), ends, Some(_)) if ends != Ends::Clamped => {
            let message = "`tangents` clamp the ends, so that they can have no other condition";
            complain(span, message, "leave out `ends`, or `tangents`")
        }
        (Some(span), ends, _) if degree != 3 && ends != Ends::Averaged => {
            let message = format!("this condition is one for cubics, found degree {degree}");
            complain(span, &message, "leave out `ends`: other degrees need none")
        }
        _ => Ok(()),
    }
}
