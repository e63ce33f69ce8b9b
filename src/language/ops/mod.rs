//! The built-in operations, one file each, in families.
//!
//! A family is a folder and the list of its operations; nothing outside names one of them.

mod combined;
mod constant;
mod convert;
mod curve;
mod edit;
mod face;
mod list;
mod math;
mod measure;
mod mesh;
mod region;
mod search;
mod solid;
mod surface;
mod text;
mod transform;
mod vector;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    value::{Length, Registry, shortest},
};

pub use mesh::loaded_endings;
pub use mesh::{CsvCell, CsvRow, csv_rows};

/// Everything that a script can use without defining it.
#[must_use]
pub fn registry() -> Registry {
    [
        curve::OPS,
        convert::OPS,
        surface::OPS,
        edit::OPS,
        transform::OPS,
        face::OPS,
        measure::OPS,
        region::OPS,
        solid::OPS,
        mesh::OPS,
        math::OPS,
        search::OPS,
        vector::OPS,
        list::OPS,
        text::OPS,
    ]
    .into_iter()
    .flatten()
    .copied()
    .collect::<Registry>()
    .with_constants(constant::CONSTANTS)
}

/// A radius: above zero, with a square that is a number like others.
fn radius(what: &str, length: Spanned<Length>) -> Result<f64> {
    let value = positive(what, length)?;
    if f64::MIN_POSITIVE <= value * value {
        return Ok(value);
    }
    let message = format!(
        "{what} is {}, too small to compute with: its square is below the smallest number, 2.2e-308",
        shortest(value)
    );
    Diagnostic::error(Code::Degenerate, length.span, message).fail()
}

/// A length that is above zero.
fn positive(what: &str, length: Spanned<Length>) -> Result<f64> {
    let value = length.value.0;
    if 0.0 < value {
        return Ok(value);
    }
    let message = format!("{what} must be positive, found {}", shortest(value));
    Diagnostic::error(Code::Degenerate, length.span, message).fail()
}
