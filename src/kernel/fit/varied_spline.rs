//! Interpolating splines that vary with the points that they go through: curves, with the slopes of their control points.

use std::sync::Arc;

use glam::{DVec3, DVec4};

use super::{
    Interpolator, Parametrization,
    growth::spline_slopes_asked,
    interpolate::Ends,
    moving::{MovingSpline, SplineSpeeds, derivative},
};
use crate::{GeomError, NurbsCurve, PointSlopes, VariedCurve, varied::knots::with_knots_twice};

/// The degree of closed splines whose knots may move.
const CUBIC: usize = 3;

/// The spline that [`Interpolator::new`] makes through points that vary, at parameters by a rule; none where
/// its slopes are not known.
///
/// # Errors
/// As for [`Interpolator::curve`].
///
/// ```
/// use virote_kernel::{Ends, Interpolator, Parametrization, PointSlopes, VariedCurve, interpolate_varied, glam::{DVec3, DVec4}};
///
/// // Points of a straight line, one of which moves along it: the spline stays what it is, and so does its length.
/// let points = [0.0, 1.0, 3.0, 4.0].map(|x| DVec3::X * x);
/// let rule = Parametrization::Chord;
/// let fit = Interpolator::new(&rule.parameters(&points)?, 3, Ends::Bessel)?;
/// let slopes = PointSlopes::new(1, 4, vec![(0, vec![DVec4::ZERO, DVec4::X, DVec4::ZERO, DVec4::ZERO])])?;
/// let varied: VariedCurve = interpolate_varied((&fit, Ends::Bessel), rule, &points, &slopes)?.expect("slopes");
/// let length = varied.length(varied.curve().domain())?;
/// assert!((length.value() - 4.0).abs() < 1e-14 && length.slopes()[0].abs() < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
pub fn interpolate_varied(
    (fit, ends): (&Interpolator, Ends),
    rule: Parametrization,
    points: &[DVec3],
    slopes: &PointSlopes,
) -> Result<Option<VariedCurve>, GeomError> {
    slopes.check_points(points.len())?;
    let parameters = rule.parameters(points)?;
    let values: Vec<DVec4> = points.iter().map(|point| point.extend(1.0)).collect();
    let Some(spline) = MovingSpline::new((fit, ends), &parameters, &values, [DVec4::ZERO; 2])?
    else {
        return Ok(None);
    };
    let curve = fit.curve(points)?;
    let Some(legs) = rule.leg_growths(points) else { return Ok(None) };
    if !slopes.are_asked_rather() {
        let Some(all) = spline_slopes(&spline, rule, points, slopes)? else { return Ok(None) };
        let variables = slopes.by_variable().iter().map(|(variable, _)| *variable);
        let by_variable = variables.zip(all).collect();
        return varied_on_own_knots(&spline, by_variable, slopes.n_variables(), curve);
    }
    let fixed = on_knots_twice(&spline)?;
    let spline = Arc::new(spline.into_owned());
    let (forward, points, given) = (spline.clone(), points.to_vec(), slopes.clone());
    let all = move || spline_slopes(&forward, rule, &points, &given).ok().flatten();
    let slopes = spline_slopes_asked(spline, legs, slopes, Box::new(all));
    Ok(Some(VariedCurve::new(fixed.into(), slopes)?.known_of_moving_knots(curve.into())))
}

/// The slopes of a spline through points that vary, at parameters by a rule that move with them: by each variable that moves
/// any. None where they are not known.
fn spline_slopes(
    spline: &MovingSpline<'_>,
    rule: Parametrization,
    points: &[DVec3],
    slopes: &PointSlopes,
) -> Result<Option<Vec<Vec<DVec4>>>, GeomError> {
    let by_rule = |(_, own): &(usize, Vec<DVec4>)| rule.speeds(points, &spline.parameters, own);
    let speeds: Option<Vec<Vec<f64>>> = slopes.by_variable().iter().map(by_rule).collect();
    let Some(speeds) = speeds else { return Ok(None) };
    let tangents = [DVec4::ZERO; 2];
    let pairs = speeds.iter().zip(slopes.by_variable());
    let all: Vec<SplineSpeeds<'_>> = pairs
        .map(|(parameters, (_, values))| SplineSpeeds { parameters, values, tangents })
        .collect();
    spline.slopes(&all).map(Some)
}

