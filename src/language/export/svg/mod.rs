//! SVG: a drawing of the geometry from one side, without hidden lines.
//!
//! `path` makes paths of curves, exactly where a cubic can be, [`super::wire`] finds the lines of
//! surfaces and meshes, `hidden` what of a line is seen, `legend` explains colours, `marks` names places and lengths. W3C, *Scalable Vector Graphics 1.1*, second edition.

mod hidden;
mod legend;
mod marks;
mod path;

use std::io::Write;

use glam::DVec3;

use self::{hidden::HidingScene, path::Pen};
use super::{
    ExportError, Format, Item, Job, POINT, STROKE, Subject, Summary,
    options::{
        CAMERA, DECIMALS, EDGES, HAIRLINE, ISOCURVES, LOOK_AT, OBLIQUE_ANGLE, OBLIQUE_RATIO,
        PERSPECTIVE, TOLERANCE, VIEW,
    },
    text::TextBuffer,
    unique_values::UniqueValues,
    wire::{Drawing, DrawingExtent, DrawnLine, LineWeight},
    xml::{Ids, escaped},
};
use crate::kernel::{
    Bounds,
    tolerance::{DRAWING_DIGIT, HAIRLINE_WIDTH, HIDDEN_RELATIVE, PATH_RELATIVE},
};

pub(super) static FORMAT: Format = Format {
    ending: "svg",
    aliases: &[],
    title: "SVG: a drawing from one side, curves as exact paths, surfaces and meshes as wireframes without hidden lines",
    options: &[
        &TOLERANCE,
        &DECIMALS,
        &VIEW,
        &OBLIQUE_ANGLE,
        &OBLIQUE_RATIO,
        &CAMERA,
        &LOOK_AT,
        &PERSPECTIVE,
        &EDGES,
        &ISOCURVES,
        &HAIRLINE,
    ],
    takes: Subject::is_geometry,
    takes_data: false,
    is_of_meshes: false,
    wants: "points, curves, surfaces, regions, faces, solids and meshes",
    write,
};

/// Lines around filled triangles, in strokes.
const FILL: f64 = 0.1;
/// Free space around the drawing, in strokes.
const MARGIN: f64 = 10.0;
/// Drawings of these sizes, in millimetres, are made to be printed as large as they are.
const PAPER: std::ops::RangeInclusive<f64> = 10.0..=2000.0;

fn write(job: &Job, out: &mut dyn Write) -> Result<Summary, ExportError> {
    let extent = DrawingExtent::of(job)?;
    let within =
        |share: f64| job.options.tolerance.unwrap_or(share * extent.size).max(extent.finest);
    let (tolerance, on_paper) = (within(PATH_RELATIVE), within(HIDDEN_RELATIVE));
    let view = &extent.projection;
    let near = view.in_space(on_paper);

    // Everything as lines and triangles in the view's coordinates.
    let mut drawings = Vec::with_capacity(job.items.len());
    let mut summary = Summary::default();
    for item in &job.items {
        summary.count(&item.subject);
        let mut drawing = Drawing::of(item, view, near, job)?;
        summary.undrawn.append(&mut drawing.undrawn);
        drawing.add_stripes(item, view, near, job)?;
        drawings.push(drawing);
    }
    let scene =
        HidingScene::new(drawings.iter().flat_map(|drawing| drawing.triangles(view)), on_paper);
    let bounds = drawings.iter().filter_map(|drawing| drawing.bounds).reduce(Bounds::union);
    let bounds = bounds.unwrap_or(Bounds { min: DVec3::ZERO, max: DVec3::ZERO });

    let sheet = SvgSheet::new(job, bounds);
    let legends = job.picture.as_ref().map_or(&[][..], |picture| &picture.legends);
    let mut text = TextBuffer::rounded(Some(sheet.decimals));
    sheet.head(job, &mut text);
    let layers = layers(&job.items);
    let mut ids = Ids::default();
    for &(layer, ref members) in layers.pairs() {
        if let Some(layer) = layer {
            text.push("<g id=\"")
                .push(&ids.next(&format!("layer-{layer}")))
                .push("\" inkscape:groupmode=\"layer\"");
            text.push(" inkscape:label=\"").push(&escaped(layer)).push("\">\n");
        }
        for &idx in members {
            let item = &job.items[idx];
            text.push("<g id=\"").push(&ids.next(&item.name)).push("\"");
            if let Some(color) = item.color {
                text.push(" stroke=\"").push(&hex(color)).push("\"");
            }
            if 0.0 < (item.line_width - 1.0).abs() {
                text.push(" stroke-width=\"").number(item.line_width * sheet.stroke).push("\"");
            }
            text.push(">\n<title>").push(&escaped(&item.name)).push("</title>\n");
            sheet.draw(item, &drawings[idx], &scene, tolerance, &mut text);
            text.push("</g>\n");
            text.flush_if_large(out)?;
        }
        text.push(if layer.is_some() { "</g>\n" } else { "" });
    }
    text.push("</g>\n");
    legend::draw(legends, &sheet, &mut text);
    marks::draw_labels(job, view, &sheet, &mut text);
    marks::draw_scale(job, &sheet, &mut text);
    text.push("</svg>\n");
    text.flush(out)?;
    Ok(summary)
}

