//! The lines of equal parameter of an item, as many as somebody wants to see.

use super::{
    encode::{EncodingItem, Fineness},
    parts::Shape,
};
use crate::kernel::GeomError;

/// The bytes of an item that has the lines of a shape, `n` inside in each direction, with their curvatures.
///
/// # Errors
/// Those of the lines.
pub(crate) fn isolines(shape: &Shape, n: usize, fineness: &Fineness) -> Result<Vec<u8>, GeomError> {
    let mut item = EncodingItem::new(shape, n, fineness);
    match shape {
        Shape::Face(face) => item.add_face_lines(face)?,
        shape => item.add_surface_lines(shape.surfaces())?,
    }
    Ok(item.writer.finish())
}
