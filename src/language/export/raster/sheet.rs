//! A picture as something to write on: letters as strokes, of a size that suits the picture.

use glam::{DVec2, DVec3};

use super::{super::Picture, font};

/// Height of capitals in pixels, before they are enlarged.
pub(super) const LETTER: usize = 8;
/// Free space, in pixels before it is enlarged.
pub(super) const GAP: usize = 6;
/// Width of a line of a letter, in pixels before it is enlarged.
const STROKE: f64 = 1.2;
/// Width of the white around letters that stand on something, in widths of their lines.
const HALO: f64 = 3.5;
/// Letters are enlarged once for each so many pixels of the picture's smaller side.
const PIXELS_PER_SIZE: usize = 480;

/// How many times letters are enlarged.
pub(super) fn enlargement(picture: &Picture) -> usize {
    (picture.size[0].min(picture.size[1]) / PIXELS_PER_SIZE).max(1)
}

/// Pixels at the bottom that the scale takes.
pub(super) fn scale_height(picture: &Picture) -> usize {
    if picture.has_scale { enlargement(picture) * (LETTER + 3 * GAP) } else { 0 }
}

/// The picture as something to write on.
pub(super) struct PictureSheet<'a> {
    pixels: &'a mut [u8],
    pub(super) size: [usize; 2],
    /// How many times letters are enlarged.
    pub(super) times: usize,
}

impl<'a> PictureSheet<'a> {
    pub(super) fn new(picture: &Picture, pixels: &'a mut [u8]) -> Self {
        Self { pixels, size: picture.size, times: enlargement(picture) }
    }

    /// Height of capitals in pixels.
    pub(super) fn letter(&self) -> f64 {
        (self.times * LETTER) as f64
    }

    /// The width of a line of text in pixels.
    pub(super) fn width_of(&self, text: &str) -> f64 {
        self.letter() / font::CAPITAL * font::width(text)
    }

    /// Writes a line of text with its upper left corner in a place, as far as there is room.
    pub(super) fn text(&mut self, text: &str, corner: DVec2) {
        for leg in self.legs(text, corner) {
            self.stroke(leg, STROKE, |level, cover| level.min(1.0 - cover));
        }
    }

    /// The same, with white around the letters.
    pub(super) fn text_on_white(&mut self, text: &str, corner: DVec2) {
        for leg in self.legs(text, corner) {
            self.stroke(leg, HALO * STROKE, f64::max);
        }
        self.text(text, corner);
    }

    fn legs(&self, text: &str, corner: DVec2) -> Vec<[DVec2; 2]> {
        let unit = self.letter() / font::CAPITAL;
        let room = (self.size[0] as f64 - corner.x).max(0.0);
        let foot = corner + DVec2::new(0.0, self.letter());
        let legs = font::legs(text, room / unit).into_iter();
        legs.map(|leg| leg.map(|place| foot + unit * DVec2::new(place.x, -place.y))).collect()
    }

    /// Changes the levels of the pixels along a leg of a stroke by how much of them it covers.
    fn stroke(&mut self, [from, to]: [DVec2; 2], width: f64, change: impl Fn(f64, f64) -> f64) {
        let half = 0.5 * width * self.times as f64;
        let (low, high) = (from.min(to) - half - 1.0, from.max(to) + half + 1.0);
        let leg = to - from;
        let end = |high: f64, side: usize| (high.max(0.0) as usize + 1).min(side);
        for y in low.y.max(0.0) as usize..end(high.y, self.size[1]) {
            for x in low.x.max(0.0) as usize..end(high.x, self.size[0]) {
                let center = DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
                let share = ((center - from).dot(leg) / leg.length_squared()).clamp(0.0, 1.0);
                let distance = center.distance(from + share * leg);
                let cover = (half + 0.5 - distance).clamp(0.0, 1.0);
                let place = 3 * (y * self.size[0] + x);
                for byte in &mut self.pixels[place..place + 3] {
                    let level = change(f64::from(*byte) / 255.0, cover);
                    *byte = (255.0 * level).round() as u8;
                }
            }
        }
    }

    /// Colours a pixel, if it is on the picture.
    pub(super) fn set(&mut self, [x, y]: [usize; 2], color: DVec3) {
        if x < self.size[0] && y < self.size[1] {
            let place = 3 * (y * self.size[0] + x);
            let bytes = color.to_array().map(|level| (255.0 * level).round() as u8);
            self.pixels[place..place + 3].copy_from_slice(&bytes);
        }
    }
}
