//! Derivatives of curves and surfaces whose control points are the points that they are made of: the slopes of
//! these, with nothing to be computed for each variable.

use std::sync::Arc;

use glam::{DVec3, DVec4};

use super::{Call, Op, Value, varies};
use crate::kernel::{Curve, Jet, PointSlopes, Surface, VariedCurve, VariedSurface};

/// A point that may carry derivatives.
enum ConstantOrVaried<'v> {
    Plain(DVec3),
    Varying(&'v [Jet; 3]),
}

impl ConstantOrVaried<'_> {
    fn value(&self) -> DVec3 {
        match self {
            Self::Plain(point) => *point,
            Self::Varying(jets) => DVec3::from(jets.each_ref().map(Jet::value)),
        }
    }

    /// How many variables it has slopes by; none of a series of a higher order.
    fn n_variables(&self) -> Option<usize> {
        match self {
            Self::Plain(_) => None,
            Self::Varying(jets) => jets[0].n_variables(),
        }
    }
}

/// The answer of an operation whose control points are its points, with their slopes; none where something else
/// in the call varies, or the answer has other control points.
#[must_use]
pub fn with_slopes_of_points(op: &Op, call: &Call, answer: &Value) -> Option<Value> {
    let points = points_of(op, call)?;
    Some(match answer {
        Value::Curve(Curve::Nurbs(curve)) => {
            let slopes = slopes(&points, curve.control_points())?;
            Value::JetCurve(Arc::new(VariedCurve::new(Arc::clone(curve), slopes).ok()?))
        }
        Value::Surface(Surface::Nurbs(surface)) => {
            let net = surface.control_points().as_slice();
            // The rows of a net that closes are longer than those of its points.
            let slopes = (net.len() == points.len()).then(|| slopes(&points, net)).flatten()?;
            Value::JetSurface(Arc::new(VariedSurface::new(Arc::clone(surface), slopes).ok()?))
        }
        _ => return None,
    })
}

/// The points of a call, one behind the other, unless something beside them varies.
fn points_of<'c>(op: &Op, call: &'c Call) -> Option<Vec<ConstantOrVaried<'c>>> {
    let name = op.params.first()?.name;
    let mut points = Vec::new();
    for (label, given) in &call.named {
        if &*label.value == name {
            flatten(&given.value, &mut points)?;
        } else if varies(&given.value) {
            return None;
        }
    }
    call.positional.iter().try_for_each(|given| flatten(&given.value, &mut points))?;
    Some(points)
}

/// Adds the points of a list to others; none where something else stands in it.
fn flatten<'v>(value: &'v Value, points: &mut Vec<ConstantOrVaried<'v>>) -> Option<()> {
    match value {
        Value::Point(point) => points.push(ConstantOrVaried::Plain(*point)),
        Value::JetPoint(jets) => points.push(ConstantOrVaried::Varying(jets)),
        Value::List(items) if items.numbers().is_none() => {
            items.iter().try_for_each(|item| flatten(item, points))?;
        }
        _ => return None,
    }
    Some(())
}

/// The slopes of control points that are these points, with weights of their own, and the first of them again where
/// there are more.
fn slopes(points: &[ConstantOrVaried<'_>], control_points: &[DVec4]) -> Option<PointSlopes> {
    let n_variables = points.iter().find_map(ConstantOrVaried::n_variables)?;
    let around = || control_points.iter().zip(points.iter().cycle());
    let is_own = |(control_point, point): (&DVec4, &ConstantOrVaried<'_>)| {
        *control_point == weighted(point.value(), control_point.w)
    };
    if control_points.len() < points.len() || !around().all(is_own) {
        return None;
    }
    let mut by_variable = vec![Vec::new(); n_variables];
    for (idx, (control_point, point)) in around().enumerate() {
        let ConstantOrVaried::Varying(jets) = point else { continue };
        let [x, y, z] = jets.each_ref().map(Jet::slopes);
        for (variable, own) in by_variable.iter_mut().enumerate() {
            let slope = DVec3::new(x[variable], y[variable], z[variable]);
            if slope != DVec3::ZERO {
                own.resize(control_points.len(), DVec4::ZERO);
                own[idx] = (slope * control_point.w).extend(0.0);
            }
        }
    }
    let moving = by_variable.into_iter().enumerate().filter(|(_, slopes)| !slopes.is_empty());
    PointSlopes::new(n_variables, control_points.len(), moving.collect()).ok()
}

/// The homogeneous point.
fn weighted(point: DVec3, weight: f64) -> DVec4 {
    (point * weight).extend(weight)
}
