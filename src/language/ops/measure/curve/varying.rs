//! Questions about a curve where its parameter or the curve itself carries derivatives: the formulas of the field, on the
//! truncated Taylor series of the curve's derivatives.
//!
//! The value of an answer, and what is refused, is that of the question at the plain parameter; the
//! derivatives come on top. do Carmo, *Differential Geometry of Curves and Surfaces*, §1-5; the functions
//! that equations define by Griewank & Walther, *Evaluating Derivatives*, §15.1: each step of Newton's
//! method on series, with the derivative at the place, makes one more order right.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{Curve, GeomError, Interval, Jet, LocalError, Side, tolerance::LAST_BIT},
    ops::measure::Measured,
    value::{At, CARRIES_DERIVATIVES, Real, RealCurve, Vector},
};

/// A parameter of a curve, inside its domain.
pub(super) fn inside(curve: &Curve, t: &Spanned<Real>) -> Result<Real> {
    let clamped = curve.domain().clamp_inside(t.value.value()).at(t.span)?;
    Ok(t.value.clone().with_value(clamped))
}

/// A number that a curve has at a parameter: that of the plain question, with the derivatives of a formula
/// of C, C', … up to an order.
pub(super) fn number(
    curve: &RealCurve,
    t: &Spanned<Real>,
    side: Side,
    plain: impl FnOnce(f64) -> Measured<f64>,
    (order, formula): (usize, impl FnOnce(&[Vector], f64) -> Measured<Real>),
) -> Result<Real> {
    let t = Spanned::new(inside(curve, t)?, t.span);
    let value = plain(t.value.value()).at(t.span)?;
    let Some(jet) = curve.jet_of(&t.value).at(t.span)? else { return Ok(Real::Plain(value)) };
    let found = curve.series_beside(&jet, side, order).and_then(|d| formula(&d, value));
    Ok(found.at(t.span)?.with_value(value))
}

/// A vector that a curve has at a parameter, as [`number`].
pub(super) fn vector(
    curve: &RealCurve,
    t: &Spanned<Real>,
    side: Side,
    plain: impl FnOnce(f64) -> Measured<DVec3>,
    (order, formula): (usize, impl FnOnce(&[Vector]) -> Measured<Vector>),
) -> Result<Vector> {
    let t = Spanned::new(inside(curve, t)?, t.span);
    let value = plain(t.value.value()).at(t.span)?;
    let Some(jet) = curve.jet_of(&t.value).at(t.span)? else { return Ok(Vector::Plain(value)) };
    let found = curve.series_beside(&jet, side, order).and_then(|d| formula(&d));
    Ok(found.at(t.span)?.with_value(value))
}

/// C'/|C'|.
pub(super) fn tangent(d: &[Vector]) -> Measured<Vector> {
    d[1].over(&d[1].norm()?)
}

/// The derivative of the tangent by arc length, (C''(C'·C') − C'(C'·C''))/(C'·C')².
pub(super) fn bending(d: &[Vector]) -> Measured<Vector> {
    let squared = d[1].dot(&d[1]);
    let across = d[2].times(&squared).minus(&d[1].times(&d[1].dot(&d[2])));
    across.over(&squared.times(&squared))
}

/// |C' × C''|/|C'|³; where it is zero it has derivatives only where the curve is straight all around.
pub(super) fn curvature(d: &[Vector], value: f64) -> Measured<Real> {
    if value == 0.0 {
        let bending = bending(d)?;
        let rounding = LAST_BIT.sqrt() * (d[1].over(&d[1].dot(&d[1]))?).magnitude();
        if bending.magnitude() <= rounding {
            return Ok(Real::Plain(0.0));
        }
    }
    let (axis, speed) = (d[1].cross(&d[2]), d[1].norm()?);
    // Beside an inflection the value is nothing but rounding, while its derivatives are well known.
    if axis.value() == DVec3::ZERO {
        return Err(GeomError::Local(LocalError::NotDifferentiable {
            what: "the curvature",
            at: 0.0,
        }));
    }
    axis.norm()?.over(&speed.times(&speed).times(&speed))
}

