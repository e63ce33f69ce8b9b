//! A shape as the page draws it: its triangles, lines and points, with what analyses need at each.

use std::sync::Arc;

use glam::DVec3;
use serde_json::{Map, Value as Json, json};

use super::{
    bytes::{ItemWriter, digest, numbers_of},
    parts::Shape,
};
use crate::{
    export::N_ISOCURVES,
    kernel::{
        Bounds, Curve, Direction, GeomError, Interval, Mesh, NurbsCurve, Side, Surface, Tolerance,
        tessellation_parameters, tolerance::DRAWING_DIGIT,
    },
};

/// How fine what is drawn is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Fineness {
    /// How far triangles and polylines may be from what they stand for.
    pub(crate) chord: f64,
    /// How far normals at the corners of a triangle may turn from one another, in radians.
    pub(crate) angle: f64,
    /// Points that are no further apart are one.
    pub(crate) weld: f64,
    /// Vertices of one item.
    pub(crate) most: usize,
}

/// An item as it is sent.
#[derive(Debug)]
pub(crate) struct EncodedItem {
    pub(crate) bytes: Arc<Vec<u8>>,
    /// What there is to tell about it: sizes and degrees.
    pub(crate) facts: Map<String, Json>,
    pub(crate) bounds: Option<Bounds>,
    /// What of it is not drawn, and why.
    pub(crate) trouble: Option<String>,
}

impl EncodedItem {
    /// A key that stands for its bytes, whatever they were made from.
    pub(super) fn key(&self) -> Arc<str> {
        format!("{:032x}", digest(&self.bytes)).into()
    }

    /// The parameters of each vertex of a surface.
    pub(crate) fn parameters(&self) -> Option<Vec<[f64; 2]>> {
        let numbers = numbers_of(&self.bytes, "parameters", 2)?;
        Some(numbers.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect())
    }
}

/// Points of a curve that its comb needs at least.
const N_COMB: usize = 96;

/// The same of a line of equal parameter.
pub(super) const N_ISOCOMB: usize = 32;

/// The item of a shape, whose surfaces have this mesh.
///
/// # Errors
/// Where it has no points that could be drawn.
pub(super) fn encoded(
    shape: &Shape,
    mesh: Option<Mesh>,
    fineness: &Fineness,
) -> Result<EncodedItem, GeomError> {
    let mut item = EncodingItem::new(shape, N_ISOCURVES, fineness);
    item.add_snaps(shape);
    match shape {
        Shape::Points(points) => {
            item.add_points(points);
        }
        Shape::Curve(curve) => item.add_curve(curve)?,
        Shape::Curves(curves) => item.add_curves(curves)?,
        Shape::Mesh(mesh) | Shape::Region(_, mesh) => {
            item.add_mesh(mesh);
            item.add_mesh_edges(mesh);
        }
        Shape::Surface(surface) => {
            let mesh = Arc::new(mesh.unwrap_or_default());
            item.add_mesh(&mesh);
            item.add_curvatures(surface, &mesh);
            item.add_surface_lines(std::slice::from_ref(surface))?;
            item.add_net(surface);
        }
        Shape::Face(face) => {
            let mesh = Arc::new(mesh.unwrap_or_default());
            let surface = Surface::Nurbs(Arc::clone(face.surface()));
            item.add_mesh(&mesh);
            item.add_curvatures(&surface, &mesh);
            item.add_face_lines(face)?;
            item.add_net(&surface);
        }
        Shape::Surfaces(surfaces) => {
            let mesh = Arc::new(mesh.unwrap_or_default());
            item.add_mesh(&mesh);
            item.add_surface_lines(surfaces)?;
            item.facts.insert("surfaces".to_owned(), json!(surfaces.len()));
        }
    }
    let EncodingItem { writer, facts, trouble, .. } = item;
    let bounds = shape.bounds();
    Ok(EncodedItem { bytes: Arc::new(writer.finish()), facts, bounds, trouble })
}

