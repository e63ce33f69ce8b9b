//! PNG: a shaded picture of the geometry from one side, without any graphics processor.
//!
//! `scene` places triangles and lines on the picture, `band` finds by a depth buffer what of them
//! is seen, sixteen samples a pixel, `light` colours it, `legend` explains the colours, `marks` names places and lengths, both on a `sheet` to write on. Catmull, *A
//! subdivision algorithm for computer display of curved surfaces*, thesis, Utah 1974, §2.5; W3C,
//! *Portable Network Graphics*, second edition.

mod band;
mod contact;
mod font;
mod legend;
mod light;
mod marks;
mod pixel;
mod scene;
mod sheet;

use std::io::{self, Write};

pub use self::contact::{Thumbnail, write_sheet};
use self::{band::RowBand, light::Light, pixel::SIDE, scene::RasterScene};
use super::{
    ExportError, Format, Job, Picture, Subject, Summary,
    wire::{Drawing, DrawingExtent},
};

pub(crate) static FORMAT: Format = Format {
    ending: "png",
    aliases: &[],
    title: "PNG: a shaded picture from one side",
    // No script exports a picture; the command sets what it needs.
    options: &[],
    takes: Subject::is_geometry,
    takes_data: false,
    is_of_meshes: false,
    wants: "points, curves, surfaces, regions, faces, solids and meshes",
    write,
};

/// The size of a picture for which none is asked.
const SIZE: [usize; 2] = [800, 600];

fn write(job: &Job, out: &mut dyn Write) -> Result<Summary, ExportError> {
    let picture = Picture::new(SIZE);
    let picture = job.picture.as_ref().unwrap_or(&picture);
    let n_across = SIDE * picture.size[0].max(picture.size[1]);
    // What lies nearer to a surface than half a sample cannot be told from it.
    let extent = DrawingExtent::of(job)?;
    let visible = if 0.0 < extent.on_paper { extent.on_paper } else { extent.size };
    let near = extent.projection.in_space(0.5 * visible / n_across as f64).max(extent.finest);

    let mut summary = Summary::default();
    let mut drawings = Vec::with_capacity(job.items.len());
    for item in &job.items {
        summary.count(&item.subject);
        let mut drawing = Drawing::of(item, &extent.projection, near, job)?;
        summary.undrawn.append(&mut drawing.undrawn);
        drawings.push(drawing);
    }
    let scene = RasterScene::new(job, (&drawings, &extent.projection), picture, near)?;
    let light = Light::new(&extent.projection, picture.stripes);
    let mut pixels = Vec::with_capacity(3 * picture.size[0] * picture.size[1]);
    let mut band = RowBand::new(scene.width);
    for idx in 0..scene.n_bands() {
        band.draw_all(&scene, idx);
        band.resolve(&scene, &light, &mut pixels);
    }
    legend::draw(picture, &mut pixels);
    marks::draw_labels(picture, &scene, &mut pixels);
    marks::draw_scale(job, picture, &scene, &mut pixels);
    encode(picture.size, &pixels, out)?;
    Ok(summary)
}

/// Writes the pixels, row by row from the top, red, green and blue.
fn encode([width, height]: [usize; 2], pixels: &[u8], out: &mut dyn Write) -> io::Result<()> {
    let mut encoder = png::Encoder::new(out, width as u32, height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    Ok(writer.finish()?)
}
