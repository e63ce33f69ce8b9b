//! What colours mean: a bar with values beside the picture.

use glam::{DVec2, DVec3};

use super::{
    super::{Legend, Picture},
    font,
};

/// Height of capitals in pixels, before they are enlarged.
const LETTER: usize = 8;
/// Width of a line of text, in heights of its capitals.
const LINE: usize = 13;
/// Width of a line of a letter, in pixels before it is enlarged.
const STROKE: f64 = 1.2;
/// Width of a bar, in heights of capitals.
const BAR: usize = 2;
/// Length of the mark at a label, in pixels before they are enlarged.
const TICK: usize = 3;
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
        for (share, label) in legend.labels() {
            let at = top + ((n_rows as f64 * (1.0 - share)) as usize).min(n_rows.saturating_sub(1));
            let right = x + BAR * letter;
            for column in 0..self.times * TICK {
                self.set([right + column, at], DVec3::ZERO);
            }
            self.text(&label, [right + gap, at.saturating_sub(letter / 2)]);
        }
    }

    /// Writes a line of text with its upper left corner in a place, as far as there is room.
    fn text(&mut self, text: &str, [x, y]: [usize; 2]) {
        let unit = (self.times * LETTER) as f64 / font::CAPITAL;
        let room = self.size[0].saturating_sub(x) as f64;
        let corner = DVec2::new(x as f64, (y + self.times * LETTER) as f64);
        for leg in font::legs(text, room / unit) {
            self.stroke(leg.map(|place| corner + unit * DVec2::new(place.x, -place.y)));
        }
    }

    /// Darkens the pixels along a leg of a stroke by how much of them it covers.
    fn stroke(&mut self, [from, to]: [DVec2; 2]) {
        let half = 0.5 * STROKE * self.times as f64;
        let (low, high) = (from.min(to) - half - 1.0, from.max(to) + half + 1.0);
        let leg = to - from;
        for y in low.y.max(0.0) as usize..=high.y.max(0.0) as usize {
            for x in low.x.max(0.0) as usize..=high.x.max(0.0) as usize {
                let center = DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
                let share = ((center - from).dot(leg) / leg.length_squared()).clamp(0.0, 1.0);
                let distance = center.distance(from + share * leg);
                self.darken([x, y], (half + 0.5 - distance).clamp(0.0, 1.0));
            }
        }
    }

    /// Makes a pixel at least so dark, if it is on the picture.
    fn darken(&mut self, [x, y]: [usize; 2], darkness: f64) {
        if x < self.size[0] && y < self.size[1] {
            let place = 3 * (y * self.size[0] + x);
            let level = (255.0 * (1.0 - darkness)).round() as u8;
            for byte in &mut self.pixels[place..place + 3] {
                *byte = (*byte).min(level);
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
