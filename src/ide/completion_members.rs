//! Completion behind a dot: fields of records and geometry, names of imported files.

use std::ops::Range;

use super::{
    Completion, CompletionKind, DefinedName, NameRole, Outline, completion_spot::CompletionSpot,
    owner::Owner, wanted_types::WantedTypes,
};
use crate::{
    kernel::Curve,
    syntax::Highlight,
    value::{Value, field, field_names, field_names_of},
};

/// Control points up to which what a curve is made of is told beside its fields.
const MOST_TOLD: usize = 100;

impl CompletionSpot<'_> {
    /// Members of what stands before the dot.
    pub(super) fn fields(&self, of: &str, range: &Range<usize>) -> Vec<Completion> {
        let one = |name: &str| Completion::new(name, CompletionKind::Field, range);
        match self.owner(of) {
            Some(Owner::Value(value)) => {
                let told =
                    |name: &str| one(name).detail(self.told(&value, name).unwrap_or_default());
                field_names(&value).into_iter().map(told).collect()
            }
            Some(Owner::Like(value)) => field_names(&value).into_iter().map(one).collect(),
            Some(Owner::Type(ty)) => field_names_of(ty).into_iter().map(one).collect(),
            Some(Owner::Record(fields)) => fields.iter().map(|(label, _)| one(label)).collect(),
            Some(Owner::List(_) | Owner::Function(_)) => Vec::new(),
            None => self.names_of_import(of, range),
        }
    }

    /// What a field holds, where that is quickly known.
    fn told(&self, value: &Value, name: &str) -> Option<String> {
        let values = self.values?;
        let is_small = match value {
            Value::Record(_) | Value::Point(_) | Value::Range(_) | Value::Frame(_) => true,
            Value::Curve(Curve::Nurbs(curve)) => curve.control_points().len() <= MOST_TOLD,
            _ => false,
        };
        if !is_small {
            return None;
        }
        let tolerance = values.report().document.1;
        let held = field(value, name, tolerance).ok().flatten()?;
        Some(values.brief(&held).unwrap_or_else(|| held.kind().to_owned()))
    }

    /// What an imported file defines, also where nothing could be evaluated.
    fn names_of_import(&self, of: &str, range: &Range<usize>) -> Vec<Completion> {
        let alias = self
            .document
            .outline
            .of_file()
            .find(|name| name.role == NameRole::Import && name.name == of);
        let Some(alias) = alias else { return Vec::new() };
        let outline = self.document.outline_of_import(&alias.whole);
        outline.map(|outline| self.shown_names(outline, range)).unwrap_or_default()
    }

    /// What a file shows to others.
    fn shown_names(&self, outline: &Outline, range: &Range<usize>) -> Vec<Completion> {
        let is_shown =
            |name: &&DefinedName| name.role != NameRole::Import && !name.name.starts_with('_');
        let anything = WantedTypes::default();
        let shown = outline.of_file().filter(is_shown);
        let told = |name: &DefinedName| Completion {
            kind: CompletionKind::Field,
            snippet: None,
            ..self.definition(name, range, &anything)
        };
        shown.map(told).collect()
    }

    /// In the brackets behind the path of an import what that file shows and the brackets do not name yet.
    pub(super) fn names_to_import(&self, range: &Range<usize>) -> Option<Vec<Completion>> {
        let pieces = &self.document.pieces;
        let first = pieces.partition_point(|(_, place)| place.end <= range.start);
        let is_listed =
            |idx: &usize| pieces[*idx].0 == Highlight::Name || self.document.piece(*idx) == ",";
        let listed: Vec<usize> = (0..first).rev().take_while(is_listed).collect();
        let open = first.checked_sub(listed.len() + 1)?;
        let path = open.checked_sub(1).filter(|_| self.document.piece(open) == "(")?;
        let keyword = path.checked_sub(1)?;
        if pieces[path].0 != Highlight::Text || self.document.piece(keyword) != "import" {
            return None;
        }
        let outline = self.document.outline_of_import(&pieces[path].1);
        let mut found = outline.map(|outline| self.shown_names(outline, range)).unwrap_or_default();
        found.retain(|one| !listed.iter().any(|idx| self.document.piece(*idx) == one.label));
        Some(found)
    }
}