/// The item of a shape that cannot be drawn, with the reason.
pub(super) fn empty(shape: &Shape, why: &str) -> EncodedItem {
    let bounds = shape.bounds();
    let mut writer = ItemWriter::new(shape.kind(), bounds.map_or(DVec3::ZERO, Bounds::center));
    writer.set("trouble", json!(why));
    EncodedItem {
        bytes: Arc::new(writer.finish()),
        facts: facts_of(shape),
        bounds,
        trouble: Some(why.to_owned()),
    }
}

/// What can be told of a shape without its triangles.
pub(super) fn facts_of(shape: &Shape) -> Map<String, Json> {
    let mut facts = Map::new();
    let mut tell = |name: &str, value: Json| facts.insert(name.to_owned(), value);
    match shape {
        Shape::Surface(Surface::Nurbs(surface)) => {
            let net = surface.points();
            tell("degree", json!(format!("{} x {}", surface.degree_u(), surface.degree_v())));
            tell("controlPoints", json!(format!("{} x {}", net.n_rows(), net.n_columns())));
            tell("rational", json!(surface.is_rational()));
        }
        Shape::Face(face) => {
            let surface = face.surface();
            tell("degree", json!(format!("{} x {}", surface.degree_u(), surface.degree_v())));
        }
        Shape::Surface(Surface::Parametric(_)) => {
            tell("form", json!("parametric"));
        }
        Shape::Surfaces(surfaces) => {
            tell("surfaces", json!(surfaces.len()));
        }
        Shape::Mesh(mesh) | Shape::Region(_, mesh) => {
            tell("triangles", json!(mesh.n_triangles()));
            tell("points", json!(mesh.n_vertices()));
        }
        _ => {}
    }
    facts
}

/// An item in the making.
pub(super) struct EncodingItem {
    pub(super) writer: ItemWriter,
    facts: Map<String, Json>,
    pub(super) size: f64,
    pub(super) fineness: Fineness,
    pub(super) trouble: Option<String>,
    /// Lines of equal parameter in each direction.
    pub(super) n_isocurves: usize,
}

impl EncodingItem {
    pub(super) fn new(shape: &Shape, n_isocurves: usize, fineness: &Fineness) -> Self {
        let bounds = shape.bounds();
        Self {
            writer: ItemWriter::new(shape.kind(), bounds.map_or(DVec3::ZERO, Bounds::center)),
            facts: Map::new(),
            size: bounds.map_or(0.0, Bounds::diagonal),
            fineness: *fineness,
            trouble: None,
            n_isocurves,
        }
    }

    fn add_fact(&mut self, name: &str, value: Json) {
        self.facts.insert(name.to_owned(), value);
    }

    fn add_points(&mut self, points: &[DVec3]) {
        let positions = self.writer.places(points);
        self.writer.set("positions", positions);
        self.add_fact("points", json!(points.len()));
    }

    /// The triangles with what is known at their corners.
    fn add_mesh(&mut self, mesh: &Mesh) {
        let positions = self.writer.places(mesh.vertices());
        self.writer.set("positions", positions);
        if !mesh.normals().is_empty() {
            let normals = self.writer.vectors(mesh.normals());
            self.writer.set("normals", normals);
        }
        if !mesh.uvs().is_empty() {
            let pairs: Vec<f64> = mesh.uvs().iter().flat_map(|uv| [uv.x, uv.y]).collect();
            let parameters = self.writer.numbers(2, &pairs);
            self.writer.set("parameters", parameters);
        }
        if !mesh.colors().is_empty() {
            let colors = self.writer.colors(mesh.colors());
            self.writer.set("colors", colors);
        }
        let triangles = self.writer.triangles(mesh.triangles());
        self.writer.set("triangles", triangles);
        self.add_fact("triangles", json!(mesh.n_triangles()));
        self.add_fact("points", json!(mesh.n_vertices()));
    }

