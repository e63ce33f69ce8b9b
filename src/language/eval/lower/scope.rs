//! Which name means what: the scopes of functions inside one another.
//!
//! A function sees its parameters and variables, the functions that were defined together with
//! it, and whatever the functions around it see; of the latter it takes copies when it is made
//! (captures). The innermost of a name hides the others.

use std::{collections::HashMap, sync::Arc};

use super::super::ir::CaptureSource;
use crate::{diag::Span, limits::work};

/// The names that one function can see without looking around it.
#[derive(Debug, Default)]
pub(super) struct FunctionScope<'s> {
    /// Parameters and variables in force.
    locals: Vec<Local<'s>>,
    /// Where the last of each name stands among them.
    places: HashMap<&'s str, usize>,
    /// Functions defined together with this one.
    siblings: Arc<Siblings<'s>>,
    /// What it takes from around it.
    captures: Captures<'s>,
    /// Slots given out so far.
    n_slots: usize,
}

/// A parameter or variable.
#[derive(Debug)]
struct Local<'s> {
    name: &'s str,
    slot: usize,
    span: Span,
    /// Where the one of this name stands that it hides.
    hidden: Option<usize>,
}

/// Functions that are defined together.
#[derive(Debug, Default)]
pub(super) struct Siblings<'s> {
    names: Vec<(&'s str, Span)>,
    places: HashMap<&'s str, usize>,
}

impl<'s> Siblings<'s> {
    pub(super) fn new(names: Vec<(&'s str, Span)>) -> Self {
        let places = names.iter().enumerate().rev().map(|(idx, &(name, _))| (name, idx)).collect();
        Self { names, places }
    }
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
    pub(super) fn enter_function(&mut self, siblings: Arc<Siblings<'s>>, captures: Captures<'s>) {
        self.functions.push(FunctionScope { siblings, captures, ..FunctionScope::default() });
    }

    /// Leaves the innermost function: the slots that it needs and what it captured.
    pub(super) fn leave(&mut self) -> (usize, Captures<'s>) {
        let scope = self.functions.pop().unwrap_or_default();
        (scope.n_slots, scope.captures)
    }

    /// Gives `name` a slot in the innermost function.
    pub(super) fn bind(&mut self, name: &'s str, span: Span) -> usize {
        let slot = self.reserve();
        if let Some(scope) = self.functions.last_mut() {
            let hidden = scope.places.insert(name, scope.locals.len());
            scope.locals.push(Local { name, slot, span, hidden });
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
            for local in scope.locals.drain(mark..).rev() {
                match local.hidden {
                    Some(hidden) => scope.places.insert(local.name, hidden),
                    None => scope.places.remove(local.name),
                };
            }
        }
    }

    /// Where the innermost function defines `name` among its variables that came after `mark`.
    pub(super) fn own(&self, name: &str, mark: usize) -> Option<Span> {
        let scope = self.functions.last()?;
        let idx = scope.places.get(name).filter(|&&idx| mark <= idx)?;
        Some(scope.locals[*idx].span)
    }

    /// What `name` means here, if it is no definition of the file, and where it was defined.
    pub(super) fn find(&mut self, name: &str) -> Option<(CaptureSource, Span)> {
        self.find_in(self.functions.len(), name)
    }

    fn find_in(&mut self, n_functions: usize, name: &str) -> Option<(CaptureSource, Span)> {
        let (scope, outer) = self.functions[..n_functions].split_last_mut()?;
        work::count(1);
        if let Some(&idx) = scope.places.get(name) {
            let Local { slot, span, .. } = scope.locals[idx];
            return Some((CaptureSource::Local(slot), span));
        }
        if let Some(&idx) = scope.siblings.places.get(name) {
            return Some((CaptureSource::Sibling(idx), scope.siblings.names[idx].1));
        }
        if let Some(&idx) = scope.captures.places.get(name) {
            return Some((CaptureSource::Captured(idx), scope.captures.taken[idx].1));
        }
        let n_outer = outer.len();
        let known = self.name_around(n_outer, name)?;
        let (source, span) = self.find_in(n_outer, name)?;
        let captures = &mut self.functions[n_outer].captures;
        let idx = captures.taken.len();
        captures.places.insert(known, idx);
        captures.taken.push((source, span));
        Some((CaptureSource::Captured(idx), span))
    }

    /// The name with the lifetime of the source, if a function around knows it.
    fn name_around(&self, n_functions: usize, name: &str) -> Option<&'s str> {
        self.functions[..n_functions].iter().rev().find_map(|scope| {
            let all = [&scope.places, &scope.siblings.places, &scope.captures.places];
            all.into_iter().find_map(|places| places.get_key_value(name)).map(|(&known, _)| known)
        })
    }

    /// Every name in force, for suggestions.
    pub(super) fn names(&self) -> Vec<&'s str> {
        self.functions
            .iter()
            .flat_map(|scope| {
                let locals = scope.locals.iter().map(|local| local.name);
                locals.chain(scope.siblings.names.iter().map(|sibling| sibling.0))
            })
            .collect()
    }
}

/// What a group of functions takes from around it.
#[derive(Debug, Default)]
pub(super) struct Captures<'s> {
    taken: Vec<(CaptureSource, Span)>,
    /// Where each name stands among them.
    places: HashMap<&'s str, usize>,
}

impl Captures<'_> {
    /// Where each captured value comes from.
    pub(super) fn sources(&self) -> Vec<CaptureSource> {
        self.taken.iter().map(|&(source, _)| source).collect()
    }
}
