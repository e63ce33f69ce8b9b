//! Ceilings that a script crosses: the message names the flag that moves them.

use crate::{diag::Diagnostic, limits::Ceiling};

/// Adds a hint where the finding tells that a ceiling with a flag was crossed.
pub fn name_flag(found: &mut Diagnostic) {
    if let Some(ceiling) = Ceiling::crossed(found.code.id(), &found.message) {
        found.hints.push(format!("`--limit {}=N` moves this ceiling", ceiling.name));
    }
}
