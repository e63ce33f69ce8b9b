//! Edges with their curves of parameters on the surfaces that they are edges of. ISO 10303-42, §4.4.
//!
//! Who reads an edge without them looks for it on the surface by its own means, within its own tolerance.

use glam::DVec3;

use super::{
    entity::{Id, Records},
    shape::{Carrier, basis, edge_along, spline_through},
};
use crate::kernel::{AnalyticCurve, EdgePath, GeomError, NurbsCurve, ParameterArc};

/// A face beside an edge: its surface, and the edge by the parameters of that, from its start to its end.
pub(super) struct EdgeSide<'a> {
    pub(super) carrier: &'a Carrier<'a>,
    pub(super) arc: ParameterArc,
}

/// An edge along a curve between two vertices, with the curves of parameters of both of its sides where it has some.
/// These keep to it within a quarter of `distance`.
///
/// # Errors
/// Those of a search that was ended.
pub(super) fn edge_curve(
    curve: &NurbsCurve,
    ends: [Id; 2],
    sides: &[EdgeSide<'_>],
    distance: f64,
    file: &mut Records,
) -> Result<Id, GeomError> {
    let (basis, analytic) = basis(curve, ends, file);
    let path = EdgePath::new(curve, analytic);
    let mut written = Vec::with_capacity(sides.len());
    for side in sides {
        let Some(chart) = &side.carrier.chart else { continue };
        if let Some(found) = chart.along(&side.arc, &path, distance)? {
            let own = parameter_curve(&found, analytic.as_ref(), file);
            written.push((side.carrier.id, on_surface(side.carrier.id, own, file)));
        }
    }
    if written.is_empty() {
        return Ok(edge_along(basis, ends, file));
    }
    let is_seam = matches!(&written[..], [one, other] if one.0 == other.0);
    let ids: Vec<Id> = written.iter().map(|&(_, id)| id).collect();
    let basis = file.add(|r| {
        r.text(if is_seam { "SEAM_CURVE" } else { "SURFACE_CURVE" });
        r.text("('',").id(basis).text(",").ids(&ids).text(",.CURVE_3D.)");
    });
    Ok(edge_along(basis, ends, file))
}

/// A curve in the plane of parameters: a line where it is one and the edge has an equation, which goes evenly too.
fn parameter_curve(curve: &NurbsCurve, edge: Option<&AnalyticCurve>, file: &mut Records) -> Id {
    if edge.is_none() || curve.degree() != 1 || curve.control_points().len() != 2 {
        return spline_through("", curve, in_plane, file);
    }
    let (start, way) = (curve.start(), curve.end() - curve.start());
    let speed = way.length() / curve.domain().length();
    let from = in_plane(start, file);
    let along = way.normalize_or(DVec3::X);
    let along = file.add(|r| {
        r.text("DIRECTION('',").pair(along).text(")");
    });
    let vector = file.add(|r| {
        r.text("VECTOR('',").id(along).text(",").real(speed).text(")");
    });
    file.add(|r| {
        r.text("LINE('',").id(from).text(",").id(vector).text(")");
    })
}

/// A point in the plane of parameters.
fn in_plane(at: DVec3, file: &mut Records) -> Id {
    file.add(|r| {
        r.text("CARTESIAN_POINT('',").pair(at).text(")");
    })
}

/// A curve of parameters on a surface.
fn on_surface(surface: Id, curve: Id, file: &mut Records) -> Id {
    let context = file.plane_of_parameters();
    let defined = file.add(|r| {
        r.text("DEFINITIONAL_REPRESENTATION('',(").id(curve).text("),").id(context).text(")");
    });
    file.add(|r| {
        r.text("PCURVE('',").id(surface).text(",").id(defined).text(")");
    })
}
