//! Warnings of what written files came to hold.

use crate::{
    diag::{Code, Diagnostic},
    export::Summary,
    session::File,
};

/// Warnings of what a file came to hold.
pub(super) fn doubts(file: &File, summary: &Summary) -> impl Iterator<Item = Diagnostic> {
    let undrawn = summary.undrawn.iter().map(|why| undrawn(file, why));
    turned(file, summary).into_iter().chain(rounded(file, summary)).chain(undrawn)
}

/// A warning of lines of equal parameter that a drawing lacks.
fn undrawn(file: &File, why: &str) -> Diagnostic {
    let message = format!("some lines of equal parameter are not drawn of {why}");
    Diagnostic::warning(Code::Unclean, file.span, message)
}

/// A warning of numbers that are too coarse for where the geometry lies.
fn rounded(file: &File, summary: &Summary) -> Option<Diagnostic> {
    let rounding = summary.rounding?;
    let message = format!(
        "the file has numbers of single precision, which move places by up to {rounding:.1e}: farther than the tolerance"
    );
    let hint = "`translate` the geometry near the origin, or choose a format with more digits, such as .obj, .ply, or .stl with (binary = false)";
    Some(Diagnostic::warning(Code::Unclean, file.span, message).hint(hint))
}

/// A warning of surfaces and meshes that were turned for a file.
fn turned(file: &File, summary: &Summary) -> Option<Diagnostic> {
    /// Names that are told; the rest is counted.
    const MOST: usize = 6;
    let names: Vec<String> =
        summary.turned.iter().take(MOST).map(|name| format!("`{name}`")).collect();
    let more = match summary.turned.len().saturating_sub(MOST) {
        0 => String::new(),
        n_more => format!(" and {n_more} more"),
    };
    let message = format!(
        "turned {}{more} in the file: parts of closed shells that faced inward now face outward",
        names.join(", ")
    );
    let hint = "`orient([…])` gives surfaces that face outward, `flip(s)` turns one of them";
    let warning = Diagnostic::warning(Code::Unclean, file.span, message).hint(hint);
    (!names.is_empty()).then_some(warning)
}
