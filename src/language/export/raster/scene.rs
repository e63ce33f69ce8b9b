//! What is drawn, in the coordinates of the picture: x to the right and y down, a sample wide, with
//! whole numbers in the middle of samples; z toward the viewer in the same unit.

use std::{borrow::Cow, sync::Arc};

use glam::{DVec2, DVec3};

use super::{
    super::{
        DefinitionLabel, ExportError, Item, Job, POINT, Picture, STROKE, Subject,
        projection::Projection,
        wire::{Drawing, DrawnLine, LineWeight},
    },
    legend,
    pixel::{SIDE, levels},
    sheet::scale_height,
};
use crate::kernel::{Bounds, GeomError, Mesh, NurbsCurve, tessellate_curve};

/// Free space around the geometry, as a part of the smaller side.
const MARGIN: f64 = 0.05;

/// Rows of pixels that are worked on together.
const BAND: usize = 16;

/// Edges of meshes are drawn where they are longer than this many strokes on average.
const LEAST_EDGE: f64 = 5.0;

/// How dark the lines of a surface are, and the edges of a mesh.
const DARK: f64 = 0.4;

/// A mesh on the picture.
pub(super) struct PlacedMesh {
    pub(super) mesh: Arc<Mesh>,
    /// Its vertices on the picture.
    pub(super) places: Vec<DVec3>,
    /// Where its vertices have none.
    pub(super) color: DVec3,
}

/// A straight piece of a line, or a point.
pub(super) struct Stroke {
    pub(super) ends: [DVec3; 2],
    pub(super) radius: f64,
    pub(super) color: DVec3,
    /// The body on which alone it is drawn: lines inside a surface, edges of triangles. What is
    /// covered by another surface in the same place does not show through by its lines.
    pub(super) body: Option<u32>,
    /// Whether its surface lies on one of its sides only, as at borders and outlines.
    pub(super) is_rim: bool,
}

/// Everything on the picture, sorted into bands of rows.
pub(super) struct RasterScene {
    /// Samples in a row.
    pub(super) width: usize,
    pub(super) bodies: Vec<PlacedMesh>,
    pub(super) strokes: Vec<Stroke>,
    /// Rows of samples above and below a band where its lines may lie behind something.
    pub(super) apron: usize,
    /// For each band body and triangle.
    pub(super) triangles_in: Vec<Vec<[u32; 2]>>,
    /// For each band the strokes.
    pub(super) strokes_in: Vec<Vec<u32>>,
    /// Rows of samples.
    height: usize,
    projection: Projection,
    camera: Camera,
}

impl RasterScene {
    pub(super) fn new(
        job: &Job,
        (drawings, projection): (&[Drawing], &Projection),
        picture: &Picture,
        near: f64,
    ) -> Result<Self, ExportError> {
        let bounds = drawings.iter().filter_map(|drawing| drawing.bounds).reduce(Bounds::union);
        let bounds = bounds.unwrap_or(Bounds { min: DVec3::ZERO, max: DVec3::ZERO });
        let camera = Camera::new(bounds, picture);
        let [width, height] = picture.size.map(|pixels| SIDE * pixels);
        let stroke = STROKE * DVec2::new(width as f64, height as f64).length();
        let widest = job.items.iter().map(|item| item.line_width).fold(1.0, f64::max);
        let mut scene = Self {
            width,
            bodies: Vec::new(),
            strokes: Vec::new(),
            apron: (POINT * widest * stroke).ceil() as usize + 1,
            triangles_in: Vec::new(),
            strokes_in: Vec::new(),
            height,
            projection: projection.clone(),
            camera: camera.clone(),
        };
        for (item, drawing) in job.items.iter().zip(drawings) {
            let color = levels(item.color.unwrap_or_default());
            if let Some(mesh) = &drawing.mesh {
                let place = |&vertex: &DVec3| camera.place(projection.project(vertex));
                let places = mesh.vertices().iter().map(place).collect();
                scene.bodies.push(PlacedMesh { mesh: Arc::clone(mesh), places, color });
            }
            scene.add_lines(
                item,
                drawing,
                &camera,
                (item.line_width * stroke, color),
                (near, job),
            )?;
        }
        scene.sort_in();
        Ok(scene)
    }

    /// Where a label belongs, in pixels from the upper left corner.
    pub(super) fn pixel_of(&self, label: &DefinitionLabel) -> DVec2 {
        let place = label.place_seen(&self.projection);
        (self.camera.place(place).truncate() + 0.5) / SIDE as f64
    }

    /// How many pixels a unit of length is wide, at what a camera looks at.
    pub(super) fn pixels_per_unit(&self) -> f64 {
        self.camera.scale / SIDE as f64
    }

    pub(super) fn n_bands(&self) -> usize {
        self.height.div_ceil(SIDE * BAND)
    }