/// The spline over the knots that do not move.
fn on_knots_twice(spline: &MovingSpline<'_>) -> Result<NurbsCurve, GeomError> {
    let twice = with_knots_twice(&spline.fit.knots, vec![spline.points.clone()])?.concat();
    let polynomial = twice.into_iter().map(|point| point.truncate().extend(1.0)).collect();
    NurbsCurve::new(spline.by_knots.knots().clone(), polynomial)
}

/// The spline with the slopes of its control points over the knots that do not move, as what it is on its own.
fn varied_on_own_knots(
    spline: &MovingSpline<'_>,
    by_variable: Vec<(usize, Vec<DVec4>)>,
    n_variables: usize,
    own: NurbsCurve,
) -> Result<Option<VariedCurve>, GeomError> {
    let fixed = on_knots_twice(spline)?;
    let slopes = PointSlopes::new(n_variables, fixed.control_points().len(), by_variable)?;
    Ok(VariedCurve::new(fixed.into(), slopes)?.of_moving_knots(own.into()))
}

/// The cubic that [`Interpolator::periodic`] makes through points that vary, the first of which stands at the end again,
/// at parameters by a rule; none where its slopes are not known.
///
/// It is the one that is clamped by the tangent at its seam, where the second derivatives of both ends agree: so do
/// their slopes, which tells that of the tangent.
///
/// # Errors
/// As for [`Interpolator::periodic`].
///
/// ```
/// use virote_kernel::{Parametrization, PointSlopes, interpolate_varied_ring, glam::{DVec3, DVec4}};
///
/// // A square that grows about its centre: its length grows with it.
/// let corners = [DVec3::X, DVec3::Y, -DVec3::X, -DVec3::Y, DVec3::X];
/// let outward = corners.iter().map(|corner| corner.extend(0.0)).collect();
/// let slopes = PointSlopes::new(1, 5, vec![(0, outward)])?;
/// let varied = interpolate_varied_ring(Parametrization::Chord, &corners, &slopes)?.expect("slopes");
/// let length = varied.length(varied.curve().domain())?;
/// assert!((length.slopes()[0] - length.value()).abs() < 1e-12 * length.value());
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
pub fn interpolate_varied_ring(
    rule: Parametrization,
    points: &[DVec3],
    slopes: &PointSlopes,
) -> Result<Option<VariedCurve>, GeomError> {
    slopes.check_points(points.len())?;
    let parameters = rule.parameters(points)?;
    let around = &points[..points.len().saturating_sub(1)];
    let own = Interpolator::periodic(&parameters, CUBIC)?.curve(around)?;
    let (from, to) = (parameters[0], parameters[parameters.len() - 1]);
    let tangent = own.derivatives_at(from, 1)[1].extend(0.0);
    let fit = Interpolator::new(&parameters, CUBIC, Ends::Clamped)?;
    let values: Vec<DVec4> = points.iter().map(|point| point.extend(1.0)).collect();
    let spline = MovingSpline::new((&fit, Ends::Clamped), &parameters, &values, [tangent; 2])?;
    let Some(spline) = spline.filter(|_| own.degree() == CUBIC) else { return Ok(None) };
    let knots = spline.by_knots.knots();
    let bend =
        |points: &[DVec4]| derivative(knots, points, from, 2) - derivative(knots, points, to, 2);
    let still = vec![0.0; points.len()];
    let (rest, tangents) = (vec![DVec4::ZERO; points.len()], [DVec4::ONE; 2]);
    let by_tangent =
        spline.slopes(&[SplineSpeeds { parameters: &still, values: &rest, tangents }])?.concat();
    let bend_by_tangent = bend(&by_tangent);
    let Some(moved) = spline_slopes(&spline, rule, points, slopes)? else { return Ok(None) };
    let mut all = Vec::with_capacity(moved.len());
    for ((variable, _), mut own) in slopes.by_variable().iter().zip(moved) {
        let speed = -bend(&own) / bend_by_tangent;
        own.iter_mut().zip(&by_tangent).for_each(|(own, by_tangent)| *own += *by_tangent * speed);
        all.push((*variable, own));
    }
    varied_on_own_knots(&spline, all, slopes.n_variables(), own)
}
