//! GLB and glTF: triangles, polylines and points for viewers and renderers.
//!
//! The geometry is turned so that z becomes the format's y, and brought to metres. Each item is a
//! node under its name; a colour or a layer is a material. Khronos Group, *glTF 2.0 Specification*.

use std::io::Write;

use glam::DVec3;
use serde_json::{Map, Value as Json, json};

use super::{
    ExportError, Format, Item, Job, Subject, Summary,
    base64::Base64,
    options::{ANGLE, TOLERANCE},
    shape::{MeshShape, ShapedItem, byte_color, shapes},
    unique_values::UniqueValues,
};

pub(super) static GLB: Format = Format {
    ending: "glb",
    aliases: &[],
    title: "binary glTF: meshes with normals and colours, polylines and points, in metres, y upward",
    options: &[&TOLERANCE, &ANGLE],
    takes: Subject::is_geometry,
    takes_data: false,
    is_of_meshes: true,
    wants: "points, curves, surfaces, regions, faces, solids and meshes",
    write: write_glb,
};

pub(super) static GLTF: Format = Format {
    ending: "gltf",
    aliases: &[],
    title: "glTF: as `.glb`, in one file of text",
    options: &[&TOLERANCE, &ANGLE],
    takes: Subject::is_geometry,
    takes_data: false,
    is_of_meshes: true,
    wants: "points, curves, surfaces, regions, faces, solids and meshes",
    write: write_gltf,
};

/// Numbers of the specification.
mod code {
    pub(super) const UNSIGNED_BYTE: u32 = 5121;
    pub(super) const UNSIGNED_INT: u32 = 5125;
    pub(super) const FLOAT: u32 = 5126;
    pub(super) const ARRAY_BUFFER: u32 = 34962;
    pub(super) const ELEMENT_ARRAY_BUFFER: u32 = 34963;
    pub(super) const POINTS: u32 = 0;
    pub(super) const LINE_STRIP: u32 = 3;
    pub(super) const TRIANGLES: u32 = 4;
    pub(super) const GLB_MAGIC: u32 = 0x4654_6C67;
    pub(super) const JSON_CHUNK: u32 = 0x4E4F_534A;
    pub(super) const BIN_CHUNK: u32 = 0x004E_4942;
}

/// Of what has no colour.
const GREY: [u8; 3] = [204; 3];

fn write_glb(job: &Job, out: &mut dyn Write) -> Result<Summary, ExportError> {
    let scene = GltfScene::new(job)?;
    let mut document = scene.document;
    document.insert("buffers".to_owned(), json!([{ "byteLength": scene.n_bytes }]));
    let mut text = serde_json::to_vec(&document).map_err(std::io::Error::from)?;
    text.resize(text.len().next_multiple_of(4), b' ');
    let whole = 12 + 8 + text.len() + 8 + scene.n_bytes;
    let whole =
        u32::try_from(whole).map_err(|_| ExportError::TooLarge { most: u32::MAX.into() })?;
    let words = [code::GLB_MAGIC, 2, whole, text.len() as u32, code::JSON_CHUNK];
    words.into_iter().try_for_each(|word| out.write_all(&word.to_le_bytes()))?;
    out.write_all(&text)?;
    let words = [scene.n_bytes as u32, code::BIN_CHUNK];
    words.into_iter().try_for_each(|word| out.write_all(&word.to_le_bytes()))?;
    for shaped in &scene.shapes {
        write_buffers(shaped, scene.scale, out)?;
    }
    Ok(scene.summary)
}

fn write_gltf(job: &Job, out: &mut dyn Write) -> Result<Summary, ExportError> {
    let scene = GltfScene::new(job)?;
    let text = serde_json::to_string_pretty(&scene.document).map_err(std::io::Error::from)?;
    // The buffer goes before the last brace, as it is made.
    out.write_all(text.trim_end_matches(['}', '\n']).as_bytes())?;
    let head = "data:application/octet-stream;base64,";
    write!(out, ",\n  \"buffers\": [{{ \"byteLength\": {}, \"uri\": \"{head}", scene.n_bytes)?;
    let mut encoded = Base64::new(out);
    for shaped in &scene.shapes {
        write_buffers(shaped, scene.scale, &mut encoded)?;
    }
    encoded.finish()?;
    out.write_all(b"\" }]\n}\n")?;
    Ok(scene.summary)
}

/// The place of a point in the file's coordinates.
fn placed(point: DVec3, scale: f64) -> [f32; 3] {
    // Zero has no sign.
    [point.x, point.z, -point.y].map(|x| (x * scale) as f32 + 0.0)
}

