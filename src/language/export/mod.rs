//! Geometry and tables into files: one format a file of this folder, chosen by the path's ending.
//!
//! Formats write to any [`Write`]; that files appear whole or not at all is the door's business.

mod base64;
mod csv;
mod document;
mod dxf;
mod error;
mod exact;
mod gltf;
mod iges;
mod json;
mod labels;
mod legend;
mod limited;
mod measure;
mod mesh_memory;
mod name;
mod obj;
mod options;
mod ply;
mod projection;
mod raster;
mod shape;
mod step;
mod stl;
mod svg;
mod text;
mod unique_values;
mod view;
mod wire;
mod xml;

use std::{io::Write, sync::Arc};

use glam::DVec3;

use crate::{
    kernel::{Curve, Face, Mesh, Region, Solid, Surface, Table, Tolerance},
    limits::Limits,
};

pub use base64::base64;
pub use csv::text_cell as csv_cell;
pub use document::{DocumentBlock, DocumentCell, DocumentTable, ReportDocument};
pub use error::{ExportError, io_reason};
pub use labels::DefinitionLabel;
pub use legend::Legend;
pub use limited::capped;
pub use measure::{MeasuredPart, parts};
pub use mesh_memory::MeshMemory;
pub use options::N_ISOCURVES;
pub use options::{ExportOption, OptionValue, Options};
pub use projection::{Viewpoint, ViewpointError};
pub(crate) use raster::FORMAT as PNG;
pub use raster::{Thumbnail, write_sheet};
pub(crate) use shape::whole;
pub use view::{Oblique, View};

/// Something that a file can hold.
#[derive(Clone, Debug)]
pub enum Subject {
    /// A point.
    Point(DVec3),
    /// A curve.
    Curve(Curve),
    /// A surface.
    Surface(Surface),
    /// A plane region.
    Region(Arc<Region>),
    /// A part of a surface.
    Face(Arc<Face>),
    /// What faces enclose.
    Solid(Arc<Solid>),
    /// A mesh.
    Mesh(Arc<Mesh>),
    /// A table.
    Table(Arc<Table>),
    /// Any value as exact data.
    Data(serde_json::Value),
    /// Something to be read.
    Document(Arc<ReportDocument>),
}

impl Subject {
    /// Whether it has a place in space.
    #[must_use]
    pub fn is_geometry(&self) -> bool {
        !matches!(self, Self::Table(_) | Self::Data(_) | Self::Document(_))
    }
}

/// A subject under the name that the file gives it.
#[derive(Clone, Debug)]
pub struct Item {
    /// The name of the definition, or the expression as it was written, with the place in its
    /// list.
    pub name: String,
    /// The same without the place in a list: what belongs together.
    pub group: String,
    /// Red, green and blue of sRGB.
    pub color: Option<[u8; 3]>,
    /// The layer that it is put on.
    pub layer: Option<String>,
    /// How wide its lines and points are in drawings, as a multiple of the usual.
    pub line_width: f64,
    /// What is written.
    pub subject: Subject,
    /// In an incremental session the identity of the definition's value that it is, or is a part of.
    pub identity: Option<u64>,
}

/// What a format is asked to do.
#[derive(Clone, Debug)]
pub struct Job {
    /// What goes into the file.
    pub items: Vec<Item>,
    /// The document's unit of length, by name.
    pub unit: &'static str,
    /// The document's unit of length in millimetres.
    pub millimetres: f64,
    /// Points closer than this are one: the document's tolerance.
    pub precision: f64,
    /// What the script asked for.
    pub options: Options,
    /// What a picture needs beside, of a fixed size in pixels.
    pub picture: Option<Picture>,
    /// The ceilings.
    pub limits: Limits,
    /// How many threads may make it; its bytes do not depend on that.
    pub n_threads: usize,
    /// Meshes that are there already.
    pub meshes: MeshMemory,
}

impl Item {
    /// An item without colour and layer.
    #[must_use]
    pub fn new(name: impl Into<String>, subject: Subject) -> Self {
        let name = name.into();
        let group = name.clone();
        Self { group, name, color: None, layer: None, line_width: 1.0, subject, identity: None }
    }
}

impl Job {
    /// These items in millimetres, with the usual tolerance, options and ceilings. For files that no
    /// script asks for.
    ///
    /// ```
    /// use virote_language::{export::{Format, Item, Job, Subject}, kernel::{Frame, NurbsCurve}};
    ///
    /// let circle = NurbsCurve::arc(Frame::XY, 10.0, 0.0, std::f64::consts::TAU)?;
    /// let job = Job::new(vec![Item::new("ring", Subject::Curve(circle.into()))]);
    /// let mut bytes = Vec::new();
    /// let format = Format::of_path("ring.svg").expect("a format that is known");
    /// let summary = (format.write)(&job, &mut bytes)?;
    /// assert_eq!(summary.to_string(), "1 curve");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn new(items: Vec<Item>) -> Self {
        Self {
            items,
            unit: "mm",
            millimetres: 1.0,
            precision: Tolerance::DEFAULT.distance,
            options: Options::default(),
            picture: None,
            limits: Limits::DEFAULT,
            n_threads: 1,
            meshes: MeshMemory::default(),
        }
    }
}

