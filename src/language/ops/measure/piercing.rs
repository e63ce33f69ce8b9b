//! Where a curve meets a surface, with derivatives where one of them varies.
//!
//! The functions that the equation C(t) = S(u, v) defines: Griewank & Walther, *Evaluating Derivatives*, §15.1.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::{Measured, curve::varying::tangent_inside};
use crate::{
    diag::Result,
    kernel::{CurveSurfaceIntersection, GeomError, Jet, LocalError, Side, tolerance::LAST_BIT},
    ops::face::RealSurfaceOrFace,
    value::{At, Ctx, IntoValue, Real, RealCurve, RealSurface, Record, Value, Vector},
};

/// The places of a curve on a surface, as scripts see them.
pub(super) fn pierced(
    ctx: &Ctx<'_>,
    curve: &RealCurve,
    surface: &RealSurfaceOrFace,
) -> Result<Vec<Record>> {
    let places = surface.piercings(curve, ctx.tolerance).at(ctx.span)?;
    let places = places.into_iter().filter(|place| surface.has(place.uv, ctx.tolerance));
    places.map(|place| record(curve, surface.real(), &place).at(ctx.span)).collect()
}

fn record(
    curve: &RealCurve,
    surface: &RealSurface,
    place: &CurveSurfaceIntersection,
) -> Measured<Record> {
    let [u, v] = place.uv;
    let (parameters, point) = match varying(curve, surface, [place.t, u, v])? {
        None => ([place.t, u, v].map(Value::number), Value::Point(place.point)),
        Some(jets) => {
            let point = curve.series_beside(&jets[0], Side::Right, 0)?.remove(0);
            let parameters = jets.map(|jet| Real::Jet(jet).into_value());
            (parameters, point.with_value(place.point).into_value())
        }
    };
    let [t, u, v] = parameters;
    let labels = ["t", "u", "v", "point"].map(Arc::from);
    Ok(Record::new(labels.into_iter().zip([t, u, v, point])))
}

/// The parameters of the curve and of the surface at a place where they cross, which are `place` at their values; none
/// where neither varies.
///
/// # Errors
/// [`LocalError::NotDifferentiable`] where the curve touches the surface or one of them ends or bends sharply.
fn varying(
    curve: &RealCurve,
    surface: &RealSurface,
    place: [f64; 3],
) -> Measured<Option<[Jet; 3]>> {
    let [t, u, v] = place;
    let by_curve = curve.jet_of(&Real::Plain(t))?;
    let by_surface = surface.jets_of([&Real::Plain(u), &Real::Plain(v)], None)?;
    let Some(like) = by_curve.or_else(|| by_surface.map(|[jet, _]| jet)) else { return Ok(None) };
    let along = tangent_inside(curve, t)?;
    if !surface.is_smooth_around(u, v) {
        return Err(no_crossing(t));
    }
    let d = surface.derivatives_at(u, v, 1)?;
    let matrix = DMat3::from_cols(along, -d.get(1, 0), -d.get(0, 1));
    let size = along.length() * d.get(1, 0).length() * d.get(0, 1).length();
    if matrix.determinant().abs() <= LAST_BIT.sqrt() * size {
        return Err(no_crossing(t));
    }
    let steps = matrix.inverse().transpose();
    let mut found = place.map(|parameter| like.same(parameter));
    for _ in 0..like.order() {
        let on_curve = curve.series_beside(&found[0], Side::Right, 0)?.remove(0);
        let on_surface = surface.series_at([&found[1], &found[2]], 0)?.row(0)[0].clone();
        let gap = on_curve.minus(&on_surface);
        let step = |axis: DVec3| gap.dot(&Vector::Plain(axis)).like(&like);
        found = [0, 1, 2].map(|k| found[k].minus(&step(steps.col(k))).with_value(place[k]));
    }
    Ok(Some(found))
}

fn no_crossing(at: f64) -> GeomError {
    LocalError::NotDifferentiable { what: "the place where the curve meets the surface", at }.into()
}
