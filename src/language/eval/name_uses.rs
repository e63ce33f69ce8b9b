//! Which name means which definition, as places: for whoever looks things up or renames them.

use std::{collections::BTreeMap, sync::Arc};

use crate::diag::{Diagnostic, Span};

/// What the names of a script and of the files that it imports mean. Nothing is evaluated.
#[derive(Debug, Default)]
pub struct NameUses {
    /// Each use of a name with the place where the name is defined, in order. A name that an import
    /// lists is a use of the other file's, and the definition of those in this one.
    pub uses: Vec<(Span, Span)>,
    /// The path of each import, and of each script that a call names, with the path of the file, relative to the script's folder.
    pub imports: Vec<(Span, String)>,
    /// What is wrong with the texts or their names.
    pub diagnostics: Vec<Diagnostic>,
}

impl NameUses {
    /// Where the name at a place is defined in the first place; the place itself where it defines the
    /// name.
    #[must_use]
    pub fn origin(&self, place: Span) -> Span {
        let mut at = place;
        // An import that lists a name of an import that lists it: files make no circle.
        while let Some(target) = self.target(at) {
            if target == at {
                break;
            }
            at = target;
        }
        at
    }

    /// The place that a use at exactly this place means.
    #[must_use]
    pub fn target(&self, place: Span) -> Option<Span> {
        let idx = self.uses.binary_search_by_key(&place, |&(place, _)| place).ok()?;
        Some(self.uses[idx].1)
    }
}

/// What lowering notes of the names of a file.
#[derive(Debug, Default)]
pub(super) struct NotedNames {
    /// Uses with the places of their definitions.
    pub(super) uses: Vec<(Span, Span)>,
    /// What belongs to a name, the parameters of a function and the definitions of a file: the place of
    /// the name (or of the file's path, where a call names it), the part, its place.
    pub(super) parts: Vec<(Span, Arc<str>, Span)>,
    /// Labels of arguments and fields: the place of the called or asked name, the part, its place.
    pub(super) part_uses: Vec<(Span, Arc<str>, Span)>,
    /// Paths of imports and scripts, and what they stand for.
    pub(super) imports: Vec<(Span, String)>,
}

impl NotedNames {
    /// Takes in those of another file.
    pub(super) fn append(&mut self, mut other: Self) {
        self.uses.append(&mut other.uses);
        self.parts.append(&mut other.parts);
        self.part_uses.append(&mut other.part_uses);
        self.imports.append(&mut other.imports);
    }

    pub(super) fn finish(mut self, diagnostics: Vec<Diagnostic>) -> NameUses {
        self.uses.sort_unstable();
        self.uses.dedup_by_key(|(place, _)| *place);
        let mut found = NameUses { uses: self.uses, imports: self.imports, diagnostics };
        let parts: BTreeMap<(Span, &str), Span> = self
            .parts
            .iter()
            .rev()
            .map(|(whole, name, place)| ((*whole, &**name), *place))
            .collect();
        // The parameters of a function of a file are known once the function is.
        let mut open = self.part_uses;
        loop {
            let (known, unknown): (Vec<_>, Vec<_>) = open
                .into_iter()
                .map(|used| (parts.get(&(found.origin(used.0), &*used.1)).copied(), used))
                .partition(|(target, _)| target.is_some());
            if known.is_empty() {
                break;
            }
            let placed = known.into_iter().filter_map(|(target, used)| Some((used.2, target?)));
            found.uses.extend(placed);
            found.uses.sort_unstable();
            open = unknown.into_iter().map(|(_, used)| used).collect();
        }
        found
    }
}
