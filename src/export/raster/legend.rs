//! What colours mean: a bar with values beside the picture.

use font8x8::legacy::BASIC_LEGACY;
use glam::DVec3;

use super::super::{Legend, Picture};

/// Pixels of a letter on each side, before it is enlarged.
const LETTER: usize = 8;
/// Letters in a line.
const LINE: usize = 13;
/// Width of a bar, in letters.
const BAR: usize = 2;
/// Free space, in pixels before they are enlarged.
const GAP: usize = 6;
/// Letters are enlarged once for each so many pixels of the picture's smaller side.
const PIXELS_PER_SIZE: usize = 480;

/// How many times letters are enlarged.
fn enlargement(picture: &Picture) -> usize {
    (picture.size[0].min(picture.size[1]) / PIXELS_PER_SIZE).max(1)
}

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
    let mut sheet = PictureSheet { pixels, size: picture.size, times: enlargement(picture) };
    for (i, legend) in picture.legends.iter().enumerate() {
        sheet.legend(legend, [picture.size[0] - width, i * height], height);
    }
}

/// The picture as something to write on.
struct PictureSheet<'a> {
    pixels: &'a mut [u8],
    size: [usize; 2],
    /// How many times letters are enlarged.
    times: usize,
}

impl PictureSheet<'_> {
    /// Draws a legend with its upper left corner in a place.
    fn legend(&mut self, legend: &Legend, [x, y]: [usize; 2], height: usize) {
        let (gap, letter) = (self.times * GAP, self.times * LETTER);
        for (i, line) in legend.title.split(": ").enumerate() {
            self.text(line, [x, y + gap + i * (letter + gap / 2)]);
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
        let values = legend.values();
        let last = values.len().saturating_sub(1).max(1);
        // Each second value, beside its place.
        for (i, value) in values.into_iter().enumerate().filter(|(i, _)| i % 2 == 0) {
            let at = top + n_rows * (last - i) / last;
            let beside = x + BAR * letter + gap;
            self.text(&Legend::label(value), [beside, at.saturating_sub(letter / 2)]);
        }
    }

    /// Writes a line of text; a letter that the alphabet does not have is a question mark.
    fn text(&mut self, text: &str, [x, y]: [usize; 2]) {
        for (i, c) in text.chars().take(LINE).enumerate() {
            let letter = BASIC_LEGACY.get(c as usize).or(BASIC_LEGACY.get(usize::from(b'?')));
            for (row, bits) in letter.into_iter().flatten().enumerate() {
                for column in (0..LETTER).filter(|column| bits >> column & 1 == 1) {
                    self.dot([x + self.times * (i * LETTER + column), y + self.times * row]);
                }
            }
        }
    }

    /// A dot of a letter.
    fn dot(&mut self, [x, y]: [usize; 2]) {
        for row in 0..self.times {
            for column in 0..self.times {
                self.set([x + column, y + row], DVec3::ZERO);
            }
        }
    }

    /// Colours a pixel, if it is on the picture.
    fn set(&mut self, [x, y]: [usize; 2], color: DVec3) {
        if x < self.size[0] && y < self.size[1] {
            let place = 3 * (y * self.size[0] + x);
            let bytes = color.to_array().map(|level| (255.0 * level).round() as u8);
            self.pixels[place..place + 3].copy_from_slice(&bytes);
        }
    }
}
