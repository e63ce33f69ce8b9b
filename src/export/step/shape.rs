//! Geometry and topology. ISO 10303-42.

use glam::DVec3;

use super::{
    super::{ExportError, Item, Job},
    entity::{Id, Records},
};
use crate::kernel::{Grid, KnotVector, NurbsCurve, NurbsSurface, Tolerance};

/// The origin with the axes of space.
pub(super) fn placement(file: &mut Records) -> Id {
    let origin = point("", DVec3::ZERO, file);
    let [z, x] = [DVec3::Z, DVec3::X].map(|axis| {
        file.add(|r| {
            r.text("DIRECTION('',").place(axis).text(")");
        })
    });
    file.add(|r| {
        r.text("AXIS2_PLACEMENT_3D('',").id(origin).text(",").id(z).text(",").id(x).text(")");
    })
}

pub(super) fn point(name: &str, point: DVec3, file: &mut Records) -> Id {
    file.add(|r| {
        r.text("CARTESIAN_POINT(").string(name).text(",").place(point).text(")");
    })
}

/// A curve: a B-spline with knots, rational where its weights differ.
pub(super) fn curve(name: &str, curve: &NurbsCurve, file: &mut Records) -> Id {
    let points: Vec<Id> = curve.points().into_iter().map(|p| point("", p, file)).collect();
    let knots = curve.knots();
    let is_closed = curve.start() == curve.end();
    file.add(|r| {
        if !curve.is_rational() {
            r.text("B_SPLINE_CURVE_WITH_KNOTS(").string(name).text(",").count(curve.degree());
            r.text(",").ids(&points).text(",.UNSPECIFIED.,").truth(is_closed).text(",.F.,");
            multiplicities(knots, r);
            r.text(",");
            values(knots, r);
            r.text(",.UNSPECIFIED.)");
            return;
        }
        r.text("(BOUNDED_CURVE()B_SPLINE_CURVE(").count(curve.degree()).text(",").ids(&points);
        r.text(",.UNSPECIFIED.,").truth(is_closed).text(",.F.)B_SPLINE_CURVE_WITH_KNOTS(");
        multiplicities(knots, r);
        r.text(",");
        values(knots, r);
        r.text(",.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE(");
        r.list(&curve.weights(), |r, &weight| {
            r.real(weight);
        });
        r.text(")REPRESENTATION_ITEM(").string(name).text("))");
    })
}

fn multiplicities(knots: &KnotVector, r: &mut Records) {
    r.list(&knots.distinct(), |r, &(_, times)| {
        r.count(times);
    });
}

fn values(knots: &KnotVector, r: &mut Records) {
    r.list(&knots.distinct(), |r, &(at, _)| {
        r.real(at);
    });
}

fn rows<T: Copy>(grid: &Grid<T>, r: &mut Records, mut write: impl FnMut(&mut Records, &T)) {
    let rows: Vec<&[T]> = (0..grid.n_rows()).map(|i| grid.row(i)).collect();
    r.list(&rows, |r, row| {
        r.list(row, &mut write);
    });
}

fn surface(name: &str, surface: &NurbsSurface, closed: [bool; 2], file: &mut Records) -> Id {
    let points = surface.points().map(|&p| point("", p, file));
    let (knots_u, knots_v) = (surface.knots_u(), surface.knots_v());
    file.add(|r| {
        let degrees = |r: &mut Records| {
            r.count(surface.degree_u()).text(",").count(surface.degree_v()).text(",");
            rows(&points, r, |r, &id| {
                r.id(id);
            });
            r.text(",.UNSPECIFIED.,").truth(closed[0]).text(",").truth(closed[1]).text(",.F.");
        };
        let knots = |r: &mut Records| {
            multiplicities(knots_u, r);
            r.text(",");
            multiplicities(knots_v, r);
            r.text(",");
            values(knots_u, r);
            r.text(",");
            values(knots_v, r);
            r.text(",.UNSPECIFIED.");
        };
        if !surface.is_rational() {
            r.text("B_SPLINE_SURFACE_WITH_KNOTS(").string(name).text(",");
            degrees(r);
            r.text(",");
            knots(r);
            r.text(")");
            return;
        }
        r.text("(BOUNDED_SURFACE()B_SPLINE_SURFACE(");
        degrees(r);
        r.text(")B_SPLINE_SURFACE_WITH_KNOTS(");
        knots(r);
        r.text(")GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_SURFACE(");
        rows(&surface.weights(), r, |r, &weight| {
            r.real(weight);
        });
        r.text(")REPRESENTATION_ITEM(").string(name).text(")SURFACE())");
    })
}

