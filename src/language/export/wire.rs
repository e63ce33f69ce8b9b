//! The lines by which surfaces and meshes are drawn, and the meshes that hide what is behind.

use std::{collections::BTreeMap, sync::Arc};

use glam::DVec3;

use super::{
    ExportError, Item, Job, Subject,
    exact::with_positive_weights,
    projection::Projection,
    shape::{MeshShape, byte_color, shape, size, whole},
};
use crate::kernel::{
    Bounds, Curve, Face, GeomError, Interval, Mesh, NurbsCurve, Surface, Tolerance,
    tolerance::{DRAWING_DIGIT, PATH_RELATIVE, PATH_ROUNDING},
};

/// How thick a line is.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum LineWeight {
    /// Curves, edges and outlines.
    Full,
    /// Lines inside.
    Half,
}

/// How large is what is drawn, and how it is seen.
pub(super) struct DrawingExtent {
    /// The diagonal, 1 where that is nothing.
    pub(super) size: f64,
    /// The diagonal on paper of the box around all.
    pub(super) on_paper: f64,
    /// The finest tolerance that rounding lets a polygon or path keep.
    pub(super) finest: f64,
    /// From space to paper.
    pub(super) projection: Projection,
}

impl DrawingExtent {
    /// Of all items of a job, if that has an end.
    pub(super) fn of(job: &Job) -> Result<Self, ExportError> {
        let whole = whole(&job.items).unwrap_or(Bounds { min: DVec3::ZERO, max: DVec3::ZERO });
        let size = size(job)?;
        let projection = Projection::new(&job.options.viewpoint, whole)?;
        let on_paper = projection.bounds(whole).size().truncate().length();
        Ok(Self { size, on_paper, finest: PATH_ROUNDING * whole.magnitude(), projection })
    }
}

/// A line in the view's coordinates.
pub(super) enum DrawnLine {
    Curve(NurbsCurve),
    Polygon(Vec<DVec3>),
}

/// An item in the view's coordinates: x to the right, y upward, z toward the viewer.
#[derive(Default)]
pub(super) struct Drawing {
    pub(super) lines: Vec<(LineWeight, DrawnLine)>,
    pub(super) points: Vec<DVec3>,
    /// Triangles filled with a colour.
    pub(super) fills: Vec<([DVec3; 3], [u8; 3])>,
    /// The box around all of it.
    pub(super) bounds: Option<Bounds>,
    /// What hides, in space.
    pub(super) mesh: Option<Arc<Mesh>>,
    /// What of the lines of a face is left out, and why.
    pub(super) undrawn: Vec<String>,
}

impl Drawing {
    /// What is drawn of an item; triangles are within `near` of their surface.
    pub(super) fn of(
        item: &Item,
        view: &Projection,
        near: f64,
        job: &Job,
    ) -> Result<Self, ExportError> {
        let blame = |source: GeomError| ExportError::Geometry { name: item.name.clone(), source };
        let mut drawing = Self::default();
        match &item.subject {
            Subject::Point(point) => {
                drawing.points.push(view.project(*point));
                drawing.bounds = Bounds::of(drawing.points.iter().copied());
            }
            Subject::Curve(curve) => {
                let curve = curve.spline().map_err(blame)?;
                drawing.curve(LineWeight::Full, &curve, view, item)?;
            }
            Subject::Surface(surface) => {
                drawing.lines_of(surface, view, (item, job))?;
                drawing.outlines(near, view, (item, job))?;
            }
            Subject::Region(region) => {
                for border in region.borders().map_err(blame)? {
                    drawing.curve(LineWeight::Full, &border, view, item)?;
                }
                if let Some(MeshShape::Mesh(mesh)) = shape(item, near, job)? {
                    drawing.hide_behind(mesh, view);
                }
            }
            Subject::Face(face) => {
                drawing.lines_of_face(face, view, (item, job))?;
                drawing.outlines(near, view, (item, job))?;
            }
            Subject::Solid(solid) => {
                for face in solid.faces() {
                    drawing.lines_of_face(face, view, (item, job))?;
                }
                drawing.outlines(near, view, (item, job))?;
            }
            Subject::Mesh(mesh) => {
                if !mesh.colors().is_empty() {
                    drawing.paint(mesh, view);
                    drawing.hide_behind(Arc::clone(mesh), view);
                    return Ok(drawing);
                }
                let place = |i: u32| view.project(mesh.vertices()[i as usize]);
                let edges = if job.options.has_edges { mesh.face_edges() } else { Vec::new() };
                let edges = edges.into_iter().map(|[a, b]| vec![place(a), place(b)]);
                drawing
                    .lines
                    .extend(edges.map(|edge| (LineWeight::Half, DrawnLine::Polygon(edge))));
                drawing.hide_behind(Arc::clone(mesh), view);
            }
            Subject::Table(_) | Subject::Data(_) | Subject::Document(_) => {}
        }
        Ok(drawing)
    }