/// N = B × T; beside an inflection of a curve in a plane z = 0 exact, where the bending at length 1 is rounding.
pub(super) fn normal(d: &[Vector]) -> Measured<Vector> {
    Ok(binormal(d)?.cross(&tangent(d)?))
}

/// C' × C'' at length 1.
pub(super) fn binormal(d: &[Vector]) -> Measured<Vector> {
    let axis = d[1].cross(&d[2]);
    axis.over(&axis.norm()?)
}

/// C + N/κ.
pub(super) fn center_of_curvature(d: &[Vector]) -> Measured<Vector> {
    let bending = bending(d)?;
    Ok(d[0].plus(&bending.over(&bending.dot(&bending))?))
}

/// [C' C'' C‴]/|C' × C''|².
pub(super) fn torsion(d: &[Vector]) -> Measured<Real> {
    let axis = d[1].cross(&d[2]);
    axis.dot(&d[3]).over(&axis.dot(&axis))
}

/// The curvature with the sign of the turn about an axis, (C' × C'')·A/|C'|³ of a curve in a plane across it.
pub(super) fn signed_curvature(d: &[Vector], axis: DVec3, value: f64) -> Measured<Real> {
    let turn = d[1].cross(&d[2]);
    let axis = Vector::Plain(axis);
    let along = turn.dot(&axis);
    let is_plane =
        turn.minus(&axis.times(&along)).magnitude() <= LAST_BIT.sqrt() * turn.magnitude();
    if is_plane {
        let speed = d[1].norm()?;
        return along.over(&speed.times(&speed).times(&speed));
    }
    match value {
        0.0 => Err(GeomError::Local(LocalError::NotDifferentiable {
            what: "the signed curvature",
            at: 0.0,
        })),
        _ => Ok(bending(d)?.norm()?.scaled(value.signum())),
    }
}

/// The arc length up to a parameter that varies, which is `value` at its value: the integral of the series
/// of |C'|.
fn length_up_to(curve: &RealCurve, t: &Jet, value: f64) -> Measured<Jet> {
    check_speed(curve, t, t.value())?;
    let side = if t.is_growing() { Side::Right } else { Side::Left };
    let speeds = speeds(curve, t.value(), side, t.order())?;
    let mut series = vec![value];
    series.extend(speeds.iter().zip(1..).map(|(speed, k)| speed / f64::from(k)));
    t.compose(&series)
}

/// The first coefficients of the series of |C'| about a parameter.
fn speeds(curve: &RealCurve, t: f64, side: Side, n: usize) -> Measured<Vec<f64>> {
    let Some(order) = n.checked_sub(1) else { return Ok(Vec::new()) };
    let plain = RealCurve::from(Curve::clone(curve));
    let velocity = &plain.series_beside(&Jet::variable(t, order), side, 1)?[1];
    let speed = velocity.norm()?;
    let mut factorial = 1.0;
    let coefficient = |k: usize| {
        factorial *= k.max(1) as f64;
        speed.derivative(k, 0) / factorial
    };
    Ok((0..n).map(coefficient).collect())
}

/// # Errors
/// [`LocalError::NotDifferentiable`] where the speed jumps at a parameter that `jet` moves.
fn check_speed(curve: &RealCurve, jet: &Jet, t: f64) -> Measured<()> {
    if !jet.goes_both_ways() || curve.is_smooth_at(t, 1) {
        return Ok(());
    }
    let [before, behind] =
        [Side::Left, Side::Right].map(|side| curve.derivatives_beside(t, side, 1));
    let [before, behind] = [before?[1].length(), behind?[1].length()];
    match LAST_BIT.sqrt() * before.max(behind) < (before - behind).abs() {
        true => {
            Err(LocalError::NotDifferentiable { what: "the length along the curve", at: t }.into())
        }
        false => Ok(()),
    }
}

/// The arc length between two parameters, which is `value` between their values.
pub(super) fn length(curve: &RealCurve, [from, to]: [&Real; 2], value: f64) -> Measured<Real> {
    let up_to = |t: &Real, value: f64| match t {
        Real::Plain(_) => Ok(Real::Plain(value)),
        Real::Jet(jet) => length_up_to(curve, jet, value).map(Real::Jet),
    };
    let by_ends = up_to(to, value)?.minus(&up_to(from, 0.0)?);
    let Some(varied) = curve.varied() else { return Ok(by_ends.with_value(value)) };
    let by_curve = match Interval::new(from.value(), to.value()) {
        Ok(interval) => Real::Jet(varied.length(interval)?),
        Err(_) => Real::Plain(0.0),
    };
    Ok(by_ends.plus(&by_curve).with_value(value))
}

