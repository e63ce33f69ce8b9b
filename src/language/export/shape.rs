//! Geometry as what mesh formats hold: triangles, polylines and points.

use std::sync::Arc;

use glam::DVec3;

use super::{ExportError, Item, Job, Subject, Summary};
use crate::kernel::{
    Bounds, GeomError, Mesh, SurfacePiece, TessellationOptions, Tolerance, facing_inward,
    tessellate_any, tessellate_curve_any, tessellate_together, tolerance::DEFAULT_CHORD_RELATIVE,
};

/// A subject as a mesh format holds it.
pub(super) enum MeshShape {
    Mesh(Arc<Mesh>),
    Polyline(Vec<DVec3>),
    Point(DVec3),
}

/// An item with its shape.
pub(super) struct ShapedItem<'a> {
    pub(super) item: &'a Item,
    pub(super) shape: MeshShape,
    /// Whether some of it was turned to face outward.
    pub(super) is_turned: bool,
}

impl ShapedItem<'_> {
    /// Its vertices.
    pub(super) fn points(&self) -> &[DVec3] {
        match &self.shape {
            MeshShape::Mesh(mesh) => mesh.vertices(),
            MeshShape::Polyline(points) => points,
            MeshShape::Point(point) => std::slice::from_ref(point),
        }
    }

    /// It as a mesh, if it is one.
    pub(super) fn mesh(&self) -> Option<&Mesh> {
        match &self.shape {
            MeshShape::Mesh(mesh) => Some(mesh),
            _ => None,
        }
    }

    pub(super) fn n_vertices(&self) -> usize {
        self.points().len()
    }

    pub(super) fn n_triangles(&self) -> usize {
        self.mesh().map_or(0, Mesh::n_triangles)
    }

    /// Segments of a polyline.
    pub(super) fn n_legs(&self) -> usize {
        match &self.shape {
            MeshShape::Polyline(points) => points.len().saturating_sub(1),
            _ => 0,
        }
    }

    /// Whether it has a colour, or its vertices have.
    pub(super) fn is_colored(&self) -> bool {
        let is_painted = match &self.shape {
            MeshShape::Mesh(mesh) => !mesh.colors().is_empty(),
            _ => false,
        };
        is_painted || self.item.color.is_some()
    }

    /// Whether there is nothing to draw.
    pub(super) fn is_empty(&self) -> bool {
        matches!(&self.shape, MeshShape::Mesh(mesh) if mesh.triangles().is_empty())
    }

    /// The error for coordinates that a format of single precision cannot hold.
    pub(super) fn beyond_single_precision(&self) -> ExportError {
        let problem = "has coordinates beyond single precision, which the format has".to_owned();
        ExportError::Unfit { name: self.item.name.clone(), problem }
    }
}