/// Writes the numbers of an item: places, then normals, colours and corners where it has them.
fn write_buffers(
    shaped: &ShapedItem<'_>,
    scale: f64,
    out: &mut dyn Write,
) -> Result<(), ExportError> {
    let mut buffer = Buffer { bytes: Vec::with_capacity(2 * Buffer::LARGE), out };
    for &point in shaped.points() {
        buffer.floats(placed(point, scale))?;
    }
    if let MeshShape::Mesh(mesh) = &shaped.shape {
        for &normal in mesh.normals() {
            buffer.floats(placed(normal, 1.0))?;
        }
        for &color in mesh.colors() {
            let [r, g, b] = linear(byte_color(color)).map(|level| (level * 255.0).round() as u8);
            buffer.push([r, g, b, u8::MAX])?;
        }
        for triangle in mesh.triangles() {
            for corner in triangle {
                buffer.push(corner.to_le_bytes())?;
            }
        }
    }
    Ok(out_of(buffer)?)
}

/// Bytes on their way, in large writes.
struct Buffer<'a> {
    bytes: Vec<u8>,
    out: &'a mut dyn Write,
}

impl Buffer<'_> {
    const LARGE: usize = 1 << 16;

    fn floats(&mut self, numbers: [f32; 3]) -> std::io::Result<()> {
        let mut bytes = [0; 12];
        for (slot, number) in bytes.chunks_exact_mut(4).zip(numbers) {
            slot.copy_from_slice(&number.to_le_bytes());
        }
        self.push(bytes)
    }

    fn push<const N: usize>(&mut self, bytes: [u8; N]) -> std::io::Result<()> {
        self.bytes.extend_from_slice(&bytes);
        if Self::LARGE <= self.bytes.len() {
            self.out.write_all(&self.bytes)?;
            self.bytes.clear();
        }
        Ok(())
    }
}

fn out_of(buffer: Buffer<'_>) -> std::io::Result<()> {
    buffer.out.write_all(&buffer.bytes)
}

/// Levels of light of a colour of sRGB. IEC 61966-2-1.
fn linear(color: [u8; 3]) -> [f64; 3] {
    color.map(|level| {
        let level = f64::from(level) / 255.0;
        if level <= 0.04045 { level / 12.92 } else { libm::pow((level + 0.055) / 1.055, 2.4) }
    })
}

/// What a material is made of.
#[derive(Clone, PartialEq, Eq, Hash)]
struct Material {
    color: Option<[u8; 3]>,
    layer: Option<String>,
    /// Whether the vertices have colours of their own.
    is_painted: bool,
}

/// The file's text without its buffer, and what goes into that.
struct GltfScene<'a> {
    shapes: Vec<ShapedItem<'a>>,
    summary: Summary,
    document: Map<String, Json>,
    n_bytes: usize,
    /// Metres a unit.
    scale: f64,
}

impl<'a> GltfScene<'a> {
    fn new(job: &'a Job) -> Result<Self, ExportError> {
        let mut shapes = shapes(job)?;
        shapes.retain(|shaped| !shaped.is_empty());
        if shapes.is_empty() {
            let name = job.items.first().map_or_else(String::new, |item| item.name.clone());
            return Err(ExportError::Unfit { name, problem: "has no triangle".to_owned() });
        }
        let scale = job.millimetres / 1000.0;
        let mut parts = GltfParts::default();
        for shaped in &shapes {
            parts.add(shaped, scale)?;
        }
        let (n_bytes, document) = (parts.n_bytes, parts.document());
        Ok(Self { summary: Summary::of_single(job, &shapes), shapes, document, n_bytes, scale })
    }
}

/// The lists of a document under construction.
#[derive(Default)]
struct GltfParts {
    nodes: Vec<Json>,
    /// The node of each layer, and its members.
    layers: UniqueValues<String, Vec<usize>>,
    roots: Vec<usize>,
    meshes: Vec<Json>,
    looks: UniqueValues<Material, ()>,
    accessors: Vec<Json>,
    views: Vec<Json>,
    n_bytes: usize,
}

