//! What colours mean: a bar with values beside the picture.

use glam::{DVec2, DVec3};

use super::{
    super::{Legend, Picture},
    sheet::{GAP, LETTER, PictureSheet, enlargement},
};

/// Width of a line of text, in heights of its capitals.
const LINE: usize = 13;
/// Width of a bar, in heights of capitals.
const BAR: usize = 2;
/// Length of the mark at a label, in pixels before they are enlarged.
const TICK: usize = 3;

/// Pixels at the right that legends take; a picture of less than three times that has no room.
pub(in super::super) fn width(picture: &Picture) -> usize {
    let width = enlargement(picture) * (LINE * LETTER + GAP);
    if picture.legends.is_empty() || picture.size[0] < 3 * width { 0 } else { width }
}

/// Draws the legends, one below the other.
pub(super) fn draw(picture: &Picture, pixels: &mut [u8]) {
    let n_legends = picture.legends.len();
    let width = width(picture);
    if width == 0 {
        return;
    }
    let height = picture.size[1] / n_legends;
    let mut sheet = PictureSheet::new(picture, pixels);
    for (i, legend) in picture.legends.iter().enumerate() {
        sheet.legend(legend, [picture.size[0] - width, i * height], height);
    }
}

impl PictureSheet<'_> {
    /// Draws a legend with its upper left corner in a place.
    fn legend(&mut self, legend: &Legend, [x, y]: [usize; 2], height: usize) {
        let (gap, letter) = (self.times * GAP, self.times * LETTER);
        let corner = |[x, y]: [usize; 2]| DVec2::new(x as f64, y as f64);
        for (i, line) in legend.title.split(": ").enumerate() {
            self.text(line, corner([x, y + gap + i * (letter + gap / 2)]));
        }
        let n_lines = legend.title.split(": ").count();
        let top = y + gap + n_lines * (letter + gap / 2) + gap;
        let bottom = (y + height).saturating_sub(3 * gap);
        let n_rows = bottom.saturating_sub(top);
        for row in 0..n_rows {
            let share = 1.0 - (row as f64 + 0.5) / n_rows as f64;
            let color = legend.color_at(share);
            for column in 0..BAR * letter {
                self.set([x + column, top + row], color);
            }
        }
        for (share, label) in legend.labels() {
            let at = top + ((n_rows as f64 * (1.0 - share)) as usize).min(n_rows.saturating_sub(1));
            let right = x + BAR * letter;
            for column in 0..self.times * TICK {
                self.set([right + column, at], DVec3::ZERO);
            }
            self.text(&label, corner([right + gap, at.saturating_sub(letter / 2)]));
        }
    }
}