impl Summary {
    /// What the shapes of a file come to.
    pub(super) fn of(shapes: &[ShapedItem<'_>]) -> Self {
        let mut summary = Self::default();
        shapes.iter().for_each(|shaped| summary.add(shaped));
        summary
    }

    /// The same of a file of single precision.
    pub(super) fn of_single(job: &Job, shapes: &[ShapedItem<'_>]) -> Self {
        let points = || shapes.iter().flat_map(|shaped| shaped.points().iter().copied());
        let size = Bounds::of(points()).map_or(0.0, Bounds::diagonal);
        let tolerance = job.options.tolerance.unwrap_or(DEFAULT_CHORD_RELATIVE * size);
        let moved = |point: DVec3| (point.as_vec3().as_dvec3() - point).abs().max_element();
        let rounding = points().map(moved).fold(0.0, f64::max);
        let is_told = tolerance.max(job.precision) < rounding;
        Self { rounding: is_told.then_some(rounding), ..Self::of(shapes) }
    }

    /// Counts a shape.
    pub(super) fn add(&mut self, shaped: &ShapedItem<'_>) {
        match &shaped.shape {
            MeshShape::Mesh(mesh) => {
                self.vertices += mesh.n_vertices();
                self.triangles += mesh.n_triangles();
            }
            MeshShape::Polyline(_) => self.curves += 1,
            MeshShape::Point(_) => self.points += 1,
        }
        if shaped.is_turned {
            self.turned.push(shaped.item.name.clone());
        }
    }

    /// Counts a subject that is written as what it is.
    pub(super) fn count(&mut self, subject: &Subject) {
        match subject {
            Subject::Point(_) => self.points += 1,
            Subject::Curve(_) => self.curves += 1,
            Subject::Surface(_) => self.surfaces += 1,
            Subject::Region(region) => self.curves += 1 + region.n_holes(),
            Subject::Face(_) => self.surfaces += 1,
            Subject::Solid(solid) => self.surfaces += solid.faces().len(),
            Subject::Mesh(mesh) => {
                self.vertices += mesh.n_vertices();
                self.triangles += mesh.n_triangles();
            }
            Subject::Document(_) => self.documents += 1,
            Subject::Table(_) | Subject::Data(_) => {}
        }
    }
}

/// A colour with levels on 0..1 in bytes.
pub(super) fn byte_color(color: DVec3) -> [u8; 3] {
    color.to_array().map(|level| (level * 255.0).round() as u8)
}

/// How far meshes of a job may lie from their surfaces.
pub(super) fn tolerance(job: &Job) -> Result<f64, ExportError> {
    let size = size(job)?;
    Ok(job.options.tolerance.unwrap_or(DEFAULT_CHORD_RELATIVE * size))
}

/// The diagonal of all items together; 1 where that is nothing.
pub(super) fn size(job: &Job) -> Result<f64, ExportError> {
    let size = whole(&job.items).map_or(0.0, Bounds::diagonal);
    if size.is_finite() {
        Ok(if size == 0.0 { 1.0 } else { size })
    } else {
        let problem = "reaches farther than can be measured".to_owned();
        Err(ExportError::Unfit { name: "the geometry".to_owned(), problem })
    }
}

/// The box around all items that have one.
pub(crate) fn whole(items: &[Item]) -> Option<Bounds> {
    items.iter().filter_map(bounds).reduce(Bounds::union)
}

/// The box around an item; none around what has no place in space or no bounds.
fn bounds(item: &Item) -> Option<Bounds> {
    match &item.subject {
        Subject::Point(point) => Some(Bounds { min: *point, max: *point }),
        Subject::Curve(curve) => curve.bounds().ok(),
        Subject::Surface(surface) => surface.bounds().ok(),
        Subject::Region(region) => Some(region.bounds()),
        Subject::Face(face) => face.bounds(Tolerance::DEFAULT).ok(),
        Subject::Solid(solid) => solid.bounds(Tolerance::DEFAULT).ok(),
        Subject::Mesh(mesh) => mesh.bounds(),
        Subject::Table(_) | Subject::Data(_) | Subject::Document(_) => None,
    }
}

/// The shapes of all items, those of surfaces and meshes as [`solids`] has them.
pub(super) fn shapes(job: &Job) -> Result<Vec<ShapedItem<'_>>, ExportError> {
    let tolerance = tolerance(job)?;
    let mut solids = solids(job, tolerance)?.into_iter();
    let mut shapes = Vec::with_capacity(job.items.len());
    for item in &job.items {
        if is_solid(&item.subject) {
            shapes.extend(solids.next());
        } else if let Some(shape) = shape(item, tolerance, job)? {
            shapes.push(ShapedItem { item, shape, is_turned: false });
        }
    }
    Ok(shapes)
}

/// Whether it has an area, and a mesh.
pub(super) fn is_solid(subject: &Subject) -> bool {
    matches!(
        subject,
        Subject::Surface(_)
            | Subject::Region(_)
            | Subject::Face(_)
            | Subject::Solid(_)
            | Subject::Mesh(_)
    )
}

/// The meshes among the items, and those of surfaces and faces, with common vertices on common edges; those
/// that make a closed shell together face outward.
pub(super) fn solids(job: &Job, tolerance: f64) -> Result<Vec<ShapedItem<'_>>, ExportError> {
    let mut meshes = meshes(job, tolerance)?.into_iter();
    let mut shapes = Vec::with_capacity(job.items.len());
    for item in &job.items {
        let mesh = match &item.subject {
            Subject::Surface(_) | Subject::Face(_) => meshes.next(),
            Subject::Mesh(mesh) => Some(Arc::clone(mesh)),
            Subject::Region(_) | Subject::Solid(_) => match shape(item, tolerance, job)? {
                Some(MeshShape::Mesh(mesh)) => Some(mesh),
                _ => None,
            },
            _ => None,
        };
        let shaped = |mesh| ShapedItem { item, shape: MeshShape::Mesh(mesh), is_turned: false };
        shapes.extend(mesh.map(shaped));
    }
    face_outward(&mut shapes, job);
    Ok(shapes)
}