    /// The first row of samples of a band, and the one behind its last.
    pub(super) fn rows(&self, band: usize) -> [usize; 2] {
        [band * SIDE * BAND, ((band + 1) * SIDE * BAND).min(self.height)]
    }

    fn add_lines(
        &mut self,
        item: &Item,
        drawing: &Drawing,
        camera: &Camera,
        (stroke, color): (f64, DVec3),
        (near, job): (f64, &Job),
    ) -> Result<(), ExportError> {
        let blame = |source: GeomError| ExportError::Geometry { name: item.name.clone(), source };
        let first = self.strokes.len();
        let color = if drawing.mesh.is_some() { DARK * color } else { color };
        let body = drawing.mesh.as_ref().map(|_| self.bodies.len() as u32 - 1);
        for (weight, line) in &drawing.lines {
            let is_full = *weight == LineWeight::Full;
            let radius = if is_full { 0.5 } else { 0.25 } * stroke;
            let polygons = match line {
                DrawnLine::Polygon(points) => vec![points.clone()],
                DrawnLine::Curve(curve) => {
                    let of_part = |part: &Cow<'_, NurbsCurve>| {
                        tessellate_curve(part, near, job.limits.mesh_vertices)
                    };
                    let parts: Result<_, _> = curve.connected_parts().iter().map(of_part).collect();
                    parts.map_err(blame)?
                }
            };
            let legs = polygons.iter().flat_map(|points| points.windows(2));
            self.strokes.extend(legs.map(|leg| Stroke {
                ends: [camera.place(leg[0]), camera.place(leg[1])],
                radius,
                color,
                body: body.filter(|_| !is_full),
                is_rim: is_full && body.is_some(),
            }));
        }
        if matches!(item.subject, Subject::Mesh(_)) {
            let edges = &self.strokes[first..];
            let length = |edge: &Stroke| (edge.ends[1] - edge.ends[0]).truncate().length();
            let total: f64 = edges.iter().map(length).sum();
            if total < LEAST_EDGE * stroke * edges.len() as f64 {
                self.strokes.truncate(first);
            }
        }
        self.strokes.extend(drawing.points.iter().map(|&point| Stroke {
            ends: [camera.place(point); 2],
            radius: POINT * stroke,
            color,
            body: None,
            is_rim: false,
        }));
        Ok(())
    }

    /// Notes for each band what may reach into it or its apron.
    fn sort_in(&mut self) {
        let n_bands = self.n_bands();
        let reach = self.apron as f64;
        let per_band = (SIDE * BAND) as f64;
        let bands = |low: f64, high: f64| {
            // What is outside of the picture belongs to no band.
            let first = ((low - reach) / per_band).max(0.0) as usize;
            let last = ((high + reach) / per_band).min(n_bands as f64 - 1.0);
            if last < 0.0 { 0..0 } else { first..last as usize + 1 }
        };
        self.triangles_in = vec![Vec::new(); n_bands];
        for (body_idx, body) in self.bodies.iter().enumerate() {
            for (idx, triangle) in body.mesh.triangles().iter().enumerate() {
                let ys = triangle.map(|corner| body.places[corner as usize].y);
                let (low, high) = (ys[0].min(ys[1]).min(ys[2]), ys[0].max(ys[1]).max(ys[2]));
                for band in bands(low, high) {
                    self.triangles_in[band].push([body_idx as u32, idx as u32]);
                }
            }
        }
        self.strokes_in = vec![Vec::new(); n_bands];
        for (idx, stroke) in self.strokes.iter().enumerate() {
            let [a, b] = stroke.ends.map(|end| end.y);
            for band in bands(a.min(b), a.max(b)) {
                self.strokes_in[band].push(idx as u32);
            }
        }
    }
}

/// From the view's coordinates to those of the picture.
#[derive(Clone)]
struct Camera {
    middle: DVec3,
    /// Samples of a unit of length.
    scale: f64,
    /// Where the middle is drawn.
    target: DVec2,
}

impl Camera {
    /// A camera that has the whole box in sight, beside the legend.
    fn new(bounds: Bounds, picture: &Picture) -> Self {
        let [width, height] = picture.size.map(|pixels| (SIDE * pixels) as f64);
        let width = width - (SIDE * legend::width(picture)) as f64;
        let height = height - (SIDE * scale_height(picture)) as f64;
        let room = DVec2::new(width, height) - 2.0 * MARGIN * width.min(height);
        let scale = (room / bounds.size().truncate()).min_element();
        // What cannot be told from a point is drawn as one.
        let scale = if scale.is_finite() { scale } else { 1.0 };
        let target = 0.5 * (DVec2::new(width, height) - 1.0);
        Self { middle: bounds.center(), scale, target }
    }

    fn place(&self, point: DVec3) -> DVec3 {
        let [x, y, z] = ((point - self.middle) * self.scale).to_array();
        DVec3::new(self.target.x + x, self.target.y - y, z)
    }
}
