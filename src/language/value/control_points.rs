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
    let moving = around().enumerate().filter_map(|(idx, (control_point, point))| match point {
        ConstantOrVaried::Varying(jets) => Some((idx, *jets, control_point.w)),
        ConstantOrVaried::Plain(_) => None,
    });
    let by_variable = slopes_by_variable([n_variables, control_points.len()], moving);
    PointSlopes::new(n_variables, control_points.len(), by_variable).ok()
}

/// The slopes of so many points by those of so many variables that move any: of points with their places among these
/// and their weights.
pub fn slopes_by_variable<'j>(
    [n_variables, n_points]: [usize; 2],
    moving: impl Iterator<Item = (usize, &'j [Jet; 3], f64)>,
) -> Vec<(usize, Vec<DVec4>)> {
    let mut by_variable = vec![Vec::new(); n_variables];
    for (idx, jets, weight) in moving {
        for (axis, jet) in jets.iter().enumerate() {
            for (own, &slope) in by_variable.iter_mut().zip(jet.slopes()) {
                if slope != 0.0 {
                    own.resize(n_points, DVec4::ZERO);
                    own[idx][axis] = slope * weight;
                }
            }
        }
    }
    by_variable.into_iter().enumerate().filter(|(_, slopes)| !slopes.is_empty()).collect()
}

/// The homogeneous point.
fn weighted(point: DVec3, weight: f64) -> DVec4 {
    (point * weight).extend(weight)
}
