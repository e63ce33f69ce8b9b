//! Many small pictures on one sheet, each with a line of text below.

use std::io::{self, Cursor, Write};

use glam::DVec2;

use super::{
    super::Picture,
    encode,
    sheet::{GAP, LETTER, PictureSheet},
};

/// A small picture with what stands below it.
#[derive(Clone, Debug)]
pub struct Thumbnail {
    label: String,
    size: [usize; 2],
    /// Red, green and blue, row by row; none of a picture that is missing.
    pixels: Vec<u8>,
}

/// The width of a small picture is at most this.
const WIDTH: usize = 200;

impl Thumbnail {
    /// The size of what stands where a picture is missing.
    const EMPTY: [usize; 2] = [WIDTH, WIDTH * 3 / 4];

    /// A picture in PNG made small, by the mean of squares of its pixels.
    ///
    /// # Errors
    /// That it is no picture of ours.
    pub fn of(label: String, png: &[u8]) -> io::Result<Self> {
        let mut reader =
            png::Decoder::new(Cursor::new(png)).read_info().map_err(io::Error::other)?;
        let too_large = || io::Error::other("the picture is too large");
        let mut pixels = vec![0; reader.output_buffer_size().ok_or_else(too_large)?];
        let info = reader.next_frame(&mut pixels).map_err(io::Error::other)?;
        if info.color_type != png::ColorType::Rgb || info.bit_depth != png::BitDepth::Eight {
            return Err(io::Error::other("the picture was not made by this program"));
        }
        let [width, height] = [info.width, info.height].map(|side| side as usize);
        let factor = width.div_ceil(WIDTH).max(1);
        let size = [width / factor, height / factor];
        let mut small = Vec::with_capacity(3 * size[0] * size[1]);
        for y in 0..size[1] {
            for x in 0..size[0] {
                for channel in 0..3 {
                    let byte = |dx: usize, dy: usize| {
                        let place = (factor * y + dy) * width + factor * x + dx;
                        usize::from(pixels[3 * place + channel])
                    };
                    let square = (0..factor).flat_map(|dy| (0..factor).map(move |dx| (dx, dy)));
                    let sum: usize = square.map(|(dx, dy)| byte(dx, dy)).sum();
                    small.push((sum / (factor * factor)) as u8);
                }
            }
        }
        Ok(Self { label, size, pixels: small })
    }

    /// What stands where a picture is missing.
    #[must_use]
    pub fn missing(label: String) -> Self {
        Self { label, size: Self::EMPTY, pixels: Vec::new() }
    }
}

/// Writes the sheet, with so many pictures in a row.
pub fn write_sheet(
    thumbnails: &[Thumbnail],
    n_columns: usize,
    out: &mut dyn Write,
) -> io::Result<()> {
    let largest = |axis: usize| thumbnails.iter().map(|one| one.size[axis]).max().unwrap_or(0);
    let cell = [largest(0) + GAP, largest(1) + LETTER + 3 * GAP];
    let n_rows = thumbnails.len().div_ceil(n_columns.max(1)).max(1);
    let size = [n_columns.max(1) * cell[0] + GAP, n_rows * cell[1] + GAP];
    let mut pixels = vec![u8::MAX; 3 * size[0] * size[1]];
    for (i, one) in thumbnails.iter().enumerate() {
        let [x, y] = [GAP + i % n_columns * cell[0], GAP + i / n_columns * cell[1]];
        for (row, line) in one.pixels.chunks_exact(3 * one.size[0].max(1)).enumerate() {
            let start = 3 * ((y + row) * size[0] + x);
            pixels[start..start + line.len()].copy_from_slice(line);
        }
        let mut sheet = PictureSheet::new(&Picture::new(size), &mut pixels);
        sheet.times = 1;
        let room = one.size[0] as f64;
        let mut label = one.label.clone();
        while room < sheet.width_of(&label) && label.pop().is_some() {}
        let corner = DVec2::new(x as f64, (y + cell[1] - LETTER - 2 * GAP) as f64);
        sheet.text(&label, corner);
    }
    encode(size, &pixels, out)
}

#[cfg(test)]
mod tests {
    use super::{Thumbnail, encode, write_sheet};

    #[test]
    fn pictures_are_made_small_and_stand_in_rows() {
        // The left half is black, the right half is red.
        let pixel = |x: usize| if x < 400 { [0, 0, 0] } else { [200, 0, 0] };
        let pixels: Vec<u8> = (0..800 * 600).flat_map(|place| pixel(place % 800)).collect();
        let mut png = Vec::new();
        encode([800, 600], &pixels, &mut png).expect("a picture");
        let one = Thumbnail::of("1".to_owned(), &png).expect("a small picture");
        assert_eq!(one.size, [200, 150]);
        assert_eq!(
            (&one.pixels[3 * 99..3 * 100], &one.pixels[3 * 100..3 * 101]),
            (&[0, 0, 0][..], &[200, 0, 0][..])
        );
        let mut sheet = Vec::new();
        write_sheet(&[one.clone(), Thumbnail::missing("2".to_owned()), one], 2, &mut sheet)
            .expect("a sheet");
        let reader = png::Decoder::new(std::io::Cursor::new(sheet)).read_info().expect("a picture");
        assert_eq!((reader.info().width, reader.info().height), (418, 358));
        assert!(Thumbnail::of(String::new(), b"no picture").is_err());
    }
}
