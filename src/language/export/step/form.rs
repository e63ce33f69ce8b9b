//! Lines, circles, planes and surfaces of revolution by their equations. ISO 10303-42, §4.4.

use std::f64::consts::TAU;

use super::{
    entity::{Id, Records},
    place::{direction, placement, point},
};
use crate::kernel::{AnalyticCurve, AnalyticForm, AnalyticSurface};

/// A line or a circle without ends.
pub(super) fn unbounded(name: &str, curve: &AnalyticCurve, file: &mut Records) -> Id {
    match *curve {
        AnalyticCurve::Line { start, direction: along, .. } => {
            let from = point("", start, file);
            let along = direction(along, file);
            let vector = file.add(|r| {
                r.text("VECTOR('',").id(along).text(",1.)");
            });
            file.add(|r| {
                r.text("LINE(").string(name).text(",").id(from).text(",").id(vector).text(")");
            })
        }
        AnalyticCurve::Circle { frame, radius, .. } => {
            let placement = placement(frame, file);
            file.add(|r| {
                r.text("CIRCLE(").string(name).text(",").id(placement).text(",").real(radius);
                r.text(")");
            })
        }
    }
}

/// A line or an arc between its ends, or a whole circle.
pub(super) fn bounded(name: &str, curve: &AnalyticCurve, file: &mut Records) -> Id {
    let last = match *curve {
        AnalyticCurve::Line { length, .. } => length,
        AnalyticCurve::Circle { turn, .. } if turn < TAU => turn,
        AnalyticCurve::Circle { .. } => return unbounded(name, curve, file),
    };
    let basis = unbounded("", curve, file);
    file.add(|r| {
        r.text("TRIMMED_CURVE(").string(name).text(",").id(basis);
        r.text(",(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(").real(last);
        r.text(")),.T.,.PARAMETER.)");
    })
}

/// A surface without borders.
pub(super) fn surface(name: &str, surface: &AnalyticSurface, file: &mut Records) -> Id {
    let (kind, sizes) = match surface.form {
        AnalyticForm::Plane => ("PLANE", Vec::new()),
        AnalyticForm::Cylinder { radius } => ("CYLINDRICAL_SURFACE", vec![radius]),
        AnalyticForm::Cone { radius, half_angle } => ("CONICAL_SURFACE", vec![radius, half_angle]),
        AnalyticForm::Sphere { radius } => ("SPHERICAL_SURFACE", vec![radius]),
        AnalyticForm::Torus { major, minor } => ("TOROIDAL_SURFACE", vec![major, minor]),
    };
    let placement = placement(surface.frame, file);
    file.add(|r| {
        r.text(kind).text("(").string(name).text(",").id(placement);
        for size in sizes {
            r.text(",").real(size);
        }
        r.text(")");
    })
}