/// A picture of a fixed size.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Width and height in pixels.
    pub size: [usize; 2],
    /// What its colours mean.
    pub legends: Vec<Legend>,
    /// The stripes that surfaces mirror toward the viewer.
    pub stripes: Option<Stripes>,
    /// What stands beside places of the geometry.
    pub labels: Vec<DefinitionLabel>,
    /// Whether a scale tells how long a round length is.
    pub has_scale: bool,
}

impl Picture {
    /// A picture of the geometry alone.
    #[must_use]
    pub fn new(size: [usize; 2]) -> Self {
        Self { size, legends: Vec::new(), stripes: None, labels: Vec::new(), has_scale: false }
    }
}

/// Stripes that surfaces mirror toward the viewer, as [`crate::kernel::Surface::zebra`] has them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stripes {
    /// How many there are all around, an even number.
    pub n_stripes: usize,
    /// The direction to the light; without one it is where the viewer is.
    pub light: Option<DVec3>,
}

/// Width of lines in drawings and pictures as a part of the diagonal.
const STROKE: f64 = 0.002;
/// Radius of a point, in strokes.
const POINT: f64 = 1.75;

/// What a file came to hold.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// Vertices of meshes.
    pub vertices: usize,
    /// Triangles of meshes.
    pub triangles: usize,
    /// Curves, exact or as polylines.
    pub curves: usize,
    /// Exact surfaces.
    pub surfaces: usize,
    /// Single points.
    pub points: usize,
    /// Rows of tables.
    pub rows: usize,
    /// Values as exact data.
    pub values: usize,
    /// Documents.
    pub documents: usize,
    /// What was turned so that closed shells face outward, by name.
    pub turned: Vec<String>,
    /// How far numbers of single precision move places, where that is farther than the tolerance.
    pub rounding: Option<f64>,
    /// Lines of faces that a drawing lacks, and why: the name with the reason.
    pub undrawn: Vec<String>,
}

/// `482 vertices, 960 triangles`.
impl std::fmt::Display for Summary {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let parts = [
            (self.vertices, "vertex", "vertices"),
            (self.triangles, "triangle", "triangles"),
            (self.surfaces, "surface", "surfaces"),
            (self.curves, "curve", "curves"),
            (self.points, "point", "points"),
            (self.rows, "row", "rows"),
            (self.values, "value", "values"),
            (self.documents, "report", "reports"),
        ];
        let mut first = true;
        for (n, one, many) in parts.into_iter().filter(|part| part.0 != 0) {
            write!(f, "{}{n} {}", if first { "" } else { ", " }, if n == 1 { one } else { many })?;
            first = false;
        }
        if first { f.write_str("nothing") } else { Ok(()) }
    }
}

/// A file format.
#[derive(Debug)]
pub struct Format {
    /// The ending that chooses it, without the point.
    pub ending: &'static str,
    /// Other endings for the same.
    pub aliases: &'static [&'static str],
    /// What it is.
    pub title: &'static str,
    /// The options after `with` that it knows.
    pub options: &'static [&'static ExportOption],
    /// Whether it has a place for a subject.
    pub takes: fn(&Subject) -> bool,
    /// Whether it holds any value as exact data rather than shapes.
    pub takes_data: bool,
    /// Whether curves and surfaces are polylines and triangles in it, unless they are asked for in
    /// exact form.
    pub is_of_meshes: bool,
    /// What it takes, as a noun phrase.
    pub wants: &'static str,
    /// Writes a file.
    pub write: fn(&Job, &mut dyn Write) -> Result<Summary, ExportError>,
}

/// Every format, in the order of the reference.
pub static FORMATS: &[&Format] = &[
    &obj::FORMAT,
    &stl::FORMAT,
    &ply::FORMAT,
    &gltf::GLB,
    &gltf::GLTF,
    &svg::FORMAT,
    &dxf::FORMAT,
    &step::FORMAT,
    &iges::FORMAT,
    &csv::FORMAT,
    &json::FORMAT,
    &document::HTML,
    &document::MARKDOWN,
];

/// Every format of a picture.
pub static PICTURES: &[&Format] = &[&raster::FORMAT, &svg::FORMAT];

impl Format {
    /// Whether it holds curves, surfaces or meshes.
    #[must_use]
    pub fn takes_shapes(&self) -> bool {
        (self.takes)(&Subject::Mesh(Arc::default())) || (self.takes)(&Subject::Point(DVec3::ZERO))
    }

    /// Whether it holds a table.
    #[must_use]
    pub fn takes_tables(&self) -> bool {
        (self.takes)(&Subject::Table(Arc::default()))
    }

    /// Whether it holds documents.
    #[must_use]
    pub fn takes_documents(&self) -> bool {
        (self.takes)(&Subject::Document(Arc::default()))
    }

    /// Whether a file with these options holds polylines and triangles in the place of curves and
    /// surfaces.
    #[must_use]
    pub fn holds_meshes(&self, options: &Options) -> bool {
        self.is_of_meshes && !options.free_form
    }

    /// The format of a path.
    #[must_use]
    pub fn of_path(path: &str) -> Option<&'static Self> {
        Self::among(FORMATS, path)
    }

    /// The format of a path among these.
    #[must_use]
    pub fn among(formats: &[&'static Self], path: &str) -> Option<&'static Self> {
        let (_, ending) = path.rsplit_once('.')?;
        let is_its = |its: &str| its.eq_ignore_ascii_case(ending);
        formats.iter().copied().find(|format| {
            is_its(format.ending) || format.aliases.iter().any(|alias| is_its(alias))
        })
    }
}
