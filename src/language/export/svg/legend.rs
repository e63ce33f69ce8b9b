//! What colours mean: a bar with values beside the drawing.

use super::{
    super::{Legend, shape::byte_color, text::TextBuffer, xml::escaped},
    SvgSheet, hex,
};

/// Width of the legends, in strokes.
pub(super) const WIDTH: f64 = 90.0;
/// Width of a bar, in strokes.
const BAR: f64 = 15.0;
/// Length of the mark at a label, in strokes.
const TICK: f64 = 3.0;
/// Height of letters, in strokes.
pub(super) const LETTER: f64 = 12.0;
/// Pieces of a bar between two values.
const N_PIECES: usize = 8;

/// Draws the legends at the right, one below the other.
pub(super) fn draw(legends: &[Legend], sheet: &SvgSheet, text: &mut TextBuffer) {
    let left = sheet.corner[0] + sheet.extent[0] - WIDTH * sheet.stroke;
    let height = sheet.extent[1] / legends.len().max(1) as f64;
    for (i, legend) in legends.iter().enumerate() {
        let top = sheet.corner[1] + i as f64 * height;
        text.push("<g class=\"legend\" font-family=\"sans-serif\" font-size=\"");
        text.number(LETTER * sheet.stroke).push("\">\n");
        bar(legend, [left, top], height, sheet.stroke, text);
        text.push("</g>\n");
    }
}

fn bar(legend: &Legend, [left, top]: [f64; 2], height: f64, stroke: f64, text: &mut TextBuffer) {
    let line = 1.5 * LETTER * stroke;
    write(&legend.title, [left, top + line], text);
    let (top, height) = (top + 2.0 * line, height - 3.0 * line);
    let n_pieces = N_PIECES * legend.stops.len().saturating_sub(1);
    for i in 0..n_pieces {
        let color = hex(byte_color(legend.color_at(1.0 - (i as f64 + 0.5) / n_pieces as f64)));
        let piece = height / n_pieces as f64;
        text.push("<rect x=\"").number(left).push("\" y=\"").number(top + i as f64 * piece);
        text.push("\" width=\"").number(BAR * stroke).push("\" height=\"").number(piece);
        text.push("\" fill=\"").push(&color).push("\"/>\n");
    }
    for (share, label) in legend.labels() {
        let (at, right) = (top + height * (1.0 - share), left + BAR * stroke);
        text.push("<line x1=\"").number(right).push("\" y1=\"").number(at);
        text.push("\" x2=\"").number(right + TICK * stroke).push("\" y2=\"").number(at);
        text.push("\" stroke=\"#000000\" stroke-width=\"").number(0.5 * stroke).push("\"/>\n");
        let place = [right + (TICK + 3.0) * stroke, at + 0.35 * LETTER * stroke];
        write(&label, place, text);
    }
}

fn write(words: &str, [x, y]: [f64; 2], text: &mut TextBuffer) {
    text.push("<text x=\"").number(x).push("\" y=\"").number(y).push("\">");
    text.push(&escaped(words)).push("</text>\n");
}