    /// The edges of faces that are no triangles, whose edges the page finds; but of meshes whose colours
    /// they would cover.
    fn add_mesh_edges(&mut self, mesh: &Mesh) {
        if mesh.colors().is_empty() && mesh.n_faces() < mesh.n_triangles() {
            let ends = mesh.face_edges().into_iter().flatten();
            let ends: Vec<DVec3> = ends.map(|end| mesh.vertices()[end as usize]).collect();
            let segments = self.writer.places(&ends);
            self.writer.set("segments", segments);
        }
    }

    /// The exact principal curvatures at the corners of the triangles.
    fn add_curvatures(&mut self, surface: &Surface, mesh: &Mesh) {
        let at = |u: f64, v: f64| surface.shape_at(u, v).map(|shape| shape.curvatures());
        let pairs = mesh.uvs().iter().flat_map(|uv| at(uv.x, uv.y).unwrap_or([f64::NAN; 2]));
        let pairs: Vec<f64> = pairs.collect();
        let curvatures = self.writer.numbers(2, &pairs);
        self.writer.set("curvatures", curvatures);
    }

    /// The edges of surfaces where they end, and lines of equal parameter inside.
    pub(super) fn add_surface_lines(&mut self, surfaces: &[Surface]) -> Result<(), GeomError> {
        let (mut edges, mut isocurves, mut isocombs) = (Vec::new(), Vec::new(), Vec::new());
        for surface in surfaces {
            let same = DRAWING_DIGIT * self.size;
            for along in Direction::BOTH {
                let (domain, is_closed) = match along {
                    Direction::U => (surface.domain_u(), surface.is_closed_u(same)?),
                    Direction::V => (surface.domain_v(), surface.is_closed_v(same)?),
                };
                let steps = domain.steps(self.n_isocurves + 1);
                for (i, &at) in steps.iter().enumerate() {
                    let is_end = i == 0 || i + 1 == steps.len();
                    let line = match along {
                        Direction::U => surface.isocurve_u(at)?,
                        Direction::V => surface.isocurve_v(at)?,
                    };
                    // A line that is a point is a pole, and not drawn; nor is a seam drawn twice.
                    let is_point = line.bounds()?.diagonal() <= same;
                    if is_point || (is_end && is_closed && i != 0) {
                        continue;
                    }
                    if is_end && !is_closed {
                        let points = self.polyline(&line)?.1;
                        edges.push(self.writer.places(&points));
                        continue;
                    }
                    let (parameters, points) = self.finely(&line, N_ISOCOMB)?;
                    isocurves.push(self.writer.places(&points));
                    let bends: Vec<DVec3> = parameters.iter().map(|&t| bending(&line, t)).collect();
                    isocombs.push(self.writer.vectors(&bends));
                }
            }
        }
        self.writer.set("edges", edges.into());
        self.writer.set("isocurves", isocurves.into());
        self.writer.set("isocombs", isocombs.into());
        Ok(())
    }

    /// The control net and the knots, where there are such.
    fn add_net(&mut self, surface: &Surface) {
        let Surface::Nurbs(surface) = surface else {
            self.add_fact("form", json!("parametric"));
            return;
        };
        let net = surface.points();
        let size = [net.n_rows(), net.n_columns()];
        let points = self.writer.places(net.as_slice());
        self.writer.set("control", json!({ "points": points, "size": size }));
        let [u, v] =
            [surface.knots_u(), surface.knots_v()].map(crate::kernel::KnotVector::as_slice);
        self.writer.set("knots", json!({ "u": u, "v": v }));
        let degrees = [surface.degree_u(), surface.degree_v()];
        self.add_fact("degree", json!(format!("{} x {}", degrees[0], degrees[1])));
        self.add_fact("controlPoints", json!(format!("{} x {}", size[0], size[1])));
        self.add_fact("rational", json!(surface.is_rational()));
    }