/// A surface as the one face of an open shell, with its border lines as edges: a seam once, a pole
/// not at all. The model, and its face.
pub(super) fn model(
    item: &Item,
    geometry: &NurbsSurface,
    job: &Job,
    file: &mut Records,
) -> Result<(Id, Id), ExportError> {
    let same = Tolerance::DEFAULT.with_distance(job.precision);
    let same = same.distance_for(geometry.bounds().diagonal());
    let closed = [geometry.is_closed_u(same), geometry.is_closed_v(same)];
    let basis = surface(&item.name, geometry, closed, file);
    let border = border(geometry, closed, same, file);
    if border.is_empty() {
        let problem = "has no border lines: all of its edges are points".to_owned();
        return Err(ExportError::Unfit { name: item.name.clone(), problem });
    }
    let edges: Vec<Id> = border
        .into_iter()
        .map(|(edge, is_forward)| {
            file.add(|r| {
                r.text("ORIENTED_EDGE('',*,*,").id(edge).text(",").truth(is_forward).text(")");
            })
        })
        .collect();
    let edge_loop = file.add(|r| {
        r.text("EDGE_LOOP('',").ids(&edges).text(")");
    });
    let bound = file.add(|r| {
        r.text("FACE_OUTER_BOUND('',").id(edge_loop).text(",.T.)");
    });
    let face = file.add(|r| {
        r.text("ADVANCED_FACE(").string(&item.name).text(",(").id(bound).text("),").id(basis);
        r.text(",.T.)");
    });
    let shell = file.add(|r| {
        r.text("OPEN_SHELL('',(").id(face).text("))");
    });
    let model = file.add(|r| {
        r.text("SHELL_BASED_SURFACE_MODEL(").string(&item.name).text(",(").id(shell).text("))");
    });
    Ok((model, face))
}

/// The edges around a surface, counter-clockwise seen from its normal's side, and whether each
/// runs along its curve.
fn border(
    geometry: &NurbsSurface,
    [closed_u, closed_v]: [bool; 2],
    same: f64,
    file: &mut Records,
) -> Vec<(Id, bool)> {
    let [u0, u1, v0, v1] = geometry.edges();
    let mut vertices: Vec<(DVec3, Id)> = Vec::new();
    let mut vertex = |at: DVec3, file: &mut Records| match vertices
        .iter()
        .find(|(place, _)| place.distance(at) <= same)
    {
        Some(&(_, id)) => id,
        None => {
            let place = point("", at, file);
            let id = file.add(|r| {
                r.text("VERTEX_POINT('',").id(place).text(")");
            });
            vertices.push((at, id));
            id
        }
    };
    let mut edge = |line: &NurbsCurve, file: &mut Records| {
        if line.bounds().diagonal() <= same {
            return None;
        }
        let (from, to) = (vertex(line.start(), file), vertex(line.end(), file));
        let basis = curve("", line, file);
        Some(file.add(|r| {
            r.text("EDGE_CURVE('',").id(from).text(",").id(to).text(",").id(basis).text(",.T.)");
        }))
    };
    let along_v0 = edge(&v0, file);
    let along_u1 = edge(&u1, file);
    let along_v1 = if closed_v { along_v0 } else { edge(&v1, file) };
    let along_u0 = if closed_u { along_u1 } else { edge(&u0, file) };
    let way = [(along_v0, true), (along_u1, true), (along_v1, false), (along_u0, false)];
    way.into_iter().filter_map(|(edge, is_forward)| Some((edge?, is_forward))).collect()
}