    /// Where the triangles of an item turn away, which hide what is behind.
    fn outlines(
        &mut self,
        near: f64,
        view: &Projection,
        (item, job): (&Item, &Job),
    ) -> Result<(), ExportError> {
        if let Some(MeshShape::Mesh(mesh)) = shape(item, near, job)? {
            let outline = if job.options.has_edges { outline(&mesh, view) } else { Vec::new() };
            let outline = outline.into_iter().map(DrawnLine::Polygon);
            self.lines.extend(outline.map(|line| (LineWeight::Full, line)));
            self.hide_behind(mesh, view);
        }
        Ok(())
    }

    /// The triangles that hide.
    pub(super) fn triangles(&self, view: &Projection) -> impl Iterator<Item = [DVec3; 3]> {
        let image = |corners: [DVec3; 3]| corners.map(|corner| view.project(corner));
        self.mesh.iter().flat_map(|mesh| mesh.corners()).map(image)
    }

    fn curve(
        &mut self,
        weight: LineWeight,
        curve: &NurbsCurve,
        view: &Projection,
        item: &Item,
    ) -> Result<(), ExportError> {
        let curve = match view.curve(curve) {
            Ok(image) => image,
            // Points of weight zero have no image in perspective.
            Err(_) => {
                let curve = with_positive_weights(item, curve.clone())?;
                let blame =
                    |source: GeomError| ExportError::Geometry { name: item.name.clone(), source };
                view.curve(&curve).map_err(blame)?
            }
        };
        let bounds = curve.bounds();
        self.bounds = Some(self.bounds.map_or(bounds, |whole| whole.union(bounds)));
        self.lines.push((weight, DrawnLine::Curve(curve)));
        Ok(())
    }

    /// The edges of a surface, and lines inside at even steps of the parameters; none that is a
    /// point.
    fn lines_of(
        &mut self,
        surface: &Surface,
        view: &Projection,
        (item, job): (&Item, &Job),
    ) -> Result<(), ExportError> {
        let blame = |source: GeomError| ExportError::Geometry { name: item.name.clone(), source };
        let size = surface.bounds().map_err(blame)?.diagonal();
        for (weight, line) in isocurves(surface, size, job).map_err(blame)? {
            // A line that is a point is a pole, and not drawn.
            if DRAWING_DIGIT * size < line.bounds().map_err(blame)?.diagonal() {
                self.curve(weight, line.spline().map_err(blame)?.as_ref(), view, item)?;
            }
        }
        Ok(())
    }

    /// The edges of a face, and what of its surface's lines inside is on it.
    fn lines_of_face(
        &mut self,
        face: &Face,
        view: &Projection,
        (item, job): (&Item, &Job),
    ) -> Result<(), ExportError> {
        let surface = Surface::Nurbs(Arc::clone(face.surface()));
        if face.is_whole() {
            return self.lines_of(&surface, view, (item, job));
        }
        let blame = |source: GeomError| ExportError::Geometry { name: item.name.clone(), source };
        let tolerance = Tolerance::DEFAULT.with_distance(job.precision);
        if job.options.has_edges {
            for edge in face.edges(tolerance).map_err(blame)? {
                self.curve(LineWeight::Full, &edge, view, item)?;
            }
        }
        let size = surface.bounds().map_err(blame)?.diagonal();
        for (weight, line) in isocurves(&surface, size, job).map_err(blame)? {
            if weight == LineWeight::Full
                || line.bounds().map_err(blame)?.diagonal() <= DRAWING_DIGIT * size
            {
                continue;
            }
            let line = [(*line.spline().map_err(blame)?).clone()];
            let seen = Tolerance::DEFAULT.with_distance(job.precision.max(PATH_RELATIVE * size));
            let parts = face.clipped(&line, tolerance).or_else(|_| face.clipped(&line, seen));
            match parts {
                Ok(parts) => {
                    for part in parts {
                        self.curve(weight, &part, view, item)?;
                    }
                }
                // The face is drawn without a line that only pleases.
                Err(why) if self.undrawn.is_empty() => {
                    self.undrawn.push(format!("`{}`: {why}", item.name));
                }
                Err(_) => {}
            }
        }
        Ok(())
    }

    /// The borders of the stripes that a surface mirrors toward the viewer, where they are asked for.
    pub(super) fn add_stripes(
        &mut self,
        item: &Item,
        view: &Projection,
        near: f64,
        job: &Job,
    ) -> Result<(), ExportError> {
        let stripes = job.picture.as_ref().and_then(|picture| picture.stripes);
        let (Subject::Surface(surface), Some(stripes)) = (&item.subject, stripes) else {
            return Ok(());
        };
        let tolerance = Tolerance::DEFAULT.with_distance(near);
        let light = stripes.light.unwrap_or_else(|| view.ahead());
        let sets = surface.zebra(light, stripes.n_stripes, tolerance);
        let blame = |source: GeomError| ExportError::Geometry { name: item.name.clone(), source };
        for curve in sets.map_err(blame)?.into_iter().flat_map(|set| set.curves) {
            let image = view.curve(&curve).map_err(blame)?;
            self.lines.push((LineWeight::Full, DrawnLine::Curve(image)));
        }
        Ok(())
    }