    fn add_curve(&mut self, curve: &Curve) -> Result<(), GeomError> {
        let (parameters, points) = self.finely(curve, N_COMB)?;
        let run = self.writer.places(&points);
        self.writer.set("edges", json!([run]));
        let numbers = self.writer.numbers(1, &parameters);
        self.writer.set("parameters", numbers);
        let bends: Vec<DVec3> = parameters.iter().map(|&t| bending(curve, t)).collect();
        let comb = self.writer.vectors(&bends);
        self.writer.set("comb", comb);
        self.add_fact("points", json!(points.len()));
        match curve {
            Curve::Nurbs(curve) => self.add_polygon(curve),
            Curve::Parametric(_) => self.add_fact("form", json!("parametric")),
        }
        Ok(())
    }

    fn add_polygon(&mut self, curve: &NurbsCurve) {
        let polygon = curve.points();
        let points = self.writer.places(&polygon);
        self.writer.set("control", json!({ "points": points, "size": [polygon.len()] }));
        self.writer.set("knots", json!({ "t": curve.knots().as_slice() }));
        self.add_fact("degree", json!(curve.degree()));
        self.add_fact("controlPoints", json!(polygon.len()));
        self.add_fact("rational", json!(curve.is_rational()));
    }

    fn add_curves(&mut self, curves: &[Curve]) -> Result<(), GeomError> {
        let mut ends = Vec::new();
        for curve in curves {
            let points = self.polyline(curve)?.1;
            ends.extend(points.windows(2).flatten());
        }
        let segments = self.writer.places(&ends);
        self.writer.set("segments", segments);
        self.add_fact("curves", json!(curves.len()));
        Ok(())
    }

    /// Points of a curve with their parameters; from one to the next it turns by no more than normals may.
    pub(super) fn polyline(&self, curve: &Curve) -> Result<(Vec<f64>, Vec<DVec3>), GeomError> {
        let spline = curve.spline()?;
        let Fineness { chord, angle, most, .. } = self.fineness;
        let parameters = tessellation_parameters(&spline, chord, most)?;
        let mut finer = vec![parameters[0]];
        for ends in parameters.windows(2) {
            let n_parts = (turn(&spline, [ends[0], ends[1]]) / angle).ceil().max(1.0) as usize;
            finer.extend(Interval::new(ends[0], ends[1])?.steps(n_parts).into_iter().skip(1));
        }
        let parameters = if finer.len() <= most { finer } else { parameters };
        let points = parameters.iter().map(|&t| spline.point_at(t)).collect();
        Ok((parameters, points))
    }

    /// The same, where the curve bends as many as its comb needs at least.
    pub(super) fn finely(
        &self,
        curve: &Curve,
        least: usize,
    ) -> Result<(Vec<f64>, Vec<DVec3>), GeomError> {
        let (parameters, points) = self.polyline(curve)?;
        let n_parts = least.div_ceil(parameters.len().max(2) - 1);
        if n_parts < 2 || curve.is_straight(Tolerance::DEFAULT.with_distance(self.fineness.weld))? {
            return Ok((parameters, points));
        }
        let mut finer = vec![parameters[0]];
        for pair in parameters.windows(2) {
            finer.extend(Interval::new(pair[0], pair[1])?.steps(n_parts).into_iter().skip(1));
        }
        let spline = curve.spline()?;
        let points = finer.iter().map(|&t| spline.point_at(t)).collect();
        Ok((finer, points))
    }
}

/// By how much a curve turns between parameters of one piece, in radians, as three directions tell it.
fn turn(curve: &NurbsCurve, [start, end]: [f64; 2]) -> f64 {
    let places = [(start, Side::Right), (0.5 * (start + end), Side::Right), (end, Side::Left)];
    let [from, middle, to] = places.map(|(t, side)| curve.derivatives_beside(t, side, 1)[1]);
    from.angle_between(middle) + middle.angle_between(to)
}

/// The curvature vector of a curve; nothing where it has none.
pub(super) fn bending(curve: &Curve, t: f64) -> DVec3 {
    let local = curve.local_at(t, Side::Right).ok();
    local.and_then(|local| local.curvature_vector()).unwrap_or(DVec3::ZERO)
}
