//! Paths on paper.

/// Triangles that decide what a drawing hides may be this fraction of the whole's size away from
/// their surfaces.
///
/// Larger lets lines show through walls thinner than a few times that; smaller takes longer and
/// shows on no paper.
pub const HIDDEN_RELATIVE: f64 = 2.5e-4;

/// A path of a drawing may be this fraction of the whole's size away from a curve that no cubic
/// can be.
///
/// Larger shows when one zooms in; smaller writes more pieces than anybody sees.
pub const PATH_RELATIVE: f64 = 1e-6;

/// No path, polygon or mesh is asked to be nearer to its curve or surface than this fraction of the
/// largest coordinate.
///
/// Larger shows corners on what is small and far from the origin, and refuses meshes of it; smaller
/// asks for less than the rounding of a point, so that pieces are halved to the ceiling everywhere.
pub const PATH_ROUNDING: f64 = 4e-15;

/// Millimetres of a hairline, which laser cutters take for a path.
///
/// Larger is engraved by some as an area; smaller is not seen on a screen.
pub const HAIRLINE_WIDTH: f64 = 0.01;

/// Coordinates of a drawing are rounded to this fraction of its size, unless the script says how.
///
/// Larger moves joints that zooming in shows; smaller writes digits that are rounding.
pub const DRAWING_DIGIT: f64 = 1e-9;

/// Lines of light on a screen may be this fraction of the size of what they lie on away from where they are.
///
/// Larger shows when one zooms in fifty times; smaller takes longer and shows nothing more.
pub const SEEN_LINE_RELATIVE: f64 = 2e-5;
