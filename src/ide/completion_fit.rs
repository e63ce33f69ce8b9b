//! What may stand at a place by its kind: values and calls of that kind are offered first.

use std::ops::Range;

use super::{
    Completion, CompletionKind,
    completion_spot::CompletionSpot,
    signature::active_parameter,
    wanted_types::{WantedTypes, elements, type_of},
};
use crate::{
    syntax::{OpenCall, ast::Kind, open_call, open_list},
    value::{COLOR_NAMES, Type},
};

/// Lists inside of lists that are looked through.
const MOST_LISTS: usize = 3;

impl CompletionSpot<'_> {
    /// What may stand at byte `start`: where it is an argument, an element of one, or all of a promise.
    pub(super) fn wanted(&self, call: Option<&OpenCall<'_>>, start: usize) -> WantedTypes {
        if let Some(call) = call {
            return WantedTypes::new(self.argument_types(call));
        }
        let text: &str = &self.document.text;
        let (mut at, mut n_lists) = (start, 0);
        while let Some(list) = open_list(text, at).filter(|_| n_lists < MOST_LISTS) {
            (at, n_lists) = (list, n_lists + 1);
            if let Some(call) = open_call(text, at) {
                let mut types = self.argument_types(&call);
                for _ in 0..n_lists {
                    types = types.into_iter().flat_map(elements).collect();
                }
                return WantedTypes::new(types);
            }
        }
        let promised = (n_lists == 0).then(|| self.promised(start)).flatten();
        WantedTypes::new(promised.into_iter().collect())
    }

    /// The types that the argument under way may have.
    fn argument_types(&self, call: &OpenCall<'_>) -> Vec<Type> {
        if call.name == "with" {
            let is_truth = matches!(call.label, Some("hidden" | "binary" | "picture"));
            return if is_truth { vec![Type::Bool] } else { Vec::new() };
        }
        let own = self.document.outline.of_file().any(|name| name.name == call.name);
        let ops = self.registry.get(call.name).filter(|_| !own);
        let ops = ops.map(|(_, ops)| &ops[..]).unwrap_or_default();
        let mut types = Vec::new();
        for op in ops {
            let Some(param) = active_parameter(op, call).map(|idx| &op.params[idx]) else {
                continue;
            };
            types.push(param.ty);
            if param.spreads {
                types.extend(elements(param.ty));
            }
        }
        types
    }

    /// What the keyword of the definition promises whose value begins at byte `start`.
    fn promised(&self, start: usize) -> Option<Type> {
        let pieces = &self.document.pieces;
        let n_before = pieces.partition_point(|(_, place)| place.end <= start);
        let before = |n: usize| n_before.checked_sub(n).map(|idx| self.document.piece(idx));
        if before(1)? != "=" {
            return None;
        }
        let word = before(3)?;
        Kind::ALL.iter().find(|(known, _)| *known == word).and_then(|&(_, kind)| type_of(kind))
    }

    /// Words and colours where a string is to be written and has no quotes yet.
    pub(super) fn words_wanted(
        &self,
        call: Option<&OpenCall<'_>>,
        wanted: &WantedTypes,
        range: &Range<usize>,
    ) -> Vec<Completion> {
        let quoted =
            |word: &str| Completion::new(format!("\"{word}\""), CompletionKind::Choice, range);
        let label = call.and_then(|call| call.label).unwrap_or_default();
        if call.is_some_and(|call| call.name == "with") {
            if label.ends_with("color") {
                return COLOR_NAMES.iter().map(|(name, _)| quoted(name)).collect();
            }
            let options = self.export_options();
            let option = options.into_iter().find(|option| option.name == label);
            let words = option.map(|option| (option.words)()).unwrap_or_default();
            return words.into_iter().map(quoted).collect();
        }
        wanted.words().into_iter().map(quoted).collect()
    }
}
