//! The colours that a script names.

use std::ops::Range;

use super::Document;
use crate::value::{COLOR_NAMES, color_of};

/// Red, green and blue of sRGB.
pub type Color = [u8; 3];

/// The strings of a text that are a colour, as the value of a label that ends with `color`.
#[must_use]
pub fn colors(document: &Document) -> Vec<(Range<usize>, Color)> {
    let texts = document.outline().texts.iter();
    let colored =
        texts.filter(|(.., label)| label.as_ref().is_some_and(|label| label.ends_with("color")));
    colored.filter_map(|(range, text, _)| Some((range.clone(), color_of(text)?))).collect()
}

/// How a colour can be written, in quotes: by its name where it has one, in hexadecimal digits.
#[must_use]
pub fn spellings(color: Color) -> Vec<String> {
    let [r, g, b] = color;
    let names = COLOR_NAMES
        .iter()
        .filter(|(_, known)| *known == color)
        .map(|(name, _)| format!("\"{name}\""));
    names.chain([format!("\"#{r:02x}{g:02x}{b:02x}\"")]).collect()
}
