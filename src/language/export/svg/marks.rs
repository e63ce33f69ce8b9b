//! What is written on the drawing: names beside places, and a scale below.

use glam::DVec2;

use super::{
    super::{Job, labels, projection::Projection, text::TextBuffer, xml::escaped},
    SvgSheet,
    legend::LETTER,
};

/// Height of the scale with the space around it, in strokes.
pub(super) const HEIGHT: f64 = 24.0;
/// The scale is at most this part of the drawing's width.
const SCALE: f64 = 0.25;
/// Height of the marks at its ends, in strokes.
const MARK: f64 = 6.0;
/// Height of capitals and width of a letter on average, in heights of a line.
const CAPITAL: f64 = 0.72;
const WIDTH: f64 = 0.6;
/// Width of the white around letters, in strokes.
const HALO: f64 = 2.5;

/// Writes the labels, each beside its place.
pub(super) fn draw_labels(job: &Job, view: &Projection, sheet: &SvgSheet, text: &mut TextBuffer) {
    let Some(picture) = &job.picture else { return };
    let em = LETTER * sheet.stroke;
    let places: Vec<(DVec2, f64)> = picture
        .labels
        .iter()
        .map(|label| {
            let place = label.place_seen(view);
            (DVec2::new(place.x, -place.y), WIDTH * em * label.text.chars().count() as f64)
        })
        .collect();
    let corners = labels::arranged(&places, CAPITAL * em);
    for (label, corner) in picture.labels.iter().zip(corners) {
        text.push("<text class=\"label\" font-family=\"sans-serif\" font-size=\"").number(em);
        text.push("\" stroke=\"#ffffff\" stroke-width=\"").number(HALO * sheet.stroke);
        text.push("\" paint-order=\"stroke\" x=\"").number(corner.x);
        text.push("\" y=\"").number(corner.y + CAPITAL * em).push("\">");
        text.push(&escaped(&label.text)).push("</text>\n");
    }
}

/// Draws how long a round length is, at the lower left.
pub(super) fn draw_scale(job: &Job, sheet: &SvgSheet, text: &mut TextBuffer) {
    if !job.picture.as_ref().is_some_and(|picture| picture.has_scale) {
        return;
    }
    let stroke = sheet.stroke;
    let length = labels::round_length(SCALE * sheet.extent[0]);
    let (left, half) = (sheet.corner[0] + MARK * stroke, 0.5 * MARK * stroke);
    let middle = sheet.corner[1] + sheet.extent[1] - MARK * stroke;
    let right = left + length;
    text.push("<g class=\"scale\" stroke=\"#000000\" stroke-width=\"").number(stroke).push("\">\n");
    for [from, to] in [
        [[left, middle], [right, middle]],
        [[left, middle - half], [left, middle + half]],
        [[right, middle - half], [right, middle + half]],
    ] {
        text.push("<line x1=\"").number(from[0]).push("\" y1=\"").number(from[1]);
        text.push("\" x2=\"").number(to[0]).push("\" y2=\"").number(to[1]).push("\"/>\n");
    }
    text.push("</g>\n<text font-family=\"sans-serif\" font-size=\"").number(LETTER * stroke);
    text.push("\" x=\"").number(right + MARK * stroke);
    text.push("\" y=\"").number(middle + 0.5 * CAPITAL * LETTER * stroke).push("\">");
    text.push(&escaped(&labels::scale_text(length, job.unit))).push("</text>\n");
}
