//! How a definition is presented: what `with (color = ..., layer = ..., hidden = ...)` says.

use std::sync::Arc;

/// The presentation of a definition. It changes no geometry.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Look {
    /// Red, green and blue of sRGB.
    pub color: Option<[u8; 3]>,
    /// The layer that files put it on.
    pub layer: Option<Arc<str>>,
    /// Whether `all` leaves it out.
    pub is_hidden: bool,
}

/// The colours that have a name: those of CSS Color Module Level 4, §6.1, that people use.
pub const COLOR_NAMES: &[(&str, [u8; 3])] = &[
    ("black", [0, 0, 0]),
    ("blue", [0, 0, 255]),
    ("brown", [165, 42, 42]),
    ("coral", [255, 127, 80]),
    ("crimson", [220, 20, 60]),
    ("cyan", [0, 255, 255]),
    ("darkblue", [0, 0, 139]),
    ("darkgray", [169, 169, 169]),
    ("darkgreen", [0, 100, 0]),
    ("darkorange", [255, 140, 0]),
    ("darkred", [139, 0, 0]),
    ("dimgray", [105, 105, 105]),
    ("forestgreen", [34, 139, 34]),
    ("gold", [255, 215, 0]),
    ("gray", [128, 128, 128]),
    ("green", [0, 128, 0]),
    ("grey", [128, 128, 128]),
    ("indigo", [75, 0, 130]),
    ("lightblue", [173, 216, 230]),
    ("lightgray", [211, 211, 211]),
    ("lightgreen", [144, 238, 144]),
    ("lime", [0, 255, 0]),
    ("magenta", [255, 0, 255]),
    ("maroon", [128, 0, 0]),
    ("navy", [0, 0, 128]),
    ("olive", [128, 128, 0]),
    ("orange", [255, 165, 0]),
    ("pink", [255, 192, 203]),
    ("purple", [128, 0, 128]),
    ("red", [255, 0, 0]),
    ("royalblue", [65, 105, 225]),
    ("salmon", [250, 128, 114]),
    ("silver", [192, 192, 192]),
    ("skyblue", [135, 206, 235]),
    ("slategray", [112, 128, 144]),
    ("steelblue", [70, 130, 180]),
    ("tan", [210, 180, 140]),
    ("teal", [0, 128, 128]),
    ("tomato", [255, 99, 71]),
    ("turquoise", [64, 224, 208]),
    ("violet", [238, 130, 238]),
    ("white", [255, 255, 255]),
    ("yellow", [255, 255, 0]),
];

/// The colour that a text names: `#rrggbb`, `#rgb`, or one of [`COLOR_NAMES`].
///
/// ```
/// use virote::value::color_of;
///
/// assert_eq!(color_of("#6688aa"), Some([0x66, 0x88, 0xaa]));
/// assert_eq!(color_of("#68A"), Some([0x66, 0x88, 0xaa]));
/// assert_eq!(color_of("red"), Some([255, 0, 0]));
/// assert_eq!(color_of("#12345"), None);
/// ```
#[must_use]
pub fn color_of(text: &str) -> Option<[u8; 3]> {
    let Some(digits) = text.strip_prefix('#') else {
        return COLOR_NAMES.iter().find(|(name, _)| *name == text).map(|&(_, color)| color);
    };
    let digits: Vec<u8> =
        digits.chars().map(|c| c.to_digit(16).map(|digit| digit as u8)).collect::<Option<_>>()?;
    match digits[..] {
        [r, g, b] => Some([r, g, b].map(|digit| 17 * digit)),
        [r, s, g, h, b, c] => Some([16 * r + s, 16 * g + h, 16 * b + c]),
        _ => None,
    }
}
