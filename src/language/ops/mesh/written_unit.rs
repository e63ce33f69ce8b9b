//! The unit that a file was written in.

use crate::{
    diag::{Code, Diagnostic},
    value::Ctx,
};

/// Names that other programs write units by, in small letters, and those of scripts.
const NAMES: &[(&[&str], &str)] = &[
    (&["micrometer", "micrometers", "micrometre", "micrometres", "micron", "microns"], "um"),
    (&["millimeter", "millimeters", "millimetre", "millimetres"], "mm"),
    (&["centimeter", "centimeters", "centimetre", "centimetres"], "cm"),
    (&["meter", "meters", "metre", "metres"], "m"),
    (&["kilometer", "kilometers", "kilometre", "kilometres"], "km"),
    (&["inch", "inches", "\""], "in"),
    (&["foot", "feet", "'"], "ft"),
];

/// Warns where a file was written in another unit than the script's; one that says nothing says none.
pub(super) fn compare_units(unit: &str, ctx: &mut Ctx<'_>) {
    let written = unit.trim().to_lowercase();
    let named = NAMES.iter().find(|(names, _)| names.contains(&written.as_str()));
    let name = named.map_or(written.as_str(), |&(_, name)| name);
    if name.is_empty() || name == ctx.unit {
        return;
    }
    let unit = unit.trim();
    let message = format!(
        "the file was written in {unit}, and the script's unit is {}: its lengths are taken as they stand",
        ctx.unit
    );
    let hint = "state the file's `unit` in the script, or `scale` what it holds";
    ctx.warn(Diagnostic::warning(Code::Unclean, ctx.span, message).hint(hint));
}