/// The items by layer, layers in the order of their first item, those without one before all.
fn layers(items: &[Item]) -> UniqueValues<Option<&str>, Vec<usize>> {
    let mut layers = UniqueValues::default();
    layers.entry(&None, Vec::new);
    for (idx, item) in items.iter().enumerate() {
        layers.entry(&item.layer.as_deref(), Vec::new).1.push(idx);
    }
    layers
}

/// The paper: where the drawing lies on it, and how thick its lines are.
struct SvgSheet {
    /// Least x and y of the drawing on paper with its margin, y downward.
    corner: [f64; 2],
    /// Width and height.
    extent: [f64; 2],
    stroke: f64,
    decimals: usize,
}

impl SvgSheet {
    fn new(job: &Job, bounds: Bounds) -> Self {
        let size = bounds.size().truncate().length();
        let size = if size == 0.0 { 1.0 } else { size };
        let (stroke, margin) = (STROKE * size, MARGIN * STROKE * size);
        let is_hairline = job.options.is_hairline;
        let stroke = if is_hairline { HAIRLINE_WIDTH / job.millimetres } else { stroke };
        let mut extent = (bounds.size().truncate() + 2.0 * margin).to_array();
        if job.picture.as_ref().is_some_and(|picture| !picture.legends.is_empty()) {
            extent[0] += legend::WIDTH * stroke;
        }
        if job.picture.as_ref().is_some_and(|picture| picture.has_scale) {
            extent[1] += marks::HEIGHT * stroke;
        }
        let digits = -libm::log10(DRAWING_DIGIT * size).floor();
        let decimals = job.options.decimals.unwrap_or(digits.clamp(0.0, 17.0) as usize);
        let corner = [bounds.min.x - margin, -bounds.max.y - margin];
        Self { corner, extent, stroke, decimals }
    }

    fn head(&self, job: &Job, text: &mut TextBuffer) {
        text.push("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
        text.push("<svg xmlns=\"http://www.w3.org/2000/svg\"");
        text.push(
            " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\"",
        );
        let [width, height] = self.extent.map(|length| length * job.millimetres);
        if let Some(picture) = &job.picture {
            let [width, height] = picture.size.map(|pixels| pixels.to_string());
            text.push(" width=\"").push(&width).push("\" height=\"").push(&height).push("\"");
        } else if PAPER.contains(&width.max(height)) {
            text.push(" width=\"").number(width).push("mm\" height=\"").number(height).push("mm\"");
        }
        text.push(" viewBox=\"");
        for (i, number) in self.corner.into_iter().chain(self.extent).enumerate() {
            text.push(if i == 0 { "" } else { " " }).number(number);
        }
        text.push("\">\n<desc>unit: ").push(job.unit).push("</desc>\n");
        text.push("<g fill=\"none\" stroke=\"#000000\" stroke-width=\"").number(self.stroke);
        text.push("\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n");
    }

    /// Fills the triangles that are seen, as far as their middle tells. A thin line of the same
    /// colour closes the gaps between them.
    fn fill(&self, drawing: &Drawing, scene: &HidingScene, text: &mut TextBuffer) {
        let is_seen = |corners: &[DVec3; 3]| scene.is_seen(corners.iter().sum::<DVec3>() / 3.0);
        let seen = drawing.fills.iter().filter(|(corners, _)| is_seen(corners));
        for (corners, color) in seen {
            let mut pen = Pen::new(self.decimals);
            pen.polygon(corners);
            let color = hex(*color);
            text.push("<path fill=\"").push(&color).push("\" stroke=\"").push(&color);
            text.push("\" stroke-width=\"").number(FILL * self.stroke).push("\" d=\"");
            text.append(&pen.text).push("Z\"/>\n");
        }
    }

    /// Draws what is seen of an item.
    fn draw(
        &self,
        item: &Item,
        drawing: &Drawing,
        scene: &HidingScene,
        tolerance: f64,
        text: &mut TextBuffer,
    ) {
        self.fill(drawing, scene, text);
        for weight in [LineWeight::Full, LineWeight::Half] {
            let mut pen = Pen::new(self.decimals);
            let of_weight = drawing.lines.iter().filter(|(its, _)| *its == weight);
            for (_, line) in of_weight {
                match line {
                    DrawnLine::Curve(curve) => {
                        for part in scene.seen_parts(curve) {
                            pen.curve(&part, tolerance);
                        }
                    }
                    DrawnLine::Polygon(points) => {
                        for part in scene.seen_pieces(points) {
                            pen.polygon(&part);
                        }
                    }
                }
            }
            if !pen.text.is_empty() {
                text.push("<path");
                if weight == LineWeight::Half {
                    text.push(" stroke-width=\"")
                        .number(0.5 * item.line_width * self.stroke)
                        .push("\"");
                }
                text.push(" d=\"").append(&pen.text).push("\"/>\n");
            }
        }
        for &point in drawing.points.iter().filter(|&&point| scene.is_seen(point)) {
            text.push("<circle cx=\"").number(point.x).push("\" cy=\"").number(-point.y);
            text.push("\" r=\"")
                .number(POINT * item.line_width * self.stroke)
                .push("\" stroke=\"none\" fill=\"");
            text.push(&hex(item.color.unwrap_or_default())).push("\"/>\n");
        }
    }
}

/// `#6688aa`
fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}