/// The parameter at an arc length from the start, which is `t` where neither the length nor the curve
/// varies.
pub(super) fn parameter_at_length(curve: &RealCurve, length: &Real, t: f64) -> Measured<Real> {
    let Some(like) = curve.jet_of(length)? else { return Ok(Real::Plain(t)) };
    let length = length.like(&like);
    check_speed(curve, &length, t)?;
    let side = if length.is_growing() { Side::Right } else { Side::Left };
    let speed = speeds(curve, t, side, 1)?.first().copied().unwrap_or(0.0);
    let start = Real::Plain(curve.domain().start());
    let mut found = length.same(t);
    for _ in 0..length.order() {
        let so_far = self::length(curve, [&start, &Real::Jet(found.clone())], length.value())?;
        let rest = so_far.like(&length).minus(&length);
        found = found.minus(&rest.over(&rest.same(speed))?).with_value(t);
    }
    Ok(Real::Jet(found))
}

/// The parameter of the nearest point where the curve or the point varies, which is `t` at their values: where
/// (C − P)·C' vanishes, or an end of the curve that it stays at.
pub(super) fn closest(curve: &RealCurve, p: &Vector, t: f64) -> Measured<Real> {
    let place = match p {
        Vector::Plain(_) => Real::Plain(t),
        Vector::Jets(jets) => Real::Jet(jets[0].same(t)),
    };
    let Some(like) = &curve.jet_of(&place)? else { return Ok(place) };
    let at_place = curve.derivatives_beside(t, Side::Right, 2)?;
    let way = at_place[0] - p.value();
    let (slope, speed) = (way.dot(at_place[1]), at_place[1].length());
    let (domain, rounding) = (curve.domain(), LAST_BIT.sqrt() * (speed * way.length()));
    let is_at_end =
        t <= domain.start() && rounding < slope || domain.end() <= t && slope < -rounding;
    if is_at_end {
        return Ok(Real::Jet(like.same(t)));
    }
    if !curve.is_smooth_at(t, 2) {
        let before = curve.derivatives_beside(t, Side::Left, 2)?;
        let arriving = way.dot(before[1]);
        // It stays at a corner that it is held at from both sides.
        if arriving < -LAST_BIT.sqrt() * (before[1].length() * way.length()) && rounding < slope {
            return Ok(Real::Jet(like.same(t)));
        }
        let bends = [&before, &at_place].map(|d| d[1].dot(d[1]) + way.dot(d[2]));
        let is_even = (bends[0] - bends[1]).abs() <= LAST_BIT.sqrt() * bends[0].abs();
        if !is_even || !curve.is_smooth_at(t, 1) {
            return Err(no_nearest(t));
        }
    }
    let bend = at_place[1].dot(at_place[1]) + way.dot(at_place[2]);
    if bend <= LAST_BIT.sqrt() * speed * speed {
        return Err(no_nearest(t));
    }
    let mut found = like.same(t);
    for _ in 0..like.order() {
        let d = curve.series_beside(&found, Side::Right, 1)?;
        let slope = d[0].minus(p).dot(&d[1]).like(like);
        found = found.minus(&slope.scaled(1.0 / bend)).with_value(t);
    }
    Ok(Real::Jet(found))
}

/// The largest coefficient of first order of some jets, without its sign.
fn largest_slope(jets: impl Iterator<Item = Jet>) -> f64 {
    jets.flat_map(|jet| jet.slopes().to_vec()).fold(0.0, |most: f64, slope| most.max(slope.abs()))
}

