//! Which name means what: the scopes of functions inside one another.
//!
//! A function sees its parameters and variables, the functions that were defined together with
//! it, and whatever the functions around it see; of the latter it takes copies when it is made
//! (captures). Names never hide one another, so each lookup has one answer.

use super::super::ir::Source;
use crate::diag::Span;

/// The names that one function can see without looking around it.
#[derive(Debug, Default)]
pub(super) struct FunctionScope<'s> {
    /// Parameters and variables in force: name, slot, place of definition.
    locals: Vec<(&'s str, usize, Span)>,
    /// Functions defined together with this one.
    siblings: Vec<(&'s str, Span)>,
    /// What it takes from around it.
    captures: Vec<(&'s str, Source, Span)>,
    /// Slots given out so far.
    n_slots: usize,
}

/// The functions around a place, outermost first. The first one is the definition itself.
#[derive(Debug, Default)]
pub(super) struct Scopes<'s> {
    functions: Vec<FunctionScope<'s>>,
}

impl<'s> Scopes<'s> {
    /// Enters a definition of the file.
    pub(super) fn enter_definition(&mut self) {
        self.functions.push(FunctionScope::default());
    }

    /// Enters a function that may use `siblings`; `captures` were taken by its siblings before.
    pub(super) fn enter_function(
        &mut self,
        siblings: Vec<(&'s str, Span)>,
        captures: Captures<'s>,
    ) {
        self.functions.push(FunctionScope {
            siblings,
            captures: captures.0,
            ..FunctionScope::default()
        });
    }

    /// Leaves the innermost function: the slots that it needs and what it captured.
    pub(super) fn leave(&mut self) -> (usize, Captures<'s>) {
        let scope = self.functions.pop().unwrap_or_default();
        (scope.n_slots, Captures(scope.captures))
    }

    /// Gives `name` a slot in the innermost function.
    pub(super) fn bind(&mut self, name: &'s str, span: Span) -> usize {
        let slot = self.reserve();
        if let Some(scope) = self.functions.last_mut() {
            scope.locals.push((name, slot, span));
        }
        slot
    }

    /// A slot without a name.
    pub(super) fn reserve(&mut self) -> usize {
        let Some(scope) = self.functions.last_mut() else { return 0 };
        scope.n_slots += 1;
        scope.n_slots - 1
    }

    /// How many variables are in force, to go back to.
    pub(super) fn mark(&self) -> usize {
        self.functions.last().map_or(0, |scope| scope.locals.len())
    }

    /// Ends the scope of the variables that came after `mark`.
    pub(super) fn release(&mut self, mark: usize) {
        if let Some(scope) = self.functions.last_mut() {
            scope.locals.truncate(mark);
        }
    }

    /// What `name` means here, if it is no definition of the file, and where it was defined.
    pub(super) fn find(&mut self, name: &str) -> Option<(Source, Span)> {
        self.find_in(self.functions.len(), name)
    }

    fn find_in(&mut self, n_functions: usize, name: &str) -> Option<(Source, Span)> {
        let (scope, outer) = self.functions[..n_functions].split_last_mut()?;
        if let Some(&(_, slot, span)) = scope.locals.iter().rev().find(|local| local.0 == name) {
            return Some((Source::Local(slot), span));
        }
        if let Some(idx) = scope.siblings.iter().position(|sibling| sibling.0 == name) {
            return Some((Source::Sibling(idx), scope.siblings[idx].1));
        }
        if let Some(idx) = scope.captures.iter().position(|capture| capture.0 == name) {
            return Some((Source::Captured(idx), scope.captures[idx].2));
        }
        let n_outer = outer.len();
        let known = self.name_around(n_outer, name)?;
        let (source, span) = self.find_in(n_outer, name)?;
        let scope = &mut self.functions[n_outer];
        scope.captures.push((known, source, span));
        Some((Source::Captured(scope.captures.len() - 1), span))
    }

    /// The name with the lifetime of the source, if a function around knows it.
    fn name_around(&self, n_functions: usize, name: &str) -> Option<&'s str> {
        self.functions[..n_functions].iter().rev().find_map(|scope| {
            let locals = scope.locals.iter().map(|local| local.0);
            let siblings = scope.siblings.iter().map(|sibling| sibling.0);
            let captures = scope.captures.iter().map(|capture| capture.0);
            locals.chain(siblings).chain(captures).find(|known| *known == name)
        })
    }

    /// Every name in force, for suggestions.
    pub(super) fn names(&self) -> Vec<&'s str> {
        self.functions
            .iter()
            .flat_map(|scope| {
                let locals = scope.locals.iter().map(|local| local.0);
                locals.chain(scope.siblings.iter().map(|sibling| sibling.0))
            })
            .collect()
    }
}

/// What a group of functions takes from around it.
#[derive(Debug, Default)]
pub(super) struct Captures<'s>(Vec<(&'s str, Source, Span)>);

impl Captures<'_> {
    /// Where each captured value comes from.
    pub(super) fn sources(&self) -> Vec<Source> {
        self.0.iter().map(|&(_, source, _)| source).collect()
    }
}
