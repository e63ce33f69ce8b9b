//! Geometry and topology. ISO 10303-42.

use std::f64::consts::TAU;

use glam::DVec3;

use super::{
    super::{ExportError, Item, Job},
    entity::{Id, Records},
    form,
    place::point,
};
use crate::kernel::{
    AnalyticCurve, AnalyticForm, FaceChart, Grid, KnotVector, NurbsCurve, NurbsSurface, Tolerance,
    sorting::sort_by,
};

/// An edge along a curve alone.
fn edge_in_space(curve: &NurbsCurve, ends: [Id; 2], file: &mut Records) -> Id {
    let (basis, _) = basis(curve, ends, file);
    edge_along(basis, ends, file)
}

/// A curve in space by its equation, which is told then, or as a B-spline.
pub(super) fn basis(
    curve: &NurbsCurve,
    [from, to]: [Id; 2],
    file: &mut Records,
) -> (Id, Option<AnalyticCurve>) {
    let analytic = curve.analytic().filter(|found| is_whole(found) == (from == to));
    let basis = match &analytic {
        Some(found) => form::unbounded("", found, file),
        None => spline("", curve, file),
    };
    (basis, analytic)
}

/// An edge along what is known of its curve.
pub(super) fn edge_along(basis: Id, [from, to]: [Id; 2], file: &mut Records) -> Id {
    file.add(|r| {
        r.text("EDGE_CURVE('',").id(from).text(",").id(to).text(",").id(basis).text(",.T.)");
    })
}

/// A curve: a line or an arc where it is one, else a B-spline.
pub(super) fn curve(name: &str, curve: &NurbsCurve, file: &mut Records) -> Id {
    match curve.analytic() {
        Some(found) => form::bounded(name, &found, file),
        None => spline(name, curve, file),
    }
}

/// A B-spline with knots, rational where its weights differ.
pub(super) fn spline(name: &str, curve: &NurbsCurve, file: &mut Records) -> Id {
    spline_through(name, curve, |at, file| point("", at, file), file)
}

/// The same with control points that are written in another way.
pub(super) fn spline_through(
    name: &str,
    curve: &NurbsCurve,
    mut write: impl FnMut(DVec3, &mut Records) -> Id,
    file: &mut Records,
) -> Id {
    let points: Vec<Id> = curve.points().into_iter().map(|p| write(p, file)).collect();
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

/// A surface as the one face of an open shell, with its border lines as edges: a seam once, that
/// of a plane and a pole not at all. The model, and its face.
pub(super) fn model(
    item: &Item,
    geometry: &NurbsSurface,
    job: &Job,
    file: &mut Records,
) -> Result<(Id, Id), ExportError> {
    let same = Tolerance::DEFAULT.with_distance(job.precision);
    let same = same.distance_for(geometry.bounds().diagonal());
    let closed = [geometry.is_closed_u(same), geometry.is_closed_v(same)];
    let carrier = carrier(&item.name, geometry, same, file);
    let edges = BorderEdges { same, vertices: Vec::new() };
    let bounds = FaceBound { closed, is_flat: carrier.is_flat, edges }.bounds(geometry, file);
    if bounds.is_empty() {
        let problem = "has no border lines: all of its edges are points".to_owned();
        return Err(ExportError::Unfit { name: item.name.clone(), problem });
    }
    let face = face(&item.name, &bounds, &carrier, file);
    Ok((shell(&item.name, &[face], file), face))
}

/// The surface of faces.
pub(super) struct Carrier<'a> {
    pub(super) id: Id,
    /// How it has parameters; those of a plane nobody needs.
    pub(super) chart: Option<FaceChart<'a>>,
    /// Whether its normal is that of the parametrization.
    is_outward: bool,
    is_flat: bool,
    pub(super) is_sphere: bool,
}

/// A surface without borders: by its equation where it has one.
pub(super) fn carrier<'a>(
    name: &str,
    geometry: &'a NurbsSurface,
    same: f64,
    file: &mut Records,
) -> Carrier<'a> {
    let chart = |equation| FaceChart { surface: geometry, equation };
    match geometry.analytic(same) {
        Some(found) => Carrier {
            id: form::surface(name, &found, file),
            chart: (found.form != AnalyticForm::Plane)
                .then(|| chart(Some(geometry.analytic_chart(&found)))),
            is_outward: found.is_outward,
            is_flat: found.form == AnalyticForm::Plane,
            is_sphere: matches!(found.form, AnalyticForm::Sphere { .. }),
        },
        None => {
            let closed = [geometry.is_closed_u(same), geometry.is_closed_v(same)];
            Carrier {
                id: surface(name, geometry, closed, file),
                chart: Some(chart(None)),
                is_outward: true,
                is_flat: false,
                is_sphere: false,
            }
        }
    }
}