/// That no other place of the curve is as near as that at `t` and becomes so at another rate: beside such a place it is the
/// nearest one.
///
/// # Errors
/// [`LocalError::NotDifferentiable`].
pub(super) fn check_only(curve: &RealCurve, p: &Vector, t: f64) -> Measured<()> {
    let distance = |t: f64| -> Measured<Real> {
        let place = match p {
            Vector::Plain(_) => Real::Plain(t),
            Vector::Jets(jets) => Real::Jet(jets[0].same(t)),
        };
        match curve.jet_of(&place)? {
            Some(t) => curve.series_beside(&t, Side::Right, 0)?.remove(0).minus(p).norm(),
            None => Ok(Real::Plain(0.0)),
        }
    };
    // The first of the reversed curve is the last one.
    let (domain, point) = (curve.domain(), curve.point_at(t)?);
    let rounding = LAST_BIT * (p.value().abs().max_element() + point.abs().max_element());
    let last = curve.reversed()?.closest(p.value(), rounding)?;
    if point.distance(p.value()) + rounding < last.distance {
        return Ok(());
    }
    let other = domain.start() + (domain.end() - last.parameter);
    let other = other.clamp(domain.start(), domain.end());
    if last.point.distance(point) <= LAST_BIT.sqrt() * (last.distance + rounding) {
        return Ok(());
    }
    let (Real::Jet(one), Real::Jet(other)) = (distance(t)?, distance(other)?) else {
        return Ok(());
    };
    let part = largest_slope([one.minus(&other)].into_iter());
    let size = largest_slope([one, other].into_iter());
    match LAST_BIT.sqrt() * size < part {
        true => Err(no_nearest(t)),
        false => Ok(()),
    }
}

/// The parameters at which two curves cross where one of them varies, which are `place` at their values: where C − D
/// vanishes in the plane of both tangents.
pub(super) fn meeting(curves: [&RealCurve; 2], place: [f64; 2]) -> Measured<Option<[Jet; 2]>> {
    let jets =
        [curves[0].jet_of(&Real::Plain(place[0]))?, curves[1].jet_of(&Real::Plain(place[1]))?];
    let Some(like) = jets.into_iter().flatten().next() else { return Ok(None) };
    let [a, b] = [0, 1].map(|k| tangent_inside(curves[k], place[k]));
    let (a, b) = (a?, b?);
    let (aa, ab, bb) = (a.dot(a), a.dot(b), b.dot(b));
    let apart = aa * bb - ab * ab;
    if apart <= LAST_BIT.sqrt() * aa * bb {
        return Err(no_crossing(place[0]));
    }
    let mut found = place.map(|t| like.same(t));
    for _ in 0..like.order() {
        let c = curves[0].series_beside(&found[0], Side::Right, 0)?.remove(0);
        let d = curves[1].series_beside(&found[1], Side::Right, 0)?.remove(0);
        let gap = c.minus(&d);
        let along = |axis: DVec3| gap.dot(&Vector::Plain(axis)).like(&like);
        let steps = [(a * bb - b * ab) / apart, (a * ab - b * aa) / apart];
        for (k, step) in steps.into_iter().enumerate() {
            found[k] = found[k].minus(&along(step)).with_value(place[k]);
        }
    }
    Ok(Some(found))
}

/// The derivative at a place inside of a curve where it has no corner.
pub(in crate::ops::measure) fn tangent_inside(curve: &RealCurve, t: f64) -> Measured<DVec3> {
    let domain = curve.domain();
    let [before, behind] =
        [Side::Left, Side::Right].map(|side| curve.derivatives_beside(t, side, 1));
    let (before, behind) = (before?[1], behind?[1]);
    let is_inside = domain.start() < t && t < domain.end();
    let is_smooth = before.distance(behind) <= LAST_BIT.sqrt() * before.length();
    if is_inside && is_smooth { Ok(behind) } else { Err(no_crossing(t)) }
}

fn no_nearest(at: f64) -> GeomError {
    LocalError::NotDifferentiable { what: "the nearest place of the curve", at }.into()
}

fn no_crossing(at: f64) -> GeomError {
    LocalError::NotDifferentiable { what: "the place where the curves meet", at }.into()
}

/// Fails: no derivative passes through what is named.
pub(in crate::ops::measure) fn no_derivative<T>(what: &str, span: Span) -> Result<T> {
    let message = format!("{what}: no derivative passes through here, and derivatives are wanted");
    Diagnostic::error(Code::NoDerivative, span, message).hint(CARRIES_DERIVATIVES).fail()
}
