//! The uses of names in a script and in all that it imports.

use super::{load::load, name_uses::NameUses, settings::Settings};
use crate::diag::Sources;

/// The uses of names in the script `text`, which messages call `name`, and in what it imports.
#[must_use]
pub fn name_uses(
    name: &str,
    text: &str,
    sources: &mut Sources,
    settings: Settings<'_>,
) -> NameUses {
    let loaded = load(name, text, sources, settings);
    let mut noted = loaded.noted;
    let mut diagnostics = loaded.diagnostics;
    let mut library = loaded.library;
    noted.append(library.take_noted());
    diagnostics.extend(library.take_findings());
    super::in_order(&mut diagnostics);
    noted.finish(diagnostics)
}