    /// Fills the triangles of a mesh whose vertices have colours, each with their mean.
    fn paint(&mut self, mesh: &Mesh, view: &Projection) {
        for (triangle, corners) in mesh.triangles().iter().zip(mesh.corners()) {
            let sum: DVec3 = triangle.iter().map(|&corner| mesh.colors()[corner as usize]).sum();
            let image = corners.map(|corner| view.project(corner));
            self.fills.push((image, byte_color(sum / 3.0)));
        }
    }

    fn hide_behind(&mut self, mesh: Arc<Mesh>, view: &Projection) {
        self.mesh = Some(mesh);
        let whole = Bounds::of(self.triangles(view).flatten());
        self.bounds = match (self.bounds, whole) {
            (Some(a), Some(b)) => Some(a.union(b)),
            (a, b) => a.or(b),
        };
    }
}

/// The lines of a surface at even steps of the parameters: its edges, and as many inside as are asked
/// for. The seam of a closed surface is no edge, and one line.
fn isocurves(
    surface: &Surface,
    size: f64,
    job: &Job,
) -> Result<Vec<(LineWeight, Curve)>, GeomError> {
    let n_inside = job.options.n_isocurves;
    let steps = |domain: Interval| domain.steps(n_inside + 1);
    let (us, vs) = (steps(surface.domain_u()), steps(surface.domain_v()));
    let same = DRAWING_DIGIT * size;
    let (closed_u, closed_v) = (surface.is_closed_u(same)?, surface.is_closed_v(same)?);
    let mut lines = Vec::new();
    let weight = |i: usize, is_closed: bool| {
        let is_end = i == 0 || i == n_inside + 1;
        match (is_end, is_closed) {
            (true, false) => job.options.has_edges.then_some(LineWeight::Full),
            (true, true) => (i != 0 && n_inside != 0).then_some(LineWeight::Half),
            (false, _) => Some(LineWeight::Half),
        }
    };
    for (i, &u) in us.iter().enumerate() {
        if let Some(weight) = weight(i, closed_u) {
            lines.push((weight, surface.isocurve_u(u)?));
        }
    }
    for (i, &v) in vs.iter().enumerate() {
        if let Some(weight) = weight(i, closed_v) {
            lines.push((weight, surface.isocurve_v(v)?));
        }
    }
    Ok(lines)
}

/// Where the surface of a mesh turns away from the viewer: the zeros of the normal's component
/// toward them, linear over each triangle, as polygons.
fn outline(mesh: &Mesh, view: &Projection) -> Vec<Vec<DVec3>> {
    // What turns away within rounding does so there: a seam along the outline has it on one side.
    let slope = |(normal, &place): (&DVec3, &DVec3)| {
        let toward = view.toward(place);
        let slope = normal.dot(toward);
        if slope.abs() <= DRAWING_DIGIT * toward.length() { 0.0 } else { slope }
    };
    let slopes: Vec<f64> = mesh.normals().iter().zip(mesh.vertices()).map(slope).collect();
    if slopes.is_empty() {
        return Vec::new();
    }
    let mut links: BTreeMap<[u32; 2], Vec<[u32; 2]>> = BTreeMap::new();
    for &[a, b, c] in mesh.triangles() {
        let crossed = |&[a, b]: &[u32; 2]| (slopes[a as usize] < 0.0) != (slopes[b as usize] < 0.0);
        let sides = [[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)]);
        let mut crossed = sides.into_iter().filter(crossed);
        if let (Some(from), Some(to)) = (crossed.next(), crossed.next()) {
            links.entry(from).or_default().push(to);
            links.entry(to).or_default().push(from);
        }
    }
    let place = |[a, b]: [u32; 2]| {
        let (a, b) = (a as usize, b as usize);
        let fraction = slopes[a] / (slopes[a] - slopes[b]);
        view.project(mesh.vertices()[a].lerp(mesh.vertices()[b], fraction))
    };
    chains(links).into_iter().map(|chain| chain.into_iter().map(place).collect()).collect()
}

/// Runs through all links, each once, from the ends of open chains first.
fn chains(mut links: BTreeMap<[u32; 2], Vec<[u32; 2]>>) -> Vec<Vec<[u32; 2]>> {
    let ends: Vec<[u32; 2]> =
        links.iter().filter(|(_, to)| to.len() == 1).map(|(&from, _)| from).collect();
    let all: Vec<[u32; 2]> = links.keys().copied().collect();
    let mut chains = Vec::new();
    for start in ends.into_iter().chain(all) {
        let mut chain = vec![start];
        let mut at = start;
        while let Some(next) = links.get_mut(&at).and_then(Vec::pop) {
            if let Some(back) = links.get_mut(&next)
                && let Some(idx) = back.iter().position(|&other| other == at)
            {
                back.swap_remove(idx);
            }
            chain.push(next);
            at = next;
        }
        if 1 < chain.len() {
            chains.push(chain);
        }
    }
    chains
}