impl GltfParts {
    fn add(&mut self, shaped: &ShapedItem<'_>, scale: f64) -> Result<(), ExportError> {
        let item = shaped.item;
        let mut attributes = Map::new();
        attributes.insert("POSITION".to_owned(), json!(self.places(shaped, scale)?));
        let mut primitive = Map::new();
        let mut is_painted = false;
        let mode = match &shaped.shape {
            MeshShape::Mesh(mesh) => {
                let n = mesh.n_vertices();
                if !mesh.normals().is_empty() {
                    let idx = self.accessor(n, code::FLOAT, "VEC3", 12, code::ARRAY_BUFFER);
                    attributes.insert("NORMAL".to_owned(), json!(idx));
                }
                if !mesh.colors().is_empty() {
                    is_painted = true;
                    let idx = self.accessor(n, code::UNSIGNED_BYTE, "VEC4", 4, code::ARRAY_BUFFER);
                    self.accessors[idx]["normalized"] = json!(true);
                    attributes.insert("COLOR_0".to_owned(), json!(idx));
                }
                let n = 3 * mesh.n_triangles();
                let target = code::ELEMENT_ARRAY_BUFFER;
                let idx = self.accessor(n, code::UNSIGNED_INT, "SCALAR", 4, target);
                primitive.insert("indices".to_owned(), json!(idx));
                code::TRIANGLES
            }
            MeshShape::Polyline(_) => code::LINE_STRIP,
            MeshShape::Point(_) => code::POINTS,
        };
        let look = Material { color: item.color, layer: item.layer.clone(), is_painted };
        let (material, ()) = self.looks.entry(&look, || ());
        primitive.insert("attributes".to_owned(), Json::Object(attributes));
        primitive.insert("material".to_owned(), json!(material));
        primitive.insert("mode".to_owned(), json!(mode));
        self.meshes.push(json!({ "name": item.name, "primitives": [primitive] }));
        self.node(item);
        Ok(())
    }

    /// The node of the latest mesh, under that of its layer.
    fn node(&mut self, item: &Item) {
        let idx = self.nodes.len();
        self.nodes.push(json!({ "name": item.name, "mesh": self.meshes.len() - 1 }));
        match &item.layer {
            None => self.roots.push(idx),
            Some(layer) => self.layers.entry(layer, Vec::new).1.push(idx),
        }
    }

    /// The places of an item, with the box around them as the file's numbers have it.
    fn places(&mut self, shaped: &ShapedItem<'_>, scale: f64) -> Result<usize, ExportError> {
        let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for &point in shaped.points() {
            let place = placed(point, scale);
            for i in 0..3 {
                (low[i], high[i]) = (low[i].min(place[i]), high[i].max(place[i]));
            }
        }
        if low.iter().chain(&high).any(|x| !x.is_finite()) {
            return Err(shaped.beyond_single_precision());
        }
        let n = shaped.points().len();
        let idx = self.accessor(n, code::FLOAT, "VEC3", 12, code::ARRAY_BUFFER);
        self.accessors[idx]["min"] = json!(low.map(f64::from));
        self.accessors[idx]["max"] = json!(high.map(f64::from));
        Ok(idx)
    }

    /// A new accessor of `n` elements on a view of its own behind all others.
    fn accessor(
        &mut self,
        n: usize,
        component: u32,
        kind: &str,
        size: usize,
        target: u32,
    ) -> usize {
        let n_bytes = n * size;
        self.views.push(json!({
            "buffer": 0, "byteOffset": self.n_bytes, "byteLength": n_bytes, "target": target,
        }));
        self.n_bytes += n_bytes;
        self.accessors.push(json!({
            "bufferView": self.views.len() - 1,
            "componentType": component, "count": n, "type": kind,
        }));
        self.accessors.len() - 1
    }

    fn document(mut self) -> Map<String, Json> {
        for (name, members) in std::mem::take(&mut self.layers).pairs() {
            self.roots.push(self.nodes.len());
            self.nodes.push(json!({ "name": name, "children": members }));
        }
        let materials: Vec<Json> =
            self.looks.pairs().iter().map(|(look, ())| material(look)).collect();
        let members = [
            ("asset", json!({ "version": "2.0", "generator": "virote" })),
            ("scene", json!(0)),
            ("scenes", json!([{ "nodes": self.roots }])),
            ("nodes", Json::Array(self.nodes)),
            ("meshes", Json::Array(self.meshes)),
            ("materials", Json::Array(materials)),
            ("accessors", Json::Array(self.accessors)),
            ("bufferViews", Json::Array(self.views)),
        ];
        members.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
    }
}

fn material(look: &Material) -> Json {
    let color = look.color.unwrap_or(if look.is_painted { [u8::MAX; 3] } else { GREY });
    let [r, g, b] = linear(if look.is_painted { [u8::MAX; 3] } else { color });
    let hex = || look.color.map(|[r, g, b]| format!("#{r:02x}{g:02x}{b:02x}"));
    let name = look.layer.clone().or_else(hex).unwrap_or_else(|| "plain".to_owned());
    json!({
        "name": name,
        "pbrMetallicRoughness": {
            "baseColorFactor": [r, g, b, 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.6,
        },
        "doubleSided": true,
    })
}