/// Turns the triangles of closed shells that face inward.
fn face_outward(shapes: &mut [ShapedItem<'_>], job: &Job) {
    let of_shape = |shaped: &ShapedItem<'_>| match &shaped.shape {
        MeshShape::Mesh(mesh) => Some(Arc::clone(mesh)),
        _ => None,
    };
    let meshes: Vec<Arc<Mesh>> = shapes.iter().filter_map(of_shape).collect();
    let turned = job.meshes.turned(&meshes, || {
        let all: Vec<&Mesh> = meshes.iter().map(|mesh| &**mesh).collect();
        let turn = |(mesh, turns): (&Arc<Mesh>, Vec<bool>)| match turns.contains(&true) {
            true => Arc::new(mesh.with_turned(&turns)),
            false => Arc::clone(mesh),
        };
        meshes.iter().zip(facing_inward(&all)).map(turn).collect()
    });
    let mut turned = turned.into_iter();
    for shaped in shapes {
        if let MeshShape::Mesh(mesh) = &mut shaped.shape
            && let Some(turned) = turned.next()
        {
            shaped.is_turned = !Arc::ptr_eq(mesh, &turned);
            *mesh = turned;
        }
    }
}

/// The meshes of the surfaces and faces among the items, in their order.
fn meshes(job: &Job, tolerance: f64) -> Result<Vec<Arc<Mesh>>, ExportError> {
    let items: Vec<&Item> = job.items.iter().filter(|item| piece(item).is_some()).collect();
    let (limits, most) = (limits(job, tolerance), job.limits.mesh_vertices);
    let make = || {
        let pieces: Vec<SurfacePiece<'_>> = items.iter().filter_map(|item| piece(item)).collect();
        tessellate_together(&pieces, &limits, most)
    };
    job.meshes.of_items(&items, &limits, make).map_err(|source| {
        // Which of them it is that has no mesh shows when each is taken alone.
        let alone = job.items.iter().find_map(|item| shape(item, tolerance, job).err());
        let name = || job.items.iter().find(|item| piece(item).is_some());
        alone.unwrap_or_else(|| ExportError::Geometry {
            name: name().map_or_else(String::new, |item| item.group.clone()),
            source,
        })
    })
}

/// What shares vertices with others.
fn piece(item: &Item) -> Option<SurfacePiece<'_>> {
    match &item.subject {
        Subject::Surface(surface) => Some(SurfacePiece::Whole(surface)),
        Subject::Face(face) => Some(SurfacePiece::Part(face)),
        _ => None,
    }
}

fn limits(job: &Job, tolerance: f64) -> TessellationOptions {
    let within = TessellationOptions::within(tolerance);
    TessellationOptions {
        angle: job.options.angle.unwrap_or(within.angle),
        weld: job.precision,
        n_threads: job.n_threads,
        ..within
    }
}

/// The shape of an item within `tolerance`; `None` for what has no place in space.
pub(super) fn shape(
    item: &Item,
    tolerance: f64,
    job: &Job,
) -> Result<Option<MeshShape>, ExportError> {
    let blame = |source: GeomError| ExportError::Geometry { name: item.name.clone(), source };
    let most = job.limits.mesh_vertices;
    Ok(Some(match &item.subject {
        Subject::Point(point) => MeshShape::Point(*point),
        Subject::Curve(curve) => {
            MeshShape::Polyline(tessellate_curve_any(curve, tolerance, most).map_err(blame)?)
        }
        Subject::Mesh(mesh) => MeshShape::Mesh(Arc::clone(mesh)),
        Subject::Surface(_) | Subject::Region(_) | Subject::Face(_) | Subject::Solid(_) => {
            let limits = limits(job, tolerance);
            let make = || Ok(vec![mesh_of(&item.subject, &limits, most)?]);
            let meshes = job.meshes.of_items(&[item], &limits, make).map_err(blame)?;
            return Ok(meshes.into_iter().next().map(MeshShape::Mesh));
        }
        Subject::Table(_) | Subject::Data(_) | Subject::Document(_) => return Ok(None),
    }))
}

/// The mesh of a subject that has an area.
fn mesh_of(
    subject: &Subject,
    limits: &TessellationOptions,
    most: usize,
) -> Result<Mesh, GeomError> {
    match subject {
        Subject::Surface(surface) => tessellate_any(surface, limits, most),
        Subject::Region(region) => region.mesh(limits.tolerance, limits.weld, most),
        Subject::Face(face) => face.mesh(limits, most),
        Subject::Solid(solid) => solid.mesh(limits, most),
        _ => Ok(Mesh::default()),
    }
}