/// A face within its bounds.
pub(super) fn face(name: &str, bounds: &[Id], carrier: &Carrier<'_>, file: &mut Records) -> Id {
    file.add(|r| {
        r.text("ADVANCED_FACE(").string(name).text(",").ids(bounds).text(",").id(carrier.id);
        r.text(",").truth(carrier.is_outward).text(")");
    })
}

/// A model of the faces of one open shell.
pub(super) fn shell(name: &str, faces: &[Id], file: &mut Records) -> Id {
    let shell = file.add(|r| {
        r.text("OPEN_SHELL('',").ids(faces).text(")");
    });
    file.add(|r| {
        r.text("SHELL_BASED_SURFACE_MODEL(").string(name).text(",(").id(shell).text("))");
    })
}

/// What bounds a face.
struct FaceBound {
    /// Whether the edges at both ends of u, of v, are one.
    closed: [bool; 2],
    /// Whether it is in a plane, where no seam is needed.
    is_flat: bool,
    edges: BorderEdges,
}

/// Edges with their vertices.
pub(super) struct BorderEdges {
    /// Points nearer than this are one.
    pub(super) same: f64,
    pub(super) vertices: Vec<(DVec3, Id)>,
}

impl FaceBound {
    /// The edges around a surface, counter-clockwise seen from its normal's side, in one loop; of
    /// a plane with a hole in two, the outer one first.
    fn bounds(mut self, geometry: &NurbsSurface, file: &mut Records) -> Vec<Id> {
        let [u0, u1, v0, v1] = geometry.edges();
        let [closed_u, closed_v] = self.closed;
        let is_seam = [closed_u && self.is_flat, closed_v && self.is_flat];
        let along_v0 = if is_seam[1] { None } else { self.edge(&v0, file) };
        let along_u1 = if is_seam[0] { None } else { self.edge(&u1, file) };
        let along_v1 = if closed_v { along_v0 } else { self.edge(&v1, file) };
        let along_u0 = if closed_u { along_u1 } else { self.edge(&u0, file) };
        let way = [(along_v0, &v0), (along_u1, &u1), (along_v1, &v1), (along_u0, &u0)];
        let mut edges: Vec<(Id, &NurbsCurve)> = Vec::new();
        for (i, (edge, line)) in way.into_iter().enumerate() {
            let Some(edge) = edge else { continue };
            edges.push((oriented(edge, i < 2, file), line));
        }
        if !(is_seam[0] || is_seam[1]) {
            let edges: Vec<Id> = edges.into_iter().map(|(edge, _)| edge).collect();
            return if edges.is_empty() { edges } else { vec![bound(true, &edges, file)] };
        }
        let size = |line: &NurbsCurve| line.bounds().diagonal();
        sort_by(&mut edges, |(_, a), (_, b)| size(b).total_cmp(&size(a)));
        edges.iter().enumerate().map(|(i, &(edge, _))| bound(i == 0, &[edge], file)).collect()
    }

    /// The edge along a line; none along a point.
    fn edge(&mut self, line: &NurbsCurve, file: &mut Records) -> Option<Id> {
        (self.edges.same < line.bounds().diagonal()).then(|| self.edges.edge(line, file))
    }
}

impl BorderEdges {
    /// The edge along a line.
    fn edge(&mut self, line: &NurbsCurve, file: &mut Records) -> Id {
        let ends = self.ends(line, file);
        edge_in_space(line, ends, file)
    }

    /// The vertices where a line starts and ends.
    pub(super) fn ends(&mut self, line: &NurbsCurve, file: &mut Records) -> [Id; 2] {
        [line.start(), line.end()].map(|end| self.vertex(end, file))
    }

    fn vertex(&mut self, at: DVec3, file: &mut Records) -> Id {
        let known = self.vertices.iter().find(|(place, _)| place.distance(at) <= self.same);
        if let Some(&(_, id)) = known {
            return id;
        }
        let id = vertex(at, file);
        self.vertices.push((at, id));
        id
    }
}

pub(super) fn vertex(at: DVec3, file: &mut Records) -> Id {
    let place = point("", at, file);
    file.add(|r| {
        r.text("VERTEX_POINT('',").id(place).text(")");
    })
}

/// Whether it is all of a circle, which has one vertex.
fn is_whole(curve: &AnalyticCurve) -> bool {
    matches!(curve, AnalyticCurve::Circle { turn, .. } if TAU <= *turn)
}

/// An edge that is gone along, or back.
pub(super) fn oriented(edge: Id, is_along: bool, file: &mut Records) -> Id {
    file.add(|r| {
        r.text("ORIENTED_EDGE('',*,*,").id(edge).text(",").truth(is_along).text(")");
    })
}

pub(super) fn bound(is_outer: bool, edges: &[Id], file: &mut Records) -> Id {
    let edge_loop = file.add(|r| {
        r.text("EDGE_LOOP('',").ids(edges).text(")");
    });
    file.add(|r| {
        r.text(if is_outer { "FACE_OUTER_BOUND" } else { "FACE_BOUND" });
        r.text("('',").id(edge_loop).text(",.T.)");
    })
}
