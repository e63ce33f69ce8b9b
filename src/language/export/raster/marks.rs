//! What is written on the picture: names beside places, and a scale below.

use glam::{DVec2, DVec3};

use super::{
    super::{DefinitionLabel, Job, Picture, labels},
    scene::RasterScene,
    sheet::{GAP, PictureSheet},
};

/// The scale is at most this part of the picture's width.
const SCALE: f64 = 0.25;
/// Height of the marks at its ends, in pixels before they are enlarged.
const MARK: usize = 6;

/// Writes the labels, each beside its place.
pub(super) fn draw_labels(picture: &Picture, scene: &RasterScene, pixels: &mut [u8]) {
    let mut sheet = PictureSheet::new(picture, pixels);
    let place = |label: &DefinitionLabel| (scene.pixel_of(label), sheet.width_of(&label.text));
    let places: Vec<(DVec2, f64)> = picture.labels.iter().map(place).collect();
    let corners = labels::arranged(&places, sheet.letter());
    for (label, corner) in picture.labels.iter().zip(corners) {
        sheet.text_on_white(&label.text, corner);
    }
}

/// Draws how long a round length is, at the lower left.
pub(super) fn draw_scale(job: &Job, picture: &Picture, scene: &RasterScene, pixels: &mut [u8]) {
    if !picture.has_scale {
        return;
    }
    let per_unit = scene.pixels_per_unit();
    let length = labels::round_length(SCALE * picture.size[0] as f64 / per_unit);
    let mut sheet = PictureSheet::new(picture, pixels);
    let (gap, mark) = (sheet.times * GAP, sheet.times * MARK);
    let n_pixels = ((length * per_unit).round() as usize).min(sheet.size[0]);
    let bottom = sheet.size[1].saturating_sub(gap);
    let line = bottom.saturating_sub(mark / 2);
    for row in 0..sheet.times {
        for column in 0..=n_pixels {
            sheet.set([gap + column, line + row], DVec3::ZERO);
        }
    }
    for row in bottom.saturating_sub(mark)..=bottom {
        for column in 0..sheet.times {
            sheet.set([gap + column, row], DVec3::ZERO);
            sheet.set([gap + n_pixels - column.min(n_pixels), row], DVec3::ZERO);
        }
    }
    let corner = DVec2::new((2 * gap + n_pixels) as f64, bottom as f64 - sheet.letter());
    sheet.text(&labels::scale_text(length, job.unit), corner);
}
